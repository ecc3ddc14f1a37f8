"""`gantline ballast`, as people use it."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path

import pytest

from ballasted import barge, pump, tank, text
from program import called, program

TANKS = {
    "fore": tank((85, 0, 0.5), 900.0),
    "aft": tank((20, 0, 0.5), 200.0),
    "side": tank((50, 5, 0.5), 50.0),
}
PLAN = [pump("fore", "aft", "3000 t/h", by="100 t"), {"step": "wait", "hold": "until_end"}]


def ballast(*arguments: object) -> subprocess.CompletedProcess[str]:
    return called("ballast", *arguments)


@pytest.fixture
def lift(tmp_path: Path) -> Path:
    path = tmp_path / "lift.yaml"
    path.write_text(text(barge(TANKS), PLAN), encoding="utf-8")
    return path


def test_contents_and_back_into_the_lift_file(lift: Path, tmp_path: Path) -> None:
    """What is written floats as wanted, and only contents are other."""
    written = tmp_path / "ballasted.yaml"
    wanted = ("--step", "fore to aft", "--heel=-0.2 deg", "--draft", "3.9 m")
    result = program("ballast", lift, *wanted, "--write", written)
    assert result.returncode == 0, result.stderr
    assert "heel -0.200 deg, trim 0.000 deg, draft 3.900 m" in result.stdout
    assert "at that moment" in result.stdout, "the plan pumps before"
    assert f"Lift file   {written}" in result.stdout
    before, after = (path.read_text(encoding="utf-8").splitlines() for path in (lift, written))
    other = [old for old, new in zip(before, after, strict=True) if old != new]
    assert len(other) == 3
    assert all("content" in line for line in other)
    # Contents are written to the kilogram: nothing is left to move but that.
    again = ballast(written, *wanted, "--json")
    assert again.returncode == 0, again.stderr
    found = json.loads(again.stdout)
    assert found["moved"] < 5.0
    assert found["attitude"]["draft"] == pytest.approx(3.9, abs=1e-6)


def test_only_some_tanks(lift: Path) -> None:
    result = ballast(lift, "--tanks", "aft, side", "--time", "0 s", "--json")
    assert result.returncode == 0, result.stderr
    found = json.loads(result.stdout)
    assert found["contents"]["fore"] == 900e3
    assert found["time"] == 0.0
    assert abs(found["attitude"]["trim"]) < 1e-7


@pytest.mark.parametrize(
    ("arguments", "code", "sentence"),
    [
        (["--tanks", "foer"], 2, "'foer' is not a tank of barge; did you mean 'fore'?"),
        (["--tanks", ","], 2, "no tank may change; name one at least"),
        (["--vessel", "boat"], 2, "'boat' is not a vessel with tanks"),
        (["--step", "wiat"], 2, "'wiat' is not a step of the plan; did you mean 'wait'?"),
        (["--step", "wait", "--time", "1 s"], 2, "a time and a step are given; one of them says when"),
        (["--time", "700 s"], 2, "700 s is not in the lift, which lasts 600 s"),
        (["--draft", "4"], 2, "--draft: '4' has no unit"),
        (["--draft", "0 m"], 2, "--draft: '0 m' is no draft"),
        (["--heel", "50 deg"], 2, "--heel: 50 deg is too steep; less than 45 deg is right"),
        (["--trim", "10 m"], 2, "--trim: '10 m' is a length"),
        (["--draft", "8 m"], 2, "8 m is not between the keel of barge at 0 m and its deck at 8 m; it floats"),
        (["--draft", "70 m"], 2, "a draft of 70 m is not between the keel of barge"),
        (
            ["--draft", "7 m"],
            3,
            "a draft of 7 m takes 9375.0 t more in the tanks, and they have room for 6130",
        ),
        (
            ["--draft", "3.4 m"],
            3,
            "takes 1695.0 t less in the tanks, and they can give 1050.0 t (the draft is",
        ),
        (["--trim", "6 deg"], 3, "the tanks cannot do it; the nearest that was found is heel"),
    ],
)
def test_what_cannot_be(lift: Path, arguments: list[str], code: int, sentence: str) -> None:
    result = ballast(lift, *arguments)
    assert (result.returncode, result.stdout) == (code, "")
    assert sentence in result.stderr
    assert "Traceback" not in result.stderr


def test_a_file_that_is_there_stays(lift: Path) -> None:
    before = lift.read_text(encoding="utf-8")
    result = ballast(lift, "--write", lift)
    assert result.returncode == 2
    assert "is there already; a new file is needed" in result.stderr
    assert lift.read_text(encoding="utf-8") == before
