"""Gear whose unit has slipped, and a load that its own box does not allow.

A working load limit of 400 t beside a breaking force of 200 t was GO: shackles at a tenth of what they carry.
So were ropes with a damping time of 10 s for 10 ms, which let a load come off the ground 2 s early and do
not ring; inertias in kg m^2 for t m^2; a centre of gravity that was left at the datum, in the underside of
the load, which makes it hang more stably than it will; and friction of 50 for 50 %.
"""

from __future__ import annotations

import pytest

from four_slings import LIFT
from gantline.assembly import assemble
from gantline.scenario import ScenarioError, parse_scenario
from lift_text import spoiled

ROPE = "construction: 6x36 IWRC, grade: 1960, diameter: 44 mm, damping_time: 10 ms"
SHACKLE = (
    "shackles: {wb40: {working_load_limit: 40 t, minimum_breaking_force: 1962 kN, mass: 21 kg}}\nload:\n"
)
#: Of the load of 40 t in a box of 6 x 4 x 3 m: 40/12 (4^2 + 3^2) and so on.
INERTIA = "xx: 83.3 {0}, yy: 150 {0}, zz: 173 {0}"


def warnings(*changes: str) -> list[str]:
    text = LIFT
    for old, new in zip(changes[::2], changes[1::2], strict=True):
        text = spoiled(old, new, text)
    return list(assemble(parse_scenario(text)).warnings)


def test_gear_as_it_is_says_nothing() -> None:
    assert warnings("load:\n", SHACKLE) == []


@pytest.mark.parametrize(
    ("rope", "said"),
    [
        (ROPE.replace("10 ms", "10 s"), "has a damping time of 10 s: it pulls up to that long before"),
        # 40 t over four slings are 98 kN.
        ("axial_stiffness: 89 kN", "an EA of 89 kN: its slings would stretch by 110 % under their part"),
        ("axial_stiffness: 89 MN, minimum_breaking_force: 1335 N", "break at 0.0015 % of stretch"),
        ("axial_stiffness: 89 MN, minimum_breaking_force: 1335 MN", "break at 1,500 % of stretch"),
    ],
)
def test_a_rope_of_two_ropes_is_told(rope: str, said: str) -> None:
    told = warnings(ROPE, rope)
    assert len(told) == 1
    assert said in told[0]


def test_a_rope_stiffer_than_a_bar_of_its_size_is_told() -> None:
    """210 kN/mm2 over pi/4 44^2 mm2 are 319.3 MN."""
    assert warnings(ROPE, "axial_stiffness: 319 MN, diameter: 44 mm") == []
    told = warnings(ROPE, "axial_stiffness: 89 GN, diameter: 44 mm, minimum_breaking_force: 1351 kN")
    bar = "a bar of solid steel of 44 mm has 319 MN"
    assert told == [f"rope sling has an EA of 89,000 MN, and {bar}; one of both has a wrong unit"]


def test_a_shackle_that_breaks_below_its_limit_is_refused() -> None:
    with pytest.raises(ScenarioError, match="break at 1962 kN, below its working load limit of 3924 kN"):
        warnings("load:\n", SHACKLE.replace("40 t", "400 t"))


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("1962 kN", "1962 MN", "breaks at 1,960 MN, 5,000 times its limit of 40 t"),
        ("21 kg", "21 t", "weighs 21 t and may carry 40 t"),
    ],
)
def test_a_shackle_of_two_shackles_is_told(old: str, new: str, said: str) -> None:
    told = warnings("load:\n", SHACKLE.replace(old, new))
    assert len(told) == 1
    assert said in told[0]


@pytest.mark.parametrize(("friction", "is_told"), [("50", True), ("50 %", False), ("1.5", False)])
def test_friction_without_its_per_cent_is_told(friction: str, is_told: bool) -> None:
    told = warnings("ground: {friction: 0.5}", f"ground: {{friction: {friction}}}")
    assert (
        told
        == ["the coefficient of friction of the ground is 50; 0.1 to 1 is usual; '50 %' is 0.5"] * is_told
    )


@pytest.mark.parametrize(("friction", "is_told"), [("30", True), ("30 %", False)])
def test_friction_of_a_contact_without_its_per_cent_is_told(friction: str, is_told: bool) -> None:
    """A load that stands on a deck of `mechanics` stands on no ground and no supports; 30 was in order."""
    deck = "{joint: {type: fixed}, shape: {box: [9 m, 9 m, 1 m], centre: [0 m, 0 m, -0.5 m]}}"
    touches = f"{{between: [module, deck], stiffness: 100 MN/m, friction: {friction}}}"
    mechanics = f"mechanics: {{bodies: {{deck: {deck}}}, body_contacts: {{on_deck: {touches}}}}}\nload:\n"
    told = [one for one in warnings("load:\n", mechanics) if "friction" in one]
    usual = "the coefficient of friction of contact on_deck is 30; 0.1 to 1 is usual; '30 %' is 0.3"
    assert told == [usual] * is_told


@pytest.mark.parametrize(
    ("z", "is_told"), [("0 m", True), ("1.5 mm", True), ("29 mm", True), ("31 mm", False), ("1.5 m", False)]
)
def test_a_centre_of_gravity_in_the_underside_is_told(z: str, is_told: bool) -> None:
    """The load is 3 m high, of which a hundredth is 30 mm."""
    told = warnings("at: [0 m, 0 m, 1.5 m]}", f"at: [0 m, 0 m, {z}]}}")
    assert ["above the underside of a load 3 m high" in one for one in told] == [True] * is_told


@pytest.mark.parametrize(("unit", "is_told"), [("t m^2", False), ("kg m^2", True)])
def test_an_inertia_of_another_unit_is_told(unit: str, is_told: bool) -> None:
    change = "stands_on: ground", f"stands_on: ground\n  inertia: {{{INERTIA.format(unit)}}}"
    told = warnings(*change)
    assert ["xx 0.0456 m (a solid box 1.44 m)" in one for one in told] == [True] * is_told


def test_an_inertia_beyond_the_box_is_told() -> None:
    """Nothing in the box is farther than 5 m off an axis: with 1 m to spare that is 36 m2 times 40 t."""
    body = "stands_on: ground\n  inertia: {{xx: {0} t m^2, yy: {0} t m^2, zz: {0} t m^2}}"
    assert warnings("stands_on: ground", body.format(480)) == []
    assert "xx 38.7 m" in warnings("stands_on: ground", body.format(60000))[0]


def test_creep_that_is_faster_than_all_else_is_refused() -> None:
    with pytest.raises(ScenarioError, match="creep of 30 m/min is faster than the highest speed of 3 m/min"):
        warnings("hoist: {speed: 3 m/min,", "hoist: {speed: 3 m/min, creep: 30 m/min,")
