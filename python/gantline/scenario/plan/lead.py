"""The step that leads the load: cranes that slew move together so that their hooks go as one rigid body.

docs/concepts/lead.md has the equations.
"""

from __future__ import annotations

from typing import Annotated, ClassVar

from pydantic import Field, model_validator

from gantline.scenario.plan.steps import StartingStep
from gantline.scenario.quantities import (
    Angle,
    ListOf,
    Names,
    Position,
    PositiveAcceleration,
    PositiveSpeed,
    Quantity,
    refuse,
)

__all__ = ["LeadStep"]

_Axis = Annotated[tuple[float, float] | None, ListOf(Quantity("length"), 2)]


class LeadStep(StartingStep):
    """A step in which hooks lead the load along a way, and their cranes slew, luff and hoist for it."""

    what: ClassVar[str] = "a lead step"

    lead: Names = Field(
        description="Hook or hooks that lead the load, each of another crane that slews: they keep their "
        "distances, and their falls stay plumb."
    )
    by: Position = Field((0.0, 0.0, 0.0), description="Way of the load along x, y and z of the world.")
    turn: Angle = Field(0.0, description="Angle by which the load turns meanwhile, from x towards y.")
    about: _Axis = Field(
        None,
        description="Vertical axis about which it turns, x and y of the world as the step begins; midway "
        "between the hooks if not given.",
    )
    speed: PositiveSpeed = Field(description="Speed of the hook that goes fastest.")
    acceleration: PositiveAcceleration = Field(description="Acceleration of that hook along its way.")
    travelling: Names = Field(
        (),
        description="Crane or cranes of these that travel and slew, and keep their radius; the others slew "
        "and luff.",
    )

    verb: ClassVar[str] = "lead"
    #: It ends where its way does.
    until: ClassVar[None] = None

    @model_validator(mode="after")
    def _goes_somewhere(self) -> LeadStep:
        if not any(self.by) and self.turn == 0.0:
            raise refuse("goes nowhere; 'by: [0 m, 12 m, 0 m]', say, or 'turn: 30 deg' is needed")
        if self.about is not None and self.turn == 0.0:
            raise refuse("an axis without 'turn', the angle about it", "about")
        if self.turn != 0.0 and self.about is None and len(self.lead) == 1:
            sentence = "one hook does not turn a load about itself"
            raise refuse(f"{sentence}; 'about: [12 m, 30 m]', say, takes it round that axis", "turn")
        return self
