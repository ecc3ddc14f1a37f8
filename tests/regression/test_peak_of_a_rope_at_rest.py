"""When a rope at rest carried the most was told by the last bit.

A load that hangs in three ropes from its start at rest carries the same in each all the time but for 1e-13 of
it. The peaks were told to be at 0.21 s and 0.23 s, by `del` at 1.3 s, 9.9 s and 12.14 s: whichever step had
the largest rounding. Nothing is ever more than at the start.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import gantline
from gantline.results import series
from gantline.results.alike import earliest_peak
from gantline.results.ropes.upper_end import peak_at_upper_end
from gantline.scenario import parse_scenario
from sample_lift import sample_recording

HANGING = """
format: 1
lift: {{title: A load that hangs in three ropes}}
duration: 20 s
start: rest
simulation: {{{integrator}}}
ropes:
  rope: {{axial_stiffness: 1 MN, damping_time: 0.1 s, mass: none}}
mechanics:
  bodies:
    load:
      joint: {{type: free}}
      mass: 1 t
      at: [0 m, 0 m, 0 m]
      inertia: {{xx: 1 t m^2, yy: 1 t m^2, zz: 1 t m^2}}
  ropes:
    one:
      rope: rope
      length: 5 m
      route:
        - {{type: end, body: load, at: [0.3 m, 0.2 m, 0.5 m]}}
        - {{type: end, body: world, at: [1 m, 0.1 m, 5 m]}}
    two:
      rope: rope
      length: 5.1 m
      route:
        - {{type: end, body: load, at: [-0.3 m, -0.2 m, 0.5 m]}}
        - {{type: end, body: world, at: [-1.3 m, 0 m, 5 m]}}
    three:
      rope: rope
      length: 5.1 m
      route:
        - {{type: end, body: load, at: [-0.3 m, 0.2 m, 0.5 m]}}
        - {{type: end, body: world, at: [-1.1 m, 1 m, 5 m]}}
plan:
  - {{step: hold, hold: until_end}}
"""


@pytest.mark.parametrize(
    ("integrator", "first_step"), [("integrator: adaptive", 1.0), ("integrator: del, step: 10 ms", 0.01)]
)
def test_it_is_at_the_start(integrator: str, first_step: float) -> None:
    """The core knows of steps alone, and tells the first; samples know of the start."""
    run = gantline.simulate(parse_scenario(HANGING.format(integrator=integrator)))
    for rope in ("one", "two", "three"):
        tension = run.column("rope_tension", rope)
        assert 0.0 < np.ptp(tension) < 1e-12 * tension.max()
        assert run.column("rope_peak_time", rope) <= first_step
        most, time = series.rope_peak(run, rope)
        assert most == pytest.approx(tension.max(), rel=1e-9)
        assert time == 0.0
        upper = peak_at_upper_end(run, rope)
        assert upper is not None and upper.time == 0.0


@pytest.mark.parametrize("later", [1e-13, -1e-13])
def test_steps_and_samples_that_are_alike_count_as_one(later: float) -> None:
    """A plateau from 0.3 s on, in which the sling has the most to the last bit at the end."""
    time = np.linspace(0.0, 1.0, 11)
    tension = 1e6 * np.minimum(time / 0.3, 1.0) * (1.0 + later * (time > 0.9))
    recording = sample_recording(time, tension=np.tile(tension[:, None], 5))
    most, when = series.rope_peak(recording, "sling.S1")
    assert most == pytest.approx(1e6)
    assert when == pytest.approx(0.3)


def test_a_millionth_is_no_tie() -> None:
    """The larger of two, and its own time; what is no number says nothing against one."""
    assert earliest_peak((1.0, 2.0), (1.0 + 1e-6, 3.0)) == (1.0 + 1e-6, 3.0)
    assert earliest_peak((1.0, 2.0), (1.0 + 1e-12, 1.0)) == (1.0 + 1e-12, 1.0)
    assert earliest_peak((math.nan, 0.0), (1.0, 2.0)) == (1.0, 2.0)
    assert earliest_peak((math.inf, 3.0), (1.0, 2.0)) == (math.inf, 3.0)
