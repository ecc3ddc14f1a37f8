"""A crane afloat within the heel and trim of its chart as simulated, past them with the design weight: a GO.

`heel` and `trim` of its vessel were warned of by derivatives of the equilibria; the chart of the crane on
her, which holds up to an attitude, was held against that of the simulated weight alone.
"""

from __future__ import annotations

import math
from importlib.resources import files

import numpy as np
import pytest

from gantline.checks import Check, Verdict
from gantline.checks.booms import lean_at_design
from gantline.results import Recording
from gantline.scenario import parse_scenario
from gantline.statics import Statics
from lift_text import changed
from of_recording import check_of

#: Of the crane barge: length, draft [m], what contingency adds [kg], all that she displaces with it [kg].
LENGTH, DRAFT, MORE = 90.0, 3.0, 0.05 * 120e3
DISPLACED = 1025.0 * LENGTH * 30.0 * DRAFT
#: Where the head of her boom is along her [m].
HEAD = 84.0 + 55.0 * math.cos(math.radians(65.0))


def at_rest(
    name: str, simulated: str = "calculated", time: float | None = None, trim: str = "3 deg"
) -> Recording:
    """A scenario with a crane afloat at rest, its chart up to this trim of what bears the boom."""
    file = files("gantline.scenarios") / f"{name}.yaml"
    to = (
        ("simulate: calculated", f"simulate: {simulated}"),
        ("trim: 3 deg\n      off", f"trim: {trim}\n      off"),
    )
    return (
        Statics(parse_scenario(changed(file.read_text(encoding="utf-8"), *to), str(file)))
        .equilibrium(time)
        .recording
    )


def sheerleg(trim: str) -> Check:
    """What is said of her chart."""
    return check_of(at_rest("crane_barge_in_swell", trim=trim), "attitude_of_rating")


def test_a_chart_that_the_design_weight_leaves_is_a_warning() -> None:
    """By hand: 6 t more at the boom's head trim her by m (x - L/2)/(Δ GM), GM = L²/12T less some metres.

    As simulated she lies level to 0.001 deg.
    """
    by_hand = MORE * (HEAD - LENGTH / 2.0) / (DISPLACED * LENGTH**2 / (12.0 * DRAFT))
    assert math.degrees(by_hand) == pytest.approx(0.0115, abs=5e-5)
    between = sheerleg("0.009 deg")
    assert between.value is not None
    assert between.value < 0.15
    assert between.verdict is Verdict.WARNING
    told = float(between.remark.partition("with the design weight it comes to ")[2].partition(" %")[0])
    # By the bow, as what she has already; two hundredths are KG less KB, of 225 m, and her other 0.0007 deg.
    assert told / 100.0 * 0.009 == pytest.approx(math.degrees(by_hand) + 0.0007, rel=2e-2)
    kept = sheerleg("0.014 deg")
    assert (kept.verdict, kept.remark) == (Verdict.OK, "")


@pytest.mark.parametrize("time", [200.0, 720.0])
def test_a_crane_that_has_slewed_has_them_along_and_across_its_boom(time: float) -> None:
    """Over the side the vessel's heel is the trim of the crane; over the bow it is her trim.

    To first order: the equilibrium with the design weight differs by a hundredth of the change.
    """
    calculated, design = (at_rest("revolving_crane", one, time) for one in ("calculated", "design"))
    for way in ("heel", "trim"):
        was, told, lies = (
            float(one[-1])
            for one in (
                calculated.column(f"crane_{way}", "rc"),
                lean_at_design(calculated, "rc", way),
                design.column(f"crane_{way}", "rc"),
            )
        )
        assert told - was == pytest.approx(lies - was, rel=1.5e-2, abs=1e-7)
    assert np.array_equal(lean_at_design(design, "rc", "trim"), design.column("crane_trim", "rc"))
