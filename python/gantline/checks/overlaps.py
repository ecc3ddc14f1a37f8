"""Load, equalizer frames, cranes, hulls and structures that run into each other and nobody watches."""

from __future__ import annotations

from gantline.checks.check import Check, Verdict
from gantline.results.overlaps import overlaps
from gantline.results.recording import Recording

__all__ = ["run_into"]


def run_into(recording: Recording) -> list[Check]:
    """A check for each pair of bodies that are drawn in the same place.

    A warning where that may be a matter of how they are drawn; it fails where one reaches past the middle of
    the other.
    """
    checks = []
    for found in overlaps(recording):
        one, other = found.between
        remark = f"{one} and {other} are drawn in the same place, {found.depth:.2f} m deep"
        if found.is_past_middle:
            verdict, more = Verdict.FAILED, "no drawing makes that good"
        else:
            verdict, more = (
                Verdict.WARNING,
                "drawn sizes of cranes are rough: a pair under 'watch' takes the place of this",
            )
        meaning = "load, equalizer frames, cranes, hulls and structures stay outside of each other"
        checks.append(
            Check(
                "no_overlap",
                verdict,
                meaning,
                element=f"{one} to {other}",
                time=found.time,
                remark=f"{remark}; {more}",
            )
        )
    return checks
