"""Whether the plan can be carried out by the hooks there are."""

from __future__ import annotations

from gantline.scenario.errors import nearest
from gantline.scenario.findings import Findings
from gantline.scenario.plan import HoistStep, HoldStep, LowerStep, MovingStep

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
        _check_hooks(findings, place, step)
        earliest = _check_times(findings, place, step, earliest)
        if step.until is not None:
            _check_condition(findings, place, step)


def _check_hooks(findings: Findings, place: int, step: HoistStep | LowerStep) -> None:
    cranes = findings.scenario.cranes or {}
    for name in step.hooks:
        if name not in cranes:
            findings.add(("plan", place, step.verb), f"'{name}' is not a hook; {nearest(name, cranes)}")
            continue
        hoist = cranes[name].hoist
        if step.speed > hoist.speed * _ROUNDING:
            sentence = f"{step.speed:g} m/s is faster than '{name}' can hoist"
            findings.add(("plan", place, "speed"), f"{sentence}; its highest speed is {hoist.speed:g} m/s")
        if step.acceleration is not None and step.acceleration > hoist.acceleration * _ROUNDING:
            sentence = f"{step.acceleration:g} m/s^2 is more than '{name}' can do"
            findings.add(
                ("plan", place, "acceleration"), f"{sentence}; its most is {hoist.acceleration:g} m/s^2"
            )
    if len(set(step.hooks)) < len(step.hooks):
        findings.add(("plan", place, step.verb), "names a hook twice; each hook stands once")


def _check_times(findings: Findings, place: int, step: MovingStep, earliest: float) -> float:
    """Check when a step starts and brakes; gives the time before which no later step can start [s]."""
    duration = findings.scenario.duration
    for key, time in (("start_at", step.start_at), ("brake_from", step.brake_from)):
        if time is None:
            continue
        if time > duration:
            sentence = f"{time:g} s is after the end of the lift at {duration:g} s"
            findings.add(("plan", place, key), f"{sentence}; make 'duration' longer or this time earlier")
        elif time < earliest or (key == "brake_from" and time == earliest):
            sentence = f"{time:g} s is not after what comes before it, at {earliest:g} s"
            findings.add(("plan", place, key), f"{sentence}; steps go in order of time")
        earliest = max(earliest, time)
    return earliest


def _check_condition(findings: Findings, place: int, step: HoistStep | LowerStep) -> None:
    path = ("plan", place, "until")
    if findings.scenario.load is None or findings.scenario.ground is None:
        sentence = "this waits for a load to leave the ground"
        findings.add(path, f"{sentence}; there is no 'load' on a 'ground' in this file")
    elif isinstance(step, LowerStep):
        sentence = "lowering until something happens cannot be simulated yet"
        findings.add(path, f"{sentence}; end the step with 'by' or 'brake_from'")
