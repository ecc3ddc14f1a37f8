"""Recordings for other programs: poses in glTF, numbers in tables."""

from __future__ import annotations

import csv
import json
import shutil
import struct
import sys
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from PIL import Image
from typer.testing import CliRunner, Result

import gantline
from gantline.cli.app import app
from gantline.export import RerunMissing, TableError, gltf_binary, write_csv, write_parquet, write_rerun
from gantline.export.surroundings import surroundings
from gantline.export.tables import columns
from gantline.export.video import VideoError, write_still, write_video
from gantline.plot.film import Film
from gantline.results import Recording
from hostile import hostile_recording
from sample_lift import ringing_lift, sample_recording, sample_scene

Array = npt.NDArray[np.float64]


class Glb:
    """A `.glb` file read by the specification."""

    def __init__(self, data: bytes) -> None:
        magic, version, length = struct.unpack_from("<4sII", data)
        assert (magic, version, length) == (b"glTF", 2, len(data))
        size, kind = struct.unpack_from("<I4s", data, 12)
        assert kind == b"JSON" and size % 4 == 0
        self.document: dict[str, Any] = json.loads(data[20 : 20 + size])
        rest, kind = struct.unpack_from("<I4s", data, 20 + size)
        assert kind == b"BIN\0" and rest == self.document["buffers"][0]["byteLength"]
        self.buffer = data[28 + size :]

    def values(self, accessor: int) -> Array:
        entry = self.document["accessors"][accessor]
        view = self.document["bufferViews"][entry["bufferView"]]
        width = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[entry["type"]]
        found = np.frombuffer(self.buffer, "<f4", entry["count"] * width, view["byteOffset"])
        return found.reshape(-1, width).astype(np.float64)

    def motion(self, node: str, path: str) -> tuple[Array, Array]:
        """Times and values of a node's animation."""
        animation = self.document["animations"][0]
        number = next(n for n, one in enumerate(self.document["nodes"]) if one["name"] == node)
        channel = next(c for c in animation["channels"] if c["target"] == {"node": number, "path": path})
        sampler = animation["samplers"][channel["sampler"]]
        return self.values(sampler["input"])[:, 0], self.values(sampler["output"])


def test_poses_in_gltf_are_those_of_the_recording() -> None:
    time = np.linspace(0.0, 40.0, 2001)
    recording = ringing_lift(tilt=0.2 * np.sin(time), yaw=3.0 * time, load_z=2.5 + time)
    glb = Glb(gltf_binary(recording))
    for body in recording.coordinates["body"]:
        times, places = glb.motion(body, "translation")
        at = np.array([int(np.argmin(np.abs(recording.time - when))) for when in times])
        assert np.abs(recording.time[at] - times).max() < 1e-5
        assert np.abs(places - recording.column("body_position", body)[at]).max() < 1e-5
        _, turns = glb.motion(body, "rotation")
        recorded = recording.column("body_orientation", body)[at][:, [1, 2, 3, 0]]
        # q and -q are one attitude.
        signs = np.sign(np.sum(turns * recorded, axis=1, keepdims=True))
        assert np.abs(turns * signs - recorded).max() < 1e-5
        assert (np.sum(turns[1:] * turns[:-1], axis=1) > 0.0).all()


@pytest.mark.parametrize("interval", [0.1e-3, 0.4e-3, 1e-3])
def test_fine_sampling_keeps_the_motion_from_start_to_end(interval: float) -> None:
    """Times are a millisecond apart or as little more as the samples allow, the whole lift through."""
    time = np.linspace(0.0, 1000 * interval, 1001)
    recording = sample_recording(time, tension=np.full((len(time), 5), 6e5), load_z=2.5 + time)
    times, places = Glb(gltf_binary(recording)).motion(recording.rig.loads[0].body, "translation")
    apart = np.ceil(1e-3 / interval - 1e-6) * interval
    assert np.diff(times) == pytest.approx(apart, abs=1e-7)
    assert times[-1] > time[-1] - apart
    assert places[:, 2] - places[0, 2] == pytest.approx(times, abs=1e-5)


def test_pieces_of_ropes_go_from_point_to_point() -> None:
    recording = ringing_lift()
    glb = Glb(gltf_binary(recording))
    _, begins = glb.motion("sling.S1 1", "translation")
    _, turns = glb.motion("sling.S1 1", "rotation")
    _, sizes = glb.motion("sling.S1 1", "scale")
    # The third axis of the turn, from its quaternion x y z w, is the way of the rod.
    x, y, z, w = turns.T
    way = np.column_stack([2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)])
    owner = recording["rope_of_point"].values == "sling.S1"
    path = recording["rope_point"].values[0][owner]
    assert np.abs(begins[0] - path[0]).max() < 1e-5
    assert np.abs(begins[0] + way[0] * sizes[0, 2] - path[1]).max() < 2e-5


def test_z_up_becomes_y_up() -> None:
    root = Glb(gltf_binary(ringing_lift())).document["nodes"][0]
    x, _, _, w = root["rotation"]
    assert root["name"] == "lift"
    # A quarter turn about x by -90 degrees takes z to y: y component of the turned z axis is -2xw.
    assert -2 * x * w == pytest.approx(1.0)


def test_hostile_names_are_names() -> None:
    glb = Glb(gltf_binary(hostile_recording()))
    assert any("<script>" in node["name"] for node in glb.document["nodes"])


def test_a_mesh_of_the_load_goes_along() -> None:
    plain = ringing_lift()
    scene = sample_scene()
    points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    load = next(body for body in scene["bodies"] if body["kind"] == "load")
    load["shape"] = {"type": "mesh", "vertices": points, "triangles": [[0, 1, 2], [0, 2, 3], [1, 1, 2]]}

    def made() -> bytes:
        return gltf_binary(
            Recording(plain.variables, plain.coordinates, {**plain.attributes, "scene": scene})
        )

    glb = Glb(made())
    mesh = next(one for one in glb.document["meshes"] if one["name"] == load["name"])
    count = glb.document["accessors"][mesh["primitives"][0]["attributes"]["POSITION"]]["count"]
    assert count == 6  # two triangles; the one without area is left out
    load["shape"]["triangles"] = [[0, 1, 9]]
    with pytest.raises(ValueError, match="faces without them"):
        made()


def test_a_table_has_every_sample_to_the_last_digit(tmp_path: Path) -> None:
    recording = ringing_lift()
    write_csv(recording, tmp_path / "lift.csv", ["rope_tension", "body_position"])
    with (tmp_path / "lift.csv").open(encoding="utf-8", newline="") as file:
        head, *rows = csv.reader(file)
    assert head[:2] == ["time [s]", "rope_tension.e1.equalizing [N]"]
    column = head.index("rope_tension.sling.S3 [N]")
    found = np.array([float(row[column]) for row in rows])
    np.testing.assert_array_equal(found, recording.column("rope_tension", "sling.S3"))
    height = head.index(f"body_position.{recording.rig.loads[0].body}.z [m]")
    assert float(rows[0][height]) == 2.5


def test_a_table_has_all_variables_over_time_but_paths(tmp_path: Path) -> None:
    write_csv(ringing_lift(), tmp_path / "lift.csv")
    head = (tmp_path / "lift.csv").read_text(encoding="utf-8").splitlines()[0]
    assert "load_transferred" in head and "rope_point" not in head and "rope_peak_tension" not in head


def test_points_of_paths_are_named_by_their_ropes() -> None:
    """They were `rope_point.0.x`, from which nobody told the rope, whose names no table has."""
    recording = gantline.simulate("equalizer")
    heads = [name for name, _ in columns(recording, ["rope_point"])][1:]
    points = [f"{rope}/{n}" for rope, at in recording.points_of_ropes.items() for n in range(len(at))]
    assert sorted(heads) == sorted(f"rope_point.{point}.{axis} [m]" for point in points for axis in "xyz")
    values = dict(columns(recording, ["rope_point"]))["rope_point.sling.S3/1.z [m]"]
    at = recording.points_of_ropes["sling.S3"][1]
    np.testing.assert_array_equal(values, recording["rope_point"].values[:, at, 2])


def test_variables_that_there_are_not_are_refused(tmp_path: Path) -> None:
    for name in ("nothing", "rope_peak_tension"):
        with pytest.raises(TableError, match=f"no variable '{name}' over time"):
            write_csv(ringing_lift(), tmp_path / "lift.csv", [name])


def test_parquet_without_pyarrow_is_a_sentence(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pyarrow", None)
    with pytest.raises(TableError, match="needs the package pyarrow"):
        write_parquet(ringing_lift(), tmp_path / "lift.parquet")


def test_parquet_has_the_same_numbers(tmp_path: Path) -> None:
    parquet = pytest.importorskip("pyarrow.parquet", reason="pyarrow is not installed")
    recording = ringing_lift()
    write_parquet(recording, tmp_path / "lift.parquet", ["hook_load"])
    table = parquet.read_table(tmp_path / "lift.parquet")
    assert (
        table.column("hook_load.test_hook [N]").to_numpy().tolist()
        == recording["hook_load"].values[:, 0].tolist()
    )


def test_the_command_writes_by_the_ending_of_its_file(tmp_path: Path) -> None:
    ringing_lift().save(tmp_path / "recording.nc")

    def says(*words: object) -> Result:
        return CliRunner().invoke(app, ["export", str(tmp_path), *map(str, words)])

    assert says(tmp_path / "a.glb").exit_code == 0
    assert (tmp_path / "a.glb").read_bytes()[:4] == b"glTF"
    assert says(tmp_path / "a.csv", "--variable", "hook_load").exit_code == 0
    for words, message in (
        ((tmp_path / "a.obj",), "right would be one of .glb, .rrd, .csv, .parquet, .png, .mp4, .gif"),
        ((tmp_path / "a.glb", "--variable", "hook_load"), "is about tables"),
        ((tmp_path / "a.csv", "--variable", "nothing"), "error: --variable: no variable 'nothing'"),
        ((tmp_path / "a.csv", "--variable", "rope_tensions"), "did you mean 'rope_tension'? It has"),
        ((tmp_path / "a.png", "--time", "1 h"), "error: --time: 3600 s is not within the recording, which"),
        ((tmp_path / "missing" / "a.csv",), "cannot be written"),
    ):
        result = says(*words)
        assert result.exit_code == 2 and message in result.stderr, result.output


def test_a_still_is_a_picture_of_its_moment(tmp_path: Path) -> None:
    recording = ringing_lift(load_z=2.5 + np.linspace(0.0, 5.0, 2001))
    for name, time in (("start", 0.0), ("again", 0.0), ("end", None)):
        write_still(recording, tmp_path / f"{name}.png", time)
    start, again, end = (np.asarray(Image.open(tmp_path / f"{n}.png")) for n in ("start", "again", "end"))
    assert start.shape == (720, 1280, 3)
    assert (start == again).all()
    assert (start != end).any(axis=2).mean() > 0.005  # load and cursor have moved
    with pytest.raises(ValueError, match="not within the recording"):
        write_still(recording, tmp_path / "late.png", 1e4)
    assert not (tmp_path / "late.png").exists()


def test_a_film_has_its_pictures_at_its_speed(tmp_path: Path) -> None:
    recording = ringing_lift(load_z=2.5 + np.linspace(0.0, 5.0, 2001))
    span = float(recording.time[-1] - recording.time[0])
    write_video(recording, tmp_path / "lift.gif", speed=span)
    with Image.open(tmp_path / "lift.gif") as film:
        assert (getattr(film, "n_frames", 1), film.size) == (11, (800, 450))  # a second, both ends
        assert film.info["duration"] == 100
    with pytest.raises(VideoError, match="more than 20000 pictures"):
        write_video(recording, tmp_path / "long.gif", speed=1e-4)


def test_a_picture_of_a_film_has_nothing_of_those_before() -> None:
    """Each begins with what no moment changes: of what another moment has, nothing is left."""
    recording = ringing_lift(load_z=2.5 + np.linspace(0.0, 5.0, 2001))
    film, last = Film(recording, 800), len(recording.time) - 1
    first, later, again = (film.picture(sample) for sample in (0, last, 0))
    np.testing.assert_array_equal(again, first)
    np.testing.assert_array_equal(later, Film(recording, 800).picture(last))
    for part in (np.s_[:60], np.s_[60:, :450], np.s_[60:220, 480:], np.s_[225:, 480:]):
        assert (first[part] != later[part]).any(), "caption, side, top and cursor have moved"


@pytest.mark.parametrize("speed", ["inf", "nan", "0", "-1"])
def test_a_film_has_a_finite_speed_above_zero(tmp_path: Path, speed: str) -> None:
    recording = ringing_lift()
    with pytest.raises(VideoError, match=rf"a speed of {speed} is not a finite number above zero"):
        write_video(recording, tmp_path / "lift.gif", speed=float(speed))
    recording.save(tmp_path / "lift.nc")
    words = ["export", str(tmp_path / "lift.nc"), str(tmp_path / "lift.gif"), f"--speed={speed}"]
    result = CliRunner().invoke(app, words)
    assert result.exit_code == 2
    assert result.stderr == (
        f"error: --speed: {speed} is not a finite number above zero; 2 is twice as fast as the lift\n"
    )
    assert [one.name for one in tmp_path.iterdir()] == ["lift.nc"]


def test_a_film_goes_through_ffmpeg(tmp_path: Path) -> None:
    if shutil.which("ffmpeg") is None:
        pytest.skip("ffmpeg is not on the path")
    recording = ringing_lift()
    write_video(recording, tmp_path / "lift.mp4", speed=float(recording.time[-1]))
    data = (tmp_path / "lift.mp4").read_bytes()
    assert data[4:8] == b"ftyp" and b"avc1" in data
    with pytest.raises(FileNotFoundError):
        write_video(recording, tmp_path / "nowhere" / "lift.mp4", speed=float(recording.time[-1]))


def test_without_ffmpeg_it_is_said_what_would_help(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(VideoError, match=r"needs the program ffmpeg.*gif needs nothing"):
        write_video(ringing_lift(), tmp_path / "lift.mp4")
    assert not (tmp_path / "lift.mp4").exists()


def test_without_rerun_it_is_said_what_would_help(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "rerun", None)
    with pytest.raises(RerunMissing, match="pip install rerun-sdk"):
        write_rerun(ringing_lift(), tmp_path / "lift.rrd")


def test_rerun_files_hold_the_lift(tmp_path: Path) -> None:
    pytest.importorskip("rerun", reason="rerun-sdk is not installed")
    write_rerun(ringing_lift(), tmp_path / "lift.rrd")
    data = (tmp_path / "lift.rrd").read_bytes()
    assert data.startswith(b"RRF") and len(data) > 10_000


def test_ground_has_holes_floors_and_walls_in_gltf() -> None:
    recording = ringing_lift()
    scene = {
        **recording.attributes["scene"],
        "ground": {"level": 0.0, "holes": [{"x": [-2.0, 3.0], "y": [-1.0, 1.0], "floor": -4.0}]},
        "water": {"level": -1.5},
    }
    changed = Recording(recording.variables, recording.coordinates, {**recording.attributes, "scene": scene})
    found = {one.name: one for one in surroundings(changed, np.array([0]))}
    ground, water = found["ground"], found["water"]
    corners = ground.vertices[ground.faces]
    areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2
    levels = corners[..., 2]
    floor, walls = (levels == -4.0).all(axis=1), np.ptp(levels, axis=1) > 0.0
    assert areas[floor].sum() == pytest.approx(5.0 * 2.0)
    assert areas[walls].sum() == pytest.approx(4.0 * 2 * (5.0 + 2.0))
    x, y = np.ptp(ground.vertices, axis=0)[:2]
    assert areas[~floor & ~walls].sum() == pytest.approx(x * y - 10.0)
    # Ground above the water: there is water in the hole alone, and nothing is seen through the ground.
    np.testing.assert_array_equal(water.vertices[:, :2], [(-2, -1), (3, -1), (3, 1), (-2, 1)])
    assert set(water.vertices[:, 2]) == {-1.5}
    assert (ground.kind, water.kind) == ("ground", "water")


@pytest.mark.parametrize(
    ("ground", "kinds", "covers"),
    [
        ({"level": 0.0}, ["quay", "water"], True),  # nobody says where it ends
        ({"level": -9.0}, ["ground", "water"], True),  # the bed of the sea
        ({"level": 0.0, "holes": [{"x": [-2.0, 3.0], "y": [-1.0, 1.0], "floor": -1.0}]}, ["ground"], False),
    ],
)
def test_water_is_where_the_ground_leaves_room(ground: object, kinds: list[str], *, covers: bool) -> None:
    recording = ringing_lift()
    scene = {**recording.attributes["scene"], "ground": ground, "water": {"level": -1.5}}
    changed = Recording(recording.variables, recording.coordinates, {**recording.attributes, "scene": scene})
    found = surroundings(changed, np.array([0]))
    assert [one.kind for one in found] == kinds
    if covers:
        np.testing.assert_array_equal(
            np.ptp(found[1].vertices, axis=0)[:2], np.ptp(found[0].vertices, axis=0)[:2]
        )
