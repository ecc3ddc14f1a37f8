"""Mistakes in the shape of a round load, and what is doubtful about it."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pytest

import gantline
from gantline.assembly import assemble
from gantline.scenario import load_scenario
from hull_lift import text
from round_lift import assembled, round_lift

PLAIN = {"diameter": "5 m", "length": "20 m"}


def problem(folder: Path, given: dict[str, Any]) -> str:
    path = folder / "scenario.yaml"
    path.write_text(text(given))
    with pytest.raises(gantline.ScenarioError) as raised:
        assemble(load_scenario(path))
    return str(raised.value)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ({**PLAIN, "wall": "2.5 m"}, "cylinder.wall: a tube 5 m across has no room for two walls of 2.5 m"),
        ({**PLAIN, "end_diameter": "1 m", "wall": "0.6 m"}, "a tube 1 m across has no room"),
        ({"radius": "2 m", "length": "20 m"}, "a cylinder has a 'diameter', and no 'radius'"),
        ({**PLAIN, "along": "y"}, "cylinder.along"),
        ({**PLAIN, "diameter": "0 m"}, "cylinder.diameter"),
        ({**PLAIN, "length": 20}, "cylinder.length"),
    ],
)
def test_a_cylinder_that_is_none(tmp_path: Path, words: dict[str, Any], said: str) -> None:
    assert said in problem(tmp_path, round_lift(words, (0, 0, 2.5)))


@pytest.mark.parametrize(
    ("shape", "said"),
    [
        (
            {"box": ["1 m", "1 m", "1 m"], "cylinder": PLAIN},
            "a 'box', a 'cylinder' or comes from 'cad', one of them",
        ),
        (
            {"cylinder": PLAIN, "thickness": "60 mm"},
            "'thickness' is for a shape from 'cad'; a cylinder says its units; a tube has a 'wall'",
        ),
        ({"cylinder": PLAIN, "up": "y"}, "'up' is for a shape from 'cad'; a cylinder says its units"),
        ({}, "'cylinder: {diameter: 6 m, length: 40 m}'"),
    ],
)
def test_a_shape_is_one_thing(tmp_path: Path, shape: dict[str, Any], said: str) -> None:
    assert said in problem(tmp_path, round_lift(PLAIN, (0, 0, 2.5), load={"shape": shape}))


def test_what_comes_from_cad_needs_a_file(tmp_path: Path) -> None:
    load = {"inertia": "from_cad", "datum": "origin"}
    said = problem(tmp_path, round_lift(PLAIN, (0, 0, 2.5), load=load))
    assert "'homogeneous' is a solid cylinder" in said
    assert "'bottom_centre' is right for a cylinder" in said


def test_one_that_lies_on_bare_ground_rolls(tmp_path: Path) -> None:
    given = round_lift(PLAIN, (0, 0, 2.5), load={"stands_on": "ground"}, start="rest")
    said = problem(tmp_path, given)
    assert "load.stands_on: a round load that lies on the ground rolls" in said
    assert "'height: to_load', or let it roll by 'start: as_given'" in said
    assembled(tmp_path, {**given, "start": "as_given"})


def test_it_stands_at_rest_beside_a_dock_on_supports_alone(tmp_path: Path) -> None:
    dock = {"type": "dock", "x": ["30 m", "60 m"], "y": ["-9 m", "9 m"], "floor": "-8 m"}
    standing = {**PLAIN, "along": "z"}
    given = round_lift(
        standing, (0, 0, 2.5), load={"stands_on": "ground"}, start="rest", structures={"dock": dock}
    )
    assert "around a dock a round load at rest stands on 'supports'" in problem(tmp_path, given)


def test_it_displaces_no_more_than_is_in_it(tmp_path: Path) -> None:
    """Its box of 500 m³ has room for 400, and what is round in it has 392.7 m³."""
    in_water = {
        "displaced_volume": "400 m^3",
        "added_mass": ["1 t", "1 t", "1 t"],
        "drag_coefficients": ["1", "1", "1"],
    }
    given = round_lift(PLAIN, (0, 0, 2.5), load={"in_water": in_water}, water={"level": "-9 m"})
    assert "400 m^3 are more than the load has, 392.7 m^3" in problem(tmp_path, given)


def test_its_tanks_are_inside_of_it(tmp_path: Path) -> None:
    """A box of 4 m by 4 m is in that of 5 m, and its corners are 0.33 m outside of a circle of that size."""
    tank = {"box": ["4 m", "4 m", "4 m"], "bottom": ["0 m", "0 m", "0.5 m"], "content": "10 t"}
    given = round_lift(PLAIN, (0, 0, 2.5), load={"tanks": {"one": tank}})
    assert "load.tanks.one: a corner of it is 0.328 m outside the round load" in problem(tmp_path, given)


def test_what_weighs_more_than_steel_is_told(tmp_path: Path) -> None:
    """A bar of 1 m by 20 m is 15.7 m³, 123.3 t of steel; its box would have room for 157 t."""
    given = round_lift(
        {"diameter": "1 m", "length": "20 m"}, (0, 0, 0.5), load={"weight": {"calculated": "140 t"}}
    )
    doubts = [str(doubt) for doubt in assembled(tmp_path, given).doubts]
    assert any("more than it full of steel, 123.3 t" in doubt for doubt in doubts)


def test_falls_through_it_are_told(tmp_path: Path) -> None:
    """From eyes under a pipe 1 m across, at its sides by a quarter of its radius, falls cut through it."""
    route = [
        {"type": "end", "body": "hook"},
        {"type": "eye", "body": "column", "at": ["0 m", "0.2 m", "-0.45 m"]},
        {"type": "eye", "body": "column", "at": ["0 m", "-0.2 m", "-0.45 m"]},
        {"type": "end", "body": "hook"},
    ]
    given = round_lift(
        {"diameter": "1 m", "length": "20 m"}, (0, 0, 0.5), load={"weight": {"calculated": "20 t"}}
    )
    given["mechanics"] = {"ropes": {"basket": {"rope": "sling", "length": "as_routed", "route": route}}}
    doubts = [str(doubt) for doubt in assembled(tmp_path, given).doubts]
    assert any("basket goes through column, up to" in doubt for doubt in doubts)
    places = [(0.5, 0.0), (0.35, -0.35), (0.0, -0.5), (-0.35, -0.35), (-0.5, 0.0)]
    eyes = [{"type": "eye", "body": "column", "at": ["0 m", f"{y} m", f"{z} m"]} for y, z in places]
    given["mechanics"]["ropes"]["basket"]["route"] = [route[0], *eyes, route[-1]]
    doubts = [str(doubt) for doubt in assembled(tmp_path, given).doubts]
    assert not any("goes through" in doubt for doubt in doubts)


def test_areas_are_held_against_what_it_shows(tmp_path: Path) -> None:
    """A standing one shows 5 m by 20 m from the side: 210 m² are more than twice that."""
    area = {"area": "210 m^2", "coefficient": "0.7", "along": "x", "at": ["0 m", "0 m", "10 m"]}
    given = round_lift(
        {**PLAIN, "along": "z"},
        (0, 0, 2.5),
        load={"wind_areas": {"side": area}},
        wind={"speed": "8 m/s", "direction": "0 deg"},
    )
    doubts = [str(doubt) for doubt in assembled(tmp_path, given).doubts]
    assert any(
        "column has 210 m^2 of wind areas along x, and all that it shows there is 100 m^2" in one
        for one in doubts
    )


@pytest.mark.parametrize(("along", "area"), [("x", math.pi * 6.25), ("y", 100.0), ("z", 100.0)])
def test_an_area_is_what_it_shows(tmp_path: Path, along: str, area: float) -> None:
    """Of a lying one its end, π D²/4, and its side, D L: ½ ρ C A in air of 1.225 kg/m³."""
    given = round_lift(
        PLAIN,
        (0, 0, 2.5),
        load={"wind_areas": {"all": {"coefficient": "0.7", "along": along}}},
        wind={"speed": "8 m/s", "direction": "0.5 rad"},
    )
    [force] = [one for one in assembled(tmp_path, given).document["forces"] if one["type"] == "drag"]
    assert sum(force["quadratic"]) == pytest.approx(0.5 * 1.225 * 0.7 * area, rel=1e-12)


def test_a_shape_from_cad_says_no_area(tmp_path: Path) -> None:
    load = {"shape": {"cad": "none.obj"}, "wind_areas": {"all": {"coefficient": "0.7", "along": "x"}}}
    said = problem(
        tmp_path, round_lift(PLAIN, (0, 0, 2.5), load=load, wind={"speed": "0 m/s", "direction": "0 deg"})
    )
    assert "load.wind_areas.all: a shape from CAD does not say what it shows; write 'area: 120 m^2'" in said
