"""Cases that were simulated against all limits: a row for each limit, a column for each case."""

from __future__ import annotations

import matplotlib as mpl
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine

from gantline.plot.cells import CELL, Look, columns_and_rows, draw_cell, legend
from gantline.plot.style import INK, RC, shortened
from gantline.results.file.saved_case_runs import SavedCaseRuns, SavedCheck

__all__ = ["case_runs_picture"]

#: Of what stands around the field: names of limits, and of cases above it [inch].
_AROUND = (3.4, 1.7)
_NARROWEST = 6.4
_LONGEST_NAME = 24


def case_runs_picture(found: SavedCaseRuns) -> Figure:
    """The picture: what the worst run of each case uses of each limit, the limit that is nearest on top."""
    limits = [check.name for check, _ in found.nearest][::-1]
    size = (
        max(_NARROWEST, _AROUND[0] + CELL[0] * len(found.names)),
        _AROUND[1] + CELL[1] * max(1, len(limits)),
    )
    with mpl.rc_context(RC):
        figure = Figure(figsize=size)
        figure.set_layout_engine(ConstrainedLayoutEngine(h_pad=0.06, w_pad=0.08))
        field = figure.subplots()
        kinds = _fill(field, found, limits)
        title = f"Cases, simulated: {shortened(found.title, 50)}"
        figure.suptitle(title, x=0.01, ha="left", fontsize=11, fontweight="bold")
        said = {
            "kept": "share of the limit that is used",
            "warns": "past one that only warns",
            "failed": "not kept",
            "missing": "not checked",
        }
        legend(figure, {kind: text for kind, text in said.items() if kind in kinds})
    return figure


def _fill(field: Axes, found: SavedCaseRuns, limits: list[str]) -> set[str]:
    """Draw all cells; gives the kinds that there are."""
    kinds = set()
    for column, case in enumerate(found.names):
        for row, limit in enumerate(limits):
            look = _look(found.worst(case, limit))
            kinds.add(look.kind)
            draw_cell(field, column, row, look)
    cases = [_head(found, case) for case in found.names]
    columns_and_rows(field, cases, [limit.replace("_", " ") for limit in limits])
    field.xaxis.tick_top()
    for label, case in zip(field.get_xticklabels(), found.names, strict=True):
        label.set(rotation=35, ha="left", rotation_mode="anchor", color=INK)
        if any(run.outcome == "NO-GO" for run in found.of(case)):
            label.set_fontweight("bold")
    return kinds


def _head(found: SavedCaseRuns, case: str) -> str:
    """Name of a case, how many runs it has, and that one of them did not come to its end."""
    runs, told = found.of(case), found.outcome(case)
    name = shortened(case or "as given", _LONGEST_NAME)
    count = f" ({len(runs)})" if len(runs) > 1 else ""
    return f"{name}{count}{f', {told}' if told not in ('go', 'warns', 'no go') else ''}"


def _look(check: SavedCheck | None) -> Look:
    """What a cell says."""
    if check is None:
        return Look("missing", "–")
    if check.has_failed:
        return Look("failed", check.share)
    return Look("warns" if check.only_warns else "kept", check.share, check.size)
