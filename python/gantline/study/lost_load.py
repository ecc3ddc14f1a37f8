"""A load that is lost at once: how far vessels swing, and whether they come back.

With the load a vessel lies at an angle; without it, it comes to rest at another one, and swings past that.
The work that the load has left in it is the area A1 below the righting arms without the load, from where it
lies to where it comes to rest. What it can take on the other side is A2, up to where water comes in or arms
vanish. See docs/concepts/lost_load.md.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
import numpy.typing as npt

from gantline.arguments import needed
from gantline.hydro import CannotFloatError, Heeled, Hull, Righting
from gantline.results import series
from gantline.results.afloat.attitude import Lie
from gantline.results.afloat.vessels import Vessel
from gantline.results.file.saved import digest_of
from gantline.results.loads.hinges import is_shut
from gantline.results.recording import Recording
from gantline.results.rotation import axes
from gantline.statics import Equilibrium, NoEquilibriumError, Statics
from gantline.statics.inclining import MetacentricHeights, metacentric_heights
from gantline.study.afloat import hull_of

__all__ = ["LostLoad", "Swing", "lose_load"]

Floats = npt.NDArray[np.float64]

#: What a vessel swings towards, by the angle from its bow to port in steps of 45°.
_WAYS = (
    "bow",
    "port bow",
    "port",
    "port quarter",
    "stern",
    "starboard quarter",
    "starboard",
    "starboard bow",
)
#: Name of the edge of the deck among the marks of a vessel: it is told, and no water comes in there.
DECK_EDGE = "deck_edge"
#: A vessel that turns by less is not moved by the load [rad].
_STAYS = math.radians(0.001)
#: Farthest from rest that arms are looked at, as far as they count by the IS Code, and how far apart [rad].
_FARTHEST = math.radians(50.0)
_STEP = math.radians(0.5)
#: Share of a load that hangs at least where something may part that it hangs by [1].
_HANGS_FROM = 0.05
#: Share of its weight with which a load rests on something, and not by rounding [1].
_TOUCHES = 1e-6
#: Roots of angles are found to this [rad].
_ANGLE = 1e-10


@dataclass(frozen=True)
class Swing:
    """How a vessel swings that has lost a load, undamped, and what it can take.

    Angles are from the vessel's upright about one axis, positive the way it swings, away from the load.

    Attributes:
        vessel: Its name.
        away: The way it swings, over its bow 0, to port positive [rad].
        before: Angle with the load [rad].
        after: Angle at rest without it [rad].
        farthest: Angle of the first swing [rad]; None where the arms do not stop it.
        freeboard: Of the lowest point of deck edge and openings there [m]; None without `farthest`.
        under: Angles at which deck edge and openings go under on that side [rad]; of those that do.
        flooding: The first of the openings' [rad]; None where none goes under.
        has_openings: Whether the lift file gives the vessel any.
        vanishing: Angle at which the arms vanish [rad]; None where they do not within 50° of rest.
        end: Angle up to which A2 counts, the first of these two, or 50° past rest [rad].
        left: A1, the work over the weight that the load has left in it [m rad].
        taken: A2, what it can take on that side [m rad].
        left_at_design: A1 that the design weight of the load would leave [m rad]; None where it has no more
            than is simulated, or no equilibrium with it.
        angles: Of the curve [rad], shape (n,).
        arms: Righting arms there, positive where they push back towards the load [m], shape (n,).
    """

    vessel: str
    away: float
    before: float
    after: float
    farthest: float | None
    freeboard: float | None
    under: Mapping[str, float]
    flooding: float | None
    has_openings: bool
    vanishing: float | None
    end: float
    left: float
    taken: float
    angles: Floats = field(repr=False)
    arms: Floats = field(repr=False)
    left_at_design: float | None = None

    @property
    def towards(self) -> str:
        """The way it swings, in words."""
        return _WAYS[round(self.away / math.radians(45.0)) % len(_WAYS)]

    @property
    def ratio(self) -> float:
        """A2 over A1."""
        return self.taken / self.left

    @property
    def ratio_at_design(self) -> float | None:
        """The same with the design weight of the load; None where that is not known."""
        return None if self.left_at_design is None else self.taken / self.left_at_design

    @property
    def is_held(self) -> bool:
        """Whether it swings back before water comes in, with the design weight too."""
        return self.taken > max(self.left, self.left_at_design or 0.0)


@dataclass(frozen=True)
class LostLoad:
    """What becomes of a lift that loses a load at once.

    Attributes:
        load: Its name.
        rest: The equilibrium without it.
        heights: Metacentric heights of the vessels there.
        swings: Of the vessels that it moves.
        stands: Whether less than 5 % of it hung, so that nothing it hung by could part.
        under_with_load: What of each vessel is under water with the load still on, deck edge or openings, by
            the vessel's name; of those that have any.
    """

    load: str
    rest: Equilibrium
    heights: Mapping[str, MetacentricHeights]
    swings: Sequence[Swing]
    stands: bool
    under_with_load: Mapping[str, Sequence[str]] = field(default_factory=dict)

    @property
    def flooded(self) -> dict[str, list[str]]:
        """Openings that water comes in by before the load is lost, by vessel; arms do not know of it."""
        openings = {
            vessel: [mark for mark in marks if mark != DECK_EDGE]
            for vessel, marks in self.under_with_load.items()
        }
        return {vessel: marks for vessel, marks in openings.items() if marks}

    @property
    def is_sound(self) -> bool:
        """Whether all vessels are dry with the load, come back, and rest without it."""
        comes_back = all(swing.is_held for swing in self.swings)
        return self.rest.is_stable and comes_back and not self.flooded

    def to_json(self) -> dict[str, Any]:
        """All of it as a JSON object, SI units, with the lift file that it belongs to."""
        return {
            "load": self.load,
            "scenario_sha256": digest_of(str(self.rest.recording.attributes["scenario"])),
            "sound": self.is_sound,
            "stands": self.stands,
            "under_with_load": {vessel: list(marks) for vessel, marks in self.under_with_load.items()},
            "flooded": [f"{vessel}.{mark}" for vessel, marks in self.flooded.items() for mark in marks],
            **self.rest.to_json(),
            "metacentric_heights": {
                name: [height.transverse, height.longitudinal] for name, height in self.heights.items()
            },
            "swings": [_swing_json(swing) for swing in self.swings],
        }


def _swing_json(one: Swing) -> dict[str, Any]:
    single = (
        "vessel", "towards", "away", "before", "after", "farthest", "freeboard", "flooding", "vanishing",
        "end", "left", "taken", "ratio", "left_at_design", "ratio_at_design",
    )  # fmt: skip
    return {
        **{name: getattr(one, name) for name in single},
        "under": dict(one.under),
        "angle": one.angles.tolist(),
        "arm": one.arms.tolist(),
    }


def lose_load(question: Statics, rest: Equilibrium, load: str) -> LostLoad:
    """Lose a load at the equilibrium found last.

    Args:
        question: The lift.
        rest: Its equilibrium that was found last.
        load: Name of the load.

    Raises:
        NoEquilibriumError: If there is none without it.
        TypeError: If it is asked of a lift file, or of no equilibrium.
        ValueError: If there is no such load, or no vessel that floats freely, or the load rests on one, which
            does not lose it.
    """
    needed(question, Statics, "a lift to ask for equilibria", "gantline.Statics(lift) is one")
    needed(rest, Equilibrium, "an equilibrium", "`equilibrium` of a Statics gives one")
    vessels = [vessel for vessel in rest.recording.rig.vessels if not vessel.is_carried]
    if rest.recording.rig.vessels and not vessels:
        raise ValueError("vessels with 'wave_motion' move by that alone, whatever they lose")
    if not vessels:
        ashore = "a run shows what a crane on land does, with 'cut_at' on the slings of its load"
        raise ValueError(f"no vessel of this lift floats; {ashore}")
    hung = float(rest.recording.column("load_transferred", load)[-1]) if _is_told(rest, load) else 1.0
    _refuse_aboard(question, rest, load)
    heavier = _with_design_weight(question, load)
    without = question.lose(load)
    heights = metacentric_heights(question, without)
    swings, under = [], dict[str, list[str]]()
    for vessel in vessels:
        turn, lie = _lie(rest.recording, vessel)
        wet = [mark for mark, points in vessel.marks.items() if _lowest(lie.up, lie.height, points) < 0.0]
        under |= {vessel.name: wet} if wet else {}
        ups = [turn[2], *(_lie(one, vessel)[0][2] for one in heavier)]
        swing = _swing(hull_of(question, vessel.name), vessel, ups, without.recording, heights[vessel.name])
        swings += [swing] if swing is not None else []
    return LostLoad(load, without, heights, swings, stands=hung < _HANGS_FROM, under_with_load=under)


def _with_design_weight(question: Statics, load: str) -> list[Recording]:
    """How the lift rests with the design weight of a load; none where it has no more than is simulated."""
    more = {one.body: one.more_mass for one in question.rig.loads if one.name == load and one.more_mass > 0.0}
    if not more:
        return []
    try:
        return [question.heavier(more)[1]]
    except NoEquilibriumError:
        return []


def _refuse_aboard(question: Statics, rest: Equilibrium, load: str) -> None:
    """Raise where a load rests on a vessel: what lets it go leaves it there, and nothing is without it."""
    rig = rest.recording.rig
    parents = {body["name"]: body["parent"] for body in question.assembly.document["bodies"]}
    afloat = {vessel.body: vessel.name for vessel in rig.vessels}
    lost = next((one for one in rig.loads if one.name == load), None)
    if lost is None:
        return
    for hinge in rig.hinges:
        if hinge.load == load and is_shut(rest.recording, hinge)[-1]:
            sentence = f"at {rest.time:g} s hinge '{hinge.name}' holds '{load}', which stays in it"
            raise ValueError(f"{sentence}; --time says when 'open_hinges' has let it go")
    weight = float(series.load_weight(rest.recording, lost)[-1])
    # In a cradle contacts press harder than what they bear.
    pressed = float(series.support_force(rest.recording, lost)[-1])
    bears = float(series.borne(rest.recording, lost)[-1]) / pressed if pressed > 0.0 else 0.0
    borne = dict[str, float]()
    for contact in lost.contacts:
        body = lost.meets.get(contact)
        while body is not None and body not in afloat:
            body = parents.get(body)
        if body is not None:
            force = bears * float(rest.recording.column("contact_force", contact)[-1])
            borne[afloat[body]] = borne.get(afloat[body], 0.0) + force
    for vessel, force in borne.items():
        if force > _TOUCHES * weight:
            sentence = f"at {rest.time:g} s {vessel} bears {100.0 * force / weight:.3g} % of '{load}'"
            stays = "which stays aboard where its slings let it go"
            right = f"--time says when it hangs clear of {vessel}, and a run with 'cut_at' on its slings"
            raise ValueError(f"{sentence}, {stays}; {right} shows where it comes down")


def _lowest(up: Floats, height: Floats | float, points: Sequence[Sequence[float]] | Floats) -> float:
    """Height over the water of the lowest of some points of a vessel [m]."""
    return float((np.asarray(points) @ up).min() + height)


def _is_told(rest: Equilibrium, load: str) -> bool:
    """Whether the recording tells how much of a load hangs; there may be no such load."""
    return load in rest.recording.coordinates.get("load", ())


def _lie(recording: Recording, vessel: Vessel) -> tuple[Floats, Lie]:
    """World from vessel, shape (3, 3), and how it lies, at the last sample."""
    turn = axes(recording.column("body_orientation", vessel.body)[-1])
    origin = recording.column("body_position", vessel.body)[-1] - turn @ np.asarray(vessel.centre_of_gravity)
    return turn, Lie(turn, origin[2] - vessel.level)


def _swing(
    hull: Hull, vessel: Vessel, ups: Sequence[Floats], without: Recording, heights: MetacentricHeights
) -> Swing | None:
    """The swing of a vessel; None where the load does not move it, or nothing rights it without the load.

    Args:
        hull: Its hull.
        vessel: It.
        ups: Upwards in its axes with the load, and with the design weight of that where it is more, each of
            shape (3,).
        without: The equilibrium without the load.
        heights: What rights it there.
    """
    turn, lie = _lie(without, vessel)
    up = turn[2]
    axis = np.cross(up, ups[0])[:2]  # of the turn that the vessel makes
    if np.linalg.norm(axis) < _STAYS:
        return None
    axis /= np.linalg.norm(axis)
    centre = _centre_of_gravity(hull, up, float(lie.height), heights, axis)
    if centre is None:
        return None
    # Turned so that the axis points forward: the swing is heel to starboard.
    aside = np.array([[axis[0], axis[1], 0.0], [-axis[1], axis[0], 0.0], [0.0, 0.0, 1.0]])
    vertices, triangles = hull.mesh
    turned = Hull(hull.name, vertices @ aside.T, triangles)
    mass = float(without.column("vessel_displacement", vessel.name)[-1])
    righting = Righting(turned, mass, aside @ centre, density=vessel.density)
    marks = {name: np.array(points) @ aside.T for name, points in vessel.marks.items()}
    before, after, *heavier = (
        math.atan2(way[1], way[2]) for way in (aside @ one for one in (ups[0], up, *ups[1:]))
    )
    away = math.atan2(-aside[1, 1], -aside[1, 0])
    curve = _Curve(righting, marks)
    swing = _measured(curve, vessel.name, away, before, after)
    left = [curve.at(angle).work - curve.at(after).work for angle in heavier]
    return replace(swing, left_at_design=max(left, default=None))


def _centre_of_gravity(
    hull: Hull, up: Floats, height: float, heights: MetacentricHeights, axis: Floats
) -> Floats | None:
    """Of all that weighs on a vessel at rest, vessel axes (3,) [m], such that it rights itself as it does.

    None where nothing rights it about the axis. It is plumb over the centre of buoyancy, by s. Where the
    section of the surface has the moments I about its middle and V lies below it, a turn about a level axis u
    yields by uᵀ (I/V - s)⁻¹ u.
    """
    below = hull.below(up, height)
    forward = np.array([1.0, 0.0, 0.0]) - up[0] * up
    forward /= np.linalg.norm(forward)
    ways = np.array([forward, np.cross(up, forward)])
    first = ways @ below["area_moment"]
    second = ways @ below["area_second"] @ ways.T - np.outer(first, first) / below["area"]
    # A turn about one way lifts what lies along the other one.
    across = np.array([[second[1, 1], -second[0, 1]], [-second[0, 1], second[0, 0]]]) / below["volume"]
    level = ways @ np.append(axis, 0.0)
    level /= np.linalg.norm(level)
    yields = 1.0 / heights.about(level)
    if yields <= 0.0:
        return None
    radii, principal = np.linalg.eigh(across)
    shares = (principal.T @ level) ** 2
    # shares_0/(radii_0 - s) + shares_1/(radii_1 - s) = yields; the lower root rights it about both.
    polynomial = [
        yields,
        1.0 - yields * radii.sum(),
        yields * radii.prod() - shares[0] * radii[1] - shares[1] * radii[0],
    ]
    above = float(np.roots(polynomial).real.min())
    return np.asarray(below["moment"] / below["volume"] + above * up)


class _Curve:
    """Righting arms of a vessel without the load, and how high its marks are over the water."""

    def __init__(self, righting: Righting, marks: Mapping[str, Floats]) -> None:
        self.at, self.marks = righting.at, marks

    def height_of(self, mark: str, there: Heeled) -> float:
        """Of the lowest point of a mark over the water [m]."""
        return _lowest(there.normal, there.height, self.marks[mark])

    def looks(self, rest: float) -> list[Heeled]:
        """From the angle of rest [rad] away from the load, to where it is righted no more."""
        found = [self.at(rest)]
        while found[-1].heel < rest + _FARTHEST:
            try:
                there = self.at(found[-1].heel + _STEP)
            except CannotFloatError:
                break
            if not _is_righted(there):
                return [*found, self.at(self._last_righted(found[-1].heel, there.heel))]
            found.append(there)
        return found

    def _last_righted(self, low: float, high: float) -> float:
        """The angle up to which it is righted, between one at which it is and one at which it is not [rad].

        By halves: where it lies over, the arm jumps, and shortly before that it may rest nowhere.
        """
        while high - low > _ANGLE:
            middle = 0.5 * (low + high)
            low, high = (middle, high) if self._rights_at(middle) else (low, middle)
        return low

    def _rights_at(self, heel: float) -> bool:
        """Whether it is righted at an angle [rad]; not where no attitude is found in which it rests."""
        try:
            return _is_righted(self.at(heel))
        except CannotFloatError:
            return False

    def first(self, what: Callable[[Heeled], float], looks: Sequence[Heeled]) -> float | None:
        """The first angle on the way along some looks where something is not below zero [rad]."""
        if what(looks[0]) >= 0.0:
            return looks[0].heel
        for one, other in itertools.pairwise(looks):
            if what(other) >= 0.0:
                from scipy.optimize import brentq  # takes long to load

                return float(brentq(lambda angle: what(self.at(angle)), one.heel, other.heel, xtol=_ANGLE))
        return None


def _is_righted(there: Heeled) -> bool:
    """Whether arms push a vessel back, and it does not lie over across them."""
    return there.arm >= 0.0 and there.across > 0.0


def _measured(curve: _Curve, name: str, away: float, before: float, after: float) -> Swing:
    """Angles and areas of a curve."""
    looks = curve.looks(after)
    rest, last, released = looks[0], looks[-1], curve.at(before)
    under = {}
    for mark in curve.marks:
        angle = curve.first(lambda there, mark=mark: -curve.height_of(mark, there), looks)  # type: ignore[misc]
        if angle is not None:
            under[mark] = angle
    flooding = min((angle for mark, angle in under.items() if mark != DECK_EDGE), default=None)
    end = last.heel if flooding is None else flooding
    farthest = curve.first(lambda there: there.work - released.work, looks)
    freeboard = None
    if farthest is not None:
        there = curve.at(farthest)
        freeboard = min(curve.height_of(mark, there) for mark in curve.marks)
    steps = math.ceil((after - before) / _STEP)
    drawn = [*(curve.at(before + (after - before) * step / steps) for step in range(steps)), *looks]
    return Swing(
        vessel=name,
        away=away,
        before=before,
        after=after,
        farthest=farthest,
        freeboard=freeboard,
        under=under,
        flooding=flooding,
        has_openings=any(mark != DECK_EDGE for mark in curve.marks),
        vanishing=last.heel if last.heel < after + _FARTHEST else None,
        end=end,
        left=released.work - rest.work,
        taken=curve.at(end).work - rest.work,
        angles=np.array([one.heel for one in drawn]),
        arms=np.array([one.arm for one in drawn]),
    )
