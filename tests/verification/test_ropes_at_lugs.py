"""Ropes of `mechanics` that are made fast to lugs: where they pull, and what the lugs bear."""

from __future__ import annotations

import math

import numpy as np
import pytest

from gantline.assembly import assemble
from gantline.checks import Check, Verdict, check_recording
from gantline.checks.lug_figures import lug_figures
from gantline.results.recording import Recording
from gantline.scenario import ScenarioError, parse_scenario
from gantline.statics import Statics
from lift_text import changed
from shown import MECHANICS, ROOT, lift_on

JACKS = (ROOT / "scenarios" / "strand_jacks" / "scenario.yaml").read_text(encoding="utf-8")
BAR = lift_on(MECHANICS, "A module on a spreader bar")
G = 9.81
#: A load of 20 t that hangs by one lug, 2 m over its centre of gravity, in two ropes of 5 m to places at 3 m
#: to each side of it and 4 m up, so that each leans with cos = 4/5.
_TWO = """\
format: 1
lift: {title: Two ropes at one lug}
duration: 1 s
start: rest
ropes:
  stay: {axial_stiffness: 2000 MN, mass: none, minimum_breaking_force: 900 kN}
load:
  name: box
  shape: {box: [2 m, 2 m, 2 m]}
  position: [0 m, 0 m, 5 m]
  weight: {calculated: 20 t, contingency: 1.1}
  centre_of_gravity: {at: [0 m, 0 m, 1 m]}
  lugs: {L: {at: [0 m, 0 m, 3 m], capacity: 25 t, main_plate: yz}}
mechanics:
  ropes:
    left:
      rope: stay
      length: 5 m
      route: [{type: end, body: world, at: [-3 m, 0 m, 12 m]}, {type: end, body: box, lug: L}]
    right:
      rope: stay
      length: 5 m
      route: [{type: end, body: box, lug: L}, {type: end, body: world, at: [3 m, 0 m, 12 m]}]
plan:
  - {step: hold, hold: until_end}
"""


def at_rest(text: str, time: float = 0.0) -> Recording:
    return Statics(parse_scenario(text)).equilibrium(time=time).recording


def checks(recording: Recording) -> dict[str, Check]:
    return {check.name: check for check in check_recording(recording)}


def refused(text: str) -> str:
    with pytest.raises(ScenarioError) as error:
        parse_scenario(text)
    return "\n".join(f"{one.path}: {one.sentence}" for one in error.value.problems)


def test_an_end_at_a_lug_is_where_the_lug_is_from_the_centre_of_gravity() -> None:
    """Lug L1 at x = -4 m, z = 3 m of the load, whose centre of gravity is at 0.3 m and 1.5 m."""
    told = assemble(parse_scenario(BAR)).document
    by_place = changed(
        BAR,
        ("body: module, lug: L1", "body: module, at: [-4.3 m, 0 m, 1.5 m]"),
        ("body: module, lug: L2", "body: module, at: [3.7 m, 0 m, 1.5 m]"),
    )
    assert told == assemble(parse_scenario(by_place)).document


@pytest.mark.parametrize("centre", ["0.3 m", "0.8 m", "-1 m"])
def test_a_case_that_moves_the_centre_of_gravity_leaves_the_lug_on_the_load(centre: str) -> None:
    """From the datum of the load the rope ends at the lug: at cog + at = (-4, 0, 3) m."""
    scenario = parse_scenario(BAR).changed({"load.centre_of_gravity.at": f"[{centre}, 0 m, 1.5 m]"})
    [rope] = [one for one in assemble(scenario).document["ropes"] if one["name"] == "down_1"]
    at = np.add(rope["route"][-1]["at"], [float(centre.removesuffix(" m")), 0.0, 1.5])
    assert at == pytest.approx((-4.0, 0.0, 3.0), abs=1e-12)


def test_lugs_of_strand_jacks_bear_their_bundles_with_the_design_weight() -> None:
    """Section and half bundles by moments, times 1.05, over 300 t: (800 t 19/36/2 + 0.4033 t) 1.05/300 t."""
    found = checks(at_rest(JACKS, 900.0))["lug_load_of_capacity"]
    # Bundles lean by 2 mm of 36 m, and stretched ones are lumped as they are at the start.
    assert found.element in ("section.C", "section.D")
    # What is lumped is no weight of the load, and all of the force is raised with it.
    ratio = (840.0 + 1.613) / (800.0 + 1.613)
    assert found.value == pytest.approx((800.0 * 19 / 36 / 2 + 0.4033) * ratio / 300.0, rel=2e-4)


def test_ropes_at_one_lug_pull_as_vectors_and_each_out_of_the_plate() -> None:
    """Each bears W/2/cos, together W upright; they lean by atan(3/4) out of a plate that stands along y."""
    rest = at_rest(_TWO)
    weight = 20e3 * G
    for rope in ("left", "right"):
        assert rest.column("rope_tension", rope)[-1] == pytest.approx(weight / 2 / 0.8, rel=1e-3)
    found = checks(rest)
    assert found["lug_load_of_capacity"].value == pytest.approx(20.0 * 1.1 / 25.0, rel=1e-9)
    [figures] = lug_figures(rest)
    assert figures.slings == ("left", "right")
    assert figures.pull == pytest.approx((0.0, 0.0, 1.1 * weight), abs=1e-3 * weight)
    out = checks(at_rest(_TWO + "limits: {rule: own, lug_out_of_plane_angle: 10 deg}\n"))
    assert out["lug_out_of_plane_angle"].verdict is Verdict.FAILED
    assert out["lug_out_of_plane_angle"].value == pytest.approx(math.atan2(3.0, 4.0), rel=1e-3)


def test_ropes_that_pull_against_each_other_load_a_lug_as_one_of_them_does() -> None:
    """Level ends 6 m away leave each the tension T, together a hundredth of the weight: the lug bears T."""
    text = changed(
        _TWO, ("[-3 m, 0 m, 12 m]", "[-5 m, 0 m, 8.5 m]"), ("[3 m, 0 m, 12 m]", "[5 m, 0 m, 8.5 m]")
    )
    rest = at_rest(text)
    tension = rest.column("rope_tension", "left")[-1]
    assert tension > 5 * 20e3 * G
    found = checks(rest)["lug_load_of_capacity"]
    assert found.value == pytest.approx(1.1 * tension / (25e3 * G), rel=1e-9)


def test_a_sling_beside_a_rope_at_one_lug_pulls_with_it() -> None:
    """A slack sling in one lug leaves it the ropes' force; one in which all hangs has the same weight."""
    hook = (
        "cranes:\n  H: {type: fixed_hook, at: [0 m, 0 m, 14 m],"
        " hoist: {speed: 1 m/min, acceleration: 0.1 m/s^2}}\n"
        "slings: {S: {from: H, to: box.L, length: LONG, rope: stay}}\n"
    )
    for long in ("6.05 m", "5.995 m"):
        found = checks(at_rest(_TWO + hook.replace("LONG", long)))["lug_load_of_capacity"]
        assert found.element == "box.L"
        assert found.value == pytest.approx(20.0 * 1.1 / 25.0, rel=1e-6)


def test_what_cannot_be_is_refused() -> None:
    """A lug and a place, a lug that is not there, and a body that has none."""
    both = refused(BAR.replace("body: module, lug: L1", "body: module, lug: L1, at: [0 m, 0 m, 0 m]"))
    assert "an end is made fast to a 'lug', or is 'at' a place; leave one of both out" in both
    other = refused(BAR.replace("body: module, lug: L1", "body: module, lug: L3"))
    assert "'L3' is not a lug of 'module'; known here: 'L1', 'L2'" in other
    bar = refused(BAR.replace("body: bar, at: [-4 m, 0 m, -0.2 m]", "body: bar, lug: L1"))
    assert "'bar' has no lugs; the load alone has, of other bodies 'at' says where" in bar


def test_a_lug_with_a_rope_is_no_free_one() -> None:
    """No sling leads to any lug of a load in jacks; of one that has nothing the lift file is asked."""
    assert not [one for one in assemble(parse_scenario(JACKS)).doubts if "leads to lug" in one.sentence]
    free = JACKS.replace("body: section, lug: D", "body: section, at: [17 m, -5 m, 2 m]")
    [told] = [one.sentence for one in assemble(parse_scenario(free)).doubts if "leads to lug" in one.sentence]
    assert told == "no sling leads to lug D"
