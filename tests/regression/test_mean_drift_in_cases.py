"""Cases of a lift in waves lay in still water, beside the lift as it is given, which the waves push.

A case starts as given, so that its ropes may pull from the start, and mean drift forces push from the start
only what starts at rest: so they were left out of cases, sweeps, margins of tilting, `--level`, `--plumb` and
`gantline ballast`, which say that they are in. Of `crane_barge_in_swell` with its design weight the tightest
line had 200.19 kN in `gantline cases`, and 205.74 kN in `gantline statics` of a file with that weight; as it
is given it has 205.78 kN.

What waves push with does not depend on the weight of the load, and so hardly what lines pull against it; and
a case is the lift file with that change, at rest.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from gantline.scenario import Scenario, parse_scenario
from gantline.statics import Equilibrium, Statics
from gantline.study import run_cases, run_sweep

FOLDER = Path(__file__).parents[2] / "scenarios" / "crane_barge_in_swell"
LINES = [f"mooring.{end}.{side}" for end in ("bow", "stern") for side in ("ps", "sb")]
PRETENSION = 200e3


def lift(case: str, **changes: str) -> Scenario:
    """The scenario with one case and other words at the left margin."""
    text = (FOLDER / "scenario.yaml").read_text(encoding="utf-8")
    text = re.sub(r"(?s)\ncases:.*?\n\n", f"\ncases: {{other: {{set: {{{case}}}}}}}\n\n", text)
    for key, value in changes.items():
        text = re.sub(rf"(?m)^{key}: .*$", f"{key}: {value}", text)
    return parse_scenario(text, str(FOLDER / "scenario.yaml"))


def pulls(rest: Equilibrium | None) -> list[float]:
    """What the lines pull with [N]."""
    assert rest is not None
    return [rest.tension(line) for line in LINES]


def test_a_case_is_pushed_as_the_lift_is() -> None:
    """As the lift with its design weight in the file, and held against the same push as the lift as given."""
    found = run_cases(lift("load.weight.simulate: design"), workers=1)
    (given, case) = (pulls(found.of(name)[0].rest) for name in ("", "other"))
    heavy = lift("load.weight.simulate: design").changed({"load.weight.simulate": "design"})
    assert case == pytest.approx(pulls(Statics(heavy).equilibrium()), rel=1e-12)
    assert [pull - case[0] for pull in case] == pytest.approx([pull - given[0] for pull in given], abs=10.0)
    assert max(case) > PRETENSION + 5e3


def test_a_value_of_a_sweep_is_pushed_too() -> None:
    """The weight that the lift has, as a value of a sweep."""
    scenario = lift("load.weight.simulate: design")
    (point,) = run_sweep(scenario, "load.weight.calculated", "120 t", "120 t", 1)
    assert pulls(point.state.rest) == pytest.approx(pulls(Statics(scenario).equilibrium()), rel=1e-12)


@pytest.mark.parametrize(("case", "start"), [("start: as_given", "rest"), ("duration: 299 s", "as_given")])
def test_what_starts_as_given_is_not(case: str, start: str) -> None:
    """By the word of the case or of the file: lines have their pretension but for how deep she lies."""
    (state,) = run_cases(lift(case, start=start), workers=1).of("other")[:1]
    assert pulls(state.rest) == pytest.approx([PRETENSION] * 4, rel=5e-3)
