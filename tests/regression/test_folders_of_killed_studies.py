"""`kill` left an empty folder where `gantline seas -o` or `gantline cases -o` worked, or `run` and `compare`.

An empty folder passes for one whose results are still to come, or were lost. And of seas that could not be
written the picture stayed beside numbers of another study: it was written before them, and each by itself.
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from column_in_waves import SEA, column
from gantline.cli.lift import new_folder
from gantline.plot import seas as drawn
from verbs import gantline

_USE = """
import os, signal, sys
from pathlib import Path
from gantline.cli.lift import new_folder
from gantline.replacing import replaced
signal.signal(signal.SIGTERM, signal.SIG_DFL)
with new_folder(Path(sys.argv[1])) as folder:
    with replaced(folder / "seas.json") as trial:
        trial.write_text("half")
        print(sorted(path.name for path in folder.iterdir()), flush=True)
        os.kill(os.getpid(), signal.SIGTERM)
"""


@pytest.mark.parametrize("there", ["", "above", "above/out"])
def test_what_is_new_of_a_folder_goes_with_the_program(there: str, tmp_path: Path) -> None:
    """What was there stays, and half a file within goes first."""
    (tmp_path / there).mkdir(parents=True, exist_ok=True)
    before = sorted(tmp_path.rglob("*"))
    done = subprocess.run(
        [sys.executable, "-c", _USE, str(tmp_path / "above" / "out")], capture_output=True, text=True
    )
    assert done.returncode == -signal.SIGTERM and done.stderr == ""
    assert ".part" in done.stdout
    assert sorted(tmp_path.rglob("*")) == before


@pytest.mark.parametrize("verb", ["seas", "cases", "run", "compare"])
def test_verbs_that_make_one_are_ended_without_it(
    verb: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Told to end as soon as it is there, by a way of our own in place of the end of all tests."""
    lift = tmp_path / "lift.yaml"
    text = column(SEA, duration="2 s") + "cases: {heavy: {set: {load.weight.calculated: 5 t}}}\n"
    lift.write_text(text, encoding="utf-8")
    folder = tmp_path / "above" / "out"
    seen = []

    def killed(*_: object, **__: object) -> None:
        seen.append(folder.is_dir())
        signal.raise_signal(signal.SIGTERM)

    for name in ("seas._run", "cases.telling", "run._simulate", "compare._simulate"):
        monkeypatch.setattr(f"gantline.cli.{name}", killed)
    # The last thing before the end is to take the signal as if nobody had, and to send it once more.
    monkeypatch.setattr(os, "kill", lambda *_: sys.exit(99))
    words = [verb, str(lift), *([str(lift)] if verb == "compare" else []), "-o", str(folder)]
    before = signal.getsignal(signal.SIGTERM)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    try:
        result = gantline(*words)
    finally:
        signal.signal(signal.SIGTERM, before)
    assert (seen, result.exit_code) == ([True], 99)
    assert not (tmp_path / "above").exists()


def test_a_forked_process_tidies_nothing(tmp_path: Path) -> None:
    """Workers are ended by the same signal while the study goes on."""
    with new_folder(tmp_path / "out") as folder:
        worker = os.fork()
        if not worker:
            signal.raise_signal(signal.SIGTERM)
            os._exit(1)
        os.waitpid(worker, 0)
        assert folder.is_dir()


def test_what_cannot_be_tidied_is_no_matter() -> None:
    ends = """
import signal
from gantline.interrupt import tidied
signal.signal(signal.SIGTERM, signal.SIG_DFL)
def refused(): raise PermissionError
with tidied(lambda: print("first", flush=True)), tidied(refused):
    signal.raise_signal(signal.SIGTERM)
"""
    done = subprocess.run([sys.executable, "-c", ends], capture_output=True, text=True)
    assert (done.returncode, done.stdout, done.stderr) == (-signal.SIGTERM, "first\n", "")


def test_picture_and_numbers_of_seas_are_of_one_study(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Both or none: where the picture cannot be written, the numbers of before stay beside it."""
    lift, folder = tmp_path / "lift.yaml", tmp_path / "out"
    lift.write_text(column(SEA, duration="2 s"), encoding="utf-8")
    folder.mkdir()
    for name in ("seas.json", "seas.png"):
        (folder / name).write_text("of before", encoding="utf-8")

    class Full:
        def savefig(self, *_: object, **__: object) -> None:
            raise OSError(28, "No space left on device")

    monkeypatch.setattr(drawn, "seas_picture", lambda _: Full())
    result = gantline("seas", str(lift), "-o", str(folder))
    assert result.exit_code == 2
    assert result.stderr.endswith(f"error: {folder}: cannot be written (no space left on device)\n")
    # The runs that were made are kept all the same: `--continue` needs not make them again.
    assert (folder / "seas_runs.jsonl").exists()
    assert all(
        (folder / name).read_text(encoding="utf-8") == "of before" for name in ("seas.json", "seas.png")
    )
