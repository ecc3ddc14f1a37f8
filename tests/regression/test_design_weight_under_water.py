"""A module of 900 t of which water bears 780 m³ passed at 81 % of its hook's rated capacity, and needs 112 %.

Contingency was put on what the hook bore, 5 % of 100 t. The 45 t that the module may weigh more displace
nothing: under water the hook has all of them, and 100 t become 145 t. So it was with slings, lugs, hoist
ropes and supports on the bed.
"""

from __future__ import annotations

import pytest

from gantline.checks.design_weight import design_ratio, largest_ratios
from gantline.checks.force import Force
from gantline.checks.forces import hook_force, rope_force, sling_forces
from gantline.results import series
from gantline.results.recording import Recording
from gantline.scenario import Scenario, load_scenario
from gantline.simulation import simulate
from gantline.statics import Statics

G = 9.81
WEIGHT = 900e3 * G  # as simulated [N]
CONTINGENCY = 1.05
BUOYANCY = 1025.0 * 780.0 * G  # density of the lift file, displaced volume [N]
HOOK_BLOCK = 6e3 * G  # with nothing of the weight of its falls [N]

LIFT = """
format: 1
lift: {title: A module of which water bears nearly all}
duration: 60 s
water: {density: 1025 kg/m^3, depth: 60 m}
ropes:
  sling: {axial_stiffness: 300 MN, damping_time: 20 ms, minimum_breaking_force: 6 MN, mass: none}
  hoist: {axial_stiffness: 60 MN, damping_time: 20 ms, minimum_breaking_force: 900 kN, mass: none}
load:
  name: module
  shape: {box: [12 m, 12 m, 8 m]}
  position: [0 m, 0 m, -20 m]
  weight: {calculated: 900 t, contingency: 1.05}
  centre_of_gravity: {at: [0 m, 0 m, 3.9 m]}
  in_water: {displaced_volume: 780 m^3, added_mass: [300 t, 300 t, 600 t], drag_coefficients: [1, 1, 1]}
  lugs:
    A: {at: [ 5 m,  5 m, 8 m], capacity: 60 t}
    B: {at: [ 5 m, -5 m, 8 m], capacity: 60 t}
    C: {at: [-5 m,  5 m, 8 m], capacity: 60 t}
    D: {at: [-5 m, -5 m, 8 m], capacity: 60 t}
cranes:
  hook:
    type: fixed_hook
    at: [0 m, 0 m, 3 m]
    rated_capacity: 130 t
    block: {mass: 6 t, height: 2 m}
    reeving: {ropes: 2, parts_each: 4, rope: hoist, sheave_diameter: 1 m, upper_sheaves_at: 40 m}
    drum: {diameter: 1 m, layers: 1, wraps_at_start: 20}
    hoist: {speed: 3 m/min, acceleration: 0.05 m/s^2}
sling_defaults: {rope: sling, length: 16.5 m}
slings:
  A: {from: hook, to: module.A}
  B: {from: hook, to: module.B}
  C: {from: hook, to: module.C}
  D: {from: hook, to: module.D}
plan:
  - {step: hang, hold: until_end}
"""


@pytest.fixture(scope="module")
def lift(tmp_path_factory: pytest.TempPathFactory) -> Scenario:
    file = tmp_path_factory.mktemp("lift") / "scenario.yaml"
    file.write_text(LIFT)
    return load_scenario(file)


@pytest.fixture(scope="module")
def at_rest(lift: Scenario) -> Recording:
    return Statics(lift).equilibrium().recording


@pytest.fixture(scope="module")
def heavy(lift: Scenario) -> Recording:
    """The same with the design weight simulated: what raised forces have to come to."""
    return Statics(lift.changed({"load.weight.simulate": "design"})).equilibrium().recording


def _static(force: Force) -> float:
    assert force.static is not None
    return force.static


def _hook(recording: Recording) -> float:
    return _static(hook_force(recording, ["hook"], "hook_load", series.everywhere(recording)))


def test_the_hook_has_all_that_the_load_weighs_more(at_rest: Recording, heavy: Recording) -> None:
    """c W - B by hand, and what hangs there with the design weight simulated; it was 1.05 (W - B)."""
    expected = CONTINGENCY * WEIGHT - BUOYANCY
    assert _hook(at_rest) == pytest.approx(expected, rel=1e-9)
    assert _hook(heavy) == pytest.approx(expected, rel=1e-9)
    assert expected == pytest.approx(1.379 * CONTINGENCY * (WEIGHT - BUOYANCY), rel=1e-3)


def test_a_sling_has_its_quarter_of_it(at_rest: Recording, heavy: Recording) -> None:
    """Four alike; the heavier load stretches them by as little as leaves their angle as it is, to 1e-4."""
    forces = [sling_forces(one, series.everywhere(one))["A"] for one in (at_rest, heavy)]
    raised, simulated = map(_static, forces)
    assert raised == pytest.approx(simulated, rel=1e-4)


def test_a_hoist_rope_has_its_part_of_it_and_of_the_hook_block(at_rest: Recording) -> None:
    """(c W - B + hook block)/8 parts of line without losses; the hook block gets no heavier."""
    force = rope_force(at_rest, "hoist.hook.1", series.everywhere(at_rest))
    assert _static(force) == pytest.approx((CONTINGENCY * WEIGHT - BUOYANCY + HOOK_BLOCK) / 8.0, rel=1e-9)


def test_the_verdict_of_an_equilibrium_and_of_a_run_is_no_go(lift: Scenario, at_rest: Recording) -> None:
    """145.5 t over 130 t: 111.9 %, in still water with nothing that moves."""
    for recording in (at_rest, simulate(lift.changed({"duration": "20 s"}))):
        used = _hook(recording) / (130e3 * G)
        assert used == pytest.approx((CONTINGENCY * WEIGHT - BUOYANCY) / (130e3 * G), rel=1e-3)
        assert used > 1.11


def test_supports_on_the_bed_bear_all_of_it(lift: Scenario) -> None:
    """c W - B on all of them while no sling pulls."""
    on_bed = {
        "supports": {
            "mud_mats": {
                "under": "module",
                "grid": {"x": ["-4 m", "4 m"], "y": ["-4 m", "4 m"]},
                "foot": "-21 m",
                "height": "1 m",
                "stiffness": "500 MN/m",
                "damping": "5 MN s/m",
                "friction": 0.4,
                "capacity": "40 t",
            }
        },
        "load.stands_on": "mud_mats",
        "cranes.hook.at.z": "2.5 m",
    }
    recording = Statics(lift.changed(on_bed)).equilibrium().recording
    ratio = float(largest_ratios(recording, ["module"])[-1])
    assert ratio * (WEIGHT - BUOYANCY) == pytest.approx(CONTINGENCY * WEIGHT - BUOYANCY, rel=1e-9)


def test_in_air_nothing_else_is_raised_than_before(lift: Scenario) -> None:
    dry = {"load.position": ["0 m", "0 m", "4 m"], "cranes.hook.at.z": "27 m"}
    recording = Statics(lift.changed(dry)).equilibrium().recording
    assert _hook(recording) == pytest.approx(CONTINGENCY * WEIGHT, rel=1e-9)
    assert design_ratio(recording, "module") == pytest.approx(CONTINGENCY)
