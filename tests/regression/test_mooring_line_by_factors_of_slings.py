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

#: Drawn to 46 % of what breaks it: 460 kN x 1.3 x 1.3 x 1.5 / 1 MN = 117 % by the factors of slings.
MOORED = """\
format: 1
lift: {title: A moored barge}
duration: 1 s
water: {level: 0 m}
ropes: {line: {axial_stiffness: 20 MN, minimum_breaking_force: 1 MN, mass: none, damping_time: 10 ms}}
vessels:
  bg:
    draft: 4 m
    hull: {box: [60 m, 20 m, 6 m]}
    masses: {hull: {mass: 4920 t, at: [30 m, 0 m, 3 m]}}
    radii_of_gyration: [6 m, 16 m, 16 m]
mooring_lines:
  bow:
    {vessel: bg, type: spring, fairlead: [60 m, 0 m, 4 m], to: [90 m, 0, 0], rope: line, pretension: 460 kN}
  stern:
    {vessel: bg, type: spring, fairlead: [0 m, 0 m, 4 m], to: [-30 m, 0, 0], rope: line, pretension: 460 kN}
rules: {load_factor: 1.3, consequence_factor: 1.3, material_factor: 1.5, termination_factor: 1.0}
"""


def verdicts(lift: str) -> dict[str, Verdict]:
    return {check.name: check.verdict for check in check_recording(simulate(parse_scenario(lift)))}


def test_it_is_held_against_its_own_limit_alone() -> None:
    found = verdicts(MOORED + "limits: {mooring_tension_of_breaking_force: 50 %}\n")
    assert found["mooring_tension_of_breaking_force"] is Verdict.OK
    assert found.get("rope_load_of_breaking_force") is not Verdict.FAILED


def test_without_one_factors_of_slings_are_what_there_is() -> None:
    assert verdicts(MOORED)["rope_load_of_breaking_force"] is Verdict.FAILED
