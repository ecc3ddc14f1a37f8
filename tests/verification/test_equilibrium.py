"""Where a lift comes to rest: closed forms, from anywhere, and what is said where there is no such place."""

from __future__ import annotations

import math
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from gantline.results import series
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from gantline.statics import Statics
from lowest import tilt_under_an_equalizer
from mechanics import (
    adaptive,
    body,
    contact,
    document,
    drum,
    end,
    flow,
    free,
    hinge,
    point,
    rope,
    slider,
)
from resting import CORNERS, AtRest, G, at_rest, four_slings, one_equalizer

SCENARIOS = Path(__file__).resolve().parents[2] / "scenarios"
LOAD = "block"  # as the lift file calls it
LUGS = ((-2.5, 2.5), (2.5, 2.5), (0, 0), (-2.5, -2.5), (2.5, -2.5))


def angle_between(a: np.ndarray, b: np.ndarray) -> float:
    """Angle about the vertical from one orientation to another [deg]."""
    headings = [2 * math.atan2(q[3], q[0]) for q in (a, b)]
    return math.degrees(headings[1] - headings[0])


def test_the_reference_lift_hangs_as_it_must() -> None:
    """The reference lift at rest, frame and ropes, to the last digit of an independent solution."""
    lift = Statics(SCENARIOS / "equalizer")
    rest = lift.equilibrium()
    last = {name: rest.recording.column("body_orientation", name)[-1] for name in ("e1", LOAD)}
    # The frame turns until the slings pull it no way: an independent solution in minimal coordinates has
    # -68.983 deg.
    assert angle_between(last[LOAD], last["e1"]) == pytest.approx(-68.983, abs=5e-4)
    # Each sling pulls with W/5 along the plumb; the equalizing rope with half of that and half a sheave's
    # weight.
    assert rest.tension("e1.equalizing") == pytest.approx((588.6e3 + 300 * 9.81) / 2, rel=1e-12)
    wanted = {"S1": 589.746e3, "S2": 593.180e3, "S3": 588.600e3, "S4": 593.180e3, "S5": 589.746e3}
    for name, tension in wanted.items():
        # To the last digit of the independent solution.
        assert rest.tension(f"sling.{name}") == pytest.approx(tension, abs=0.5)
    # (300 + 20 + 5 * 0.3) t * g
    assert rest.recording.column("hook_load", "test_hook")[-1] == pytest.approx(321.5e3 * 9.81, rel=1e-12)
    # The hook turns nothing: load and frame may turn together.
    assert (rest.neutral, rest.unstable) == (1, 0)
    assert lift.modes()[0].motion == f"{LOAD} turns about z"


def test_a_thousand_starts_end_in_one_state() -> None:
    """1000 starts of the reference lift, up to 20 m off, end in one state but for what nothing holds."""
    lift = Statics(SCENARIOS / "equalizer")
    planned = lift.equilibrium()
    wanted = planned.recording.column("rope_tension", "sling.S1")[-1], planned.tension("sling.S2")
    draw = np.random.default_rng(20160101)
    steps = []
    for _ in range(1000):
        # Hook, frame, five sheaves, load: up to 20 m and any heading off.
        increment = np.concatenate(
            [[0.0], draw.uniform(-math.pi, math.pi, 1), draw.uniform(-1.2, 1.2, 5),
             draw.uniform(-20, 20, 3), draw.uniform(-0.8, 0.8, 2), draw.uniform(-math.pi, math.pi, 1)]
        )  # fmt: skip
        found = lift.equilibrium(increment=increment.tolist())
        assert (found.neutral, found.unstable) == (1, 0)
        # Ten digits: rounding of sums of 600 kN after at most some hundred steps.
        assert found.tension("sling.S1") == pytest.approx(wanted[0], rel=1e-10)
        assert found.tension("sling.S2") == pytest.approx(wanted[1], rel=1e-10)
        steps.append(found.steps)
    # What a start takes, which no busy machine changes.
    assert np.median(steps) <= 30
    assert max(steps) <= 300


@pytest.mark.parametrize("excess", [0.25, 0.5, 0.9, 1.0, 1.5])
def test_one_sling_short_of_four(excess: float) -> None:
    """Four slings, one short by δ: loads 1 ± kδ/W of W/4 until two go slack."""
    # kδ = x W: loads 1 + x, 1 − x of W/4 until two go slack and the others carry 2. The limit of small δ/L
    # by a cubic through four stretches W/EA; rounding of e = ℓ − L there is 2e-15 m/5e-4 m.
    weight = 300e3 * G
    stretches = np.array([2e-4, 4e-4, 6e-4, 8e-4])
    loads = [at_rest(four_slings(weight / s, excess * s * 10.0)).tensions * 4 / weight for s in stretches]
    limit = np.linalg.solve(np.vander(stretches, 4, increasing=True), np.array(loads))[0]
    up, down = 1 + min(excess, 1.0), 1 - min(excess, 1.0)
    assert limit == pytest.approx([up, down, up, down], abs=1e-9)


def test_skew_load_factor_of_a_real_sling() -> None:
    """Skew load factor of four 60 mm slings, one 32.5 mm short: 1.2571."""
    # 300 t, 60 mm ropes of 80 GPa on 0.785 d², 10 m, 32.5 mm short: kδ/W = 0.24966 in the limit; with the
    # exact geometry of slings 5 m apart 1.2571.
    stiffness = 80e9 * 0.785 * 0.06**2
    assert stiffness / 10 * 0.0325 / (300e3 * G) == pytest.approx(0.24966, abs=1e-5)
    short, even = (at_rest(four_slings(stiffness, delta)).tensions for delta in (0.0325, 0.0))
    assert float((short / even).max()) == pytest.approx(1.2571, abs=5e-5)


def test_an_equalizer_takes_the_skew_away() -> None:
    """The same under an ideal equalizer: 1.000."""
    lugs = [(2.5 * x, 2.5 * y) for x, y in CORNERS]
    tensions = [
        at_rest(one_equalizer(lugs, lengths=[24, 24 + off, 24, 24], plumb=True)).tensions[1:]
        for off in (0.0, 0.03)
    ]
    # The sheave goes where the sling wants it: all stay plumb, to the rounding of a sling's length.
    assert tensions[1] / tensions[0] == pytest.approx([1.0] * 4, rel=1e-9)


@pytest.mark.parametrize("offset", [(0.1, 0.0), (0.0, 0.1)])
def test_tilt_under_one_equalizer(offset: tuple[float, float]) -> None:
    """Tilt under one equalizer: tan θ = e/h, 2.29 degrees for 100 mm over 2.5 m."""
    # Five equal pulls act as one from the lugs' middle: tan θ = e/h = 0.1/2.5. Slings over their lugs lean
    # by what the load turns about, so their pulls differ by 1e-9 and the tilt by 1e-4 of it.
    rest = at_rest(one_equalizer(LUGS, lengths=[26] * 5, offset=offset, plumb=True))
    orientation = rest.body("load", "body_orientation")
    tilt = 2 * math.asin(math.hypot(orientation[1], orientation[2]))
    assert math.tan(tilt) == pytest.approx(0.1 / 2.5, rel=1e-4)
    assert math.degrees(tilt) == pytest.approx(2.29, abs=0.005)


def test_equal_to_a_run_damped_to_rest() -> None:
    """The equilibrium against a simulation that is damped to rest."""
    lift = one_equalizer(LUGS, lengths=[26.0, 25.9, 26.1, 25.8, 26.2])
    for one in lift["bodies"][:-1]:
        one["joint"]["damping"] = 3e3
    for one in lift["ropes"]:
        one["material"]["damping_time"] = 0.05
    # Swings, tilts and turns are damped by lines to the world, off the load's middle.
    for index, (x, y) in enumerate([(200, 30), (-200, 30), (30, 200), (30, -200)]):
        corner = (3.0, 2.0, -2.0)
        length = math.dist(corner, (x, y, 0)) - 1.0
        route = [end(None, (x, y, 12.0)), end("load", corner)]
        lift["ropes"].append(rope(f"line{index}", length, route, 2e6, 20.0))
    rest = at_rest(lift)
    damped = adaptive(lift, 800.0, sample_interval=10.0)
    assert damped.columns["rope_tension"][-1] == pytest.approx(rest.tensions, rel=1e-6)


def test_three_legged_bridle() -> None:
    """Three slings to one hook: forces and moments about the centre of gravity."""
    # Lugs not evenly about the centre of gravity: forces by moments. The hook hangs over the centre of
    # gravity, so with slings to one point the lengths' directions and the weight make three equations.
    lugs = np.array([(3.0, 0.0, 0.0), (-2.0, 2.5, 0.0), (-1.0, -3.0, 0.0)])
    load = body("load", free((0, 0, 0)), 50e3, centre_of_gravity=(0, 0, -1.0), inertia=(2e5, 2e5, 3e5))
    hook = np.array([0.0, 0.0, 9.0])
    slings = [
        rope(f"s{i}", float(np.linalg.norm(hook - lug)), [end(None, hook), end("load", lug)], 1e8)
        for i, lug in enumerate(lugs)
    ]
    rest = at_rest(document([load], ropes=slings))
    w, x, y, z = rest.body("load", "body_orientation")
    turn = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )
    # body_position is the centre of gravity, 1 m below the lugs' plane.
    centre = rest.body("load")
    arms = np.add(lugs, (0, 0, 1.0)) @ turn.T
    pulls = hook - (centre + arms)
    directions = pulls / np.linalg.norm(pulls, axis=1)[:, None]
    tensions = np.linalg.solve(directions.T, [0, 0, 50e3 * G])
    assert rest.tensions == pytest.approx(tensions, rel=1e-9)
    moments = np.cross(arms, directions * rest.tensions[:, None]).sum(axis=0)
    assert np.abs(moments).max() < 1e-9 * 50e3 * G * 3


def test_two_cranes_share_by_moments() -> None:
    """Two cranes share a load by moments."""
    # Plumb falls 12 m apart, centre of gravity 2 m from the middle and in the lugs' plane: 8/12 and 4/12 of
    # the weight, whatever the stiffness of the falls.
    ropes = [
        rope(f"hoist{i}", 20.0, [end(None, (x, 0, 20)), end("load", (x, 0, 0))], ea)
        for i, (x, ea) in enumerate([(-6.0, 1e12), (6.0, 2e12)])
    ]
    load = body("load", free((0, 0, 0)), 200e3, centre_of_gravity=(-2, 0, -1e-9), inertia=(1e6, 3e6, 3e6))
    rest = at_rest(document([load], ropes=ropes))
    # The falls stretch by 2e-5 m over 12 m.
    assert rest.tensions == pytest.approx([200e3 * G * 8 / 12, 200e3 * G * 4 / 12], rel=1e-5)


def test_inextensible_ropes_from_far_away() -> None:
    """A double pendulum on inextensible ropes, found from up to 20 m off."""
    system = document(
        [body("hook", point((0, 0, -30)), 30e3), body("load", point((0, 0, -50)), 300e3)],
        ropes=[
            rope("upper", 30.0, [end(None), end("hook")], None),
            rope("lower", 20.0, [end("hook"), end("load")], None),
        ],
    )
    for seed in range(20):
        rest = at_rest(system, increment=np.random.default_rng(seed).uniform(-20, 20, 6).tolist())
        assert rest.tensions == pytest.approx([330e3 * G, 300e3 * G], rel=1e-10)
        assert rest.body("load") == pytest.approx([0, 0, -50], abs=1e-9)


def test_contacts_stops_and_slack_ropes() -> None:
    """A box on four springs under a slack rope, a slider on its stop."""
    # A box on four springs sinks by W/4k; the rope above it is slack.
    corners = [
        contact(f"c{i}", "box", (x, y, -1), stiffness=1e6, friction=0.5) for i, (x, y) in enumerate(CORNERS)
    ]
    box = body("box", free((0.3, 0.2, 5.0)), 1e3, inertia=(400, 400, 400))
    system = document(
        [box], contacts=corners, ropes=[rope("r", 6.0, [end(None, (0, 0, 5)), end("box")], 1e6)]
    )
    rest = at_rest(system)
    assert rest.tensions == pytest.approx([0.0])
    assert rest.body("box") == pytest.approx([0.3, 0.2, 1 - 1e3 * G / 4e6], abs=1e-10)
    # Without friction it slides and turns where it likes.
    assert (rest.found["neutral"], rest.found["unstable"]) == (3, 0)
    # A slider that falls onto its stop: W/k beyond it.
    stops = {"lower": -2.0, "stiffness": 1e5}
    fallen = at_rest(document([body("slide", slider(stops=stops), 10.0)]))
    assert fallen.joint("slide") == pytest.approx(-2.0 - 10 * G / 1e5, abs=1e-12)


def test_brakes_hold_what_they_can() -> None:
    """A drum held by its brake, and not; a pin with dry friction: sin θ = M/(m g l)."""

    def hoist(brake: float) -> AtRest:
        route = [drum(None, (0, 0, 10), "winch"), end("load")]
        load = body("load", slider(), 1e3)
        return at_rest(
            document([load, flow("winch", 100.0, brake=brake)], ropes=[rope("r", 10.0, route, 1e6)])
        )

    held = hoist(2e4)
    assert held.tensions == pytest.approx([1e3 * G], rel=1e-9)
    assert held.joint("load") == pytest.approx(-1e3 * G * 10 / 1e6, rel=1e-6)
    with pytest.raises(RuntimeError, match="falls without end"):
        hoist(5e3)
    # Dry friction of a pin holds a pendulum where it starts, up to its moment: sin θ = M/(m g l).
    for friction, angle in ((2e3, 0.5), (1e2, math.asin(1e2 / (50 * G * 1.0)))):
        pin = body("pin", hinge(position=0.5, friction=friction), 50.0, centre_of_gravity=(0, 0, -1.0))
        assert at_rest(document([pin])).joint("pin") == pytest.approx(angle, abs=1e-9)


def test_bounds_of_lossy_sheaves() -> None:
    """Nine crossings of 2 % that all slip one way: parts of the rope as 0.98 to each other."""
    text = (SCENARIOS / "equalizer" / "scenario.yaml").read_text(encoding="utf-8")
    lossy = text.replace("efficiency: 1.0, rotating_mass: 0 kg", "efficiency: 0.98, rotating_mass: 100 kg")
    lift = Statics(parse_scenario(lossy))
    assert len(lift.equilibrium().lossy) == 9
    shares = {}
    for losses in ("forward", "backward"):
        rest = lift.equilibrium(losses=losses)
        pulls = []
        for sling in rest.recording.rig.slings:
            angle = float(series.sling_angle(rest.recording, sling)[-1])
            pulls.append(rest.tension(sling.rope) * math.cos(angle) + 300 * 9.81)
        # A moving sheave hangs in parts 2 i and 2 i + 1 of ten: between two sheaves lie two crossings. Rope
        # that passes takes its stretch along, half the strain of 3e-3 times its change of 4 %.
        ratio = 0.98**2 if losses == "backward" else 0.98**-2
        assert [b / a for a, b in pairwise(pulls)] == pytest.approx([ratio] * 4, rel=2e-4)
        # They carry the load all the same.
        assert sum(pulls) == pytest.approx((300e3 + 5 * 300) * 9.81, rel=1e-9)
        shares[losses] = [pull / (sum(pulls) / 5) for pull in pulls]
    assert shares["backward"] == pytest.approx([1.082, 1.040, 0.998, 0.959, 0.921], abs=6e-4)
    assert shares["forward"] == pytest.approx(shares["backward"][::-1], rel=1e-6)


def test_a_lift_that_starts_at_rest_stays_there() -> None:
    """From `start: rest` nothing moves until the plan does."""
    text = (SCENARIOS / "equalizer" / "scenario.yaml").read_text(encoding="utf-8")
    later = text.replace("start: settled", "start: rest").replace("start_at: 0 s", "start_at: 3 s")
    moved = {}
    for name, lift in (("rest", later), ("settled", later.replace("start: rest", "start: settled"))):
        recording = simulate(parse_scenario(lift), duration=3.0)
        moved[name] = float(np.abs(recording["body_velocity"].values).max())
    # Contact springs of 200 MN/m turn rounding of 1e-15 m into 2e-7 N; sheaves would fall 0.05 mm otherwise.
    assert moved["rest"] < 1e-9
    assert moved["settled"] > 1e-4


def test_a_plan_that_waits_for_conditions() -> None:
    """Half of the weight transferred: support and hook share it."""
    lift = Statics(SCENARIOS / "equalizer_yard")
    # The hold at 50 % lasts 10 s; 60 s lies within it.
    rest = lift.equilibrium(60.0)
    transferred = float(rest.recording.column("load_transferred", LOAD)[-1])
    # From 0.5 m/min the hook brakes within v²/2a = 0.35 mm; of slings and equalizer, 33 MN/m, that is 0.39 %.
    assert transferred == pytest.approx(0.5039, abs=5e-4)
    hook = float(rest.recording.column("hook_load", "test_hook")[-1])
    # (20 + 5 * 0.3) t hang there in any case.
    assert hook == pytest.approx(transferred * 300e3 * 9.81 + 21.5e3 * 9.81, rel=1e-9)


def test_tilt_with_and_without_an_equalizer() -> None:
    """The reference load 100 mm off: 2.5 and 2.3 degrees under its equalizer, 0.2 straight to the hook."""
    text = (SCENARIOS / "equalizer" / "scenario.yaml").read_text(encoding="utf-8")

    def tilt(x: float, y: float) -> float:
        at = text.replace("at: [0 m, 0 m, 2.5 m]\n", f"at: [{x} m, {y} m, 2.5 m]\n")
        return math.degrees(
            float(Statics(parse_scenario(at)).equilibrium().recording["load_tilt"].values[-1, 0])
        )

    # atan(0.1/2.5) = 2.29 deg for plumb slings; these cross, lean by up to 7 deg, and add to it. They stretch
    # by W/5 L/EA, their lean left out of that: 0.7 % of 77 mm, of which the tilt feels a thousandth.
    sheaves, slings = (-3.2, -1.6, 0.0, 1.6, 3.2), (23.0, 26.0, 26.0, 26.0, 23.0)
    stretched = [length * (1 + 300e3 * 9.81 / 5 / 200e6) for length in slings]
    lugs = [(*lug, 5.0) for lug in LUGS]
    for offset in ((0.0, 0.0), (0.1, 0.0), (0.0, 0.1)):
        by_hand = tilt_under_an_equalizer(sheaves, stretched, lugs, (*offset, 2.5), math.radians(68.983))
        assert tilt(*offset) == pytest.approx(math.degrees(by_hand), abs=1e-4)
    # Five slings of 25 m from one point that hardly stretch: all turns as one about the hook, tan θ = e/27.5.
    lengths = [math.sqrt(25**2 + x * x + y * y) for x, y in LUGS]
    ropes = [
        rope(f"s{i}", length, [end(None, (0, 0, 27.5)), end("load", (*lug, 2.5))], 2e11)
        for i, (lug, length) in enumerate(zip(LUGS, lengths, strict=True))
    ]
    inertia = (3.125e6, 3.125e6, 5e6)
    load = body("load", free((0, 0, 0)), 300e3, centre_of_gravity=(0.1, 0, 0), inertia=inertia)
    orientation = at_rest(document([load], ropes=ropes)).body("load", "body_orientation")
    straight = math.degrees(2 * math.asin(math.hypot(orientation[1], orientation[2])))
    assert straight == pytest.approx(math.degrees(math.atan(0.1 / 27.5)), rel=1e-3)


def test_pinned_sheaves_share_by_length() -> None:
    """With its moving sheaves pinned the reference lift hangs on its two short slings alone."""
    text = (SCENARIOS / "equalizer" / "scenario.yaml").read_text(encoding="utf-8")
    lift = Statics(parse_scenario(text.replace("locked: false", "locked: true")))
    rest = lift.equilibrium()
    for sling in lift.rig.slings:
        angle = float(series.sling_angle(rest.recording, sling)[-1])
        # Slings 1 and 5 are 23 m, the others 26 m: no stretch makes up for that.
        share = 0.5 if sling.name in ("S1", "S5") else 0.0
        assert rest.tension(sling.rope) * math.cos(angle) == pytest.approx(share * 300e3 * 9.81, rel=1e-9)
    travel = rest.recording["sheave_travel"].values[-1]
    # A row without compliance is left 1e-11 m.
    assert np.abs(travel).max() <= 1e-11


def test_nothing_holds_it() -> None:
    """What nothing holds falls without end, and is named."""
    with pytest.raises(RuntimeError) as caught:
        at_rest(document([body("loose", point((0, 0, 0)), 1.0)]))
    assert caught.value.args == ("loose", "nothing holds it, it falls without end")


def beam_with_lugs(above: float) -> AtRest:
    """A beam on two slings, its centre of gravity so high above its lugs, started exactly upright."""
    slings = [
        rope(f"s{i}", 8.0, [end(None, (x, 0, 8)), end("beam", (x, 0, -above))], 1e8)
        for i, x in enumerate((-3.0, 3.0))
    ]
    beam = body("beam", free((0, 0, above)), 1e4, inertia=(5e3, 5e4, 5e4))
    return at_rest(document([beam], ropes=slings))


def test_a_centre_of_gravity_above_the_lugs_is_unstable() -> None:
    """A beam whose lugs lie below its centre of gravity is unstable about the line of its lugs."""
    assert beam_with_lugs(-0.5).found["unstable"] == 0
    rest = beam_with_lugs(0.5)
    assert rest.found["unstable"] == 1
    modes = rest.core.modes()
    assert modes["square"][0] < 0 < modes["square"][1]
    # It rolls about the line of its lugs, x.
    motion = modes["body_motion"][0, 0]
    assert abs(motion[3]) > 1e3 * np.abs(motion[4:]).max()


def test_left_by_itself_an_unstable_load_turns_over() -> None:
    """From exactly upright to where its centre of gravity hangs below the lugs, always the same way round."""
    assert beam_with_lugs(-0.5).core.step_off() is None
    rest = beam_with_lugs(0.5)
    upright = rest.body("beam")
    found = rest.core.step_off()
    assert (found["unstable"], found["neutral"]) == (0, 0)
    # Lugs at −8 (1 + m g/2 EA), the centre of gravity 0.5 m above them, then below.
    lugs = 8.0 - 8.0 * (1 + 1e4 * G / 2e8)
    assert upright == pytest.approx([0, 0, lugs + 0.5], abs=1e-9)
    assert rest.body("beam") == pytest.approx([0, 0, lugs - 0.5], abs=1e-9)
    assert rest.body("beam", "body_orientation") == pytest.approx([0, 1, 0, 0], abs=1e-9)
    # Motions are those of the new place; there is nothing left to step off from.
    assert rest.core.modes(1)["square"][0] > 0
    assert rest.core.step_off() is None
    again = beam_with_lugs(0.5)
    again.core.step_off()
    assert np.array_equal(again.body("beam", "body_orientation"), rest.body("beam", "body_orientation"))
