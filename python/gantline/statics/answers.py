"""What statics answers: equilibria, natural motions, sensitivities."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from gantline.results.afloat.vessels import AtRest, with_rest
from gantline.results.alike import without_rounding
from gantline.results.leading_away import stability
from gantline.results.recording import Recording

Floats = npt.NDArray[np.float64]
Losses = Literal["none", "forward", "backward", "held"]

#: ω² within this of zero is no stiffness at all [1/s²], as in the core.
_NEUTRAL = 1e-6
#: Kinds of a `Sensitivity` of a rope; of a rope or a body.
OF_ROPES = ("length", "stiffness")
KINDS = (*OF_ROPES, "mass", "centre_x", "centre_y", "centre_z", "place_x", "place_y", "place_z")
#: Most names that a message lists.
_MOST_NAMED = 12


class NoEquilibriumError(RuntimeError):
    """The lift comes to rest nowhere.

    Attributes:
        time: Time of the plan [s].
        element: The body, rope or contact concerned.
        cause: Why, in one sentence.
    """

    def __init__(self, time: float, element: str, cause: str) -> None:
        super().__init__(f"there is no equilibrium at t = {time:g} s: {cause} ({element})")
        self.time = time
        self.element = element
        self.cause = cause

    def __reduce__(self) -> tuple[Any, ...]:
        """For pickle: an error of a process that works for another one arrives there whole."""
        return type(self), (self.time, self.element, self.cause)


@dataclass(frozen=True, eq=False)
class ContactForce:
    """What a contact carries at rest.

    Attributes:
        contact: Its name.
        support: Support force N [N].
        friction: Force of friction on the load, world axes, shape (3,) [N].
        bound: The largest that it can be, μN [N].
    """

    contact: str
    support: float
    friction: Floats
    bound: float

    @property
    def used(self) -> float | None:
        """Share of what friction can hold that it holds [1]; None where it can hold nothing."""
        return float(np.linalg.norm(self.friction)) / self.bound if self.bound > 0.0 else None


@dataclass(frozen=True, eq=False)
class Equilibrium:
    """A lift at rest.

    Attributes:
        time: Time of the plan [s].
        recording: The start of the lift as given, and the equilibrium as the last sample; at time 0 that
            alone.
        residual: Largest imbalance of forces relative to the forces that meet there.
        neutral: How many motions nothing holds; each step of the search leaves them where they were.
        unstable: How many motions lead away; 0 if it is stable.
        swinging: How many of these lead away by swinging ever farther, in wind or current.
        steps: Steps that the search made.
        lossy: Sheaves with losses.
        losses: What friction does, see `Statics.equilibrium`.
        contacts: The contacts that carry.
        slides: Loads, modules and body contacts whose friction found no balance on the way, and when [s]:
            there they slid to where nothing drives them.
    """

    time: float
    recording: Recording
    residual: float
    neutral: int
    unstable: int
    steps: int
    lossy: tuple[str, ...] = ()
    losses: Losses = "none"
    contacts: tuple[ContactForce, ...] = ()
    slides: tuple[tuple[float, str], ...] = ()
    swinging: int = 0

    def __repr__(self) -> str:
        return f"<Equilibrium {self.recording.title!r}: at {self.time:g} s, {self.stability}>"

    @property
    def is_stable(self) -> bool:
        """Whether no motion leads away from it."""
        return self.unstable == 0

    @property
    def stability(self) -> str:
        """Whether it is stable, in words."""
        return stability(self.unstable, self.swinging)

    def to_json(self) -> dict[str, Any]:
        """What it is like as a JSON object, SI units; its numbers are in the recording."""
        return {
            "time": self.time,
            "stable": self.is_stable,
            "unstable_motions": self.unstable,
            "swinging_motions": self.swinging,
            "neutral_motions": self.neutral,
            "residual": self.residual,
            "losses": self.losses,
            "lossy_sheaves": list(self.lossy),
            "slides": [{"time": moment, "name": name} for moment, name in self.slides],
        }

    def with_modes(self, modes: Sequence[Mode], heights: Mapping[str, Sequence[float]]) -> Recording:
        """Its recording with the attributes `statics` and `modes`: what it is like, how it swings.

        Args:
            modes: Its natural motions.
            heights: Metacentric heights of its vessels for heel and trim by their names [m].
        """
        one = self.recording
        more = {"metacentric_heights": {name: list(both) for name, both in heights.items()}}
        said = {"statics": self.to_json() | more, "modes": [mode.to_json() for mode in modes]}
        return Recording(one.variables, one.coordinates, {**one.attributes, **said})

    def with_rest(self, found: AtRest) -> Equilibrium:
        """The same, whose recording tells what it says of vessels.

        Args:
            found: What that is.
        """
        if not found.heights and not found.by_contingency:
            return self
        one = self.recording
        rig = with_rest(one.attributes["rig"], self.time, found)
        return replace(
            self, recording=Recording(one.variables, one.coordinates, {**one.attributes, "rig": rig})
        )

    def tension(self, rope: str) -> float:
        """Tension of a rope [N]; none of one that just reaches, which rounding of its length has taut."""
        return without_rounding(float(self.recording.column("rope_tension", rope)[-1]), 0.0, "kN")


@dataclass(frozen=True, eq=False)
class Mode:
    """A natural motion about an equilibrium.

    Attributes:
        number: Its place in the list, 0 for the slowest; what is shown to people counts from 1.
        square: ω² [1/s²]; negative where the motion leads away.
        damping_ratio: Of this mode by itself; None where it does not swing.
        body_motion: Velocity of each body's centre of gravity and its angular velocity, world axes, shape
            (body, 6), in the order of `bodies`, of the shape with xᵀ M x = 1 [1/√kg].
        motion: What moves, in words.
        bodies: Their names.
        flows: Velocity of rope over each sheave, or off each drum, that turns by itself, by its name [1/√kg].
    """

    number: int
    square: float
    damping_ratio: float | None
    body_motion: Floats
    motion: str
    bodies: tuple[str, ...] = ()
    flows: Mapping[str, float] = field(default_factory=dict)

    def __repr__(self) -> str:
        if self.period is not None:
            swings = f"period {self.period:.4g} s"
        else:
            swings = "neutral" if self.growth_time is None else f"grows e-fold in {self.growth_time:.3g} s"
        return f"<Mode {self.number + 1}: {self.motion}; {swings}>"

    @property
    def period(self) -> float | None:
        """Natural period [s]; None where it does not swing."""
        return 2 * math.pi / math.sqrt(self.square) if self.square > _NEUTRAL else None

    def of_body(self, body: str) -> Floats:
        """How a body moves, shape (6,), as in `body_motion`.

        Raises:
            KeyError: If there is no such body.
        """
        row: Floats = self.body_motion[_place(body, self.bodies)]
        return row

    def to_json(self) -> dict[str, Any]:
        """All but the shape as a JSON object, SI units."""
        return {
            "number": self.number + 1,
            "period": self.period,
            "growth_time": self.growth_time,
            "damping_ratio": self.damping_ratio,
            "motion": self.motion,
        }

    @property
    def growth_time(self) -> float | None:
        """Time in which a motion that leads away grows e-fold [s]; None where it does not."""
        return 1 / math.sqrt(-self.square) if self.square < -_NEUTRAL else None


@dataclass(frozen=True, eq=False)
class Sensitivity:
    """How the tensions of all ropes and the motion of all bodies answer to one quantity of the plan.

    Attributes:
        kind: `length` (the weight of what is longer is left out), `stiffness` (EA) of a rope; `centre_x`,
            `centre_y`, `centre_z`, `mass` of a body; `place_x`, `place_y`, `place_z` of its joint, along the
            axes of the world, such as of a hook.
        name: The rope or body.
        tension: dT/dp of every rope and mooring line [N per m, N per N, N per kg], in the order of `ropes`.
        ropes: Their names.
        motion: Derivatives of each body's centre of gravity [m] and of its attitude as a rotation vector
            [rad], world axes, shape (body, 6), in the order of `bodies`. Of a body whose centre of gravity is
            asked about, the point of the body that is there counts: the shift itself is left out.
        bodies: Their names.
        is_held: False where the quantity sets something going that nothing holds, such as the mass on one
            side of two that balance over a sheave: there is no derivative then. `tension` is that of a lift
            that gathers speed, and `motion` no more than a direction.
    """

    kind: str
    name: str
    tension: Floats
    ropes: tuple[str, ...]
    motion: Floats
    bodies: tuple[str, ...]
    is_held: bool

    def __repr__(self) -> str:
        if not self.is_held:
            return f"<Sensitivity to {self.kind} of {self.name}: none, nothing holds what it sets going>"
        most = int(np.argmax(np.abs(self.tension))) if self.ropes else None
        answer = "" if most is None else f"; most in {self.ropes[most]}: {self.tension[most]:.4g}"
        return f"<Sensitivity to {self.kind} of {self.name}: {len(self.ropes)} ropes{answer}>"

    def of(self, rope: str) -> float:
        """Derivative of the tension of one rope, in the unit of `tension`.

        Raises:
            KeyError: If there is no such rope.
        """
        return float(self.tension[_place(rope, self.ropes)])

    def of_body(self, body: str) -> Floats:
        """Derivatives of a body's centre of gravity and rotation vector, shape (6,), as in `motion`.

        Raises:
            KeyError: If there is no such body.
        """
        row: Floats = self.motion[_place(body, self.bodies)]
        return row


def _place(name: str, names: Sequence[str]) -> int:
    if name not in names:
        raise KeyError(f"no {name!r}; there are {likely(name, names)}")
    return names.index(name)


def likely(name: str, names: Sequence[str]) -> str:
    """Of the names that there are those that end like one that is none, or else all, for a message."""
    alike = [one for one in names if one.endswith(f".{name}")] or list(names)
    return ", ".join(alike[:_MOST_NAMED]) or "none"
