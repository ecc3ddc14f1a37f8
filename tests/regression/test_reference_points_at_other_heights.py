"""The height of a database's reference point was taken as given, and its two places aboard side by side.

`crane_barge.nc` counts from the water, 3 m above the keel. With `at: [45 m, 0 m, 0 m]`, the keel,
everything was in order: waves from abeam then pushed 3 m too low, and the barge heeled by other angles. So
it was where `wave_forces` had the point at the keel and `radiation` the same point of the same file at the
water.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from gantline.assembly import assemble
from gantline.hydro import read_database
from gantline.scenario import load_scenario

FOLDER = Path(__file__).parents[2] / "scenarios/crane_barge_in_swell"


def doubts(**heights: float) -> list[str]:
    """Of reference points amidships at heights over the keel [m], by key."""
    lift = load_scenario(FOLDER / "scenario.yaml")
    at = {f"vessels.barge.{key}.at": ["45 m", "0 m", f"{z} m"] for key, z in heights.items()}
    return list(assemble(lift.changed(at)).warnings)


def test_the_file_counts_from_the_water() -> None:
    reference = read_database(FOLDER / "crane_barge.nc").reference
    assert reference is not None and reference[2] == 0.0


@pytest.mark.parametrize(
    ("height", "where"), [(0.0, "3.00 m below"), (-3.0, "6.00 m below"), (6.5, "3.50 m above")]
)
def test_another_height_is_told(height: float, where: str) -> None:
    """The draft of the lift file is 3 m: z = 3 m is at the water."""
    [sentence] = doubts(wave_forces=height, radiation=height)
    assert sentence == (
        f"wave_forces of barge: the reference point of crane_barge.nc (Capytaine) is at the water, 'at' "
        f"{where} the water at the draft of the lift file; 'at' counts from the keel, so that its z is 3.00 m"
    )


def test_two_places_of_one_file_are_told() -> None:
    [sentence] = doubts(wave_forces=3.0, radiation=3.4)
    at = "'at' is (45, 0, 3.4) m and that of 'wave_forces' (45, 0, 3) m"
    assert sentence == f"radiation of barge: {at}; a file has one reference point"


def test_nothing_is_said_of_a_little_more_draft() -> None:
    assert not doubts(wave_forces=3.4, radiation=3.4)
