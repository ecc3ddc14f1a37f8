"""Values of a lift file replaced in its text."""

from __future__ import annotations

import pytest

from gantline.scenario.file.edit import text_with

TEXT = """\
# A remark with content: 1 t
vessels:
  barge:
    tanks: {row.1: {content: 5 t}, "2": {content: '6 t'}}   # two
    masses: [1 t, {at: 2 m}, 3 t]
"""


def test_all_else_stays() -> None:
    found = text_with(
        TEXT,
        {
            ("vessels", "barge", "tanks", "row.1", "content"): "12.5 t",
            ("vessels", "barge", "tanks", "2", "content"): "0 t",
            ("vessels", "barge", "masses", 1, "at"): "20 m",
            ("vessels", "barge", "masses", 2): "4 t",
        },
    )
    wanted = (
        TEXT.replace("5 t", "12.5 t").replace("'6 t'", "0 t").replace("2 m", "20 m").replace("3 t", "4 t")
    )
    assert found == wanted


def test_what_is_not_there() -> None:
    with pytest.raises(KeyError, match=r"vessels\.barge\.tanks"):
        text_with(TEXT, {("vessels", "barge", "tanks"): "1 t"})
