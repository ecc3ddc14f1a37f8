"""Pictures of one moment, and films: the lift from the side and from above beside its tensions."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import matplotlib
import numpy as np
import numpy.typing as npt
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from gantline.plot import drawing, panels
from gantline.plot.scene import snapshot
from gantline.plot.style import INK, QUIET, RC, colour, force_unit, shortened
from gantline.results import series
from gantline.results.progress import under_way
from gantline.results.recording import Recording
from gantline.results.ropes.families import families
from gantline.results.surroundings import ground_of, water_level
from gantline.results.variable import FloatArray

Image = npt.NDArray[np.uint8]

_SIZE = (12.8, 7.2)  # inch
_LOOKS = 9  # samples over the whole lift that the views must hold
_MOST_NAMED = 8  # curves that have names; of more, families have


class Film:
    """A recording as pictures of 16 by 9 at any of its samples, all to one scale.

    Args:
        recording: A recording with something to draw.
        width: Of a picture [pixels].

    Raises:
        ValueError: If there is nothing to draw.
    """

    _windows: dict[Axes, FloatArray]

    def __init__(self, recording: Recording, width: int = 1280) -> None:
        if not len(recording.time):
            raise ValueError("this recording has no samples to draw")
        self._recording = recording
        looks = np.unique(np.linspace(0, len(recording.time) - 1, _LOOKS).round().astype(int))
        shown = [("", snapshot(recording, int(look))) for look in looks]
        if not any(snap.ropes or snap.boxes for _, snap in shown):
            raise ValueError("this recording has nothing to draw")
        self._norm = drawing.norm_of(shown)
        self._view = drawing.side_of(recording)
        self._lift = np.concatenate([snap.extent() for _, snap in shown])
        self._ground = ground_of(recording)
        with matplotlib.rc_context(RC):
            self._figure = Figure(figsize=_SIZE, dpi=width / _SIZE[0])
            self._side, self._top, trace = self._panels()
            self._cursor = self._trace(trace)
            panels.tension_bar(self._figure, [self._side], self._norm, pad=0.05)
            for panel, window in self._windows.items():
                panels.bare(panel, _filled(panel, window))
            # What no moment changes is drawn once, and each picture begins with that.
            for moving in self._moving():
                moving.set_animated(True)
            canvas: Any = FigureCanvasAgg(self._figure)  # has no types
            canvas.draw()
            self._canvas, self._backdrop = canvas, canvas.copy_from_bbox(self._figure.bbox)

    def picture(self, sample: int) -> Image:
        """The lift at a sample, red, green and blue of each pixel, shape (rows, columns, 3)."""
        recording = self._recording
        snap = snapshot(recording, sample)
        with matplotlib.rc_context(RC):
            for panel, view in ((self._side, self._view), (self._top, drawing.TOP)):
                # All of the moment before; to clear a panel would make its frame anew as well.
                for artist in (*panel.lines, *panel.collections, *panel.patches, *panel.texts, *panel.images):
                    artist.remove()
                drawing.draw(panel, snap, view, self._norm)
            if self._ground is not None:
                panels.draw_ground(self._side, self._ground, self._lift, self._view.axis)
                panels.draw_holes(self._top, self._ground, water_level(recording))
            panels.draw_water(self._side, recording, self._lift, snap.time, self._view.axis)
            panels.scale_bar(self._side)
            self._caption.set_text(self._said(snap.time))
            self._cursor.set_xdata([snap.time, snap.time])
            self._canvas.restore_region(self._backdrop)
            for moving in self._moving():
                self._figure.draw_artist(moving)
        pixels: Image = np.array(self._canvas.buffer_rgba())[..., :3]
        return pixels

    def _moving(self) -> tuple[Artist, ...]:
        """What each moment draws anew, in this order."""
        return self._side, self._top, self._caption, self._cursor

    def frames(self, speed: float, rate: float) -> Iterator[Image]:
        """Pictures from the start to the end.

        Args:
            speed: Simulated seconds in a second of the film.
            rate: Pictures in a second of the film.
        """
        time = self._recording.time
        for moment in moments_of(time, speed, rate):
            yield self.picture(int(np.argmin(np.abs(time - moment))))

    def _panels(self) -> tuple[Axes, Axes, Axes]:
        extent = self._lift
        if self._ground is not None:
            extent = np.concatenate([extent, self._ground.near(extent)])
        figure = self._figure
        title = self._recording.rig.title or self._recording.title
        figure.text(0.02, 0.955, shortened(title, 80), fontsize=14, fontweight="bold", color=INK)
        self._caption = figure.text(0.02, 0.915, "", fontsize=11, color=QUIET)
        grid = figure.add_gridspec(
            2,
            2,
            width_ratios=[1.5, 1.0],
            left=0.02,
            right=0.985,
            top=0.89,
            bottom=0.075,
            hspace=0.16,
            wspace=0.15,
        )
        side, top = figure.add_subplot(grid[:, 0]), figure.add_subplot(grid[0, 1])
        self._windows = {
            side: panels.window_of(self._view.project(extent), below=0.8),
            top: panels.window_of(drawing.TOP.project(extent)),
        }
        return side, top, figure.add_subplot(grid[1, 1])

    def _trace(self, panel: Axes) -> matplotlib.lines.Line2D:
        """Tensions of slings, or of all ropes in a lift without, and the cursor over them."""
        recording = self._recording
        slings = {sling.name: series.sling_tension(recording, sling) for sling in recording.rig.slings}
        ropes = recording.coordinates.get("rope", ())
        curves = slings or {name: recording.column("rope_tension", name) for name in ropes}
        scale, unit = force_unit(max((float(one.max()) for one in curves.values()), default=1.0))
        has_names = len(curves) <= _MOST_NAMED
        of = {sling.name: sling.rope for sling in recording.rig.slings} or {name: name for name in ropes}
        family = families(recording.rig, list(of.values()))
        known = list(dict.fromkeys(family.values()))
        for index, (name, values) in enumerate(curves.items()):
            if has_names:
                panel.plot(recording.time, values / scale, color=colour(index), linewidth=1.3, label=name)
            else:
                shade = colour(known.index(family[of[name]]))
                panel.plot(recording.time, values / scale, color=shade, linewidth=0.7, alpha=0.7)
        panel.set_xlabel("Time [s]")
        panel.set_ylabel(f"{'Sling' if slings else 'Rope'} tension [{unit}]")
        panel.set_xlim(float(recording.time[0]), max(float(recording.time[-1]), 1e-9))
        panel.set_ylim(bottom=0.0)
        if has_names and curves:
            panel.legend(fontsize=7, ncols=4, loc="lower right", frameon=False)
        elif len(known) > 1:
            keys = [Line2D([], [], color=colour(index), linewidth=2.0) for index in range(len(known))]
            panel.legend(keys, known, fontsize=7, ncols=2, loc="lower right", frameon=False)
        return panel.axvline(float(recording.time[0]), color=INK, linewidth=1.2)

    def _said(self, time: float) -> str:
        step = under_way(self._recording, time)
        return f"{time:.2f} s" + (f"   {shortened(step, 40)}" if step else "")


def moments_of(time: FloatArray, speed: float, rate: float) -> FloatArray:
    """Times of the pictures of a film from the first to the last sample [s]."""
    count = int((time[-1] - time[0]) / speed * rate) + 1
    moments: FloatArray = np.minimum(time[0] + np.arange(count) * speed / rate, time[-1])
    return moments


def _filled(panel: Axes, window: FloatArray) -> FloatArray:
    """A window made as wide or as high as its panel has room for."""
    room = panel.get_position()
    ratio = room.width * _SIZE[0] / (room.height * _SIZE[1])
    wide, high = np.ptp(window, axis=1)
    more = np.maximum([high * ratio - wide, wide / ratio - high], 0.0) / 2
    filled: FloatArray = window + np.outer(more, [-1.0, 1.0])
    return filled
