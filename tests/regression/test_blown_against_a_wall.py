"""A module that the wind blew against a wall once its tag line was let go: GO WITH WARNINGS, none of it.

`stays_clear` looked at steps that slew, luff, traverse or travel alone. In a `hold`, as a line is hauled or
while a hook hoists, a load could hit a wall without a word: 20 t in wind of 20 m/s, with 22.6 kN at each of
two places.
"""

from __future__ import annotations

import pytest

from gantline.checks import Check, Verdict
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from of_recording import checks_of

#: Wall from the module's side, where it hangs with its line on [m].
GAP = 1.2
LET_GO = "  - {step: loose, hold: 30 s, cut: tag.back}\n"

_LIFT = """\
format: 1
lift: {{title: A module beside a wall}}
duration: 50 s
wind: {{speed: {wind} m/s, direction: 0 deg}}
ground: {{level: 0 m}}
ropes:
  sling: {{axial_stiffness: 188 MN, damping_time: 10 ms, mass: none}}
  tag: {{axial_stiffness: 150 kN, damping_time: 0.2 s, mass: none}}
structures:
  wall: {{type: box, x: [{wall} m, 7 m], y: [-10 m, 10 m], z: [0 m, 12 m]}}
load:
  name: box
  shape: {{box: [8 m, 8 m, 6 m]}}
  position: [0 m, 0 m, 2 m]
  weight: {{calculated: 20 t}}
  inertia: homogeneous
  centre_of_gravity: {{at: [0 m, 0 m, 3 m]}}
  lugs: {{A: {{at: [-3 m, 3 m, 6 m]}}, B: {{at: [-3 m, -3 m, 6 m]}}, C: {{at: [3 m, 3 m, 6 m]}},
    D: {{at: [3 m, -3 m, 6 m]}}}}
  wind_areas: {{side: {{area: 48 m^2, coefficient: 1.2, along: x, at: [0 m, 0 m, 3 m]}}}}
cranes:
  hook: {{type: fixed_hook, at: [0 m, 0 m, 28 m], hoist: {{speed: 6 m/min, acceleration: 0.05 m/s^2}}}}
sling_defaults: {{rope: sling, length: 20.5 m}}
slings:
  A: {{from: hook, to: box.A}}
  B: {{from: hook, to: box.B}}
  C: {{from: hook, to: box.C}}
  D: {{from: hook, to: box.D}}
tag_lines:
  back: {{at: [-4 m, 0 m, 3 m], to: [-30 m, 0 m, 3 m], rope: tag, pretension: 6 kN}}
plan:
  - {{step: wait, hold: 10 s}}
{plan}"""


def simulated(plan: str, wind: float = 20.0, gap: float = GAP) -> Recording:
    return simulate(parse_scenario(_LIFT.format(plan=plan, wind=wind, wall=4.0 + gap)))


def told(recording: Recording) -> list[Check]:
    return checks_of(recording, "stays_clear")


def test_a_load_that_is_let_go_of_before_a_wall() -> None:
    """Let go of at 0.5 m it would hang at (14.1 kN / 196.2 kN) 23 m = 1.65 m, and swings past that."""
    recording = simulated(LET_GO)
    met = [time for time, kind, _ in recording.events() if kind == "set_down"]
    (found,) = told(recording)
    assert (found.verdict, found.element, found.time) == (Verdict.WARNING, "box", met[0])
    assert f"in 'loose', after {met[0]:.3g} s of hanging clear" in found.remark
    assert 10.0 < met[0] < 13.0


@pytest.mark.parametrize(("wind", "gap"), [(20.0, 6.0 - 4.0 + 0.9), (5.0, GAP)], ids=["far", "a breeze"])
def test_a_load_that_does_not_come_so_far(wind: float, gap: float) -> None:
    """Let go from rest at 0.5 m it swings to 2 * 1.65 m - 0.5 m = 2.8 m; at 5 m/s to a sixteenth of that."""
    recording = simulated(LET_GO, wind=wind, gap=gap)
    assert [kind for _, kind, _ in recording.events() if kind == "set_down"] == []
    assert told(recording) == []


def test_a_load_that_is_lowered_comes_down() -> None:
    """2 m of way down to the ground, and what it does there after that in a hold is no surprise."""
    down = "  - {step: down, lower: hook, speed: 6 m/min, by: 2.05 m}\n  - {step: end, hold: until_end}\n"
    recording = simulated(down, wind=0.1)
    assert [kind for _, kind, _ in recording.events() if kind == "set_down"]
    assert told(recording) == []
