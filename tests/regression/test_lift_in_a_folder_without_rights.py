"""`gantline check` of a lift file in a folder that may not be read ended in a traceback of two pages.

A recording there was "not a recording of gantline ([Errno 13] Permission denied: 'closed/a.nc')".
"""

from __future__ import annotations

from pathlib import Path

import pytest

from gantline.results.recording import open_recording
from verbs import gantline


@pytest.mark.parametrize("verb", ["check", "run", "compare"])
def test_it_is_told_in_words_of_the_system(verb: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Rights bind no administrator, as who runs tests may be: the system is asked in their place."""
    ask = Path.stat

    def refused(self: Path, **how: bool) -> object:
        if self.parent.name == "closed":
            raise PermissionError(13, "Permission denied", str(self))
        return ask(self, **how)

    monkeypatch.setattr(Path, "stat", refused)
    other = ["equalizer"] if verb == "compare" else []
    result = gantline(verb, "closed/lift.yaml", *other)
    assert result.exit_code == 2
    assert "closed/lift.yaml: cannot be read (" in result.stderr


def test_so_is_a_recording(monkeypatch: pytest.MonkeyPatch) -> None:
    def refused(self: Path) -> bool:
        raise PermissionError(13, "Permission denied", str(self))

    monkeypatch.setattr(Path, "is_file", refused)
    with pytest.raises(ValueError, match=r"^closed/a\.nc: cannot be read \(permission denied\)$"):
        open_recording(Path("closed/a.nc"))
