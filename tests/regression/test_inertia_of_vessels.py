"""Radii of gyration in the wrong order, and added mass in kilograms where tonnes are meant: in order, both.

`radii_of_gyration: [26 m, 10 m, 27 m]` of a barge of 90 × 30 m are those about y, x, z, and `heave: 16000
kg` is a thousandth of its added mass: periods and motions were of another vessel, without a word.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from afloat import BREADTH, LENGTH, MASS, barge, lift_of, written
from gantline.assembly import assemble
from gantline.scenario import load_scenario

#: Of a barge of 100 × 30 m, 12 300 t, as plausible.
ADDED = {"heave": "30000 t", "sway": "4000 t", "roll": "1e6 t m^2", "pitch": "2e7 t m^2"}


def doubts(folder: Path, **vessel: Any) -> list[str]:
    return list(assemble(load_scenario(written(folder, lift_of(barge(**vessel))))).warnings)


@pytest.mark.parametrize(
    ("radii", "said"),
    [
        (("27 m", "11 m", "27 m"), "along a long hull the first is the smallest; see their order"),
        (("1.1 m", "27 m", "27 m"), "usual about x is 7.5 m to 13.5 m"),
        (("11 m", "110 m", "110 m"), "usual about y is about 27.0 m"),
    ],
)
def test_radii_out_of_scale_are_told(tmp_path: Path, radii: tuple[str, ...], said: str) -> None:
    [sentence] = doubts(tmp_path, radii_of_gyration=list(radii))
    assert sentence.startswith("barge has radii of gyration of ")
    assert f"is {LENGTH:g} m long, {BREADTH:g} m wide" in sentence
    assert sentence.endswith(said)


def test_an_inertia_is_told_by_its_radii(tmp_path: Path) -> None:
    """i = sqrt(I/m), of 11 m and 27 m that about x and y given the other way round."""
    xx, yy = (f"{MASS / 1e3 * radius**2!r} t m^2" for radius in (11.0, 27.0))
    given = {"radii_of_gyration": None, "inertia": {"xx": yy, "yy": xx, "zz": yy}}
    vessel = {key: value for key, value in barge(**given).items() if value is not None}
    [sentence] = assemble(load_scenario(written(tmp_path, lift_of(vessel)))).warnings
    assert "27.0 m, 11.0 m, 27.0 m about x, y, z" in sentence


@pytest.mark.parametrize(("key", "slipped"), [("heave", "30000 kg"), ("sway", "4000 kg")])
def test_added_mass_out_of_scale_is_told(tmp_path: Path, key: str, slipped: str) -> None:
    [sentence] = doubts(tmp_path, added_mass=ADDED | {key: slipped})
    mass = f"{float(slipped.split()[0]) / 1e3:g} t"
    said = f"barge has {mass} of added mass in {key}, and displaces 12,300 t at its draft: a unit has slipped"
    assert sentence == said


@pytest.mark.parametrize(("key", "slipped"), [("roll", "1e6 kg m^2"), ("pitch", "2e7 kg m^2")])
def test_added_inertia_out_of_scale_is_told(tmp_path: Path, key: str, slipped: str) -> None:
    [sentence] = doubts(tmp_path, added_mass=ADDED | {key: slipped})
    assert f" t m^2 of added mass in {key}, and displaces 12,300 t" in sentence


def test_nothing_is_said_of_what_is_plausible(tmp_path: Path) -> None:
    assert not doubts(tmp_path, added_mass=ADDED)
