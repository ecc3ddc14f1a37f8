"""Slips of which `gantline check` said nothing.

A body of 1e-300 kg; legs of a Goliath crane 1.4 m apart along the rail, for 14 m, which makes corner loads
ten times as uneven; wind areas of a vessel a hundredth of what its hull shows, or a hundred times that; a
filter of heave compensation of 1 s, which takes a swell for what is slow.
"""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from gantline.assembly import assemble
from gantline.assembly.doubts.masses import doubtful_masses
from gantline.scenario import load_scenario, parse_scenario

SCENARIOS = Path(__file__).resolve().parents[2] / "scenarios"


def doubts(name: str, changes: dict[str, object], said: str) -> list[str]:
    found = assemble(load_scenario(SCENARIOS / name).changed(changes)).warnings
    return [one for one in found if said in one]


@pytest.mark.parametrize(("mass", "is_told"), [("1e-300 kg", True), ("0.9 g", True), ("1.1 g", False)])
def test_a_mass_below_a_gram(mass: str, is_told: bool) -> None:
    lift = parse_scenario(
        "format: 1\nlift: {title: A bob}\nduration: 1 s\nropes: {thin: {axial_stiffness: 1 kN}}\nmechanics:\n"
        f"  bodies:\n    bob: {{at: [0 m, 0 m, 1 m], joint: {{type: point}}, mass: {mass}}}\n"
        "  ropes:\n    one: {rope: thin, length: 1 m, route: [\n"
        "          {type: end, body: world, at: [0 m, 0 m, 2 m]},\n"
        "          {type: end, body: bob}]}\n"
    )
    found = [doubt.sentence for doubt in doubtful_masses(lift)]
    assert bool(found) is is_told
    assert all("bob has a mass of" in one and "less than a gram" in one for one in found)


@pytest.mark.parametrize(("base", "is_told"), [("1.4 m", True), ("14 m", False), ("320 m", True)])
def test_a_base_of_legs_as_no_crane_has_it(base: str, is_told: bool) -> None:
    """At a span of 148 m, of which an eighth is 18.5 m; the lift file has 32 m."""
    found = doubts("goliath", {"cranes.goliath.legs.base": base}, "stand on a base of")
    assert bool(found) is is_told
    assert all(f"a base of {base} at a span of 148 m, where 19 m to 49 m is usual" in one for one in found)


@pytest.mark.parametrize(
    ("along", "area", "is_told"),
    [
        # Aside 90 m of hull show 6.5 m, 3.5 m of them above water: 585 and 315 m^2; ahead 195 and 105 m^2.
        ("y", "3 m^2", True),
        ("y", "320 m^2", False),
        ("y", "1000 m^2", False),
        ("y", "32000 m^2", True),
        ("x", "1 m^2", True),
        ("x", "600 m^2", False),
        ("x", "60000 m^2", True),
    ],
)
def test_wind_areas_of_no_vessel(along: str, area: str, is_told: bool) -> None:
    areas = {"hull": {"area": area, "coefficient": 1.0, "along": along, "at": ["45 m", "0 m", "6 m"]}}
    found = doubts("onto_a_platform", {"vessels.barge.wind_areas": areas}, "of wind areas along")
    assert bool(found) is is_told
    hull = "585 m^2, 315 m^2 above water" if along == "y" else "195 m^2, 105 m^2 above water"
    assert all(hull in one for one in found)


@pytest.mark.parametrize(("time", "is_told"), [("1 s", True), ("5 s", True), ("8 s", False), ("25 s", False)])
def test_a_filter_that_takes_waves_for_what_is_slow(time: str, is_told: bool) -> None:
    """Of a wave of w it leaves 1/sqrt(1 + (w tau)^2), of 10 s and 1 s 85 %."""
    place = "hook_types.hook_200.hoist.heave_compensation"
    given = {"speed": "1 m/s", "acceleration": "1 m/s^2", "filter": time}
    found = doubts("onto_a_platform", {place: given}, "takes waves for what is slow")
    assert bool(found) is is_told
    tau = float(time.split()[0])
    left = 100.0 / math.hypot(1.0, 2.0 * math.pi / 10.0 * tau)
    assert all(f"leaves {left:.0f} % of the heave of waves of 10 s" in one for one in found)
