"""What hangs on a hoist, against what motor and brake of its drum hold: by hand, of the hoist in 16 parts."""

from __future__ import annotations

from pathlib import Path

import pytest

import gantline
from gantline.checks import Check, Verdict, check_recording, verdict_of
from gantline.results import series
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from of_recording import checks_of

FILE = Path(__file__).resolve().parents[2] / "scenarios" / "reeved_hoist" / "scenario.yaml"
TEXT = FILE.read_text(encoding="utf-8")
PULLS = "capacity: 260 kN, brake: 320 kN"
PARTS = 2 * 8
DRUM, ROPE = 1.6, 0.042
#: Rope of the second layer lies in the grooves of the first: sin 60 deg of its diameter farther out.
SECOND_LAYER = DRUM + 2 * 0.5 * 3**0.5 * ROPE


def run(pulls: str) -> Recording:
    assert PULLS in TEXT
    return gantline.simulate(parse_scenario(TEXT.replace(PULLS, pulls)))


def drive_check(recording: Recording) -> Check:
    (found,) = checks_of(recording, "hoist_load_of_drive_capacity")
    return found


@pytest.mark.parametrize(
    ("pulls", "least"),
    [(PULLS, 260e3), ("capacity: 260 kN, brake: 180 kN", 180e3)],
    ids=["the motor", "the brake"],
)
def test_the_weaker_of_motor_and_brake_on_the_last_layer_counts(pulls: str, least: float) -> None:
    """Hoist load / (pull x parts of line x first layer / last layer); 250 t alone are 2451.7 kN."""
    recording = run(pulls)
    static, _ = series.greatest_static(recording, recording.column("hoist_load", "hook"))
    assert static is not None and static > 250e3 * 9.80665
    assert recording.column("drum_layer", recording.rig.hooks[0].drum).max() == 2.0
    found = drive_check(recording)
    assert found.value == pytest.approx(static / (least * PARTS * DRUM / SECOND_LAYER), rel=1e-9)
    assert found.verdict is Verdict.OK


def test_a_brake_that_only_the_friction_of_the_sheaves_helps_is_no_go() -> None:
    """150 kN on each of 16 parts hold 2400 kN, less than the load alone; it need not slip for that."""
    checks = check_recording(run("capacity: 260 kN, brake: 150 kN"))
    (found,) = (one for one in checks if one.name == "hoist_load_of_drive_capacity")
    assert found.verdict is Verdict.FAILED
    assert verdict_of(checks).startswith("NO-GO")


def test_a_motor_without_end_has_no_such_check() -> None:
    """It pulls whatever the lift takes, and there is nothing to hold that against."""
    recording = gantline.simulate(parse_scenario(TEXT.replace(PULLS, "emergency_acceleration: 0.2 m/s^2")))
    names = {one.name for one in check_recording(recording)}
    assert names and "hoist_load_of_drive_capacity" not in names
