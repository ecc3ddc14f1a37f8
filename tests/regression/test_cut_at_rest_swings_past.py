"""A case that cuts a sling told how the others rest without it, and nothing of how far they swing before.

Of two slings to one place each bears half of 100 t; one of them alone rests with all of it, 981 kN. What
comes on at once comes on twice: it swings to 1.5 W, 1471.5 kN, as a run shows.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from gantline.results.series import rope_peak
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from gantline.study import run_cases
from lift_text import changed
from program import called
from two_slings import LIFT, LOAD, G

CASES = changed(LIFT, (", cut_at: 10 s", ""), ("limits:", "cases:\n  sling: {cut: B}\nlimits:"))


def test_it_tells_what_comes_on_twice() -> None:
    """W/2 + 2 (W - W/2); a run of the same has the first swing damped, by 0.3 %."""
    _, cut = run_cases(parse_scenario(CASES, "lift.yaml")).states
    assert cut.swings_to == {"A": pytest.approx(1.5 * LOAD * 1e3 * G, rel=1e-6)}
    peak, _ = rope_peak(simulate(parse_scenario(LIFT, "lift.yaml")), "sling.A")
    assert cut.swings_to["A"] == pytest.approx(peak, rel=5e-3)


def test_the_table_says_so(tmp_path: Path) -> None:
    path = tmp_path / "lift.yaml"
    path.write_text(CASES, encoding="utf-8")
    said = " ".join(called("cases", path).stdout.split())
    assert "sling is at rest: A swings to 1471.5 kN on the way there, by twice what comes on" in said


def test_nothing_is_said_where_nothing_comes_on() -> None:
    """A sling that is cut below an equalizer, or carries nothing, leaves the others with no more."""
    slack = changed(CASES, ("B: {from: crane, to: box.B}", "B: {from: crane, to: box.B, length: 21.5 m}"))
    _, cut = run_cases(parse_scenario(slack, "lift.yaml")).states
    assert cut.swings_to == {} and cut.in_vain
