"""The work of waves on a vessel with `wave_motion` in steps that are cut, as where a rope goes taut.

At the end of a whole step she is where the waves have her, and the course leads there. Of a step that was
cut she was put there at its end, off the course by micrometres, and no look at the course saw what that
takes: 25 J of a vessel and a crane of 2500 t. A lift of 560 t that hung in a swell had a balance that did
not close.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from afloat import DRAFT, LENGTH, barge, lift_of, written
from gantline.hydro import write_raos
from gantline.simulation import simulate
from table_of_raos import goes_with_the_water

MIDDLE = f"{LENGTH / 2} m"
#: 5000 t aboard, and a soft rope from there to the ground, taut while the vessel is up.
HEAVY: dict[str, Any] = {
    "mechanics": {
        "bodies": {
            "crane": {
                "parent": "barge",
                "at": [MIDDLE, "0 m", "30 m"],
                "joint": {"type": "fixed"},
                "mass": "5000 t",
            },
        },
        "ropes": {
            "stay": {
                "rope": "soft",
                "length": "50 m",
                "route": [
                    {"type": "end", "body": "crane"},
                    {
                        "type": "end",
                        "body": "world",
                        "at": [f"{LENGTH / 2} m", "0 m", f"{30 - DRAFT - 50} m"],
                    },
                ],
            }
        },
    },
    "ropes": {"soft": {"axial_stiffness": "1 MN", "damping_time": "10 ms"}},
}


def test_it_is_booked(tmp_path: Path) -> None:
    """5000 t go up and down by 1 m: 49 MJ, of which 3e-6 was missing: 130 J."""
    write_raos(goes_with_the_water(), tmp_path / "barge.csv")
    vessel = barge(wave_motion={"raos": "barge.csv", "phases": "lag", "at": [MIDDLE, "0 m", "4 m"]})
    given = {
        "waves": {"swell": {"significant_height": "1 m", "peak_period": "9 s", "direction": "20 deg"}},
        "duration": "200 s",
        "start": "as_given",
        "simulation": {"sample_interval": "0.5 s"},
    }
    run = simulate(written(tmp_path, lift_of(vessel, **given, **HEAVY)))
    work = run.column("energy", "fluid_work")
    assert run.attributes["counters"]["cut"] > 20 and np.ptp(work) > 2e7
    assert run.attributes["energy_remainder"] < 3e-8
