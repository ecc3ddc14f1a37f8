"""A round load in a cradle of supports was told to be 0.13 m in the same place as one that carried nothing.

Its bounding box is as low as its lowest line, and the flat top beside that is higher.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from gantline.results.loads import overlaps
from round_lift import round_lift, simulated


def test_a_top_that_its_curve_has_room_for_is_not_told(tmp_path: Path) -> None:
    """A load of 5 m across is 0.168 m up at 0.9 m from its lowest line, and 0.073 m at the inner edge of a
    top there. One 0.115 m up carries nothing; that edge is 0.042 m in the load, and its box 0.115 m.
    """
    places = {"al": (-6, -0.9), "ar": (-6, 0.9), "bl": (6, -0.9), "br": (6, 0.9), "low": (0, 0.9)}
    given = round_lift(
        {"diameter": "5 m", "length": "20 m"},
        (0.0, 0.0, 2.5),
        load={"position": ["0 m", "0 m", "1.5 m"], "stands_on": "cradle"},
        supports={
            "cradle": {
                "under": "column",
                "places": {
                    name: {"at": [f"{x} m", f"{y} m"], "height": "to_load" if name != "low" else "1.615 m"}
                    for name, (x, y) in places.items()
                },
                "stiffness": "400 MN/m",
                "damping": "4 MN s/m",
                "friction": 0.5,
            }
        },
        start="rest",
        duration="0.1 s",
    )
    recording = simulated(tmp_path, given)
    assert recording.column("contact_force", "support.cradle.low").max() == 0.0
    assert overlaps.overlaps(recording) == []
    bodies = {one.name: one for one in overlaps._bodies(recording, np.array([0]))}
    deep = overlaps._through(bodies["column"], bodies["cradle.low"], 0)
    # It has sunk by 490 kN over 400 MN/m, and its picture of 48 sides is up to 5 mm within it.
    assert 0.042 - 0.005 < deep < 0.042 + 0.005
