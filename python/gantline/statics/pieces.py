"""Ropes with nodes among sensitivities: the core has many ropes and bodies where a lift has one rope."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from gantline.results.alike import first_peak
from gantline.results.rig import Rig
from gantline.statics.answers import Floats, Sensitivity

__all__ = ["Pieces"]


class Pieces:
    """What the core calls the ropes and bodies of a lift.

    Attributes:
        ropes: Names of ropes as the lift has them, in the core's order.
        bodies: Names of bodies without nodes, in the core's order.
    """

    def __init__(self, rig: Rig, names: Mapping[str, Sequence[str]]) -> None:
        self._of = {
            rope.name: [f"{rope.name}/{piece}" for piece in range(rope.nodes + 1)]
            for rope in rig.ropes
            if rope.nodes
        }
        self._core_ropes = list(names["rope"])
        owner = {piece: rope for rope, pieces in self._of.items() for piece in pieces}
        self.ropes = tuple(dict.fromkeys(owner.get(rope, rope) for rope in self._core_ropes))
        self._kept = [at for at, body in enumerate(names["body"]) if body not in owner]
        self.bodies = tuple(names["body"][at] for at in self._kept)

    def asked(self, kind: str, name: str) -> list[tuple[str, str]]:
        """What is asked of the core for one kind and rope or body."""
        return [(kind, piece) for piece in self._of.get(name, [name])]

    def answer(
        self, kind: str, name: str, parts: Sequence[tuple[Floats, Floats, float]], loads: Floats
    ) -> Sensitivity:
        """One answer, of those of the core to all of `asked`.

        A rope that is longer has as much more in each of its equal pieces; its stiffness is that of each.
        The tension of a rope with nodes is that of its piece that carries most, by `loads` [N] at rest.
        """
        share = 1.0 / len(parts) if kind == "length" else 1.0
        tension: Any = share * sum(tension for tension, _, _ in parts)
        motion: Any = share * sum(motion for _, motion, _ in parts)
        is_held = all(held > 0.0 for _, _, held in parts)
        places = [self._most_loaded(rope, loads) for rope in self.ropes]
        return Sensitivity(kind, name, tension[places], self.ropes, motion[self._kept], self.bodies, is_held)

    def _most_loaded(self, rope: str, loads: Floats) -> int:
        places = [self._core_ropes.index(piece) for piece in self._of.get(rope, [rope])]
        return places[first_peak(loads[places])]
