"""Loads, gear, cranes, hulls, structures and supports that run into each other and nobody watches."""

from __future__ import annotations

from gantline.checks.check import Check, Verdict
from gantline.results.loads.overlaps import overlaps
from gantline.results.recording import Recording

__all__ = ["run_into"]

#: Why a load may go through a support, and what holds it up.
_TOPS_ONLY = (
    "supports carry by their tops what comes down on them, and stand in the way of nothing; a box under "
    "'structures' is touched by all of its sides"
)
#: What holds a load off a hull or what stands on it, which no key of either does.
_NO_CONTACT = ", and a load goes through hulls and decks unless 'body_contacts' of 'mechanics' let them touch"


def run_into(recording: Recording) -> list[Check]:
    """A check for each pair of bodies that are drawn in the same place.

    A warning where that may be a matter of how they are drawn; it fails where one reaches past the middle of
    the other.
    """
    checks = []
    for found in overlaps(recording):
        one, other = found.between
        remark = f"{one} and {other} are drawn in the same place, {found.depth:.2f} m deep"
        verdict = Verdict.FAILED if found.is_past_middle else Verdict.WARNING
        if found.support is not None:
            more = f"{found.support} carries nothing then: {_TOPS_ONLY}"
        elif found.is_past_middle:
            more = "no drawing makes that good" + (
                _NO_CONTACT if _may_be_set_on(recording, {one, other}) else ""
            )
        elif found.is_of_hulls:
            more = (
                "hulls go through each other and structures unless fenders or 'body_contacts' hold them off"
            )
        else:
            more = "drawn sizes of cranes are rough: a pair under 'watch' takes the place of this"
        meaning = "load, equalizer frames, cranes, hulls, structures and supports stay outside of each other"
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


def _may_be_set_on(recording: Recording, pair: set[str]) -> bool:
    """Whether one of two is a load and the other a vessel, or a body of `mechanics` that stands somewhere."""
    rig = recording.rig
    places = {*(vessel.name for vessel in rig.vessels), *rig.fixtures}
    return bool(pair & {load.name for load in rig.loads}) and bool(pair & places)
