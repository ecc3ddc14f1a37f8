"""Righting arms of a vessel that loses a load at once, with the areas that are compared."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine

from gantline.plot.style import ALARM, INK, QUIET, RC, colour, legend_above
from gantline.results.variable import FloatArray

__all__ = ["SwingCurve", "lost_load_picture"]

#: The curve goes on beyond what happens by this share of it.
_BEYOND = 0.35
#: And the picture begins so much before it.
_AHEAD = 0.07
#: Of each part of it.
_POINTS = 200


@dataclass(frozen=True)
class SwingCurve:
    """What is drawn; angles positive the way the vessel swings.

    Attributes:
        title: Of the picture.
        angles: Of the curve, ascending [rad].
        arms: Righting arms there [m].
        before: Angle with the load [rad].
        after: Angle at rest without it [rad].
        farthest: Of the first swing [rad]; None where nothing stops it.
        end: Up to which the vessel can take work [rad].
        under: Angles at which marks go under, by name [rad].
    """

    title: str
    angles: FloatArray
    arms: FloatArray
    before: float
    after: float
    farthest: float | None
    end: float
    under: Mapping[str, float]


def lost_load_picture(curve: SwingCurve) -> Figure:
    """The picture: arms over the angle, A1 and A2 below them, where the swing ends and what goes under."""
    with mpl.rc_context(RC):
        figure = Figure(figsize=(7.2, 3.6))
        figure.set_layout_engine(ConstrainedLayoutEngine(h_pad=0.06, w_pad=0.06))
        panel = figure.add_subplot()
        farthest = curve.end if curve.farthest is None else curve.farthest
        end = max([farthest, *curve.under.values()])
        reach = end - curve.before
        last = min(float(curve.angles[-1]), end + _BEYOND * reach)
        _arms(panel, curve, last)
        _places(panel, curve)
        panel.set_xlim(float(np.degrees(curve.before - _AHEAD * reach)), float(np.degrees(last)))
        panel.set_xlabel("Angle from upright [deg]")
        panel.set_ylabel("Righting arm [m]")
        figure.suptitle(curve.title, x=0.01, ha="left", fontsize=11, fontweight="bold")
    return figure


def _arms(panel: Axes, curve: SwingCurve, last: float) -> None:
    def part(first: float, end: float) -> tuple[FloatArray, FloatArray]:
        angles = np.linspace(first, end, _POINTS)
        return np.degrees(angles), np.interp(angles, curve.angles, curve.arms)

    panel.plot(*part(curve.before, last), color=colour(0))
    panel.axhline(0.0, color=QUIET, linewidth=0.8)
    left, taken = part(curve.before, curve.after), part(curve.after, min(curve.end, last))
    panel.fill_between(*left, color=colour(1), alpha=0.35, linewidth=0, label="A1, left by the load")
    panel.fill_between(*taken, color=colour(2), alpha=0.25, linewidth=0, label="A2, can be taken")
    legend_above(panel, *panel.get_legend_handles_labels(), columns=2)


def _places(panel: Axes, curve: SwingCurve) -> None:
    """Upright lines, named at their lower ends."""
    places = [("with the load", curve.before, INK), ("at rest", curve.after, INK)]
    if curve.farthest is not None:
        places.append(("first swing", curve.farthest, colour(1)))
    places += [(f"{name.replace('_', ' ')} under", angle, ALARM) for name, angle in curve.under.items()]
    for number, (name, angle, ink) in enumerate(places):
        side = 1 if number else -1  # the first is named where there is no curve
        where = float(np.degrees(angle))
        panel.axvline(where, color=ink, linewidth=0.9, linestyle=(0, (4, 2)))
        panel.annotate(
            name,
            (where, 0.02),
            xycoords=("data", "axes fraction"),
            xytext=(3 * side, 0),
            textcoords="offset points",
            rotation=90,
            ha="left" if side > 0 else "right",
            va="bottom",
            fontsize=7.5,
            color=ink,
        )
