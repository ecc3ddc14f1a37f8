"""A rope that pulled more than the last point of its curve went on along its last line, and nothing said so.

A maker's curve may end far below the breaking force. A mass that was thrown against a line given up
to 350 kN pulled it with more, by a stretch that nobody had said, and the run was GO without a word.
`gantline check` found a lift in order whose lines pull more from the start on, by their pretension or
their length; it tells now, too.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from typer.testing import CliRunner

import gantline
from gantline.cli.app import app
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


#: A tension is beyond the last point from 0.1 % more on.
@pytest.mark.parametrize(("tension", "is_told"), [(350.3, False), (350.4, True)])
def test_the_tolerance_of_a_method_is_not_beyond(tension: float, is_told: bool) -> None:
    lift = LIFT.replace("SPEED", "0").replace("PULL", f"pretension: {tension} kN")
    assert bool(_said(list(gantline.simulate(parse_scenario(lift)).attributes["warnings"]))) == is_told


def test_the_largest_of_a_run_counts_and_no_rope_of_one_stiffness() -> None:
    """A line that begins with 400 kN and throws its mass off: it is slack at the end."""
    lift = LIFT.replace("SPEED", "0").replace("PULL", "pretension: 400 kN")
    lift = lift.replace("  nylon:", "  steel: {axial_stiffness: 50 MN, mass: none}\n  nylon:")
    slack = "right: {vessel: mass, fairlead: [0 m, 0 m, 0 m], to: [30 m, 0 m, 0 m], rope: steel, length: 40 m"
    lift = lift.replace("plan:", f"  {slack}, type: spring}}\nplan:")
    said = f"mooring.left pulls with up to 400 kN, {SAID}"
    assert _said(list(gantline.simulate(parse_scenario(lift)).attributes["warnings"])) == [said]


@pytest.mark.parametrize(
    ("pull", "told"),
    [
        ("pretension: 340 kN", None),
        ("pretension: 400 kN", f"400 kN at the start, {SAID}"),
        # 30 m of 28.5 m are 5.2632 %, 1.2632 % past a last point at 4 %, by 260 kN / 2 % more.
        ("length: 28.5 m", f"514 kN at the start, {SAID.replace('20 %', '4 %')}"),
    ],
)
def test_check_tells_of_it_at_the_start(tmp_path: Path, pull: str, told: str | None) -> None:
    file = tmp_path / "lift.yaml"
    short = "[5 %, 10 %, 20 %]", "[1 %, 2 %, 4 %]"
    lift = LIFT.replace(*short) if "length" in pull else LIFT
    file.write_text(lift.replace("SPEED", "0").replace("PULL", pull), encoding="utf-8")
    result = CliRunner().invoke(app, ["check", str(file)])
    assert result.exit_code == 0
    said = [line for line in result.stderr.splitlines() if "last point" in line]
    at = f"warning: {file}:6: ropes.nylon.curve: mooring.left pulls with "
    assert said == ([] if told is None else [at + told])
