"""What heave compensation is asked for in the waves of a lift, by small motions about its equilibria."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from gantline.assembly.afloat.carriers import carried_motion, carrier
from gantline.assembly.spatial import rotation_matrix
from gantline.results.recording import Recording
from gantline.results.rotation import heading
from gantline.scenario import Scenario, ScenarioError
from gantline.scenario.errors import Doubt
from gantline.statics import LinearModel, NoEquilibriumError, Statics
from gantline.units import format_quantity

__all__ = ["LASTS", "HeaveDemand", "doubts_of_demand", "heave_demands"]

Complex = npt.NDArray[np.complex128]
Array = npt.NDArray[np.float64]

#: The largest of so long a time in the sea is what is told [s].
LASTS = 3 * 3600.0


@dataclass(frozen=True)
class HeaveDemand:
    """What a hoist has to add to keep a hook as still as its filter lets it, and what it can.

    Each largest value is the most probable one of 3 h in a sea; of waves that are all alike that of each.

    Attributes:
        hook: The hook.
        step: The first or the last step to compensate over the same deck.
        place: Number of that step in the plan, from 0.
        over: The vessel over whose deck; None is the ground.
        deviation: Standard deviation of the speed that is added [m/s].
        speed: Its largest value [m/s].
        acceleration: That of the acceleration [m/s^2].
        stroke: Twice that of the way [m].
        has: Speed, acceleration and stroke that there are; stroke None where it has no end.
    """

    hook: str
    step: str
    place: int
    over: str | None
    deviation: float
    speed: float
    acceleration: float
    stroke: float
    has: tuple[float, float, float | None]

    def covers(self, other: HeaveDemand) -> bool:
        """Whether it asks for no less speed, acceleration and stroke than another."""
        own = (self.speed, self.acceleration, self.stroke)
        others = (other.speed, other.acceleration, other.stroke)
        return all(most >= least for most, least in zip(own, others, strict=True))

    @property
    def lacks(self) -> list[str]:
        """In words, what there is too little of."""
        names = ("speed", "acceleration", "stroke")
        units = (("m/s", 2), ("m/s^2", 2), ("m", 2))
        asked = (self.speed, self.acceleration, self.stroke)
        return [
            f"'{name}' {format_quantity(needs, *unit)}, and has {format_quantity(has, *unit)}"
            for name, unit, needs, has in zip(names, units, asked, self.has, strict=True)
            if has is not None and needs > has
        ]


def heave_demands(scenario: Scenario) -> list[HeaveDemand]:
    """What each compensator is asked for at most, over the ground and over each deck.

    The lift is looked at at rest where the first and the last step begins that compensates so, with what
    friction holds; of two both are told where each of them asks for more of something. About there vessels,
    crane, load, moorings and water with memory move little, and so in proportion to the waves; drag does not
    count. None of a lift without waves that push, or without statics; none where a vessel moves by a record,
    of which the sea tells nothing.
    """
    if not scenario.waves or not any(step.compensate_heave for step in scenario.plan):
        return []
    given = [vessel.wave_motion for vessel in (scenario.vessels or {}).values()]
    if any(motion is not None and motion.record is not None for motion in given):
        return []
    try:
        statics = Statics(scenario)
        statics.equilibrium(losses="held")
        begins = [statics.times_of(step.step)[0] for step in scenario.plan]
    except (ScenarioError, NoEquilibriumError):
        return []
    document = statics.assembly.document
    pushed = any(one["type"] == "wave" for one in document["forces"])
    if not pushed and not any("waves" in drive for drive in document["drives"]):
        return []
    compensators = {one["name"]: one for one in document["compensators"]}
    steps: dict[tuple[str, str | None], list[int]] = {}
    for place, made in enumerate(document["plan"]):
        for one in made.get("compensates", ()):
            steps.setdefault((one["compensator"], one["against"]), []).append(place)
    responses: dict[float, _Response] = {}
    found = []
    for (hook, over), places in steps.items():
        asked = []
        for place in dict.fromkeys((places[0], places[-1])):
            begin = begins[place]
            if begin is None:
                continue
            if begin not in responses:
                try:
                    responses[begin] = _Response.at(statics, begin)
                except NoEquilibriumError:
                    continue
            heave = responses[begin].heave(compensators[hook], over)
            asked.append(_demand(scenario, responses[begin], heave, compensators[hook], (place, over)))
        found += _most(asked)
    return found


def doubts_of_demand(demands: list[HeaveDemand]) -> Iterator[Doubt]:
    """A sentence for each hoist that can do less than it is asked for."""
    for one in demands:
        if one.lacks:
            needs = f"in these waves heave compensation of {one.hook} needs, at most in 3 h, "
            sentence = f"{needs}{'; '.join(one.lacks)}: past that the hook heaves"
            yield Doubt(("plan", one.place, "compensate_heave"), sentence)


@dataclass(frozen=True)
class _Response:
    """A lift in its waves about an equilibrium.

    Attributes:
        recording: The equilibrium.
        model: Its matrices; those of motion hold for all frequencies.
        frequency: Of each wave of the sea (n,) [rad/s].
        motion: Of each degree of freedom by each wave, over exp -iωt (n, coordinate) [m or rad].
        centres: Centres of gravity of bodies, in their own axes [m].
        carried: Surge to yaw of vessels that move by their RAOs, by each wave (n, 6) [m or rad].
    """

    recording: Recording
    model: LinearModel
    frequency: Array
    motion: Complex
    centres: Mapping[str, Array]
    carried: Mapping[str, Complex]

    @classmethod
    def at(cls, statics: Statics, time: float) -> _Response:
        """At a time of the plan [s].

        Raises:
            NoEquilibriumError: If there is no equilibrium then.
        """
        from scipy.linalg import null_space  # takes a while to load

        recording = statics.equilibrium(time, losses="held").recording
        document = statics.assembly.document
        centres = {one["name"]: np.array(one["centre_of_gravity"]) for one in document["bodies"]}
        forces = [one for one in document["forces"] if one["type"] == "wave"]
        motion = []
        model = statics.linear_model()
        # Of ropes, pins and sheaves that hold some may repeat others.
        free = null_space(model.held) if len(model.held) else np.eye(len(model.coordinates))
        for place, wave in enumerate(document["sea"]["components"] if forces else ()):
            omega = wave["frequency"]
            model = statics.linear_model(omega)
            push = sum(
                model.body_motion[model.bodies.index(force["body"])].T
                @ _push(force, place, wave, recording, centres[force["body"]])
                for force in forces
            )
            dynamic = model.stiffness - 1j * omega * model.damping - omega**2 * model.mass
            motion.append(free @ np.linalg.solve(free.T @ dynamic @ free, free.T @ push))
        frequency = np.array([wave["frequency"] for wave in document["sea"]["components"]])
        answers = np.zeros((len(frequency), len(model.coordinates)), dtype=np.complex128)
        if forces:
            answers[:] = motion
        carried = {
            one.name: carried_motion(document, one.name) for one in recording.rig.vessels if one.is_carried
        }
        return cls(recording, model, frequency, answers, centres, carried)

    def heave(self, compensator: Mapping[str, Any], over: str | None) -> Complex:
        """How the place of the vessel at the boom head heaves, over the deck below it if any (n,) [m]."""
        body, at = compensator["head"]
        head = _place(self.recording, body, np.array(at), self.centres[body])
        own = self._rise(compensator["vessel"], head)
        return own if over is None else own - self._rise(over, head)

    def _rise(self, body: str, point: Array) -> Complex:
        """How a place of a body heaves that is plumb below or above a point of the world (n,) [m]."""
        if body in self.carried:
            about = carrier(body, "surge")
            ahead = heading(self.recording.column("body_orientation", about)[-1])
            x, y = (point - self.recording.column("body_position", about)[-1])[:2]
            forward = math.cos(ahead) * x + math.sin(ahead) * y
            port = math.cos(ahead) * y - math.sin(ahead) * x
            own = self.carried[body]
            level: Complex = own[:, 2] + own[:, 3] * port - own[:, 4] * forward
            return level
        motion = self.motion @ self.model.body_motion[self.model.bodies.index(body)].T
        arm = point - self.recording.column("body_position", body)[-1]
        rise: Complex = motion[:, 2] + motion[:, 3] * arm[1] - motion[:, 4] * arm[0]
        return rise


def _push(
    force: Mapping[str, Any], place: int, wave: Mapping[str, Any], recording: Recording, centre: Array
) -> Complex:
    """Force and moment of a wave about a vessel's centre of gravity at rest, world axes (6,) [N, N m]."""
    turned = recording.column("body_orientation", force["body"])[-1]
    way = math.atan2(wave["wave_number"][1], wave["wave_number"][0])
    towards = heading(turned)
    directions = np.array(force["directions"])
    ahead = directions[0] + (way - towards - directions[0]) % math.tau
    before = int(np.searchsorted(directions, ahead, side="right")) - 1
    gap = np.diff(directions, append=directions[0] + math.tau)[before]
    share = ((ahead - directions[before]) / gap) ** np.arange(4)
    parts = np.array(force["phasors"][place])[before]
    whole = share @ (parts[..., 0] + 1j * parts[..., 1]) * wave["amplitude"]
    origin = _place(recording, force["body"], np.array(force["origin"]), centre)
    phase = np.dot(wave["wave_number"], origin[:2]) + wave["phase"]
    turn = np.array(
        [[math.cos(towards), -math.sin(towards), 0], [math.sin(towards), math.cos(towards), 0], [0, 0, 1]]
    )
    pull, moment = turn @ whole[:3], turn @ whole[3:]
    arm = _place(recording, force["body"], np.array(force["at"]), centre)
    arm = arm - recording.column("body_position", force["body"])[-1]
    wrench: Complex = np.exp(1j * phase) * np.concatenate([pull, moment + np.cross(arm, pull)])
    return wrench


def _place(recording: Recording, body: str, at: Array, centre: Array) -> Array:
    """Where a point of a body is [m]."""
    turn = rotation_matrix(recording.column("body_orientation", body)[-1].tolist())
    place: Array = recording.column("body_position", body)[-1] + turn @ (at - centre)
    return place


def _demand(
    scenario: Scenario,
    response: _Response,
    heave: Complex,
    compensator: Mapping[str, Any],
    what: tuple[int, str | None],
) -> HeaveDemand:
    """Of the heave z of each wave compensation adds |c| = |z| ωτ/√(1 + ω²τ²), what its filter keeps off."""
    omega, place = response.frequency, what[0]
    behind = omega * compensator["filter"]
    added = np.abs(heave) * behind / np.sqrt(1.0 + behind**2)
    alike = np.concatenate(
        [
            np.full(1 if train.is_regular else train.components, train.is_regular)
            for train in (scenario.waves or {}).values()
        ]
    )
    way, speed, acceleration = (_largest(omega, added * omega**power, alike) for power in range(3))
    has = (compensator["velocity"], compensator["acceleration"], compensator["stroke"])
    return HeaveDemand(
        hook=compensator["name"],
        step=scenario.plan[place].step,
        place=place,
        over=what[1],
        deviation=_deviation(added * omega),
        speed=speed,
        acceleration=acceleration,
        stroke=2.0 * way,
        has=has,
    )


def _most(asked: list[HeaveDemand]) -> list[HeaveDemand]:
    """Those of which no other asks for as much of everything.

    A boom that slews from over the bow to over the side goes up and down in other waves there: more slowly
    and farther, say.
    """
    found: list[HeaveDemand] = []
    for one in asked:
        if not any(other.covers(one) for other in found):
            found = [other for other in found if not one.covers(other)] + [one]
    return found


def _largest(omega: Array, amplitude: Array, alike: npt.NDArray[np.bool_]) -> float:
    """The most probable largest value in 3 h: σ √(2 ln N) of N = T σ'/2πσ crests of a sea (Rayleigh).

    Waves that are all alike come on top with their amplitudes.
    """
    sea = np.where(alike, 0.0, amplitude)
    deviation = _deviation(sea)
    steady = float(amplitude[alike].sum())
    if deviation == 0.0:
        return steady
    crests = LASTS * _deviation(sea * omega) / (math.tau * deviation)
    return steady + deviation * math.sqrt(2.0 * math.log(max(crests, 1.0)))


def _deviation(amplitude: Array) -> float:
    """Standard deviation of a sum of waves of other frequencies."""
    return math.sqrt(0.5 * float(np.sum(amplitude**2)))
