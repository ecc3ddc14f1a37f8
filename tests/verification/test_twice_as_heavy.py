"""A lift with everything twice as heavy, as stiff and as strong moves as before, and pulls twice as much.

All forces of the equations are then twice what they were, and so are all masses: accelerations are the same.
"""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pytest

from gantline import Simulation, _core

#: Keys of what the core is given that stand for masses, forces and stiffnesses.
HEAVY = {"mass", "inertia", "axial_stiffness", "stiffness", "weight"}


def heavier(given: Any, key: str = "") -> Any:
    """The same with all numbers twice as large under these keys; dry friction of a joint is a torque, too."""
    if isinstance(given, dict):
        return {
            name: 2.0 * one if (key, name) == ("joint", "friction") else heavier(one, name)
            for name, one in given.items()
        }
    if isinstance(given, list):
        return [heavier(one, key) for one in given]
    is_number = isinstance(given, (int, float)) and not isinstance(given, bool)
    return 2.0 * given if is_number and key in HEAVY else given


def ran(document: Any, settings: dict[str, Any]) -> dict[str, Any]:
    core = _core.Simulation(json.dumps(document), json.dumps({**settings, "duration": 60.0}))
    core.run()
    return dict(core.columns())


def test_twice_as_heavy_moves_alike() -> None:
    """`goliath` while it takes up slack and evens its slings out, to the bit: a factor of two rounds nothing.

    Its sheaves and drums have twice the inertia, too. Where they keep that of discs of steel, which the lift
    file leaves to their size, the motion is another one.
    """
    lift = Simulation("goliath")
    before = json.loads(lift.assembly.document_text())
    once = ran(before, lift.settings)
    twice = ran(heavier(before), lift.settings)
    assert np.array_equal(twice["time"], once["time"])
    assert np.array_equal(twice["body_position"], once["body_position"])
    assert np.array_equal(twice["rope_tension"], 2.0 * once["rope_tension"])
    assert once["rope_tension"].max() > 10e3
    discs = heavier(before)
    for body, own in zip(discs["bodies"], before["bodies"], strict=True):
        if "inertia" in body["joint"]:
            body["joint"]["inertia"] = own["joint"]["inertia"]
    other = ran(discs, lift.settings)
    assert other["rope_tension"] != pytest.approx(2.0 * once["rope_tension"], rel=1e-6, abs=1.0)
