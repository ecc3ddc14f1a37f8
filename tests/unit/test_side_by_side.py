"""Vessels of one database: where they have to lie, what is said where they do not, and the file itself."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pytest

import databases
import two_hulls
import waves
from afloat import MASS
from gantline.assembly import assemble
from gantline.hydro import DatabaseError, HydrodynamicDatabase, read_database, write_database
from gantline.hydro.database.model import AXES, Coupling
from gantline.hydro.side_by_side import asymmetries, forces_side_by_side
from gantline.results.afloat.unfollowed import parted_neighbours
from gantline.scenario import ScenarioError, load_scenario
from gantline.simulation import simulate

SWELL = {"height": "1 m", "period": "8 s", "direction": "90 deg"}


def placed(lift: Path) -> str:
    """Warnings of a lift, one a line."""
    return "\n".join(assemble(load_scenario(lift)).warnings)


def refused(lift: Path) -> str:
    with pytest.raises(ScenarioError) as caught:
        assemble(load_scenario(lift))
    return str(caught.value)


def at(x: float, y: float) -> dict[str, Any]:
    """The right one with its stern so far from where the file has it [m]."""
    place = two_hulls.REFERENCES[1, :2] + [x - 50.0, y]
    return {"position": [f"{part} m" for part in place]}


def test_both_as_in_the_file_are_in_order(tmp_path: Path) -> None:
    """Neither the lee nor the water between them is left out: nothing is said of hulls 10 m apart."""
    two_hulls.database(tmp_path / "two.nc")
    said = placed(two_hulls.in_waves(tmp_path, SWELL))
    assert "apart" not in said and "as if alone" not in said and "lies" not in said


def test_a_third_one_is_alone(tmp_path: Path) -> None:
    """One more, 5 m behind the left one, of a file of its own: of it and either of both it is said."""
    two_hulls.database(tmp_path / "two.nc")
    waves.database(tmp_path, waves.radiated)
    own = {"database": "barge.nc", "at": ["50 m", "0 m", "4 m"]}
    path = two_hulls.in_waves(tmp_path, SWELL)
    lift = json.loads(path.read_text(encoding="utf-8"))
    third = {**lift["vessels"]["left"], "wave_forces": own, "radiation": own}
    lift["vessels"]["third"] = {**third, "position": ["-143 m", "-7 m"]}
    path.write_text(json.dumps(lift), encoding="utf-8")
    said = placed(path)
    assert "left and third lie 5.0 m apart" in said
    assert "right and third lie 10.0 m apart" not in said and "left and right" not in said


def test_a_little_elsewhere_is_a_warning(tmp_path: Path) -> None:
    """From 0.2 m on; (3, 4) m are 5 m."""
    two_hulls.database(tmp_path / "two.nc")
    assert "lies" not in placed(two_hulls.in_waves(tmp_path, SWELL, right=at(-0.14, 0.14)))
    assert "0.21 m from there" in placed(two_hulls.in_waves(tmp_path, SWELL, right=at(0.15, -0.15)))
    said = placed(two_hulls.in_waves(tmp_path, SWELL, right=at(3.0, 4.0)))
    lies = "the reference point of right lies (8.00, 44.00) m from that of left, along the axes of two.nc"
    assert f"{lies}; there it is (5.00, 40.00) m, 5.00 m from there" in said


def test_far_elsewhere_is_refused(tmp_path: Path) -> None:
    """From a quarter of the breadth of the narrower on, 7.5 m of 30 m."""
    two_hulls.database(tmp_path / "two.nc")
    wide = {"hull": {"box": ["100 m", "36 m", "8 m"]}}
    said = refused(two_hulls.in_waves(tmp_path, SWELL, left=wide, right=at(0.0, 7.6)))
    assert (
        "vessels.right.position: the reference point of right lies (5.00, 47.60) m from that of left" in said
    )
    assert "7.60 m from there: see 'position' and 'at', or compute the file as they lie" in said
    placed(two_hulls.in_waves(tmp_path, SWELL, left=wide, right=at(0.0, 7.4)))


@pytest.mark.parametrize(
    ("degrees", "refuses"),
    [(0.49, None), (-0.49, None), (0.51, False), (-0.51, False), (4.9, False), (5.1, True), (-5.1, True)],
)
def test_headings(tmp_path: Path, degrees: float, refuses: bool | None) -> None:
    """The right one turned about its reference point."""
    two_hulls.database(tmp_path / "two.nc")
    by = math.radians(degrees)
    stern = two_hulls.REFERENCES[1, :2] - 50.0 * np.array([math.cos(by), math.sin(by)])
    turned = {"position": [f"{part} m" for part in stern], "heading": f"{degrees} deg"}
    path = two_hulls.in_waves(tmp_path, SWELL, right=turned)
    said = refused(path) if refuses else placed(path)
    sentence = (
        f"right has a heading of {degrees:.3g} deg from that of left, and by their 'heading_in_file' 0 deg"
    )
    assert (sentence in said) == (refuses is not None)
    assert ("vessels.right.heading" in said) == bool(refuses)
    assert ("they have to be the same" in said) == bool(refuses)


def test_bodies_that_are_no_vessels(tmp_path: Path) -> None:
    two_hulls.database(tmp_path / "two.nc")
    said = refused(two_hulls.in_waves(tmp_path, SWELL, right={"wave_forces": None}))
    assert (
        "vessels.left.wave_forces.database: two.nc has right beside left, and no vessel of the lift has"
        in said
    )
    assert "a vessel of its own for each by 'body', or a file of one that lies alone" in said
    both = {"database": "two.nc", "body": "left", "at": ["50 m", "0 m", "4 m"]}
    said = refused(two_hulls.in_waves(tmp_path, SWELL, right={"wave_forces": both}))
    assert "vessels.right.wave_forces.body: 'left' of two.nc is left already; name another body" in said


def test_a_body_by_no_name_or_another(tmp_path: Path) -> None:
    two_hulls.database(tmp_path / "two.nc")
    none = {"database": "two.nc", "at": ["50 m", "0 m", "4 m"]}
    said = refused(two_hulls.in_waves(tmp_path, SWELL, left={"wave_forces": none}))
    assert (
        "left.wave_forces.database: two.nc: has several bodies, left, right; name one of them by 'body'"
        in said
    )
    said = refused(two_hulls.in_waves(tmp_path, SWELL, left={"wave_forces": {**none, "body": "wrong"}}))
    assert "left.wave_forces.database: two.nc: has no body 'wrong'; it has left, right" in said


@pytest.mark.parametrize(
    ("kind", "axes", "largest"),
    [
        ("damping", ("heave", "heave"), ("heave", "heave")),
        ("damping", ("sway", "roll"), ("heave", "pitch")),
        ("added_mass", ("roll", "surge"), ("pitch", "heave")),
    ],
)
def test_what_one_does_to_the_other_goes_both_ways(
    tmp_path: Path, kind: str, axes: tuple[str, str], largest: tuple[str, str]
) -> None:
    """0.3 more there than back of what shifts and turns have at most, heave and pitch; water that swings in
    a gap, whose added mass is below zero, counts by its size.
    """
    path = two_hulls.database(tmp_path / "two.nc")
    left, right = (read_database(path, body) for body in two_hulls.BODIES)
    assert asymmetries(left, right)[0] < 1e-12
    by_left, by_right = (AXES.index(axis) for axis in axes)
    of_left, of_right = (AXES.index(axis) for axis in largest)
    crooked = getattr(right.others["left"], kind).copy()
    own = np.abs(getattr(right, kind))
    crooked[7, by_right, by_left] += 0.3 * math.sqrt(
        own[:, of_left, of_left].max() * own[:, of_right, of_right].max()
    )
    one_way = {"left": right.others["left"]._replace(**{kind: crooked})}
    swings = (
        replace(left, added_mass=-left.added_mass),
        replace(right, added_mass=-right.added_mass, others=one_way),
    )
    for one, other in ((left, replace(right, others=one_way)), swings):
        share, said = asymmetries(one, other)
        assert share == pytest.approx(0.3, rel=1e-12)
        what = f"{kind.replace('_', ' ')} of left's {axes[0]} and right's {axes[1]}"
        assert said == f"{what} at {2 * math.pi / 0.55:.4g} s"


def askew(monkeypatch: pytest.MonkeyPatch, there: float, back: float) -> None:
    """Let files have so much more damping of the left heave by the right one, and back, of the largest."""
    given = two_hulls.radiation

    def radiation(*which: Any) -> Any:
        added, damping = given(*which)
        scale = damping[:, 2, 2].max()
        damping[10, 2, 8] += there * scale
        damping[10, 8, 2] += back * scale
        return added, damping

    monkeypatch.setattr(two_hulls, "radiation", radiation)


@pytest.mark.parametrize(("share", "refuses"), [(0.049, None), (0.051, False), (0.249, False), (0.251, True)])
def test_what_goes_both_ways_unlike_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, share: float, refuses: bool | None
) -> None:
    """From 5 % of the diagonal on, and refused from 25 %; at 0.2 + 10 · 0.05 rad/s."""
    askew(monkeypatch, share, 0.0)
    two_hulls.database(tmp_path / "two.nc")
    path = two_hulls.in_waves(tmp_path, SWELL)
    said = refused(path) if refuses else placed(path)
    what = f"damping of left's heave and right's heave at {2 * math.pi / 0.7:.4g} s"
    sentence = (
        f"two.nc: {what}, the same there and back by nature, differ by {100 * share:.2g} % of the diagonal"
    )
    right = {
        None: "differ by",
        False: f"{sentence}; their mean is taken",
        True: f"{sentence}; finer panels agree",
    }
    assert (right[refuses] in said) == (refuses is not None)
    assert ("vessels.right.wave_forces.database" in said) == bool(refuses)


def test_the_mean_of_what_goes_both_ways_is_taken(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """0.2 there and none back push as 0.1 both ways do, and otherwise than none."""
    swell = {**SWELL, "period": f"{2 * math.pi / 0.7!r} s"}
    pushed = []
    for there, back in ((0.2, 0.0), (0.1, 0.1), (0.0, 0.0)):
        with monkeypatch.context() as patch:
            askew(patch, there, back)
            two_hulls.database(tmp_path / "two.nc")
            document: Any = assemble(load_scenario(two_hulls.in_waves(tmp_path, swell))).document
            phasors = [one["phasors"] for one in document["forces"] if one["type"] == "wave"]
            pushed.append(np.array(phasors))
    one_way, mean, none = pushed
    scale = np.abs(none).max(axis=(1, 2, 3, 5), keepdims=True)
    assert np.abs(one_way - mean).max() < 1e-9 * scale.min()
    assert np.abs((none - mean) / scale).max() > 0.01


def test_a_matrix_of_another_file_is_no_matter(tmp_path: Path) -> None:
    """Added mass and damping of a run may be of a hull that is alone: its motions in waves stay the same."""
    two_hulls.database(tmp_path / "two.nc", water=waves.constant)
    waves.database(tmp_path, waves.radiated)
    alone = {"radiation": {"database": "barge.nc", "at": ["50 m", "0 m", "4 m"]}}
    omega = 0.7
    period = 2 * math.pi / omega
    swell = {"height": "0.2 mm", "period": f"{period!r} s", "direction": "90 deg"}
    settings: dict[str, Any] = {
        "duration": f"{60 * period!r} s",
        "simulation": {"sample_interval": f"{period / 16!r} s"},
    }
    run = simulate(
        two_hulls.in_waves(tmp_path, swell, left=alone, right=alone, **settings),
        tension_tolerance=0.1,
        position_tolerance=1e-9,
    )
    heave = waves.harmonic(*late(run, period, run.variables["body_position"].values[:, 1, 2]), omega)
    added, damping = two_hulls.radiation(water=waves.constant)
    place = int(np.argmin(np.abs(waves.FREQUENCIES - omega)))
    whole = -(omega**2) * added[place] - 1j * omega * damping[place]
    nothing = np.zeros((6, 6))
    for rows in (slice(0, 6), slice(6, 12)):
        whole[rows, rows] += waves.impedance(omega, nothing, nothing)
    moved = 1e-4 * np.linalg.solve(whole, two_hulls.excitation(omega, math.pi / 2))
    assert heave == pytest.approx(moved[8], abs=1e-5 * abs(moved[8]))


def late(run: Any, period: float, values: Any) -> tuple[Any, Any]:
    kept = run.time > run.time[-1] - 10 * period + 1e-9
    return run.time[kept], values[kept]


def test_files_of_bemio(tmp_path: Path) -> None:
    """Columns of the other body, unscaled as its own; zeros of bodies that were computed alone are none."""
    path = databases.bemio(tmp_path / "two.h5", bodies=2)
    assert not read_database(path, "box1").others
    with h5py.File(path, "r+") as file:
        file["body1/hydro_coeffs/added_mass/all"][2, 8] = 0.5
        file["body1/hydro_coeffs/radiation_damping/all"][2, 8] = 0.25
    found = read_database(path, "box1").others
    assert list(found) == ["box2"]
    assert found["box2"].added_mass[:, 2, 2] == pytest.approx(0.5 * databases.DENSITY, rel=1e-12)
    wanted = 0.25 * databases.DENSITY * databases.OMEGA
    assert found["box2"].damping[:, 2, 2] == pytest.approx(wanted, rel=1e-12)


def test_one_of_several_is_not_written_as_if_alone(tmp_path: Path) -> None:
    found = read_database(two_hulls.database(tmp_path / "two.nc"), "left")
    with pytest.raises(DatabaseError, match="left lies beside right in its file; one that lies alone"):
        write_database(found, tmp_path / "one.nc")


def test_numbers_of_others_have_the_shape_of_its_own(tmp_path: Path) -> None:
    found = read_database(two_hulls.database(tmp_path / "two.nc"), "left")
    short = {"right": found.others["right"]._replace(damping=np.zeros((3, 6, 6)))}
    with pytest.raises(DatabaseError, match="what right does to left is no 57 × 6 × 6 numbers"):
        replace(found, others=short)


def test_axes_of_a_file_turn(tmp_path: Path) -> None:
    """A hull of another heading in its file is the same hull, with waves from elsewhere."""
    straight = read_database(two_hulls.database(tmp_path / "a.nc"), "left")
    askew = read_database(two_hulls.database(tmp_path / "b.nc", (1.1, 0.0)), "left").along(1.1)
    assert askew.added_mass == pytest.approx(straight.added_mass, rel=1e-9, abs=1.0)
    by = math.radians(30.0) - 1.1
    place = int(np.argmin(np.abs((askew.directions - by + math.pi) % math.tau - math.pi)))
    own = two_hulls.SHELTER[0] * waves.force_per_metre(0.7, by)
    turned = two_hulls.turn(1.1)[:2, :2] @ two_hulls.REFERENCES[0, :2]
    assert askew.reference == pytest.approx([*turned, 0.0], abs=1e-12)
    way = 0.49 / waves.G * float(turned @ [math.cos(by), math.sin(by)])
    assert askew.excitation is not None
    assert askew.excitation[10, place] == pytest.approx(own * np.exp(1j * way), rel=1e-9)


def test_headings_in_a_file_that_differ_by_key(tmp_path: Path) -> None:
    two_hulls.database(tmp_path / "two.nc")
    other = {"database": "two.nc", "body": "left", "at": ["50 m", "0 m", "4 m"], "heading_in_file": "180 deg"}
    said = placed(two_hulls.in_waves(tmp_path, SWELL, left={"radiation": other}))
    assert "'heading_in_file' is 180 deg and that of 'wave_forces' 0 deg; a file has one of each body" in said


@pytest.mark.parametrize(
    ("across", "turns", "since", "by"),
    [
        (0.1, (0.0, 0.0), 87.0, "10.8 m and 0.0 deg"),
        (0.0, (0.0, 0.1), 63.0, "0.0 m and 10.8 deg"),
        (0.0, (0.0, -0.1), 63.0, "0.0 m and 10.8 deg"),
        (0.05, (0.0, 0.03), None, ""),
        (0.0, (0.1, 0.1), None, ""),
        (0.1, (0.3, 0.3), 87.0, "10.8 m and 0.0 deg"),
    ],
)
def test_neighbours_that_part_in_a_run(
    tmp_path: Path, across: float, turns: tuple[float, float], since: float | None, by: str
) -> None:
    """Of 120 s in which the right one goes across [m/s], while it sways by 5 m in each wave of 8 s, and each
    turns about its middle [deg/s], the right one going round with the left one: from 7.5 m on, a quarter of
    the breadth of the narrower, or 5 deg, by means over the longest wave, the first 4 s after the start at
    7 s, the next half a wave later and so on. Both lie at a bearing of their own. Of a run of less than three
    waves nothing is said. The centre of gravity of the right one lies 10 m ahead of its middle.
    """
    two_hulls.database(tmp_path / "two.nc")
    assembly = assemble(load_scenario(two_hulls.in_waves(tmp_path, SWELL, bearing=0.3)))
    run = np.arange(0.0, 120.01, 0.25)
    headings = [0.3 + math.radians(turning) * run for turning in turns]
    along = np.column_stack([np.cos(headings[0]), np.sin(headings[0])])
    aside = np.column_stack([-along[:, 1], along[:, 0]])
    position, orientation = np.zeros((len(run), 2, 3)), np.zeros((len(run), 2, 4))
    away = across * run + 5.0 * np.sin(2 * math.pi / 8.0 * run)
    position[:, 1, :2] = 5.0 * along + (40.0 + away)[:, np.newaxis] * aside
    for k, turned in enumerate(headings):
        orientation[:, k, 0], orientation[:, k, 3] = np.cos(turned / 2), np.sin(turned / 2)
        position[:, k, :2] += (0.0, 10.0)[k] * np.column_stack([np.cos(turned), np.sin(turned)])
    columns = {"time": 7.0 + run, "body_position": position, "body_orientation": orientation}
    left, right = two_hulls.BODIES
    half = {left: 20.0, right: 15.0}
    hulls = {name: np.array([[0.0, -y, 0.0], [100.0, y, 8.0]]) for name, y in half.items()}
    names = {"body": list(two_hulls.BODIES)}
    document: Any = assembly.document
    for one in document["bodies"]:
        one["centre_of_gravity"] = [60.0 if one["name"] == right else 50.0, 0.0, 5.0]
    swell = document["sea"]["components"][0]
    document["sea"]["components"].append({**swell, "frequency": 2.0 * swell["frequency"]})
    document["forces"].append({"type": "drag", "body": right})
    said = parted_neighbours(document, columns, names, [set(two_hulls.BODIES)], hulls)
    if since is None:
        assert said == []
    else:
        sentence = (
            f"wave forces of left and right: from {since:.0f} s on they lie elsewhere beside each other"
        )
        assert said == [
            f"{sentence} than at the start, by up to {by}, and feel waves as if they still lay there"
        ]
    assert parted_neighbours(document, columns, names, [], hulls) == []
    position[:, 1, :2] += run[:, np.newaxis] * aside
    for short, is_told in ((run < 23.9, False), (run < 24.6, True)):
        few = {name: values[short] for name, values in columns.items()}
        assert bool(parted_neighbours(document, few, names, [set(two_hulls.BODIES)], hulls)) == is_told


def test_a_run_of_neighbours_says_nothing(tmp_path: Path) -> None:
    two_hulls.database(tmp_path / "two.nc")
    run = simulate(two_hulls.in_waves(tmp_path, SWELL, duration="40 s"))
    assert not [one for one in run.attributes["warnings"] if "beside each other" in one]


def test_damping_by_hand_is_none_of_motions_side_by_side(tmp_path: Path) -> None:
    """But on top of radiation."""
    two_hulls.database(tmp_path / "two.nc")
    by_hand: dict[str, Any] = {"water_damping": {"at": ["50 m", "0 m", "4 m"], "roll": "200 MN m s"}}
    sentence = "side by side left has in waves the damping of two.nc and none of 'water_damping'"
    assert sentence not in placed(two_hulls.in_waves(tmp_path, SWELL, left=by_hand))
    assert sentence in placed(two_hulls.in_waves(tmp_path, SWELL, left={**by_hand, "radiation": None}))


def test_added_mass_below_zero_beside_others(tmp_path: Path) -> None:
    """Water that swings in a gap gives more back than there is inertia in it; no energy is gained."""
    found = read_database(two_hulls.database(tmp_path / "two.nc"), "left")
    swings = found.added_mass.copy()
    swings[:, 1, 1] = -0.4 * swings[:, 2, 2]
    with pytest.raises(DatabaseError) as caught:
        replace(found, added_mass=swings).added_mass_at(2 * math.pi / 0.7, 1025.0)
    said = str(caught.value)
    assert "a motion whose added mass is below zero, by " in said
    assert "as water that swings beside right makes it; 'radiation' or another period can have it" in said
    with pytest.raises(DatabaseError, match="gains energy from the water"):
        replace(found, added_mass=swings, others={}).added_mass_at(2 * math.pi / 0.7, 1025.0)


def test_one_file_by_two_paths(tmp_path: Path) -> None:
    two_hulls.database(tmp_path / "two.nc")
    right = {"database": "./two.nc", "body": "right", "at": ["50 m", "0 m", "4 m"]}
    assert "as if alone" not in placed(two_hulls.in_waves(tmp_path, SWELL, right={"wave_forces": right}))


@pytest.mark.parametrize(("ballast", "bears"), [(0.0, True), (2e6, False), (0.98e6, True), (1.02e6, False)])
def test_a_load_that_stands_aboard_moves_with_its_vessel(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, ballast: float, bears: bool
) -> None:
    """2000 t, 3 m over the deck, on a vessel that floats as deep as with them; what has its mass without them
    bears none yet, and half of it is the bound. About the reference point, 4 m over the keel, its moment is
    that of hull and load.
    """
    two_hulls.database(tmp_path / "two.nc")
    x, y = two_hulls.REFERENCES[1, :2]
    load = {
        "name": "module",
        "shape": {"box": ["10 m", "10 m", "6 m"]},
        "datum": "bottom_centre",
        "position": [f"{x} m", f"{y} m", "4 m"],
        "weight": {"calculated": "2000 t", "contingency": "1.0", "simulate": "calculated"},
        "centre_of_gravity": {"at": ["0 m", "0 m", "3 m"]},
        "lugs": {"A": {"at": ["0 m", "0 m", "6 m"]}},
    }
    deck = {
        "parent": "right",
        "at": ["50 m", "0 m", "8 m"],
        "joint": {"type": "fixed"},
        "shape": {"box": ["12 m", "12 m", "1 m"], "centre": ["0 m", "0 m", "-0.5 m"]},
    }
    stands = {"between": ["module", "deck"], "stiffness": "100 MN/m", "damping": "1 MN s/m"}
    mechanics = {"bodies": {"deck": deck}, "body_contacts": {"stands": stands}}
    own = MASS - 2e6 + ballast
    hull = {"hull": {"mass": f"{own} kg", "at": ["50 m", "0 m", "5 m"]}}
    seen: list[Any] = []

    def watched(bodies: Any, *rest: Any) -> Any:
        seen.append(bodies)
        return forces_side_by_side(bodies, *rest)

    monkeypatch.setattr("gantline.assembly.afloat.side_by_side.forces_side_by_side", watched)
    path = two_hulls.in_waves(tmp_path, SWELL, right={"masses": hull}, load=load, mechanics=mechanics)
    assemble(load_scenario(path))
    inertia = seen[0][1].inertia
    assert inertia[0, 0] == pytest.approx(own + (2e6 if bears else 0.0), rel=1e-12)
    # Surge with pitch is m z: hull 1 m, load 8 + 3 - 4 m over the point.
    moment = own * 1.0 + (2e6 * 7.0 if bears else 0.0)
    assert inertia[0, 4] == pytest.approx(moment, rel=1e-9)


def thinner(database: HydrodynamicDatabase) -> HydrodynamicDatabase:
    """The same hull in a water of half its density."""
    assert database.density is not None and database.excitation is not None
    others = {name: Coupling(*(0.5 * values for values in one)) for name, one in database.others.items()}
    return replace(
        database,
        density=0.5 * database.density,
        added_mass=0.5 * database.added_mass,
        damping=0.5 * database.damping,
        excitation=0.5 * database.excitation,
        others=others,
    )


def test_a_file_of_another_water(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """All that water does goes with its density: a file of half of it pushes as the file of that water."""
    two_hulls.database(tmp_path / "two.nc")
    asked: list[Any] = []

    def watched(*of: Any) -> Any:
        asked.append((of, forces_side_by_side(*of)))
        return asked[-1][1]

    monkeypatch.setattr("gantline.assembly.afloat.side_by_side.forces_side_by_side", watched)
    assemble(load_scenario(two_hulls.in_waves(tmp_path, SWELL)))
    assert len(asked) == 2
    for (bodies, *rest), found in asked:
        thin = [thinner(body.database) for body in bodies]
        # A file that does not say is of the water of the lift.
        unsaid = [replace(body.database, density=None) for body in bodies]
        for files in (thin, unsaid):
            of_file = [replace(body, database=file) for body, file in zip(bodies, files, strict=True)]
            again = forces_side_by_side(of_file, *rest)
            assert np.abs(again.cubics - found.cubics).max() < 1e-9 * np.abs(found.cubics).max()


@pytest.mark.parametrize("held", [True, False])
def test_long_waves_beside_one_held_fast(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, held: bool) -> None:
    """Where a file has what a neighbour that is held takes of the heave of a hull, −ω² A_j3, it is of the
    hull; where it has not, of another: ω² A is 9 MN/m in its longest waves, 0.2 rad/s, of 30.2 MN/m by the
    waterplane less 1.7 MN/m by mass and added mass.
    """
    coupled = 9e6 / 0.2**2
    given = two_hulls.radiation

    def radiation(*which: Any) -> Any:
        added, damping = given(*which)
        added[:, 2, 8] = added[:, 8, 2] = coupled
        return added, damping

    def excitation(frequency: float, direction: float, headings: tuple[float, float]) -> Any:
        found = []
        for place in two_hulls.REFERENCES:
            way = frequency**2 / waves.G * (place[:2] @ [math.cos(direction), math.sin(direction)])
            alone = waves.force_per_metre(frequency, direction)
            alone[2] -= coupled * frequency**2 if held else 0.0
            found.append(np.exp(1j * way) * alone)
        return np.concatenate(found)

    monkeypatch.setattr(two_hulls, "radiation", radiation)
    monkeypatch.setattr(two_hulls, "excitation", excitation)
    two_hulls.database(tmp_path / "two.nc")
    said = placed(two_hulls.in_waves(tmp_path, SWELL))
    assert ("is of another hull, draft or scale" in said) != held
