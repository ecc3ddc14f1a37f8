"""Files that are no text, no GLB and no HDF5, told in words of the libraries that failed on them.

A spreadsheet given as a lift file was asked to be saved as UTF-8, since "it looks like Windows-1252, 'â'
in 'PK????????â?{]«ß?0È???È'", and a PDF alike. Of what is no GLB it was said that "'utf-8' codec can't
decode byte 0x90 in position 0: invalid start byte", of what is no HDF5 "Unable to synchronously open
file (file signature not found)".
"""

from __future__ import annotations

from pathlib import Path

import pytest

from gantline.cad import CadError, read
from gantline.hydro import DatabaseError, read_database
from gantline.scenario import ScenarioError, load_scenario

NOISE = bytes(range(128, 256)) + bytes(range(16))


@pytest.mark.parametrize(
    ("content", "says"),
    [
        (b"PK\x03\x04\x14\x00" + NOISE, "is no lift file but a zip file, as spreadsheets and documents are"),
        (b"%PDF-1.4\n%\xe2\xe3\xcf\xd3\n", "is no lift file but a PDF"),
        (b"\xd0\xcf\x11\xe0" + NOISE, "is no lift file but an older spreadsheet or document"),
        (NOISE, "is no text but a binary file"),
    ],
)
def test_a_lift_file_that_is_no_text(content: bytes, says: str, tmp_path: Path) -> None:
    file = tmp_path / "lift.yaml"
    file.write_bytes(content)
    with pytest.raises(ScenarioError) as found:
        load_scenario(file)
    assert str(found.value) == f"{file}: {says}; a lift file is plain text"


def test_a_glb_file_that_is_none(tmp_path: Path) -> None:
    file = tmp_path / "load.glb"
    file.write_bytes(NOISE)
    with pytest.raises(CadError) as found:
        read(file)
    assert str(found.value) == f"{file}: it is no GLB file: 'glTF' does not stand at its beginning"


def test_a_glb_file_whose_document_is_no_text(tmp_path: Path) -> None:
    """Twelve bytes of the file, length and kind of its first chunk, and then what is no UTF-8."""
    file = tmp_path / "load.glb"
    file.write_bytes(b"glTF" + bytes(8) + len(NOISE).to_bytes(4, "little") + b"JSON" + NOISE)
    with pytest.raises(CadError) as found:
        read(file)
    assert str(found.value) == f"{file}: it is no GLB file, or a broken one: its JSON is not UTF-8 text"


@pytest.mark.parametrize("ending", ["nc", "h5"])
def test_a_database_that_is_no_hdf5(ending: str, tmp_path: Path) -> None:
    file = tmp_path / f"barge.{ending}"
    file.write_bytes(NOISE)
    with pytest.raises(DatabaseError) as found:
        read_database(file)
    broken = "it is no hydrodynamic database, or a broken one: it does not begin as HDF5 does"
    assert str(found.value) == f"{file}: {broken}"
