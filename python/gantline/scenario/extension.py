"""Extension sheaves: they hang on a sling and serve two lugs each, or two further extension sheaves."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar, NamedTuple

from pydantic import Field

from gantline.scenario.base import Element
from gantline.scenario.errors import nearest
from gantline.scenario.loads.spreader import spreader_lugs
from gantline.scenario.quantities import PositiveLength, PositiveMass

if TYPE_CHECKING:
    from gantline.scenario.findings import Findings, Path
    from gantline.scenario.gear import RopeMaterial, Sling
    from gantline.scenario.rigging import SlingRigging
    from gantline.scenario.rope_weight import RopeWeight

__all__ = [
    "ExtensionRigging",
    "ExtensionSheave",
    "SlingEnd",
    "check_sling_over",
    "ends_below",
    "extensions_of",
    "sling_ends",
]


class ExtensionSheave(Element):
    """A sheave that hangs on a sling; one sling runs over it."""

    what: ClassVar[str] = "an extension sheave"

    mass: PositiveMass = Field(description="Mass with its sheave block and pin.")
    pitch_diameter: PositiveLength = Field(
        0.5, description="Diameter on which the rope's axis lies; for pictures only."
    )


class SlingEnd(NamedTuple):
    """The lower end of a sling: a lug of load or spreader, or what else hangs on it.

    Attributes:
        lug: the lug there; None of an extension sheave and a compensator.
        extension: extension sheave that hangs on it; None for none.
        spreader: spreader that has the lug; None of a lug of the load.
        compensator: compensator whose cylinder hangs on it; None for none.
    """

    lug: str | None
    extension: str | None
    spreader: str | None = None
    compensator: str | None = None

    @property
    def held(self) -> str | None:
        """Spreader, extension sheave or compensator that hangs on it; None of a lug of the load."""
        return self.spreader or self.extension or self.compensator


@dataclass(frozen=True)
class ExtensionRigging:
    """An extension sheave.

    Attributes:
        hangs_on: the sling that carries it.
        carries: the sling that runs over it.
    """

    name: str
    mass: float
    pitch_diameter: float
    hangs_on: str
    carries: str


def extensions_of(
    findings: Findings, given: Mapping[str, Sling], slings: Mapping[str, SlingRigging]
) -> dict[str, ExtensionRigging]:
    """Every extension sheave between its two slings.

    Args:
        findings: where to note sheaves that do not hang on one sling and carry one.
        given: all slings as the lift file has them.
        slings: those of them that could be looked up.
    """
    found = {}
    for name, sheave in (findings.scenario.extension_sheaves or {}).items():
        above = [sling for sling, said in given.items() if name in said.to]
        over = [sling for sling, said in given.items() if said.over == name]
        path = ("extension_sheaves", name)
        for own, doing in ((above, "end at"), (over, "run over")):
            if len(own) != 1:
                listed = " and ".join(f"'{sling}'" for sling in own)
                sentence = (
                    f"slings {listed} {doing} it" if own else f"no sling {doing.replace(' ', 's ', 1)} it"
                )
                findings.add(path, f"{sentence}; one sling ends at an extension sheave, one runs over it")
        if len(above) == len(over) == 1 and above[0] in slings and over[0] in slings:
            found[name] = ExtensionRigging(name, sheave.mass, sheave.pitch_diameter, above[0], over[0])
    for name in found:
        _check_circle(findings, name, found, slings)
    return found


def _check_circle(
    findings: Findings,
    name: str,
    found: Mapping[str, ExtensionRigging],
    slings: Mapping[str, SlingRigging],
) -> None:
    chain = [name]
    while (above := slings[found[chain[-1]].hangs_on].over) is not None and above in found:
        chain.append(above)
        if above == name:
            sentence = (
                f"hangs in a circle ({' -> '.join(chain)}); at the top there is a moving sheave or a hook"
            )
            findings.add(("extension_sheaves", name), sentence)
            return
        if above in chain[:-1]:
            return  # it hangs on a circle, which is reported for its members


def sling_ends(findings: Findings, given: Sling, path: Path) -> tuple[str, ...] | None:
    """Words for the lower ends of a sling: one if it hangs from something, two if it runs over a sheave."""
    needed = 1 if given.over is None else 2
    if len(given.to) != needed:
        right = "'from' has one end" if needed == 1 else "'over' has two ends, such as [block.L1, block.L2]"
        findings.add((*path, "to"), f"found {len(given.to)} of them; a sling with {right}")
        return None
    if len(set(given.to)) < len(given.to):
        findings.add((*path, "to"), "names the same end twice; the two ends of a sling go to two places")
        return None
    return given.to


def check_sling_over(
    findings: Findings, given: Sling, rope: RopeMaterial, weight: RopeWeight, path: Path
) -> None:
    """Note what a sling at an extension sheave, a spreader or a compensator cannot have."""
    sheaves = findings.scenario.extension_sheaves or {}
    compensators = findings.scenario.compensators or {}
    if given.over is not None and given.over not in sheaves:
        sentence = f"'{given.over}' is not an extension sheave; {nearest(given.over, sheaves)}"
        findings.add((*path, "over"), sentence)
    if given.over is not None and given.shackles is not None and given.shackles.top is not None:
        sentence = "a sling that runs over a sheave has no shackle at its top"
        findings.add((*path, "shackles", "top"), f"{sentence}; leave it out")
    near = None
    if given.over is not None or any(end in sheaves for end in given.to):
        near = "an extension sheave"
    elif {given.from_, *given.to} & set(spreader_lugs(findings.scenario)):
        near = "a spreader"
    elif any(end in compensators for end in (given.from_, *given.to)):
        near = "a compensator"
    if given.over is not None and rope.curve is not None:
        sentence = "has a curve, and runs over a sheave"
        findings.add(path, f"{sentence}; give its rope an axial stiffness")
    if near is not None and rope.inextensible:
        sentence = f"is inextensible, and {near} hangs on it or carries it"
        findings.add(path, f"{sentence}; give its rope an axial stiffness")
    if near is not None and weight.nodes:
        sentence = f"has nodes, and {near} hangs on it or carries it"
        findings.add(path, f"{sentence}; 'rope_weight: lumped' or 'none' is right")


def ends_below(
    end: SlingEnd, found: Mapping[str, ExtensionRigging], slings: Mapping[str, SlingRigging]
) -> list[SlingEnd]:
    """Lower ends at lugs that the lower end of a sling serves, through however many extension sheaves."""
    if end.extension is None:
        return [end]
    below = slings[found[end.extension].carries].ends
    return [at_lug for one in below for at_lug in ends_below(one, found, slings)]
