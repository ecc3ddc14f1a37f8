"""A measure in place of a list of three was answered with measures of something else.

`envelope: 0.5 m`, which people write of a centre of gravity that may be off by that much any way, was
answered by "a list of 3 is needed, such as [23 m, 23 m, 23 m]". It repeats the measure now, as was meant.
"""

from __future__ import annotations

import pytest

from gantline.scenario import ScenarioError, parse_scenario
from lift_text import changed

LIFT = """\
format: 1
lift: {title: One measure}
duration: 1 s
load:
  name: box
  shape: {box: [4 m, 4 m, 2 m]}
  weight: {calculated: 10 t}
  centre_of_gravity: {at: [0 m, 0 m, 1 m], envelope: 0.5 m}
"""


def told(lift: str) -> str:
    with pytest.raises(ScenarioError) as caught:
        parse_scenario(lift)
    return str(caught.value)


def test_the_measure_is_repeated() -> None:
    right = "found '0.5 m'; a list of 3 is needed, such as [0.5 m, 0.5 m, 0.5 m]"
    assert f"8: load.centre_of_gravity.envelope: {right}" in told(LIFT)


def test_what_is_none_is_not() -> None:
    assert "found '0.5 kN'; a list of 3 is needed, such as [23 m, 23 m, 23 m]" in told(
        changed(LIFT, ("envelope: 0.5 m", "envelope: 0.5 kN"))
    )
