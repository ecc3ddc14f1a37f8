"""A load that one hook sets down may turn about plumb: told where its place lets it by a little alone."""

from __future__ import annotations

import math

import pytest

from gantline.assembly import assemble
from gantline.scenario import parse_scenario
from guided_lift import MASS, guided_lift

POST = "post: {at: [3.5 m, 0 m, 0 m], diameter: 0.4 m, height: 1 m}"
FRAME = "frame: {at: [3.5 m, 0 m, 0 m], clearance: 30 mm, height: 0.6 m}"
LOWER = "  - {step: down, lower: crane, speed: 1 m/min, until: {supports: touched}}\n"
#: Two supports at the ends of the load, whose tops its corners leave as it turns.
SUPPORTS = (
    "supports: {{stools: {{under: module, grid: {{x: [-2.9 m, 2.9 m], y: [{y} m]}}, height: 0.3 m, "
    "top: [0.1 m, 0.1 m], stiffness: 100 MN/m, damping: 1 MN s/m, friction: 0.4}}}}"
)
TAG = "tag: {axial_stiffness: 150 kN, damping_time: 0.2 s, mass: none}"
LINE = "tag_lines: {one: {at: [3 m, 0 m, 1 m], to: [20 m, 0 m, 1 m], rope: tag, pull: 0.5 kN}}"


def told(text: str) -> list[str]:
    """Doubts of a heading."""
    return [one for one in assemble(parse_scenario(text)).warnings if "holds the heading" in one]


def lift(guide: str = f"{POST}, {FRAME}, friction: 0.2", *, plan: str = LOWER, more: str = "") -> str:
    text = guided_lift(f"  g: {{{guide}}}\n", height=2.0, plan=plan, more=more)
    text = text.replace("ropes: {", f"ropes: {{{TAG}, ", 1)
    return text if guide else text.replace("guides:\n  g: {}\n", "")


def test_a_guide_that_a_small_turn_misses() -> None:
    """Its frame goes 3.5 m ψ aside, and misses a blunt post by more than the 30 mm between them: 0.49 deg.

    The push of 0.1 kN is at a corner, √(3² + 1.5²) m out; the load is a box of 6 m by 3 m.
    """
    turn = 0.5  # the first tenth of a degree past it
    assert 0.4 < math.degrees(0.03 / 3.5) < turn
    inertia, arm = MASS * (6.0**2 + 3.0**2) / 12, math.hypot(3.0, 1.5)
    time = math.sqrt(2 * inertia * math.radians(turn) / (100.0 * arm))
    [doubt] = told(lift())
    assert "the one hook 'crane' sets it down: turned by 0.5 deg, it misses guide g; 100 N" in doubt
    assert f"{arm:.1f} m out, turns it so far in {time:.0f} s from rest. Tag lines hold it" in doubt


def test_wind_with_an_arm() -> None:
    """½ ρ C A u² 2 m turns it as well: 1.225 · 0.5 · 1.2 · 12 · 64 · 2 = 1.1 kN m."""
    areas = "  wind_areas: {side: {area: 12 m^2, coefficient: 1.2, along: y, at: [2 m, 0 m, 1 m]}}\ncranes:"
    text = lift().replace("cranes:", areas, 1) + "wind: {speed: 8 m/s, direction: 90 deg}\n"
    moment = 0.5 * 1.225 * 1.2 * 12 * 8**2 * 2
    time = math.sqrt(2 * MASS * 45 / 12 * math.radians(0.5) / moment)
    [doubt] = told(text)
    assert f"the wind with {moment / 1e3:.1f} kN m in {time:.0f} s" in doubt


def test_a_support_at_the_edge() -> None:
    """A corner of the load is 50 mm within the outer end of a top, and is off it as 2.95 m ψ are more."""
    at = 1.5 - 0.02  # 70 mm of the top are under the load
    [doubt] = told(lift("", more=SUPPORTS.format(y=at)))
    # The nearest corner of the top, 2.85 m out, has y = 1.43: it is off as 2.85 sin ψ = 1.5 - 1.43 cos ψ.
    turn = next(
        tenth / 10
        for tenth in range(1, 51)
        if 2.85 * math.sin(math.radians(tenth / 10)) > 1.5 - 1.43 * math.cos(math.radians(tenth / 10))
    )
    assert f"turned by {turn} deg, it is off stools." in doubt
    assert told(lift("", more=SUPPORTS.format(y=1.0))) == []


@pytest.mark.parametrize(
    "text",
    [
        pytest.param(lift().replace("30 mm", "0.4 m"), id="wide"),
        pytest.param(lift(plan=LOWER.replace("lower:", "hoist:").replace("touched", "clear")), id="hoists"),
        pytest.param(lift(more=LINE), id="tag line"),
    ],
)
def test_silent(text: str) -> None:
    """Where a large turn does no harm, where nothing is set down, and where a tag line holds it."""
    assert told(text) == []
