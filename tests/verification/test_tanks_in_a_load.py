"""Liquid in tanks of a load that hangs, floods or drains, against weights, levers and pendulums by hand."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from gantline.checks import Verdict
from gantline.checks.forces import hook_force
from gantline.checks.loads import on_their_tip
from gantline.results import Recording, series
from gantline.results.rotation import axes
from gantline.scenario import Scenario, load_scenario
from gantline.simulation import Simulation
from gantline.statics import Statics
from gantline.study.tilting import tilting_of
from tanked_load import HIGH, OWN, SEA, SIZE, G, hold, lift, pump, tank

DRAINED = 24e3
PLAN = [
    hold("full"),
    pump("drain", ("module.inside", "sea"), "600 t/h", by="24 t"),
    hold("empty", "until_end"),
]
INSIDE = {"inside": tank((0, 0, 0.5), DRAINED / 1e3)}


def at_rest(scenario: Scenario, time: float | None = None) -> Recording:
    return Statics(scenario).equilibrium(time).recording


def hook_load(recording: Recording) -> float:
    return float(recording.column("hook_load", "crane")[-1])


def test_hook_load_before_and_after() -> None:
    """(W + m) g before, W g after, to the accuracy of equilibria, 1e-9 of the forces."""
    scenario = lift(INSIDE, PLAN)
    assert hook_load(at_rest(scenario, 0.0)) == pytest.approx((OWN + DRAINED) * G, rel=1e-9)
    assert hook_load(at_rest(scenario, 300.0)) == pytest.approx(OWN * G, rel=1e-9)


@pytest.mark.parametrize("integrator", ["adaptive", "del"])
def test_hook_load_follows_a_slow_pump(integrator: str) -> None:
    """(W + m − r t) g: of what starts within ten seconds the load's bounce makes less than 1e-6 of that;
    liquid that leaves takes its momentum along and pushes nothing. By hand 24 t at 600 t/h take 144 s and the
    ten in which pumps start and stop. `del` weighs what is there as a step begins: r h g = 16.35 N more.
    """
    settings = {"integrator": integrator, **({"step": "10 ms"} if integrator == "del" else {})}
    run = Simulation(lift(INSIDE, PLAN, simulation={**settings, "sample_interval": "0.1 s"})).run()
    content = run.column("tank_content", "module.inside")
    begin, end = 30.0 + 10.0, 30.0 + 144.0
    even = (run.time >= begin) & (run.time <= end)
    rate = 600e3 / 3600.0
    # Half of the rate in the mean of its ten first seconds.
    linear = DRAINED - rate * (run.time[even] - begin + 5.0)
    assert content[even] == pytest.approx(linear, abs=1e-6)
    assert content[-1] == pytest.approx(0.0, abs=1e-6)
    behind = rate * 10e-3 if integrator == "del" else 0.0
    weight = (OWN + linear + behind) * G
    assert run.column("hook_load", "crane")[even] == pytest.approx(weight, rel=1e-6)


def test_books_of_what_runs_out() -> None:
    """What leaves a load that hangs still takes m g (z + h/2 − z_w), from the middle of its depth to the sea.

    Slings give 2.4 mm less as it leaves; the place of the load is that of the recording.
    """
    run = Simulation(lift(INSIDE, PLAN, simulation={"integrator": "adaptive"})).run()
    bottom = run.column("body_position", "module")[[0, -1], 2] - HIGH + 0.5
    depth = DRAINED / (SEA * 16.0)
    # Both level and place fall and rise linearly with what has left: z(s) = z₀ + s Δz, h(s) = h (1 − s).
    expected = -DRAINED * G * (bottom.mean() + depth / 2)
    assert run.column("energy", "drive_work")[-1] == pytest.approx(expected, rel=1e-7)
    assert run.attributes["energy_remainder"] < 1e-9


def test_books_count_from_the_level_of_the_sea() -> None:
    """Over a sea at 3 m the 1 t that runs out in 16 s falls 3 m less far, and takes m g · 3 m less away.

    What leaves a surface takes m g (z + h/2 − z_w); bodies and forces are those of z_w = 0.
    """
    plan = [pump("drain", ("module.inside", "sea"), "600 t/h", by="1 t"), hold("empty", "until_end")]
    given: dict[str, Any] = {"simulation": {"integrator": "adaptive"}, "duration": "20 s"}
    low, high = (
        Simulation(lift(INSIDE, plan, water={"level": level}, **given)).run() for level in ("0 m", "3 m")
    )
    assert high.column("tank_content", "module.inside")[-1] == pytest.approx(DRAINED - 1e3, abs=1e-6)
    less = high.column("energy", "drive_work")[-1] - low.column("energy", "drive_work")[-1]
    assert less == pytest.approx(1e3 * G * 3.0, rel=1e-7)
    assert high.attributes["energy_remainder"] < 1e-9


def balance(recording: Recording, box: tuple[float, ...], place: tuple[float, ...]) -> float:
    """Moment about the hook of a load that leans about y with a liquid in it, over its weight [m].

    In a box of the length L that is filled to d the surface, level in the world, leans by φ in the load:
    its centre is L²/12d tan φ aside and d/2 + L²/24d tan²φ high, where it meets no bottom and no top.
    """
    turn = axes(recording.column("body_orientation", "module")[-1])
    up = turn[2]
    lean = -up[0] / up[2]
    mass = float(recording.column("tank_content", "module.end")[-1])
    depth = mass / (SEA * box[0] * box[1])
    aside, high = box[0] ** 2 / 12 / depth * lean, depth / 2 + box[0] ** 2 / 24 / depth * lean**2
    where = np.add(place, (aside, 0.0, high))
    hook = turn.T @ (np.array([0.0, 0.0, 30.0]) - recording.column("body_position", "module")[-1])
    moment = OWN * np.cross(-hook, up) + mass * np.cross(where - [0.0, 0.0, HIGH] - hook, up)
    return float(moment[1] / (OWN + mass))


def test_tilt_as_a_tank_at_the_end_drains() -> None:
    """The moment of load and liquid about the hook is none, the surface of the liquid level; and with a full
    tank, which has none, tan φ is the shift of the centre of gravity over its distance below the hook.
    """
    box, place = (3.0, 4.0, 3.0), (4.0, 0.0, 0.5)
    full = SEA * math.prod(box) / 1e3
    plan = [
        hold("full"),
        pump("half", ("module.end", "sea"), "600 t/h", by=f"{full / 2!r} t"),
        hold("rest", "until_end"),
    ]
    scenario = lift({"end": tank(place, full, box)}, plan)
    before, after = at_rest(scenario, 0.0), at_rest(scenario, 300.0)
    turn = axes(before.column("body_orientation", "module")[-1])
    hook = turn.T @ (np.array([0.0, 0.0, 30.0]) - before.column("body_position", "module")[-1])
    mass = 1e3 * full
    aside = (mass * place[0]) / (OWN + mass) - hook[0]
    below = hook[2] - mass * (place[2] + 1.5 - HIGH) / (OWN + mass)
    tilt = float(before.column("load_tilt", "module")[-1])
    assert math.tan(tilt) == pytest.approx(aside / below, rel=1e-9)
    assert tilt > math.radians(2.0)
    assert balance(after, box, place) == pytest.approx(0.0, abs=1e-9)
    assert 0.3 * tilt < after.column("load_tilt", "module")[-1] < 0.6 * tilt
    # That the surface follows counts: the frozen liquid of half the tank would lean otherwise.
    lean = math.tan(float(after.column("load_tilt", "module")[-1]))
    assert box[0] ** 2 / 12 / 1.5 * lean > 1e-2


def test_a_free_surface_slows_the_swing() -> None:
    """On slings to one hook a load swings as one body: (J + Σ m d²) φ̈ + (M g d − ρ g i) φ = 0, i = b l³/12 of
    the surface. Slings of an EA of 2 TN give by less than 1e-4 of that.
    """
    box, place = (10.0, 5.0, 3.0), (0.0, 0.0, 0.5)
    mass = SEA * math.prod(box) / 2
    rigid: dict[str, Any] = {"ropes": {"stiff": {"axial_stiffness": "2e6 MN"}}}
    question = Statics(lift({"inside": tank(place, mass / 1e3, box)}, **rigid))
    rest = question.equilibrium()
    modes = question.modes()
    hook = 30.0 - rest.recording.column("body_position", "module")[-1, 2]
    at = hook - (place[2] + box[2] / 4 - HIGH)
    for axis, (along, across) in enumerate(((1, 0), (0, 1))):
        own = OWN * (SIZE[along] ** 2 + SIZE[2] ** 2) / 12 + OWN * hook**2
        liquid = mass * (box[along] ** 2 + (box[2] / 2) ** 2) / 12 + mass * at**2
        second = box[across] * box[along] ** 3 / 12
        rights = (OWN * hook + mass * at) * G - SEA * G * second
        found = [mode for mode in modes if mode.motion == f"module moves along {'yx'[axis]}"]
        assert found[0].square == pytest.approx(rights / (own + liquid), rel=1e-4)
        # Without what the surface takes it would be another.
        assert SEA * G * second > 0.02 * rights
    (tilting,) = tilting_of(question, rest, modes)
    below = (OWN * hook + mass * at) / (OWN + mass)
    heights = [below - SEA * (box[1 - axis] * box[axis] ** 3 / 12) / (OWN + mass) for axis in (0, 1)]
    found_heights = [tilting.soft.height, tilting.stiff.height]
    assert found_heights == pytest.approx(heights, rel=1e-4)
    of_lugs = (OWN * (SIZE[2] - HIGH) + mass * (SIZE[2] - place[2] - box[2] / 4)) / (OWN + mass)
    assert tilting.depth == pytest.approx(of_lugs, rel=1e-9)


def test_on_its_tip_by_a_free_surface() -> None:
    """A load in slings to two hooks above its ends tilts about x as if hung at its lugs: M d < ρ i turns it
    over, with d of the centre of gravity below them; the check fails, and passes with the tank full.
    """
    box, place = (11.0, 5.9, 3.0), (0.0, 0.0, 0.1)
    changes: dict[str, Any] = two_hooks()
    half = SEA * math.prod(box) / 2
    lugs, middle = 2.2, (OWN * 2.0 + half * (place[2] + box[2] / 4)) / (OWN + half)
    assert (OWN + half) * (lugs - middle) < SEA * box[0] * box[1] ** 3 / 12
    loose = lift({"inside": tank(place, half / 1e3, box)}, [hold("still", "20 s")], **changes)
    assert not Statics(loose).equilibrium().is_stable
    (check,) = on_their_tip(Simulation(loose).run())
    assert (check.verdict, check.element) == (Verdict.FAILED, "module")
    full = SEA * math.prod(box)
    middle = (OWN * 2.0 + full * (place[2] + box[2] / 2)) / (OWN + full)
    assert lugs > middle
    steady = lift({"inside": tank(place, full / 1e3, box)}, [hold("still", "20 s")], **changes)
    assert Statics(steady).equilibrium().is_stable
    assert on_their_tip(Simulation(steady).run()) == []


def test_contingency_is_on_the_weight_and_not_on_what_is_in_tanks() -> None:
    """Two hooks together bear 1.05 × 120 t and 24 t, of which nobody knows who bears how much: alone each has
    1.05 times all that it bears, 60 t and of a full tank above the western hook all.
    """
    changes = two_hooks()
    changes["load"] |= {"weight": {"calculated": f"{OWN} kg", "contingency": 1.05}}
    tanks = {"inside": tank((-4.0, 0, 0.5), 18.45, (2.0, 3.0, 3.0))}
    found = at_rest(lift(tanks, **changes))
    every = series.everywhere(found)
    together = hook_force(found, ["east", "west"], "hook_load", every)
    assert together.static == pytest.approx((1.05 * OWN + 18450.0) * G, rel=1e-9)
    for hook, part in (("east", 60e3 + 18450.0 * 0.1), ("west", 60e3 + 18450.0 * 0.9)):
        alone = hook_force(found, [hook], "hook_load", every)
        # Slings of 17.8 m lean by what the load has gone aside.
        assert alone.static == pytest.approx(1.05 * part * G, rel=1e-3)


def test_a_load_that_swings_is_not_on_its_tip() -> None:
    """It hangs still as no drive moves, and leans by degrees as the run ends: no equilibrium is elsewhere."""
    aside = {"position": ["1.2 m", "0 m", "10.4 m"]}
    plan = [hold("swing", "until_end")]
    run = Simulation(lift(INSIDE, plan, load=aside, start="as_given", duration="26.5 s")).run()
    assert np.degrees(run.column("load_tilt", "module").max()) > 3.0
    assert on_their_tip(run) == []


def two_hooks() -> dict[str, Any]:
    """Two hooks, each above the lug at one end, 2.2 m over the underside."""
    hoist = {"speed": "6 m/min", "acceleration": "0.05 m/s^2"}
    ends = {"east": 5.0, "west": -5.0}
    return {
        "cranes": {
            name: {"type": "fixed_hook", "at": [f"{x} m", "0 m", "30 m"], "hoist": hoist}
            for name, x in ends.items()
        },
        "slings": {
            name: {"from": name, "to": f"module.{name}", "rope": "stiff", "length": "17.8 m"} for name in ends
        },
        "load": {"lugs": {name: {"at": [f"{x} m", "0 m", "2.2 m"]} for name, x in ends.items()}},
    }


def test_flooded_it_is_as_heavy_as_its_steel_in_water() -> None:
    """Wholly wet a full tank of sea water weighs nothing, wherever it is: hook load (W − ρ V) g and no tilt,
    V of the steel alone; half full it pulls up by what it lacks, at its place.
    """
    steel = OWN / 7850.0
    wet = {"added_mass": ["50 t", "80 t", "150 t"], "drag_coefficients": [1.2, 1.2, 1.8]}
    box, place = (3.0, 4.0, 3.0), (4.0, 0.0, 0.5)
    inside = math.prod(box)
    sea: dict[str, Any] = {"water": {"level": "60 m", "density": f"{SEA} kg/m^3"}}
    flooded = at_rest(lift({"end": tank(place, SEA * inside / 1e3, box)}, load={"in_water": wet}, **sea))
    assert hook_load(flooded) == pytest.approx((OWN - SEA * steel) * G, rel=1e-9)
    assert flooded.column("load_tilt", "module")[-1] == pytest.approx(0.0, abs=1e-9)
    stated = {**wet, "displaced_volume": f"{steel + inside!r} m^3"}
    half = at_rest(lift({"end": tank(place, SEA * inside / 2e3, box)}, load={"in_water": stated}, **sea))
    assert hook_load(half) == pytest.approx((OWN - SEA * (steel + inside / 2)) * G, rel=1e-9)
    assert axes(half.column("body_orientation", "module")[-1])[2, 0] > 0.02


def test_static_values_are_of_a_load_that_does_not_drain() -> None:
    """It hung still under water alone, and drains as it is out: static is the time in the air before that, of
    the full weight, and no mean over what has run out since.
    """
    wet = {"added_mass": ["50 t", "80 t", "150 t"], "drag_coefficients": [1.2, 1.2, 1.8]}
    plan = [
        hold("below"),
        {"step": "out", "hoist": "crane", "speed": "6 m/min", "by": "9 m"},
        pump("drain", ("module.inside", "sea"), "600 t/h", by="49 t"),
    ]
    full = 49.2e3
    changes: dict[str, Any] = {"water": {"level": "16 m"}, "duration": "430 s", "load": {"in_water": wet}}
    run = Simulation(lift({"inside": tank((0, 0, 0.5), full / 1e3)}, plan, **changes)).run()
    static, window = series.greatest_static(run, run.column("hook_load", "crane"))
    assert np.ptp(run.column("tank_content", "module.inside")[window]) == 0.0
    # It is being hoisted, and brakes: a mean over 20 s is that near to the weight.
    assert static == pytest.approx((OWN + full) * G, rel=1e-3)


def test_full_tanks_hang_as_steel_does() -> None:
    """A load of 800 t with 200 t in a full tank at its centre of gravity lies as one of 1000 t: heel and trim
    of the vessel, hook loads, all to the accuracy of equilibria; it is lost as one, too.
    """
    steel = load_scenario("floating_crane")
    deep = 200e3 / SEA / 100.0
    filled = {"box": ["10 m", "10 m", f"{deep!r} m"], "bottom": ["0 m", "0 m", f"{5.0 - deep / 2!r} m"]}
    content = {"content": f"{200.0 * (1 - 1e-10)!r} t"}
    tanked = steel.changed({"load.weight.calculated": "800 t", "load.tanks": {"deep": {**filled, **content}}})
    found = []
    for scenario in (steel, tanked):
        question = Statics(scenario)
        rest = question.equilibrium(question.when("hold point 3", "ends")).recording
        found.append(
            [
                rest[name].values[-1]
                for name in ("hook_load", "vessel_heel", "vessel_trim", "load_transferred")
            ]
        )
    for one, other in zip(*found, strict=True):
        assert other == pytest.approx(one, rel=1e-7, abs=1e-9)


def test_stands_with_what_is_in_it() -> None:
    """Supports bear (W + m) g, none is transferred; a step that waits for a share goes on while its hoist
    brakes, to that share of W and what is in the tank then, and a bit; settled and from rest alike.
    """
    ground = {"ground": {"stiffness": "100 MN/m"}}
    stands = {"stands_on": "ground", "position": ["0 m", "0 m", "0 m"]}
    crane = {"cranes": {"crane": {"type": "fixed_hook", "at": ["0 m", "0 m", "19.99 m"],
             "hoist": {"speed": "6 m/min", "acceleration": "0.05 m/s^2"}}}}  # fmt: skip
    plan = [
        {"step": "half", "hoist": "crane", "speed": "0.1 m/min", "until": {"load_transferred": "50 %"}},
        hold("wait"),
        pump("drain", ("module.end", "sea"), "600 t/h", by="24 t"),
        {"step": "all", "hoist": "crane", "speed": "0.1 m/min", "until": {"load_transferred": "90 %"}},
        hold("rest", "20 s"),
    ]
    tanks = {"end": tank((1.0, 0.5, 0.5), 24.0)}
    for start in ("rest", "settled"):
        scenario = lift(tanks, plan, load=stands, start=start, duration="600 s", **ground, **crane)
        run = Simulation(scenario).run()
        supports = sum(run.column("contact_force", one) for one in run.rig.loads[0].contacts)
        share = run.column("load_transferred", "module")
        weight = (OWN + run.column("tank_content", "module.end")) * G
        hung = run.column("hook_load", "crane")
        assert share == pytest.approx(1.0 - supports / weight, abs=1e-12)
        assert share[0] == pytest.approx(0.0, abs=1e-6)
        ends = {name: time for time, kind, name in run.events() if kind == "step_end"}
        for step, still, part in (("half", "wait", 0.5), ("all", "rest", 0.9)):
            assert part <= share[np.searchsorted(run.time, ends[step])] < part + 0.05
            at = int(np.searchsorted(run.time, ends[still])) - 1
            # What is left of the bounce after twenty seconds.
            assert hung[at] == pytest.approx(share[at] * weight[at], rel=1e-6)


def test_moment_about_a_hinge() -> None:
    """A mast in a hinge at its foot, held by a hook at its head: F l = Σ m g x about the hinge, with the
    liquid of a full leg at its middle.
    """
    box, place = (1.0, 1.0, 8.0), (1.5, 0.0, 6.0)
    mass = SEA * math.prod(box)
    found = at_rest(mast({"leg": tank(place, mass / 1e3, box)}))
    turn = axes(found.column("body_orientation", "mast")[-1])
    own = found.column("body_position", "mast")[-1]
    foot = own + turn @ [0.0, 0.0, -15.0]
    leg = own + turn @ (np.array([place[0], 0.0, place[2] + 4.0]) - [0.0, 0.0, 15.0])
    first, last = (found["rope_point"].values[-1, at] for at in (0, 1))
    pull = float(found.column("rope_tension", "sling.S")[-1]) * (first - last) / np.linalg.norm(first - last)
    by_sling = np.cross(last - foot, pull)[1]
    weights = 50e3 * G * (own - foot)[0] + mass * G * (leg - foot)[0]
    assert by_sling == pytest.approx(-weights, rel=1e-8)
    borne = 1.0 - found.column("load_transferred", "mast")[-1]
    assert borne == pytest.approx(1.0 - pull[2] / ((50e3 + mass) * G), rel=1e-8)


def mast(tanks: dict[str, Any]) -> Scenario:
    """A mast of 50 t, 30 m long, that stands in a hinge at its foot and leans by what its sling lets it."""
    lug = {"head": {"at": ["0 m", "0 m", "30 m"]}}
    return lift(
        tanks,
        load={
            "name": "mast",
            "shape": {"box": ["4 m", "2 m", "30 m"]},
            "position": ["0 m", "0 m", "0 m"],
            "weight": {"calculated": "50 t"},
            "centre_of_gravity": {"at": ["0 m", "0 m", "15 m"]},
            "lugs": lug,
        },
        hinges={"foot": {"at": ["0 m", "0 m", "0 m"], "axis": ["0", "1", "0"], "held_by": "world"}},
        slings={"S": {"from": "crane", "to": "mast.head", "rope": "stiff", "length": "20 m"}},
        cranes={"crane": {"type": "fixed_hook", "at": ["-15 m", "0 m", "43 m"],
                "hoist": {"speed": "6 m/min", "acceleration": "0.05 m/s^2"}}},
    )  # fmt: skip


def test_a_run_that_goes_on_amid_pumping() -> None:
    """From a saved state to the last bit, as a run that was not stopped, and twice the same."""
    scenario = lift(
        {"end": tank((4.0, 0.5, 0.5), 24.0)},
        [PLAN[0], pump("drain", ("module.end", "sea"), "600 t/h", by="24 t")],
    )
    whole, first, again = Simulation(scenario).run(), Simulation(scenario), Simulation(scenario)
    first.run(until=95.0)
    assert 0.0 < first.now("tank_content", "module.end") < 24e3
    assert first.now("load_transferred", "module") == 1.0
    again.restore(first.save())
    rest = again.run()
    for name in ("hook_load", "tank_content", "body_position", "energy"):
        assert np.array_equal(rest[name].values, whole[name].values), name
