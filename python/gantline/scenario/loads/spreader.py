"""Spreaders: bars, beams and frames between slings that hold them and slings that hang from them."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from pydantic import Field

from gantline.scenario.base import Element, Named
from gantline.scenario.loads.load import LoadInertia
from gantline.scenario.loads.lug import Lug
from gantline.scenario.quantities import Angle, Name, Position, PositiveMass, Sizes

if TYPE_CHECKING:
    from gantline.scenario.model import Scenario

__all__ = ["Spreader", "spreader_lugs"]


class Spreader(Element):
    """A bar, beam or frame that hangs on slings and has slings below it: a rigid body."""

    what: ClassVar[str] = "a spreader"

    type: Name | None = Field(
        None, description="A name of 'spreader_types' that gives what is not said here."
    )
    mass: PositiveMass = Field(description="Mass, with its own fittings and without shackles and slings.")
    size: Sizes = Field(description="Length x, breadth y, height z of its box.")
    lugs: Named[Lug] = Field(
        description="Lugs above and below by name, each from the middle of its box along its axes; slings "
        "call them <spreader>.<lug>."
    )
    centre_of_gravity: Position = Field(
        (0.0, 0.0, 0.0), description="From the middle of its box, along its axes."
    )
    inertia: LoadInertia | None = Field(
        None, description="About its centre of gravity, along its axes; of a solid box if not given."
    )
    heading: Angle | None = Field(
        None, description="Direction of its x axis at the start; that of the load if not given."
    )
    rated_capacity: PositiveMass | None = Field(None, description="Working load limit, of all below it.")

    def off(self, at: tuple[float, float, float]) -> float:
        """How far a place is outside of its box, along the axis on which it is most [m]; negative inside."""
        return max(abs(part) - size / 2 for part, size in zip(at, self.size, strict=True))


def spreader_lugs(scenario: Scenario) -> list[str]:
    """Lugs of all spreaders, as slings call them."""
    return [f"{name}.{lug}" for name, one in (scenario.spreaders or {}).items() for lug in one.lugs]
