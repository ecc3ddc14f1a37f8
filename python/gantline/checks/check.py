"""What a check says."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, fields
from enum import StrEnum
from typing import Any

from gantline.arguments import listed
from gantline.results.alike import ROUNDING, first_largest
from gantline.units import compared_digits, format_quantity

#: Checks that a run got through its plan, that it lifted what it should, and that nothing of it is lost.
PLAN_FINISHED, LOAD_LIFTED, ALL_KNOWN = "plan_finished", "load_lifted", "all_known"
HANGS_STILL = "hangs_still"
#: The check that fails of each rope that was cut or broke.
PARTED = "rope_parted"
#: Checks that hold what hooks, slings, shackles and lugs bear against what they may bear.
_STRENGTHS = frozenset(
    {
        "hoist_load_of_rated_capacity",
        "hoist_load_of_rating",
        "equalizer_load_of_rated_capacity",
        "chain_hoist_load_of_rated_capacity",
        "drum_load_of_rated_capacity",
        "spreader_load_of_rated_capacity",
        "compensator_load_of_rated_capacity",
        "compensator_peak_of_rated_capacity",
        "sling_factor_on_breaking_force",
        "rope_factor_on_breaking_force",
        "rope_load_of_breaking_force",
        "shackle_load_of_working_load_limit",
        "shackle_dynamic_load_of_strength",
        "lug_load_of_capacity",
    }
)
#: Why a lift is no go of whose gear nothing is known.
_NO_STRENGTH = (
    "no force has been held against what bears it: capacities of hooks and lugs, breaking forces of slings "
    "and working load limits of shackles are not known"
)
#: What a step may ask to be at least and has to come to: less is missed, and no share of it is used up.
_COME_TO = frozenset({"load_tilt", "load_yaw", "load_transferred"})
#: Most checks that the verdict on a lift names.
_MOST_NAMED = 3


class Verdict(StrEnum):
    """Outcome of a check: `OK`, `WARNING`, `FAILED` or `NOT_CHECKED`; each is its text, such as `"ok"`."""

    OK = "ok"
    WARNING = "warning"
    FAILED = "failed"
    NOT_CHECKED = "not checked"


class Outcome(StrEnum):
    """What all checks together say of a lift: `GO`, `GO_WITH_WARNINGS`, `NO_GO` or `NO_VERDICT`.

    Each is its text, such as `"GO WITH WARNINGS"`.
    """

    GO = "GO"
    GO_WITH_WARNINGS = "GO WITH WARNINGS"
    NO_GO = "NO-GO"
    NO_VERDICT = "NO VERDICT"


@dataclass(frozen=True)
class Check:
    """One limit held against a recording.

    Attributes:
        name: Key of the limit in the lift file.
        verdict: The outcome.
        meaning: What is compared with what, in words.
        formula: The same with the numbers of the worst moment put in; empty without a value.
        value: Governing value [SI]; None if there was nothing to check.
        limit: The limit [SI]; None if there is none.
        at_least: Whether the limit is the smallest allowed value, not the largest.
        source: Where the limit, and the factors in the formula, come from.
        unit: Unit in which people read both, of `gantline.units`.
        digits: Decimals with which people read both, if these tell a value past its limit from it.
        element: Sling, lug, equalizer, load or hook that governs.
        time: When it governs [s]; None where the value belongs to no one time.
        step: Step of the plan whose end was checked; empty for the whole lift.
        remark: Why there is no verdict, or what else to know.
        cautions: What of the remark is to be known of the measure, within its limit too.
        is_vain: Whether the lift file sets the limit, and the lift has nothing that it is about.
        is_beside: Whether all its values are of ropes by which nothing hangs: mooring and tag lines.
    """

    name: str
    verdict: Verdict
    meaning: str
    formula: str = ""
    value: float | None = None
    limit: float | None = None
    at_least: bool = False
    source: str = ""
    unit: str = ""
    digits: int = 2
    element: str = ""
    time: float | None = None
    step: str = ""
    remark: str = ""
    is_vain: bool = False
    is_beside: bool = False
    cautions: Sequence[str] = ()

    def shown(self, number: float | None) -> str:
        """A value or limit of this check as people read it; empty for None."""
        return "" if number is None else format_quantity(number, self.unit, self._digits)

    @property
    def _digits(self) -> int:
        """Decimals of value and limit: more of them where what is past its limit would read like it."""
        if self.value is None:
            return self.digits
        return compared_digits(self.value, self.limit, self.unit, self.digits, at_least=self.at_least)

    @property
    def has_no_limit(self) -> bool:
        """Whether there is a value and nothing to hold it against, so that its verdict is `not checked`."""
        return self.verdict is Verdict.NOT_CHECKED and self.value is not None and self.limit is None

    @property
    def utilisation(self) -> float | None:
        """Value over limit [1], or limit over value where the limit is the smallest allowed.

        None without both, where that is no number (a limit of 0), or where a step has to come to a place.
        """
        if self.at_least and self.name in _COME_TO:
            return None
        # A margin may come as near to 0 as it likes: no share of that limit says how near.
        if self.value is None or not self.limit:
            return None
        over, under = (self.limit, self.value) if self.at_least else (self.value, self.limit)
        used = over / under if under > 0.0 else math.inf
        # Adding 0 takes the sign off a zero: nobody has used -0 %.
        return used + 0.0 if math.isfinite(used) else None

    def to_json(self) -> dict[str, Any]:
        """All of it as a JSON object, SI units."""
        return {**asdict(self), "verdict": self.verdict.value, "utilisation": self.utilisation}

    @classmethod
    def from_json(cls, document: Mapping[str, Any]) -> Check:
        """Read what `to_json` made.

        Raises:
            ValueError: If it is something else.
        """
        try:
            given = {one.name: document[one.name] for one in fields(cls)}
            given |= {"verdict": Verdict(given["verdict"]), "cautions": tuple(given["cautions"])}
        except (KeyError, TypeError) as error:
            raise ValueError(f"no check: {error}") from None
        return cls(**given)


def has_failed(checks: Sequence[Check]) -> bool:
    """Whether any check failed."""
    return any(check.verdict is Verdict.FAILED for check in checks)


def failed_names(checks: Sequence[Check]) -> tuple[str, ...]:
    """Names of the checks that failed, each once."""
    return tuple(dict.fromkeys(check.name for check in checks if check.verdict is Verdict.FAILED))


def outcome_of(checks: Sequence[Check]) -> Outcome:
    """Go or no-go.

    A run that ends before its plan, lifts nothing, or of which something is no number, may show that a lift
    is no go, but not that it is one. Nor may a lift of whose gear no strength is known.

    Raises:
        TypeError: If these are no checks, such as a recording.
    """
    right = "gantline.checks.check_recording gives those of a recording"
    if not all(isinstance(check, Check) for check in listed(checks, "a list of checks", right)):
        raise TypeError(f"a list of checks is needed, not {type(checks).__name__}; {right}")
    if _is_nothing(checks):
        return Outcome.NO_VERDICT
    if has_failed(checks):
        return Outcome.NO_GO
    if _shown_nothing(checks):
        return Outcome.NO_VERDICT
    is_warned = any(check.verdict is Verdict.WARNING for check in checks)
    return Outcome.GO_WITH_WARNINGS if is_warned else Outcome.GO


def verdict_of(checks: Sequence[Check]) -> str:
    """The lift in one sentence: go or no-go, what governs, how many warnings, what has not been checked."""
    outcome = outcome_of(checks)
    if _is_nothing(checks):
        return f"{outcome}: nothing has been checked"
    done = [check for check in checks if _is_done(check)]
    failed = [check for check in done if check.verdict is Verdict.FAILED]
    if failed:
        head = f"{outcome}: {len(failed)} failed, {_foremost(failed)}"
    else:
        past = past_limits(checks)
        nearest = _foremost([check for check in done if check.utilisation is not None and check not in past])
        why = "; ".join(_shown_nothing(checks))
        head = f"{outcome}: {why}" if why else f"{outcome}"
        head += f"; past a limit that only warns: {_foremost(past)}" if past else ""
        head += f"; nearest to their limits: {nearest}" if nearest else ""
    warnings = sum(check.verdict is Verdict.WARNING for check in checks)
    without = sum(check.has_no_limit for check in checks)
    rest = f"{len(checks) - len(done) - without} not checked, {without} without a limit"
    vain = [check.name for check in checks if check.is_vain]
    rest += f"; the lift has nothing that these limits are about: {', '.join(vain)}" if vain else ""
    return f"{head}; {_count(warnings, 'warning')}, {rest}"


def governing(checks: Sequence[Check]) -> Check | None:
    """The check that uses most of its limit, of those alike the first; None where there is none with a limit.

    One that failed without a number comes before all others, and before these a rope that parted: others hang
    slack, tilt and fall by that.
    """
    known = [
        check
        for check in checks
        if check.verdict is Verdict.FAILED or (check.utilisation is not None and _is_done(check))
    ]
    parted = [check for check in known if check.name == PARTED]
    return first_largest(parted or known, _share)


def past_limits(checks: Sequence[Check]) -> list[Check]:
    """Checks that are past their limit and no more than a warning."""
    return [
        check
        for check in checks
        if check.verdict is Verdict.WARNING and check.utilisation is not None and check.utilisation > 1.0
    ]


def _is_nothing(checks: Sequence[Check]) -> bool:
    """Whether nothing was held against anything."""
    done = [check for check in checks if _is_done(check)]
    return all(check.value is None and check.verdict is Verdict.WARNING for check in done)


def _shown_nothing(checks: Sequence[Check]) -> list[str]:
    """Why these checks cannot show that a lift is a go."""
    names = (PLAN_FINISHED, LOAD_LIFTED, ALL_KNOWN)
    reasons = [check.remark for check in checks if check.name in names and _is_done(check)]
    strengths = [check for check in checks if check.name in _STRENGTHS]
    if strengths and all(one.value is None or one.is_beside for one in strengths) and _is_hung(checks):
        reasons.append(_NO_STRENGTH)
    return reasons


def _is_hung(checks: Sequence[Check]) -> bool:
    """Whether they are of something that hangs in a hook."""
    return any(check.name in ("static_hook_load", "dynamic_hook_load") and check.value for check in checks)


def _is_done(check: Check) -> bool:
    return check.verdict is not Verdict.NOT_CHECKED


def _share(check: Check) -> float:
    """The share of its limit that a check uses [1]; infinite of one without a number."""
    return math.inf if check.utilisation is None else check.utilisation


def foremost(checks: Sequence[Check]) -> list[Check]:
    """Of checks of one name the one that uses most of its limit, most first; those without a number lead.

    What parted leads these.
    """

    def used(check: Check) -> tuple[bool, float]:
        share = _share(check)
        # Of shares that are one but for rounding the first leads.
        return check.name == PARTED, round(share / ROUNDING) if math.isfinite(share) else share

    worst: dict[str, Check] = {}
    for check in sorted(checks, key=used, reverse=True):
        worst.setdefault(check.name, check)
    return list(worst.values())


def _foremost(checks: Sequence[Check]) -> str:
    """Names of the checks that use most of their limits, with the share."""
    every = foremost(checks)
    named = [
        check.name + ("" if check.utilisation is None else f" {100.0 * check.utilisation:.0f} %")
        for check in every[:_MOST_NAMED]
    ]
    more = f" and {len(every) - _MOST_NAMED} more" if len(every) > _MOST_NAMED and has_failed(checks) else ""
    return ", ".join(named) + more


def _count(number: int, what: str) -> str:
    return f"{number} {what}{'' if number == 1 else 's'}"
