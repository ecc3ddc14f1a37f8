"""Slings with nodes, which `gantline statics --sensitivities` answered with a traceback.

The core has many ropes where the lift has one, and was asked for the sling by its name. `gantline cases` told
the same by names that nobody had given, `sling.A/0` and on, and had no worst pattern of lengths for them.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from gantline.scenario import parse_scenario
from gantline.statics import Statics
from gantline.study import run_cases
from program import program

NODES = "rope_weight: distributed, rope_nodes: 8"


def lift(longer: float = 0.0, stiffer: float = 0.0, weight: str = NODES, cases: str = "") -> str:
    """Four slings from one hook; D longer by so much [m], A stiffer by so much [N]."""
    return f"""
format: 1
lift: {{title: Four slings with nodes}}
duration: 30 s
ropes:
  steel: {{axial_stiffness: 20 MN, damping_time: 20 ms, mass: 12 kg/m}}
  other: {{axial_stiffness: {20e6 + stiffer} N, damping_time: 20 ms, mass: 12 kg/m}}
load:
  name: module
  shape: {{box: [8 m, 5 m, 2 m]}}
  position: [0 m, 0 m, 2 m]
  weight: {{calculated: 20 t}}
  centre_of_gravity: {{at: [0.1 m, 0.05 m, 1 m]}}
  lugs: {{A: {{at: [-3 m, -2 m, 2 m]}}, B: {{at: [3 m, -2 m, 2 m]}}, C: {{at: [3 m, 2 m, 2 m]}}, D: {{at: [-3 m, 2 m, 2 m]}}}}
cranes:
  crane: {{type: fixed_hook, at: [0 m, 0 m, 11.7 m], hoist: {{speed: 6 m/min, acceleration: 0.1 m/s^2}}}}
sling_defaults: {{rope: steel, {weight}, tolerance: 10 mm}}
slings:
  A: {{from: crane, to: module.A, length: 8.6 m, rope: other}}
  B: {{from: crane, to: module.B, length: 8.6 m}}
  C: {{from: crane, to: module.C, length: 8.6 m}}
  D: {{from: crane, to: module.D, length: {8.6 + longer} m}}
{cases}
"""  # noqa: E501


def tensions(text: str) -> dict[str, float]:
    rest = Statics(parse_scenario(text, "lift.yaml")).equilibrium()
    return {name: rest.tension(f"sling.{name}") for name in "ABCD"}


def test_they_are_the_derivatives() -> None:
    """Central differences; those of a length have the weight of the rope that is longer too.

    12 kg/m of it: 118 N/m at its own upper end, of 580 kN/m.
    """
    question = Statics(parse_scenario(lift(), "lift.yaml"))
    question.equilibrium()
    for asked, texts, step, share in (
        (("length", "sling.D"), [lift(longer=more) for more in (-1e-4, 1e-4)], 2e-4, 2.5e-4),
        (("stiffness", "sling.A"), [lift(stiffer=more) for more in (-2e4, 2e4)], 4e4, 1e-5),
    ):
        (found,) = question.sensitivities([asked])
        less, more = (tensions(text) for text in texts)
        for name in "ABCD":
            expected = (more[name] - less[name]) / step
            assert found.of(f"sling.{name}") == pytest.approx(expected, rel=share)
        assert not [body for body in (*found.ropes, *found.bodies) if "/" in body]


def test_the_table_of_the_program_has_them(tmp_path: Path) -> None:
    path = tmp_path / "lift.yaml"
    path.write_text(lift(), encoding="utf-8")
    done = program("statics", path, "--sensitivities")
    # It has no strength and no limit, so that there is no verdict.
    assert done.returncode == 4, done.stderr
    assert "sling.D 10 mm longer" in done.stdout
    row = next(line for line in done.stdout.splitlines() if "sling.A 1 % stiffer" in line and "kN" in line)
    assert row.split()[-8] == f"{6.477e-4 * 0.01 * 20e3:.3f}"


def test_the_worst_pattern_of_their_lengths() -> None:
    """Opposite slings long, the others short: by sensitivities, and by equilibria with these lengths."""
    cases = "cases:\n  off: {vary: slings.tolerance, pattern: worst}"
    states = run_cases(parse_scenario(lift(cases=cases), "lift.yaml")).of("off")
    assert sorted(state.variant for state in states) == ["+A,C −B,D", "+B,D −A,C"]
    for state in states:
        assert state.rest is not None
        for name in "ABCD":
            assert state.first_order[name] == pytest.approx(state.rest.tension(f"sling.{name}"), rel=1e-3)
