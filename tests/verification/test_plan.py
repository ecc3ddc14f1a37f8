"""Steps of a plan: side by side, to positions, until loads and spreads, stopped; by closed forms."""

from __future__ import annotations

import numpy as np
import pytest

from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import Simulation
from gantline.statics import Statics
from gantline.study import run_steps
from goliath_lift import HOOK, HOOK_BLOCK, HUNG, goliath_lift
from lift_text import BASE, spoiled
from mechanics import G


def run(text: str) -> Recording:
    return Simulation(parse_scenario(text)).run()


def steps(recording: Recording) -> dict[tuple[str, str], float]:
    """Times of begin and end of every step."""
    return {(kind, name): time for time, kind, name in recording.events() if kind.startswith("step")}


def joint(recording: Recording, name: str) -> np.ndarray:
    return recording.column("joint_position", name)


def test_steps_side_by_side_end_by_themselves_and_the_next_waits_for_all() -> None:
    """A way s at speed v with ramps of a takes s/v + v/a, or 2 sqrt(s/a) where it is too short for v."""
    plan = """\
{step: hoist, hoist: A, speed: 6 m/min, by: 2 m}
{step: over, traverse: one, starts: with_previous, speed: 30 m/min, by: -10 m}
{step: later, travel: gol, starts: with_previous, start_at: 5 s, speed: 30 m/min, to: 3 m}
{step: down, lower: A, speed: 6 m/min, to: 34 m}"""
    recording = run(goliath_lift(plan, duration=120.0))
    at = steps(recording)
    # a way s at speed v with ramps of a lasts s/v + v/a, or 2 sqrt(s/a) where it is too short for v
    assert at["step_begin", "hoist"] == at["step_begin", "over"] == 0.0
    assert at["step_end", "hoist"] == pytest.approx(2 / 0.1 + 0.1 / 0.05, rel=1e-12)
    assert at["step_end", "over"] == pytest.approx(10 / 0.5 + 0.5 / 0.03, rel=1e-12)
    assert at["step_begin", "later"] == 5.0
    assert at["step_end", "later"] == pytest.approx(5 + 2 * (3 / 0.03) ** 0.5, rel=1e-12)
    assert at["step_begin", "down"] == at["step_end", "over"]
    assert joint(recording, "gol.one")[-1] == pytest.approx(-30.0, abs=1e-9)
    assert joint(recording, "gol")[-1] == pytest.approx(3.0, abs=1e-9)
    assert joint(recording, "gol.A.drum")[-1] == pytest.approx(34.0 - HOOK, abs=1e-9)


_CRANE = """at: [0 m, 0 m, 20 m]
    rated_capacity: 100 t
    block: {mass: 2 t, height: 2 m}
    reeving: {parts_each: 4, rope: thick, sheave_diameter: 0.6 m, upper_sheaves_at: 40 m,
              rope_weight: none}
    drum: {diameter: 1 m}"""
_PLAN = """\
  - {step: slack, hoist: hook, speed: 1 m/min, until: {load_transferred: 2 %}}
  - {step: up, hoist: hook, speed: 0.6 m/min, until: {hoist_load: {hook: hook, above: 400 kN}}}
  - {step: equal, hold: until_met, until: {tension_spread: 5 %, of: e1}}
  - {step: clear, hoist: hook, speed: 0.6 m/min, until: {supports: clear}}
  - {step: free, hoist: hook, speed: 0.6 m/min, by: 0.2 m}
  - {step: down, lower: hook, speed: 0.6 m/min, until: {supports: touched}}
  - {step: half, lower: hook, speed: 0.6 m/min, until: {load_transferred: 50 %}}
  - {step: last, lower: hook, speed: 0.6 m/min, until: {hoist_load: {hook: hook, below: 200 kN}}}
"""


def lift_by_conditions() -> str:
    """A load of 60 t in an equalizer, up from a ground of springs and down onto it again."""
    plan = BASE.index("  - {step: hoist"), BASE.index("limits:")
    text = BASE[: plan[0]] + _PLAN + BASE[plan[1] :]
    for old, new in (
        ("at: [0 m, 0 m, 20 m]\n    rated_capacity: 100 t", _CRANE),
        ("duration: 20 s", "duration: 300 s"),
        (
            "simulation: {integrator: del, step: 1 ms, sample_interval: 20 ms}",
            "simulation: {sample_interval: 5 ms}",
        ),
    ):
        text = spoiled(old, new, text)
    return text


def test_at_rest_a_condition_is_met_within_a_millisecond() -> None:
    """Steps from rest to rest: the hook brakes from 0.6 m/min in v/a = 0.1 s once 400 kN hang in it.

    What is more after a millisecond is that of the 20 ms before, by 1/20, while load goes with way.
    """
    question = Statics(parse_scenario(lift_by_conditions()))
    up = next(one for one in run_steps(question) if one.name == "up, equal")
    met = up.state.time - 0.1

    def hoist_load(time: float) -> float:
        return float(question.equilibrium(time).recording.column("hoist_load", "hook")[-1])

    before, there = hoist_load(met - 0.02), hoist_load(met)
    assert before < 400e3 <= there
    assert there - 400e3 <= (there - before) / 20


def test_steps_end_on_loads_spreads_and_supports() -> None:
    """As the plan says, on the way up and down again."""
    text = lift_by_conditions()
    recording = run(text)
    at = steps(recording)

    def value(variable: str, label: str, step: str, before: float = 0.0) -> float:
        """A variable at the end of a step, when its hook has come to rest, or so long before [s]."""
        time = at["step_end", step] - before
        return float(np.interp(time, recording.time, recording.column(variable, label)))

    # From 0.6 m/min a hoist brakes within 0.01/0.1 = 0.1 s: that long before the end of a step was its
    # condition met.
    assert value("hoist_load", "hook", "up", 0.1) == pytest.approx(400e3, rel=1e-3)
    slings = [recording.column("rope_tension", f"sling.S{n}") for n in (1, 2)]
    spread = np.abs(slings[0] - slings[1]) / ((slings[0] + slings[1]) / 2 + 1e-9)
    equal = at["step_end", "equal"]
    assert equal >= at["step_begin", "equal"]
    assert np.interp(equal, recording.time, spread) < 0.06
    assert value("load_transferred", "block", "clear") == pytest.approx(1.0, abs=0.01)
    touched = [time for time, _, _ in recording.events("set_down")]
    assert any(time == pytest.approx(at["step_end", "down"] - 0.1, abs=0.01) for time in touched)
    assert value("load_transferred", "block", "half", 0.1) == pytest.approx(0.5, abs=0.01)
    assert value("hoist_load", "hook", "last", 0.1) == pytest.approx(200e3, rel=0.02)


def test_trolleys_stop_in_an_emergency_by_their_deceleration() -> None:
    """v^2/2a to speed, v t, and v^2/2a to rest; no step ends or begins after it."""
    plan = """\
{step: over, traverse: one, speed: 30 m/min, by: 40 m}
{step: never, traverse: one, speed: 30 m/min, by: -5 m}"""
    more = "emergency_stop: {in_step: over, after: 30 s}\n"
    recording = run(goliath_lift(plan, more=more))
    (stop,) = recording.events("emergency_stop")
    assert stop[0] == 30.0 and stop[2] == "over"
    # ramp up over v^2/2a, at speed until 30 s, and v^2/2a to rest
    way = 0.5 * (30.0 - 0.5 / 0.03) + 0.5**2 / 0.03
    assert joint(recording, "gol.one")[-1] == pytest.approx(-20.0 + way, abs=1e-9)
    assert ("step_begin", "never") not in steps(recording)
    assert ("step_end", "over") not in steps(recording)


def test_a_hoist_stops_in_an_emergency_and_its_load_bounces() -> None:
    """The drum goes on by v^2/2a; falls unload and swing about the weight."""
    plan = "{step: up, hoist: A, speed: 10 m/min, by: 10 m}"
    more = "emergency_stop: {at: 20 s}\n"
    hoist = ", emergency_acceleration: 1 m/s^2"
    text = goliath_lift(plan, more=more, hoist=hoist, stiffness=100.0, duration=30.0)
    recording = run(text)
    speed = 10 / 60
    way = speed * (20.0 - speed / 0.05 / 2) + speed**2 / 2
    assert joint(recording, "gol.A.drum")[-1] == pytest.approx(way, abs=1e-9)
    load = recording.column("hoist_load", "gol.A")
    weight = (HOOK_BLOCK + HUNG) * G
    after = load[recording.time > 20.0]
    # A hoist that stops lets go: the load, still going up, unloads its falls and bounces about its weight. A
    # stop within v/a' = 0.17 s, short beside the period of 0.9 s, swings by nearly m v omega.
    assert after.min() < 0.9 * weight and after.max() > 1.05 * weight
