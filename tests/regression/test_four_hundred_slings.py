"""Four hundred slings in pictures and tables.

Names of 400 moving sheaves beside the picture of their travel took all of its room: matplotlib printed
"constrained_layout not applied because axes sizes collapsed to zero", and most names stood outside of the
picture. The table of `gantline run` listed 400 slings twice, 887 lines.
"""

from __future__ import annotations

import warnings

import numpy as np
import pytest
from matplotlib.figure import Figure

from gantline.cli.table import cut, table
from gantline.plot.style import MOST_NAMED, label_ends


def names_beside(count: int) -> list[str]:
    """What stands beside a panel with so many curves, drawn without a warning."""
    figure = Figure(figsize=(7.4, 4.2), layout="constrained")
    panel = figure.add_subplot()
    time = np.linspace(0.0, 1.0, 5)
    values = {f"e1.{place}": np.full(5, 0.01 * place) for place in range(count)}
    for curve in values.values():
        panel.plot(time, curve)
    label_ends(panel, time, values)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        figure.canvas.draw()
    return [text.get_text() for text in panel.texts]


def test_of_many_curves_some_are_named_and_the_others_counted() -> None:
    named = names_beside(400)
    assert named[0] == f"… and {400 - (len(named) - 1)} more"
    assert 5 < len(named) <= MOST_NAMED
    assert {"e1.0", "e1.399"} < set(named)


@pytest.mark.parametrize("count", [1, 5, 10])
def test_of_few_all_are_named(count: int) -> None:
    assert names_beside(count) == [f"e1.{place}" for place in range(count)]


def test_long_tables_leave_out_their_middle() -> None:
    lines = table(("Sling", "peak"), [(f"S{place}", "1 kN") for place in range(1, 401)], "lr")
    shown = cut(lines, 40)
    assert shown == [*lines[:21], "  ... and 360 more", *lines[-20:]]
    assert cut(lines, 400) == lines
