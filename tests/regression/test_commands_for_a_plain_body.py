"""A program that commands a body of `mechanics`, such as a trolley on a slider with a `motion`.

It was told "'trolley' is nothing in this lift that can move; there is none" of what moved before its eyes.
"""

from __future__ import annotations

import pytest

import gantline
from gantline import CommandError
from gantline.scenario import parse_scenario

_TROLLEY = {
    "format": 1,
    "lift": {"title": "A trolley"},
    "duration": "5 s",
    "mechanics": {
        "bodies": {
            "trolley": {
                "joint": {
                    "type": "slider",
                    "axis": [1, 0, 0],
                    "motion": [{"at": "1 s", "duration": "1 s", "velocity": "0.5 m/s"}],
                },
                "mass": "5 t",
            }
        }
    },
}


def test_a_body_of_mechanics_is_told_what_takes_commands() -> None:
    run = gantline.Simulation(parse_scenario(_TROLLEY))
    with pytest.raises(CommandError) as refused:
        run.command("trolley", speed=0.2)
    assert str(refused.value) == (
        "'trolley' is a body of 'mechanics', and moves as its joint lets it; commands are for hooks, "
        "trolleys, cranes, booms, drums, winches and chain hoists; this lift has none"
    )
