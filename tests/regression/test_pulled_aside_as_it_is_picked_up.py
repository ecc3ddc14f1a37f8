"""Four slings with one 2 cm short had falls 20 deg out of plumb, 1014 % of the bound, as they came taut.

Their hook was of `type: fixed_hook`, which stays where falls would lean. The short sling carried by itself
until the others were taut, and pulled aside. Falls would have come over by 6 cm, which takes up the 2 cm,
and leaned by a tenth of a degree. The verdict had this first, and no word of how the slings shared. A load
that a hook beside it drags along as it comes clear still counts.
"""

from __future__ import annotations

import math

import numpy as np

import gantline
from gantline.checks import Verdict
from gantline.results import series
from gantline.results.cranes.pulled_aside import pull_aside
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from hooked_lift import hooked_lift
from of_recording import checks_of

#: Bound past which falls warn where nobody limits them [rad].
BOUND = math.radians(2.0)
PLAN = """\
ground: {level: 0 m, friction: 0.1}
plan:
  - {step: lift off, hoist: H, speed: 1 m/min, until: {supports: clear}}
  - {step: hoist, hoist: H, speed: 1 m/min, by: 0.2 m}
  - {step: hang, hold: until_end}
"""


def picked_up(beside: float, short: float) -> Recording:
    """A load of 40 t below a hook so far beside its middle, with one of four slings so much shorter [m]."""
    lugs = {"A": (-2.5, 1.5, 3.0), "B": (2.5, 1.5, 3.0), "C": (-2.5, -1.5, 3.0), "D": (2.5, -1.5, 3.0)}
    slings = {name: ("H", name, 8.6 - (short if name == "A" else 0.0)) for name in lugs}
    text = hooked_lift(
        {"H": (beside, 0.0, 10.9)},
        lugs,
        slings,
        mass=40e3,
        centre=(0.0, 0.0, 1.5),
        box=(6.0, 4.0, 3.0),
        position=(0.0, 0.0, 0.0),
        more=PLAN,
    )
    text = text.replace("start: as_given", "start: rest").replace("duration: 10 s", "duration: 60 s")
    return gantline.simulate(parse_scenario(text))


def test_slings_that_come_taut_one_after_another_are_no_lead() -> None:
    """As A carries alone its pull leans by atan(2.92/7.9), 20 deg, past a quarter of the load's weight."""
    recording = picked_up(0.0, 0.02)
    load, aside = recording.column("hook_load", "H"), pull_aside(recording, recording.rig.hooks[0])
    leans = np.arctan2(aside, load)[load > 0.25 * load.max()]
    assert leans.max() > BOUND, "the lift shows nothing otherwise"
    assert series.is_clear(recording).any()
    assert not checks_of(recording, "falls_out_of_plumb")


def test_a_load_that_comes_clear_aside_counts() -> None:
    """The hook stands 0.4 m beside the middle of the load, which goes there over the ground, and swings."""
    (found,) = checks_of(picked_up(0.4, 0.0), "falls_out_of_plumb")
    assert found.verdict is Verdict.WARNING
    assert found.value is not None and found.value > BOUND
