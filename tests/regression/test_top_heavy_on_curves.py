"""A load that turned over on slings that get softer was in order.

Whether what hangs stays upright came from one stiffness for the whole curve of its slings. At 307 kN, past
the bend of a curve, they give way ten times as easily: no word of a centre of gravity 0.66 m too high.
"""

from __future__ import annotations

import pytest

from gantline.results.loads.upright import top_heavy
from gantline.scenario import parse_scenario
from gantline.statics import Statics
from on_a_curve import on_a_curve

#: Strain and tension [N] of the slings.
CURVE = ((0.01, 300e3), (0.03, 330e3))


@pytest.mark.parametrize(("height", "too_high"), [(4.0, None), (5.30, None), (5.38, 0.04), (6.0, 0.66)])
def test_what_hangs_is_told_to_turn_over_where_statics_have_it(height: float, too_high: float | None) -> None:
    """It turns over where the equilibrium of the core is unstable, which takes slopes from its rows.

    By how much it is too high is height less the 5.34 m between, to 1 cm.
    """
    text = on_a_curve(CURVE, mass=115e3, height=12.0, centre=(0.0, 0.0, height))
    rest = Statics(parse_scenario(text)).equilibrium()
    found = [one.too_high for one in top_heavy(rest.recording)]
    assert rest.is_stable == (too_high is None)
    assert found == ([] if too_high is None else [pytest.approx(too_high, abs=0.01)])
