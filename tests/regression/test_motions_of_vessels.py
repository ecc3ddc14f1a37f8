"""Natural motions of vessels, which were told along the axes of the world.

A cargo barge that lay across another, heading 90 deg, "turns about x" with 5.95 s and "about y" with 5.31 s:
the first is its pitch, the second its roll. Seamen have names for them, along the axes of the barge.
"""

from __future__ import annotations

import math
from collections.abc import Collection
from pathlib import Path

import numpy as np
import pytest

from afloat import BREADTH, DRAFT, KG, LENGTH, MASS, barge, lift_of, written
from floating import SEA
from gantline.scenario import load_scenario
from gantline.statics import Statics
from gantline.statics.motion import in_words

G = 9.81


@pytest.mark.parametrize("heading", [0.0, 37.0, 90.0, -90.0])
def test_heave_roll_and_pitch_have_their_names_at_any_heading(tmp_path: Path, heading: float) -> None:
    """(WA7) without added mass: rho g A / m, and g GM / r^2 with GM = KB + I/V - KG, r 11 and 27 m."""
    given = lift_of(barge(heading=f"{heading} deg"), simulation={"gravity": f"{G} m/s^2"})
    statics = Statics(load_scenario(written(tmp_path, given)))
    statics.equilibrium(0.0)
    periods = {mode.motion: mode.period for mode in statics.modes() if mode.period is not None}

    def righting(size: float) -> float:
        return DRAFT / 2 + size**2 / (12 * DRAFT) - KG

    assert periods == pytest.approx(
        {
            "barge heaves": 2 * math.pi / math.sqrt(SEA * G * LENGTH * BREADTH / MASS),
            "barge rolls": 2 * math.pi * 11.0 / math.sqrt(G * righting(BREADTH)),
            "barge pitches": 2 * math.pi * 27.0 / math.sqrt(G * righting(LENGTH)),
        },
        rel=1e-6,
    )


def test_what_goes_together_is_named_together() -> None:
    """Half of the energy in sway and half in yaw; a third in each of two shifts; and a load as it was."""
    body = {"mass": 2.0, "inertia": (2.0, 2.0, 2.0, 0.0, 0.0, 0.0)}
    quarter = math.sqrt(0.5)
    across = np.array([quarter, 0.0, 0.0, quarter])  # its x axis along the world's y

    def told(*motion: float, vessels: Collection[str] = ("barge",)) -> str:
        return in_words(np.array([motion]), ["barge"], {"barge": body}, np.array([across]), vessels=vessels)

    assert told(1.0, 0.0, 0.0, 0.0, 0.0, 1.0) == "barge sways and yaws"
    assert told(0.0, 1.0, 1.0, 0.0, 1.0, 0.0) == "barge surges and heaves and rolls"
    assert told(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, vessels=()) == "barge moves along x and turns about z"
