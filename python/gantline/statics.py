"""Statics of a lift: how it hangs at a time of its plan, how it swings about that, how errors change it."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from gantline import _core
from gantline.assembly import assemble
from gantline.results.derive import recording_of
from gantline.results.recording import Recording
from gantline.results.rig import Rig
from gantline.scenario import Scenario, load_scenario
from gantline.version import version

__all__ = ["ContactForce", "Equilibrium", "Mode", "NoEquilibriumError", "Sensitivity", "Statics"]

Floats = npt.NDArray[np.float64]
Losses = Literal["none", "forward", "backward", "held"]

#: ω² within this of zero is no stiffness at all [1/s²], as in the core.
_NEUTRAL = 1e-6
#: What the core says of a body that nothing holds.
_FALLS = "nothing holds it, it falls without end"
#: Share of the kinetic energy from which on a body is named as taking part in a motion.
_TAKES_PART = 0.25
#: Share of its kinetic energy from which on a body is said to move, or to turn.
_SHOWS = 0.3
#: Cosine from which on a direction is called by the name of an axis.
_ALONG = 0.98
#: Largest displacement of a mode that is shown, of any body's centre of gravity [m] or turn [rad].
_SHOWN = 0.5


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


@dataclass(frozen=True)
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
        """Share of what friction can hold that it holds; None where it can hold nothing."""
        return float(np.linalg.norm(self.friction)) / self.bound if self.bound > 0.0 else None


@dataclass(frozen=True)
class Equilibrium:
    """A lift at rest.

    Attributes:
        time: Time of the plan [s].
        recording: The start of the lift as given, and the equilibrium as the last sample; at time 0 that
            alone.
        residual: Largest imbalance of forces relative to the forces that meet there.
        neutral: How many motions nothing holds; they stay where the start was nearest.
        unstable: How many motions lead away; 0 if it is stable.
        steps: Steps that the search made.
        lossy: Sheaves with losses.
        losses: What friction does, see `Statics.equilibrium`.
        contacts: The contacts that carry.
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

    @property
    def is_stable(self) -> bool:
        """Whether no motion leads away from it."""
        return self.unstable == 0

    def to_json(self) -> dict[str, Any]:
        """What it is like as a JSON object, SI units; its numbers are in the recording."""
        return {
            "time": self.time,
            "stable": self.is_stable,
            "unstable_motions": self.unstable,
            "neutral_motions": self.neutral,
            "residual": self.residual,
            "losses": self.losses,
            "lossy_sheaves": list(self.lossy),
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

    def tension(self, rope: str) -> float:
        """Tension of a rope [N]."""
        return float(self.recording.column("rope_tension", rope)[-1])


@dataclass(frozen=True)
class Mode:
    """A natural motion about an equilibrium.

    Attributes:
        number: Its number, from the slowest on.
        square: ω² [1/s²]; negative where the motion leads away.
        damping_ratio: Of this mode by itself; None where it does not swing.
        body_motion: Velocity of each body's centre of gravity and its angular velocity, world axes, shape
            (body, 6), of the shape with xᵀ M x = 1 [1/√kg].
        motion: What moves, in words.
    """

    number: int
    square: float
    damping_ratio: float | None
    body_motion: Floats
    motion: str

    @property
    def period(self) -> float | None:
        """Natural period [s]; None where it does not swing."""
        return 2 * math.pi / math.sqrt(self.square) if self.square > _NEUTRAL else None

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


@dataclass(frozen=True)
class Sensitivity:
    """How the tensions of all ropes and the motion of all bodies answer to one quantity of the plan.

    Attributes:
        kind: `length`, `stiffness` (EA) of a rope; `centre_x`, `centre_y`, `centre_z`, `mass` of a body;
            `place_x`, `place_y`, `place_z` of its joint, along the axes of the world, such as of a hook.
        name: The rope or body.
        tension: dT/dp of every rope [N per m, N per N, N per kg], in the order of `ropes`.
        ropes: Their names.
        motion: Derivatives of each body's centre of gravity [m] and of its attitude as a rotation vector
            [rad], world axes, shape (body, 6), in the order of `bodies`.
        bodies: Their names.
    """

    kind: str
    name: str
    tension: Floats
    ropes: tuple[str, ...]
    motion: Floats
    bodies: tuple[str, ...]

    def of(self, rope: str) -> float:
        """Derivative of the tension of one rope."""
        return float(self.tension[self.ropes.index(rope)])

    def of_body(self, body: str) -> Floats:
        """Derivatives of a body's centre of gravity and rotation vector, shape (6,)."""
        row: Floats = self.motion[self.bodies.index(body)]
        return row


class Statics:
    """A lift whose equilibria are asked for.

    Args:
        lift: A lift file, its folder, or a loaded scenario.

    Raises:
        ScenarioError: If the lift file is not right, or the lift has no statics (lengths that are adjusted).
    """

    def __init__(self, lift: str | Path | Scenario) -> None:
        self.scenario = lift if isinstance(lift, Scenario) else load_scenario(lift)
        self.assembly = assemble(self.scenario)
        try:
            self._core = _core.Statics(self.assembly.document_text())
        except ValueError as problem:
            raise self.scenario.error((), str(problem)) from problem
        self._losses: Losses = "none"
        self._bodies = {body["name"]: body for body in self.assembly.document["bodies"]}

    @property
    def rig(self) -> Rig:
        """Who carries whom."""
        return Rig.from_json(self.assembly.rig)

    def equilibrium(
        self,
        time: float | None = None,
        *,
        losses: Losses = "none",
        slide: Sequence[float] | None = None,
        increment: Sequence[float] | None = None,
    ) -> Equilibrium:
        """The equilibrium that lies downhill of the start of the lift.

        Brakes, locking pins and dry friction given in newtons hold what they hold at the start.

        Args:
            time: Time of the plan [s], at which drives are where it says; None for the end of the lift. A
                plan that waits for conditions is followed from rest to rest; so is a lift with drums that
                remember what they wind, and one whose friction holds.
            losses: What friction of sheaves and contacts does: `none`, sheaves are ideal, which is the middle
                of what they may hold, and contacts slide freely; `forward` and `backward`, all sheaves slip
                towards the end or the start of their ropes' routes, which bounds it; `held`, sheaves and
                contacts hold where they are at the start, with no more than their friction.
            slide: A direction of the world along which all contacts have slid: friction, as large as it can
                be, pulls back along it.
            increment: How far each degree of freedom starts from the start of the lift [m or rad].

        Raises:
            NoEquilibriumError: If there is none.
        """
        moment = self.scenario.duration if time is None else time
        start = None if increment is None else list(increment)
        way = None if slide is None else [float(part) for part in slide]
        try:
            found = self._core.settle(moment, start, losses, way)
        except RuntimeError as problem:
            raise NoEquilibriumError(moment, *problem.args) from None
        return self._found(found, losses)

    def equilibrium_of(self, state: bytes, *, losses: Losses = "held") -> Equilibrium:
        """The equilibrium of where a simulation has got to, as if everything stopped there.

        Drives and drums stay where they are, with what they have wound; what sticks may go on sticking.

        Args:
            state: What `gantline.simulation.Simulation.save` gave, of the same lift with any settings.
            losses: See `equilibrium`.

        Raises:
            NoEquilibriumError: If there is none.
            ValueError: If it is no state of this lift.
        """
        try:
            found = self._core.settle_saved(state, losses)
        except RuntimeError as problem:
            raise NoEquilibriumError(self._core.time(), *problem.args) from None
        return self._found(found, losses)

    def slid(self, direction: Sequence[float], time: float | None = None) -> Equilibrium | None:
        """Where loads come to rest that slide along a direction of the world.

        From where the plan has brought them: friction of their contacts, as large as it can be, pulls them
        back, and slings pull them on. None where nothing but friction holds them.

        Args:
            direction: Of the world.
            time: As in `equilibrium`.

        Raises:
            NoEquilibriumError: If there is none for another cause.
        """
        try:
            return self.equilibrium(time, slide=direction)
        except NoEquilibriumError as problem:
            if problem.cause == _FALLS:
                return None
            raise

    def stick_range(
        self, direction: Sequence[float], time: float | None = None
    ) -> tuple[Equilibrium | None, Equilibrium | None]:
        """Where loads come to rest that slide along a direction, and against it.

        Between these two friction of their contacts holds them wherever they are put; where one is None the
        range is open on that side. For the rest see `slid`.
        """
        return self.slid(direction, time), self.slid([-part for part in direction], time)

    def step_off(self) -> Equilibrium | None:
        """From the unstable equilibrium found last to the stable one downhill of it.

        It steps off along the motion that leads away fastest, by 0.02 rad (where nothing turns, 0.02 m), in
        the direction in which the first of the coordinates that move most grows. None where the equilibrium
        found last is not unstable.

        Raises:
            NoEquilibriumError: If nothing holds it there.
        """
        try:
            found = self._core.step_off(self._losses)
        except RuntimeError as problem:
            raise NoEquilibriumError(self._core.time(), *problem.args) from None
        return None if found is None else self._found(found, self._losses)

    def _found(self, found: dict[str, Any], losses: Losses) -> Equilibrium:
        self._losses = losses
        moment = float(found["time"])
        recording = self._recording(f"at rest at {moment:g} s")
        for _, _, crane in recording.events("tipping"):  # downhill of the start lies the crane on its back
            raise NoEquilibriumError(moment, crane, "the crane tips over")
        return Equilibrium(
            time=moment,
            recording=recording,
            residual=found["residual"],
            neutral=found["neutral"],
            unstable=found["unstable"],
            steps=found["steps"],
            lossy=tuple(found["lossy"]),
            losses=losses,
            contacts=tuple(
                ContactForce(name, support, np.asarray(friction), bound)
                for name, support, friction, bound in found["contacts"]
            ),
        )

    def modes(self, count: int | None = None) -> list[Mode]:
        """Natural motions about the equilibrium found last, slowest first, after those that lead away.

        Args:
            count: How many; None for all. A few of a large lift take much less time than all of them.
        """
        found = self._core.modes(count)
        ratios = found["damping_ratio"]
        return [
            Mode(
                number=number,
                square=float(square),
                damping_ratio=None if math.isnan(ratios[number]) else float(ratios[number]),
                body_motion=found["body_motion"][number],
                motion=self._words(found["body_motion"][number]),
            )
            for number, square in enumerate(found["square"])
        ]

    def swing(self, mode: Mode, *, amplitude: float = _SHOWN, frames: int = 61) -> Recording:
        """One period of a mode as a recording, so that everything that shows recordings shows it.

        Args:
            mode: Of the modes found last.
            amplitude: Largest displacement of any body [m] or turn [rad].
            frames: Samples.
        """
        moved = mode.body_motion.reshape(-1, 2, 3)
        largest = float(np.linalg.norm(moved, axis=2).max())
        self._core.swing(mode.number, amplitude / largest if largest > 0.0 else 0.0, frames)
        return self._recording(f"mode {mode.number + 1}: {mode.motion}")

    def sensitivities(self, parameters: Sequence[tuple[str, str]] | None = None) -> list[Sensitivity]:
        """Derivatives of tensions and motions about the equilibrium found last, from its factorised tangent.

        Args:
            parameters: Pairs of a kind and a name, see `Sensitivity`; None for the lengths and stiffnesses
                of all slings and the centres of gravity and masses of all loads.
        """
        wanted = list(parameters) if parameters is not None else self._uncertain()
        found = self._core.sensitivities(wanted)
        names = self._core.names()
        ropes, bodies = tuple(names["rope"]), tuple(names["body"])
        return [
            Sensitivity(kind, name, tension, ropes, motion, bodies)
            for (kind, name), tension, motion in zip(
                wanted, found["rope_tension"], found["body_motion"], strict=True
            )
        ]

    def times_of(self, step: str) -> tuple[float | None, float | None]:
        """When a step of the plan began and ended on the way to the equilibrium found last [s].

        None where it had not, or there is no such step.
        """
        return self._core.times_of(step)

    def _uncertain(self) -> list[tuple[str, str]]:
        rig = self.rig
        slings = [(kind, sling.rope) for kind in ("length", "stiffness") for sling in rig.slings]
        kinds = ("centre_x", "centre_y", "centre_z", "mass")
        return [*slings, *((kind, load.body) for load in rig.loads for kind in kinds)]

    def _recording(self, status: str) -> Recording:
        return recording_of(
            self._core.columns(),
            self._core.names(),
            self.assembly.rig,
            title=str(self.assembly.rig.get("title", "")),
            gantline_version=version(),
            scenario=self.scenario.text,
            settings=self.assembly.settings,
            axial_stiffness=self._stiffness(),
            warnings=list(self.assembly.warnings),
            scene=self.assembly.scene,
            counters={},
            status=status,
        )

    def _stiffness(self) -> dict[str, float]:
        """Axial stiffness of ropes that stretch [N]."""
        materials = {rope["name"]: rope["material"] for rope in self.assembly.document["ropes"]}
        return {
            name: float(one["axial_stiffness"]) for name, one in materials.items() if one["type"] == "elastic"
        }

    def _words(self, motion: Floats) -> str:
        """What moves: the bodies with the most kinetic energy."""
        names = self._core.names()["body"]
        turned = self._core.columns()["body_orientation"][-1]
        energies = np.array(
            [_energies(self._bodies[name], row, turned[index])
             for index, (name, row) in enumerate(zip(names, motion, strict=True))]
        )  # fmt: skip
        total = energies.sum(axis=1)
        if total.sum() <= 0.0:
            return "rope runs over sheaves"
        share = total / total.sum()
        named = [index for index in np.argsort(-share) if share[index] >= _TAKES_PART][:2]
        named = named or [int(np.argmax(share))]
        return ", ".join(_moves(names[index], motion[index], energies[index]) for index in named)


def _energies(body: dict[str, object], motion: Floats, quaternion: Floats) -> tuple[float, float]:
    """Kinetic energy of a body's translation and rotation."""
    w, x, y, z = quaternion
    rotation = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )
    xx, yy, zz, xy, xz, yz = np.asarray(body["inertia"], dtype=float)
    inertia = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    spin = rotation.T @ motion[3:]
    mass = float(np.asarray(body["mass"], dtype=float))
    return 0.5 * mass * float(motion[:3] @ motion[:3]), 0.5 * float(spin @ inertia @ spin)


def _moves(name: str, motion: Floats, energies: Floats) -> str:
    shift, turn = energies / energies.sum()
    parts = []
    if shift >= _SHOWS:
        parts.append(f"moves along {_direction(motion[:3])}")
    if turn >= _SHOWS:
        parts.append(f"turns about {_direction(motion[3:])}")
    return f"{name} {' and '.join(parts)}"


def _direction(vector: Floats) -> str:
    unit = vector / np.linalg.norm(vector)
    for axis, name in enumerate("xyz"):
        if abs(unit[axis]) >= _ALONG:
            return name
    unit = unit if unit[int(np.argmax(np.abs(unit)))] > 0 else -unit
    return f"({', '.join(f'{round(part, 2) + 0.0:.2f}' for part in unit)})"
