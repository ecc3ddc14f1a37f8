"""`--plumb` of a lift with a hook whose slings are slack.

The side pull on it was nothing over nothing: two warnings of numpy and "SVD did not converge" stood where the
slack sling belongs. A tail crane that has handed over its load is such a hook.
"""

from __future__ import annotations

import warnings

import pytest

from gantline.scenario import parse_scenario
from gantline.study import CannotBeError, plumb_hooks

LIFT = """\
format: 1
lift: {title: A hook too many}
duration: 10 s
ropes: {sling: {axial_stiffness: 200 MN}}
cranes:
  main: {type: fixed_hook, at: [0.2 m, 0 m, 20 m], hoist: {speed: 1 m/min, acceleration: 0.01 m/s^2}}
  tail: {type: fixed_hook, at: [3 m, 0 m, 10 m], hoist: {speed: 1 m/min, acceleration: 0.01 m/s^2}}
load:
  name: load
  shape: {box: [8 m, 3 m, 2 m]}
  position: [0 m, 0 m, 8 m]
  weight: {calculated: 20 t}
  centre_of_gravity: {at: [0 m, 0 m, 1 m]}
  lugs: {A: {at: [-3 m, 0 m, 2 m]}, B: {at: [3 m, 0 m, 2 m]}}
sling_defaults: {rope: sling}
slings:
  A: {from: main, to: load.A, length: 10.45 m}
  B: {from: main, to: load.B, length: 10.4 m}
  T: {from: tail, to: load.B, length: 3 m}
plan: [{step: rest, hold: until_end}]
"""


def test_the_slack_sling_is_named() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(CannotBeError, match=r"T would be slack|slack: T"):
            plumb_hooks(parse_scenario(LIFT))
