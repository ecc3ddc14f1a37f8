"""The system at one moment, drawn into a panel as it is seen from somewhere."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import Normalize, to_rgb
from matplotlib.patheffects import Normal, Stroke

from gantline.plot.panels import EARTH_EDGE, TENSION
from gantline.plot.raster import View
from gantline.plot.scene import Box, RopePath, Sheave, Snapshot
from gantline.plot.style import INK, QUIET
from gantline.results.recording import Recording
from gantline.results.ropes.families import shortened_inside
from gantline.results.variable import FloatArray

_EDGE_ON = 1e-3  # cosine to the line of sight below which a triangle is a line
_LINES_REACH = 0.05  # of a panel's larger side: more than half the width of any line
_BEHIND = 2.0  # times as far from each other along the line of sight as across it: hooks hide each other
_SLACK_BELOW = 1e-3  # of the largest tension shown, or of that of the rope itself
_PLAIN = "#DDDDDD"
#: Colour of ropes that are slack.
SLACK = "#8A8A8A"
_FILL = {
    "load": "#C9D6E2",
    "frame": "#8FA3B5",
    "support": "#CFC6B8",
    "structure": "#E6E6E6",
    "hull": "#D5D2C8",
}
_EDGE = {
    "load": "#5B7286",
    "frame": "#4A5F73",
    "support": EARTH_EDGE,
    "structure": "#A3A3A3",
    "hull": "#6B665A",
}


SIDE = View(np.array([1.0, 0.0, 0.0]), np.array([0.0, 0.0, 1.0]), np.array([0.0, -1.0, 0.0]))
_SIDE_ALONG_Y = View(np.array([0.0, 1.0, 0.0]), np.array([0.0, 0.0, 1.0]), np.array([1.0, 0.0, 0.0]))
TOP = View(np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0]), np.array([0.0, 0.0, 1.0]))


def side_of(recording: Recording) -> View:
    """The side view of a lift: x to the right, or y where hooks stand behind each other, seen along y.

    Booms lie along x or turn, so that a lift with one is seen along y whatever its hooks do.
    """
    bodies = recording.coordinates.get("body", ())
    hooks = [hook.name for hook in recording.rig.hooks if hook.name in bodies]
    if len(hooks) < 2 or recording.rig.booms:
        return SIDE
    starts = np.array([recording.column("body_position", hook)[0, :2] for hook in hooks])
    wide, deep = np.ptp(starts, axis=0)
    return _SIDE_ALONG_Y if deep > _BEHIND * wide else SIDE


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
    boxes = (*snap.surroundings, *snap.boxes)
    seen = [box for box in boxes if _is_seen(view.project(box.faces).reshape(-1, 2), limits)]
    # One after the other, as they cover each other; those in a row that are drawn alike in one artist.
    for alike, row in groupby(seen, _drawn_as):
        if alike == "mesh":
            for box in row:
                if box.triangles is not None:
                    _draw_mesh(panel, box.triangles, view, _FILL.get(box.kind, _PLAIN))
        else:
            _draw_boxes(panel, list(row), view, is_frame=alike == "frame")
    for box in boxes:
        if box.name in snap.frame_origin:
            _draw_hanger(panel, box, snap.frame_origin[box.name], snap.frame_axes[box.name][:, 2], view)
    ropes = [(rope, view.project(rope.path)) for rope in snap.ropes]
    seen_ropes = [(rope, path) for rope, path in ropes if _is_seen(path, limits)]
    _draw_ropes(panel, seen_ropes, norm, 2.0 if large else 1.1)
    outlines = [(sheave, view.project(sheave.circle)) for sheave in snap.sheaves]
    _draw_sheaves(panel, [one for one in outlines if _is_seen(one[1], limits)], large=large)
    for name, point in snap.points.items():
        panel.plot(
            *view.project(point), marker="v" if name in snap.hooks else "s", color=INK, markersize=4, zorder=4
        )
    for name, point in snap.hinges.items():
        along, up = view.project(point)
        _draw_hinge(panel, shortened_inside(name), (float(along), float(up)))
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


def _drawn_as(box: Box) -> str:
    if box.triangles is not None:
        return "mesh"
    return "frame" if box.kind == "frame" else "box"


def _draw_boxes(panel: Axes, boxes: Sequence[Box], view: View, *, is_frame: bool) -> None:
    """The faces of boxes that look at the viewer, the first of them farthest behind."""
    outlines: list[FloatArray] = []
    fills: list[str] = []
    edges: list[str] = []
    for box in boxes:
        normals = np.cross(box.faces[:, 1] - box.faces[:, 0], box.faces[:, 2] - box.faces[:, 1])
        near = box.faces[normals @ view.toward > 1e-9 * np.linalg.norm(normals, axis=1)]
        outlines += list(view.project(near))
        fills += [_FILL.get(box.kind, _PLAIN)] * len(near)
        edges += [_EDGE.get(box.kind, QUIET)] * len(near)
    if is_frame:
        # What runs behind its face shows through, and its edges stand before that.
        panel.add_collection(
            PolyCollection(outlines, facecolors=fills, edgecolors="none", alpha=0.35, zorder=1)
        )
    panel.add_collection(
        PolyCollection(
            outlines,
            facecolors="none" if is_frame else fills,
            edgecolors=edges,
            linewidths=0.8,
            zorder=2.5 if is_frame else 1,
        )
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


def _draw_hinge(panel: Axes, name: str, place: tuple[float, float]) -> None:
    """A ring with a dot, as a pin is drawn, and its name below; a load's centre of gravity has a cross."""
    panel.plot(*place, "o", color="white", markeredgecolor=INK, markersize=6, markeredgewidth=1.3, zorder=4.2)
    panel.plot(*place, "o", color=INK, markersize=1.8, zorder=4.3)
    label = panel.annotate(
        name, place, (0, -6), textcoords="offset points", ha="center", va="top", fontsize=6.5, zorder=5
    )
    label.set_in_layout(False)
    label.set_path_effects([Stroke(linewidth=2.0, foreground="white"), Normal()])


def _draw_ropes(
    panel: Axes, ropes: Sequence[tuple[RopePath, FloatArray]], norm: Normalize, width: float
) -> None:
    """Ropes with their paths on paper; equalizing ropes before the sheaves, all others behind them."""
    for place, is_equalizing in ((3.0, False), (3.7, True)):
        here = [one for one in ropes if (one[0].kind == "equalizing") == is_equalizing]
        slack = [path for rope, path in here if _is_slack(rope, norm)]
        panel.add_collection(
            LineCollection(
                slack, colors=SLACK, linewidths=0.7 * width, linestyles=[(0, (3, 1.5))], zorder=place
            )
        )
        taut = [(rope, path) for rope, path in here if not _is_slack(rope, norm)]
        panel.add_collection(
            LineCollection(
                [path for _, path in taut],
                colors=[TENSION(norm(rope.tension)) for rope, _ in taut],
                linewidths=width,
                capstyle="round",
                zorder=place,
            )
        )


def _is_slack(rope: RopePath, norm: Normalize) -> bool:
    return rope.tension <= _SLACK_BELOW * min(float(norm.vmax or 1.0), rope.largest)


def _draw_sheaves(panel: Axes, sheaves: Sequence[tuple[Sheave, FloatArray]], *, large: bool) -> None:
    """Sheaves with their outlines on paper, those that move white."""
    edges = [INK if sheave.moves else "#4A5F73" for sheave, _ in sheaves]
    panel.add_collection(
        PolyCollection(
            [outline for _, outline in sheaves],
            facecolors=["white" if sheave.moves else "#B9C4CE" for sheave, _ in sheaves],
            edgecolors=edges,
            linewidths=1.1 if large else 0.6,
            zorder=3.5,
        )
    )
    if large:
        for (_, outline), edge in zip(sheaves, edges, strict=True):
            panel.plot(*outline[:-1].mean(axis=0), "o", color=edge, markersize=2.2, zorder=3.6)


def norm_of(shown: Sequence[tuple[str, Snapshot]]) -> Normalize:
    """From tensions [N] to the colour scale of all that is shown."""
    highest = max((rope.tension for _, snap in shown for rope in snap.ropes), default=0.0)
    return Normalize(0.0, highest if highest > 0.0 else 1.0)
