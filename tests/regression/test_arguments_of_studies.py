"""What studies, saved states and progress are handed in by mistake, and how it ended.

`finer_simulation("equalizer", recording)` ended with "'str' object has no attribute 'settings'", `values_of`
of a text with "... has no attribute 'rest'", `restore("abc")` with "'str' object is not an instance of
'bytes'", and `on_progress=3` with "'int' object is not callable".
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

import gantline
from gantline import study


def lift(**settings: Any) -> gantline.Simulation:
    return gantline.Simulation("pulleys", duration=0.1, **settings)


A_SIMULATION = "a simulation is needed, not str; gantline.Simulation makes one of a lift"
A_STATE = r"a state of a lift is needed, not str; gantline.study.run_cases\(...\).states has some"
BYTES = "a saved state is needed, not str; `save` of a simulation gives one, in bytes"
A_FUNCTION = "on_progress: a function is needed, not int; such as `on_progress=print`"
A_RECORDING = "a recording is needed, not str; gantline.open_recording reads a file"
WRONG: Any = "abc"
THREE: Any = 3


@pytest.mark.parametrize(
    ("ask", "told"),
    [
        (lambda: study.finer_simulation(WRONG, lift().run()), A_SIMULATION),
        (lambda: study.finer_simulation(lift(), WRONG), A_RECORDING),
        (lambda: study.refined(WRONG, WRONG), A_RECORDING),
        (lambda: study.values_of(WRONG), A_STATE),
        (lambda: study.worst_of(WRONG), A_STATE),
        (lambda: lift().restore(WRONG), BYTES),
        (lambda: lift().run(on_progress=THREE), A_FUNCTION),
        (lambda: gantline.simulate("pulleys", on_progress=THREE), A_FUNCTION),
        (lambda: study.run_cases("pulleys", on_progress=THREE), A_FUNCTION),
        (lambda: study.run_seas("crane_barge_in_swell", on_progress=THREE), A_FUNCTION),
        (lambda: study.solve_ballast("floating_crane", on_progress=THREE), A_FUNCTION),
    ],
)
def test_it_is_told_what_is_needed(ask: Callable[[], object], told: str) -> None:
    with pytest.raises(TypeError, match=told):
        ask()


def test_a_run_that_was_refused_goes_on() -> None:
    one = lift()
    with pytest.raises(TypeError, match=A_FUNCTION):
        one.run(on_progress=THREE)
    assert one.status == "ready"
    assert one.run(on_progress=lambda _: None).attributes["status"] == "done"
