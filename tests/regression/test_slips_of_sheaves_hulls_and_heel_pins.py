"""Slips that `gantline check` had in order: sheaves in mm, a hull in kg, heel pins with the wrong sign.

`sheave_diameter: 1.0 mm` of a hook was told by a run alone, a hull of 110 m with `mass: 18000 kg` by the
draft at which it then started, and heel pins 9 m below the keel by nothing.
"""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import load_scenario


def _told(scenario: str, key: str, value: object) -> list[tuple[str, str]]:
    lift = load_scenario(scenario)
    before = {(one.path, one.sentence) for one in assemble(lift).doubts}
    doubts = assemble(lift.changed({key: value})).doubts
    return [(one.path, one.sentence) for one in doubts if (one.path, one.sentence) not in before]


@pytest.mark.parametrize(
    ("scenario", "key", "value", "sentence"),
    [
        (
            "goliath",
            "hook_types.hook_300.reeving.sheave_diameter",
            "1.0 mm",
            "the sheaves of goliath.U1 have a diameter of 1 mm, their rope is 42 mm thick; "
            "11 to 25 times that is usual, and a unit has slipped",
        ),
        # The box of 60 m by 24 m, 2 m deep in sea water, displaces 60 * 24 * 2 * 1.025 t = 2952 t.
        (
            "off_a_barge",
            "vessels.cargo.masses",
            {"hull": {"mass": "1000 kg", "at": ["30 m", "0 m", "2.2 m"]}},
            "cargo weighs 1 t with its tanks, and displaces 2,950 t at its draft: "
            "a unit has slipped, kg for t",
        ),
        (
            "off_a_barge",
            "cranes.sheerleg.boom.heel_pins.at",
            ["84 m", "0 m", "-7.5 m"],
            "the heel pins of sheerleg are 7.5 m below the keel of barge; heights count up from it",
        ),
    ],
)
def test_it_is_told_at_its_key(scenario: str, key: str, value: object, sentence: str) -> None:
    assert (key, sentence) in _told(scenario, key, value)
