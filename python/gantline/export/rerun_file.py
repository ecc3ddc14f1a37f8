"""A recorded lift for the Rerun viewer (`.rrd`), by its package `rerun-sdk`, which is optional.

Bodies are entities below `world`, with their shapes about the centre of gravity and their poses over the
timeline `lift`; ropes are strips of the recorded paths, coloured by tension; the curves of the report are
scalars below `curves`.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from gantline.arguments import path_of
from gantline.export.surroundings import surroundings
from gantline.replacing import replaced
from gantline.results.recording import Recording, recorded
from gantline.results.solids import solid_of
from gantline.results.variable import FloatArray
from gantline.viewer.curves import curves
from gantline.viewer.decimate import Places, peaks
from gantline.viewer.frames import frames
from gantline.viewer.shapes import vector

_MOST_FRAMES = 600
_BUCKETS = 500  # of a curve
_TIMELINE = "lift"
_GREY, _LIGHT = [150, 165, 180], [200, 200, 195]
#: Colours from no tension to the largest, red green blue.
_RAMP = np.array([[107, 173, 214], [51, 115, 184], [122, 82, 163], [204, 69, 107], [230, 102, 26]])


class RerunMissing(ValueError):
    """The package is not installed; the message is a plain sentence."""


def write_rerun(recording: Recording, path: str | Path) -> Path:
    """Write a recording for the Rerun viewer.

    Args:
        recording: A recording with at least one sample.
        path: File to write.

    Returns:
        The path written.

    Raises:
        RerunMissing: If the package is not installed.
        ValueError: If there is nothing to show.
        OSError: If it cannot be written there.
    """
    recorded(recording)
    try:
        import rerun
    except ImportError:
        raise RerunMissing(
            "a .rrd file needs the package rerun-sdk, which is not installed ('pip install rerun-sdk');"
            " .glb needs nothing"
        ) from None
    if not len(recording.time):
        raise ValueError("this recording has nothing to show")
    target = path_of(path, "a file to write")
    # The package only warns where a file cannot be written.
    with replaced(target) as trial:
        _write(rerun, recording, trial)
    return target


def _write(rerun: Any, recording: Recording, path: Path) -> None:
    stream = rerun.RecordingStream(
        "gantline", recording_id=recording.rig.title or "lift", send_properties=False
    )
    stream.save(path)
    at = frames(recording, _MOST_FRAMES)
    stream.log("world", rerun.ViewCoordinates.RIGHT_HAND_Z_UP, static=True)
    _bodies(rerun, stream, recording, at)
    _surroundings(rerun, stream, recording, at)
    _ropes(rerun, stream, recording, at)
    for curve in curves(recording):
        kept = peaks(curve.values, _BUCKETS)
        kept = kept[np.isfinite(curve.values[kept])]
        rerun.send_columns(
            _path(rerun, "curves", curve.group, curve.name),
            [rerun.TimeColumn(_TIMELINE, duration=recording.time[kept])],
            rerun.Scalars.columns(scalars=curve.values[kept] * curve.factor),
            recording=stream,
        )
    stream.flush()
    stream.disconnect()


def _path(rerun: Any, *parts: str) -> str:
    """Of an entity; names may hold whatever they like."""
    return "/".join(rerun.escape_entity_path_part(part) for part in parts)


def _bodies(rerun: Any, stream: Any, recording: Recording, at: Places) -> None:
    scene: Mapping[str, Any] = recording.attributes.get("scene") or {}
    names = recording.coordinates.get("body", ())
    for entry in scene.get("bodies") or ():
        name = str(entry["name"])
        if name not in names:
            continue
        path = _path(rerun, "world", name)
        solid = solid_of(entry.get("shape"))
        if solid is not None:
            centre = np.asarray(vector(entry.get("centre_of_gravity")))
            mesh = rerun.Mesh3D(
                vertex_positions=solid[0] - centre, triangle_indices=solid[1], albedo_factor=_GREY
            )
            stream.log(path, mesh, static=True)
        turn = recording.column("body_orientation", name)[at][:, [1, 2, 3, 0]]
        rerun.send_columns(
            path,
            [rerun.TimeColumn(_TIMELINE, duration=recording.time[at])],
            rerun.Transform3D.columns(
                translation=recording.column("body_position", name)[at], quaternion=turn
            ),
            recording=stream,
        )


def _surroundings(rerun: Any, stream: Any, recording: Recording, at: Places) -> None:
    times = recording.time[at]
    for one in surroundings(recording, at):
        path = _path(rerun, "world", "surroundings", one.name)
        mesh = rerun.Mesh3D(vertex_positions=one.vertices, triangle_indices=one.faces, albedo_factor=_LIGHT)
        if one.size is None:
            stream.log(path, mesh, static=True)
            continue
        stream.set_time(_TIMELINE, duration=float(times[0]))
        stream.log(path, mesh)
        if not one.size.all():
            stream.set_time(_TIMELINE, duration=float(times[int(np.argmin(one.size))]))
            stream.log(path, rerun.Clear(recursive=False))


def _ropes(rerun: Any, stream: Any, recording: Recording, at: Places) -> None:
    if "rope_point" not in recording:
        return
    places = recording.points_of_ropes
    tension = recording["rope_tension"].values
    largest = max(float(tension.max()), 1.0)
    times = recording.time[at]
    for place, name in enumerate(recording.coordinates["rope"]):
        if len(places.get(name, ())) < 2:
            continue
        points = recording["rope_point"].values[np.ix_(at, places[name])]
        rerun.send_columns(
            _path(rerun, "world", "ropes", name),
            [rerun.TimeColumn(_TIMELINE, duration=times)],
            rerun.LineStrips3D.columns(strips=list(points), colors=_colours(tension[at, place] / largest)),
            recording=stream,
        )


def _colours(share: FloatArray) -> Any:
    """Colours of shares of the largest tension, red green blue, shape (n, 3)."""
    places = np.clip(share, 0.0, 1.0) * (len(_RAMP) - 1)
    channels = [np.interp(places, np.arange(len(_RAMP)), channel) for channel in _RAMP.T]
    return np.column_stack(channels).round().astype(np.uint8)
