"""How vessels lie, and how stable they are at rest, as tables."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from gantline.cli.table import table
from gantline.results.afloat.vessels import AS_CARRIED
from gantline.results.recording import Recording
from gantline.results.rig import Load, Rig
from gantline.results.rotation import heading
from gantline.results.series import ends_partly_lifted, load_is_clear, mean_over
from gantline.units import format_quantity

if TYPE_CHECKING:
    from gantline.statics import Equilibrium, Statics

#: A vessel that lies nearer, and turned by less, is where the lift file has it [m, rad].
_NEAR = 0.005
_TURNED = math.radians(0.005)
#: What bears a load and does not move.
_ASHORE = "what does not move"
#: Of a vessel at the end: variable, title, unit, decimals.
_LIES = (
    ("vessel_displacement", "displacement", "t", 1),
    ("vessel_draft_aft", "draft aft", "m", 3),
    ("vessel_draft_forward", "forward", "m", 3),
    ("vessel_heel", "heel to starboard", "deg", 3),
    ("vessel_trim", "trim by the stern", "deg", 3),
)


def recorded_motions(rig: Rig, width: int) -> list[str]:
    """Which vessels move by records, and until when these grow; a load is not to be lifted before.

    Args:
        rig: the lift.
        width: columns of text that a line may have.
    """
    rows = [
        (one.name, format_quantity(one.grows_over, "s", 1)) for one in rig.vessels if one.grows_over > 0.0
    ]
    return table(("Vessel that moves by a record", "which grows until"), rows, "lr", width) if rows else []


def vessels(recording: Recording) -> list[str]:
    """How each vessel lies at the end, and its least freeboard, at rest that there.

    In waves and gusts the last sample is a moment between a crest and a trough; a mean is told.
    """
    last = 0.0 if recording.is_equilibrium else recording.rig.time_to_average
    time = recording.time
    late = time >= time[-1:] - last if last > 0.0 else np.s_[-1:]
    rows = []
    for vessel in recording.rig.vessels:
        at_end = [
            format_quantity(mean_over(time[late], recording.column(name, vessel.name)[late]), unit, digits)
            for name, _, unit, digits in _LIES
        ]
        freeboard = recording.column("vessel_freeboard", vessel.name)
        if recording.is_equilibrium:
            freeboard = freeboard[-1:]
        rows.append((vessel.name, *at_end, format_quantity(float(freeboard.min()), "m", 3)))
    head = ("Vessel", *(title for _, title, _, _ in _LIES), "least freeboard")
    if not rows:
        return []
    over = ", over still water" if recording.rig.moved_in_still_water else ""
    of_waves = f"  means over the last {format_quantity(last, 's', 0)}; freeboard: the least of all{over}"
    carried = [f"  {one.name}: {AS_CARRIED}" for one in recording.rig.vessels if one.is_carried]
    return [*table(head, rows, "l" + "r" * (len(head) - 1)), *([of_waves] if last > 0.0 else []), *carried]


def vessels_at_rest(question: Statics, rest: Equilibrium) -> list[str]:
    """How each vessel lies at rest, and what rights it."""
    from gantline.statics.inclining import metacentric_heights
    from gantline.study.standing import AsHeld, least_heights, lessened

    lies = vessels(rest.recording)
    if not lies:
        return []
    heights = metacentric_heights(question, rest)
    held = AsHeld(question).heights(rest)
    rights = righting(least_heights(heights, held))
    elsewhere = held_elsewhere(question, [(rest, heights)])
    elsewhere += held_by_friction([""] if lessened(heights, held) else [])
    return [*lies, *_lies_aside(question, rest), *([""] if rights else []), *rights, *elsewhere]


def held_elsewhere(question: Statics, found: Iterable[tuple[Equilibrium, Collection[str]]]) -> list[str]:
    """That GM is more than the vessel's own where a load on her hangs or stands elsewhere, too.

    Args:
        question: The lift.
        found: Equilibria, each with the vessels of which GM is told.
    """
    known: set[str] = set()
    for rest, vessels_told in found:
        if not vessels_told:
            continue
        for load in rest.recording.rig.loads:
            if load_is_clear(rest.recording, load)[-1]:
                continue
            on = _stood_on(question, rest.recording, load)
            if ends_partly_lifted(rest.recording, load):
                known.add(f"{load.name}, partly lifted, holds its crane to what it stands on")
            elif len(on) > 1 and not on.isdisjoint(vessels_told):
                known.add(f"{load.name} stands on {' and '.join(sorted(on))}, and holds one to the other")
    return [f"  GM as an inclining experiment finds it: {sentence}" for sentence in sorted(known)]


def held_by_friction(moments: Sequence[str]) -> list[str]:
    """That GM is the less that friction leaves, and when, where a load stands aboard.

    Args:
        moments: Names of these moments; an empty one of a table that has no other.
    """
    of = f": {', '.join(moments)}" if any(moments) else ""
    sentence = "as friction holds what stands aboard; as if it slid, its slings hold her, and GM is more"
    return [f"  GM {sentence}{of}"] if moments else []


def _stood_on(question: Statics, recording: Recording, load: Load) -> set[str]:
    """Vessels and other bodies that bear a load, and in one name what bears it and does not move."""
    parents = {body["name"]: body["parent"] for body in question.assembly.document["bodies"]}
    on = set()
    for contact in load.contacts:
        if recording.column("contact_force", contact)[-1] > 0.0:
            body, above = _ASHORE, load.meets.get(contact)
            while above is not None:
                body, above = above, parents.get(above)
            on.add(body)
    return on


def _lies_aside(question: Statics, rest: Equilibrium) -> list[str]:
    """Vessels that lie elsewhere than the lift file has them: how far along their own axes, how turned."""
    from gantline.assembly.afloat.vessels import way_of

    recording = rest.recording
    places = dict(zip(recording.coordinates["body"], recording["body_position"].values[-1], strict=True))
    bodies = {body["name"]: body for body in question.assembly.document["bodies"]}
    lines = []
    for vessel in (one for one in recording.rig.vessels if not one.is_carried):
        body = bodies[vessel.body]
        orientations = [body["joint"]["orientation"], recording.column("body_orientation", vessel.body)[-1]]
        given, heads = heading(np.array(orientations))
        turned = math.remainder(heads - given, math.tau)
        x, y, _ = way_of(bodies, vessel.body, places)
        ahead = math.cos(given) * x + math.sin(given) * y
        to_port = math.cos(given) * y - math.sin(given) * x
        ways = [("ahead", "aft", ahead), ("to port", "to starboard", to_port)]
        told = " and ".join(_way(*way) for way in ways if abs(way[2]) >= _NEAR)
        lies = [f"lies {told} of where the lift file has it"] if told else []
        if abs(turned) >= _TURNED:
            side = "port" if turned > 0 else "starboard"
            lies.append(f"turned {format_quantity(abs(turned), 'deg', 2)} to {side}")
        if lies:
            lines.append(f"  {vessel.name} {', '.join(lies)}")
    return lines


def _way(forth: str, back: str, way: float) -> str:
    return f"{format_quantity(abs(way), 'm', 2)} {forth if way > 0 else back}"


def righting(heights: Mapping[str, tuple[float, float]]) -> list[str]:
    """What rights each vessel, GM for heel and trim [m]; nothing where none floats freely."""
    rows = [(name, *(format_quantity(height, "m", 2) for height in both)) for name, both in heights.items()]
    if not rows:
        return []
    return table(("Righting", "GM transverse, with free surfaces", "longitudinal"), rows, "lrr")
