"""Records of motion: what is read of them, what is wrong with some, and the waves that add up to them."""

from __future__ import annotations

import math
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gantline.hydro import DatabaseError, MotionRecord, read_motion_record, write_motion_record
from gantline.hydro.motion_record import Harmonics
from gantline.scenario import ScenarioError, parse_scenario
from gantline.simulation import Simulation
from hooked_lift import TWO_HOOKS, TWO_HOOKS_LUGS, TWO_HOOKS_SLINGS, hooked_lift

EITHER = "needs 'raos', a table of RAOs, or 'record', a motion over time, and not both"
PLACED = "{record: motion.csv, at: [50 m, 0 m, 4 m]}"
RNG = np.random.default_rng(1)
HEAD = "time [s],heave [m],roll [deg]"
WAVES = [(0.5 * k, math.cos(0.4 * k), 2 * math.sin(0.4 * k)) for k in range(400)]
LINES = [f"{time:g},{heave:.9g},{roll:.9g}" for time, heave, roll in WAVES]


def written(folder: Path, *lines: str) -> Path:
    path = folder / "motion.csv"
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


def test_what_a_record_says(tmp_path: Path) -> None:
    """From its mean; what has no column does not move."""
    record = read_motion_record(written(tmp_path, "# of nobody", HEAD, *LINES))
    want = np.zeros((400, 6))
    want[:, 2] = [heave for _, heave, _ in WAVES]
    want[:, 3] = np.radians([roll for *_, roll in WAVES])
    assert (record.interval, record.duration) == (0.5, 199.5)
    assert record.mean == pytest.approx(want.mean(axis=0), abs=1e-9)
    assert record.motion == pytest.approx(want - want.mean(axis=0), abs=1e-8)


def test_times_may_begin_anywhere_and_columns_stand_in_any_order(tmp_path: Path) -> None:
    plain = read_motion_record(written(tmp_path, HEAD, *LINES))
    other = [f"{roll:.9g};{1000 + time:g};{heave:.9g}".replace(".", ",") for time, heave, roll in WAVES]
    again = read_motion_record(written(tmp_path, "roll [deg];time [s];heave [m]", *other))
    assert again.interval == pytest.approx(plain.interval)
    assert (again.motion == plain.motion).all()


def test_a_record_that_is_written_is_read(tmp_path: Path) -> None:
    record = read_motion_record(written(tmp_path, HEAD, *LINES))
    write_motion_record(record, tmp_path / "again.csv")
    again = read_motion_record(tmp_path / "again.csv")
    assert again.motion == pytest.approx(record.motion, abs=1e-11)
    assert again.mean == pytest.approx(record.mean, abs=1e-11)


@given(
    st.lists(
        st.tuples(st.floats(0.3, 2.0), st.floats(0.1, 1.0), st.floats(0.0, 6.2)), min_size=1, max_size=8
    ),
    st.sampled_from([0.1, 0.25, 0.5]),
)
def test_its_waves_add_up_to_it(parts: list[tuple[float, float, float]], interval: float) -> None:
    """What is left out is 0.1 % rms of it, over the record and its way back, at which nothing looks here."""
    time: Any = interval * np.arange(int(240 / interval))
    way = sum(size * np.cos(omega * time + phase) for omega, size, phase in parts)
    motion = np.zeros((len(time), 6))
    motion[:, 2] = way - np.mean(way)
    found = MotionRecord("record", interval, motion, np.zeros(6)).harmonics()
    missed = found.at(time) - motion
    assert np.sqrt(np.mean(missed[:, 2] ** 2)) < 1.5e-3 * motion[:, 2].std()
    assert not missed[:, [0, 1, 3, 4, 5]].any()


@pytest.mark.parametrize(
    ("lines", "said"),
    [
        ([HEAD, *LINES[:15]], "has 15 samples; no fewer than 16 tell a motion"),
        (["time [s]", "0", "1"], "there is no motion beside the time; 'time [s]', 'heave [m]'"),
        (["heave [m]", "0", "1"], "1: there is no column 'time [s]'"),
        (["time [s],heave [deg]", "0,1"], "1: 'heave [deg]' has no unit of it; 'heave [m]' is right"),
        (["time [s],z [m]", "0,1"], "1: 'z [m]' is no column of a record of motion; 'time [s]'"),
        ([HEAD, LINES[0], LINES[0]], "3: 0 s is not after the line before"),
        (
            [HEAD, *LINES[:3], *LINES[4:]],
            "5: 1 s after the line before; most lines are 0.5 s apart, and times at even",
        ),
        (
            [HEAD, *LINES[:9], "4.5,,1"],
            "11: '' is no number; it is the heave; a motion that there is none of",
        ),
        (["time [s],roll [rad]", *(f"{k},{k}" for k in range(20))], "roll goes 9.5 rad from its mean"),
    ],
)
def test_what_is_wrong_is_said(tmp_path: Path, lines: list[str], said: str) -> None:
    with pytest.raises(DatabaseError) as problem:
        read_motion_record(written(tmp_path, *lines))
    assert said in str(problem.value)


@pytest.mark.parametrize(
    ("heave", "said"),
    [
        (np.zeros(500), "nothing moves in it"),
        (
            np.random.default_rng(1).normal(size=9000),
            r"it takes \d{4} waves, down to 0\.2 s, to come as near",
        ),
    ],
)
def test_what_has_no_waves_is_said(tmp_path: Path, heave: Any, said: str) -> None:
    lines = [f"{0.1 * k:.1f},{value:.6g}" for k, value in enumerate(heave)]
    with pytest.raises(DatabaseError, match=said):
        read_motion_record(written(tmp_path, "time [s],heave [m]", *lines)).harmonics()


def test_how_far_a_motion_may_go(tmp_path: Path) -> None:
    """1000 m and 1.6 rad from its mean, in as few as 16 samples."""
    head = "time [s],sway [m],yaw [rad]"
    for sway, yaw, said in (
        (999.0, 1.599, ""),
        (1001.0, 1.0, "sway goes 1e+03 m"),
        (1.0, 1.601, "yaw goes 1.6 rad"),
    ):
        lines = [f"{k},{sway * (-1) ** k},{yaw * (-1) ** k}" for k in range(16)]
        path = written(tmp_path, head, *lines)
        if not said:
            assert np.abs(read_motion_record(path).motion[:, [1, 5]]).max(axis=0) == pytest.approx(
                [sway, yaw]
            )
            continue
        with pytest.raises(DatabaseError, match=re.escape(said)):
            read_motion_record(path)


def test_how_many_samples_a_record_may_have(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("gantline.hydro.motion_record._MOST_SAMPLES", 20)
    assert len(read_motion_record(written(tmp_path, HEAD, *LINES[:20])).motion) == 20
    with pytest.raises(DatabaseError, match=r":22: more than 20 samples; leave every other out"):
        read_motion_record(written(tmp_path, HEAD, *LINES[:21]))


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_how_uneven_times_may_be(tmp_path: Path, sign: float) -> None:
    """One of 400 is away from its place by less or more than 0.1 % of the interval, √2/3 s."""
    for share, is_even in ((0.97e-3, True), (1.03e-3, False)):
        times = math.sqrt(2.0) / 3.0 * (np.arange(400) + sign * share * (np.arange(400) == 200))
        path = written(tmp_path, HEAD, *(f"{time:.12g},{k % 3},0" for k, time in enumerate(times)))
        if is_even:
            assert read_motion_record(path).interval == pytest.approx(math.sqrt(2.0) / 3.0, rel=1e-7)
            continue
        with pytest.raises(DatabaseError, match="times at even intervals are right"):
            read_motion_record(path)


def test_a_decimal_as_wide_as_the_interval_leaves_times_open(tmp_path: Path) -> None:
    """0.1 s is 62.5 % of 0.16 s, which is read (tests/regression/test_record_of_few_decimals.py), and 67 % of
    0.15 s: a line of those that is missing could be rounding.
    """
    lines = [f"{0.15 * k:.1f},{k % 3},0" for k in range(400)]
    with pytest.raises(DatabaseError, match="times at even intervals are right"):
        read_motion_record(written(tmp_path, HEAD, *lines))


def test_its_way_back_takes_three_periods() -> None:
    """Ten waves of 8 s from 0 to 80 s every 0.1 s, and 24 s back: harmonics of 104 s."""
    motion = np.zeros((801, 6))
    motion[:, 4] = 0.1 * np.cos(2.0 * math.pi * np.arange(801) / 80.0)
    waves = MotionRecord("record", 0.1, motion - motion.mean(axis=0), np.zeros(6)).harmonics()
    assert waves.period == pytest.approx(8.0, rel=1e-12)
    assert waves.frequency[:2] == pytest.approx([2.0 * math.pi / 104.0, 4.0 * math.pi / 104.0], rel=1e-12)


@pytest.mark.parametrize("period", [4.0, 8.0, 16.0])
def test_accelerations_within_two_seconds_of_its_ends(period: float) -> None:
    """-ω² cos(ωt + 1) to 3 %: the way back goes on with its derivatives, each by a power of half a fitted
    stretch of half a period. One that is 10 % too long or too short leaves 6 %.
    """
    omega, time = 2.0 * math.pi / period, 0.1 * np.arange(int(103 * period))
    motion = np.zeros((len(time), 6))
    motion[:, 2] = np.cos(omega * time + 1.0)
    waves = MotionRecord("record", 0.1, motion - motion.mean(axis=0), np.zeros(6)).harmonics()
    turns = np.exp(-1j * np.outer(time, waves.frequency))
    acceleration = (turns @ (-(waves.frequency**2) * waves.motion[:, 2])).real
    missed = np.abs(acceleration + omega**2 * motion[:, 2])[[*range(20), *range(-20, 0)]]
    assert missed.max() < 0.03 * omega**2


def test_waves_that_ride_on_a_drift_keep_their_ends() -> None:
    """Waves of 4 s on a drift of 5 m, whose mean period counts as 20 s: half of that has 2.5 of them,
    which no polynomial of degree 7 follows, and one through less of it does. What is left out is 1.4 mm rms,
    which at the ends comes to a fifth of the acceleration; of one through all of it that is 2 to 10 times.
    """
    omega, time = 0.5 * math.pi, 0.1 * np.arange(6001)
    wave = 0.3 * np.cos(omega * time + 1.0)
    motion = np.zeros((len(time), 6))
    motion[:, 0] = 5.0 * time / 600.0 + wave
    waves = MotionRecord("record", 0.1, motion - motion.mean(axis=0), np.zeros(6)).harmonics()
    turns = np.exp(-1j * np.outer(time, waves.frequency))
    acceleration = (turns @ (-(waves.frequency**2) * waves.motion[:, 0])).real
    assert np.abs(acceleration + omega**2 * wave).max() < 0.2 * 0.3 * omega**2


@pytest.mark.parametrize(("samples", "waves"), [(3950, None), (4050, r"it takes 20\d\d waves")])
def test_how_many_waves_a_record_may_take(samples: int, waves: str | None) -> None:
    """Of noise all harmonics are needed, half as many as samples there and back; 2000 are allowed."""
    motion = np.zeros((samples, 6))
    motion[:, 0] = np.random.default_rng(6).standard_normal(samples)
    record = MotionRecord("record", 0.1, motion - motion.mean(axis=0), np.zeros(6))
    if waves is None:
        assert 0.5 * samples - 5 <= len(record.harmonics().frequency) <= 2000
        return
    with pytest.raises(DatabaseError, match=waves):
        record.harmonics()


def lift(motion: str, waves: str = "") -> str:
    """A vessel that moves so, beside a load on the ground."""
    vessel = f"""vessels:
  vessel:
    position: [200 m, 0 m]
    draft: 4 m
    hull: {{box: [100 m, 30 m, 8 m]}}
    wave_motion: {motion}
{waves}"""
    return hooked_lift(
        TWO_HOOKS, TWO_HOOKS_LUGS, TWO_HOOKS_SLINGS, mass=200e3, position=(0, 0, 6.9), more=vessel
    )


@pytest.mark.parametrize(
    ("motion", "said"),
    [
        (
            "{at: [50 m, 0 m, 4 m]}",
            EITHER,
        ),
        (
            "{raos: vessel.csv, phases: lag, record: motion.csv, at: [50 m, 0 m, 4 m]}",
            EITHER,
        ),
        ("{raos: vessel.csv, at: [50 m, 0 m, 4 m]}", "'phases' is missing; 'lag' or 'lead'"),
        ("{record: motion.csv, phases: lag, at: [50 m, 0 m, 4 m]}", "phases: a record has no phases"),
    ],
)
def test_a_motion_is_given_once(motion: str, said: str) -> None:
    with pytest.raises(ScenarioError) as problem:
        parse_scenario(lift(motion))
    assert said in str(problem.value)


def test_a_record_lasts_as_long_as_its_lift(tmp_path: Path) -> None:
    written(tmp_path, HEAD, *LINES[:20])
    scenario = parse_scenario(lift(PLACED), str(tmp_path / "lift.yaml"))
    with pytest.raises(ScenarioError) as problem:
        Simulation(scenario)
    assert "wave_motion.record: motion.csv: lasts 9.5 s and the lift" in str(problem.value)


def test_a_record_that_is_not_there_is_missed(tmp_path: Path) -> None:
    scenario = parse_scenario(lift(PLACED), str(tmp_path / "lift.yaml"))
    with pytest.raises(
        ScenarioError, match=r"lift.yaml:\d+: vessels.vessel.wave_motion.record: motion.csv: cannot"
    ):
        Simulation(scenario)


def test_waves_of_the_lift_are_none_of_the_record(tmp_path: Path) -> None:
    written(tmp_path, HEAD, *LINES)
    text = lift(
        PLACED,
        "waves: {swell: {height: 0.5 m, period: 8 s, direction: 180 deg}}\n",
    )
    told = Simulation(parse_scenario(text, str(tmp_path / "lift.yaml"))).assembly.warnings
    assert any("a record knows nothing of 'waves' of the lift" in one for one in told)
    calm = Simulation(parse_scenario(lift(PLACED), str(tmp_path / "lift.yaml"))).assembly.warnings
    assert not any("record" in one for one in calm)


@pytest.mark.parametrize(
    ("period", "share", "told"), [(1.99, 0.201, True), (1.99, 0.199, False), (2.01, 0.9, False)]
)
def test_waves_of_which_no_vessel_moves(period: float, share: float, told: bool) -> None:
    """Of accelerations ω²X, one of 10 s and a short one, that has a share s = F/√(F² + S²) of both: S = 1."""
    omega = 2.0 * math.pi / np.array([10.0, period])
    motion = np.zeros((2, 6), dtype=complex)
    motion[:, 4] = np.array([1j, share / math.sqrt(1.0 - share**2)]) / omega**2
    found: Any = Harmonics(omega, motion, 10.0).too_fast
    assert found == (("pitch", pytest.approx(share, rel=1e-12)) if told else None)


@pytest.mark.parametrize(("share", "told"), [(0.0501, True), (0.0499, False)])
def test_decimals_that_tell_too_little(share: float, told: bool) -> None:
    """A decimal d leaves d/√12 open, rms; of yaw of ±0.01 rad, whose rms that is; surge is 3 times it."""
    motion = np.zeros((16, 6))
    motion[:, 5] = np.tile([-0.01, 0.01], 8)
    motion[:, 0] = 3.0 * motion[:, 5]
    decimal = np.full(6, share * 0.01 * math.sqrt(12.0))
    found: Any = MotionRecord("record", 1.0, motion, np.zeros(6), decimal).coarse
    assert found == (("yaw", pytest.approx(share, rel=1e-12)) if told else None)


def test_decimals_of_turns_are_those_of_their_unit(tmp_path: Path) -> None:
    """0.1 deg of a roll of 12.3 deg, which is any number of rad; 0.001 rad of a pitch of 0.123 rad."""
    lines = [f"{k},{12.3 * (-1) ** k},{0.123 * (-1) ** k}" for k in range(16)]
    found = read_motion_record(written(tmp_path, "time [s],roll [deg],pitch [rad]", *lines)).decimal
    assert found[3:5] == pytest.approx([math.radians(0.1), 1e-3], rel=1e-12)
