"""`gantline seas`, as people use it."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from column_in_waves import ALIKE, SEA, column
from gantline.results.file.saved_seas import SavedSeas
from gantline.study import Gumbel
from verbs import gantline

OVER = ("--height", "0.1 m, 2 m, 3 m, 9 m", "--period", "6 s")


@pytest.fixture
def lift(tmp_path: Path) -> Path:
    """Some 780 kN hang from its sling in still water."""
    path = tmp_path / "lift.yaml"
    path.write_text(column(ALIKE, duration="20 s", least="770 kN"), encoding="utf-8")
    return path


def sea_of(lift: Path) -> None:
    lift.write_text(column(SEA, duration="20 s"), encoding="utf-8")


def test_the_table(lift: Path) -> None:
    result = gantline("seas", str(lift), *OVER, "--direction", "0 deg, 22.5 deg")
    assert result.exit_code == 1, result.stderr
    lines = result.stdout.splitlines()
    assert max(map(len, lines)) <= 80
    assert re.search(r"^Towards 0 deg +6 s$", result.stdout, re.MULTILINE)
    assert re.search(r"^Towards 22\.5 deg +6 s$", result.stdout, re.MULTILINE)
    assert re.search(r"^  9 m +too steep$", result.stdout, re.MULTILINE)
    assert re.search(r"^  3 m +not run$", result.stdout, re.MULTILINE)
    assert re.search(r"^  2 m +10\d %? ?FAILED$|^  2 m +10\d % FAILED$", result.stdout, re.MULTILINE)
    assert re.search(r"^  0\.1 m +9\d %$", result.stdout, re.MULTILINE)
    assert re.search(r"^  allowed +0\.1 m$", result.stdout, re.MULTILINE)
    assert re.search(
        r"0 deg +6 s +2 m +10\d % +1  smallest_sling_tension_when_clear S1$", result.stdout, re.M
    )
    assert "too steep: there are no such waves (they would break)" in result.stdout
    assert "not run: higher than a sea in which the lift is no go; --every" in " ".join(result.stdout.split())


def test_a_go_in_every_sea_ends_with_0(lift: Path) -> None:
    result = gantline("seas", str(lift), "--height", "0.1 m", "--period", "6 s")
    assert result.exit_code == 0, result.stdout
    assert "Not allowed" not in result.stdout


def test_higher_seas_are_run_if_asked(lift: Path) -> None:
    result = gantline("seas", str(lift), "--height", "2 m..3 m/2", "--period", "6 s", "--every", "--json")
    assert result.exit_code == 1
    document = json.loads(result.stdout)
    assert [sea["outcome"] for sea in document["seas"]] == ["NO-GO", "NO-GO"]
    assert document["allowed"] == [{"direction": 0.0, "period": 6.0, "height": None}]


def test_records_of_a_sea(lift: Path) -> None:
    sea_of(lift)
    result = gantline("seas", str(lift), "--height", "0.5 m", "--records", "3")
    assert result.exit_code == 0, result.stdout
    assert "3 records of each sea" in " ".join(result.stdout.split())
    assert "worse than the worst of them is 1 in 4" in " ".join(result.stdout.split())


def test_one_lift_in_ten(lift: Path, tmp_path: Path) -> None:
    """Of five records or more: in the table, in the report, and in the numbers."""
    sea_of(lift)
    folder = tmp_path / "out"
    assert gantline("run", str(lift), "-o", str(folder), "--no-plots", "--no-report").exit_code == 0
    result = gantline("seas", str(lift), "--height", "0.5 m", "--records", "5", "-o", str(folder))
    assert result.exit_code == 0, result.stdout
    row = r"^  0 deg +7 s +0\.5 m +(\S+ ± \S+ %)  smallest_sling_tension_when_clear S1$"
    (shown,) = re.findall(row, result.stdout, re.MULTILINE)
    assert "by Gumbel's distribution" in " ".join(result.stdout.split())
    (sea,) = json.loads((folder / "seas.json").read_text(encoding="utf-8"))["seas"]
    (found,) = (one for one in sea["extremes"] if one["check"] == "smallest_sling_tension_when_clear")
    every = (check for record in sea["records"] for check in record["checks"])
    values = [check["value"] for check in every if check["name"] == found["check"]]
    assert found["value"] == pytest.approx(-Gumbel.of([-value for value in values]).exceeded_by(0.1))
    assert shown == f"{100 * found['utilisation']:.1f} ± {100 * found['utilisation_error']:.1f} %"
    assert gantline("report", str(folder)).exit_code == 0
    page = (folder / "report.html").read_text(encoding="utf-8")
    assert re.search(re.escape(shown).replace(r"\ ", "."), page)


def test_files_and_the_report_beside_them(lift: Path, tmp_path: Path) -> None:
    folder = tmp_path / "out"
    assert gantline("run", str(lift), "-o", str(folder), "--no-plots", "--no-report").exit_code == 0
    result = gantline("seas", str(lift), *OVER, "-o", str(folder))
    assert result.exit_code == 1
    found = SavedSeas.from_json(json.loads((folder / "seas.json").read_text(encoding="utf-8")))
    assert found.allowed == {(0.0, 6.0): 0.1}
    assert (folder / "seas.png").read_bytes().startswith(b"\x89PNG")
    assert gantline("report", str(folder)).exit_code == 0
    page = (folder / "report.html").read_text(encoding="utf-8")
    assert 'id="seas"' in page
    assert re.search(r"allowed up to</th><td><strong>0\.1.m", page)
    assert "smallest_sling_tension_when_clear S1" in page


def test_seas_of_another_lift_are_not_shown(lift: Path, tmp_path: Path) -> None:
    folder = tmp_path / "out"
    assert gantline("seas", str(lift), "--height", "0.1 m", "-o", str(folder)).exit_code == 0
    lift.write_text(column(ALIKE, duration="10 s"), encoding="utf-8")
    assert gantline("run", str(lift), "-o", str(folder), "--no-plots", "--no-report").exit_code == 0
    result = gantline("report", str(folder))
    assert "seas.json: is of another lift file" in result.stderr
    assert 'id="seas"' not in (folder / "report.html").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (["--height", "1 t"], "--height: '1 t' is a mass"),
        (["--height", "0 m"], "--height: 0 is none that waves can have"),
        (["--height", "1 m..2 m/1"], "--height: '1' is no number of values"),
        (["--period", "8"], "--period: '8' has no unit"),
        (["--waves", "sea"], "--waves: the lift has no 'sea'; it has swell"),
        (["--records", "2"], "--records: waves that are all alike, without gusts, are the same in every"),
        (["--duration", "-3 s"], "--duration: '-3 s'"),
    ],
)
def test_what_cannot_be_asked(lift: Path, tmp_path: Path, words: list[str], expected: str) -> None:
    folder = tmp_path / "out"
    result = gantline("seas", str(lift), *words, "-o", str(folder))
    assert result.exit_code == 2
    assert expected in result.stderr
    assert not (folder / "seas.json").exists()


def test_ctrl_c_tells_what_there_is(lift: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from gantline.study.side_by_side import SideBySide

    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(SideBySide, "submit", interrupted)
    result = gantline("seas", str(lift), *OVER)
    assert result.exit_code == 130
    assert "interrupted" in result.stderr
    assert re.search(r"^  0\.1 m +not run$", result.stdout, re.MULTILINE)


def test_a_search_that_was_killed_goes_on(lift: Path, tmp_path: Path) -> None:
    """With the runs that had ended; the same numbers as of one that was not."""
    sea_of(lift)
    folder, whole = tmp_path / "out", tmp_path / "whole"
    asked = ["seas", str(lift), "--height", "0.2 m, 0.5 m", "--records", "2"]
    assert gantline(*asked, "-o", str(whole)).exit_code == 0
    folder.mkdir()
    lines = (whole / "seas_runs.jsonl").read_bytes().splitlines(keepends=True)
    # Killed as its third run was written.
    (folder / "seas_runs.jsonl").write_bytes(b"".join(lines[:3]) + lines[3][:100])
    result = gantline(*asked, "-o", str(folder), "--continue")
    assert result.exit_code == 0, result.stderr
    assert "Taken over  2 runs of seas_runs.jsonl" in result.stdout
    assert (folder / "seas.json").read_bytes() == (whole / "seas.json").read_bytes()


def test_without_it_all_is_run_anew(lift: Path, tmp_path: Path) -> None:
    folder = tmp_path / "out"
    for _ in range(2):
        result = gantline("seas", str(lift), "--height", "0.1 m", "-o", str(folder))
        assert "Taken over" not in result.stdout
    assert len((folder / "seas_runs.jsonl").read_bytes().splitlines()) == 2


def test_going_on_from_nothing(lift: Path, tmp_path: Path) -> None:
    """Without a folder, without a search in it, or with one of another lift; nothing is written."""
    folder = tmp_path / "out"
    result = gantline("seas", str(lift), "--continue")
    assert (result.exit_code, "name it by -o" in result.stderr) == (2, True)
    result = gantline("seas", str(lift), "--continue", "-o", str(folder))
    assert (result.exit_code, "nothing has been run in this folder" in result.stderr) == (2, True)
    assert not folder.exists()
    assert gantline("seas", str(lift), "--height", "0.1 m", "-o", str(folder)).exit_code == 0
    sea_of(lift)
    before = (folder / "seas_runs.jsonl").read_bytes()
    result = gantline("seas", str(lift), "--height", "0.1 m", "-o", str(folder), "--continue")
    assert (result.exit_code, "of another state of the lift file" in result.stderr) == (2, True)
    assert (folder / "seas_runs.jsonl").read_bytes() == before
