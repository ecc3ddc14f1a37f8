"""Names in pictures of the system, where ropes, edges and other names leave room."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patheffects import Normal, Stroke

from gantline.plot.drawing import TOP
from gantline.plot.raster import View
from gantline.plot.scene import Snapshot
from gantline.plot.style import INK, KILO, MOST_NAMED
from gantline.results.gear import Equalizer
from gantline.results.recording import Recording
from gantline.results.ropes.families import shortened_inside
from gantline.results.variable import FloatArray

__all__ = ["beside", "label_lugs", "label_sheaves"]

_CHARACTER = 0.055  # inches along of a character of a name
_MOST_LUGS = 10  # that are labelled one by one
_LUGS_APART = 0.1  # of the width of a panel: nearer to each other their names would touch
# Directions in which a label may stand, the preferred ones first.
_AROUND = np.array([(np.cos(a), np.sin(a)) for a in np.deg2rad([45, -45, 135, -135, *range(0, 360, 15)])])


def label_lugs(panel: Axes, recording: Recording, snap: Snapshot) -> None:
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
        name = shortened_inside(name)
        half = character * len(name) / 2
        paper = (panel.get_xlim(), panel.get_ylim())
        right, up = beside(TOP.project(lug), half, taken, 0.05 * width, paper)
        label = panel.text(right, up, name, fontsize=6.5, ha="center", va="center", zorder=5)
        label.set_in_layout(False)
        label.set_path_effects([Stroke(linewidth=2.0, foreground="white"), Normal()])
        taken = np.concatenate([taken, (right, up) + np.linspace(-half, half, 9)[:, None] * (1.0, 0.0)])


def label_sheaves(panel: Axes, snap: Snapshot, view: View, which: Equalizer) -> None:
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
            f"{shortened_inside(rope.removeprefix('sling.'))}\n{force:.0f} kN",
            fontsize=6.5,
            ha="center",
            va="bottom",
            color=INK,
            bbox={"facecolor": "white", "edgecolor": "none", "pad": 1.0},
            in_layout=False,
            zorder=5,
        )


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
        rooms = np.minimum(rooms, (np.minimum(places - least, most - places) - (half, 0.0)).min(axis=1))
        if rooms.max() >= 0.8 * reach:
            break
    right, up = places[int(np.argmax(np.round(rooms, 6)))]
    return float(right), float(up)


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
            gear = equalizer or rig.gear_above(sling)
            bears = sling.from_body if gear is None else gear.name
            groups.setdefault(bears, []).append(snap.lugs[sling.name])
    return {name: np.mean(lugs, axis=0) for name, lugs in groups.items()}


def _densely(path: FloatArray) -> FloatArray:
    """Points all along a path on paper, shape (points, 2)."""
    share = np.linspace(0.0, 1.0, 40)[:, None, None]
    points: FloatArray = (path[:-1] + share * (path[1:] - path[:-1])).reshape(-1, 2)
    return points
