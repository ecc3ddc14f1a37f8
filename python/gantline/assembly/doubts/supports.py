"""Supports under a load at the start: where one cannot stand, and where it does not bear as one may think.

Of a load from CAD its own shape decides, the convex hull, of a box its underside.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from gantline.assembly.loads.load_body import LoadBody
from gantline.assembly.loads.under_load import UnderLoad, nothing_over
from gantline.scenario import Scenario
from gantline.scenario.consistency.supports import foot_of
from gantline.scenario.errors import Doubt
from gantline.scenario.findings import Findings
from gantline.scenario.loads.load import Load
from gantline.scenario.loads.structures import dock_of, ground_at

__all__ = ["bears_nothing", "check_under_load", "doubtful_supports", "shown_gap", "too_low"]

#: A load at rest may be given this far from the nearest support [m]; one less below it touches as they yield.
_STANDING = 1e-3
#: A top higher than this over the underside of a load is in the load and not under it [m].
_INSIDE = 0.1
#: Supports that are less below a load bear it as it settles, or as it is let down a little [m].
_NEAR = 0.1
#: CAD geometry that begins so much higher than its convex hull leaves a hollow [m].
_HOLLOW = 0.05
#: Sides that rise by so much more than friction holds slide off a level top [1]: 3 deg.
_SLIDES = 0.05
#: Sides that miss the convex hull by more than this are told [m].
_COARSE = 2e-3
#: Corners of a box are so far off a load that nearly fills it [m].
_OFF = 0.1
#: Supports that a sentence names.
_MOST_NAMED = 5


def check_under_load(scenario: Scenario, load: Load, body: LoadBody, under: Sequence[UnderLoad]) -> None:
    """Refuse supports that cannot stand where they are under a load from CAD; a lift file knows boxes itself.

    Args:
        scenario: the lift.
        load: the load.
        body: its shape.
        under: all supports, and where the load is over them.

    Raises:
        ScenarioError: with everything found.
    """
    if body.surface is None:
        return
    findings = Findings(scenario)
    for one in under:
        path = ("supports", one.support.group)
        if one.place is None and one.group.measured_from == "load":
            found = nothing_over(one.pad)
            findings.add(path, f"'{one.support.name}': {found}; move it under the load, or leave it out")
    _check_standing(findings, load, under)
    for one in under:
        is_under = foot_of(scenario, one.group) < load.position[2] + float(body.box[1, 2])
        if one.gap is not None and one.gap < -_INSIDE and is_under:
            findings.add(("supports", one.support.group), _inside(one))
    findings.raise_any()


def _check_standing(findings: Findings, load: Load, under: Sequence[UnderLoad]) -> None:
    """Note a load at rest that is not on the nearest of the supports on which it stands."""
    own = [one for one in under if one.support.group == load.stands_on]
    if not own or not findings.scenario.load_has_settled:
        return
    nearest = min((one for one in own if one.gap is not None), key=_gap, default=None)
    if nearest is None or nearest.gap is None:
        findings.add(("load", "stands_on"), f"no support of '{load.stands_on}' is under the load")
    elif abs(nearest.gap) > _STANDING:
        where = "above" if nearest.gap > 0 else "below"
        found = f"its underside is {abs(nearest.gap):.4g} m {where} '{nearest.support.name}'"
        found = f"{found}, the nearest of them"
        right = f"right is z = {load.position[2] - nearest.gap:.6g} m"
        findings.add(("load", "position"), f"the load stands on {load.stands_on} but {found}; {right}")


def _gap(one: UnderLoad) -> float:
    """Gap of a support that has one, without its rounding: of those that are alike the first is named [m]."""
    return round(one.gap or 0.0, 9)


def _inside(one: UnderLoad) -> str:
    assert one.place is not None and one.gap is not None  # asked of those with a place
    top = float(one.pad["at"][2])
    sentence = f"'{one.support.name}' stands inside the load at the start: its top is at {top:.4g} m"
    sentence = f"{sentence}, the underside of the load there at {one.place[2]:.4g} m"
    if one.own is None or one.own > top:
        sentence = f"{sentence}, that of its convex hull, which closes a hollow"
    return f"{sentence}; move it to where the load comes down, or the load to where it starts"


def bears_nothing(base: str, under: Sequence[UnderLoad], bears: Sequence[bool]) -> list[Doubt]:
    """Which supports that a load stands on are too low to bear anything at rest, and by how much.

    Args:
        base: name of their group.
        under: the supports.
        bears: whether each bears anything.
    """
    without = [one for one, some in zip(under, bears, strict=True) if not some]
    low = too_low(without)
    if not low:
        return []
    said = f"{len(without)} of {len(under)} supports of {base} bear nothing as the load stands at the start"
    return [Doubt(("supports", base), f"{said}: {low}; 'height: to_load' is up to it")]


def too_low(under: Sequence[UnderLoad]) -> str:
    """Supports that are lower than the underside of the load over them, and by how much; may be empty."""
    low = [
        f"'{one.support.name}' {shown_gap(one.gap)}"
        for one in under
        if one.gap is not None and one.gap > _STANDING
    ]
    return f"lower than its underside over them are {_listed(low)}" if low else ""


def doubtful_supports(
    scenario: Scenario, load: Load, body: LoadBody, under: Sequence[UnderLoad]
) -> Iterator[Doubt]:
    """Supports, and ground, that do not bear the load as one may think.

    Args:
        scenario: the lift.
        load: the load.
        body: its shape.
        under: all supports, and where the load is over them.
    """
    for name in scenario.supports or {}:
        own = [one for one in under if one.support.group == name]
        path = ("supports", name)
        yield from _buried(scenario, path, own)
        if name == load.stands_on and (beside := [one for one in own if one.place is None]):
            found = _listed([f"'{one.support.name}'" for one in beside])
            yield Doubt(path, f"nothing of the load is over {len(beside)} of {len(own)} supports: {found}")
        near = [one for one in own if one.gap is not None and one.gap < _NEAR]
        if body.surface is not None:
            yield from _hollow(path, near)
            yield from _steep(path, near)
    yield from _corners_in_the_air(scenario, load, body)
    if scenario.supports and body.sides_error > _COARSE:
        error = shown_gap(body.sides_error)
        sentence = (
            "the CAD file of the load: its convex hull has so many corners that what lies on supports is"
        )
        yield Doubt(("load", "shape", "cad"), f"{sentence} up to {error} within it, and heights off by that")


def _buried(scenario: Scenario, path: tuple[str, ...], own: Sequence[UnderLoad]) -> Iterator[Doubt]:
    """Supports whose tops lie under the ground, on which a load that is set down there stands before.

    In a dock, down to its floor, there is none.
    """
    deep: dict[str, float] = {}
    for one in own:
        x, y, top = one.pad["at"]
        level = ground_at(scenario, x, y)
        if level is not None and top < level - _STANDING:
            deep[one.support.name] = level - top
    if deep:
        lie = "lies" if len(deep) == 1 else "lie"
        most = shown_gap(max(deep.values()))
        found = f"{len(deep)} of {len(own)} {lie} up to {most} under the ground: "
        named = _listed([f"'{name}'" for name in deep])
        right = "a load that comes down there stands on the ground; see their 'foot' and 'height'"
        yield Doubt(path, f"tops of {found}{named}; {right}")


def _corners_in_the_air(scenario: Scenario, load: Load, body: LoadBody) -> Iterator[Doubt]:
    """Corners of a box by which a load from CAD stands on the ground, where nothing of the load is."""
    if load.shape.cad is None or load.stands_on != "ground" or dock_of(scenario) is not None:
        return  # around a dock the ground is touched by the hull
    (left, back, low), (right, front, _) = body.box
    corners = np.array([(x, y, low) for x in (left, right) for y in (back, front)])
    off = np.linalg.norm(corners[:, None] - body.hull, axis=2).min(axis=1)
    if (count := int((off > _OFF).sum())) > 0:
        sentence = f"on the ground the load stands on the corners of its box, of which {count} are up to"
        found = f"{sentence} {shown_gap(float(off.max()))} off any corner of its shape"
        yield Doubt(("load", "stands_on"), f"{found}; supports carry its own underside")


def _hollow(path: tuple[str, ...], near: Sequence[UnderLoad]) -> Iterator[Doubt]:
    """Those over which the convex hull closes a hollow of the load."""
    found = []
    for one in near:
        assert one.place is not None  # they have a gap
        if one.own is None:
            found.append(f"'{one.support.name}' nothing at all")
        elif one.own - float(one.place[2]) > _HOLLOW:
            found.append(f"'{one.support.name}' {shown_gap(one.own - float(one.place[2]))}")
    if found:
        sentence = "the load stands on its convex hull, which closes a hollow of its CAD geometry here"
        yield Doubt(path, f"{sentence}; how much higher that begins: {_listed(found)}")


def _steep(path: tuple[str, ...], near: Sequence[UnderLoad]) -> Iterator[Doubt]:
    """Those under a side that would slide off a level top."""
    found = [
        f"'{one.support.name}' {math.degrees(math.atan(one.rise)):.0f}°"
        for one in near
        if one.rise > one.support.friction + _SLIDES
    ]
    if found:
        sentence = f"the underside of the load rises by more than friction holds over {_listed(found)}"
        left = "its push to the side is not simulated: hold it, or cut the caps to the slope"
        yield Doubt(path, f"{sentence}; {left}")


def shown_gap(gap: float | None) -> str:
    """A height in mm, one of a metre and more in m; '-' without."""
    if gap is None:
        return "-"
    return f"{gap:.2f} m" if abs(gap) >= 1.0 else f"{1e3 * gap:.0f} mm"


def _listed(found: Sequence[str]) -> str:
    more = len(found) - _MOST_NAMED
    return f"{', '.join(found[:_MOST_NAMED])}{f' and {more} more' if more > 0 else ''}"
