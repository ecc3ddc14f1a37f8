"""Tanks that drain and flood through holes by their head, against Torricelli and levels that are equal."""

from __future__ import annotations

import json
import math
from typing import Any

import numpy as np
import pytest

from ballasted import ADDED, BREADTH, DAMPED, LENGTH, barge
from ballasted import OWN as BARGE
from ballasted import lift as afloat
from ballasted import tank as tank_afloat
from gantline.results import Recording
from gantline.scenario import Scenario, parse_scenario
from gantline.simulation import Simulation
from tanked_load import OWN, SEA, G, hold, lift, tank

#: Least head that lets something flow, and time between glances [m, s].
STILL, EVERY = 1e-4, 0.2
#: A hole in the load, area times discharge [m^2]; level area of its tank [m^2].
PASSES, LEVEL = 0.6 * 0.05, 16.0


def hole(height: float, area: float = 0.05) -> dict[str, Any]:
    """One in the middle of the load, so high over its underside [m], with so much area [m^2]."""
    return {"valve": {"at": ["0 m", "0 m", f"{height} m"], "area": f"{area} m^2"}}


def drained(content: float, height: float = 0.5, **settings: Any) -> Scenario:
    """A load in air that drains, with so much in it at first [t] and its hole so high [m]."""
    return lift({"inside": tank((0, 0, 0.5), content, holes=hole(height))}, simulation=settings)


def step(integrator: str) -> dict[str, Any]:
    """Settings of one method."""
    return {"integrator": integrator, **({"step": "20 ms"} if integrator == "del" else {})}


def weight_on(recording: Recording) -> Any:
    """What hangs on the hook over time [kg]."""
    return recording.column("hook_load", "crane") / G


@pytest.mark.parametrize("integrator", ["adaptive", "del"])
def test_a_box_drains_as_torricelli_says(integrator: str) -> None:
    """√h = √h₀ − c a √(2g) t/2A and empty at t = (2A/ca) √(h₀/2g), (HO3), T/6 later than that since the flow
    begins from rest, h over the hole less the head that lets nothing flow. Of second order in the time
    between glances, which leaves 1e-6 of 24 t; the hook carries what is there, and the load's bounce less
    than 1e-5 of it; `del` weighs what is there as a step begins, 165 kg/s · 20 ms = 3.3 kg more.
    """
    run = Simulation(drained(24.0, **step(integrator))).run()
    content, time = run.column("tank_content", "module.inside"), run.time
    depth = 24e3 / (SEA * LEVEL) - STILL
    fall = 0.5 * PASSES * math.sqrt(2 * G) / LEVEL
    root = np.maximum(math.sqrt(depth) - fall * (time - EVERY / 6), 0.0)
    after = time > 5.0
    assert content[after] == pytest.approx((SEA * LEVEL * (root**2 + STILL))[after], abs=1e-6 * 24e3)
    empty = float(time[np.flatnonzero(np.diff(content) != 0.0)[-1]])
    by_hand = 2 * LEVEL / PASSES * math.sqrt(depth / (2 * G)) + EVERY / 6
    # The last millimetre settles over a few glances, and rates halve at each.
    assert by_hand - 1.0 < empty < by_hand + 15.0
    assert weight_on(run)[after] == pytest.approx((OWN + content)[after], abs=1e-5 * OWN + 3.5)


def level_left(time: Any, since: float, depth: float) -> Any:
    """What is in a tank of the load that drains since a time, its level over the hole falling from a depth
    less the head that lets nothing flow, by (HO3), T/6 late [kg]."""
    fall = 0.5 * PASSES * math.sqrt(2 * G) / LEVEL
    root = math.sqrt(depth) - fall * np.maximum(time - since - EVERY / 6, 0.0)
    return SEA * LEVEL * (root**2 + STILL)


@pytest.mark.parametrize("integrator", ["adaptive", "del"])
def test_it_drains_from_the_time_on_at_which_a_step_opens_the_hole(integrator: str) -> None:
    """A closed tank keeps its content to the last digit; opened at 30.1 s it drains from the next glance on,
    at 30.2 s, as from the start of a run, T/6 late. Closed at 90.1 s the rate u of the glance at 90.2 s goes
    on as u, -u/2, u/4, … from glance to glance, ramps between them, T/2 · u/2 · (1 - 1/2 + 1/4 - …) = u T/6
    in all: what ends is T/6 late as well, and it has run for 60 s. Of second order in the time between
    glances, 1e-6 of 24 t; 10 s are 50 glances.
    """
    closed = hole(0.5)
    closed["valve"]["closed"] = True
    plan = [
        hold("sealed", "30.1 s"),
        {"step": "drain", "hold": "60 s", "open_holes": "valve"},
        {"step": "sealed again", "hold": "until_end", "close_holes": "module.inside.valve"},
    ]
    tanks = {"inside": tank((0, 0, 0.5), 24.0, holes=closed)}
    run = Simulation(lift(tanks, plan, simulation=step(integrator), duration="120 s")).run()
    content, time = run.column("tank_content", "module.inside"), run.time
    assert (content[time <= 30.2] == 24e3).all()
    depth = 24e3 / (SEA * LEVEL) - STILL
    open_ = (time > 35.0) & (time < 90.0)
    assert content[open_] == pytest.approx(level_left(time[open_], 30.2, depth), abs=1e-6 * 24e3)
    kept = float(level_left(np.array(90.2 + EVERY / 6), 30.2, depth))
    after = content[time > 100.2]
    assert after == pytest.approx(kept, abs=1e-6 * 24e3)
    assert np.ptp(content[-50:]) == 0.0


def test_a_sealed_tank_does_not_flood() -> None:
    """A barge whose room is shut floats at m/ρ L B; opened, at (HO4)."""
    room = (20.0, 20.0)
    holed = tank_afloat((LENGTH / 2, 0.0, 0.0), 0.0, (*room, 6.0))
    holed["holes"] = {"gash": {"at": [f"{LENGTH / 2} m", "0 m", "0 m"], "area": "4 m^2", "closed": True}}
    draft = BARGE / (SEA * LENGTH * BREADTH)
    vessel = barge({"room": holed}, draft=f"{draft!r} m", added_mass=ADDED, water_damping=DAMPED)
    plan = [hold("afloat"), {"step": "flood", "hold": "until_end", "open_holes": "barge.room.gash"}]
    run = Simulation(afloat(vessel, plan=plan)).run()
    content, drafts = run.column("tank_content", "barge.room"), run.column("vessel_draft_aft", "barge")
    before = run.time < 30.0
    assert (content[before] == 0.0).all()
    assert drafts[before] == pytest.approx(draft, abs=1e-6)
    deeper = BARGE / (SEA * (LENGTH * BREADTH - math.prod(room)))
    assert drafts[-1] == pytest.approx(deeper, abs=STILL)


def test_what_is_below_a_hole_stays() -> None:
    """The hook carries the load and ρ A (h + d) in the end, h from the bottom of the tank to the hole, and
    nothing flows any more, to the last digit; less than that is not touched by a hole above it.
    """
    run = Simulation(drained(24.0, height=1.2)).run()
    kept = SEA * LEVEL * (0.7 + STILL)
    assert run.column("tank_content", "module.inside")[-1] == pytest.approx(
        kept, abs=0.1 * SEA * LEVEL * STILL
    )
    assert np.ptp(run.column("tank_content", "module.inside")[-100:]) == 0.0
    assert weight_on(run)[-1] == pytest.approx(OWN + kept, rel=1e-6)
    low = Simulation(drained(10.0, height=1.2)).run()
    assert (low.column("tank_content", "module.inside") == 10e3).all()


@pytest.mark.parametrize("integrator", ["adaptive", "del"])
def test_a_compartment_open_to_the_sea_is_lost_buoyancy(integrator: str) -> None:
    """A box barge whose room fills up to the water outside floats as if the room's area a were not there, at
    the draft T = m/ρ(L B − a), (HO4), with ρ a T of water in it; levels are as equal as the head that lets
    nothing flow.
    """
    room = (20.0, 20.0)
    holed = tank_afloat((LENGTH / 2, 0.0, 0.0), 0.0, (*room, 6.0))
    holed["holes"] = {"gash": {"at": [f"{LENGTH / 2} m", "0 m", "0 m"], "area": "4 m^2"}}
    draft = BARGE / (SEA * LENGTH * BREADTH)
    vessel = barge({"room": holed}, draft=f"{draft!r} m", added_mass=ADDED, water_damping=DAMPED)
    run = Simulation(afloat(vessel, simulation=step(integrator))).run()
    lost = math.prod(room)
    deeper = BARGE / (SEA * (LENGTH * BREADTH - lost))
    assert run.column("vessel_draft_aft", "barge")[-1] == pytest.approx(deeper, abs=STILL)
    content = run.column("tank_content", "barge.room")
    assert content[-1] / (SEA * lost) == pytest.approx(deeper, abs=2 * STILL)
    assert content[-1] == content[-1000]
    if integrator == "adaptive":
        remainder = abs(float(run.column("energy", "remainder")[-1]))
        assert remainder < 1e-6 * abs(float(run.column("energy", "fluid_work")[-1]))


def test_what_holes_take_is_in_the_books() -> None:
    """A tank ashore, its bottom D below the sea, fills through a hole: each kilogram loses g (z_w − z_S),
    (HO5), ρ A g D²/2 in all, and `fluid_work` is as much negative. The head that is left over is 5e-5
    of 2 m, of which the square counts.
    """
    deep, area = 2.0, 12.0
    inside: dict[str, Any] = {
        "box": ["4 m", "3 m", "5 m"],
        "bottom": ["0 m", "0 m", f"{-deep} m"],
        "content": 0,
    }
    inside["holes"] = {"pipe": {"at": ["0 m", "0 m", f"{-deep} m"], "area": "0.1 m^2", "discharge": 0.8}}
    ones = {axis: "1 t m^2" for axis in ("xx", "yy", "zz")}
    swing = {"joint": {"type": "hinge", "axis": ["0", "1", "0"]}, "mass": "1 t", "inertia": ones}
    swing["centre_of_gravity"] = ["0 m", "0 m", "-1 m"]
    bodies = {"shore": {"joint": {"type": "fixed"}, "tanks": {"dock": inside}}, "swing": swing}
    given = {
        "format": 1,
        "lift": {"title": "A dock that fills"},
        "duration": "400 s",
        "water": {"level": "0 m"},
    }
    run = Simulation(parse_scenario(json.dumps({**given, "mechanics": {"bodies": bodies}}))).run()
    full = SEA * area * deep
    assert run.column("tank_content", "shore.dock")[-1] == pytest.approx(full, rel=STILL)
    lost = 0.5 * SEA * area * G * deep**2
    assert run.column("energy", "fluid_work")[-1] == pytest.approx(-lost, rel=1e-6)


def test_a_load_that_is_hoisted_faster_than_it_drains() -> None:
    """Hoisted out within a minute, and it drains in seven: the hook carries steel and most of the water at
    first, and the steel and what stays below the hole once it has drained.
    """
    tanks = {"inside": tank((0, 0, 0.5), SEA * LEVEL * 3.0 / 1e3, holes=hole(0.5))}
    wet = {"added_mass": ["10 t", "10 t", "50 t"], "drag_coefficients": [1.0, 1.0, 1.5]}
    hoist = {"step": "out", "hoist": "crane", "speed": "6 m/min", "by": "7 m"}
    changes: dict[str, Any] = {"water": {"level": "15 m"}, "duration": "700 s", "load": {"in_water": wet}}
    run = Simulation(
        lift(tanks, [hold("below", "60 s"), hoist, hold("drains", "until_end")], **changes)
    ).run()
    content, full = run.column("tank_content", "module.inside"), SEA * LEVEL * 3.0
    # Below the water both heads grow alike: nothing runs out of a tank that is full.
    assert (content[run.time <= 60.0] == full).all()
    assert weight_on(run).max() > OWN + 0.75 * full
    assert weight_on(run)[-1] == pytest.approx(OWN + SEA * LEVEL * STILL, rel=1e-6)


def test_a_run_that_goes_on_while_it_drains() -> None:
    """From a saved state to the last bit, as a run that was not stopped."""
    scenario = drained(24.0)
    whole, first, again = Simulation(scenario).run(), Simulation(scenario), Simulation(scenario)
    first.run(until=95.0)
    again.restore(first.save())
    rest = again.run()
    for name in ("hook_load", "tank_content", "body_position", "energy"):
        assert np.array_equal(rest[name].values, whole[name].values), name


def test_holes_go_on_after_an_emergency_stop() -> None:
    """What is no drive of a crane is not stopped with these."""
    plan = [{"step": "up", "hoist": "crane", "speed": "1 m/min", "by": "5 m"}]
    tanks = {"inside": tank((0, 0, 0.5), 24.0, holes=hole(0.5))}
    hoist = {"speed": "6 m/min", "acceleration": "0.05 m/s^2", "emergency_acceleration": "0.2 m/s^2"}
    crane = {"type": "fixed_hook", "at": ["0 m", "0 m", "30 m"], "hoist": hoist}
    run = Simulation(lift(tanks, plan, emergency_stop={"at": "30 s"}, cranes={"crane": crane})).run()
    assert run.column("tank_content", "module.inside")[-1] < 2e-4 * 24e3


def test_steps_longer_than_glances_are_apart() -> None:
    """Several glances fall into a step of `del`: the content is on (HO3) to 1 % of 24 t all the same, so far
    as what was seen as a step began goes on evenly through it, and never less than nothing.
    """
    run = Simulation(drained(24.0, integrator="del", step="0.5 s")).run()
    content = run.column("tank_content", "module.inside")
    depth = 24e3 / (SEA * LEVEL) - STILL
    fall = 0.5 * PASSES * math.sqrt(2 * G) / LEVEL
    root = np.maximum(math.sqrt(depth) - fall * run.time, 0.0)
    assert content == pytest.approx(SEA * LEVEL * (root**2 + STILL), abs=0.01 * 24e3)
    assert content.min() >= 0.0
