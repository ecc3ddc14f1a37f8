"""Stop if a load cell differs from its reading, `in water from  t in “wet”`: jacks had none there.

A section of 800 t that four strand jacks lower into the sea. The sentence had readings of hooks alone, of
which there are none; and gauges read an eighth less in water than in the table, past the 10 % at which one
stops. Which of the jacks a number was of, its place among them had to tell.
"""

from __future__ import annotations

import re

import pytest

from gantline.report.first_page import stop_if
from gantline.report.subject import Subject
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from lift_text import changed
from shown import ROOT, lift_on

#: What the section displaces [m^3], density of the sea [t/m^3].
DISPLACED, DENSITY = 100.0, 1.025
#: Load and one bundle as it hangs in the water [t]; of the pairs of jacks the levers about its weight [m].
LOAD, BUNDLE, NEAR, FAR = 800.0, 46.0 * 22.4e-3, 17.0, 19.0
PLAN = """\
plan:
  - {step: air, hold: 30 s}
  - {step: down, pay_out: [j1, j2, j3, j4], speed: 3 m/min, by: 10 m}
  - {step: wet, hold: until_end}
"""


def test_it_is_told_what_gauges_read_in_water() -> None:
    """By levers, less a quarter each of what is displaced, amid the jacks; bundles as they hang to 0.5 t."""
    text = lift_on(ROOT / "docs" / "guides" / "several_cranes.md", "A bridge section in four strand jacks")
    water = f"displaced_volume: {DISPLACED} m^3, added_mass: [200 t, 200 t, 600 t]"
    text = changed(
        re.sub(r"(?s)plan:\n.*", PLAN, text),
        (
            "ground: {level: 0 m, stiffness: 400 MN/m, damping: 4 MN s/m, friction: 0.4}",
            "water: {level: 0 m}",
        ),
        (
            "stands_on: ground",
            f"position: [0 m, 0 m, 2 m]\n  in_water: {{{water}, drag_coefficients: [1.2, 1.2, 1.8]}}",
        ),
        ("duration: 500 s", "duration: 400 s\nstart: rest"),
        ("speed: 0.33 m/min", "speed: 3 m/min"),
    )
    told = stop_if(Subject(simulate(parse_scenario(text))))[0]
    found = re.fullmatch(r".*“Winches and jacks”, which is that in air; in water from (.*) t in “wet”", told)
    assert found is not None
    names, numbers = zip(*(one.split() for one in found[1].split(" / ")), strict=True)
    assert names == ("j1", "j2", "j3", "j4")
    readings = [float(one) for one in numbers]
    hangs = [LOAD * lever / (NEAR + FAR) / 2 for lever in (NEAR, NEAR, FAR, FAR)]
    assert readings == pytest.approx([one + BUNDLE - DENSITY * DISPLACED / 4 for one in hangs], abs=0.5)
