"""A recording held against what it says itself when it is read, at one place for all that show recordings.

A file that was damaged, or changed by another program, is told by what is wrong in it and not found out in
the middle of a table. Only names, dimensions, types and attributes are looked at, the times of the samples
and what is of no sample: large columns cost nothing.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from gantline.results.file.form import FormError, hold_form
from gantline.results.file.layout import BY_RIG, COUNTED, DIMS, FIXED, OPTIONAL, hold_variable
from gantline.results.metrics import ENERGY_BOUNDS
from gantline.results.recording import Recording
from gantline.results.refinement import Refinement
from gantline.results.rig import Rig
from gantline.results.scene import hold_scene

__all__ = ["hold_recording"]


@dataclass(frozen=True)
class _Integrator:
    type: str
    step: float | None = None
    tension_tolerance: float | None = None
    position_tolerance: float | None = None


@dataclass(frozen=True)
class _Settings:
    integrator: _Integrator


@dataclass(frozen=True)
class _Failure:
    time: float
    element: str
    cause: str


#: Forms of attributes, and whether a recording has to have them.
_ATTRIBUTES: dict[str, tuple[Any, bool]] = {
    "rig": (Rig, True),
    "settings": (_Settings, True),
    "status": (str, True),
    "warnings": (Sequence[str] | None, False),
    "counters": (Mapping[str, int] | None, False),
    "energy_remainder": (float | None, False),
    "failure": (_Failure | None, False),
    "refinement": (Refinement | None, False),
}


def hold_recording(recording: Recording) -> None:
    """Hold a recording against its rig, its names and its samples.

    Raises:
        FormError: At the first thing that is missing, or that is not what it should be.
    """
    for name, variable in recording.variables.items():
        hold_variable(name, variable.dims, variable.values.dtype)
    _hold_attributes(recording)
    _hold_time(recording)
    _hold_events_and_peaks(recording)
    _hold_names(recording)
    for name in DIMS:
        if name not in recording and name not in OPTIONAL and _is_due(recording, name):
            raise FormError(f"variable '{name}' is missing")


def _hold_attributes(recording: Recording) -> None:
    given = recording.attributes
    for name, (form, is_needed) in _ATTRIBUTES.items():
        if name in given:
            hold_form(given[name], form, f"attribute {name}")
        elif is_needed:
            raise FormError(f"attribute '{name}' is missing")
    method = given["settings"]["integrator"]["type"]
    if method not in ENERGY_BOUNDS:
        known = ", ".join(ENERGY_BOUNDS)
        raise FormError(f"attribute settings.integrator.type is {method!r:.40}; expected one of {known}")
    for name, limit in given["rig"].get("limits", {}).items():
        form = str if name == "rule" else float
        hold_form(limit, form | None, f"attribute rig.limits.{name}")
    if given.get("scene") is not None:
        hold_scene(given["scene"], "attribute scene")


def _hold_time(recording: Recording) -> None:
    if "time" not in recording:
        raise FormError("variable 'time' is missing")
    # Also false where a time is no number.
    if not bool(np.all(np.diff(recording.time) >= 0.0) and np.all(np.isfinite(recording.time))):
        raise FormError("variable 'time' has values that do not rise; expected the times of the samples")


def _hold_events_and_peaks(recording: Recording) -> None:
    """What is of no sample: a gap there is a gap in all that is told of it."""
    for name, variable in recording.variables.items():
        if "time" in variable.dims or variable.is_text or np.isfinite(variable.values).all():
            continue
        raise FormError(f"variable '{name}' has a value that is no number")


def _hold_names(recording: Recording) -> None:
    """Every dimension has its names, and what the rig speaks of is among them."""
    used = {dim for name in recording if name in DIMS for dim in DIMS[name]} - COUNTED
    for dim in sorted(used - set(recording.coordinates)):
        raise FormError(f"the names '{dim}' are missing")
    for dim, labels in FIXED.items():
        if dim in used and recording.coordinates[dim] != labels:
            raise FormError(
                f"the names '{dim}' are {', '.join(recording.coordinates[dim])}; expected {', '.join(labels)}"
            )
    if not len(recording.time):
        return
    for dim, names_of in BY_RIG.items():
        known = set(recording.coordinates.get(dim, ()))
        absent = next((name for name in names_of(recording.rig) if name not in known), None)
        if absent is None or (dim == "energy_kind" and not known):
            continue
        if not known:
            raise FormError(f"the names '{dim}' are missing, and what belongs to them")
        raise FormError(f"the names '{dim}' lack '{absent}' of the rig")
    drawn = set(recording["rope_of_point"].values.tolist()) if "rope_of_point" in recording else set()
    undrawn = sorted(set(BY_RIG["rope"](recording.rig)) - drawn)
    if undrawn and drawn:
        raise FormError(f"variable 'rope_of_point' lacks '{undrawn[0]}' of the rig")


def _is_due(recording: Recording, name: str) -> bool:
    """Whether a recording with its names and samples has to have a variable."""
    dims = [dim for dim in DIMS[name] if dim not in FIXED]
    if "time" in dims and not len(recording.time):
        return False
    if "event" in dims:
        return "event" in recording.sizes
    return all(recording.sizes.get(dim, 0) for dim in dims)
