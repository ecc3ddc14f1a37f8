"""What hung at one place while a hinge held the load was held against the chart at every other.

`hoist_load_of_rating` takes the whole load to hang where it is clear of supports, and what hung still once
against the least that is rated on the way. A load in a hinge is clear of supports and hangs by half: the
monopile of 1000 t that a crane raises at 110 m of radius, 591 t on the hook of 773 t, and has whole at 42 m,
1098 t of 2440 t, was NO-GO with 201.6 % of the chart. At hold points it was the same.
"""

from __future__ import annotations

import numpy as np
import pytest

from gantline.scenario import load_scenario
from gantline.simulation import simulate
from of_recording import check_of
from reference_lift import ROOT


def test_each_place_is_held_against_what_hung_there() -> None:
    """(591.2 t + 3 % of 498.6 t) of 774 t at 110.1 m, lying; at 30 deg 8 t more hang, and more may.

    498.6 t are 1000 t * 34.5/70 and 5.8 t of slings, 92.6 t more hook block and falls.
    """
    lift = load_scenario(ROOT / "scenarios/monopile/scenario.yaml")
    recording = simulate(lift.changed({"duration": "780 s"}))
    hung = 1000.0 * 34.5 / 70.0 + 5.76
    rated = float(np.interp(110.13, (100.0, 120.0), (900.0, 650.0)))
    check = check_of(recording, "hoist_load_of_rating")
    # 0.011 more by what hangs at 30 deg, over what is rated lying.
    assert check.value == pytest.approx((1.03 * hung + 92.6) / rated, abs=2e-3)
