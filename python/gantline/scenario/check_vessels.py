"""Whether vessels can float as they are said to, and hold what is said to be in them."""

from __future__ import annotations

from collections.abc import Mapping

from gantline.scenario.findings import Findings, Path
from gantline.scenario.mechanics import BodyInertia
from gantline.scenario.stream import StreamArea
from gantline.scenario.water import Afloat

__all__ = ["check_afloat", "check_areas", "check_inertia", "check_vessels"]

_ROUNDING = 1 + 1e-9


def check_vessels(findings: Findings) -> None:
    """Note everything that is wrong with vessels."""
    for name, vessel in (findings.scenario.vessels or {}).items():
        path: Path = ("vessels", name)
        check_afloat(findings, path, vessel)
        check_inertia(findings, path, vessel.own_inertia, is_free=True)


def check_afloat(findings: Findings, path: Path, body: Afloat) -> None:
    """Note a hull or tanks where nothing weighs anything, and areas in wind that comes from nowhere."""
    check_areas(findings, path, body.wind_areas)
    for key in ("hull", "tanks"):
        if getattr(body, key) is not None and findings.scenario.simulation.gravity == 0:
            findings.add((*path, key), "gravity is zero; water needs gravity above zero")


def check_areas(findings: Findings, path: Path, areas: Mapping[str, StreamArea] | None) -> None:
    """Note areas in wind that has no direction."""
    wind = findings.scenario.wind
    if areas and isinstance(wind, float) and wind > 0:
        sentence = "the 'wind' of this lift is a speed alone and pushes nothing"
        right = f"write 'wind: {{speed: {wind:g} m/s, direction: 0 deg}}', or leave the areas out"
        findings.add((*path, "wind_areas"), f"{sentence}; {right}")


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
