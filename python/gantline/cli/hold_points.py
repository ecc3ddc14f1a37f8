"""What the steps of a plan report at their ends."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from gantline.cli.table import pairs, show
from gantline.results.recording import Recording


def hold_points(recording: Recording) -> list[str]:
    """A table for every step that reports something and has ended."""
    from gantline.checks import end_of_step

    lines: list[str] = []
    for step in recording.rig.plan:
        at = end_of_step(recording, step.step) if step.report else None
        if at is None:
            continue
        sample = int(np.argmax(at))
        measured = {measure: ", ".join(_measure(recording, measure, sample)) for measure in step.report}
        rows = [(measure.replace("_", " "), text) for measure, text in measured.items() if text]
        lines += pairs(f"At the end of '{step.step}', {show(float(recording.time[sample]), 's', 2)}", rows)
    return lines


def _measure(recording: Recording, measure: str, sample: int) -> Iterator[str]:
    """Values of a measure that a step reports, at one sample."""
    rig = recording.rig
    hooks = {hook.name: hook.name for hook in rig.carried_hooks}
    at_booms = {hook.name: hook.name for boom in rig.booms for hook in boom.hooks}
    sources: dict[str, tuple[str, str, int, dict[str, str]]] = {
        "sling_tension": ("rope_tension", "kN", 1, {sling.name: sling.rope for sling in rig.slings}),
        "equalizing_rope_tension": (
            "rope_tension",
            "kN",
            1,
            {e.name: e.equalizing_rope for e in rig.equalizers},
        ),
        "equalizer_travel": (
            "sheave_travel",
            "m",
            3,
            {s: s for e in rig.equalizers for s in e.moving_sheaves},
        ),
        "hook_load": ("hook_load", "kN", 1, {hook.name: hook.name for hook in rig.hooks}),
        "hoist_load": ("hoist_load", "kN", 1, {hook.name: hook.name for hook in rig.hooks}),
        "load_tilt": ("load_tilt", "deg", 2, {load.name: load.name for load in rig.loads}),
        "load_transferred": ("load_transferred", "%", 1, {load.name: load.name for load in rig.loads}),
        "load_swing": ("load_swing", "m", 3, {load.name: load.name for load in rig.loads if hooks}),
        "hook_height": ("hook_height", "m", 3, hooks),
        "falls_out_of_plumb": ("falls_out_of_plumb", "deg", 3, hooks),
        "off_lead": ("off_lead", "deg", 3, at_booms),
        "side_lead": ("side_lead", "deg", 3, at_booms),
        "crane_radius": ("crane_radius", "m", 2, at_booms),
        "boom_angle": ("boom_angle", "deg", 2, {boom.name: boom.name for boom in rig.booms}),
        "luffing_pull": ("luffing_pull", "kN", 0, {boom.name: boom.name for boom in rig.booms if boom.ropes}),
        "corner_load": (
            "corner_load",
            "kN",
            0,
            {name: name for crane in rig.cranes for name in crane.corners},
        ),
        "ground_pressure": (
            "ground_pressure",
            "kPa",
            1,
            {name: name for crane in rig.crawlers for name in crane.corners},
        ),
        "tipping_utilisation": (
            "tipping_utilisation",
            "%",
            1,
            {crane.name: crane.name for crane in rig.crawlers},
        ),
    }
    afloat = {vessel.name: vessel.name for vessel in rig.vessels}
    of_vessels = (("draft", "m", 3), ("heel", "deg", 2), ("trim", "deg", 2), ("freeboard", "m", 2))
    sources |= {name: (f"vessel_{name}", unit, digits, afloat) for name, unit, digits in of_vessels}
    if measure not in sources:
        yield "not known here"
        return
    variable, unit, digits, names = sources[measure]
    for name, label in names.items():
        if label:
            yield f"{name} {show(float(recording.column(variable, label)[sample]), unit, digits)}"
