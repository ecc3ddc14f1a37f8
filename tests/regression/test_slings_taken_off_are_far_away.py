"""A watched pair whose ropes have all been taken off failed its clearance, but only once it was read back.

Nothing is left to come near then: the distance is infinite. A file that was read had no number there, as of
a damaged one, and `gantline check`, `compare` and `report` told NO-GO by `clearance_margin`, `nan m`, of a
lift of which the run itself had said GO: of any that watches `slings` and takes them off.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import gantline
from gantline.checks import check_recording
from gantline.results.recording import Recording
from gantline.results.variable import Variable

LIFT = Path(__file__).resolve().parents[2] / "scenarios" / "onto_a_platform"


@pytest.fixture(scope="module")
def begun() -> Recording:
    """The first tenth of a second of a lift that watches its slings."""
    return gantline.simulate(LIFT, duration=0.1)


def with_distance(begun: Recording, distance: float) -> Recording:
    """The same with another distance of slings and load."""
    apart = begun["clearance"]
    values = apart.values.copy()
    values[-1, begun.coordinates["pair"].index("slings - skid")] = distance
    changed = Variable(apart.dims, values, apart.unit, apart.description)
    return Recording({**begun.variables, "clearance": changed}, begun.coordinates, begun.attributes)


def test_what_is_read_is_what_was_made(begun: Recording, tmp_path: Path) -> None:
    made = with_distance(begun, np.inf)
    read = gantline.open_recording(made.save(tmp_path / "recording.nc"))
    assert np.array_equal(read["clearance"].values, made["clearance"].values)
    found = [[one.to_json() for one in check_recording(each)] for each in (made, read)]
    assert found[0] == found[1]
    (margin,) = (one for one in found[0] if one["name"] == "clearance_margin")
    assert margin["value"] is not None and np.isfinite(margin["value"]), "of the other pairs"


def test_nothing_is_nearer_than_nowhere(begun: Recording, tmp_path: Path) -> None:
    """Minus infinity is no distance: a gap, as other infinite values are."""
    made = with_distance(begun, -np.inf)
    read = gantline.open_recording(made.save(tmp_path / "recording.nc"))
    assert int(np.isnan(read["clearance"].values).sum()) == 1
