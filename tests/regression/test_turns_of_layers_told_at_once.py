"""A drum of three layers that says no turns was told one of the keys that it needs, and only then the other.

Whoever wrote `drum: {diameter: 0.8 m, layers: 3}` was answered with `wraps_per_layer: 30`, wrote that, and
was answered with `wraps_at_start: 30` by the next `gantline check`. What is wrong is told at once.
"""

from __future__ import annotations

import pytest

from gantline import ScenarioError, parse_scenario

LIFT = """\
format: 1
lift: {{title: A winch of three layers}}
duration: 1 s
ropes:
  r: {{axial_stiffness: 60 MN, damping_time: 10 ms, mass: none, diameter: 28 mm}}
mechanics:
  bodies:
    weight: {{at: [0 m, 0 m, 0 m], joint: {{type: slider, axis: [0, 0, 1]}}, mass: 5 t}}
  drums:
    winch: {{diameter: 0.8 m, rotating_mass: 2 t, layers: 3{turns},
            drive: {{speed: 30 m/min, acceleration: 0.2 m/s^2}}}}
  ropes:
    r:
      rope: r
      length: as_routed
      route:
        - {{type: end, body: world, at: [0 m, 0 m, 20 m], drum: winch}}
        - {{type: end, body: weight}}
"""


@pytest.mark.parametrize(
    ("turns", "said"),
    [
        ("", "needs 'wraps_per_layer' and 'wraps_at_start' to know the layer, such as "),
        (", wraps_per_layer: 30", "needs 'wraps_at_start' to know the layer, such as 'wraps_at_start: 20'"),
        (", wraps_at_start: 20", "needs 'wraps_per_layer' to know the layer, such as 'wraps_per_layer: 30'"),
    ],
)
def test_all_that_is_missing_is_said(turns: str, said: str) -> None:
    """Each key that is missing, and no other."""
    with pytest.raises(ScenarioError) as refused:
        parse_scenario(LIFT.format(turns=turns))
    assert said in str(refused.value)
    assert str(refused.value).count("to know the layer") == 1


def test_what_the_message_shows_is_right() -> None:
    """Its example makes the lift file right."""
    with pytest.raises(ScenarioError) as refused:
        parse_scenario(LIFT.format(turns=""))
    example = str(refused.value).split("such as '")[1].split("'")[0]
    parse_scenario(LIFT.format(turns=f", {example}"))
