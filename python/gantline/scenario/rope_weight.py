"""How the weight of a rope acts: left out, lumped to bodies, or distributed over nodes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Final, Literal

from gantline.scenario.quantities import Number

if TYPE_CHECKING:
    from gantline.scenario.gear import RopeMaterial

__all__ = [
    "NODES_GIVEN",
    "NODES_SHOWN",
    "WEIGHT_SHOWN",
    "RopeNodes",
    "RopeWeight",
    "RopeWeightWord",
    "check_rope_weight",
    "rope_weight",
]

RopeWeightWord = Literal["none", "lumped", "distributed"]
RopeNodes = Annotated[int, Number(least=1, most=1000, whole=True)]

#: Nodes of a rope that says none.
NODES_GIVEN: Final = 50

WEIGHT_SHOWN: Final = (
    "How the weight of the rope acts: 'none', 'lumped' to the bodies that it touches, or 'distributed' over "
    "nodes, so that it sags. If not given: 'lumped' where its mass per length is known, else 'none'."
)
NODES_SHOWN: Final = "Nodes of a rope of distributed weight; 50 if not given."


@dataclass(frozen=True)
class RopeWeight:
    """How the weight of one rope acts.

    Attributes:
        way: left out, lumped or distributed.
        mass_per_length: mass per unstretched length [kg/m]; 0 where it is left out.
        nodes: number of nodes; 0 unless distributed.
    """

    way: RopeWeightWord
    mass_per_length: float
    nodes: int


def rope_weight(kind: RopeMaterial, way: RopeWeightWord | None, nodes: int | None) -> RopeWeight:
    """The weight of a rope of a kind, with what is not said filled in.

    Args:
        kind: kind of rope.
        way: what the lift file says; None where it says nothing.
        nodes: number of nodes that it says; None where it says none.
    """
    if way is None:
        way = "lumped" if kind.mass_per_length > 0 else "none"
    mass = 0.0 if way == "none" else kind.mass_per_length
    return RopeWeight(way, mass, (nodes or NODES_GIVEN) if way == "distributed" else 0)


def check_rope_weight(
    add: Callable[[str, str], None],
    rope: str,
    kind: RopeMaterial,
    way: RopeWeightWord | None,
    *,
    nodes_said: bool = False,
    over_sheaves: str = "",
    gravity: float,
) -> None:
    """Note what is wrong with how the weight of a rope shall act.

    Args:
        add: notes a sentence at `rope_weight` or `rope_nodes`.
        rope: name of the kind of rope.
        kind: the kind of rope.
        way: what the lift file says; None where it says nothing.
        nodes_said: whether the same rope says a number of nodes.
        over_sheaves: what runs over sheaves, if the rope does, such as `an equalizing rope`.
        gravity: acceleration of gravity [m/s^2].
    """
    if nodes_said and way != "distributed":
        sentence = "only a rope of distributed weight has nodes"
        add("rope_nodes", f"{sentence}; write 'rope_weight: distributed' too, or leave this out")
    if way in (None, "none"):
        return
    if kind.mass_per_length == 0:
        sentence = (
            f"the mass of rope '{rope}' is not known" if kind.mass is None else f"rope '{rope}' has no mass"
        )
        ways = "give it a 'construction' or its mass, such as 'mass: 9 kg/m'"
        add("rope_weight", f"{sentence}; {ways}, or write 'rope_weight: none'")
    if way != "distributed":
        return
    advice = "'rope_weight: lumped' is right here"
    if over_sheaves:
        sentence = f"{over_sheaves} runs over sheaves, and nodes cannot"
        add("rope_weight", f"{sentence}; {advice}, 'distributed' for a rope that is free from end to end")
    if kind.inextensible:
        sentence = f"rope '{rope}' is inextensible, and a rope with nodes has to stretch"
        add("rope_weight", f"{sentence}; give it an axial stiffness, or write 'rope_weight: lumped'")
    if (bent := kind.bent(rope, "a rope with nodes")) is not None:
        add("rope_weight", f"{bent}, or write 'rope_weight: lumped'")
    if gravity == 0:
        add("rope_weight", f"without gravity a rope with nodes has no place to hang; {advice}")
