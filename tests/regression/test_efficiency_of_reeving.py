"""A loss that was written as the efficiency of a hook's sheaves.

`sheaves: {efficiency: ...}` was held against what sheaves can have, `sheave_efficiency` of a reeving was
not: 2 % or 0.02 was simulated as it stood, with every part of line carrying a fiftieth of the one before,
and 98 was refused by the core, at the crane, in words of its equations.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from gantline.scenario import ScenarioError, load_scenario

LIFT = Path(__file__).resolve().parents[2] / "scenarios" / "reeved_hoist" / "scenario.yaml"
PLACE = "cranes.hook.reeving.sheave_efficiency"


@pytest.mark.parametrize(
    ("found", "says"),
    [
        ("0.02", "0.02 is no efficiency of a sheave; 0.95 to 1 is usual, or write 'sheaves: {loss: 2 %}'"),
        ("2 %", "0.02 is no efficiency of a sheave"),
        ("98", "98 is above 1; no sheave gives force back"),
    ],
)
def test_what_no_sheave_has_is_refused_at_its_key(found: str, says: str) -> None:
    with pytest.raises(ScenarioError) as refused:
        load_scenario(LIFT).changed({PLACE: found})
    assert f"{PLACE}: {says}" in str(refused.value)


def test_percent_is_an_efficiency_too() -> None:
    assert load_scenario(LIFT).changed({PLACE: "98 %"}).starts_at_rest
