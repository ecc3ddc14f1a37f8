"""Supports of an engine seating stood on a level 3 m under the ground, and the lift file was in order.

`foot: 0 m` was the water, the quay and the tank top lay at 3 m. Nothing would have come down on them: the
engine landed on the ground, and who looked for its seating found forces of 0 kN.
"""

from __future__ import annotations

import pytest

from four_slings import LIFT
from gantline.assembly import assemble
from gantline.scenario import parse_scenario

SEATING = """\
supports:
  seating: {{under: module, measured_from: world,
            places: {{A: {{at: [{x} m, 0 m]}}, B: {{at: [{x} m, 2 m]}}}},
            foot: {foot} m, height: 1 m, stiffness: 100 MN/m}}
structures: {{dock: {{type: dock, x: [30 m, 60 m], y: [-9 m, 9 m], floor: -8 m}}}}
cranes:
"""


@pytest.mark.parametrize(
    ("x", "foot", "deep"),
    [
        (20.0, 0.0, None),
        (20.0, -3.0, "2.00 m"),
        (40.0, -8.0, None),  # on the floor of the dock
        (40.0, -10.0, "1.00 m"),
    ],
)
def test_tops_under_the_ground_are_told(x: float, foot: float, deep: str | None) -> None:
    text = LIFT.replace("cranes:\n", SEATING.format(x=x, foot=foot))
    told = [one for one in assemble(parse_scenario(text)).warnings if "under the ground" in one]
    assert len(told) == (deep is not None)
    for one in told:
        assert one == (
            f"tops of 2 of 2 lie up to {deep} under the ground: 'seating.A', 'seating.B'; a load that comes "
            "down there stands on the ground; see their 'foot' and 'height'"
        )
