"""What a researcher hands in on the first day, and how it ended.

`recording.save("lift.csv")` wrote NetCDF under the name of a table, which no spreadsheet opens. `compare` of
one name ended with "not enough values to unpack (expected 2, got 1)", and took the text "ab" for the names
"a" and "b". `verdict_of(recording)` ended with "'str' object has no attribute 'verdict'", `Report(None)` and
`open_recording(None)` in words of Python. `equilibrium(time="12 s")` said that '12 s' is no time of a lift of
40 s.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import gantline
from gantline.checks import check_recording, outcome_of, verdict_of
from gantline.results import Recording


@pytest.fixture(scope="module")
def recording() -> Recording:
    return gantline.simulate("pulleys", duration=0.1)


@pytest.mark.parametrize("ending", ["csv", "XLSX", "parquet", "json"])
def test_a_recording_is_no_table(recording: Recording, tmp_path: Path, ending: str) -> None:
    told = rf"lift.{ending}: a recording is a NetCDF4 file, lift.nc; gantline.export.write_csv and "
    with pytest.raises(ValueError, match=told):
        recording.save(tmp_path / f"lift.{ending}")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", ["lift.nc", "lift", "lift.nc4", "lift.2026"])
def test_other_names_are_as_they_were(recording: Recording, tmp_path: Path, name: str) -> None:
    path = recording.save(tmp_path / name)
    assert gantline.open_recording(path).metrics() == recording.metrics()


@pytest.mark.parametrize("names", [("a",), "ab", ("a", "b", "c"), ("a", 2)])
def test_a_comparison_has_two_names(recording: Recording, names: Any) -> None:
    with pytest.raises(TypeError, match=r"are not two texts, such as \('before', 'after'\)"):
        gantline.compare(recording, recording, names=names)
    assert gantline.compare(recording, recording, names=("a", "b")).names == ("a", "b")


@pytest.mark.parametrize("take", [outcome_of, verdict_of])
def test_verdicts_are_of_checks(recording: Recording, take: Any) -> None:
    told = "a list of checks is needed, not Recording; gantline.checks.check_recording gives those"
    with pytest.raises(TypeError, match=told):
        take(recording)
    assert take(check_recording(recording))


def test_nothing_is_no_recording() -> None:
    with pytest.raises(TypeError, match="a recording is needed, not NoneType"):
        gantline.Report(None)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="the file of a recording is needed, not NoneType"):
        gantline.open_recording(None)  # type: ignore[arg-type]


def test_a_time_is_a_number() -> None:
    told = "time: '12 s' is no number of seconds; the lift lasts from 0 s to 40 s"
    with pytest.raises(ValueError, match=told):
        gantline.Statics("equalizer").equilibrium(time="12 s")  # type: ignore[arg-type]
