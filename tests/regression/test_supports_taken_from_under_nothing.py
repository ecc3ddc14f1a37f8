"""A trailer that drove out from under a reactor that hung clear was four warnings, `under 0 kN`.

Taking supports away from under a load that hangs is what the step is for; under a force it is a drop. Of
one that is taken away as the run begins no sample shows what it bore, which was told as `under 0 kN` too."""

from __future__ import annotations

import pytest

import gantline
from four_slings import LIFT
from gantline.scenario import parse_scenario

STOOLS = """\
supports:
  stools: {under: module, grid: {x: [-2 m, 2 m], y: [-1 m, 1 m]}, height: 0.5 m, stiffness: 100 MN/m}
cranes:
"""
TEXT = (
    LIFT.replace("  stands_on: ground\n", "  stands_on: stools\n  position: [0 m, 0 m, 0.5 m]\n")
    .replace("cranes:\n", STOOLS)
    .replace("11 m]", "11.5 m]")
)
HOLD = "{step: hold point, hold: 20 s}"
FIRST = "plan:\n"


def warned(text: str) -> list[str]:
    recording = gantline.simulate(parse_scenario(text))
    assert len(recording.events("support_removed")) == 4
    return [one for one in recording.attributes["warnings"] if "is taken away" in one]


def test_from_under_a_load_that_hangs_nothing_is_said() -> None:
    assert not warned(TEXT.replace(HOLD, "{step: out, hold: 20 s, remove_supports: stools}"))


@pytest.mark.parametrize(
    ("wait", "told"),
    [
        ("  - {step: wait, hold: 2 s}\n", "at 2.00 s under 98 kN"),
        ("", "as the run begins, whatever stands on it"),
    ],
)
def test_from_under_one_that_stands_it_is_told(wait: str, told: str) -> None:
    """Each has a quarter of 40 t and of 0.13 t of slings on it, 98.4 kN."""
    out = "  - {step: out, hold: 5 s, remove_supports: stools}\n"
    warnings = warned(TEXT.replace(FIRST, f"{FIRST}{wait}{out}"))
    assert len(warnings) == 4
    assert all(one.endswith(f"is taken away {told}") for one in warnings)
