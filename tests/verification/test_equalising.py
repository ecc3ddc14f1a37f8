"""Time to equalise against closed forms: three sheaves with damped guides, `tests/support/adjustment.py`.

With all slings taut and lugs at rest the mean of their forces stays, and differences decay as exp(−k t/c).
So does the tension spread, and it is below the bound b after (c/k) ln(spread at the begin/b).
"""

from __future__ import annotations

import json
import math
from typing import Any

import numpy as np
import pytest

from adjustment import DAMPING, DURATION, GAP, STIFFNESS, course, system
from gantline._core import Simulation
from gantline.results.derive import recording_of
from gantline.results.recording import Recording
from gantline.results.ropes.equalising import equalising
from mechanics import Json

SLINGS = [f"f{i}" for i in range(3)]
SHEAVES = [f"p{i}" for i in range(3)]
#: Samples are apart by this [s]; the spread between them is taken as straight, (dt k/c)²/8 of it off at most.
INTERVAL = 0.05


def recorded(document: Json, bound: float | None = None) -> Recording:
    method = {"type": "adaptive", "tension_tolerance": 1e-2, "position_tolerance": 1e-8}
    settings = {"integrator": method, "duration": DURATION, "sample_interval": INTERVAL}
    run = Simulation(json.dumps(document), json.dumps(settings))
    assert run.run()["status"] == "done"
    equalizer = {"name": "e", "body": "", "slings": SLINGS, "moving_sheaves": SHEAVES}
    rig: dict[str, Any] = {"equalizers": [equalizer]}
    if bound is not None:
        rig["equalised_below"] = bound
    return recording_of(run.columns(), run.names(), rig)


def decay(spread: float, bound: float) -> float:
    return DAMPING / STIFFNESS * math.log(spread / bound)


@pytest.mark.parametrize("bound", [None, 0.2, 0.01])
def test_from_the_moment_when_the_last_sling_goes_taut(bound: float | None) -> None:
    """Begin: when sling 2 goes taut, by the closed form of the sequence; 5 % if no bound is named."""
    recording = recorded(system(), bound)
    begin = max(course(np.array([DURATION])).taut)
    force = course(np.array([begin])).force[0]
    spread = float(np.ptp(force) / force.mean())
    found = equalising(recording, recording.rig.equalizers[0])
    assert found is not None
    assert found.begin == pytest.approx(begin, abs=1e-4)
    # A chord above an exponential: its crossing is late by at most (dt k/c)²/8 of c/k, 0.2 ms.
    assert found.time == pytest.approx(decay(spread, bound or 0.05), abs=3e-4)
    assert recording.metrics()["time_to_equalise.e"] == found.time


def test_from_the_moment_when_the_pins_are_pulled() -> None:
    """Pinned sheaves hold the forces k (y − g) of their slings apart; pulled at 9 s, they decay."""
    document = system()
    for body in document["bodies"]:
        if body["name"] in SHEAVES:
            body["joint"]["pin"] = True
    document["drives"][2]["ramps"] = [
        {"at": 1.0, "duration": 1e-3, "velocity": 0.2},
        {"at": 2.5, "duration": 1e-3, "velocity": 0.0},
    ]
    document["plan"] = [
        {"name": "hold", "until": {"type": "duration", "duration": 9.0}},
        {"name": "let go", "until": {"type": "end_of_run"}, "pulls": SHEAVES},
    ]
    force = STIFFNESS * (np.array([0.45, 0.20, 0.30]) - np.array(GAP))
    recording = recorded(document)
    before = int(np.searchsorted(recording.time, 8.99))
    held = np.array([recording.column("rope_tension", sling)[before] for sling in SLINGS])
    assert held == pytest.approx(force, rel=1e-6)
    found = equalising(recording, recording.rig.equalizers[0])
    assert found is not None
    assert found.begin == 9.0
    assert found.time == pytest.approx(decay(float(np.ptp(force) / force.mean()), 0.05), abs=3e-4)


def test_an_equalizer_that_does_not_equalise() -> None:
    """Nothing where the recording ends before the spread is below the bound, or with a pin that is in."""
    document = system()
    assert equalising(recorded(document, 1e-4), recorded(document).rig.equalizers[0]) is None
    document["bodies"][0]["joint"]["pin"] = True
    recording = recorded(document)
    assert equalising(recording, recording.rig.equalizers[0]) is None
    assert "time_to_equalise.e" not in recording.metrics()
    assert recording.metrics()["peak_pin_force"] > 0.0
