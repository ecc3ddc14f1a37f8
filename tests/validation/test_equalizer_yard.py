"""The load of the reference lift at creep: conditions, hold points, and what creep is worth."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import gantline

LIFT = Path(__file__).resolve().parents[2] / "scenarios" / "equalizer_yard" / "scenario.yaml"
G = 9.81
MASS = 300e3  # kg
CREEP, BRAKE_TIME = 0.3 / 60, 0.05  # m/s; 0.005 m/s at 0.1 m/s²
#: Static end state of the reference lift by an independent solution: frame at −68.983°, slings 1 to 5 [N].
STATIC = np.array([589.746e3, 593.180e3, 588.600e3, 593.180e3, 589.746e3])
PLAN = [
    "take up slack",
    "look round",
    "to 50 percent",
    "hold point 1",
    "lift off",
    "clear 0.3 m",
    "hold point 2",
    "hoist",
]


@pytest.fixture(scope="module")
def lift() -> gantline.Recording:
    return gantline.simulate(LIFT)


@pytest.fixture(scope="module")
def mirrored(tmp_path_factory: pytest.TempPathFactory) -> gantline.Recording:
    """The lift with slings 1 and 5, and 2 and 4, to lugs that mirror each other: nothing turns the frame."""
    text = LIFT.read_text(encoding="utf-8")
    for sling, lug, other in (("e1.2", "L2", "L4"), ("e1.4", "L4", "L5"), ("e1.5", "L5", "L2")):
        before = f"from: {sling}, to: block.{lug}"
        assert before in text
        text = text.replace(before, f"from: {sling}, to: block.{other}")
    path = tmp_path_factory.mktemp("mirrored") / "scenario.yaml"
    path.write_text(text, encoding="utf-8")
    return gantline.simulate(path)


def events(recording: gantline.Recording, kind: str) -> list[tuple[str, float]]:
    """Name and time [s] of the events of a kind, in their order."""
    rows = zip(
        recording["event_name"].values,
        recording["event_time"].values,
        recording["event_kind"].values,
        strict=True,
    )
    return [(str(name), float(time)) for name, time, found in rows if found == kind]


def stiffness() -> float:
    """Of the load on slings and equalizing rope in series [N/m].

    With the equalizing rope's tension T each sling pulls with 2 T, the load with 10 T. Sling i stretches by
    sᵢ = 2 T Lᵢ/EA, the sheaves sink by dᵢ with Σ 2 dᵢ = T L/EA of the equalizing rope, and the load by
    x = dᵢ + sᵢ, hence 10 x = Σ 2 (dᵢ + sᵢ).
    """
    slings = (2 * 23.0 + 3 * 26.0) / 200e6
    equalizing = (10 * 2.0 + 9 * math.pi * 0.4) / 100e6
    return 100.0 / (4.0 * slings + equalizing)


def dynamic_factor(recording: gantline.Recording, begin: float, end: float) -> float:
    """Largest hook load within a time over the static one: of the load, without frame and sheaves."""
    within = (recording.time >= begin) & (recording.time < end)
    dead = (20e3 + 5 * 300.0) * G
    force = recording["hook_load"].values[within, 0] - dead
    return float(force.max()) / (MASS * G)


def test_steps_follow_each_other(lift: gantline.Recording) -> None:
    """Every step begins when the one before it ends, in the order of the plan; the last one ends too."""
    begins, ends = events(lift, "step_begin"), events(lift, "step_end")
    assert [name for name, _ in begins] == PLAN == [name for name, _ in ends]
    assert [time for _, time in begins[1:]] == pytest.approx([time for _, time in ends[:-1]], abs=1e-9)


def test_steps_end_when_their_condition_is_met(lift: gantline.Recording) -> None:
    """2 % and 50 % are transferred as braking begins, not a sample before; *lift off* ends at lift-off."""
    ends = dict(events(lift, "step_end"))
    transferred = lift["load_transferred"].values[:, 0]
    begin = dict(events(lift, "step_begin"))
    for step, share, speed in (("take up slack", 0.02, 3 / 60), ("to 50 percent", 0.5, 0.5 / 60)):
        braking = ends[step] - speed / 0.1  # at 0.1 m/s²
        before = (lift.time > begin[step] + 1.0) & (lift.time < braking - 1e-6)
        assert transferred[before].max() <= share
        first = int(np.searchsorted(lift.time, braking))
        assert transferred[first : first + 2].max() >= share
    lift_off = min(time for _, time in events(lift, "lift_off"))
    assert ends["lift off"] == pytest.approx(lift_off + BRAKE_TIME, abs=2e-3)


def test_holds_last_as_long_as_planned(lift: gantline.Recording) -> None:
    """10 s, 10 s and 30 s, and the hook stands meanwhile."""
    begins, ends = dict(events(lift, "step_begin")), dict(events(lift, "step_end"))
    hook = lift.column("joint_position", "test_hook")
    for step, duration in (("look round", 10.0), ("hold point 1", 10.0), ("hold point 2", 30.0)):
        assert ends[step] - begins[step] == pytest.approx(duration, abs=2e-3)
        held = hook[(lift.time >= begins[step]) & (lift.time <= ends[step])]
        assert np.ptp(held) == 0.0


def test_ways_are_as_planned(lift: gantline.Recording) -> None:
    """Clear 0.3 m at 0.3 m/min takes 60 s and one braking, hoist 1 m at 3 m/min 20 s and one braking."""
    begins, ends = dict(events(lift, "step_begin")), dict(events(lift, "step_end"))
    hook = lift.column("joint_position", "test_hook")
    for step, way, speed in (("clear 0.3 m", 0.3, CREEP), ("hoist", 1.0, 3 / 60)):
        at = np.searchsorted(lift.time, [begins[step] - 1e-9, ends[step]])
        assert hook[at[1]] - hook[at[0]] == pytest.approx(way, abs=1e-4)
        assert ends[step] - begins[step] == pytest.approx(way / speed + speed / 0.1, abs=2e-3)


def test_load_transferred_at_the_hold_points(lift: gantline.Recording) -> None:
    """1 − support forces/weight: it swings below the half at hold point 1; all of it from hold point 2 on."""
    begins, ends = dict(events(lift, "step_begin")), dict(events(lift, "step_end"))
    transferred = lift["load_transferred"].values[:, 0]
    at_first = transferred[(lift.time >= begins["hold point 1"]) & (lift.time <= ends["hold point 1"])]
    assert at_first.min() > 0.02 and at_first.max() < 0.6
    assert np.all(transferred[lift.time >= begins["hold point 2"]] == 1.0)
    assert lift.metrics()["final_load_transferred"] == 1.0


def test_static_tensions_are_those_of_the_reference_lift(lift: gantline.Recording) -> None:
    """Means over the quiet end against an independent static solution: the way does not change the end."""
    metrics = lift.metrics()
    static = [metrics[f"static_sling_tension.sling.S{k}"] for k in range(1, 6)]
    assert static == pytest.approx(STATIC, rel=1e-3)


def test_creep_costs_less_than_the_reference_lift(lift: gantline.Recording) -> None:
    """More than by hoisting speed alone, 1 + v √(k/m)/g; less than half of what 6 m/min cost, 702.0/589.7."""
    amplification = lift.metrics()["dynamic_amplification_factor"]
    assert 1 + CREEP * math.sqrt(stiffness() / MASS) / G < amplification < 1 + 0.5 * (702.0 / 589.7 - 1)


def test_frame_of_the_mirrored_order_does_not_turn(mirrored: gantline.Recording) -> None:
    """With slings that mirror each other the horizontal pulls have no moment about the hook."""
    assert np.abs(mirrored.column("joint_position", "e1")).max() < 1e-6


def test_dynamic_factors_of_the_mirrored_order(mirrored: gantline.Recording) -> None:
    """A stop from v in a part of the period: 1 + v ω/g; a start with constant a: 1 + 2 a/g; ω² = k/m."""
    omega = math.sqrt(stiffness() / MASS)
    assert BRAKE_TIME * omega < 0.6
    ends, begins = dict(events(mirrored, "step_end")), dict(events(mirrored, "step_begin"))
    stop = ends["clear 0.3 m"]
    # Braking pulls less, the half period after it more; what rings from before is of a percent of this.
    assert dynamic_factor(mirrored, stop, stop + 2.0) - 1 == pytest.approx(CREEP * omega / G, rel=0.1)
    start = begins["hoist"]
    assert math.pi / omega < 0.05 / 0.1, "the start lasts longer than half a period"
    assert dynamic_factor(mirrored, start, start + 0.5) - 1 == pytest.approx(2 * 0.1 / G, rel=0.1)
