"""A box in one hook whose areas are where its centre of gravity is, turned by steady wind from aside.

Nothing turns it, and nothing holds its heading: `gantline statics` says so, and that it hangs as it is
nearest to the start. The search goes by the symmetric half of what a stream changes by. How a box is turned
changes where it is pulled, how it has swung out turns nothing, and that half has both alike: as a box of
10 t swung out in 16 m/s, 30 degrees off its length, it was turned as well, by 2 degrees on its slings, and
by 31 on falls of 21 m above them, which shows the wind 15 % more of it. It leaned, and its falls were out of
plumb, by that much more, and a run began so.
"""

from __future__ import annotations

import math

import pytest

import gantline

MASS, DENSITY, COEFFICIENT = 10e3, 1.225, 1.2
LENGTH, BREADTH, HEIGHT = 8.0, 6.0, 4.0


def hung(speed: float, direction: float) -> gantline.Scenario:
    """Slings that are slack by 5 mm at the start; speed of the wind [m/s], and where it goes to [deg]."""
    slings = "\n".join(f"  {lug}: {{from: crane, to: box.{lug}, length: 9.7 m}}" for lug in "ABCD")
    return gantline.parse_scenario(f"""
format: 1
lift: {{title: A box in one hook in wind}}
duration: 10 s
wind: {{speed: {speed} m/s, direction: {direction} deg}}
ropes:
  sling: {{axial_stiffness: 70 MN, damping_time: 10 ms, mass: none}}
load:
  name: box
  shape: {{box: [{LENGTH} m, {BREADTH} m, {HEIGHT} m]}}
  position: [0 m, 0 m, 3 m]
  weight: {{calculated: {MASS} kg}}
  centre_of_gravity: {{at: [0 m, 0 m, {HEIGHT / 2} m]}}
  wind_areas:
    end: {{coefficient: {COEFFICIENT}, along: x}}
    side: {{coefficient: {COEFFICIENT}, along: y}}
  lugs:
    A: {{at: [ 3 m,  2 m, 4 m]}}
    B: {{at: [ 3 m, -2 m, 4 m]}}
    C: {{at: [-3 m,  2 m, 4 m]}}
    D: {{at: [-3 m, -2 m, 4 m]}}
cranes:
  crane: {{type: fixed_hook, at: [0 m, 0 m, 16 m], hoist: {{speed: 6 m/min, acceleration: 0.05 m/s^2}}}}
sling_defaults: {{rope: sling}}
slings:
{slings}
""")


@pytest.mark.parametrize(
    ("speed", "direction"), [(12.0, 30.0), (16.0, 30.0), (16.0, -60.0), (20.0, 30.0), (20.0, 150.0)]
)
def test_it_leans_and_keeps_its_heading(speed: float, direction: float) -> None:
    """At rest it leans by θ in line with what pushes it, along its own axes: tan θ = F/m g. What it leans
    shows the wind less of it by θ²/2, and steps that lean add up to a turn by θ² at most.
    """
    rest = gantline.Statics(hung(speed, direction)).equilibrium()
    assert (rest.unstable, rest.neutral) == (0, 1)
    assert rest.residual < 1e-8
    pressure = 0.5 * DENSITY * COEFFICIENT * speed**2
    along = pressure * BREADTH * HEIGHT * math.cos(math.radians(direction))
    across = pressure * LENGTH * HEIGHT * math.sin(math.radians(direction))
    lean = math.atan2(math.hypot(along, across), MASS * 9.81)
    w, x, y, z = rest.recording.column("body_orientation", "box")[-1]
    heading = math.atan2(2.0 * (x * y + w * z), 1.0 - 2.0 * (y * y + z * z))
    assert heading == pytest.approx(0.0, abs=lean**2)
    assert rest.recording.column("load_tilt", "box")[-1] == pytest.approx(lean, rel=lean**2)
