"""Recordings: what they hold, how they are derived from columns, and their files."""

import json
import time as clock
from pathlib import Path
from typing import Any

import h5netcdf
import h5py
import numpy as np
import pytest
import xarray

import gantline
from gantline.results.derive import recording_of
from gantline.results.file.netcdf import _write, load_rig, save_recording
from gantline.results.recording import Recording, open_recording
from gantline.results.series import sling_direction
from gantline.results.variable import Variable
from sample_lift import (
    ENERGIES,
    SLINGS,
    WEIGHT,
    ringing_lift,
    sample_recording,
    sample_rig,
    with_empty_ones,
)


def short_lift(**given: Any) -> Recording:
    return sample_recording(np.array([0.0, 1.0, 2.0]), tension=np.full((3, 5), 1e5), **given)


def test_numpy_takes_a_variable_for_its_values() -> None:
    values = np.array([[1.0, 2.0], [3.0, 4.0]])
    variable = Variable(("time", "rope"), values, "N", "tension")
    assert np.asarray(variable).shape == (2, 2)
    assert np.max(variable) == 4.0
    np.testing.assert_array_equal(np.array(variable, dtype=np.float32), values.astype(np.float32))
    copied = np.array(variable)
    copied[0, 0] = 9.0  # a copy may be changed, the recording not
    assert np.asarray(variable)[0, 0] == 1.0
    with pytest.raises(ValueError, match="read-only"):
        np.asarray(variable)[0, 0] = 9.0


def test_variables_cannot_be_changed() -> None:
    values = np.array([1.0, 2.0])
    variable = Variable(("time",), values, "N", "a force")
    values[0] = 9.0
    assert variable.values[0] == 1.0
    with pytest.raises(ValueError, match="read-only"):
        variable.values[0] = 3.0
    with pytest.raises(AttributeError):
        variable.unit = "kN"  # type: ignore[misc]


def test_a_variable_needs_a_dimension_for_every_axis() -> None:
    with pytest.raises(ValueError, match="2 axes"):
        Variable(("time",), np.zeros((2, 3)), "N", "a force")


def test_lengths_must_agree() -> None:
    time = Variable(("time",), np.zeros(3), "s", "time")
    force = Variable(("time", "rope"), np.zeros((4, 1)), "N", "tension")
    with pytest.raises(ValueError, match="force is 4 long in time, other variables 3"):
        Recording({"time": time, "force": force}, {}, {})
    with pytest.raises(ValueError, match="2 names for the 3 values in time"):
        Recording({"time": time}, {"time": ["a", "b"]}, {})


def test_columns_are_found_by_name() -> None:
    recording = ringing_lift()
    assert recording.column("rope_tension", "sling.S2")[-1] == pytest.approx(1.01 * 600e3)
    assert recording.column("body_position", "block").shape == (2001, 3)
    with pytest.raises(
        KeyError, match=r"no variable 'rope_tensions' .*; did you mean 'rope_tension'\? It has"
    ):
        recording["rope_tensions"]
    with pytest.raises(KeyError, match=r"rope_tension has no 'sling.S9'; it has e1\.equalizing, sling\.S1, "):
        recording.column("rope_tension", "sling.S9")
    with pytest.raises(KeyError, match=r"rope_tension has no 'S2'; it has sling\.S2\""):
        recording.column("rope_tension", "S2")


def test_variables_of_the_results_table_with_their_dimensions_and_units() -> None:
    recording = short_lift()
    table = {
        "rope_tension": ("time rope", "N"),
        "segment_tension": ("time segment", "N"),
        "segment_length": ("time segment", "m"),
        "rope_point": ("time rope_point xyz", "m"),
        "body_position": ("time body xyz", "m"),
        "body_orientation": ("time body wxyz", "1"),
        "body_velocity": ("time body xyz", "m/s"),
        "body_angular_velocity": ("time body xyz", "rad/s"),
        "sheave_travel": ("time moving_sheave", "m"),
        "momentum": ("time xyz", "kg m/s"),
        "angular_momentum": ("time xyz", "kg m^2/s"),
        "joint_position": ("time joint", "m or rad"),
        "contact_force": ("time contact", "N"),
        "hook_load": ("time hook", "N"),
        "hoist_load": ("time hook", "N"),
        "load_transferred": ("time load", "1"),
        "load_tilt": ("time load", "rad"),
        "energy": ("time energy_kind", "J"),
        "event_time": ("event", "s"),
        "event_kind": ("event", "1"),
        "event_name": ("event", "1"),
        "residual_constraint": ("time", "m"),
        "residual_complementarity": ("time", "N"),
        "rope_peak_tension": ("rope", "N"),
        "rope_peak_time": ("rope", "s"),
    }
    found = {name: (" ".join(recording[name].dims), recording[name].unit) for name in table}
    assert found == table


def test_hook_load_is_the_vertical_force_of_the_bearing_and_hoist_load_adds_the_hook_block() -> None:
    recording = short_lift()
    # five slings of 100 kN and 21.5 t of frame and sheaves; 50 kN of hook block and falls
    assert recording.column("hook_load", "test_hook") == pytest.approx(5e5 + 21.5e3 * 9.81)
    assert recording.column("hoist_load", "test_hook") == pytest.approx(5e5 + 21.5e3 * 9.81 + 50e3)


def test_load_transferred_is_what_the_supports_no_longer_carry() -> None:
    contact = np.array([[0.25] * 4, [0.125] * 4, [0.0] * 4]) * WEIGHT
    assert short_lift(contact=contact).column("load_transferred", "block") == pytest.approx([0.0, 0.5, 1.0])


def test_load_tilt_is_the_angle_from_plumb() -> None:
    tilt = np.array([0.0, 1e-9, 0.3])
    assert short_lift(tilt=tilt).column("load_tilt", "block") == pytest.approx(tilt, rel=1e-9, abs=1e-15)


def test_sheave_travel_is_counted_from_where_the_lift_file_has_it() -> None:
    # As strokes and stops are. Counted from the start of a run at rest it was wrong by what rest had moved.
    travel = np.array([[0.2] * 5, [0.5] * 5, [-0.1] * 5])
    assert short_lift(travel=travel).column("sheave_travel", "e1.3") == pytest.approx([0.2, 0.5, -0.1])


def test_a_sling_that_hangs_in_the_hook_adds_the_vertical_part_of_its_tension() -> None:
    # 3-4-5 triangle: 100 N along (3, 0, -4)/5 pull the hook down with 80 N
    one = np.zeros((1, 1))
    columns = {
        "time": np.zeros(1),
        "rope_tension": one + 100.0,
        "rope_point": np.array([[[0.0, 0.0, 4.0], [3.0, 0.0, 0.0]]]),
        "body_position": np.zeros((1, 1, 3)),
        "body_orientation": np.array([[[1.0, 0.0, 0.0, 0.0]]]),
        "body_velocity": np.zeros((1, 1, 3)),
        "body_angular_velocity": np.zeros((1, 1, 3)),
        "joint_force": np.zeros((1, 1, 3)),
        "segment_tension": one + 100.0,
        "segment_length": one + 5.0,
        "momentum": np.zeros((1, 3)),
        "angular_momentum": np.zeros((1, 3)),
        "energy": np.zeros((1, len(ENERGIES))),
        "residual_constraint": np.zeros(1),
        "residual_complementarity": np.zeros(1),
        "rope_peak_tension": np.full(1, 100.0),
        "rope_peak_time": np.zeros(1),
    }
    names = {
        "rope": ["sling.A"],
        "segment": ["sling.A/0"],
        "rope_point": ["sling.A", "sling.A"],
        "body": ["hook"],
        "energy_kind": ENERGIES,
        "event_kind": [],
        "event_name": [],
    }
    rig = {"hooks": [{"name": "hook", "bearing_joints": [], "direct_slings": ["sling.A"]}]}
    recording = recording_of(*with_empty_ones(columns, names), rig)
    assert recording.column("hook_load", "hook") == pytest.approx([80.0])
    assert "joint_position" not in recording
    assert "contact_force" not in recording


def test_a_file_gives_back_the_recording(tmp_path: Path) -> None:
    recording = ringing_lift(rig=sample_rig(load_tilt=0.03, rule="example"))
    again = gantline.open_recording(recording.save(tmp_path / "lift.nc"))
    assert set(again) == set(recording)
    for name, variable in recording.variables.items():
        assert again[name].dims == variable.dims
        assert (again[name].unit, again[name].description) == (variable.unit, variable.description)
        np.testing.assert_array_equal(again[name].values, variable.values)
    assert again.coordinates == recording.coordinates
    assert again.attributes == recording.attributes
    assert again.rig == recording.rig
    assert again.metrics() == recording.metrics()


def test_a_file_without_events_and_with_a_long_lift_file(tmp_path: Path) -> None:
    recording = short_lift()
    attributes = {**recording.attributes, "scenario": "é" * 200_000}
    recording = Recording(recording.variables, recording.coordinates, attributes)
    again = gantline.open_recording(recording.save(tmp_path / "lift.nc"))
    assert again.events() == []
    assert again.attributes["scenario"] == "é" * 200_000


def test_large_variables_are_read_by_any_library(tmp_path: Path) -> None:
    # Several chunks of one megabyte of which the last is not full; one has the name of a dimension.
    rng = np.random.default_rng(5)
    values = rng.normal(size=(1000, 300, 3))
    series = rng.normal(size=20_001)
    recording = Recording(
        {
            "time": Variable(("time",), np.arange(1000.0), "s", "time"),
            "point": Variable(("time", "point", "xyz"), values, "m", "points"),
            "long": Variable(("sample",), series, "N", "a long series"),
        },
        {"xyz": list("xyz")},
        {"rig": {}, "settings": {"integrator": {"type": "del"}}, "status": "done"},
    )
    path = recording.save(tmp_path / "large.nc")
    back = open_recording(path)
    assert np.array_equal(back["point"].values, values)
    assert np.array_equal(back["long"].values, series)
    with h5py.File(path) as file:
        stored = file["_nc4_non_coord_point"]
        assert stored.compression == "gzip" and stored.shuffle
        # A component apart from the others: what stands side by side is alike then.
        assert stored.chunks == ((1 << 20) // (300 * 8), 300, 1)
        assert np.array_equal(stored[...], values)


def test_same_recording_same_bytes_at_another_time(tmp_path: Path) -> None:
    first = ringing_lift().save(tmp_path / "first.nc").read_bytes()
    clock.sleep(1.1)  # HDF5 counts whole seconds where it keeps times
    assert ringing_lift().save(tmp_path / "second.nc").read_bytes() == first


def test_xarray_reads_the_root_group(tmp_path: Path) -> None:
    path = ringing_lift().save(tmp_path / "lift.nc")
    with xarray.open_dataset(path) as dataset:
        tension = dataset["rope_tension"].sel(rope="sling.S2")
        assert float(tension[-1]) == pytest.approx(1.01 * 600e3)
        assert tension.attrs["units"] == "N"
        assert dataset["time"].attrs == {"units": "s", "long_name": "time since the start of the lift"}
        assert json.loads(dataset.attrs["rig"])["number"] == "EQ-300"
        assert list(dataset["event_kind"].values[:2]) == ["step_begin", "lift_off"]


def test_the_dataset_is_that_of_the_file(tmp_path: Path) -> None:
    recording = ringing_lift()
    with xarray.open_dataset(recording.save(tmp_path / "lift.nc")) as dataset:
        xarray.testing.assert_equal(recording.dataset, dataset)


def test_a_failed_save_leaves_the_old_file_and_nothing_else(tmp_path: Path) -> None:
    recording = short_lift()
    path = recording.save(tmp_path / "lift.nc")
    before = path.read_bytes()
    attributes = {**recording.attributes, "of_mine": {"step": float("nan")}}
    broken = Recording(recording.variables, recording.coordinates, attributes)
    with pytest.raises(ValueError, match="JSON"):
        broken.save(path)
    assert path.read_bytes() == before
    assert list(tmp_path.iterdir()) == [path]
    with pytest.raises(FileNotFoundError, match=r"No such file or directory: '.*/nowhere'$"):
        recording.save(tmp_path / "nowhere" / "lift.nc")
    with pytest.raises(FileNotFoundError, match=r"is a folder; the recording in it is .*lift\.nc$"):
        gantline.open_recording(tmp_path)


def test_a_folder_in_place_of_a_recording(tmp_path: Path) -> None:
    """A folder that `statics -o` wrote into too was answered with equilibrium.nc, by its letter."""
    for name in ("equilibrium.nc", "motion_1.nc"):
        (tmp_path / name).touch()
    said = r"is a folder; the recording in it is .*equilibrium\.nc, the first of 2$"
    with pytest.raises(FileNotFoundError, match=said):
        gantline.open_recording(tmp_path)
    (tmp_path / "recording.nc").touch()
    said = r"is a folder; of the 3 recordings in it that of the run is .*recording\.nc$"
    with pytest.raises(FileNotFoundError, match=said):
        gantline.open_recording(tmp_path)


def test_what_is_no_recording_is_refused(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match="no such file"):
        gantline.open_recording(tmp_path / "none.nc")
    with pytest.raises(FileNotFoundError, match="is a folder without a recording"):
        gantline.open_recording(tmp_path)
    text = tmp_path / "text.nc"
    text.write_text("not a recording")
    with pytest.raises(ValueError, match="not a recording of gantline"):
        gantline.open_recording(text)
    other = tmp_path / "other.nc"
    xarray.Dataset({"a": ("x", [1.0])}).to_netcdf(other, engine="h5netcdf")
    with pytest.raises(ValueError, match="not a recording of gantline"):
        gantline.open_recording(other)


def test_events_of_one_kind() -> None:
    assert ringing_lift().events("lift_off") == [(9.99, "lift_off", "block")]
    assert [event[2] for event in ringing_lift().events("step_begin")] == ["hoist", "hold"]


def test_the_rig_knows_which_equalizer_holds_a_sling() -> None:
    rig = ringing_lift().rig
    assert [sling.rope for sling in rig.slings] == SLINGS
    equalizer = rig.equalizer_of(rig.slings[0])
    assert equalizer is not None
    assert equalizer.name == "e1"
    assert rig.slings[0].from_body == "e1.1"
    assert rig.loads[0].lugs["L1"].capacity == 80e3 * 9.81


def test_directions_of_slings_are_worked_out_once_and_cannot_be_changed() -> None:
    recording = ringing_lift()
    sling = recording.rig.slings[0]
    direction = sling_direction(recording, sling)
    assert sling_direction(recording, sling) is direction
    with pytest.raises(ValueError, match="read-only"):
        direction[:] = 0.0
    assert not np.array_equal(direction, sling_direction(recording, recording.rig.slings[1]))


def test_what_was_lifted_is_read_without_samples(tmp_path: Path) -> None:
    recording = ringing_lift()
    path = recording.save(tmp_path / "lift.nc")
    assert load_rig(path) == recording.rig
    path.write_bytes(b"no recording")
    with pytest.raises(ValueError, match="it is no NetCDF4 file"):
        load_rig(path)


def test_tables_that_stay_open_change_no_byte(tmp_path: Path) -> None:
    """Against what h5netcdf writes into a file that it has opened itself, with no room held for it."""
    recording = short_lift()
    with h5netcdf.File(tmp_path / "plain.nc", "w") as file:
        _write(recording, file, lambda size: None)
    save_recording(recording, tmp_path / "kept.nc")
    assert (tmp_path / "kept.nc").read_bytes() == (tmp_path / "plain.nc").read_bytes()
