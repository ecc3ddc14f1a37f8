"""A tag line under constant pull, and no force in the lift was static until it was let go.

A load hangs still where no drive does work. The motor of a tugger asks for hauling in all the time and slips,
so it works all the time: hold points did not count, only the end of the run. A column was upended by two
cranes with tag lines; the tail crane, which holds nothing in the end, had a `hook_dynamic_factor` of 299.6
and its slings carried `0.0 kN` static, so that shackles and lugs were held against nothing. The lines
themselves, let go as the plan said, were ropes that had `FAILED`.
"""

from __future__ import annotations

import math

import gantline
from four_slings import LIFT
from gantline.checks import Check, Verdict, check_recording
from gantline.results.series import greatest_static
from gantline.scenario import parse_scenario
from lift_text import changed
from of_recording import checks_of

PULL, SPEED = 0.5e3, 0.4  # N, m/s
LINES = f"""\
  tag: {{axial_stiffness: 150 kN, damping_time: 0.2 s, mass: none}}
tag_lines:
  west: {{at: [-3 m, 2 m, 0 m], to: [-30 m, 2 m, 0 m], rope: tag, pull: {PULL} N, speed: {SPEED} m/s}}
  east: {{at: [3 m, 2 m, 0 m], to: [30 m, 2 m, 0 m], rope: tag, pull: {PULL} N, speed: {SPEED} m/s}}
load:
"""
SET_DOWN = "  - {step: set down, cut: [tag.west, tag.east], lower: crane, speed: 1 m/min, by: 0.4 m}\nrules:"


def test_a_load_between_tuggers_hangs_still_at_its_hold_point() -> None:
    """40 t and the lower halves of four slings, and what the lines pull down: none, they lie level to 1 %."""
    recording = gantline.simulate(parse_scenario(changed(LIFT, ("load:\n", LINES), ("rules:", SET_DOWN))))
    static, _ = greatest_static(recording, recording.column("hook_load", "crane"))
    without = gantline.simulate(parse_scenario(LIFT))
    alone, _ = greatest_static(without, without.column("hook_load", "crane"))
    assert static is not None and alone is not None
    # They pull 27 m away, from no more than 0.4 m above where they are made fast.
    assert alone < static < alone + 2.0 * PULL * 0.4 / 27.0
    factor = named(check_recording(recording), "hook_dynamic_factor").value
    assert factor is not None and factor < 1.1


def test_a_line_that_the_plan_lets_go_of_has_not_failed() -> None:
    recording = gantline.simulate(parse_scenario(changed(LIFT, ("load:\n", LINES), ("rules:", SET_DOWN))))
    assert not checks_of(recording, "rope_parted")
    assert "parted_ropes" not in recording.metrics()


def test_a_line_that_is_lost_has_failed() -> None:
    lost = LINES.replace(f"speed: {SPEED} m/s}}", f"speed: {SPEED} m/s, cut_at: 30 s}}", 1)
    recording = gantline.simulate(parse_scenario(changed(LIFT, ("load:\n", lost))))
    parted = named(check_recording(recording), "rope_parted")
    assert (parted.element, parted.verdict) == ("tag.west", Verdict.FAILED)
    assert math.isclose(recording.metrics()["parted_ropes"], 1.0)


def named(checks: list[Check], name: str) -> Check:
    return next(one for one in checks if one.name == name)
