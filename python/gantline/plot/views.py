"""Pictures of the system at chosen times: from the side and from above, and each equalizer close up."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from gantline.plot.drawing import TOP, draw, norm_of, side_of
from gantline.plot.labels import label_lugs, label_sheaves
from gantline.plot.moments import Moment, moments
from gantline.plot.moments import stages as stages_of
from gantline.plot.panels import draw_ground, draw_holes, draw_water, scale_bar, strip, tension_bar, window_of
from gantline.plot.raster import View
from gantline.plot.scene import Snapshot, snapshot
from gantline.plot.style import INK, QUIET
from gantline.results.gear import Equalizer
from gantline.results.recording import Recording
from gantline.results.surroundings import ground_of, water_level
from gantline.results.variable import FloatArray

__all__ = ["equalizer", "stages", "system"]

_MOST_IN_COLUMNS = 6  # moving sheaves of an equalizer whose times stand side by side; with more they are rows
_MOST_DRAWN = 60  # moving sheaves of an equalizer: more could not be told from each other


def system(recording: Recording) -> Figure | None:
    """Side and top view at start, slings taut, lift-off, peak and end; None if there is nothing to draw."""
    found = moments(recording)
    shown = [(one.name, snapshot(recording, one.sample)) for one in found]
    if not any(len(snap.ropes) or len(snap.boxes) for _, snap in shown):
        return None
    extent = np.concatenate([snap.extent() for _, snap in shown])
    ground = ground_of(recording)
    lift = extent
    if ground is not None:
        extent = np.concatenate([extent, ground.near(lift)])
    norm, side = norm_of(shown), side_of(recording)
    windows = [
        window_of(side.project(extent), below=0.8),
        window_of(TOP.project(extent)),
    ]
    windows[1][1] = _at_least(windows[1][1], 0.3 * float(np.ptp(windows[0][0])))
    windows[1][0] = windows[0][0] = _hull(windows[0][0], windows[1][0])
    figure, panels = strip(recording, "The system", len(shown), windows)
    for column, (moment, (_, snap)) in enumerate(zip(found, shown, strict=True)):
        for view, row in ((side, panels[0]), (TOP, panels[1])):
            draw(row[column], snap, view, norm)
        if ground is not None:
            draw_ground(panels[0][column], ground, lift, side.axis)
            draw_holes(panels[1][column], ground, water_level(recording))
        draw_water(panels[0][column], recording, lift, snap.time, side.axis)
        _title(panels[0][column], moment)
        label_lugs(panels[1][column], recording, snap)
    panels[0][0].set_ylabel(f"side view ({'xy'[side.axis]}, z)", fontsize=8, color=QUIET)
    panels[1][0].set_ylabel("top view (x, y)", fontsize=8, color=QUIET)
    scale_bar(panels[0][-1])
    tension_bar(figure, [panel for row in panels for panel in row], norm)
    return figure


def stages(recording: Recording) -> Figure | None:
    """Side views of the stages of a lift under a crane that goes somewhere, two rows of three; else None."""
    found = stages_of(recording)
    if not (recording.rig.cranes or recording.rig.booms) or len(found) < 4:
        return None
    shown = [(one.name, snapshot(recording, one.sample)) for one in found]
    norm, side = norm_of(shown), side_of(recording)
    extent = lift = np.concatenate([snap.extent() for _, snap in shown])
    ground = ground_of(recording)
    if ground is not None:
        extent = np.concatenate([lift, ground.near(lift)])
    window = window_of(side.project(extent))
    figure, rows = strip(recording, "Stages", 3, [window, window], scale=3.6, titles=2)
    panels = [panel for row in rows for panel in row]
    for panel, moment, (_, snap) in zip(panels, found, shown, strict=False):
        if ground is not None:
            draw_ground(panel, ground, lift, side.axis)
        draw(panel, snap, side, norm)
        draw_water(panel, recording, lift, snap.time, side.axis)
        _title(panel, moment)
    for panel in panels[len(shown) :]:
        panel.set_visible(False)
    scale_bar(panels[min(len(shown), 6) - 1])
    tension_bar(figure, panels, norm)
    return figure


def equalizer(recording: Recording, which: Equalizer) -> Figure | None:
    """One equalizer close up, across its frame, at such times of its own slings, and no other.

    None if it is not drawn, or has no sheaves or more than could be told from each other.
    """
    found = moments(recording, which.slings)
    others = [one for one in recording.rig.equalizers if one.name != which.name]
    shown = [(one.name, _without(others, snapshot(recording, one.sample))) for one in found]
    has_sheaves = 0 < len(which.moving_sheaves) <= _MOST_DRAWN and which.mechanism == "sheaves"
    if not has_sheaves or which.name not in shown[0][1].frame_axes:
        return None
    norm = norm_of(shown)
    views = [_across(snap.frame_axes[which.name]) for _, snap in shown]
    origins = [
        view.project(snap.frame_origin[which.name]) for view, (_, snap) in zip(views, shown, strict=True)
    ]
    paths = [
        view.project(part) - origin
        for view, origin, (_, snap) in zip(views, origins, shown, strict=True)
        for part in _of_equalizer(snap, which)
    ]
    window = window_of(np.concatenate(paths), below=1.2)
    columns = len(shown) if len(which.moving_sheaves) <= _MOST_IN_COLUMNS else 1
    titles = len(shown) // columns
    room = {"scale": 10.0, "high": 14.0} if titles > 1 else {}
    figure, rows = strip(
        recording, f"Equalizer {which.name}", columns, [window] * titles, titles=titles, **room
    )
    row = [panel for panels in rows for panel in panels]
    for panel, view, origin, moment, (_, snap) in zip(row, views, origins, found, shown, strict=True):
        panel.set_xlim(*(window[0] + origin[0]))
        panel.set_ylim(*(window[1] + origin[1]))
        _draw_strokes(panel, recording, snap, view, which)
        draw(panel, snap, view, norm, large=True)
        _title(panel, moment)
        label_sheaves(panel, snap, view, which)
    rows[titles // 2][0].set_ylabel(
        "seen across the frame\n(ticks: ends of stroke)", fontsize=7.5, color=QUIET
    )
    scale_bar(row[-1])
    tension_bar(figure, row, norm)
    return figure


def _draw_strokes(panel: Axes, recording: Recording, snap: Snapshot, view: View, which: Equalizer) -> None:
    """Where the centre of each moving sheave may travel: a faint line with a tick at either end."""
    sample = int(np.argmin(np.abs(recording.time - snap.time)))
    for sheave in snap.sheaves:
        if sheave.body not in which.moving_sheaves or not (which.travel_up and which.travel_down):
            continue
        along, height = view.project(sheave.circle)[:-1].mean(axis=0)
        start = height + float(recording.column("sheave_travel", sheave.body)[sample])
        ends = [start + which.travel_up, start - which.travel_down]
        panel.plot([along, along], ends, color="#9FB0BF", linewidth=0.8, zorder=2.6)
        for end in ends:
            panel.plot([along - 0.18, along + 0.18], [end, end], color="#9FB0BF", linewidth=0.8, zorder=2.6)


def _across(frame: FloatArray) -> View:
    """Seen across a frame: its length to the right."""
    return View(frame[:, 0], frame[:, 2], -frame[:, 1])


def _without(others: Sequence[Equalizer], snap: Snapshot) -> Snapshot:
    bodies = {body for other in others for body in (other.body, *other.moving_sheaves)}
    ropes = {rope for other in others for rope in (other.equalizing_rope, *other.slings)}
    return replace(
        snap,
        boxes=[box for box in snap.boxes if box.name not in bodies],
        sheaves=[sheave for sheave in snap.sheaves if sheave.body not in bodies],
        ropes=[rope for rope in snap.ropes if rope.name not in ropes],
    )


def _of_equalizer(snap: Snapshot, which: Equalizer) -> list[FloatArray]:
    parts = [rope.path for rope in snap.ropes if rope.name == which.equalizing_rope]
    parts += [sheave.circle for sheave in snap.sheaves if sheave.body in (which.body, *which.moving_sheaves)]
    parts += [box.faces.reshape(-1, 3) for box in snap.boxes if box.name == which.body]
    return parts


def _hull(one: FloatArray, other: FloatArray) -> FloatArray:
    return np.array([min(one[0], other[0]), max(one[1], other[1])])


def _at_least(limits: FloatArray, span: float) -> FloatArray:
    more = max(0.0, span - float(np.ptp(limits))) / 2.0
    wider: FloatArray = limits + np.array([-more, more])
    return wider


def _title(panel: Axes, moment: Moment) -> None:
    when = f"{moment.time:.2f} s"
    panel.set_title(f"{moment.name}\n{when}" if moment.name else when, fontsize=9, color=INK)
