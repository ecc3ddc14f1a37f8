"""A barge whose GM was 15 m too large as a load that hangs from a crane ashore leaned on guides of her deck.

What stands on a deck goes along with it as a vessel is inclined, since friction holds it at an angle so
small: each contact between a vessel and what does not float was taken for one on which something stands,
guides too, and those without friction. So the side of a barge was tied to the slings of a crane ashore,
which are stiff: GM 17.4 m for 2.8 m, and a limit of 5 m was kept. Now something stands where what presses
is within 50 degrees of plumb.

A guide still pushes: a load that is a pendulum of length L with the weight W, h above the axis about which
she heels, rights her by W h^2/L, a few centimetres of GM.
"""

from __future__ import annotations

from typing import Any

import pytest

from ballasted import ADDED, BREADTH, DAMPED, LENGTH, OWN, barge, lift
from gantline.checks import Verdict, check_recording
from gantline.scenario import Scenario
from gantline.statics import Statics
from gantline.statics.inclining import metacentric_heights

SEA = 1025.0
#: Centre of gravity of the barge [m], and what weighs and hangs [kg, m].
HIGH, LOAD, HOOK = 20.0, 100e3, 17.0


def leaning(friction: float, inside: float) -> Scenario:
    """The load with two bumpers so far inside the faces of walls on deck [m] as it hangs plumb."""
    walls = {"faces": "90 deg", "breadth": "2 m", "height": "3 m"}
    guides = {
        name: {
            "held_by": "barge",
            "wall": {"at": [f"{50 + x} m", f"{-13.18 + inside} m", "8 m"], **walls},
            "bumper": {"at": [f"{x} m", "-3 m", "0.5 m"], "diameter": "0.36 m"},
            "friction": friction,
            "stiffness": "20 MN/m",
            "damping": "0.2 MN s/m",
        }
        for name, x in (("fore", 3.0), ("aft", -3.0))
    }
    lugs = {"A": (3, 2), "B": (3, -2), "C": (-3, 2), "D": (-3, -2)}
    load = {
        "name": "module",
        "shape": {"box": ["8 m", "6 m", "4 m"]},
        "position": ["50 m", "0 m", "5 m"],
        "weight": {"calculated": f"{LOAD} kg"},
        "centre_of_gravity": {"at": ["0 m", "0 m", "2 m"]},
        "lugs": {name: {"at": [f"{x} m", f"{y} m", "4 m"]} for name, (x, y) in lugs.items()},
    }
    length = ((HOOK - 4.0) ** 2 + 3.0**2 + 2.0**2) ** 0.5
    soft = {"axial_stiffness": "4 MN", "damping_time": "0.1 s", "mass": "none"}
    # Level, at the waterline: they hold her where she is.
    draft = OWN / (SEA * LENGTH * BREADTH)
    sides = {"a": (90, 15), "b": (10, 15), "c": (90, -15), "d": (10, -15)}
    lines: dict[str, Any] = {
        name: {"fairlead": [f"{x} m", f"{y} m", f"{draft} m"], "to": [f"{x} m", f"{10 + 3 * y} m", "0 m"]}
        for name, (x, y) in sides.items()
    }
    for name, x in (("e", 100), ("f", 0)):
        ends = f"{2 * x - 50} m"
        lines[name] = {"fairlead": [f"{x} m", "0 m", f"{draft} m"], "to": [ends, "10 m", "0 m"]}
    rest = {"vessel": "barge", "rope": "soft", "pretension": "20 kN", "type": "spring"}
    vessel = barge({}, added_mass=ADDED, water_damping=DAMPED, position=["0 m", "10 m"], draft=f"{draft} m")
    vessel |= {"masses": {"hull": {"mass": f"{OWN} kg", "at": ["50 m", "0 m", f"{HIGH} m"]}}}
    del vessel["tanks"]
    hoist = {"speed": "6 m/min", "acceleration": "0.05 m/s^2"}
    return lift(
        vessel,
        duration="20 s",
        load=load,
        guides=guides,
        ropes={"stiff": {"axial_stiffness": "2000 MN", "damping_time": "20 ms"}, "soft": soft},
        cranes={"crane": {"type": "fixed_hook", "at": ["50 m", "0 m", f"{5 + HOOK} m"], "hoist": hoist}},
        slings={
            name: {"from": "crane", "to": f"module.{name}", "rope": "stiff", "length": f"{length} m"}
            for name in lugs
        },
        mooring_lines={name: line | rest for name, line in lines.items()},
        limits={"metacentric_height": "5 m"},
    )


def gm(friction: float, inside: float) -> float:
    """GM for heel [m]; at rest without friction."""
    question = Statics(leaning(friction, inside))
    rest = question.equilibrium(0.0)
    pressed = float(rest.recording.column("guide_force", "fore")[-1])
    assert (pressed > 0.0) is (inside > 0.0)
    return metacentric_heights(question, rest)["barge"].transverse


@pytest.mark.parametrize("friction", [0.0, 0.3])
def test_a_load_that_leans_on_a_guide_ties_nobody_to_its_crane(friction: float) -> None:
    """GM = T/2 + B^2/12T - KG of a box, with W h^2/L over her weight by the guide, h 6 m at most."""
    draft = OWN / (SEA * LENGTH * BREADTH)
    own = draft / 2 + BREADTH**2 / (12 * draft) - HIGH
    free = gm(friction, -0.2)
    assert free == pytest.approx(own, abs=0.05)  # mooring lines beside it
    assert free < gm(friction, 0.1) < free + LOAD * 6.0**2 / ((HOOK - 2.0) * OWN) + 0.01


def test_a_limit_of_gm_knows() -> None:
    """2.8 m of 5 m."""
    rest = Statics(leaning(0.3, 0.1)).equilibrium(0.0)
    (check,) = (one for one in check_recording(rest.recording) if one.name == "metacentric_height")
    assert check.verdict is Verdict.FAILED
