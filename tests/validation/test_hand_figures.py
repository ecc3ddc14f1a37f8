"""Hand figures of lifts at rest: one equalizer, a Goliath crane with three, a floating crane with four.

They are what a lifting engineer writes down beforehand: small angles, ideal sheaves, each hook by itself.
They are reproduced to the digits that they have, or the difference is explained where it stands. Hooks hang
from the world: what a vessel, a girder or a trolley does is not in these lifts.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from gantline.results import series
from gantline.results.rotation import axes, heading
from gantline.scenario import Scenario, load_scenario, parse_scenario
from gantline.scenario.file.variants import with_value
from gantline.statics import Equilibrium, Losses, Statics
from gantline.study import tilting_of
from hand_lifts import FLOATING_HOOKS, GOLIATH_HOOKS, floating_lift, goliath_lift
from hooked_lift import hooked_lift
from mechanics import Floats, G
from reference_lift import SCENARIO

TONNE = 1000.0 * G
#: Bearing levels of the hooks of lift B, ropes just taut and equalised, load level [m].
JUST_TAUT = {"U1": 40.65, "U2": 40.65, "L": 40.74}
#: Bearing levels of the hooks of lift C with which falls are as long as by hand [m].
FLOATING_LEVELS = dict.fromkeys(FLOATING_HOOKS, 53.0)
LOAD = "block"  # as the reference lift calls it


def at_rest(
    text: str | Scenario, time: float | None = 0.0, losses: Losses = "none"
) -> tuple[Statics, Equilibrium]:
    question = Statics(text if isinstance(text, Scenario) else parse_scenario(text))
    return question, question.equilibrium(time, losses=losses)


def hook_loads(rest: Equilibrium, kind: str = "hook_load") -> Floats:
    """Of all hooks, as masses [t]."""
    hooks = [hook.name for hook in rest.recording.rig.hooks]
    return np.array([float(rest.recording.column(kind, hook)[-1]) / TONNE for hook in hooks])


def tensions(rest: Equilibrium) -> dict[str, float]:
    """Of all slings [kN]."""
    return {sling.name: rest.tension(sling.rope) / 1e3 for sling in rest.recording.rig.slings}


def travel(rest: Equilibrium, equalizer: str) -> list[float]:
    """Of its moving sheaves since the start, down positive [m]; positions of their sliders."""
    return [float(rest.recording.column("joint_position", f"{equalizer}.{n}")[-1]) for n in range(1, 6)]


def bottom(rest: Equilibrium, centre: tuple[float, float, float]) -> Floats:
    """Middle of the bottom of a load with this centre of gravity [m]."""
    own = axes(rest.recording.column("body_orientation", "load")[-1])
    at: Floats = rest.recording.column("body_position", "load")[-1] - own @ np.array(centre)
    return at


# Lift A: 300 t under one equalizer.


def test_one_equalizer_tilts_by_its_depth() -> None:
    """Lift A, centre of gravity 100 mm off: 2.29° by hand, 0.1/2.5; crossed slings make 2.47°, 2.31°."""
    by_hand = math.degrees(math.atan2(0.1, 2.5))
    assert by_hand == pytest.approx(2.29, abs=0.005)
    reference = load_scenario(SCENARIO)
    for axis, measured in (("x", 2.47), ("y", 2.31)):
        _, rest = at_rest(with_value(reference, f"load.centre_of_gravity.at.{axis}", "0.1 m"), None)
        tilt = math.degrees(float(rest.recording.column("load_tilt", LOAD)[-1]))
        assert tilt == pytest.approx(measured, abs=0.005)
    # The axis about which crossed slings do nothing has the hand figure, the other 0.2 m of 2.5 m less.
    question, rest = at_rest(reference, None)
    (found,) = tilting_of(question, rest, question.modes())
    assert math.degrees(math.atan2(0.1, found.stiff.height)) == pytest.approx(by_hand, rel=2e-3)
    assert found.soft.rig == pytest.approx(-0.20, abs=0.005)


def test_its_tilting_period() -> None:
    """Lift A: 5.2 s by hand, with the lugs held; 4.0 s and 3.9 s on slings, on which they move (MD4)."""
    question, rest = at_rest(load_scenario(SCENARIO), None)
    modes = question.modes()
    (found,) = tilting_of(question, rest, modes)
    assert found.period_on_lugs == pytest.approx(5.2, abs=0.05)
    turning = [mode.period for mode in modes if mode.motion.startswith(f"{LOAD} turns about (")]
    assert turning == pytest.approx([4.02, 3.87], abs=0.01)


def test_five_slings_straight_to_the_hook() -> None:
    """The same on five slings of 26 m to the hook: about 0.2° by hand, 0.27° since slings stretch; 10.8 s.

    Rigid slings make atan(0.1/28.5) = 0.20°. Those of 200 MN are a spring of k Σ x² besides, k = EA/L, that
    the centre of gravity turns by W (e − h θ).
    """
    depth, mass = 26.0, 300e3
    corners = ((-2.5, 2.5), (2.5, 2.5), (0.0, 0.0), (-2.5, -2.5), (2.5, -2.5))
    lugs = {str(number): (*at, 5.0) for number, at in enumerate(corners, start=1)}
    slings = {f"S{lug}": ("hook", lug, math.hypot(*at[:2], depth)) for lug, at in lugs.items()}
    text = hooked_lift(
        {"hook": (0.0, 0.0, 36.5)}, lugs, slings,
        mass=mass, centre=(0.1, 0.0, 2.5), box=(10.0, 10.0, 5.0), position=(0.0, 0.0, 5.6),
    )  # fmt: skip
    question, rest = at_rest(text)
    tilt = math.degrees(float(rest.recording.column("load_tilt", "load")[-1]))
    rigid = math.atan2(0.1, depth + 2.5)
    assert math.degrees(rigid) == pytest.approx(0.2, abs=0.005)
    spring = 200e6 / depth * sum(x**2 for x, _ in corners)
    stretched = mass * G * (0.1 - 2.5 * rigid) / spring
    # Its slings are not plumb, and share by their lengths too.
    assert tilt == pytest.approx(math.degrees(rigid + stretched), rel=0.03)
    assert tilt == pytest.approx(0.273, abs=1e-3)
    (found,) = tilting_of(question, rest, question.modes())
    assert found.loose is None
    inertia = mass / 12 * (10.0**2 + 5.0**2)
    pendulum = 2 * math.pi * math.sqrt((inertia + mass * 28.5**2) / (mass * G * 28.5))
    assert pendulum == pytest.approx(10.8, abs=0.05)
    assert found.period == pytest.approx(pendulum, rel=0.01)


MIRRORED = {"S2": "L4", "S4": "L5", "S5": "L2"}


def mirrored() -> Scenario:
    """The reference lift with slings 1, 2 to the lugs at one end and 4, 5 to those at the other."""
    text = load_scenario(SCENARIO).text
    for sling, lug in MIRRORED.items():
        old = f"  {sling}: {{from: e1.{sling[1]}, to: {LOAD}.L{sling[1]},"
        assert old in text
        text = text.replace(old, old.replace(f".L{sling[1]},", f".{lug},"))
    return parse_scenario(text)


def frame_to_load(rest: Equilibrium) -> float:
    """Heading of the frame from that of the load [deg]."""
    both = [float(heading(rest.recording.column("body_orientation", body)[-1])) for body in ("e1", LOAD)]
    return math.degrees(both[0] - both[1])


def test_which_sling_goes_to_which_lug() -> None:
    """Yaw of the frame: −72° by hand for equal lengths, −68.98° in the lift; none in the mirrored order.

    The hand check gives the mirrored order three times the yaw stiffness, 24 over 8. That is so at no yaw;
    about where each comes to rest it is 24 over √(24² + 8²) = 25.3, so the frame turns to and fro in 2.76 s
    and 2.68 s.
    """
    along = np.array([-3.2, -1.6, 0.0, 1.6, 3.2])
    lugs = np.array([(-2.5, 2.5), (2.5, 2.5), (0, 0), (-2.5, -2.5), (2.5, -2.5)])
    arms = along @ lugs
    assert math.degrees(math.atan2(arms[1], arms[0])) == pytest.approx(-72, abs=0.5)
    question, rest = at_rest(load_scenario(SCENARIO), None)
    assert frame_to_load(rest) == pytest.approx(-68.983, abs=1e-3)
    periods = [frame_period(question)]
    question, rest = at_rest(mirrored(), None)
    assert frame_to_load(rest) == pytest.approx(0.0, abs=1e-6)
    periods.append(frame_period(question))
    assert periods == pytest.approx([2.68, 2.76], abs=0.01)
    assert (periods[0] / periods[1]) ** 2 == pytest.approx(24.0 / math.hypot(24.0, 8.0), rel=0.015)


def frame_period(question: Statics) -> float:
    (found,) = [mode.period for mode in question.modes() if mode.motion == "e1 turns about z"]
    assert found is not None
    return found


# Lift B: 350 t under three equalizers of a Goliath crane.


def test_forces_of_the_goliath_lift() -> None:
    """Lift B without rigging weight: 228.9 kN a lug, slings 228.9, 230.6, 231.3 kN, equalizing rope 115.9 kN.

    All to 0.15 %. The slings of 23 m lean less than those of 20 m beside them, so they pull L aside: the load
    moves 14 mm and U carry 0.1 % more than L.
    """
    _, rest = at_rest(goliath_lift(JUST_TAUT, weighs=False, stretches=False))
    assert pytest.approx(228.9, abs=0.05) == 350 / 15 * G
    for name, tension in tensions(rest).items():
        sling = next(one for one in rest.recording.rig.slings if one.name == name)
        angle = float(series.sling_angle(rest.recording, sling)[-1])
        assert tension * math.cos(angle) == pytest.approx(228.9, rel=1.5e-3), name
    by_hand = {0.0: 228.9, 6.9: 230.6, 8.3: 231.3}
    angles = {"1": 6.9, "2": 8.3, "3": 0.0, "4": 8.3, "5": 6.9}
    for number, angle in angles.items():
        assert tensions(rest)[f"U1.{number}"] == pytest.approx(by_hand[angle], rel=1.5e-3)
    for hook in GOLIATH_HOOKS:
        assert rest.tension(f"E{hook}.equalizing") / 1e3 == pytest.approx(115.9, rel=1.5e-3)
    assert math.hypot(*(bottom(rest, (-2.0, 0.0, 4.8))[:2])) == pytest.approx(0.0147, abs=5e-4)


TRAVEL = {
    "U1": (6.9, 8.3, 0.0, 8.3, 6.9, 0.24, 0.01, -0.50, 0.01, 0.24),
    "U2": (6.9, 8.3, 0.0, 8.3, 6.9, -0.06, 0.31, -0.50, 0.31, -0.06),
    "L": (6.0, 7.2, 0.0, 8.3, 6.9, -0.19, -0.13, -0.41, 0.40, 0.33),
}


def test_angles_and_travel_of_the_goliath_lift() -> None:
    """Lift B, rigid ropes: angles to 0.2° and travel of all fifteen sheaves to 1 cm of the table by hand."""
    _, rest = at_rest(goliath_lift(JUST_TAUT, weighs=False, stretches=False))
    for hook, figures in TRAVEL.items():
        slings = [one for one in rest.recording.rig.slings if one.name.startswith(f"{hook}.")]
        angles = [math.degrees(float(series.sling_angle(rest.recording, one)[-1])) for one in slings]
        assert angles == pytest.approx(figures[:5], abs=0.2)
        assert travel(rest, f"E{hook}") == pytest.approx(figures[5:], abs=0.011)


def test_hook_levels_of_the_goliath_lift() -> None:
    """Lift B, rigid ropes, bearings at 40.65 and 40.74 m: level, and on its keel blocks, 1.5 m, to 2 mm."""
    _, rest = at_rest(goliath_lift(JUST_TAUT, weighs=False, stretches=False))
    assert bottom(rest, (-2.0, 0.0, 4.8))[2] == pytest.approx(1.5, abs=3e-3)
    assert math.degrees(float(rest.recording.column("load_tilt", "load")[-1])) < 0.01


def test_hook_loads_of_the_goliath_lift() -> None:
    """Lift B: 139.2 t on each hook, 145.0 t with contingency, 417.6 t in all; falls 156, 166, 478 t.

    By hand the rigging is 22.5 t a hook. Equalizing ropes, 31 m of 8.65 kg/m, are 0.27 t of it more here.
    """
    _, rest = at_rest(goliath_lift(JUST_TAUT, falls=True))
    ropes = 0.27
    assert hook_loads(rest) == pytest.approx([139.2 + ropes] * 3, rel=1.5e-3)
    assert hook_loads(rest).sum() == pytest.approx(417.6 + 3 * ropes, abs=0.2)
    assert hook_loads(rest, "hoist_load") == pytest.approx([156, 156, 166], abs=1.0)
    assert hook_loads(rest, "hoist_load").sum() == pytest.approx(478, abs=2.0)
    _, heavy = at_rest(goliath_lift(JUST_TAUT, contingency=1.05))
    assert hook_loads(heavy) == pytest.approx([145.0 + ropes] * 3, rel=1.5e-3)


def frequency(question: Statics) -> float:
    """Of the load's bounce [Hz]."""
    (period,) = [mode.period for mode in question.modes() if mode.motion == "load moves along z"]
    assert period is not None
    return 1 / period


def test_further_hoist_and_bounce_of_the_goliath_lift() -> None:
    """Lift B: 0.15 m from just taut to lift-off, and 1.3 Hz, where falls and girder give way too.

    The girder, 60 MN/m, is not in the lift: 350 t bend it by 57 mm, and 1/ω² grows by m/60 MN/m (Dunkerley),
    exactly so if all bounces as one. With the load alone on it that makes 1.30 Hz as by hand, with frames,
    hook blocks and falls, 462 t in all, 1.23 Hz.
    """
    girder, centre = 60e6, (-2.0, 0.0, 4.8)
    heights = {}
    for kind, stretches in {"rigid": False, "slings": True}.items():
        _, rest = at_rest(goliath_lift(JUST_TAUT, weighs=False, stretches=stretches))
        heights[kind] = float(bottom(rest, centre)[2])
    slings = heights["rigid"] - heights["slings"]
    assert slings == pytest.approx(0.057, abs=1e-3)
    falls = [350 / 3 * TONNE / stiffness for stiffness in (29.5e6, 63e6)]
    bent = 350 * TONNE / girder
    further = [slings + one + bent for one in falls]
    assert further == pytest.approx([0.15, 0.13], abs=5e-3)
    # That falls give way by that much the lift says too, at the load's middle; lead lines and rope on the
    # sheaves, 5 % of a rope, stretch as well.
    question, rest = at_rest(goliath_lift(JUST_TAUT, weighs=False, falls=True))
    sunk = heights["slings"] - float(bottom(rest, centre)[2])
    assert sunk == pytest.approx(float(np.average([falls[0], falls[1]], weights=[14, 10])), rel=0.07)
    on_falls = frequency(question)
    assert on_falls == pytest.approx(1.67, abs=0.01)

    def with_girder(mass: float) -> float:
        return 1 / math.sqrt(1 / on_falls**2 + (2 * math.pi) ** 2 * mass / girder)

    assert with_girder(350e3) == pytest.approx(1.3, abs=0.01)
    assert with_girder(462e3) == pytest.approx(1.23, abs=0.01)


@pytest.mark.parametrize("losses", ["forward", "backward"])
def test_losses_in_the_goliath_lift(losses: Losses) -> None:
    """2 % per crossing, all slipping one way: 1.082, 1.040, 0.998, 0.959, 0.921 of the mean, to 1.5e-3.

    The mean of the five; by hand sheaves weigh nothing, here 300 kg of 23.3 t.
    """
    _, rest = at_rest(goliath_lift(JUST_TAUT, weighs=False, efficiency=0.98), losses=losses)
    for hook in GOLIATH_HOOKS:
        slings = [one for one in rest.recording.rig.slings if one.name.startswith(f"{hook}.")]
        upright = np.array(
            [
                rest.tension(one.rope) * math.cos(float(series.sling_angle(rest.recording, one)[-1]))
                for one in slings
            ]
        )
        ordered = sorted(upright / upright.mean(), reverse=True)
        assert ordered == pytest.approx([1.082, 1.040, 0.998, 0.959, 0.921], abs=1.6e-3)


def test_three_equalizers_not_in_line_hold_the_tilt() -> None:
    """Lift B: the hooks fix the tilt; the rig gives hundreds of metres beside 5.4 m of the load's weight."""
    question, rest = at_rest(goliath_lift(JUST_TAUT))
    (found,) = tilting_of(question, rest, question.modes())
    assert found.loose is None
    assert found.soft.rig > 50 * found.depth


# Lift C: 1000 t under four equalizers in a row of a floating crane, hooks held in the world.


def test_forces_of_the_floating_lift() -> None:
    """Lift C: slings 490.5 kN upright, equalizing rope 247 kN, hooks 274 t; falls 354 t by hand, 343 t here.

    By hand falls weigh 30 t a hook. 32 parts of 47 m of 11.9 kg/m weigh 18 t, which is what hangs there: 30 t
    are falls of 79 m, with the hook at the water.
    """
    _, rest = at_rest(floating_lift(FLOATING_LEVELS, weighs=False, stretches=False))
    for sling in rest.recording.rig.slings:
        angle = float(series.sling_angle(rest.recording, sling)[-1])
        assert rest.tension(sling.rope) / 1e3 * math.cos(angle) == pytest.approx(490.5, abs=0.05)
        assert angle < math.radians(7.65)
    for hook in FLOATING_HOOKS:
        assert rest.tension(f"E{hook}.equalizing") / 1e3 == pytest.approx(247, abs=0.5)
        # Travel by hand with rigid ropes: +0.07, +0.11, −0.35, +0.11, +0.07 m.
        assert travel(rest, f"E{hook}") == pytest.approx([0.07, 0.11, -0.35, 0.11, 0.07], abs=6e-3)
    _, rest = at_rest(floating_lift(FLOATING_LEVELS, falls=True))
    assert hook_loads(rest) == pytest.approx([274] * 4, abs=0.5)
    assert hook_loads(rest, "hoist_load") == pytest.approx([274 + 50 + 18.5] * 4, abs=1.0)


@pytest.mark.parametrize(("hook", "more"), [("P1", 18.0), ("P2", 8.0)])
def test_hook_levels_rule_the_floating_lift(hook: str, more: float) -> None:
    """Lift C: 10 mm too high, +18 t on an inner hook, +8 t on an outer: k δ (3/4 − y²/Σ y²), k = 25 MN/m."""
    y = [place[1] for place in FLOATING_HOOKS.values()]
    share = 0.75 - FLOATING_HOOKS[hook][1] ** 2 / float(np.sum(np.square(y)))
    assert 25e6 * 0.010 * share / TONNE == pytest.approx(more, abs=0.5)
    levels = FLOATING_LEVELS | {hook: FLOATING_LEVELS[hook] + 0.010}
    before, after = (
        hook_loads(at_rest(floating_lift(one, falls=True, weighs=False))[1])
        for one in (FLOATING_LEVELS, levels)
    )
    change = after - before
    at = list(FLOATING_HOOKS).index(hook)
    assert change[at] == pytest.approx(more, abs=0.5)
    # Falls 91, slings 39, equalizer 320 MN/m in series are 25.2 MN/m; measured 24.7, lead lines are rope too.
    assert change[at] * TONNE / (0.010 * share) == pytest.approx(25e6, rel=0.02)
    assert change.sum() == pytest.approx(0.0, abs=1e-3)


def test_the_row_of_hooks_leaves_the_tilt_free() -> None:
    """Lift C: 100 mm across the row of hooks, 0.95° by hand at h = 6.0 m; 1.02°, end slings fan out."""
    question, rest = at_rest(floating_lift(FLOATING_LEVELS, weighs=False))
    (found,) = tilting_of(question, rest, question.modes())
    assert found.loose is not None and found.loose.line is not None
    assert found.loose.line == pytest.approx((0.0, 1.0), abs=1e-9)
    assert math.degrees(math.atan2(0.1, found.loose.depth)) == pytest.approx(0.95, abs=0.006)
    assert math.degrees(math.atan2(0.1, found.soft.height)) == pytest.approx(1.02, abs=0.01)
    _, moved = at_rest(floating_lift(FLOATING_LEVELS, weighs=False, centre=(0.1, 0.0, 5.0)))
    tilt = math.degrees(float(moved.recording.column("load_tilt", "load")[-1]))
    assert tilt == pytest.approx(1.02, abs=0.01)
