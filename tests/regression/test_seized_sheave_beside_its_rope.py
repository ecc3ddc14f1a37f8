"""A rope that does not lie on a sheave that is seized, at the start.

Such a sheave holds any tension but for its groove, in which the rope on it slips: with none on it `gantline
check` said "Out of range float values are not JSON compliant", without a line. So it was where `axis` had the
rope run the wrong way about, and of a wrap of more than 270°, which cannot be told from that.
"""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import gantline
from gantline.scenario import ScenarioError

LIFT = """\
format: 1
lift: {{title: Over a bar}}
duration: 1 s
ropes:
  yarn: {{axial_stiffness: 2 kN, mass: 0.001 kg/m}}
mechanics:
  bodies:
    weight: {{at: [-50 mm, 0 m, -0.4 m], joint: {{type: slider, axis: [0, 0, 1]}}, mass: 0.8 kg}}
    bar: {{joint: {{type: fixed}}}}
  ropes:
    over:
      rope: yarn
      length: as_routed
      route:
        - {{type: end, body: weight}}
        - {{type: sheave, body: bar, axis: [0, {sense}, 0], diameter: 100 mm, {losses}}}
        - {{type: end, body: world, at: [{x} m, 0 m, {z} m]}}
"""
SEIZED = "bearing: seized, groove_friction: 0.2"


def over(tmp_path: Path, wrap: float, losses: str, sense: int = 1) -> Path:
    """A weight plumb under the left side of a bar, its rope on along a tangent after a wrap [rad]."""
    x, z = (-0.05 * math.cos(wrap) + 0.4 * math.sin(wrap), 0.05 * math.sin(wrap) + 0.4 * math.cos(wrap))
    path = tmp_path / "lift.yaml"
    path.write_text(LIFT.format(sense=sense, losses=losses, x=x, z=z), encoding="utf-8")
    return path


@pytest.mark.parametrize("losses", [SEIZED, "bearing: roller, rotating_mass: 10 g"])
@pytest.mark.parametrize(("degrees", "sense"), [(280, 1), (60, -1)], ids=["too far round", "the other way"])
def test_it_is_told_with_its_place(tmp_path: Path, losses: str, degrees: float, sense: int) -> None:
    with pytest.raises(ScenarioError) as told:
        gantline.Simulation(over(tmp_path, math.radians(degrees), losses, sense))
    assert str(told.value).endswith(
        "lift.yaml:16: mechanics.ropes.over.route[2]: the rope does not lie on this sheave at the start, as "
        "on one with losses or inertia it has to; turn 'axis' round if it runs the other way (more than 270° "
        "cannot be said)"
    )


@pytest.mark.parametrize("degrees", [1, 60, 265])
def test_a_rope_that_lies_on_it_runs(tmp_path: Path, degrees: float) -> None:
    """As it did."""
    run = gantline.simulate(over(tmp_path, math.radians(degrees), SEIZED))
    assert run.attributes["status"] == "done"
