"""Two meanings of static in one table.

A tailing crane held 982 kN until the column stood. At the end it held 597 kN, and that was what the table of
the run and the first page of the report showed as static, beside a dynamic factor of 1.004 and a peak of
986 kN, both of the 982 kN that the checks use. Who reads the column for the size of the tailing crane takes
one that is too small by two fifths.
"""

from __future__ import annotations

import pytest

import gantline
from four_slings import HANDED_OVER
from gantline.checks import check_recording
from gantline.cli.summary import summary
from gantline.report.carried import hook_row, sling_rows
from gantline.report.subject import Subject
from gantline.scenario import parse_scenario

#: A sling of 44 mm [t/m]: 0.409 kg/m for each 100 mm^2 of d^2, EN 12385-4, 6x36 with steel core.
ROPE = 0.409 * 44.0**2 / 100.0 / 1e3
#: 40 t, the four slings of the first hook, and the lower halves of the others [kN].
WEIGHT = (40.0 + 4 * 8.6 * ROPE + 4 * 8.7 * ROPE / 2.0) * 9.81


@pytest.fixture(scope="module")
def subject() -> Subject:
    return Subject(gantline.simulate(parse_scenario(HANDED_OVER)))


def test_the_table_shows_what_the_checks_use(subject: Subject) -> None:
    """The first hook has handed the load over; what it held still stands in its row, and in its sling's."""
    recording = subject.recording
    assert recording.column("hook_load", "crane")[-1] < 0.02 * WEIGHT * 1e3
    lines = summary(recording, check_recording(recording), str)
    hook = next(line.split() for line in lines if line.split()[:3] == ["crane", "hook", "load"])
    static, peak, factor = float(hook[3]), float(hook[5]), float(hook[-3])
    assert static == pytest.approx(WEIGHT, rel=1e-3)
    assert factor == pytest.approx(peak / static, abs=1e-3)
    sling = next(line.split() for line in lines if line.startswith("  A "))
    assert 4.0 * float(sling[1]) > 40.0 * 9.81  # four of them, off plumb


def test_so_does_the_report(subject: Subject) -> None:
    recording = subject.recording
    hook = next(one for one in recording.rig.hooks if one.name == "crane")
    # In t, to the 0.1 t to which a report rounds.
    assert float(hook_row(subject, hook)["static"]) == pytest.approx(WEIGHT / 9.81, abs=0.06)
    sling = next(one for one in sling_rows(subject, 8)[0] if one["name"] == "A")
    assert 4.0 * float(sling["static"]) > 40.0 * 9.81
