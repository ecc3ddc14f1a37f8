"""Friction at rest: what it holds where a lift stands, and between which bounds it would hold it as well."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Sequence

import numpy as np
import pytest

from gantline import _core
from mechanics import G, Json, body, contact, document, end, flow, free, half_turn, point, rope, slider
from resting import CORNERS, AtRest

MASS, FRICTION, STIFFNESS = 1e3, 0.3, 1e9
#: To this share of the largest bound friction follows the support forces, which are themselves found to 1e-9.
KNOWN = 1e-8
#: A rope from a point above a load that slides below it.
HEIGHT, LENGTH, EA = 5.0, 5.5, 2e5


def settled(system: Json, losses: str = "none", slide: Sequence[float] | None = None) -> AtRest:
    """The equilibrium of a document with friction."""
    core = _core.Statics(json.dumps(system))
    return AtRest(core, core.settle(0.0, None, losses, None if slide is None else list(slide)))


def standing(x: float, y: float = 0.0, *more: Json) -> Json:
    """A load on rough ground, pulled towards the plumb line of the rope."""
    ground = contact("ground", "load", (0, 0, 0), stiffness=STIFFNESS, friction=FRICTION)
    pull = rope("pull", LENGTH, [end(None, (0, 0, HEIGHT)), end("load")], EA)
    return document([body("load", point((x, y, 0)), MASS)], contacts=[ground], ropes=[pull, *more])


def pulled(x: float) -> tuple[float, float]:
    """Horizontal pull k(x) x and support force at x, the load N/k deep in the ground [N]."""
    depth = 0.0
    for _ in range(40):
        length = math.hypot(x, HEIGHT + depth)
        tension = max(0.0, EA * (length / LENGTH - 1))
        support = MASS * G - tension * (HEIGHT + depth) / length
        depth = support / STIFFNESS
    return tension * x / length, support


def root(function: Callable[[float], float], low: float, high: float) -> float:
    """By halving."""
    for _ in range(100):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if function(low) * function(middle) > 0 else (low, middle)
    return middle


#: Where |T_h| = μN.
FARTHEST = root(lambda x: pulled(x)[0] - FRICTION * pulled(x)[1], 2.3, 2.9)


@pytest.mark.parametrize("x", [0.5, 2.4, 2.5, 2.54, -2.5])
def test_a_load_holds_where_the_pull_is_less_than_friction(x: float) -> None:
    """Held where it stands, but for the spring of its contact: T_h/k."""
    pull, support = pulled(x)
    assert abs(pull) < FRICTION * support
    rest = settled(standing(x), "held")
    # The rope changes with that shift, 2e-6 m of 5.5.
    assert rest.body("load")[0] - x == pytest.approx(-pull / STIFFNESS, rel=1e-4, abs=1e-15)
    [(name, found, friction, bound)] = rest.found["contacts"]
    assert name == "ground"
    assert found == pytest.approx(support, rel=1e-5)
    assert np.asarray(friction) == pytest.approx([pull, 0, 0], rel=1e-4, abs=1e-6)
    assert bound == pytest.approx(FRICTION * found, rel=1e-12)
    assert (rest.found["neutral"], rest.found["unstable"]) == (0, 0)


def test_the_range_in_which_friction_holds() -> None:
    """[x−, x+] with k(x) x = μN at both ends; a load that stands farther out slides to the nearer one."""
    low = settled(standing(0.5), slide=(1, 0, 0)).body("load")[0]
    high = settled(standing(0.5), slide=(-1, 0, 0)).body("load")[0]
    # Forces balance to 1e-9 of their size, over a stiffness of about 1e4 N/m.
    assert (low, high) == pytest.approx((-FARTHEST, FARTHEST), abs=1e-7)
    for x in (2.7, 3.5, 5.0):
        rest = settled(standing(x), "held")
        assert rest.body("load")[0] == pytest.approx(FARTHEST, abs=1e-7)
        [(_, support, friction, bound)] = rest.found["contacts"]
        assert friction[0] == pytest.approx(bound, rel=KNOWN)
        assert support == pytest.approx(pulled(FARTHEST)[1], rel=1e-7)
    # Where no rope holds it the range is open.
    loose = standing(0.5)
    loose["ropes"] = []
    with pytest.raises(RuntimeError, match="falls without end"):
        settled(loose, slide=(1, 0, 0))


def test_friction_points_back_to_where_the_load_stood() -> None:
    """Pulled aside by a second rope as well: μN against the way that it has gone, in any direction."""
    aside = rope("aside", 7.0, [end(None, (1, 9, 0.5)), end("load")], 1e4)
    start = np.array([3.4, 0.6])
    rest = settled(standing(*start, aside), "held")
    way = rest.body("load")[:2] - start
    [(_, support, friction, bound)] = rest.found["contacts"]
    assert np.hypot(*friction[:2]) == pytest.approx(FRICTION * support, rel=KNOWN)
    assert bound == pytest.approx(FRICTION * support, rel=1e-12)
    assert np.asarray(friction[:2]) / bound == pytest.approx(-way / np.hypot(*way), abs=1e-7)
    # All forces balance.
    place = rest.body("load")
    ropes = zip(rest.tensions, ((0, 0, HEIGHT), (1, 9, 0.5)), strict=True)
    total = np.array([*friction[:2], support - MASS * G])
    for tension, anchor in ropes:
        total += tension * (np.asarray(anchor) - place) / np.linalg.norm(np.asarray(anchor) - place)
    assert total == pytest.approx(np.zeros(3), abs=1e-6 * MASS * G)


@pytest.mark.parametrize("degrees", [10.0, 16.6, 16.8])
def test_a_load_on_a_slope(degrees: float) -> None:
    """It holds while tan α ≤ μ, that is to 16.699°, with m g sin α."""
    slope = math.radians(degrees)
    ground = contact("ground", "load", (0, 0, 0), stiffness=1e8, friction=FRICTION)
    ground["plane_normal"] = [-math.sin(slope), 0, math.cos(slope)]
    system = document([body("load", point((0, 0, 0)), MASS)], contacts=[ground])
    if math.tan(slope) > FRICTION:
        with pytest.raises(RuntimeError, match="falls without end"):
            settled(system, "held")
        return
    [(_, support, friction, _)] = settled(system, "held").found["contacts"]
    assert support == pytest.approx(MASS * G * math.cos(slope), rel=1e-9)
    assert np.linalg.norm(friction) == pytest.approx(MASS * G * math.sin(slope), rel=1e-9)


def box(x: float, y: float, friction: float) -> Json:
    """A box on four corners under four ropes to one point, on top of which they pull aside."""
    corners = [
        contact(f"c{i}", "box", (*at, -1), stiffness=1e7, friction=friction) for i, at in enumerate(CORNERS)
    ]
    slings = [
        rope(f"s{i}", 5.0, [end(None, (0, 0, 6)), end("box", (*at, 0.2))], 2e5)
        for i, at in enumerate(CORNERS)
    ]
    box_body = body("box", free((x, y, 1 - MASS * G / 4e7)), MASS, inertia=(400, 400, 400))
    return document([box_body], contacts=corners, ropes=slings)


@pytest.mark.parametrize(("x", "y", "friction"), [(0.2, 0.1, 0.3), (1.0, 0.5, 0.1), (2.0, 1.0, 0.05)])
def test_corners_of_a_box(x: float, y: float, friction: float) -> None:
    """Each corner within its cone, forces in balance, whether the box holds, slides or lifts a corner."""
    rest = settled(box(x, y, friction), "held")
    assert rest.found["residual"] < 1e-9
    total = np.zeros(3)
    most = max(bound for *_, bound in rest.found["contacts"])
    for _, support, force, bound in rest.found["contacts"]:
        assert np.linalg.norm(force) <= bound + KNOWN * most
        assert bound == pytest.approx(friction * support, rel=1e-12)
        total += np.asarray(force) + np.array([0, 0, support])
    place = rest.body("box")
    w, *axis = rest.body("box", "body_orientation")
    for tension, at in zip(rest.tensions, CORNERS, strict=True):
        arm = np.array([*at, 0.2])
        turned = arm + 2 * np.cross(axis, np.cross(axis, arm) + w * arm)
        pull = np.array([0, 0, 6]) - place - turned
        total += tension * pull / np.linalg.norm(pull)
    assert total == pytest.approx([0, 0, MASS * G], abs=1e-6 * MASS * G)


def test_equal_to_a_run_damped_to_rest() -> None:
    """A box that has slid while its ropes pulled: where the run has got to is where it stays."""
    system = box(1.0, 0.5, 0.1)
    for one in system["contacts"]:
        one["damping_time"] = 0.05
    for one in system["ropes"]:
        one["material"]["damping_time"] = 0.05
    settings = {"integrator": {"type": "adaptive"}, "duration": 40.0, "sample_interval": 10.0}
    run = _core.Simulation(json.dumps(system), json.dumps(settings))
    run.run(None, 8.0)
    core = _core.Statics(json.dumps(system))
    found = core.settle_saved(run.save(), "held")
    rest = AtRest(core, found)
    assert run.run()["status"] == "done"
    columns = run.columns()
    # It has slid, and sticks.
    assert np.linalg.norm(columns["body_position"][-1, 0, :2] - [1.0, 0.5]) > 0.1
    assert rest.tensions == pytest.approx(columns["rope_tension"][-1], rel=1e-6)
    assert rest.body("box") == pytest.approx(columns["body_position"][-1, 0], abs=1e-6)


def test_a_sheave_that_sticks() -> None:
    """A load on one side, a fixed end on the other: the sheave holds any ratio of tensions from 1/ρ to ρ."""
    ratio, radius, weight, axial = 1.05, 0.5, MASS * G, 1e7

    def hung(start: float) -> Json:
        """The whole rope pulls with `start` before the load is let go."""
        sheave = half_turn(None, (0, 0, 0), radius, over=True, flow="sheave", ratio=ratio)
        route = [end("load"), sheave, end(None, (radius, 0, -10.0))]
        length = (20.0 + math.pi * radius) / (1 + start / axial)
        load = body("load", slider(), MASS, position=(-radius, 0, -10.0))
        return document([load, flow("sheave", 50.0)], ropes=[rope("r", length, route, axial)])

    def sides(losses: str, start: float) -> tuple[float, float]:
        rest = settled(hung(start), losses)
        before, after = np.asarray(rest.core.columns()["segment_tension"][-1])[[0, -1]]
        assert before == pytest.approx(weight, rel=1e-9)
        return float(before), float(after)

    # (F8): rope that passes takes its stretch along, 1e-3 of strain times 5 % of change.
    for losses, expected in (("forward", ratio), ("backward", 1 / ratio)):
        before, after = sides(losses, weight)
        assert after / before == pytest.approx(expected, rel=1e-4)
    # Stuck it leaves the fixed end what it had while that lies between the bounds; beyond, it slips to one.
    for share in (0.96, 1.0, 1.04):
        assert sides("held", share * weight)[1] == pytest.approx(share * weight, rel=1e-9)
    for share, expected in ((0.9, 1 / ratio), (1.1, ratio)):
        before, after = sides("held", share * weight)
        assert after / before == pytest.approx(expected, rel=1e-4)
