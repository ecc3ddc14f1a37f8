"""Distances of hook blocks, by the places of their bearings and the sizes of their sheaves.

The hook block of a Goliath crane is the box about its bearing and its sheaves: 3 m up to their axle, 1 m the
diameter of each, and along the axle as wide as they stand, eight parts of line on four sheaves 0.15 m apart,
the radius of one at least. Hooks without reeving are 0.2 m wide every way.
"""

from __future__ import annotations

from collections.abc import Sequence

import pytest

from crawler_lift import crawler_lift
from gantline.checks import check_recording
from gantline.results import Recording
from gantline.scenario import ScenarioError, parse_scenario
from gantline.simulation import simulate
from gantline.statics import Statics
from goliath_lift import HOOK, TO_SHEAVES, goliath_lift

RADIUS = 0.5
#: Of the hook's bearing at the start: the trolley is at -20 m [m].
ALONG = -20.0
#: A tower beside the hook block along the girder, one below it, and how far each is off [m].
BESIDE, BELOW = 2.0, 4.0
TOWERS = f"""\
structures:
  beside: {{type: box, x: [{ALONG + RADIUS + BESIDE} m, 30 m], y: [-5 m, 5 m], z: [0 m, {HOOK + 10} m]}}
  below: {{type: box, x: [-30 m, -10 m], y: [-5 m, 5 m], z: [0 m, {HOOK - BELOW} m]}}
"""
PLAN = """\
{step: on, traverse: gol.one, by: 1 m, speed: 10 m/min}
{step: end, hold: until_end}"""


def watched(*pairs: Sequence[str]) -> str:
    """Sections with the towers and these pairs."""
    lines = "".join(f"  - {{between: [{one}, {other}]}}\n" for one, other in pairs)
    return f"{TOWERS}watch:\n{lines}"


def least(recording: Recording, pair: str) -> float:
    return float(recording.column("clearance", pair).min())


def test_a_hook_block_comes_near_a_tower() -> None:
    """It goes 1 m towards the one beside it, 2 m off at first, and swings on from there, upright."""
    text = goliath_lift(PLAN, duration=30.0, more=watched(("gol.A", "beside"), ("A", "below")))
    run = simulate(parse_scenario(text))
    gone, high = (run.column("body_position", "gol.A")[:, axis] for axis in (0, 2))
    assert run.column("clearance", "gol.A - beside") == pytest.approx(BESIDE - (gone - ALONG), abs=1e-9)
    assert run.column("clearance", "A - below") == pytest.approx(BELOW + high - HOOK, abs=1e-9)
    assert least(run, "gol.A - beside") < BESIDE - 1.0
    assert "smallest_clearance.gol.A - beside" in run.metrics()


def test_a_hook_block_over_which_something_stands() -> None:
    """From the top of its sheaves, the radius of one over their axle."""
    z = f"[{HOOK + 10} m, {HOOK + 12} m]"
    over = f"structures: {{roof: {{type: box, x: [-30 m, -10 m], y: [-5 m, 5 m], z: {z}}}}}\n"
    text = goliath_lift(PLAN, duration=1.0, more=over + "watch: [{between: [roof, A]}]\n")
    run = simulate(parse_scenario(text))
    assert run.column("clearance", "roof - A")[0] == pytest.approx(10.0 - TO_SHEAVES - RADIUS, abs=1e-9)


def test_the_name_of_a_crane_does_not_stand_for_its_hooks() -> None:
    """Its legs are 54 m and more from there."""
    run = simulate(parse_scenario(goliath_lift(PLAN, duration=1.0, more=watched(("gol", "below")))))
    assert least(run, "gol - below") > 20.0


@pytest.mark.parametrize(("watch", "told"), [("", ["c1.H to tower"]), ("c1.H", []), ("H", [])])
def test_a_watched_hook_is_judged_by_its_distance(watch: str, told: list[str]) -> None:
    """A hook block in the middle of a tower 10 m high: by its drawing, or as a distance below nothing."""
    lift = """\
load:
  name: tower
  shape: {box: [6 m, 6 m, 10 m]}
  position: [3 m, 14 m, 25 m]
  weight: {calculated: 30 t}
  centre_of_gravity: {at: [0 m, 0 m, 1 m]}
  lugs: {A: {at: [0 m, 3.9 m, 3 m]}, B: {at: [0 m, -3.9 m, 3 m]}}
slings:
  A: {from: c1.H, to: tower.A, length: 4.4 m, rope: hoist}
  B: {from: c1.H, to: tower.B, length: 4.4 m, rope: hoist}
"""
    more = lift + (f"watch: [{{between: [tower, {watch}]}}]\n" if watch else "")
    text = crawler_lift(7.1e3, start="as_given", more=more)
    recording = Statics(parse_scenario(text)).equilibrium(time=0.0).recording
    checks = check_recording(recording)
    assert [one.element for one in checks if one.name == "no_overlap"] == told
    if watch:
        [margin] = [one for one in checks if one.name == "clearance_margin"]
        assert margin.value is not None and margin.value < -1.0


def test_fixed_hooks_are_as_wide_as_a_hand() -> None:
    """Two hooks 5 m apart: 4.8 m between them."""
    hoist = "hoist: {speed: 3 m/min, acceleration: 0.05 m/s^2}"
    hooks = "\n".join(
        f"  {name}: {{type: fixed_hook, at: [{x} m, 0 m, 20 m], {hoist}}}" for name, x in (("p", 0), ("q", 5))
    )
    text = f"""\
format: 1
lift: {{title: Two hooks}}
duration: 1 s
cranes:
{hooks}
mechanics: {{bodies: {{hung: {{parent: p, joint: {{type: fixed}}, mass: 1 t}}}}}}
watch: [{{between: [p, q], smallest: 1 m}}]
plan: [{{step: up, hoist: p, speed: 1 m/min, by: 0.01 m}}]
"""
    run = simulate(parse_scenario(text))
    assert run.column("clearance", "p - q")[0] == pytest.approx(4.8, abs=1e-9)


@pytest.mark.parametrize(
    ("pair", "message"),
    [
        (("A", "ropes"), "distances of a hook to ropes are not recorded, as falls and slings lead to it"),
        (("gol.B", "below"), "'gol.B' has no shape; did you mean 'gol.A'?"),
    ],
)
def test_what_hooks_cannot_be_watched_against(pair: Sequence[str], message: str) -> None:
    """Told with the place in the lift file."""
    with pytest.raises(ScenarioError, match=r"watch\[1\]\.between") as refused:
        simulate(parse_scenario(goliath_lift(PLAN, duration=1.0, more=watched(pair))))
    assert message in str(refused.value)
