"""Pictures over time: tensions, travel, attitude, hook load."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from gantline.plot.style import (
    QUIET,
    colour,
    curves,
    few_ticks,
    force_axis,
    force_unit,
    four_digits,
    label_ends,
    legend,
    legend_of,
    limit_line,
    many_curves,
    mark_peak,
    time_figure,
    widen,
)
from gantline.results import series
from gantline.results.alike import first_peak
from gantline.results.gear import Equalizer
from gantline.results.loads.aside import drift_of, not_worth_a_plot, swing_of, tilt_of
from gantline.results.loads.drift import is_taken_along
from gantline.results.loads.hook_peaks import hook_peak
from gantline.results.recording import Recording
from gantline.results.ropes.families import MOST, families
from gantline.results.variable import BoolArray, FloatArray


def sling_tension(recording: Recording) -> Figure | None:
    """Tension of every sling, and the tension spread of every equalizer while clear; None without slings."""
    slings = recording.rig.slings
    if not slings:
        return None
    equalizers = [e for e in recording.rig.equalizers if e.slings]
    clear = series.is_clear(recording)
    has_spread = bool(equalizers) and bool(clear.any())
    ropes = {sling.name: sling.rope for sling in slings}
    height = 4.6 + _legend_height(recording, ropes)
    figure, panels = time_figure(recording, "Sling tension", [3.0, 1.2] if has_spread else [1.0], height)
    shades = _rope_panel(recording, panels[0], ropes)
    if has_spread:
        _deviation_panel(recording, panels[1], equalizers, clear, shades)
        figure.align_ylabels(panels)
    return figure


def _deviation_panel(
    recording: Recording,
    panel: Axes,
    equalizers: list[Equalizer],
    clear: BoolArray,
    shades: Mapping[str, str],
) -> None:
    """How far each sling is from the mean of its equalizer while the loads are clear."""
    deviations: dict[str, FloatArray] = {}
    for equalizer in equalizers:
        tensions = np.array([recording.column("rope_tension", rope) for rope in equalizer.slings])
        whole = series.are_whole(recording, equalizer.slings)
        mean = np.sum(tensions, axis=0, where=whole) / np.maximum(whole.sum(axis=0), 1)
        for rope, tension, counts in zip(equalizer.slings, tensions, whole, strict=True):
            ratio = np.divide(tension, mean, out=np.ones_like(mean), where=mean > 0.0)
            deviations[rope] = np.where(clear & counts, 100.0 * (ratio - 1.0), np.nan)
    thinnest, widest = (0.5, 0.5) if len(deviations) > MOST else (1.0, 2.6)
    widths = np.linspace(widest, thinnest, len(deviations))
    for (rope, values), width in zip(deviations.items(), widths, strict=True):
        panel.plot(recording.time, values, color=shades.get(rope, QUIET), linewidth=float(width))
    panel.set_ylabel("From the mean\nwhen clear [%]")
    widen(panel, 0.2)
    few_ticks(panel)
    spread = max(series.spread_when_clear(recording, equalizer) or 0.0 for equalizer in equalizers)
    panel.set_title(f"largest spread {100 * spread:.2f} %", loc="right", fontsize=8, color=QUIET, pad=3)


def equalizing_rope_tension(recording: Recording) -> Figure | None:
    """Tension of every equalizing rope; None without equalizers."""
    ropes = {e.name: e.equalizing_rope for e in recording.rig.equalizers if e.equalizing_rope}
    return _ropes(recording, "Equalizing rope tension", ropes)


def rope_tension(recording: Recording) -> Figure | None:
    """Tension of the ropes that are neither slings nor equalizing ropes; None without such."""
    known = {sling.rope for sling in recording.rig.slings}
    known |= {equalizer.equalizing_rope for equalizer in recording.rig.equalizers}
    known |= {compensator.gas for compensator in recording.rig.compensators}
    ropes = {rope: rope for rope in recording.coordinates.get("rope", ()) if rope not in known}
    return _ropes(recording, "Rope tension", ropes)


def sheave_travel(recording: Recording) -> Figure | None:
    """Travel of the moving sheaves between the ends of their stroke, downwards as they move, or None."""
    equalizers = [e for e in recording.rig.equalizers if e.moving_sheaves and e.mechanism == "sheaves"]
    if not equalizers:
        return None
    figure, panels = time_figure(
        recording, "Sheave travel", [1.0] * len(equalizers), 1.4 + 2.8 * len(equalizers)
    )
    for equalizer, panel in zip(equalizers, panels, strict=True):
        travel = {sheave: recording.column("sheave_travel", sheave) for sheave in equalizer.moving_sheaves}
        for index, curve in enumerate(travel.values()):
            width = 2.6 if index < len(travel) / 2 else 1.3
            panel.plot(recording.time, curve, color=colour(index), linewidth=width)
        strokes = [-(equalizer.travel_up or 0.0), equalizer.travel_down or 0.0]
        reach = np.array([*strokes, *(c.min() for c in travel.values()), *(c.max() for c in travel.values())])
        margin = 0.1 * max(float(np.ptp(reach)), 0.1)
        panel.set_ylim(float(reach.max()) + margin, float(reach.min()) - margin)
        panel.set_ylabel(f"{equalizer.name}: travel,\ndown positive [m]")
        if equalizer.travel_up:
            limit_line(
                panel, -equalizer.travel_up, f"end of stroke, {equalizer.travel_up:g} m up", right=True
            )
        if equalizer.travel_down:
            limit_line(
                panel,
                equalizer.travel_down,
                f"end of stroke, {equalizer.travel_down:g} m down",
                right=True,
                below=True,
            )
        label_ends(panel, recording.time, travel)
    return figure


def rod_out(recording: Recording) -> Figure | None:
    """How far the rods of compensators are out, between their stops; None without any."""
    compensators = recording.rig.compensators
    if not compensators:
        return None
    height = 1.4 + 2.2 * len(compensators)
    figure, panels = time_figure(recording, "Rod out", [1.0] * len(compensators), height)
    for one, panel in zip(compensators, panels, strict=True):
        out = recording.column("rod_out", one.name)
        panel.plot(recording.time, out, color=colour(0), linewidth=1.6)
        reach = np.array([0.0, one.stroke, out.min(), out.max()])
        margin = 0.12 * float(np.ptp(reach))
        panel.set_ylim(float(reach.min()) - margin, float(reach.max()) + margin)
        panel.set_ylabel(f"{one.name}: rod out [m]")
        limit_line(panel, one.stroke, f"outer stop, {one.stroke:g} m", right=True)
        limit_line(panel, 0.0, "inner stop", right=True, below=True)
    return figure


def sling_lengthening(recording: Recording) -> Figure | None:
    """What adjusting has added to the length of slings, downwards as sheaves would travel, or None."""
    equalizers = [e for e in recording.rig.equalizers if e.mechanism == "approximated"]
    if not equalizers:
        return None
    height = 1.4 + 2.8 * len(equalizers)
    figure, panels = time_figure(recording, "Sling lengthening", [1.0] * len(equalizers), height)
    for equalizer, panel in zip(equalizers, panels, strict=True):
        change = {rope: recording.column("rope_lengthening", rope) for rope in equalizer.slings}
        named = {rope.removeprefix("sling."): values for rope, values in change.items()}
        for index, curve in enumerate(named.values()):
            width = 2.6 if index < len(named) / 2 else 1.3
            panel.plot(recording.time, curve, color=colour(index), linewidth=width)
        panel.margins(y=0.15)  # room for 'lift-off'
        widen(panel, 0.1)
        panel.invert_yaxis()
        panel.set_ylabel(f"{equalizer.name}: longer than\nat the start [m]")
        label_ends(panel, recording.time, named)
    return figure


def attitude(recording: Recording) -> Figure | None:
    """Tilt, heading, height, drift or swing, and gusts of loads, headings of frames; None without loads.

    What is less than could be seen has no panel.
    """
    loads = recording.rig.loads
    if not loads:
        return None
    position = {load.name: recording.column("body_position", load.body) for load in loads}
    bodies = {load.name: load.body for load in loads} | {e.name: e.body for e in recording.rig.equalizers}
    every = {name: np.degrees(series.body_heading(recording, body)) for name, body in bodies.items()}
    # What is upended has no heading.
    degrees = {name: curve for name, curve in every.items() if np.isfinite(curve).all()}
    tilt = {name: np.degrees(curve) for name, curve in tilt_of(recording).items()}
    height = {name: place[:, 2] - place[0, 2] for name, place in position.items()}
    drift, swing = drift_of(recording), swing_of(recording)
    rows = [
        ("Tilt [deg]", tilt, 0.1),
        ("Heading [deg]", degrees, 1.0),
        ("Height above\nstart [m]", height, 0.01),
        ("Drift off the\nplan's way [m]" if is_taken_along(recording.rig) else "Drift [m]", drift, 0.01),
        ("Swing [m]", swing, 0.01),
    ]
    rows = [row for row in rows if row[1]]
    if "wind_at_load" in recording:
        wind = {load.name: recording.column("wind_at_load", load.name) for load in loads}
        rows.append(("Wind [m/s]", wind, 1.0))
    figure, panels = time_figure(recording, "Attitude", [1.0] * len(rows), 1.6 * len(rows))
    for panel, (label, values, least_span) in zip(panels, rows, strict=True):
        for index, curve in enumerate(values.values()):
            panel.plot(recording.time, curve, color=colour(index))
        panel.set_ylabel(label)
        widen(panel, least_span)
        if values is tilt or values is drift or values is swing:
            panel.set_ylim(bottom=0.0)
        if panel is panels[0]:
            low, high = panel.get_ylim()
            panel.set_ylim(top=low + 1.2 * (high - low))  # room for 'lift-off'
        few_ticks(panel)
        label_ends(panel, recording.time, values)
    missing = not_worth_a_plot(recording)
    if missing:
        panels[-1].set_xlabel(f"Time [s]\n{missing}")
    figure.align_ylabels(panels)
    return figure


def motion(recording: Recording) -> Figure | None:
    """Height of every body above its start, for a system without loads; None if nothing moves."""
    if recording.rig.loads or "body_position" not in recording:
        return None
    heights: dict[str, FloatArray] = {}
    for body in recording.coordinates["body"]:
        height = recording.column("body_position", body)[:, 2]
        if float(np.ptp(height)) > 0.0:
            heights[body] = height - height[0]
    if not heights:
        return None
    figure, (panel,) = time_figure(recording, "Motion of the bodies", [1.0], 3.8)
    curves(panel, recording.time, heights)
    panel.set_ylabel("Height above start [m]")
    label_ends(panel, recording.time, heights)
    return figure


def hook_load(recording: Recording) -> Figure | None:
    """Hook loads, and how much of every load is transferred and under water; None without hooks."""
    hooks = recording.rig.hooks
    if not hooks:
        return None
    loads = recording.rig.loads
    wet = [load for load in loads if load.in_water is not None]
    heights = [2.6, *([1.2] if loads else []), *([1.2] if wet else [])]
    figure, panels = time_figure(recording, "Hook load", heights, 3.4 + 1.2 * max(1, len(heights) - 1))
    forces = {hook.name: recording.column("hook_load", hook.name) for hook in hooks}
    peaks = {name: hook_peak(recording, name, "hook_load") for name in forces}
    name = list(forces)[first_peak([force for force, _ in peaks.values()])]
    _force_panel(recording, panels[0], forces, "Hook load", (*peaks[name], name))
    if loads:
        for index, load in enumerate(loads):
            transferred = recording.column("load_transferred", load.name) * 100.0
            panels[1].plot(recording.time, transferred, color=colour(index), label=load.name)
        if len(loads) > 1:
            panels[1].legend(fontsize=8, ncols=4, loc="lower right")
        panels[1].set_ylim(-4.0, 108.0)
        panels[1].set_yticks([0, 25, 50, 75, 100])
        panels[1].set_ylabel("Load trans-\nferred [%]")
    for index, load in enumerate(loads):
        if load.in_water is not None:
            displaced = recording.column("displaced_volume", load.in_water)
            panels[2].plot(recording.time, displaced, color=colour(index), label=load.name)
            panels[2].set_ylim(bottom=-0.04 * float(displaced.max(initial=1.0)))
            panels[2].set_ylabel("Displaced\nwater [m³]")
    figure.align_ylabels(panels)
    return figure


def _ropes(recording: Recording, title: str, ropes: dict[str, str]) -> Figure | None:
    if not ropes:
        return None
    figure, (panel,) = time_figure(recording, title, [1.0], 3.8 + _legend_height(recording, ropes))
    shades = _rope_panel(recording, panel, ropes)
    highest = max(series.rope_peak(recording, rope)[0] for rope in ropes.values())
    alpha = max(0.12, 0.3 / len(ropes) ** 0.5)  # bands may lie upon each other
    if any(
        [_shade_segments(recording, panel, shade, rope, highest, alpha) for rope, shade in shades.items()]
    ):
        panel.set_ylabel(f"{panel.get_ylabel()},\nrange of its segments shaded")
    return figure


def _legend_height(recording: Recording, ropes: Mapping[str, str]) -> float:
    """What a row for each family takes beyond the two that there is room for [inch]."""
    if len(ropes) <= MOST:
        return 0.0
    return 0.18 * max(0, len(set(families(recording.rig, list(ropes.values())).values())) - 2)


def _rope_panel(recording: Recording, panel: Axes, ropes: Mapping[str, str]) -> dict[str, str]:
    """Tensions of ropes, by what each is called; many share colours with their family.

    Returns:
        Colour by rope.
    """
    tensions = {name: recording.column("rope_tension", rope) for name, rope in ropes.items()}
    peaks = {name: series.rope_peak(recording, rope) for name, rope in ropes.items()}
    highest = list(peaks)[first_peak([force for force, _ in peaks.values()])]
    peak = (*peaks[highest], highest)
    if len(ropes) <= MOST:
        _force_panel(recording, panel, tensions, "Tension", peak)
        return {rope: colour(index) for index, rope in enumerate(ropes.values())}
    family = families(recording.rig, list(ropes.values()))
    members: dict[str, list[str]] = {}
    for name, rope in ropes.items():
        members.setdefault(family[rope], []).append(name)
    foremost = {one: names[first_peak([peaks[name][0] for name in names])] for one, names in members.items()}
    shade = {name: colour(index) for index, names in enumerate(members.values()) for name in names}
    scale, unit = _force_frame(panel, "Tension", peak)
    scaled = {name: tension / scale for name, tension in tensions.items()}
    many_curves(panel, recording.time, scaled, shade, list(foremost.values()))
    entries = {}
    for one, name in foremost.items():
        force, time = peaks[name]
        entries[f"{one}, highest {name} {four_digits(force / scale)} {unit} at {time:.1f} s"] = shade[name]
    legend_of(panel, entries)
    return {rope: shade[name] for name, rope in ropes.items()}


def _shade_segments(
    recording: Recording, panel: Axes, shade: str, rope: str, peak: float, alpha: float
) -> bool:
    """Shade the range of tension over the segments of a rope; False where all have the same."""
    names = recording.coordinates.get("segment", ())
    own = [place for place, name in enumerate(names) if name.rpartition("/")[0] == rope]
    if not own:
        return False
    tensions = recording["segment_tension"].values[:, own]
    low, high = tensions.min(axis=1), tensions.max(axis=1)
    if float((high - low).max()) <= 1e-6 * peak:
        return False
    scale, _ = force_unit(peak)
    panel.fill_between(recording.time, low / scale, high / scale, color=shade, alpha=alpha, linewidth=0)
    return True


def _force_panel(
    recording: Recording,
    panel: Axes,
    forces: dict[str, FloatArray],
    label: str,
    peak: tuple[float, float, str],
) -> None:
    """Forces [N] over time with their peak: force [N], time [s], name."""
    scale, _ = _force_frame(panel, label, peak)
    curves(panel, recording.time, {name: force / scale for name, force in forces.items()})
    if len(forces) > 1:
        legend(panel)


def _force_frame(panel: Axes, label: str, peak: tuple[float, float, str]) -> tuple[float, str]:
    """Axes for forces up to their peak, which is marked; their unit: its size [N] and its name."""
    force, time, name = peak
    scale, unit = force_unit(force)
    panel.set_ylim(0.0, 1.14 * force / scale if force > 0.0 else 1.0)
    force_axis(panel, label, unit)
    mark_peak(panel, time, force / scale, f"{name}  {four_digits(force / scale)} {unit} at {time:.2f} s")
    return scale, unit
