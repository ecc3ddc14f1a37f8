"""Whether a run got through its plan, its hoists followed it, and it lifted anything."""

from __future__ import annotations

from gantline.checks.check import LOAD_LIFTED, PLAN_FINISHED, Check, Verdict
from gantline.checks.measure import named
from gantline.results import progress
from gantline.results.recording import Recording

#: A load of which less than this share ever hangs has not been lifted [1].
_LIFTED_FROM = 0.05
#: Motors that pull all they can for longer in all are told [s]; at starts and stops that is nothing.
_LONG = 1.0


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


def not_lifted(recording: Recording) -> list[Check]:
    """A warning for each load with slings that stays on its supports: nothing that it carries was tried."""
    checks = []
    for load in recording.rig.loads if recording.rig.slings else ():
        if load.name not in recording.coordinates.get("load", ()) or not len(recording.time):
            continue
        most = float(recording.column("load_transferred", load.name).max())
        if most < _LIFTED_FROM:
            remark = f"'{load.name}' is not lifted, {max(100 * most, 0.0):.0f} % of its weight hangs at most"
            checks.append(
                Check(LOAD_LIFTED, Verdict.WARNING, "loads are lifted", "", element=load.name, remark=remark)
            )
    return checks


def fell_behind(recording: Recording) -> list[Check]:
    """A warning for each hoist whose motor or brake pulled all it could while its drum did not follow."""
    hoists = [drum.name for drum in recording.rig.drums if drum.paid_out < 0.0]
    checks = []
    for drum in hoists:
        begins = [time for time, _, name in recording.events("drum_slips") if name == drum]
        if not begins:
            continue
        ends = [time for time, _, name in recording.events("drum_holds") if name == drum]
        # One that slips at the end of the run has not come to hold again.
        ends += [float(recording.time[-1])] * (len(begins) - len(ends))
        lasted = sum(ends) - sum(begins)
        if lasted > _LONG:
            remark = f"from {begins[0]:.4g} s on, for {lasted:.3g} s, motor or brake pull all they can"
            meaning = "drums of hoists follow the plan"
            checks.append(Check("hoist_follows", Verdict.WARNING, meaning, element=drum, remark=remark))
    return checks
