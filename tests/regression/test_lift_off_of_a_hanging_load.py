"""A load that hangs as the run begins and bounces as it is set down.

It leaves no support, so it has no lift-off. The moment at which it left the ground again after its first
touch counted as one: a pipe spool that is let down through a hatch had its lift-off at 478 s, at the foot of
its way, in table, report and player. The first page of other loads that hang said `never clear of a support`.
And of a load that comes down again in waves the table knew the first time alone at which it was clear.
"""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from gantline import Recording, simulate
from gantline.cli.summary import summary
from gantline.report.attitude import attitude
from gantline.report.subject import Subject
from gantline.results.loads.lift_off import lift_off_in_words
from gantline.scenario import parse_scenario
from hung_box import hung_box
from lift_text import changed

#: Let down at 0.4 m/s onto ground that throws it up again, and lifted off once more.
LIFT = (
    """\
format: 1
lift: {title: A box is put down hard}
duration: 8 s
ground: {stiffness: 20 MN/m, damping: 0 N s/m}
ropes: {soft: {axial_stiffness: 20 MN, damping_time: 10 ms}}
"""
    + hung_box("0 m, 0 m, 0.5 m", "0 m, 0 m, 7.5 m", "speed: 30 m/min, acceleration: 1 m/s^2")
    + """\
plan:
  - {step: down, lower: hook, speed: 24 m/min, by: 0.7 m}
  - {step: wait, hold: 2 s}
"""
)
UP = "  - {step: up, hoist: hook, speed: 24 m/min, by: 1 m}\n  - {step: end, hold: until_end}\n"


@pytest.fixture(scope="module", params=[LIFT, LIFT + UP], ids=["put down", "lifted again"])
def put_down(request: pytest.FixtureRequest) -> Iterator[Recording]:
    recording = simulate(parse_scenario(request.param))
    touched, left = (recording.events(kind)[0][0] for kind in ("set_down", "lift_off"))
    assert 1.0 < touched < left < touched + 0.5  # it bounces
    yield recording


def test_no_lift_off(put_down: Recording) -> None:
    """A load that hangs clear as the run begins has no lift-off, in metrics, table and report alike."""
    assert "lift_off_time" not in put_down.metrics()
    (row,) = [line.split() for line in summary(put_down, [], str) if line.startswith("  lift-off")]
    assert row == ["lift-off", "clear", "from", "the", "start"]
    assert dict(attitude(Subject(put_down)))["lift-off"] == "clear from the start"


def test_for_good() -> None:
    """A load that stands, is lifted, put down and lifted again: when it came clear first, and for good."""
    standing = changed(LIFT + UP, ("at: [0 m, 0 m, 7.5 m]", "at: [0 m, 0 m, 6.9 m]"),
                       ("position: [0 m, 0 m, 0.5 m]", "position: [0 m, 0 m, 0 m]"),
                       ("plan:\n", "plan:\n  - {step: off, hoist: hook, speed: 12 m/min, by: 0.2 m}\n"),
                       ("by: 0.7 m", "by: 0.2 m"))  # fmt: skip
    recording = simulate(parse_scenario(standing))
    left = [time for time, _, _ in recording.events("lift_off")]
    assert len(left) > 1
    assert recording.metrics()["lift_off_time"] == left[0]
    assert lift_off_in_words(recording, 2) == f"at {left[0]:.2f} s, for good at {left[-1]:.2f} s"
