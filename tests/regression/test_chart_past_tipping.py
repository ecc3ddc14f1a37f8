"""A rating chart ten times too large, and a hook block of 7 kg.

A chart in kilonewtons that was written in tonnes had 2310 t at 16 m, where the crane goes over with 308 t by
the masses that the same file gives it: the lift used 3 % of it and was GO. So was one of which base machine
or counterweight weighed kilograms, and nothing was said of a hook block lighter than its shackles.
"""

from __future__ import annotations

import re

import pytest

from crawler_lift import crawler_lift, tipping_mass
from gantline.assembly import assemble
from gantline.scenario import parse_scenario

ROWS = "[360 t, 283 t, 231 t, 195 t, 168 t, 130 t, 104 t]"
#: Radius [m] and ten times what is rated there [t].
CHART = tuple(
    zip(
        (12.0, 14.0, 16.0, 18.0, 20.0, 24.0, 28.0),
        (3600.0, 2830.0, 2310.0, 1950.0, 1680.0, 1300.0, 1040.0),
        strict=True,
    )
)


def told(old: str = "", new: str = "") -> list[str]:
    text = crawler_lift(60e3)
    assert old in text
    return list(assemble(parse_scenario(text.replace(old, new))).warnings)


def test_three_quarters_of_the_tipping_load_are_a_chart() -> None:
    assert not [one for one in told() if "tips the crane" in one]


def test_a_chart_ten_times_too_large_is_told() -> None:
    rows = "[3600 t, 2830 t, 2310 t, 1950 t, 1680 t, 1300 t, 1040 t]"
    (said,) = [one for one in told(ROWS, rows) if "tips the crane" in one]
    rated, radius, share = (float(part) for part in re.findall(r"([0-9.e+]+) (?:t|m|%)", said)[:3])
    assert (radius, rated) in CHART
    # The row that is furthest beyond, over the side of the crane; printed to a whole per cent.
    assert share == pytest.approx(max(100 * 1e3 * most / tipping_mass(at) for at, most in CHART), abs=0.5)
    assert share == pytest.approx(100 * 1e3 * rated / tipping_mass(radius), abs=0.5)


@pytest.mark.parametrize(
    ("old", "new"), [("base_mass: 190 t", "base_mass: 190 kg"), ("{mass: 250 t", "{mass: 250 kg")]
)
def test_masses_of_which_a_unit_has_slipped_are_told(old: str, new: str) -> None:
    assert [one for one in told(old, new) if "a mass of the crane too small" in one]


def test_rows_that_no_boom_comes_to_are_nothing_to_it() -> None:
    places = "[12 m, 14 m, 16 m, 18 m, 20 m, 24 m, 280 m]"
    assert not [
        one for one in told("[12 m, 14 m, 16 m, 18 m, 20 m, 24 m, 28 m]", places) if "tips the" in one
    ]


@pytest.mark.parametrize(("mass", "is_told"), [("7 kg", True), ("790 kg", True), ("810 kg", False)])
def test_a_hook_block_of_next_to_nothing(mass: str, is_told: bool) -> None:
    """0.2 % of 400 t are 800 kg."""
    assert bool([one for one in told("mass: 7 t", f"mass: {mass}") if "hook block of c1.H" in one]) is is_told
