"""A recording packed for a browser: a small header of names, and the numbers in one piece.

Curves keep their peaks; poses and paths are kept at frames, as many as fit. The paths are the recorded ones,
which are the solver's, to half a micrometre.
"""

from __future__ import annotations

import base64
import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from gantline.results import series
from gantline.results.ending import ending_of
from gantline.results.file.gaps import gap
from gantline.results.loads.clearances import watched_span
from gantline.results.loads.hinges import HINGE_OPENED
from gantline.results.loads.lift_off import lift_off_time
from gantline.results.progress import stretches
from gantline.results.recording import Recording
from gantline.results.rig import Watch
from gantline.results.ropes.upper_end import utilisation
from gantline.results.status import OVER
from gantline.results.surroundings import ground_of, structures_of, water_level
from gantline.results.variable import FloatArray
from gantline.viewer.arrays import Arrays
from gantline.viewer.curves import curves
from gantline.viewer.decimate import Places, faithful, peaks, with_gaps
from gantline.viewer.frames import frames
from gantline.viewer.shapes import packed_shape, vector
from gantline.viewer.turning import natural_lengths, sheave_angles

#: Numbers that all frames together may have, and points that all curves together may have.
_FRAME_NUMBERS = 4_000_000
_CURVE_POINTS = 400_000
_MOST_FRAMES = 1500
#: How far a curve may be off, of its range, where a page reads it between samples that it has [1]: a quarter
#: of a pixel of a plot of 1000. Where that takes too many points, the worst places come first.
_CURVE_OFF = 2.5e-4
_MICROMETRE = 1e-6
_TURN = 1e-7


@dataclass(frozen=True)
class Packed:
    """A recording for a browser.

    Attributes:
        header: Names, shapes, events, and where each array is in the data; JSON.
        data: The arrays, compressed by zlib.
    """

    header: dict[str, Any]
    data: bytes

    def header_text(self) -> str:
        """The header as JSON text."""
        return json.dumps(self.header, allow_nan=False, separators=(",", ":"))

    def data_text(self) -> str:
        """The numbers as base64 text."""
        return base64.b64encode(self.data).decode("ascii")


def pack(recording: Recording, *, since: int = 0) -> Packed:
    """Pack a recording for a browser.

    Args:
        recording: Any recording.
        since: First sample that is packed, of a page that has those before it.

    Raises:
        ValueError: If its scene is none that can be drawn.
    """
    arrays = Arrays()
    scene: Mapping[str, Any] = recording.attributes.get("scene") or {}
    bodies = _bodies(recording, scene, arrays)
    sheaves = [entry for entry in scene.get("sheaves") or () if entry["body"] in bodies]
    whole = _frames(recording, len(bodies), len(sheaves))
    at = whole[whole >= since]
    arrays.plain("time", recording.time[since:], "f8")
    arrays.plain("frames", at - since, "u4")
    _motion(recording, at, bodies, arrays)
    poses = {name: np.asarray(body["cog"]) for name, body in bodies.items()}
    turned = sheave_angles(recording, list(whole), sheaves, poses)[whole >= since]
    arrays.steps("sheave_angle", turned, 1e-4)
    lift_off = lift_off_time(recording) if len(recording.time) else None
    header = {
        "format": 1,
        "title": recording.rig.title or recording.title,
        "samples": len(recording.time),
        "liftOff": lift_off,
        "bodies": list(bodies.values()),
        "sheaves": [_sheave(entry, list(bodies)) for entry in sheaves],
        "ropes": _ropes(recording, scene, whole),
        "lugs": _lugs(recording, list(bodies)),
        "contacts": _contacts(recording, scene, list(bodies), at, arrays),
        "hinges": _hinges(recording, list(bodies)),
        "pairs": _pairs(recording, at, arrays),
        **_surroundings(recording, arrays),
        "events": [list(event) for event in recording.events()],
        "steps": [{"names": one.names, "begin": one.begin, "end": one.end} for one in stretches(recording)],
        **_ending(recording),
        "strokes": _strokes(recording),
        "curves": _curves(recording, since, arrays),
        "arrays": arrays.index,
    }
    return Packed(header, arrays.packed())


def _frames(recording: Recording, bodies: int, sheaves: int) -> Places:
    numbers = 3 * recording.sizes.get("rope_point", 0) + 7 * bodies + sheaves
    return frames(recording, int(np.clip(_FRAME_NUMBERS // max(numbers, 1), 100, _MOST_FRAMES)))


def _bodies(recording: Recording, scene: Mapping[str, Any], arrays: Arrays) -> dict[str, dict[str, Any]]:
    names = recording.coordinates.get("body", ())
    found: dict[str, dict[str, Any]] = {}
    for place, entry in enumerate(one for one in scene.get("bodies") or () if one["name"] in names):
        if not entry.get("shape") and entry["name"] in recording.rig.seen_by_their_parts:
            continue
        found[entry["name"]] = {
            "name": entry["name"],
            "kind": str(entry.get("kind", "body")),
            "shape": packed_shape(entry.get("shape"), f"shape{place}", arrays),
            "cog": vector(entry.get("centre_of_gravity")),
        }
    return found


def _motion(recording: Recording, at: Places, bodies: Mapping[str, Any], arrays: Arrays) -> None:
    names = list(recording.coordinates.get("body", ()))
    columns = [names.index(name) for name in bodies]
    empty = np.zeros((len(at), 0, 3))
    for name, variable, step in (
        ("position", "body_position", _MICROMETRE),
        ("turn", "body_orientation", _TURN),
    ):
        values = _drawn(recording, variable, at)[:, columns] if variable in recording else empty
        arrays.steps(name, values, step)
    paths = _drawn(recording, "rope_point", at) if "rope_point" in recording else empty
    arrays.steps("path", paths, _MICROMETRE)


def _drawn(recording: Recording, variable: str, at: Places) -> FloatArray:
    """Places at the frames, which a drawing cannot do without."""
    missing = gap(recording, variable)
    if missing is not None:
        raise ValueError(f"{missing}; the lift cannot be drawn")
    return np.asarray(recording[variable].values[at])


def _sheave(entry: Mapping[str, Any], bodies: Sequence[str]) -> dict[str, Any]:
    return {
        "body": bodies.index(entry["body"]),
        "centre": vector(entry["centre"]),
        "axis": vector(entry["axis"]),
        "radius": float(entry["radius"]),
        "moves": entry.get("kind") == "moving",
    }


def _ropes(recording: Recording, scene: Mapping[str, Any], at: Places) -> list[dict[str, Any]]:
    names = recording.coordinates.get("rope", ())
    if not names:
        return []
    kinds = {entry["name"]: str(entry.get("kind", "rope")) for entry in scene.get("ropes") or ()}
    kinds |= dict.fromkeys(recording.rig.outer_ropes, "outer")
    labels = {sling.rope: sling.name for sling in recording.rig.slings}
    found = []
    for name, length in zip(names, natural_lengths(recording, list(at)), strict=True):
        points = recording.points_of_ropes.get(name, np.empty(0, dtype=np.int64))
        known = recording.rig.rope(name)
        peak, when = series.rope_peak(recording, name)
        found.append(
            {
                "name": name,
                "label": labels.get(name, name),
                "kind": kinds.get(name, "rope"),
                "first": int(points[0]) if len(points) else 0,
                "count": len(points),
                "diameter": (known.diameter if known is not None else None) or 0.0,
                "length": length,
                "used": utilisation(recording, name),
                "peak": peak,
                "peakTime": when,
            }
        )
    return found


def _lugs(recording: Recording, bodies: Sequence[str]) -> list[dict[str, Any]]:
    """Lugs of loads and spreaders that a sling is made fast to."""
    found = []
    for sling in recording.rig.slings:
        for _, of, name in sling.at_lugs():
            holder = recording.rig.with_lugs(of)
            lug = None if holder is None else holder.lugs.get(name)
            if holder is None or lug is None or holder.body not in bodies:
                continue
            found.append(
                {
                    "name": name,
                    "rope": sling.rope,
                    "body": bodies.index(holder.body),
                    "at": vector(lug.at),
                    "normal": vector(lug.main_plate_normal, (0.0, 1.0, 0.0)),
                }
            )
    return found


def _hinges(recording: Recording, bodies: Sequence[str]) -> list[dict[str, Any]]:
    """Hinges of loads, by the body that turns in each about its own y, and when they open."""
    opened = {name: time for time, _, name in recording.events(HINGE_OPENED)}
    return [
        {"body": bodies.index(hinge.name), "openedAt": opened.get(hinge.name)}
        for hinge in recording.rig.hinges
        if hinge.name in bodies
    ]


def _contacts(
    recording: Recording, scene: Mapping[str, Any], bodies: Sequence[str], at: Places, arrays: Arrays
) -> list[dict[str, Any]]:
    """Contact points whose place the scene knows, and their forces at the frames."""
    names = list(recording.coordinates.get("contact", ()))
    known = [one for one in scene.get("contacts") or () if one["name"] in names and one.get("body") in bodies]
    columns = [names.index(one["name"]) for one in known]
    if "contact_force" in recording:
        arrays.plain("contact_force", recording["contact_force"].values[at][:, columns], "f4")
    return [
        {"name": one["name"], "body": bodies.index(one["body"]), "at": vector(one["at"])} for one in known
    ]


def _pairs(recording: Recording, at: Places, arrays: Arrays) -> list[dict[str, Any]]:
    """Watched pairs whose nearest points are recorded, and these points at the frames."""
    if "clearance_point" not in recording:
        return []
    points = recording["clearance_point"].values[at]
    arrays.steps("clearance_point", points, _MICROMETRE)
    watches = {watch.name: watch for watch in recording.rig.watches}
    return [
        _pair(recording, watches.get(name) or Watch(name)) for name in recording.coordinates.get("pair", ())
    ]


def _pair(recording: Recording, watch: Watch) -> dict[str, Any]:
    """What a pair has to keep, and from when to when where that is not all the time."""
    pair: dict[str, Any] = {"name": watch.name, "smallest": watch.smallest}
    if watch.from_step or watch.to_step:
        last = float(recording.time[-1]) if len(recording.time) else 0.0
        begin, end = watched_span(watch, recording.events())
        # A span that ends before it begins: none of it has come yet.
        pair["span"] = [max(begin, 0.0), min(end, last)] if begin <= last else [1.0, 0.0]
    return pair


def _surroundings(recording: Recording, arrays: Arrays) -> dict[str, Any]:
    """Levels of ground and water, waves, holes, and what stands there; when supports are taken away."""
    ground, sea = ground_of(recording), recording.rig.sea
    waves = () if sea is None else sea.components
    arrays.plain(
        "waves",
        [(one["frequency"], *one["wave_number"], one["amplitude"], one["phase"]) for one in waves],
        "f8",
    )
    holes = () if ground is None else ground.holes
    return {
        "ground": None if ground is None else ground.level,
        "holes": [{"x": list(one.x), "y": list(one.y), "floor": one.floor} for one in holes],
        "water": water_level(recording),
        "riseTime": None if sea is None else sea.rise_time,
        "structures": [
            {"name": one.name, "kind": one.kind, "boxes": one.boxes.tolist(), "removedAt": one.removed_at}
            for one in structures_of(recording)
        ],
    }


def _ending(recording: Recording) -> dict[str, Any]:
    """Where in its plan a run has ended, in words, and whether it could not go on; None if it came through.

    Of one that is still running nothing says where it will end.
    """
    ending = ending_of(recording)
    if ending is None or recording.attributes.get("status") not in OVER:
        return {"unfinished": None, "failed": False}
    return {"unfinished": ending.in_short, "failed": ending.how == "failed"}


def _strokes(recording: Recording) -> dict[str, list[float | None]]:
    """Stroke up and down of each moving sheave [m]; None where it has no end."""
    return {
        sheave: [equalizer.travel_up, equalizer.travel_down]
        for equalizer in recording.rig.equalizers
        for sheave in equalizer.moving_sheaves
    }


def _curves(recording: Recording, since: int, arrays: Arrays) -> list[dict[str, Any]]:
    if not len(recording.time):
        return []
    every = list(curves(recording))
    buckets = int(np.clip(_CURVE_POINTS // (4 * max(len(every), 1)), 100, 500))
    # A distance to ropes that have parted is without end, which nobody can draw.
    values = [np.where(np.isfinite(one.values), one.values, np.nan)[since:] for one in every]
    time, share = recording.time[since:], _CURVE_POINTS // max(len(every), 1)
    places = [faithful(time, one, peaks(one, buckets), _CURVE_OFF, share) for one in values]
    # What others leave of their share is for those that it was too small for.
    short = [number for number, at in enumerate(places) if len(at) >= share]
    left = max(0, _CURVE_POINTS - sum(map(len, places)))
    for number in short:
        most = len(places[number]) + left // len(short)
        places[number] = faithful(time, values[number], places[number], _CURVE_OFF, most)
    # A distance ends where those ropes do, a spread where the load stands again.
    places = [with_gaps(one, at, goes_on=since > 0) for one, at in zip(values, places, strict=True)]
    bounds = np.concatenate([[0], np.cumsum([len(one) for one in places])])
    arrays.plain("curve_sample", np.concatenate(places) if places else [], "u4")
    kept = [one[at] * curve.factor for curve, one, at in zip(every, values, places, strict=True)]
    arrays.plain("curve_value", np.concatenate(kept) if kept else [], "f4")
    return [
        {
            "group": curve.group,
            "name": curve.name,
            "label": curve.label,
            "unit": curve.unit,
            "first": int(first),
            "count": int(last - first),
            "family": curve.family,
            "peak": None if curve.peak is None else [curve.peak[0] * curve.factor, curve.peak[1]],
        }
        for curve, first, last in zip(every, bounds[:-1], bounds[1:], strict=True)
    ]
