"""Where bodies and points of them are, from columns of the core."""

from __future__ import annotations

from collections.abc import Sequence

from gantline.results.rotation import axes
from gantline.results.variable import Columns, FloatArray, Names

__all__ = ["axes_of", "places_of"]


def axes_of(columns: Columns, names: Names, body: str) -> FloatArray:
    """Matrices world from body, shape (time, 3, 3); their columns are the body's axes.

    Args:
        columns: Columns of the core by name.
        names: Names along their dimensions.
        body: Name of the body.
    """
    return axes(columns["body_orientation"][:, list(names["body"]).index(body)])


def places_of(columns: Columns, names: Names, body: str, offset: Sequence[float] | FloatArray) -> FloatArray:
    """Where a point of a body is, shape (time, 3) [m].

    Args:
        columns: Columns of the core by name.
        names: Names along their dimensions.
        body: Name of the body.
        offset: The point from its centre of gravity, in its axes (3,) [m].
    """
    centre = columns["body_position"][:, list(names["body"]).index(body)]
    places: FloatArray = centre + axes_of(columns, names, body) @ offset
    return places
