"""Limits of a lift held against its recording."""

from gantline.checks.check import (
    LOAD_LIFTED,
    Check,
    Outcome,
    Verdict,
    failed_names,
    foremost,
    governing,
    has_failed,
    outcome_of,
    past_limits,
    verdict_of,
)
from gantline.checks.crawlers import highest_pressure, highest_tipping
from gantline.checks.ends import end_of_step
from gantline.checks.gauges import Gauge, winch_gauges
from gantline.checks.limits import LIMITS
from gantline.checks.lug_figures import LugFigures, lug_figures
from gantline.checks.ratings import shown_places
from gantline.checks.readings import HoldPoint, HookReading, hold_points, hook_readings
from gantline.checks.run import NO_WARNINGS, check_recording, values_of

__all__ = [
    "LIMITS",
    "LOAD_LIFTED",
    "NO_WARNINGS",
    "Check",
    "Gauge",
    "HoldPoint",
    "HookReading",
    "LugFigures",
    "Outcome",
    "Verdict",
    "check_recording",
    "end_of_step",
    "failed_names",
    "foremost",
    "governing",
    "has_failed",
    "highest_pressure",
    "highest_tipping",
    "hold_points",
    "hook_readings",
    "lug_figures",
    "outcome_of",
    "past_limits",
    "shown_places",
    "values_of",
    "verdict_of",
    "winch_gauges",
]
