"""A section of the report: chain hoists of slings."""

from __future__ import annotations

from typing import Any

from gantline.checks import values_of
from gantline.report.section import Section
from gantline.report.subject import ABSENT, Subject, as_given, number
from gantline.results.cranes.chain_uses import ChainUse, chain_uses


class ChainHoists(Section):
    """How far each chain hoist hauls in and pays out, and what it carries of what it may."""

    anchor = "chain-hoists"
    title = "Chain hoists"
    template = "chain_hoists.html"

    def content(self, subject: Subject) -> dict[str, Any] | None:
        """What the template is given."""
        used = values_of(subject.recording, "chain_hoist_load_of_rated_capacity")
        rows = [_row(subject, one, used.get(one.hoist.name)) for one in chain_uses(subject.recording)]
        return {"hoists": rows} if rows else None


def _row(subject: Subject, one: ChainUse, used: float | None) -> dict[str, Any]:
    room, rated = one.hoist.range, one.hoist.rated_capacity
    return {
        "name": one.hoist.name,
        "last": number(one.last, "m", 3),
        "least": number(one.least, "m", 3),
        "most": number(one.most, "m", 3),
        "range": ABSENT if room is None else " to ".join(number(end, "m", 2) for end in room),
        "force": number(one.force, "kN", 0),
        "time": number(one.time, "s", 1),
        "rated": as_given(None if rated is None else rated / subject.rig.gravity),
        "used": number(used, "%", 0),
    }
