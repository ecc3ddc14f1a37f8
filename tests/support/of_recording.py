"""What tests ask recordings for by name: a check, all checks of a name, the end of a step."""

from __future__ import annotations

from gantline.checks import Check, check_recording
from gantline.results.recording import Recording


def check_of(recording: Recording, name: str) -> Check:
    """The check of this name, of a recording that has one."""
    return next(one for one in check_recording(recording) if one.name == name)


def checks_of(recording: Recording, name: str) -> list[Check]:
    """All checks of this name: none, one, or one for each element and step that has it."""
    return [one for one in check_recording(recording) if one.name == name]


def step_end(recording: Recording, step: str) -> float:
    """When a step ends [s], which does so once."""
    (end,) = (time for time, _, name in recording.events("step_end") if name == step)
    return end
