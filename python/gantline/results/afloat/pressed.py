"""Fenders that are pressed by more than they are thick, where what they stand before is met."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from gantline.results.afloat.moorings import Fender
from gantline.results.bodies import axes_of, places_of
from gantline.results.variable import Columns, FloatArray, Names
from gantline.units import format_quantity

__all__ = ["DEEP", "pressed_through"]

#: A fender whose thickness is not said gives less than this [m].
DEEP = 1.0


def pressed_through(
    document: Mapping[str, Any], fenders: Sequence[Fender], columns: Columns, names: Names
) -> list[str]:
    """A sentence for each fender that is pressed by more than it is thick, at the worst moment recorded.

    Args:
        document: What has been assembled of the lift.
        fenders: Those of the rig.
        columns: Columns of the core by name.
        names: Names along their dimensions.
    """
    contacts = {one["name"]: one for one in document.get("contacts", ())} if fenders else {}
    found = []
    for fender in fenders if len(columns["time"]) else ():
        contact = contacts[fender.contact]
        place = _places(document, columns, names, contact["body"], contact["at"])
        wall, normal = np.asarray(contact["plane_point"]), np.asarray(contact["plane_normal"])
        before: FloatArray = np.broadcast_to(normal, place.shape)
        if (body := contact.get("plane_body")) is not None:
            wall = _places(document, columns, names, body, wall)
            before = axes_of(columns, names, body) @ normal
        deep = np.einsum("ti,ti->t", wall - place, before)
        worst = int(np.argmax(deep))
        if deep[worst] <= (fender.thickness or DEEP):
            continue
        shown = format_quantity(float(deep[worst]), "m", 2)
        pressed = f"fender {fender.name} is pressed {shown} deep at {columns['time'][worst]:.2f} s"
        if fender.thickness:
            found.append(f"{pressed}, and is {fender.thickness:g} m thick: its wall is met before")
        else:
            found.append(f"{pressed}: see its 'stiffness', and say its 'thickness'")
    return found


def _places(
    document: Mapping[str, Any], columns: Columns, names: Names, body: str, at: Sequence[float] | FloatArray
) -> FloatArray:
    """Where a point of a body is (time, 3) [m].

    Args:
        document: What has been assembled of the lift.
        columns: Columns of the core by name.
        names: Names along their dimensions.
        body: Its name.
        at: The point in its axes (3,) [m].
    """
    centre = next(one["centre_of_gravity"] for one in document["bodies"] if one["name"] == body)
    return places_of(columns, names, body, np.asarray(at) - np.asarray(centre))
