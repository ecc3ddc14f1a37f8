"""A vessel that its lines held 18 m from where the lift file has it was GO at rest, with 0 warnings.

With the sign of one anchor of four slipped, `to: [-340 m, ...]` for 340 m, a crane barge lay 10.8 m aft and
14.1 m to starboard with one line nearly slack. A run warned of it where it began at rest; `gantline statics`
wrote how the vessel lies in a line of its table and gave a verdict as if it were meant.
"""

from __future__ import annotations

import json

import pytest

from afloat import DRAFT, barge, lift_of
from gantline.scenario import Scenario, parse_scenario
from gantline.statics import Statics
from gantline.units import quantity

#: Two lines ahead and astern, straight and level, of 100 m from end to end.
EA, APART = 1e6, 100.0


def moored(ahead: str, astern: str, **changes: object) -> Scenario:
    """A barge of 100 m between two lines with these pretensions."""
    level = f"{8.0 - DRAFT} m"
    lines = {
        "ahead": (ahead, "100 m", "200 m"),
        "astern": (astern, "0 m", "-100 m"),
    }
    of = {
        name: {
            "vessel": "barge",
            "fairlead": [x, "0 m", "8 m"],
            "to": [to, "0 m", level],
            "rope": "soft",
            "type": "spring",
            "pretension": pull,
            "winch": {"speed": "1 m/min", "acceleration": "0.01 m/s^2"},
        }
        for name, (pull, x, to) in lines.items()
    }
    soft = {"axial_stiffness": "1 MN", "damping_time": "0.1 s", "mass": "none"}
    return parse_scenario(
        json.dumps(lift_of(barge(), ropes={"soft": soft}, mooring_lines=of, water={}, **changes))
    )


def told(scenario: Scenario) -> list[str]:
    return [one for one in Statics(scenario).equilibrium().recording.attributes["warnings"] if "rests" in one]


def aside(ahead: str, astern: str) -> float:
    """How far the barge goes ahead [m]: both pull alike there, with EA over their unstretched lengths."""
    pulls = [quantity(one, "force") for one in (ahead, astern)]
    stiffness = [EA * (1 + pull / EA) / APART for pull in pulls]
    return (pulls[0] - pulls[1]) / sum(stiffness)


def test_one_pretension_ten_times_too_high() -> None:
    way = aside("300 kN", "30 kN")
    assert way == pytest.approx(11.59, abs=0.01)
    assert told(moored("300 kN", "30 kN")) == [
        f"barge rests {way:.1f} m from where the lift file has it: see its mooring lines, their ends and "
        "pretensions, and what pulls or pushes it"
    ]


def test_lines_that_nearly_agree() -> None:
    """Half a metre is what lines are set to."""
    assert aside("40 kN", "30 kN") == pytest.approx(0.483, abs=0.001)
    assert told(moored("40 kN", "30 kN")) == []


@pytest.mark.parametrize("is_hauled", [False, True])
def test_a_plan_that_hauls(is_hauled: bool) -> None:
    """It takes its vessel along on purpose."""
    step = {"step": "haul", "haul": "ahead", "speed": "1 m/min", "by": "0.1 m"}
    plan = [step] if is_hauled else [{"step": "hold", "hold": "5 s"}]
    scenario = moored("300 kN", "30 kN", plan=plan, duration="20 s")
    assert bool(told(scenario)) is not is_hauled
