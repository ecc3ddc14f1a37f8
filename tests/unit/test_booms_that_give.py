"""Booms that give at their head: what a lift file may say of them, and what they take part in."""

from __future__ import annotations

import re

import numpy as np
import pytest

from boom_lift import TACKLES, boom_lift, simulated
from gantline.assembly import assemble
from gantline.scenario import ScenarioError, parse_scenario

RIGID = "mass: 1500 t,"


def gives(keys: str, **lift: str) -> str:
    """The lift with a boom that gives."""
    return boom_lift(**lift).replace(RIGID, f"{RIGID} {keys},")  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("keys", "lift", "said"),
    [
        (
            "vertical_stiffness: 15 MN/m",
            {"luffing": TACKLES},
            "cranes.fc.boom.vertical_stiffness: a boom in luffing tackles gives as their ropes stretch",
        ),
        (
            "side_stiffness: 15 MN/m",
            {"luffing": TACKLES},
            "cranes.fc.boom.side_stiffness: a boom in luffing tackles gives as their ropes stretch",
        ),
        ("damping: 2 %", {}, "cranes.fc.boom.damping: a boom that is rigid has nothing to damp"),
        (
            "vertical_stiffness: 15 MN/m, damping: 200 %",
            {},
            "cranes.fc.boom.damping: 200 % of critical damping; below 100 % is right",
        ),
        ("vertical_stiffness: 0 MN/m", {}, "cranes.fc.boom.vertical_stiffness"),
    ],
)
def test_what_cannot_be_is_refused(keys: str, lift: dict[str, str], said: str) -> None:
    with pytest.raises(ScenarioError, match=re.escape(said)):
        parse_scenario(gives(keys, **lift))


@pytest.mark.parametrize(
    ("keys", "said"),
    [
        # 3600 t x 9.81 m/s2 over 1.5 MN/m; 3.3 m are 3 % of 110 m.
        ("vertical_stiffness: 1.5 MN/m", "fc.boom would give by 23.54 m under the rated capacity"),
        ("side_stiffness: 0.5 MN/m", "fc.boom would give by 70.63 m under the rated capacity"),
        ("vertical_stiffness: 15 MN/m, side_stiffness: 3 MN/m", None),
    ],
)
def test_a_stiffness_of_another_unit_is_told(keys: str, said: str | None) -> None:
    told = [one for one in assemble(parse_scenario(gives(keys))).warnings if "stiffness has slipped" in one]
    assert [said in one for one in told if said is not None] == ([] if said is None else [True])
    assert said is not None or not told


def test_a_boom_without_luffing_gives_alike() -> None:
    """Held or luffed by nothing, it is the same boom at the same angle."""
    keys = "vertical_stiffness: 15 MN/m, side_stiffness: 6 MN/m"
    held, luffed = (
        simulated(gives(keys, luffing=one))
        for one in ("", "speed: 30 deg/min, acceleration: 0.05 deg/s^2, range: [40 deg, 80 deg]")
    )
    assert held["boom_angle"].values == pytest.approx(luffed["boom_angle"].values, abs=1e-12)
    assert np.isfinite(held["body_position"].values).all()
