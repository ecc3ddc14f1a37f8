"""`while run.time < 5.0: run.advance_to(run.time + 0.1)` never ended. The fiftieth sum is
4.999999999999998 s, at which the run had ended within rounding, so that no further call moved it.

It ends at its duration now.
"""

from __future__ import annotations

import pytest

import gantline


@pytest.mark.parametrize("method", [{"integrator": "adaptive"}, {"integrator": "del", "step": 0.02}])
def test_sums_of_steps_come_to_the_end(method: dict[str, object]) -> None:
    run = gantline.Simulation("pulleys", duration=5.0, **method)
    calls = 0
    while run.time < 5.0 and calls < 60:
        run.advance_to(run.time + 0.1)
        calls += 1
    assert run.ended
    assert run.time >= 5.0
    assert calls in (50, 51)  # of 0.1 s; one more where steps of 20 ms end beside them
    assert run.recording().time[-1] == pytest.approx(5.0, rel=1e-12)


def test_short_of_the_end_by_more_than_rounding_is_before_it() -> None:
    run = gantline.Simulation("pulleys", duration=1.0, integrator="adaptive")
    run.advance_to(1.0 - 1e-9)
    assert not run.ended
    assert run.time == 1.0 - 1e-9
