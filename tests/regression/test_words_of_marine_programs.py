"""Keys that engineers bring from programs for lines at sea were answered by a guess or a list of keys.

`motion` of a vessel was answered by "did you mean 'position'?", `raos` by a list, `vessel` of a fixed hook by
`rated_capacity` and others, and `EA` of a sling by keys of slings, though each has an answer of its own.
"""

from __future__ import annotations

import pytest

import gantline

LIFT = """\
format: 1
lift: {title: In words of elsewhere}
duration: 10 s
ropes:
  sling: {axial_stiffness: 100 MN, mass: 10 kg/m, damping_time: 10 ms}
water: {density: 1025 kg/m^3}
waves:
  sea: {significant_height: 1 m, peak_period: 8 s, direction: 180 deg}
vessels:
  barge:
    draft: 3 m
    hull: {box: [90 m, 30 m, 6.5 m]}
    masses: {all: {mass: 8500 t, at: [45 m, 0 m, 3 m]}}
    radii_of_gyration: [10 m, 26 m, 27 m]
load:
  name: module
  shape: {box: [6 m, 4 m, 3 m]}
  weight: {calculated: 40 t}
  centre_of_gravity: {at: [0 m, 0 m, 1.5 m]}
  lugs: {A: {at: [0 m, 0 m, 3 m]}}
cranes:
  crane: {type: fixed_hook, at: [0 m, 0 m, 11 m], hoist: {speed: 3 m/min, acceleration: 0.05 m/s^2}}
slings:
  A: {from: crane, to: module.A, length: 8 m, rope: sling}
plan:
  - {step: hold, hold: until_end}
"""


@pytest.mark.parametrize(
    ("old", "key", "said"),
    [
        ("draft: 3 m", "raos: vessel.csv", "RAOs of displacement stand in 'wave_motion: {raos: vessel.csv"),
        ("draft: 3 m", "motion: {heave: 1 m}", "'wave_forces' and 'radiation' name a hydrodynamic database"),
        ("type: fixed_hook", "vessel: barge", "a crane of 'type: floating_crane' is on a vessel"),
        ("rope: sling}", "EA: 100 MN", "it belongs to a kind of rope under 'ropes'"),
        ("axial_stiffness: 100 MN", "drag: 1.2", "neither water nor wind drags at ropes here"),
        ("axial_stiffness: 100 MN", "EI: 1 kN m^2", "ropes bend without resistance here"),
        ("peak_period: 8 s", "type: jonswap", "a sea has the spectrum of JONSWAP"),
    ],
)
def test_a_key_from_elsewhere_is_answered(old: str, key: str, said: str) -> None:
    assert gantline.parse_scenario(LIFT).load is not None
    between = "\n    " if old == "draft: 3 m" else ", "
    with pytest.raises(gantline.ScenarioError) as refused:
        gantline.parse_scenario(LIFT.replace(old, f"{key}{between}{old}"))
    name = key.partition(":")[0]
    assert f"'{name}' is not a key of" in str(refused.value)
    assert said in str(refused.value)
