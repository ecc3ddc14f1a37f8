"""Drawn views of the system at chosen times: from the side and from above, and each equalizer close up."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.colors import Normalize, to_rgb
from matplotlib.figure import Figure
from matplotlib.patches import Polygon
from matplotlib.patheffects import Normal, Stroke

from gantline.plot.moments import moments
from gantline.plot.moments import stages as stages_of
from gantline.plot.panels import (
    EARTH_EDGE,
    TENSION,
    draw_ground,
    draw_holes,
    draw_water,
    scale_bar,
    strip,
    tension_bar,
    window_of,
)
from gantline.plot.scene import Box, RopePath, Snapshot, snapshot
from gantline.plot.style import INK, KILO, MOST_NAMED, QUIET
from gantline.results.gear import Equalizer
from gantline.results.recording import Recording
from gantline.results.surroundings import ground_of, water_level
from gantline.results.variable import FloatArray

_EDGE_ON = 1e-3  # cosine to the line of sight below which a triangle is a line
_CHARACTER = 0.055  # inches along of a character of a name
_MOST_IN_COLUMNS = 6  # moving sheaves of an equalizer whose times stand side by side; with more they are rows
_MOST_DRAWN = 60  # moving sheaves of an equalizer: more could not be told from each other
_MOST_LUGS = 10  # that are labelled one by one
_LUGS_APART = 0.1  # of the width of a panel: nearer to each other their names would touch
_LINES_REACH = 0.05  # of a panel's larger side: more than half the width of any line
_SLACK_BELOW = 1e-3  # of the largest tension shown
_FILL = {
    "load": "#C9D6E2",
    "frame": "#8FA3B5",
    "support": "#CFC6B8",
    "structure": "#E6E6E6",
    "hull": "#D5D2C8",
}
# Directions in which a label may stand, the preferred ones first.
_AROUND = np.array([(np.cos(a), np.sin(a)) for a in np.deg2rad([45, -45, 135, -135, *range(0, 360, 15)])])
_EDGE = {
    "load": "#5B7286",
    "frame": "#4A5F73",
    "support": EARTH_EDGE,
    "structure": "#A3A3A3",
    "hull": "#6B665A",
}


@dataclass(frozen=True)
class View:
    """Directions in the world that are right, up and towards the viewer on paper, unit vectors."""

    right: FloatArray
    up: FloatArray
    toward: FloatArray

    def project(self, points: FloatArray) -> FloatArray:
        """Points on paper [m], shape (..., 2), of points in space, shape (..., 3)."""
        return np.stack([points @ self.right, points @ self.up], axis=-1)


SIDE = View(np.array([1.0, 0.0, 0.0]), np.array([0.0, 0.0, 1.0]), np.array([0.0, -1.0, 0.0]))
TOP = View(np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0]), np.array([0.0, 0.0, 1.0]))


def system(recording: Recording) -> Figure | None:
    """Side and top view at start, slings taut, lift-off, peak and end; None if there is nothing to draw."""
    shown = [(name, snapshot(recording, sample)) for name, sample in moments(recording)]
    if not any(len(snap.ropes) or len(snap.boxes) for _, snap in shown):
        return None
    extent = np.concatenate([snap.extent() for _, snap in shown])
    ground = ground_of(recording)
    lift = extent
    if ground is not None:
        extent = np.concatenate([extent, ground.near(lift)])
    norm = norm_of(shown)
    windows = [
        window_of(SIDE.project(extent), below=0.8),
        window_of(TOP.project(extent)),
    ]
    windows[1][1] = _at_least(windows[1][1], 0.3 * float(np.ptp(windows[0][0])))
    windows[1][0] = windows[0][0] = _hull(windows[0][0], windows[1][0])
    figure, panels = strip(recording, "The system", len(shown), windows)
    for column, (name, snap) in enumerate(shown):
        for view, row in ((SIDE, panels[0]), (TOP, panels[1])):
            draw(row[column], snap, view, norm)
        if ground is not None:
            draw_ground(panels[0][column], ground, lift)
            draw_holes(panels[1][column], ground, water_level(recording))
        draw_water(panels[0][column], recording, lift)
        _title(panels[0][column], name, snap.time)
        _label_lugs(panels[1][column], recording, snap)
    panels[0][0].set_ylabel("side view (x, z)", fontsize=8, color=QUIET)
    panels[1][0].set_ylabel("top view (x, y)", fontsize=8, color=QUIET)
    scale_bar(panels[0][-1])
    tension_bar(figure, [panel for row in panels for panel in row], norm)
    return figure


def stages(recording: Recording) -> Figure | None:
    """Side views of the stages of a lift under a crane that goes somewhere, two rows of three; else None."""
    found = stages_of(recording)
    if not (recording.rig.cranes or recording.rig.booms) or len(found) < 4:
        return None
    shown = [(name, snapshot(recording, sample)) for name, sample in found]
    norm = norm_of(shown)
    extent = lift = np.concatenate([snap.extent() for _, snap in shown])
    ground = ground_of(recording)
    if ground is not None:
        extent = np.concatenate([lift, ground.near(lift)])
    window = window_of(SIDE.project(extent))
    figure, rows = strip(recording, "Stages", 3, [window, window], scale=3.6, titles=2)
    panels = [panel for row in rows for panel in row]
    for panel, (name, snap) in zip(panels, shown, strict=False):
        if ground is not None:
            draw_ground(panel, ground, lift)
        draw(panel, snap, SIDE, norm)
        draw_water(panel, recording, lift)
        _title(panel, name, snap.time)
    for panel in panels[len(shown) :]:
        panel.set_visible(False)
    scale_bar(panels[min(len(shown), 6) - 1])
    tension_bar(figure, panels, norm)
    return figure


def equalizer(recording: Recording, which: Equalizer) -> Figure | None:
    """One equalizer close up, across its frame, at the same times.

    None if it is not drawn, or has no sheaves or more than could be told from each other.
    """
    shown = [(name, snapshot(recording, sample)) for name, sample in moments(recording)]
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
    for panel, view, origin, (name, snap) in zip(row, views, origins, shown, strict=True):
        panel.set_xlim(*(window[0] + origin[0]))
        panel.set_ylim(*(window[1] + origin[1]))
        _draw_strokes(panel, recording, snap, view, which)
        draw(panel, snap, view, norm, large=True)
        _title(panel, name, snap.time)
        _label_sheaves(panel, snap, view, which)
    rows[titles // 2][0].set_ylabel(
        "seen across the frame\n(ticks: ends of stroke)", fontsize=7.5, color=QUIET
    )
    scale_bar(row[-1])
    tension_bar(figure, row, norm)
    return figure


def draw(panel: Axes, snap: Snapshot, view: View, norm: Normalize, *, large: bool = False) -> None:
    """Draw a snapshot into a panel.

    Args:
        panel: Where to draw; its limits are kept.
        snap: What to draw.
        view: From where it is seen.
        norm: From tension [N] to the colour scale.
        large: Whether sheaves are large enough on paper to show their rims.
    """
    limits = panel.get_xlim(), panel.get_ylim()
    for box in (*snap.surroundings, *snap.boxes):
        if _is_seen(view.project(box.faces).reshape(-1, 2), limits):
            _draw_box(panel, box, view)
        if box.name in snap.frame_origin:
            _draw_hanger(panel, box, snap.frame_origin[box.name], snap.frame_axes[box.name][:, 2], view)
    for rope in snap.ropes:
        if _is_seen(view.project(rope.path), limits):
            _draw_rope(panel, rope, view, norm, 2.0 if large else 1.1)
    for sheave in snap.sheaves:
        outline = view.project(sheave.circle)
        if not _is_seen(outline, limits):
            continue
        face, edge = ("white", INK) if sheave.moves else ("#B9C4CE", "#4A5F73")
        panel.add_artist(
            Polygon(outline, facecolor=face, edgecolor=edge, linewidth=1.1 if large else 0.6, zorder=3.5)
        )
        if large:
            panel.plot(*outline[:-1].mean(axis=0), "o", color=edge, markersize=2.2, zorder=3.6)
    for name, point in snap.points.items():
        panel.plot(
            *view.project(point), marker="v" if name in snap.hooks else "s", color=INK, markersize=4, zorder=4
        )
    for centre in snap.centres.values():
        panel.plot(
            *view.project(centre), marker="o", color="white", markeredgecolor=INK, markersize=5, zorder=4
        )
        panel.plot(*view.project(centre), marker="+", color=INK, markersize=5, markeredgewidth=0.8, zorder=4)
    panel.set_xlim(*limits[0])
    panel.set_ylim(*limits[1])


def _is_seen(points: FloatArray, limits: Sequence[tuple[float, float]]) -> bool:
    """Whether what lies around points on paper may reach into a panel with its lines, which have widths.

    In the picture of one equalizer the rest of a large lift lies outside, and would take most of its time.
    """
    least, most = np.array(limits).T
    margin = _LINES_REACH * float(np.max(most - least))
    return bool(np.all(points.max(axis=0) >= least - margin) and np.all(points.min(axis=0) <= most + margin))


def _draw_box(panel: Axes, box: Box, view: View) -> None:
    fill, edge = _FILL.get(box.kind, "#DDDDDD"), _EDGE.get(box.kind, QUIET)
    is_frame = box.kind == "frame"
    if box.triangles is not None:
        _draw_mesh(panel, box.triangles, view, fill)
        return
    for face in box.faces:
        normal = np.cross(face[1] - face[0], face[2] - face[1])
        if normal @ view.toward > 1e-9 * np.linalg.norm(normal):
            outline = view.project(face)
            panel.add_artist(
                Polygon(outline, facecolor=fill, edgecolor="none", alpha=0.35 if is_frame else 1.0, zorder=1)
            )
            panel.add_artist(
                Polygon(outline, fill=False, edgecolor=edge, linewidth=0.8, zorder=2.5 if is_frame else 1)
            )


def _draw_mesh(panel: Axes, triangles: FloatArray, view: View, fill: str) -> None:
    """Triangles from the farthest to the nearest, both sides of each, the darker the steeper."""
    normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    sizes = np.linalg.norm(normals, axis=1)
    facing = np.abs(normals @ view.toward) / np.where(sizes > 0.0, sizes, 1.0)
    order = np.argsort(triangles.mean(axis=1) @ view.toward, kind="stable")
    order = order[facing[order] > _EDGE_ON]
    colours = np.array(to_rgb(fill)) * (0.6 + 0.4 * facing[order, None])
    panel.add_collection(
        PolyCollection(
            list(view.project(triangles[order])),
            facecolors=colours,
            edgecolors=colours,
            linewidths=0.2,
            zorder=1,
        )
    )


def _draw_hanger(panel: Axes, frame: Box, bearing: FloatArray, upwards: FloatArray, view: View) -> None:
    """The link from the hook's bearing to the top of a frame, seen along its own axis `upwards`."""
    corners = frame.faces.reshape(-1, 3)
    height = corners @ upwards
    top = corners[height > height.max() - 1e-3 * np.ptp(height)].mean(axis=0)
    line = view.project(np.stack([bearing, top]))
    panel.plot(line[:, 0], line[:, 1], color=_EDGE["frame"], linewidth=2.0, solid_capstyle="butt", zorder=2.4)


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


def _draw_rope(panel: Axes, rope: RopePath, view: View, norm: Normalize, width: float) -> None:
    path = view.project(rope.path)
    is_slack = rope.tension <= _SLACK_BELOW * float(norm.vmax or 1.0)
    panel.plot(
        path[:, 0],
        path[:, 1],
        color="#8A8A8A" if is_slack else TENSION(norm(rope.tension)),
        linewidth=0.7 * width if is_slack else width,
        linestyle=(0, (3, 1.5)) if is_slack else "-",
        zorder=3.7 if rope.kind == "equalizing" else 3,
    )


def norm_of(shown: Sequence[tuple[str, Snapshot]]) -> Normalize:
    """From tensions [N] to the colour scale of all that is shown."""
    highest = max((rope.tension for _, snap in shown for rope in snap.ropes), default=0.0)
    return Normalize(0.0, highest if highest > 0.0 else 1.0)


def _across(frame: FloatArray) -> View:
    """Seen across a frame: its length to the right."""
    return View(frame[:, 0], frame[:, 2], -frame[:, 1])


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


def _title(panel: Axes, name: str, time: float) -> None:
    panel.set_title(f"{name}\n{time:.2f} s" if name else f"{time:.2f} s", fontsize=9, color=INK)


def _label_lugs(panel: Axes, recording: Recording, snap: Snapshot) -> None:
    """Names of the slings beside their lugs in a top view, where ropes, edges and centres leave room.

    Where there are many, or they lie too near to each other, what they hang from is named in their place.
    """
    lines = [rope.path for rope in snap.ropes]
    lines += [np.concatenate([face, face[:1]]) for box in snap.boxes for face in box.faces]
    centres = [TOP.project(centre)[None] for centre in snap.centres.values()]
    taken = np.concatenate([_densely(TOP.project(line)) for line in lines] + centres)
    width = float(np.ptp(panel.get_xlim()))
    character = _CHARACTER * width / _inches(panel)
    for lug in snap.lugs.values():
        panel.plot(*TOP.project(lug), "o", color=INK, markersize=2.2, zorder=4)
    named = dict(snap.lugs)
    if len(named) > _MOST_LUGS or _nearest(named) < _LUGS_APART * width:
        named = _by_what_bears_them(recording, snap)
    for name, lug in named.items():
        half = character * len(name) / 2
        paper = (panel.get_xlim(), panel.get_ylim())
        right, up = beside(TOP.project(lug), half, taken, 0.05 * width, paper)
        label = panel.text(right, up, name, fontsize=6.5, ha="center", va="center", zorder=5)
        label.set_path_effects([Stroke(linewidth=2.0, foreground="white"), Normal()])
        taken = np.concatenate([taken, (right, up) + np.linspace(-half, half, 9)[:, None] * (1.0, 0.0)])


def _inches(panel: Axes) -> float:
    """How wide a panel of a strip is on paper."""
    place, figure = panel.get_subplotspec(), panel.get_figure(root=True)
    assert place is not None and figure is not None
    return float(figure.get_size_inches()[0]) / place.get_gridspec().ncols


def _nearest(lugs: Mapping[str, FloatArray]) -> float:
    """Smallest distance of two lugs from above [m]."""
    places = [TOP.project(lug) for lug in lugs.values()]
    return min((float(np.hypot(*(a - b))) for a, b in combinations(places, 2)), default=np.inf)


def _by_what_bears_them(recording: Recording, snap: Snapshot) -> dict[str, FloatArray]:
    """Mean place of the lugs of each equalizer, and of each hook with slings of its own."""
    rig = recording.rig
    groups: dict[str, list[FloatArray]] = {}
    for sling in rig.slings:
        if sling.name in snap.lugs:
            equalizer = rig.equalizer_of(sling)
            bears = equalizer.name if equalizer is not None else sling.from_body
            groups.setdefault(bears, []).append(snap.lugs[sling.name])
    return {name: np.mean(lugs, axis=0) for name, lugs in groups.items()}


def _densely(path: FloatArray) -> FloatArray:
    """Points all along a path on paper, shape (points, 2)."""
    share = np.linspace(0.0, 1.0, 40)[:, None, None]
    points: FloatArray = (path[:-1] + share * (path[1:] - path[:-1])).reshape(-1, 2)
    return points


def beside(
    place: FloatArray, half: float, taken: FloatArray, reach: float, paper: Sequence[tuple[float, float]]
) -> tuple[float, float]:
    """Where a label stands near a place on paper: as far off as it must for room, then where most room is.

    What is not `taken` between the limits of the paper, along and up, is room; beyond them there is none. A
    label reaches to `half` on either side of its middle.
    """
    places, rooms = np.empty((0, 2)), np.empty(0)
    least, most = (np.array(ends) for ends in zip(*paper, strict=True))
    along, upwards = np.ascontiguousarray(taken.T)
    for distance in (reach, 1.5 * reach, 2.0 * reach):
        places = place + distance * _AROUND
        # One place at a time: there are a hundred thousand points, and all at once would not fit the caches.
        rooms = np.sqrt(
            [np.min(np.maximum(np.abs(along - x) - half, 0.0) ** 2 + (upwards - y) ** 2) for x, y in places]
        )
        rooms = np.minimum(rooms, np.minimum(places - least, most - places).min(axis=1))
        if rooms.max() >= 0.8 * reach:
            break
    right, up = places[int(np.argmax(np.round(rooms, 6)))]
    return float(right), float(up)


def _label_sheaves(panel: Axes, snap: Snapshot, view: View, which: Equalizer) -> None:
    """Name slings with their tensions below their sheaves; of many those at the ends and in the middle."""
    tension = {rope.name: rope.tension for rope in snap.ropes}
    low = float(panel.get_ylim()[0])
    slings = dict(zip(which.moving_sheaves, which.slings, strict=False))
    if len(slings) > MOST_NAMED:
        every = list(slings.items())
        slings = dict([every[0], every[len(every) // 2], every[-1]])
    for sheave in snap.sheaves:
        if sheave.body not in slings:
            continue
        along = float(view.project(sheave.circle)[:-1, 0].mean())
        rope = slings[sheave.body]
        force = tension.get(rope, 0.0) / KILO
        panel.text(
            along,
            low,
            f"{rope.removeprefix('sling.')}\n{force:.0f} kN",
            fontsize=6.5,
            ha="center",
            va="bottom",
            color=INK,
            bbox={"facecolor": "white", "edgecolor": "none", "pad": 1.0},
            zorder=5,
        )
