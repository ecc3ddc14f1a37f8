"""What a program may ask of a drive, and how it is refused."""

from __future__ import annotations

import math

import pytest

import gantline
from gantline.assembly.plan.commands import CommandError
from gantline.scenario import parse_scenario
from gantline.simulation import Simulation
from goliath_lift import goliath_lift
from tackle import TACKLE

HOLD = "{step: end, hold: until_end}"


@pytest.fixture(scope="module")
def run() -> Simulation:
    return Simulation(parse_scenario(goliath_lift(HOLD)))


@pytest.mark.parametrize(
    ("name", "asked", "message"),
    [
        ("gol.on", {"speed": 0.1}, "'gol.on' is nothing in this lift that can move; did you mean 'gol.one'?"),
        (None, {"speed": 0.1}, "'None' is nothing in this lift that can move"),
        ("A", {"speed": 0.1, "motion": "traverse"}, "'A' is nothing in this lift that can traverse"),
        ("A", {"speed": 0.1, "motion": "hoists"}, "motion: 'hoists' is none; did you mean 'hoist'?"),
        ("A", {"speed": math.nan}, "speed: nan is not a speed"),
        ("A", {"speed": -math.inf}, "speed: -inf is not a speed"),
        ("A", {"speed": "6 m/min"}, "speed: '6 m/min' is not a speed in m and s"),
        ("A", {"speed": None}, "speed: None is not a speed"),
        ("one", {"speed": -0.6}, "is faster than 'gol.one' can traverse; its highest speed is 30 m/min"),
        ("one", {"speed": 0.1, "acceleration": 0.04}, "is more than 'gol.one' can do; its most is 0.03 m/s"),
        ("one", {"speed": 0.1, "acceleration": 0.0}, "acceleration: 0 is not above zero"),
        ("one", {"speed": 0.1, "acceleration": math.nan}, "acceleration: nan is not"),
    ],
)
def test_a_command_that_cannot_be_is_refused(
    run: Simulation, name: str, asked: dict[str, float], message: str
) -> None:
    before = run.save()
    with pytest.raises(CommandError) as refused:
        run.command(name, **asked)  # type: ignore[arg-type]
    assert message in str(refused.value) and "\n" not in str(refused.value)
    assert run.save() == before


def test_a_name_that_can_move_in_several_ways_needs_its_motion() -> None:
    run = gantline.Simulation("floating_crane_and_crawlers", duration=1.0)
    with pytest.raises(CommandError, match="can move in several ways: luff, slew; say which"):
        run.command("c1", speed=0.0)
    run.command("c1", speed=0.0, motion="slew")
    assert run.recording()["command_motion"].values.tolist() == ["slew"]


def test_after_the_end_nothing_is_commanded() -> None:
    run = Simulation(parse_scenario(goliath_lift(HOLD)), duration=0.3)
    while not run.ended:
        run.advance_to(run.time + 0.1)
    with pytest.raises(CommandError, match=r"'gol\.A' cannot be commanded any more: the run has ended"):
        run.command("A", speed=0.1)


@pytest.mark.parametrize("to", [math.nan, math.inf, "1 s", True])
def test_a_pause_needs_a_time(run: Simulation, to: float) -> None:
    with pytest.raises(ValueError, match="is no time in seconds"):
        run.advance_to(to)


def test_a_pause_is_not_in_the_past() -> None:
    run = Simulation(parse_scenario(goliath_lift(HOLD)))
    run.advance_to(0.5)
    run.advance_to(0.5)
    assert run.time == 0.5
    with pytest.raises(ValueError, match=r"0\.4 s is past, it is 0\.5 s"):
        run.advance_to(0.4)


def test_a_look_at_the_present_is_what_a_recording_has() -> None:
    """At a sample all that the two have in common is the same number."""
    run = Simulation(parse_scenario(goliath_lift(HOLD)))
    run.advance_to(0.5)
    recording = run.recording()
    assert recording.time[-1] == 0.5
    for variable, name in (
        ("rope_tension", "hoist.gol.A.1"),
        ("body_position", "hung"),
        ("body_velocity", "hung"),
        ("hook_load", "gol.A"),
        ("joint_position", "gol.one"),
    ):
        last = recording.column(variable, name)[-1]
        assert run.now(variable, name) == pytest.approx(last, rel=1e-9, abs=1e-9), variable
    with pytest.raises(KeyError, match=r"rope_tension has no 'hoist'"):
        run.now("rope_tension", "hoist")
    with pytest.raises(KeyError, match=r"no 'hook_lode' at present; there are .*rope_tension, .*hook_load, "):
        run.now("hook_lode", "gol.A")


@pytest.mark.parametrize("lift", ["equalizer", "crane_barge_in_swell", "reeved_hoist"])
def test_the_present_has_what_follows_from_a_sample(lift: str) -> None:
    """Tilts, travels, vessels and moorings of the present are those of the last sample."""
    run = Simulation(lift, sample_interval=0.5)
    run.advance_to(1.0)
    recording = run.recording()
    asked = []
    for name in (
        "load_tilt",
        "load_transferred",
        "sheave_travel",
        "vessel_heel",
        "vessel_draft",
        "mooring_tension",
        "rope_paid_out",
        "hoist_load",
        "vessel_wave_elevation",
    ):
        if name not in recording:
            continue
        asked.append(name)
        label = recording.coordinates[recording[name].dims[1]][0]
        last = recording.column(name, label)[-1]
        assert run.now(name, label) == pytest.approx(last, rel=1e-9, abs=1e-9), name
    assert len(asked) >= 3


def test_a_drum_pays_out_at_a_positive_speed() -> None:
    run = Simulation(parse_scenario(TACKLE))
    run.command("winch", speed=0.05)
    run.advance_to(3.0)
    paid, speed = run.drive_state("winch")
    assert paid > 0.0 and speed == pytest.approx(0.05, rel=1e-6)
