"""Ropes over eyes were held against their breaking force as if nothing bent them.

A pipe of 16 t in two baskets of 16 mm came to 69 % of the breaking force with all factors of 0027/ND,
straight with steel ferrules, and the lift was a GO. About an edge of the rope's own diameter bending takes
half of its strength: with 2.0 in place of 1.12 that would be 123 %. So it was with the ropes of luffing
tackles, whose sheaves are eyes here.
A guide that says its diameter was right: `type: sheave`, with (K5).
"""

from __future__ import annotations

import pytest

import gantline
from boom_lift import PRESCRIBED, boom_lift
from gantline.checks import Check, Verdict, check_recording, verdict_of
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from of_recording import check_of

RULES = "rules: {preset: nd_0027_onshore, termination_factor: 1.12}\n"
EYES = "{type: eye, body: pipe, at: [0 m, 0.5 m, 0.1 m]}, {type: eye, body: pipe, at: [0 m, -0.5 m, 0.1 m]}"
#: Two bars of 160 mm under the pipe, D/d = 10; the rope runs round below them towards -y.
SHEAVES = """{type: sheave, body: pipe, at: [0 m, 0.5 m, 0.2 m], axis: [-1, 0, 0], diameter: 160 mm},
  {type: sheave, body: pipe, at: [0 m, -0.5 m, 0.2 m], axis: [-1, 0, 0], diameter: 160 mm}"""


def basket(over: str, rules: str = RULES) -> str:
    """8 t in one basket about its middle, plumb below the hook."""
    return f"""\
format: 1
lift: {{title: A pipe in a basket}}
duration: 30 s
start: rest
ropes: {{r: {{construction: 6x36 IWRC, grade: 1960, diameter: 16 mm, damping_time: 20 ms}}}}
load:
  name: pipe
  shape: {{box: [2 m, 1 m, 1 m]}}
  weight: {{calculated: 8 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 0.4 m]}}
  position: [0 m, 0 m, 3 m]
cranes:
  hook: {{type: fixed_hook, at: [0 m, 0 m, 8.3 m], hoist: {{speed: 3 m/min, acceleration: 0.05 m/s^2}}}}
mechanics:
  ropes:
    basket: {{rope: r, length: as_routed,
      route: [{{type: end, body: hook}}, {over}, {{type: end, body: hook}}]}}
plan: [{{step: hold, hold: until_end}}]
{rules}"""


def held(recording: Recording) -> Check:
    return check_of(recording, "rope_load_of_breaking_force")


def run(text: str) -> Recording:
    return gantline.simulate(parse_scenario(text))


def test_a_basket_over_an_edge_is_no_go_without_a_word() -> None:
    found = run(basket(EYES))
    check = held(found)
    assert check.verdict is Verdict.WARNING
    assert "whose diameter is not known: basket" in check.remark and "takes half" in check.remark
    assert verdict_of(check_recording(found)).startswith("GO WITH WARNINGS")


def test_a_basket_over_bars_has_their_bending_factor() -> None:
    """1.3 x 1.3 x 1.5, least safety 2.3, times 1/(1 - 0.5/sqrt(10)) = 1.188."""
    check = held(run(basket(SHEAVES)))
    assert check.verdict is Verdict.OK
    assert "bending 1.188" in check.formula


def test_what_has_no_factors_is_not_warned_of() -> None:
    check = held(run(basket(EYES, "")))
    assert check.verdict is Verdict.NOT_CHECKED
    assert "takes half" not in check.remark


@pytest.mark.parametrize("sheave", ["", "sheave_diameter: 1.44 m, "])
def test_luffing_tackles_bend_about_their_sheaves(sheave: str) -> None:
    """Ropes of 72 mm about 1.44 m: 1/(1 - 0.5/sqrt(20)) = 1.126; without a diameter it is not known."""
    tackles = f"{PRESCRIBED}, tackles: {{count: 4, parts: 16, rope: luff, {sheave}from: [70 m, 8 m, 62 m]}}"
    check = held(run(boom_lift(luffing=tackles, more=RULES)))
    if sheave:
        assert "bending 1.126" in check.formula
        return
    assert check.verdict is Verdict.WARNING
    assert "luff.fc.1, luff.fc.2" in check.remark and "'sheave_diameter'" in check.remark
