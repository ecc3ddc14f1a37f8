"""Models that were read before: kept, found again, and never when anything has changed or is damaged."""

from __future__ import annotations

from pathlib import Path

import pytest

from gantline.cad import CadModel, cache, read
from gantline.cad.ocx import reader
from ocx_files import SQUARE, Writer, sample

W = Writer()


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    return tmp_path / "cache" / "gantline" / "cad"


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "small.3docx"
    path.write_bytes(sample(W))
    return path


@pytest.fixture
def readings(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Files that have been read and not found in the cache."""
    found: list[str] = []
    true = reader.read_ocx

    def counted(data: bytes, name: str) -> CadModel:
        found.append(name)
        return true(data, name)

    monkeypatch.setattr(reader, "read_ocx", counted)
    return found


def test_a_model_comes_back_as_it_was(place: Path, file: Path, readings: list[str]) -> None:
    first, second = read(file), read(file)
    assert readings == ["small.3docx"] and len(list(place.iterdir())) == 1
    assert (first.name, first.form, first.unit, first.doubts) == (
        second.name,
        second.form,
        second.unit,
        second.doubts,
    )
    for one, other in zip(first.parts, second.parts, strict=True):
        assert (one.name, one.kind, one.material, one.size, one.group, one.doubts) == (
            other.name, other.kind, other.material, other.size, other.group, other.doubts,
        )  # fmt: skip
        assert one.properties is not None and other.properties is not None
        assert one.properties.mass == other.properties.mass
        assert one.properties.centre.tolist() == other.properties.centre.tolist()
        assert one.properties.inertia.tolist() == other.properties.inertia.tolist()
        assert one.mesh.vertices.tolist() == other.mesh.vertices.tolist()
        assert one.mesh.triangles.tolist() == other.mesh.triangles.tolist()
        assert (one.declared is None) == (other.declared is None)
        if one.declared is not None and other.declared is not None:
            assert one.declared.mass == other.declared.mass


def test_another_content_is_another_model(place: Path, file: Path, readings: list[str]) -> None:
    read(file)
    file.write_bytes(W.file(W.plate("P", W.polygon(SQUARE))))
    assert [part.name for part in read(file).parts] == ["P"]
    assert len(readings) == 2


def test_a_changed_reader_is_another_key(monkeypatch: pytest.MonkeyPatch) -> None:
    before = cache.digest(b"data")
    monkeypatch.setattr(cache, "_readers", lambda: b"other source")
    assert cache.digest(b"data") != before


@pytest.mark.parametrize("damage", ["empty", "cut", "flipped", "other text", "a folder"])
def test_a_damaged_cache_is_as_if_it_were_not_there(
    place: Path, file: Path, readings: list[str], damage: str
) -> None:
    mass = read(file).properties.mass
    (kept,) = place.iterdir()
    data = bytearray(kept.read_bytes())
    if damage == "empty":
        kept.write_bytes(b"")
    elif damage == "cut":
        kept.write_bytes(data[: len(data) // 2])
    elif damage == "flipped":
        for at in range(100, len(data), 97):
            data[at] ^= 0x55
        kept.write_bytes(data)
    elif damage == "other text":
        kept.write_bytes(b"no archive")
    else:
        kept.unlink()
        kept.mkdir()
    assert read(file).properties.mass == mass
    assert len(readings) == 2


def test_a_cache_that_cannot_be_written_is_done_without(
    tmp_path: Path, file: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "file").write_text("in the way")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "file"))
    assert len(read(file).parts) == 5


def test_nothing_is_kept_where_nothing_is_to_be(place: Path, file: Path) -> None:
    read(file, keep=False)
    assert not place.exists()


def test_old_models_make_room(place: Path, file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cache, "_MOST_FILES", 2)
    for side in (1.0, 2.0, 3.0, 4.0):
        corners = [(x * side, y * side, z) for x, y, z in SQUARE]
        file.write_bytes(W.file(W.plate("P", W.polygon(corners))))
        read(file)
    assert len(list(place.iterdir())) == 2


def test_a_relative_cache_folder_is_not_taken(monkeypatch: pytest.MonkeyPatch) -> None:
    """As the XDG base directory specification demands."""
    monkeypatch.setenv("XDG_CACHE_HOME", "somewhere")
    assert cache.folder() == Path.home() / ".cache" / "gantline" / "cad"
