"""A simulated dynamic factor above that of the rule stood in the list of checks alone, with other limits.

The first page had the static hook load times the factor of the rule, 263.7 t of a module of 210 t in 5 m of
swell with 1.25 after table 5-1 of 0027/ND, and not that the hook had 1.30 times its static load: with the
design weight 275 t.
"""

from __future__ import annotations

import pytest

from box_on_a_hook import box_on_a_hook
from gantline.checks import values_of
from gantline.report.first_page import FirstPage
from gantline.report.subject import Subject
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from lift_text import changed

#: Contingency of the load of 10 t.
CONTINGENCY = 1.1
UP = "  - {step: up, hoist: hook, speed: 30 m/min, by: 0.5 m}"


def _rows(factor: float) -> tuple[dict[str, str], float]:
    """Rows of the weights on the first page, and the dynamic factor of the hook."""
    text = box_on_a_hook(
        UP, duration=8.0, speed=30.0, more=f"rules: {{dynamic_amplification_factor: {factor}}}\n"
    )
    text = changed(
        text,
        ("calculated: 10 t", f"calculated: 10 t, contingency: {CONTINGENCY}"),
        ("0.1 m/s^2", "2 m/s^2"),
    )
    run = simulate(parse_scenario(text))
    rows = dict(FirstPage().content(Subject(run))["weights"])
    return rows, values_of(run, "hook_dynamic_factor")["hook"]


def test_it_stands_below_that_of_the_rule() -> None:
    """W c times the factor of the run; slings weigh nothing."""
    rows, simulated = _rows(1.05)
    assert simulated > 1.2
    told = rows[f"× factor simulated, more than that of the rule: {simulated:.2f}"]
    assert float(told.removesuffix(" t")) == pytest.approx(10.0 * CONTINGENCY * simulated, abs=0.06)


def test_one_below_is_not_told() -> None:
    rows, simulated = _rows(1.5)
    assert simulated < 1.5
    assert not any("simulated, more" in name for name in rows)
