"""Pictures of two recordings over each other: A wide and pale, B thin upon it, their difference below."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import TypeVar

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from gantline.plot.style import (
    INK,
    PALE,
    QUIET,
    RC,
    colour,
    few_ticks,
    figure_over_time,
    fitting_columns,
    force_axis,
    force_unit,
    legend_above,
    shortened,
    widen,
)
from gantline.results import series
from gantline.results.alike import without_rounding
from gantline.results.common_time import CommonTime
from gantline.results.comparison import Comparison, ForceComparison, MotionComparison
from gantline.results.loads.drift import load_drift
from gantline.results.recording import Recording
from gantline.results.ropes.families import shortened_inside
from gantline.results.rotation import tilt
from gantline.results.variable import FloatArray

_T = TypeVar("_T")

_MOST_CURVES = 8  # as many as there are colours
_WIDE, _THIN = 3.0, 1.1
# Size [SI] and name of units of differences.
_MILLIMETRES = (1e-3, "mm")
_DEGREES = (float(np.radians(1.0)), "deg")
_PALE = 0.5  # share of white in a curve of A


def comparison_names(loads: Iterable[str]) -> list[str]:
    """Names of all pictures that a comparison of lifts with these loads may have."""
    kinds = ["sling_tension", "rope_tension", "hook_load", "hinge_force", "motion", "load_motion"]
    return [f"compare_{kind}" for kind in (*kinds, *(f"load_motion_{name}" for name in loads))]


def comparison_figures(comparison: Comparison) -> Iterator[tuple[str, Figure]]:
    """Make the pictures that a comparison can have, one at a time.

    Args:
        comparison: Of any two recordings; without at least two common times there are no pictures.

    Yields:
        Name of a picture (a file name without suffix) and its figure.
    """
    if comparison.common is None or len(comparison.common.times) < 2:
        return
    slings = {sling.rope: sling.name for sling in comparison.a.rig.slings}
    gear = {*slings, *(equalizer.equalizing_rope for equalizer in comparison.a.rig.equalizers)}
    under_slings = [rope for rope in comparison.ropes if rope.name in slings]
    others = [rope for rope in comparison.ropes if rope.name not in gear]
    makers: dict[str, Callable[[], Figure | None]] = {
        "compare_sling_tension": partial(_forces, comparison, under_slings, _SLINGS, slings),
        "compare_rope_tension": partial(_forces, comparison, others, _ROPES, {}),
        "compare_hook_load": partial(_forces, comparison, comparison.hooks, _HOOKS, {}),
        "compare_hinge_force": partial(_forces, comparison, comparison.hinges, _HINGES, {}),
    }
    for load in comparison.loads:
        suffix = f"_{load.name}" if len(comparison.loads) > 1 else ""
        makers[f"compare_load_motion{suffix}"] = partial(_load_motion, comparison, load)
    if not comparison.loads:
        makers["compare_motion"] = partial(_body_motion, comparison)
    for name, make in makers.items():
        with matplotlib.rc_context(RC):
            figure = make()
        if figure is not None:
            yield name, figure


@dataclass(frozen=True)
class _Kind:
    """Forces of one kind: their variable, and their name on the axis, in the title, and of many."""

    variable: str
    label: str
    title: str
    many: str


_SLINGS = _Kind("rope_tension", "Tension", "Sling tension", "slings")
_ROPES = _Kind("rope_tension", "Tension", "Rope tension", "ropes")
_HOOKS = _Kind("hook_load", "Hook load", "Hook load", "hooks")
_HINGES = _Kind("hinge_force", "Force", "Force between load and hinge", "hinges")


def _forces(
    comparison: Comparison, forces: Sequence[ForceComparison], kind: _Kind, names: Mapping[str, str]
) -> Figure | None:
    """Forces of both over each other and B - A below; None without any."""
    common = comparison.common
    if not forces or common is None:
        return None
    shown = _most_different(forces, lambda force: abs(force.deviation.largest) if force.deviation else 0.0)
    figure, panels = _figure(comparison, kind.title, [2.4, 1.2], 5.2)
    scale, unit = force_unit(max(max(force.peak_a.value, force.peak_b.value) for force in forces))
    curves = {
        names.get(force.name, force.name): (
            comparison.a.column(kind.variable, force.name) / scale,
            comparison.b.column(kind.variable, force.name_b) / scale,
        )
        for force in shown
    }
    _over_each_other(panels[0], comparison, curves)
    peaks = {
        names.get(force.name, force.name): max(force.peak_a.value, force.peak_b.value) for force in shown
    }
    peak = max(peaks.values()) / scale
    panels[0].set_ylim(0.0, 1.14 * peak if peak > 0.0 else 1.0)
    force_axis(panels[0], kind.label, unit)
    _legend(panels[0], list(curves), _left_out(len(shown), len(forces), kind.many))
    differences = {name: scale * common.difference(a, b) for name, (a, b) in curves.items()}
    _difference_panel(panels[1], common, differences, "B − A", (scale, unit), peaks)
    figure.align_ylabels(panels)
    return figure


def _load_motion(comparison: Comparison, load: MotionComparison) -> Figure:
    """Height, drift, tilt and heading of a load in both, and how far the two are apart."""
    sides = ((comparison.a, load.body), (comparison.b, load.body_b))
    rows: Sequence[tuple[str, Callable[[Recording, str], FloatArray], float]] = (
        ("Height above\nstart [m]", _height, 0.01),
        ("Drift [m]", _drift, 0.01),
        ("Tilt [deg]", _tilt, 0.1),
        ("Heading [deg]", _heading, 1.0),
    )
    title = f"Motion of load {load.name}" if len(comparison.loads) > 1 else "Motion of the load"
    figure, panels = _figure(comparison, title, [1.0] * 6, 8.2)
    for panel, (label, quantity, least_span) in zip(panels, rows, strict=False):
        a, b = (quantity(one, body) for one, body in sides)
        _over_each_other(panel, comparison, {load.name: (a, b)})
        panel.set_ylabel(label)
        widen(panel, least_span)
        if quantity in (_drift, _tilt):
            _from_zero(panel, float(max(a.max(), b.max())))
        few_ticks(panel)
    _legend(panels[0], [load.name], "")
    common = comparison.common
    assert common is not None
    place, attitude = (
        (comparison.a.column(name, load.body), comparison.b.column(name, load.body_b))
        for name in ("body_position", "body_orientation")
    )
    apart, turned = common.distance(*place), common.turn(*attitude)
    _difference_panel(panels[4], common, {"": apart}, "A and B\napart", _MILLIMETRES)
    _difference_panel(panels[5], common, {"": turned}, "A and B\nturned", _DEGREES)
    for panel, least, largest in (
        (panels[4], 1e-3, apart.max() / _MILLIMETRES[0]),
        (panels[5], 1e-4, turned.max() / _DEGREES[0]),
    ):
        widen(panel, least)
        _from_zero(panel, float(largest))
    figure.align_ylabels(panels)
    return figure


def _body_motion(comparison: Comparison) -> Figure | None:
    """Heights of the bodies that move and B - A below, for systems without loads; None if nothing moves."""
    common = comparison.common
    assert common is not None
    moving = [
        body
        for body in comparison.bodies
        if any(
            np.ptp(_height(*side)) > 0.0 for side in ((comparison.a, body.body), (comparison.b, body.body_b))
        )
    ]
    if not moving:
        return None
    shown = _most_different(moving, lambda body: body.position.largest if body.position else 0.0)
    figure, panels = _figure(comparison, "Motion of the bodies", [2.2, 1.2], 4.8)
    curves = {
        body.name: (_height(comparison.a, body.body), _height(comparison.b, body.body_b)) for body in shown
    }
    _over_each_other(panels[0], comparison, curves)
    panels[0].set_ylabel("Height above start [m]")
    _legend(panels[0], list(curves), _left_out(len(shown), len(moving), "bodies"))
    differences = {name: common.difference(a, b) for name, (a, b) in curves.items()}
    _difference_panel(panels[1], common, differences, "B − A", _MILLIMETRES)
    figure.align_ylabels(panels)
    return figure


def _height(recording: Recording, body: str) -> FloatArray:
    height = recording.column("body_position", body)[:, 2]
    above: FloatArray = height - height[0]
    return above


def _drift(recording: Recording, body: str) -> FloatArray:
    return load_drift(recording, next(load for load in recording.rig.loads if load.body == body))


def _tilt(recording: Recording, body: str) -> FloatArray:
    degrees: FloatArray = np.degrees(tilt(recording.column("body_orientation", body)))
    return degrees


def _heading(recording: Recording, body: str) -> FloatArray:
    degrees: FloatArray = np.degrees(series.body_heading(recording, body))
    return degrees


def _left_out(shown: int, there: int, many: str) -> str:
    """Says that not all are drawn; empty if they are."""
    return f"{shown} of {there} {many}" if shown < there else ""


def _most_different(ones: Sequence[_T], by: Callable[[_T], float]) -> list[_T]:
    """As many as can be told apart, in their order: those that differ most."""
    most = sorted(range(len(ones)), key=lambda index: -by(ones[index]))[:_MOST_CURVES]
    return [ones[index] for index in sorted(most)]


def _figure(
    comparison: Comparison, title: str, heights: Sequence[float], height: float
) -> tuple[Figure, list[Axes]]:
    names = "\n".join(
        f"{letter}: {shortened(name, 58)}" for letter, name in zip("AB", comparison.names, strict=True)
    )
    return figure_over_time({"A": comparison.a, "B": comparison.b}, title, names, heights, height)


def _over_each_other(
    panel: Axes, comparison: Comparison, curves: dict[str, tuple[FloatArray, FloatArray]]
) -> None:
    colours = _colours(len(curves))
    for (a, _), (shade, _) in zip(curves.values(), colours, strict=True):
        panel.plot(comparison.a.time, a, color=_paler(shade), linewidth=_WIDE, zorder=2)
    for (_, b), (_, shade) in zip(curves.values(), colours, strict=True):
        panel.plot(comparison.b.time, b, color=shade, linewidth=_THIN, zorder=3)


def _colours(count: int) -> list[tuple[str, str]]:
    """Colours of A and B for each curve: one hue for both, or two where there is but one curve."""
    return [(colour(0), colour(1))] if count == 1 else [(colour(k), colour(k)) for k in range(count)]


def _paler(shade: str) -> tuple[float, float, float]:
    red, green, blue = ((1.0 - _PALE) * part + _PALE for part in to_rgb(shade))
    return red, green, blue


def _legend(panel: Axes, names: list[str], note: str) -> None:
    """Say above the panel how A and B are drawn and which colour is what."""
    shade_a, shade_b = _colours(len(names))[0] if len(names) == 1 else (QUIET, INK)
    keys = [
        Line2D([], [], color=_paler(shade_a), linewidth=_WIDE),
        Line2D([], [], color=shade_b, linewidth=_THIN),
    ]
    labels = ["A", "B"]
    if len(names) > 1:
        keys += [Line2D([], [], color=colour(index), linewidth=2.4) for index in range(len(names))]
        labels += [shortened_inside(name) for name in names]
    if note:
        keys.append(Line2D([], [], linestyle="none"))
        labels.append(f"({note})")
    legend_above(panel, keys, labels, fitting_columns(labels), spacing=1.1)


def _written(value: float, sign: str = "") -> str:
    """Three digits, and all of a large number, as the table has it: nobody reads 1.62e+03 mm."""
    return f"{value:{sign},.0f}" if abs(value) >= 100.0 else f"{value:{sign}.3g}"


def _from_zero(panel: Axes, largest: float) -> None:
    """Begin a panel at zero, and leave room above its largest value: a constant one lay upon the edge."""
    panel.set_ylim(0.0, max(panel.get_ylim()[1], 1.3 * largest))


def _difference_panel(
    panel: Axes,
    common: CommonTime,
    differences: Mapping[str, FloatArray],
    label: str,
    shown_in: tuple[float, str],
    peaks: Mapping[str, float] | None = None,
) -> None:
    """Differences over the common time, with the largest marked and said; what is rounding alone is zero.

    Args:
        panel: To draw upon.
        common: The times.
        differences: By name, SI, shape (common,).
        label: Of the axis, without its unit.
        shown_in: Size [SI] and name of the unit of the axis.
        peaks: The largest values that were subtracted, by name [SI]; zero if not given, as the table has it.
    """
    size, unit = shown_in
    kept = {
        name: values / size
        if without_rounding(float(np.abs(values).max()), (peaks or {}).get(name, 0.0), unit)
        else np.zeros_like(values)
        for name, values in differences.items()
    }
    widths = np.linspace(2.2, 1.0, len(kept)) if len(kept) > 1 else [1.3]
    shades = [INK] if len(kept) == 1 else [colour(index) for index in range(len(kept))]
    for values, width, shade in zip(kept.values(), widths, shades, strict=True):
        panel.plot(common.times, values, color=shade, linewidth=float(width))
    name = max(kept, key=lambda one: float(np.abs(kept[one]).max()))
    deviation = common.deviation(unit, kept[name])
    panel.set_ylabel(f"{label} [{unit}]")
    panel.margins(y=0.22)
    few_ticks(panel)
    if deviation.largest == 0.0:
        panel.set_ylim(-1.0, 1.0)
        is_rounding = any(values.any() for values in differences.values())
        text = "no difference but rounding" if is_rounding else "no difference"
    else:
        panel.plot([deviation.time], [deviation.largest], "o", color=INK, markersize=3.5, zorder=5)
        sign = "+" if "−" in label else ""  # distances and angles have none
        largest = _written(deviation.largest, sign).replace("-", "−")
        where = f"{name}  " if len(kept) > 1 else ""
        rms = _written(deviation.rms)
        text = f"largest: {where}{largest} {unit} at {deviation.time:.2f} s; rms {rms} {unit}"
    panel.annotate(
        text,
        xy=(0.006, 0.95),
        xycoords="axes fraction",
        va="top",
        fontsize=8,
        color=QUIET,
        bbox=PALE,
    )
