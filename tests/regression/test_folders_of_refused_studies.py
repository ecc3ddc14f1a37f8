"""`gantline cases` and `gantline seas` left an empty folder where they refused the lift.

Both made the folder of `-o` before they had read the lift file; `run`, `compare` and `statics` leave none.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from typer.testing import CliRunner

from gantline.cli.app import app


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["cases", "equalizer"], "there are no 'cases' in this file"),
        (["cases", "no_such_lift"], "error: no_such_lift: "),
        (["seas", "equalizer"], "wave"),
        (["seas", "no_such_lift"], "error: no_such_lift: "),
    ],
    ids=" ".join,
)
def test_a_refused_study_leaves_no_folder(tmp_path: Path, words: list[str], said: str) -> None:
    """Neither a lift that is not there nor one without cases or waves."""
    result = CliRunner().invoke(app, [*words, "-o", str(tmp_path / "out")])
    assert result.exit_code == 2
    assert said in result.stderr
    assert not (tmp_path / "out").exists()
