"""Chain hoists as parts of slings: steps of the plan change the length of a sling while it carries."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, ClassVar, Final

from pydantic import Field, model_validator

from gantline.scenario.base import Element
from gantline.scenario.quantities import (
    ListOf,
    Mass,
    PositiveAcceleration,
    PositiveMass,
    PositiveSpeed,
    Quantity,
    refuse,
)

if TYPE_CHECKING:
    from gantline.scenario.findings import Findings
    from gantline.scenario.rigging import Rigging, SlingRigging

__all__ = ["ChainHoist", "chain_flow", "check_chain_hoists"]

#: Time in which a chain hoist comes to its highest speed where the lift file has no acceleration [s].
_STARTS_IN: Final = 1.0

_Range = Annotated[tuple[float, float], ListOf(Quantity("length"), 2, right="[-0.5 m, 1.5 m]")]


class ChainHoist(Element):
    """A chain hoist, hydraulic cylinder or turnbuckle that is a part of a sling."""

    what: ClassVar[str] = "the chain hoist of a sling"

    speed: PositiveSpeed = Field(description="Highest speed of the chain, or of the rod of a cylinder.")
    acceleration_: PositiveAcceleration | None = Field(
        None,
        alias="acceleration",
        description="Highest acceleration; what brings it to its highest speed within 1 s if not given.",
    )
    rated_capacity: PositiveMass | None = Field(
        None, description="Working load limit, along the sling that it is a part of."
    )
    range_: _Range | None = Field(
        None,
        alias="range",
        description="Least and largest change of the sling's length from that at the start, such as "
        "[-0.5 m, 1.5 m]: what can be hauled in, and paid out; no limit if not given.",
    )
    mass: Mass = Field(0.0, description="Its mass; it hangs at the upper end of the sling.")

    @model_validator(mode="after")
    def _range_is_one(self) -> ChainHoist:
        if self.range_ is None:
            return self
        low, high = self.range_
        if low >= high:
            sentence = f"a range goes from the least to the largest change; found {low:g} m to {high:g} m"
            raise refuse(sentence, "range")
        if not low <= 0.0 <= high:
            sentence = f"a range of changes of length has 0 in it, where the lift begins; found {low:g} m"
            right = "such as [-0.5 m, 1.5 m] for 0.5 m to haul in and 1.5 m to pay out"
            raise refuse(f"{sentence} to {high:g} m; {right}", "range")
        return self

    @property
    def acceleration(self) -> float:
        """Highest acceleration of the chain [m/s^2]."""
        return self.speed / _STARTS_IN if self.acceleration_ is None else self.acceleration_


def chain_flow(sling: str) -> str:
    """Name of the chain that the hoist of a sling has paid out, among the joints of a recording."""
    return f"sling.{sling}.chain_hoist"


def check_chain_hoists(findings: Findings, rigging: Rigging) -> None:
    """Note chain hoists in slings whose length they cannot change."""
    for name, sling in rigging.slings.items():
        if sling.chain_hoist is None:
            continue
        why = _why_not(findings, rigging, sling)
        if why is not None:
            findings.add(("slings", name, "chain_hoist"), why)
        range_ = sling.chain_hoist.range_
        if range_ is not None and sling.length + range_[0] <= 0.0:
            sentence = (
                f"{-range_[0]:g} m to haul in are all of the sling, {sling.length:.4g} m from end to end"
            )
            right = "its least change is less than that, such as [-0.5 m, 1.5 m]"
            findings.add(("slings", name, "chain_hoist", "range"), f"{sentence}; {right}")
        if f"sling.{name}" in (findings.scenario.mooring_lines or {}):
            sentence = f"steps would not know the mooring line 'sling.{name}' from this sling"
            findings.add(("mooring_lines", f"sling.{name}"), f"{sentence}; it needs another name")


def _why_not(findings: Findings, rigging: Rigging, sling: SlingRigging) -> str | None:
    """Why a sling cannot have a chain hoist; None where it can."""
    if sling.over is not None:
        return f"this sling runs over '{sling.over}', from end to end; a chain hoist is in one with 'from'"
    if sling.weight.nodes:
        return "this sling has nodes, of fixed lengths between them; 'rope_weight: lumped' or 'none' is right"
    if sling.equalizer is not None and not rigging.equalizers[sling.equalizer].has_sheaves:
        sentence = f"'{sling.equalizer}' adjusts the length of this sling all the time"
        return f"{sentence}; 'mechanism: sheaves' is right"
    if sling.rope.inextensible:
        return "this sling is inextensible; give its rope an axial stiffness"
    given = (findings.scenario.slings or {})[sling.name]
    defaults = findings.scenario.sling_defaults
    rope = given.rope or (defaults.rope if defaults is not None else None)
    return sling.rope.bent(str(rope), "a sling with a chain hoist")
