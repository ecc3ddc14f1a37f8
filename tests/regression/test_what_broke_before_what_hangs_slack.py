"""In a sea in which a sling broke, `gantline seas` said that the lift was stopped by a slack sling.

A tension that comes to nothing has no share of the least that is asked for, which counts as more than any; so
does what failed without a number, as a rope that parted, and of these the first in the table led. What broke
stood behind what hung slack by that, or was "and 9 more", in the verdict on a run too.
"""

from __future__ import annotations

from itertools import permutations

from column_in_waves import FACTOR, MASS, STRENGTH, column
from gantline.checks import Check, Verdict, foremost, governing, verdict_of
from gantline.cli.seas_table import seas_table
from gantline.results.file.saved_seas import SavedSeas
from gantline.scenario import parse_scenario
from gantline.study import run_seas
from lift_text import changed
from mechanics import G

SLACK = Check("smallest_sling_tension_when_clear", Verdict.FAILED, "", value=0.0, limit=20e3, at_least=True)
PAST = Check("load_tilt", Verdict.FAILED, "", value=0.3, limit=0.1)
BROKEN = Check("rope_parted", Verdict.FAILED, "", element="sling.S1")


def test_what_parted_leads_in_any_order() -> None:
    """20 kN over none is no number, 0.3 over 0.1 is 300 %."""
    assert SLACK.utilisation is None and BROKEN.utilisation is None
    for checks in permutations([SLACK, PAST, BROKEN]):
        assert governing(checks) is BROKEN
        assert foremost(checks)[0] is BROKEN
        assert verdict_of(checks).startswith("NO-GO: 3 failed, rope_parted, smallest_sling_")


def test_in_a_sea() -> None:
    """Half in the water a column of 981 kN weighs some 780 kN, in waves more and less: 800 kN break it.

    Its sling breaks at the force that its rope is held against, so that this by itself is just kept.
    """
    assert 780e3 < 800e3 < MASS * G
    breaks = (STRENGTH, ", minimum_breaking_force: 800 kN, breaks_at: 800 kN")
    lift = parse_scenario(changed(column(least="20 kN"), breaks, (FACTOR, "")))
    found = run_seas(lift, heights=[2.0], periods=[6.0])
    (record,) = found.seas[0].records
    assert record.failed[:2] == ("smallest_sling_tension_when_clear", "rope_parted")
    assert record.governing is not None
    assert (record.governing.name, record.governing.element) == ("rope_parted", "sling.S1")
    lines = seas_table(SavedSeas.from_json(found.to_json()), 100)
    assert any("2 m" in line and line.endswith("rope_parted sling.S1") for line in lines)
