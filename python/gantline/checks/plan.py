"""Whether a run got through its plan."""

from __future__ import annotations

from gantline.checks.check import PLAN_FINISHED, Check, Verdict
from gantline.checks.measure import named
from gantline.results import progress
from gantline.results.recording import Recording


def unfinished(recording: Recording) -> Check | None:
    """A warning where a run ends before its plan: what did not happen has not been checked."""
    left = progress.unfinished(recording)
    if left is None:
        return None
    at = f" in '{left.under_way[0]}'" if left.under_way else ""
    not_begun = f"; not begun: {named(left.not_begun)}" if left.not_begun else ""
    return Check(
        PLAN_FINISHED,
        Verdict.WARNING,
        "all steps of the plan within the run",
        remark=f"the run ends at {recording.time[-1]:.4g} s{at}{not_begun}",
    )
