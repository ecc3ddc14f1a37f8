"""Wrong things handed to functions of `docs/reference/python.md`, which ended in Python's own words.

`recording.save(None)`, `write_report`, `write_csv`, pictures and databases ended with "expected str, bytes or
os.PathLike object, not NoneType", `recording[["rope_tension", "hook_load"]]`, `now` and `command` with
"unhashable type: 'list'", `sensitivities(3)`, `box_hull(100.0)` and `outcome_of(None)` with "'float' object
is not iterable", hulls and comparisons that were none with "object has no attribute 'closure'", and
`rope_class("6x36IWRC")` and `quantity("3 m", "lenght")` with that name alone.

`righting_arms` took degrees for radians: at a heel of 30, in place of 0.5236, an upright barge had the arm of
4.8 turns.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import gantline
from gantline import checks, export, hydro, plot
from gantline.results import Recording
from gantline.rope_data import rope_class
from gantline.units import quantity

BOX = hydro.box_hull([100.0, 30.0, 8.0])
MASS, CENTRE = 1e7, [50.0, 0.0, 1.0]


@pytest.fixture(scope="module")
def run() -> gantline.Simulation:
    return gantline.Simulation("pulleys", duration=0.1)


@pytest.fixture(scope="module")
def recording(run: gantline.Simulation) -> Recording:
    return run.run()


WRITERS: dict[str, Callable[[Recording, Any], object]] = {
    "save": lambda recording, path: recording.save(path),
    "report": gantline.write_report,
    "csv": export.write_csv,
    "parquet": export.write_parquet,
    "pictures": plot.save_pictures,
}


@pytest.mark.parametrize("write", WRITERS.values(), ids=list(WRITERS))
@pytest.mark.parametrize("path", [None, 3, ["lift"]])
def test_what_is_no_path_is_named(recording: Recording, write: Callable[..., object], path: Any) -> None:
    kind = type(path).__name__
    with pytest.raises(TypeError, match=rf"is needed, not {kind}; a text such as 'lift', or a Path"):
        write(recording, path)


@pytest.mark.parametrize("read", [hydro.read_hull, hydro.read_database])
def test_files_to_read(read: Callable[[Any], object]) -> None:
    with pytest.raises(TypeError, match=r"the file of a (hull|database) is needed, not NoneType"):
        read(None)


def test_one_name_at_a_time(run: gantline.Simulation, recording: Recording) -> None:
    several: Any = ["rope_tension", "body_position"]
    with pytest.raises(TypeError, match="the name of one variable is needed, not list; 'dataset' of a rec"):
        recording[several]
    assert list(recording.dataset[several]) == several
    with pytest.raises(TypeError, match="the name of a variable is needed, not list"):
        run.now(several)
    for ask in (run.drive_state, lambda names: run.command(names, speed=0.1)):
        with pytest.raises(gantline.CommandError, match=r"\['rope_tension', .* is nothing in this lift"):
            ask(several)


WRONG: dict[str, tuple[Callable[[], object], str]] = {
    "parameters": (lambda: gantline.Statics("equalizer").sensitivities(_any(3)), "a list of parameters"),
    "sides": (lambda: hydro.box_hull(_any(100.0)), "box: a list of its sides"),
    "checks": (lambda: checks.outcome_of(_any(None)), "a list of checks"),
    "comparison": (lambda: plot.save_comparison_pictures(_any("a"), "."), "a comparison"),
    "refined": (lambda: gantline.results.refinement.refinement_of(_any({})), "a recording"),
    "hull": (lambda: hydro.float_free(_any("box"), MASS, CENTRE), "a hull"),
    "hull of arms": (lambda: hydro.righting_arms(_any("box"), MASS, CENTRE, [0.1]), "a hull"),
    "hull of an attitude": (lambda: hydro.hydrostatics(_any(3), hydro.Attitude(4.0)), "a hull"),
    "start": (lambda: hydro.float_free(BOX, MASS, CENTRE, start=_any(4.0)), "an attitude"),
    "database": (lambda: hydro.fit_memory(_any(None), 1025.0), "a hydrodynamic database"),
    "written": (lambda: hydro.write_database(_any({}), "a.nc"), "a hydrodynamic database"),
    "tanks": (lambda: hydro.free_surface_correction(_any(3), MASS), "a list of tanks"),
    "tank": (lambda: hydro.free_surface_correction(_any([3]), MASS), "a tank"),
}


def _any(value: object) -> Any:
    return value


@pytest.mark.parametrize(("ask", "needed"), WRONG.values(), ids=list(WRONG))
def test_what_is_needed_is_said(ask: Callable[[], object], needed: str, tmp_path: Path) -> None:
    with pytest.raises(TypeError, match=f"{needed} is needed, not "):
        ask()


def test_points_that_are_none() -> None:
    with pytest.raises(ValueError, match="centre_of_gravity: '1 m' is no point"):
        hydro.float_free(BOX, MASS, "1 m")


def test_a_class_of_ropes_that_is_none() -> None:
    with pytest.raises(KeyError, match=r"no class of ropes is '6x36IWRC'; there are .*6x36 IWRC"):
        rope_class("6x36IWRC")


def test_quantities_of_no_dimension_and_without_a_unit() -> None:
    with pytest.raises(KeyError, match="no dimension is 'lenght'; there are length, mass, "):
        quantity("3 m", "lenght")
    with pytest.raises(TypeError, match="a text is needed, not float; a length is written like '23 m'"):
        quantity(_any(3.0), "length")


def test_angles_of_heel_are_in_radians() -> None:
    said = "heel: 30 rad is more than half a turn; angles are in radians, 30 degrees are 0.5236"
    with pytest.raises(ValueError, match=said):
        hydro.righting_arms(BOX, MASS, CENTRE, [0.0, 10.0 * np.pi / 180, 30.0])
    with pytest.raises(TypeError, match="heel: '10 deg' is no number of radians"):
        hydro.righting_arms(BOX, MASS, CENTRE, _any("10 deg"))
    assert hydro.righting_arms(BOX, MASS, CENTRE, np.radians([-180.0, 0.0, 180.0])).heel.shape == (3,)
