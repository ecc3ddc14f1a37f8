"""Losses and inertia of sheaves: what a lift file says, and what it comes to for the rope."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import ClassVar, Final, Literal

from pydantic import Field, model_validator

from gantline.scenario.base import Element
from gantline.scenario.quantities import Mass, PositiveInertia, Ratio, refuse

__all__ = ["SheaveLosses", "SheaveWords", "check_losses", "said_twice", "sheave_losses", "taken_together"]

#: Efficiency of one sheave by its bearing, docs/concepts/flows.md says from where; a seized one never turns.
BEARINGS: Final = {"ideal": 1.0, "roller": 0.98, "plain": 0.96, "seized": 0.0}
#: A sheave that loses more is a loss and an efficiency taken for each other.
_LEAST_EFFICIENCY: Final = 0.5
#: Beyond this a unit has slipped.
_MOST_FRICTION: Final = 1.0
#: Ways to say one thing; of each at most one is said.
_OF_BEARING: Final = ("bearing", "efficiency", "loss")
_OF_GROOVE: Final = ("groove_friction",)
_OF_INERTIA: Final = ("sheave_mass", "moment_of_inertia", "rotating_mass")
_GROUPS: Final = (_OF_BEARING, _OF_GROOVE, _OF_INERTIA)


def refuse_efficiency(efficiency: float, key: str, loss: str) -> None:
    """Refuse what can be no efficiency of one sheave [1]; `loss` is how a lift file says a loss instead."""
    if efficiency > 1:
        raise refuse(f"{efficiency:g} is above 1; no sheave gives force back", key)
    if efficiency < _LEAST_EFFICIENCY:
        sentence = f"{efficiency:g} is no efficiency of a sheave"
        raise refuse(f"{sentence}; 0.95 to 1 is usual, or write '{loss}'", key)


class SheaveWords(Element):
    """Losses and inertia of sheaves."""

    what: ClassVar[str] = "sheaves"

    bearing: Literal["ideal", "roller", "plain", "seized"] | None = Field(
        None,
        description="Bearing: 'ideal', 'roller' (efficiency 0.98), 'plain' (0.96), or 'seized', which does "
        "not turn. Ideal if neither this nor 'efficiency' nor 'loss' is given.",
    )
    efficiency: Ratio | None = Field(
        None, description="Efficiency of one sheave: tension on the slack side over that on the tight side."
    )
    loss: Ratio | None = Field(None, description="Loss of one sheave: 1 - efficiency.")
    groove_friction: Ratio | None = Field(
        None,
        description="Coefficient of friction in the groove: the rope slips in it where the bearing would "
        "hold more. The groove grips if not given.",
    )
    sheave_mass: Mass | None = Field(
        None, description="Mass of one sheave; half of it moves with the rope, as of a solid disc."
    )
    moment_of_inertia: PositiveInertia | None = Field(
        None, description="Moment of inertia of one sheave about its axis."
    )
    rotating_mass: Mass | None = Field(
        None,
        description="Mass that moves with the rope: moment of inertia over radius squared. 0 neglects it, "
        "which is simulated faster.",
    )

    @model_validator(mode="after")
    def _one_way_to_say_it(self) -> SheaveWords:
        for group in _GROUPS:
            given = [key for key in group if getattr(self, key) is not None]
            if len(given) > 1:
                ways = " and ".join(f"'{key}'" for key in given)
                raise refuse(f"{ways} are given together; one of them says it", given[-1])
        if self.efficiency is not None:
            refuse_efficiency(self.efficiency, "efficiency", "loss: 2 %")
        loss = self.loss
        if loss is not None and loss > 1 - _LEAST_EFFICIENCY:
            sentence = f"{loss * 100:g} % is no loss of a sheave"
            raise refuse(f"{sentence}; up to 5 % is usual, or write 'efficiency: 0.98'", "loss")
        if self.groove_friction is not None and self.groove_friction > _MOST_FRICTION:
            sentence = f"{self.groove_friction:g} is no friction of a rope in its groove"
            raise refuse(f"{sentence}; 0.05 to 0.2 is usual for steel", "groove_friction")
        return self

    @classmethod
    def keys(cls) -> tuple[str, ...]:
        """Keys that this mapping may have, those of losses last."""
        every, losses = super().keys(), tuple(SheaveWords.model_fields)
        return (*(key for key in every if key not in losses), *losses)

    @property
    def bearing_efficiency(self) -> float:
        """Efficiency of one sheave whose groove grips [1]."""
        if self.loss is not None:
            return 1.0 - self.loss
        return self.efficiency if self.efficiency is not None else BEARINGS[self.bearing or "ideal"]


@dataclass(frozen=True)
class SheaveLosses:
    """One sheave as the rope over it meets it.

    Attributes:
        bearing: largest ratio of the tensions on both sides that its bearing holds, 1 without losses,
            infinite where it does not turn.
        groove: coefficient of friction of a groove in which the rope may slip, None where it grips.
        inertia: mass of what turns, I/r^2 [kg]; 0 where there is none or it is not known.
        inertia_from: what that mass is, in words.
        on_sheave: mass of the rope that lies on it and moves where the groove slips [kg]; 0 if not known.
    """

    bearing: float = 1.0
    groove: float | None = None
    inertia: float = 0.0
    inertia_from: str = ""
    on_sheave: float = 0.0

    def ratio(self, wrap: float = math.pi) -> float:
        """Largest ratio of the tensions on both sides at a wrap [rad], by bearing or groove."""
        return min(self.bearing, math.inf if self.groove is None else math.exp(self.groove * wrap))

    @property
    def is_ideal(self) -> bool:
        """Whether the sheave passes tension on as it is."""
        return self.ratio() == 1.0 and (self.inertia == 0.0 or self.groove == 0.0)

    @property
    def turns(self) -> bool:
        """Whether the sheave turns."""
        return self.bearing < math.inf

    @property
    def slips(self) -> bool:
        """Whether rope may slip in the groove: what then moves has to have a mass."""
        return self.groove is not None and self.on_sheave > 0 and (self.inertia > 0 or not self.turns)


def taken_together(levels: Sequence[SheaveWords | None]) -> SheaveWords:
    """What several places say of the same sheaves; of each thing the first that says it counts."""
    taken: dict[str, object] = {}
    for group in _GROUPS:
        for words in levels:
            said = {} if words is None else {key: getattr(words, key) for key in group}
            said = {key: value for key, value in said.items() if value is not None}
            if said:
                taken |= said
                break
    return SheaveWords().model_copy(update=taken)


def said_twice(first: SheaveWords | None, second: SheaveWords | None) -> Iterator[tuple[str, str]]:
    """Keys of two places that say the same thing, in pairs."""
    for group in _GROUPS:
        keys = [
            next((key for key in group if words is not None and getattr(words, key) is not None), None)
            for words in (first, second)
        ]
        if keys[0] is not None and keys[1] is not None:
            yield keys[0], keys[1]


def sheave_losses(
    words: SheaveWords, radius: float, rope_mass: float, own_mass: float | None = None, wrap: float = math.pi
) -> SheaveLosses:
    """What the losses and the inertia of a sheave come to.

    Bearing and groove are in series: the rope passes as soon as the weaker of them gives way, at the ratio
    of tensions min(1/efficiency, e^(mu wrap)). While the groove holds, the sheave turns with the rope and
    its I/r^2 moves with it; where it slips, only the rope that lies on it does.

    Args:
        words: what the lift file says.
        radius: pitch radius [m].
        rope_mass: mass per length of the rope, 0 if not known [kg/m].
        own_mass: mass of the sheave where words say nothing of inertia, None if not known [kg].
        wrap: angle of the rope on it at the start [rad].
    """
    efficiency = words.bearing_efficiency
    bearing = 1 / efficiency if efficiency > 0 else math.inf
    on_sheave = rope_mass * wrap * radius
    inertia, source = 0.0, ""
    if bearing == math.inf:
        source = "the rope that lies on it"
    elif words.rotating_mass is not None:
        inertia, source = words.rotating_mass, "as given"
    elif words.moment_of_inertia is not None:
        inertia, source = words.moment_of_inertia / radius**2, "moment of inertia over r^2"
    elif words.sheave_mass is not None:
        inertia, source = words.sheave_mass / 2, "half of its mass"
    elif bearing > 1 and own_mass is not None:
        inertia, source = own_mass / 2, f"half of {round(own_mass, 1):g} kg"
    return SheaveLosses(bearing, words.groove_friction, inertia, source, on_sheave)


def check_losses(
    add: Callable[[str, str], None], words: SheaveWords, losses: SheaveLosses, rope: str, inextensible: bool
) -> None:
    """Note what is wrong with the losses of a sheave.

    Args:
        add: notes a sentence at a key of the sheave, or at the sheave for an empty key.
        words: what the lift file says, from all places.
        losses: what it comes to.
        rope: name of the kind of rope over the sheave.
        inextensible: whether that is inextensible.
    """
    efficiency = words.bearing_efficiency
    if efficiency == 0 and words.groove_friction is None:
        sentence = "the rope slips in the groove of a seized sheave"
        add("bearing", f"{sentence}; 'groove_friction' is missing, such as 'groove_friction: 0.1'")
    elif efficiency == 1 and words.groove_friction is not None and losses.inertia == 0:
        sentence = "groove friction alone holds nothing, since an ideal bearing without inertia always turns"
        add("groove_friction", f"{sentence}; say a 'bearing' too: 'roller', 'plain' or 'seized'")
    elif losses.ratio() > 1 and losses.inertia == 0 and losses.turns:
        _check_neglected_inertia(add, words)
    elif losses.groove is not None and losses.ratio() < losses.bearing and losses.on_sheave == 0:
        sentence = (
            f"where the groove slips the mass of the rope on the sheave moves; that of '{rope}' is not known"
        )
        add("", f"{sentence}, so give the rope a 'construction' or its mass, such as 'mass: 9 kg/m'")
    elif not losses.is_ideal and inextensible:
        sentence = (
            f"rope '{rope}' is inextensible, and over sheaves with losses or inertia a rope has to stretch"
        )
        add("", f"{sentence}; give it an axial stiffness")


def _check_neglected_inertia(add: Callable[[str, str], None], words: SheaveWords) -> None:
    said = next((key for key in _OF_INERTIA if getattr(words, key) is not None), None)
    if said is None:
        ways = "'sheave_mass', 'moment_of_inertia' or 'rotating_mass'"
        neglect = "'rotating_mass: 0 kg' neglects it"
        add("", f"a sheave with losses has inertia; give it one of {ways} ({neglect})")
    elif words.groove_friction is not None:
        sentence = "0 kg moves with the rope, and a sheave on which it may slip has inertia"
        add(said, f"{sentence}; half of the mass of the sheave is usual")
