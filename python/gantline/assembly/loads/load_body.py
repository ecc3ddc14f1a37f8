"""The load by itself: weight, centre of gravity, inertia and shape, from the lift file or from CAD."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from itertools import combinations
from pathlib import Path

import numpy as np

from gantline.assembly.loads import round_body
from gantline.assembly.spatial import Array, inertia_matrix, solid_box
from gantline.assembly.stamp import stamp
from gantline.cad import Assumptions, CadError, CadModel, read, read_light_mesh
from gantline.cad.assumptions import STEEL
from gantline.cad.doubts import doubts_of_parts, doubts_of_the_whole
from gantline.cad.mass_properties import MassProperties
from gantline.cad.mesh import TriangleMesh
from gantline.cad.simplify import HullSides, contact_hull, hull_sides
from gantline.scenario import Scenario
from gantline.scenario.consistency.load import Extent, attached, check_attached, check_centre, check_underside
from gantline.scenario.consistency.supports import check_places
from gantline.scenario.consistency.tanks import check_load_tanks
from gantline.scenario.errors import Doubt
from gantline.scenario.findings import Findings
from gantline.scenario.loads.cylinder import Cylinder
from gantline.scenario.loads.load import Load, LoadInertia
from gantline.units import format_by_size

__all__ = ["LoadBody", "load_body", "stated_inertia"]

#: Triangles that stand for the load in pictures.
_MOST_TRIANGLES = 4000
#: Its convex hull may be missed by this share of its size.
_HULL_ERROR = 1e-3
#: Its sides that lie on supports may miss it by this [m].
_SIDES_ERROR = 2e-4
#: Corners of each side of a box, by their places in `_corners`, anticlockwise as seen from outside: the
#: underside first, the top, then the four around.
_SIDES_OF_BOX = (
    (2, 3, 1, 0),
    (4, 5, 7, 6),
    *((one, other, other + 4, one + 4) for one, other in ((0, 1), (1, 3), (3, 2), (2, 0))),
)
#: Masses that differ by less than this share, and centres by less than this share of the size, agree.
_MASSES_AGREE, _CENTRES_AGREE = 0.02, 0.002
#: Where the lift file names the CAD file.
_CAD = ("load", "shape", "cad")
#: Lugs nearer to each other than this are one [m].
_ONE_PLACE = 1e-3
#: Density of air [kg/m^3]: what weighs less than the air in its box has been given a unit too small.
_AIR = 1.2
#: Share of a load's height below which its centre of gravity cannot lie [1].
_LOWEST = 0.01
#: Radii of gyration below this share of those of a solid box are a slip [1]: kg m^2 for t m^2 gives 0.03.
_THINNEST = 0.1
#: Doubts of a CAD file that are told, each a sentence.
_MOST_DOUBTS = 8
#: Lugs stand on what is lifted, or on masts and houses that its box leaves out, so far [m].
_OFF = 1.0


@dataclass(frozen=True)
class LoadBody:
    """A load without rigging, measured from its datum along its own axes.

    Attributes:
        mass: simulated mass [kg].
        centre: centre of gravity (3,) [m].
        inertia: about it (3, 3) [kg m^2].
        box: least and largest x, y, z (2, 3) [m].
        mesh: light triangles to draw it, of a round one flat sides; None for a box.
        hull: corners of a convex body to touch it with (n, 3) [m]; of a box its own.
        sides: what of it may lie on supports, the corners (n, 3) of each side of a convex body, anticlockwise
            as seen from outside [m]; of a lift without supports those of its box.
        sides_error: how far the convex hull stands out of these at most [m].
        surface: all triangles of a CAD file or a round load, of a lift with supports; else None.
        doubts: where lift file and CAD do not agree, and what cannot well be meant of weight and lugs.
        pieces: convex parts (n, 3) that touch others, of a round load [m]; none where it is the hull itself.
    """

    mass: float
    centre: Array
    inertia: Array
    box: Array
    mesh: TriangleMesh | None
    hull: Array
    sides: tuple[Array, ...]
    sides_error: float = 0.0
    surface: TriangleMesh | None = None
    doubts: tuple[Doubt, ...] = ()
    pieces: tuple[Array, ...] = ()


def load_body(scenario: Scenario, load: Load) -> LoadBody:
    """The load that a lift file describes.

    Raises:
        ScenarioError: if its CAD file cannot be read, or does not fit what the lift file says.
    """
    if load.shape.cylinder is not None:
        return _of_cylinder(scenario, load, load.shape.cylinder)
    return _from_cad(scenario, load) if load.shape.cad is not None else _of_box(scenario, load)


def _of_box(scenario: Scenario, load: Load) -> LoadBody:
    assert load.shape.box is not None and load.centre_of_gravity.at != "from_cad"  # checked
    x, y, z = load.shape.box
    box = np.array([[-x / 2, -y / 2, 0.0], [x / 2, y / 2, z]])
    mass = load.weight.simulated
    inertia = (
        stated_inertia(load.inertia)
        if isinstance(load.inertia, LoadInertia)
        else solid_box(mass, load.shape.box)
    )
    centre, doubts = np.array(load.centre_of_gravity.at), tuple(_doubts(scenario, load, box))
    return LoadBody(mass, centre, inertia, box, None, _corners(box), _sides_of(box), doubts=doubts)


def _of_cylinder(scenario: Scenario, load: Load, given: Cylinder) -> LoadBody:
    assert load.centre_of_gravity.at != "from_cad"  # checked
    x, y, z = given.sizes
    box = np.array([[-x / 2, -y / 2, 0.0], [x / 2, y / 2, z]])
    mass = load.weight.simulated
    inertia = (
        stated_inertia(load.inertia)
        if isinstance(load.inertia, LoadInertia)
        else np.diag(given.inertia(mass))
    )
    return LoadBody(
        mass,
        np.array(load.centre_of_gravity.at),
        inertia,
        box,
        round_body.drawn(given),
        round_body.hull(given),
        round_body.sides(given),
        surface=round_body.surface(given) if scenario.supports else None,
        pieces=round_body.touching(given),
        doubts=tuple(_doubts(scenario, load, box)),
    )


def _doubts(scenario: Scenario, load: Load, box: Array) -> list[Doubt]:
    """What cannot well be meant of weight and lugs in a box."""
    return [
        *_of_no_matter(load, box),
        *_centre_at_the_underside(load, box),
        *_inertia_of_another(load, box),
        *_far_off(scenario, load, box),
        *_lugs_at_one_place(load),
    ]


def _weight(mass: float) -> str:
    return format_by_size(mass, "mass", 4)


def _of_no_matter(load: Load, box: Array) -> list[Doubt]:
    """Of a weight that nothing has that is as large as the load."""
    cylinder, weight = load.shape.cylinder, load.weight.calculated
    volume = float(np.prod(box[1] - box[0])) if cylinder is None else cylinder.enclosed
    what = "its box" if cylinder is None else "it"
    air, steel = _AIR * volume, STEEL * volume
    if weight < air:
        said = f"the load weighs {_weight(weight)}, less than the air in {what}, {_weight(air)}"
        return [Doubt(("load", "weight"), f"{said}; a unit has slipped, kg for t or mm for m")]
    if weight > steel:
        said = f"the load weighs {_weight(weight)}, more than {what} full of steel, {_weight(steel)}"
        return [Doubt(("load", "weight"), f"{said}; a unit has slipped, t for kg or mm for m")]
    return []


def _centre_at_the_underside(load: Load, box: Array) -> list[Doubt]:
    """Of a centre of gravity so low that a load would have to have all of its weight in its underside."""
    if load.centre_of_gravity.at == "from_cad":
        return []
    above, height = load.centre_of_gravity.at[2] - float(box[0, 2]), float(box[1, 2] - box[0, 2])
    if above > _LOWEST * height:
        return []
    in_mm = float(f"{1e3 * above:.3g}")
    said = f"the centre of gravity is {in_mm:,g} mm above the underside of a load {height:.4g} m high"
    sentence = f"{said}; a height has slipped, which makes the load hang more stably than it will"
    return [Doubt(("load", "centre_of_gravity", "at"), sentence)]


def _inertia_of_another(load: Load, box: Array) -> list[Doubt]:
    """Of stated inertias that nothing of this weight in this box has, or nothing that fills some of it."""
    if not isinstance(load.inertia, LoadInertia) or load.centre_of_gravity.at == "from_cad":
        return []
    centre = np.array(load.centre_of_gravity.at)
    found = radii_of_another(load.inertia, load.weight.calculated, centre, box)
    if not found:
        return []
    said = "the inertia and the weight of the load make radii of gyration that its box does not allow"
    sentence = f"{said}: {', '.join(found)}; a unit has slipped, or the weight"
    return [Doubt(("load", "inertia"), sentence)]


def radii_of_another(inertia: LoadInertia, mass: float, centre: Array, box: Array) -> list[str]:
    """Radii of gyration that nothing in a box has, or nothing that fills some of it, in words.

    Args:
        inertia: About the centre of gravity, along the axes of the box.
        mass: Of the body [kg].
        centre: Its centre of gravity, shape (3,) [m].
        box: Its least and largest corner, shape (2, 3) [m].
    """
    sizes = box[1] - box[0]
    reach = np.maximum(np.abs(box[0] - centre), np.abs(box[1] - centre))
    found = []
    for axis, key in enumerate(("xx", "yy", "zz")):
        across = [i for i in range(3) if i != axis]
        radius = float(np.sqrt(getattr(inertia, key) / mass))
        farthest, solid = float(np.hypot(*reach[across])), float(np.hypot(*sizes[across]) / np.sqrt(12.0))
        if radius > farthest + _OFF or radius < _THINNEST * solid:
            found.append(f"{key} {radius:.3g} m (a solid box {solid:.3g} m)")
    return found


def _lugs_at_one_place(load: Load) -> list[Doubt]:
    pairs = combinations(load.lugs.items(), 2)
    same = [
        (one, other)
        for (one, a), (other, b) in pairs
        if all(abs(x - y) <= _ONE_PLACE for x, y in zip(a.at, b.at, strict=True))
    ]
    without = "one lug would bear the slings of both"
    return [
        Doubt(("load", "lugs", other), f"lugs {one} and {other} are at one place; {without}")
        for one, other in same
    ]


def _far_off(scenario: Scenario, load: Load, box: Array) -> list[Doubt]:
    """What lies so far off the load's box that nothing seems to hold it there; farther still is refused."""
    apart = [(one, one.off(_extent(box))) for one in attached(scenario, load)]
    words = {
        "lug": "lug {} lies",
        "outfitting": "outfitting {} lies",
        "tag line": "the end of tag line {} on the load lies",
        "guide": "guide {} has its place on the load",
        "hinge": "hinge {} holds the load",
    }
    return [
        Doubt(one.path, f"{words[one.kind].format(one.name)} {off:.3g} m outside the load's box")
        for one, off in apart
        if off > _OFF
    ]


def _extent(box: Array) -> Extent:
    """A box, its least and largest x, y, z (2, 3) [m], as a lift file has it."""
    low, high = ((float(x), float(y), float(z)) for x, y, z in box)
    return low, high


def _corners(box: Array) -> Array:
    return np.array([(box[i, 0], box[j, 1], box[k, 2]) for k in (0, 1) for j in (0, 1) for i in (0, 1)])


def _sides_of(box: Array) -> tuple[Array, ...]:
    corners = _corners(box)
    return tuple(corners[list(side)] for side in _SIDES_OF_BOX)


def stated_inertia(given: LoadInertia) -> Array:
    """The matrix (3, 3) of an inertia of the lift file [kg m^2]."""
    return inertia_matrix((given.xx, given.yy, given.zz, given.xy, given.xz, given.yz))


def _from_cad(scenario: Scenario, load: Load) -> LoadBody:
    shape = load.shape
    assert shape.cad is not None
    path = Path(scenario.source).parent / shape.cad
    try:
        given = Assumptions(unit=shape.units, thickness=shape.thickness, up=shape.up)
        model, light, hull = _read(path, stamp(path), given)
        own, box = model.properties, model.box
    except CadError as problem:
        raise scenario.error(_CAD, str(problem).replace(str(path), shape.cad)) from None
    shift = np.zeros(3)
    if not load.is_at_origin:
        shift = -np.array([*box.mean(axis=0)[:2], box[0, 2]])
    box = box + shift
    whole, doubts = _weighed(load, own.moved(np.eye(3), shift))
    doubts += _of_the_file(model, shape.cad)
    centre, mass = whole.centre, load.weight.simulated
    stated = load.centre_of_gravity.at
    if stated != "from_cad":
        centre = np.array(stated)
        doubts += _apart(centre, whole.centre, box)
    doubts += _doubts(scenario, load, box)
    _check(scenario, load, box, centre)
    if isinstance(load.inertia, LoadInertia):
        inertia = stated_inertia(load.inertia)
    else:
        inertia = whole.scaled_to(mass).inertia
    drawn = light.moved(np.eye(3), shift)
    sides, error, surface = _sides_of(box), 0.0, None
    if scenario.supports:
        flat = _read_sides(path, stamp(path), given)
        sides, error = tuple(outline + shift for outline in flat.outlines), flat.error
        surface = model.mesh.moved(np.eye(3), shift)
    return LoadBody(mass, centre, inertia, box, drawn, hull + shift, sides, error, surface, tuple(doubts))


@lru_cache(maxsize=4)
def _read(path: Path, _stamp: tuple[int, int], given: Assumptions) -> tuple[CadModel, TriangleMesh, Array]:
    """The file's model, light mesh and contact hull, made once for all cases of a lift."""
    model = read(path, given)
    mesh = model.mesh
    if not len(mesh.triangles):
        raise CadError(f"{path}: no part has geometry")
    hull = contact_hull(mesh, _HULL_ERROR * mesh.size)
    return model, read_light_mesh(path, given, most=_MOST_TRIANGLES), hull.vertices


@lru_cache(maxsize=4)
def _read_sides(path: Path, _stamp: tuple[int, int], given: Assumptions) -> HullSides:
    """The flat sides of the convex hull of a file, made once for all cases of a lift."""
    return hull_sides(read(path, given).mesh, _SIDES_ERROR)


def _of_the_file(model: CadModel, name: str) -> list[Doubt]:
    """What is doubtful about a CAD file and its parts; of very many doubts the first."""
    found = [*doubts_of_the_whole(model), *doubts_of_parts(model)]
    doubts = [f"the CAD file of the load: {doubt}" for doubt in found]
    more = len(doubts) - _MOST_DOUBTS
    if more > 1:
        doubts[_MOST_DOUBTS:] = [f"the CAD file of the load: {more} more doubts; 'gantline cad {name}' tells"]
    return [Doubt(_CAD, doubt) for doubt in doubts]


def _share_more(ratio: float) -> str:
    """How far a mass is from another by their ratio; nobody reads +104666666566.7 % of a slip."""
    return f"{ratio:,.0f} times as much" if ratio >= 10.0 else f"{100 * (ratio - 1):+.1f} %"


def _weighed(load: Load, own: MassProperties) -> tuple[MassProperties, list[Doubt]]:
    """Structure scaled to what the outfitting leaves of the weight, joined with the outfitting."""
    outfitting = [MassProperties.of_point(piece.mass, piece.at) for piece in load.outfitting]
    steel = load.weight.calculated - sum(piece.mass for piece in outfitting)
    doubts = list[Doubt]()
    if abs(own.mass - steel) > _MASSES_AGREE * steel:
        without = " less outfitting" if outfitting else ""
        sentence = (
            f"the CAD file of the load weighs {_weight(own.mass)}, its calculated weight{without} is "
            f"{_weight(steel)} ({_share_more(own.mass / steel)}): masses are scaled to the weight"
        )
        doubts.append(Doubt(("load", "weight"), sentence))
    return MassProperties.combined([own.scaled_to(steel), *outfitting]), doubts


def _apart(stated: Array, found: Array, box: Array) -> list[Doubt]:
    distance = float(np.linalg.norm(stated - found))
    if distance <= _CENTRES_AGREE * float(np.linalg.norm(box[1] - box[0])):
        return []
    # Adding 0 takes the sign off a zero.
    places = [np.round(place, 3) + 0.0 for place in (stated, found)]
    here, there = (f"({x:g}, {y:g}, {z:g}) m" for x, y, z in places)
    sentence = f"the centre of gravity of the load is stated at {here}; CAD and outfitting give {there}"
    sentence = f"{sentence}, {distance:.3g} m away: the stated one is simulated"
    return [Doubt(("load", "centre_of_gravity", "at"), sentence)]


def _check(scenario: Scenario, load: Load, box: Array, centre: Array) -> None:
    """What is checked of a box when the lift file is read, as soon as the CAD file's box is known."""
    findings = Findings(scenario)
    low, high = _extent(box)
    x, y, z = (float(part) for part in centre)
    whose = ", by CAD and outfitting," if load.centre_of_gravity.at == "from_cad" else ""
    check_centre(findings, (x, y, z), (low, high), whose)
    check_attached(findings, load, (low, high))
    check_load_tanks(findings, load.tanks, (low, high))
    check_places(findings, low, high)
    if load.is_at_origin:
        check_underside(findings, load, load.position[2] + low[2])
    findings.raise_any()
