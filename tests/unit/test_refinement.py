"""Figures of a finer run beside those of a run: what is told of them, where, and what is refused."""

from __future__ import annotations

import json
from dataclasses import asdict, replace
from pathlib import Path

import pytest
from typer.testing import CliRunner

import gantline
from gantline.cli.app import app
from gantline.cli.refinement import refinement_table
from gantline.results.file.netcdf import save_recording
from gantline.results.recording import Recording
from gantline.results.refinement import Apart, Figure, Refinement, in_per_cent, refinement_of
from gantline.study import refined
from sample_lift import ringing_lift

LARGEST = Figure("load_tilt", "module", 0.010, 0.011, 0.02, "deg", 2)
SMALLEST = Figure("clearance_margin", "a to b", 0.5, 0.4, 0.2, "m", 2, at_least=True)
FREE = Figure("sling_dynamic_factor", "S1", 1.2, 1.25, None, "", 3)
FOUND = Refinement(
    {"tension_tolerance": 5.0, "position_tolerance": 1e-5},
    [LARGEST, SMALLEST, FREE, FREE],
    [],
    1e-3,
    -2e-3,
    Apart("module", 0.0123, 7.26),
)


def test_what_is_used_of_a_limit_counts() -> None:
    assert LARGEST.moved == pytest.approx(0.001 / 0.02)
    assert SMALLEST.moved == pytest.approx(0.2 / 0.4 - 0.2 / 0.5)
    assert FREE.moved == pytest.approx(0.05 / 1.25)


def test_a_margin_that_is_used_up_moves_by_itself() -> None:
    assert replace(SMALLEST, finer=-0.1).moved == pytest.approx(0.6 / 0.5)
    assert replace(SMALLEST, limit=0.0).moved == pytest.approx(0.1 / 0.5)


def test_what_does_not_show_has_not_moved() -> None:
    assert replace(FREE, finer=1.2 + 4e-6).moved == 0.0
    assert replace(FREE, value=0.0, finer=1e-9).moved == 0.0


@pytest.mark.parametrize(
    ("share", "text"),
    [(0.0, "less than 0.001 %"), (1.234e-4, "0.012 %"), (0.0123, "1.2 %"), (0.996, "100 %"), (5.58, "558 %")],
)
def test_shares_have_the_digits_that_they_have(share: float, text: str) -> None:
    assert in_per_cent(share) == text


def test_the_table_tells_what_moved_most_first() -> None:
    assert refinement_table(FOUND) == [
        "Numerical error                     as run       finer  differs by",
        "  clearance_margin      a to b    0.5000 m    0.4000 m  10 % of its limit",
        "  load_tilt             module  0.5730 deg  0.6303 deg  5 % of its limit",
        "  sling_dynamic_factor  S1         1.20000     1.25000  4 %",
        "  with tolerances a tenth (5 N, 0.01 mm) 1 other figure differs by less",
        "  loads come clear 2.0 ms earlier",
        "  tensions of ropes differ by 0.1 % rms of their largest",
        "  places of bodies differ by up to 12.3 mm, that of module at 7.3 s",
    ]


def test_what_is_the_same_is_said_to_be() -> None:
    alike = replace(
        FOUND,
        figures=[replace(FREE, finer=FREE.value)],
        lift_off=4e-5,
        tension=None,
        apart=Apart("module", 4e-5, 1.0),
    )
    assert refinement_table(alike) == [
        "Numerical error",
        "  with tolerances a tenth (5 N, 0.01 mm) 1 figure is the same",
        "  loads come clear at the same time",
        "  places of bodies differ by less than 0.1 mm",
    ]


def test_a_recording_keeps_it(tmp_path: Path) -> None:
    whole = ringing_lift()
    attributes = {**whole.attributes, "refinement": asdict(FOUND)}
    file = Recording(whole.variables, whole.coordinates, attributes).save(tmp_path / "r.nc")
    assert refinement_of(gantline.open_recording(file)) == FOUND
    result = CliRunner().invoke(app, ["check", str(file), "--json"])
    assert json.loads(result.output)["refinement"] == asdict(FOUND)
    CliRunner().invoke(app, ["report", str(file)])
    page = (tmp_path / "report.html").read_text("utf-8")
    assert "with tolerances a tenth (5 N, 0.01 mm) 1 other figure differs by less" in page
    assert "the figures of the checks differ by up to 10 %, most clearance margin" in page


def test_one_of_another_form_is_refused(tmp_path: Path) -> None:
    whole = ringing_lift()
    odd = {**asdict(FOUND), "figures": [{**asdict(LARGEST), "finer": "large"}]}
    other = Recording(whole.variables, whole.coordinates, {**whole.attributes, "refinement": odd})
    file = save_recording(other, tmp_path / "odd.nc")
    with pytest.raises(ValueError, match=r"attribute refinement\.figures\[0\]\.finer is 'large'; expected a"):
        gantline.open_recording(file)


def test_a_run_that_was_stopped_shows_nothing() -> None:
    whole = ringing_lift()
    stopped = Recording(whole.variables, whole.coordinates, {**whole.attributes, "status": "stopped"})
    with pytest.raises(ValueError, match="its status is 'stopped'"):
        refined(whole, stopped)


def test_run_tells_it(tmp_path: Path) -> None:
    result = CliRunner().invoke(
        app, ["run", "equalizer", "--duration", "2 s", "--refine", "-o", str(tmp_path), "--no-plots"]
    )
    assert "simulating once more with a finer method" in result.stderr
    assert "Numerical error" in result.stdout and "with tolerances a tenth (5.26 N, 0.01 mm)" in result.stdout
    found = refinement_of(gantline.open_recording(tmp_path / "recording.nc"))
    assert found is not None and found.figures
