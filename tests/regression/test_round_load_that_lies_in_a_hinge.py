"""A column that lies in a hinge with its head on the ground was refused at rest as one that rolls.

The hinge keeps it from rolling.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from round_lift import round_lift, simulated

WEIGHT, STIFFNESS = 200e3 * 9.81, 200e6


def test_lies_on_the_rim_of_its_head(tmp_path: Path) -> None:
    """Half of its weight is in the pins at one end, half on the rim at the other, which sinks by that over
    twice the stiffness of a corner.
    """
    given = round_lift(
        {"diameter": "5 m", "length": "20 m"},
        (0, 0, 2.5),
        load={"stands_on": "ground"},
        ground={"level": "0 m", "stiffness": f"{STIFFNESS!r} N/m", "damping": "2 MN s/m"},
        hinges={"foot": {"at": ["-10 m", "0 m", "2.5 m"], "axis": [0, 1, 0]}},
        start="rest",
    )
    recording = simulated(tmp_path, given)
    # The lever of its weight is 10 m, that of its rim 20 m, less 2.5 m times the tilt of 1e-4.
    assert recording.column("contact_force", "column.rim_2")[-1] == pytest.approx(WEIGHT / 2, rel=2e-5)
    tilt = WEIGHT / 2 / (2 * STIFFNESS) / 20.0
    assert recording.column("load_tilt", "column") == pytest.approx(tilt, rel=1e-4)
    assert recording.column("hinge_force", "foot")[-1] == pytest.approx(WEIGHT / 2, rel=2e-5)
