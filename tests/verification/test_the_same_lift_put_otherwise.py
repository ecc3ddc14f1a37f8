"""One lift put in other words: what does not change it changes no number of it.

Other names, another order, JSON in place of YAML and ropes in a library are the same lift. So is one with a
limit more, with a crane that stands idle far away, and with the height `to` which its hook goes in place of
the way `by` which it goes there, and one that waits before its first step. Two ropes side by side or in
series are one.
"""

from __future__ import annotations

import json
import math
import random
import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import yaml

import gantline
from gantline.checks import check_recording
from gantline.results.recording import Recording
from gantline.scenario import load_scenario, parse_scenario
from mechanics import G

LIFT = """
format: 1
lift: {title: Askew}
duration: 12 s
ground: {level: 0 m, friction: 0.4, stiffness: 300 MN/m, damping: 3 MN s/m}
ropes:
  s52: {axial_stiffness: 150 MN, damping_time: 15 ms, mass: 11.2 kg/m, minimum_breaking_force: 1890 kN,
    diameter: 52 mm}
shackles:
  wb55: {working_load_limit: 55 t, mass: 27 kg, bow_diameter: 95 mm, pin_diameter: 57 mm}
load:
  name: m1
  shape: {box: [12 m, 6 m, 5 m]}
  weight: {calculated: 88 t, contingency: 1.07}
  centre_of_gravity: {at: [0.4 m, -0.25 m, 2.1 m]}
  stands_on: ground
  lugs:
    L1: {at: [5 m, 2.5 m, 5 m], main_plate: xz, capacity: 40 t}
    L2: {at: [5 m, -2.5 m, 5 m], main_plate: xz, capacity: 40 t}
    L3: {at: [-5 m, -2.5 m, 5 m], main_plate: xz, capacity: 40 t}
    L4: {at: [-5 m, 2.5 m, 5 m], main_plate: xz, capacity: 40 t}
cranes:
  k1: {type: fixed_hook, at: [0.3 m, 0 m, 13.75 m], rated_capacity: 120 t, hook_block_mass: 4.2 t,
    hoist: {speed: 6 m/min, acceleration: 0.15 m/s^2}}
sling_defaults: {rope: s52, shackles: {top: wb55, bottom: wb55}}
slings:
  S1: {from: k1, to: m1.L1, length: 10.62 m}
  S2: {from: k1, to: m1.L2, length: 10.625 m}
  S3: {from: k1, to: m1.L3, length: 10.62 m}
  S4: {from: k1, to: m1.L4, length: 10.635 m}
plan:
  - {step: t1, hoist: k1, speed: 5 m/min, by: 0.75 m}
  - {step: t2, hold: until_end}
limits: {rule: a yard, load_tilt: 5 deg, static_hook_load: 1200 kN, sling_factor_on_breaking_force: 4}
"""
NAMES = {
    "m1": "Zug", "k1": "b-7", "s52": "A_rope", "wb55": "zz", "t1": "Wait for it", "t2": "Away",
    "S1": "S4.x", "S2": "q", "S3": "S1.x", "S4": "aa", "L1": "n.4", "L2": "n.3", "L3": "n.2", "L4": "n.1",
}  # fmt: skip
MEASURED = ("time", "rope_tension", "body_position", "hook_load", "load_tilt", "contact_force", "event_time")
IDLE = (
    "  idle: {type: fixed_hook, at: [300 m, 20 m, 20 m], rated_capacity: 50 t, hook_block_mass: 1 t,\n"
    "    hoist: {speed: 6 m/min, acceleration: 0.1 m/s^2}}\n"
)


def simulated(text: str) -> Recording:
    return gantline.simulate(parse_scenario(text))


@pytest.fixture(scope="module")
def base() -> Recording:
    return simulated(LIFT)


def verdicts(recording: Recording) -> list[tuple[Any, ...]]:
    """Of all checks, in order: name, element, verdict, value, sentences; but warnings, which name lines."""
    return [
        (one.name, one.element, one.verdict, one.value, one.formula, one.remark)
        for one in check_recording(recording)
        if one.name != "no_warnings"
    ]


def assert_same(found: Recording, base: Recording, names: Sequence[str] = MEASURED) -> None:
    """To the last digit."""
    for name in names:
        np.testing.assert_array_equal(found[name].values, base[name].values, err_msg=name)


@pytest.mark.parametrize(
    ("was", "words"),
    [
        ("load_tilt: 5 deg", "load_tilt: 0.01 deg, hook_dynamic_factor: 1.0, tension_spread_when_clear: 1 %"),
        ("by: 0.75 m", "to: 14.5 m"),
        ("s52:", "other: {inextensible: true}\n  s52:"),
    ],
    ids=["limits", "to", "a rope that nobody uses"],
)
def test_what_changes_no_motion(was: str, words: str, base: Recording) -> None:
    """Limits are looked at after a run; 13.75 m and 0.75 m are 14.5 m, in binary too."""
    assert was in LIFT
    assert_same(simulated(LIFT.replace(was, words, 1)), base)


def test_a_step_that_waits_before_all_others(base: Recording) -> None:
    """Nothing happens at rest while a lift waits for 4 s: all is as much later. It waits by steps of its own,
    so those of what follows are others, within the tolerance of the run; equilibria are the same to rounding.
    """
    wait, late = LIFT.replace("plan:", "plan:\n  - {step: wait, hold: 4 s}"), 4.0
    wait = wait.replace("duration: 12 s", "duration: 16 s")
    found = simulated(wait)
    first = int(np.searchsorted(found.time, late - 1e-9))
    largest = base["rope_tension"].values.max()
    tolerance = base.attributes["settings"]["integrator"]["tension_tolerance"]
    assert len(found.time) - first == len(base.time)
    assert np.abs(found["rope_tension"].values[first:] - base["rope_tension"].values).max() < tolerance
    events = [event for event in found.events() if event[0] > 0.0 and event[2] != "wait"]
    assert [event[1:] for event in events] == [event[1:] for event in base.events()]
    for time in (0.0, 6.0, 12.0):
        was = gantline.Statics(parse_scenario(LIFT)).equilibrium(time).recording["rope_tension"].values[-1]
        later = gantline.Statics(parse_scenario(wait)).equilibrium(time + late).recording
        np.testing.assert_allclose(later["rope_tension"].values[-1], was, atol=1e-11 * largest)


def test_an_idle_crane_far_away(base: Recording) -> None:
    """A crane without slings holds nothing: all of the other one and of the load is the same."""
    found = simulated(LIFT.replace("sling_defaults:", IDLE + "sling_defaults:"))
    assert_same(found, base, ("time", "rope_tension", "load_tilt", "contact_force", "event_time"))
    for name in ("k1", "m1"):
        np.testing.assert_array_equal(found.column("body_position", name), base.column("body_position", name))


def renamed(text: str) -> str:
    """Each name of the lift in other words."""
    return re.sub(rf"\b({'|'.join(NAMES)})\b", lambda found: NAMES[found[0]], text)


def test_other_names(base: Recording) -> None:
    """Each thing by another name, some of them with dots or spaces, and in another order of the alphabet: all
    numbers, events and sentences are the same but for the names in them.
    """
    found = simulated(renamed(LIFT))
    assert_same(found, base)
    assert [event[1:] for event in found.events()] == [
        (kind, renamed(name)) for _, kind, name in base.events()
    ]
    assert verdicts(found) == [
        (name, renamed(element), verdict, value, renamed(formula), renamed(remark))
        for name, element, verdict, value, formula, remark in verdicts(base)
    ]


def shuffled(node: Any, draw: random.Random) -> Any:
    """A document with the keys of each mapping in an order drawn by lot; the plan is a list and stays."""
    if isinstance(node, dict):
        return {key: shuffled(node[key], draw) for key in draw.sample(list(node), len(node))}
    return [shuffled(one, draw) for one in node] if isinstance(node, list) else node


def test_lines_json_and_a_library(base: Recording, tmp_path: Path) -> None:
    """YAML with a line for each key, JSON, which is YAML too, and gear in libraries: the same digits."""
    tree = yaml.safe_load(LIFT)
    assert_same(simulated(yaml.safe_dump(tree, sort_keys=False, default_flow_style=False)), base)
    assert_same(simulated(json.dumps(tree)), base)
    for key in ("ropes", "shackles"):
        (tmp_path / f"{key}.yaml").write_text(json.dumps({"format": 1, key: tree.pop(key)}))
    (tmp_path / "lift.yaml").write_text(json.dumps({**tree, "library": ["ropes.yaml", "shackles.yaml"]}))
    found = gantline.simulate(load_scenario(tmp_path / "lift.yaml"))
    assert_same(found, base)
    assert verdicts(found) == verdicts(base)


@pytest.mark.parametrize("seed", [1, 2])
def test_another_order(seed: int, base: Recording) -> None:
    """Slings and lugs in another order are summed and eliminated in another one. Rounding of a place is
    1e-15 m, 1e-14 of the tension of a sling of 14 MN/m in each step; friction and slack make more of it in
    six hundred steps, as in other units (`test_other_units_and_scales.py`): the same 1e-6.
    """
    tree = shuffled(yaml.safe_load(LIFT), random.Random(seed))
    found = simulated(json.dumps({"format": tree.pop("format"), **tree}))
    for rope in base.coordinates["rope"]:
        was, is_now = base.column("rope_tension", rope), found.column("rope_tension", rope)
        assert np.abs(is_now - was).max() < 1e-6 * base["rope_tension"].values.max()
    was_checked = {(name, verdict) for name, _, verdict, *_ in verdicts(base)}
    assert {(name, verdict) for name, _, verdict, *_ in verdicts(found)} == was_checked


#: A weight that is let go on a rope just taut: it bobs with ω² = EA/(L m) about a stretch of m g L/EA.
MASS, LENGTH, EA = 5000.0, 10.0, 8e6
SHACKLE = 0.5
HEAD = f"""
format: 1
lift: {{title: A weight let go}}
duration: 2 s
start: as_given
ropes:
  whole: {{axial_stiffness: {EA} N, damping_time: 2 ms, mass: none}}
  half: {{axial_stiffness: {EA / 2} N, damping_time: 2 ms, mass: none}}
simulation: {{tension_tolerance: 1 N, position_tolerance: 0.001 mm}}
mechanics:
  bodies:
    weight: {{at: [0 m, 0 m, -{LENGTH} m], joint: {{type: slider, axis: [0, 0, 1]}}, mass: {MASS} kg}}
"""
TOP, LOW = "{type: end, body: world, at: [0 m, 0 m, 0 m]}", "{type: end, body: weight}"
ONE = HEAD + f"  ropes: {{a: {{rope: whole, length: {LENGTH} m, route: [{TOP}, {LOW}]}}}}\n"
SIDE_BY_SIDE = (
    HEAD
    + "  ropes:\n"
    + "".join(f"    {name}: {{rope: half, length: {LENGTH} m, route: [{TOP}, {LOW}]}}\n" for name in "ab")
)
IN_SERIES = HEAD + (
    f"    shackle: {{at: [0 m, 0 m, -{LENGTH / 2} m], joint: {{type: slider, axis: [0, 0, 1]}}, "
    f"mass: {SHACKLE} kg}}\n"
    f"  ropes:\n"
    f"    a: {{rope: whole, length: {LENGTH / 2} m, route: [{TOP}, {{type: end, body: shackle}}]}}\n"
    f"    b: {{rope: whole, length: {LENGTH / 2} m, route: [{{type: end, body: shackle}}, {LOW}]}}\n"
)


def test_two_ropes_side_by_side_for_one() -> None:
    """Two of EA/2 stretch alike: half the tension in each, and the same way, within the tolerance of 1 N and
    what 1 N stretches. The weight is let go, so that the rope bears up to twice of it, less what it damps.
    """
    one, two = simulated(ONE), simulated(SIDE_BY_SIDE)
    assert one.column("rope_tension", "a").max() == pytest.approx(2 * MASS * G, rel=0.1)
    for name in "ab":
        assert np.abs(2 * two.column("rope_tension", name) - one.column("rope_tension", "a")).max() < 1.0
    ways = [each.column("body_position", "weight")[:, 2] for each in (one, two)]
    assert np.abs(ways[0] - ways[1]).max() < 1.0 * LENGTH / EA


def test_two_ropes_in_series_for_one() -> None:
    """Two of half the length, joined by a shackle of μ = 1e-4 of the weight: 1/k + 1/k = 2/k, so the weight
    bobs as on one. The shackle goes half the way: a quarter of its mass bobs too, which is μ/8 of ω, and half
    of its weight stretches the upper rope, μ/2 of m g L/EA for the middle and the same for the width of the
    way; its own tremble moves the weight by μ at most. Over ω t = 25.3 rad that is
    25.3 μ/8 + μ/2 + μ/2 + μ = 5.2e-4 of m g L/EA.
    """
    share, angle = SHACKLE / MASS, 2.0 * math.sqrt(EA / (LENGTH * MASS))
    one, two = simulated(ONE), simulated(IN_SERIES)
    ways = [each.column("body_position", "weight")[:, 2] for each in (one, two)]
    bound = (angle / 8 + 2.0) * share * MASS * G * LENGTH / EA
    assert np.abs(ways[0] - ways[1]).max() < bound
