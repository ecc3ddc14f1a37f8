"""The benchmark lifts and the arithmetic of the race; the hand-written program against gantline."""

from __future__ import annotations

import math
import shutil
import sys
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from benchmarks import race, race_report, stages  # noqa: E402
from benchmarks.contract import SAMPLE_INTERVAL, Setting, sample_count  # noqa: E402
from benchmarks.gantline_code import Gantline, GantlineRun  # noqa: E402
from benchmarks.lifts import equalizer_lift, varied_lift  # noqa: E402
from benchmarks.measure import Errors, Point, cost, errors, growth  # noqa: E402
from benchmarks.worker import CODES, Worker  # noqa: E402
from benchmarks.yardstick import Yardstick, compiler  # noqa: E402

needs_compiler = pytest.mark.skipif(shutil.which(compiler()[0]) is None, reason="no C compiler")


# --- the lifts ---------------------------------------------------------------------------------------


def test_the_equalizing_rope_is_as_long_as_its_parts_and_half_turns() -> None:
    lift = equalizer_lift(5)
    assert lift.equalizing_length == pytest.approx(10 * 3.0 + 9 * math.pi * 0.4)
    assert lift.equalizing_stiffness == pytest.approx(4e7 / lift.equalizing_length)


def test_the_load_starts_where_the_first_sling_is_taut() -> None:
    # Sling 0 of E(5): 23 m long, its lug 0.7 m along and 2.5 m across; all others are longer than their way.
    lift = equalizer_lift(5)
    top = lift.load_height + 2.5
    assert top == pytest.approx(55.0 - math.sqrt(23.0**2 - 0.7**2 - 2.5**2))
    gaps = [
        length - math.dist((x, 0.0, 55.0), (*lug, top))
        for length, lug, x in zip(lift.sling_lengths, lift.lugs, lift.sheave_x, strict=True)
    ]
    assert min(gaps) == pytest.approx(0.0, abs=1e-12)
    assert gaps[0] == pytest.approx(gaps[4])


def test_short_slings_repeat_every_four_from_both_ends() -> None:
    lengths = equalizer_lift(10).sling_lengths
    assert [i for i, length in enumerate(lengths) if length == 23.0] == [0, 4, 5, 9]
    assert set(lengths) == {23.0, 26.0}


@pytest.mark.parametrize("n", [7, 20])
def test_lugs_of_a_long_load_are_mirrored_with_opposite_sides(n: int) -> None:
    lugs = equalizer_lift(n).lugs
    assert [y for _, y in lugs[:2]] == [2.5, -2.5]
    for (x, y), (mirrored_x, mirrored_y) in zip(lugs, reversed(lugs), strict=True):
        assert (mirrored_x, mirrored_y) == pytest.approx((-x, -y))


def test_varied_slings_stay_within_five_centimetres_and_are_always_the_same() -> None:
    lift = varied_lift(100)
    plan = equalizer_lift(100).sling_lengths
    deviation = np.subtract(lift.sling_lengths, plan)
    assert np.abs(deviation).max() <= 0.05
    # Of 100 uniform numbers the standard deviation is known to 4.5 %; four times that is as good as never.
    assert deviation.std() == pytest.approx(0.1 / math.sqrt(12), rel=0.18)
    assert lift == varied_lift(100)


# --- the runs ----------------------------------------------------------------------------------------


@needs_compiler
@pytest.mark.parametrize("vectorised", [False, True])
def test_gantline_agrees_with_the_hand_written_program(vectorised: bool) -> None:
    # Written from the equations, in minimal coordinates, with another method: no code in common.
    lift = equalizer_lift(7)
    ours = GantlineRun(lift, tolerance=0.1, duration=3.0)
    theirs = Yardstick(vectorised).prepare(lift, Setting("RK4, h [ms]", 0.25), 3.0)
    ours.integrate()
    theirs.integrate()
    scale = lift.load_mass * lift.gravity / lift.sheaves
    assert theirs.tensions().max() > 2 * scale, "the load falls into its slings"
    # What is left is the fixed step, which knows nothing of ropes going taut and slack within it.
    assert errors(ours.tensions(), theirs.tensions(), scale).rms < 1e-5


@needs_compiler
def test_the_hand_written_program_is_of_order_four_up_to_where_it_is_unstable() -> None:
    # Before any rope is taut but two, so that the motion is smooth; stable below 2.79/1960 s = 1.42 ms.
    lift = equalizer_lift(5)
    scale = lift.load_mass * lift.gravity / lift.sheaves

    def error(step: float) -> float:
        runs = [Yardstick(True).prepare(lift, Setting("RK4, h [ms]", value), 0.5) for value in (step, 0.1)]
        for run in runs:
            run.integrate()
        return errors(runs[0].tensions(), runs[1].tensions(), scale).rms

    assert error(1.25) / error(0.625) > 12
    assert error(2.5) > 100 * error(1.25)


def test_gantline_records_a_hundred_times_a_second_whatever_the_tolerance() -> None:
    lift = equalizer_lift(5)
    for tolerance in (1e2, 1e4):
        run = Gantline().prepare(lift, Setting("adaptive, tolerance [N]", tolerance), 0.5)
        run.integrate()
        assert run.tensions().shape == (sample_count(0.5), 5)
    assert sample_count(0.5) == 1 + round(0.5 / SAMPLE_INTERVAL)


def test_codes_have_names_of_their_own_and_ladders_from_tight_to_loose() -> None:
    assert len({code.name for code in CODES}) == len(CODES)
    for code in CODES:
        assert code.name in race_report.LOOKS
        for n in (5, 20, 100, 400):
            values = [setting.value for setting in code.settings(equalizer_lift(n))]
            assert values == sorted(values), (code.name, n)


def test_a_code_in_its_process_tells_what_went_wrong() -> None:
    worker = Worker(CODES[0])
    try:
        assert worker.version()
        outcome = worker.run(equalizer_lift(5), Setting("adaptive, tolerance [N]", -1.0), 0.1)
        assert outcome.tension is None and outcome.failure
        outcome = worker.run(equalizer_lift(5), Setting("adaptive, tolerance [N]", 1e4), 0.1)
        assert outcome.tension is not None and outcome.seconds > 0
    finally:
        worker.stop()


# --- the arithmetic ----------------------------------------------------------------------------------


def test_errors_are_relative_to_the_given_tension() -> None:
    reference = np.array([[1.0, 2.0], [3.0, 5.0]])
    found = errors(reference + np.array([[0.0, 0.0], [0.0, 1.0]]), reference, scale=10.0)
    assert (found.rms, found.peak, found.final) == pytest.approx((0.05, 0.1, 0.1))


def point(rms: float, seconds: float) -> Point:
    return Point(Setting("h", seconds), seconds, Errors(rms, rms, rms))


FAILED = Point(Setting("h", 0.0), 0.0, None, "unstable")


def test_time_is_interpolated_logarithmically() -> None:
    # Error falls like time to the power -2: at 1e-3, between (1e-4, 10 s) and (1e-2, 1 s), it is √10 s.
    found = cost([point(1e-4, 10.0), point(1e-2, 1.0)], 1e-3)
    assert found is not None and found.interpolated
    assert found.seconds == pytest.approx(math.sqrt(10.0))


@pytest.mark.parametrize(
    ("ladder", "seconds"),
    [
        ([point(1e-4, 10.0), point(1e-3, 4.0)], 4.0),  # even the loosest is good enough
        ([point(1e-4, 10.0), FAILED], 10.0),  # nothing beyond to interpolate to
        ([point(1e-4, 10.0), point(1e-3, 12.0), point(1.0, 11.0)], 10.0),  # a slower one that is worse
        ([FAILED, point(1e-4, 10.0)], None),
        ([point(0.1, 10.0), point(1e-4, 1.0)], None),  # right by luck
        ([], None),
    ],
)
def test_time_at_an_error(ladder: list[Point], seconds: float | None) -> None:
    found = cost(ladder, 1e-2)
    assert (None if found is None else found.seconds) == seconds


def test_growth_of_a_power_law_is_its_exponent() -> None:
    assert growth([5, 20, 100], [2 * n**1.3 for n in (5, 20, 100)]) == pytest.approx(1.3)


def test_long_runs_are_repeated_less() -> None:
    entry = race.Entry(Setting("h", 1.0))
    assert entry.wanted(0)
    for seconds, repeats in ((0.1, 5), (5.0, 3), (100.0, 1)):
        entry.seconds = [seconds]
        assert [entry.wanted(repeat) for repeat in range(6)] == [repeat < repeats for repeat in range(6)]
    entry.failure = "unstable"
    assert not entry.wanted(0)


def test_shares_of_stages_add_up() -> None:
    _, passed, counters = stages.timed(5, measures=True)
    found = stages.shares(passed)
    assert {name for name, _, _ in found} >= {"kinematics", "assembly", "factorisation", "solution", "events"}
    assert sum(share for _, _, share in found) == pytest.approx(1.0)
    assert counters["steps"] > 0
    assert stages.timed(5, measures=False)[1] == {}


# --- the report --------------------------------------------------------------------------------------


def made_up() -> race_report.Result:
    ladders = {
        ("E(5)", "gantline"): [point(1e-4, 0.04), point(1e-2, 0.02)],
        ("E(5)", "MuJoCo"): [point(1e-3, 1.0), point(1e-2, 0.1)],
        ("E(5)", "OpenSim"): [point(0.05, 3.0), FAILED],
    }
    versions = {"gantline": "1", "MuJoCo": "2", "OpenSim": "3"}
    return race_report.Result(["E(5)"], {"E(5)": 10.0}, versions, ladders)


def test_the_table_tells_times_and_how_many_times_gantlines_they_are() -> None:
    assert race_report.rows(made_up(), 0.01) == [
        ["gantline", "2"],
        ["MuJoCo", "10 (5 ×)"],
        ["OpenSim", "not below 5 %"],
    ]


def test_the_page_picture_and_points_are_written(tmp_path: Path) -> None:
    race_report.write(made_up(), tmp_path)
    page = (tmp_path / "race.md").read_text(encoding="utf-8")
    assert "| MuJoCo | 10 (5 ×) |" in page and "MuJoCo 2" in page
    assert (tmp_path / "race.png").stat().st_size > 10_000
    lines = (tmp_path / "race.csv").read_text(encoding="utf-8").splitlines()
    assert len(lines) == 1 + 6 and lines[-1].endswith("unstable")
    panels = race_report.picture(made_up()).axes
    assert [line.get_label() for line in panels[0].get_lines() if line.get_label() in made_up().versions] == [
        "gantline",
        "MuJoCo",
        "OpenSim",
    ]
