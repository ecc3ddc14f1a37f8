"""Whether tanks are inside of what has them, and have names of their own."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import product

from gantline.scenario.afloat.tanks import bodies_afloat
from gantline.scenario.afloat.water import BallastTank, Extent
from gantline.scenario.findings import Findings, Path
from gantline.scenario.loads.cylinder import Cylinder
from gantline.scenario.model import Scenario

__all__ = ["check_inside_of", "check_load_tanks", "check_round_tanks", "check_tank_names"]

#: A tank may reach so far out of what has it by rounding [m].
_CLOSE = 1e-6
#: What water does to a body has the body's name and one of these: a tank of that name would be taken for it.
_MEANT = {
    "hull": "its hull",
    "added_mass": "its added mass",
    "water_damping": "what water damps it with",
    "radiation": "the waves that it makes",
    "in_water": "what water does to it",
}


def check_load_tanks(findings: Findings, tanks: Mapping[str, BallastTank] | None, box: Extent) -> None:
    """Note tanks of the load outside its box, its least and largest x, y, z from its datum [m]."""
    check_inside_of(findings, ("load",), tanks, box, "the load's box")


def check_round_tanks(
    findings: Findings, tanks: Mapping[str, BallastTank] | None, cylinder: Cylinder
) -> None:
    """Note tanks of a round load whose corners stick out of its skin."""
    for name, tank in (tanks or {}).items():
        (length, breadth, depth), (x, y, z) = tank.box, tank.bottom
        ways = product((x - length / 2, x + length / 2), (y - breadth / 2, y + breadth / 2), (z, z + depth))
        out = max(-cylinder.depth(corner) for corner in ways)
        if out > _CLOSE:
            sentence = f"a corner of it is {out:.3g} m outside the round load"
            findings.add(("load", "tanks", name), f"{sentence}; a tank is inside of it")


def check_inside_of(
    findings: Findings, path: Path, tanks: Mapping[str, BallastTank] | None, extent: Extent, what: str
) -> None:
    """Note tanks that stick out of something, in words, of this extent; of each the first axis."""
    for name, tank in (tanks or {}).items():
        (length, breadth, depth), (x, y, z) = tank.box, tank.bottom
        least, most = (x - length / 2, y - breadth / 2, z), (x + length / 2, y + breadth / 2, z + depth)
        for axis, own in zip("xyz", zip(least, most, *extent, strict=True), strict=True):
            from_, to, start, end = own
            if from_ < start - _CLOSE or to > end + _CLOSE:
                sentence = f"it goes from {from_:g} m to {to:g} m along {axis}"
                right = f"{what} from {start:g} m to {end:g} m"
                findings.add((*path, "tanks", name), f"{sentence}, {right}; a tank is inside of it")
                break


def check_tank_names(findings: Findings) -> None:
    """Note tanks that share their full name, `<body>.<tank>`, with another or with what water does."""
    taken: dict[str, str] = {}
    for path, body, tanks in _with_tanks(findings.scenario):
        for name in tanks:
            full, own = f"{body}.{name}", (*path, "tanks", name)
            if name in _MEANT:
                findings.add(own, f"'{full}' means {_MEANT[name]}; this tank needs another name")
            elif full in taken:
                sentence = f"'{full}' is already a tank of '{taken[full]}'"
                findings.add(own, f"{sentence}; this one needs another name")
            taken.setdefault(full, body)


def _with_tanks(scenario: Scenario) -> list[tuple[Path, str, Mapping[str, BallastTank]]]:
    """All that has tanks: where the lift file has it, its name, its tanks."""
    found: list[tuple[Path, str, Mapping[str, BallastTank]]] = [
        (("vessels", name) if name in (scenario.vessels or {}) else ("mechanics", "bodies", name), name, own)
        for name, body in bodies_afloat(scenario).items()
        if (own := body.tanks)
    ]
    load = scenario.load
    return [*found, (("load",), load.name, load.tanks)] if load is not None and load.tanks else found
