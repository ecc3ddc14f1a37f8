"""The report in a notebook."""

from __future__ import annotations

from html import escape

from gantline.report.page import render_report
from gantline.results.file.saved import Beside
from gantline.results.recording import Recording, recorded

_HEIGHT = 760  # pixels


class Report:
    """The report of a recording, which Jupyter and marimo show as it is.

    It stands in a frame of its own, in which its program may run and from which it reaches nothing else. A
    notebook that is saved holds all of it; the line below the frame says how much that is.

    Args:
        recording: Any recording.
        beside: Equilibrium and cases of the same lift, where they are known.

    Raises:
        BundleMissing: If the player is not built in this installation.
        TypeError: If it is no recording.
        ValueError: If the recording cannot be drawn.
    """

    def __init__(self, recording: Recording, *, beside: Beside | None = None) -> None:
        self.title = recorded(recording).title
        self.html = render_report(recording, beside=beside)

    def __repr__(self) -> str:
        return f"<Report {self.title!r}: {self._size}>"

    @property
    def _size(self) -> str:
        return f"{len(self.html.encode('utf-8')) / 1e6:.1f} MB"

    def _repr_html_(self) -> str:
        # Without allow-same-origin the page has no part in the notebook's origin.
        return (
            f'<iframe sandbox="allow-scripts" title="{escape(f"Report: {self.title}")}" width="100%" '
            f'height="{_HEIGHT}" style="border:1px solid #bbb" srcdoc="{escape(self.html)}"></iframe>'
            f"<div><small>{self._size} in this notebook; write_report makes a file of it</small></div>"
        )
