"""Contents of tanks wanted at the end of a step that waits for something, which they move.

The moment was the end of the step with the contents that the lift file gives. With those found the load came
off 109 s earlier, or 58 s later, and they were for whatever the plan did at the old moment; where the load
then still stood in part, trim and load went to and fro and there was no answer.
"""

from __future__ import annotations

import pytest

from crane_off_quay import taken_at_once
from gantline.scenario.file.variants import with_values
from gantline.statics import Statics
from gantline.study import solve_ballast
from gantline.study.afloat import Afloat
from gantline.study.moment import end_of_step

STEP = "lift off"


def test_the_moment_is_the_end_of_the_step_with_the_contents_found() -> None:
    """600 t too far aft: by the stern, with its boom head higher, so that the load comes off too soon."""
    contents = {1: 827.75 + 150.0, 2: 1610.25 - 150.0}
    changes = {
        f"vessels.barge.tanks.row{row}.{number}.content": f"{content!r} t"
        for row, content in contents.items()
        for number in (1, 2, 3, 4)
    }
    given = with_values(taken_at_once("1000 s"), changes)
    before = end_of_step(Statics(given), STEP)
    answer = solve_ballast(given, step=STEP)
    question = Statics(answer.scenario)
    after = end_of_step(question, STEP)
    assert before is not None
    assert after is not None
    assert max(before, after) < 950.0
    assert abs(after - before) > 10.0
    assert answer.time == after
    then = Afloat(question, "barge", after)
    assert then.rest.recording.column("load_transferred", "load")[-1] == pytest.approx(1.0, abs=1e-9)
    assert (then.attitude.heel, then.attitude.trim) == pytest.approx((0.0, 0.0), abs=1e-5)
