"""`gantline compare`: what it prints and writes, and how it ends."""

from __future__ import annotations

import json
import os
import signal
import subprocess
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

import gantline
from fake_core import FakeCore, core
from gantline.cli.app import app
from lift_text import DEAD_CENTRE
from program import PROGRAM

__all__ = ["core"]

SCENARIOS = Path(__file__).parents[2] / "scenarios"
SHORT = ("--both", "duration=1 s")
NAMES = ("pulleys", "pulleys" + ", integrator=adaptive")


def compare(*words: str | Path) -> Result:
    return CliRunner().invoke(app, ["compare", *(str(word) for word in words)])


def lines(result: Result) -> list[str]:
    """Printed lines with single spaces."""
    return [" ".join(line.split()) for line in result.stdout.splitlines()]


@pytest.fixture(scope="module")
def two_methods(tmp_path_factory: pytest.TempPathFactory) -> tuple[Result, Path]:
    folder = tmp_path_factory.mktemp("compare") / "out"
    return compare("pulleys", *SHORT, "--b", "integrator=adaptive", "-o", folder), folder


def test_one_lift_by_two_methods(two_methods: tuple[Result, Path]) -> None:
    result, folder = two_methods
    assert result.exit_code == 0, result.output
    said = lines(result)
    assert said[:2] == [f"{letter} {name}" for letter, name in zip("AB", NAMES, strict=True)]
    assert "method del, step 1 ms adaptive" in said
    assert "status done done" in said
    assert any(line.startswith("steps 1,000 ") for line in said)
    assert any(line.startswith("rope 99.917 N ") for line in said)
    assert sum("the balance closes" in line for line in said) == 2
    assert "simulating A: pulleys" in result.stderr
    assert "simulated 1.0 of 1.0 s" in result.stderr
    written = {"a.nc", "b.nc", "comparison.json", "comparison.txt"}
    assert {path.name for path in folder.iterdir()} == written | {
        "compare_rope_tension.png",
        "compare_motion.png",
    }
    assert (folder / "comparison.txt").read_text() in result.stdout
    assert str(folder / "compare_motion.png") in result.stdout


def test_the_numbers_are_those_of_the_recordings(two_methods: tuple[Result, Path]) -> None:
    _, folder = two_methods
    numbers = json.loads((folder / "comparison.json").read_text())
    again = gantline.compare(folder / "a.nc", folder / "b.nc", names=NAMES).to_json()
    assert numbers == again | {"verdicts": [None, None]}
    assert numbers["counters"]["steps"]["a"] == 1000
    # The first step of del is h g/2 per step late at rest: after t its bodies are ½ a h t behind.
    box = next(body for body in numbers["bodies"] if body["name"] == "box")
    acceleration = 2 * 0.363 / 1.0**2
    assert box["position"]["largest"] == pytest.approx(acceleration * 1e-3 / 2, rel=1e-2)
    assert box["position"]["time"] == 1.0


def test_recordings_and_folders_of_runs(two_methods: tuple[Result, Path], tmp_path: Path) -> None:
    _, folder = two_methods
    run = CliRunner().invoke(
        app, ["run", "pulleys", "--duration", "1 s", "-o", str(tmp_path / "run"), "--no-plots"]
    )
    assert run.exit_code == 0, run.output
    result = compare(folder / "a.nc", tmp_path / "run", "-o", tmp_path / "out", "--no-plots")
    assert result.exit_code == 0, result.output
    assert "simulat" not in result.stderr
    assert "time in the integrator - - - -" in lines(result)
    numbers = json.loads((tmp_path / "out" / "comparison.json").read_text())
    assert {rope["deviation"]["largest"] for rope in numbers["ropes"]} == {0.0}
    assert (tmp_path / "out" / "a.nc").read_bytes() == (folder / "a.nc").read_bytes()


def test_settings_of_either_side(tmp_path: Path) -> None:
    result = compare(
        SCENARIOS / "pulleys", "pulleys", *SHORT, "--both", "sample-interval=0.1 s",
        "--a", "step=2 ms", "--b", "step = 5 ms", "--b", "paper=true", "--b", "geometric_stiffness=false",
        "-o", tmp_path, "--no-plots",
    )  # fmt: skip
    assert result.exit_code == 0, result.output
    a, b = (gantline.open_recording(tmp_path / name).attributes["settings"] for name in ("a.nc", "b.nc"))
    assert (a["integrator"]["step"], b["integrator"]["step"]) == (0.002, 0.005)
    assert (b["integrator"]["paper"], b["integrator"]["geometric_stiffness"]) == (True, False)
    assert a["duration"] == b["duration"] == 1.0
    assert a["sample_interval"] == b["sample_interval"] == 0.1


def test_the_folder_that_is_written_by_default(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert compare("pulleys", *SHORT, "--b", "step=2 ms", "--no-plots").exit_code == 0
    assert (tmp_path / "results" / "compare-pulleys" / "comparison.json").is_file()


def test_the_same_comparison_writes_the_same_bytes(tmp_path: Path) -> None:
    for name in ("one", "other"):
        result = compare("pulleys", *SHORT, "--b", "step=2 ms", "-o", tmp_path / name)
        assert result.exit_code == 0, result.output
    for path in (tmp_path / "one").iterdir():
        if path.name != "comparison.txt":  # which tells the wall time
            assert path.read_bytes() == (tmp_path / "other" / path.name).read_bytes(), path.name


def test_slings_hooks_and_loads_stand_side_by_side(tmp_path: Path) -> None:
    result = compare("equalizer", "equalizer_yard", "--both", "duration=22 s", "-o", tmp_path, "--no-plots")
    assert result.exit_code == 0, result.output
    said = lines(result)
    starts = ("peak sling tension 702.0 kN ", "in sling S", "lift-off at 19.81 s - - -", "sling.S1 701.4 kN")
    for start in (*starts, "test_hook 3700."):
        assert any(line.startswith(start) for line in said), start
    assert any(line.partition(" ")[0] == "block" for line in said)
    assert not [line for line in said if line.startswith("Only in")]


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["pulleys"], "nothing to compare"),
        (["pulleys", "none.yaml"], "none.yaml"),
        (["pulleys", "none.nc"], "none.nc: no such file"),
        (["pulleys", "--b", "step"], "--b: 'step' is no setting; one is written like 'step=1 ms'"),
        (["pulleys", "--b", "speed=1"], "--b: there is no setting 'speed'; there are integrator, step"),
        (["pulleys", "--b", "step=1"], "--b step: '1' has no unit"),
        (["pulleys", "--b", "step=0 ms"], "--b step: '0 ms' is not a time above zero"),
        (["pulleys", "--b", "paper=yes"], "--b paper: 'yes' is neither true nor false"),
        (["pulleys", "--a", "step=1 ms", "--a", "step=2 ms"], "--a: step is given twice"),
        (["pulleys", "--b", "integrator=euler"], "--b integrator: 'euler' is none"),
    ],
)
def test_bad_input_is_one_message_and_nothing_is_written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, words: list[str], message: str
) -> None:
    monkeypatch.chdir(tmp_path)
    result = compare(*words)
    assert (result.exit_code, result.stdout) == (2, "")
    assert result.stderr.startswith("error: ")
    assert message in result.stderr
    assert "Traceback" not in result.stderr
    assert list(tmp_path.iterdir()) == []


def test_files_that_are_no_recordings(two_methods: tuple[Result, Path], tmp_path: Path) -> None:
    _, folder = two_methods
    broken = tmp_path / "broken.nc"
    broken.write_text("mine")
    result = compare(broken, folder / "b.nc", "-o", tmp_path / "out")
    assert result.exit_code == 2
    assert "broken.nc: not a recording of gantline" in result.stderr
    result = compare(folder / "a.nc", "pulleys", "--a", "step=1 ms", "-o", tmp_path / "out")
    assert result.exit_code == 2
    assert "is a recording; the settings of a run that is over cannot be changed" in result.stderr
    assert not (tmp_path / "out").exists()


def test_a_run_that_cannot_go_on_is_compared_as_far_as_it_got(core: type[FakeCore], tmp_path: Path) -> None:
    core.fails_at = 2
    result = compare("one.yaml", "other.yaml", "-o", tmp_path / "out")
    assert result.exit_code == 3
    for letter in "AB":
        assert f"error: {letter}: the simulation could not go on at t = 2.000 s at sling.S1" in result.stderr
        assert (tmp_path / "out" / f"{letter.lower()}.state.bin").read_bytes() == b"2"
    assert "A FAILED at 2.000 s at sling.S1: a pivot is zero" in lines(result)
    recording = gantline.open_recording(tmp_path / "out" / "a.nc")
    assert recording.attributes["failure"] == {"time": 2.0, "element": "sling.S1", "cause": "a pivot is zero"}
    assert (tmp_path / "out" / "compare_sling_tension.png").is_file()
    # Recordings of failed runs can be compared; that they failed was said when they were made.
    again = compare(
        tmp_path / "out" / "a.nc", tmp_path / "out" / "b.nc", "-o", tmp_path / "again", "--no-plots"
    )
    assert again.exit_code == 0
    assert "B FAILED at 2.000 s at sling.S1: a pivot is zero" in lines(again)


def test_a_run_that_fails_in_its_first_step(tmp_path: Path) -> None:
    lift = tmp_path / "lift.yaml"
    lift.write_text(DEAD_CENTRE, encoding="utf-8")
    result = compare(lift, "pulleys", "-o", tmp_path / "out")
    assert result.exit_code == 3
    said = "\n".join(lines(result))
    assert "Only in A: ropes plumb" in said
    assert "FAILED at 0.000 s at plumb" in said
    assert "Compared at 0 s alone, which both have." in said
    assert not list((tmp_path / "out").glob("*.png"))


def test_an_open_balance_is_said_in_so_many_words(core: type[FakeCore], tmp_path: Path) -> None:
    core.remainder = 2e-3
    result = compare("one.yaml", "other.yaml", "-o", tmp_path, "--no-plots")
    assert result.stdout.count("THE BALANCE DOES NOT CLOSE") == 2


def test_an_interrupt_saves_what_there_is(tmp_path: Path) -> None:
    command = [*PROGRAM, "compare", "equalizer_yard", "pulleys", "--no-plots"]
    command += ["-o", str(tmp_path), "--a", "duration=4000 s", "--a", "sample_interval=1 s"]
    with subprocess.Popen(command, stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as process:
        assert process.stderr is not None
        assert process.stderr.readline().startswith("simulating A")
        assert process.stderr.readline().startswith("simulated ")
        os.kill(process.pid, signal.SIGINT)
        _, err = process.communicate(timeout=60)
    assert process.returncode == 130
    assert "stopped before B was simulated" in err
    assert "Traceback" not in err
    assert gantline.open_recording(tmp_path / "a.nc").attributes["status"] == "stopped"


def test_a_mechanism_that_feeds_the_load_is_found_out(tmp_path: Path) -> None:
    result = compare(
        "mechanisms", "--b", "adjusting_factor=2.05", "--both", "duration=22 s", "-o", tmp_path, "--no-plots"
    )
    assert result.exit_code == 0, result.stderr
    assert "no energy from nowhere" in result.stdout
    assert "GAINS ENERGY from 18.7" in result.stdout


def test_an_explicit_step_that_is_too_long_is_compared_as_far_as_it_got(tmp_path: Path) -> None:
    changes = ("--b", "integrator=explicit", "--b", "step=10 ms", "--both", "duration=5 s")
    result = compare("equalizer", *changes, "-o", tmp_path, "--no-plots")
    assert result.exit_code == 3
    assert "explicit, step 10 ms" in result.stdout
    assert "the step of 0.01 s is too long for an explicit method" in result.stdout


def test_verdicts_and_what_parted_come_first(tmp_path: Path) -> None:
    """The sling of `equalizer_sling_cut` is cut 40 s after the start; nothing parts in `equalizer`."""
    cut = ("equalizer_sling_cut", "--both", "duration=42 s", "--no-plots")
    result = compare("equalizer", *cut, "-o", tmp_path)
    assert result.exit_code == 0, result.output
    said = lines(result)
    numbers = json.loads((tmp_path / "comparison.json").read_text())
    at = said.index("Verdict")
    assert at < said.index("Lift A B B - A of A")
    a, b = numbers["verdicts"]
    assert said[at + 1].startswith("A " + a[:40]) and b.startswith("NO-GO")
    (nothing, (parted,)) = numbers["parted"]
    assert nothing == [] and (parted["kind"], parted["time"]) == ("cut", 40.0)
    row = next(line for line in said if line.startswith(f"B {parted['rope']} "))
    assert row == f"B {parted['rope']} cut 40.000 s {parted['tension'] / 1e3:.1f} kN"
