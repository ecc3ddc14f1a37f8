"""Heave compensation: what its filter lets by, over ground and deck; limits, where it ends, at rest."""

from __future__ import annotations

from importlib.resources import files
from pathlib import Path

import numpy as np
import pytest

import gantline
from compensated import (
    BARGE,
    EASE,
    HOOK,
    VESSEL,
    compensated,
    compensated_text,
    deck_below,
    expected,
    head_of,
    place_of,
)
from gantline.results import Recording
from gantline.scenario import parse_scenario
from lift_text import changed

START = "wraps_at_start: 60"
STILL = "  - {step: still, hold: until_end, compensate_heave: H1}\n"


def rms(values: np.ndarray) -> float:
    return float(np.sqrt(np.mean(np.square(values))))


def hook(recording: Recording) -> np.ndarray:
    return recording.column("hook_height", HOOK)


@pytest.fixture(scope="module")
def kept_still() -> Recording:
    return gantline.Simulation(compensated(STILL)).run()


def test_a_hook_keeps_what_the_filter_lets_by(kept_still: Recording) -> None:
    """(HC1) over the rigid heave of the vessel at the boom head.

    A parabola through glances of 0.1 s leaves (ωT)² = 0.8 % of the heave of waves of 7 s at most, (HC3), and
    0.5 % with what is made good; boom and tackles give way under what the load still bounces.
    """
    recording = kept_still
    heave = place_of(recording, VESSEL, head_of(recording))[:, 2]
    wanted = expected(recording.time, heave)
    kept = hook(recording)[0] + heave - heave[0] + wanted
    assert rms(heave - np.mean(heave)) > 0.1, "it heaves"
    assert rms(hook(recording) - kept) < 6e-3 * rms(heave - np.mean(heave))
    # What it has added is that, without what gives way.
    added = recording.column("heave_compensation", HOOK)
    assert rms(added - wanted) < 5e-3 * rms(wanted)
    assert recording.attributes["warnings"] == []


def test_without_it_the_load_is_thrown_about(kept_still: Recording) -> None:
    """The force on the hook varies as the hook is accelerated: (HC1) of it with compensation, all without."""
    thrown = gantline.Simulation(compensated("  - {step: still, hold: until_end}\n")).run()
    loads = [one.column("hook_load", HOOK) for one in (kept_still, thrown)]
    with_it, without = (float(np.std(load) / np.mean(load)) for load in loads)
    assert without > 5e-3 and with_it < 0.15 * without


def test_a_hook_keeps_still_above_a_deck() -> None:
    """The same over the deck of a cargo barge below the boom head, which heaves and rolls by itself."""
    name = files("gantline.scenarios") / "off_a_barge.yaml"
    text = name.read_text(encoding="utf-8")
    begin, end = text.index("\nplan:\n"), text.index("\nwatch:\n")
    plan = "  - {step: still, hold: until_end, compensate_heave: H1, relative_to: cargo}\n"
    text = text[:begin] + f"\nplan:\n{plan}" + text[end:]
    can = "heave_compensation: {speed: 2 m/s, acceleration: 2 m/s^2}"
    text = changed(
        text,
        ("duration: 200 s", "duration: 60 s"),
        ("emergency_acceleration: 0.1 m/s^2}", f"emergency_acceleration: 0.1 m/s^2, {can}}}"),
    )
    recording = gantline.Simulation(parse_scenario(text, str(name))).run()
    head = head_of(recording)
    place = place_of(recording, VESSEL, head)
    heave = place[:, 2] - deck_below(recording, "cargo", place)
    wanted = expected(recording.time, heave)
    added = recording.column("heave_compensation", HOOK)
    assert rms(wanted) > 0.05
    assert rms(added - wanted) < 6e-3 * rms(wanted)


@pytest.mark.parametrize(
    ("limit", "can", "most", "slope"),
    [
        ("speed", "speed: 0.05 m/s, acceleration: 1 m/s^2", 0.05, 1),
        ("acceleration", "speed: 1 m/s, acceleration: 0.05 m/s^2", 0.05, 2),
        ("stroke", "speed: 1 m/s, acceleration: 1 m/s^2, stroke: 0.2 m", 0.1, 0),
    ],
    ids=["speed", "acceleration", "stroke"],
)
def test_it_keeps_to_its_limits_and_tells(limit: str, can: str, most: float, slope: int) -> None:
    """What is added, or its differences between samples, comes to the limit and not past it, and is told."""
    recording = gantline.Simulation(compensated(STILL, can=can, lasts="60 s")).run()
    found = recording.column("heave_compensation", HOOK)
    for _ in range(slope):
        found = np.diff(found) / 0.1
    # Samples are rounded to nothing here, but glances lie some roundings beside them.
    assert 0.95 * most < np.max(np.abs(found)) < most * (1 + 1e-6)
    kinds = list(recording["event_kind"].values)
    when = recording["event_time"].values[kinds.index(f"compensation_{limit}_limit")]
    assert sum(kind.startswith("compensation_") for kind in kinds) == 1
    assert recording.attributes["warnings"] == [
        f"heave compensation of {HOOK} comes to the limit of its {limit} at {when:.2f} s, and follows no "
        "more than that lets it"
    ]


def test_where_it_ends_the_hook_stays_and_heights_count_from_there() -> None:
    """Falls as long at the end as with no compensation before: `to` is a height in still water."""
    plan = (
        "  - {step: still, hold: 31.7 s, compensate_heave: H1}\n"
        "  - {step: up, hoist: H1, speed: 6 m/min, to: 32 m}\n"
        "  - {step: hold, hold: until_end}\n"
    )
    falls = {}
    for text in (plan, plan.replace(", compensate_heave: H1", "")):
        recording = gantline.Simulation(compensated(text, lasts="70 s")).run()
        head = recording.column("body_position", f"{HOOK}/upper_sheaves")[:, 2]
        falls[text] = head - hook(recording), recording
    (with_it, recording), (without, _) = falls.values()
    added = recording.column("heave_compensation", HOOK)
    ended = recording.time > 31.7 + EASE + 0.1
    assert np.max(np.abs(added[recording.time < 31.0])) > 0.1
    assert np.all(added[ended] == 0.0)
    # Hoisted rope is the same but for the strain at which it was wound: losses change the lead line's 1.6e-3
    # by a fifth as the drum turns back, over 5 m of rope and 12 parts of line 0.13 mm each way.
    assert abs(with_it[-1] - without[-1]) < 3e-4
    # Nothing jumps as it ends: the hoist goes 0.1 m/s, and the boom head heaves with up to 0.4 m/s.
    near = (recording.time > 31.5) & (recording.time < 37.0)
    assert np.max(np.abs(np.diff(with_it[near]))) < 0.1 * (0.1 + 0.4)


def test_one_step_after_another_it_goes_on() -> None:
    """Split into steps that all compensate, and with one that also lowers: the same to what lowering adds."""
    plan = (
        "  - {step: still, hold: 20 s, compensate_heave: H1}\n"
        "  - {step: down, lower: H1, speed: 6 m/min, by: 1 m, compensate_heave: sheerleg.H1}\n"
        "  - {step: hold, hold: until_end, compensate_heave: H1}\n"
    )
    recording = gantline.Simulation(compensated(plan, lasts="60 s")).run()
    heave = place_of(recording, VESSEL, head_of(recording))[:, 2]
    wanted = expected(recording.time, heave)
    added = recording.column("heave_compensation", HOOK)
    assert rms(added - wanted) < 6e-3 * rms(wanted)
    lowered = hook(recording) - hook(recording)[0] - (heave - heave[0] + wanted)
    # To what is left in the mean of 0.6 % of the heave, 0.18 m rms, over three waves.
    assert abs(np.mean(lowered[recording.time > 40.0]) + 1.0) < 5e-4


def test_it_asks_as_much_of_the_hook_on_a_higher_layer() -> None:
    """Rope from the second layer, wider by its diameter, goes faster: the drum turns by as much less.

    What the hook adds is a matter of how its boom head heaves, which layers change by rounding.
    """
    text = compensated_text(STILL, lasts="8 s")
    low, high = (
        gantline.Simulation(
            parse_scenario(changed(text, (START, f"wraps_at_start: {wraps}")), str(BARGE))
        ).run()
        for wraps in (60, 100)
    )
    layers = [run["drum_layer"].values[[0, -1], 0].tolist() for run in (low, high)]
    assert layers == [[1.0, 1.0], [2.0, 2.0]]
    on_first, on_second = (run.column("heave_compensation", HOOK) for run in (low, high))
    assert np.ptp(on_first) > 1e-4
    assert np.max(np.abs(on_second - on_first)) < 1e-6 * np.ptp(on_first)


def test_an_emergency_stop_ends_it() -> None:
    """Brakes of 0.1 m/s² stop what is added as well, within 5 s."""
    plan = f"{STILL}\nemergency_stop: {{at: 40 s}}\n"
    recording = gantline.Simulation(compensated(plan, lasts="50 s")).run()
    added = recording.column("heave_compensation", HOOK)
    after = recording.time > 40.0 + 5.0
    assert np.ptp(added[after]) == 0.0
    assert np.ptp(added[recording.time < 40.0]) > 0.1


def test_taken_up_again_it_gives_the_same_bytes(tmp_path: Path) -> None:
    """Saved between two glances, and gone on with elsewhere."""
    lift = compensated(STILL, lasts="30 s")
    whole = gantline.Simulation(lift).run()
    first, other = gantline.Simulation(lift), gantline.Simulation(lift)
    first.run(until=14.23)
    other.restore(first.save())
    assert (
        other.run().save(tmp_path / "other.nc").read_bytes() == whole.save(tmp_path / "whole.nc").read_bytes()
    )


def test_in_equal_steps_it_is_the_same(kept_still: Recording) -> None:
    """`del` glances at the beginnings of its steps, 20 ms apart, and so sees some of it later."""
    recording = gantline.Simulation(compensated(STILL, lasts="40 s"), integrator="del", step=0.02).run()
    added = [one.column("heave_compensation", HOOK)[: len(recording.time)] for one in (recording, kept_still)]
    assert rms(added[0] - added[1]) < 1e-2 * rms(added[1])


def test_at_rest_nothing_heaves() -> None:
    """Statics of a plan that compensates are those of one that does not, to the last digit."""
    plan = (
        "  - {step: up, hoist: H1, speed: 6 m/min, by: 1 m, compensate_heave: H1}\n"
        "  - {step: on, hold: until_end}\n"
    )
    found = []
    for text in (plan, plan.replace(", compensate_heave: H1", "")):
        rest = gantline.Statics(compensated(text)).equilibrium(time=60.0)
        found.append([rest.recording.column(name, HOOK)[-1] for name in ("hook_height", "hook_load")])
    assert found[0] == found[1]


def test_at_rest_where_a_run_has_got_to_the_hook_is_where_it_was_kept() -> None:
    """The equilibrium of a state in which it compensates: falls as long as then, and nothing goes on."""
    lift = compensated(STILL, lasts="30 s")
    run = gantline.Simulation(lift)
    recording = run.run(until=28.0)
    rest = gantline.Statics(lift).equilibrium_of(run.save()).recording
    falls = [
        one.column("body_position", f"{HOOK}/upper_sheaves")[-1, 2] - hook(one)[-1]
        for one in (recording, rest)
    ]
    assert abs(recording.column("heave_compensation", HOOK)[-1]) > 0.1
    # What the load bounces about at that time stretches them.
    assert abs(falls[0] - falls[1]) < 2e-3
