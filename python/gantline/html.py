"""Small tables of HTML, for notebooks: static, nothing in them can act."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

#: In place of a style sheet, which notebooks share with everything else on their page.
_CELL = "text-align:left;padding:2px 10px 2px 0;vertical-align:top"


def facts_table(title: str, rows: Sequence[tuple[str, str]]) -> str:
    """A title and pairs of name and text below it, all escaped."""
    body = "".join(
        f'<tr><th style="{_CELL};font-weight:normal;opacity:0.7">{escape(name)}</th>'
        f'<td style="{_CELL}">{escape(text)}</td></tr>'
        for name, text in rows
    )
    return f"<div><strong>{escape(title)}</strong><table><tbody>{body}</tbody></table></div>"
