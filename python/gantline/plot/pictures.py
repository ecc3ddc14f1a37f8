"""Which pictures a recording gets, and writing them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from functools import partial
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from PIL.Image import Image, fromarray

from gantline.arguments import needed, path_of
from gantline.plot import by_equalizer, traces, views
from gantline.plot.comparison import comparison_figures, comparison_names
from gantline.plot.energy import energy
from gantline.plot.style import RC
from gantline.plot.vessels import vessels
from gantline.replacing import replaced
from gantline.results.comparison import Comparison
from gantline.results.recording import Recording, recorded

#: Every kind of picture by its file name; those that a lift does not have give None.
PICTURES: dict[str, Callable[[Recording], Figure | None]] = {
    "sling_tension": traces.sling_tension,
    "slings_by_equalizer": by_equalizer.slings,
    "equalizing_rope_tension": traces.equalizing_rope_tension,
    "rope_tension": traces.rope_tension,
    "sheave_travel": traces.sheave_travel,
    "rod_out": traces.rod_out,
    "sling_lengthening": traces.sling_lengthening,
    "attitude": traces.attitude,
    "vessels": vessels,
    "motion": traces.motion,
    "hook_load": traces.hook_load,
    "energy": energy,
    "system": views.system,
    "stages": views.stages,
}


def figures(recording: Recording) -> Iterator[tuple[str, Figure]]:
    """Make the pictures that a recording can have, one at a time.

    Args:
        recording: Any recording; one with fewer than two samples has no pictures.

    Yields:
        Name of a picture (a file name without suffix) and its figure.
    """
    if len(recorded(recording).time) < 2:
        return
    makers = dict(PICTURES)
    for equalizer in recording.rig.equalizers:
        makers[_of_equalizer(equalizer.name)] = partial(views.equalizer, which=equalizer)
    for name, make in makers.items():
        with matplotlib.rc_context(RC):
            figure = make(recording)
        if figure is not None:
            yield name, figure


def picture_files(equalizers: Iterable[str]) -> list[str]:
    """Names of all files that pictures of a recording with these equalizers may have."""
    return [f"{name}.png" for name in (*PICTURES, *map(_of_equalizer, equalizers))]


def _of_equalizer(name: str) -> str:
    """Name of the picture of an equalizer."""
    return f"equalizer_{name}"


def save_pictures(recording: Recording, directory: str | Path) -> list[Path]:
    """Write the pictures of a recording as PNG files.

    Args:
        recording: Any recording.
        directory: Folder to write into; it must exist.

    Returns:
        Paths of the files.

    Raises:
        OSError: If they cannot be written there.
    """
    return write_pictures(figures(recording), directory)


def comparison_picture_files(loads: Iterable[str]) -> list[str]:
    """Names of all files that pictures of a comparison of lifts with these loads may have."""
    return [f"{name}.png" for name in comparison_names(loads)]


def save_comparison_pictures(comparison: Comparison, directory: str | Path) -> list[Path]:
    """Write the pictures of a comparison as PNG files.

    Args:
        comparison: Of any two recordings.
        directory: Folder to write into; it must exist.

    Returns:
        Paths of the files; none where the recordings have no time in common.

    Raises:
        OSError: If they cannot be written there.
    """
    needed(comparison, Comparison, "a comparison", "gantline.compare makes one of two recordings")
    return write_pictures(comparison_figures(comparison), directory)


def write_pictures(pictures: Iterable[tuple[str, Figure]], directory: str | Path) -> list[Path]:
    """Write figures as PNG files of their names, each at once: first under another name, then renamed."""
    folder, paths = path_of(directory, "a folder to write into"), []
    for name, figure in pictures:
        path = folder / f"{name}.png"
        picture = _drawn(figure)
        with replaced(path) as trial:
            picture.save(trial, format="png")
        paths.append(path)
    return paths


def _drawn(figure: Figure) -> Image:
    """A figure as an image. `savefig` walks through all of it once more, to lay it out before it draws it."""
    with matplotlib.rc_context(RC):
        figure.set_dpi(matplotlib.rcParams["savefig.dpi"])
        canvas: Any = FigureCanvasAgg(figure)  # has no types
        canvas.draw()
    return fromarray(np.asarray(canvas.buffer_rgba())).convert("RGB")
