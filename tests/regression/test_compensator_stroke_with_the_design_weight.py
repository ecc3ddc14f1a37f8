"""A rod that keeps its way from the outer stop with the simulated weight, and not with the design weight.

A gas spring is soft: a tenth more of 70 t has the rod of the lift of docs/concepts/compensator.md 0.68 m
farther out, 23 % of its stroke. `compensator_stroke_margin` held the way as it was simulated against its
limit, and said nothing of a rod that the design weight would have on its stop, where a compensator is none.
"""

from __future__ import annotations

import math

import pytest

from gantline.checks import Check, Verdict
from gantline.results import Recording
from gantline.scenario import parse_scenario
from gantline.statics import Statics
from lift_text import changed
from of_recording import checks_of
from shown import ROOT, lift_on, unsaid

TEXT = lift_on(ROOT / "docs" / "concepts" / "compensator.md", "A manifold under a passive compensator")
#: Stroke [m], pulls of the gas at both ends of it [N], exponent, and the column of gas by (PC2) [m].
STROKE, ROD_IN, ROD_OUT, N = 3.0, 600e3, 900e3, 1.1
COLUMN = STROKE / (1.0 - math.pow(ROD_IN / ROD_OUT, 1.0 / N))
G = 9.81


def lift(mass: float, contingency: float, limit: str) -> Recording:
    """The lift of that page with another load [t] and without seals, at rest at its end."""
    text = changed(
        TEXT,
        ("calculated: 70 t", f"calculated: {mass} t, contingency: {contingency}, simulate: calculated"),
        ("    seal_friction: 20 kN\n", ""),
        ("load_tilt: 5 deg", f"load_tilt: 5 deg, compensator_stroke_margin: {limit}"),
    )
    return Statics(parse_scenario(text, "lift.yaml")).equilibrium().recording


def told(recording: Recording) -> Check:
    [check] = checks_of(recording, "compensator_stroke_margin")
    return check


def out(mass: float) -> float:
    """(PC1) turned round: the rod of 2 t and so much below it pull the gas with their weight."""
    pull = (mass + 2.0) * 1e3 * G
    return COLUMN * (1.0 - math.pow(ROD_IN / pull, 1.0 / N))


def test_a_limit_between_both_is_a_warning() -> None:
    """1.32 m out of 70 t, 2.00 m of 77 t, of 3 m: 44 % from the inner stop, 33 % from the outer one."""
    farther = out(77.0) - out(70.0)
    assert farther == pytest.approx(0.68, abs=0.01)
    said = f"by (PC1): {farther:.2f} m of 3 m for a tenth more of the 70 t above"
    assert unsaid("docs/concepts/compensator.md", said) == []
    recording = lift(70.0, 1.1, "40 %")
    # What stands for the gas has chords, 1e-4 of the pull, which is 0.8 mm.
    assert float(recording.column("rod_out", "PHC")[-1]) == pytest.approx(out(70.0), abs=1e-3)
    check = told(recording)
    assert check.verdict is Verdict.WARNING
    with_design = float(check.remark.partition("with the design weight it comes to ")[2].partition(" %")[0])
    assert with_design == pytest.approx(100.0 * (1.0 - out(77.0) / STROKE), abs=0.1)


def test_a_rod_that_the_design_weight_has_on_its_stop_is_told() -> None:
    """84 t pull 844 kN and leave 14 %; with 8.4 t more it is 926 kN, and the gas has 900."""
    assert out(84.0) < STROKE < out(92.4)
    check = told(lift(84.0, 1.1, "10 %"))
    assert check.verdict is Verdict.WARNING
    assert "with the design weight the rod of PHC comes to its outer stop" in check.remark


@pytest.mark.parametrize("contingency", [1.0, 1.02])
def test_a_margin_that_both_keep_is_kept(contingency: float) -> None:
    """1.4 t more have it 0.15 m farther out: 50 % are left."""
    check = told(lift(70.0, contingency, "40 %"))
    assert (check.verdict, check.remark) == (Verdict.OK, "")
