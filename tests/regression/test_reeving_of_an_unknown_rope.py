"""A misspelt rope in the reeving of a hook whose drum counts its layers.

The drum asks its rope for a diameter before names are checked: `KeyError: 'hoist_24'` with a traceback, where
the same mistake at a drum without `wraps_at_start` was told with line and path.
"""

from __future__ import annotations

from pathlib import Path

import pytest

import gantline
from gantline.scenario import parse_scenario

LIFT = Path(gantline.__file__).parent / "scenarios" / "reeved_hoist.yaml"


def test_it_is_told_with_its_place() -> None:
    text = LIFT.read_text(encoding="utf-8")
    assert "wraps_at_start" in text and text.count("rope: hoist_42") == 1
    with pytest.raises(gantline.ScenarioError, match=r"reeving\.rope: 'hoist_24' is not a name of 'ropes'"):
        parse_scenario(text.replace("rope: hoist_42", "rope: hoist_24"))
