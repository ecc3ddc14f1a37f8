"""What "as given" means in cases of a lift whose sheaves have losses.

There are three equilibria of each variant then: without losses, all sheaves slipping along the rope, all
against. "As given" was the worst of the three in the table of the highest tensions and the one without losses
in that of the worst cases: 638.4 kN and 589.7 kN of the same sling, of which a case that changes nothing was
told to be "1.083 of it". It is the worst of the three everywhere now, and the tables say so.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from gantline.cli.cases_table import cases_table
from gantline.scenario import parse_scenario
from gantline.study import run_cases
from gantline.study.cases import CasesResult
from gantline.study.state import values_of

EQUALIZER = Path(__file__).resolve().parents[2] / "scenarios" / "equalizer" / "scenario.yaml"
LOSSY = ("efficiency: 1.0, rotating_mass: 0 kg", "efficiency: 0.98, rotating_mass: 150 kg")
CASES = """\
cases:
  higher: {vary: {cranes.test_hook.at.z: [10 mm]}}
  off: {vary: slings.tolerance, pattern: each}
"""
SAID = (
    "of sheaves with losses the worst of three equilibria: without losses, all slip along, all slip against"
)


@pytest.fixture(scope="module")
def result() -> CasesResult:
    text = EQUALIZER.read_text(encoding="utf-8").replace(*LOSSY)
    return run_cases(parse_scenario(text + CASES))


def test_as_given_is_the_worst_of_its_three(result: CasesResult) -> None:
    of_given = [values_of(state) for state in result.of("")]
    assert [state.losses for state in result.of("")] == ["none", "forward", "backward"]
    found = {(one.quantity, one.element): one for one in result.worst}
    for sling in ("S1", "S2", "S3", "S4", "S5"):
        tensions = [one["sling_tension"][sling] for one in of_given]
        assert found["sling_tension", sling].given == pytest.approx(max(tensions), rel=1e-9)
        assert found["smallest_sling_tension", sling].given == pytest.approx(min(tensions), rel=1e-9)
    tilts = [one["load_tilt"]["block"] for one in of_given]
    assert found["load_tilt", "block"].given == pytest.approx(max(tilts), rel=1e-9)
    for sheave in ("e1.1", "e1.5"):
        travels = [one["sheave_travel"][sheave] for one in of_given]
        assert found["sheave_travel", sheave].given == pytest.approx(max(travels, key=abs), rel=1e-9)


def test_tables_have_the_same_number(result: CasesResult) -> None:
    """The column of the highest tensions, and the lines of the worst cases."""
    lines = cases_table(result, width=200, variants=False)
    assert any(SAID in line for line in lines)
    rows = [re.split(r" {2,}", line.strip()) for line in lines]
    (head,) = (row for row in rows if row[0] == "Highest tension")
    highest = {row[0]: row[head.index("as given")] for row in rows[rows.index(head) + 1 :][:5]}
    worst = {row[0].removesuffix(" highest"): row[1] for row in rows if row[0].endswith(" highest")}
    assert len(highest) == 5
    assert worst == highest
    # Sensitivities are about the lift without losses, and say so.
    (bands,) = (row for row in rows if row[0] == "off" and "by sensitivities" in row)
    assert bands[1] == "without losses"


def test_each_variant_says_what_its_losses_are(result: CasesResult) -> None:
    lines = cases_table(result, width=200, variants=True)
    names = [line.split("  ")[0] or line.strip().split("  ")[0] for line in lines]
    assert "as given" not in names
    for name in ("as given (without losses)", "as given (slip along)", "as given (slip against)"):
        assert name in names


def test_a_lift_without_losses_says_nothing_of_them() -> None:
    lift = parse_scenario(EQUALIZER.read_text(encoding="utf-8") + CASES)
    text = "\n".join(cases_table(run_cases(lift), width=200, variants=False))
    assert "losses" not in text
