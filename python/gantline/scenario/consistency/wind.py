"""Whether wind is such that something can stand in it."""

from __future__ import annotations

from collections.abc import Mapping

from gantline.scenario.afloat.stream import LoadArea, StreamArea, Wind
from gantline.scenario.findings import Findings, Path

__all__ = ["check_areas", "check_wind"]

#: More turbulence than wind has anywhere that cranes lift, standard deviation over mean.
_MOST_TURBULENCE = 0.5


def check_wind(findings: Findings) -> None:
    """Note gusts that are no faster than the mean, of no wind, or wilder than wind is."""
    wind = findings.scenario.wind
    if not isinstance(wind, Wind) or wind.gusts is None:
        return
    path, gusts = ("wind", "gusts"), wind.gusts
    if wind.speed == 0.0:
        findings.add(path, "there are no gusts without wind; 'speed' beside them is its mean")
    elif gusts.speed is not None and gusts.speed <= wind.speed:
        found = f"gusts of {gusts.speed:g} m/s are no faster than the mean of {wind.speed:g} m/s"
        findings.add((*path, "speed"), f"{found}; a gust is 1.2 to 1.6 times the mean")
    elif gusts.turbulence is not None and gusts.turbulence > _MOST_TURBULENCE:
        found = f"turbulence of {100 * gusts.turbulence:g} % is more than wind has"
        findings.add((*path, "turbulence"), f"{found}; 10 % at sea to 25 % between buildings")


def check_areas(findings: Findings, path: Path, areas: Mapping[str, LoadArea | StreamArea] | None) -> None:
    """Note areas in wind that has no direction."""
    wind = findings.scenario.wind
    if areas and isinstance(wind, float) and wind > 0:
        sentence = "the 'wind' of this lift is a speed alone and pushes nothing"
        right = f"write 'wind: {{speed: {wind:g} m/s, direction: 0 deg}}', or leave the areas out"
        findings.add((*path, "wind_areas"), f"{sentence}; {right}")
