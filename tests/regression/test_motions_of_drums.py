"""Natural motions of drums and sheaves, which were told as motions of the load.

A tugger of constant pull has a drum of its own, and its rope's stretch lets that swing: 20 kg on 55 m of rope
of 1 MN, 0.21 s. Energy was counted of bodies alone, so the table of motions had "load moves along x and turns
about y" for it, whose load moved by a two thousandth of what the drum paid out.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from gantline.scenario import parse_scenario
from gantline.statics import Mode, Statics
from gantline.statics.motion import in_words
from tugged_load import LIFT, PULL

STIFFNESS = 1e6  # EA of the tag line [N]


@pytest.fixture(scope="module")
def question() -> Statics:
    statics = Statics(parse_scenario(LIFT))
    statics.equilibrium(40.0)
    return statics


def of_the_tugger(question: Statics) -> Mode:
    (found,) = [mode for mode in question.modes() if mode.motion == "drum tag.line.tugger turns"]
    return found


def test_a_drum_is_named(question: Statics) -> None:
    """T = 2 pi sqrt(m L/EA) of what turns over its radius squared; L is less by what the pull stretches."""
    mode = of_the_tugger(question)
    inertia = question.assembly.document["bodies"][-1]["joint"]["inertia"]
    (stretched,) = question.equilibrium(40.0).recording.column("segment_length", "tag.line/0")[-1:]
    length = stretched / (1.0 + PULL / STIFFNESS)
    # The load, 2000 times as heavy, gives a little.
    assert mode.period == pytest.approx(2 * math.pi * math.sqrt(inertia * length / STIFFNESS), rel=1e-3)
    assert mode.flows.keys() == {"tag.line.tugger"}
    # x' M x = 1: all of it is the drum's.
    assert inertia * mode.flows["tag.line.tugger"] ** 2 == pytest.approx(1.0, rel=1e-2)


def test_those_of_the_load_are_told_as_before(question: Statics) -> None:
    told = [mode.motion for mode in question.modes()]
    assert told[:4] == ["load turns about z", *(f"load moves along {axis}" for axis in "xyz")]
    assert told[-1] == "hook moves along z"


def test_its_swing_is_as_large_as_that_of_any(question: Statics) -> None:
    """Scaled by the body that moves most, the drum paid out 1.2 km."""
    mode = of_the_tugger(question)
    swung = question.swing(mode, amplitude=0.5, frames=5)
    place = swung.column("body_position", "load")
    moved = np.abs(place - place[0]).max()
    assert moved <= 0.5 * np.abs(mode.of_body("load")).max() / mode.flows["tag.line.tugger"] * 1.01


def test_rope_over_a_sheave() -> None:
    """Half the energy each is a body's and a sheave's: 1/2 m v²."""
    upright = np.array([[1.0, 0.0, 0.0, 0.0]])
    bodies = {
        "load": {"mass": 4.0, "inertia": [1.0, 1.0, 1.0, 0.0, 0.0, 0.0]},
        "sheave_1": {"mass": 0.0, "joint": {"type": "flow", "inertia": 16.0}},
    }
    motion = np.array([[1.0, 0.0, 0.0, 0.0, 0.0, 0.0]])
    told = in_words(motion, ["load"], bodies, upright, {"sheave_1": 0.5})
    assert told == "load moves along x, sheave sheave_1 turns"
    assert in_words(motion, ["load"], bodies, upright, {"sheave_1": 0.1}) == "load moves along x"
