"""A plan that needs longer than is simulated.

`gantline check` found it in order, though the ways and times of its steps alone were longer than `duration`;
only after the run was it told that the plan had not been finished.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from typer.testing import CliRunner

from gantline.cli.app import app
from gantline.scenario import parse_scenario
from gantline.scenario.plan.plan_time import earliest_ends
from hooked_lift import hooked_lift

#: 30 s of way, 20 s beside 10 s of it, a condition, a hold, and what waits for a time.
PLAN = """\
plan:
  - {step: up, hoist: A, speed: 0.1 m/s, by: 3 m}
  - {step: down, lower: A, speed: 0.05 m/s, by: 1 m}
  - {step: beside, hoist: B, speed: 0.1 m/s, by: 1 m, starts: with_previous}
  - {step: on, hoist: B, speed: 0.1 m/s, until: {supports: clear}}
  - {step: look, hold: 7 s}
  - {step: later, hoist: A, speed: 0.1 m/s, by: 1 m, start_at: 80 s}
  - {step: end, hold: until_end}
ground: {level: 0 m}
"""
ENDS = [30.0, 50.0, 40.0, 50.0, 57.0, 90.0, 90.0]
HOOKS = {"A": (-1.0, 0.0, 9.0), "B": (1.0, 0.0, 9.0)}
LUGS = {"A": (-1.0, 0.0, 4.0), "B": (1.0, 0.0, 4.0)}
LIFT = hooked_lift(HOOKS, LUGS, {"A": ("A", "A", 5.0), "B": ("B", "B", 5.0)}, more=PLAN)


def test_earliest_ends() -> None:
    """Ways over speeds, one step after the other or side by side, and times as they are said."""
    plan = parse_scenario(LIFT.replace("duration: 10 s", "duration: 100 s")).plan
    assert earliest_ends(plan) == pytest.approx(ENDS, rel=1e-12)


@pytest.mark.parametrize(("duration", "told"), [(89, "'later'"), (90, None)])
def test_it_is_told(duration: int, told: str | None, tmp_path: Path) -> None:
    """With the step that cannot be over, and how long the plan takes at the least."""
    file = tmp_path / "lift.yaml"
    file.write_text(LIFT.replace("duration: 10 s", f"duration: {duration} s"), encoding="utf-8")
    result = CliRunner().invoke(app, ["check", str(file)])
    assert result.exit_code == 0
    least = f"the plan takes 90 s at least; {duration} s are simulated, and end before {told} does"
    assert (least in result.stderr.replace("\n", " ")) is (told is not None)
