"""A file or folder whose name is too long ended in a traceback.

`gantline cad` and `gantline hydro` with a name of 300 letters, as when a shell did not expand a list, looked
for files of a like name beside it; whether there is one of that name at all was asked outside of what catches
errors of the system. So was whether there is the folder of `gantline new`. A name with a zero byte ended in
`embedded null byte`.
"""

from __future__ import annotations

import pytest
from typer.testing import CliRunner

from gantline import cad, hydro
from gantline.cli.app import app

#: Names of most file systems have up to 255 bytes, NAME_MAX of POSIX's limits.h on Linux.
LONG = 300 * "a" + ".stl"


@pytest.mark.parametrize("verb", ["cad", "hydro", "new"])
def test_a_name_that_is_too_long_is_bad_input(verb: str) -> None:
    """One sentence, and 2."""
    result = CliRunner().invoke(app, [verb, LONG])
    assert result.exit_code == 2, result.exception
    assert "name too long" in " ".join(result.output.split()).lower()


def test_errors_are_those_of_readers() -> None:
    """Of CAD and of hulls."""
    with pytest.raises(cad.CadError, match=r"cannot be read \(file name too long\)"):
        cad.read(LONG)
    with pytest.raises(hydro.HullError, match=r"cannot be read \(file name too long\)"):
        hydro.read_hull(LONG)
    with pytest.raises(cad.CadError, match="not a usable file name"):
        cad.read("a\0b.stl")
