"""Gear that exists was warned of as a slip of units.

Bounds for what is a thousand times too strong were set by steel gear of big lifts. Chain as a rope kind was
told "one of both has a wrong unit", and many anchors hang in chain; shackles of fibre, lugs of a model in a
laboratory, clearances of a model, and a thin panel whose weight report has one margin for all directions
were told "a unit or digit has slipped". An engineer who reads that of right figures reads no further warning.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from gantline.assembly import assemble
from gantline.scenario import load_scenario

#: A studless chain of 76 mm has 19.9 t/m d² = 115 kg/m and one with studs 21.9 t/m d² = 126 kg/m (makers'
#: tables); R3 breaks at 0.0223 d² (44 - 0.08 d) kN with d in mm, 4884 kN (DNV-OS-E302).
CHAIN = {"axial_stiffness": "490 MN", "diameter": "76 mm", "minimum_breaking_force": "4884 kN"}
#: Chain of grade 80 for slings, 10 mm: 2.2 kg/m, breaks at 126 kN (EN 818-2).
GRADE_80 = {
    "axial_stiffness": "6 MN",
    "diameter": "10 mm",
    "mass": "2.2 kg/m",
    "minimum_breaking_force": "126 kN",
}
HMPE = {
    "axial_stiffness": "150 kN",
    "diameter": "2 mm",
    "mass": "0.0026 kg/m",
    "minimum_breaking_force": "4.8 kN",
}
#: A manifold at 1 to 20, in a laboratory.
MODEL = """
format: 1
lift: {title: Model of a manifold}
duration: 5 s
ground: {level: 0 m}
ropes:
  hmpe_2:
    axial_stiffness: 150 kN
    minimum_breaking_force: 4.8 kN
    diameter: 2 mm
    mass: 0.0026 kg/m
    damping_time: 10 ms
load:
  name: model
  shape: {box: [0.4 m, 0.3 m, 0.2 m]}
  weight: {calculated: 4 kg}
  centre_of_gravity: {at: [0 m, 0 m, 0.1 m]}
  lugs:
    A: {at: [ 0.18 m,  0.13 m, 0.2 m], main_plate: xz, capacity: CAPACITY}
    B: {at: [ 0.18 m, -0.13 m, 0.2 m], main_plate: xz, capacity: CAPACITY}
    C: {at: [-0.18 m,  0.13 m, 0.2 m], main_plate: xz, capacity: CAPACITY}
    D: {at: [-0.18 m, -0.13 m, 0.2 m], main_plate: xz, capacity: CAPACITY}
cranes:
  hook:
    type: fixed_hook
    at: [0 m, 0 m, 0.62 m]
    rated_capacity: 250 kg
    hoist: {speed: 0.6 m/min, acceleration: 0.02 m/s^2}
sling_defaults: {rope: hmpe_2}
slings:
  A: {from: hook, to: model.A, length: 0.477 m}
  B: {from: hook, to: model.B, length: 0.477 m}
  C: {from: hook, to: model.C, length: 0.477 m}
  D: {from: hook, to: model.D, length: 0.477 m}
plan:
  - {step: lift off, hoist: hook, speed: 0.3 m/min, until: {supports: clear}}
watch:
  - {between: [slings, model], smallest: KEPT, from_ends: 0.1 m}
"""


def _slips(lift: str | Path, changes: dict[str, Any]) -> list[str]:
    said = [one.sentence for one in assemble(load_scenario(lift).changed(changes)).doubts]
    return [one for one in said if "slipped" in one or "wrong unit" in one]


@pytest.mark.parametrize("mass", ["115 kg/m", "126 kg/m"])
def test_chain_of_anchors_is_no_slip(mass: str) -> None:
    assert _slips("floating_crane", {"ropes.moor_44": {**CHAIN, "mass": mass}}) == []


@pytest.mark.parametrize("rope", [GRADE_80, HMPE], ids=["grade 80", "HMPE of 2 mm"])
def test_thin_slings_are_no_slip(rope: dict[str, str]) -> None:
    assert _slips("upending", {"ropes.spare": rope}) == []


def test_chain_a_thousand_times_as_heavy_is_one() -> None:
    told = _slips("upending", {"ropes.spare": {**GRADE_80, "mass": "2200 kg/m"}})
    assert [one for one in told if "a bar of solid steel has 0.617 kg/m" in one], told


def test_a_shackle_of_fibre_is_no_slip() -> None:
    shackle = {
        "working_load_limit": "1.7 t",
        "mass": "0.03 kg",
        "bow_diameter": "12 mm",
        "pin_diameter": "12 mm",
    }
    assert _slips("upending", {"shackles.soft": shackle}) == []


@pytest.mark.parametrize(
    ("capacity", "kept", "told"),
    [
        ("0.5 t", "4 mm", []),  # shackles and eyes from the shop bear 125 times the model
        ("0.5 t", "0.3 mm", ["0.3 mm: that is no distance to keep"]),
        ("500 t", "4 mm", ["500 t: 125,000 times all of the load"] * 4),
    ],
)
def test_a_model_in_a_laboratory(tmp_path: Path, capacity: str, kept: str, told: list[str]) -> None:
    file = tmp_path / "model.yaml"
    file.write_text(MODEL.replace("CAPACITY", capacity).replace("KEPT", kept))
    said = _slips(file, {})
    assert [one.split(";")[0] for one in said] == told


def test_a_thin_panel_has_one_margin_for_all_directions() -> None:
    panel = {
        "load.shape.box": ["14 m", "12 m", "0.4 m"],
        "load.centre_of_gravity.at": ["0 m", "0 m", "0.2 m"],
        "load.centre_of_gravity.envelope": ["0.3 m", "0.3 m", "0.3 m"],
    }
    assert _slips("equalizer_yard", panel) == []
