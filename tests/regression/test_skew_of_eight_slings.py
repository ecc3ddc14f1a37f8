"""The rule's skew load factor of four slings, taken for eight under one hook.

0027/ND 5.6.12 has 1.25 for four slings in matched pairs, and 5.6.13 asks to calculate it for others. A tank
lid on eight slings of 0.25 % had 1.25 in a run without a word of that, while `gantline cases` finds 2.15 with
one sling short and its neighbour long.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

import pytest

import gantline
from gantline.checks import Check, Verdict, check_recording
from gantline.scenario import parse_scenario

SAID = "the rule has 1.25 for four slings in matched pairs, and {} share by their lengths below hook"


def lid(slings: int, rules: str) -> Check:
    """The check of the skew load factor of a lid that hangs from slings all alike, in a circle."""
    places = [(6 * math.cos(turn), 6 * math.sin(turn)) for turn in _turns(slings)]
    lugs = "".join(
        f"    L{n}: {{at: [{x} m, {y} m, 1 m], capacity: 20 t}}\n" for n, (x, y) in enumerate(places)
    )
    hung = "".join(f"  S{n}: {{from: hook, to: lid.L{n}, length: 11 m, rope: s26}}\n" for n in range(slings))
    text = f"""\
format: 1
lift: {{title: A lid}}
duration: 10 s
ropes: {{s26: {{axial_stiffness: 31 MN, mass: none, damping_time: 50 ms, minimum_breaking_force: 472 kN}}}}
load:
  name: lid
  shape: {{box: [14 m, 14 m, 1 m]}}
  position: [0 m, 0 m, 2 m]
  weight: {{calculated: 36 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 0.5 m]}}
  lugs:
{lugs}cranes: {{hook: {{type: fixed_hook, at: [0 m, 0 m, 12.22 m], rated_capacity: 63 t,
  hoist: {{speed: 3 m/min, acceleration: 0.05 m/s^2}}}}}}
slings:
{hung}plan: [{{step: hold, hold: until_end}}]
rules: {rules}
"""
    found: Mapping[str, Check] = {
        one.name: one for one in check_recording(gantline.simulate(parse_scenario(text)))
    }
    return found["skew_load_factor"]


def _turns(slings: int) -> list[float]:
    return [2 * math.pi * (n + 0.5) / slings for n in range(slings)]


@pytest.mark.parametrize("slings", [5, 8])
def test_more_than_four_slings_are_told(slings: int) -> None:
    check = lid(slings, "{preset: nd_0027_onshore}")
    assert check.verdict is Verdict.WARNING
    assert SAID.format(slings) in check.remark


@pytest.mark.parametrize(
    ("slings", "rules"),
    [(4, "{preset: nd_0027_onshore}"), (8, "{preset: nd_0027_onshore, skew_load_factor: 2.2}")],
)
def test_four_slings_and_a_factor_of_ones_own_are_not(slings: int, rules: str) -> None:
    check = lid(slings, rules)
    assert (check.verdict, check.remark) == (Verdict.NOT_CHECKED, "")
