"""Pumping ballast, and contents for a wanted attitude, against closed forms and hand figures."""

from __future__ import annotations

import json
import math
import re
from typing import Any

import numpy as np
import pytest

from ballasted import ADDED, BREADTH, DAMPED, KG, LENGTH, OWN, barge, lift, pump, tank
from floating import SEA
from gantline.assembly import assemble
from gantline.results import Recording
from gantline.scenario import Scenario, ScenarioError, parse_scenario
from gantline.simulation import Simulation
from gantline.statics import Statics
from gantline.study import CannotBeError, solve_ballast

G = 9.81


def run(scenario: Scenario, **settings: Any) -> Recording:
    simulation = Simulation(scenario, **settings)
    return simulation.run()


def trim_of(scenario: Scenario, time: float) -> float:
    """Trim by the stern [rad]."""
    w, x, y, z = Statics(scenario).equilibrium(time).recording.column("body_orientation", "barge")[-1]
    return math.asin(2 * (x * z - w * y))


def test_work_of_a_pump_between_tanks_that_stand() -> None:
    """From a depth h₁ over the area A₁ at z₁ into an empty tank at z₂: the surfaces fall and rise linearly
    with what is pumped, so that the work is m g (z₂ + m/2ρA₂ − z₁ − h₁ + m/2ρA₁).
    """
    moved, low, high, areas = 200e3, 1.0, 7.0, (20.0 * 20.0, 8.0 * 10.0)
    tanks = {"low": tank((0, 0, low), 900.0), "high": tank((40, 0, high), 0.0, (8.0, 10.0, 6.0))}
    swing: dict[str, Any] = {"joint": {"type": "hinge", "axis": ["0", "1", "0"]}, "mass": "1 t"}
    swing |= {"centre_of_gravity": ["0 m", "0 m", "-1 m"], "inertia": {"xx": "1 t m^2", "yy": "1 t m^2"}}
    swing["inertia"] |= {"zz": "1 t m^2"}
    mechanics = {"bodies": {"shore": {"joint": {"type": "fixed"}, "tanks": tanks}, "swing": swing}}
    given = {"format": 1, "lift": {"title": "Two tanks ashore"}, "duration": "600 s", "mechanics": mechanics}
    plan = [pump("shore.low", "shore.high", "2000 t/h", by="200 t")]
    recording = run(parse_scenario(json.dumps({**given, "plan": plan})))
    work = recording.column("energy", "drive_work")[-1]
    start = 900e3 / (SEA * areas[0])
    expected = moved * G * (high - low - start + moved / (2 * SEA) * (1 / areas[0] + 1 / areas[1]))
    # The work is integrated along steps by Gauss points, exact for its linear course; 1e-9 is rounding.
    assert work == pytest.approx(expected, rel=1e-9)


def test_what_is_pumped_has_the_weight_the_inertia_and_the_surface_of_what_is_there() -> None:
    """A tank that has been pumped is the force alone, one that has not is mass of the vessel and a shift: the
    same attitude and the same natural motions, with one tank emptied and one filled to the top.
    """
    before = {"a": tank((85, 3, 0.5), 900.0), "b": tank((15, -4, 0.5), 200.0), "c": tank((50, 0, 1), 100.0)}
    capacity = SEA * 2400.0 / 1e3
    after = {"a": tank((85, 3, 0.5), 0.0), "b": tank((15, -4, 0.5), capacity), "c": tank((50, 0, 1), 400.0)}
    plan = [
        pump("a", "sea", "20000 t/h", by="900 t"),
        pump("sea", "b", "90000 t/h", by=f"{capacity - 200.0!r} t"),
        pump("sea", "c", "20000 t/h", by="300 t"),
    ]
    found = []
    for scenario in (lift(barge(before, draft="5 m"), plan), lift(barge(after, draft="5 m"))):
        question = Statics(scenario)
        rest = question.equilibrium()
        modes = np.array([mode.square for mode in question.modes()])
        found.append((rest.recording.column("body_orientation", "barge")[-1], np.sort(modes)[-3:]))
    # Equilibria are found to 1e-9 of the forces; squares of frequencies follow them.
    assert found[0][0] == pytest.approx(found[1][0], abs=1e-9)
    assert found[0][1] == pytest.approx(found[1][1], rel=1e-7)


def test_shares_of_critical_damping_know_what_is_pumped() -> None:
    """The same damping as with tanks that are not pumped, whose liquid is mass of the vessel."""
    tanks = {"a": tank((85, 3, 0.5), 900.0), "b": tank((15, -4, 0.5), 200.0)}
    damping = {"critical": {"heave": "20 %", "roll": "6 %", "pitch": "20 %"}}
    vessel, plan = barge(tanks, water_damping=damping), [pump("a", "b", "500 t/h", by="100 t")]
    found = []
    for scenario in (lift(vessel), lift(vessel, plan)):
        forces = assemble(scenario).document["forces"]
        found.append(next(one["damping"] for one in forces if one["name"] == "barge.critical_damping"))
    standing, pumped = (np.array(one) for one in found)
    # Sums in another order: rounding of the largest entry.
    assert np.abs(pumped - standing).max() < 1e-12 * np.abs(standing).max()


ROLLING = {"added_mass": ADDED, "heel": "4 deg", "trim": "-1 deg"}
SHIFTING = {"a": tank((85, 4, 0.5), 300.0), "b": tank((15, -4, 0.5), 2000.0), "c": tank((50, 5, 2), 0.0)}


@pytest.mark.parametrize("integrator", ["adaptive", "del"])
def test_energy_and_mass_of_a_barge_that_rolls_while_it_is_pumped(integrator: str) -> None:
    """From a tank that runs empty, and from the sea, on a barge that nothing damps: what pumps give, lift and
    motion, is all that its energy grows by. What one tank loses the other gets, to the last digits.
    """
    plan = [
        pump("a", "b", "60000 t/h", by="300 t"),
        pump("sea", "c", "30000 t/h", by="200 t", starts="with_previous"),
    ]
    lasts = 40.0 if integrator == "adaptive" else 6.0
    scenario = lift(barge(SHIFTING, **ROLLING), plan, start="as_given", duration=f"{lasts} s")
    recording = run(scenario, integrator=integrator)
    assert recording.attributes["status"] == "done"
    warnings = recording.attributes["warnings"]
    assert not any("energy" in one for one in warnings), "the energy balance closes to its usual bound"
    content = {name: recording.column("tank_content", f"barge.{name}") for name in SHIFTING}
    moved = content["b"][-1] - content["b"][0]
    assert moved > 20e3
    # Sums of some 2e6 kg in double precision.
    assert np.ptp(content["a"] + content["b"]) < 1e-9
    assert recording.column("energy", "kinetic").max() > 1e6, "it rolls"
    if integrator == "adaptive":
        assert content["a"][-1] == pytest.approx(0.0, abs=1e-6)
        assert content["c"][-1] == pytest.approx(200e3, abs=1e-6)
        stored = np.sum(
            [recording.column("energy", kind) for kind in ("kinetic", "gravity", "fluid")], axis=0
        )
        given = recording.column("energy", "drive_work") - recording.column("energy", "method")
        # Of the motion 1e-6, as slack tanks are held to without a pump.
        most = recording.column("energy", "kinetic").max()
        assert (stored - given)[-1] == pytest.approx(stored[0], abs=1e-6 * most)


def test_both_methods_pump_alike() -> None:
    """`adaptive` to its tolerance and `del` with steps of 1 ms, whose error is of first order in them."""
    plan = [pump("a", "b", "60000 t/h", by="100 t")]
    scenario = lift(barge(SHIFTING, **ROLLING), plan, start="as_given", duration="8 s")
    turned = [
        run(scenario, integrator=kind).column("body_orientation", "barge") for kind in ("adaptive", "del")
    ]
    assert np.abs(turned[0]).max() > 0.03
    assert np.abs(turned[0] - turned[1]).max() < 2e-4


def test_water_from_the_sea_sinks_the_barge() -> None:
    """100 t over a water plane of 3000 m²: 32.5 mm."""
    draughts = []
    scenario = lift(barge({"a": tank((50, 0, 0.5), 0.0)}), [pump("sea", "a", "3000 t/h", by="100 t")])
    for time in (0.0, 600.0):
        draughts.append(Statics(scenario).equilibrium(time).recording.column("body_position", "barge")[-1, 2])
    assert draughts[0] - draughts[1] == pytest.approx(100e3 / (SEA * LENGTH * BREADTH), rel=1e-9)


def test_a_run_that_is_saved_while_it_pumps_goes_on_alike() -> None:
    """Byte by byte what the run without a break has."""
    plan = [pump("a", "b", "60000 t/h", until={"trim": {"vessel": "barge", "above": "3 deg"}})]
    scenario = lift(barge(SHIFTING, **ROLLING), plan, start="as_given", duration="30 s")
    whole = run(scenario)
    first, second = Simulation(scenario), Simulation(scenario)
    first.run(until=9.0)
    second.restore(first.save())
    rest = second.run()
    for name in ("tank_content", "body_position", "energy"):
        assert np.array_equal(whole[name].values, rest[name].values)


def events(recording: Recording) -> list[tuple[float, str, str]]:
    columns = (recording[f"event_{key}"].values.tolist() for key in ("time", "kind", "name"))
    return list(zip(*columns, strict=True))


def test_pumps_stop_where_a_trim_is_reached_and_where_a_tank_is_empty() -> None:
    """With damping and slowly: the step ends at its trim, the next one with the tank."""
    plan = [
        pump("a", "b", "600 t/h", until={"trim": {"vessel": "barge", "above": "0.2 deg"}}),
        pump("b", "a", "40000 t/h", until={"trim": {"vessel": "barge", "below": "-5 deg"}}),
    ]
    tanks = {"a": tank((85, 0, 0.5), 300.0), "b": tank((15, 0, 0.5), 250.0)}
    damped = barge(tanks, added_mass=ADDED, water_damping=DAMPED)
    recording = run(lift(damped, plan, duration="1800 s"))
    ((begin, *_), (end, kind, _), _, (stopped, last, name), _) = events(recording)
    assert (begin, kind, last, name) == (0.0, "step_end", "pump_stopped", "b to a")
    assert recording.attributes["warnings"] == [
        f"the pumps of 'b to a' stop at {stopped:.2f} s before it is done: barge.b is empty"
    ]
    content = recording.column("tank_content", "barge.a")
    assert content[-1] == pytest.approx(550e3, rel=1e-12)
    # The pumps brake from 0.2° on in 10 s, 833 kg, and the barge follows at once.
    at = recording.time.searchsorted(end)
    turned = recording.column("body_orientation", "barge")[at]
    trim = math.degrees(math.asin(2 * (turned[1] * turned[3] - turned[0] * turned[2])))
    assert trim == pytest.approx(0.2, abs=0.002)


# The solver.


def test_least_water_by_hand() -> None:
    """Moments of tanks at 35 m ahead and 30 m astern of the middle: 900 · 35 = 200 · 30 + 25 500 t m too
    much. A tonne from the fore tank takes 35 t m away, one into the aft tank 30: all of 728.571 t from the
    fore one.
    With 500 t in it and as much moment from a weight it is emptied, and (25 500 − 500 · 35)/30 t go aft.
    """
    tanks = {"fore": tank((85, 0, 0.5), 900.0), "aft": tank((20, 0, 0.5), 200.0)}
    answer = solve_ballast(lift(barge(tanks)))
    # Even keel is a matter of moments alone, and found to 1e-7 rad: over 35 m, with a GM_L of 200 m, to 7 kg.
    assert answer.contents["fore"] == pytest.approx(900e3 - 25500e3 / 35, abs=10.0)
    assert answer.contents["aft"] == pytest.approx(200e3, abs=10.0)
    assert answer.moved == pytest.approx(25500e3 / 35, abs=10.0)
    assert answer.sea_water == pytest.approx(-answer.moved, rel=1e-9)

    own = {"hull": {"mass": f"{OWN} kg", "at": ["50 m", "0 m", f"{KG} m"]}}
    excess = 25500.0 - (500 * 35 - 200 * 30)
    own["weight"] = {"mass": "100 t", "at": [f"{50 + excess / 100} m", "0 m", "5 m"]}
    tanks["fore"] = tank((85, 0, 0.5), 500.0)
    answer = solve_ballast(lift(barge(tanks, masses=own)))
    assert answer.contents["fore"] == pytest.approx(0.0, abs=10.0)
    assert answer.contents["aft"] == pytest.approx(200e3 + (25500e3 - 500e3 * 35) / 30, abs=10.0)
    assert abs(answer.attitude.trim) < 1e-7


HOOK, LOAD = (115.0, 0.0, 60.0), 800e3


def hoisted(tanks: dict[str, Any]) -> Scenario:
    """800 t on the ground, lifted by a rope from a boom head 65 m ahead of the middle of the barge."""
    load = {"joint": {"type": "point", "position": ["115 m", "0 m", "10 m"]}, "mass": "800 t"}
    drum = {
        "diameter": "1 m",
        "rotating_mass": "1 t",
        "drive": {"speed": "30 m/min", "acceleration": "0.1 m/s^2"},
    }
    route = [
        {"type": "end", "body": "load"},
        {"type": "end", "body": "barge", "at": [f"{part} m" for part in HOOK], "drum": "winch"},
    ]
    ground = {"body": "load", "plane": {"point": ["0 m", "0 m", "10 m"], "normal": ["0", "0", "1"]}}
    mechanics = {
        "bodies": {"load": load},
        "drums": {"winch": drum},
        "ropes": {"fall": {"rope": "fall", "length": "47 m", "route": route}},
        "contacts": {"ground": {**ground, "stiffness": "200 MN/m", "damping": "2 MN s/m"}},
    }
    plan = [{"step": "up", "haul_in": "winch", "speed": "10 m/min", "by": "6 m"}]
    ropes = {"fall": {"axial_stiffness": "500 MN", "damping_time": "10 ms", "mass": "none"}}
    return lift(barge(tanks), plan, duration="60 s", mechanics=mechanics, ropes=ropes)


def test_even_keel_with_the_load_and_the_trim_before() -> None:
    """Before the lift the barge lies as the wall-sided formula says, t (GM + BM t²/2) = Σ m x/Δ with the
    surfaces of its tanks in both, its load on the ground; with the load it is even to 0.01°.
    """
    tanks = {"fore": tank((85, 0, 0.5), 900.0), "aft": tank((15, 0, 0.5), 700.0, (20.0, 28.0, 7.0))}
    tanks["middle"] = tank((30, 0, 0.5), 0.0)
    scenario = hoisted(tanks)
    answer = solve_ballast(scenario)
    assert math.degrees(max(abs(answer.attitude.heel), abs(answer.attitude.trim))) < 0.01
    found = Statics(answer.scenario).equilibrium()
    assert found.recording.column("contact_force", "ground")[-1] == 0.0, "the load hangs"
    assert abs(trim_of(answer.scenario, 60.0)) < 1e-6
    boxes = {"fore": (20.0, 20.0, 35.0), "aft": (20.0, 28.0, -35.0), "middle": (20.0, 20.0, -20.0)}
    mass = OWN + sum(answer.contents.values())
    draft, moment, height, surface = mass / (SEA * LENGTH * BREADTH), 0.0, OWN * KG, 0.0
    for name, (length, breadth, arm) in boxes.items():
        content = answer.contents[name]
        height += content * (0.5 + content / (2 * SEA * length * breadth))
        moment -= content * arm
        surface += SEA * breadth * length**3 / 12 if content > 1.0 else 0.0
    bm = LENGTH**2 / (12 * draft) - surface / mass
    gm = draft / 2 + bm - height / mass
    (tangent,) = (root.real for root in np.roots([bm / 2, 0, gm, -moment / mass]) if abs(root.imag) < 1e-9)
    assert math.degrees(answer.attitude_before.trim) > 1.0
    # Wall-sided while no bottom or top is met; the rope is slack. The search leaves 1e-9 of the forces.
    assert math.tan(answer.attitude_before.trim) == pytest.approx(tangent, rel=1e-6)
    # trim = moment/(Δ GM_L): tan θ for θ, and BM t²/2 of GM, a third of a per mille each at 1.3 degrees.
    assert answer.attitude_before.trim == pytest.approx(moment / mass / gm, rel=1e-3)
    # And with the load: GM of the boom head's height, which is where a load that hangs acts.
    whole = mass + LOAD
    draft = whole / (SEA * LENGTH * BREADTH)
    raised = (height + LOAD * HOOK[2]) / whole
    gm = draft / 2 + LENGTH**2 / (12 * draft) - surface / whole - raised
    assert answer.displacement == pytest.approx(whole, rel=1e-9)
    assert answer.gm[1] == pytest.approx(gm, rel=1e-6)


def test_tanks_too_small_and_a_vessel_that_would_capsize() -> None:
    """Tanks of 2460 t; a box of 3000 m² in sea water. KM of a box at 4 m, 20.75 m, is below 24 m."""
    tanks = {"fore": tank((85, 0, 0.5), 900.0), "side": tank((50, 5, 0.5), 0.0)}
    # 6 m displace 18 450 t, and 11 900 t are there; 4920 t less 900 t find room.
    with pytest.raises(CannotBeError, match=r"takes 6550\.0 t more .* have room for 4020\.0 t"):
        solve_ballast(lift(barge(tanks)), draft=6.0)
    with pytest.raises(CannotBeError, match=r"takes 2675\.0 t less .* can give 900\.0 t"):
        solve_ballast(lift(barge(tanks)), draft=3.0)
    with pytest.raises(CannotBeError, match=r"the nearest that was found is heel .*; draft .* off"):
        solve_ballast(lift(barge(tanks)), draft=5.0)
    with pytest.raises(ValueError, match="8 m is not between the keel of barge at 0 m and its deck at 8 m"):
        solve_ballast(lift(barge(tanks)), draft=8.0)
    top_heavy = {"hull": {"mass": f"{OWN} kg", "at": ["50 m", "0 m", "24 m"]}}
    with pytest.raises(
        CannotBeError, match=r"GM for heel is -\d\.\d\d m, so that it would capsize; free surfaces"
    ):
        solve_ballast(lift(barge(tanks, masses=top_heavy)))


def test_what_is_looked_for_is_told_before_each_equilibrium() -> None:
    """One look at the lift as given, and one for each round."""
    told: list[str] = []
    tanks = {"fore": tank((85, 0, 0.5), 900.0), "aft": tank((20, 0, 0.5), 200.0)}
    answer = solve_ballast(lift(barge(tanks)), on_progress=told.append)
    assert told[0] == "how barge floats at 600 s with the contents given"
    assert len(told) == 1 + answer.rounds
    assert re.match(r"round 1: heel 0\.000 deg; trim -\d\.\d+ deg; draft .* m; tries [\d.]+ t moved", told[1])


# Floating crane of 3600 t: what it weighs, its boom of 110 m at 60° from heel pins at (98, 9) m with 1500 t
# at 48 % of its length, 460 t of gear at its head and 1096 t that hang there, and 16 tanks in rows from the
# stern. Plausible figures for a sheerleg of 105.6 × 46 × 7.5 m; what is expected are hand figures by moments
# about its middle, for small angles, with tanks of a row alike.

ROW, WIDTH = 26.4, 11.5
HEAD = (98 + 110 * math.cos(math.radians(60)), 9 + 110 * math.sin(math.radians(60)))
CENTRE = (98 + 0.48 * (HEAD[0] - 98), 9 + 0.48 * (HEAD[1] - 9))


def sheerleg(contents: tuple[float, float], hanging: float) -> Scenario:
    """The floating crane with so much in each tank of rows 1 and 2 [t], and so much at its boom head [t]."""
    places = {
        (row, number): (ROW * (row - 0.5), WIDTH * (2.5 - number))
        for row in range(1, 5)
        for number in range(1, 5)
    }
    tanks = {
        f"row{row}.{number}": tank((x, y, 0), (*contents, 0.0, 0.0)[row - 1], (ROW, WIDTH, 7.5))
        for (row, number), (x, y) in places.items()
    }
    weights = {
        "vessel": (9100, 47.6, 8.1),
        "boom": (1500, *CENTRE),
        "gear": (460, *HEAD),
        "load": (hanging, *HEAD),
    }
    masses = {
        name: {"mass": f"{mass} t", "at": [f"{x!r} m", "0 m", f"{z!r} m"]}
        for name, (mass, x, z) in weights.items()
        if mass
    }
    vessel = {
        "draft": "4.3 m",
        "hull": {"box": ["105.6 m", "46 m", "7.5 m"]},
        "masses": masses,
        "radii_of_gyration": ["15 m", "28.5 m", "30 m"],
        "tanks": tanks,
    }
    return lift(vessel)


def test_ballast_of_a_floating_crane_by_rows() -> None:
    """Even keel at 4.40 m by rows 1 and 2: 3311 and 6441 t. How it then lies before: 1.46° by the stern, mean
    draft 4.18 m.
    """
    rows = {row: [f"row{row}.{number}" for number in range(1, 5)] for row in (1, 2)}
    found = solve_ballast(sheerleg((0.0, 0.0), 1096), draft=4.4, tanks=[*rows[1], *rows[2]])
    totals = [sum(found.contents[tank] for tank in rows[row]) for row in (1, 2)]
    assert totals == pytest.approx([3311e3, 6441e3], rel=0.02)
    # By moments alone: Σ m = ρ ∇ − 12 156 t, Σ m x = 0. Rounded places make a few tonnes.
    masses = np.array([9100e3, 1500e3, 460e3, 1096e3])
    arms = np.array([47.6, CENTRE[0], HEAD[0], HEAD[0]]) - 52.8
    ballast = SEA * 105.6 * 46 * 4.4 - masses.sum()
    exact = np.linalg.solve([[1.0, 1.0], [-39.6, -13.2]], np.array([ballast, -masses @ arms]))
    assert totals == pytest.approx(exact, rel=1e-5)

    # Found again from tanks of each row alike, hardly moving water; GM then, and before.
    alike = sheerleg((exact[0] / 4e3, exact[1] / 4e3), 1096)
    again = solve_ballast(alike, draft=4.4)
    assert again.moved < 2e3
    assert again.displacement == pytest.approx(21908e3, rel=1e-3)
    assert again.gm == pytest.approx((25.6, 191.4), rel=0.02)
    assert again.free_surface == pytest.approx((1.25, 6.6), rel=0.02)
    before = sheerleg((exact[0] / 4e3, exact[1] / 4e3), 0)
    assert math.degrees(trim_of(before, 0.0)) == pytest.approx(1.46, rel=0.02)
    alone = solve_ballast(before, trim=trim_of(before, 0.0))
    assert alone.attitude.draft == pytest.approx(4.18, rel=0.02)
    assert alone.gm == pytest.approx((32.2, 206.7), rel=0.02)


@pytest.mark.parametrize(
    ("plan", "sentence"),
    [
        ([pump("a", "b", "5 t/h", by="400 t")], "'barge.a' would run empty: 400 t are pumped from it, and 3"),
        ([pump("sea", "b", "5 t/h", by="900 t")], "'barge.b' would run over: 900 t are pumped into it, and"),
        ([pump("aa", "b", "500 t/h", by="1 t")], "'aa' is not a tank, nor 'sea'"),
        ([pump("a", "barge.a", "500 t/h", by="1 t")], "'a' is pumped into itself"),
        ([pump("a", "b", "500 t/h")], "a pump step ends by one of 'by' and 'until'; found none of them"),
        ([pump("a", "b", "500 m/h", by="1 t")], "'m/h' in '500 m/h' is not a unit of rate of pumping"),
        ([pump("a", "fresh", "500 t/h", by="1 t")], "liquid of 1025 kg/m^3 would be pumped into a tank"),
        (
            [pump("a", "b", "5 t/h", by="1 t"), pump("sea", "a", "5 t/h", by="1 t", starts="with_previous")],
            "'barge.a' is moved by two steps at once",
        ),
        (
            [pump("a", "b", "5 t/h", until={"trim": {"vessel": "boat", "above": "1 deg"}})],
            "'boat' is not a vessel",
        ),
        (
            [pump("a", "b", "5 t/h", until={"heel": {"vessel": "barge", "above": "1 deg", "below": "0"}})],
            "it has one of 'above' and 'below'",
        ),
    ],
)  # fmt: skip
def test_mistakes_about_pumps_have_a_line(plan: list[dict[str, Any]], sentence: str) -> None:
    """One message with the line for each, before the run."""
    tanks = {
        "a": tank((85, 0, 0.5), 300.0),
        "b": tank((15, 0, 0.5), 2000.0),
        "fresh": tank((50, 0, 0.5), 0.0),
    }
    tanks["fresh"]["density"] = "1 t/m^3"
    with pytest.raises(ScenarioError) as raised:
        lift(barge(tanks), plan)
    assert sentence in str(raised.value)
    assert "scenario.yaml:" in str(raised.value)


def test_contents_with_which_the_vessel_turns_over_are_no_way_to_others() -> None:
    """To first order too much goes aft and its deck under; from there nothing led back to 4° by the stern."""
    answer = solve_ballast(sheerleg((800.0, 1600.0), 1096), trim=math.radians(4.0))
    assert answer.attitude.trim == pytest.approx(math.radians(4.0), abs=1e-7)
    assert answer.attitude.heel == pytest.approx(0.0, abs=1e-7)
    # At half length; the stern is 52.8 m · tan 4° = 3.69 m deeper than that.
    assert 0.0 < answer.attitude.draft < 7.5
