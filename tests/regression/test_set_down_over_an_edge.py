"""Of a load set down with its centre of gravity beyond the edge of its plinth nothing was said.

40 t come down on a plinth that ends 50 mm short of their centre of gravity, and are lowered on by 100 mm.
They lean in their slings by 1.7°, which bear 2.7 % of them, and tip over as these are taken off. A limit of
tilt of 5° allows it, slings that bear so little are far from theirs, and nothing else looked at it: a GO.
"""

from __future__ import annotations

import math

import pytest

from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from lift_text import changed
from of_recording import check_of, checks_of

#: Hook 8 m above the lugs, which are 2.4 m to either side of it and of the centre of gravity.
_REACH, _HEIGHT, _CENTRE, _LUGS = 2.4, 8.0, 1.5, 3.0
_EDGE = 0.05  # of the plinth, short of the centre of gravity [m]
_LENGTH = math.hypot(_REACH, 1.5, _HEIGHT)
_LIFT = f"""\
format: 1
lift: {{title: Set down on an edge}}
duration: 60 s
ground: {{friction: 0.5}}
structures:
  plinth: {{type: box, x: [-6 m, {-_EDGE} m], y: [-4 m, 4 m], z: [0 m, 3 m]}}
ropes:
  sling_44: {{construction: 6x36 IWRC, grade: 1960, diameter: 44 mm, damping_time: 10 ms, mass: none}}
load:
  name: module
  shape: {{box: [6 m, 4 m, {_LUGS} m]}}
  position: [0 m, 0 m, 3.3 m]
  weight: {{calculated: 40 t}}
  centre_of_gravity: {{at: [0 m, 0 m, {_CENTRE} m]}}
  lugs:
    A: {{at: [-{_REACH} m,  1.5 m, {_LUGS} m], capacity: 20 t}}
    B: {{at: [ {_REACH} m,  1.5 m, {_LUGS} m], capacity: 20 t}}
    C: {{at: [-{_REACH} m, -1.5 m, {_LUGS} m], capacity: 20 t}}
    D: {{at: [ {_REACH} m, -1.5 m, {_LUGS} m], capacity: 20 t}}
cranes:
  crane:
    type: fixed_hook
    at: [0 m, 0 m, {3.3 + _LUGS + _HEIGHT} m]
    rated_capacity: 60 t
    hoist: {{speed: 3 m/min, acceleration: 0.05 m/s^2}}
sling_defaults: {{length: {_LENGTH:.3f} m, rope: sling_44}}
slings:
  A: {{from: crane, to: module.A}}
  B: {{from: crane, to: module.B}}
  C: {{from: crane, to: module.C}}
  D: {{from: crane, to: module.D}}
plan:
  - {{step: look, hold: 6 s}}
  - {{step: lower, lower: crane, speed: 2 m/min, by: 0.4 m}}
  - {{step: hold, hold: 10 s}}
limits: {{load_tilt: 5 deg, sling_factor_on_breaking_force: 5}}
"""
_NAME = "stands_by_itself"


def _run(*changes: tuple[str, str]) -> Recording:
    return simulate(parse_scenario(changed(_LIFT, *changes), "lift.yaml"))


def test_it_leans_in_its_slings() -> None:
    """Moments about the edge, with θ the tilt, give the share that the slings carry.

    The centre of gravity is e cosθ + z_G sinθ beyond the edge. Of the slings that carry, the lugs are
    e + 2.4 m beyond the edge and 3 m above it as the load stands, at x and z turned by θ; their moment per
    share that they bear is x + z tanα, with tanα the horizontal over the vertical way from lug to hook.
    """
    recording = _run()
    check = check_of(recording, _NAME)
    assert check.element == "module"
    theta = float(recording.column("load_tilt", "module")[-1])
    lever = _EDGE * math.cos(theta) + _CENTRE * math.sin(theta)
    across, up = _EDGE + _REACH, _LUGS
    x = across * math.cos(theta) + up * math.sin(theta)
    z = up * math.cos(theta) - across * math.sin(theta)
    hook = (_EDGE, 3.3 + _LUGS + _HEIGHT - 0.4 - 3.0)
    share = lever / (x + z * (x - hook[0]) / (hook[1] - z))
    # Ground and plinth give by 0.2 mm, of 3 m of lever to the lugs; the load slides by less than 1 mm.
    assert float(recording.column("load_transferred", "module")[-1]) == pytest.approx(share, rel=0.01)
    assert f"{share * 100:.1f} % of its weight still hangs in its slings" in check.remark
    assert f"it has tilted by {math.degrees(theta):.2f} deg more since" in check.remark


def test_what_stands_is_not_told() -> None:
    """With the edge 0.2 m beyond the centre of gravity."""
    recording = _run((f"{-_EDGE} m]", "0.2 m]"))
    assert recording.column("load_transferred", "module")[-1] == pytest.approx(0.0, abs=1e-6)
    assert checks_of(recording, _NAME) == []


def test_what_comes_down_aslant_is_not_told() -> None:
    """Hung 0.1 m aside of its centre of gravity it comes down on an edge, and levels as it is lowered on."""
    recording = _run(("x: [-6 m, -0.05 m]", "x: [-6 m, 6 m]"), ("gravity: {at: [0 m", "gravity: {at: [0.2 m"))
    assert recording.column("load_tilt", "module").max() > math.radians(0.5)
    assert checks_of(recording, _NAME) == []


def test_what_is_hoisted_again_is_not_told() -> None:
    again = "  - {step: hold, hold: 10 s}\n"
    up = "  - {step: up, hoist: crane, speed: 2 m/min, by: 5 mm}\n"
    assert checks_of(_run((again, again + up)), _NAME) == []
