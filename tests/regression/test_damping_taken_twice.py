"""Critical damping of heave beside `radiation`, and periods by another unit, made a lift calm: in order.

`radiation` has what waves take of heave and pitch, 10 to 30 % of critical; the 20 % that a lift file
without it needs are then taken twice. A share of surge with `2.6 s` for `26 s` is ten times the damping,
and one with `41 min` for `41 s` a sixtieth.
"""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import load_scenario

CRITICAL = "vessels.barge.water_damping.critical"


def doubts(changes: dict[str, object]) -> list[str]:
    return list(assemble(load_scenario("crane_barge_in_swell").changed(changes)).warnings)


@pytest.mark.parametrize("key", ["heave", "pitch"])
def test_damping_of_waves_beside_radiation_is_told(key: str) -> None:
    [sentence] = doubts({f"{CRITICAL}.{key}": "20 %"})
    beside = f"barge has 20 % of critical damping in {key} beside 'radiation', which has that by waves"
    assert sentence == f"{beside}: what lines and hull add to it is less than 10 %"


@pytest.mark.parametrize("changes", [{f"{CRITICAL}.heave": "5 %"}, {f"{CRITICAL}.roll": "10 %"}])
def test_nothing_is_said_of_what_a_hull_adds(changes: dict[str, object]) -> None:
    assert not doubts(changes)


@pytest.mark.parametrize(("key", "period", "seconds"), [("surge", "2.6 s", "2.6"), ("yaw", "41 min", "2460")])
def test_periods_of_no_mooring_are_told(key: str, period: str, seconds: str) -> None:
    [sentence] = doubts({f"{CRITICAL}.periods.{key}": period})
    assert sentence.startswith(f"barge has a period of {seconds} s in {key} on its moorings, as no moorings")
