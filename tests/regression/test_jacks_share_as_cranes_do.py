"""Capacity that a rule keeps back where several lift one load: strand jacks beside a crane were nobody.

A hook of 220 t under one end of a section and two jacks under the other: 91 % of 220 t, GO, with
`several_cranes_factor: 1.2` in the lift file, as if the hook had lifted alone.
"""

from __future__ import annotations

import pytest

from gantline.checks import Verdict, winch_gauges
from gantline.checks.ratings import bears_alone, kept_back
from gantline.results import Recording
from gantline.scenario import parse_scenario
from gantline.statics import Statics
from jacks_and_hook import LIFT, LOAD
from lift_text import changed
from of_recording import check_of

#: Rated capacity of the hook [t], and what a lift file keeps back.
RATED, KEPT = 220.0, 1.2


def _at_rest(rules: str, *changes: tuple[str, str]) -> Recording:
    text = changed(LIFT, ("type: fixed_hook,", f"type: fixed_hook, rated_capacity: {RATED} t,"), *changes)
    return Statics(parse_scenario(f"{text}rules: {{{rules}}}\n")).equilibrium(time=0.0).recording


@pytest.fixture(scope="module")
def shared() -> Recording:
    """A hook with half of the load, two jacks with the other half."""
    return _at_rest(f"several_cranes_factor: {KEPT}")


def test_the_factor_counts_beside_jacks(shared: Recording) -> None:
    """(RA1): f x 200 t over 220 t, 109 %.

    Sling and bundles stretch by T L/EA, which lets the hook's end down by 134 mm, with the 100 mm that the
    sling is short, and the other by 60 mm: the centre of gravity, 2 m below the lugs, moves 4 mm of 36 m.
    """
    found = check_of(shared, "hoist_load_of_rated_capacity")
    force = LOAD / 2 * 9.81e3
    sags = force * 23.9 / 200e6 - 0.1 - force / 2 * 34 / 556e6
    share = 0.5 - 2.0 * sags / 36 / 36
    assert found.value == pytest.approx(KEPT * LOAD * share / RATED, rel=2e-6)
    assert found.verdict is Verdict.FAILED


def test_who_has_jacks_beside_it_bears_nothing_alone(shared: Recording) -> None:
    assert not bears_alone(shared, "H").any()


def test_a_table_of_cranes_has_no_row_for_jacks() -> None:
    rest = _at_rest("several_cranes: queensland")
    kept, [caution] = kept_back(rest, "H")
    assert kept == 1.0
    assert caution.text == (
        "H lifts together with j1, j2, and no rule keeps capacity back; 'several_cranes_factor' of 'rules' "
        "does"
    )


def test_what_steadies_the_load_shares_nothing() -> None:
    """With the weight below the hook the jacks bear their own bundles and little else."""
    rest = _at_rest(
        f"several_cranes_factor: {KEPT}",
        ("centre_of_gravity: {at: [0 m,", "centre_of_gravity: {at: [17.9 m,"),
    )
    assert kept_back(rest, "H") == (1.0, [])


def test_a_tugger_that_pulls_hard_shares_nothing() -> None:
    """Two ropes 3 m too short pull a load aside that hangs 24 m below its hook: some 400 t x 3/24 = 50 t."""
    rest = _at_rest(
        f"several_cranes_factor: {KEPT}",
        ("at: [18 m, 0 m, 30 m]", "at: [0 m, 0 m, 30 m]"),
        ("at: [18 m, 0 m, 4 m]", "at: [0 m, 0 m, 4 m]"),
        ("at: [-18 m, -5 m, 40 m]", "at: [-170 m, -5 m, 4 m]"),
        ("at: [-18 m, 5 m, 40 m]", "at: [-170 m, 5 m, 4 m]"),
        ("b1: {rope: bundle, length: as_routed", "b1: {rope: bundle, length: 149.1 m"),
        ("b2: {rope: bundle, length: as_routed", "b2: {rope: bundle, length: 149.1 m"),
    )
    assert [gauge.name for gauge in winch_gauges(rest)] == ["j1", "j2"], "they pull with more than 5 %"
    assert kept_back(rest, "H") == (1.0, [])
