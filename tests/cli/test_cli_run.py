"""`gantline run`: what it prints and writes, and how it ends."""

import os
import re
import signal
import subprocess
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

import gantline
from fake_core import FakeCore, core
from gantline.cli.app import app
from program import PROGRAM

__all__ = ["core"]

SCENARIOS = Path(__file__).parents[2] / "scenarios"


def run(*words: str | Path) -> Result:
    return CliRunner().invoke(app, ["run", *(str(word) for word in words)])


@pytest.fixture(scope="module")
def reference(tmp_path_factory: pytest.TempPathFactory) -> tuple[Result, Path]:
    folder = tmp_path_factory.mktemp("reference") / "out"
    return run(SCENARIOS / "equalizer", "-o", folder), folder


def test_a_lift_ends_with_its_table_recording_and_pictures(reference: tuple[Result, Path]) -> None:
    result, folder = reference
    assert result.exit_code == 0, result.output
    for words in (
        "EQ-300 rev 0  One equalizer lifts a 300 t load",
        "calculated 300.0 t x contingency 1.00 = design 300.0 t",
        "lift-off",
        "Sling    static      peak       at  least clear",
        "equalizing rope",
        "tension spread",
        "travel used up",
        "hook load",
        "hoist load",
        "warning      load_tilt",
        "warning      equalizer_travel_used",
        "Energy remainder",
        "the balance closes",
        "times real time",
        str(folder / "recording.nc"),
        str(folder / "system.png"),
    ):
        assert words in result.stdout
    assert "simulated 40.0 of 40.0 s" in result.stderr
    names = {path.name for path in folder.iterdir()}
    pictures = ("sling_tension", "sheave_travel", "attitude", "hook_load", "energy", "system", "equalizer_e1")
    assert {"recording.nc", *(f"{name}.png" for name in pictures)} <= names
    assert not [name for name in names if name.startswith(".")]


def test_the_table_shows_the_metrics_of_the_recording(reference: tuple[Result, Path]) -> None:
    result, folder = reference
    metrics = gantline.open_recording(folder / "recording.nc").metrics()
    assert f"{metrics['peak_sling_tension'] / 1e3:.1f} kN" in result.stdout
    assert f"at {metrics['lift_off_time']:.2f} s" in result.stdout
    assert f"{metrics['static_hook_load'] / 1e3:.1f} kN" in result.stdout
    assert f"{metrics['travel_used_down']:.1%}".replace("%", " %") in result.stdout


def test_settings_of_the_command_line_take_the_place_of_those_of_the_file(tmp_path: Path) -> None:
    result = run(
        SCENARIOS / "pulleys", "-o", tmp_path, "--no-plots", "--no-report", "--step", "2 ms",
        "--duration", "1s", "--sample-interval", "0.1 s", "--profile",
    )  # fmt: skip
    assert result.exit_code == 0, result.output
    assert [path.name for path in tmp_path.iterdir()] == ["recording.nc"]
    recording = gantline.open_recording(tmp_path / "recording.nc")
    assert recording.time == pytest.approx([0.1 * k for k in range(11)])
    assert recording.attributes["settings"]["integrator"]["step"] == 0.002
    assert recording.attributes["counters"]["steps"] == 500
    profile = result.stdout.partition("Where the time went")[2]
    times = {name: float(ms) for name, ms in re.findall(r"^ *(\w+) +([\d.]+) ms", profile, re.MULTILINE)}
    stages = ("kinematics", "assembly", "factorisation", "solution", "events", "other")
    assert 0.0 < times["Integrator"] < times["simulate"]
    # Seven numbers, printed to 0.01 ms: each is off by half of that.
    assert sum(times[name] for name in stages) == pytest.approx(times["Integrator"], abs=0.036)
    assert times["Recording"] > 0.0
    assert re.search(r"^ *steps +500$", profile, re.MULTILINE)


def test_two_runs_write_the_same_bytes(tmp_path: Path) -> None:
    for name in ("a", "b"):
        assert run(SCENARIOS / "pulleys", "-o", tmp_path / name, "--duration", "1 s").exit_code == 0
    for path in (tmp_path / "a").iterdir():
        assert path.read_bytes() == (tmp_path / "b" / path.name).read_bytes(), path.name


def test_a_failed_check_ends_with_one(tmp_path: Path) -> None:
    text = (SCENARIOS / "equalizer" / "scenario.yaml").read_text()
    assert "hook_dynamic_factor: 1.30" in text
    lift = tmp_path / "lift.yaml"
    lift.write_text(text.replace("hook_dynamic_factor: 1.30", "hook_dynamic_factor: 1.01"))
    result = run(lift, "-o", tmp_path / "out", "--no-plots")
    assert result.exit_code == 1
    assert "FAILED       hook_dynamic_factor" in result.stdout
    assert (tmp_path / "out" / "recording.nc").is_file()


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["none.yaml"], "none.yaml"),
        ([str(SCENARIOS / "pulleys"), "--step", "1"], "--step: '1' has no unit"),
        ([str(SCENARIOS / "pulleys"), "--step", "-1 ms"], "--step: '-1 ms' is not a time above zero"),
        ([str(SCENARIOS / "pulleys"), "--duration", "3 kg"], "--duration: '3 kg' is a mass"),
        ([str(SCENARIOS / "pulleys"), "--integrator", "euler"], "--integrator: 'euler' is none"),
    ],
)
def test_bad_input_is_one_message_and_nothing_is_written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, words: list[str], message: str
) -> None:
    monkeypatch.chdir(tmp_path)
    result = run(*words)
    assert result.exit_code == 2
    assert result.stdout == ""
    assert message in result.stderr
    assert result.stderr.startswith("error: ")
    assert "Traceback" not in result.stderr
    assert list(tmp_path.iterdir()) == []


def test_a_file_where_the_folder_should_be(tmp_path: Path) -> None:
    file = tmp_path / "out"
    file.write_text("mine")
    result = run(SCENARIOS / "pulleys", "-o", file)
    assert (result.exit_code, result.stdout) == (2, "")
    assert "is a file; --output needs a folder" in result.stderr
    result = run(SCENARIOS / "pulleys", "-o", file / "deeper")
    assert (result.exit_code, result.stdout) == (2, "")
    assert "cannot be written (not a directory)" in result.stderr
    assert file.read_text() == "mine"


def test_a_simulation_that_cannot_go_on(core: type[FakeCore], tmp_path: Path) -> None:
    core.fails_at = 2
    result = run("lift.yaml", "-o", tmp_path / "out", "--no-plots", "--no-report")
    assert result.exit_code == 3
    assert "could not go on at t = 2.000 s at sling.S1: a pivot is zero" in result.stderr
    assert (tmp_path / "out" / "state.bin").read_bytes() == b"2"
    assert str(tmp_path / "out" / "state.bin") in result.stderr
    recording = gantline.open_recording(tmp_path / "out" / "recording.nc")
    assert (recording.time[-1], recording.attributes["status"]) == (2.0, "failed")


def test_progress_names_the_step_under_way_and_what_the_slings_carry(
    core: type[FakeCore], tmp_path: Path
) -> None:
    lines = run("lift.yaml", "-o", tmp_path, "--no-plots", "--no-report").stderr.splitlines()
    ends = [line.partition(" s left, ")[2] for line in lines]
    assert ends == [
        "step 'hoist', most in sling S1: 1.00 kN",
        "step 'hoist', most in sling S1: 2.00 kN",
        "most in sling S1: 3.00 kN",
        "most in sling S1: 4.00 kN",
    ]


def test_an_open_balance_is_said_in_so_many_words(core: type[FakeCore], tmp_path: Path) -> None:
    core.remainder = 2e-3
    result = run("lift.yaml", "-o", tmp_path, "--no-plots")
    assert "THE BALANCE DOES NOT CLOSE" in result.stdout
    assert "Warning: the energy balance does not close" in result.stdout


def test_an_interrupt_after_the_last_step_waits_until_the_run_is_saved(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    saved = gantline.Recording.save

    def interrupted(self: gantline.Recording, path: Path) -> Path:
        os.kill(os.getpid(), signal.SIGINT)
        return saved(self, path)

    monkeypatch.setattr(gantline.Recording, "save", interrupted)
    result = CliRunner().invoke(app, ["run", "pulleys", "-o", str(tmp_path), "--no-plots", "--no-report"])
    assert result.exit_code == 130
    assert "interrupted after the last step; the recording is" in result.stderr
    assert gantline.open_recording(tmp_path / "recording.nc").attributes["status"] == "done"


def test_an_interrupt_saves_what_there_is(tmp_path: Path) -> None:
    command = [*PROGRAM, "run", str(SCENARIOS / "equalizer_yard"), "--no-plots"]
    command += ["-o", str(tmp_path), "--duration", "4000 s", "--sample-interval", "1 s"]
    with subprocess.Popen(command, stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as process:
        assert process.stderr is not None
        assert process.stdout is not None
        assert process.stderr.readline().startswith("simulated ")
        os.kill(process.pid, signal.SIGINT)
        out, err = process.communicate(timeout=60)
    assert process.returncode == 130
    assert "stopped at" in err
    assert "Traceback" not in err
    assert str(tmp_path / "recording.nc") in out
    recording = gantline.open_recording(tmp_path / "recording.nc")
    assert recording.attributes["status"] == "stopped"
    assert 0.0 < recording.time[-1] < 4000.0
