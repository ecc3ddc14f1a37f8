"""What chain hoists of slings have paid out, and what they carry of what they may, as a table."""

from __future__ import annotations

from gantline.checks import values_of
from gantline.cli.table import ABSENT, show, table
from gantline.results.cranes.chain_uses import chain_uses
from gantline.results.recording import Recording


def chain_hoist_table(recording: Recording) -> list[str]:
    """One row for each chain hoist; of an equilibrium where it is, of a run how far it went."""
    used = values_of(recording, "chain_hoist_load_of_rated_capacity")
    stands = recording.is_equilibrium
    rows = []
    for one in chain_uses(recording):
        ways = [one.last] if stands else [one.last, one.least, one.most]
        ends = one.hoist.range
        room = ABSENT if ends is None else " to ".join(show(end, "m", 2) for end in ends)
        carries = (show(one.force, "kN", 1), show(used.get(one.hoist.name), "%", 1))
        rows.append((one.hoist.name, *(show(way, "m", 3) for way in ways), room, *carries))
    heads = ("paid out",) if stands else ("paid out at the end", "least", "most")
    force = "force" if stands else "largest force"
    head = ("Chain hoist", *heads, "range", force, "of rated capacity")
    return table(head, rows, "l" + "r" * (len(head) - 1)) if rows else []
