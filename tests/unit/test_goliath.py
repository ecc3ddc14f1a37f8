"""Goliath cranes and their plans in lift files: what is refused, names, corner loads, events, checks."""

from __future__ import annotations

import math

import numpy as np
import pytest

from gantline.assembly import assemble
from gantline.checks import check_recording, values_of
from gantline.results.cranes.crane import Crane, CraneHook, corner_loads, crane_events, hook_state
from gantline.results.strength import Rating
from gantline.scenario import ScenarioError, parse_scenario
from gantline.simulation import Simulation
from goliath_lift import goliath_lift
from lift_text import spoiled

OVER = "{step: over, traverse: one, speed: 30 m/min, by: 10 m}"


def refused(text: str) -> list[str]:
    with pytest.raises(ScenarioError) as caught:
        parse_scenario(text)
    return [f"{problem.path}: {problem.sentence}" for problem in caught.value.problems]


@pytest.mark.parametrize(
    ("plan", "says"),
    [
        (
            OVER.replace("10 m", "81 m"),
            "plan[1].by: 'gol.one' would come to 61 m; its range is -60 m to 60 m",
        ),
        (
            OVER.replace("by: 10 m", "to: -61 m"),
            "plan[1].to: 'gol.one' would come to -61 m; its range is -60 m to 60 m",
        ),
        (
            "{step: up, hoist: A, speed: 10 m/min, by: 38 m}",
            "plan[1].by: 'gol.A' would come to 73 m; its highest position is 72 m",
        ),
        (
            "{step: up, hoist: A, speed: 10 m/min, to: 30 m}",
            "plan[1].to: the hook is at 35 m or higher, and hoisting does not bring it down to 30 m; "
            "a 'lower' step is right here",
        ),
        (
            f"{OVER}\n{OVER.replace('step: over', 'step: again, starts: with_previous')}",
            "plan[2].traverse: 'gol.one' is moved by two steps at once; leave 'starts: with_previous' out, "
            "or move it in one of them",
        ),
        (
            OVER.replace("step: over", "step: over, starts: with_previous"),
            "plan[1].starts: there is no step before the first; leave 'starts' out",
        ),
        (
            OVER.replace("30 m/min", "40 m/min"),
            "plan[1].speed: 40 m/min is faster than 'gol.one' can traverse; its highest speed is 30 m/min",
        ),
        (
            OVER.replace("traverse: one", "traverse: two"),
            "plan[1].traverse: 'two' is not a trolley; known here: 'gol.one'",
        ),
        (
            OVER.replace("10 m}", "0 m}"),
            "plan[1].by: '0' goes nowhere; a way like '75 m' or '-75 m' is needed",
        ),
        (
            OVER.replace("10 m}", "10 m, towards: minus}"),
            "plan[1].towards: 'by' and 'to' say where it goes; leave 'towards' out",
        ),
        (
            "{step: wait, hold: until_met}",
            "plan[1]: 'hold: until_met' and 'until' stand together, or none of them does",
        ),
        (
            "{step: up, hoist: A, speed: 10 m/min, until: {tension_spread: 5 %}}",
            "plan[1].until: this waits for the "
            "slings of an equalizer; there are no 'equalizers' in this file",
        ),
    ],
)
def test_a_plan_that_cannot_be_carried_out_is_refused(plan: str, says: str) -> None:
    assert refused(goliath_lift(plan)) == [says]


def test_positions_after_a_condition_are_bounds() -> None:
    """After a hoist that waits, 37 m more may pass the highest position, and 38 m do for sure."""
    wait = "{step: up, hoist: A, speed: 10 m/min, until: {hoist_load: {hook: A, above: 100 kN}}}"
    parse_scenario(goliath_lift(f"{wait}\n{{step: on, hoist: A, speed: 10 m/min, by: 37 m}}"))
    assert (
        "highest position"
        in refused(goliath_lift(f"{wait}\n{{step: on, hoist: A, speed: 10 m/min, by: 38 m}}"))[0]
    )


def test_an_emergency_stop_needs_a_deceleration_and_a_step() -> None:
    up = "{step: up, hoist: A, speed: 10 m/min, by: 10 m}"
    assert refused(goliath_lift(up, more="emergency_stop: {at: 5 s}\n")) == [
        "emergency_stop: 'gol.A' has no 'capacity', so that it would stop at once, with any force; give its "
        "hoist a capacity or an 'emergency_acceleration', such as 0.2 m/s^2"
    ]
    assert refused(goliath_lift(OVER, more="emergency_stop: {in_step: ovr}\n")) == [
        "emergency_stop.in_step: 'ovr' is not a step of the plan; did you mean 'over'?"
    ]


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        (
            "{type: H, height: 35.0 m}",
            "{height: 35.0 m}",
            "'reeving' is missing; a hook of a trolley needs it",
        ),
        ("{type: H, height: 35.0 m}", "{type: K, height: 35 m}", "'K' is not a name of 'hook_types'"),
        ("{type: H, height: 35.0 m}", "{type: H, height: 73 m}", "73 m is above the highest position, 72 m"),
        ("position: -20 m", "position: -70 m", "-70 m is outside of the range of traverse, -60 m to 60 m"),
        ("range: [-60 m, 60 m]", "range: [-61 m, 60 m]", "with this span and approach 60 m is the most"),
        ("range: [-60 m, 60 m]", "range: [60 m, -60 m]", "a range goes from its least to its largest"),
        ("base: 32 m", "base: 32 m, fixed_leg_at: -70 m", "with this span it is at -74 m or 74 m"),
        (
            "    legs: {fixed: 700 t, hinged: 450 t, bogies: 700 t, base: 32 m}\n",
            "",
            "nothing says what the girder stands on; 'legs: {fixed: 700 t, hinged: 450 t}'",
        ),
        (
            "    legs: ",
            "    end_carriages: {mass: 9 t}\n    legs: ",
            "where it is an overhead crane; found both",
        ),
        ("underside: 80 m", "underside: -1 m", "of a girder on legs is above their rails; found -1 m"),
    ],
)
def test_a_crane_that_cannot_be_is_refused(old: str, new: str, says: str) -> None:
    problems = refused(spoiled(old, new, goliath_lift(OVER)))
    assert any(says in problem for problem in problems), problems


def test_bodies_joints_and_masses_of_a_crane() -> None:
    girder = ", vertical_stiffness: 60 MN/m, damping: 2 %"
    document = assemble(parse_scenario(goliath_lift(OVER, girder=girder))).document
    bodies = {body["name"]: body for body in document["bodies"]}
    assert bodies["gol"]["mass"] == pytest.approx(700e3 + 450e3 + 700e3 + 18 / 35 * 2600e3)
    assert bodies["gol.girder"]["mass"] == pytest.approx(17 / 35 * 2600e3)
    # By moments about the middle of the span and the rails: the fixed leg is 74 m towards -x, legs have their
    # middles half as high as the girder, bogies are on the rails.
    x, y, z = np.array(bodies["gol"]["centre_of_gravity"]) * bodies["gol"]["mass"]
    assert x == pytest.approx((700e3 - 450e3) * -74.0) and y == 0.0
    assert z == pytest.approx((700e3 + 450e3) * 40.0 + 18 / 35 * 2600e3 * 80.0)
    assert bodies["gol.one"]["joint"]["position"] == -20.0 and bodies["gol.one"]["parent"] == "gol.girder"
    assert bodies["gol.A"]["joint"]["type"] == "point" and bodies["gol.A"]["parent"] is None
    spring = bodies["gol.girder"]["joint"]["stops"]
    carried = 17 / 35 * 2600e3 + 300e3 + 12e3 + 88e3
    assert spring["lower"] == pytest.approx(carried * 9.81 / 60e6)
    empty = 17 / 35 * 2600e3 + 300e3
    assert spring["damping_time"] == pytest.approx(2 * 0.02 / math.sqrt(60e6 / empty))


CRANE = {
    "name": "c",
    "span": 100.0,
    "fixed_leg_at": -50.0,
    "base": 20.0,
    "weights": {"girder": 400.0, "fixed": 100.0, "hinged": 60.0, "bogies": 80.0},
    "trolleys": [
        {
            "name": "c.t",
            "weight": 200.0,
            "hooks": [{"name": "c.h", "highest": 10.0, "top": "c.h/top", "along": 5.0, "across": 4.0}],
        }
    ],
}


def test_corner_loads_are_those_of_moments() -> None:
    """A trolley 25 m from mid-span towards the hinged leg with a hook 5 m further and 4 m across."""
    columns = {
        "time": np.array([0.0, 1.0]),
        "joint_position": np.array([[25.0], [25.0]]),
        "body_position": np.array(
            [[[30.0, 4.0, 9.0], [30.0, 4.0, 59.0]], [[33.0, 8.0, 9.0], [30.0, 4.0, 59.0]]]
        ),
        "body_orientation": np.tile([1.0, 0.0, 0.0, 0.0], (2, 2, 1)),
    }
    names = {"joint": ["c.t"], "body": ["c.h", "c.h/top"]}
    hoist = {"c.h": np.array([1000.0, 1000.0])}
    crane = Crane.from_json(CRANE)
    found, labels = corner_loads(columns, names, [crane], hoist)
    corners = dict(zip(labels["corner"], found["corner_load"].values[0], strict=True))
    # fixed leg: 100 + 80/2 + 400/2 + 200 (50 - 25)/100 + 1000 (50 - 30)/100; of the hook's 200 each corner
    # has 1/2 +- 4/20
    fixed, hinged = 100 + 40 + 200 + 50 + 200, 60 + 40 + 200 + 150 + 800
    assert corners["c.fixed.front"] == pytest.approx(fixed / 2 + 200 * 0.2)
    assert corners["c.fixed.back"] == pytest.approx(fixed / 2 - 200 * 0.2)
    assert corners["c.hinged.front"] == pytest.approx(hinged / 2 + 800 * 0.2)
    assert corners["c.hinged.back"] == pytest.approx(hinged / 2 - 800 * 0.2)
    # 3 m and 4 m off under 50 m of falls: they point at 3.54 m and 4.72 m off, 59 m below their top, and bear
    # upright by their cosine.
    aside = dict(zip(labels["corner"], found["corner_load"].values[1], strict=True))
    upright = 1000 * 50 / math.hypot(3, 4, 50)
    share = 0.5 + (30 + 3.54) / 100
    fixed, hinged = 100 + 40 + 200 + 50, 60 + 40 + 200 + 150
    lever = (4 + 4.72) / 20
    assert aside["c.fixed.front"] == pytest.approx(fixed / 2 + upright * (1 - share) * (0.5 + lever))
    assert aside["c.fixed.back"] == pytest.approx(fixed / 2 + upright * (1 - share) * (0.5 - lever))
    assert aside["c.hinged.front"] == pytest.approx(hinged / 2 + upright * share * (0.5 + lever))
    assert aside["c.hinged.back"] == pytest.approx(hinged / 2 + upright * share * (0.5 - lever))
    found, _ = hook_state(columns, names, [hook for _, hook in crane.hooks], ["load"])
    # 3 m and 4 m off under 50 m of falls
    assert found["falls_out_of_plumb"].values[:, 0] == pytest.approx([0.0, math.atan(5 / 50)])
    assert found["load_swing"].values[:, 0] == pytest.approx([0.0, 5.0])
    assert found["hook_height"].values[:, 0] == pytest.approx([9.0, 9.0])


def test_falls_at_a_boom_end_below_the_pin_of_their_sheave_block() -> None:
    """Falls of 20 m lean by 6 deg along x, in line with a sheave block with its sheaves 2 m below its pin.

    The pin is 22 m along the falls from the sheaves of the hook block, which stays upright, 3 m above its
    bearing. A sheave block that stays plumb has them 2 m plumb below its pin: over 1 m aside and 20 m up.
    """
    lean = math.radians(6.0)
    along = np.array([math.sin(lean), 0.0, math.cos(lean)])
    pin = np.array([10.0, 5.0, 60.0])
    sheaves = np.array([pin - 22.0 * along, pin - (1.0, 0.0, 22.0)])
    columns = {
        "body_position": np.stack((sheaves - (0.0, 0.0, 3.0), np.tile(pin, (2, 1))), axis=1),
        "body_orientation": np.array(
            [[[1.0, 0.0, 0.0, 0.0], [math.cos(lean / 2), 0.0, math.sin(lean / 2), 0.0]]] * 2
        ),
    }
    columns["body_orientation"][1, 1] = 1.0, 0.0, 0.0, 0.0
    hook = CraneHook("h", sheaves_above=3.0, top="h/top", sheaves_below=2.0)
    found, _ = hook_state(columns, {"body": ["h", "h/top"]}, [hook], [])
    expected = [lean, math.atan(1.0 / 20.0)]
    assert found["falls_out_of_plumb"].values[:, 0] == pytest.approx(expected, abs=1e-12)


def test_overloads_and_heights_are_events_at_their_crossing() -> None:
    time = np.array([0.0, 1.0, 2.0, 3.0])
    load = {"c.h": np.array([90.0, 110.0, 90.0, 130.0])}
    rating = Rating("c.h", "hook", ("c.h",), 100.0, True)
    heights = {"c.h": np.array([11.0, 9.0, 9.0, 11.0])}
    hooks = [hook for _, hook in Crane.from_json(CRANE).hooks]
    loads = {"hoist_load": load, "hook_load": load}
    events = list(crane_events(time, [rating], loads, hooks, heights))
    assert [(kind, name) for _, kind, name in events] == [("overload", "c.h")] * 2 + [
        ("hook_too_high", "c.h")
    ] * 2
    assert [at for at, _, _ in events] == pytest.approx([0.5, 2.25, 0.0, 2.5])


def test_checks_hold_the_recording_against_the_crane() -> None:
    """100 t on a hook of 100 t rated for the load alone, in gusts of 20 m/s where 16 m/s are allowed."""
    text = goliath_lift("{step: look, hold: until_end}", duration=1.0, more="wind: 20 m/s\n")
    recording = Simulation(parse_scenario(text)).run()
    checks = {check.name: check for check in check_recording(recording)}
    assert checks["wind_of_limit"].verdict == "failed" and checks["wind_of_limit"].value == pytest.approx(
        1.25
    )
    assert checks["hook_height_margin"].value == pytest.approx(72.0 - 35.0, abs=1e-6)
    assert checks["hook_approach_margin"].value == pytest.approx(74.0 - 20.0 - 14.0)
    assert checks["falls_out_of_plumb"].value == pytest.approx(0.0, abs=1e-6)
    levels = {rating.level for rating in recording.rig.ratings}
    assert levels == {"hook", "trolley", "crane"}


def test_hooks_count_where_they_are_under_their_trolleys() -> None:
    """A 3 m outside of its trolley at -20 m, B 4 m outside of one at 18 m: at -23 m and 22 m.

    They are 74 m - 23 m - 14 m and 74 m - 22 m - 14 m from where they may not go, and 45 m apart, of 12 m.
    """
    one = "          A: {type: H, height: 35.0 m}\n"
    two = (
        "      two:\n        mass: 300 t\n        position: 18 m\n"
        "        traverse: {speed: 30 m/min, acceleration: 0.03 m/s^2, range: [-50 m, 50 m]}\n"
        "        hooks:\n          B: {type: H, along: 4 m, height: 35 m}\n"
    )
    text = goliath_lift("{step: look, hold: until_end}", duration=1.0)
    text = spoiled(one, one.replace("H,", "H, along: -3 m,") + two, text)
    text = text.replace("range: [-60 m, 60 m]", "range: [-50 m, 50 m]")
    recording = Simulation(parse_scenario(text)).run()
    assert values_of(recording, "hook_approach_margin") == pytest.approx({"gol.A": 37.0, "gol.B": 38.0})
    assert values_of(recording, "hook_distance_margin") == pytest.approx({"gol.A to gol.B": 33.0})
