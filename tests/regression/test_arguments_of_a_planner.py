"""What ended in words of Python: `solve_ballast(lift, heel="2 deg")` with "bad operand type for abs():
'str'", `adjust_lengths(lift, slopes=0)` with "'int' object is not iterable", `run_steps(lift)` with
"'Scenario' object has no attribute 'equilibrium'", `float_free` with the signature of a product of matrices.

`Statics.when("hoist", "starts")` was taken for `begins`, and `Gumbel.of([1.0])` was nan.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import gantline
from gantline import hydro, study
from gantline.checks import lug_figures
from gantline.rule_data import dynamic_factor, several_cranes

TEXT: Any = "1 t"
NUMBER: Any = 4.0
LIFT: Any = gantline.load_scenario("equalizer")
BOX = hydro.box_hull((100.0, 30.0, 8.0))
STATICS: Any = gantline.Statics(LIFT)
TOLD: dict[str, Callable[[], object]] = {
    "heel: '1 t' is no number of radians": lambda: study.solve_ballast("floating_crane", heel=TEXT),
    "draft: '1 t' is no number of metres": lambda: study.solve_ballast("floating_crane", draft=TEXT),
    "slopes: 4.0 are no two angles in radians": lambda: study.adjust_lengths(LIFT, slopes=NUMBER),
    "heading: '1 t' is no number of radians": lambda: study.adjust_lengths(LIFT, heading=TEXT),
    "shares: S1: '1 t' is no number of parts": lambda: study.adjust_lengths(LIFT, shares={"S1": TEXT}),
    "a scenario is needed, not Statics": lambda: study.margins_of(STATICS, TEXT),
    "a lift to ask for equilibria is needed, not Scenario": lambda: list(study.run_steps(LIFT)),
    "for equilibria is needed, not str": lambda: study.tilting_of(TEXT, TEXT, []),
    "more of [a-z]+: '1 t' is no number of kilograms": lambda: STATICS.heavier({"block": TEXT}),
    "a saved state is needed, not str": lambda: STATICS.equilibrium_of(TEXT),
    "box: a side: '1 t' is no number of metres": lambda: hydro.box_hull((TEXT, TEXT, TEXT)),
    "an attitude is needed, not float": lambda: hydro.hydrostatics(BOX, NUMBER),
    "mass: '1 t' is no number of kilograms": lambda: hydro.float_free(BOX, TEXT, (50.0, 0.0, 5.0)),
    "a recording is needed, not str": lambda: lug_figures(TEXT),
    "a preset is needed, not str": lambda: dynamic_factor(TEXT, 1e5),
}


@pytest.mark.parametrize("told", TOLD)
def test_what_is_of_another_kind_is_told(told: str) -> None:
    with pytest.raises(TypeError, match=told):
        TOLD[told]()


def test_what_is_no_value_is_told() -> None:
    with pytest.raises(ValueError, match="moment: 'starts' is none; a step 'begins' or 'ends'"):
        STATICS.when("hoist", "starts")
    with pytest.raises(ValueError, match=r"centre_of_gravity: 4\.0 is no point; x, y and z"):
        hydro.float_free(BOX, 1e7, NUMBER)
    with pytest.raises(KeyError, match="no rule for several cranes is 'iso'; there are queensland"):
        several_cranes("iso", 2)
    with pytest.raises(ValueError, match="of 1 there is no spread; two or more are needed"):
        study.Gumbel.of([1.0])


def test_numbers_of_numpy_are_numbers() -> None:
    answer = study.adjust_lengths(LIFT, slopes=(np.float64(0.0), np.float64(0.0)), time=30.0)
    assert answer.residual < 1e-6


def test_one_angle_is_a_row_of_one() -> None:
    """A box in deep heel rights by as much alone as among others."""
    one = hydro.righting_arms(BOX, 1e7, (50.0, 0.0, 5.0), NUMBER / 20.0)
    both = hydro.righting_arms(BOX, 1e7, (50.0, 0.0, 5.0), [0.0, 0.2])
    assert one.arm.shape == (1,)
    assert one.arm[0] == pytest.approx(both.arm[1], rel=1e-9)
