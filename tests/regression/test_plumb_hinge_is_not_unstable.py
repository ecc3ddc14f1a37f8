"""A load in a frictionless hinge with a plumb axis turns freely: nothing holds it, and nothing leads away.

Statics said "UNSTABLE: one motion leads away" beside "nothing holds it". The core counts motions by the signs
of pivots, with the pins of the hinge as soft as its search has them. A load of the weight W, a aside of the
hinge, has K = W a between its turn about plumb and that of a pin, and so -(W a)² ε in place of 0 for the
first: with ε = 6e-5 m/W, as stiff as the search makes them, W a = 17.66 MN m and I = 45.7e6 kg m² that is an
ω² of -4e-4/s², while -1e-6/s² counts.
"""

from __future__ import annotations

import pytest

from gantline.scenario import parse_scenario
from gantline.statics import Statics
from hinged_mast import ACROSS, FOOT, MAST, WEIGHT, mast

HOLD = "  - {step: hold, hold: 20 s}\n"
#: Under its hook, with a sling that is slack.
PLUMB = (
    mast(HOLD, hook=(19.0, 0.0, 60.0)).replace("900 s", "20 s").replace("axis: [0, 1, 0]", "axis: [0, 0, 1]")
)


def test_what_nothing_holds_does_not_lead_away() -> None:
    statics = Statics(parse_scenario(PLUMB))
    rest = statics.equilibrium()
    assert (rest.unstable, rest.neutral, rest.is_stable) == (0, 1, True)
    (mode,) = statics.modes(1)
    assert abs(mode.square) <= 1e-6 and mode.period is None
    # All of W on the hinge, at the lever that its centre of gravity has: W a.
    assert rest.recording.column("hinge_force", "foot")[-1] == pytest.approx(WEIGHT, rel=1e-6)
    assert rest.recording.column("hinge_moment", "foot")[-1] == pytest.approx(WEIGHT * FOOT, rel=1e-6)


def test_what_leads_away_is_still_told() -> None:
    """On pins 1 m below its centre of gravity, in a slack sling, it leads away with ω² = -W h/(I + m h²)."""
    text = PLUMB.replace("at: [-20 m, 0 m, 1 m], axis: [0, 0, 1]", "at: [-2 m, 0 m, 0 m], axis: [0, 1, 0]")
    text = text.replace("length: 49.0 m", "length: 50 m")
    statics = Statics(parse_scenario(text))
    rest = statics.equilibrium()
    assert (rest.unstable, rest.neutral, rest.is_stable) == (1, 0, False)
    assert statics.modes(1)[0].square == pytest.approx(-WEIGHT / (ACROSS + MAST), rel=1e-6)
