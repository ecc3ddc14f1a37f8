"""Recordings that are damaged or that another program has changed: refused when read, in one line."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pytest
import xarray
from typer.testing import CliRunner

import gantline
from gantline.cli.app import app
from gantline.results.file.form import FormError
from gantline.results.file.gaps import gaps
from gantline.results.file.layout import DIMS
from gantline.results.file.netcdf import save_recording
from gantline.results.file.validity import hold_recording
from gantline.results.recording import Recording
from gantline.results.variable import Variable
from sample_lift import ringing_lift, sample_recording

ADVICE = ". The recording is damaged, or another program has changed it: run the lift again"
#: Variables that the sample lift has and that nothing needs.
UNNEEDED = ("residual_constraint", "residual_complementarity", "momentum", "angular_momentum")


@cache
def sample() -> Recording:
    return sample_recording(
        np.linspace(0.0, 10.0, 5),
        tension=np.linspace(0.0, 600e3, 5)[:, None] + np.zeros((5, 5)),
        contact=np.linspace(700e3, 0.0, 5)[:, None] + np.zeros((5, 4)),
        events=[(0.0, "step_begin", "hoist"), (9.0, "lift_off", "block")],
    )


NAMES = list(sample().variables)
COORDINATES = list(sample().coordinates)


def _changed(path: Path, *parts: Any) -> Path:
    """A file as another program leaves it: `Recording.save` writes none that could not be read again."""
    return save_recording(Recording(*parts), path)


def refusal(folder: Path, variables: Mapping[str, Variable] | None = None, **changed: Any) -> str:
    """What is said of the sample lift with other variables, names or attributes, without file and advice."""
    whole = sample()
    file = _changed(
        folder / "changed.nc",
        whole.variables if variables is None else variables,
        changed.get("coordinates", whole.coordinates),
        changed.get("attributes", whole.attributes),
    )
    with pytest.raises(ValueError) as problem:
        gantline.open_recording(file)
    said = str(problem.value)
    assert said.startswith(f"{file}: ") and said.endswith(ADVICE) and "\n" not in said
    return said.removeprefix(f"{file}: ").removesuffix(ADVICE)


def other(name: str, dims: tuple[str, ...] | None = None, values: Any = None) -> dict[str, Variable]:
    """A variable of the sample lift with other dimensions or values, alone."""
    one = sample()[name]
    return {
        name: Variable(dims or one.dims, one.values if values is None else values, one.unit, one.description)
    }


def changed(name: str, values: Any) -> dict[str, Variable]:
    """All variables of the sample lift, one of them with other values."""
    return {**sample().variables, **other(name, values=values)}


def test_the_sample_itself_is_read(tmp_path: Path) -> None:
    found = gantline.open_recording(sample().save(tmp_path / "whole.nc"))
    assert found.variables.keys() == sample().variables.keys()


@pytest.mark.parametrize("name", NAMES)
def test_a_variable_that_is_missing_is_named(tmp_path: Path, name: str) -> None:
    """Also where another name stands in its place."""
    others = {one: variable for one, variable in sample().variables.items() if one != name}
    others[f"{name}_old"] = sample()[name]
    if name in UNNEEDED:
        gantline.open_recording(
            Recording(others, sample().coordinates, sample().attributes).save(tmp_path / "r.nc")
        )
        return
    assert refusal(tmp_path, others) == f"variable '{name}' is missing"
    # As it is found once a file has been read, which takes most of the time.
    del others[f"{name}_old"]
    with pytest.raises(FormError, match=f"^variable '{name}' is missing$"):
        hold_recording(Recording(others, sample().coordinates, sample().attributes))


@pytest.mark.parametrize("name", NAMES)
def test_a_variable_of_another_type_is_named(tmp_path: Path, name: str) -> None:
    """Refused as it is read, whatever else a file has: here nothing."""
    one = sample()[name]
    if one.is_text:
        said = refusal(tmp_path, other(name, values=np.zeros(one.values.shape)))
        assert said == f"variable '{name}' has values of type float64; expected text"
    else:
        said = refusal(tmp_path, other(name, values=np.full(one.values.shape, "7 kN")))
        assert said == f"variable '{name}' has text; expected floating-point numbers"


@pytest.mark.parametrize("name", NAMES)
def test_a_variable_with_other_dimensions_is_named(tmp_path: Path, name: str) -> None:
    """Refused as it is read, whatever else a file has: here nothing."""
    dims = sample()[name].dims
    wrong = tuple(f"other_{dim}" for dim in dims)
    said = refusal(tmp_path, other(name, dims=wrong))
    assert said == f"variable '{name}' has the dimensions ({', '.join(wrong)}); expected ({', '.join(dims)})"


def test_the_layout_is_that_of_the_page_on_recordings() -> None:
    """Commands of a program are held by nothing; `rope_of_point` has no row of its own."""
    page = (Path(__file__).parents[2] / "docs/reference/recording.md").read_text(encoding="utf-8")
    table = page.split("## Variables")[1].split("## Attributes")[0]
    rows = [row.split("|")[1:3] for row in table.splitlines() if row.startswith("| `")]
    every = [(name, dims) for names, dims in rows for name in re.findall(r"`(\w+)`", names)]
    told = {name: tuple(re.findall(r"\w+", dims)) for name, dims in every}
    assert {name: dims for name, dims in told.items() if not name.startswith("command_")} == {
        name: dims for name, dims in DIMS.items() if name != "rope_of_point"
    }


def test_integers_are_no_forces(tmp_path: Path) -> None:
    """Whole numbers are what packing by scale and offset leaves, and mean something else then."""
    file = sample().save(tmp_path / "packed.nc")
    with h5py.File(file, "r+") as opened:
        tension = opened["rope_tension"]
        scales = [dim[0] for dim in tension.dims]
        del opened["rope_tension"]
        packed = opened.create_dataset("rope_tension", data=np.ones((5, 6), dtype="<i2"))
        packed.attrs["units"], packed.attrs["long_name"] = "N", "tension"
        for axis, scale in enumerate(scales):
            packed.dims[axis].attach_scale(scale)
    with pytest.raises(ValueError, match="'rope_tension' has values of type int16; expected floating-point"):
        gantline.open_recording(file)


def test_a_variable_without_its_unit_is_named(tmp_path: Path) -> None:
    file = sample().save(tmp_path / "bare.nc")
    with h5py.File(file, "r+") as opened:
        del opened["rope_tension"].attrs["units"]
    with pytest.raises(ValueError, match="variable 'rope_tension' has no attribute 'units'"):
        gantline.open_recording(file)


@pytest.mark.parametrize("dim", COORDINATES)
def test_names_that_are_missing_are_told(tmp_path: Path, dim: str) -> None:
    left = {other: labels for other, labels in sample().coordinates.items() if other != dim}
    assert refusal(tmp_path, coordinates=left) == f"the names '{dim}' are missing"


@pytest.mark.parametrize("dim", [dim for dim in COORDINATES if dim not in ("segment", "joint")])
def test_names_that_the_rig_counts_on_are_told(tmp_path: Path, dim: str) -> None:
    """Segments and joints are named by rigs with reeved hooks and trolleys alone."""
    labels = sample().coordinates[dim]
    other = {**sample().coordinates, dim: [f"{label}'" for label in labels]}
    said = refusal(tmp_path, coordinates=other)
    assert said.startswith(f"the names '{dim}' ") and any(label in said for label in labels)


def test_times_rise(tmp_path: Path) -> None:
    words = "variable 'time' has values that do not rise; expected the times of the samples"
    assert refusal(tmp_path, changed("time", values=sample().time[::-1])) == words
    assert refusal(tmp_path, changed("time", values=np.full(5, np.nan))) == words


ODD: tuple[Any, ...] = ([], {}, "x", 5, None, True, float("nan"))


UNREADABLE = "is nested too deeply, or has text that is no Unicode"


def nested(depth: int) -> Any:
    return json.loads("[" * depth + "]" * depth)


def places(document: Any, place: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """Every key of JSON, of lists the first entry."""
    entries = document.items() if isinstance(document, dict) else enumerate(document[:1])
    for key, one in entries:
        yield (*place, key)
        if isinstance(one, dict | list):
            yield from places(one, (*place, key))


def replaced(document: Any, place: tuple[Any, ...], value: Any) -> Any:
    copy = json.loads(json.dumps(document))
    at = copy
    for key in place[:-1]:
        at = at[key]
    at[place[-1]] = value
    return copy


def test_attributes_are_of_the_right_form_or_do_no_harm() -> None:
    """Whatever stands in the place of any part of an attribute: a refusal that names it, or no trouble."""
    given = {
        name: one
        for name, one in json.loads(json.dumps(dict(sample().attributes))).items()
        if name not in ("title", "gantline_version", "scenario", "status")  # text in every file
    }
    refused = 0
    for place in places(given):
        for value in ODD:
            attributes = {**replaced(given, place, value), "status": "done"}
            recording = Recording(sample().variables, sample().coordinates, attributes)
            try:
                hold_recording(recording)
            except FormError as problem:
                refused += 1
                said = str(problem)
                assert said.startswith("attribute ") or " of the rig" in said, (place, said)
            else:
                recording.metrics()
    assert refused > 600


@pytest.mark.parametrize(
    ("place", "value", "said"),
    [
        (("rig",), [], "attribute rig is a list; expected an object"),
        (("scene",), [], "attribute scene is a list; expected an object"),
        (("settings",), {}, "attribute settings has no 'integrator'"),
        (("settings", "integrator", "type"), "euler", "attribute settings.integrator.type is 'euler'; "
         "expected one of del, adaptive, explicit"),
        (("warnings",), {}, "attribute warnings is an object; expected a list"),
        (("counters",), [], "attribute counters is a list; expected an object"),
        (("rig", "slings", 0, "length"), "9 m", "attribute rig.slings[0].length is '9 m'; expected a number"),
        (("rig", "slings", 0), {}, "attribute rig.slings[0] has no 'name'"),
        (("rig", "slings", 0, "from"), [], "attribute rig.slings[0].from is a list; expected text"),
        (("rig", "slings", 0, "rope"), "sling.X", "the names 'rope' lack 'sling.X' of the rig"),
        (("rig", "limits", "load_tilt"), "2", "attribute rig.limits.load_tilt is '2'; expected a number"),
        (("rig", "loads", 0, "lugs", "L1", "at"), [1.0], "attribute rig.loads[0].lugs.L1.at has 1 entries; "
         "expected 3"),
        (("scene", "bodies", 1, "shape", "size"), 3, "attribute scene.bodies[1].shape.size is 3; "
         "expected a list"),
        (("scene", "sheaves", 0, "radius"), True, "attribute scene.sheaves[0].radius is true; "
         "expected a number"),
        (("rig", "gravity"), 10**400, "attribute rig.gravity is 1" + 39 * "0" + "...; expected a number"),
        (("rig", "limits", "odd"), nested(210), f"attribute rig {UNREADABLE}"),
        (("rig", "limits", "odd"), nested(400), f"attribute rig {UNREADABLE}"),
        (("rig", "loads", 0, "name"), "\ud800", f"attribute rig {UNREADABLE}"),
    ],
)  # fmt: skip
def test_attributes_of_another_form_are_told_with_their_place(
    tmp_path: Path, place: tuple[Any, ...], value: Any, said: str
) -> None:
    given = json.loads(json.dumps(dict(sample().attributes)))
    assert refusal(tmp_path, attributes=replaced(given, place, value)) == said


@pytest.mark.parametrize("name", ["rig", "settings", "status"])
def test_an_attribute_that_is_missing_is_named(tmp_path: Path, name: str) -> None:
    left = {other: one for other, one in sample().attributes.items() if other != name}
    assert refusal(tmp_path, attributes=left) == f"attribute '{name}' is missing"


def test_what_other_programs_add_does_no_harm(tmp_path: Path) -> None:
    """NCO and others leave a line of history, which is no JSON."""
    file = sample().save(tmp_path / "more.nc")
    with h5py.File(file, "r+") as opened:
        opened.attrs["history"] = "Mon: ncks -A more.nc"
    recording = gantline.open_recording(file)
    assert recording.attributes["history"] == "Mon: ncks -A more.nc"
    again = gantline.open_recording(recording.save(tmp_path / "again.nc"))
    assert again.attributes["history"] == "Mon: ncks -A more.nc"


def test_what_xarray_has_saved_again_is_the_same(tmp_path: Path) -> None:
    """Its files have other attributes, and a list of coordinates beside the scales."""
    whole = sample()
    with xarray.open_dataset(whole.save(tmp_path / "whole.nc"), decode_times=False) as dataset:
        dataset.to_netcdf(tmp_path / "again.nc", engine="h5netcdf")
    again = gantline.open_recording(tmp_path / "again.nc")
    assert again.attributes == whole.attributes and again.coordinates == whole.coordinates
    assert set(again.variables) == set(whole.variables)
    assert all(again[name].dims == whole[name].dims for name in NAMES)
    assert all(np.array_equal(again[name].values, whole[name].values) for name in NAMES)


@pytest.mark.parametrize(
    "words",
    [
        ("check", "{}"),
        ("report", "{}"),
        ("view", "{}", "--no-browser"),
        ("export", "{}", "{}.csv"),
        ("compare", "{}", "{}", "--no-plots", "-o", "{}.out"),
    ],
    ids=lambda words: words[0],
)
def test_every_verb_says_it_in_one_line(tmp_path: Path, words: tuple[str, ...]) -> None:
    others = {name: one for name, one in sample().variables.items() if name != "rope_tension"}
    file = _changed(tmp_path / "bad.nc", others, sample().coordinates, sample().attributes)
    result = CliRunner().invoke(app, [word.format(file) for word in words])
    assert result.exit_code == 2
    assert result.output == f"error: {file}: variable 'rope_tension' is missing{ADVICE}\n"


def with_a_gap() -> Recording:
    whole = ringing_lift()
    tension = whole["rope_tension"].values.copy()
    tension[1000:1003, 2] = np.nan
    holed = Variable(("time", "rope"), tension, "N", "tension")
    return Recording({**whole.variables, "rope_tension": holed}, whole.coordinates, whole.attributes)


def test_what_is_no_number_is_told_with_element_and_time() -> None:
    assert gaps(ringing_lift()) == []
    assert gaps(with_a_gap()) == [
        "rope_tension of sling.S2 is no number at 3 samples, first at 20.00 s: "
        "what follows from it is not known"
    ]


def test_large_numbers_are_no_gap() -> None:
    whole = sample()
    large = Variable(("time", "rope"), np.full((5, 6), 1e308), "N", "tension")
    assert gaps(Recording({**whole.variables, "rope_tension": large}, whole.coordinates, {})) == []


@pytest.mark.parametrize(
    "words",
    [
        ("check", "{}"),
        ("check", "{}", "--json"),
        ("report", "{}"),
        ("export", "{}", "{}.csv"),
        ("compare", "{}", "{}", "--no-plots", "-o", "{}.out"),
    ],
    ids=lambda words: " ".join(words[::2]).replace("{}", ""),
)
def test_every_verb_tells_of_what_is_no_number(tmp_path: Path, words: tuple[str, ...]) -> None:
    file = with_a_gap().save(tmp_path / "holed.nc")
    result = CliRunner().invoke(app, [word.format(file) for word in words])
    assert result.exit_code in (0, 1), result.output
    assert "rope_tension of sling.S2 is no number at 3 samples, first at 20.00 s" in result.stderr
    if words[0] == "report":
        assert "rope_tension of sling.S2 is no number" in (tmp_path / "report.html").read_text("utf-8")
    if words[0] == "compare":
        numbers = json.loads((tmp_path / "holed.nc.out" / "comparison.json").read_text("utf-8"))
        ropes = {one["name"]: one for one in numbers["ropes"]}
        assert ropes["sling.S2"]["deviation"]["rms"] is None
        assert ropes["sling.S1"]["deviation"]["rms"] == 0.0


@pytest.mark.parametrize("name", ["rope_peak_tension", "rope_peak_time", "event_time"])
def test_a_peak_or_an_event_that_is_no_number_is_named(tmp_path: Path, name: str) -> None:
    """No sample stands for it, so that nothing could be told in its place."""
    values = sample()[name].values.copy()
    values[0] = np.inf
    said = refusal(tmp_path, changed(name, values=values))
    assert said == f"variable '{name}' has a value that is no number"


def test_an_infinite_value_is_a_gap(tmp_path: Path) -> None:
    tension = sample()["rope_tension"].values.copy()
    tension[2, 1], tension[3, 1] = np.inf, -np.inf
    others = changed("rope_tension", values=tension)
    file = Recording(others, sample().coordinates, sample().attributes).save(tmp_path / "endless.nc")
    read = gantline.open_recording(file)["rope_tension"].values
    assert np.isnan(read[2:4, 1]).all() and np.isfinite(np.delete(read, 1, axis=1)).all()


def test_a_report_without_places_says_whose_are_missing(tmp_path: Path) -> None:
    whole = ringing_lift()
    places = whole["body_position"].values.copy()
    places[7, 1] = np.nan
    one = Variable(whole["body_position"].dims, places, "m", "position")
    file = Recording({**whole.variables, "body_position": one}, whole.coordinates, whole.attributes).save(
        tmp_path / "nowhere.nc"
    )
    result = CliRunner().invoke(app, ["report", str(file)])
    assert result.exit_code == 2 and not (tmp_path / "report.html").exists()
    of = f"body_position of {whole.coordinates['body'][1]} is no number at 1 sample"
    assert of in result.output and result.output.endswith("; the lift cannot be drawn\n")
