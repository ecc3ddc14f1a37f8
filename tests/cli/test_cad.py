"""`gantline cad`: what it prints, writes and says of files that are not right."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from matplotlib.image import imread
from typer.testing import CliRunner, Result

from gantline.cli.app import app
from ocx_files import SQUARE, Writer, sample

W = Writer()


@pytest.fixture(autouse=True)
def own_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "small.3docx"
    path.write_bytes(sample(W))
    return path


def run(*words: str | Path) -> Result:
    return CliRunner().invoke(app, ["cad", *(str(word) for word in words)])


def test_the_table_tells_masses_part_by_part(file: Path) -> None:
    result = run(file, "--no-plots", "--parts")
    assert result.exit_code == 0, result.output
    lines = result.stdout.splitlines()
    assert lines[:2] == ["small", "OCX 3.1.0, by hand; 5 parts; lengths in m, as the file says"]
    table = {line.split("  ")[1].strip(): line for line in lines if line.startswith("  ")}
    # 2 x 2 m less a disc of 0.72 m, 10 mm: 314 - 31.96 kg; declared 282.4 kg.
    words = {name: " ".join(line.split()) for name, line in table.items()}
    assert "282.0 kg 282.4 kg -0.13 % P1" in words["plate"]
    assert "31.4 kg 31.4 kg +0.00 % S1" in words["stiffener"]
    assert "36.0 kg - - -" in words["edge reinforcement"]
    assert "Mass                         0.394 t" in lines
    assert any(line.startswith("Centre of gravity") for line in lines)
    assert any(
        line.startswith("Box size") and "2.0000 m        2.0000 m        3.1000 m" in line for line in lines
    )
    assert any(line.startswith("  C1") and "pillar" in line and "tube" in line for line in lines)
    assert "No doubts." in lines


def test_the_inertia_is_that_of_the_model(file: Path) -> None:
    document = json.loads(run(file, "--no-plots", "--json").stdout)
    rows = [
        line[22:].split()
        for line in run(file, "--no-plots").stdout.splitlines()
        if line[20:22] in ("x ", "y ", "z ")
    ]
    assert np.array(rows, dtype=float) == pytest.approx(np.array(document["inertia"]) / 1000, abs=6e-4)


def test_json_has_everything_in_si(file: Path) -> None:
    result = run(file, "--no-plots", "--json")
    assert result.exit_code == 0
    document = json.loads(result.stdout)
    assert document["mass"] == pytest.approx(sum(part["mass"] for part in document["parts"]))
    assert document["declared_mass"] == pytest.approx(282.4 + 9.8 + 31.4)
    assert document["kinds"]["plate"] == {
        "parts": 1,
        "computed_mass": pytest.approx(282.04, abs=0.01),
        "declared_mass": 282.4,
    }
    assert document["worst_part"] == "P1" and document["doubts"] == []
    assert [part["kind"] for part in document["parts"]][-1] == "pillar"


def test_a_picture_is_drawn(file: Path, tmp_path: Path) -> None:
    result = run(file, "-o", tmp_path / "out")
    assert result.exit_code == 0
    assert f"Picture     {tmp_path / 'out' / 'model.png'}" in result.stdout.splitlines()
    image = imread(tmp_path / "out" / "model.png")
    assert image.shape[0] > 1000 and float((image[..., :3].min(axis=2) < 0.9).mean()) > 0.05


@pytest.mark.usefixtures("blank_pictures")
def test_json_stays_alone_on_standard_output(file: Path, tmp_path: Path) -> None:
    result = run(file, "-o", tmp_path / "out", "--json")
    json.loads(result.stdout)
    assert "Picture" in result.stderr


def test_doubts_are_told_with_the_parts_that_have_them(tmp_path: Path) -> None:
    plates = "".join(
        W.plate(f"P{number}", "".join(W.line(SQUARE[a], SQUARE[a + 1]) for a in range(3)), declared=400.0)
        for number in range(5)
    )
    bar = W.bar("S", W.line((0.0, 0.0, 0.0), (2.0, 0.0, 0.0)), "nowhere", declared=31.4)
    path = tmp_path / "doubtful.3docx"
    path.write_bytes(W.file(plates + bar))
    result = run(path, "--no-plots")
    said = " ".join(result.stdout.split("Doubts")[1].split())
    assert "Without weight: S." in said
    assert "differ by more than 1%: P0, P1, P2 and 2 more." in said
    assert "P0, P1, P2 and 2 more: its contour is open by 2 m, closed by a straight line." in said
    assert "S: its geometry is not read, nor does it declare a weight and its place" in said


@pytest.mark.parametrize(
    ("name", "data", "says"),
    [
        ("none.3docx", None, "cannot be read"),
        ("empty.3docx", b"", "empty"),
        ("broken.3docx", b"<ocx", "ends in the middle"),
        ("other.txt", b"hello", "is no CAD file that can be read"),
        ("other.xml", b"<html/>", "is no OCX: its first element is 'html'"),
    ],
)
def test_what_is_wrong_is_one_message(tmp_path: Path, name: str, data: bytes | None, says: str) -> None:
    path = tmp_path / name
    if data is not None:
        path.write_bytes(data)
    result = run(path)
    assert result.exit_code == 2 and result.stdout == ""
    assert result.stderr.startswith("error: ") and len(result.stderr.splitlines()) == 1
    assert says in result.stderr and name in result.stderr
