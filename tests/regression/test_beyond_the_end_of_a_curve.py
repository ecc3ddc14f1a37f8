"""A rope that pulled more than the last point of its curve went on along its last line, and nothing said so.

A maker's curve may end far below the breaking force. A mass that was thrown against a line given up
to 350 kN pulled it with more, by a stretch that nobody had said, and the run was GO without a word.
"""

from __future__ import annotations

import gantline
from gantline.scenario import parse_scenario

LIFT = """\
format: 1
lift: {title: A mass between two lines}
duration: 6 s
start: as_given
ropes:
  nylon: {curve: {strain: [5 %, 10 %, 20 %], tension: [30 kN, 90 kN, 350 kN]}, mass: none}
mechanics:
  bodies:
    mass: {joint: {type: slider, axis: [1, 0, 0], velocity: SPEED m/s}, mass: 500 t}
mooring_lines:
  left: {vessel: mass, fairlead: [0 m, 0 m, 0 m], to: [-30 m, 0 m, 0 m], rope: nylon, type: spring, PULL}
plan: [{step: hold, hold: until_end}]
simulation: {sample_interval: 1 s}
"""
SAID = (
    "more than the last point of its curve, 350 kN at 20 %: it goes on along its last line, "
    "which nobody has given"
)


def _said(warnings: list[str]) -> list[str]:
    return [one for one in warnings if "last point" in one]


def test_a_run_says_by_how_much_between_samples_too() -> None:
    """½ m v² = L u with the line of 30 m just taut: u(20 %) = 25.75 kJ/m are 1.76 m/s, and 350 kN."""
    pull = "length: 30 m"
    slow, fast = (LIFT.replace("SPEED", one).replace("PULL", pull) for one in ("1.6", "2.5"))
    assert not _said(list(gantline.simulate(parse_scenario(slow)).attributes["warnings"]))
    recording = gantline.simulate(parse_scenario(fast))
    # u = 52.083 kJ/m, 26.333 kJ/m of it past 20 %, where the slope is 2.6 MN:
    # T² = 350² + 2 · 2600 · 26.333.
    said = [f"mooring.left pulls with up to 509 kN, {SAID}"]
    assert _said(list(recording.attributes["warnings"])) == said


def test_an_equilibrium_says_so() -> None:
    lift = (
        LIFT.replace("SPEED", "0")
        .replace("PULL", "pretension: 400 kN")
        .replace(
            "plan:",
            "  right: {vessel: mass, fairlead: [0 m, 0 m, 0 m], to: [30 m, 0 m, 0 m], rope: nylon, "
            "type: spring, pretension: 400 kN}\nplan:",
        )
    )
    rest = gantline.Statics(parse_scenario(lift)).equilibrium().recording
    said = [f"mooring.{name} pulls with up to 400 kN, {SAID}" for name in ("left", "right")]
    assert _said(list(rest.attributes["warnings"])) == said
