"""What is asked of a lift that is not at rest was answered by a panic, by garbage, or by NaN.

`Statics(lift).sensitivities()` as the first question ended in a panic of the core, `index out of bounds`,
where `modes()` finds the end of the lift by itself. The guard was in Python alone, and the core went on to
panic where it is asked without; now it answers with an error. After an equilibrium that does not exist the
same question gave derivatives about nowhere: a body in free fall answered to its mass by -9.81e6 m/kg. And
an increment of NaN gave an equilibrium of NaN, about which the next question failed with a bare pair of
texts.
"""

from __future__ import annotations

import pytest

import gantline
from gantline import _core
from gantline.scenario import parse_scenario
from gantline.statics import Statics
from lift_text import weight_on_a_rope

MASS, STIFFNESS, LENGTH, G = 100.0, 1e6, 5.0, 9.81
LIFT = weight_on_a_rope("100 kg")
FALLS = LIFT[: LIFT.index("  ropes:\n")]


def test_sensitivities_come_first() -> None:
    """T = m g, and z falls by g L/EA per kilogram: the end of the lift counts where none was asked for."""
    [mass] = Statics(parse_scenario(LIFT)).sensitivities([("mass", "weight")])
    assert mass.of("rope") == pytest.approx(G, rel=1e-9)
    assert mass.of_body("weight")[2] == pytest.approx(-G * LENGTH / STIFFNESS, rel=1e-6)


def test_nothing_is_answered_about_a_fall() -> None:
    """Sensitivities and modes say again that nothing holds it."""
    question = Statics(parse_scenario(FALLS))
    for ask in (question.equilibrium, lambda: question.sensitivities([("mass", "weight")]), question.modes):
        with pytest.raises(gantline.NoEquilibriumError, match="it falls without end"):
            ask()


def test_what_is_asked_is_about_the_last_one() -> None:
    """The rope is cut at 0.5 s: before that the weight swings, after it nothing does, and before it again."""
    question = Statics(parse_scenario(LIFT.replace("length: 5 m", "length: 5 m\n      cut_at: 0.5 s")))
    for _ in range(2):
        question.equilibrium(0.2)
        assert len(question.modes()) == 1
        with pytest.raises(gantline.NoEquilibriumError, match="at t = 1 s: nothing holds it"):
            question.equilibrium()
        with pytest.raises(gantline.NoEquilibriumError, match="at t = 1 s: nothing holds it"):
            question.modes()


def test_the_core_answers_about_no_equilibrium_with_an_error() -> None:
    """Before the first question, and after one that had no answer."""
    for text in (LIFT, FALLS):
        core = _core.Statics(Statics(parse_scenario(text)).assembly.document_text())
        if text == FALLS:
            with pytest.raises(RuntimeError, match="it falls without end"):
                core.settle()
        with pytest.raises(RuntimeError, match="none has been found about which it could be asked"):
            core.sensitivities([("mass", "weight")])


@pytest.mark.parametrize("part", [float("nan"), float("inf")])
def test_an_increment_is_finite(part: float) -> None:
    with pytest.raises(ValueError, match=r"increment: .* has a part that is not finite"):
        Statics(parse_scenario(LIFT)).equilibrium(increment=[part])


def test_wrong_names_are_answered_with_right_ones() -> None:
    """`of` said `tuple.index(x): x not in tuple`."""
    question = Statics(parse_scenario(LIFT))
    with pytest.raises(ValueError, match="no sensitivity to 'lenth'; there are length, stiffness, mass"):
        question.sensitivities([("lenth", "rope")])
    [mass] = question.sensitivities([("mass", "weight")])
    with pytest.raises(KeyError, match="no 'ropes'; there are rope"):
        mass.of("ropes")
    with pytest.raises(KeyError, match="no 'wait'; there are weight"):
        mass.of_body("wait")


@pytest.mark.parametrize("wrong", [{"frames": 0}, {"frames": -1}, {"amplitude": float("nan")}])
def test_a_swing_has_frames_and_an_amplitude(wrong: dict[str, float]) -> None:
    question = Statics(parse_scenario(LIFT))
    [mode] = question.modes()
    with pytest.raises(ValueError, match="can be shown"):
        question.swing(mode, **wrong)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="count: -1 is no whole number from 0 on"):
        question.modes(-1)


@pytest.mark.parametrize("wrong", [None, 0])
def test_what_swings_is_a_mode(wrong: object) -> None:
    """A number said that it has no `body_motion`."""
    question = Statics(parse_scenario(LIFT))
    question.modes()
    with pytest.raises(ValueError, match=rf"mode: {wrong} is no Mode; modes\(\) answers with them"):
        question.swing(wrong)  # type: ignore[arg-type]


def test_answers_can_be_compared_and_shown() -> None:
    """`==` of two modes raised an error of arrays, and a list of them filled a page."""
    question = Statics(parse_scenario(LIFT))
    [mode] = question.modes()
    [again] = question.modes()
    assert mode == mode and mode != again
    # Natural period 2 pi sqrt(m/k), k = (EA/L) of the stretched rope's own length.
    assert repr(mode).startswith("<Mode 1: weight moves along z; period 0.1405 s")
    [length] = question.sensitivities([("length", "rope")])
    assert repr(length).startswith("<Sensitivity to length of rope: 1 ropes; most in rope:")
    assert repr(question) == "<Statics 'A weight on a rope'>"
