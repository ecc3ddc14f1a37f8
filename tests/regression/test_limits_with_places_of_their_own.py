"""`clearance: 1 m` under `limits` was answered with twelve of its fifty keys, and none of them is about that.

Distances have a list of their own, and the wind in which a crane may lift is one of its own figures.
"""

from __future__ import annotations

import pytest

from gantline.scenario import ScenarioError, parse_scenario
from lift_text import spoiled


@pytest.mark.parametrize(
    ("key", "right"),
    [
        ("clearance: 1 m", "stand under 'watch', each with its 'smallest'"),
        ("wind_speed: 9 m/s", "may lift is its own 'wind_limit', held against that of the lift"),
    ],
)
def test_where_they_stand_is_said(key: str, right: str) -> None:
    with pytest.raises(ScenarioError) as refused:
        parse_scenario(spoiled("rule: example,", f"rule: example, {key},"))
    says = str(refused.value)
    assert f"limits.{key.split(':')[0]}" in says and says.rstrip().endswith(right)
