"""A load in wind under fixed hooks in falls of 40 m swung as if it hung in its links alone, without a word.

A bridge section of 900 t in four strand jacks on two towers: hooks of `type: fixed_hook` with `reeving`,
which "hang in their ropes", so the page. They go up and down only: the section swung in 3.0 s on its links of
2.3 m, where 42 m make 13 s, and wind pushed it aside by a twentieth of what it would.
"""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import parse_scenario
from gantline.statics import Statics

LINK, FALLS, G = 2.3, 40.0, 9.81
LIFT = f"""\
format: 1
lift: {{title: A section in strand jacks}}
duration: 20 s
wind: {{speed: 8 m/s, direction: 90 deg}}
ropes:
  strand: {{axial_stiffness: 1100 MN, mass: none}}
  link: {{axial_stiffness: 900 MN, mass: none}}
load:
  name: section
  shape: {{box: [32 m, 4 m, 4 m]}}
  position: [0 m, 0 m, 1 m]
  weight: {{calculated: 400 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 2 m]}}
  wind_areas: {{side: {{area: 120 m^2, coefficient: 1.2, along: y, at: [0 m, 0 m, 2 m]}}}}
  lugs: {{W: {{at: [-12 m, 0 m, 4 m]}}, E: {{at: [12 m, 0 m, 4 m]}}}}
cranes:
  W:
    type: fixed_hook
    at: [-12 m, 0 m, {5 + LINK} m]
    block: {{mass: 2 t, height: 1 m}}
    reeving: {{parts_each: 1, rope: strand, sheave_diameter: 1 m, upper_sheaves_at: {6 + LINK + FALLS} m}}
    drum: {{diameter: 1 m}}
    hoist: {{speed: 0.33 m/min, acceleration: 0.01 m/s^2}}
  E:
    type: fixed_hook
    at: [12 m, 0 m, {5 + LINK} m]
    hoist: {{speed: 0.33 m/min, acceleration: 0.01 m/s^2}}
slings:
  W: {{from: W, to: section.W, length: {LINK} m, rope: link}}
  E: {{from: E, to: section.E, length: {LINK} m, rope: link}}
plan:
  - {{step: hold, hold: until_end}}
"""


def _told(text: str) -> list[tuple[str, str]]:
    return [(str(doubt.path), doubt.sentence) for doubt in assemble(parse_scenario(text)).doubts]


def test_falls_that_do_not_swing_are_told() -> None:
    (doubt,) = [found for found in _told(LIFT) if "do not swing" in found[1]]
    assert doubt[0] == "cranes.W.reeving"  # E has no falls in the lift file
    assert "do not swing, 40.0 m long here" in doubt[1]


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("wind: {speed: 8 m/s, direction: 90 deg}", "wind: {speed: 0 m/s, direction: 90 deg}"),
        ("  wind_areas: {side: {area: 120 m^2, coefficient: 1.2, along: y, at: [0 m, 0 m, 2 m]}}\n", ""),
    ],
)
def test_where_no_wind_pushes_nothing_is_told(old: str, new: str) -> None:
    assert old in LIFT
    assert not [found for found in _told(LIFT.replace(old, new)) if "do not swing" in found[1]]


def test_a_section_swings_on_its_links_as_the_warning_says() -> None:
    """Along itself, on two plumb links: omega^2 = g/L, L with their stretch of 4 mm; and nothing is slower.

    Across, where links and a section that rolls make two pendulums, the slower has g/L with the 2 m from its
    lugs to its centre of gravity at the most.
    """
    squares = sorted(mode.square for mode in Statics(parse_scenario(LIFT.replace("8 m/s", "0 m/s"))).modes())
    stretched = LINK + 200e3 * G * LINK / 900e6
    assert min(abs(square / (G / stretched) - 1.0) for square in squares) < 1e-3
    assert squares[0] > G / (LINK + 2.0) * 0.8 > 4.0 * G / (LINK + FALLS)
