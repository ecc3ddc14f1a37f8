"""Landing guides in a recording: what presses on them, and loads that come down beside them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from gantline.results.bodies import axes_of, places_of
from gantline.results.strength import FromJson
from gantline.results.variable import Columns, Derived, FloatArray, Names, Variable
from gantline.units import format_quantity

__all__ = ["Guide", "guide_force", "guide_state", "missed_guides", "told_missed"]

#: Faces that look at each other, of frames; those of the other pair stand across them.
_OPPOSITE = (("fore", "aft"), ("port", "starboard"))
#: A load that stands on the tip of a post is as near to it [m].
_ON_TIP = 0.02
#: What comes down farther than this beside its post was taken elsewhere: modules are to move by no more
#: before they come to their guides (0027/ND, 17.2) [m].
_FAR = 1.5
#: Rounding of places [m].
_JUST = 1e-6


@dataclass(frozen=True)
class Guide(FromJson):
    """A landing guide.

    Attributes:
        name: Its name in the lift file.
        load: The load that it guides.
        sides: Contacts of the recording by the face that they are of: `fore`, `aft`, `port`, `starboard` of a
            frame, or `wall`.
        capacity: Largest force that it may take across its faces [N]; None if not said.
    """

    name: str
    load: str
    sides: Mapping[str, Sequence[str]] = field(default_factory=dict)
    capacity: float | None = None

    @property
    def contacts(self) -> list[str]:
        """All its contacts, in the order of the recording."""
        return [contact for side in self.sides.values() for contact in side]

    def used_by(self, force: float) -> float | None:
        """A force [N] over its capacity; None where that is not said."""
        return None if self.capacity is None else force / self.capacity


def guide_state(columns: Columns, names: Names, guides: Sequence[Guide]) -> Derived:
    """Forces of guides over time, by (LG8) of docs/concepts/landing_guide.md.

    Args:
        columns: Columns of the core by name.
        names: Names along their dimensions.
        guides: Guides of the rig.
    """
    if not guides:
        return {}, {}
    order = {name: place for place, name in enumerate(names["contact"])}
    pressed = columns["contact_force"]
    force = np.stack([guide_force(guide, pressed, order) for guide in guides], axis=1)
    described = "force across the faces of a landing guide"
    return (
        {"guide_force": Variable(("time", "guide"), force, "N", described)},
        {"guide": [guide.name for guide in guides]},
    )


def guide_force(guide: Guide, pressed: FloatArray, order: Mapping[str, int]) -> FloatArray:
    """Force of a guide across its faces over time [N].

    Args:
        guide: The guide.
        pressed: Force of each contact over time, shape (time, contact) [N].
        order: Place of each contact by its name.
    """
    nothing = np.zeros(len(pressed))
    face = {
        side: pressed[:, [order[contact] for contact in contacts]].sum(axis=1)
        for side, contacts in guide.sides.items()
    }
    if "wall" in face:
        wall: FloatArray = face["wall"]
        return wall
    along, across = (np.maximum(face.get(one, nothing), face.get(other, nothing)) for one, other in _OPPOSITE)
    together: FloatArray = np.hypot(along, across)
    return together


def missed_guides(
    document: Mapping[str, Any], guides: Sequence[Guide], columns: Columns, names: Names
) -> list[str]:
    """A sentence for each guide on whose tip a load stands, or beside which it comes down, when it does.

    Args:
        document: What has been assembled of the lift.
        guides: Those of the rig.
        columns: Columns of the core by name.
        names: Names along their dimensions.
    """
    if not guides or not len(columns["time"]):
        return []
    pairs = {one["name"]: one for one in document["landings"]}
    found = []
    for guide in guides:
        missed = [
            one
            for side, contacts in guide.sides.items()
            for one in _missed(
                document, pairs[contacts[0].rpartition("/")[0]], contacts, columns, names, side
            )
        ]
        if missed:
            time, words, by = min(missed)
            lacks = f"it misses by {format_quantity(by, 'm', 2)}"
            found.append(f"{_misses(guide)}{words} at {format_quantity(time, 's', 2)}; {lacks}")
    return found


def told_missed(guides: Sequence[Guide], warnings: Iterable[str]) -> dict[str, str]:
    """What `missed_guides` has told in the warnings of a recording, by the name of the guide."""
    told = tuple(warnings)
    return {
        guide.name: one.removeprefix(_misses(guide))
        for guide in guides
        for one in told
        if one.startswith(_misses(guide))
    }


def _misses(guide: Guide) -> str:
    return f"the load misses guide {guide.name}: "


def _missed(
    document: Mapping[str, Any],
    pair: Mapping[str, Any],
    contacts: Sequence[str],
    columns: Columns,
    names: Names,
    side: str,
) -> list[tuple[float, str, float]]:
    """When a face first stands on the tip or is on the wrong side of its post, words for it, by how much."""
    post, wall = pair["post"], pair["wall"]
    base, axis = _seen(document, columns, names, post["body"], post["base"], post["axis"])
    radius, top = post.get("tip_radius", post["radius"]), post["height"] + post.get("cone", 0.0)
    normal, up = np.array(wall["normal"]), np.array(wall["up"])
    flare, angle = wall.get("flare", 0.0), wall.get("angle", 0.0)
    lip = np.array(wall["knee"]) - flare * (np.cos(angle) * up + np.sin(angle) * normal)
    edge, inwards = _seen(document, columns, names, wall["body"], lip, normal)
    along = _seen(document, columns, names, wall["body"], lip, np.cross(up, normal))[1]
    apart = base - edge
    # Of the lip over the tip, along the post; of the axis from the lip, towards the post and aside.
    over = -np.einsum("ti,ti->t", apart, axis) - top
    inside = np.einsum("ti,ti->t", apart + top * axis, inwards)
    aside = np.abs(np.einsum("ti,ti->t", apart + top * axis, along))
    near = aside < wall["breadth"] / 2
    order = list(names["contact"])
    pressed = columns["contact_force"][:, [order.index(contact) for contact in contacts]].max(axis=1)
    # A face that slides past the tip is pressed into it from aside, by its force over its stiffness.
    onto = radius - pressed / pair["stiffness"] - _JUST
    stands = near & (pressed > 0.0) & (np.abs(over) < _ON_TIP) & (np.abs(inside) < onto)
    # What has not been over the tip yet has not come down: a load that waits elsewhere, lower than that.
    was_over = np.logical_or.accumulate(over > 0.0)
    beside = near & was_over & (over < -_ON_TIP) & (inside < -radius) & (inside > -radius - _FAR)
    face = "its wall" if side == "wall" else f"the {side} side of its frame"
    kinds = (
        (stands, f"{face} stands on the rim of the {'bumper' if side == 'wall' else 'post'}"),
        (beside, f"{face} is on the wrong side of the {'bumper' if side == 'wall' else 'post'}"),
    )
    firsts = [(int(np.argmax(when)), words) for when, words in kinds if when.any()]
    # With its lip outside of the tip a face catches it.
    return [(float(columns["time"][first]), words, float(radius - inside[first])) for first, words in firsts]


def _seen(
    document: Mapping[str, Any],
    columns: Columns,
    names: Names,
    body: str | None,
    at: Sequence[float] | FloatArray,
    direction: Sequence[float] | FloatArray,
) -> tuple[FloatArray, FloatArray]:
    """Where a point of a body is [m] and how a direction of it lies, both (time, 3); None is the world."""
    shape = (len(columns["time"]), 3)
    if body is None:
        return np.broadcast_to(np.asarray(at), shape), np.broadcast_to(np.asarray(direction), shape)
    centre = next(one["centre_of_gravity"] for one in document["bodies"] if one["name"] == body)
    turned: FloatArray = axes_of(columns, names, body) @ np.asarray(direction)
    return places_of(columns, names, body, np.asarray(at) - np.asarray(centre)), turned
