"""A load that was lowered through the surface as if there were no water.

Hulls of vessels and of bodies of `mechanics` displace water, a load has no hull: a module that would float
went down to the sea bed with all of its weight in the hook, without a word. Then it was told once its centre
of gravity was under, when water would have carried all of it, and only where a vessel was about.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.scenario import parse_scenario

LIFT = """\
format: 1
lift: {title: a module is lowered beside a barge}
duration: 60 s
ground: {level: -30 m}
ropes:
  sling: {axial_stiffness: 100 MN, damping_time: 10 ms}
load:
  name: module
  shape: {box: [4 m, 4 m, 3 m]}
  position: [60 m, 0 m, 2 m]
  weight: {calculated: 20 t}
  centre_of_gravity: {at: [0 m, 0 m, 1.5 m]}
  lugs:
    A: {at: [0 m, 0 m, 3 m]}
vessels:
  barge:
    draft: 2 m
    hull: {box: [40 m, 12 m, 4 m]}
    masses:
      hull: {mass: 984 t, at: [20 m, 0 m, 2 m]}
    radii_of_gyration: [4 m, 11 m, 11 m]
cranes:
  hook: {type: fixed_hook, at: [60 m, 0 m, 10 m], hoist: {speed: 12 m/min, acceleration: 0.1 m/s^2}}
slings:
  A: {from: hook, to: module.A, length: 5 m, rope: sling}
plan:
  - {step: lower, lower: hook, speed: 12 m/min, by: LOWERED}
  - {step: hold, hold: until_end}
"""


#: The same off a quay, with no vessel anywhere.
ASHORE = LIFT[: LIFT.index("vessels:")] + "water: {density: 1000 kg/m^3}\n" + LIFT[LIFT.index("cranes:") :]


def told(text: str, lowered: str) -> list[str]:
    recording = gantline.simulate(parse_scenario(text.replace("LOWERED", lowered)))
    return [one for one in recording.attributes["warnings"] if "module goes into the water" in one]


@pytest.mark.parametrize(("text", "density"), [(LIFT, 1025.0), (ASHORE, 1000.0)], ids=["afloat", "ashore"])
@pytest.mark.parametrize(("lowered", "depth"), [("1.9 m", 0.0), ("3 m", 1.0), ("6 m", 4.0)])
def test_it_is_told_once_it_goes_under(text: str, density: float, lowered: str, depth: float) -> None:
    found = told(text, lowered)
    assert bool(found) is (depth > 0.0)
    if found:
        # From 2 m above the water, less what the sling stretches: 0.2 m/s, reached in 2 s, so 1 s later than
        # at once; told is the first sample 10 mm deep, 20 ms apart.
        stretched = 20e3 * 9.81 * 5.0 / 100e6
        exact = (2.0 + 0.01 - stretched) / 0.2 + 1.0
        when = float(found[0].split(" at ")[1].split(" s")[0])
        assert exact - 1e-6 <= when <= exact + 0.021
        deep, heavy = (float(found[0].split(words)[1].split(" ")[0]) for words in ("up to ", "carry up to "))
        assert deep == pytest.approx(depth + stretched, abs=6e-3)  # as printed
        # A box of 4 x 4 m, 3 m high.
        carried = density * 16.0 * min(depth + stretched, 3.0) / 1e3
        assert heavy == pytest.approx(carried, abs=0.06)  # as printed


def test_on_dry_land_there_is_nothing_to_go_into() -> None:
    assert told(ASHORE.replace("water: {density: 1000 kg/m^3}\n", ""), "6 m") == []
