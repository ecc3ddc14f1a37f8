"""Whether vessels can float as they are said to, and hold what is said to be in them."""

from __future__ import annotations

import math
from collections.abc import Sequence

from gantline.scenario.afloat.vessel import CAPSIZED_BEYOND, DECK_EDGE, Vessel
from gantline.scenario.afloat.water import Afloat, Extent
from gantline.scenario.consistency.tanks import check_inside_of
from gantline.scenario.consistency.wind import check_areas
from gantline.scenario.findings import Findings, Path
from gantline.scenario.mechanics import BodyInertia

__all__ = ["check_afloat", "check_inertia", "check_inside", "check_vessels"]

_ROUNDING = 1 + 1e-9
#: A fairlead or fender may stand so far off the hull, on a platform or a boom [m].
_OFF_HULL = 10.0


def check_vessels(findings: Findings) -> None:
    """Note everything that is wrong with vessels."""
    for name, vessel in (findings.scenario.vessels or {}).items():
        path: Path = ("vessels", name)
        check_afloat(findings, path, vessel)
        if vessel.inertia is not None:
            check_inertia(findings, path, vessel.inertia, is_free=True)
        _check_radii(findings, path, vessel)
        extent = vessel.hull.extent
        if extent is not None:
            check_inside(findings, path, vessel, extent)


def check_afloat(findings: Findings, path: Path, body: Afloat) -> None:
    """Note a hull or tanks where nothing weighs anything, and areas in wind that comes from nowhere."""
    check_areas(findings, path, body.wind_areas)
    for key in ("hull", "tanks"):
        if getattr(body, key) is not None and findings.scenario.simulation.gravity == 0:
            findings.add((*path, key), "gravity is zero; water needs gravity above zero")


def check_inertia(findings: Findings, path: Path, inertia: BodyInertia, *, is_free: bool) -> None:
    """Note an inertia that no body has; a free body has one about each axis."""
    a, b, c = inertia.xx, inertia.yy, inertia.zz
    largest = max(a, b, c)
    products = ((inertia.yz, a), (inertia.xz, b), (inertia.xy, c))
    if min(a, b, c) < 0 or (is_free and min(a, b, c) == 0):
        bound = "above zero" if is_free else "never negative"
        findings.add((*path, "inertia"), f"xx, yy and zz of this body are {bound}")
    elif largest > (a + b + c - largest) * _ROUNDING or any(
        2 * abs(p) > own * _ROUNDING for p, own in products
    ):
        sentence = "no body has such an inertia; each of xx, yy, zz is at most the sum of the other two"
        findings.add((*path, "inertia"), f"{sentence}, and products are small")


def check_inside(findings: Findings, path: Path, vessel: Vessel, extent: Extent) -> None:
    """Note a draft, tanks and openings that do not fit a hull of this extent."""
    _check_draft(findings, path, vessel, extent)
    check_inside_of(findings, path, vessel.tanks, extent, "the hull")
    _check_openings(findings, path, vessel, extent)
    _check_ends(findings, str(path[-1]), extent)


def _check_radii(findings: Findings, path: Path, vessel: Vessel) -> None:
    squares = [radius**2 for radius in vessel.radii_of_gyration or ()]
    if squares and 2 * max(squares) > sum(squares) * _ROUNDING:
        sentence = "no body has such radii; the square of each is at most the sum of those of the other two"
        findings.add((*path, "radii_of_gyration"), sentence)


def _check_draft(findings: Findings, path: Path, vessel: Vessel, extent: Extent) -> None:
    keel, deck = extent[0][2], extent[1][2]
    if not keel < vessel.draft < deck:
        sentence = f"{vessel.draft:g} m is not between the keel at {keel:g} m and the deck at {deck:g} m"
        findings.add((*path, "draft"), f"{sentence}; a vessel floats with its deck dry")
    for key in ("heel", "trim"):
        if abs(getattr(vessel, key)) >= CAPSIZED_BEYOND:
            sentence = f"{math.degrees(getattr(vessel, key)):g} deg is no {key} to start from"
            findings.add(
                (*path, key), f"{sentence}; beyond {math.degrees(CAPSIZED_BEYOND):g} deg it has capsized"
            )


def _check_openings(findings: Findings, path: Path, vessel: Vessel, extent: Extent) -> None:
    for name, at in (vessel.openings or {}).items():
        if name == DECK_EDGE:
            findings.add((*path, "openings", name), f"'{name}' means that of the hull; use another name")
        elif at[2] <= extent[0][2]:
            sentence = f"z = {at[2]:g} m is not above the keel at {extent[0][2]:g} m"
            findings.add((*path, "openings", name), f"{sentence}; z counts from the vessel's origin")
        elif (off := _off(at[:2], extent[0][:2], extent[1][:2])) > _OFF_HULL:
            findings.add((*path, "openings", name), _outside(off, str(path[-1])))


def _check_ends(findings: Findings, vessel: str, extent: Extent) -> None:
    """Note lines that leave a vessel, and fenders on which it presses, where it is not."""
    low, high = extent
    ends = [
        (("mooring_lines", name, key), body, end)
        for name, line in (findings.scenario.mooring_lines or {}).items()
        for key, body, end in (("fairlead", line.vessel, line.fairlead), ("to", line.holder, line.to))
    ]
    fenders = (findings.scenario.fenders or {}).items()
    ends += [(("fenders", name, "at"), fender.vessel, fender.at) for name, fender in fenders]
    for path, body, end in ends:
        if body != vessel:
            continue
        off = _off(end, low, high)
        if off > _OFF_HULL:
            findings.add(path, _outside(off, vessel))


def _off(place: Sequence[float], low: Sequence[float], high: Sequence[float]) -> float:
    """How far a place is outside of an extent, along the axis along which that is most [m]."""
    return max(max(a - at, at - b) for a, at, b in zip(low, place, high, strict=True))


def _outside(off: float, vessel: str) -> str:
    sentence = f"this is {off:.4g} m outside the hull of '{vessel}'"
    return f"{sentence}; it counts along the vessel's axes, from stern, keel and centre plane"
