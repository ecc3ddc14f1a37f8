"""What cranes do so that their hooks lead a load: the way of the hooks, and inverse kinematics of each crane.

docs/concepts/lead.md has the equations, (LD1) to (LD6). Bases of cranes are level and where the lift file has
them: what a vessel heels, ropes stretch and ground gives is left out.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from gantline.scenario.cranes.boom import FloatingCrane
from gantline.scenario.cranes.crawler import Crawler
from gantline.scenario.cranes.hooks import full_name, full_names
from gantline.scenario.cranes.slewing import upper_body
from gantline.scenario.model import Scenario
from gantline.scenario.plan.lead import LeadStep
from gantline.scenario.plan.movers import Mover, mover

__all__ = [
    "Beyond",
    "Gone",
    "LedHook",
    "Pose",
    "Way",
    "gone_along",
    "led_hook",
    "led_hooks",
    "movers_of_lead",
    "pose_before",
    "way_of",
]

#: So many parts of a way are looked at: a crane that goes all round turns by less than 10 degrees in each.
_PARTS = 64
#: So near to square to its way is a boom at 90 degrees but for rounding [rad, and as a share of its reach].
_SQUARE = 1e-9
#: Where things are before a step: the last place that the plan says, as `to` counts it, and whether they are.
Places = Mapping[str, tuple[float, bool]]


@dataclass(frozen=True)
class Pose:
    """Where a crane is.

    Attributes:
        angle: of its boom [rad].
        slew: of its upper structure [rad].
        travel: how far it has travelled [m].
    """

    angle: float
    slew: float
    travel: float


class Beyond(ValueError):
    """A crane does not bring its hook there; the message says how far that is and what it reaches."""


@dataclass(frozen=True)
class LedHook:
    """A hook that leads, with the crane that takes it along.

    Attributes:
        name: of the hook.
        crane: name of the crane.
        base: x and y of the slewing axis in the world, before any travel [m].
        heading: direction from which it slews, and along which it travels, from world x [rad].
        heel: x and z of the heel pins in the axes of the upper structure [m].
        pin: where the hook hangs, along the boom from the heel pins and square to it upwards [m].
        aside: how far the pin is to the left of the slewing axis [m].
        travels: whether it travels in place of luffing.
        boom, upper, hoist, track: what moves it.
    """

    name: str
    crane: str
    base: tuple[float, float]
    heading: float
    heel: tuple[float, float]
    pin: tuple[float, float]
    aside: float
    travels: bool
    boom: Mover
    upper: Mover
    hoist: Mover
    track: Mover | None

    @property
    def movers(self) -> list[Mover]:
        """What moves it."""
        second = self.track if self.travels and self.track is not None else self.boom
        return [self.upper, second, self.hoist]

    def radius(self, angle: float) -> float:
        """How far the pin is ahead of the slewing axis at an angle of the boom (LD2) [m]."""
        along, above = self.pin
        return self.heel[0] + along * math.cos(angle) - above * math.sin(angle)

    def height(self, angle: float) -> float:
        """How high the pin is at an angle of the boom, axes of the upper structure (LD2) [m]."""
        along, above = self.pin
        return self.heel[1] + along * math.sin(angle) + above * math.cos(angle)

    def place(self, pose: Pose) -> tuple[float, float]:
        """Where the pin is from above (LD3), world x and y [m]."""
        ahead, turn = self.radius(pose.angle), self.heading + pose.slew
        cosine, sine = math.cos(turn), math.sin(turn)
        x, y = self._axis(pose.travel)
        return x + ahead * cosine - self.aside * sine, y + ahead * sine + self.aside * cosine

    def follow(self, place: tuple[float, float], before: Pose) -> Pose:
        """How the crane stands so that its pin is at a place from above [m], next to how it stood before.

        Raises:
            Beyond: if it does not reach that.
        """
        return self._travel_to(place, before) if self.travels else self._luff_to(place, before)

    def _axis(self, travel: float) -> tuple[float, float]:
        x, y = self.base
        return x + travel * math.cos(self.heading), y + travel * math.sin(self.heading)

    def _luff_to(self, place: tuple[float, float], before: Pose) -> Pose:
        """(LD4): the direction gives the slew, the distance from the axis the angle of the boom."""
        x, y = self._axis(before.travel)
        east, north = place[0] - x, place[1] - y
        distance = math.hypot(east, north)
        if distance <= abs(self.aside):
            sentence = f"{distance:.2f} m from the slewing axis of '{self.crane}'"
            raise Beyond(f"{sentence}; its hook hangs {abs(self.aside):.2f} m beside it at the least")
        ahead = math.sqrt(distance**2 - self.aside**2)
        turn = math.atan2(north, east) - math.atan2(self.aside, ahead) - self.heading
        long, raised = math.hypot(*self.pin), math.atan2(self.pin[1], self.pin[0])
        cosine = (ahead - self.heel[0]) / long
        if abs(cosine) > 1.0:
            ends = sorted(self.heel[0] + side * long for side in (-1.0, 1.0))
            reach = f"its boom reaches {max(ends[0], 0.0):.2f} m to {ends[1]:.2f} m"
            raise Beyond(f"{ahead:.2f} m from the slewing axis of '{self.crane}'; {reach}")
        return Pose(math.acos(cosine) - raised, _next_to(before.slew, turn), before.travel)

    def _travel_to(self, place: tuple[float, float], before: Pose) -> Pose:
        """(LD5): the radius stays; how far aside of its way the place is gives slew and travel.

        A boom square to the way stays so: the root is 0 there, but for rounding, and has no slope.
        """
        ahead = self.radius(before.angle)
        distance, lead = math.hypot(ahead, self.aside), math.atan2(self.aside, ahead)
        cosine, sine = math.cos(self.heading), math.sin(self.heading)
        east, north = place[0] - self.base[0], place[1] - self.base[1]
        along, across = east * cosine + north * sine, north * cosine - east * sine
        is_square = abs(math.cos(before.slew + lead)) < _SQUARE
        if is_square and abs(abs(across) - distance) < _SQUARE * distance:
            return Pose(before.angle, before.slew, along)
        if is_square or abs(across) >= distance:
            sentence = (
                f"{abs(across):.2f} m aside of the way of '{self.crane}'; at its radius, which it keeps, "
            )
            told = "its boom is square to that way, and goes straight along it only"
            raise Beyond(sentence + (told if is_square else f"it reaches {distance:.2f} m"))
        forward = math.sqrt(distance**2 - across**2)
        forward = math.copysign(forward, math.cos(before.slew + lead))
        turn = math.atan2(across, forward) - lead
        return Pose(before.angle, _next_to(before.slew, turn), along - forward)


def _next_to(before: float, turn: float) -> float:
    """The same direction as a turn, as many times round as brings it next to that before [rad]."""
    return before + math.remainder(turn - before, 2 * math.pi)


@dataclass(frozen=True)
class Way:
    """The way of a load that hooks lead, over the share of it that they have gone (LD1).

    Attributes:
        starts: where each hook is as it begins, x and y of the world [m].
        by: how far the load goes [m].
        turn: by how much it turns [rad].
        about: about which vertical axis [m].
    """

    starts: Sequence[tuple[float, float]]
    by: tuple[float, float, float]
    turn: float
    about: tuple[float, float]

    def place(self, hook: int, share: float) -> tuple[float, float]:
        """Where a hook is from above, x and y of the world [m]."""
        x, y = (self.starts[hook][axis] - self.about[axis] for axis in (0, 1))
        cosine, sine = math.cos(share * self.turn), math.sin(share * self.turn)
        return (
            self.about[0] + x * cosine - y * sine + share * self.by[0],
            self.about[1] + x * sine + y * cosine + share * self.by[1],
        )

    @property
    def length(self) -> float:
        """The way of the hook that goes fastest, as if it went as fast all along [m].

        A hook at r from the axis goes by b dσ + ψ ẑ × R(ψσ) r dσ: fastest where both point alike.
        """
        return max(self._fastest(start) for start in self.starts)

    def _fastest(self, start: tuple[float, float]) -> float:
        x, y = start[0] - self.about[0], start[1] - self.about[1]
        level, round_ = math.hypot(*self.by[:2]), abs(self.turn) * math.hypot(x, y)
        # Angle from `by` to where the hook goes as it turns, at the beginning and the end.
        begin = math.atan2(self.turn * x, -self.turn * y) - math.atan2(self.by[1], self.by[0])
        ends = sorted((begin, begin + self.turn))
        passes = math.floor(ends[1] / (2 * math.pi)) >= math.ceil(ends[0] / (2 * math.pi))
        alike = 1.0 if passes else max(math.cos(end) for end in ends)
        return math.sqrt(level**2 + round_**2 + 2 * level * round_ * alike + self.by[2] ** 2)

    def poses(self, hook: int, led: LedHook, begin: Pose, shares: Sequence[float]) -> Iterator[Pose]:
        """How a crane stands at rising shares of the way.

        Raises:
            Beyond: where it does not reach.
        """
        pose = begin
        for share in shares:
            pose = led.follow(self.place(hook, share), pose)
            yield pose

    def hoisted(self, led: LedHook, begin: Pose, pose: Pose, share: float) -> float:
        """How far the hoist has taken the hook up: the way up less what the boom head has risen (LD6) [m]."""
        return share * self.by[2] - (led.height(pose.angle) - led.height(begin.angle))


@dataclass(frozen=True)
class Gone:
    """What a crane does along a whole way, at even shares of it from 0 to 1.

    Attributes:
        led: the hook that it leads.
        poses: how it stands.
        hoisted: how far its hoist has taken the hook up (LD6) [m].
    """

    led: LedHook
    poses: Sequence[Pose]
    hoisted: Sequence[float]


def gone_along(scenario: Scenario, step: LeadStep, before: Places) -> Iterator[Gone]:
    """What each crane does in a step that leads, without those that do not reach all of their way."""
    hooks = led_hooks(scenario, step)
    shares = [part / _PARTS for part in range(_PARTS + 1)]
    for index, led in enumerate(hooks):
        way, begin = way_of(step, hooks, before), pose_before(led, before)
        try:
            poses = list(way.poses(index, led, begin, shares))
        except Beyond:
            continue
        risen = [way.hoisted(led, begin, pose, share) for pose, share in zip(poses, shares, strict=True)]
        yield Gone(led, poses, risen)


def led_hooks(scenario: Scenario, step: LeadStep) -> list[LedHook]:
    """The hooks that lead in a step, without any that none can: `check_lead` says of those what is wrong."""
    found = (led_hook(scenario, text, step.travelling) for text in step.lead)
    return [led for led in found if led is not None]


def led_hook(scenario: Scenario, text: str, travelling: Sequence[str] = ()) -> LedHook | None:
    """A hook by its name, with the crane that takes it along; None of a crane that does not slew.

    Args:
        scenario: the lift.
        text: name of the hook, as written.
        travelling: cranes that travel in place of luffing.
    """
    name = full_name(text, scenario.hooks)
    hook = None if name is None else scenario.hooks[name]
    placed = None if hook is None else scenario.booms.get(hook.crane)
    upper = None if hook is None else mover(scenario, "upper", hook.crane)
    hoist = None if hook is None else mover(scenario, "hook", hook.name)
    if hook is None or placed is None or upper is None or hoist is None:
        return None
    base, heading = _base(scenario, hook.crane)
    along, across, above = hook.pin
    unmoved = Mover(placed.name, "boom", 0.0, 0.0, start=placed.boom.angle)
    return LedHook(
        name=hook.name,
        crane=hook.crane,
        base=base,
        heading=heading,
        heel=(placed.heel[0], placed.heel[2]),
        pin=(along, above),
        aside=placed.heel[1] + across,
        travels=hook.crane in full_names(travelling, scenario.cranes or {}),
        boom=mover(scenario, "boom", hook.crane) or unmoved,
        upper=upper,
        hoist=hoist,
        track=mover(scenario, "crane", hook.crane),
    )


def _base(scenario: Scenario, name: str) -> tuple[tuple[float, float], float]:
    """Slewing axis of a crane from above [m], and the direction from which it slews [rad]."""
    crane = (scenario.cranes or {})[name]
    if isinstance(crane, Crawler):
        return crane.position, crane.heading
    assert isinstance(crane, FloatingCrane) and crane.slewing_axis is not None
    vessel = (scenario.vessels or {}).get(crane.vessel or "")
    if vessel is not None:
        (x, y), heading = vessel.position, vessel.heading
    else:
        x, y, _ = crane.position or (0.0, 0.0, 0.0)
        heading = crane.heading
    ahead, left = crane.slewing_axis
    cosine, sine = math.cos(heading), math.sin(heading)
    return (x + ahead * cosine - left * sine, y + ahead * sine + left * cosine), heading


def movers_of_lead(scenario: Scenario, step: LeadStep) -> list[Mover]:
    """All that moves in a step that leads."""
    return [one for led in led_hooks(scenario, step) for one in led.movers]


def pose_before(led: LedHook, before: Places) -> Pose:
    """How a crane stands before a step."""
    track = 0.0 if led.track is None else before[led.track.name][0]
    return Pose(before[led.boom.name][0], before[upper_body(led.crane)][0], track)


def way_of(step: LeadStep, hooks: Sequence[LedHook], before: Places) -> Way:
    """The way of the hooks of a step."""
    starts = [led.place(pose_before(led, before)) for led in hooks]
    middle = tuple(math.fsum(place[axis] for place in starts) / len(starts) for axis in (0, 1))
    return Way(starts, step.by, step.turn, step.about or (middle[0], middle[1]))
