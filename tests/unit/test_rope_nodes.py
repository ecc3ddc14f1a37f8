"""Recordings of ropes with nodes: one rope with many segments, and nothing of how it was computed."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import gantline
from gantline.plot.pictures import PICTURES
from gantline.plot.scene import snapshot
from gantline.results.recording import Recording
from gantline.results.rig import Rig
from gantline.results.ropes.nodes import joined
from gantline.scenario import parse_scenario
from hanging import Catenary, lift, run
from lift_text import BASE

SAGGING = Catenary(40e3, 70e3, 500.0, 5e9, 200.0)


def sagging(nodes: int = 8) -> Recording:
    return run(lift(SAGGING.reach, SAGGING.length, SAGGING.stiffness, SAGGING.weight, nodes)).recording


def test_one_rope_with_a_segment_for_every_piece() -> None:
    recording = sagging(8)
    assert recording.coordinates["rope"] == ("rope",)
    assert recording.coordinates["segment"] == tuple(f"rope/{k}" for k in range(9))
    assert recording.coordinates["body"] == ("low", "high")
    assert recording.coordinates["rope_end"] == ("first", "last")
    assert recording["rope_end_tension"].dims == ("time", "rope", "rope_end")
    sizes = recording.sizes
    assert (sizes["rope"], sizes["segment"], sizes["body"], sizes["rope_point"]) == (1, 9, 2, 10)


def test_the_drawn_path_runs_through_the_nodes() -> None:
    recording = sagging(8)
    path = recording["rope_point"].values[0]
    assert set(recording["rope_of_point"].values) == {"rope"}
    assert path[0] == pytest.approx([0, 0, 0]) and path[-1] == pytest.approx(
        [SAGGING.reach[0], 0, SAGGING.reach[1]]
    )
    gaps = np.linalg.norm(np.diff(path, axis=0), axis=1)
    assert gaps == pytest.approx(recording["segment_length"].values[0])
    assert path[:, 2].min() < -5.0  # below its lower end
    (drawn,) = snapshot(recording, 0).ropes
    assert drawn.path == pytest.approx(path)
    assert set(snapshot(recording, 0).points) == {"low", "high"}


def test_the_tension_of_the_rope_is_the_largest_along_it() -> None:
    recording = sagging(8)
    tension = recording["rope_tension"].values[:, 0]
    segments, ends = recording["segment_tension"].values, recording["rope_end_tension"].values[:, 0]
    assert tension == pytest.approx(np.maximum(segments.max(axis=1), ends.max(axis=1)))
    assert (ends[:, 1] > segments[:, -1]).all() and (ends[:, 0] > segments[:, 0]).all()  # it sags between
    assert recording.metrics()["peak_rope_tension.rope"] >= tension.max()


def test_metrics_files_and_pictures_know_one_rope(tmp_path: Path) -> None:
    recording = sagging()
    names = [name for name in recording.metrics() if name.startswith("peak_rope_tension.")]
    assert names == ["peak_rope_tension.rope"]
    again = gantline.open_recording(recording.save(tmp_path / "recording.nc"))
    assert again["rope_end_tension"].values == pytest.approx(recording["rope_end_tension"].values, abs=0)
    assert again.dataset["rope_end_tension"].sel(rope="rope", rope_end="last").shape == recording.time.shape
    assert all(rope.nodes == 8 for rope in again.rig.ropes)
    figures = [draw(recording) for draw in PICTURES.values()]
    assert sum(figure is not None for figure in figures) >= 2


def test_a_lift_without_nodes_is_recorded_as_before() -> None:
    recording = gantline.simulate(parse_scenario(BASE), duration=10.0)
    assert "rope_end_tension" not in recording and "rope_end" not in recording.coordinates


def test_a_sling_with_nodes_beside_one_without() -> None:
    text = (
        BASE.replace("start: rest", "start: settled")
        .replace("mass: none", "mass: 8 kg/m")
        .replace("rope: sling, tol", "rope: sling, rope_weight: distributed, rope_nodes: 5, tol")
    )
    recording = gantline.simulate(parse_scenario(text), integrator="adaptive", duration=10.0)
    assert recording.coordinates["rope"] == ("e1.equalizing", "sling.S1", "sling.S2")
    assert not any("/" in body for body in recording.coordinates["body"])
    ends = recording["rope_end_tension"].values
    assert ends[:, 1, 0] == pytest.approx(recording.column("rope_tension", "sling.S1"))
    assert ends[:, 1, 0] == pytest.approx(ends[:, 1, 1])
    # slack and plumb enough at the start, both ends of the sling with nodes carry its weight of 13 m
    assert recording.column("rope_tension", "sling.S1")[0] == 0.0
    assert ends[0, 2].sum() > 0.99 * 8 * 13 * 9.81
    assert recording.metrics()["peak_sling_tension"] > 0.0
    assert recording.column("segment_length", "sling.S2/5").shape == recording.time.shape


def fake(
    kinds: list[str], subjects: list[str], times: list[float]
) -> tuple[dict[str, Any], dict[str, list[str]]]:
    """Columns of a rope `a` of three pieces and a rope `b`, at two samples, with events."""
    columns = {
        "time": np.array([0.0, 1.0]),
        "rope_lengthening": np.zeros((2, 0)),
        "rope_tension": np.array([[1.0, 2.0, 3.0, 9.0], [0.0, 2.0, 5.0, 9.0]]),
        "segment_tension": np.array([[1.0, 2.0, 3.0, 9.0], [0.0, 2.0, 5.0, 9.0]]),
        "segment_length": np.ones((2, 4)),
        "rope_peak_tension": np.array([4.0, 2.0, 5.0, 9.0]),
        "rope_peak_time": np.array([0.3, 0.4, 1.0, 0.6]),
        "rope_point": np.cumsum(np.ones((2, 8, 3)), axis=1),
        "event_time": np.array(times),
        **{name: np.zeros((2, 3, 3)) for name in ("body_position", "body_velocity", "body_angular_velocity")},
        "body_orientation": np.zeros((2, 3, 4)),
        "joint_force": np.zeros((2, 3, 3)),
    }
    names = {
        "rope": ["a/0", "a/1", "a/2", "b"],
        "segment": ["a/0/0", "a/1/0", "a/2/0", "b/0"],
        "rope_point": ["a/0", "a/0", "a/1", "a/1", "a/2", "a/2", "b", "b"],
        "body": ["a/1", "a/2", "box"],
        "event_kind": kinds,
        "event_name": subjects,
    }
    return columns, names


RIG = Rig.from_json(
    {
        "gravity": 10.0,
        "ropes": [{"name": "a", "nodes": 2, "end_mass": 0.03}, {"name": "b", "weight": "lumped"}],
    }
)


def test_the_ends_carry_their_own_weight_where_they_are_taut() -> None:
    columns, names, added = joined(*fake([], [], []), RIG)
    ends = added["rope_end_tension"].values
    # all pieces run along (1, 1, 1): z has 0.3 N less at the first end, 0.3 N more at the last; slack is zero
    part = 1 / np.sqrt(3)
    assert ends[0, 0] == pytest.approx(
        [np.hypot(np.sqrt(2 / 3), part - 0.3), np.hypot(3 * np.sqrt(2 / 3), 3 * part + 0.3)]
    )
    last = np.hypot(5 * np.sqrt(2 / 3), 5 * part + 0.3)
    assert ends[1, 0] == pytest.approx([0.0, last])
    assert ends[:, 1] == pytest.approx(9.0)
    assert columns["rope_tension"] == pytest.approx(np.array([[ends[0, 0, 1], 9.0], [last, 9.0]]))
    assert columns["rope_peak_tension"] == pytest.approx([last, 9.0])
    assert columns["rope_peak_time"] == pytest.approx([1.0, 0.6])
    assert names["body"] == ["box"] and names["rope_point"] == ["a", "a", "a", "a", "b", "b"]
    assert columns["rope_point"][0, :, 0] == pytest.approx([1, 2, 4, 6, 7, 8])


def test_events_of_pieces_become_those_of_the_rope() -> None:
    kinds = ["slack", "slack", "taut", "slack", "taut", "lift_off", "taut"]
    subjects = ["a/0", "a/1", "a/0", "b", "a/1", "box", "b"]
    columns, names, _ = joined(*fake(kinds, subjects, [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]), RIG)
    assert names["event_kind"] == ["slack", "slack", "taut", "lift_off", "taut"]
    assert names["event_name"] == ["a", "b", "a", "box", "b"]
    assert list(columns["event_time"]) == [1.0, 4.0, 5.0, 6.0, 7.0]


def test_a_piece_that_is_slack_at_the_start_counts() -> None:
    _, names, _ = joined(*fake(["slack", "taut", "taut"], ["a/0", "a/0", "a/2"], [1.0, 2.0, 3.0]), RIG)
    assert list(zip(names["event_kind"], names["event_name"], strict=True)) == [("taut", "a")]


def test_a_piece_that_parts_is_the_rope_that_parts() -> None:
    kinds, subjects = ["cut", "broken", "slack"], ["a/0", "a/2", "a/1"]
    columns, names, _ = joined(*fake(kinds, subjects, [1.0, 2.0, 3.0]), RIG)
    assert list(zip(columns["event_time"], names["event_kind"], names["event_name"], strict=True)) == [
        (1.0, "cut", "a"),
        (2.0, "broken", "a"),
    ]


def test_a_sling_with_nodes_is_cut() -> None:
    """Its pieces fall from the lug or lie about; what is recorded is finite and the run goes to its end."""
    text = BASE.replace("mass: none", "mass: 16 kg/m").replace("integrator: del, step: 1 ms, ", "")
    text = text.replace(
        "S1: {from: e1.1,", "S1: {cut_at: 4 s, rope_weight: distributed, rope_nodes: 4, from: e1.1,"
    )
    recording = gantline.simulate(parse_scenario(text), duration=6.0)
    assert recording.attributes["status"] == "done"
    assert recording.events("cut") == [(4.0, "cut", "sling.S1")]
    assert all(np.isfinite(recording[name].values).all() for name in ("rope_point", "rope_tension"))
    assert np.isfinite(recording["rope_end_tension"].values).all()
    assert recording.metrics()["energy_remainder"] < 1e-5


def test_what_has_no_nodes_is_left_alone() -> None:
    columns, names = fake([], [], [])
    rig = Rig.from_json({"ropes": [{"name": "b"}]})
    assert joined(columns, names, rig) == (columns, names, {})
