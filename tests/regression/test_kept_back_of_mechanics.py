"""What a rule keeps back of several cranes, where one of them bears the load by ropes of `mechanics`.

Cranes counted by their slings alone. Two hooks of 90 t bore 80 t each, one by a sling and one by a rope of
`mechanics`, or by a bar with ropes on it: 89 %, GO, where the rule that the lift file names asks for 1.2
times that: 107 %. Nobody was told either that a tag line bears a load, of which no hook and no lug knows.
"""

from __future__ import annotations

import pytest

from gantline.checks import Check, Verdict, check_recording
from gantline.checks.ratings import kept_back
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.statics import Statics
from hooked_lift import hooked_lift
from of_recording import check_of

#: Factor of the Queensland code for two cranes, share of each, rated capacity [t].
KEPT, SHARE, RATED = 1.2, 80.0, 90.0
HOOKS = {"A": (-1.0, 0.0, 9.0), "B": (1.0, 0.0, 9.0)}
LUGS = {"A": (-1.0, 0.0, 4.0), "B": (1.0, 0.0, 4.0)}
SLINGS = {"A": ("A", "A", 5.0)}
RULE = "rules: {several_cranes: queensland}\n"
#: From hook B to where lug B is, counted from the centre of gravity.
ROPE = """\
mechanics:
  ropes:
    B: {rope: kind, length: 5 m, route: [{type: end, body: B}, {type: end, body: load, at: [1 m, 0 m, 2 m]}]}
"""
BAR = """\
mechanics:
  bodies:
    bar: {at: [1 m, 0 m, 6.5 m], joint: {type: point}, mass: 1 kg}
  ropes:
    B1: {rope: kind, length: 2.5 m, route: [{type: end, body: bar}, {type: end, body: B}]}
    B2: {rope: kind, length: 2.5 m, route: [{type: end, body: bar}, {type: end, body: load, at: [1 m, 0 m, 2 m]}]}
"""  # noqa: E501
#: Something of its own in the second hook, which the load does not know of.
BESIDE = """\
mechanics:
  bodies:
    weight: {at: [1 m, 0 m, 7 m], joint: {type: point}, mass: 80 t}
  ropes:
    B: {rope: kind, length: 2 m, route: [{type: end, body: B}, {type: end, body: weight}]}
"""


def at_rest(more: str, *, slings: dict[str, tuple[str, str, float]] = SLINGS) -> Recording:
    """160 t in two hooks of 90 t."""
    text = hooked_lift(HOOKS, LUGS, slings, mass=160e3, more=more)
    lift = text.replace("type: fixed_hook", "type: fixed_hook, rated_capacity: 90 t")
    return Statics(parse_scenario(lift)).equilibrium().recording


def rated(recording: Recording) -> Check:
    return check_of(recording, "hoist_load_of_rated_capacity")


@pytest.mark.parametrize("more", [ROPE, BAR], ids=["a rope", "a bar"])
@pytest.mark.parametrize(
    ("rule", "factor"), [(RULE, KEPT), ("rules: {several_cranes_factor: 1.15}\n", 1.15), ("", 1.0)]
)
def test_a_crane_that_bears_the_load_by_mechanics_is_one(more: str, rule: str, factor: float) -> None:
    """(RA1): f x 80 t over 90 t; of both, for each bears half of the load by moments."""
    recording = at_rest(rule + more)
    found = rated(recording)
    assert found.value == pytest.approx(factor * SHARE / RATED, rel=1e-4)  # and 1 kg of the bar
    assert (found.verdict is Verdict.FAILED) is (factor * SHARE > RATED)
    assert [kept_back(recording, crane)[0] for crane in HOOKS] == [factor, factor]


def test_a_crane_that_bears_something_else_is_none() -> None:
    """A lifts the load alone: 160 t on 90 t, nothing kept back; nor of B with its own 80 t."""
    centred = {"A": ("A", "A", 5.0), "A2": ("A", "B", 5.4)}
    recording = at_rest(RULE + BESIDE, slings=centred)
    assert "several_cranes_factor" not in recording.rig.factors
    assert [kept_back(recording, crane)[0] for crane in HOOKS] == [1.0, 1.0]


def test_a_group_of_fixed_hooks_is_one_crane_of_mechanics_too() -> None:
    """A Goliath crane of two hooks lifts alone."""
    group = "hook_groups: {goliath: {type: crane, hooks: [A, B], rated_capacity: 200 t}}\n"
    assert rated(at_rest(RULE + group + ROPE)).value == pytest.approx(SHARE / RATED, rel=1e-4)


def test_a_tag_line_that_bears_the_load_is_told() -> None:
    """A line from 5 m over the load in place of the second sling bears half of its weight."""
    tag = "tag_lines: {up: {at: [1 m, 0 m, 4 m], to: [1 m, 0 m, 9 m], rope: kind, length: 5 m}}\n"
    recording = at_rest(RULE + tag)
    checks = {one.name: one for one in check_recording(recording)}
    assert "carries load as a tag line, which has no lug: tag.up" in checks["lug_load_of_capacity"].remark
    told = checks["tag_lines_bear_nothing"]
    assert (told.verdict, told.element) == (Verdict.WARNING, "up")
    assert told.remark == "it pulls with up to 50 % of the weight of load, which no hook and no lug knows of"


def test_a_tag_line_that_holds_a_heading_is_not() -> None:
    """5 kN of 160 t are 0.3 %."""
    both = {**SLINGS, "B": ("B", "B", 5.0)}
    tag = "tag_lines: {aside: {at: [1 m, 3 m, 2 m], to: [1 m, 30 m, 2 m], rope: kind, pull: 5 kN}}\n"
    checks = check_recording(at_rest(RULE + tag, slings=both))
    assert "tag_lines_bear_nothing" not in {one.name for one in checks}
    [lugs] = [one for one in checks if one.name == "lug_load_of_capacity"]
    assert "tag." not in lugs.remark
