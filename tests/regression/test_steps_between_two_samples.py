"""A pair that is watched in a step that begins and ends between two samples.

No sample lay within the step: the distance was never held against what it has to be, `clearance_margin` was
`not checked` and said that the step is not looked at, and the lift was GO.
"""

from __future__ import annotations

from gantline.checks import Verdict
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import Simulation
from of_recording import checks_of

#: The load's side is 3 m from the middle, the wall 6 m: they are 3 m apart all the time.
LIFT = """
format: 1
lift: {title: Watched in a short step}
duration: 20 s
ropes: {steel: {axial_stiffness: 60 MN, damping_time: 50 ms, mass: none}}
structures: {wall: {type: box, x: [6 m, 7 m], y: [-5 m, 5 m], z: [0 m, 20 m]}}
load:
  name: module
  shape: {box: [6 m, 4 m, 3 m]}
  position: [0 m, 0 m, 6 m]
  weight: {calculated: 45 t}
  centre_of_gravity: {at: [0 m, 0 m, 1.5 m]}
  lugs: {A: {at: [-2 m, 0 m, 3 m]}, B: {at: [2 m, 0 m, 3 m]}}
cranes:
  crane: {type: fixed_hook, at: [0 m, 0 m, 15 m], hoist: {speed: 6 m/min, acceleration: 0.05 m/s^2}}
sling_defaults: {rope: steel, length: 6.35 m}
slings: {A: {from: crane, to: module.A}, B: {from: crane, to: module.B}}
plan:
  - {step: hold, hold: 5.3 s}
  - {step: short, hold: 0.4 s}
  - {step: up, hoist: crane, speed: 3 m/min, by: 0.5 m}
  - {step: end, hold: until_end}
watch:
  - {between: [module, wall], smallest: SMALLEST, from_step: STEP, to_step: STEP}
simulation: {sample_interval: 1 s}
"""
PAIR = "module - wall from 'short' to 'short'"


def run(smallest: str, step: str = "short") -> Recording:
    return Simulation(parse_scenario(LIFT.replace("SMALLEST", smallest).replace("STEP", step))).run()


def test_it_is_held_against_its_distance() -> None:
    """3 m less the 4 m that are asked for, and less the 2 m."""
    for smallest, margin, verdict in (("4 m", -1.0, Verdict.FAILED), ("2 m", 1.0, Verdict.OK)):
        recording = run(smallest)
        (check,) = checks_of(recording, "clearance_margin")
        assert check.verdict is verdict and check.element == PAIR
        assert check.value is not None and abs(check.value - margin) < 1e-6
        assert abs(recording.metrics()[f"smallest_clearance.{PAIR}"] - 3.0) < 1e-6


def test_its_event_and_its_warning_are_there() -> None:
    recording = run("4 m")
    ((time, _, name),) = recording.events("too_close")
    assert name == PAIR and 5.3 <= time <= 5.7
    assert any("module comes within 3.00 m of wall" in text for text in recording.attributes["warnings"])


def test_a_step_that_a_run_does_not_come_to_has_nothing_to_check() -> None:
    recording = Simulation(
        parse_scenario(
            LIFT.replace("SMALLEST", "4 m").replace("STEP", "end").replace("duration: 20 s", "duration: 8 s")
        )
    ).run()
    (check,) = checks_of(recording, "clearance_margin")
    assert check.verdict is not Verdict.FAILED and check.value is None
