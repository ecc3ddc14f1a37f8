"""Whether loads that are set down stay there, and what to do about one that meets its deck hard."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

import numpy as np

from gantline.checks.check import Check, Verdict
from gantline.results import progress, series
from gantline.results.loads.lift_off import hangs_from_the_start
from gantline.results.loads.upending import TURNED_FROM
from gantline.results.recording import Recording
from gantline.results.rig import Load
from gantline.results.ropes.parting import PARTING
from gantline.results.rotation import tilt
from gantline.results.variable import FloatArray
from gantline.units import format_quantity

__all__ = ["beside_supports", "leans", "picked_up", "what_helps"]

#: A load that has hung clear for so long was not just coming off; one that does bounces for less [s].
_HUNG = 5.0
#: In waves the deck comes up to it for longer, a wave or two after it came off, while it is hoisted [s].
_HUNG_IN_WAVES = 15.0
#: One that is clear for less after it has been set down bounces on what it stands on [s].
_BOUNCES = 0.5
#: One that is lowered on past what it met comes lower than this there [m].
_LOWER = 0.1
#: What stands on springs, or on beams that are not quite level, tilts less as its slings go slack [rad].
_TILTS = math.radians(0.5)
#: Steps that set a load down, and that leave it where it is.
_LOWERS, _LEAVES = ("lower", "pay_out"), ("hold",)
#: Steps that no load that stands is raised by: what is pumped may turn it over.
_LETS_STAND = {*_LOWERS, *_LEAVES, "pump"}
#: What drops a load that comes down within a few seconds of it [s], and what helps or tells more.
_DROPS = 5.0
_DROPPED: Final = {
    "pin_pulled": "pins are pulled at {time:.2f} s, and it drops by what they held: pull them as it stands",
    "cut": "{name} is cut at {time:.2f} s, and it drops: see 'rope_parted'",
    "broken": "{name} breaks at {time:.2f} s, and it drops: see 'rope_parted'",
    "detached": "{name} is taken off at {time:.2f} s, and it drops: take it off slack",
    "hinge_opened": "{name} opens at {time:.2f} s, and it drops: open it with nothing on it",
}
#: What helps against that, and what besides where there are waves.
_MORE_SLACK = "pay out more slack, as soon as it stands"
_OF_WAVES = ", compensate heave until its slings are off, or wait for less sea"


@dataclass(frozen=True)
class _Clear:
    """A time in which a load hung clear.

    Attributes:
        begin: When it came clear, or the run began [s].
        end: When it met something, or the run ended [s].
        came_off: Whether it stood before.
        landed: When a step had set it down before; None if none had, or another has hoisted it since.
    """

    begin: float
    end: float
    came_off: bool
    landed: float | None


def picked_up(recording: Recording) -> list[Check]:
    """A warning for each load that a step sets down, and that comes clear again while none raises it."""
    checks = []
    for load in recording.rig.loads:
        again = [
            one
            for one in _clear(recording, load)
            if one.landed is not None
            and one.end - one.begin >= _BOUNCES
            and not _is_lowered_past(recording, load, one)
        ]
        if not again:
            continue
        first, longest = again[0], max(one.end - one.begin for one in again)
        steps = _steps_at(recording, first.begin)
        where = f" in '{progress.BESIDE.join(steps)}'" if steps else ""
        times = "once" if len(again) == 1 else f"{len(again)} times"
        said = f"set down at {first.landed:.2f} s, it is picked up again{where}"
        said = f"{said}, {times}, for {longest:.1f} s at most"
        remark = f"{said}: {_MORE_SLACK}{_OF_WAVES if recording.rig.is_in_waves else ''}"
        meaning = "loads that are set down stay there until a step raises them"
        checks.append(
            Check(
                "stays_set_down",
                Verdict.WARNING,
                meaning,
                element=load.name,
                time=first.begin,
                remark=remark,
            )
        )
    return checks


def leans(recording: Recording) -> list[Check]:
    """A warning for each load that stands, tilts then, and ends leaning in its slings.

    With its centre of gravity beyond the edge of what it stands on it turns about that edge, as far as its
    hooks let it: a force of few percent of its weight holds it so, which no limit tells. It tilts as it is
    lowered on after it was set down, or as its tanks are filled. Loads in hinges or water, and those that are
    turned on purpose, are left out.
    """
    checks = []
    for load in recording.rig.loads:
        down = _stands_for_good(recording, load)
        is_held = load.in_water is not None or any(hinge.load == load.name for hinge in recording.rig.hinges)
        if down is None or is_held or not series.ends_partly_lifted(recording, load):
            continue
        tilts = recording.column("load_tilt", load.name)
        since = float(tilts[-1]) - _at(recording, tilts, down)
        if since <= _TILTS + _vessels_tilt(recording, down) or tilts.max() > TURNED_FROM:
            continue
        share = float(recording.column("load_transferred", load.name)[-1])
        stands = f"set down at {down:.2f} s" if down > 0.0 else "standing from the start"
        said = f"{stands}, it has tilted by {format_quantity(since, 'deg', 2)} more since"
        hangs = f"{format_quantity(share, '%', 1)} of its weight still hangs in its slings"
        remark = (
            f"{said}, and {hangs}: it turns about the edge of what is below, and tips over as they are let "
            "off; set it down with its centre of gravity well within what bears it"
            f"{', with what is in its tanks' if load.tanks else ''}"
        )
        meaning = "loads that are set down stand without their slings"
        checks.append(
            Check("stands_by_itself", Verdict.WARNING, meaning, element=load.name, time=down, remark=remark)
        )
    return checks


def beside_supports(recording: Recording) -> list[Check]:
    """A warning for each group of supports on which a load that steps set down has never stood.

    Who has built it meant the load to come down there. One that was taken away before is left out.
    """
    checks = []
    removed = {name for _, _, name in recording.events("support_removed")}
    for load in recording.rig.loads:
        down = _stands_for_good(recording, load)
        if not down:
            continue  # it hangs, or has stood from the start
        groups: dict[str, list[str]] = {}
        for support in recording.rig.supports:
            if support.name in load.contacts and support.removed_at is None:
                groups.setdefault(support.group, []).append(support.name)
        forces = {
            group: np.stack([recording.column("contact_force", name) for name in names])
            for group, names in groups.items()
            if group and removed.isdisjoint(names)
        }
        below = [group for group, force in forces.items() if force[:, -1].any()]
        place = [format_quantity(one, "m", 2) for one in recording.column("body_position", load.body)[-1]]
        for group, force in forces.items():
            if force.any():
                continue
            stands = f"it stands on {' and '.join(below)}" if below else "it stands on something else"
            said = f"set down at {down:.2f} s, {stands}, and {group} bears nothing all along"
            at = f"its centre of gravity is at x {place[0]}, y {place[1]} and z {place[2]} then"
            meaning = "loads come to the supports that are there for them"
            remark = f"{said}: {at}; see places, heading and level of {group}, and what brings the load there"
            checks.append(
                Check(
                    "comes_to_supports", Verdict.WARNING, meaning, element=load.name, time=down, remark=remark
                )
            )
    return checks


def _stands_for_good(recording: Recording, load: Load) -> float | None:
    """Since when a load stands that nothing but lowering moves from then on [s]; None of others.

    From the start, or since a step that lowers has set it down.
    """
    kinds = {step.step: step.acts_as for step in recording.rig.plan}
    downs = [time for time, _, name in recording.events("set_down") if name == load.name]
    if not len(recording.time):  # before a run
        return None
    down = downs[-1] if downs else 0.0
    if downs and not any(kinds.get(step) in _LOWERS for step in _steps_at(recording, down)):
        return None
    if not downs and hangs_from_the_start(recording, load):
        return None
    if recording.is_equilibrium:
        # What of its plan is over it does not say; its first sample is the start.
        stood = not series.load_is_clear(recording, load)[0]
        return down if stood and set(kinds.values()) <= _LETS_STAND else None
    later = [kinds.get(step) for step, (_, end) in progress.spans(recording).items() if end > down]
    return down if set(later) <= _LETS_STAND else None


def _vessels_tilt(recording: Recording, since: float) -> float:
    """The most that a vessel, on which a load may stand, has heeled and trimmed since a time [rad]."""
    tilts = [tilt(recording.column("body_orientation", one.body)) for one in recording.rig.vessels]
    return max((abs(float(one[-1]) - _at(recording, one, since)) for one in tilts), default=0.0)


def _at(recording: Recording, values: FloatArray, time: float) -> float:
    return float(np.interp(time, recording.time, values))


def what_helps(recording: Recording, load: Load, time: float) -> str:
    """What helps a load that meets what is below it hard at a time [s], by what the plan does then."""
    kinds = {step.step: step.acts_as for step in recording.rig.plan}
    clear = _clear(recording, load)
    hung = next((one for one in clear if one.end == time), None)
    if hung is not None and hung.landed is not None:
        return "it had been set down, and was picked up again"
    if (dropped := _dropped(recording, 0.0 if hung is None else hung.begin, time)) is not None:
        return dropped
    doing = {kinds.get(step) for step in _steps_at(recording, time)}
    if doing - {"hoist", "hold"}:
        return "creep, or a brake before it, is usual"
    if hung is not None and (came_down := _came_down(clear, hung)) is not None:
        return f"it came down at {came_down:.2f} s, and bounces"
    just = _HUNG_IN_WAVES if recording.rig.is_in_waves and "hoist" in doing else _HUNG
    if hung is not None and hung.came_off and hung.end - hung.begin < just:
        less = ", or wait for less sea" if recording.rig.is_in_waves else ""
        if not less and recording.rig.wind is not None:
            less = ", or wait for less wind"
        return f"it had just lifted off; hoist it off faster{less}"
    return "no step lowers it then; keep it farther away"


def _dropped(recording: Recording, begin: float, end: float) -> str | None:
    """What let a load go that had hung clear since a time and meets something at another [s], in words."""
    since = max(begin, end - _DROPS)
    events = [(time, kind, name) for time, kind, name in recording.events() if since <= time < end]
    slings = {sling.rope for sling in recording.rig.slings}
    for time, kind, name in reversed(events):
        if kind in PARTING and (name not in slings or not _carried(recording, name, time)):
            continue  # it held nothing up
        if kind in _DROPPED:
            return _DROPPED[kind].format(name=name, time=time)
    return None


def _carried(recording: Recording, rope: str, time: float) -> bool:
    """Whether a rope carries at the last sample before a time [s]."""
    before = max(int(np.searchsorted(recording.time, time, side="left")) - 1, 0)
    return bool(series.is_carrying(recording.column("rope_tension", rope))[before])


def _came_down(clear: list[_Clear], bounce: _Clear) -> float | None:
    """When a load came down that had hung, and bounces since [s]; None of one that has just lifted off."""
    later = bounce
    for one in reversed(clear[: clear.index(bounce)]):
        if later.begin - one.end >= _HUNG:
            return None
        if one.end - one.begin >= _HUNG:
            return one.end
        later = one
    return None


def _is_lowered_past(recording: Recording, load: Load, one: _Clear) -> bool:
    """Whether a load that met something on its way down is lowered on beside it, and hangs lower since.

    In waves it may as well have been picked up from a deck that sinks.
    """
    kinds = {step.step: step.acts_as for step in recording.rig.plan}
    if recording.rig.is_in_waves or not any(
        kinds.get(step) in _LOWERS for step in _steps_at(recording, one.begin)
    ):
        return False
    height = recording.column("body_position", load.body)[:, 2]
    began, ended = np.interp((one.begin, one.end), recording.time, height)
    return bool(began - ended > _LOWER)


def _clear(recording: Recording, load: Load) -> list[_Clear]:
    """Each time in which a load hung clear, in order."""
    removed = [one.removed_at for one in recording.rig.supports if one.removed_at is not None]
    kinds = {step.step: step.acts_as for step in recording.rig.plan}
    begins = [(begin, kinds.get(step)) for step, (begin, _) in progress.spans(recording).items()]
    raised = removed + [begin for begin, kind in begins if kind not in (*_LOWERS, *_LEAVES)]
    spans: list[_Clear] = []
    since = 0.0 if hangs_from_the_start(recording, load) else None
    came_off, landed = False, None
    last = float(recording.time[-1]) if len(recording.time) else 0.0
    events = [(time, kind) for time, kind, name in recording.events() if name == load.name]
    for time, kind in [*events, (last, "end")]:
        if kind == "lift_off":
            since, came_off = time, True
            if landed is not None and any(landed < moment <= time for moment in raised):
                landed = None
        elif since is not None and kind in ("set_down", "end"):
            spans.append(_Clear(since, time, came_off, landed))
            steps = _steps_at(recording, time)
            is_lowered = any(kinds.get(step) in _LOWERS for step in steps)
            if kind == "set_down" and landed is None and is_lowered and time - since >= _HUNG:
                landed = time
            since = None
    return spans


def _steps_at(recording: Recording, time: float) -> list[str]:
    return [step for step, (begin, end) in progress.spans(recording).items() if begin < time <= end]
