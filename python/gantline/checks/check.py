"""What a check says."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from gantline.units import format_quantity


class Verdict(StrEnum):
    """Outcome of a check."""

    OK = "ok"
    WARNING = "warning"
    FAILED = "failed"
    NOT_CHECKED = "not checked"


@dataclass(frozen=True)
class Check:
    """One limit held against a recording.

    Attributes:
        name: Key of the limit in the lift file.
        verdict: The outcome.
        formula: What is compared with what, in words.
        value: Governing value [SI]; None if there was nothing to check.
        limit: The limit [SI]; None if it is not a number.
        unit: Unit in which people read both, of `gantline.units`.
        digits: Decimals with which people read both.
        where: Sling, equalizer, load or hook that governs.
        time: When it governs [s]; None where the value belongs to no one time.
        step: Step of the plan whose end was checked; empty for the whole lift.
        remark: Why there is no verdict, or what else to know.
    """

    name: str
    verdict: Verdict
    formula: str
    value: float | None = None
    limit: float | None = None
    unit: str = ""
    digits: int = 2
    where: str = ""
    time: float | None = None
    step: str = ""
    remark: str = ""

    def shown(self, number: float | None) -> str:
        """A value or limit of this check as people read it; empty for None."""
        return "" if number is None else format_quantity(number, self.unit, self.digits)
