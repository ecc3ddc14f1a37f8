"""How far apart samples are of a lift that does not say it."""

from __future__ import annotations

import pytest

from gantline.scenario import parse_scenario
from gantline.scenario.plan.times import usual_sample_interval
from lift_text import spoiled


@pytest.mark.parametrize(
    ("duration", "interval"),
    # 30,000 samples of 20 ms are 600 s, of 50 ms 1500 s, of 0.1 s 3000 s; three hours take 0.36 s and more.
    [
        (1e-3, 0.02),
        (40.0, 0.02),
        (600.0, 0.02),
        (600.1, 0.05),
        (1500.0, 0.05),
        (3000.0, 0.1),
        (10800.0, 0.5),
        (1e6, 50.0),
    ],
)
def test_the_least_round_number_with_no_more_than_thirty_thousand(duration: float, interval: float) -> None:
    assert usual_sample_interval(duration) == interval


@pytest.mark.parametrize(("said", "interval"), [("{}", 0.5), ("{sample_interval: 40 ms}", 0.04)])
def test_what_the_lift_file_says_goes_first(said: str, interval: float) -> None:
    text = spoiled("duration: 20 s", "duration: 3 h")
    own = next(line for line in text.splitlines() if line.startswith("simulation:"))
    assert parse_scenario(text.replace(own, f"simulation: {said}")).sample_interval == interval
