"""Whether the plan can be carried out by the hooks, drums, trolleys, cranes and booms there are."""

from __future__ import annotations

from gantline.scenario.afloat.tanks import bodies_afloat
from gantline.scenario.consistency.booms import check_luffing
from gantline.scenario.consistency.heave import check_heave
from gantline.scenario.consistency.lead import check_lead
from gantline.scenario.consistency.pumps import check_contents, check_pump, check_shares
from gantline.scenario.consistency.travel import check_travel, said
from gantline.scenario.cranes.boom import FloatingCrane
from gantline.scenario.cranes.hooks import full_name
from gantline.scenario.errors import nearest
from gantline.scenario.findings import Findings, Path
from gantline.scenario.model import Scenario
from gantline.scenario.plan.condition import Condition
from gantline.scenario.plan.lead import LeadStep
from gantline.scenario.plan.leading import movers_of_lead
from gantline.scenario.plan.movers import Mover, movers
from gantline.scenario.plan.plan_time import earliest_begins
from gantline.scenario.plan.steps import (
    DrumStep,
    HoldStep,
    HookStep,
    LowerStep,
    MovingStep,
    PayOutStep,
    PumpStep,
)
from gantline.scenario.tag_line import tag_rope

__all__ = ["check_plan", "place_of_step"]

_ROUNDING = 1 + 1e-9
#: What can be moved, and what it does, in the words of messages.
_WORDS = {
    "hook": ("hook", "hoist", "hoist"),
    "drum": ("drum", "turn", "drive"),
    "trolley": ("trolley", "traverse", "traverse"),
    "crane": ("crane that travels", "travel", "travel"),
    "boom": ("crane with 'luffing'", "luff", "luffing"),
    "upper": ("crane with 'slewing'", "slew", "slewing"),
    "line": ("mooring or tag line", "move", "winch"),
}


def check_plan(findings: Findings) -> None:
    """Note everything that is wrong with the plan."""
    plan = findings.scenario.plan
    _check_names(findings)
    earliest = began = 0.0
    begins = earliest_begins(plan)
    busy: set[str] = set()  # what the steps that go on side by side move
    for place, step in enumerate(plan):
        check_heave(findings, place, step)
        if isinstance(step, HoldStep):
            if step.hold == "until_end" and place + 1 < len(plan):
                sentence = "'until_end' stands before other steps, which would never begin"
                findings.add(("plan", place, "hold"), f"{sentence}; only the last step holds until the end")
            if step.until is not None:
                _check_condition(findings, place, step)
            busy = set()
            continue
        aside = step.starts == "with_previous"
        if aside and place == 0:
            sentence = "there is no step before the first; leave 'starts' out"
            findings.add(("plan", place, "starts"), sentence)
        if isinstance(step, PumpStep):
            moved = check_pump(findings, place, step)
        elif isinstance(step, LeadStep):
            moved = check_lead(findings, place, step)
        else:
            moved = _check_moved(findings, place, step)
        busy = busy if aside else set()
        for name in moved & busy:
            sentence = f"'{name}' is moved by two steps at once"
            right = "leave 'starts: with_previous' out, or move it in one of them"
            if step.start_at is not None:
                right += "; what stops and goes on has a step for each part of its way, and what goes on "
                right += "beside it has its way in the same parts"
            findings.add(("plan", place, step.verb), f"{sentence}; {right}")
        busy |= moved
        began, latest = _check_times(findings, place, step, began if aside else earliest, begins[place])
        earliest = max(earliest, latest)
        if step.until is not None:
            _check_condition(findings, place, step)
    check_travel(findings)
    check_luffing(findings)
    if not findings.problems:
        check_contents(findings)
        check_shares(findings)
    _check_emergency_stop(findings)


def place_of_step(findings: Findings, path: Path, name: str) -> int | None:
    """Which step of the plan, from 0, a name means; None, with a note, where it means none."""
    steps = [step.step for step in findings.scenario.plan]
    if name in steps:
        return steps.index(name)
    findings.add(path, f"'{name}' is not a step of the plan; {nearest(name, steps)}")
    return None


def _check_names(findings: Findings) -> None:
    """Events say which step they are of by its name: requirements, readings and times are found by it."""
    steps = [step.step for step in findings.scenario.plan]
    for place, name in enumerate(steps):
        if name in steps[:place]:
            sentence = f"'{name}' is the name of plan[{steps.index(name) + 1}] already"
            number = 2
            while f"{name} {number}" in steps:
                number += 1
            right = f"results are told by step, so each has its own, such as '{name} {number}'"
            findings.add(("plan", place, "step"), f"{sentence}; {right}")


def _of_sling(scenario: Scenario, step: MovingStep, text: str) -> str | None:
    """What is to be said of a sling that this step cannot move; None of anything else."""
    name = text.removeprefix("sling.")
    sling = (scenario.slings or {}).get(name)
    if sling is None:
        return None
    if step.kind == "line":
        sentence = f"sling '{name}' has no 'chain_hoist' that could move it; give it one, such as "
        return sentence + "'chain_hoist: {speed: 1 m/min, rated_capacity: 20 t}'"
    if sling.chain_hoist is None:
        return None
    return f"'{text}' is a sling; 'haul' shortens it by its chain hoist, and 'veer' lengthens it"


def _of_drum(scenario: Scenario, step: MovingStep, text: str) -> str | None:
    """What is to be said of a drum of `mechanics` that is moved as a hook or line; None of anything else."""
    mechanics = scenario.mechanics
    if step.kind not in ("hook", "line") or text not in ((mechanics and mechanics.drums) or {}):
        return None
    return f"'{text}' is a drum of 'mechanics'; 'haul_in' winds its rope up, and 'pay_out' lets it out"


def _of_hook(scenario: Scenario, step: MovingStep, text: str) -> str | None:
    """What is to be said of a hook that is moved as a drum or line; None of anything else."""
    if step.kind not in ("drum", "line") or full_name(text, scenario.hooks) is None:
        return None
    return f"'{text}' is a hook; 'hoist' raises it, and 'lower' lets it down"


def _check_moved(findings: Findings, place: int, step: MovingStep) -> set[str]:
    """Each step moves what there is, once, and not faster than its hoist or drive can."""
    what, can, drive = _WORDS[step.kind]
    known = movers(findings.scenario, step.kind)
    lines = findings.scenario.tag_lines or {}
    tuggers = [tag_rope(name) for name, line in lines.items() if line.pull is not None]
    moved: list[str] = []
    for text in step.moved:
        name = full_name(text, known)
        if name is None:
            has_hoists = any(one is not None and one.kind == "sling" for one in known.values())
            nor = ", nor a sling with a 'chain_hoist'" if has_hoists else ""
            sentence = f"'{text}' is not a {what}{nor}; {nearest(text, known)}"
            crane = (findings.scenario.cranes or {}).get(text)
            if step.kind == "upper" and isinstance(crane, FloatingCrane):
                missing = "'slewing'" if crane.slewing_axis else "'slewing_axis' and 'slewing'"
                sentence = f"the boom of '{text}' does not slew: it has no {missing}"
                sentence += "; 'haul' and 'veer' of mooring lines take its vessel along"
            if step.kind in ("hook", "drum") and full_name(text, movers(findings.scenario, "line")):
                sentence += "; 'haul' shortens a line by its winch, and 'veer' lets it out"
            of_others = (of(findings.scenario, step, text) for of in (_of_sling, _of_drum, _of_hook))
            findings.add(("plan", place, step.verb), next(filter(None, of_others), sentence))
            continue
        one = known[name]
        moved.append(name if one is None else one.name)
        if one is None:
            if name in tuggers:
                sentence = f"'{name}' hauls and gives way by itself, to keep its 'pull'"
                right = "a line with a 'length' or 'pretension' and a 'winch' is moved by steps"
                findings.add(("plan", place, step.verb), f"{sentence}; {right}")
                continue
            sentence = f"{what} '{name}' has no '{drive}' that could {can} it"
            right = f"'{drive}: {{speed: 30 m/min, acceleration: 0.1 m/s^2}}'"
            findings.add(("plan", place, step.verb), f"{sentence}; give it one, such as {right}")
            continue
        if step.emergency_stop_at is not None:
            _check_stop(findings, ("plan", place, "emergency_stop_at"), one, drive)
        if step.speed > one.speed * _ROUNDING:
            sentence = f"{said(step.kind, step.speed, 'speed')} is faster than '{name}' can {can}"
            right = f"its highest speed is {said(step.kind, one.speed, 'speed')}"
            findings.add(("plan", place, "speed"), f"{sentence}; {right}")
        if step.acceleration is not None and step.acceleration > one.acceleration * _ROUNDING:
            sentence = f"{said(step.kind, step.acceleration, 'acceleration')} is more than '{name}' can do"
            right = f"its most is {said(step.kind, one.acceleration, 'acceleration')}"
            findings.add(("plan", place, "acceleration"), f"{sentence}; {right}")
    if len(set(moved)) < len(moved):
        short = what.partition(" ")[0]
        if step.kind == "line":
            twice = {name for name in moved if moved.count(name) > 1}
            short = "sling" if all(name.startswith("sling.") for name in twice) else "line"
        findings.add(("plan", place, step.verb), f"names a {short} twice; each {short} stands once")
    return set(moved)


def _check_stop(findings: Findings, path: Path, one: Mover, drive: str) -> None:
    """What shall stop in an emergency needs a way to do so that takes a finite force."""
    if one.capacity or one.emergency is not None:
        return
    sentence = f"'{one.name}' has no 'capacity', so that it would stop at once, with any force"
    right = f"give its {drive} a capacity"
    right += " or an 'emergency_acceleration', such as 0.2 m/s^2" if one.kind == "hook" else ""
    findings.add(path, f"{sentence}; {right}")


def _check_times(
    findings: Findings, place: int, step: MovingStep | LeadStep | PumpStep, earliest: float, begin: float
) -> tuple[float, float]:
    """Check when a step starts and brakes.

    Args:
        findings: What is wrong so far.
        place: Of the step in the plan.
        step: The step.
        earliest: The last time that the plan names before it [s].
        begin: When it begins at the earliest, by the ways and times of all before it [s].

    Returns:
        The time before which it cannot start, and that before which no step after it can [s].
    """
    duration, began = findings.scenario.duration, earliest
    ends = [(key, getattr(step, key, None)) for key in ("brake_from", "emergency_stop_at")]
    for key, time in (("start_at", step.start_at), *ends):
        if time is None:
            continue
        if time > duration:
            sentence = f"{time:g} s is after the end of the lift at {duration:g} s"
            findings.add(("plan", place, key), f"{sentence}; make 'duration' longer or this time earlier")
        elif time < earliest or (key != "start_at" and time == earliest):
            sentence = f"{time:g} s is not after what comes before it, at {earliest:g} s"
            findings.add(("plan", place, key), f"{sentence}; steps go in order of time")
        elif key != "start_at" and time <= begin:
            sentence = f"{time:g} s is over before this step begins, at {begin:.4g} s at the earliest"
            findings.add(("plan", place, key), f"{sentence}; it would move nothing")
        earliest = max(earliest, time)
        began = earliest if key == "start_at" else began
    return began, earliest


def _check_condition(findings: Findings, place: int, step: MovingStep | PumpStep | HoldStep) -> None:
    path: Path = ("plan", place, "until")
    condition = step.until
    assert condition is not None
    if condition.hoist_load is not None:
        _check_hoist_load(findings, (*path, "hoist_load", "hook"), condition.hoist_load.hook)
        return
    if condition.tension_spread is not None:
        _check_spread(findings, path, condition)
        return
    if condition.load_tilt is not None:
        if findings.scenario.load is None:
            findings.add(path, "this waits for a tilt of the load; there is no 'load' in this file")
        return
    if condition.slings is not None:
        _check_slings(findings, path, condition)
        return
    for key in ("heel", "trim"):
        reached = getattr(condition, key)
        if reached is not None:
            _check_floating(findings, (*path, key, "vessel"), reached.vessel)
            return
    if condition.falls_out_of_plumb is not None:
        _check_falls(findings, path, condition)
        return
    if condition.mooring_tension is not None:
        line, lines = condition.mooring_tension.line, findings.scenario.mooring_lines or {}
        if line not in lines:
            found = f"'{line}' is not a mooring line; {nearest(line, lines)}"
            findings.add((*path, "mooring_tension", "line"), found)
        return
    _check_supports(findings, path, step, condition.supports)


def _check_supports(
    findings: Findings, path: Path, step: MovingStep | PumpStep | HoldStep, supports: str | None
) -> None:
    """Note a wait for supports, or for a share of the load that has left them, which cannot end."""
    if not _may_stand(findings.scenario):
        how = "come down" if supports == "touched" else "leave the ground"
        sentence = f"this waits for a load to {how}"
        stands = "on a 'ground', on 'supports' or 'structures', or in 'body_contacts'"
        findings.add(path, f"{sentence}; there is no 'load' {stands} in this file")
        return
    down = isinstance(step, (LowerStep, PayOutStep))
    up = isinstance(step, (HookStep, DrumStep)) and not down
    if down and supports == "clear":
        sentence = "a load that is let down does not leave its supports"
        findings.add(path, f"{sentence}; 'supports: touched' is right here")
    if up and supports == "touched":
        sentence = "a load that is lifted does not come down on supports"
        findings.add(path, f"{sentence}; 'supports: clear' is right here")


def _may_stand(scenario: Scenario) -> bool:
    """Whether there is a load, and something that it may touch: a deck aboard is one of `body_contacts`."""
    load, mechanics = scenario.load, scenario.mechanics
    if load is None:
        return False
    contacts = (mechanics and mechanics.body_contacts) or {}
    touched = any(load.name in contact.between for contact in contacts.values())
    return touched or scenario.ground is not None or bool(scenario.supports or scenario.structures)


def _check_hoist_load(findings: Findings, path: Path, text: str) -> None:
    hooks = findings.scenario.hooks
    name = full_name(text, hooks)
    if name is None:
        findings.add(path, f"'{text}' is not a hook; {nearest(text, hooks)}")
    elif hooks[name].reeving is None:
        sentence = f"'{text}' has no 'reeving', and so no ropes in which its load could be read"
        findings.add(path, f"{sentence}; give it one or wait for 'load_transferred'")


def _check_floating(findings: Findings, path: Path, name: str) -> None:
    known = bodies_afloat(findings.scenario)
    floating = {one: body for one, body in known.items() if body.floats_freely}
    if name in floating:
        return
    if name in known and known[name].is_carried:
        sentence = f"'{name}' moves by its 'wave_motion', and nothing that the plan does heels or trims it"
        findings.add(path, sentence)
    elif name in known:
        findings.add(path, f"'{name}' does not float freely; only what has a hull and six motions does")
    else:
        findings.add(path, f"'{name}' is not a vessel; {nearest(name, floating)}")


def _check_falls(findings: Findings, path: Path, condition: Condition) -> None:
    hooks = findings.scenario.hooks
    reeved = {name: hook for name, hook in hooks.items() if hook.reeving is not None}
    if not reeved:
        findings.add(path, "this waits for falls to hang plumb; no hook in this file hangs in ropes")
    for text in condition.of:
        if full_name(text, reeved) is None:
            findings.add(
                (*path, "of"), f"'{text}' is not a hook that hangs in ropes; {nearest(text, reeved)}"
            )


def _check_slings(findings: Findings, path: Path, condition: Condition) -> None:
    slings = [f"sling.{name}" for name in findings.scenario.slings or {}]
    if not slings:
        findings.add(path, "this waits for slings; there are no 'slings' in this file")
    for name in condition.of:
        if name not in slings:
            findings.add((*path, "of"), f"'{name}' is not a sling; {nearest(name, slings)}")


def _check_spread(findings: Findings, path: Path, condition: Condition) -> None:
    equalizers = findings.scenario.equalizers or {}
    if not equalizers:
        findings.add(
            path, "this waits for the slings of an equalizer; there are no 'equalizers' in this file"
        )
    for name in condition.of:
        if name not in equalizers:
            findings.add((*path, "of"), f"'{name}' is not an equalizer; {nearest(name, equalizers)}")


def _check_emergency_stop(findings: Findings) -> None:
    stop, scenario = findings.scenario.emergency_stop, findings.scenario
    if stop is None:
        return
    path: Path = ("emergency_stop",)
    if stop.at is not None and stop.at > scenario.duration:
        sentence = f"{stop.at:g} s is after the end of the lift at {scenario.duration:g} s"
        findings.add((*path, "at"), f"{sentence}; make 'duration' longer or this time earlier")
    if stop.in_step is not None:
        place = place_of_step(findings, (*path, "in_step"), stop.in_step)
        begin = 0.0 if place is None else earliest_begins(scenario.plan)[place]
        if begin + (stop.after or 0.0) > scenario.duration:
            sentence = f"'{stop.in_step}' begins at {begin:.4g} s at the earliest"
            late = f"{sentence}, so that this is after the end of the lift at {scenario.duration:g} s"
            key = "in_step" if begin > scenario.duration or stop.after is None else "after"
            findings.add((*path, key), f"{late}; make 'duration' longer or this time earlier")
    moved = {
        name: one
        for step in scenario.plan
        if isinstance(step, MovingStep)
        for known in [movers(scenario, step.kind)]
        for name, one in ((full_name(text, known), step) for text in step.moved)
        if name is not None
    }
    for name, step in moved.items():
        one = movers(scenario, step.kind)[name]
        if one is not None:
            _check_stop(findings, path, one, _WORDS[step.kind][2])
    leads = (step for step in scenario.plan if isinstance(step, LeadStep))
    led = {one.name: one for step in leads for one in movers_of_lead(scenario, step)}
    for one in (one for name, one in led.items() if name not in moved):
        _check_stop(findings, path, one, _WORDS[one.kind][2])
