"""Arguments of the Python interface that are of another kind than asked for were answered from inside.

`sensitivities(("length", "sling.S1"))`, a pair in place of a list of pairs, ended with "too many values to
unpack"; `run_sweep` from 22 to 24, numbers without a unit, with "object of type 'int' has no len()"; and
`changed` with a list with "'list' object has no attribute 'items'". Each says now what it takes.
"""

from __future__ import annotations

from typing import Any

import pytest

import gantline
from gantline.units import UnitError


@pytest.mark.parametrize("asked", [("length", "sling.S1"), "length", [("length",)], [3]])
def test_sensitivities_are_asked_for_by_pairs(asked: Any) -> None:
    """A pair by itself, a word, a pair with one half: none is a list of pairs."""
    statics = gantline.Statics("equalizer")
    with pytest.raises(TypeError, match=r'parameters: .* is no pair of .* such as \("length", "sling.S1"\)'):
        statics.sensitivities(asked)


def test_a_sweep_goes_between_quantities() -> None:
    """A number has no unit, wherever it comes from."""
    first: Any = 22
    with pytest.raises(UnitError, match=r"found '22'; a length is written like"):
        next(gantline.study.run_sweep("equalizer", "slings.S1.length", first, "24 m", 3))


def test_changes_are_a_mapping() -> None:
    """A list of paths says not what stands there."""
    lift = gantline.load_scenario("equalizer")
    with pytest.raises(TypeError, match=r"values: a mapping from paths to values is needed, not list"):
        lift.changed(["slings.S1.length"])  # type: ignore[arg-type]
