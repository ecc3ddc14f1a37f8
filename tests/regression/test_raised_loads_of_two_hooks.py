"""A rule's dynamic factor on what hangs in an auxiliary hook was spread over the empty main hook too.

The hoist load of the crane by the rule was held against what hangs over the sum of the shares as simulated,
(RA2). But hook blocks are not raised, and 1 t more in the hook whose rows rate less takes more of them than
1 t of both hooks on average: 84.8 % were 82.4 %.
"""

from __future__ import annotations

import math

import pytest

from boom_lift import BOW, HEEL, LENGTH, boom_lift, head, simulated
from gantline.checks import values_of

#: What the rule makes of what hangs in a hook.
DYNAMIC = 1.3
CHART = "    rating: {outreach: [20 m, 80 m], rated: [900 t, 300 t], hooks_share: 100 %}\n"
#: A load of 70 t that hangs in the auxiliary hook, plumb below it.
HUNG = """\
load:
  name: box
  shape: {{box: [4 m, 4 m, 2 m]}}
  position: [{at!r} m, 0 m, 48 m]
  weight: {{calculated: 70 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 1 m]}}
  lugs: {{top: {{at: [0 m, 0 m, 2 m]}}}}
slings: {{S: {{from: fc.H2, to: box.top, length: 10 m, rope: hoist}}}}
rules: {{dynamic_amplification_factor: {dynamic}}}
"""


def _rated(outreach: float) -> float:
    """What the chart of the crane rates [t]."""
    return 900.0 - (900.0 - 300.0) * (outreach - 20.0) / 60.0


@pytest.mark.parametrize("own", ["", ", rating: {outreach: [40 m, 80 m], rated: [250 t, 100 t]}"])
def test_what_the_rule_adds_hangs_in_its_own_hook(own: str) -> None:
    """Main hook empty, 50 t of hook block; auxiliary with its own 50 t and 1.3 times 70 t by the rule."""
    hooks = f"H1: {{type: H, height: 40 m}}\nH2: {{type: H, along: 12 m, above: -5 m, height: 60 m{own}}}"
    angle = math.radians(60)
    main = head(angle)[0] - BOW
    out = HEEL[0] + (LENGTH + 12.0) * math.cos(angle) + 5.0 * math.sin(angle) - BOW
    more = HUNG.format(at=out + BOW, dynamic=DYNAMIC)
    beside = "beside: {joint: {type: fixed}, mass: 1 kg}"
    text = boom_lift(duration=30.0, start="rest", hooks=hooks, bodies=beside, more=more)
    recording = simulated(text.replace("    luffing:", CHART + "    luffing:"))
    aux = 250.0 - 150.0 * (out - 40.0) / 40.0 if own else _rated(out)
    expected = 50.0 / _rated(main) + (70.0 * DYNAMIC + 50.0) / aux
    assert values_of(recording, "hoist_load_of_rating")["crane fc"] == pytest.approx(expected, rel=1e-4)
