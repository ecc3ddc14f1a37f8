"""A wreck that was raised while it drained had a dynamic factor of 1.19 at its hooks, and nothing moved fast.

It had hung still under water alone. What water no longer bore of it higher up counted as
dynamics, and failed a limit of 1.10; and the contingency on what it weighed up there stood in no check: 1.2
times what hung under water was held against capacities, at 3750 kN a hook, where 4360 kN were due.
"""

from __future__ import annotations

import pytest

from gantline.checks import check_recording
from gantline.checks.check import Check, Verdict
from gantline.results.recording import Recording
from gantline.scenario import Scenario, parse_scenario
from gantline.simulation import simulate

G = 9.81
WEIGHT, VOLUME = 200e3 * G, 100.0  # simulated [N], displaced by all of its height of 8 m [m^3]

LIFT = """
format: 1
lift: {title: A section is raised to half of its height above water and let down again}
duration: 330 s
water: {density: 1025 kg/m^3, depth: 30 m}
ropes:
  sling: {axial_stiffness: 300 MN, damping_time: 20 ms, minimum_breaking_force: 6 MN, mass: none}
load:
  name: section
  shape: {box: [10 m, 10 m, 8 m]}
  position: [0 m, 0 m, -12 m]
  weight: {calculated: 200 t, contingency: 1.1}
  centre_of_gravity: {at: [0 m, 0 m, 3.5 m]}
  in_water: {displaced_volume: 100 m^3, added_mass: [20 t, 20 t, 40 t], drag_coefficients: [1, 1, 1]}
  lugs:
    A: {at: [ 4 m,  4 m, 8 m], capacity: 100 t}
    B: {at: [ 4 m, -4 m, 8 m], capacity: 100 t}
    C: {at: [-4 m,  4 m, 8 m], capacity: 100 t}
    D: {at: [-4 m, -4 m, 8 m], capacity: 100 t}
cranes:
  hook:
    type: fixed_hook
    at: [0 m, 0 m, 8 m]
    rated_capacity: 300 t
    hoist: {speed: 6 m/min, acceleration: 0.02 m/s^2}
sling_defaults: {rope: sling, length: 13.27 m}
slings:
  A: {from: hook, to: section.A}
  B: {from: hook, to: section.B}
  C: {from: hook, to: section.C}
  D: {from: hook, to: section.D}
plan:
  - {step: hang under water, hold: 40 s}
  - {step: up, hoist: hook, speed: 4 m/min, by: 8 m}
  - {step: stop there, hold: 1 s}
  - {step: down, lower: hook, speed: 4 m/min, by: 8 m}
  - {step: hang there again, hold: until_end}
limits: {rule: example, hook_dynamic_factor: 1.10}
"""


@pytest.fixture(scope="module")
def lift() -> Scenario:
    return parse_scenario(LIFT)


@pytest.fixture(scope="module")
def raised(lift: Scenario) -> Recording:
    return simulate(lift)


def _check(recording: Recording, name: str) -> Check:
    return next(check for check in check_recording(recording) if check.name == name)


def test_the_water_is_no_dynamics(raised: Recording) -> None:
    """Half out of the water it weighs (W - ρ g V/2)/(W - ρ g V) = 1.526 of what it does below."""
    hook_load = raised.column("hook_load", "hook")
    more = (WEIGHT - 1025.0 * G * VOLUME / 2) / (WEIGHT - 1025.0 * G * VOLUME)
    assert float(hook_load.max() / hook_load[-1]) == pytest.approx(more, rel=2e-2)
    check = _check(raised, "hook_dynamic_factor")
    assert check.verdict is not Verdict.FAILED
    assert check.value is None
    assert "water bore more of it" in check.remark


@pytest.mark.parametrize("name", ["hoist_load_of_rated_capacity", "lug_load_of_capacity"])
def test_what_is_left_out_is_told(raised: Recording, name: str) -> None:
    check = _check(raised, name)
    assert check.verdict is Verdict.WARNING
    assert "more of the load is left to bear then" in check.remark


def test_a_hold_up_there_has_its_design_weight(lift: Scenario) -> None:
    """1.1 W less what water carries of half of its height, to 1 %; nothing is told."""
    recording = simulate(lift.changed({"plan.3.hold": "20 s", "duration": "350 s"}))
    check = _check(recording, "static_hook_load")
    assert check.value == pytest.approx(1.1 * WEIGHT - 1025.0 * G * VOLUME / 2, rel=1e-2)
    factor = _check(recording, "hook_dynamic_factor")
    assert factor.value == pytest.approx(1.0, abs=0.03)
    assert _check(recording, "hoist_load_of_rated_capacity").verdict is Verdict.OK


def test_a_load_in_the_water_all_along_keeps_its_factor(lift: Scenario) -> None:
    """Hoisted by 2 m, it stays wholly wet, and a start of the hoist is dynamics."""
    recording = simulate(lift.changed({"plan.2.by": "2 m", "plan.4.by": "2 m"}))
    check = _check(recording, "hook_dynamic_factor")
    assert check.value is not None
    assert check.verdict is Verdict.OK
