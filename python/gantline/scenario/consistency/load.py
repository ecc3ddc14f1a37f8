"""Whether the load is a body that can exist, and stands where it says it stands."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from gantline.scenario.consistency.supports import check_beside, check_places, top_of
from gantline.scenario.consistency.tanks import check_load_tanks, check_round_tanks
from gantline.scenario.consistency.wind import check_areas
from gantline.scenario.errors import nearest
from gantline.scenario.findings import Findings, Path
from gantline.scenario.loads.cylinder import Cylinder
from gantline.scenario.loads.load import Load, LoadInertia
from gantline.scenario.loads.lug import Lug
from gantline.scenario.loads.structures import dock_of
from gantline.scenario.model import Scenario

__all__ = [
    "Attached",
    "Extent",
    "attached",
    "check_attached",
    "check_centre",
    "check_inertia",
    "check_load",
    "check_lug_type",
    "check_underside",
]

#: A load at rest may be given this far from the ground it stands on [m].
_STANDING = 1e-3
_ROUNDING = 1 + 1e-9
#: What is called made fast to a load, by its kind.
_THIS = {
    "lug": "this lug",
    "outfitting": "this outfitting",
    "tag line": "this end of the line",
    "guide": "this part of the guide",
    "hinge": "this hinge",
}

Triple = tuple[float, float, float]
#: Least and largest x, y, z.
Extent = tuple[Triple, Triple]


def check_load(findings: Findings, load: Load) -> None:
    """Note everything that is wrong with the load."""
    _check_sources(findings, load)
    box, cylinder = load.shape.sizes, load.shape.cylinder
    if cylinder is not None:
        _check_wall(findings, cylinder)
    if box is not None and load.centre_of_gravity.at != "from_cad":
        check_centre(findings, load.centre_of_gravity.at, _box_of(box))
    for name, lug in load.lugs.items():
        check_lug_type(findings, ("load", "lugs", name), lug)
    if box is not None:
        check_attached(findings, load, _box_of(box))
        check_load_tanks(findings, load.tanks, _box_of(box))
        if cylinder is not None:
            check_round_tanks(findings, load.tanks, cylinder)
        check_places(findings, *_box_of(box))
        if cylinder is None:  # under a round one its own sides decide
            check_beside(findings, *_box_of(box))
    if isinstance(load.inertia, LoadInertia):
        check_inertia(findings, ("load", "inertia"), load.inertia)
    check_areas(findings, ("load",), load.wind_areas)
    if load.shape.cad is not None:
        for kind, areas in (("wind_areas", load.wind_areas), ("current_areas", load.current_areas)):
            for name in (name for name, one in (areas or {}).items() if one.area is None):
                sentence = "a shape from CAD does not say what it shows; write 'area: 120 m^2'"
                findings.add(("load", kind, name), sentence)
    if load.stands_on is not None:
        _check_standing(findings, load, load.stands_on)
    if findings.scenario.simulation.gravity == 0:
        findings.add(("simulation", "gravity"), "gravity is zero; a load needs gravity above zero")


def _check_wall(findings: Findings, cylinder: Cylinder) -> None:
    """Note a tube whose wall leaves nothing hollow."""
    narrow = 2.0 * min(cylinder.radii)
    if cylinder.wall is not None and 2.0 * cylinder.wall >= narrow:
        sentence = f"a tube {narrow:g} m across has no room for two walls of {cylinder.wall:g} m"
        findings.add(("load", "shape", "cylinder", "wall"), f"{sentence}; leave it out for a solid one")


def _box_of(sizes: tuple[float, float, float]) -> Extent:
    x, y, z = sizes
    return (-x / 2, -y / 2, 0.0), (x / 2, y / 2, z)


def check_centre(findings: Findings, centre: Triple, box: Extent, whose: str = "") -> None:
    """Note a centre of gravity, and whose it is, outside the load's box: least and largest x, y, z [m]."""
    if any(not low <= part <= high for low, part, high in zip(box[0], centre, box[1], strict=True)):
        x, y, z = centre
        sentence = f"({x:g}, {y:g}, {z:g}) m{whose} is outside the load's box; {_measured(findings)}"
        findings.add(("load", "centre_of_gravity", "at"), sentence)


class Attached(NamedTuple):
    """What is made fast to a load: where the lift file says it, its kind and name, and the place."""

    path: Path
    kind: str
    name: str
    at: Triple

    def off(self, box: Extent) -> float:
        """How far it is outside a box, its least and largest x, y, z [m]; negative inside."""
        sides = zip(box[0], self.at, box[1], strict=True)
        return max(max(low - part, part - high) for low, part, high in sides)


def attached(scenario: Scenario, load: Load) -> Iterator[Attached]:
    """Lugs of a load, outfitting, ends of its tag lines, what of guides is on it, and its hinge."""
    for name, lug in load.lugs.items():
        yield Attached(("load", "lugs", name, "at"), "lug", name, lug.at)
    for place, piece in enumerate(load.outfitting):
        yield Attached(("load", "outfitting", place, "at"), "outfitting", piece.name, piece.at)
    for name, line in (scenario.tag_lines or {}).items():
        yield Attached(("tag_lines", name, "at"), "tag line", name, line.at)
    for name, guide in (scenario.guides or {}).items():
        key, on_load = ("frame", guide.frame) if guide.frame is not None else ("bumper", guide.bumper_there)
        yield Attached(("guides", name, key, "at"), "guide", name, on_load.at)
    for name, hinge in (scenario.hinges or {}).items():
        yield Attached(("hinges", name, "at"), "hinge", name, hinge.at)


def check_attached(findings: Findings, load: Load, box: Extent) -> None:
    """Note lugs, outfitting, ends of tag lines, parts of guides and hinges far outside the load's box."""
    for one in attached(findings.scenario, load):
        off = one.off(box)
        if off > max(high - low for low, high in zip(*box, strict=True)) / 2:
            sentence = f"{_THIS[one.kind]} is {off:g} m outside the load's box; {_measured(findings)}"
            findings.add(one.path, sentence)


def _measured(findings: Findings) -> str:
    load = findings.scenario.load
    at_origin = load is not None and load.is_at_origin
    return f"positions are measured from {'the origin of its CAD file' if at_origin else 'its bottom centre'}"


def _check_sources(findings: Findings, load: Load) -> None:
    """What comes from CAD needs a CAD file, and the other way round."""
    if load.shape.cad is None:
        wanted = "needs a CAD file: 'shape: {cad: load.3docx}'"
        kind = "box" if load.shape.cylinder is None else "cylinder"
        if load.centre_of_gravity.at == "from_cad":
            findings.add(("load", "centre_of_gravity", "at"), f"'from_cad' {wanted}")
        if load.inertia == "from_cad":
            findings.add(("load", "inertia"), f"'from_cad' {wanted}; 'homogeneous' is a solid {kind}")
        if load.datum == "origin":
            findings.add(("load", "datum"), f"'origin' {wanted}; 'bottom_centre' is right for a {kind}")
        if load.outfitting:
            findings.add(("load", "outfitting"), f"outfitting {wanted}; a {kind} has all of its weight in it")
        return
    if load.inertia == "homogeneous":
        sentence = "'homogeneous' is a solid box; right for a shape from CAD is 'from_cad', or values"
        findings.add(("load", "inertia"), sentence)
    if load.outfitting and isinstance(load.inertia, LoadInertia):
        sentence = "stated inertias have the outfitting in them; 'inertia: from_cad' adds it"
        findings.add(("load", "outfitting"), sentence)
    mass = sum(piece.mass for piece in load.outfitting)
    if mass >= load.weight.calculated:
        sentence = (
            f"the outfitting weighs {mass / 1e3:g} t, all of the load's {load.weight.calculated / 1e3:g} t"
        )
        findings.add(("load", "outfitting"), f"{sentence}; the calculated weight includes it")


def check_lug_type(findings: Findings, path: Path, lug: Lug) -> None:
    """Note a lug at a path whose type nothing describes."""
    types = findings.scenario.lug_types or {}
    if lug.type is not None and lug.type not in types:
        sentence = f"'{lug.type}' is not a name of 'lug_types'; {nearest(lug.type, types)}"
        findings.add((*path, "type"), sentence)


def check_inertia(findings: Findings, path: Path, inertia: LoadInertia) -> None:
    """Note an inertia at a path that no body has."""
    a, b, c = inertia.xx, inertia.yy, inertia.zz
    d, e, f = inertia.xy, inertia.xz, inertia.yz
    minor = a * b - d * d
    determinant = a * (b * c - f * f) - d * (d * c - f * e) + e * (d * f - b * e)
    largest = max(a, b, c)
    if largest > (a + b + c - largest) * _ROUNDING or minor <= 0 or determinant <= 0:
        sentence = "no body has such an inertia; each of xx, yy, zz is at most the sum of the other two"
        findings.add(path, f"{sentence}, and products are small")


def _check_standing(findings: Findings, load: Load, base: str) -> None:
    scenario = findings.scenario
    ground, supports = scenario.ground, scenario.supports or {}
    if base in supports:
        if scenario.start == "settled":
            sentence = "'settled' is for a load on the ground"
            findings.add(("start",), f"{sentence}; one on supports starts at 'rest', or 'as_given'")
    elif base != "ground":
        sentence = f"'{base}' is not a group of 'supports' and not 'ground'"
        right = nearest(base, ["ground", *supports])
        plain = scenario.mechanics.bodies if scenario.mechanics is not None else {}
        if base in (scenario.vessels or {}) or base in plain:
            kind = "body of 'mechanics'" if base in plain else "vessel"
            sentence = f"'{base}' is a {kind}, which no load stands on by 'stands_on'"
            right = "leave it out and let both touch by 'body_contacts' of 'mechanics'"
        findings.add(("load", "stands_on"), f"{sentence}; {right}")
    elif load.shape.cylinder is not None and scenario.load_has_settled and ground is not None:
        _check_round_standing(findings, load.shape.cylinder)
    elif ground is None:
        sentence = "the load stands on the ground but there is no 'ground' in this file"
        findings.add(("load", "stands_on"), f"{sentence}; add 'ground: {{level: 0 m}}'")
    if not load.is_at_origin:
        check_underside(findings, load, load.position[2])


def _check_round_standing(findings: Findings, cylinder: Cylinder) -> None:
    """Note a round load at rest on the ground where it has no place of rest."""
    path = ("load", "stands_on")
    if cylinder.along == "x" and not findings.scenario.hinges:  # a hinge keeps it from rolling
        sentence = "a round load that lies on the ground rolls, so it has no place of rest there"
        right = (
            "lay it on 'supports' to both sides of its lowest line, with 'height: to_load', or let it roll "
            "by 'start: as_given'"
        )
        findings.add(path, f"{sentence}; {right}")
    elif dock_of(findings.scenario) is not None:
        sentence = "around a dock a round load at rest stands on 'supports'"
        findings.add(path, f"{sentence}; put some under it, or begin by 'start: as_given'")


def check_underside(findings: Findings, load: Load, underside: float) -> None:
    """Note a load at rest whose underside, at this height [m], is not on what it stands on."""
    scenario, base = findings.scenario, load.stands_on
    if base in (scenario.supports or {}) and load.shape.box is None:
        return  # its sides over each of them decide, see `gantline.assembly.loads.under_load`
    if base in (scenario.supports or {}):
        level, what, where_from = top_of(scenario, base), base, "the highest of them"
    elif base == "ground" and scenario.ground is not None:
        level, what, where_from = scenario.ground.level, "the ground", "it"
    else:
        return  # nothing to stand on, or nothing that there is
    gap = underside - level
    if scenario.load_has_settled and abs(gap) > _STANDING:
        where = "above" if gap > 0 else "below"
        sentence = f"the load stands on {what} but its underside is {abs(gap):g} m {where} {where_from}"
        right = load.position[2] - gap
        findings.add(("load", "position"), f"{sentence}; right is z = {right:g} m")
