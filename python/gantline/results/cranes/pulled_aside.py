"""How far hooks are pulled aside that move as told, or up and down in guided falls: none of them leans."""

from __future__ import annotations

import numpy as np

from gantline.results import series
from gantline.results.gear import Hook
from gantline.results.recording import Recording
from gantline.results.variable import FloatArray

__all__ = ["hooks_that_stay", "pull_aside"]


def hooks_that_stay(recording: Recording) -> list[Hook]:
    """Hooks that no trolley and no boom takes along and that only slings pull at.

    What ropes and bodies of `mechanics` pull at a hook is not recorded by its direction.
    """
    carried = {hook.name for hook in recording.rig.carried_hooks}
    return [one for one in recording.rig.hooks if one.name not in carried and not one.bears_mechanics]


def pull_aside(recording: Recording, hook: Hook) -> FloatArray:
    """Level part of what all slings of a hook pull at it, by its equalizers too [N], shape (time,)."""
    rig = recording.rig
    level = np.zeros((len(recording.time), 2))
    for sling in rig.slings:
        if rig.hook_of(sling) == hook.name:
            along = series.sling_direction(recording, sling)[:, :2]
            level += series.sling_tension(recording, sling)[:, None] * along
    aside: FloatArray = np.linalg.norm(level, axis=1)
    return aside
