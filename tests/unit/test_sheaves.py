"""Sheaves with true tangents and eyes from the lift file to table, checks and warnings."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from gantline.assembly import assemble
from gantline.checks import Verdict
from gantline.cli.summary import summary
from gantline.results.recording import Recording
from gantline.scenario import ScenarioError, load_scenario
from gantline.simulation import Simulation, SimulationError
from of_recording import checks_of

LIFT = """
format: 1
lift: {{title: a rope over a sheave}}
duration: 2 s
start: as_given
simulation: {{sample_interval: 0.05 s}}
ropes:
  hoist: {{axial_stiffness: 100 MN, damping_time: 5 ms}}
{limits}
mechanics:
  bodies:
    weight: {{at: [0.5 m, 0 m, 0 m], joint: {{type: slider, axis: [0, 0, 1], damping: 10 kN s/m}}, mass: 1 t}}
    end:
      at: {start}
      joint:
        type: slider
        axis: [0, 0, 1]
        motion: [{{at: 0.1 s, duration: 0.2 s, velocity: 2 m/s}}]
      mass: 1 t
  ropes:
    r:
      rope: hoist
      length: as_routed
      route:
        - {{type: end, body: end}}
        - {guide}
        - {{type: eye, body: world, at: [0.5 m, 0 m, 8 m]}}
        - {{type: end, body: weight}}
"""
#: Its left side is at the x of the end, so that the rope comes up plumb; the end rises past it.
SHEAVE = "{{type: sheave, body: world, at: [-3.5 m, 0 m, 8 m], axis: [0, 1, 0], diameter: 1 m{rest}}}"


def lift(folder: Path, *, rest: str = "", start: str = "[-8 m, 0 m, 7 m]", limits: str = "") -> Path:
    path = folder / "lift.yaml"
    guide = SHEAVE.format(rest=rest)
    path.write_text(LIFT.format(guide=guide, start=start, limits=limits), encoding="utf-8")
    return path


def run(folder: Path, **given: str) -> Recording:
    return Simulation(lift(folder, **given)).run()


def test_a_rope_that_leaves_is_a_warning(tmp_path: Path) -> None:
    recording = run(tmp_path)
    ((time, kind, name),) = recording.events("rope_off_sheave")
    assert (kind, name) == ("rope_off_sheave", "r/sheave_1")
    (warning,) = recording.attributes["warnings"]
    assert f"the rope leaves the sheave r/sheave_1 at {time:.3f} s" in warning
    assert recording.column("wrap_angle", "r/sheave_1")[-1] < 0.0


def test_a_rope_that_may_leave_is_none(tmp_path: Path) -> None:
    recording = run(tmp_path, rest=", may_lift_off: true")
    assert len(recording.events("rope_off_sheave")) == 1
    assert not recording.attributes["warnings"]
    assert recording.column("wrap_angle", "r/sheave_1")[-1] == 0.0
    points = recording["rope_point"].values[-1]
    way = points[-2] - points[0]
    across = np.cross(points[:-1] - points[0], way) / np.linalg.norm(way)
    # What is drawn is rounded to 2⁻²⁴ m.
    assert np.abs(across).max() < 2.0**-24, "drawn straight from the end to the eye"


def test_a_saved_run_goes_on_off_the_sheave(tmp_path: Path) -> None:
    """The checkpoint knows which sheaves the rope has left: the same numbers as without a break."""
    path = lift(tmp_path, rest=", may_lift_off: true")
    whole = Simulation(path).run()
    broken, other = Simulation(path), Simulation(path)
    broken.run(until=1.5)
    other.restore(broken.save())
    again = other.run()
    for name in ("rope_tension", "wrap_angle", "fleet_angle", "rope_point"):
        assert np.array_equal(again[name].values, whole[name].values), name
    assert again.events("rope_off_sheave") == whole.events("rope_off_sheave")


def test_variables_and_table_of_sheaves(tmp_path: Path) -> None:
    recording = run(tmp_path)
    assert recording["wrap_angle"].dims == ("time", "wrapped_sheave")
    assert recording["wrap_angle"].unit == recording["fleet_angle"].unit == "rad"
    assert recording["fleet_angle"].dims == ("time", "wrapped_sheave", "sheave_side")
    assert tuple(recording.coordinates["wrapped_sheave"]) == ("r/sheave_1",)
    assert tuple(recording.coordinates["sheave_side"]) == ("arriving", "leaving")
    lines = summary(recording, [], str)
    (row,) = [line for line in lines if line.lstrip().startswith("r/sheave_1")]
    assert "deg" in row


@pytest.mark.parametrize(
    ("limits", "verdict"),
    [
        ("", Verdict.WARNING),
        ("limits: {fleet_angle: 2 deg}", Verdict.FAILED),
        ("limits: {fleet_angle: 20 deg}", Verdict.OK),
    ],
)
def test_fleet_angle_is_held_against_its_limit(tmp_path: Path, limits: str, verdict: Verdict) -> None:
    """From (-8, 0.5, 7) to the top of the sheave at x = -3.5: about asin(0.5/4.6) = 6.2 deg at the start."""
    recording = run(tmp_path, start="[-8 m, 0.5 m, 7 m]", limits=limits)
    (check,) = checks_of(recording, "fleet_angle")
    assert check.verdict is verdict
    assert check.element == "r/sheave_1"
    assert check.value == pytest.approx(recording.metrics()["peak_fleet_angle"])
    assert 5.0 < math.degrees(check.value or 0.0) < 8.0
    if not limits:
        assert check.limit == pytest.approx(math.radians(4.0))


def test_a_lift_without_such_sheaves_has_no_limit_of_fleet_angles(tmp_path: Path) -> None:
    path = lift(tmp_path)
    text = "\n".join(
        line for line in path.read_text(encoding="utf-8").splitlines() if "type: sheave" not in line
    )
    path.write_text(text, encoding="utf-8")
    rig = assemble(load_scenario(path)).rig
    assert rig["wrapped_sheaves"] == [] and rig["limits"] == {} and rig["assumed_limits"] == []
    recording = Simulation(path).run()
    assert "wrap_angle" not in recording and "sheave_side" not in recording.coordinates


@pytest.mark.parametrize(
    ("start", "sentence"),
    [
        ("[-3.5 m, 0 m, 8.2 m]", "the first lies within the circle of the second"),
        ("[-3.5 m, 3 m, 8 m]", "points at the other end"),
    ],
)
def test_what_is_in_the_way_is_said_at_the_rope(tmp_path: Path, start: str, sentence: str) -> None:
    with pytest.raises(ScenarioError, match=sentence) as refused:
        Simulation(lift(tmp_path, start=start))
    assert "mechanics.ropes.r" in str(refused.value)


@pytest.mark.parametrize("method", [{}, {"integrator": "del"}])
def test_a_motion_that_leads_into_a_sheave_says_so(tmp_path: Path, method: dict[str, str]) -> None:
    """The end rises into the circle: no tangent is left, and the message says which part and why."""
    with pytest.raises(SimulationError) as failed:
        Simulation(lift(tmp_path, start="[-3.7 m, 0 m, 6.5 m]"), **method).run()
    # It meets the circle 0.46 m below its centre, after 0.72 s on the way.
    assert failed.value.time == pytest.approx(0.2 + (1.5 - math.sqrt(0.25 - 0.04)) / 2, abs=2e-3)
    assert np.isfinite(failed.value.recording["rope_tension"].values).all()
    assert failed.value.element == "r"
    assert failed.value.cause == (
        "its part 1, from route[1] (an end of a rope on 'end') to route[2] (a sheave on 'world'): the "
        "first lies within the circle of the second, seen along the axis of that, "
        "and no rope leads onto it from there"
    )


def test_an_eye_that_meets_an_end_is_refused(tmp_path: Path) -> None:
    path = lift(tmp_path)
    text = path.read_text(encoding="utf-8").replace("at: [0.5 m, 0 m, 8 m]", "at: [0.5 m, 0 m, 0 m]")
    path.write_text(text, encoding="utf-8")
    with pytest.raises(
        ScenarioError,
        match=r"its part 3 at the start, from route\[3\] \(an eye on 'world'\).*: its ends coin",
    ):
        Simulation(path)
