"""A module that hangs in one hook in steady wind: no place to rest, or one that was said to be unstable.

Wind that comes from aside turns it slowly until its areas are down-wind of its hook. What turns it is a
millionth of its weight, and as it turns it is pulled aside: no step that turned it brought all forces nearer
to balance, and `gantline statics`, and every run that started at rest, ended with "no step brings its forces
closer to balance". Where it was found, stability and periods went by the symmetric half of what the push
changes by: a module whose areas are in the middle, which nothing turns, was said to turn away within 20 s,
and so was one that comes back within 139 s.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import gantline

MASS, INERTIA, SPEED = 45e3, 420e3, 14.0
SIDE = 0.5 * 1.225 * 1.2 * 60.0  # c of (WC1) of its sides [N s²/m²]


def hung(lever: float, direction: float = 20.0) -> gantline.Scenario:
    """Its sides have their middle so far ahead of its centre of gravity [m]; where wind goes to [deg]."""
    slings = "\n".join(
        f"    s{number}: {{rope: sling, length: 12 m, stretched: true, route: "
        f"[{{type: end, body: hook}}, {{type: end, body: module, at: [{x} m, {y} m, 2 m]}}]}}"
        for number, (x, y) in enumerate(((4, 2), (4, -2), (-4, 2), (-4, -2)))
    )
    return gantline.parse_scenario(f"""
format: 1
lift: {{title: A module in one hook in wind}}
duration: 30 s
start: rest
wind: {{speed: {SPEED} m/s, direction: {direction} deg}}
ropes:
  sling: {{axial_stiffness: 100 MN, damping_time: 20 ms, mass: none}}
mechanics:
  bodies:
    hook: {{at: [0 m, 0 m, 12 m], joint: {{type: point}}, mass: 2 t}}
    module:
      at: [0.5 m, 0 m, 0 m]
      joint: {{type: free}}
      mass: {MASS} kg
      inertia: {{xx: 100 t m^2, yy: 400 t m^2, zz: {INERTIA} kg m^2}}
      wind_areas:
        side: {{area: 60 m^2, coefficient: 1.2, along: y, at: [{lever} m, 0 m, 0 m]}}
        end: {{area: 20 m^2, coefficient: 1.2, along: x}}
  ropes:
    fall:
      rope: sling
      length: 40 m
      stretched: true
      route: [{{type: end, body: world, at: [0 m, 0 m, 52 m]}}, {{type: end, body: hook}}]
{slings}
""")


@pytest.mark.parametrize("direction", [20.0, 70.0, 90.0])
def test_it_turns_its_areas_down_wind(direction: float) -> None:
    """At rest its length lies along the wind. Turned by ψ it has the moment −e c u² ψ, and a pull aside turns
    nothing: ω² = e c u²/I, and nothing that leads away.
    """
    lever = 0.1
    statics = gantline.Statics(hung(lever, direction))
    rest = statics.equilibrium()
    assert rest.residual < 1e-9
    w, _, _, z = rest.recording.column("body_orientation", "module")[-1]
    assert 2.0 * math.degrees(math.atan2(z, w)) == pytest.approx(direction, abs=1e-9)
    assert (rest.is_stable, rest.unstable, rest.neutral) == (True, 0, 0)
    slow = statics.modes(1)[0]
    # Its slings swing and lean by 0.02 rad, which is in I by its square.
    assert slow.square == pytest.approx(lever * SIDE * SPEED**2 / INERTIA, rel=2e-3)
    assert slow.motion.startswith("module turns")
    swing = statics.swing(slow, amplitude=0.1)
    w, _, _, z = swing.column("body_orientation", "module").T
    heading = 2.0 * np.arctan2(z, w) - math.radians(direction)
    # The lean of its slings is in that by its square too, 0.02^2.
    assert (heading.min(), heading.max()) == pytest.approx((-0.1, 0.1), rel=4e-4)


def test_nothing_turns_what_the_wind_meets_in_the_middle() -> None:
    """Areas at the centre of gravity have no moment: the heading is as given, and neutral."""
    statics = gantline.Statics(hung(0.0))
    rest = statics.equilibrium()
    assert (rest.unstable, rest.neutral) == (0, 1)
    assert statics.step_off() is None
    assert statics.modes(1)[0].square == pytest.approx(0.0, abs=1e-6)


def test_it_starts_at_rest_and_stays_there() -> None:
    """Nothing moves in a run from there."""
    run = gantline.simulate(hung(0.1))
    place = run.column("body_position", "module")
    assert np.abs(place - place[0]).max() < 1e-4


def test_what_is_up_wind_leads_away() -> None:
    """Held to start with its areas up-wind, exactly: ω² = −e c u²/I."""
    statics = gantline.Statics(hung(-0.1, 0.0))
    rest = statics.equilibrium()
    assert (rest.is_stable, rest.unstable) == (False, 1)
    slow = statics.modes(1)[0]
    assert slow.square == pytest.approx(-0.1 * SIDE * SPEED**2 / INERTIA, rel=2e-3)


@pytest.mark.parametrize("length", [20.0, 70.0])
def test_a_barge_on_one_line_fishtails(length: float) -> None:
    """Held at its bow alone, in a current, sway and yaw build up together: their ω² are complex. A run that
    starts a little aside swings out by the largest root of det(λ² M + λ D + K), e-fold in 404 s and in 495 s.
    """
    lift = gantline.parse_scenario(f"""
format: 1
lift: {{title: A barge on one line}}
duration: 10 s
current: {{speed: 1 m/s, direction: 180 deg}}
ropes:
  fibre: {{axial_stiffness: 20 MN, damping_time: 100 ms, mass: none}}
vessels:
  barge:
    draft: 3 m
    hull: {{box: [60 m, 20 m, 6 m]}}
    masses: {{all: {{mass: 3690 t, at: [30 m, 0 m, 3 m]}}}}
    radii_of_gyration: [6 m, 17 m, 18 m]
    added_mass: {{at: [30 m, 0 m, 2 m], surge: 200 t, sway: 2000 t, heave: 4000 t, roll: 100000 t m^2,
                 pitch: 800000 t m^2, yaw: 500000 t m^2}}
    current_areas:
      side: {{area: 180 m^2, coefficient: 1.0, along: y, at: [30 m, 0 m, 1.5 m]}}
      bow: {{area: 60 m^2, coefficient: 0.6, along: x, at: [30 m, 0 m, 1.5 m]}}
mooring_lines:
  bow: {{vessel: barge, type: spring, fairlead: [60 m, 0 m, 3 m], to: [{60 + length} m, 0 m, 3 m],
         length: {length} m, rope: fibre}}
""")
    statics = gantline.Statics(lift)
    rest = statics.equilibrium()
    assert (rest.is_stable, rest.unstable) == (False, 1)
    assert statics.step_off() is None  # no way leads down
    model = statics.linear_model()
    size = len(model.mass)
    rates = np.linalg.solve(model.mass, np.hstack([-model.stiffness, -model.damping]))
    roots = np.linalg.eigvals(np.vstack([np.eye(size, 2 * size, size), rates]))
    fastest = roots[np.argmax(roots.real)]
    # Let go 0.01° askew; after 400 s the slower motion has died away beside it. Three periods lie between the
    # swings, so that both are looked at in the same phase.
    askew = lift.changed({"vessels.barge.heading": "0.01 deg", "start": "as_given"})
    period = 2.0 * math.pi / abs(fastest.imag)
    end = 400.0 + 4.0 * period
    run = gantline.simulate(askew, duration=end, position_tolerance=1e-7, sample_interval=0.5)
    w, _, _, z = run.column("body_orientation", "barge").T
    heading, time = 2.0 * np.arctan2(z, w), run.time
    first, last = (heading[(time >= at) & (time <= at + period)] for at in (400.0, end - period))
    assert 1.0 / fastest.real == pytest.approx({20.0: 404.0, 70.0: 495.0}[length], abs=1.0)
    growth = math.log(np.ptp(last) / np.ptp(first)) / (3.0 * period)
    # Samples 0.5 s apart miss the ends of swings of minutes by parts in 10^4.
    assert growth == pytest.approx(fastest.real, rel=2e-4)
