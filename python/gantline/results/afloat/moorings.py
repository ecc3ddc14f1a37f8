"""Mooring lines and fenders in a recording: what they pull and press with."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from gantline.results.strength import FromJson
from gantline.results.variable import Columns, Derived, Names, Variable

__all__ = ["Fender", "MooringLine", "mooring_state"]


@dataclass(frozen=True)
class MooringLine(FromJson):
    """A mooring line.

    Attributes:
        name: Its name in the lift file.
        rope: Its name among the ropes of the recording.
        minimum_breaking_force: Of its rope [N]; None if not known.
        slipping_winch: Joint of its winch if that has a capacity, at which it slips.
        let_go_in: Steps of the plan that let go of it.
        hanging_weight: Weight per length of one that hangs by it without nodes, in air or under water
            [N/m]; 0 of others.
    """

    name: str
    rope: str
    minimum_breaking_force: float | None = None
    slipping_winch: str | None = None
    let_go_in: Sequence[str] = ()
    hanging_weight: float = 0.0


@dataclass(frozen=True)
class Fender(FromJson):
    """A fender.

    Attributes:
        name: Its name in the lift file.
        contact: Its name among the contacts of the recording.
        capacity: Largest force that it may take [N]; None if not said.
        thickness: Of it where nothing presses on it [m]; 0 if not said.
    """

    name: str
    contact: str
    capacity: float | None = None
    thickness: float = 0.0

    def used_by(self, force: float) -> float | None:
        """A force [N] over its capacity; None where that is not said."""
        return None if self.capacity is None else force / self.capacity


def mooring_state(
    columns: Columns, names: Names, lines: Sequence[MooringLine], fenders: Sequence[Fender]
) -> Derived:
    """Tensions of mooring lines and forces of fenders over time.

    Args:
        columns: Columns of the core by name.
        names: Names along their dimensions.
        lines: Mooring lines of the rig.
        fenders: Fenders of the rig.
    """
    found: dict[str, Variable] = {}
    labels: dict[str, Sequence[str]] = {}
    if lines:
        at = [list(names["rope"]).index(line.rope) for line in lines]
        tension = columns["rope_tension"][:, at]
        described = "tension of a mooring line at its fairlead; with nodes the largest along it"
        found["mooring_tension"] = Variable(("time", "mooring_line"), tension, "N", described)
        labels["mooring_line"] = [line.name for line in lines]
    if fenders:
        at = [list(names["contact"]).index(fender.contact) for fender in fenders]
        force = columns["contact_force"][:, at]
        found["fender_force"] = Variable(("time", "fender"), force, "N", "force across a fender")
        labels["fender"] = [fender.name for fender in fenders]
    return found, labels
