"""A load hung whole as a step asked, `require: {load_transferred: above 99 %}`, and the verdict named that
first: "nearest to their limits: load_transferred 99 %".

What a step has to come to is missed where it is less, and no share of it is used up: a load that hangs whole
has 99/100 of that bound, and one that was to turn by 80 deg and has turned by 84 has 80/84. Of tilts this was
so already. A least force is a bound that something may come near to, and keeps its share.
"""

from __future__ import annotations

import math

import pytest

from gantline.checks import Check, Verdict, verdict_of


def required(name: str, value: float, least: float) -> Check:
    """What a step requires to be at least, met."""
    return Check(name, Verdict.OK, "", value=value, limit=least, at_least=True, step="turn")


@pytest.mark.parametrize(
    ("name", "value", "least"),
    [
        ("load_transferred", 1.0, 0.99),
        ("load_yaw", math.radians(84.0), math.radians(80.0)),
        ("load_tilt", math.radians(89.0), math.radians(85.0)),
    ],
)
def test_what_a_step_has_to_come_to_is_not_used_up(name: str, value: float, least: float) -> None:
    met = required(name, value, least)
    used = Check("lug_load_of_capacity", Verdict.OK, "", value=0.8, limit=1.0)
    assert met.utilisation is None
    assert name not in verdict_of([met, used])
    assert "lug_load_of_capacity 80 %" in verdict_of([met, used])


def test_what_is_to_stay_below_a_bound_uses_it() -> None:
    """9 of 10 deg are 90 %, and 10 kN where 12.5 kN are left 80 %."""
    below = Check("load_yaw", Verdict.OK, "", value=math.radians(9.0), limit=math.radians(10.0), step="turn")
    assert below.utilisation == pytest.approx(0.9)
    assert required("sling_tension", 12.5e3, 10e3).utilisation == pytest.approx(0.8)
