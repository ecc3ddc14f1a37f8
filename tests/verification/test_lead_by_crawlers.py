"""Two crawler cranes lead a beam while they travel at the radius that they have: (LD5)."""

from __future__ import annotations

import math

import numpy as np
import pytest

import gantline
from crawler_pair import GEAR, MASSES
from gantline.results.variable import FloatArray
from gantline.scenario import parse_scenario

#: Steps of `adaptive` end on the way; between their ends a polynomial misses it by less [rad].
BETWEEN = 1e-9

_CRANE = """\
  {name}:
    type: crawler
    position: [{x} m, 13.856406460551018 m]
    heading: 0 deg
    slew: -60 deg
    slewing: {{speed: 30 deg/min, acceleration: 0.1 deg/s^2}}
    luffing: {{speed: 6 deg/min, acceleration: 0.05 deg/s^2, range: [30 deg, 82 deg]}}
    travel: {{speed: 10 m/min, acceleration: 0.02 m/s^2, range: [-5 m, 20 m]}}
    tracks: {{length: 9 m, width: 1.5 m, gauge: 8.4 m, mats: 6 m, allowed_pressure: 150 kPa}}
{masses}    hooks: {{H: {{type: H, height: 18 m}}}}
"""
_LIFT = """\
format: 1
lift: {{title: Two crawler cranes travel}}
duration: 200 s
start: rest
{gear}load:
  name: beam
  shape: {{box: [28 m, 4 m, 3 m]}}
  datum: bottom_centre
  position: [0 m, 0 m, 2 m]
  weight: {{calculated: 200 t, contingency: 1.00}}
  inertia: homogeneous
  centre_of_gravity: {{at: [0 m, 0 m, 1.5 m]}}
  lugs: {{A: {{at: [-12 m, 0 m, 3 m]}}, B: {{at: [-8 m, 0 m, 3 m]}}, C: {{at: [8 m, 0 m, 3 m]}},
    D: {{at: [12 m, 0 m, 3 m]}}}}
cranes:
{cranes}slings:
  A: {{from: c1.H, to: beam.A, length: 13.16 m, rope: sling}}
  B: {{from: c1.H, to: beam.B, length: 13.16 m, rope: sling}}
  C: {{from: c2.H, to: beam.C, length: 13.16 m, rope: sling}}
  D: {{from: c2.H, to: beam.D, length: 13.16 m, rope: sling}}
plan:
  - {{step: over, lead: [c1.H, c2.H], by: [10 m, 3 m, 0 m], travelling: {travelling}, speed: 6 m/min,
      acceleration: 0.01 m/s^2}}
  - {{step: hold, hold: until_end}}
simulation: {{sample_interval: 0.5 s{settings}}}
"""


def lift(travelling: str, settings: str = "") -> str:
    cranes = "".join(_CRANE.format(name=name, x=x, masses=MASSES) for name, x in (("c1", -18), ("c2", 2)))
    return _LIFT.format(gear=GEAR, cranes=cranes, travelling=travelling, settings=settings)


def share_at(time: FloatArray) -> FloatArray:
    """Share of a way of |(10, 3)| m at 0.1 m/s and 0.01 m/s^2 (P1): 1/20 of a metre in its first second."""
    length = math.hypot(10.0, 3.0)
    end = length / 0.1 + 10.0
    time = np.clip(time, 0.0, end)
    braked = length - 0.005 * (end - time) ** 2
    gone = np.where(time < 10.0, 0.005 * time**2, np.where(end - time < 10.0, braked, 0.1 * (time - 5.0)))
    share: FloatArray = gone / length
    return share


@pytest.mark.parametrize("settings", ["", ", integrator: del, step: 10 ms"], ids=["adaptive", "del"])
def test_cranes_travel_and_slew_at_their_radius(settings: str) -> None:
    """(LD5): 16 m all along; aside of its way a hook is at 16 sin 60 - 3 sigma, ahead at what is left.

    The tracks go by 10 sigma less what the hook has gone ahead of the axis; drives, which no ground moves.
    """
    recording = gantline.simulate(parse_scenario(lift("[c1, c2]", settings)))
    share = share_at(recording.time)
    aside = 16.0 * math.sin(math.radians(60.0)) - 3.0 * share
    forward = np.sqrt(256.0 - aside**2)
    for crane in ("c1", "c2"):
        assert np.ptp(recording.column("boom_angle", crane)) < 1e-14
        slew = recording.column("slew_angle", crane)
        assert slew == pytest.approx(-np.arctan2(aside, forward), abs=BETWEEN)
        along = recording.column("body_position", f"{crane}.tracks")[:, 0]
        # The middle of tracks and ballast is 0.8 m up: they lean by a share of a degree that hardly changes.
        gone = 10.0 * share - (forward - forward[0])
        assert along - along[0] == pytest.approx(gone, abs=2e-3)
        joint = recording.column("joint_position", f"{crane}/along")
        assert joint == pytest.approx(gone, abs=30 * BETWEEN)


def test_one_travels_and_the_other_luffs() -> None:
    """The first keeps its radius; the other keeps its place, and its head goes (10, 3) m: by (LD4)."""
    recording = gantline.simulate(parse_scenario(lift("c1")))
    share = share_at(recording.time)
    assert np.ptp(recording.column("boom_angle", "c1")) < 1e-14
    ahead, aside = 8.0 + 10.0 * share, 16.0 * math.sin(math.radians(60.0)) - 3.0 * share
    boom = np.arccos((np.hypot(ahead, aside) - 1.6) / 63.0)
    assert recording.column("boom_angle", "c2") == pytest.approx(boom, abs=BETWEEN)
    assert recording.column("slew_angle", "c2") == pytest.approx(-np.arctan2(aside, ahead), abs=BETWEEN)


def test_a_crane_that_stands_abeam_does_not_travel_and_slew() -> None:
    """With its boom square to its way the root of (LD5) is at its end: the load would go off it at once."""
    text = lift("[c1, c2]").replace("slew: -60 deg", "slew: -90 deg")
    with pytest.raises(
        gantline.ScenarioError,
        match="aside of the way of 'c1'; at its radius, which it keeps, its boom is square",
    ):
        parse_scenario(text)


def test_a_crane_that_stands_abeam_goes_straight_along() -> None:
    """With s = r all along (LD5) leaves the tracks the whole way of 10 m, and the slew where it is."""
    text = (
        lift("[c1, c2]")
        .replace("slew: -60 deg", "slew: -90 deg")
        .replace("10 m, 3 m, 0 m]", "10 m, 0 m, 0 m]")
    )
    # 16 m abeam of the beam, and ahead of it by nothing in place of 8 m.
    text = (
        text.replace("13.856406460551018 m", "16 m")
        .replace("[-18 m", "[-10 m")
        .replace("[2 m, 16 m", "[10 m, 16 m")
    )
    recording = gantline.simulate(parse_scenario(text))
    for crane in ("c1", "c2"):
        assert recording.column("slew_angle", crane) == pytest.approx(-math.pi / 2, abs=1e-14)
        joint = recording.column("joint_position", f"{crane}/along")
        assert joint[-1] == pytest.approx(10.0, abs=30 * BETWEEN)
