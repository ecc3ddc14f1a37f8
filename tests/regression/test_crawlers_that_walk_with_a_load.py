"""A crawler crane that walks with its load was held against the dynamic factor of one that stands.

`nd_0027_onshore` is 1.05 for 115 t, and two crawlers that walked with them for 20 m were GO with 85 % of a
chart. By note 2 to table 5-1 of 0027/ND crawler cranes that travel with a load take the inshore column where
nothing else is documented, 1.12, as the page of checks said and nothing that is printed did.
"""

from __future__ import annotations

import pytest

from crawler_lift import HOOK_BLOCK, crawler_lift
from gantline.assembly import assemble
from gantline.scenario import parse_scenario

HOIST = "{step: up, hoist: c1.H, speed: 3 m/min, by: 1 m}"
WALK = "{step: walk, travel: c1, speed: 0.5 km/h, by: 20 m}"
DOWN = "{step: down, lower: c1.H, speed: 3 m/min, until: {slings: slack}}"
PLUMB = "{step: plumb, lower: c1.H, speed: 3 m/min, until: {load_tilt: {above: 5 deg}}}"
LEAD = (
    "{step: walk, lead: c1.H, travelling: c1, by: [9 m, 0 m, 0 m], speed: 6 m/min, acceleration: 0.005 m/s^2}"
)


def told(
    *plan: str, rules: str = "preset: nd_0027_onshore", weight: str = "115 t", stands: bool = True
) -> list[str]:
    more = f"""\
load:
  name: vessel
  shape: {{box: [4 m, 4 m, 4 m]}}
  position: [3 m, 14 m, 0 m]
  weight: {{calculated: {weight}}}
  centre_of_gravity: {{at: [0 m, 0 m, 2 m]}}
  {"stands_on: ground" if stands else ""}
  lugs: {{E: {{at: [1 m, 0 m, 4 m]}}, W: {{at: [-1 m, 0 m, 4 m]}}}}
slings:
  E: {{from: c1.H, to: vessel.E, length: 26.3 m, rope: hoist}}
  W: {{from: c1.H, to: vessel.W, length: 26.3 m, rope: hoist}}
rules: {{{rules}}}
"""
    travels = "    travel: {speed: 1 km/h, acceleration: 0.02 m/s^2, range: [-50 m, 50 m]}\n"
    text = crawler_lift(HOOK_BLOCK + 1.0, "\n".join(plan), crane=travels, more=more, duration=400.0)
    doubts = assemble(parse_scenario(text)).doubts
    return [one.sentence for one in doubts if one.path == "rules.preset"]


# 0027/ND rev 11, table 5-1, up to 100 and 300 t: onshore 1.10, 1.05; inshore 1.07 + 0.05 sqrt(100/W), 1.12.
@pytest.mark.parametrize(("weight", "asks", "has"), [("115 t", "1.12", "1.05"), ("25 t", "1.17", "1.10")])
def test_a_crawler_that_walks_with_the_load(weight: str, asks: str, has: str) -> None:
    (found,) = told(HOIST, WALK, weight=weight)
    assert found.startswith(
        f"'c1' travels with the load in 'walk': 0027/ND, note 2 to table 5-1, asks crawler cranes for {asks} "
    )
    assert f"in place of {has}, where nothing else is documented" in found


@pytest.mark.parametrize("plan", [(HOIST, LEAD), (HOIST, PLUMB, WALK), (DOWN, HOIST, WALK)])
def test_so_it_is_when_led_or_let_down_at_one_end(plan: tuple[str, ...]) -> None:
    assert len(told(*plan)) == 1


def test_what_hangs_from_the_start_is_walked_with() -> None:
    assert len(told(WALK, stands=False)) == 1


@pytest.mark.parametrize("plan", [(HOIST,), (WALK, HOIST), (HOIST, DOWN, WALK)])
def test_a_crane_that_stands_or_walks_without_it_is_not_told(plan: tuple[str, ...]) -> None:
    assert told(*plan) == []


@pytest.mark.parametrize(
    "rules", ["preset: nd_0027_inshore", "preset: nd_0027_onshore, dynamic_amplification_factor: 1.05"]
)
def test_a_factor_that_somebody_has_chosen_stays(rules: str) -> None:
    assert told(HOIST, WALK, rules=rules) == []
