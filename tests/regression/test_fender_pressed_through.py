"""A fender a metre thick that was pressed by 1.5 m was a GO, with a hundredth of its capacity in use.

Nothing but its stiffness holds what presses on it: with `5 kN/m` for `5 MN/m` a vessel went through it into
the quay. Only one pressed so where the lift file has the vessels was told.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import gantline
from afloat import barge, lift_of, written
from gantline.results.recording import Recording
from gantline.scenario import Scenario, load_scenario

STIFFNESS, PRETENSION, LINE, EA = 5e3, 20e3, 100.0, 10e3  # [N/m, N, m, N]
#: From the fender to the quay where the lift file has the barge, with a fender of 0.5 m [m].
OFF = 0.5


def lift(folder: Path, thickness: float, **fender: Any) -> Scenario:
    """A barge that two soft lines pull against two fenders, 1 m off the quay at y = 16 m."""
    ends = {"ps.fore": 80.0, "ps.aft": 20.0}
    lines = {
        name: {
            "vessel": "barge",
            "fairlead": [f"{x} m", "15 m", "8 m"],
            "to": [f"{x} m", f"{15 + LINE} m", "4 m"],
            "rope": "soft",
            "type": "spring",
            "pretension": f"{PRETENSION} N",
        }
        for name, x in ends.items()
    }
    fenders = {
        name: {
            "vessel": "barge",
            "at": [f"{x} m", "15 m", "5 m"],
            "wall": ["0 m", "16 m"],
            "facing": "-90 deg",
            "stiffness": f"{STIFFNESS} N/m",
            "capacity": "1 MN",
            "thickness": f"{thickness} m",
            **fender,
        }
        for name, x in ends.items()
    }
    return load_scenario(
        written(
            folder,
            lift_of(
                barge(),
                ropes={"soft": {"axial_stiffness": f"{EA} N", "mass": "none"}},
                mooring_lines=lines,
                fenders=fenders,
                duration="2 s",
            ),
        )
    )


def told(recording: Recording) -> list[str]:
    return [one for one in recording.attributes["warnings"] if "pressed" in one]


def test_one_pressed_through_is_told(tmp_path: Path) -> None:
    """A line of EA/L₀ = k′, L₀ = L/(1 + T₀/EA), pulls less as the barge comes: k d = T₀ − k′ (OFF + d)."""
    give = EA * (1.0 + PRETENSION / EA) / LINE
    deep = (PRETENSION - give * OFF) / (STIFFNESS + give)
    scenario = lift(tmp_path, 1.0 - OFF)
    rest = gantline.Statics(scenario).equilibrium(time=0.0)
    assert float(rest.recording.column("fender_force", "ps.fore")[-1]) == pytest.approx(
        STIFFNESS * deep, rel=1e-3
    )
    said = f"is pressed {deep:.2f} m deep at 0.00 s, and is 0.5 m thick: its wall is met before"
    assert told(rest.recording) == [f"fender ps.fore {said}", f"fender ps.aft {said}"]
    assert told(gantline.simulate(scenario))


def test_nothing_is_said_of_one_that_holds(tmp_path: Path) -> None:
    scenario = lift(tmp_path, 0.5, stiffness="5 MN/m")
    assert not told(gantline.simulate(scenario))


@pytest.mark.parametrize("thickness", [4.0, 10.0])
def test_nothing_is_said_of_one_thick_enough(tmp_path: Path, thickness: float) -> None:
    scenario = lift(tmp_path, thickness)
    assert not told(gantline.Statics(scenario).equilibrium(time=0.0).recording)
