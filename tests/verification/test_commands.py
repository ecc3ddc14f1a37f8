"""Drives that a program commands: a closed loop against its own equations, commands against plans."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from gantline.assembly.plan.commands import CommandError
from gantline.scenario import parse_scenario
from gantline.simulation import Simulation
from goliath_lift import FALLS, goliath_lift
from mechanics import Floats, G

SCENARIOS = Path(__file__).resolve().parents[2] / "scenarios"
OVER = "{step: over, traverse: one, speed: 30 m/min, by: 40 m}\n{step: end, hold: until_end}"
HOLD = "{step: end, hold: until_end}"
#: The most that the trolley does [m/s², m/s], and the time of its plan before the program takes over [s].
LIMIT, FASTEST, TAKEN_OVER = 0.03, 0.5, 12.0
#: Time between commands [s], how many there are, and trolley speed per offset of the load [1/s].
EVERY, COUNT, GAIN = 0.5, 120, 0.4


def goliath(plan: str, **settings: object) -> Simulation:
    return Simulation(parse_scenario(goliath_lift(plan, start="rest")), **settings)


def damped_by_equations() -> Floats:
    """Trolley, load and speed of the trolley at each command, shape (COUNT, 3) [m, m, m/s].

    The load hangs under the trolley on L, the falls as they start, at rest and stretched. With the angle θ
    of the falls and the trolley at X, `L θ̈ = −g sin θ − Ẍ cos θ`; the trolley runs with a constant Ẍ until
    it has the speed GAIN L sin θ of the last command, and keeps that.
    """

    def swing(state: Floats, acceleration: float, lasts: float) -> Floats:
        def rates(_: float, y: Floats) -> list[float]:
            angle, turning, _, speed = y
            pulled = -G * math.sin(angle) - acceleration * math.cos(angle)
            return [turning, pulled / FALLS, speed, acceleration]

        if lasts <= 0.0:
            return state
        solved = solve_ivp(rates, (0, lasts), state, method="DOP853", rtol=1e-11, atol=1e-13)
        found: Floats = solved.y[:, -1]
        return found

    state = swing(np.array([0.0, 0.0, -20.0, 0.0]), LIMIT, TAKEN_OVER)
    seen = []
    for _ in range(COUNT):
        offset = FALLS * math.sin(state[0])
        seen.append((state[2], state[2] + offset, state[3]))
        wanted = min(max(GAIN * offset, -FASTEST), FASTEST)
        ramp = min(abs(wanted - state[3]) / LIMIT, EVERY)
        state = swing(state, math.copysign(LIMIT, wanted - state[3]), ramp)
        state = swing(state, 0.0, EVERY - ramp)
    return np.array(seen)


def damp(run: Simulation, count: int = COUNT) -> Floats:
    """The same by a program; what it saw at each command."""
    seen = []
    for _ in range(count):
        trolley, speed = run.drive_state("one")
        load = run.now("body_position", "gol.A")[0]
        seen.append((trolley, load, speed))
        run.command("one", speed=min(max(GAIN * (load - trolley), -FASTEST), FASTEST))
        run.advance_to(run.time + EVERY)
    return np.array(seen)


def test_a_trolley_damps_the_swing_of_its_load_as_its_equations_say() -> None:
    """A program steers the trolley by the offset of the load: 40 cm go to a hundredth of a millimetre.

    The rope is stiff: its stretch of 0.6 mm changes by 1e-4 of itself as the load swings, which moves nothing
    by more than 0.1 µm. The lift's own tolerance is 1 µm in a step, and the loop damps errors as it damps the
    swing: 1 µm it is.
    """
    run = goliath(OVER)
    run.advance_to(TAKEN_OVER)
    seen, expected = damp(run), damped_by_equations()
    offset = expected[:, 1] - expected[:, 0]
    assert np.abs(offset).max() > 0.4 and np.abs(offset[-10:]).max() < 1e-5
    assert np.abs(seen[:, :2] - expected[:, :2]).max() < 1e-6
    # An offset wrong by 1 µm commands a speed wrong by GAIN times that.
    assert np.abs(seen[:, 2] - expected[:, 2]).max() < GAIN * 1e-6
    recording = run.recording()
    assert recording["command_time"].values == pytest.approx(TAKEN_OVER + EVERY * np.arange(COUNT), abs=1e-12)
    assert set(recording["command_name"].values) == {"gol.one"}
    assert set(recording["command_motion"].values) == {"traverse"}
    wanted = np.clip(GAIN * (seen[:, 1] - seen[:, 0]), -FASTEST, FASTEST)
    assert np.array_equal(recording["command_speed"].values, wanted)
    assert any("moved by a program" in warning for warning in recording.attributes["warnings"])


def test_commands_are_part_of_the_state_and_give_the_same_bytes(tmp_path: Path) -> None:
    """Two commanded runs, and one that goes on from a state saved between two commands, byte by byte."""
    saved = []
    for name, taken_up in (("a.nc", False), ("b.nc", False), ("c.nc", True)):
        run = goliath(OVER, duration=40.0)
        run.advance_to(TAKEN_OVER)
        damp(run, 10)
        if taken_up:
            run, state = goliath(OVER, duration=40.0), run.save()
            run.restore(state)
        damp(run, 10)
        saved.append(run.run().save(tmp_path / name).read_bytes())
    assert saved[0] == saved[1] == saved[2]


@pytest.mark.parametrize("settings", [{}, {"integrator": "del", "step": 0.01}], ids=["adaptive", "del"])
def test_commands_do_what_a_plan_with_the_same_ramps_does(settings: dict[str, object]) -> None:
    """Same ramps from the same pauses: a plan that knows them beforehand makes the same steps.

    It ends its steps at the same times, so every bit of motion and forces is the same, also of a hoist.
    """
    plan = """\
{step: over, traverse: one, speed: 24 m/min, start_at: 1 s, brake_from: 20 s}
{step: up, hoist: A, speed: 6 m/min, acceleration: 0.04 m/s^2, start_at: 36 s, brake_from: 41 s}
{step: end, hold: until_end}"""
    planned = goliath(plan, duration=50.0, **settings).run()
    run = goliath(HOLD, duration=50.0, **settings)
    for at, name, speed, acceleration in (
        (1.0, "one", 0.4, None),
        (20.0, "one", 0.0, None),
        (36.0, "A", 0.1, 0.04),
        (41.0, "A", 0.0, 0.04),
    ):
        run.advance_to(at)
        run.command(name, speed=speed, acceleration=acceleration)
    commanded = run.run()
    assert np.ptp(commanded.column("body_position", "gol.A")[:, 2]) > 0.4
    for name, variable in planned.variables.items():
        if not name.startswith("event"):
            assert np.array_equal(variable.values, commanded[name].values), name


def test_a_pause_is_at_its_time_and_on_the_same_course() -> None:
    """Steps are cut at the pauses: the time is theirs to the last bit, the motion that of a run without any.

    Each keeps 1 µm in a step; that is how far they may be from one another while the load swings by 30 cm.
    """
    run, whole = goliath(OVER, duration=40.0), goliath(OVER, duration=40.0).run()
    for k in range(1, 101):
        run.advance_to(0.37 * k)
        assert run.time == 0.37 * k
    paused = run.run()
    assert np.array_equal(paused.time, whole.time)
    difference = paused.column("body_position", "gol.A") - whole.column("body_position", "gol.A")
    assert np.abs(difference).max() < 1e-6


def test_the_plan_goes_on_without_what_a_program_moves() -> None:
    """Of two drives of a step the other one makes its way; a step of the commanded one alone ends at once."""
    plan = """\
{step: both, hoist: A, start_at: 10 s, speed: 6 m/min, by: 2 m}
{step: over, traverse: one, starts: with_previous, speed: 30 m/min, by: 10 m}
{step: back, traverse: one, speed: 30 m/min, to: -20 m}
{step: end, hold: until_end}"""
    run = goliath(plan, duration=60.0)
    run.advance_to(8.0)
    run.command("one", speed=-0.1)
    recording = run.run()
    at = {(kind, name): time for time, kind, name in recording.events() if kind.startswith("step")}
    assert at["step_begin", "over"] == at["step_end", "over"] == 10.0
    # a way s at speed v with ramps of a lasts s/v + v/a
    assert at["step_end", "both"] == pytest.approx(10 + 2 / 0.1 + 0.1 / 0.05, rel=1e-12)
    assert at["step_end", "back"] == at["step_begin", "back"] == at["step_end", "both"]
    # 0.1 m/s after 0.1/a, which makes 0.1²/2a less way than without a ramp
    assert run.drive_state("one")[0] == pytest.approx(-20 - 5.2 + 0.1**2 / (2 * LIMIT), abs=1e-9)


def test_an_emergency_stop_stops_what_a_program_moves_and_ends_commands() -> None:
    """v²/2a further, with the deceleration that the trolley has; after it commands are refused."""
    text = goliath_lift(OVER, start="rest").replace("plan:\n", "emergency_stop: {at: 30 s}\nplan:\n")
    run = Simulation(parse_scenario(text), duration=60.0)
    run.advance_to(5.0)
    run.command("one", speed=0.0)
    run.command("gol", speed=-0.3)
    run.advance_to(30.0)
    # 0.3 m/s within 10 s, then 15 s of it; then 0.3²/0.06 to rest
    assert run.drive_state("gol") == pytest.approx((-(1.5 + 4.5), -0.3), abs=1e-12)
    run.advance_to(50.0)
    assert run.drive_state("gol") == pytest.approx((-(6.0 + 1.5), 0.0), abs=1e-12)
    assert run.drive_state("one") == pytest.approx((-20 + 0.15**2 / LIMIT, 0.0), abs=1e-12)
    with pytest.raises(CommandError, match="an emergency stop has stopped everything"):
        run.command("one", speed=0.1)


def test_a_drive_comes_to_rest_at_the_end_of_its_range() -> None:
    """The trolley may go to 60 m, the hook to 72 m: there they stop, whatever a program asks for."""
    run = goliath(HOLD, duration=400.0)
    for k in range(78):
        run.command("one", speed=0.5)
        run.command("A", speed=1 / 6)
        run.advance_to(5.0 * (k + 1))
    assert run.drive_state("one") == pytest.approx((60.0, 0.0), abs=1e-9)
    assert run.drive_state("A") == pytest.approx((72.0, 0.0), abs=1e-9)


def test_a_boom_in_tackles_luffs_at_the_speed_that_is_asked_for() -> None:
    """Its winches take up rope; an angular speed is that of the angle at which it is commanded.

    Over 0.02 rad the lever of the tackles changes by a few per cent at most, and the speed with it.
    """
    run = Simulation(SCENARIOS / "crane_barge_in_swell", duration=60.0)
    before, _ = run.drive_state("sheerleg", motion="luff")
    run.command("sheerleg", speed=2e-4, motion="luff")
    run.advance_to(50.0)
    after, speed = run.drive_state("sheerleg", motion="luff")
    assert speed == pytest.approx(2e-4, rel=0.03)
    assert after - before == pytest.approx(2e-4 * 50.0, rel=0.05)
