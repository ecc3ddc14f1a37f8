"""How far slings may be off the length that they are made to."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from pydantic.json_schema import JsonSchemaValue
from pydantic_core import PydanticCustomError

from gantline.scenario.quantities import Quantity, Reader, refuse
from gantline.units import UnitError, common_dimension

__all__ = ["LARGEST_TOLERANCE", "LengthTolerance", "Tolerance"]

#: Share of its length by which a sling may be off at most; beyond it a '%' was left out, or a unit slipped.
LARGEST_TOLERANCE = 0.1


@dataclass(frozen=True)
class Tolerance:
    """What a length may be off, plus and minus.

    Attributes:
        amount: as a share of the length, or a length [m].
        kind: which of them.
    """

    amount: float
    kind: Literal["ratio", "length"]

    def of(self, length: float) -> float:
        """What a sling of this length [m] may be off [m]."""
        return self.amount * length if self.kind == "ratio" else self.amount


def _kind(text: str) -> Literal["ratio", "length"]:
    """Which of both a text is by its unit; what is neither is refused as a share."""
    try:
        return "length" if common_dimension(text, among=("length", "ratio")) == "length" else "ratio"
    except UnitError:
        return "ratio"


@dataclass(frozen=True)
class _ToleranceReader(Reader):
    """Reads a share of the length, or a length."""

    def read(self, value: object) -> Tolerance:
        """The tolerance."""
        kind = _kind(str(value))
        try:
            tolerance = Tolerance(Quantity(kind, "not_negative").read(value), kind)
        except PydanticCustomError as error:
            more = "; or a length like '25 mm'" if kind == "ratio" else ""
            raise refuse(f"{error.message()}{more}") from None
        if kind == "ratio" and tolerance.amount > LARGEST_TOLERANCE:
            sentence = f"a sling that is {tolerance.amount * 100:g} % too long or too short is none"
            raise refuse(f"{sentence}; at most 10 % is right, such as 'tolerance: 0.25 %', or '25 mm'")
        return tolerance

    def shown(self) -> JsonSchemaValue:
        """A share, or a length."""
        return {"anyOf": [Quantity(kind, "not_negative").shown() for kind in ("ratio", "length")]}


LengthTolerance = Annotated[Tolerance, _ToleranceReader()]
