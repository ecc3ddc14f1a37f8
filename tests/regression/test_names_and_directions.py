"""What a planner mistypes ended far away: `Statics.heavier({"bloc": 1e3})` with "there is no equilibrium at
t = 40 s: there is no such body (bloc)", a list with "'list' object has no attribute 'items'", `slid([1, 0])`
with "expected a sequence of length 3 (got 2)", `now("hook_load")` with "missing 1 required positional
argument".

`refined(recording, recording)` told that figures do not move at all, of a run that is no finer.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import gantline
from gantline import study

STATICS: Any = gantline.Statics("equalizer")
REFUSED: dict[str, Callable[[], object]] = {
    "the lift has no body 'bloc'; did you mean 'block'": lambda: STATICS.heavier({"bloc": 1e3}),
    r"direction: \[1, 0\] is no direction; x, y and z": lambda: STATICS.slid([1, 0]),
    "direction: 4.0 is no direction": lambda: STATICS.stick_range(4.0),
    r"direction: \[0, 0, 0\] is no direction": lambda: STATICS.slid([0, 0, 0]),
    r"slide: \[1, nan, 0\] is no direction": lambda: STATICS.equilibrium(slide=[1, float("nan"), 0]),
}


@pytest.mark.parametrize("said", REFUSED)
def test_what_is_mistyped_is_told(said: str) -> None:
    with pytest.raises(ValueError, match=said):
        REFUSED[said]()


def test_masses_come_by_names() -> None:
    with pytest.raises(TypeError, match="a dictionary of masses by names of bodies is needed, not list"):
        STATICS.heavier([("block", 1e3)])


def test_the_present_of_all_names() -> None:
    simulation = gantline.Simulation("equalizer")
    tensions = simulation.now("rope_tension")
    ropes = simulation.recording().coordinates["rope"]
    assert tensions.tolist() == [float(simulation.now("rope_tension", rope)) for rope in ropes]
    assert simulation.now("momentum").shape == (3,)


def test_a_run_is_no_finer_than_itself() -> None:
    recording = gantline.simulate("pulleys", duration=0.1)
    with pytest.raises(ValueError, match="the second run is no finer than the first; `finer_simulation`"):
        study.refined(recording, recording)
    simulation = gantline.Simulation("pulleys", duration=0.1)
    finer = study.finer_simulation(simulation, recording).run()
    assert study.refined(recording, finer).attributes["refinement"]["settings"]
    with pytest.raises(ValueError, match="no finer"):
        study.refined(finer, recording)


def test_a_direction_may_be_an_array() -> None:
    rest = STATICS.slid(np.array([1.0, 0.0, 0.0]))
    assert rest is not None and rest.residual < 1e-6
