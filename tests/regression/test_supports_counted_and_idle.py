"""Fifteen stools were not among what `gantline check` counts, and a reading listed each of them with 0 kN.

A line of `report: [support_force]` before a load is set down was as long as there are supports."""

from __future__ import annotations

from pathlib import Path

from gantline.cli.hold_points import hold_points
from gantline.scenario import parse_scenario
from gantline.simulation import Simulation
from hooked_lift import hooked_lift
from program import called

#: A load of 10 m by 6 m on slings of 10 m, 0.5 m over six feet, two of them too low to bear anything.
LIFT = hooked_lift(
    {"A": (0.0, 0.0, 6.0 + 84.0**0.5)},
    {"1": (-4.0, 0.0, 4.0), "2": (4.0, 0.0, 4.0)},
    {"S1": ("A", "1", 10.0), "S2": ("A", "2", 10.0)},
    mass=200e3,
    position=(0.0, 0.0, 2.0),
    more="""\
supports:
  feet: {under: load, grid: {x: [-4 m, 0 m, 4 m], y: [-2 m, 2 m]}, height: 1.5 m,
    stiffness: 200 MN/m, friction: 0.3, each: {"2.1": {height: 1 m}, "2.2": {height: 1 m}}}
plan:
  - {step: look, hold: 1 s, report: [support_force]}
  - {step: down, lower: A, speed: 0.1 m/s, until: {supports: touched}}
  - {step: set down, lower: A, speed: 0.01 m/s, until: {slings: slack}}
  - {step: off, hold: 10 s, report: [support_force]}
""",
).replace("duration: 10 s", "duration: 60 s")


def test_those_that_bear_nothing_are_counted() -> None:
    """200 t of g = 9.81 m/s^2 on four feet are 490.5 kN each."""
    lines = hold_points(Simulation(parse_scenario(LIFT)).run())
    first, last = (" ".join(line.split()) for line in lines if line.strip().startswith("support force"))
    assert first == "support force all 6 0 kN"
    feet = ", ".join(f"feet.{n}.{m} {200 * 9.81 / 4:.0f} kN" for n in (1, 3) for m in (1, 2))
    assert last == f"support force {feet}, the other 2 0 kN"


def test_check_counts_them(tmp_path: Path) -> None:
    file = tmp_path / "lift.yaml"
    file.write_text(LIFT, encoding="utf-8")
    assert "6 supports" in called("check", file).stdout
