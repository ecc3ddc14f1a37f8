"""The step that leads a load: inverse kinematics there and back, what is refused, what is shown of it."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import gantline
from gantline.cli.lead_table import lead_table
from gantline.report.steps import step_rows
from gantline.report.subject import Subject
from gantline.scenario import ScenarioError, parse_scenario
from gantline.scenario.consistency.lead import drives_along
from gantline.scenario.plan.lead import LeadStep
from gantline.scenario.plan.leading import Beyond, LedHook, Pose, Way, led_hooks, pose_before, way_of
from gantline.scenario.plan.movers import Mover
from gantline.scenario.plan.positions import boom_angles, places_of_cranes
from gantline.simulation import Simulation
from led_pair import LED, led, led_text

_RAMPS = "speed: 6 m/min, acceleration: 0.02 m/s^2"


def crane(*, travels: bool = False, aside: float = 0.7, above: float = 1.5) -> LedHook:
    """A crane with a jib, its hook beside the middle of its boom."""
    one = Mover("c.boom", "boom", 1.0, 1.0)
    return LedHook(
        name="c.H",
        crane="c",
        base=(3.0, -2.0),
        heading=0.4,
        heel=(1.6, 2.5),
        pin=(42.0, above),
        aside=aside,
        travels=travels,
        boom=one,
        upper=Mover("c.upper", "upper", 1.0, 1.0),
        hoist=Mover("c.H", "hook", 1.0, 1.0),
        track=Mover("c", "crane", 1.0, 1.0),
    )


@pytest.mark.parametrize("travels", [False, True])
def test_a_crane_finds_the_pose_that_it_had(travels: bool) -> None:
    """(LD3) of a pose, and (LD4) or (LD5) of that place from a pose near by, is that pose."""
    random = np.random.default_rng(59)
    for _ in range(200):
        led = crane(travels=travels, aside=random.uniform(-2, 2), above=random.uniform(-3, 3))
        angle, travel = math.radians(random.uniform(15, 80)), random.uniform(-10, 20)
        # Amid quadrants: abeam a crane that travels changes from pointing forward to back.
        slew = random.choice([0.0, math.pi, 2 * math.pi]) + random.uniform(-1.2, 1.2)
        pose = Pose(angle, slew, travel)
        near = Pose(angle if travels else angle + 0.1, slew + random.uniform(-0.1, 0.1), travel)
        found = led.follow(led.place(pose), near)
        assert [found.angle, found.slew, found.travel] == pytest.approx([angle, slew, travel], abs=1e-9)


def test_a_crane_goes_on_the_way_round_that_it_began() -> None:
    """Round its axis one and a half times, in parts of a tenth turn: its slew counts on past 180 degrees."""
    led = crane()
    way = Way([led.place(Pose(1.0, 0.0, 0.0))], (0.0, 0.0, 0.0), 3 * math.pi, led.base)
    shares = [part / 15 for part in range(16)]
    slews = [pose.slew for pose in way.poses(0, led, Pose(1.0, 0.0, 0.0), shares)]
    assert slews == pytest.approx([3 * math.pi * share for share in shares], abs=1e-12)


@pytest.mark.parametrize("turn", [0.0, 0.6, -0.6, 4.0])
@pytest.mark.parametrize("by", [(0.0, 0.0, 0.0), (3.0, -4.0, 0.0), (1.0, 2.0, 5.0)])
def test_the_length_of_a_way_is_its_highest_slope(turn: float, by: tuple[float, float, float]) -> None:
    """(LD1) by differences at 4000 shares, for hooks on both sides of the axis.

    The first is in the middle of the first share: the way has turned there by a 8000th of its turn.
    """
    way = Way([(-7.0, 2.0), (9.0, 1.0)], by, turn, (1.0, 0.0))
    shares = np.linspace(0.0, 1.0, 4001)
    slopes = []
    for hook in (0, 1):
        places = np.array([way.place(hook, share) for share in shares])
        level = np.linalg.norm(np.diff(places, axis=0), axis=1) / (shares[1] - shares[0])
        slopes.append(np.hypot(level, by[2]).max())
    assert way.length == pytest.approx(max(slopes), rel=1e-6 + abs(turn) / 8000)


def test_what_no_crane_reaches_is_told() -> None:
    with pytest.raises(Beyond, match=r"50\.00 m from the slewing axis of 'c'; its boom reaches"):
        crane(aside=0.0, above=0.0).follow((53.0, -2.0), Pose(1.0, 0.0, 0.0))
    with pytest.raises(Beyond, match=r"hook hangs 0\.70 m beside it at the least"):
        crane().follow((3.1, -2.0), Pose(1.0, 0.0, 0.0))
    with pytest.raises(Beyond, match="aside of the way of 'c'; at its radius, which it keeps"):
        crane(travels=True).follow((3.0, 60.0), Pose(1.0, 0.0, 0.0))


def test_a_way_past_the_slewing_axis_is_told() -> None:
    """From 20 m before the axis to 20 m behind it, 50 mm aside: half round within a hundredth of the way."""
    given = {"step": "s", "lead": "c.H", "by": ["-40 m", "0 m", "0 m"], "speed": "1 m/min"}
    step = LeadStep.model_validate({**given, "acceleration": "0.01 m/s^2"})
    led = replace(crane(aside=0.0, above=0.0), heel=(-20.0, 2.5))
    begin = led.follow((23.0, -1.95), Pose(0.5, 0.0, 0.0))
    way = Way([led.place(begin)], step.by, 0.0, (0.0, 0.0))
    with pytest.raises(
        Beyond, match=r"0\.05 m from the slewing axis of 'c', about which it cannot slew so fast"
    ):
        drives_along(step, way, 0, led, begin)


@pytest.mark.parametrize(
    ("step", "message"),
    [
        (f"{{step: s, lead: [a.H, c.H], by: [1 m, 0 m, 0 m], {_RAMPS}}}", "'c.H' is not a hook; did you"),
        (f"{{step: s, lead: [a.H, a.H], by: [1 m, 0 m, 0 m], {_RAMPS}}}", "names two hooks of 'a'"),
        (f"{{step: s, lead: [a.H, b.H], {_RAMPS}}}", "goes nowhere; 'by: [0 m, 12 m, 0 m]', say"),
        (f"{{step: s, lead: a.H, turn: 5 deg, {_RAMPS}}}", "one hook does not turn a load about itself"),
        (
            f"{{step: s, lead: a.H, by: [1 m, 0 m, 0 m], about: [0 m, 0 m], {_RAMPS}}}",
            "an axis without 'turn'",
        ),
        (
            f"{{step: s, lead: [a.H, b.H], by: [1 m, 0 m, 0 m], travelling: a, {_RAMPS}}}",
            "'a' has no 'travel'; give it one",
        ),
        (
            f"{{step: s, lead: a.H, by: [1 m, 0 m, 0 m], travelling: b, {_RAMPS}}}",
            "'b' is not a crane whose hook leads here",
        ),
        (
            f"{{step: s, lead: [a.H, b.H], by: [30 m, 5 m, 2 m], {_RAMPS}}}",
            "'a.H' would come to 32.02 m from the slewing axis of 'a'; its boom reaches",
        ),
        (
            f"{{step: s, lead: [a.H, b.H], by: [0 m, -12 m, 0 m], {_RAMPS}}}",
            "'a.boom' would come to 80.1 deg at 82 % of the way; its range is 20 deg to 80 deg",
        ),
        (
            f"{{step: s, lead: a.H, by: [0 m, 0 m, 60 m], {_RAMPS}}}",
            "'a.H' would come to 74 m; its highest position is 20 m",
        ),
        (
            "{step: s, lead: [a.H, b.H], by: [0 m, 0 m, 5 m], speed: 15 m/min, acceleration: 0.02 m/s^2}",
            "hoisting of 'a.H' would need 15 m/min at 32 % of the way; its highest speed is 12 m/min, and "
            "'12 m/min' is right here",
        ),
        (
            "{step: s, lead: [a.H, b.H], by: [0 m, 0 m, 5 m], speed: 6 m/min, acceleration: 0.4 m/s^2}",
            "hoisting of 'a.H' would need 0.4 m/s^2 at 0 % of the way; its most is 0.2 m/s^2: '0.2 m/s^2' is",
        ),
        (f"{{step: s, lead: [a.H, b.H], slew: a, by: [1 m, 0 m, 0 m], {_RAMPS}}}", "a step does one thing"),
        (
            "{step: s, lead: [a.H, b.H], by: [1 m, 0 m, 0 m], speed: 6 m/min}",
            "'acceleration' is missing",
        ),
    ],
)
def test_what_a_plan_cannot_lead_is_told(step: str, message: str) -> None:
    hook = ", highest: 20 m"
    with pytest.raises(ScenarioError) as refused:
        led(step, hook=hook)
    assert message in str(refused.value)
    assert str(refused.value).count("scenario.yaml:") == 1


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (
            "    slewing: {speed: 60 deg/min, acceleration: 0.5 deg/s^2}\n",
            "",
            "'a' does not slew, so that its hook",
        ),
        (
            "    luffing: {speed: 40 deg/min, acceleration: 0.5 deg/s^2, range: [20 deg, 80 deg]}\n",
            "",
            "the boom of 'a' does not luff: it has no 'luffing'",
        ),
        (
            "drum: {diameter: 1 m, layers: 1}",
            "drum: {diameter: 1 m, layers: 3, wraps_per_layer: 40, wraps_at_start: 20}",
            "lies on its drum in layers",
        ),
    ],
)
def test_cranes_that_cannot_lead_are_told(old: str, new: str, message: str) -> None:
    text = led_text()
    assert old in text
    with pytest.raises(ScenarioError, match=message):
        parse_scenario(text.replace(old, new))


def test_steps_that_leave_a_crane_somewhere_are_told() -> None:
    """A slew that ends on a time, and a way of which only the run knows where it begins; `to` is right."""
    slew = "{step: turn, slew: a, speed: 10 deg/min, brake_from: 5 s}"
    with pytest.raises(ScenarioError, match=r"where 'a.upper' is by then only the run can tell"):
        led(slew, LED)
    scenario = led(slew, "{step: there, slew: a, speed: 10 deg/min, to: 90 deg}", LED, duration=200.0)
    assert places_of_cranes(scenario)[1]["a.upper"] == (math.radians(90.0), False)
    assert places_of_cranes(scenario)[2]["a.upper"] == (math.radians(90.0), True)


def test_nothing_else_moves_what_a_step_leads() -> None:
    beside = "{step: luff, luff: a, starts: with_previous, speed: 1 deg/min, by: 1 deg}"
    with pytest.raises(ScenarioError, match=r"'a\.boom' is moved by two steps at once"):
        led(LED, beside)


def test_where_a_way_leaves_booms_is_known_after_it() -> None:
    """acos((|p| - 2)/30) of the place of the boom head, which a luff step `by` goes on from."""
    scenario = led(LED, "{step: luff, luff: a, speed: 5 deg/min, by: 2 deg}", duration=200.0)
    after = boom_angles(scenario)[1]["a.boom"]
    assert after[1]
    assert after[0] == pytest.approx(math.acos((math.hypot(3.0, 22.0) - 2.0) / 30.0), abs=1e-12)


def test_a_chart_that_ends_on_the_way_is_a_warning() -> None:
    rating = "rated_capacity: 100 t\n    rating: {radius: [10 m, 18 m], rated: [100 t, 60 t]}"
    text = led_text().replace("rated_capacity: 100 t\n    boom", f"{rating}\n    boom")
    doubts = [str(one.sentence) for one in Simulation(parse_scenario(text)).assembly.doubts]
    told = [one for one in doubts if "its chart has" in one]
    assert told == [
        f"at 100 % of the way '{crane}.H' is at a radius of 22.2 m, and its chart has 10.0 m to 18.0 m: "
        "outside of it nothing may hang"
        for crane in "ab"
    ]


def test_a_hook_that_stays_behind_is_a_warning() -> None:
    alone = LED.replace("[a.H, b.H]", "a.H")
    doubts = [str(one.sentence) for one in Simulation(led(alone)).assembly.doubts]
    assert [one for one in doubts if "stays behind" in one] == [
        "the load hangs in 'b.H' as well, which stays behind and pulls at it; lead all hooks that have "
        "slings on"
    ]


def test_a_hook_that_is_led_beside_does_not_stay_behind() -> None:
    """Two steps that begin together, each with a hook: nobody is left; the second after the first is."""
    first, other = LED.replace("[a.H, b.H]", "a.H"), LED.replace("[a.H, b.H]", "b.H").replace("over", "other")
    for starts, left in (("with_previous", 0), ("after_previous", 2)):
        beside = other.replace("}", f", starts: {starts}}}")
        doubts = [str(one.sentence) for one in Simulation(led(first, beside, duration=200.0)).assembly.doubts]
        assert sum("stays behind" in one for one in doubts) == left


def test_the_table_of_check_says_what_cranes_do() -> None:
    """Radius from 17 m to |(3, 22)| = 22.2 m, slew from 90 to atan(22/3) = 82.2 deg."""
    head, *rows = lead_table(led(), 140)
    assert head.split()[:3] == ["Led", "by", "step"]
    assert len(rows) == 2
    for text in ("'over'", "a.H", "17.00 to 22.20 m", "90.0 to 82.2 deg", "60.0 to 47.7 deg"):
        assert text in rows[0]
    assert lead_table(led("{step: up, hoist: a.H, speed: 1 m/min, by: 1 m}"), 140) == []


def test_report_and_rig_say_where_it_goes() -> None:
    turned = LED.replace("speed", "turn: 5 deg, speed")
    recording = gantline.simulate(parse_scenario(led_text(turned, duration=3.0)))
    step = recording.rig.plan[0]
    assert (step.kind, list(step.moves), step.acts_as) == ("lead", ["a.H", "b.H"], "lead")
    assert list(step.way or ()) == [3.0, 5.0, 2.0]
    does = step_rows(Subject(recording))[0]["does"]
    assert "lead" in does
    for text in ("3 m along x", "5 m along y", "2 m along z", "turned by 5 deg", "6 m/min"):
        assert text in does.replace(" ", " ").replace(" ", " ")


def test_a_way_down_lowers_and_one_straight_up_hoists() -> None:
    plan = led(
        LED.replace("2 m]", "-2 m]"),
        LED.replace("over", "up").replace("[3 m, 5 m", "[0 m, 0 m"),
        duration=150.0,
    )
    steps = Simulation(plan).assembly.rig["plan"]
    from gantline.results.rig import Step

    assert [Step.from_json(one).acts_as for one in steps[:2]] == ["lower", "hoist"]


def test_a_crane_on_a_vessel_stands_where_the_vessel_does() -> None:
    """Slewing axes of the ship are at x = 105 and 55 m, y = -10.5 m; hooks 10 m from x = 80 m."""
    root = Path(__file__).parents[2] / "scenarios" / "heavy_lift_ship" / "scenario.yaml"
    scenario = gantline.load_scenario(root)
    place = next(at for at, step in enumerate(scenario.plan) if step.step == "over the deck")
    step, before = scenario.plan[place], places_of_cranes(scenario)[place]
    hooks = led_hooks(scenario, step)  # type: ignore[arg-type]
    assert [led.base for led in hooks] == [(105.0, -10.5), (55.0, -10.5)]
    starts = way_of(step, hooks, before).starts  # type: ignore[arg-type]
    assert np.asarray(starts) == pytest.approx(np.array([(90.0, 21.0), (70.0, 21.0)]), abs=0.011)
    assert pose_before(hooks[0], before).slew == pytest.approx(math.radians(115.463))
