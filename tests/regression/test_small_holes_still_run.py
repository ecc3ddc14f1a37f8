"""A tank that still drained as the run ended, and was said to have come to what was in it then.

Liquid counted as still running where the last twentieth of a run changed it by more than a hundredth of what
the tank holds. 49.2 t that drain through 15 cm² lose 4.1 t in 800 s and a two hundredth of the tank in the
last 40 s: the first page of the report said that 45.1 t were in it from 791 s on, and nothing warned. Of more
than six tanks with holes the others were left out without a word.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from ballasted import barge, lift, tank
from gantline.report.afloat import afloat_facts
from gantline.report.subject import Subject
from gantline.results.afloat.tanks import ran_through_holes
from gantline.results.rig import Rig, Tank
from gantline.simulation import Simulation

TIME = np.linspace(0.0, 800.0, 8001)


def goes_on(content: Any) -> bool:
    """What is said of a tank of 100 t with holes whose content goes so [kg]."""
    rig = Rig(tanks=[Tank("barge.room", 0.0, 100e3, holes=["gash"])])
    (ran,) = ran_through_holes(rig, TIME, {"barge.room": content})
    return ran.goes_on


@pytest.mark.parametrize("rate", [0.1, 5.0, 100.0])
def test_what_runs_evenly_still_runs(rate: float) -> None:
    """From 0.1 to 100 kg/s, of 100 t."""
    assert goes_on(100e3 - rate * TIME)


def test_what_rests_or_goes_to_and_fro_does_not() -> None:
    """A tank that has been empty for 100 s, and one on a vessel that rolls about levels that are equal."""
    assert not goes_on(np.maximum(70e3 - 100.0 * TIME, 0.0))
    flooded = 50e3 - 50e3 * np.exp(-TIME / 60.0)
    assert not goes_on(flooded + 500.0 * np.sin(2 * np.pi * TIME / 12.0))
    assert not goes_on(np.full(len(TIME), 50e3))


def test_of_many_tanks_the_report_says_how_many_more_there_are() -> None:
    """Eight rooms, of which six have a row."""
    rooms = {}
    for number in range(8):
        x = 10.0 + 10.0 * number
        rooms[f"room{number}"] = tank((x, 0.0, 0.0), 0.0, (5.0, 5.0, 6.0))
        rooms[f"room{number}"]["holes"] = {"gash": {"at": [f"{x} m", "0 m", "0 m"], "area": "1 m^2"}}
    run = Simulation(lift(barge(rooms), duration="2 s", start="as_given")).run()
    facts = [fact for fact in afloat_facts(Subject(run)) if fact[0].startswith("holes")]
    assert len(facts) == 7
    assert facts[-1] == ("holes", "of 2 more tanks")
