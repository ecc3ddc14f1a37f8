"""Mooring lines that the plan lets go of were a rope parted each: a barge towed away was NO-GO.

Once a load is off its deck a cargo barge is towed from under it: its lines are let go and a tug hauls. A step
lets go of a mooring line as of a tag line, by `cut`, and of tag lines alone no check failed by it.
"""

from __future__ import annotations

import pytest

from gantline.checks import Verdict, check_recording
from gantline.report.steps import step_rows
from gantline.report.subject import Subject
from gantline.results.ropes.parting import partings
from gantline.scenario import parse_scenario
from gantline.simulation import simulate

#: Its aft line pulls with 50 kN, whichever kind it is.
BARGE = """\
format: 1
lift: {{title: A cargo barge is towed away}}
duration: 12 s
water: {{density: 1025 kg/m^3, level: 0 m}}
ropes:
  nylon: {{axial_stiffness: 4 MN, damping_time: 0.1 s, mass: 2.5 kg/m, minimum_breaking_force: 800 kN}}
vessels:
  cargo:
    draft: 2 m
    hull: {{box: [60 m, 24 m, 4.5 m]}}
    masses: {{all: {{mass: 2952 t, at: [30 m, 0 m, 2 m]}}}}
    radii_of_gyration: [8 m, 17 m, 18 m]
mooring_lines:
  aft: {{vessel: cargo, fairlead: [0 m, 0 m, 3 m], to: [-20 m, 0 m, 1 m], rope: nylon, {more}}}
  tow: {{vessel: cargo, fairlead: [60 m, 0 m, 3 m], to: [300 m, 0 m, 1 m], rope: nylon, pretension: 50 kN,
      type: spring, winch: {{speed: 30 m/min, acceleration: 0.1 m/s^2, capacity: 200 kN}}}}
plan:
  - {{step: moored, hold: 2 s}}
  - {{step: away, haul: tow, cut: mooring.aft, speed: 30 m/min, by: 4 m}}
  - {{step: end, hold: until_end}}
"""


@pytest.mark.parametrize("kind", ["spring", "catenary"])
@pytest.mark.parametrize(
    ("lost", "said"), [("", ("let go", 2.0)), (", cut_at: 1 s", ("cut", 1.0))], ids=["let go", "lost"]
)
def test_a_line_that_a_step_lets_go_of_has_not_parted(kind: str, lost: str, said: tuple[str, float]) -> None:
    """One that its step lets go of, as that begins, fails nothing; one lost before does."""
    text = BARGE.format(more=f"pretension: 50 kN, type: {kind}{lost}")
    recording = simulate(parse_scenario(text))
    (parting,) = partings(recording)
    assert (parting.rope, parting.kind, parting.time) == ("mooring.aft", *said)
    # The barge has hardly moved by then.
    assert parting.tension == pytest.approx(50e3, rel=2e-5)
    failed = [check.name for check in check_recording(recording) if check.verdict is Verdict.FAILED]
    assert failed == (["rope_parted"] if lost else [])
    # Its report says so by the line's own name.
    rows = step_rows(Subject(recording))
    assert rows[1]["does"] == "haul tow 30 m/min by 4 m; let go of aft"
    # The tow alone pulls it: 50 kN and more over 10 s on 2952 t.
    speed = recording.column("body_velocity", "cargo")[:, 0]
    assert speed[-1] > 50e3 * 10.0 / 2952e3
