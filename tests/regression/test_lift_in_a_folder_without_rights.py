"""`gantline check` of a lift file in a folder that may not be read ended in a traceback of two pages."""

from __future__ import annotations

from pathlib import Path

import pytest

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
