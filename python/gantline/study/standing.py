"""What rights vessels on which a load stands, with friction and without: the least of both counts.

Equilibria are found as if contacts slid. A load that a crane ashore has set down on a deck, aside of its
middle, then slides into its slings, by which the crane holds the vessel; friction holds it, and leaves her
less.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from gantline.statics import Equilibrium, NoEquilibriumError, Statics
from gantline.statics.inclining import MetacentricHeights, metacentric_heights
from gantline.statics.righted import stands_aboard

__all__ = ["AsHeld", "least_heights", "lessened"]

#: By how much GM is less before it is said that friction leaves less of it [1].
_LESS = 0.01
#: Metacentric heights by vessel.
Heights = Mapping[str, MetacentricHeights]


class AsHeld:
    """What rights the vessels of a lift where friction holds what stands on them.

    Args:
        question: The lift. Its last equilibrium stays what it is.
    """

    def __init__(self, question: Statics) -> None:
        self._of = question
        self._held: Statics | None = None
        self._ends: dict[str, float | None] = {}

    def heights(
        self,
        rest: Equilibrium,
        moment: float | None = None,
        ending: Sequence[str] = (),
        *,
        at_level: bool = False,
    ) -> dict[str, MetacentricHeights]:
        """Metacentric heights with friction; empty where no load stands aboard, or nothing rests with it.

        Args:
            rest: An equilibrium of the lift; of one with friction nothing more is asked.
            moment: For which it stands, if that is a little later [s].
            ending: Steps of the plan that end then: with friction that may be at another time.
            at_level: Whether of tanks with holes those count only that have come to their level.
        """
        floats = any(not vessel.is_carried for vessel in rest.recording.rig.vessels)
        if not floats or rest.losses != "none" or not stands_aboard(rest):
            return {}
        try:
            held = self._question()
            known = [end for step in ending if (end := self._ends[step]) is not None]
            earlier = 0.0 if moment is None else moment - rest.time
            then = max(known) - earlier if known else rest.time
            there = held.equilibrium(max(then, 0.0), losses="held")
            return metacentric_heights(held, there, at_level=at_level)
        except NoEquilibriumError:
            return {}

    def _question(self) -> Statics:
        """The lift once more, whose steps end where with friction they do."""
        if self._held is None:
            self._held = Statics(self._of.scenario, assembly=self._of.assembly)
            self._held.equilibrium(losses="held")
            plan = self._of.scenario.plan
            self._ends = {step.step: self._held.times_of(step.step)[1] for step in plan}
        return self._held


def least_heights(heights: Heights, held: Heights) -> dict[str, tuple[float, float]]:
    """For heel and trim of each vessel the least without friction and with what stands on it held [m]."""
    return {
        name: (
            min(one.transverse, held[name].transverse if name in held else one.transverse),
            min(one.longitudinal, held[name].longitudinal if name in held else one.longitudinal),
        )
        for name, one in heights.items()
    }


def lessened(heights: Heights, held: Heights) -> bool:
    """Whether a vessel has less GM as friction holds what stands on it, by more than a hundredth."""
    least = least_heights(heights, held)
    return any(
        before - after > _LESS * abs(before)
        for name, one in heights.items()
        for before, after in zip((one.transverse, one.longitudinal), least[name], strict=True)
    )
