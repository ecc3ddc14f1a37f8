"""A chain hoist that moved while its sling was not on left the sling as long as before.

A sling that is put on later, or taken off meanwhile, was let out by 0.1 m on the deck and put on: it carried
as one of its first length, while `chain_paid_out`, the report and the player had the other. One that was too
short to be put on was told with the length of the start, and with a way between its ends that they have not.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import gantline
from gantline.results import series
from gantline.scenario import parse_scenario
from gantline.statics import Statics

LENGTH, EA = 10.2, 60e6
#: From the bearing of the hook to a lug at the start [m].
APART = math.hypot(1.0, 10.0)


def lift(way: str, *, off: bool = False, method: str = "adaptive", hook: str = "hoist") -> str:
    """A box on the ground below one hook, sling B of which is put on after its chain hoist has moved."""
    return f"""\
format: 1
lift: {{title: A box}}
duration: 50 s
simulation: {{integrator: {method}}}
ground: {{level: 0 m, friction: 0.5, stiffness: 200 MN/m, damping: 2 MN s/m}}
ropes: {{r: {{axial_stiffness: {EA} N, damping_time: 0.2 s, mass: none}}}}
cranes: {{c: {{type: fixed_hook, at: [0 m, 0 m, 14 m], hoist: {{speed: 6 m/min, acceleration: 0.05 m/s^2}}}}}}
load:
  name: box
  shape: {{box: [4 m, 4 m, 4 m]}}
  weight: {{calculated: 10 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 2 m]}}
  lugs: {{A: {{at: [-1 m, 0 m, 4 m]}}, B: {{at: [1 m, 0 m, 4 m]}}}}
  position: [0 m, 0 m, 0 m]
  stands_on: ground
sling_defaults: {{rope: r, length: {LENGTH} m}}
slings:
  A: {{from: c, to: box.A}}
  B: {{from: c, to: box.B, chain_hoist: {{speed: 2 m/min}}}}
plan:
  - {{step: wait, hold: 1 s{", detach: sling.B" * off}}}
  - {{step: chain, {way}, speed: 2 m/min}}
  - {{step: on, hold: 1 s, attach: sling.B}}
  - {{step: up, hoist: c, speed: 2 m/min, by: 0.5 m}}
  - {{step: end, hold: until_end}}
"""


def unstretched(recording: gantline.Recording) -> float:
    """L = l/(1 + T/EA) of sling B at the last sample [m]."""
    first, last = series.rope_ends(recording, "sling.B")
    slings = {sling.name: sling for sling in recording.rig.slings}
    tension = series.sling_tension(recording, slings["B"])[-1]
    assert tension > 40e3
    return float(np.linalg.norm(first[-1] - last[-1]) / (1.0 + tension / EA))


@pytest.mark.parametrize("method", ["adaptive", "del"])
@pytest.mark.parametrize("off", [False, True])
@pytest.mark.parametrize(("way", "longer"), [("veer: B, by: 0.1 m", 0.1), ("haul: B, by: 0.1 m", -0.1)])
def test_it_is_as_long_as_its_chain_hoist_has_made_it(
    method: str, off: bool, way: str, longer: float
) -> None:
    """Slack chain goes over as it is: L is 10.2 m and what has been paid out."""
    run = gantline.simulate(parse_scenario(lift(way, off=off, method=method)))
    assert run.column("chain_paid_out", "B")[-1] == pytest.approx(longer, abs=1e-9)
    # The load swings below, and what damps the sling has a part in its tension: τ ė of some µm.
    assert unstretched(run) == pytest.approx(LENGTH + longer, abs=1e-5)
    assert run.metrics()["energy_remainder"] < 1e-5
    rest = Statics(parse_scenario(lift(way, off=off))).equilibrium(50.0)
    assert unstretched(rest.recording) == pytest.approx(LENGTH + longer, abs=1e-9)


@pytest.mark.parametrize("method", ["adaptive", "del"])
def test_one_that_is_too_short_is_told_with_the_length_that_it_has(method: str) -> None:
    """Hauled in by 0.3 m it is 9.9 m, and √(1² + 10²) m lie between its ends."""
    with pytest.raises(gantline.SimulationError) as stopped:
        gantline.simulate(parse_scenario(lift("haul: B, by: 0.3 m", off=True, method=method)))
    short = f"is 9.900 m long and {APART - 9.9:.3f} m too short: its ends are {APART:.3f} m apart"
    assert short in str(stopped.value)
