"""A mooring line within its own limit used up a safety factor that rules have for slings.

0027/ND, 7.3, is about slings. With its factors, 1.3 x 1.3 x 1.5, a mooring line at 28.5 % of its breaking
force, of 50 % that `mooring_tension_of_breaking_force` allows, was told as 75 % of
`rope_load_of_breaking_force`, raised by the dynamic factor of the hook at that: the third check nearest to
its limit of a bridge span that two barges lift. One at 46 %, within its limit, failed: NO-GO.
"""

from __future__ import annotations

from gantline.checks import Verdict, check_recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from moored_by_springs import MOORED

#: 46 % of what breaks the lines are 460 kN x 1.3 x 1.3 x 1.5 / 1 MN = 117 % by the factors of slings.
RULED = MOORED + (
    "rules: {load_factor: 1.3, consequence_factor: 1.3, material_factor: 1.5, termination_factor: 1.0}\n"
)


def verdicts(lift: str) -> dict[str, Verdict]:
    return {check.name: check.verdict for check in check_recording(simulate(parse_scenario(lift)))}


def test_it_is_held_against_its_own_limit_alone() -> None:
    found = verdicts(RULED + "limits: {mooring_tension_of_breaking_force: 50 %}\n")
    assert found["mooring_tension_of_breaking_force"] is Verdict.OK
    assert found.get("rope_load_of_breaking_force") is not Verdict.FAILED


def test_without_one_factors_of_slings_are_what_there_is() -> None:
    assert verdicts(RULED)["rope_load_of_breaking_force"] is Verdict.FAILED
