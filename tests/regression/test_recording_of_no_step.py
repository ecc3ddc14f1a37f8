"""What was asked of a run that had made no step ended in tracebacks.

Its recording has no samples, and variables without values were left out of it; checks missed them, ropes with
nodes had no largest tension to compare, and `gantline run` of a lift with such a rope that failed in its
first step told an IndexError in place of the cause. The report of a recording without samples says that in
one line; a run that fails in its first step has the start as its sample, and a report that shows it.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from typer.testing import CliRunner

import gantline
from gantline.cli.app import app
from gantline.export import write_csv

SCENARIOS = Path(__file__).resolve().parents[2] / "scenarios"
#: Slings of 15 kg/m, one of them with nodes.
HEAVY = {"ropes.sling.mass": "15 kg/m", "slings.S3.rope_weight": "distributed", "slings.S3.rope_nodes": 6}
#: A weight on two inextensible ropes, one as good as the other.
TWICE = """
mechanics:
  bodies:
    weight: {at: [0 m, 50 m, 0 m], joint: {type: slider, axis: [0, 0, 1]}, mass: 10 kg}
  ropes:
    a:
      rope: thin
      length: 5 m
      route: [{type: end, body: world, at: [0 m, 50 m, 5 m]}, {type: end, body: weight}]
    b:
      rope: thin
      length: 5 m
      route: [{type: end, body: world, at: [0 m, 50 m, 5 m]}, {type: end, body: weight}]
"""


@pytest.mark.parametrize("name", ["equalizer", "reeved_hoist", "spreader_bar"])
def test_what_can_be_asked_before_a_run(name: str, tmp_path: Path) -> None:
    """Metrics, checks, tables and files of lifts of all kinds; a report has nothing to show."""
    lift = gantline.load_scenario(SCENARIOS / name)
    if name == "equalizer":
        lift = lift.changed(HEAVY)
    recording = gantline.Simulation(lift).recording()
    assert len(recording.time) == 0
    assert recording["rope_tension"].values.shape == (0, len(recording.coordinates["rope"]))
    assert not recording["rope_peak_tension"].values.any()
    recording.metrics()
    assert not any(
        check.verdict is gantline.checks.Verdict.FAILED
        for check in gantline.checks.check_recording(recording)
    )
    again = gantline.open_recording(recording.save(tmp_path / "recording.nc"))
    assert list(again.variables) == list(recording.variables)
    write_csv(again, tmp_path / "recording.csv")
    assert len((tmp_path / "recording.csv").read_text(encoding="utf-8").splitlines()) == 1
    with pytest.raises(ValueError, match="no samples to show: its run has not begun"):
        gantline.write_report(again, tmp_path / "report.html")


def test_a_lift_with_nodes_that_fails_at_once_tells_why(tmp_path: Path) -> None:
    """Cause and files of the run, whose report shows how it starts."""
    text = (SCENARIOS / "equalizer" / "scenario.yaml").read_text(encoding="utf-8")
    text = text.replace("\nropes:\n", "\nropes:\n  thin: {inextensible: true}\n").replace(
        "mass: none", "mass: 15 kg/m"
    )
    text = text.replace("  S3: {", "  S3: {rope_weight: distributed, rope_nodes: 6, ")
    lift, out = tmp_path / "lift.yaml", tmp_path / "out"
    lift.write_text(text + TWICE, encoding="utf-8")
    run = CliRunner().invoke(app, ["run", str(lift), "-o", str(out)])
    assert run.exit_code == 3
    assert "an inextensible rope that repeats another" in " ".join(run.output.split())
    report = CliRunner().invoke(app, ["report", str(out)])
    assert report.exit_code == 0
    assert "could not go on at its start" in (out / "report.html").read_text(encoding="utf-8")
