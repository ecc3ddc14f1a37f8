"""A vessel that heeled by 12 degrees was a GO where the lift file set no limit: its freeboard alone counted.

A load that tilts by more than 5 degrees was told without a limit, and so was a spreader; vessels were not.
"""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import gantline
from afloat import BREADTH, DEPTH, DRAFT, KG, LENGTH, MASS, barge, lift_of, written
from gantline.checks import Check, Verdict
from gantline.scenario import load_scenario
from of_recording import checks_of

#: Of a box: BM = B^2/12T, GM = T/2 + BM - KG [m].
BM = BREADTH**2 / (12 * DRAFT)
GM = DRAFT / 2 + BM - KG


def heeled(folder: Path, degrees: float, **changes: object) -> Check:
    """A barge that weights aside of its middle heel to starboard: y = (GM + BM/2 tan^2) tan by Scribanti."""
    lean = math.tan(math.radians(degrees))
    aside = (GM + BM / 2 * lean**2) * lean
    masses = {"hull": {"mass": f"{MASS} kg", "at": [f"{LENGTH / 2} m", f"{-aside} m", f"{KG} m"]}}
    given = lift_of(barge(masses=masses), **changes)
    recording = gantline.Statics(load_scenario(written(folder, given))).equilibrium(time=0.0).recording
    [check] = checks_of(recording, "heel")
    assert check.value == pytest.approx(math.radians(degrees), rel=1e-3)
    return check


def test_more_than_five_degrees_are_told(tmp_path: Path) -> None:
    """12 degrees: the deck's edge is DEPTH - DRAFT - B/2 tan 12 deg = 0.81 m over the water."""
    assert DEPTH - DRAFT - BREADTH / 2 * math.tan(math.radians(12.0)) > 0.8
    check = heeled(tmp_path, 12.0)
    assert (check.verdict, check.element) == (Verdict.WARNING, "barge")
    assert check.limit == pytest.approx(math.radians(5.0))


def test_less_is_not(tmp_path: Path) -> None:
    assert heeled(tmp_path, 4.5).verdict is Verdict.NOT_CHECKED


def test_a_limit_of_its_own_counts(tmp_path: Path) -> None:
    assert heeled(tmp_path, 12.0, limits={"rule": "own", "heel": "15 deg"}).verdict is Verdict.OK
