"""A mooring line made fast above its fairlead was checked by the pull at the fairlead.

The tension of a line that hangs by its weight is that at the fairlead, its upper end where it goes down to
an anchor or along to a quay. Where the bollard is higher, the upper end is there, and bears what hangs
between both heights too: 17.5 m of 40 kg/m are 6.9 kN over 150 kN. A line of nodes, whose tension is the
largest along it, had 4 % more of its breaking force than the catenary.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.checks import values_of
from gantline.results.recording import Recording

#: Of the rope [kg/m, kN], heights of fairlead and bollard over the water [m].
MASS, STRENGTH, FAIRLEAD, BOLLARD, GRAVITY = 40.0, 1300.0, 0.5, 18.0, 9.81
LIFT = f"""
format: 1
lift: {{title: A barge below a high quay}}
duration: 5 s
water: {{density: 1025 kg/m^3, level: 0 m}}
ropes:
  steel:
    {{axial_stiffness: 90 MN, damping_time: 50 ms, minimum_breaking_force: {STRENGTH} kN, mass: {MASS} kg/m}}
vessels:
  barge:
    position: [-30 m, 0 m]
    draft: 2.5 m
    hull: {{box: [60 m, 20 m, 5 m]}}
    masses: {{hull: {{mass: 3075 t, at: [30 m, 0 m, 3 m]}}}}
    radii_of_gyration: [7 m, 17 m, 17 m]
mooring_lines:
  fore:
    vessel: barge
    fairlead: [60 m, 0 m, 3 m]
    to: [130 m, 0 m, {BOLLARD} m]
    rope: steel
    pretension: 150 kN
  aft:
    vessel: barge
    fairlead: [0 m, 0 m, 3 m]
    to: [-130 m, 0 m, {BOLLARD} m]
    rope: steel
    pretension: 150 kN
plan:
  - {{step: wait, hold: until_end}}
limits: {{mooring_tension_of_breaking_force: 50 %}}
"""


@pytest.fixture(scope="module")
def run() -> Recording:
    return gantline.simulate(gantline.parse_scenario(LIFT))


def test_the_upper_end_bears_what_hangs_below(run: Recording) -> None:
    """T2 = T1 + w (z2 - z1) of a catenary; the barge floats within 10 mm of where the lift file has it."""
    pull = float(run.column("mooring_tension", "fore").max()) / 1e3
    upper = pull + MASS * GRAVITY * (BOLLARD - FAIRLEAD) / 1e3
    assert pull == pytest.approx(150.0, rel=1e-2)
    assert values_of(run, "mooring_tension_of_breaking_force")["fore"] == pytest.approx(
        upper / STRENGTH, rel=1e-4
    )
    assert values_of(run, "rope_factor_on_breaking_force")["mooring.fore"] == pytest.approx(
        STRENGTH / upper, rel=1e-4
    )


def test_a_line_of_nodes_tells_the_same(run: Recording) -> None:
    nodes = LIFT.replace("pretension: 150 kN", "pretension: 150 kN\n    type: distributed")
    other = gantline.simulate(gantline.parse_scenario(nodes))
    name = "mooring_tension_of_breaking_force"
    assert values_of(other, name)["fore"] == pytest.approx(values_of(run, name)["fore"], rel=2e-3)


def test_a_line_that_goes_down_has_it_at_its_fairlead() -> None:
    low = LIFT.replace(f"{BOLLARD} m]", "-3 m]")
    lower = gantline.simulate(gantline.parse_scenario(low))
    pull = float(lower["rope_peak_tension"].values.max()) / 1e3
    used = values_of(lower, "mooring_tension_of_breaking_force")
    assert max(used.values()) == pytest.approx(pull / STRENGTH, rel=1e-9)
