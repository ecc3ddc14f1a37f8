"""A skid that came down beside both its landing guides: the first page of its report said "none is touched".

That stood in the row of the largest force of a guide, as if the load had come down between its guides without
pressing on them. The warning of the run was the last of ten, of which the first page shows four.
"""

from __future__ import annotations

from gantline.report.attitude import attitude
from gantline.report.subject import Subject
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from guided_lift import guided_lift

PLAN = "  - {step: lower, lower: crane, speed: 6 m/min, by: 1.0 m}\n  - {step: rest, hold: until_end}\n"


def _rows(at: float) -> dict[str, str]:
    """Rows of a load that comes down by a metre onto the ground, with a fork over a post at a place [m]."""
    guide = (
        f"  g: {{post: {{at: [{at} m, 0 m, 0 m], diameter: 0.1 m, height: 0.8 m}}, "
        "frame: {at: [3.5 m, 0 m, 0 m], clearance: 30 mm, height: 0.3 m, sides: [fore, aft]}, "
        "friction: 0.2}\n"
    )
    lift = guided_lift(guide, height=1.0, plan=PLAN, duration=14.0)
    return dict(attitude(Subject(simulate(parse_scenario(lift)))))


def test_a_guide_that_was_missed_is_named() -> None:
    """Its post stands 0.5 m ahead of where the middle of the frame comes down: outside of the fork."""
    assert _rows(4.0)["missed by the load"] == "guide g"


def test_a_guide_that_was_met_is_not() -> None:
    """The post stands in the middle of its fork."""
    assert "missed by the load" not in _rows(3.5)
