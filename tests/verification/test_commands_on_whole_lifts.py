"""Commands on whole lifts: against brakes, with a cut rope, and a hook held above a barge in waves."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import gantline
import waves
from afloat import LENGTH
from gantline.scenario import parse_scenario
from gantline.simulation import Simulation
from mechanics import Floats

SCENARIOS = Path(__file__).resolve().parents[2] / "scenarios"
HOLD = "{step: end, hold: until_end}"
#: Frequency of the waves, one of the database's [rad/s]; time between commands [s]; speed per height [1/s].
OMEGA, EVERY, GAIN = 0.8, 0.05, 1.5
PERIOD = 2 * math.pi / OMEGA
#: Of the hoist above the barge [m/s, m/s²]; the least time of a change [s].
FASTEST, LIMIT, SHORTEST = 2.0, 0.5, 1e-3


def reeved(*plan: str) -> gantline.Scenario:
    """The lift of `reeved_hoist` from where its load hangs 3 m above the ground."""
    text = (SCENARIOS / "reeved_hoist" / "scenario.yaml").read_text(encoding="utf-8")
    text = text.replace("position: [0 m, 0 m, 0 m]", "position: [0 m, 0 m, 3 m]")
    text = text.replace("at: [0 m, 0 m, 16.75 m]", "at: [0 m, 0 m, 19.75 m]").replace(
        "  stands_on: ground\n", ""
    )
    before, after = text.split("plan:\n")[0], "limits:" + text.split("limits:")[1]
    return parse_scenario(f"{before}plan:\n" + "".join(f"  - {step}\n" for step in plan) + after)


def same_motion(one: gantline.Recording, other: gantline.Recording) -> None:
    """Every bit of every variable but events and the commands themselves."""
    for name, variable in one.variables.items():
        if not name.startswith(("event", "command")):
            assert np.array_equal(variable.values, other[name].values), name


LOWER = "{step: lower, lower: hook, speed: 5 m/min, emergency_stop_at: 5 s}"


@pytest.mark.parametrize("after", [5.01, 7.0])
def test_a_command_takes_a_drum_from_its_brake(after: float) -> None:
    """While the brake slips, and when it holds: every bit as by a plan that hoists then. Energy balances."""
    hoist = f"{{step: up, hoist: hook, speed: 1.2 m/min, start_at: {after} s, by: 10 m}}"
    planned = Simulation(reeved(LOWER, hoist), duration=12.0).run()
    run = Simulation(reeved(LOWER, HOLD), duration=12.0)
    run.advance_to(after)
    _, speed = run.drive_state("hook")
    assert (speed < -0.01) == (after < 5.012)
    run.command("hook", speed=0.02)
    commanded = run.run()
    same_motion(planned, commanded)
    remainder = commanded.column("energy", "remainder")
    assert np.abs(remainder).max() < 1e-10 * np.abs(commanded.column("energy", "gravity")).max()


def test_of_commands_at_one_time_the_last_one_holds() -> None:
    """Three at 3 s, while the plan lowers, do what the third does alone."""
    found = []
    for before in ([], [(0.05, None), (-0.08, 0.01)]):
        run = Simulation(reeved(LOWER, HOLD), duration=8.0)
        run.advance_to(3.0)
        for speed, acceleration in [*before, (0.03, None)]:
            run.command("hook", speed=speed, acceleration=acceleration)
        found.append(run.run())
    assert len(found[1]["command_time"].values) == 3
    same_motion(*found)


def test_a_state_saved_between_commands_under_a_brake_gives_the_same_bytes(tmp_path: Path) -> None:
    """Saved while the brake slips, before a command and after it."""
    kept = []
    for name, at in (("a.nc", None), ("b.nc", 0), ("c.nc", 1)):
        run = Simulation(reeved(LOWER, HOLD), duration=9.0)
        for index, (time, speed) in enumerate(((5.005, 0.03), (5.5, -0.03), (6.0003, 0.0))):
            run.advance_to(time)
            if index == at:
                state, run = run.save(), Simulation(reeved(LOWER, HOLD), duration=9.0)
                run.restore(state)
            run.command("hook", speed=speed)
        kept.append(run.run().save(tmp_path / name).read_bytes())
    assert kept[0] == kept[1] == kept[2]


def test_a_sling_is_cut_while_a_program_hoists() -> None:
    """Sling 1 of `equalizer_sling_cut` parts at 40 s, as the hook that a program moves is about to brake:
    every bit as by the lift's own plan, which brakes at 40.3 s.
    """
    text = (SCENARIOS / "equalizer_sling_cut" / "scenario.yaml").read_text(encoding="utf-8")
    planned = Simulation(
        parse_scenario(text.replace("brake_from: 60 s", "brake_from: 40.3 s")), duration=42.0
    )
    before, rest = text.split("plan:\n")
    after = rest[rest.index("\n\n") :]
    run = Simulation(parse_scenario(f"{before}plan:\n  - {HOLD}{after}"), duration=42.0)
    for time, speed in ((0.0, 0.1), (40.3, 0.0)):
        run.advance_to(time)
        run.command("test_hook", speed=speed)
    commanded = run.run()
    assert ("cut", "sling.S1") in {(kind, name) for _, kind, name in commanded.events()}
    same_motion(planned.run(), commanded)


def hook_over_barge(folder: Path, height: str, duration: float) -> Simulation:
    """A hook with 50 t, 30 m above the water, over the middle of a barge in waves of a height."""
    crane = {
        "type": "fixed_hook",
        "at": [f"{LENGTH / 2} m", "0 m", "30 m"],
        "hoist": {"speed": f"{FASTEST} m/s", "acceleration": f"{LIMIT} m/s^2"},
    }
    path = waves.in_waves(
        folder,
        {"swell": {"height": height, "period": f"{PERIOD!r} s", "direction": "30 deg"}},
        cranes={"crane": crane},
        mechanics={"bodies": {"hung": {"parent": "crane", "joint": {"type": "fixed"}, "mass": "50 t"}}},
        plan=[{"step": "end", "hold": "until_end"}],
        duration=f"{duration!r} s",
    )
    return Simulation(path, tension_tolerance=0.1, position_tolerance=1e-8)


def follow(run: Simulation, since: float) -> tuple[Floats, float]:
    """Holds the hook as high above the barge as it is at a time.

    Returns:
        Time, heights of hook and barge and speed of the hook at each command, and the height that is wanted.
    """
    run.advance_to(since)
    wanted = run.drive_state("crane")[0] - run.now("body_position", "barge")[2]
    seen = []
    while not run.ended:
        hook, speed = run.drive_state("crane")
        barge = float(run.now("body_position", "barge")[2])
        seen.append((run.time, hook, barge, speed))
        run.command("crane", speed=GAIN * (wanted + barge - hook))
        run.advance_to(run.time + EVERY)
    return np.array(seen), float(wanted)


def test_a_hook_follows_a_barge_as_a_sampled_loop_does(tmp_path: Path) -> None:
    """In waves of 1 mm each change takes the shortest time d, and the loop is linear. With samples as powers
    of ζ = exp(−iωT), z_{k+1} − z_k = T v_k − (v_k − v_{k−1}) d/2 and v = GAIN (b − z) of heights b and z,

        Z = c B/(ζ − 1 + c),    c = GAIN (T − (1 − 1/ζ) d/2),

    and the height above the barge changes by |1 − Z/B| = 47.46 % of heave, which is that of the frequency
    domain.
    """
    since = 40 * PERIOD
    seen, _ = follow(hook_over_barge(tmp_path, "1 mm", since + 8 * PERIOD), since)
    late = seen[:, 0] >= since + 4 * PERIOD
    time, hook, barge, _ = seen[late].T
    found, heave = (waves.harmonic(time, height, OMEGA) for height in (hook, barge))
    zeta = np.exp(-1j * OMEGA * EVERY)
    loop = GAIN * (EVERY - (1 - 1 / zeta) * SHORTEST / 2)
    expected = loop / (zeta - 1 + loop)
    assert abs(1 - expected) == pytest.approx(0.4746, abs=5e-5)  # half a digit of that
    assert abs(found / heave - expected) < 1e-6
    towards = math.radians(30.0)
    along = OMEGA**2 / waves.G * LENGTH / 2 * math.cos(towards)
    force = waves.force_per_metre(OMEGA, towards) * 0.5e-3 * np.exp(1j * along)
    assert abs(heave - waves.response(OMEGA, force)[2]) < 1e-3 * abs(heave)


def test_a_hook_follows_a_barge_in_high_waves_within_what_its_hoist_can_do(tmp_path: Path) -> None:
    """In waves of 1.5 m ramps last |v_k − v_{k−1}|/a, less than T, and
    z_{k+1} = z_k + T v_k − (v_k − v_{k−1}) |v_k − v_{k−1}|/2a. The first one, from rest, has nothing to do.
    """
    seen, wanted = follow(hook_over_barge(tmp_path, "1.5 m", 30.0), 10.0)
    _, hook, barge, speed = seen.T
    asked = GAIN * (wanted + barge - hook)
    change = np.diff(asked, prepend=0.0)
    ramp = np.maximum(np.abs(change) / LIMIT, SHORTEST)
    assert 10 * SHORTEST < ramp.max() < EVERY
    assert speed[1:] == pytest.approx(asked[:-1], abs=1e-12)
    expected = hook + EVERY * asked - change * ramp / 2
    assert hook[1:] == pytest.approx(expected[:-1], abs=1e-11)
    held, free = np.ptp(hook - barge), np.ptp(barge)
    assert free > 0.3 and held < 0.6 * free
