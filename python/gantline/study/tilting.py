"""What keeps a hanging load upright: its own weight, its rig, and how far both are from letting it go."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np
import numpy.typing as npt

from gantline.arguments import listed, needed, number
from gantline.assembly.afloat.water import frozen
from gantline.assembly.spatial import inertia_matrix
from gantline.cad.mass_properties import point_inertia
from gantline.checks import Check, Verdict, check_recording, governing, past_limits
from gantline.hydro.tank import liquid_in_box
from gantline.results import series
from gantline.results.alike import first_peak
from gantline.results.loads.tilting import LooseTilt, loose_tilt
from gantline.results.rig import Load
from gantline.results.rotation import axes
from gantline.scenario import Scenario, ScenarioError
from gantline.scenario.afloat.tanks import load_tanks
from gantline.scenario.file.variants import with_values
from gantline.statics import Equilibrium, Mode, NoEquilibriumError, Sensitivity, Statics
from gantline.study.hanging import Hanging
from gantline.units import format_quantity, si_text

__all__ = ["Margin", "TiltAxis", "Tilting", "margins_of", "tilting_of", "untold"]

Floats = npt.NDArray[np.float64]

#: Tilt per metre of centre of gravity that is rounding [rad/m].
_RIGID = 1e-12
#: Part of a level shift along an axis of the load that is rounding, of one that stands plumb [1].
_LEVEL = 1e-9
#: Where lift files state the centre of gravity, which has to be within the load.
_CENTRE = "load.centre_of_gravity.at"
#: Length to which a margin is known [m].
_TO = 1e-3
#: Margins beyond this are not looked for [m].
_FARTHEST = 10.0
#: First shift that is tried [m].
_FIRST = 0.1
#: What such a shift turns by more about plumb is not held there [rad].
_FAR_ROUND = math.radians(30.0)
#: What fails as planned counts where this much more of its limit is used [1]: less is rounding.
_MORE_USED = 1.001
#: Of natural motions, as many times those known are asked for where they do not tell how a load tilts.
_MORE = 4


@dataclass(frozen=True)
class TiltAxis:
    """Tilting about one of the two level axes in which it does not bring the other with it.

    Attributes:
        direction: Of the axis, world x and y.
        stiffness: Moment over tilt [N m/rad]; negative where it leads away, infinite where nothing gives.
        height: The same over the weight, with what is in the load's tanks [m]: tan(tilt) is what their common
            centre of gravity is off over this.
        rig: What of the height the rig gives, less what free surfaces in tanks take [m]; the rest is
            `Tilting.depth`, the weight.
    """

    direction: tuple[float, float]
    stiffness: float
    height: float
    rig: float


@dataclass(frozen=True)
class Tilting:
    """What keeps a load upright.

    Attributes:
        load: Its name.
        depth: Of its centre of gravity, with what is in its tanks, below the point in which its slings pull,
            the middle of their lower ends weighted by their vertical forces [m].
        soft: The axis about which it tilts most easily.
        stiff: The axis across.
        tilt_per_metre: By how much it tilts per metre of its own centre of gravity, without tanks, along its
            own x and y [rad/m].
        period: Of the natural motion that has most part in tilting about the soft axis [s]; None where it
            does not swing so.
        period_on_lugs: The same by hand, as if the point in which its slings pull were held [s]; None where
            it would not swing.
        loose: Whether equalizers leave it free to tilt; None if they do not.
    """

    load: str
    depth: float
    soft: TiltAxis
    stiff: TiltAxis
    tilt_per_metre: tuple[float, float]
    period: float | None
    period_on_lugs: float | None
    loose: LooseTilt | None


@dataclass(frozen=True)
class Margin:
    """How far a centre of gravity may be elsewhere before a lift no longer hangs as it should.

    Attributes:
        direction: `up`, or along one of the load's own axes, such as `+x`; not of the one nearest to plumb.
        distance: How far [m], to a millimetre; none where what a check fails as planned grows that way.
        cause: What happens then, in words; empty where nothing does within 10 m.
    """

    direction: str
    distance: float
    cause: str


@dataclass(frozen=True)
class _Trouble:
    """What is wrong with a lift whose centre of gravity is elsewhere.

    Attributes:
        cause: In words; empty if nothing.
        is_planned: Whether it is wrong as planned too, and less.
    """

    cause: str = ""
    is_planned: bool = False


def tilting_of(question: Statics, rest: Equilibrium, modes: Sequence[Mode]) -> list[Tilting]:
    """What keeps each load upright that hangs clear.

    Nothing is known of one whose centre of gravity, were it aside, would set it turning about plumb, which
    nothing holds: `untold` names it.

    Args:
        question: The lift.
        rest: Its equilibrium found last.
        modes: Its slowest natural motions; where these do not tell how a load tilts, more are found.

    Raises:
        TypeError: If it is asked of a lift file, of which `Statics` is made, or of no equilibrium or modes.
    """
    needed(question, Statics, "a lift to ask for equilibria", "gantline.Statics(lift) is one")
    needed(rest, Equilibrium, "an equilibrium", "`equilibrium` of a Statics gives one")
    for mode in listed(modes, "a list of modes", "`modes` of a Statics gives one"):
        needed(mode, Mode, "a mode", "`modes` of a Statics gives a list of them")
    found = (_tilting(question, rest, modes, load) for load in _hanging_clear(rest))
    return [one for one in found if one is not None]


def untold(rest: Equilibrium, found: Sequence[Tilting]) -> list[str]:
    """Names of loads that hang clear and of which it is not known what keeps them upright.

    Below one hook any wind turns a load whose centre of gravity is aside about plumb, and without end.

    Args:
        rest: The equilibrium.
        found: What is known of the others, by `tilting_of`.
    """
    known = {one.load for one in found}
    return [load.name for load in _hanging_clear(rest) if load.name not in known]


def _hanging_clear(rest: Equilibrium) -> list[Load]:
    """Loads that hang in slings, clear of what they stood on."""
    on = {sling.to_load for sling in series.slings_on(rest.recording)}
    loads = rest.recording.rig.loads
    return [load for load in loads if load.name in on and series.load_is_clear(rest.recording, load)[-1]]


def _tilting(question: Statics, rest: Equilibrium, modes: Sequence[Mode], load: Load) -> Tilting | None:
    own = axes(rest.recording.column("body_orientation", load.body)[-1])
    answers = question.sensitivities([(f"centre_{axis}", load.body) for axis in "xyz"])
    if any(_turns_about_plumb(one, load, own[:2, place]) for place, one in enumerate(answers)):
        return None
    turned = np.array([one.of_body(load.body)[3:5] for one in answers]).T
    # A level shift d of the centre of gravity brings the moment d × m g, of one along x about y, along y
    # about −x.
    by_x, by_y = turned @ own[0], turned @ own[1]
    compliance = np.column_stack([-by_y, by_x]) / load.weight
    values, directions = np.linalg.eigh(0.5 * (compliance + compliance.T))
    liquids = _liquids(question, rest, load)
    mass = load.weight / question.rig.gravity + math.fsum(one.mass for one in liquids)
    weight = mass * question.rig.gravity
    heights = [1.0 / (one * weight) if abs(one) * weight > _RIGID else math.inf for one in values]
    order = np.argsort(heights)
    middle = np.sum([one.mass / mass * one.at for one in liquids], axis=0) if liquids else np.zeros(3)
    depth = _depth(rest, load) - float(middle[2])
    found = [
        TiltAxis(
            direction=_named(directions[:, index]),
            stiffness=heights[index] * weight,
            height=heights[index],
            rig=heights[index] - depth,
        )
        for index in order
    ]
    inertia = own @ _inertia(question, load) @ own.T
    inertia = inertia + point_inertia(load.weight / question.rig.gravity, middle)
    for one in liquids:
        inertia = inertia + one.inertia + point_inertia(one.mass, one.at - middle)
    soft = directions[:, order[0]]
    about = float(soft @ inertia[:2, :2] @ soft)
    across = np.array([-soft[1], soft[0]])
    lost = question.rig.gravity * sum(float(across @ one.spread[:2, :2] @ across) for one in liquids)
    return Tilting(
        load=load.name,
        depth=depth,
        soft=found[0],
        stiff=found[1],
        tilt_per_metre=(float(np.linalg.norm(turned[:, 0])), float(np.linalg.norm(turned[:, 1]))),
        period=_period(question, rest, modes, load, soft, float(values[order[0]])),
        period_on_lugs=(
            2 * math.pi * math.sqrt((about + mass * depth**2) / (weight * depth - lost))
            if weight * depth > lost
            else None
        ),
        loose=loose_tilt(rest.recording, load),
    )


def _turns_about_plumb(answer: Sensitivity, load: Load, level: Floats) -> bool:
    """Whether a shift along an axis of a load, with so much of it level, sets it turning about plumb.

    Nothing holds that, and the answer has but the direction in which it goes; or next to nothing, so that it
    is far round before it has an end, tilts along other axes there, and what is told for small shifts is none
    of it. A load on its tip tilts.
    """
    turn = answer.of_body(load.body)[3:]
    is_held = answer.is_held and abs(turn[2]) * _FIRST < _FAR_ROUND
    return not is_held and _is_about_plumb(turn) and float(np.abs(level).max()) > _LEVEL


def _is_about_plumb(turn: Floats) -> bool:
    """Whether a turn, world axes (3,), is one about plumb rather than a tilt."""
    return bool(abs(turn[2]) > np.linalg.norm(turn[:2]))


@dataclass(frozen=True)
class _Liquid:
    """What is in a tank of a load, world axes.

    Attributes:
        mass: Of the liquid [kg].
        at: Its centre, from the load's centre of gravity (3,) [m].
        inertia: About that, frozen upright in the load (3, 3) [kg m^2].
        spread: Density times the second moments of its surface (3, 3) [kg m].
    """

    mass: float
    at: Floats
    inertia: Floats
    spread: Floats


def _liquids(question: Statics, rest: Equilibrium, load: Load) -> list[_Liquid]:
    """Liquids in tanks of a load at rest."""
    own = axes(rest.recording.column("body_orientation", load.body)[-1])
    (centre,) = [
        np.array(one["centre_of_gravity_from_datum"])
        for one in question.assembly.rig["loads"]
        if one["name"] == load.name
    ]
    found = []
    for name, tank in load_tanks(question.scenario).items():
        mass = float(rest.recording.column("tank_content", name)[-1])
        if mass <= 0.0:
            continue
        filled = tank.model_copy(update={"content": mass})
        if filled.is_slack:
            liquid = liquid_in_box(tank.box, own[2], mass / tank.density)
            inside, spread = liquid.centre, tank.density * own @ liquid.spread @ own.T
        else:
            inside, spread = np.array([0.0, 0.0, tank.box[2] / 2.0]), np.zeros((3, 3))
        at = own @ (np.array(tank.bottom) + inside - centre)
        found.append(_Liquid(mass, at, own @ frozen(filled)[1] @ own.T, spread))
    return found


def margins_of(scenario: Scenario, rest: Equilibrium, *, farthest: float = _FARTHEST) -> list[Margin]:
    """How far the centre of gravity of a lift's load may be elsewhere.

    The lift is solved anew with it moved, each way until something happens: no equilibrium, one that is not
    stable, a sling goes slack, a sheave is beyond its travel, the load tilts by more than its limit, or than
    checks warn of where it has none and does not do so as planned, or a check of the equilibrium fails, such
    as that of the hook which then bears more. There is no margin to where a check gets worse that fails as
    planned.

    Args:
        scenario: The lift, without cases.
        rest: Its equilibrium.
        farthest: Where the search ends [m].

    Raises:
        TypeError: If it is no scenario, such as a `Statics`, whose `scenario` is one, or no equilibrium.
        ValueError: If the lift has no load, or one whose centre of gravity is that of its CAD file, or the
            search has no way to go.
    """
    load = needed(scenario, Scenario, "a scenario", "'scenario' of a Statics is one").load
    if not number(farthest, "farthest", "metres") > 0.0:
        raise ValueError(f"farthest: {farthest:g} m is no way to look along; one above zero is needed")
    if load is None:
        raise ValueError("the lift has no load")
    needed(rest, Equilibrium, "an equilibrium", "`equilibrium` of a Statics gives one")
    at = load.centre_of_gravity.at
    if at == "from_cad":
        sentence = "the centre of gravity is that of the CAD file"
        raise ValueError(f"{sentence}; state it in 'load.centre_of_gravity.at' to see how far it may move")
    (name,) = [one.body for one in rest.recording.rig.loads if one.name == load.name]
    plumb = axes(rest.recording.column("body_orientation", name)[-1])[2]
    failed = {name: _used(one) for name, one in _failed(rest).items()}
    leans = bool(_leans(rest))
    slack = {sling.name for sling in rest.recording.rig.slings if rest.tension(sling.rope) <= 0.0}

    def trouble(way: Floats, shift: float) -> _Trouble:
        moved = [value + shift * float(part) for value, part in zip(at, way, strict=True)]
        texts = {f"load.centre_of_gravity.at.{name}": si_text(value, "length")
                 for name, value in zip("xyz", moved, strict=True)}  # fmt: skip
        try:
            question = Statics(with_values(scenario, texts))
            found = question.equilibrium(rest.time)
        except ScenarioError as problem:
            if problem.problems[0].path == _CENTRE:
                return _Trouble("nothing; further on it is outside the load")
            return _Trouble(problem.problems[0].sentence.partition(";")[0])
        except NoEquilibriumError as problem:
            return _Trouble(f"no equilibrium: {problem.cause} ({problem.element})")
        there = _trouble(question, Hanging(question, found), slack, failed)
        return there if there.cause or leans else _Trouble(_leans(found))

    return [_margin(name, partial(trouble, way), farthest) for name, way in _ways(plumb)]


def _ways(plumb: Floats) -> Iterator[tuple[str, Floats]]:
    """Where a centre of gravity is moved, in the load's own axes: up, and to all sides."""
    yield "up", plumb
    upright = first_peak(np.abs(plumb))
    for place, axis in enumerate("xyz"):
        if place != upright:
            yield f"+{axis}", np.eye(3)[place]
            yield f"−{axis}", -np.eye(3)[place]


def _margin(direction: str, trouble: Callable[[float], _Trouble], farthest: float) -> Margin:
    """The least shift with trouble, by doubling and halving."""
    least = trouble(0.0)
    if least.cause:
        return Margin(direction, 0.0, least.cause)
    good, bad = 0.0, _FIRST
    while not (least := trouble(min(bad, farthest))).cause:
        good = min(bad, farthest)
        if good == farthest:
            return Margin(direction, farthest, "")
        bad *= 2.0
    bad = min(bad, farthest)
    while bad - good > _TO:
        middle = 0.5 * (good + bad)
        found = trouble(middle)
        if found.cause:
            bad, least = middle, found
        else:
            good = middle
    return Margin(direction, 0.0 if least.is_planned else good, least.cause)


def _trouble(question: Statics, hanging: Hanging, slack: set[str], failed: Mapping[str, float]) -> _Trouble:
    """What is wrong with how a lift hangs that was found last.

    Args:
        question: The lift, of which that is the equilibrium found last.
        hanging: How it hangs.
        slack: Slings that are slack as planned.
        failed: How much of their limits checks use that fail as planned [1], by their names.
    """
    rest = hanging.rest
    if not rest.is_stable:
        turns = [one.of_body(hanging.load.body)[3:] for one in question.modes(rest.unstable)]
        # Nothing holds the heading below one hook: wind that turns it takes nothing from how it tilts.
        turns_alone = not rest.swinging and all(_is_about_plumb(turn) for turn in turns)
        if not turns_alone or len(hanging.hooks()) > 1:
            return _Trouble("unstable")
    newly = [name for name in hanging.slack() if name not in slack]
    if newly:
        return _Trouble(f"{', '.join(newly)} slack")
    beyond = hanging.beyond_travel()
    if beyond is not None:
        return _Trouble(beyond)
    limit = rest.recording.rig.limits.get("load_tilt")
    tilt = float(rest.recording.column("load_tilt", hanging.load.name)[-1])
    if limit is not None and tilt > float(limit):
        return _Trouble(f"tilt beyond its limit of {format_quantity(float(limit), 'deg', 2)}")
    # Of several hooks one bears more as the centre of gravity comes nearer, long before a sling goes slack.
    worst = governing(
        [one for one in _failed(rest).values() if _used(one) > _MORE_USED * failed.get(one.name, 0.0)]
    )
    if worst is None or worst.limit is None:
        return _Trouble()
    limit = format_quantity(worst.limit, worst.unit, worst.digits)
    is_planned = worst.name in failed
    planned = " as planned, and by more" if is_planned else ""
    return _Trouble(f"{worst.name} of {worst.element} fails its limit of {limit}{planned}", is_planned)


def _leans(rest: Equilibrium) -> str:
    """That a load without a limit tilts past the bound of checks, in words; empty where it does not."""
    checks = check_recording(rest.recording)
    past = next((one for one in past_limits(checks) if one.name == "load_tilt"), None)
    if past is None or past.limit is None:
        return ""
    return f"tilt beyond {format_quantity(past.limit, past.unit, past.digits)}, of which checks warn"


def _failed(rest: Equilibrium) -> dict[str, Check]:
    """Checks of the whole lift that an equilibrium fails by a value, by their names."""
    checks = [one for one in check_recording(rest.recording) if one.verdict is Verdict.FAILED]
    return {one.name: one for one in checks if one.value is not None}


def _used(check: Check) -> float:
    """How much of its limit is used [1]; infinite where no share says so."""
    return math.inf if check.utilisation is None else check.utilisation


def _depth(rest: Equilibrium, load: Load) -> float:
    """Of the centre of gravity below the lower ends of the slings, by their vertical forces [m]."""
    centre = float(rest.recording.column("body_position", load.body)[-1, 2])
    total, moment = 0.0, 0.0
    for sling in rest.recording.rig.slings:
        for end, of, _ in sling.at_lugs():
            if of != load.name:
                continue  # what hangs there bears the load by slings of its own
            along = series.sling_direction(rest.recording, sling, end)[-1]
            upright = rest.tension(sling.rope) * float(along[2])
            first, last = (one[-1] for one in series.rope_ends(rest.recording, sling.rope))
            lower = last if sling.over is None else (first, last)[end]
            total += upright
            moment += upright * (float(lower[2]) - centre)
    return moment / total if total > 0.0 else 0.0


def _inertia(question: Statics, load: Load) -> Floats:
    """About the centre of gravity, axes of the load [kg m²]."""
    bodies = question.assembly.document["bodies"]
    return inertia_matrix(next(body["inertia"] for body in bodies if body["name"] == load.body))


def _period(
    question: Statics, rest: Equilibrium, modes: Sequence[Mode], load: Load, axis: Floats, compliance: float
) -> float | None:
    """Of the motion with the largest part in the tilt that a moment makes, Σ θ²/ω² with xᵀ M x = 1.

    All parts together are the compliance, so it is known when no motion can have a larger one that is not
    among `modes`; until then more are asked for. Slow ones may all be motions in which the load hardly tilts.
    """
    place = list(rest.recording.coordinates["body"]).index(load.body)
    while True:
        tilting = [one for one in modes if one.period is not None or one.growth_time is not None]
        parts = [float(one.body_motion[place][3:5] @ axis) ** 2 / one.square for one in tilting]
        largest = max(range(len(parts)), key=lambda index: abs(parts[index]), default=None)
        unseen = compliance - sum(parts)
        if largest is not None and abs(parts[largest]) >= unseen:
            return tilting[largest].period
        more = question.modes(_MORE * max(len(modes), 1))
        if len(more) <= len(modes):
            return None if largest is None else tilting[largest].period
        modes = more


def _named(direction: Floats) -> tuple[float, float]:
    """A direction with its larger part positive, of parts alike the first."""
    way = direction if direction[first_peak(np.abs(direction))] > 0.0 else -direction
    return float(way[0]), float(way[1])
