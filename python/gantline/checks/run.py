"""Hold a recording against its limits and the requirements of its plan."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from gantline.checks.check import ALL_KNOWN, PARTED, Check, Verdict
from gantline.checks.crawlers import left_ground
from gantline.checks.drums import turns_left
from gantline.checks.ends import about_end_of_step, one_sample, second_half_of_hold
from gantline.checks.equalizers import held_upright
from gantline.checks.guides import beside_guides
from gantline.checks.held_down import held_down, shut_in, tied_down
from gantline.checks.hinges import opened
from gantline.checks.level import out_of_level
from gantline.checks.limits import LIMITS
from gantline.checks.loads import (
    bent_over_edges,
    held_by_tag_lines,
    lines_run_through,
    on_their_tip,
    run_through,
    run_through_structures,
)
from gantline.checks.measure import Caution, Finding, Found, Measure, Missing, Refused, named
from gantline.checks.overlaps import run_into
from gantline.checks.parted import parted
from gantline.checks.picked_up import beside_supports, leans, picked_up
from gantline.checks.plan import (
    came_down,
    fell_behind,
    hit,
    never_still,
    not_lifted,
    ran_out,
    steps_move,
    unfinished,
)
from gantline.checks.ranges import left_range
from gantline.checks.slings import idle, taken_off
from gantline.checks.tag_lines import left_behind, never_taut
from gantline.checks.vessels import turn_over
from gantline.results import series
from gantline.results.alike import differs, first_largest
from gantline.results.file.gaps import gaps
from gantline.results.recording import Recording, recorded
from gantline.results.rig import Step
from gantline.results.variable import BoolArray
from gantline.rule_data import LIFT_FILE
from gantline.units import format_quantity

#: Of a bound that nobody set.
_OWN_LIMIT = "a limit of its own under 'limits' would make this a failure"

#: Of a limit that no element of the lift has.
_NOTHING = "the lift has nothing that this limit is about, or nothing of that carries"

#: Limits of what comes and goes as a load swings.
AS_IT_SWINGS = ("falls_out_of_plumb", "off_lead", "side_lead", "load_tilt", "compensator_stroke_margin")
#: Check that lift file and run give no warnings of their own.
NO_WARNINGS = "no_warnings"


def check_recording(recording: Recording, ending: Collection[str] = ()) -> list[Check]:
    """Check a recording: of a run, or of an equilibrium.

    Args:
        recording: Any recording.
        ending: Steps of the plan that end at the moment of an equilibrium: it is held against what they
            require.

    Raises:
        ValueError: If the plan has no step of one of these names.

    Returns:
        One check for each quantity that the lift sets a limit for, or that has to be handed in of every lift
        with a load, hook, sling or vessel, in the order of `LIMITS`; limits that are not known here; one
        check for each requirement of a step; then what no limit is about, such as ropes that parted, ranges
        that were left and warnings of the recording, which `docs/reference/checks.md` lists; and that a run
        lifts nothing, holds nothing still or ends before its plan.
    """
    _hold_steps(recorded(recording), ending)
    return list(recording.kept(("checks", *ending), lambda: tuple(_all_checks(recording, ending))))


def _all_checks(recording: Recording, ending: Collection[str]) -> list[Check]:
    rig = recording.rig
    limits = {key: limit for key, limit in rig.limits.items() if key != "rule" and limit is not None}
    hands_in = bool(rig.loads or rig.hooks or rig.slings or rig.vessels or rig.mooring_lines or rig.fenders)
    found = [
        _check_limit(recording, key, measure, limits.get(key))
        for key, measure in LIMITS.items()
        if key in limits or ((measure.is_listed or measure.alarm is not None) and hands_in)
    ]
    whole = [check for check in found if check is not None]
    unknown = [
        Check(key, Verdict.WARNING, "", remark="this limit is not known here")
        for key in limits
        if key not in LIMITS
    ]
    steps: list[Check] = []
    for step in rig.plan:
        for check in _check_step(recording, step, ending):
            steps.append(_cautioned(check, whole + steps))
    every = whole + unknown + steps
    for look in _BESIDE_LIMITS:
        every += look(recording)
    if recording.is_equilibrium:
        # It has no moments to tell apart.
        return [replace(one, time=None) for one in every + not_lifted(recording)]
    for look in _OF_RUNS:
        every += look(recording)
    return every + (unfinished(recording) or not_lifted(recording) + never_still(recording))


def values_of(recording: Recording, name: str, at: BoolArray | None = None) -> dict[str, float]:
    """What a quantity of `LIMITS` comes to [SI], worst of each element.

    Args:
        recording: Any recording.
        name: A key of `LIMITS`.
        at: Samples that count; None for the whole lift.

    Raises:
        KeyError: If there is no such quantity.
    """
    if name not in tuple(LIMITS):
        raise KeyError(f"no quantity that limits can be set for is {name!r}; they are {', '.join(LIMITS)}")
    measure = LIMITS[name]
    pick = min if measure.at_least else max
    values: dict[str, float] = {}
    during = series.everywhere(recorded(recording)) if at is None else np.asarray(at, dtype=np.bool_)
    for found in _findings(measure, recording, during):
        if isinstance(found, Found):
            values[found.element] = pick(found.value, values.get(found.element, found.value))
    return values


@dataclass(frozen=True)
class _Outcome:
    """What a measure found: all values, the governing one, worse ones that may be, and what is not a value.

    `of` are the elements that have a value; it lacks strength where what some of them may bear is not known.
    """

    values: tuple[Found, ...]
    worst: Found | None
    of: frozenset[str]
    between: float | None
    at_design: float | None
    with_losses: float | None
    refused: tuple[Refused, ...]
    missing: str
    lacks_strength: bool
    cautions: tuple[str, ...]


def _findings(measure: Measure, recording: Recording, during: BoolArray) -> Sequence[Finding]:
    """What a measure finds; checks, tables and first page all ask for that of the whole lift."""
    if during.all() and during.size:
        return recording.kept(
            ("findings", measure.meaning), lambda: tuple(measure.findings(recording, during))
        )
    return tuple(measure.findings(recording, during)) if during.any() else ()


def _look(measure: Measure, recording: Recording, during: BoolArray) -> _Outcome:
    inside = during & series.is_clear(recording) if measure.when_clear else during
    findings = _findings(measure, recording, inside)
    values = [one for one in findings if isinstance(one, Found)]
    pick = min if measure.at_least else max
    return _Outcome(
        values=tuple(values),
        worst=_worst(measure, values),
        of=frozenset(one.element for one in values),
        between=pick((one.between for one in values if one.between is not None), default=None),
        at_design=pick((one.at_design for one in values if one.at_design is not None), default=None),
        with_losses=pick((one.with_losses for one in values if one.with_losses is not None), default=None),
        refused=tuple(one for one in findings if isinstance(one, Refused)),
        missing=_reasons(one for one in findings if isinstance(one, Missing)),
        lacks_strength=any(isinstance(one, Missing) and one.is_strength for one in findings),
        cautions=tuple(dict.fromkeys(one.text for one in findings if isinstance(one, Caution))),
    )


def _look_one_by_one(measure: Measure, recording: Recording, during: BoolArray, found: _Outcome) -> _Outcome:
    """The same with the worst of each sample: of many at once a measure finds the largest, or its least."""
    looks = [_look(measure, recording, one_sample(int(at), during)) for at in np.flatnonzero(during)]
    values = [look.worst for look in looks if look.worst is not None]
    return replace(found, worst=_worst(measure, values))


def _worst(measure: Measure, values: Sequence[Found]) -> Found | None:
    """The worst value, with element and time of the first that is so but for rounding; None of none."""
    # Nothing compares with what is no number: that governs.
    unknown = next((one for one in values if math.isnan(one.value)), None)
    first = first_largest(values, lambda one: one.value, measure.unit, smallest=measure.at_least)
    if unknown is not None or first is None:
        return unknown
    pick = min if measure.at_least else max
    return replace(first, value=pick(one.value for one in values))


def _reasons(of: Iterable[Missing | Refused]) -> str:
    """Why elements could not be checked or failed, each reason once with the elements that it is true of."""
    by_reason: dict[str, list[str]] = {}
    for one in of:
        by_reason.setdefault(one.reason, []).append(one.element)
    return "; ".join(f"{reason}: {named(elements)}" for reason, elements in by_reason.items())


def _check_limit(recording: Recording, key: str, measure: Measure, given: object) -> Check | None:
    """One check of the whole lift; None without a limit where the lift has nothing of the kind to be told."""
    rig = recording.rig
    check = Check(
        key,
        Verdict.NOT_CHECKED,
        measure.meaning,
        at_least=measure.at_least,
        unit=measure.unit,
        digits=measure.digits,
    )
    if given is not None and (isinstance(given, bool) or not isinstance(given, int | float)):
        return replace(check, verdict=Verdict.WARNING, remark=f"the limit is not a number: {given!r}")
    limit = measure.by_definition if given is None else float(given)
    source = (
        measure.definition if given is None else rig.limit_sources.get(key, str(rig.limits.get("rule", "")))
    )
    found = _look(measure, recording, series.everywhere(recording))
    nothing = found.worst is None and not found.refused
    if nothing and given is None and not (found.missing and measure.is_listed):
        return None
    factors = found.worst.factors if found.worst is not None else ()
    check = replace(check, limit=limit, source=_with_factors(recording, source, factors))
    if found.refused:
        return _refused(check, found.refused)
    check = replace(check, cautions=found.cautions)
    if found.worst is None:
        return _of_nothing(recording, measure, check, found, is_given=given is not None)
    check = replace(_with_value(check, found.worst), is_beside=found.of <= set(rig.outer_ropes))
    remarks = [f"not checked, {found.missing}" if found.missing else "", *found.cautions]
    if given is None and (limit is None or _verdict(measure, found.worst.value, limit) is Verdict.OK):
        alarmed = _alarmed(recording, measure, check, found.values)
        if alarmed is not None:
            return replace(alarmed, verdict=Verdict.WARNING, remark=_joined([_OWN_LIMIT, *remarks]))
    if given is None and not measure.is_listed:
        return None
    if limit is None:
        verdict = Verdict.WARNING if found.cautions else Verdict.NOT_CHECKED
        return replace(check, verdict=verdict, remark=_joined([found.missing, *found.cautions]))
    verdict = _verdict(measure, found.worst.value, limit)
    if verdict is Verdict.OK:
        between = "between two samples it may have come to {}: a shorter 'sample_interval' tells"
        at_design = "with the design weight it comes to {}, drums and tanks as here: 'simulate: design' tells"
        with_losses = (
            "as it hoists over sheaves that take 2 % each it comes to {}: 'sheave_efficiency' says it"
        )
        remarks = [
            _beyond_all(check, measure),
            _past_too(check, measure, found.between, between),
            _past_too(check, measure, found.at_design, at_design),
            _past_too(check, measure, found.with_losses, with_losses),
            *remarks,
        ]
    if key in rig.assumed_limits and verdict is Verdict.FAILED:
        verdict = Verdict.WARNING
        remarks.append(_OWN_LIMIT)
    remark = _joined(remarks)
    if remark and verdict is Verdict.OK:
        verdict = Verdict.WARNING
    return replace(check, verdict=verdict, remark=remark)


def _of_nothing(
    recording: Recording, measure: Measure, check: Check, found: _Outcome, *, is_given: bool
) -> Check:
    """The check of a lift that has no value to hold against its limit."""
    rig = recording.rig
    missing = found.missing or _never_clear(recording, measure)
    # A preset is for every lift; its limits have other sources than those of the lift file.
    is_own = rig.limit_sources.get(check.name, LIFT_FILE) in (LIFT_FILE, rig.limits.get("rule"))
    check = replace(check, is_vain=is_own and is_given and not missing and not found.cautions)
    is_asked = is_given and check.name not in rig.assumed_limits
    check = _without_value(recording, check, missing, _NOTHING, is_asked=is_asked)
    if found.lacks_strength:
        # Nobody need ask for that: of a lug whose capacity is known beside it this would be a warning too.
        check = replace(check, verdict=Verdict.WARNING)
    if not found.cautions:
        return check
    return replace(check, verdict=Verdict.WARNING, remark=_joined([check.remark, *found.cautions]))


def _alarmed(recording: Recording, measure: Measure, check: Check, values: Sequence[Found]) -> Check | None:
    """The check of the element that is farthest past its alarm; None where none is."""
    if measure.alarm is None:
        return None
    beyond = []
    for one in values:
        bound = measure.alarm.value(recording, one.element)
        if _verdict(measure, one.value, bound) is Verdict.FAILED:
            source = _with_factors(recording, measure.alarm.source, one.factors)
            beyond.append(replace(_with_value(check, one), limit=bound, source=source))
    return first_largest(beyond, lambda one: math.inf if one.utilisation is None else one.utilisation)


def _past_too(check: Check, measure: Measure, other: float | None, text: str) -> str:
    """That a value within its limit may be past it otherwise, in a sentence with a place for that value."""
    if other is None or check.limit is None or _verdict(measure, other, check.limit) is Verdict.OK:
        return ""
    return text.format(replace(check, value=other).shown(other))


def _beyond_all(check: Check, measure: Measure) -> str:
    """That a value is past all of what there is, by definition, and within a limit that allows more."""
    whole = measure.by_definition
    if whole is None or check.value is None or _verdict(measure, check.value, whole) is not Verdict.FAILED:
        return ""
    return f"more than all of it, {check.shown(whole)}, which the limit allows"


def _refused(check: Check, refused: Sequence[Refused]) -> Check:
    """The check of elements to which something happens that is not allowed at all."""
    first = refused[0]
    check = replace(check, element=first.element) if first.found is None else _with_value(check, first.found)
    return replace(check, verdict=Verdict.FAILED, remark=_reasons(refused))


def _without_value(
    recording: Recording, check: Check, missing: str, nothing: str, *, is_asked: bool
) -> Check:
    """The check of which no element has a value; a warning where the lift asks for it and a run has one.

    Less is known then than where some elements have a value, which is a warning too. What an equilibrium
    lacks, a peak first of all, the run of the lift has.
    """
    asked_in_vain = is_asked and missing and not recording.is_equilibrium
    verdict = Verdict.WARNING if asked_in_vain else Verdict.NOT_CHECKED
    return replace(check, verdict=verdict, remark=missing or nothing)


def _with_value(check: Check, found: Found) -> Check:
    return replace(check, value=found.value, element=found.element, time=found.time, formula=found.formula)


def _with_factors(recording: Recording, source: str, factors: Iterable[str]) -> str:
    """Source of a limit, and of the rule's factors in its value."""
    texts = [source] if source else []
    for name in factors:
        factor = recording.rig.factors.get(name)
        if factor is not None:
            texts.append(f"{name} {factor.value:.4g}: {factor.source}")
    return "; ".join(texts)


def _joined(remarks: Iterable[str]) -> str:
    return "; ".join(remark for remark in remarks if remark)


def _never_clear(recording: Recording, measure: Measure) -> str:
    """Why there is no value of what counts while the load hangs clear, and would have one else."""
    if (
        not measure.when_clear
        or _look(replace(measure, when_clear=False), recording, series.everywhere(recording)).worst is None
    ):
        return ""
    return "the load never came clear of its supports"


def _hold_steps(recording: Recording, names: Collection[str]) -> None:
    known = [step.step for step in recording.rig.plan]
    # One word is a collection of letters.
    if isinstance(names, str) or not set(names) <= set(known):
        raise ValueError(f"ending: {names!r} are no steps of the plan; they are {', '.join(known)}")


def _check_step(recording: Recording, step: Step, ending: Collection[str]) -> Iterator[Check]:
    is_now = step.step in ending and recording.is_equilibrium
    during = one_sample(-1, recording.time) if is_now else about_end_of_step(recording, step)
    for key, bounds in step.require.items():
        for side, limit in bounds.items():
            yield _check_requirement(recording, step, during, key, side, float(limit))


def _check_requirement(
    recording: Recording, step: Step, during: BoolArray | None, key: str, side: str, limit: float
) -> Check:
    measure = LIMITS.get(key)
    if measure is None:
        return Check(key, Verdict.WARNING, "", step=step.step, remark="this quantity is not known here")
    sided = replace(measure, at_least=side == "above")
    check = Check(
        key,
        Verdict.NOT_CHECKED,
        measure.meaning,
        limit=limit,
        at_least=sided.at_least,
        source="plan",
        unit=measure.unit,
        digits=measure.digits,
        step=step.step,
    )
    if during is None:
        if recording.is_equilibrium:
            return replace(check, remark="a run checks what steps require, and 'gantline statics --steps'")
        return replace(check, remark="the recording ends before this step does")
    found = _look(sided, recording, during)
    if sided.at_least != measure.at_least and np.count_nonzero(during) > 1:
        found = _look_one_by_one(sided, recording, during, found)
    if found.refused:
        return _refused(check, found.refused)
    if found.worst is None:
        missing = found.missing or "nothing to check at the end of this step"
        check = replace(check, cautions=found.cautions)
        return _without_value(recording, check, missing, missing, is_asked=True)
    check = replace(_with_value(check, found.worst), cautions=found.cautions)
    verdict = _verdict(sided, found.worst.value, limit)
    swings = _swings(recording, step, key, limit) if verdict is Verdict.OK and side == "below" else ""
    remarks = [f"not checked, {found.missing}" if found.missing else "", swings]
    if any(remarks):
        verdict = Verdict.WARNING if verdict is Verdict.OK else verdict
        check = replace(check, remark=_joined(remarks))
    return replace(check, verdict=verdict)


def _swings(recording: Recording, step: Step, key: str, limit: float) -> str:
    """That what a load does as it swings keeps a bound at the end of a hold and not before; empty if it does.

    The end of a hold is a moment: half a swing later plumb is what a quarter later is not.
    """
    measure = LIMITS[key]
    during = second_half_of_hold(recording, step) if key in AS_IT_SWINGS else None
    worst = None if during is None else _look(measure, recording, during).worst
    if worst is None or worst.time is None or _verdict(measure, worst.value, limit) is not Verdict.FAILED:
        return ""
    shown = format_quantity(worst.value, measure.unit, measure.digits)
    return f"at the end alone: it is {shown} at {worst.time:.2f} s of this hold, and swings; hold it longer"


def _cautioned(check: Check, told: Sequence[Check]) -> Check:
    """The check of a requirement, with a warning of those cautions that none of the same measure has told."""
    said = {caution for one in told if one.name == check.name for caution in one.cautions}
    cautions = tuple(one for one in check.cautions if one not in said)
    if not cautions:
        return replace(check, cautions=())
    verdict = Verdict.WARNING if check.verdict is Verdict.OK else check.verdict
    return replace(check, verdict=verdict, remark=_joined([check.remark, *cautions]), cautions=cautions)


def _would_part(recording: Recording) -> list[Check]:
    """One that failed for each rope that carries at rest what breaks it in a run; an equilibrium keeps it."""
    if not recording.is_equilibrium:
        return []
    found = []
    for rope in recording.rig.ropes:
        carries = float(series.tightest_tension(recording, rope.name)[-1])
        if rope.breaks_at is not None and carries >= rope.breaks_at:
            found.append(
                Check(
                    PARTED,
                    Verdict.FAILED,
                    "a rope was cut or broke",
                    element=rope.name,
                    remark=f"it carries {format_quantity(carries, 'kN', 1)} and breaks at "
                    f"{format_quantity(rope.breaks_at, 'kN', 1)}; what comes of that a run tells",
                )
            )
    return found


def _told(recording: Recording) -> list[Check]:
    """A warning where the recording has any: a verdict does not pass over them."""
    warnings = recording.attributes.get("warnings") or []
    more = "more warning" if len(warnings) == 2 else "more warnings"
    return _first_of(NO_WARNINGS, "lift file and run give no warning", warnings, more)


def _unknown(recording: Recording) -> list[Check]:
    """A warning where values are no numbers, which no run leaves: what follows from them is not known."""
    return _first_of(ALL_KNOWN, "every value of a recording is a number", gaps(recording), "more")


def _first_of(name: str, meaning: str, sentences: Sequence[str], more: str) -> list[Check]:
    """A warning that tells the first of some sentences and how many more there are; nothing of none."""
    if not sentences:
        return []
    others = f"; and {len(sentences) - 1} {more}" if len(sentences) > 1 else ""
    return [Check(name, Verdict.WARNING, meaning, remark=f"{sentences[0]}{others}")]


def _verdict(measure: Measure, value: float, limit: float) -> Verdict:
    if math.isnan(value):
        return Verdict.FAILED
    if measure.warns_up_to is not None and _is_past(value, measure.warns_up_to, measure.unit):
        return Verdict.FAILED
    sign = -1.0 if measure.at_least else 1.0
    if not _is_past(sign * value, sign * limit, measure.unit):
        return Verdict.OK
    return Verdict.FAILED if measure.warns_up_to is None else Verdict.WARNING


def _is_past(value: float, limit: float, unit: str) -> bool:
    """Whether a value is more than a limit, and not by rounding alone: 300 mm over 50 mm are six."""
    return value > limit and differs(value, limit, unit)


#: What is looked at beside limits, in the order of the table; each says of what it has a check.
_BESIDE_LIMITS: tuple[Callable[[Recording], Iterable[Check]], ...] = (
    parted,
    _would_part,
    taken_off,
    opened,
    fell_behind,
    ran_out,
    idle,
    turns_left,
    on_their_tip,
    turn_over,
    held_by_tag_lines,
    left_behind,
    never_taut,
    run_through,
    bent_over_edges,
    run_through_structures,
    lines_run_through,
    run_into,
    left_ground,
    out_of_level,
    left_range,
    held_down,
    tied_down,
    shut_in,
    held_upright,
    leans,
    _told,
    _unknown,
)
#: The same of runs alone, which have moments to tell apart.
_OF_RUNS: tuple[Callable[[Recording], Iterable[Check]], ...] = (
    steps_move,
    came_down,
    hit,
    picked_up,
    beside_supports,
    beside_guides,
)
