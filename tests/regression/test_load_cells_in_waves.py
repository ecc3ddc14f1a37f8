"""What load cells should read while a load is taken off its stand in waves.

The first page of the report read them from the sample in which the share of the weight first came over. In a
sea that is the first wave that jerks at the slings: a module of 180 t off a cargo barge, 202.5 t in the falls
once it hung, should have shown 66.6 t at 25 % of its weight, 62.5 t at 50 %, 212.6 t at 75 % and 227.6 t at
100 %; and the page told to stop where a cell differs from that by a tenth.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from gantline.report.carried import hook_row
from gantline.report.first_page import stop_if
from gantline.report.holds import HoldPoints
from gantline.report.subject import Subject
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate

FILE = Path(__file__).parents[2] / "scenarios" / "crane_barge_in_swell" / "scenario.yaml"
STAND = """
mechanics:
  bodies:
    stand:
      at: [107.2 m, 0 m, 10.9 m]
      joint: {type: fixed}
      shape: {box: [12 m, 10 m, 1 m], centre: [0 m, 0 m, -0.5 m]}
  body_contacts:
    on_stand: {between: [module, stand], stiffness: 100 MN/m, damping: 1 MN s/m, friction: 0.3}
"""


@pytest.fixture(scope="module")
def run() -> Recording:
    """The module stands on a stand ahead of the bow, and its slings are slack by half a metre."""
    text = FILE.read_text(encoding="utf-8")
    plan = """plan:
  - {step: wait, hold: 40 s}
  - {step: lift off, hoist: H1, speed: 3 m/min, until: {supports: clear}}
  - {step: hoist, hoist: H1, speed: 6 m/min, by: 3 m}
  - {step: hold, hold: until_end}
"""
    begin, end = text.index("plan:\n"), text.index("watch:\n")
    text = text[:begin] + plan + STAND + text[end:]
    for given, other in (
        ("duration: 300 s", "duration: 110 s"),
        ("significant_height: 0.8 m", "significant_height: 2 m"),
        ("{type: hook_300, height: 30 m}", "{type: hook_300, height: 29 m}"),
    ):
        assert given in text
        text = text.replace(given, other)
    return simulate(parse_scenario(text, str(FILE)))


def test_load_cell_readings_in_waves(run: Recording) -> None:
    """One hook bears what the stand does not: with 120.5 t of module and what slings lump on it, and 11 t of
    hook block, falls and upper halves of slings, the reading at the share p is 11 t + p 120.5 t.
    """
    subject = Subject(run)
    (hook,) = run.rig.hooks
    (load,) = run.rig.loads
    row = hook_row(subject, hook)
    weight = load.weight / run.rig.gravity
    # Module, and at its lugs half of each sling and one shackle: 120 t + 4 (179.6 / 2 + 27) kg.
    assert weight == pytest.approx(120e3 + 4 * (179.6 / 2 + 27.0), rel=1e-4)
    static = subject.static(run.column("hoist_load", hook.name))
    assert static is not None
    tare = static / run.rig.gravity - weight
    expected = [(tare + part * weight) / 1e3 for part in (0.25, 0.5, 0.75, 1.0)]  # [t]
    # Readings are shown to 0.1 t.
    assert [float(one) for one in row["readings"]] == pytest.approx(expected, abs=0.05 + 1e-6)
    assert row["readings"][-1] == row["static"]


def test_what_stops_the_lift_is_the_mean(run: Recording) -> None:
    """In waves a load cell goes up and down by more than a tenth, as it should."""
    (said, *_) = stop_if(Subject(run))
    assert said.startswith("the mean of a load cell over some waves differs by more than 10 %")


def test_hold_points_are_told_as_those_of_a_moment(run: Recording) -> None:
    """The table of a run said so, and that of the report, by which load cells may be read, did not."""
    content = HoldPoints().content(Subject(run))
    assert content is not None and content["by"] == "waves"
