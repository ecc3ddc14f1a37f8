"""What a spreader bears as a load is turned, between two holds, was not held against its rated capacity.

Spreaders, equalizers and compensators are rated for what hangs still, and that is what they bore at holds. A
beam of 20 t that hangs level has half of it at either end; sloping by 35 deg it hangs with 71 % in the bar at
its raised end, with lugs 3 m over the centre of gravity. Turned so far and let down again without a hold, a
bar for 14.5 t was at 76 %, ok, with the 11 t of the design weight at the holds, and had 15.6 t in it; a bar
for 13 t would have been ok with 14.2 t as simulated. So it was with the motor of a hoist, which holds what
hangs level.
"""

from __future__ import annotations

import pytest

from gantline.checks import Check, Verdict, check_recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from turned_beam import CONTINGENCY, LIFT, MASS, RATED, USED, by_crawlers

#: Mass of the bar [t].
BAR = 0.2
_OF_LUG = f"    E: {{at: [5.0 m, 0 m, 4 m], capacity: {RATED} t}}\n"
_SLING = LIFT[LIFT.index("  E: {from: E") : LIFT.index("plan:")]
_LUGS = "    E1: {at: [5.0 m, 1 m, 4 m]}\n    E2: {at: [5.0 m, -1 m, 4 m]}\n"
_BELOW_A_BAR = """\
  U1: {from: E, to: bar.u1, length: 90.01 m}
  U2: {from: E, to: bar.u2, length: 90.01 m}
  L1: {from: bar.l1, to: beam.E1, length: 9.7 m}
  L2: {from: bar.l2, to: beam.E2, length: 9.7 m}
spreaders:
  bar:
    size: [0.3 m, 2 m, 0.3 m]
    mass: 0.2 t
    rated_capacity: RATED
    lugs: {u1: {at: [0 m, 1 m, 0.15 m]}, u2: {at: [0 m, -1 m, 0.15 m]}, l1: {at: [0 m, 1 m, -0.15 m]},
      l2: {at: [0 m, -1 m, -0.15 m]}}
"""


def _by_a_bar(rated: float, contingency: float = CONTINGENCY) -> Check:
    text = LIFT.replace(_OF_LUG, _LUGS).replace(_SLING, _BELOW_A_BAR.replace("RATED", f"{rated} t"))
    assert "bar.u1" in text and "beam.E1" in text
    text = text.replace(f"contingency: {CONTINGENCY}", f"contingency: {contingency}")
    return _of(text, "spreader_load_of_rated_capacity")


def _of(text: str, name: str) -> Check:
    (check,) = [one for one in check_recording(simulate(parse_scenario(text))) if one.name == name]
    return check


def test_a_bar_bears_the_design_weight_as_the_load_is_turned() -> None:
    """By moments about the other lug, as at the hook without a bar."""
    check = _by_a_bar(RATED)
    assert CONTINGENCY * MASS / 2.0 < RATED < USED * RATED
    assert check.value == pytest.approx(USED, rel=1e-2)
    assert check.verdict is Verdict.FAILED and check.time is not None
    assert "x 1.1 to the design weight" in check.formula


def test_a_bar_bears_what_is_simulated_too() -> None:
    check = _by_a_bar(13.0, 1.0)
    assert check.value == pytest.approx(USED / CONTINGENCY * RATED / 13.0, rel=1e-2)
    assert check.verdict is Verdict.FAILED


def test_a_motor_holds_the_design_weight_as_the_load_is_turned() -> None:
    """Four parts of 40 kN hold 160 kN: 9.8 kN of hook block, and what hangs in it, 155.9 kN with 1.1."""
    text = by_crawlers().replace(
        "hoist: {speed: 10 m/min, acceleration: 0.02 m/s^2}\n",
        "hoist: {speed: 10 m/min, acceleration: 0.02 m/s^2, capacity: 40 kN}\n",
    )
    text = text.replace("drum: {diameter: 0.8 m}", "drum: {diameter: 0.8 m, rotating_mass: 1 t}")
    check = _of(text, "hoist_load_of_drive_capacity")
    hangs = USED * RATED * 9.81
    assert check.value == pytest.approx((hangs + 9.81) / 160.0, rel=1e-2)
    assert check.verdict is Verdict.FAILED
