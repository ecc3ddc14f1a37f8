"""Time to equalise in lift files, rig and table."""

from __future__ import annotations

import numpy as np
import pytest

from gantline.assembly import assemble
from gantline.cli.summary import summary
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from lift_text import BASE
from sample_lift import sample_recording, sample_rig

TIME = np.arange(6.0)
#: Spread (max - min)/mean of the five slings: 20, 16, 8, 4, 6 and 2 %.
SPREAD = np.array([0.20, 0.16, 0.08, 0.04, 0.06, 0.02])


def recording(**rig: object) -> Recording:
    tension = 1e5 * (1.0 + SPREAD[:, None] * np.linspace(-0.5, 0.5, 5))
    return sample_recording(TIME, tension=tension, rig={**sample_rig(), **rig})


def lines(found: Recording) -> list[str]:
    return [" ".join(line.split()) for line in summary(found, [], str) if "time to equalise" in line]


def test_the_bound_is_a_word_of_the_limits_and_no_limit() -> None:
    plain = assemble(parse_scenario(BASE)).rig
    assert "equalised_below" not in plain
    named = assemble(
        parse_scenario(BASE.replace("rule: example,", "rule: example, equalised_below: 2.5 %,"))
    ).rig
    assert named["equalised_below"] == 0.025
    assert "equalised_below" not in named["limits"]


def test_the_last_time_that_the_spread_is_above_the_bound_counts() -> None:
    """4 % at 3 s is below 5 %, but 6 % at 4 s is not: from 6 to 2 % a quarter of the way is 5 %."""
    found = recording()
    assert found.metrics()["time_to_equalise.e1"] == pytest.approx(4.25)
    assert lines(found) == ["time to equalise 4.25 s to a spread below 5 %, from 0.00 s on"]


def test_other_bounds() -> None:
    assert recording(equalised_below=0.18).metrics()["time_to_equalise.e1"] == pytest.approx(0.5)
    assert recording(equalised_below=0.3).metrics()["time_to_equalise.e1"] == 0.0
    never = recording(equalised_below=0.01)
    assert "time_to_equalise.e1" not in never.metrics()
    assert lines(never) == ["time to equalise -, the spread does not end below 1 % with all slings taut"]


@pytest.mark.parametrize(("begin", "end"), [(2.5, 2.96), (2.98, 2.98)])
def test_a_spread_that_comes_below_the_bound_between_two_samples(begin: float, end: float) -> None:
    """The last sling is slack at 2 s, with a spread of 5/4, and taut before 3 s, where the spread is none.

    5 % are 0.96 of the way: with no sample of that spread after the last sling is taut it was 0 s whenever.
    """
    tension = np.full((6, 5), 1e5)
    tension[:3, 4] = 0.0
    found = sample_recording(TIME, tension=tension, events=[(begin, "taut", "sling.S5")], rig=sample_rig())
    assert found.metrics()["time_to_equalise.e1"] == pytest.approx(end - begin)
