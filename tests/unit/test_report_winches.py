"""The table of winches and strand jacks on the first page of a report."""

from __future__ import annotations

import re
from functools import cache

import pytest

from gantline.report import render_report
from gantline.report.first_page import stop_if
from gantline.report.sketch import sketches
from gantline.report.subject import Subject
from gantline.report.winches import winch_rows
from gantline.results import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from gantline.statics import Statics
from lift_text import changed
from shown import ROOT, lift_on
from tackle import TACKLE

#: The lift in strand jacks of the guide.
TEXT = lift_on(ROOT / "docs" / "guides" / "several_cranes.md", "A bridge section in four strand jacks")
#: Of its load [t], the levers of its pairs of jacks [m], and one bundle as far as it is hauled in [t].
LOAD, NEAR, FAR, BUNDLE = 800.0, 17.0, 19.0, (36.0 - 1.1) * 22.4e-3


@cache
def run() -> Recording:
    """That lift."""
    return simulate(parse_scenario(TEXT))


def test_gauges_read_what_hangs_from_the_jacks() -> None:
    """Hauled in alike the four bear alike while the load stands, in the end by the levers of their pairs."""
    rows, left_out = winch_rows(Subject(run()))
    assert [(row["name"], row["rope"], row["rated"]) for row in rows] == [
        (f"j{number}", f"b{number}", "300") for number in (1, 2, 3, 4)
    ]
    assert left_out == 0
    for row in rows:
        quarters = [float(reading) for reading in row["readings"][:3]]
        borne = [LOAD / 4 * part + BUNDLE / 2 for part in (0.25, 0.5, 0.75)]
        assert quarters == pytest.approx(borne, abs=0.5)
    for row, lever in zip(rows, (NEAR, NEAR, FAR, FAR), strict=True):
        hangs = LOAD * lever / (NEAR + FAR) / 2 + BUNDLE
        assert float(row["static"]) == pytest.approx(hangs, abs=0.1)
        assert float(row["readings"][3]) == pytest.approx(hangs, abs=0.2)
        assert float(row["used"]) == pytest.approx(float(row["peak"]) / 3.0, abs=0.1)
        # Anchor plates of 300 t have a half of the bundle less.
        assert float(row["lug_used"]) == pytest.approx((float(row["peak"]) - BUNDLE / 2) / 3.0, abs=0.1)


def test_the_page_has_the_table_and_stops_by_it() -> None:
    page = render_report(run())
    assert "Winches and jacks: what their gauges should read" in page
    assert page.count("of lug <i>%</i>") == 1
    assert stop_if(Subject(run()))[0] == (
        "a gauge differs by more than 10 % from its reading in the table “Winches and jacks”"
    )


def test_sketches_name_the_bundles() -> None:
    """In plan each at its corner of the load."""
    side, plan = sketches(Subject(run()))
    for view in (side, plan):
        assert {mark.text for mark in view.marks if mark.style == "sk-number"} == {"b1", "b2", "b3", "b4"}
    at = {mark.text: (mark.x, mark.y) for mark in plan.marks if mark.style == "sk-number"}
    assert at["b1"][0] < at["b3"][0] and at["b2"][0] < at["b4"][0]
    assert at["b1"][1] < at["b2"][1] and at["b3"][1] < at["b4"][1]  # y of the world is up, of paper down


def test_at_rest_gauges_read_what_hangs() -> None:
    rows, _ = winch_rows(Subject(Statics(parse_scenario(TEXT)).equilibrium().recording))
    assert [row["peak"] for row in rows] == [row["static"] for row in rows]


def test_those_that_pull_most_have_room() -> None:
    """Sixteen jacks in the place of four, of which the outer ones bear more: twelve stand on the page."""
    jack = "{diameter: 1 m, rotating_mass: 1 t, drive: {speed: 0.33 m/min, acceleration: 5 mm/s^2}}"
    names = [f"k{number}" for number in range(16)]
    drums = "".join(f"    {name}: {jack}\n" for name in names)
    ropes = "".join(
        f"    {name}: {{rope: bundle, length: as_routed, route: [{{type: end, body: world, drum: {name}, at: "
        f"[{x} m, {y} m, 40 m]}}, {{type: end, body: section, at: [{x - 1} m, {y} m, 2 m]}}]}}\n"
        for name, (x, y) in zip(names, [(x, y) for x in range(-16, 16, 4) for y in (-5, 5)], strict=True)
    )
    own = re.sub(r"(?s)  drums:.*?plan:", f"  drums:\n{drums}  ropes:\n{ropes}plan:", TEXT)
    own = own.replace("[j1, j2, j3, j4]", f"[{', '.join(names)}]")
    rows, left_out = winch_rows(Subject(simulate(parse_scenario(own[: own.index("cases:")]))))
    assert (len(rows), left_out) == (12, 4)


def test_no_lift_has_no_gauges() -> None:
    """A tackle of `mechanics` that lifts a body is no lift with a load; its page has no such table."""
    winch = ("winch: {", "winch: {rated_capacity: 8 t, ")
    assert winch_rows(Subject(simulate(parse_scenario(changed(TACKLE, winch))))) == ([], 0)
