"""`gantline cases` and `gantline statics --sweep`, as people use them."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from gantline.results.file.saved import SavedCases
from lift_text import changed
from plumb_lift import WEIGHT, plumb_lift
from verbs import gantline

ALL = """\
heavy: {set: {load.weight.simulate: design}}
cog_corners: {vary: load.centre_of_gravity.envelope, corners: all}
sling_lengths: {vary: slings.tolerance, pattern: worst}
hook_levels: {vary: {cranes.A.at.z: [-1 mm, 1 mm]}}"""


@pytest.fixture
def lift(tmp_path: Path) -> Path:
    path = tmp_path / "lift.yaml"
    text = plumb_lift(ALL, tolerance="0.01 %", envelope="[0.1 m, 0.1 m, 0 m]")
    path.write_text(text, encoding="utf-8")
    return path


@pytest.mark.parametrize("columns", [80, 120])
def test_the_tables(lift: Path, columns: int) -> None:
    result = gantline("cases", str(lift), columns=columns)
    assert result.exit_code == 0, result.stderr
    assert max(map(len, result.stdout.splitlines())) <= columns
    assert "4 cases, 10 equilibria asked for: all sound" in result.stdout
    # W/4 = 735.75 kN.
    assert re.search(r"as given +735\.[78] kN +735\.[78] kN .*ok\n", result.stdout)
    # W/4 (1 ± 4 k t/W): k t = 20 kN.
    assert re.search(r"sling_lengths \(2\) +715\.7 kN +755\.8 kN", result.stdout)
    assert re.search(r"SA +735\.[78] kN +715\.7 to 755\.8 kN +715\.7 to 755\.8 kN", result.stdout)
    assert re.search(r"SA highest +735\.[78] kN +809\.3 kN +1\.100 +heavy\n", result.stdout)


def test_long_searches_say_what_they_are_at(lift: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """It was silent to the end, for a minute or two of a lift with equalizers; as given and nine variants."""
    monkeypatch.setattr("gantline.cli.progress._SILENCE_OF_SEARCHES", 1e-3)
    result = gantline("cases", str(lift), "--json")
    assert re.search(r"^cases, \d of 10 variants, \d+ s so far$", result.stderr, re.MULTILINE)
    assert json.loads(result.stdout)


def test_each_variant_in_a_line(lift: Path) -> None:
    result = gantline("cases", str(lift), "--variants", columns=120)
    assert result.exit_code == 0
    for variant in ("−x −y", "−x +y", "+x −y", "+x +y"):
        assert f"cog_corners ({variant})" in result.stdout
    assert "hook_levels (cranes.A.at.z −1 mm)" in result.stdout


def test_what_shows_the_same_as_given_has_no_case_for_its_cause(lift: Path) -> None:
    """1 g more in 300 t is worse by a share of 3e-9: that is in the numbers for programs, and in no table."""
    spoil(lift, ("  heavy: ", "  gram: {set: {load.weight.calculated: 300.000001 t}}\n  heavy: "))
    lines = lift.read_text(encoding="utf-8").splitlines()
    kept = [line for line in lines if not line.startswith(("  heavy", "  cog", "  sling_l", "  hook_l"))]
    lift.write_text("\n".join(kept), encoding="utf-8")
    result = gantline("cases", str(lift))
    assert result.exit_code == 0, result.stderr
    assert re.search(r"SA highest +735\.[78] kN +735\.[78] kN +1\.000 +as given\n", result.stdout)
    document = json.loads(gantline("cases", str(lift), "--json").stdout)
    worst = {(one["quantity"], one["element"]): one for one in document["worst"]}
    assert worst["sling_tension", "SA"]["case"] == "gram"


def test_json(lift: Path) -> None:
    result = gantline("cases", str(lift), "--json")
    assert result.exit_code == 0
    document = json.loads(result.stdout)
    assert document["sound"] is True
    named = {one["case"]: one["states"] for one in document["cases"]}
    assert list(named) == ["", "heavy", "cog_corners", "sling_lengths", "hook_levels"]
    (heavy,) = named["heavy"]
    assert heavy["sling_tension"]["SA"] == pytest.approx(1.1 * WEIGHT / 4, rel=1e-9)
    assert heavy["governing"] is None, "there are no limits"
    assert heavy["stable"] is True and heavy["failed"] == [] and heavy["checks"]
    worst = {(one["quantity"], one["element"]): one for one in document["worst"]}
    assert worst["sling_tension", "SA"]["case"] == "heavy"


def spoil(lift: Path, *changes: tuple[str, str]) -> None:
    lift.write_text(changed(lift.read_text(encoding="utf-8"), *changes), encoding="utf-8")


def test_a_check_that_fails_in_a_case_ends_with_one(lift: Path) -> None:
    spoil(lift, ("cases:\n", "limits: {smallest_sling_tension_when_clear: 720 kN}\ncases:\n"))
    result = gantline("cases", str(lift))
    assert result.exit_code == 1, result.stdout + result.stderr
    assert re.search(r"sling_lengths \(2\) +715\.7 kN .*FAILED\n", result.stdout)
    # 720 kN over W/4 (1 − 0.04 − 0.04) = 676.9 kN, and over W/4 as given.
    assert re.search(
        r"cog_corners \(4\) +smallest_sling_tension_when_clear +106\.4 % +S[A-D]\n", result.stdout
    )
    assert re.search(r"as given +smallest_sling_tension_when_clear +97\.9 % +S[A-D]\n", result.stdout)
    assert max(map(len, result.stdout.splitlines())) <= 80
    # W/4 (1 − 0.04 − 0.04) = 676.9 kN in two corners at the lug that is farthest off.
    note = "smallest_sling_tension_when_clear failed: cog_corners (4 of 4),"
    assert note in result.stdout
    assert "6 failed a check" in result.stdout


def test_no_equilibrium_ends_with_three(lift: Path) -> None:
    spoil(lift, ("  heavy: ", "  gone: {cut: [SA, SB, SC, SD]}\n  heavy: "))
    result = gantline("cases", str(lift))
    assert result.exit_code == 3
    assert re.search(r"gone +- +- +- +- +- +NONE\n", result.stdout)
    assert "no equilibrium: nothing holds it, it falls without end (girder): gone" in result.stdout
    assert "5 cases, 11 equilibria asked for: 1 no equilibrium" in result.stdout


def test_a_case_that_cannot_start_is_a_line_of_the_table(lift: Path, tmp_path: Path) -> None:
    """Its sling would be stretched by 0.5 m in 9.5 m; all else is shown as ever."""
    spoil(lift, ("  heavy: ", "  short: {set: {slings.SA.length: 9.5 m}}\n  heavy: "))
    result = gantline("cases", str(lift), "-o", str(tmp_path / "out"))
    assert result.exit_code == 1, result.stderr
    assert max(map(len, result.stdout.split("\nCases ")[0].splitlines())) <= 80
    assert re.search(r"short +- +- +- +- +- +NO START\n", result.stdout)
    assert re.search(r"heavy +809\.3 kN .* ok\n", result.stdout)
    why = " ".join(result.stdout.split())
    assert "cannot start: slings.SA: the sling is 9.5 m, but from 'A' to 'girder.A' it is 10.000 m" in why
    assert "it would be stretched by 5.26 %, and a start allows 2 %; lower the hook" in why
    assert "5 cases, 11 equilibria asked for: 1 cannot start" in why
    saved = json.loads((tmp_path / "out" / "cases.json").read_text(encoding="utf-8"))
    troubles = {one.name: one.troubles for one in SavedCases.from_json(saved).cases}
    assert troubles["short"][0].startswith("cannot start: slings.SA: the sling is 9.5 m")
    assert not saved["sound"] and not troubles["heavy"]


def test_a_lift_that_cannot_start_as_given_is_bad_input(lift: Path) -> None:
    spoil(lift, ("  SA: {from", "  SA: {length: 9.5 m, from"))
    result = gantline("cases", str(lift))
    assert (result.exit_code, result.stdout) == (2, "")
    assert "slings.SA: the sling is 9.5 m, but" in result.stderr


def test_no_equilibrium_outweighs_a_case_that_cannot_start(lift: Path) -> None:
    more = "  gone: {cut: [SA, SB, SC, SD]}\n  short: {set: {slings.SA.length: 9.5 m}}\n  heavy: "
    spoil(lift, ("  heavy: ", more))
    result = gantline("cases", str(lift))
    assert result.exit_code == 3
    assert "equilibria asked for: 1 no equilibrium, 1 cannot start" in result.stdout


def test_a_load_that_stands_in_a_case_and_hangs_as_given_is_told(tmp_path: Path) -> None:
    # With its hook 2.2 m lower the load, which is lifted by 2 m, is still on the ground.
    reference = Path(__file__).parents[2] / "scenarios" / "equalizer" / "scenario.yaml"
    path = tmp_path / "lift.yaml"
    low = "cases:\n  low: {vary: {cranes.test_hook.at.z: [-2.2 m, 0.01 m]}}\n"
    path.write_text(reference.read_text(encoding="utf-8") + low, encoding="utf-8")
    result = gantline("cases", str(path), "--variants", columns=120)
    assert result.exit_code == 1
    assert re.search(r"test_hook\.at\.z −2\.2 m\) .* STANDS\n", result.stdout)
    assert re.search(r"test_hook\.at\.z \+0\.01 m\) .* ok\n", result.stdout)
    assert "stands on its supports, and hangs as given: low (1 of 2)\n" in result.stdout
    assert "3 equilibria asked for: 1 on its supports" in result.stdout
    states = json.loads(gantline("cases", str(path), "--json").stdout)["cases"][1]["states"]
    assert [len(state["stands"]) for state in states] == [1, 0]


def test_a_file_without_cases(lift: Path) -> None:
    result = gantline("cases", "equalizer")
    assert result.exit_code == 2
    assert "there are no 'cases' in this file; one is written like 'cases: {heavy: " in result.stderr
    assert gantline("cases", str(lift), "--time", "-1 s").exit_code == 2


def test_a_sweep(lift: Path) -> None:
    result = gantline("statics", str(lift), "--sweep", "load.weight.calculated=100 t..300 t/3")
    assert result.exit_code == 0, result.stderr
    assert max(map(len, result.stdout.splitlines())) <= 80
    assert re.search(r"load\.weight\.calculated +girder tilt", result.stdout)
    assert re.search(r" 100 t +0\.00 deg", result.stdout)
    assert re.search(r" 200 t.* 490\.5 kN", result.stdout)


def test_a_sweep_of_what_decides_nothing_at_rest_says_so() -> None:
    """The table of a sea from other sides had the same numbers in each line, and no word of that."""
    swept = "waves.sea.direction=0 deg..90 deg/2"
    result = gantline("statics", "splash_zone", "--sweep", swept, columns=200)
    said = "  nothing changes with waves.sea.direction: forces, tilts and checks are alike, at rest\n"
    assert said in result.stdout
    # What mooring lines hold is pushed the way the waves run.
    pushed = swept.replace("sea", "swell")
    assert "nothing changes" not in gantline("statics", "crane_barge_in_swell", "--sweep", pushed).stdout
    heavier = gantline("statics", "crane_barge_in_swell", "--sweep", "load.weight.calculated=100 t..110 t/2")
    assert "nothing changes" not in heavier.stdout


def test_a_sweep_past_the_end_of_equilibria_ends_with_three(lift: Path) -> None:
    spoil(lift, ("  SD: {from", "  SD: {cut_at: 9 s, from"), ("  SB: {from", "  SB: {cut_at: 9 s, from"),
          ("  SC: {from", "  SC: {cut_at: 9 s, from"))  # fmt: skip
    result = gantline("statics", str(lift), "--sweep", "slings.SA.cut_at=9 s..10 s/2")
    assert result.exit_code == 3
    assert re.search(r"NONE", result.stdout)
    # The other slings part at 9 s: with SA then too nothing is left.
    assert re.search(r"no equilibrium: nothing holds it.*: 9 s$", result.stdout, re.MULTILINE)


def test_a_sweep_goes_on_where_the_lift_cannot_start(lift: Path) -> None:
    # 2 % of 10 m allow a hook at 12.7 m.
    swept = "cranes.A.at.z=12.5 m..12.8 m/3"
    result = gantline("statics", str(lift), "--sweep", swept, columns=200)
    assert result.exit_code == 1, result.stderr
    assert re.search(r" 12\.65 m .* ok\n", result.stdout)
    assert re.search(r" 12\.8 m +-.* NO START\n", result.stdout)
    assert re.search(r"stretched by 3\.00 %, and a start allows 2 %;[^:]*:\s+12\.8 m\n", result.stdout)


def test_a_sweep_says_which_check_failed_and_where(lift: Path) -> None:
    spoil(lift, ("cranes:", "limits: {smallest_sling_tension_when_clear: 200 kN}\ncranes:"))
    result = gantline("statics", str(lift), "--sweep", "load.weight.calculated=60 t..100 t/5")
    assert result.exit_code == 1
    # A quarter of the weight: 220.7 kN of 90 t, 196.1 kN of 80 t.
    assert "smallest_sling_tension_when_clear failed: 60 t to 80 t\n" in result.stdout


@pytest.mark.parametrize(
    ("sweep", "says"),
    [
        ("load.weight", "'load.weight' is no sweep; a sweep is written like"),
        ("load.weight.calculated=1 t..2 t/1", "'1' is no number of values; a whole number from 2 to 1000"),
        ("load.weight.calculated=1 t..2 m/3", "found '2 m'; a mass is written like"),
        ("load.weight=1 t..2 t/3", "'load.weight' has several values; name one of its parts"),
        ("lood.weight=1 t..2 t/3", "there is no 'lood' of this file; did you mean 'load'?"),
        (
            "load.weight.calculated=-1 t..2 t/3",
            "--sweep: load.weight.calculated=-1 t: '-1 t' is negative",
        ),
    ],
)
def test_a_sweep_that_cannot_be(lift: Path, sweep: str, says: str) -> None:
    result = gantline("statics", str(lift), "--sweep", sweep)
    assert result.exit_code == 2
    assert says in result.stderr and result.stdout == ""


def test_a_sweep_takes_no_options_of_one_equilibrium(lift: Path) -> None:
    result = gantline("statics", str(lift), "--sensitivities", "--sweep", "load.weight.calculated=1 t..2 t/3")
    assert result.exit_code == 2
    said = "--sensitivities does not go with it, --time and --json do"
    assert result.stderr == f"error: --sweep: makes a table of many equilibria; {said}\n"


def test_cases_are_saved_for_a_report_and_do_not_depend_on_the_workers(lift: Path, tmp_path: Path) -> None:
    from gantline.results.file.saved import CASES
    from gantline.study import run_cases

    folder = tmp_path / "out"
    result = gantline("cases", str(lift), "-o", str(folder))
    assert result.stdout.endswith(f"Cases       {folder / CASES}\n")
    text = (folder / CASES).read_text(encoding="utf-8")
    for workers in (1, 3):
        found = run_cases(lift, workers=workers)
        assert json.dumps(found.to_json(), indent=2) + "\n" == text
    saved = SavedCases.from_json(json.loads(text))
    assert [one.name for one in saved.cases] == list(found.names)
    assert saved.is_sound and not any(one.troubles for one in saved.cases)
    worst = saved.worst_of("sling_tension")
    assert worst is not None
    assert worst.value == max(one.value for one in found.worst if one.quantity == "sling_tension")


def test_a_case_that_changes_nothing_says_so_and_why(tmp_path: Path) -> None:
    """SA is taken off at 5 s, and SC, across, is slack then: neither is missed; SB is."""
    cases = """\
off: {cut: SA}
early: {cut: SA, at: 1 s}
late: {cut: SA, at: 7 s}
partly: {cut: [SA, SB], at_step: look}
slack: {cut: SC}
title: {set: {lift.title: another}}
by_nothing: {vary: {sling_defaults.length: [0 mm, 1 mm]}}"""
    plan = "plan:\n  - {step: hang, hold: 5 s}\n  - {step: look, hold: 1 s, detach: sling.SA}\n"
    path = tmp_path / "lift.yaml"
    path.write_text(plumb_lift(cases) + plan, encoding="utf-8")
    result = gantline("cases", str(path), columns=120)
    lines = [line.split() for line in result.stdout.splitlines()]
    ends = {line[0]: line[-2:] for line in lines if line and line[-2:] == ["NO", "CHANGE"]}
    assert sorted(ends) == ["late", "off", "slack"]
    for note in (
        "nothing is cut: SA is not on at 10 s: off",
        "nothing is cut: SA is not on at 7 s: late",
        "nothing is cut: SA is not on at 5 s: partly",
        "nothing is cut: SC carries nothing at 10 s as given: slack",
        "nothing changes: forces, tilts and checks are as given: title, by_nothing (1 of 2)",
    ):
        assert f"  {note}\n" in result.stdout
    assert "; 4 cases changed nothing\n" in result.stdout
    document = json.loads(gantline("cases", str(path), "--json").stdout)
    states = {one["case"]: one["states"] for one in document["cases"]}
    assert [one["changes_nothing"] for one in states["by_nothing"]] == [True, False]
    assert states["late"][0]["changes_nothing"] and states["late"][0]["in_vain"] == ["SA is not on at 7 s"]
    assert not states["early"][0]["changes_nothing"] and not states["partly"][0]["changes_nothing"]
    remarks = {one.name: one.remarks for one in SavedCases.from_json(document).cases}
    assert remarks["late"] == ("nothing is cut: SA is not on at 7 s", "changes nothing")
    assert remarks["title"] == ("changes nothing",) and remarks["early"] == ()


def test_a_case_past_what_nobody_limits_is_named(tmp_path: Path) -> None:
    """Two slings 0.9 m longer, 5 m from the others, tilt the load by 10 deg; nobody set a limit of that."""
    path = tmp_path / "lift.yaml"
    askew = "askew: {set: {slings.SA.length: 10.9 m, slings.SB.length: 10.9 m}}"
    heavy = "heavy: {set: {load.weight.simulate: design}}"
    path.write_text(plumb_lift(f"{askew}\n{heavy}"), encoding="utf-8")
    result = gantline("cases", str(path), columns=120)
    assert result.exit_code == 0, result.stdout + result.stderr
    assert "  load_tilt past a limit that only warns: askew\n" in result.stdout
    document = json.loads(gantline("cases", str(path), "--json").stdout)
    named = {one["case"]: one["states"][0] for one in document["cases"]}
    assert named["askew"]["past_limits_that_warn"] == ["load_tilt"]
    assert named["heavy"]["past_limits_that_warn"] == []


SIMULATED = """\
heavy: {set: {load.weight.simulate: design}}
hook_levels: {vary: {cranes.A.at.z: [-1 mm, 0 mm]}}
cut: {cut: SA, at: 0.2 s}"""


@pytest.fixture
def plan(tmp_path: Path) -> Path:
    """The same four hooks, whose slings are not taut at the start."""
    path = tmp_path / "plan.yaml"
    path.write_text(plumb_lift(SIMULATED, tolerance="0.01 %", envelope="[0 m, 0 m, 0 m]"), encoding="utf-8")
    return path


@pytest.mark.parametrize("columns", [80, 120])
def test_simulated(plan: Path, columns: int) -> None:
    result = gantline("cases", str(plan), "--simulate", columns=columns)
    assert result.exit_code == 1, result.stderr
    assert max(map(len, result.stdout.splitlines())) <= columns
    assert re.search(r"^Case +slings +to +hook load +tilt$", result.stdout, re.MULTILINE)
    assert re.search(r"^  hook_levels \(2\) ", result.stdout, re.MULTILINE)
    assert re.search(r"^  cut +.* NO-GO$", result.stdout, re.MULTILINE)
    assert re.search(r"rope_parted failed: cut$", result.stdout, re.MULTILINE)
    assert re.search(r"^Worst case of each limit +value +limit +used", result.stdout, re.MULTILINE)
    assert re.search(r"^3 cases, 5 runs: \d NO-GO", result.stdout, re.MULTILINE)


def test_simulated_in_a_file(plan: Path, tmp_path: Path) -> None:
    folder = tmp_path / "out"
    result = gantline("cases", str(plan), "--simulate", "--json", "-o", str(folder))
    assert result.exit_code == 1
    document = json.loads(result.stdout)
    assert json.loads((folder / "case_runs.json").read_text(encoding="utf-8")) == document
    assert not (folder / "cases.json").exists()
    assert (folder / "case_runs.png").read_bytes().startswith(b"\x89PNG")
    assert [(one["case"], len(one["runs"])) for one in document["cases"]] == [
        ("", 1),
        ("heavy", 1),
        ("hook_levels", 2),
        ("cut", 1),
    ]
    assert document["go"] is False
    assert {one["case"] for one in document["worst"]} <= {"", "heavy", "hook_levels", "cut"}


def test_each_simulated_variant_in_a_line(plan: Path) -> None:
    result = gantline("cases", str(plan), "--simulate", "--variants", columns=120)
    for variant in ("−1 mm", "+0 mm"):
        assert f"hook_levels (cranes.A.at.z {variant})" in result.stdout


def test_simulated_cases_that_were_killed_go_on(plan: Path, tmp_path: Path) -> None:
    """With the runs that had ended, to the same bytes; their table is the same but for its last line."""
    asked = ["cases", str(plan), "--simulate", "-o"]
    whole, folder = tmp_path / "whole", tmp_path / "out"
    first = gantline(*asked, str(whole))
    assert first.exit_code == 1, first.stderr
    lines = (whole / "case_runs.jsonl").read_bytes().splitlines(keepends=True)
    assert len(lines) == 1 + 5
    folder.mkdir()
    # Killed as its third run was written.
    (folder / "case_runs.jsonl").write_bytes(b"".join(lines[:3]) + lines[3][:100])
    result = gantline(*asked, str(folder), "--continue")
    assert result.exit_code == 1, result.stderr
    assert "Taken over  2 runs of case_runs.jsonl" in result.stdout
    assert result.stdout.split("\nPicture ")[0] == first.stdout.split("\nPicture ")[0]
    assert (folder / "case_runs.json").read_bytes() == (whole / "case_runs.json").read_bytes()
    spoil(plan, ("contingency: 1.1", "contingency: 1.2"))
    before = (folder / "case_runs.jsonl").read_bytes()
    result = gantline(*asked, str(folder), "--continue")
    assert (result.exit_code, "of another state of the lift file" in result.stderr) == (2, True)
    assert (folder / "case_runs.jsonl").read_bytes() == before


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--continue"], "--continue: only runs are kept, no equilibria; with --simulate it is right"),
        (["--simulate", "--continue"], "name it by -o"),
        (["--simulate", "--continue", "-o", "out"], "nothing has been run in this folder"),
    ],
)
def test_cases_that_cannot_go_on(
    plan: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, words: list[str], said: str
) -> None:
    monkeypatch.chdir(tmp_path)
    result = gantline("cases", str(plan), *words)
    assert (result.exit_code, said in result.stderr) == (2, True), result.stderr
    assert not (tmp_path / "out").exists()


def test_the_report_shows_simulated_cases(plan: Path, tmp_path: Path) -> None:
    """Where a case nearest to a limit is as the table has it."""
    folder = tmp_path / "out"
    assert gantline("run", str(plan), "-o", str(folder), "--no-plots", "--no-report").exit_code in (0, 1, 4)
    result = gantline("cases", str(plan), "--simulate", "-o", str(folder), columns=120)
    assert gantline("report", str(folder)).exit_code == 0
    page = (folder / "report.html").read_text(encoding="utf-8")
    assert 'id="simulated-cases"' in page
    (counts,) = re.findall(r"^(3 cases, 5 runs: .*)$", result.stdout, re.MULTILINE)
    assert page.count(counts) == 2
    assert "no go when simulated" in page
    assert "rope parted" in page
