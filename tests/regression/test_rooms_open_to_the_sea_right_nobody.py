"""A vessel with rooms open to the sea whose GM was that of rooms that are closed.

GM was taken with what is in every tank held. Through a hole below the water it is not: the lower of two wing
rooms takes water as she heels, and the other one loses some. A barge of 11 000 t with two such rooms, her
centre of gravity at 12 m, heeled by 9° in 10 minutes since that was 10 mm beside her middle, and had a GM
of 6.61 m for -0.10 m; `metacentric_height` passed at a limit of 0.5 m, and `floats_stably` said nothing.

Where a run ended with another heel than she would rest with, as amid a swell, she was asked as the plan has
her: with rooms as empty as at the start.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from ballasted import ADDED, BREADTH, DAMPED, LENGTH, OWN, barge, lift, tank
from gantline.checks import Verdict
from gantline.scenario.afloat.tanks import with_contents
from gantline.simulation import Simulation
from gantline.statics import Statics
from gantline.statics.inclining import metacentric_heights
from gantline.statics.righted import at_end
from of_recording import checks_of

SEA = 1025.0
#: Length and breadth of each room, and how far aside its middle is [m].
ROOM, ASIDE = (60.0, 10.0), 10.0


def rooms(content: float = 0.0, along: float = 50.0) -> dict[str, Any]:
    """Two wing rooms with a gash in the bottom of each, and so much in each [t]."""
    found = {}
    for name, y in (("port", ASIDE), ("starboard", -ASIDE)):
        found[name] = tank((along, y, 0.0), content, (*ROOM, 8.0))
        found[name]["holes"] = {"gash": {"at": [f"{along} m", f"{y} m", "0 m"], "area": "10 m^2"}}
    return found


def flooded(
    high: float, aside: float = 0.0, along: float = 50.0, content: float = 0.0, **changes: Any
) -> Any:
    """The barge with her centre of gravity so high and so far aside [m]."""
    hull = {"mass": f"{OWN} kg", "at": ["50 m", f"{aside} m", f"{high} m"]}
    vessel = barge(rooms(content, along), added_mass=ADDED, water_damping=DAMPED)
    vessel |= {"masses": {"hull": hull}, "hull": {"box": ["100 m", "30 m", "12 m"]}}
    return lift(vessel, duration="600 s", start="as_given", **changes)


def by_lost_buoyancy(high: float) -> tuple[float, float]:
    """Draft [m] and GM over all that is displaced [m]: the rooms' part of the hull bears nothing."""
    length, breadth = ROOM
    own, area = OWN / SEA, LENGTH * BREADTH - 2 * length * breadth
    draft = own / area
    second = LENGTH * BREADTH**3 / 12 - 2 * (length * breadth**3 / 12 + length * breadth * ASIDE**2)
    gm = draft / 2 + second / own - high
    return draft, gm * own / (LENGTH * BREADTH * draft)


@pytest.mark.parametrize("high", [5.0, 11.0, 12.0])
def test_gm_is_that_of_lost_buoyancy(high: float) -> None:
    """GM Δ = (KB + BM - KG) Δ', BM and Δ' of what is left of the hull, levels being equal."""
    draft, gm = by_lost_buoyancy(high)
    content = SEA * math.prod(ROOM) * draft / 1e3
    question = Statics(flooded(high, content=content))
    heights = metacentric_heights(question, question.equilibrium(0.0))["barge"]
    assert heights.transverse == pytest.approx(gm, abs=1e-6)


def test_rooms_forward_take_from_both() -> None:
    """Rooms 20 m forward of the middle: level, with her weight over the middle of what is left, (HO4)."""
    length, breadth = ROOM[0], ROOM[1]
    own, lost = OWN / SEA, 2 * length * breadth
    left = LENGTH * BREADTH - lost
    draft, middle = own / left, (LENGTH * BREADTH * 50.0 - lost * 70.0) / left
    whole = BREADTH * LENGTH**3 / 12 + LENGTH * BREADTH * (50.0 - middle) ** 2
    second = whole - 2 * breadth * length**3 / 12 - lost * (70.0 - middle) ** 2
    gm = (draft / 2 + second / own - 5.0) * own / (LENGTH * BREADTH * draft)
    vessel = barge(rooms(SEA * length * breadth * draft / 1e3, 70.0))
    vessel |= {"masses": {"hull": {"mass": f"{OWN} kg", "at": [f"{middle!r} m", "0 m", "5 m"]}}}
    question = Statics(lift(vessel, start="as_given"))
    found = metacentric_heights(question, question.equilibrium(0.0))["barge"]
    assert found.longitudinal == pytest.approx(gm, rel=1e-6)
    assert found.transverse == pytest.approx(by_lost_buoyancy(5.0)[1], abs=1e-6)


def test_it_heels_as_gm_says_once_it_has_flooded() -> None:
    """tan φ = m y/(Δ GM), with y = 10 mm aside, which in this run is 0.68°."""
    high, aside = 11.0, 0.01
    run = Simulation(flooded(high, aside)).run()
    draft, gm = by_lost_buoyancy(high)
    heel = math.atan(aside * OWN / (SEA * LENGTH * BREADTH * draft * gm))
    assert run.column("vessel_heel", "barge")[-1] == pytest.approx(-heel, rel=0.01)


def test_a_run_that_ends_with_nothing_to_right_her_fails() -> None:
    """Without a limit; upright, since nothing pushes her."""
    run = Simulation(flooded(12.0)).run()
    assert abs(run.column("vessel_heel", "barge")).max() < 1e-9
    (check,) = checks_of(run, "floats_stably")
    assert check.verdict is Verdict.FAILED
    assert "its GM is -0.10 m" in check.remark
    assert not checks_of(Simulation(flooded(11.0)).run(), "floats_stably")


def test_rooms_that_stay_shut_hold_their_water() -> None:
    """Holes that are closed, and that no step opens, change nothing."""
    shut, whole = rooms(2000.0), rooms(2000.0)
    for name in whole:
        shut[name]["holes"]["gash"]["closed"] = True
        del whole[name]["holes"]
    hull = {"mass": f"{OWN} kg", "at": ["50 m", "0 m", "11 m"]}
    found = []
    for tanks in (shut, whole):
        vessel = barge(tanks) | {"masses": {"hull": hull}, "hull": {"box": ["100 m", "30 m", "12 m"]}}
        question = Statics(lift(vessel, duration="600 s", start="as_given"))
        found.append(metacentric_heights(question, question.equilibrium(0.0))["barge"].transverse)
    assert found[0] == pytest.approx(found[1], abs=1e-9)
    assert found[0] > by_lost_buoyancy(11.0)[1] + 5.0


def test_where_a_swell_leaves_her_the_rooms_are_as_they_are() -> None:
    """Heeled by 2° as a run ends, from where she comes to rest upright."""
    scenario = flooded(11.0, limits={"metacentric_height": "0.1 m"})
    simulation = Simulation(scenario)
    simulation.run()
    heeled = np.array([math.cos(math.radians(1.0)), math.sin(math.radians(1.0)), 0.0, 0.0])
    found = at_end(Statics(scenario), 600.0, simulation.save(), {"barge": heeled}).heights
    assert found["barge"][0] == pytest.approx(by_lost_buoyancy(11.0)[1], abs=2e-3)


def test_contents_of_all_tanks_can_be_given() -> None:
    """By their full names, where they stand in the file."""
    other = with_contents(flooded(11.0), {"barge.port": 125.5})
    vessels = other.vessels or {}
    assert {name: one.content for name, one in (vessels["barge"].tanks or {}).items()} == {
        "port": 125.5,
        "starboard": 0.0,
    }
