"""`gantline statics --level`, `--want`, `--plumb`, as people use them."""

from __future__ import annotations

import json
import math
import re
import subprocess
from pathlib import Path

import pytest

from gantline.results import open_recording
from gantline.scenario import load_scenario
from gantline.statics import Statics
from gantline.study import run_cases
from hooked_lift import two_hooks
from program import called


def statics(*arguments: object) -> subprocess.CompletedProcess[str]:
    return called("statics", *arguments)


@pytest.fixture
def lift(tmp_path: Path) -> Path:
    """A load under two hooks, neither level nor plumb."""
    path = tmp_path / "lift.yaml"
    path.write_text(two_hooks(), encoding="utf-8")
    return path


def test_level_and_back_into_the_lift_file(lift: Path, tmp_path: Path) -> None:
    """The case that is printed hangs level to what a tenth of a millimetre makes over 4 m: 0.002°."""
    result = statics(lift, "--level", "-o", tmp_path / "out")
    assert result.returncode == 0, result.stderr
    assert re.search(r"S1 +12\.0000 m +11\.\d{4} m +-\d+\.\d mm", result.stdout)
    assert "tilt 2.289 deg, then 0.000 deg" in result.stdout
    case = re.search(r"lengths: \{set: .*\}", result.stdout)
    assert case is not None
    with lift.open("a", encoding="utf-8") as file:
        file.write(f"cases:\n  {case[0]}\n")
    found = run_cases(lift)
    (level,) = found.of("lengths")
    assert level.rest is not None
    assert level.rest.recording.column("load_tilt", "load")[-1] < 1e-4
    recording = open_recording(tmp_path / "out" / "equilibrium.nc")
    assert recording.column("load_tilt", "load")[-1] < 1e-8


def test_what_is_wanted_by_name(lift: Path) -> None:
    want = "slope_x=0 deg, slope_y=1 deg, S1=20 %"
    result = statics(lift, "--want", want, "--adjust", "S1, S2,S3", "--most", "0.5 m")
    assert result.returncode == 0, result.stderr
    assert "then 1.000 deg" in result.stdout
    assert "S4" not in result.stdout


def test_plumb(lift: Path) -> None:
    result = statics(lift, "--plumb")
    assert result.returncode == 0, result.stderr
    assert re.search(
        r"A +-4\.\d{4} m +0\.\d{4} m +\+\d+\.\d mm +-\d+\.\d mm +16\.81 kN +0\.00 kN", result.stdout
    )
    assert "plumb: {set: {cranes.A.at.x: -4." in result.stdout
    one = statics(lift, "--plumb", "--adjust", "A")
    assert one.returncode == 0, one.stderr
    assert re.search(r"B +- +- +- +- +16\.81 kN +0\.00 kN", one.stdout)


def test_lengths_as_json(lift: Path, tmp_path: Path) -> None:
    """The numbers of the table, unrounded; put into the lift file the new lengths hang it level."""
    result = statics(lift, "--level", "--json", "-o", tmp_path / "out")
    assert result.returncode == 0, result.stderr
    assert "equilibrium.nc" in result.stderr
    found = json.loads(result.stdout)
    numbers = ["values", "lengths", "given", "chain_hoists", "before", "after", "slack_by_least_change"]
    numbers.append("cannot_start")
    assert list(found) == [*numbers, "residual", "steps", "left_out"]
    assert found["chain_hoists"] == {}
    assert found["given"] == {"S1": 12.0, "S2": 12.1, "S3": 12.0, "S4": 12.2}
    assert found["values"] == {f"slings.{name}.length": value for name, value in found["lengths"].items()}
    assert math.degrees(found["before"]["load_tilt"]["load"]) == pytest.approx(2.289, abs=5e-4)
    assert found["after"]["load_tilt"]["load"] < 1e-8
    assert found["before"]["load_heading"].keys() == {"load"}
    assert found["after"]["sling_tension"].keys() == {"S1", "S2", "S3", "S4"}
    level = load_scenario(lift).changed({path: f"{value!r} m" for path, value in found["values"].items()})
    rest = Statics(level).equilibrium().recording
    assert rest.column("load_tilt", "load")[-1] < 1e-8


def test_places_as_json(lift: Path) -> None:
    result = statics(lift, "--plumb", "--json")
    assert result.returncode == 0, result.stderr
    found = json.loads(result.stdout)
    assert found["values"].keys() == {f"cranes.{hook}.at.{axis}" for hook in "AB" for axis in "xy"}
    assert [found["values"][f"cranes.A.at.{axis}"] for axis in "xy"] == pytest.approx(found["places"]["A"])
    before, after = found["side_pulls"]["A"]
    assert math.hypot(*before) == pytest.approx(16.81e3, abs=5.0)
    assert math.hypot(*after) < 1.0
    assert found["drift"] is None
    assert found["left_out"] == []


def test_wanted_as_json(lift: Path) -> None:
    result = statics(lift, "--want", "slope_x=0 deg, slope_y=1 deg", "--json")
    assert result.returncode == 0, result.stderr
    found = json.loads(result.stdout)
    assert math.degrees(found["after"]["load_tilt"]["load"]) == pytest.approx(1.0, abs=1e-6)


def test_drift_of_the_reference_lift() -> None:
    """Five crossed slings turn the frame by 1.6°, and the load by none: it comes off where it stood."""
    result = statics("equalizer", "--plumb")
    assert result.returncode == 0, result.stderr
    assert "drift when it comes off: 0.0 mm, then 0.0 mm" in result.stdout


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("--level", "--most", "10 mm"), "--level: too far: S"),
        (("--want", "heading=170 deg"), "--want: "),
    ],
)
def test_what_cannot_be_ends_with_three(lift: Path, arguments: tuple[str, ...], message: str) -> None:
    result = statics(lift, *arguments)
    assert result.returncode == 3, result.stdout
    assert message in result.stderr
    assert "Traceback" not in result.stderr


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("--level", "--plumb"), "--plumb: moves hooks until none is pulled aside; --level does not"),
        (("--want", "S1"), "--want: 'S1' says nothing; wanted is written like 'slope_x=0 deg"),
        (("--want", "slope_x=0 deg"), "--want: 'slope_y' is not given"),
        (("--want", "slope_x=0 deg,slope_y=95 deg"), "--want: a slope is less than 90 deg"),
        (("--want", "S1=3 kN"), "--want: S1: "),
        (("--want", "S9=20 %"), "error: --want: 'S9' is not a sling"),
        (
            ("--want", "S1=30"),
            "--want: S1: 3000 % is no share of what all slings carry; one is written like '30 %'",
        ),
        (("--level", "--adjust", "S9"), "error: --adjust: 'S9' is not a sling"),
        (("--level", "--most", "-1 m"), "--most: '-1 m' is no change of a length"),
        (("--adjust", "S1"), "--adjust: belongs to --plumb, --want or --level"),
        (("--most", "1 m"), "--most: belongs to --want or --level"),
        (("--plumb", "--adjust", "C"), "error: --adjust: 'C' is not a hook in which slings hang"),
    ],
)
def test_bad_input_is_named(lift: Path, arguments: tuple[str, ...], message: str) -> None:
    result = statics(lift, *arguments)
    assert result.returncode == 2, result.stdout
    assert message in result.stderr
    assert "Traceback" not in result.stderr


def test_trolleys_and_their_crane_by_their_positions() -> None:
    result = statics("goliath", "--plumb")
    assert result.returncode == 0, result.stderr
    one = (
        r"  plumb: {set: {cranes\.goliath\.trolleys\.upper\.position: (\S+) m, "
        r"cranes\.goliath\.trolleys\.lower\.position: (\S+) m, cranes\.goliath\.position: (\S+) m}}$"
    )
    found = re.search(one, result.stdout, flags=re.M)
    assert found is not None
    # Of the trolleys' hooks, and of the crane's, whose hooks are 6 m, -6 m and 0 m across.
    for hook, x, across in (("U1", found[1], 6.0), ("U2", found[1], -6.0), ("L", found[2], 0.0)):
        row = next(line for line in result.stdout.splitlines() if line.startswith(f"  goliath.{hook} "))
        assert row.split()[1] == x
        assert float(row.split()[3]) == pytest.approx(float(found[3]) + across, abs=1e-9)


def test_hooks_at_booms_have_no_place_of_their_own() -> None:
    result = statics("floating_crane", "--plumb")
    assert result.returncode == 2
    assert "lets its boom follow the load, and a sweep of 'cranes." in result.stderr
    assert ".boom.angle' shows" in result.stderr
