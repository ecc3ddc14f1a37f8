"""Printed pages of the documentation lost what is wider than the paper, and had a link over their text.

On a screen code and tables scroll; on paper they were cut off. Of the table of all checks the columns with
assumptions and sources were missing, of lift files the ends of lines, such as the capacity of a fender. The
theme's link "Skip to content", which waits outside of the screen, stood at the foot of each sheet over what
is written there.
"""

from __future__ import annotations

import importlib.util
import re
from pathlib import Path

import pytest

PAGES = Path(__file__).resolve().parents[2] / "docs" / "static" / "pages.css"


def on_paper() -> dict[str, str]:
    """What the style of pages says for paper, by selector."""
    found = re.search(
        r"^@media print \{\n(.*?)^\}", PAGES.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL
    )
    assert found is not None
    return dict(re.findall(r"^  ([^{]+) \{ (.*) \}$", found[1], re.MULTILINE))


def test_nothing_is_cut_off() -> None:
    rules = on_paper()
    assert "white-space: pre-wrap" in rules["article pre"]
    assert "overflow: visible" in rules["article .table-wrapper"]
    assert "overflow-wrap: anywhere" in rules["article td code.literal"]


def test_no_link_stands_over_the_text() -> None:
    """The class is the theme's own; where that calls it something else, the rule says nothing."""
    assert on_paper()[".skip-to-content"] == "display: none;"
    theme = importlib.util.find_spec("furo")
    if theme is None or theme.origin is None:
        pytest.skip("the theme of the documentation is not installed")
    page = Path(theme.origin).parent / "theme" / "furo" / "page.html"
    assert 'class="skip-to-content' in page.read_text(encoding="utf-8")
