"""Limits of a lift held against its recording."""

from gantline.checks.check import Check, Verdict
from gantline.checks.limits import LIMITS
from gantline.checks.run import check_recording, end_of_step, has_failed

__all__ = ["LIMITS", "Check", "Verdict", "check_recording", "end_of_step", "has_failed"]
