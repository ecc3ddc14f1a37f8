"""What winches and strand jacks bear of what they are rated for, by weights and levers.

A section of 800 t hangs plumb in four strand jacks, two each way: the centre of gravity is 19 m before one
pair and 17 m behind the other, so that each jack of the near pair bears W 19/36/2. Half of each bundle is
lumped at the load, half at the jack, which has both: at its upper end hangs the bundle as it is at the start.
"""

from __future__ import annotations

import pytest

from gantline.checks.check import Verdict
from gantline.checks.run import check_recording, values_of
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from gantline.statics import Statics
from lift_text import changed
from shown import ROOT, lift_on
from tackle import TACKLE

NAME = "drum_load_of_rated_capacity"
#: Of the load [t], the levers of the pairs about its centre of gravity [m], and one bundle of 36 m [t].
LOAD, NEAR, FAR, BUNDLE = 800.0, 17.0, 19.0, 36.0 * 22.4e-3
JACKS = {
    name: LOAD * lever / (NEAR + FAR) / 2 + BUNDLE
    for name, lever in {"j1": NEAR, "j2": NEAR, "j3": FAR, "j4": FAR}.items()
}
"""What each bears [t]."""
#: The lift, with jacks for 300 t.
TEXT = lift_on(ROOT / "docs" / "guides" / "several_cranes.md", "A bridge section in four strand jacks")


def test_jacks_bear_their_share_and_their_bundles() -> None:
    """By levers: 189.7 and 211.9 t of 300 t; bundles that stretch by 0.4 % move these by less than 2 mm."""
    at_rest = Statics(parse_scenario(TEXT)).equilibrium().recording
    expected = {name: borne / 300.0 for name, borne in JACKS.items()}
    assert values_of(at_rest, NAME) == pytest.approx(expected, rel=2e-4)


def test_a_run_has_the_peak_as_the_jacks_start() -> None:
    """Starting at 5 mm/s^2 adds 0.5e-3 of what hangs, and up to twice that as the bundles ring.

    That is of the end which comes clear last; the other bears more while its load stands on the far corners.
    """
    used = values_of(simulate(parse_scenario(TEXT)), NAME)
    for name in ("j3", "j4"):
        assert 1.0 < used[name] / (JACKS[name] / 300.0) < 1.0 + 4 * 5e-3 / 9.81


def test_contingency_counts_and_more_than_rated_fails() -> None:
    """The share of the load, rigging on it included, times the contingency, and the bundle as it is.

    By hand 211.1 + 0.4 t times 1.1, and 0.4 t: 233.1 of 230 t.
    """
    text = changed(TEXT, ("calculated: 800 t", "calculated: 800 t, contingency: 1.1"), ("300 t", "230 t"))
    [check] = [
        one
        for one in check_recording(Statics(parse_scenario(text)).equilibrium().recording)
        if one.name == NAME and one.verdict is not Verdict.NOT_CHECKED
    ]
    borne = (JACKS["j3"] - BUNDLE / 2) * 1.1 + BUNDLE / 2
    assert (check.verdict, check.element) == (Verdict.FAILED, "j3")
    assert check.value == pytest.approx(borne / 230.0, rel=2e-4)


#: A winch with two ropes beside each other, one of them on another diameter, and a bight wound both ways.
RATED = "winch: {rated_capacity: 8 t, "
BIGHT = """\
    bight:
      rope: hoist
      length: 20 m
      route:
        - {type: end, body: world, at: [5 m, 0 m, 10 m], drum: winch}
        - {type: end, body: world, at: [5 m, 0 m, 0 m], drum: winch, drum_diameter: 0.56 m, wound: against}
plan:
"""


def test_a_winch_over_sheaves_has_its_lead_line() -> None:
    """Its peak is that of the last part, at which four sheaves with losses have added up as it hauls in.

    Peaks are over all steps, and the largest of samples 20 ms apart is less by what they miss.
    """
    text = changed(TACKLE, ("winch: {", RATED), ("duration: 24 s", "duration: 8 s\nstart: rest"))
    run = simulate(parse_scenario(text))
    parts = [run.column("segment_tension", f"fall/{part}") for part in range(5)]
    highest = parts[-1].argmax()
    lead = parts[-1][highest]
    assert all(part[highest] < lead / 1.02 for part in parts[:-1])
    used = values_of(run, NAME)
    assert list(used) == ["winch"]
    assert used["winch"] * 8e3 * run.rig.gravity == pytest.approx(lead, rel=1e-3)


def test_ropes_of_one_winch_are_told_apart() -> None:
    """The bight is slack: nothing of what the winch is rated for."""
    used = values_of(simulate(parse_scenario(changed(TACKLE, ("winch: {", RATED), ("plan:\n", BIGHT)))), NAME)
    assert used.keys() == {"winch/bight", "winch/fall"}
    assert used["winch/bight"] == 0.0 < used["winch/fall"]
