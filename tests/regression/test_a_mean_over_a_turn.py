"""A ship block was still being turned as its run ended, and the mean over that stood for a force at rest.

The sling that took the load over had 158 kN `static`, 8.5 % of the working load limit of its shackle, and a
peak of 1244 kN in steady motion: the quiet window went back to where a sling had been taken off, half an hour
and 86 degrees before. `sling_dynamic_factor` had 7.9, without any dynamics. The window of a run that ends
in motion begins where its load is turned by 10 degrees less than at the end, or a sling has been put on.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from gantline import simulate
from gantline.results import series
from gantline.scenario import parse_scenario
from lift_text import changed
from upending import between_trolleys, upended

#: Of the column [N].
WEIGHT = 100e3 * 9.81
#: Half of the distance of the lugs, and their height over the centre of gravity [m].
HALF, OVER = 9.5, 1.5

JOINED = """\
format: 1
lift: {title: A third hook takes hold in the air}
duration: 40 s
ropes: {sling: {axial_stiffness: 10 MN, damping_time: 50 ms}}
load:
  name: bar
  shape: {box: [20 m, 2 m, 2 m]}
  position: [0 m, 0 m, 10 m]
  weight: {calculated: 40 t}
  centre_of_gravity: {at: [0 m, 0 m, 1 m]}
  lugs: {a: {at: [-9 m, 0 m, 2 m]}, b: {at: [9 m, 0 m, 2 m]}, c: {at: [0 m, 0 m, 2 m]}}
cranes:
  A: {type: fixed_hook, at: [-9 m, 0 m, 20 m], hoist: {speed: 1 m/min, acceleration: 0.1 m/s^2}}
  B: {type: fixed_hook, at: [9 m, 0 m, 20 m], hoist: {speed: 1 m/min, acceleration: 0.1 m/s^2}}
  C: {type: fixed_hook, at: [0 m, 0 m, 20 m], hoist: {speed: 1 m/min, acceleration: 0.1 m/s^2}}
slings:
  a: {from: A, to: bar.a, length: 8 m}
  b: {from: B, to: bar.b, length: 8 m}
  c: {from: C, to: bar.c, length: 8.3 m}
sling_defaults: {rope: sling}
plan:
  - {step: hang, hold: 15 s}
  - {step: hook on, hold: 2 s, attach: sling.c}
  - {step: take over, hoist: C, speed: 1 m/min, by: 2 m}
"""


def test_the_window_of_a_turn_holds_no_more_of_it_than_ten_degrees() -> None:
    """Lugs lie over the centre of gravity: the higher one bears W/2 (1 + OVER/HALF tan(tilt)).

    At the end that grows with the tilt; the mean lies between what it is there and 10 degrees before.
    """
    text = changed(
        between_trolleys(upended(16.5)),
        (
            "a: {at: [-9.5 m, 0 m, 1.5 m]}, b: {at: [9.5 m, 0 m, 1.5 m]}",
            "a: {at: [-9.5 m, 0 m, 3 m]}, b: {at: [9.5 m, 0 m, 3 m]}",
        ),
    )
    recording = simulate(parse_scenario(text), duration=230.0)
    tilt = recording.column("load_tilt", "column")
    window = series.quiet_window(recording)
    assert np.ptp(tilt[window]) <= math.radians(10.0) < np.ptp(tilt)
    static, _ = series.greatest_static(recording, recording.column("rope_tension", "sling.S1"))
    low, high = (
        WEIGHT / 2 * (1.0 + OVER / HALF * math.tan(angle)) for angle in (tilt[-1] - 0.1745, tilt[-1])
    )
    assert static is not None
    assert low < static < high


def test_a_sling_that_is_put_on_in_the_air_has_no_mean_of_the_time_before() -> None:
    recording = simulate(parse_scenario(JOINED))
    (put_on,) = [time for time, kind, _ in recording.events() if kind == "attached"]
    assert put_on == pytest.approx(15.0, abs=0.1)
    assert recording.time[series.quiet_window(recording)][0] > put_on
