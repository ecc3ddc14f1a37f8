"""Whether a run got through its plan."""

from __future__ import annotations

from gantline.checks.check import PLAN_FINISHED, Check, Verdict
from gantline.checks.measure import named
from gantline.results.recording import Recording


def unfinished(recording: Recording) -> Check | None:
    """A warning where a run ends before its plan: what did not happen has not been checked.

    A hold that is under way has nothing left to do; any other step has.
    """
    begun = {name for _, _, name in recording.events("step_begin")}
    ended = {name for _, _, name in recording.events("step_end")}
    plan = recording.rig.plan
    left = [step.step for step in plan if step.step not in begun]
    under_way = [step.step for step in plan if step.step in begun - ended and step.kind != "hold"]
    if not (left or under_way) or not len(recording.time):
        return None
    at = f" in '{under_way[0]}'" if under_way else ""
    not_begun = f"; not begun: {named(left)}" if left else ""
    return Check(
        PLAN_FINISHED,
        Verdict.WARNING,
        "all steps of the plan within the run",
        remark=f"the run ends at {recording.time[-1]:.4g} s{at}{not_begun}",
    )
