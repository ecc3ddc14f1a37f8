"""`gantline view` of a lift in a folder that may not be read ended in a traceback of two pages.

And of a recording that may not be read HDF5 had the word: "cannot be read (unable to synchronously open file
(unable to open file: name = 'run/recording.nc', errno = 13, …))".
"""

from __future__ import annotations

from pathlib import Path

import pytest

from gantline.results.recording import open_recording
from verbs import gantline


def test_it_is_told_in_words_of_the_system(monkeypatch: pytest.MonkeyPatch) -> None:
    """Rights bind no administrator, as who runs tests may be: the system is asked in their place."""
    ask = Path.stat

    def refused(self: Path, **how: bool) -> object:
        if self.parent.name == "closed":
            raise PermissionError(13, "Permission denied", str(self))
        return ask(self, **how)

    monkeypatch.setattr(Path, "stat", refused)
    for lift in ("closed/in", "closed/lift.yaml"):
        result = gantline("view", lift, "--no-browser")
        assert result.exit_code == 2
        assert result.stderr.startswith(f"error: {lift}: cannot be read (permission denied)")


def test_so_is_a_recording(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = tmp_path / "a.nc"
    file.touch()

    def refused(*_: object, **__: object) -> None:
        raise PermissionError(13, f"Unable to synchronously open file (name = '{file}', errno = 13)")

    monkeypatch.setattr("gantline.results.file.netcdf.h5py.File", refused)
    with pytest.raises(ValueError) as told:
        open_recording(file)
    assert str(told.value) == f"{file}: cannot be read (permission denied)"
