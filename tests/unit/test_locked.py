"""A file that one program has for itself, and that is free again however it ends."""

from __future__ import annotations

import errno
import fcntl
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from gantline.locked import InUseError, locked

#: Has the file until it is killed, with something in it or without.
HOLDER = """\
import sys
from pathlib import Path
from gantline.locked import locked

with locked(Path(sys.argv[1])) as file:
    file.write(sys.argv[2].encode())
    file.flush()
    print("mine", flush=True)
    sys.stdin.read()
"""


def holder(path: Path, text: str) -> subprocess.Popen[str]:
    words = [sys.executable, "-c", HOLDER, str(path), text]
    process = subprocess.Popen(words, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    assert process.stdout is not None and process.stdout.readline() == "mine\n"
    return process


@pytest.mark.parametrize("text", ["", "a line\n"])
def test_a_killed_program_leaves_no_lock(tmp_path: Path, text: str) -> None:
    """While it goes on nobody else has the file; after `kill -9` the next one has, with all that is in it."""
    path = tmp_path / "runs"
    process = holder(path, text)
    with pytest.raises(InUseError), locked(path):
        pass
    assert path.read_text() == text
    process.kill()
    process.communicate()
    with locked(path) as file:
        assert file.read().decode() == text


def test_a_program_told_to_end_leaves_no_empty_file(tmp_path: Path) -> None:
    path = tmp_path / "runs"
    process = holder(path, "")
    process.send_signal(signal.SIGTERM)
    process.communicate()
    assert process.returncode == -signal.SIGTERM
    assert not path.exists()


def test_what_is_empty_is_gone_and_what_is_not_stays(tmp_path: Path) -> None:
    path = tmp_path / "runs"
    with locked(path):
        assert path.exists()
    assert not path.exists()
    with locked(path) as file:
        file.write(b"a line\n")
    with locked(path) as file:
        assert file.read() == b"a line\n"


def test_a_file_removed_meanwhile_is_not_the_one(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The one who had it has removed it, empty, between its opening and its locking by the next."""
    path = tmp_path / "runs"
    lock, others = fcntl.flock, [lambda: path.unlink()]

    def late(file: int, how: int) -> None:
        while others:
            others.pop()()
        lock(file, how)

    monkeypatch.setattr(fcntl, "flock", late)
    with locked(path) as file:
        file.write(b"a line\n")
    assert path.read_bytes() == b"a line\n"


def test_where_there_are_no_locks_it_goes_without(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """As on some file systems of a network."""

    def unknown(_file: int, _how: int) -> None:
        raise OSError(errno.EOPNOTSUPP, "no locks here")

    monkeypatch.setattr(fcntl, "flock", unknown)
    path = tmp_path / "runs"
    with locked(path) as file:
        file.write(b"a line\n")
    assert path.read_bytes() == b"a line\n"
