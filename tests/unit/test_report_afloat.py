"""The first page of lifts afloat and under cranes with a boom, against the recordings that it is made of."""

from __future__ import annotations

import dataclasses
from pathlib import Path

import numpy as np
import pytest

import gantline
from ballasted import barge, lift, tank
from crawler_lift import BALLAST, BASE, BOOM, TRACK, WEIGHT, crawler_lift, tipping_mass
from gantline.report.afloat import afloat_facts, vessel_tables
from gantline.report.booms import boom_rows
from gantline.report.first_page import FirstPage
from gantline.report.plots import Tanks
from gantline.report.sketch import sketches
from gantline.report.subject import Subject
from gantline.results import Recording
from gantline.results.file.saved import Beside, SavedCase, SavedCases, SavedLostLoad, SavedSwing
from gantline.results.surroundings import Ground, Hole, is_cut, water_cut
from gantline.viewer.curves import curves

TANKS = {"fore": tank((80.0, 0.0, 0.0), 500.0), "aft": tank((20.0, 0.0, 0.0), 500.0)}
PUMP = [
    {"step": "wait", "hold": "1 s"},
    {"step": "aft", "pump": {"from": "barge.fore", "to": "barge.aft"}, "rate": "36000 t/h", "by": "50 t"},
    {"step": "lie", "hold": "until_end"},
]


@pytest.fixture(scope="module")
def pumped() -> Recording:
    line = {"vessel": "barge", "fairlead": ["100 m", "0 m", "8 m"], "to": ["130 m", "0 m", "4 m"]}
    line |= {"rope": "moor", "pretension": "150 kN", "type": "spring"}
    rope = {"axial_stiffness": "60 MN", "mass": "none", "minimum_breaking_force": "1200 kN"}
    more = {"mooring_lines": {"line": line}, "ropes": {"moor": rope}}
    return gantline.simulate(lift(barge(TANKS), PUMP, duration="20 s", **more))


def with_statics(recording: Recording, heights: object) -> Subject:
    attributes = {**recording.attributes, "statics": {"metacentric_heights": heights}}
    rest = Recording(recording.variables, recording.coordinates, attributes)
    return Subject(recording, Beside(equilibrium=rest))


def test_a_vessel_has_a_row_for_the_start_and_for_each_step(pumped: Recording) -> None:
    (table,) = vessel_tables(Subject(pumped))
    assert [row["name"] for row in table["rows"]] == ["at the start", "wait", "aft", "lie"]
    first, *_, last = table["rows"]
    assert last["lies"][0] == f"{float(pumped.column('vessel_draft_aft', 'barge')[-1]):.2f}"
    assert last["lies"][2] == f"{np.degrees(float(pumped.column('vessel_trim', 'barge')[-1])):.2f}"
    assert (first["ballast"], last["ballast"]) == ("1000", "1000")
    assert table["pumped"] == "fore 500 to 450 t, aft 500 to 550 t"
    assert table["gm"] == ""


def test_a_vessel_that_heels_farther_on_the_way_than_after_any_step_says_so(pumped: Recording) -> None:
    """At 4 s by 2.5 deg to port, its deck 1 m nearer to the water, between two ends of steps."""
    (table,) = vessel_tables(Subject(pumped))
    assert table["beyond"] == ""
    at = int(np.searchsorted(pumped.time, 4.0))
    changed = {}
    for name, more in {"vessel_heel": -np.radians(2.5), "vessel_freeboard": -1.0}.items():
        values = pumped[name].values.copy()
        values[at] += more
        changed[name] = dataclasses.replace(pumped[name], values=values)
    heeled = Recording({**pumped.variables, **changed}, pumped.coordinates, pumped.attributes)
    (table,) = vessel_tables(Subject(heeled))
    freeboard = float(heeled.column("vessel_freeboard", "barge").min())
    assert table["beyond"] == f"heel −2.50 deg at 4 s, least freeboard {freeboard:.2f} m at 4 s"
    page = FirstPage().content(Subject(heeled))
    assert page["vessels"][0]["beyond"] == table["beyond"]


def test_tanks_that_are_pumped_have_curves(pumped: Recording) -> None:
    """50 t go from one tank to the other, of those that the barge has."""
    found = {curve.label: curve for curve in curves(pumped) if curve.group == "tanks"}
    assert list(found) == ["barge.fore", "barge.aft"]
    ends = [(one.factor * one.values[0], one.factor * one.values[-1], one.unit) for one in found.values()]
    assert ends == [(500.0, pytest.approx(450.0), "t"), (500.0, pytest.approx(550.0), "t")]
    [plot] = Tanks().plots(Subject(pumped))
    assert (plot["groups"], plot["unit"]) == (["tanks"], "t")
    rig = {**pumped.attributes["rig"], "plan": []}
    still = Recording({}, {}, {**pumped.attributes, "rig": rig})
    assert Tanks().plots(Subject(still)) == []


def test_the_largest_mooring_force_is_that_of_the_recording(pumped: Recording) -> None:
    facts = dict(afloat_facts(Subject(pumped)))
    most = float(pumped["rope_peak"].values.max()) if "rope_peak" in pumped else 0.0
    most = max(most, float(pumped.column("mooring_tension", "line").max()))
    # 2 kN, to 1 %.
    assert facts["largest mooring force"].startswith(f"line {most / 1e3:.2f} kN at ")
    assert facts["largest mooring force"].endswith(f"{100 * most / 1200e3:.0f} % of breaking")
    assert facts["sudden release of the load"].startswith("not simulated")


def test_cases_of_a_release_stand_on_the_first_page(pumped: Recording) -> None:
    cases = SavedCases("", False, [SavedCase("", 1, ()), SavedCase("release", 1, ("freeboard failed",))], [])
    facts = dict(afloat_facts(Subject(pumped, Beside(cases=cases))))
    assert facts["case release"] == "freeboard failed"


def test_a_load_that_is_lost_stands_on_the_first_page(pumped: Recording) -> None:
    swing = SavedSwing("barge", "stern", np.radians(2.684), 0.826, 28.74)
    lost = SavedLostLoad("", True, "module", 40.0, [swing])
    facts = dict(afloat_facts(Subject(pumped, Beside(lost_load=lost))))
    assert facts["'module' lost at once"] == "at 40.0 s, comes back"
    assert facts["barge as it is lost"] == "2.68 deg towards its stern, freeboard 0.83 m, A2/A1 28.7"
    gone = dataclasses.replace(swing, farthest=None, freeboard=None, ratio=0.8)
    facts = dict(
        afloat_facts(
            Subject(pumped, Beside(lost_load=dataclasses.replace(lost, is_sound=False, swings=[gone])))
        )
    )
    assert facts["'module' lost at once"] == "at 40.0 s, DOES NOT COME BACK"
    assert facts["barge as it is lost"] == "no end towards its stern, A2/A1 0.8"
    wet = dataclasses.replace(lost, is_sound=False, flooded=["barge.hatch"])
    facts = dict(afloat_facts(Subject(pumped, Beside(lost_load=wet))))
    assert facts["'module' lost at once"] == "at 40.0 s, UNDER WATER ALREADY WITH IT: barge.hatch"


def test_a_lost_load_of_a_file_from_before_openings_were_looked_at() -> None:
    swings: list[object] = []
    document = {"sound": True, "scenario_sha256": "", "load": "module", "time": 40.0, "swings": swings}
    assert SavedLostLoad.from_json(document).flooded == []
    assert SavedLostLoad.from_json({**document, "flooded": ["barge.hatch"]}).flooded == ["barge.hatch"]


def test_what_a_vessel_does_after_a_rope_has_parted(pumped: Recording) -> None:
    more = {"event_time": 4.0, "event_kind": "cut", "event_name": "mooring.line"}
    changed = {
        name: dataclasses.replace(pumped[name], values=np.array([*pumped[name].values.tolist(), value]))
        for name, value in more.items()
    }
    coordinates = {name: labels for name, labels in pumped.coordinates.items() if name != "event"}
    parted = Recording({**pumped.variables, **changed}, coordinates, pumped.attributes)
    facts = dict(afloat_facts(Subject(parted)))
    trim = np.abs(pumped.column("vessel_trim", "barge")[pumped.time >= 4.0]).max()
    assert facts["sudden release"] == "at 4.0 s"
    assert facts["barge after it"].startswith(f"trim {np.degrees(trim):.1f} deg")


def test_gm_comes_from_the_equilibrium_beside_the_recording(pumped: Recording) -> None:
    (table,) = vessel_tables(with_statics(pumped, {"barge": [7.25, 203.0]}))
    assert table["gm"] == "7.25 m for heel, 203.0 m for trim"
    for wrong in ({"barge": "7"}, {"barge": [1.0]}, {}, None):
        (table,) = vessel_tables(with_statics(pumped, wrong))
        assert table["gm"] == ""


def test_a_crawler_crane_has_its_chart_its_ground_and_its_tipping(tmp_path: Path) -> None:
    path = tmp_path / "lift.yaml"
    path.write_text(crawler_lift(100e3), encoding="utf-8")
    subject = Subject(gantline.simulate(path))
    (row,) = boom_rows(subject)
    # 231 t are rated at 16 m; ropes stretch and the crane leans by less than what is shown.
    assert (row["name"], row["hangs"]) == ("c1", "100.0")
    assert float(row["may"]) == pytest.approx(231.0, abs=3.0)
    assert float(row["used"]) == pytest.approx(100.0 * 100.0 / 231.0, abs=0.6)
    assert float(row["tipping"]) == pytest.approx(100.0 * 100e3 / tipping_mass(16.0), abs=1.0)
    mean = (BASE + BALLAST + WEIGHT + BOOM + 100e3) * 9.81 / (2 * TRACK * 6.0) / 1e3
    assert float(row["pressure"]) > mean  # the boom is over the side
    page = FirstPage().content(subject)
    assert page["booms"] == [row]
    assert page["stands_on_tracks"]


def test_sketches_have_water_where_the_ground_leaves_room() -> None:
    basin = {"basin": {"type": "dock", "x": ["-20 m", "120 m"], "y": ["-30 m", "30 m"], "floor": "-10 m"}}
    ground = {"level": "3 m", "stiffness": "200 MN/m", "damping": "2 MN s/m"}
    recording = gantline.simulate(lift(barge(TANKS), [], duration="1 s", ground=ground, structures=basin))
    side, plan = sketches(Subject(recording))
    (water,) = [mark for mark in side.marks if mark.style == "sk-water"]
    points = np.array([[float(part) for part in point.split(",")] for point in water.points.split()])
    # Both ends are written to a hundredth of a unit of the drawing.
    assert np.ptp(points[:, 1]) * side.scale == pytest.approx(10.0, abs=0.02 * side.scale)
    assert any(mark.style == "sk-surface" for mark in side.marks)
    assert any(mark.style.startswith("sk-solid sk-hull") for mark in plan.marks)


def test_the_water_is_cut_by_the_ground() -> None:
    dock = Ground(3.5, (Hole((0.0, 50.0), (-20.0, 20.0), -12.0),))
    lift_at = np.array([[-10.0, -5.0, 0.0], [60.0, 5.0, 30.0]])
    (cut,) = water_cut(dock, 0.0, 0, ((-30.0, 90.0), -15.0), lift_at)
    np.testing.assert_array_equal(cut, [(0, -12), (50, -12), (50, 0), (0, 0)])
    assert water_cut(dock, -13.0, 0, ((-30.0, 90.0), -15.0), lift_at) == []
    # Nobody says where a quay without a dock ends; the bed of the sea has water all over.
    for ground, low in ((Ground(3.5, ()), -15.0), (None, -15.0), (Ground(-8.0, ()), -8.0)):
        (cut,) = water_cut(ground, 0.0, 0, ((-30.0, 90.0), -15.0), lift_at)
        np.testing.assert_array_equal(cut, [(-30, low), (90, low), (90, 0), (-30, 0)])
    grounds = (dock, Ground(3.5, ()), Ground(-8.0, ()), None)
    assert [is_cut(one, 0.0) for one in grounds] == [True, False, True, False]
