"""Gusts in lift files: what is refused, what is held against limits, and what results say of them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from typer.testing import CliRunner

import gantline
from gantline.assembly import assemble
from gantline.cli.app import app
from gantline.cli.hold_points import hold_points
from gantline.cli.summary import heading
from gantline.plot.traces import attitude as picture
from gantline.report.attitude import attitude
from gantline.report.first_page import stop_if
from gantline.report.plots import Attitude
from gantline.report.subject import Subject
from gantline.results import Recording
from gantline.results.rig import Rig
from gantline.scenario import ScenarioError, load_scenario, parse_scenario, shipped
from gantline.statics import Statics
from gantline.viewer.curves import curves
from json_lift import plain_lift
from lift_text import spoiled

AREA = {"area": "100 m^2", "coefficient": 1.2, "along": "x"}


def windy(folder: Path, wind: dict[str, Any]) -> Path:
    body = {"joint": {"type": "slider", "axis": [1, 0, 0]}, "mass": "2 t", "wind_areas": {"side": AREA}}
    return plain_lift(folder, {"body": body}, wind={"speed": "10 m/s", "direction": "0 deg", **wind})


@pytest.mark.parametrize(
    ("wind", "said"),
    [
        ({"gusts": {}}, "wind.gusts: needs 'speed: 16 m/s', the speed of gusts, or 'turbulence: 15 %'"),
        ({"gusts": {"speed": "14 m/s", "turbulence": "10 %"}}, "'speed' says already how strong gusts are"),
        ({"gusts": {"speed": "10 m/s"}}, "gusts of 10 m/s are no faster than the mean of 10 m/s"),
        ({"gusts": {"turbulence": "60 %"}}, "turbulence of 60 % is more than wind has"),
        ({"speed": "0 m/s", "gusts": {"speed": "3 m/s"}}, "there are no gusts without wind"),
        ({"gusts": {"speed": "14 m/s", "components": 3}}, "components"),
        ({"gusts": {"speed": "14 m/s", "length": "0 m"}}, "length"),
    ],
)
def test_what_is_refused(tmp_path: Path, wind: dict[str, Any], said: str) -> None:
    with pytest.raises(ScenarioError) as error:
        assemble(load_scenario(windy(tmp_path, wind)))
    assert said in str(error.value)


def test_gusts_by_themselves_are_told_where_they_belong(tmp_path: Path) -> None:
    """People look for them beside the wind."""
    path = plain_lift(
        tmp_path, {"body": {"joint": {"type": "point"}, "mass": "1 t"}}, gusts={"speed": "14 m/s"}
    )
    with pytest.raises(ScenarioError) as error:
        load_scenario(path)
    assert "gusts belong to 'wind'" in str(error.value)


def test_another_seed_is_another_record_of_the_same_gusts(tmp_path: Path) -> None:
    def record(**gusts: Any) -> list[dict[str, Any]]:
        path = windy(tmp_path, {"gusts": {"speed": "14 m/s", **gusts}})
        found: list[dict[str, Any]] = assemble(load_scenario(path)).document["gusts"]["components"]
        return found

    first, again, other = record(), record(seed=1), record(seed=2)
    assert first == again
    assert [one["phase"] for one in first] != [one["phase"] for one in other]
    assert [one["amplitude"] for one in first] == [one["amplitude"] for one in other]


def test_limits_of_cranes_are_for_gusts() -> None:
    """A Goliath crane that may lift in 16 m/s, in wind of 12 m/s that gusts to 17."""
    wind = {"speed": "12 m/s", "direction": "0 deg", "gusts": {"speed": "17 m/s"}}
    lift = load_scenario(shipped()["goliath"]).changed({"wind": wind})
    (crane,) = Rig.from_json(assemble(lift).rig).cranes
    assert crane.wind == 17.0


@pytest.fixture(scope="module")
def swung(tmp_path_factory: pytest.TempPathFactory) -> Recording:
    """The load of a scenario in gusts along x."""
    text = shipped()["spreader_bar"].read_text(encoding="utf-8")
    wind = "wind: {speed: 8 m/s, direction: 0 deg, gusts: {speed: 12 m/s, seed: 3}}\n"
    areas = "  wind_areas: {end: {area: 40 m^2, coefficient: 1.2, along: x}}\n"
    path = tmp_path_factory.mktemp("gusts") / "lift.yaml"
    path.write_text(spoiled("load:\n", f"{wind}load:\n{areas}", text), encoding="utf-8")
    return gantline.simulate(path, duration=30.0)


def test_what_results_say(swung: Recording) -> None:
    """Speeds at the load are those of the record there, and report, player, pictures and tables have them."""
    wind = swung.rig.wind
    assert wind is not None and wind.gusts is not None
    (load,) = swung.rig.loads
    place = swung.column("body_position", load.body)[:, :2]
    found = swung.column("wind_at_load", load.name)
    assert np.array_equal(found, wind.speed_at(swung.time, place))
    assert found[0] == pytest.approx(8.0, abs=1e-12)
    assert float(np.std(found[swung.time > 20.0])) > 0.3
    said = "8.0 m/s towards 0 deg, gusts of 12.0 m/s"
    assert any(line.startswith(f"Wind: {said}") for line in heading(swung.rig))
    rows = dict(attitude(Subject(swung)))
    assert rows["wind"].startswith(said) and rows["wind"].endswith("record 3")
    assert rows[f"wind at {load.name}"] == f"{found.min():.1f} m/s to {found.max():.1f} m/s"
    assert "gusts are over 12.0 m/s, or from elsewhere" in stop_if(Subject(swung))
    (curve,) = [one for one in curves(swung) if one.group == "wind"]
    assert np.array_equal(curve.values, found)
    assert "Wind at the load, gusts included" in [plot["title"] for plot in Attitude().plots(Subject(swung))]
    figure = picture(swung)
    assert figure is not None
    assert "Wind [m/s]" in [panel.get_ylabel() for panel in figure.axes]


def test_at_rest_the_wind_is_steady(swung: Recording, tmp_path: Path) -> None:
    """Statics say that they leave gusts out, and have no speed of a gust at that time of the plan."""
    path = tmp_path / "lift.yaml"
    path.write_text(str(swung.attributes["scenario"]), encoding="utf-8")
    rest = Statics(path).equilibrium(20.0).recording
    assert "wind_at_load" not in rest and rest.rig.time_to_average == 0.0
    found = CliRunner().invoke(app, ["statics", str(path), "--time", "20 s"]).output
    assert "Wind: 8.0 m/s towards 0 deg\n" in found and "Steady wind: without its gusts" in found


def test_readings_of_a_moment_are_as_gusts_have_them(swung: Recording) -> None:
    """A hold point is one moment."""
    heads = [line for line in hold_points(swung) if line.startswith("At the end of 'look round'")]
    assert [head.endswith("s, as gusts have it then") for head in heads] == [True]


def test_quiet_windows_average_over_gusts(swung: Recording, tmp_path: Path) -> None:
    """As long as gusts take to grow; steady wind asks for no more than still air."""
    assert swung.rig.time_to_average == 20.0
    assert Rig.from_json(assemble(load_scenario(windy(tmp_path, {}))).rig).time_to_average == 0.0


@pytest.mark.parametrize(
    ("profile", "answer"),
    [
        ("{}", "needs 'terrain: sea', or 'roughness: 3 mm' or 'exponent: 0.14' instead"),
        ("{terrain: sea, exponent: 0.1}", "'terrain' says already how wind grows; leave one out"),
        ("{terrain: town, height: 5 m}", "below 10 m wind does not grow over that; measured at 5 m"),
        ("{alpha: 0.14}", "a power of the height is an 'exponent'"),
        ("{terrain: forest}", "'sea', 'flat', 'fields', 'suburbs' or 'town'"),
    ],
)
def test_a_profile_that_cannot_be_is_refused(profile: str, answer: str) -> None:
    """What is missing, said twice, or without growth where it was measured."""
    wind = f"wind: {{speed: 8 m/s, direction: 0 deg, profile: {profile}}}\n"
    with pytest.raises(ScenarioError) as found:
        parse_scenario(spoiled("load:\n", f"{wind}load:\n"))
    assert answer in str(found.value)
