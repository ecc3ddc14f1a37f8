"""Loads of the corners of a Goliath crane whose falls are out of plumb.

Falls out of plumb pull level too, where they hang from, 88 m over the rails. The corners had the moments of
hoist loads as if these hung plumb under the trolley: of 100 t that are held 5 m aside one corner bore 165 kN
less than was said and another 135 kN more, so that a crane was nearer to tipping than it seemed.
"""

from __future__ import annotations

import numpy as np
import pytest

from gantline.scenario import parse_scenario
from gantline.statics import Statics
from goliath_lift import HOOK_BLOCK, HUNG, TO_SHEAVES, goliath_lift

G = 9.81
#: Where the trolley is, and the span and the base of the legs [m].
ALONG, SPAN, BASE = -20.0, 148.0, 32.0
#: Masses of girder, trolley, fixed leg, hinged leg, bogies [kg].
GIRDER, TROLLEY, FIXED, HINGED, BOGIES = 2600e3, 300e3, 700e3, 450e3, 700e3
#: A rope that holds the hook block aside, level with its sheaves, to a bollard on a tower [m].
TOWER = (10.0, 60.0, 38.0)
_ROPES = f"""\
  ropes:
    aside:
      rope: hoist
      length: 62 m
      stretched: true
      route:
        - {{type: end, body: hung, at: [0 m, 0 m, {TO_SHEAVES} m]}}
        - {{type: end, body: world, at: [{TOWER[0]} m, {TOWER[1]} m, {TOWER[2]} m]}}
"""


def test_all_that_hangs_and_pulls_is_on_the_corners_by_moments() -> None:
    """Crane and load as one: weights where they are, and the pull of the rope aside at its height."""
    text = goliath_lift("{step: look, hold: until_end}", duration=1.0, start="rest", ropes=_ROPES)
    rest = Statics(parse_scenario(text)).equilibrium(time=0.0).recording
    hook = rest.column("body_position", "gol.A")[-1]
    assert np.hypot(hook[0] - ALONG, hook[1]) > 4.0  # m: otherwise nothing is tested
    end = np.array([*hook[:2], hook[2] + TO_SHEAVES])
    way = np.array(TOWER) - end
    pull = rest.column("rope_tension", "aside")[-1] * way / np.linalg.norm(way)

    upright = (HOOK_BLOCK + HUNG) * G - pull[2]
    total = (GIRDER + TROLLEY + FIXED + HINGED + BOGIES) * G + upright
    # About mid-span and about the girder's centre line, at the height of the rails.
    along = TROLLEY * G * ALONG + (HOOK_BLOCK + HUNG) * G * hook[0] - pull[2] * end[0] + pull[0] * end[2]
    along += (HINGED - FIXED) * G * SPAN / 2
    across = (HOOK_BLOCK + HUNG) * G * hook[1] - pull[2] * end[1] + pull[1] * end[2]

    front, back, far_front, far_back = (
        rest.column("corner_load", f"gol.{corner}")[-1]
        for corner in ("fixed.front", "fixed.back", "hinged.front", "hinged.back")
    )
    assert front + back + far_front + far_back == pytest.approx(total, rel=1e-9)
    assert (far_front + far_back - front - back) * SPAN / 2 == pytest.approx(along, rel=1e-7)
    assert (front + far_front - back - far_back) * BASE / 2 == pytest.approx(across, rel=1e-7)
