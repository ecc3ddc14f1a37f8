"""Whether the plan can be carried out by the hooks and drums there are."""

from __future__ import annotations

from collections.abc import Mapping

from gantline.scenario.crane import Hoist
from gantline.scenario.drum import DrumDrive
from gantline.scenario.errors import nearest
from gantline.scenario.findings import Findings
from gantline.scenario.model import Scenario
from gantline.scenario.plan import DrumStep, HoldStep, HookStep, LowerStep, MovingStep, PayOutStep

__all__ = ["check_plan"]

_ROUNDING = 1 + 1e-9


def check_plan(findings: Findings) -> None:
    """Note everything that is wrong with the plan."""
    plan = findings.scenario.plan
    earliest = 0.0
    for place, step in enumerate(plan):
        if isinstance(step, HoldStep):
            if step.hold == "until_end" and place + 1 < len(plan):
                sentence = "'until_end' stands before other steps, which would never begin"
                findings.add(("plan", place, "hold"), f"{sentence}; only the last step holds until the end")
            continue
        _check_moved(findings, place, step)
        earliest = _check_times(findings, place, step, earliest)
        if step.until is not None:
            _check_condition(findings, place, step)


def _check_moved(findings: Findings, place: int, step: MovingStep) -> None:
    """Each step moves what there is, once, and not faster than its hoist or drive can."""
    what = "hook" if isinstance(step, HookStep) else "drum"
    names = step.hooks if isinstance(step, HookStep) else step.drums if isinstance(step, DrumStep) else ()
    known = _movable(findings.scenario, what)
    for name in names:
        if name not in known:
            sentence = f"'{name}' is not a {what}; {nearest(name, known)}"
            findings.add(("plan", place, step.verb), sentence)
            continue
        drive = known[name]
        if drive is None:
            sentence = f"drum '{name}' has no 'drive' that could turn it"
            right = "'drive: {speed: 30 m/min, acceleration: 0.1 m/s^2}'"
            findings.add(("plan", place, step.verb), f"{sentence}; give it one, such as {right}")
            continue
        if step.emergency_stop_at is not None and drive.capacity is None:
            sentence = f"'{name}' has no 'capacity', so that it would stop at once, with any force"
            findings.add(
                ("plan", place, "emergency_stop_at"),
                f"{sentence}; give its {'hoist' if what == 'hook' else 'drive'} a capacity",
            )
        if step.speed > drive.speed * _ROUNDING:
            can = "hoist" if what == "hook" else "turn"
            sentence = f"{step.speed:g} m/s is faster than '{name}' can {can}"
            findings.add(("plan", place, "speed"), f"{sentence}; its highest speed is {drive.speed:g} m/s")
        if step.acceleration is not None and step.acceleration > drive.acceleration * _ROUNDING:
            sentence = f"{step.acceleration:g} m/s^2 is more than '{name}' can do"
            findings.add(
                ("plan", place, "acceleration"), f"{sentence}; its most is {drive.acceleration:g} m/s^2"
            )
    if len(set(names)) < len(names):
        findings.add(("plan", place, step.verb), f"names a {what} twice; each {what} stands once")


def _movable(scenario: Scenario, what: str) -> Mapping[str, Hoist | DrumDrive | None]:
    """Hooks or drums by name, with what moves them."""
    if what == "hook":
        return {name: crane.hoist for name, crane in (scenario.cranes or {}).items()}
    drums = scenario.mechanics.drums if scenario.mechanics is not None else None
    return {name: drum.drive for name, drum in (drums or {}).items()}


def _check_times(findings: Findings, place: int, step: MovingStep, earliest: float) -> float:
    """Check when a step starts and brakes; gives the time before which no later step can start [s]."""
    duration = findings.scenario.duration
    ends = (("brake_from", step.brake_from), ("emergency_stop_at", step.emergency_stop_at))
    for key, time in (("start_at", step.start_at), *ends):
        if time is None:
            continue
        if time > duration:
            sentence = f"{time:g} s is after the end of the lift at {duration:g} s"
            findings.add(("plan", place, key), f"{sentence}; make 'duration' longer or this time earlier")
        elif time < earliest or (key != "start_at" and time == earliest):
            sentence = f"{time:g} s is not after what comes before it, at {earliest:g} s"
            findings.add(("plan", place, key), f"{sentence}; steps go in order of time")
        earliest = max(earliest, time)
    return earliest


def _check_condition(findings: Findings, place: int, step: MovingStep) -> None:
    path = ("plan", place, "until")
    scenario = findings.scenario
    if scenario.load is None or (scenario.ground is None and not scenario.supports):
        sentence = "this waits for a load to leave the ground"
        findings.add(path, f"{sentence}; there is no 'load' on a 'ground' or on 'supports' in this file")
    elif isinstance(step, (LowerStep, PayOutStep)):
        doing = "lowering" if isinstance(step, LowerStep) else "paying out"
        sentence = f"{doing} until something happens cannot be simulated yet"
        findings.add(path, f"{sentence}; end the step with 'by' or 'brake_from'")
