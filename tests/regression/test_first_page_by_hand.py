"""First pages that said something else than the checks below them, or than what was given.

- `equalizer_yard` had "travel up 93 % of 1.40 m" under a warning of 125.9 %: the one while the load is
  clear, the other before that, and nothing said so.
- `onto_a_platform` had a guide at 74 % of its capacity, and the check, with the design weight, 77 %
  (tests/unit/test_guides.py holds the row against the check).
- `off_a_barge` and `monopile`, whose loads stand on decks, had the ground under them never looked at; a
  deck, which has to bear them, was not named.
- `floating_crane_and_crawlers` waits for 1602 kN and then for 446 kN; its steps said "1.602 MN" and "446 kN";
  those of `monopile` said "1,095 t", which may be read as 1.095 t.
- A lift afloat that is a go in no waves of 10 s had "swell up to none to 0.8 m, by period and direction".
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from gantline.assembly.plan.waits import waited_for
from gantline.report import render_report
from gantline.report.first_page import beyond
from gantline.report.seas import allowed_seas
from gantline.results.file.saved_seas import SavedSeas
from gantline.results.rig import Rig
from gantline.scenario import load_scenario
from sample_lift import WEIGHT, ringing_lift


def test_travel_of_a_load_that_comes_clear_is_that_when_clear() -> None:
    heads = "<th>travel up{0}</th><th>travel down{0}</th>"
    assert heads.format(" when clear") in render_report(ringing_lift())
    stands = ringing_lift(contact=np.full((2001, 4), WEIGHT / 4), events=[])
    assert heads.format("") in render_report(stands)


@pytest.mark.parametrize(
    ("vessels", "what"), [([], "ground"), ([{"name": "barge", "body": "barge"}], "ground or deck")]
)
def test_a_deck_has_to_bear_a_load_too(vessels: list[Any], what: str) -> None:
    loads = [{"name": "module", "body": "module", "weight": 1.0, "contacts": ["corner_1"]}]
    found = beyond(Rig.from_json({"loads": loads, "vessels": vessels}))
    assert found.endswith(f" and bearing capacity of the {what} under the load")


@pytest.mark.parametrize(
    ("lift", "step", "load"),
    [
        ("floating_crane_and_crawlers", "fc to 25 percent", "fc.H2 above 1602 kN"),
        ("floating_crane_and_crawlers", "c1 to 25 percent", "c1.H above 446 kN"),
        ("monopile", "to half", "H1 above 350 t"),
        ("monopile", "take the weight", "H1 above 1095 t"),
    ],
)
def test_steps_wait_for_loads_in_kn_or_t(lift: str, step: str, load: str) -> None:
    scenario = load_scenario(lift)
    [own] = [one for one in scenario.plan if one.step == step]
    assert waited_for(scenario, own)["until"] == f"hoist load of {load}"


@pytest.mark.parametrize(
    ("heights", "told"),
    [
        ((None, None), "none"),
        ((0.8, 0.8), "up to 0.8 m"),
        ((0.8, 1.2), "up to 0.8 m to 1.2 m, by period and direction"),
        ((None, 0.8), "none or up to 0.8 m, by period and direction"),
    ],
)
def test_seas_in_which_it_is_no_go(heights: tuple[float | None, float | None], told: str) -> None:
    allowed = dict(zip([(0.0, 7.0), (0.0, 10.0)], heights, strict=True))
    found = SavedSeas("", "", "swell", False, 1, 0.0, [], allowed, [])
    assert allowed_seas(found) == told
