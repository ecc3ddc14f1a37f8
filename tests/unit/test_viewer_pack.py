"""A recording packed for a page: what is kept, how exactly, and what is refused."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest

from gantline.results import Recording, Variable
from gantline.viewer import Packed, pack
from gantline.viewer.arrays import Arrays
from gantline.viewer.decimate import faithful, peaks
from gantline.viewer.frames import frames
from gantline.viewer.shapes import packed_shape
from packed_arrays import unpacked
from sample_lift import SLINGS, ringing_lift, sample_recording

Array = npt.NDArray[np.float64]


def test_steps_are_exact_to_half_a_step() -> None:
    values = np.random.default_rng(1).normal(scale=40.0, size=(50, 7, 3))
    arrays = Arrays()
    arrays.plain("before", [1.0, 2.0, 3.0], "f4")  # 12 bytes: what follows must begin at a multiple of 8
    arrays.steps("places", values, 1e-6)
    packed = Packed({"arrays": arrays.index}, arrays.packed())
    assert np.abs(unpacked(packed, "places") - values).max() <= 0.5e-6 * (1 + 1e-6)
    assert arrays.index["places"]["at"] % 8 == 0
    np.testing.assert_array_equal(unpacked(packed, "before"), [1.0, 2.0, 3.0])


def test_steps_grow_where_values_are_too_large_for_them() -> None:
    arrays = Arrays()
    arrays.steps("far", np.array([[0.0], [1e9]]), 1e-6)
    packed = Packed({"arrays": arrays.index}, arrays.packed())
    assert unpacked(packed, "far")[1, 0] == pytest.approx(1e9, rel=1e-9)


def test_no_value_that_is_no_number_is_packed() -> None:
    with pytest.raises(ValueError, match="no number"):
        Arrays().steps("bad", np.array([[np.nan]]), 1.0)


def test_decimated_curves_keep_their_peaks_and_stay_small() -> None:
    time = np.linspace(0.0, 100.0, 50_001)
    values = np.sin(7.0 * time)
    values[31_234] = 9.0  # one sample alone
    values[777] = -9.0
    kept = peaks(values, 200)
    assert {31_234, 777, 0, 50_000} <= set(kept.tolist())
    assert len(kept) <= 4 * 200
    assert (np.diff(kept) > 0).all()


def test_what_no_few_samples_can_follow_has_as_many_as_may_be() -> None:
    """Noise: those that are furthest off come first, and there is an end to them."""
    time = np.linspace(0.0, 100.0, 20_001)
    noise = np.random.default_rng(2).normal(size=time.size)
    kept = peaks(noise, 200)
    assert faithful(time, noise, kept, 1e-3, 10).tolist() == kept.tolist()
    assert len(faithful(time, noise, kept, 1e-3, 3000)) == 3000
    every = faithful(time, noise, kept, 0.0, 10**6)
    np.testing.assert_allclose(np.interp(time, time[every], noise[every]), noise, rtol=0.0, atol=1e-15)


def test_a_straight_stretch_needs_its_ends_alone() -> None:
    kept = peaks(np.concatenate([np.zeros(50), np.linspace(0, 1, 10)]), 100)
    assert kept[:2].tolist() == [0, 50]


def test_frames_are_spread_evenly_with_those_around_events() -> None:
    recording = ringing_lift()
    at = frames(recording, 100)
    assert at[0] == 0 and at[-1] == len(recording.time) - 1
    # Half of them; the others are where the motion bends, which it does nowhere here.
    assert np.diff(at).max() <= np.ceil(2000 / 49) + 1
    # Lift-off at 9.99 s lies between samples 499 (9.98 s) and 500 (10 s), step ends at 20 s in sample 1000.
    assert {499, 500, 1000} <= set(at.tolist())
    assert len(frames(recording, 5000)) == 2001


def test_the_packed_path_and_poses_are_those_of_the_recording() -> None:
    recording = ringing_lift()
    packed = pack(recording)
    at = unpacked(packed, "frames").astype(int)
    path = recording["rope_point"].values[at]
    assert np.abs(unpacked(packed, "path") - path).max() < 0.51e-6
    names = [body["name"] for body in packed.header["bodies"]]
    columns = [recording.coordinates["body"].index(name) for name in names]
    places = recording["body_position"].values[at][:, columns]
    assert np.abs(unpacked(packed, "position") - places).max() < 0.51e-6
    turns = recording["body_orientation"].values[at][:, columns]
    assert np.abs(unpacked(packed, "turn") - turns).max() < 0.51e-7


def test_packed_curves_have_the_peak_of_every_sling() -> None:
    recording = ringing_lift()
    packed = pack(recording)
    values = unpacked(packed, "curve_value")
    for name in SLINGS:
        curve = next(c for c in packed.header["curves"] if (c["group"], c["name"]) == ("tension", name))
        own = values[curve["first"] : curve["first"] + curve["count"]]
        # kN, float32: 24 bits of a number.
        assert own.max() == pytest.approx(recording.column("rope_tension", name).max() / 1e3, rel=1e-7)


def test_sheaves_turn_by_the_rope_that_passes_them() -> None:
    # Of the equalizing rope the first moving sheave goes down by 0.2 m, the others stay: rope comes from the
    # dead end's side alone, 2 x 0.2 m of it, since the path to the middle of its arc grows by 0.2 m; the next
    # sheaves see 0.4 m arrive.
    travel = np.zeros((3, 5))
    travel[:, 0] = [0.0, 0.1, 0.2]
    time = np.array([0.0, 1.0, 2.0])
    recording = sample_recording(time, tension=np.full((3, 5), 1e5), travel=travel)
    packed = pack(recording)
    angle = unpacked(packed, "sheave_angle")
    fixed = [k for k, sheave in enumerate(packed.header["sheaves"]) if not sheave["moves"]]
    assert np.abs(angle[2, fixed]) == pytest.approx(np.full(4, 0.4 / 0.4), abs=2e-4)
    assert np.abs(angle[2, 0]) == pytest.approx(0.2 / 0.4, abs=2e-4)


def test_a_header_is_plain_json() -> None:
    header = json.loads(pack(ringing_lift()).header_text())
    assert header["liftOff"] == pytest.approx(9.99)
    assert header["ropes"][1]["length"] == 23.0
    assert [lug["name"] for lug in header["lugs"]] == ["L1", "L2", "L3", "L4", "L5"]


def with_load_shape(shape: dict[str, Any]) -> Recording:
    recording = ringing_lift()
    scene = json.loads(json.dumps(recording.attributes["scene"]))
    next(body for body in scene["bodies"] if body["kind"] == "load")["shape"] = shape
    attributes = {**recording.attributes, "scene": scene}
    return Recording(recording.variables, recording.coordinates, attributes)


def test_meshes_and_hulls_go_among_the_arrays() -> None:
    points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    mesh = {"type": "mesh", "vertices": points, "triangles": [[0, 1, 2], [0, 2, 3]]}
    packed = pack(with_load_shape(mesh))
    shape = next(body["shape"] for body in packed.header["bodies"] if body["kind"] == "load")
    assert shape["type"] == "mesh"
    assert unpacked(packed, f"{shape['arrays']}.faces").tolist() == [[0, 1, 2], [0, 2, 3]]
    np.testing.assert_array_equal(unpacked(packed, f"{shape['arrays']}.vertices"), points)
    leg = {"size": [1, 2, 3], "centre": [0, 0, 1]}
    boxes = pack(with_load_shape({"type": "boxes", "boxes": [{"type": "box", **leg}]}))
    shape = next(body["shape"] for body in boxes.header["bodies"] if body["kind"] == "load")
    assert shape == {"type": "boxes", "boxes": [leg]}
    hull = pack(with_load_shape({"type": "convex", "points": points}))
    assert any((body["shape"] or {}).get("type") == "convex" for body in hull.header["bodies"])


@pytest.mark.parametrize(
    ("shape", "message"),
    [
        ({"type": "mesh", "vertices": [[0, 0, 0]], "faces": [[0, 1, 2]]}, "three of its vertices"),
        ({"type": "mesh", "vertices": [[0, 0, 0]], "faces": [[0, 0]]}, "three of its vertices"),
        ({"type": "mesh", "vertices": [[0, 0, "NaN"]], "faces": []}, "finite"),
        ({"type": "mesh", "vertices": [[0, 0, "<script>"]], "faces": []}, "could not convert"),
        ({"type": "box", "size": [1, 2, float("inf")]}, "finite"),
        ({"type": "convex", "points": [0, 1]}, "three finite numbers"),
    ],
)
def test_shapes_that_are_none_are_refused(shape: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        packed_shape(shape, "load", Arrays())


def test_shapes_that_are_not_known_are_not_drawn() -> None:
    assert packed_shape({"type": "teapot"}, "load", Arrays()) is None
    assert packed_shape(None, "load", Arrays()) is None


def test_a_recording_without_a_scene_can_be_packed() -> None:
    time = Variable(("time",), np.array([0.0, 1.0]), "s", "time")
    packed = pack(Recording({"time": time}, {}, {"settings": {"integrator": {"type": "del"}}}))
    assert packed.header["bodies"] == [] and packed.header["ropes"] == []
