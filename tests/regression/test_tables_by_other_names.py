"""`write_csv(recording, "lift.xlsx")` wrote CSV under the name of a workbook, which no spreadsheet opens,
though `Recording.save` refused such names. `save` and `write_report` hand out the path; `write_csv` and its
like did not. Pictures into a file in place of a folder ended with "No such file or directory: 'lift.csv'",
which is there.
"""

from __future__ import annotations

from pathlib import Path

import pytest

import gantline
from gantline.export import TableError, write_csv, write_parquet
from gantline.plot import save_pictures
from sample_lift import ringing_lift


@pytest.mark.parametrize("ending", ["xlsx", "ODS", "nc", "parquet"])
def test_a_table_is_no_workbook(tmp_path: Path, ending: str) -> None:
    with pytest.raises(
        TableError, match=rf"lift.{ending}: a table in CSV is lift.csv, which spreadsheets open"
    ):
        write_csv(ringing_lift(), tmp_path / f"lift.{ending}")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", ["lift.csv", "lift.txt", "lift", "lift.2026"])
def test_other_names_are_as_they_were(tmp_path: Path, name: str) -> None:
    assert write_csv(ringing_lift(), tmp_path / name) == tmp_path / name
    assert (tmp_path / name).read_text(encoding="utf-8").startswith("time [s],")


def test_a_table_in_parquet_is_where_it_says(tmp_path: Path) -> None:
    pytest.importorskip("pyarrow")
    assert write_parquet(ringing_lift(), tmp_path / "a.parquet").read_bytes().startswith(b"PAR1")


def test_a_file_is_no_folder(tmp_path: Path) -> None:
    path = gantline.simulate("pulleys", duration=0.1).save(tmp_path / "lift.nc")
    with pytest.raises(NotADirectoryError, match=r"lift\.nc"):
        save_pictures(ringing_lift(), path)
    with pytest.raises(FileNotFoundError, match="nowhere"):
        write_csv(ringing_lift(), tmp_path / "nowhere" / "lift.csv")
