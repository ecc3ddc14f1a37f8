"""What is said of lines whose rope has a curve, and of curves that no rope has."""

from __future__ import annotations

import pytest

import gantline
from gantline.scenario import ScenarioError, parse_scenario

LIFT = """\
format: 1
lift: {title: A barge and its load on lines}
duration: 20 s
start: rest
water: {density: 1025 kg/m^3, level: 0 m}
ropes:
  nylon: {CURVE, mass: 2 kg/m}
  steel: {axial_stiffness: 50 MN, mass: none}
load:
  name: box
  shape: {box: [6 m, 3 m, 2 m]}
  position: [0 m, 0 m, 12 m]
  weight: {calculated: 30 t}
  centre_of_gravity: {at: [0 m, 0 m, 1 m]}
  lugs: {L: {at: [0 m, 0 m, 2 m]}}
cranes:
  crane: {type: fixed_hook, at: [0 m, 0 m, 25 m], hoist: {speed: 6 m/min, acceleration: 0.1 m/s^2}}
slings:
  S: {from: crane, to: box.L, length: 11 m, rope: steel}
vessels:
  barge:
    position: [0 m, 40 m]
    draft: 3 m
    hull: {box: [60 m, 20 m, 5 m]}
    masses: {all: {mass: 3690 t, at: [30 m, 0 m, 3 m]}}
    radii_of_gyration: [7 m, 15 m, 15 m]
mooring_lines:
  bow: {vessel: barge, fairlead: [60 m, 0 m, 3 m], to: [100 m, 40 m, 0 m], rope: nylon, BOW}
tag_lines:
  west: {at: [-3 m, 0 m, 1 m], to: [-30 m, 0 m, 13 m], rope: nylon, TAG}
plan: [{step: hold, hold: until_end}]
"""
CURVE = "curve: {strain: [5 %, 10 %, 20 %], tension: [30 kN, 90 kN, 350 kN]}"
SPRING = "or write 'type: spring', straight from end to end"
USUAL = (
    "ropes break at about 1.5 % of steel to some ten per cent of fibre, and a % has been lost or added, "
    "or a unit has slipped"
)
STIFF = "give it an 'axial_stiffness', such as the slope about its working load"


def text(
    bow: str = "type: spring, pretension: 60 kN", tag: str = "pretension: 5 kN", curve: str = CURVE
) -> str:
    return LIFT.replace("CURVE", curve).replace("BOW", bow).replace("TAG", tag)


def test_springs_and_tag_lines_made_fast_are_in_order() -> None:
    assert gantline.Simulation(parse_scenario(text())).assembly.document["ropes"]


@pytest.mark.parametrize(
    ("bow", "needs"),
    [
        (
            "pretension: 60 kN",
            f"a catenary needs one stiffness; {STIFF}, {SPRING}",
        ),
        (
            "type: distributed, length: 40 m",
            f"a line with nodes needs one stiffness; {STIFF}, {SPRING}",
        ),
        (
            "type: spring, length: 40 m, winch: {speed: 5 m/min, acceleration: 0.1 m/s^2}",
            f"a line on a winch needs one stiffness; {STIFF}, or leave 'winch' out",
        ),
        (
            "type: spring, length: 40 m, winch: {speed: 5 m/min, acceleration: 0.1 m/s^2, capacity: 100 kN}",
            f"a line on a winch needs one stiffness; {STIFF}, or leave 'winch' out",
        ),
    ],
)
def test_a_mooring_line_that_no_curve_fits_is_told_what_does(bow: str, needs: str) -> None:
    with pytest.raises(ScenarioError) as caught:
        parse_scenario(text(bow=bow), "x.yaml")
    assert str(caught.value) == f"x.yaml:28: mooring_lines.bow.rope: rope 'nylon' has a curve, and {needs}"


@pytest.mark.parametrize(
    ("tag", "needs"),
    [
        (
            "pull: 1 kN",
            f"a line whose 'pull' is kept needs one stiffness; {STIFF}, or make the line "
            "fast: 'pretension' in place of 'pull'",
        ),
        (
            "length: 27 m, winch: {speed: 5 m/min, acceleration: 0.1 m/s^2}",
            f"a line on a winch needs one stiffness; {STIFF}, or leave 'winch' out",
        ),
    ],
)
def test_a_tag_line_that_no_curve_fits_is_told_what_does(tag: str, needs: str) -> None:
    with pytest.raises(ScenarioError) as caught:
        parse_scenario(text(tag=tag), "x.yaml")
    assert str(caught.value) == f"x.yaml:30: tag_lines.west.rope: rope 'nylon' has a curve, and {needs}"


def test_a_line_too_short_is_told_the_tension_of_its_curve() -> None:
    """40 m of 34 m are 17.6 %: on the line to 350 kN, 90 + 260 * 0.7647 = 288.8 kN."""
    stretched = text(bow="type: spring, length: 34 m")
    gantline.Simulation(parse_scenario(stretched))
    weak = stretched.replace("mass: 2 kg/m", "mass: 2 kg/m, minimum_breaking_force: 250 kN")
    with pytest.raises(ScenarioError, match=r"34 m are too short .* it would pull with 288\.8 kN"):
        gantline.Simulation(parse_scenario(weak))
    # 40 m of 33 m are 21.2 %, beyond the last point.
    with pytest.raises(ScenarioError, match=r"33 m are too short .* it would pull with 381\.5 kN"):
        gantline.Simulation(parse_scenario(text(bow="type: spring, length: 33 m")))
    with pytest.raises(ScenarioError, match=r"it would be stretched by 22\.73 %, and a start allows 20 %"):
        gantline.Simulation(parse_scenario(text(tag="length: 22 m")))


def test_strains_without_their_percent_sign_are_refused() -> None:
    with pytest.raises(ScenarioError, match=r"ropes\.nylon\.curve\.strain.*'5' is 500 %"):
        parse_scenario(text(curve=CURVE.replace(" %", "")))


@pytest.mark.parametrize(
    ("strains", "more", "says"),
    [
        (
            "[0.5, 1, 1.5]",
            "",
            f"rope nylon stretches by 150 % at the last point of its curve; {USUAL}",
        ),
        (
            "[0.05 %, 0.1 %, 0.15 %]",
            "",
            f"rope nylon stretches by 0.15 % at the last point of its curve; {USUAL}",
        ),
        (
            "[5 %, 10 %, 20 %]",
            ", minimum_breaking_force: 9 MN",
            f"rope nylon stretches by 353 % where it breaks, at 9 MN; {USUAL}",
        ),
    ],
)
def test_strains_of_no_rope_are_doubted(strains: str, more: str, says: str) -> None:
    spoilt = text(curve=CURVE.replace("[5 %, 10 %, 20 %]", strains) + more)
    doubts = [one.sentence for one in gantline.Simulation(parse_scenario(spoilt)).assembly.doubts]
    assert [one for one in doubts if one.startswith("rope nylon")] == [says]


def test_a_curve_to_a_part_of_the_breaking_force_is_not_doubted() -> None:
    """It goes to 350 kN; by its last line it would break at 41 %, which fibre does."""
    fine = text(curve=f"{CURVE}, minimum_breaking_force: 900 kN")
    doubts = gantline.Simulation(parse_scenario(fine)).assembly.doubts
    assert not [one for one in doubts if "nylon" in one.sentence]
