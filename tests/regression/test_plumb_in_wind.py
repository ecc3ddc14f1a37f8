"""`--plumb` of a load in wind: no place of hooks could do it, and nothing said why.

"places of hooks cannot do all of what is wanted at once" was all that was told of two crawler cranes with a
beam in wind of 9 m/s, whose falls have to lean by what pushes it. Tag lines were named where they pull.
"""

from __future__ import annotations

import pytest

from gantline.scenario import parse_scenario
from gantline.study import CannotBeError, plumb_hooks
from upending import between_trolleys

AREAS = """\
  wind_areas: {end: {area: 9 m^2, coefficient: 1.2, along: x, at: [0 m, 0 m, 1.5 m]}}
"""


def lift(wind: str) -> str:
    text = between_trolleys("{step: rest, hold: 1 s}")
    return text.replace("sling_defaults:", f"{AREAS}wind: {wind}\nsling_defaults:", 1)


def test_wind_that_pushes_is_named() -> None:
    """Along the column 9 m/s have 536 N, which no other force but falls that lean can balance."""
    said = "at once; the wind of 9.0 m/s pushes the load aside$"
    with pytest.raises(CannotBeError, match=said):
        plumb_hooks(parse_scenario(lift("{speed: 9 m/s, direction: 0 deg}")))


def test_no_wind_pushes_nothing() -> None:
    """Areas alone stand in air that stands: falls can hang plumb."""
    assert plumb_hooks(parse_scenario(lift("none"))).residual < 1e-4
