"""Numerical errors that `--refine` tells, against motion that is known."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from gantline.checks import Verdict, check_recording
from gantline.results.refinement import Refinement, refinement_of
from gantline.scenario import parse_scenario
from gantline.simulation import Simulation
from gantline.study import finer_simulation, refined
from lift_text import changed
from shown import MECHANICS, lift_on, unsaid

#: Acceleration with which the load is picked up [m/s^2], and gravity.
ACCELERATION, GRAVITY = 0.5, 10.0
MASS, BREAKING = 20e3, 1e6
#: A load of 20 t on one sling without weight, at rest as it begins; the hook accelerates all the time.
LIFT = f"""
format: 1
lift: {{title: A load picked up with a constant acceleration}}
start: rest
duration: 1.9 s
simulation: {{gravity: {GRAVITY} m/s^2, sample_interval: 20 ms}}
ropes:
  stiff: {{axial_stiffness: 20 MN, damping_time: 0, minimum_breaking_force: {BREAKING:g} N}}
load:
  name: module
  shape: {{box: [4 m, 4 m, 2 m]}}
  weight: {{calculated: 20 t}}
  centre_of_gravity: {{at: [0, 0, 1 m]}}
  lugs: {{top: {{at: [0, 0, 2 m]}}}}
cranes:
  crane: {{type: fixed_hook, at: [0, 0, 22 m], hoist: {{speed: 1 m/s, acceleration: {ACCELERATION} m/s^2}}}}
slings:
  one: {{from: crane, to: module.top, length: 20 m, rope: stiff}}
plan:
  - {{step: hoist, hoist: crane, speed: 1 m/s, by: 5 m}}
"""
#: T = m g + m a (1 - cos w t): what breaks the sling over the largest, whatever the stiffness.
EXACT = BREAKING / (MASS * (GRAVITY + 2.0 * ACCELERATION))


def errors(lift: str = LIFT, exact: float = EXACT, **settings: Any) -> tuple[float, float, Refinement]:
    """Errors of what breaks the sling over its largest tension, as run and in the finer run."""
    simulation = Simulation(parse_scenario(lift), **settings)
    recording = simulation.run()
    found = refinement_of(refined(recording, finer_simulation(simulation, recording).run()))
    assert found is not None
    figure = next(one for one in found.figures if one.name == "rope_factor_on_breaking_force")
    return figure.value - exact, figure.finer - exact, found


@pytest.mark.parametrize("step", [4e-3, 2e-3, 1e-3])
def test_three_quarters_of_the_error_of_a_first_order_method(step: float) -> None:
    """(1 - 1/4) e of `del`, to 1 %: its error has 0.6 % of a second order at the longest step."""
    as_run, finer, found = errors(integrator="del", step=step)
    assert as_run - finer == pytest.approx(0.75 * as_run, rel=0.01)
    assert found.settings == {"step": step / 4}


@pytest.mark.parametrize("step", [4e-3, 2e-3, 1e-3])
def test_three_quarters_of_the_error_of_an_explicit_one_that_damps(step: float) -> None:
    """(1 - 1/4) e of `explicit` on a sling with a damping time: it is of first order too.

    With s = w^2 tau/2 and v^2 = w^2 - s^2 the stretch u has u'' = a exp(-s t) (cos v t - s/v sin v t), and
    T = m (g + a - u''), which is largest where tan v t = -2 s v/(v^2 - s^2). The largest of steps misses the
    peak of a swing by up to (h w)^2/8 of it: 1e-4 at 4 ms, where the error is 9e-4 of it, so 11 %, and at
    shorter steps less as they are shorter. An error of h^2 would leave 15/16 for 3/4, a quarter more.
    """
    damping = 10e-3
    stiff, decay = 20e6 / 20.0 / MASS, 20e6 / 20.0 / MASS * damping / 2.0
    fast = math.sqrt(stiff - decay**2)
    at = (math.pi - math.atan2(2.0 * decay * fast, fast**2 - decay**2)) / fast
    swing = math.exp(-decay * at) * (math.cos(fast * at) - decay / fast * math.sin(fast * at))
    exact = BREAKING / (MASS * (GRAVITY + ACCELERATION * (1.0 - swing)))
    lift = LIFT.replace("damping_time: 0", f"damping_time: {damping} s")
    as_run, finer, found = errors(lift, exact, integrator="explicit", step=step)
    assert as_run - finer == pytest.approx(0.75 * as_run, rel=0.11 * step / 4e-3)
    assert found.settings == {"step": step / 4}


@pytest.mark.parametrize("tolerance", [20e3, 2e3, 200.0])
def test_nine_tenths_of_the_error_under_error_control(tolerance: float) -> None:
    """(1 - 1/10) e of `adaptive`, to the tenth of it by which no error follows a tolerance more closely.

    Steps are whole: of a motion of 60 steps one more or less is 1.6 % of their length and 8 % of the error.
    """
    as_run, finer, found = errors(tension_tolerance=tolerance, position_tolerance=5e-7 * tolerance)
    assert as_run - finer == pytest.approx(0.9 * as_run, rel=0.1)
    assert found.settings["tension_tolerance"] == pytest.approx(tolerance / 10)


def test_a_check_that_comes_out_otherwise_is_a_warning_of_the_recording() -> None:
    """A limit of 4.555 lies between 4.563 of long steps and 4.545, which is right.

    What is past it has as many digits as tell it from the limit: with two, 4.550 and 4.555 would read alike.
    """
    limited = LIFT.replace("ropes:", "limits: {sling_factor_on_breaking_force: 4.555}\nropes:", 1)
    simulation = Simulation(parse_scenario(limited), integrator="del", step=8e-3)
    recording = simulation.run()
    whole = refined(recording, finer_simulation(simulation, recording).run())
    assert whole.attributes["warnings"][-1] == (
        "with steps a quarter as long (2 ms) checks come out otherwise: "
        "sling_factor_on_breaking_force one ok with 4.56 as run, failed with 4.550 so"
    )
    said = {check.name: check.verdict for check in check_recording(whole)}
    assert said["sling_factor_on_breaking_force"] is Verdict.OK
    assert said["no_warnings"] is Verdict.WARNING


def test_places_of_a_double_pendulum_part_while_its_energy_stays() -> None:
    """The lift of the guide, thrown over its top: chaos takes places apart, and the balance closes.

    What the page says of it is not known otherwise: the figures are held against the page alone. Up to the
    18th second it is the tolerances that part both runs, since rounding is 1e-8 of what they let through.
    """
    lift = changed(
        lift_on(MECHANICS, "Double pendulum"),
        ("integrator: del, step: 0.05 ms", "integrator: adaptive"),
        ("duration: 2 s", "duration: 20 s"),
        ("position: 30 deg", "position: 170 deg"),
        ("axis: [0, 1, 0]}\n      mass", "axis: [0, 1, 0], position: 10 deg}\n      mass"),
    )
    simulation = Simulation(parse_scenario(lift))
    recording = simulation.run()
    finer = finer_simulation(simulation, recording).run()
    places = recording["body_position"].values - finer["body_position"].values
    apart = np.linalg.norm(places, axis=2).max(axis=1)
    times = recording.time
    said = (
        f"by {1e3 * apart[times <= 2.8][-1]:.1f} mm after 2.8 s, "
        f"0.1 m after {times[np.argmax(apart > 0.1)]:.0f} s and "
        f"{apart.max():.1f} m after {times[np.argmax(apart)]:.0f} s, "
        f"while its energy balance closes to {recording.metrics()['energy_remainder']:.0e}"
    )
    assert unsaid("docs/concepts/refinement.md", said.replace("e-0", "e-")) == []
