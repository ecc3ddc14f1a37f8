"""Hoists that turn a load in a hinge to where their pull goes through the hinge, and stop too late for that.

The last degrees to upright take next to no hoisting: the lever of a pull about the hinge vanishes, a hoist at
full speed turns the load faster and faster, and while it stops it has nothing left to turn.
docs/concepts/hinge.md has the equations.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from gantline.assembly.loads.lifted import LiftedLoad
from gantline.assembly.parts import Parts
from gantline.assembly.spatial import Array, inertia_matrix, unit
from gantline.scenario import Rigging, Scenario
from gantline.scenario.cranes.hooks import Hook, full_names
from gantline.scenario.cranes.kept_plumb import is_moved_by
from gantline.scenario.errors import Doubt
from gantline.scenario.loads.hinge import LoadHinge
from gantline.scenario.plan.lead import LeadStep
from gantline.scenario.plan.movers import mover
from gantline.scenario.plan.plan import Step
from gantline.scenario.plan.slinging import slings_on
from gantline.scenario.plan.steps import AlongStep, HoistStep, HoldStep, LineStep
from gantline.scenario.rigging import SlingRigging
from gantline.units import format_quantity

__all__ = ["doubtful_hinges"]

#: Pull over the weight of the load from which on a stop is told: it weighs one, half of that is no noise.
_TOO_MUCH = 1.5
#: How closely angles are looked at [rad], and as far as a load is turned.
_ANGLES = np.radians(np.linspace(0.0, 180.0, 18001))
#: Of an angle that is looked at [rad].
_ROUNDING = 1e-9
#: Cosine to plumb beyond which the axis of a hinge is no level one, about which loads are raised.
_LEVEL = 0.1
#: Least length of falls at their shortest [m].
_SHORTEST = 1.0
#: How often a speed is halved that is looked for, and below which no hoist creeps [m/s].
_HALVINGS, _SLOWEST = 40, 0.05 / 60.0


def doubtful_hinges(
    parts: Parts, scenario: Scenario, rigging: Rigging, lifted: LiftedLoad | None
) -> Iterator[Doubt]:
    """Each step that hoists a load in a hinge to a tilt at which it stops too late, or that it never reaches.

    Of one hook that nothing of the plan takes aside before, to which all slings lead, of known stiffness and
    length; hinge and crane stand on the same vessel, or both in the yard.

    Args:
        parts: The system with all its bodies.
        scenario: The lift.
        rigging: Who carries whom.
        lifted: Its load; None without one.
    """
    for name, hinge in (scenario.hinges or {}).items():
        if lifted is None:
            return
        for place, step, hook, slings in _hoists(scenario, rigging, name, hinge):
            turn = _turn(parts, scenario, hinge, hook, slings, lifted)
            above = step.until.load_tilt.above if step.until and step.until.load_tilt else None
            if turn is None or above is None:
                continue
            if said := _said(scenario, name, step, hook, turn, above):
                yield Doubt(("plan", place, "until"), said)


@dataclass(frozen=True)
class _Turn:
    """A load as a hook turns it in its hinge, its slings taut.

    Attributes:
        tilt: Of the load at each angle by which it has turned, as far as the hook turns it (n,) [rad].
        height: Of the hook at these, over the start (n,) [m].
        centre: Height of the centre of gravity (n,) [m].
        weight: Of the load [N].
        inertia: About the hinge [kg m^2].
        slings: Stiffness of all slings, upwards where the pull goes through the hinge [N/m].
        falls: EA of all falls together [N] and their length at the start [m]; infinite of a hook without.
    """

    tilt: Array
    height: Array
    centre: Array
    weight: float
    inertia: float
    slings: float
    falls: tuple[float, float]

    def lever(self, at: int) -> float:
        """What the hook goes up per angle [m/rad], the lever of its pull."""
        return float(np.gradient(self.height, _ANGLES[1])[at])

    def pull(self, at: int, speed: float, acceleration: float) -> float:
        """Largest pull of the hook that stops from a speed [m/s] as the load comes to an angle [N].

        By (HG3) what bears the load there, and the larger one of (HG4) and (HG5).
        """
        lever = self.lever(at)
        still = self.weight * float(np.gradient(self.centre, _ANGLES[1])[at]) / lever
        area, length = self.falls
        length = max(length - float(self.height[at]), _SHORTEST)
        stiffness = 1.0 / (1.0 / self.slings + length / area)
        beyond = stiffness * (speed**2 / (2.0 * acceleration) - self.room(at))
        own = math.sqrt(stiffness / self.inertia) * lever
        thrown = speed * self.inertia * own / lever**2 * min(1.0, 2.0 * acceleration / (own * speed))
        return still + max(beyond, thrown)

    def room(self, at: int) -> float:
        """How far the hook goes up from an angle until its pull goes through the hinge [m]."""
        return float(self.height[-1] - self.height[at])


def _hoists(
    scenario: Scenario, rigging: Rigging, name: str, hinge: LoadHinge
) -> Iterator[tuple[int, HoistStep, Hook, list[SlingRigging]]]:
    """Steps that hoist to a tilt while the hinge holds, with their place in the plan, hook and slings."""
    aside: set[str] = set()
    longer: dict[str, float] = {}
    for place, (step, on) in enumerate(zip(scenario.plan, slings_on(scenario), strict=True)):
        if name in step.open_hinges:
            return
        aside |= _taken_along(scenario, step)
        if isinstance(step, LineStep):
            _pay_out(scenario, step, longer)
        slings = [
            replace(one, length=one.length + longer.get(one.name, 0.0))
            for one in rigging.slings.values()
            if one.name in on
        ]
        hooks = {one.hook for one in slings}
        if not isinstance(step, HoistStep) or step.until is None or step.until.load_tilt is None:
            continue
        (hook,) = hooks if len(hooks) == 1 else ("",)
        gear = any(one.equalizer or one.spreader or one.compensator or one.over for one in slings)
        known = scenario.hooks.get(hook)
        if gear or known is None or hook not in full_names(step.moved, scenario.hooks):
            continue
        beside = _beside(scenario, place)
        taken = aside.union(*(_taken_along(scenario, one) for one in beside))
        changing = dict.fromkeys((one.name for one in slings), 0.0)
        for other in (one for one in beside if isinstance(one, LineStep)):
            _pay_out(scenario, other, changing)
        if any(changing.values()) or not all(math.isfinite(one.length) for one in slings):
            continue
        if hook not in taken and _stand_alike(scenario, hinge, known):
            yield place, step, known, slings


def _pay_out(scenario: Scenario, step: LineStep, longer: dict[str, float]) -> None:
    """Counts by how much a step makes slings longer [m]; no number where it does not say how much."""
    for text in step.moved:
        one = mover(scenario, step.kind, text)
        if one is not None and one.kind == "sling":
            name, way = one.name.removeprefix("sling."), math.nan if step.by is None else step.by
            longer[name] = longer.get(name, 0.0) + step.direction * way


def _beside(scenario: Scenario, place: int) -> list[Step]:
    """Steps after one that go on beside it."""
    found: list[Step] = []
    for step in scenario.plan[place + 1 :]:
        if isinstance(step, HoldStep) or step.starts != "with_previous":
            break
        found.append(step)
    return found


def _taken_along(scenario: Scenario, step: Step) -> set[str]:
    """Hooks that a step takes along."""
    if isinstance(step, LeadStep):
        return set(full_names(step.lead, scenario.hooks)) if any(step.by[:2]) or step.turn else set()
    if not isinstance(step, AlongStep):
        return set()
    moved = [one for name in step.moved if (one := mover(scenario, step.kind, name)) is not None]
    return {name for name, hook in scenario.hooks.items() if any(is_moved_by(one, hook) for one in moved)}


def _stand_alike(scenario: Scenario, hinge: LoadHinge, hook: Hook) -> bool:
    """Whether hinge and crane stand on the same vessel, or both on none."""
    crane = (scenario.cranes or {})[hook.crane]
    holder = None if hinge.held_by == "world" else hinge.held_by
    return holder == getattr(crane, "vessel", None)


def _turn(
    parts: Parts,
    scenario: Scenario,
    hinge: LoadHinge,
    hook: Hook,
    slings: list[SlingRigging],
    lifted: LiftedLoad,
) -> _Turn | None:
    """The load as its hook turns it; None where that is not known, or does not go up at first."""
    load = scenario.load
    assert load is not None  # a hinge without a load was refused
    position, turned = parts.pose(load.name)
    axis, own = turned @ np.array(unit(hinge.axis)), parts.bodies[load.name]
    pivot = position + turned @ (np.array(hinge.at) - lifted.centre)
    bearing = parts.pose(hook.name)[0] - pivot
    known = [
        (one.length, one.rope.stiffness, turned @ (np.array(load.lugs[lug].at) - np.array(hinge.at)))
        for one in slings
        for lug in one.lugs
    ]
    if abs(axis[2]) > _LEVEL or not known or any(ea is None for _, ea, _ in known):
        return None
    mean = np.mean([lug for _, _, lug in known], axis=0)
    axis = axis if np.cross(axis, mean)[2] > 0.0 else -axis
    height = np.min([_height(lug, axis, bearing, length) for length, _, lug in known], axis=0)
    with np.errstate(invalid="ignore"):  # where no sling reaches
        falls = np.flatnonzero(np.diff(height) <= 0.0)
    most = int(falls[0]) + 1 if falls.size else len(height)
    if most < 2 or not np.isfinite(height[0]):
        return None
    centre = position + turned @ np.array(own["centre_of_gravity"]) - pivot
    across = centre - (centre @ axis) * axis
    within = turned.T @ axis
    about = float(within @ inertia_matrix(own["inertia"]) @ within)
    # As they are in the end, where their stiffness counts.
    upright = [(height - _turned(lug, axis)[:, 2])[most - 1] / length for length, _, lug in known]
    stiff = sum((ea or 0.0) / one * up**2 for (one, ea, _), up in zip(known, upright, strict=True))
    return _Turn(
        tilt=np.arccos(np.clip(_turned(turned[:, 2], axis)[:most, 2], -1.0, 1.0)),
        height=height[:most] - height[0],
        centre=_turned(centre, axis)[:most, 2],
        weight=float(own["mass"]) * scenario.simulation.gravity,
        inertia=about + float(own["mass"]) * float(across @ across),
        slings=float(stiff),
        falls=_falls(parts, scenario, hook),
    )


def _height(lug: Array, axis: Array, bearing: Array, length: float) -> Array:
    """Height of a hook over the hinge whose sling is just taut, at all angles (n,) [m].

    Args:
        lug: From the hinge at the start (3,) [m].
        axis: About which the load turns (3,).
        bearing: Of the hook, which keeps its place in the plan view, from the hinge (3,) [m].
        length: Of the sling [m]; where it is too short to reach, the height is -inf.
    """
    there = _turned(lug, axis)
    left = length**2 - ((bearing - there)[:, :2] ** 2).sum(axis=1)
    height: Array = np.where(left >= 0.0, there[:, 2] + np.sqrt(np.maximum(left, 0.0)), -np.inf)
    return height


def _turned(place: Array, axis: Array) -> Array:
    """A place or direction, turned by all angles about an axis by the right hand, shape (n, 3)."""
    along = (place @ axis) * axis
    cosine, sine = np.cos(_ANGLES)[:, None], np.sin(_ANGLES)[:, None]
    turned: Array = along + (place - along) * cosine + np.cross(axis, place) * sine
    return turned


def _falls(parts: Parts, scenario: Scenario, hook: Hook) -> tuple[float, float]:
    """EA of all falls of a hook together [N], and how long they are at the start [m]."""
    reeving = hook.reeving
    ropes = [one["length"] for one in parts.ropes if one["name"].startswith(f"hoist.{hook.name}.")]
    stiffness = None if reeving is None else (scenario.ropes or {})[reeving.rope].stiffness
    if reeving is None or not ropes or stiffness is None:
        return math.inf, _SHORTEST
    return stiffness * reeving.parts_each * len(ropes), float(np.mean(ropes)) / reeving.parts_each


def _said(scenario: Scenario, name: str, step: HoistStep, hook: Hook, turn: _Turn, above: float) -> str:
    """What is wrong with a step that hoists a load to a tilt [rad]; nothing where it stops in time."""
    assert scenario.load is not None  # a hinge without a load was refused
    load, wanted = scenario.load.name, format_quantity(above, "deg", 1)
    over = np.flatnonzero(turn.tilt > above - _ROUNDING)
    if not over.size:
        most = format_quantity(float(turn.tilt.max()), "deg", 1)
        goes = f"'{hook.name}' turns {load} to {most} at most, where its pull goes through hinge '{name}'"
        right = "wait for less, or hoist from farther on"
        return f"step '{step.step}' waits for a tilt above {wanted}: {goes}; {right}"
    at, acceleration = int(over[0]), step.acceleration or hook.hoist.acceleration
    pull = turn.pull(at, step.speed, acceleration) / turn.weight
    if pull < _TOO_MUCH:
        return ""
    goes = f"step '{step.step}' hoists '{hook.name}' at {format_quantity(step.speed, 'm/min', 2)} to {wanted}"
    lever = format_quantity(turn.lever(at), "m", 2)
    left = format_quantity(turn.room(at), "mm", 0)
    way = format_quantity(step.speed**2 / (2.0 * acceleration), "mm", 0)
    there = f"its pull has a lever of {lever} about hinge '{name}' there, {left} short of going through it"
    stops = f"it goes on for {way} as it stops, and pulls with about {pull:.1f} times the weight of {load}"
    speed = _slow_enough(turn, at, step.speed, acceleration)
    slower = "" if speed is None else f"end at {format_quantity(speed, 'm/min', 2)} at most, or "
    return f"{goes}: {there}; {stops}; {slower or 'end '}with less tilt"


def _slow_enough(turn: _Turn, at: int, speed: float, acceleration: float) -> float | None:
    """The highest speed below one that is too high [m/s] at which the hook pulls no more than the weight."""
    least, most = 0.0, speed
    for _ in range(_HALVINGS):
        middle = 0.5 * (least + most)
        fits = turn.pull(at, middle, acceleration) <= turn.weight
        least, most = (middle, most) if fits else (least, middle)
    return least if least > _SLOWEST else None
