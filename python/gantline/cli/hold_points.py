"""What the steps of a plan report at their ends."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Protocol

import numpy as np

from gantline.checks.gauges import Gauge, winch_gauges
from gantline.checks.readings import OUTSIDE, HookReading, hook_readings
from gantline.checks.readings import hold_points as held
from gantline.checks.run import AS_IT_SWINGS
from gantline.cli.table import ABSENT, pairs, show, table
from gantline.results import progress, series
from gantline.results.recording import Recording
from gantline.results.rig import Step

#: What stands in the table of hooks.
_OF_HOOKS = ("hook_load", "hoist_load", "crane_radius")

#: Share of the most of a hold by which its end is less where that is told.
_TOLD = 0.25

#: What the share of a chart that is checked has more than what hangs at a hold point, where it is more.
_CHECKED = (
    "  (as checked: with the design weight and the factors of the rules; of a crane that lifts alone",
    "    the most that hung still in it in the whole lift, over what is rated at the hold point)",
)

#: Of a measure that nothing of a lift has; and of one of hooks that hang in falls, where no hook does.
_NOTHING = "nothing in this lift has one"
_OF_FALLS = ("hook_height", "falls_out_of_plumb", "load_swing")
_NO_FALLS = "known of hooks under trolleys and booms; those of this lift stay over their places"

#: Of a measure its variable, unit and digits, and of each thing that has it its name there.
_Source = tuple[str, str, int, dict[str, str]]


class _Named(Protocol):
    @property
    def name(self) -> str: ...


def hold_points(recording: Recording) -> list[str]:
    """What is read off at the end of every step that holds or reports, and what hooks and jacks pull."""
    lines: list[str] = []
    gauges = winch_gauges(recording)
    by = recording.rig.growing
    is_more = False
    moment = f", as {' and '.join(by)} have it then" if by else ""
    for point in held(recording):
        sample = int(np.argmax(point.at))
        readings = hook_readings(recording, point.at)
        # The table of hooks has it beside all that belongs to it.
        shown = {*_OF_HOOKS} if readings else set()
        shown |= {"hook_height"} if any(one.height is not None for one in readings) else set()
        asked = [measure for measure in point.step.report if measure not in shown]
        span = _hold(recording, point.step, sample)
        measured = {measure: ", ".join(_measure(recording, measure, sample, span)) for measure in asked}
        rows = [
            (measure.replace("_", " "), text or _nothing(recording, measure))
            for measure, text in measured.items()
        ]
        if rows or readings or gauges or point.step.report:
            lines += pairs(f"At the end of '{point.step.step}', {show(point.time, 's', 2)}{moment}", rows)
            lines += _hooks(readings)
            lines += _gauges(gauges, sample)
            is_more |= any(one.is_checked_for_more for one in readings)
    return [*lines, *(_CHECKED if is_more else ())]


def _nothing(recording: Recording, measure: str) -> str:
    """What is said of a measure that nothing of a lift has."""
    return _NO_FALLS if measure in _OF_FALLS and recording.rig.hooks else _NOTHING


def _hooks(readings: list[HookReading]) -> list[str]:
    """A table of what hangs in hooks, and of what charts say to that."""
    columns = [
        ("hook load", [show(one.hook_load, "kN", 1) for one in readings]),
        ("of all hooks", [show(one.share, "%", 1) for one in readings]),
        ("hoist load", [show(one.hoist_load, "kN", 1) for one in readings]),
        ("level", [show(one.height, "m", 2) for one in readings]),
        ("radius", [show(one.radius, "m", 2) for one in readings]),
        ("rated there", [_rated(one) for one in readings]),
        ("used then", [show(one.used_then, "%", 1) for one in readings]),
        ("as checked", [show(one.used, "%", 1) for one in readings]),
    ]
    kept = [(head, cells) for head, cells in columns if any(cell != ABSENT for cell in cells)]
    rows = list(zip([one.name for one in readings], *(cells for _, cells in kept), strict=True))
    lines = table(("Hook", *(head for head, _ in kept)), rows, "l" + "r" * len(kept)) if rows else []
    return [f"  {line}" for line in lines]


def _gauges(gauges: list[Gauge], sample: int) -> list[str]:
    """A table of what winches and jacks pull at a sample."""
    rows = [(one.name, show(float(one.reads[sample]), "kN", 1)) for one in gauges]
    return [f"  {line}" for line in (table(("Winch or jack", "pull"), rows, "lr") if rows else ())]


def _rated(reading: HookReading) -> str:
    return OUTSIDE if reading.is_outside else show(reading.rated, "kN", 1)


def _hold(recording: Recording, step: Step, last: int) -> slice:
    """Samples of a hold up to its last one, or that alone of another step."""
    span = progress.spans(recording).get(step.step)
    if step.kind != "hold" or recording.is_equilibrium or span is None:
        return slice(last, last + 1)
    return slice(min(last, int(np.searchsorted(recording.time, span[0]))), last + 1)


def _measure(recording: Recording, measure: str, sample: int, span: slice) -> Iterator[str]:
    """Values of a measure that a step reports, at a sample; of what swings also the most of its hold."""
    sources = _sources(recording, sample)
    if measure not in sources:
        yield "not known here"
        return
    variable, unit, digits, names = sources[measure]
    idle = _idle_supports(recording, sample, list(names.values())) if measure == "support_force" else set()
    for name, label in names.items():
        if label in idle:
            continue
        if label:
            values = recording.column(variable, label)
            last, most = float(values[sample]), float(values[span].max())
            swings = measure in ("load_swing", *AS_IT_SWINGS) and most > last + _TOLD * most
            beside = f" (up to {show(most, unit, digits)} in this hold)" if swings else ""
            yield f"{name} {show(last, unit, digits)}{beside}"
    if idle:
        yield f"{'all' if len(idle) == len(names) else 'the other'} {len(idle)} {show(0.0, unit, digits)}"
    if measure == "support_force":
        yield from _beside_supports(recording, sample, digits)


def _idle_supports(recording: Recording, sample: int, supports: list[str]) -> set[str]:
    """Supports that bear nothing at a sample, if there are several: of stools most do before a set-down."""
    idle = {one for one in supports if recording.column("contact_force", one)[sample] == 0.0}
    return idle if len(idle) > 1 else set()


def _sources(recording: Recording, sample: int) -> dict[str, _Source]:
    """Of each measure where its values are, at a sample."""
    rig = recording.rig
    loads, hooks, carried = _own(rig.loads), _own(rig.hooks), _own(rig.carried_hooks)
    at_booms = {hook.name: hook.name for boom in rig.booms for hook in boom.hooks}
    slings = {one.name: one.rope for one in rig.slings if series.is_on(recording, one.rope)[sample]}
    equalizing = {one.name: one.equalizing_rope for one in rig.equalizers}
    sheaves = {name: name for one in rig.equalizers for name in one.moving_sheaves}
    supports = {one.name.removeprefix("support."): one.name for one in rig.supports}
    corners = {name: name for crane in rig.cranes for name in crane.corners}
    ends = {name: name for crane in rig.crawlers for name in crane.corners}
    afloat = _own(rig.vessels)
    return {
        "sling_tension": ("rope_tension", "kN", 1, slings),
        "equalizing_rope_tension": ("rope_tension", "kN", 1, equalizing),
        "equalizer_travel": ("sheave_travel", "m", 3, sheaves),
        "rod_out": ("rod_out", "m", 3, _own(rig.compensators)),
        "hinge_force": ("hinge_force", "kN", 1, _own(rig.hinges)),
        "hook_load": ("hook_load", "kN", 1, hooks),
        "hoist_load": ("hoist_load", "kN", 1, hooks),
        "load_tilt": ("load_tilt", "deg", 2, loads),
        "load_transferred": ("load_transferred", "%", 1, loads),
        "load_swing": ("load_swing", "m", 3, loads if carried else {}),
        "support_force": ("contact_force", "kN", 0, supports),
        "hook_height": ("hook_height", "m", 3, carried),
        "falls_out_of_plumb": ("falls_out_of_plumb", "deg", 3, carried),
        "off_lead": ("off_lead", "deg", 3, at_booms),
        "side_lead": ("side_lead", "deg", 3, at_booms),
        "crane_radius": ("crane_radius", "m", 2, at_booms),
        "boom_angle": ("boom_angle", "deg", 2, _own(rig.booms)),
        "luffing_pull": ("luffing_pull", "kN", 0, _own(boom for boom in rig.booms if boom.ropes)),
        "corner_load": ("corner_load", "kN", 0, corners),
        "ground_pressure": ("ground_pressure", "kPa", 1, ends),
        "tipping_utilisation": ("tipping_utilisation", "%", 1, _own(rig.crawlers)),
        "draft": ("vessel_draft", "m", 3, afloat),
        "heel": ("vessel_heel", "deg", 2, afloat),
        "trim": ("vessel_trim", "deg", 2, afloat),
        "freeboard": ("vessel_freeboard", "m", 2, afloat),
    }


def _own(ones: Iterable[_Named]) -> dict[str, str]:
    """Things that recordings have under the names by which they are shown."""
    return {one.name: one.name for one in ones}


def _beside_supports(recording: Recording, sample: int, digits: int) -> Iterator[str]:
    """What ground or a deck carries of each load at a sample; beside supports only where it does."""
    supports = {one.name for one in recording.rig.supports}
    for load in recording.rig.loads:
        others = [contact for contact in load.contacts if contact not in supports]
        force = sum(float(recording.column("contact_force", contact)[sample]) for contact in others)
        if others and (force > 0.0 or not supports):
            yield f"under {load.name} {show(force, 'kN', digits)}"
