"""Two recordings side by side: differences that are known beforehand."""

from __future__ import annotations

import json
import math
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import gantline
from gantline.results.common_time import CommonTime, Deviation
from gantline.results.comparison import Comparison, Difference, compare, method_of, peak_sling, tolerances_of
from gantline.results.recording import Recording
from gantline.results.rotation import angle_between
from sample_lift import ringing_lift, sample_recording, sample_rig

Array = npt.NDArray[np.float64]

TURN = 2 * math.pi
MEAN, SWING = 600e3, 100e3  # N


def waves(time: Array, swing: float = SWING, phase: float = 0.0, **given: Any) -> Recording:
    """A lift whose slings all ring at 1 Hz about 600 kN."""
    tension = MEAN + swing * np.sin(TURN * time + phase)
    return sample_recording(time, tension=np.repeat(tension[:, None], 5, axis=1), **given)


def deviation(comparison: Comparison, rope: str = "sling.S1") -> Deviation:
    found = next(one for one in comparison.ropes if one.name == rope).deviation
    assert found is not None
    return found


def renamed(recording: Recording, names: dict[str, str]) -> Recording:
    """The recording with other names along dimensions, in texts and in its rig."""
    coordinates = {
        dim: [names.get(label, label) for label in labels] for dim, labels in recording.coordinates.items()
    }
    variables = {
        name: replace(one, values=np.array([names.get(str(text), str(text)) for text in one.values]))
        if one.is_text
        else one
        for name, one in recording.variables.items()
    }
    rig = json.dumps(recording.attributes["rig"])
    for old, new in names.items():
        rig = rig.replace(f'"{old}"', f'"{new}"')
    return Recording(variables, coordinates, {**recording.attributes, "rig": json.loads(rig)})


# --- series over time ----------------------------------------------------------------------------


def test_a_larger_swing_of_the_same_phase() -> None:
    """B - A = 20 kN sin: rms 20/√2 kN over whole periods, largest at the first quarter."""
    time = np.linspace(0.0, 4.0, 401)
    found = deviation(compare(waves(time), waves(time, 1.2 * SWING)))
    assert found.rms == pytest.approx(20e3 / math.sqrt(2), rel=1e-12)
    assert abs(found.largest) == pytest.approx(20e3, rel=1e-12)
    assert found.time % 0.5 == pytest.approx(0.25)
    assert found.unit == "N"


def test_a_shifted_phase() -> None:
    """sin(x + φ) - sin x = 2 sin(φ/2) cos(x + φ/2)."""
    time = np.linspace(0.0, 2.0, 201)
    phase = TURN / 50
    found = deviation(compare(waves(time), waves(time, phase=phase)))
    swing = 2 * SWING * math.sin(phase / 2)
    assert found.rms == pytest.approx(swing / math.sqrt(2), rel=1e-12)
    assert abs(found.largest) == pytest.approx(swing, rel=1e-9)  # at x + φ/2 = 0.5 turns, a sample
    assert found.time == pytest.approx(0.49) or found.time == pytest.approx(0.99)


def test_the_finer_recording_is_interpolated_at_the_samples_of_the_coarser() -> None:
    """A straight line between samples 1 ms apart is off by at most ω² h²/8 of the swing."""
    fine, coarse = np.linspace(0.0, 2.0, 2001), np.linspace(0.0, 2.0, 83)
    off = SWING * (TURN * 1e-3) ** 2 / 8
    for pair in ((fine, coarse), (coarse, fine)):
        comparison = compare(waves(pair[0]), waves(pair[1]))
        assert comparison.common is not None
        np.testing.assert_array_equal(comparison.common.times, coarse)
        assert abs(deviation(comparison).largest) <= off
        assert deviation(comparison).rms <= off


def test_as_many_samples_at_other_times() -> None:
    """Lines are lines wherever they are sampled: 3 t - 2 t = t over 0 .. 2."""
    one, other = np.array([0.0, 0.5, 2.0]), np.array([0.0, 1.5, 2.0])
    common = CommonTime.of(one, other)
    assert common is not None
    np.testing.assert_allclose(common.times, [0.0, 0.5, 1.5, 2.0])
    difference = common.difference(2.0 * one, 3.0 * other)
    np.testing.assert_allclose(difference, common.times)
    found = common.deviation("m", difference)
    assert (found.largest, found.time) == (2.0, 2.0)


def test_the_mean_square_counts_time_and_not_samples() -> None:
    """1 during 9 s and 0 during 1 s, with a hundred samples in the last: √((9 + 0.005)/10)."""
    times = np.concatenate([[0.0, 9.0], np.linspace(9.01, 10.0, 100)])
    common = CommonTime.of(times, times)
    assert common is not None
    found = common.deviation("1", np.where(times <= 9.0, 1.0, 0.0))
    assert found.rms == pytest.approx(math.sqrt((9.0 + 0.005) / 10.0))


def test_only_the_span_that_both_have_is_compared() -> None:
    long, short = np.linspace(0.0, 8.0, 801), np.linspace(0.0, 3.0, 301)
    comparison = compare(waves(long), waves(short, 1.1 * SWING))
    assert comparison.common is not None
    assert comparison.common.times[-1] == pytest.approx(3.0)
    assert deviation(comparison).rms == pytest.approx(10e3 / math.sqrt(2))


def test_recordings_without_common_time() -> None:
    assert CommonTime.of(np.zeros(0), np.array([0.0, 1.0])) is None
    assert CommonTime.of(np.array([0.0, 1.0]), np.array([2.0, 3.0])) is None


# --- motion --------------------------------------------------------------------------------------


def test_motion_of_the_load() -> None:
    """B rises 30 mm higher and tilts 2 deg more by the end, both evenly."""
    time = np.linspace(0.0, 10.0, 101)
    tension = np.full((101, 5), 1e5)
    level = sample_recording(time, tension=tension, load_z=2.5 + 0.1 * time)
    off = sample_recording(time, tension=tension, load_z=2.5 + 0.103 * time, tilt=np.radians(0.2 * time))
    (load,) = compare(level, off).loads
    assert load.position is not None and load.attitude is not None
    assert load.position.largest == pytest.approx(0.03)
    assert load.position.rms == pytest.approx(0.03 / math.sqrt(3), rel=1e-3)
    assert load.attitude.largest == pytest.approx(math.radians(2.0))
    assert (load.position.time, load.attitude.time) == (10.0, 10.0)
    bodies = {one.name: one for one in compare(level, off).bodies}
    assert bodies["block"].position == load.position
    assert bodies["e1"].position == Deviation("m", 0.0, 0.0, 0.0)


def test_attitudes_are_compared_between_samples_whatever_the_signs_of_their_quaternions() -> None:
    fine, coarse = np.linspace(0.0, 1.0, 101), np.linspace(0.0, 1.0, 11)

    def about_z(time: Array) -> Array:
        half = time / 2
        return np.stack([np.cos(half), 0 * half, 0 * half, np.sin(half)], axis=-1)

    common = CommonTime.of(fine, coarse)
    assert common is not None
    signs = np.where(np.arange(101) % 2, -1.0, 1.0)[:, None]
    assert common.turn(signs * about_z(fine), -about_z(coarse)).max() < 1e-12


def test_angle_between_two_attitudes() -> None:
    quarter = math.sqrt(0.5)
    upright, turned = np.array([1.0, 0, 0, 0]), np.array([quarter, 0, quarter, 0])
    assert angle_between(upright, turned) == pytest.approx(math.pi / 2)
    assert angle_between(upright, -turned) == pytest.approx(math.pi / 2)
    assert angle_between(turned, turned) == 0.0


# --- numbers -------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("a", "b", "absolute", "relative"),
    [
        (200.0, 210.0, 10.0, 0.05),
        (-200.0, -210.0, -10.0, -0.05),
        (0.0, 0.0, 0.0, 0.0),
        (0.0, 1.0, 1.0, None),
        (None, 1.0, None, None),
        (1.0, None, None, None),
    ],
)
def test_differences(
    a: float | None, b: float | None, absolute: float | None, relative: float | None
) -> None:
    assert Difference(a, b).absolute == absolute
    assert Difference(a, b).relative == relative


def test_metrics_and_counters_of_both() -> None:
    a, b = ringing_lift(), ringing_lift(events=[])
    comparison = compare(a, b)
    assert comparison.metrics["lift_off_time"].absolute == pytest.approx(
        0.01
    )  # 9.99 s, and the sample at 10 s
    assert comparison.metrics["peak_sling_tension"].absolute == 0.0
    assert comparison.counters["steps"] == Difference(10, 10)
    assert peak_sling(a) == "S2"


def test_metrics_that_only_one_has() -> None:
    rig = {**sample_rig(), "equalizers": []}
    comparison = compare(ringing_lift(), ringing_lift(rig=rig))
    spread = comparison.metrics["final_tension_spread"]
    assert spread.a == pytest.approx(0.02)
    assert spread.b is None


def test_methods_in_words() -> None:
    def method(**integrator: Any) -> str:
        recording = ringing_lift()
        attributes = {**recording.attributes, "settings": {"integrator": integrator}}
        return method_of(Recording(recording.variables, recording.coordinates, attributes))

    assert method(type="adaptive", tension_tolerance=None, position_tolerance=None) == "adaptive"
    assert (
        method(type="adaptive", tension_tolerance=50.0, position_tolerance=1e-4)
        == "adaptive, tension tolerance 50 N, position tolerance 0.1 mm"
    )
    recording = ringing_lift()
    kept = {"type": "adaptive", "tension_tolerance": 50.0, "position_tolerance": 1e-4}
    attributes = {**recording.attributes, "settings": {"integrator": kept}}
    kept_to = Recording(recording.variables, recording.coordinates, attributes)
    assert method_of(kept_to, with_tolerances=False) == "adaptive" and tolerances_of(kept_to) == (50.0, 1e-4)
    # Names say only what tells the two apart.
    assert all(name.endswith("(adaptive)") for name in compare(kept_to, kept_to).names)
    assert "tension tolerance 50 N" in compare(kept_to, recording).names[0]
    assert method(type="del", step=0.001, paper=False, geometric_stiffness=True) == "del, step 1 ms"
    assert method(type="del", step=0.05, paper=True) == "del, step 50 ms, as in the paper"
    assert (
        method(type="del", step=0.1, geometric_stiffness=False)
        == "del, step 100 ms, without geometric stiffness"
    )


# --- what belongs together -----------------------------------------------------------------------


def test_the_only_hook_load_and_equalizer_belong_together_whatever_their_names() -> None:
    a = ringing_lift()
    names = {"test_hook": "goliath", "block": "module", "e1": "eq", "e1.equalizing": "eq.equalizing"}
    b = renamed(a, names)
    comparison = compare(a, b)
    (hook,), (load,) = comparison.hooks, comparison.loads
    assert (hook.name, hook.name_b) == ("test_hook", "goliath")
    assert (load.name, load.name_b) == ("block", "module")
    assert hook.deviation is not None and hook.deviation.largest == 0.0
    pairs = {rope.name: rope.name_b for rope in comparison.ropes}
    assert pairs["e1.equalizing"] == "eq.equalizing"
    assert (comparison.only_a, comparison.only_b) == ({}, {})


def test_what_only_one_has_is_named() -> None:
    a = ringing_lift()
    b = renamed(a, {"sling.S5": "sling.S9", "S5": "S9"})
    comparison = compare(a, b)
    assert [rope.name for rope in comparison.ropes] == [
        "e1.equalizing",
        *(f"sling.S{k}" for k in range(1, 5)),
    ]
    assert comparison.only_a == {"sling": ["S5"]}
    assert comparison.only_b == {"sling": ["S9"]}


def test_a_lift_without_equalizer_beside_one_with() -> None:
    bare = sample_rig()
    bare["equalizers"] = []
    bare["ropes"] = [rope for rope in bare["ropes"] if rope["name"] != "e1.equalizing"]
    comparison = compare(ringing_lift(), ringing_lift(rig=bare))
    assert comparison.only_a == {"equalizer": ["e1"]}
    assert comparison.only_b == {}


def test_files_are_compared_too(tmp_path: Path) -> None:
    time = np.linspace(0.0, 1.0, 101)
    a, b = waves(time), waves(time, 1.5 * SWING)
    a.save(tmp_path / "a.nc")
    b.save(tmp_path / "b.nc")
    of_files = gantline.compare(tmp_path / "a.nc", str(tmp_path / "b.nc"), names=("one", "other"))
    assert of_files.names == ("one", "other")
    assert of_files.to_json() == gantline.compare(a, b, names=("one", "other")).to_json()
    json.dumps(of_files.to_json(), allow_nan=False)
    with pytest.raises(FileNotFoundError):
        gantline.compare(a, tmp_path / "none.nc")


# --- properties ----------------------------------------------------------------------------------

samples = st.integers(2, 12)


@st.composite
def recordings(draw: st.DrawFn) -> Recording:
    """Lifts of any tensions, tilts and heights at any sample times."""
    count = draw(samples)
    gaps = draw(st.lists(st.floats(1e-3, 2.0), min_size=count - 1, max_size=count - 1))
    generator = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    return sample_recording(
        np.concatenate([[0.0], np.cumsum(gaps)]),
        tension=generator.uniform(0.0, 1e6, (count, 5)),
        travel=generator.uniform(-1.0, 1.0, (count, 5)),
        contact=generator.choice([0.0, 1e5], (count, 4)),
        tilt=generator.uniform(-0.3, 0.3, count),
        yaw=generator.uniform(-3.0, 3.0, count),
        load_z=generator.uniform(2.0, 4.0, count),
        energy={"kinetic": generator.uniform(0.0, 1e5, count)},
    )


def deviations(comparison: Comparison) -> list[Deviation | None]:
    moving = [*comparison.loads, *comparison.bodies]
    forces = [one.deviation for one in (*comparison.ropes, *comparison.hooks)]
    return [*forces, *(one.position for one in moving), *(one.attitude for one in moving)]


@given(recordings())
@settings(max_examples=30)
def test_a_recording_does_not_differ_from_itself(recording: Recording) -> None:
    comparison = compare(recording, recording)
    assert {(value.absolute, value.relative) for value in comparison.metrics.values()} == {(0.0, 0.0)}
    assert {value.absolute for value in comparison.counters.values()} == {0}
    for one in deviations(comparison):
        assert one is not None
        assert (one.rms, one.largest) == (0.0, 0.0)
    assert comparison.only_a == comparison.only_b == {}


@given(recordings(), recordings())
@settings(max_examples=30)
def test_swapping_the_recordings_turns_the_signs(a: Recording, b: Recording) -> None:
    forth, back = compare(a, b), compare(b, a)
    assert set(forth.metrics) == set(back.metrics)
    for name, value in forth.metrics.items():
        mirrored = back.metrics[name]
        assert (value.a, value.b) == (mirrored.b, mirrored.a)
        assert value.absolute is None or value.absolute == -(mirrored.absolute or 0.0)
    for one, other in zip(forth.ropes, back.ropes, strict=True):
        assert (one.peak_a, one.peak_b) == (other.peak_b, other.peak_a)
    for here, there in zip(deviations(forth), deviations(back), strict=True):
        assert here is not None and there is not None
        is_signed = here.unit == "N"
        assert asdict(here) == asdict(replace(there, largest=-there.largest) if is_signed else there)
    assert (forth.only_a, forth.only_b) == (back.only_b, back.only_a)
    assert forth.stability == back.stability[::-1]
