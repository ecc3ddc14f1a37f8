"""Units of joints in a table.

Each column of a table has one unit, but positions of joints were all headed `[m or rad]`: who opened the
table of a crane that slews and travels could not tell which column was an angle.
"""

from __future__ import annotations

import pytest

from gantline.export.tables import columns
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate

LIFT = """
format: 1
lift: {title: Joints}
duration: 0.1 s
ropes: {fall: {axial_stiffness: 10 MN}}
mechanics:
  bodies:
    gate: {joint: {type: hinge, axis: [0, 0, 1], velocity: 0.2 rad/s}, mass: 2 t,
      centre_of_gravity: [1 m, 0 m, 0 m]}
    sledge: {at: [9 m, 0 m, 0 m], joint: {type: slider, axis: [1, 0, 0], velocity: 0.5 m/s}, mass: 1 t}
    load: {at: [20 m, 0 m, -5 m], joint: {type: slider, axis: [0, 0, 1]}, mass: 1 t}
  drums: {winch: {diameter: 0.4 m, rotating_mass: 200 kg, brake: 20 kN}}
  ropes:
    fall:
      rope: fall
      length: as_routed
      route: [{type: end, body: load}, {type: end, body: world, at: [20 m, 0 m, 0 m], drum: winch}]
"""


@pytest.fixture(scope="module")
def run() -> Recording:
    return simulate(parse_scenario(LIFT))


def test_each_joint_has_its_own_unit(run: Recording) -> None:
    """A hinge turns; a slider moves, and of a drum it is rope. They go 0.2 rad/s and 0.5 m/s for 0.1 s."""
    last = {name: float(values[-1]) for name, values in columns(run, ["joint_position"])}
    assert set(last) == {
        "time [s]",
        "joint_position.gate [rad]",
        "joint_position.sledge [m]",
        "joint_position.load [m]",
        "joint_position.winch [m]",
    }
    assert last["joint_position.gate [rad]"] == pytest.approx(0.02, rel=1e-9)
    assert last["joint_position.sledge [m]"] == pytest.approx(0.05, rel=1e-9)


def test_a_recording_that_does_not_say_which_turn(run: Recording) -> None:
    """Those of older versions do not."""
    rig = {key: value for key, value in run.attributes["rig"].items() if key != "turning"}
    older = Recording(run.variables, run.coordinates, {**run.attributes, "rig": rig})
    assert "joint_position.gate [m or rad]" in dict(columns(older, ["joint_position"]))
