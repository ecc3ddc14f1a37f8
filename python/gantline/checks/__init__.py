"""Limits of a lift held against its recording."""

from gantline.checks.check import Check, Verdict, governing, has_failed, past_limits, verdict_of
from gantline.checks.limits import LIMITS
from gantline.checks.run import check_recording, end_of_step, values_of

__all__ = [
    "LIMITS",
    "Check",
    "Verdict",
    "check_recording",
    "end_of_step",
    "governing",
    "has_failed",
    "past_limits",
    "values_of",
    "verdict_of",
]
