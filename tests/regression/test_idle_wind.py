"""Wind of 14 m/s in a lift file, and nothing that it did.

It had no direction, so it pushed nothing; the cranes were crawlers, which have no `wind_limit`, so no check
held it against anything. The lift came out as in a calm, and nothing said so. Nor was it told of wind with a
direction that found no `wind_areas`.

Two crawler cranes in 20 m/s that pushed their load alone were GO: no boom feels wind here, and nothing says
in how much of it such a crane lifts.
"""

from __future__ import annotations

import pytest

from crawler_lift import crawler_lift
from four_slings import LIFT
from gantline.assembly import assemble
from gantline.scenario import parse_scenario

AREA = "  wind_areas: {side: {area: 18 m^2, coefficient: 1.2, along: x, at: [0 m, 0 m, 1.5 m]}}\n  lugs:\n"


@pytest.mark.parametrize(
    ("wind", "areas", "told"),
    [
        ("wind: none\n", "", ""),
        ("wind: 0 m/s\n", "", ""),
        ("wind: 14 m/s\n", "", "the wind of 14.0 m/s pushes nothing, being a speed without a direction"),
        ("wind: {speed: 14 m/s, direction: 0 deg}\n", "", "the wind of 14.0 m/s pushes nothing: no body has"),
        ("wind: {speed: 14 m/s, direction: 0 deg}\n", AREA, ""),
        ("current: {speed: 1 m/s, direction: 0 deg}\n", "", "the current of 1.0 m/s pushes nothing: no body"),
    ],
)
def test_a_stream_that_does_nothing_is_told(wind: str, areas: str, told: str) -> None:
    text = LIFT.replace("ground:", f"{wind}ground:")
    if areas:
        text = text.replace("  lugs:\n", areas)
    warnings = assemble(parse_scenario(text)).warnings
    assert [one[: len(told)] for one in warnings] == ([told] if told else [])


@pytest.mark.parametrize(("speed", "is_told"), [(13.9, False), (14.1, True)])
def test_wind_in_which_booms_do_not_lift_is_told(speed: float, is_told: bool) -> None:
    text = crawler_lift(60e3, more=f"wind: {{speed: {speed} m/s, direction: 0 deg}}\n")
    told = [one for one in assemble(parse_scenario(text)).warnings if "the booms of c1" in one]
    assert bool(told) is is_told
