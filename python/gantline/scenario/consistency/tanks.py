"""Whether tanks are inside of what has them, and have names of their own."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import product

from gantline.scenario.afloat.tanks import bodies_afloat, holes_of
from gantline.scenario.afloat.water import BallastTank, Extent
from gantline.scenario.cranes.hooks import full_name
from gantline.scenario.errors import nearest
from gantline.scenario.findings import Findings, Path
from gantline.scenario.loads.cylinder import Cylinder
from gantline.scenario.model import Scenario

__all__ = [
    "check_holes",
    "check_inside_of",
    "check_load_tanks",
    "check_round_tanks",
    "check_tank_names",
    "check_turned_holes",
]

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
        out = max(-cylinder.depth(corner) for corner in product(*tank.extents))
        if out > _CLOSE:
            sentence = f"a corner of it is {out:.3g} m outside the round load"
            findings.add(("load", "tanks", name), f"{sentence}; a tank is inside of it")


def check_inside_of(
    findings: Findings, path: Path, tanks: Mapping[str, BallastTank] | None, extent: Extent, what: str
) -> None:
    """Note tanks that stick out of something, in words, of this extent; of each the first axis."""
    for name, tank in (tanks or {}).items():
        for axis, (from_, to), start, end in zip("xyz", tank.extents, *extent, strict=True):
            if from_ < start - _CLOSE or to > end + _CLOSE:
                sentence = f"it goes from {from_:g} m to {to:g} m along {axis}"
                right = f"{what} from {start:g} m to {end:g} m"
                findings.add((*path, "tanks", name), f"{sentence}, {right}; a tank is inside of it")
                break


def check_holes(findings: Findings) -> None:
    """Note holes that are outside of their tank, or larger than any side of it."""
    for path, _, tanks in _with_tanks(findings.scenario):
        for name, tank in tanks.items():
            sizes = sorted(tank.box)
            largest = sizes[1] * sizes[2]
            for hole_name, hole in (tank.holes or {}).items():
                own = (*path, "tanks", name, "holes", hole_name)
                for axis, at, (low, high) in zip("xyz", hole.at, tank.extents, strict=True):
                    if not low - _CLOSE <= at <= high + _CLOSE:
                        sentence = f"it is at {at:g} m along {axis}, its tank from {low:g} m to {high:g} m"
                        findings.add((*own, "at"), f"{sentence}; a hole is in the tank, or in a side of it")
                        break
                if hole.area > largest:
                    sentence = f"a hole of {hole.area:g} m^2 has no room in a tank whose largest side has"
                    findings.add((*own, "area"), f"{sentence} {largest:g} m^2")


def check_turned_holes(findings: Findings) -> None:
    """Note steps that open or close what is no hole, is open or closed already, or is both by one step."""
    scenario = findings.scenario
    known = holes_of(scenario)
    is_open = {name: not hole.closed for name, hole in known.items()}
    turned: dict[str, str] = {}
    for place, step in enumerate(scenario.plan):
        own: set[str] = set()
        for key, names in (("open_holes", step.open_holes), ("close_holes", step.close_holes)):
            opens = key == "open_holes"
            for text in names:
                name, path = full_name(text, known), ("plan", place, key)
                if name is None:
                    right = nearest(text, known) if known else "no tank of this lift has 'holes'"
                    findings.add(path, f"'{text}' is not a hole of a tank, or of more than one; {right}")
                elif name in own:
                    sentence = f"'{text}' is opened and closed, or named twice, by one step"
                    findings.add(path, f"{sentence}; a step for each is right")
                elif is_open[name] is opens:
                    state = "open" if opens else "closed"
                    by = f"step '{turned[name]}' has left it so" if name in turned else _at_start(opens)
                    findings.add(path, f"'{text}' is {state} already: {by}")
                if name is not None:
                    own.add(name)
                    is_open[name], turned[name] = opens, step.step


def _at_start(is_open: bool) -> str:
    return "it is from the start on; 'closed: true' has it begin closed" if is_open else "it begins so"


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
