"""Hold a recording against its limits and the requirements of its plan."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from gantline.checks.check import Check, Verdict
from gantline.checks.limits import LIMITS, Candidate, Limit, everywhere, governing
from gantline.results.parting import Parting, partings
from gantline.results.recording import Recording
from gantline.results.rig import Step
from gantline.results.variable import BoolArray
from gantline.units import format_quantity


def check_recording(recording: Recording) -> list[Check]:
    """Check every limit and every requirement of a recording.

    Args:
        recording: Any recording.

    Returns:
        One check for each limit of the rig, in the order of the lift file, one for each requirement of a
        step, and one that failed for each rope that parted.
    """
    limits = {
        key: limit for key, limit in recording.rig.limits.items() if key != "rule" and limit is not None
    }
    whole = [_check_limit(recording, key, limit) for key, limit in limits.items()]
    steps = [check for step in recording.rig.plan for check in _check_step(recording, step)]
    return whole + steps + [_parted(parting) for parting in partings(recording)]


def has_failed(checks: list[Check]) -> bool:
    """Whether any check failed."""
    return any(check.verdict is Verdict.FAILED for check in checks)


def _parted(parting: Parting) -> Check:
    carried = format_quantity(parting.tension, "kN", 1)
    return Check(
        "rope_parted",
        Verdict.FAILED,
        "a rope was cut or broke",
        where=parting.rope,
        time=parting.time,
        remark=f"{parting.kind}, it carried {carried}",
    )


def _check_limit(recording: Recording, key: str, limit: object) -> Check:
    kind = LIMITS.get(key)
    if kind is None:
        return Check(key, Verdict.NOT_CHECKED, "", remark="this limit is not known here")
    if isinstance(limit, bool) or not isinstance(limit, int | float):
        return Check(key, Verdict.NOT_CHECKED, kind.formula, remark=f"the limit is not a number: {limit!r}")
    during = everywhere(recording)
    found = governing(kind, recording, during)
    if found is None:
        return _without_value(key, kind, float(limit), recording)
    verdict = _verdict(kind, found.value, float(limit))
    if key in recording.rig.assumed_limits and verdict is Verdict.FAILED:
        remark = "a limit of its own under 'limits' would make this a failure"
        return replace(_check(key, kind, found, float(limit), Verdict.WARNING), remark=remark)
    caution = kind.caution(recording) if kind.caution is not None else ""
    if caution and verdict is Verdict.OK:
        verdict = Verdict.WARNING
    return replace(_check(key, kind, found, float(limit), verdict), remark=caution)


def _check_step(recording: Recording, step: Step) -> Iterator[Check]:
    for key, bounds in step.require.items():
        for side, limit in bounds.items():
            yield _check_requirement(recording, step, key, side, float(limit))


def _check_requirement(recording: Recording, step: Step, key: str, side: str, limit: float) -> Check:
    kind = LIMITS.get(key)
    if kind is None:
        return Check(key, Verdict.NOT_CHECKED, "", step=step.step, remark="this quantity is not known here")
    at_least = side == "above"
    sided = replace(kind, at_least=at_least)
    during = end_of_step(recording, step.step)
    if during is None:
        remark = "the recording ends before this step does"
        return Check(key, Verdict.NOT_CHECKED, kind.formula, limit=limit, step=step.step, remark=remark)
    found = governing(sided, recording, during)
    if found is None:
        remark = "nothing to check at the end of this step"
        return Check(key, Verdict.NOT_CHECKED, kind.formula, limit=limit, step=step.step, remark=remark)
    return _check(key, sided, found, limit, _verdict(sided, found.value, limit), step.step)


def end_of_step(recording: Recording, step: str) -> BoolArray | None:
    """The last sample of a step of the plan.

    Args:
        recording: Any recording.
        step: Name of the step.

    Returns:
        Mask with that one sample; None if the step did not end within the recording.
    """
    ends = [time for time, _, name in recording.events("step_end") if name == step]
    if not ends or not len(recording.time):
        return None
    last = max(0, int(np.searchsorted(recording.time, ends[0], side="right")) - 1)
    mask = np.zeros(len(recording.time), dtype=np.bool_)
    mask[last] = True
    return mask


def _verdict(kind: Limit, value: float, limit: float) -> Verdict:
    if value >= limit if kind.at_least else value <= limit:
        return Verdict.OK
    if not kind.at_least and kind.warns_up_to is not None and value <= kind.warns_up_to:
        return Verdict.WARNING
    return Verdict.FAILED


def _without_value(key: str, kind: Limit, limit: float, recording: Recording) -> Check:
    remark = (
        "the load never came clear of its supports"
        if kind.when_clear
        else "the lift has nothing that it is about"
    )
    if key == "hook_dynamic_factor" and recording.rig.hooks:
        remark = "no static hook load: the load did not end clear of its supports"
    elif kind.caution is not None:
        remark = kind.caution(recording) or remark
    return Check(key, Verdict.NOT_CHECKED, kind.formula, None, limit, kind.unit, kind.digits, remark=remark)


def _check(key: str, kind: Limit, found: Candidate, limit: float, verdict: Verdict, step: str = "") -> Check:
    return Check(
        key,
        verdict,
        kind.formula,
        value=found.value,
        limit=limit,
        unit=kind.unit,
        digits=kind.digits,
        where=found.where,
        time=found.time,
        step=step,
    )
