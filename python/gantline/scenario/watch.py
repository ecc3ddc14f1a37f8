"""Distances that are watched, over the whole lift or some steps of it."""

from __future__ import annotations

from typing import Annotated, ClassVar

from pydantic import Field, model_validator

from gantline.scenario.base import Element
from gantline.scenario.quantities import ListOf, NameText, NotNegativeLength, Text, refuse

__all__ = ["Watch"]

_Two = Annotated[tuple[str, str], ListOf(NameText(), 2)]


class Watch(Element):
    """The smallest distance between two things."""

    what: ClassVar[str] = "a watched pair"

    between: _Two = Field(
        description="Two names: of the load, a structure or a part of it ('dock.walls'), 'ground', a group "
        "of supports, an equalizer, a hook ('goliath.U1'), a body of 'mechanics' with a shape; and on one "
        "side also of a rope ('sling.S1'), or 'slings', or 'ropes'."
    )
    smallest: NotNegativeLength = Field(
        0.0, description="Distance below which there is a warning; 0 if not given: where they touch."
    )
    from_ends: NotNegativeLength = Field(
        1.0,
        description="Of ropes: what is left out at an end that is made fast on the other of the pair; 1 m if "
        "not given, since there every sling touches its load.",
    )
    from_step: Text | None = Field(
        None, description="Step of the plan as which begins it counts; from the start if not given."
    )
    to_step: Text | None = Field(
        None, description="Step of the plan with whose end it ceases to count; to the end if not given."
    )

    @model_validator(mode="after")
    def _is_of_two_things(self) -> Watch:
        one, other = self.between
        if one == other:
            raise refuse(f"both are '{one}'; two things have a distance", "between")
        return self
