"""Simulated cases as picture and report show them: what is worst of what, and what is no such file."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest

from gantline.checks import Check, Verdict
from gantline.plot.case_runs import case_runs_picture
from gantline.report.case_runs import SimulatedCases
from gantline.report.first_page import FirstPage
from gantline.report.subject import Subject
from gantline.results.file.saved import Beside, digest_of, read_beside
from gantline.results.file.saved_case_runs import SavedCaseRuns
from gantline.study import CaseRun, CaseRuns
from sample_lift import ringing_lift, sample_rig


def lug(used: float, element: str = "L1", verdict: Verdict = Verdict.OK) -> Check:
    return Check(
        "lug_load_of_capacity", verdict, "", value=used, limit=1.0, unit="%", digits=1, element=element
    )


def spread(used: float) -> Check:
    verdict = Verdict.WARNING if used > 1.0 else Verdict.OK
    return Check("tension_spread", verdict, "", value=0.05 * used, limit=0.05, unit="%", element="e1")


#: The least tension: 20 kN are asked for. A share of 20 over 0 is no number.
SLACK = Check(
    "smallest_sling_tension",
    Verdict.FAILED,
    "",
    value=0.0,
    limit=20e3,
    at_least=True,
    unit="kN",
    digits=1,
    element="S1",
)
PARTED = Check("rope_parted", Verdict.FAILED, "", element="S1")
PEAKS = {"peak_sling_tension": 500e3, "least_sling_tension_when_clear": 300e3, "peak_hook_load": 981e3}

RUNS = (
    CaseRun(case="", checks=(lug(0.5), spread(0.4)), peaks=PEAKS),
    CaseRun(case="corners", variant="−x", checks=(lug(0.9), spread(1.2)), peaks={"peak_sling_tension": 6e5}),
    CaseRun(case="corners", variant="+x", checks=(lug(1.0004, "L2", Verdict.FAILED), spread(0.8))),
    CaseRun(case="lengths", variant="S1 −", cause="slings.S1: too short", starts=False),
    CaseRun(case="lengths", variant="S1 +", checks=(lug(0.6), spread(0.4))),
    CaseRun(case="cut", variant="at 5 s", checks=(lug(0.7), SLACK, PARTED)),
)


def saved(*runs: CaseRun, **given: Any) -> SavedCaseRuns:
    document = CaseRuns("A lift", "text", runs or RUNS, **given).to_json()
    return SavedCaseRuns.from_json(json.loads(json.dumps(document)))


def content(found: SavedCaseRuns) -> Mapping[str, Any]:
    shown = SimulatedCases().content(Subject(ringing_lift(rig=sample_rig()), Beside(case_runs=found)))
    assert shown is not None
    return shown


def test_the_nearest_of_each_limit() -> None:
    """What failed without a share leads; then the shares, whatever the verdict."""
    nearest = [(check.name, check.share, run.case, run.variant) for check, run in saved().nearest]
    assert nearest == [
        ("smallest_sling_tension", "failed", "cut", "at 5 s"),
        ("rope_parted", "failed", "cut", "at 5 s"),
        ("tension_spread", "120 %", "corners", "−x"),
        # 1.0004 does not read as if it were at its limit.
        ("lug_load_of_capacity", "100.04 %", "corners", "+x"),
    ]


def test_the_section_has_a_field_of_limits_and_cases() -> None:
    (field,) = content(saved())["fields"]
    assert [one["name"] for one in field["cases"]] == ["as given", "corners", "lengths", "cut"]
    rows = {row["limit"]: [(cell["text"], cell["tone"]) for cell in row["cells"]] for row in field["rows"]}
    assert rows["lug load of capacity"] == [
        ("50 %", "good"),
        ("100.04 %", "bad"),
        ("60 %", "good"),
        ("70 %", "good"),
    ]
    assert rows["tension spread"] == [("40 %", "good"), ("120 %", "warn"), ("40 %", "good"), ("–", "")]
    assert rows["rope parted"] == [("–", ""), ("–", ""), ("–", ""), ("failed", "bad")]


def test_the_section_says_what_came_of_each_case() -> None:
    """The worst of its runs, and in which; hook loads are in t: 981 kN are 100 t."""
    cases = {one["name"]: one for one in content(saved())["cases"]}
    assert [one["told"] for one in cases.values()] == ["go", "no go", "no start", "no go"]
    assert (cases["as given"]["least"], cases["as given"]["most"]) == ("300.0", "500.0")
    assert cases["as given"]["hook_load"] == "100.0"
    assert cases["corners"]["most"] == "600.0"
    assert cases["corners"]["said"] == "lug load of capacity failed in 1 of 2 (+x)"
    assert cases["lengths"]["said"].startswith("no start in 1 of 2 (S1 −): slings.S1: too short")
    assert cases["cut"]["said"] == "smallest sling tension, rope parted failed"


def test_many_cases_come_below_each_other() -> None:
    many = [CaseRun(case=f"case_{number}" if number else "", checks=(lug(0.5),)) for number in range(10)]
    fields = content(saved(*many))["fields"]
    assert [len(field["cases"]) for field in fields] == [8, 2]


def test_what_is_missing_is_told() -> None:
    found = content(saved(left_out={"gone": "a cut without a time"}, not_done=["late"]))
    assert found["notes"] == [
        "gone was not simulated: a cut without a time.",
        "Interrupted: not all variants were simulated of late.",
    ]


def test_the_first_page_names_the_cases_that_are_no_go() -> None:
    """A GO of the run is then not green."""
    recording = ringing_lift(rig=sample_rig(load_tilt=1.0))
    clean = (CaseRun(case="", checks=(lug(0.5),)), CaseRun(case="heavy", checks=(lug(0.6),)))
    good, bad = (
        FirstPage().content(Subject(recording, Beside(case_runs=one))) for one in (saved(*clean), saved())
    )
    assert good["verdict"]["no_go_cases"] == ""
    assert bad["verdict"]["head"] == good["verdict"]["head"]
    assert (bad["verdict"]["tone"], bad["verdict"]["no_go_cases"]) == ("warn", "corners, lengths, cut")
    assert good["simulated_cases"]["nearest"] == "lug load of capacity L1 60 %, heavy"


def test_the_picture_has_a_cell_for_each_limit_and_case() -> None:
    (field,) = case_runs_picture(saved()).axes
    cells = [text.get_text() for text in field.texts]
    assert len(cells) == 4 * 4
    assert {cell: cells.count(cell) for cell in ("100.04 %", "120 %", "failed")} == {
        "100.04 %": 1,
        "120 %": 1,
        "failed": 2,
    }
    heads = [label.get_text() for label in field.get_xticklabels()]
    assert heads == ["as given", "corners (2)", "lengths (2), no start", "cut"]


def test_a_picture_of_cases_without_limits() -> None:
    assert case_runs_picture(saved(CaseRun(case=""), CaseRun(case="heavy"))).axes


def test_the_report_takes_those_of_its_lift(tmp_path: Path) -> None:
    recording = ringing_lift(rig=sample_rig())
    document = CaseRuns("A lift", str(recording.attributes.get("scenario", "")), RUNS).to_json()
    file = tmp_path / "case_runs.json"
    file.write_text(json.dumps(document), encoding="utf-8")
    assert read_beside(tmp_path, recording).case_runs is not None
    file.write_text(json.dumps(document | {"scenario_sha256": digest_of("other")}), encoding="utf-8")
    beside = read_beside(tmp_path, recording)
    assert beside.case_runs is None
    assert "case_runs.json: is of another lift file" in beside.left_out[0]
    assert "'gantline cases --simulate' renews it" in beside.left_out[0]


@pytest.mark.parametrize(
    "change",
    [
        {"cases": []},
        {"cases": [{"case": "", "runs": [{"outcome": "PERHAPS", "variant": "", "peaks": {}}]}]},
        {"cases": [{"case": "", "runs": [{}]}]},
        {"left_out": ["gone"]},
        {"not_done": None},
    ],
)
def test_what_is_no_such_file(change: dict[str, Any]) -> None:
    with pytest.raises(ValueError, match=r"."):
        SavedCaseRuns.from_json(CaseRuns("A lift", "text", RUNS).to_json() | change)
