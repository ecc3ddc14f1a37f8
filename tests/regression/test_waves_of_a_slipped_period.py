"""Waves of which a digit or unit of the period or height has slipped, so that everything passes.

`peak_period: 80 s` for 8 s, and `8 min`, were in order: a template of 120 t went through a sea of 1.5 m as
through still water, and no word was said. Nor was of `significant_height: 1.5 mm`.
"""

from __future__ import annotations

import pytest

from column_in_waves import column
from gantline.assembly import assemble
from gantline.scenario import parse_scenario


def told(waves: str) -> str:
    return "\n".join(assemble(parse_scenario(column(f"{{{waves}, direction: 0 deg}}"))).warnings)


@pytest.mark.parametrize(
    ("waves", "said"),
    [
        (
            "significant_height: 1.5 m, peak_period: 80 s",
            "swell has a peak period of 80 s, longer than waves of wind and swell",
        ),
        (
            "significant_height: 1.5 m, peak_period: 8 min",
            "swell has a peak period of 480 s, longer than waves of wind and swell",
        ),
        ("height: 1.5 m, period: 80 s", "swell has a period of 80 s, longer than waves of wind and swell"),
        ("significant_height: 1.5 m, peak_period: 30.5 s", "swell has a peak period of 30.5 s"),
        ("height: 1.5 m, period: 61 s", "swell has a period of 61 s"),
        # A length of 9.81 m/s^2 (8 s)^2/2 pi = 99.9 m, 67,000 times as much.
        ("significant_height: 1.5 mm, peak_period: 8 s", "swell is 0.0015 m high at a peak of 8 s: no sea"),
        ("significant_height: 4.9 mm, peak_period: 8 s", "swell is 0.0049 m high at a peak of 8 s: no sea"),
    ],
)
def test_waves_that_none_are_are_told(waves: str, said: str) -> None:
    assert said in told(waves)
    assert "a unit or digit has slipped" in told(waves)


@pytest.mark.parametrize(
    "waves",
    [
        "significant_height: 0.1 m, peak_period: 18 s",
        "significant_height: 2 m, peak_period: 25 s",
        "significant_height: 2 m, peak_period: 29.5 s",
        "significant_height: 5.1 mm, peak_period: 8 s",
        "height: 1.5 mm, period: 8 s",
        "height: 1 m, period: 59 s",
        "significant_height: 20 mm, peak_period: 1.5 s",
        "height: 1 m, period: 40 s",
    ],
)
def test_swell_and_waves_of_a_model_are_not(waves: str) -> None:
    assert "slipped" not in told(waves)
