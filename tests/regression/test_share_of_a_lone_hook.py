"""The share of a chart's row that one hook may carry, of a crane of which the lift file has one hook alone.

`hooks_share` was read and passed over there: a floating crane with four hooks, of which a lift uses one,
stood at 12.8 % of the 3000 t that its chart rates for all four, and not at 51 % of the quarter that one may
carry.
"""

from __future__ import annotations

import pytest

from gantline.checks import values_of
from gantline.checks.readings import hook_readings
from gantline.report.booms import boom_rows
from gantline.report.subject import Subject
from gantline.results import series
from several_cranes import HANGS, at_rest, last

RATED, SHARE, SEVERAL = 3000e3, 0.25, 1.33  # kg at 60 deg; share of one hook; factor of three cranes
_SAID = "hooks_share: 25 %, "


def test_one_of_four_hooks_has_a_quarter() -> None:
    """Hoist load x factor of three cranes over the row, and over the quarter of it."""
    recording = at_rest(HANGS)
    gravity = recording.rig.gravity
    # What slings hold is raised from 560 t to the design weight, 3 % more.
    up = [
        recording.column("rope_tension", sling.rope) * series.sling_direction(recording, sling)[:, 2]
        for sling in recording.rig.slings
        if recording.rig.hook_of(sling) == "fc.H2"
    ]
    hangs = last(recording, "hoist_load", "fc.H2") + 0.03 * float(sum(one[-1] for one in up))
    used = values_of(recording, "hoist_load_of_rating")
    assert set(used) == {"crane fc", "fc.H2", "crane c1", "crane c2"}
    # The boom stands at 60 deg in its own tackles, to what they stretch.
    assert used["crane fc"] == pytest.approx(SEVERAL * hangs / (RATED * gravity), rel=5e-3)
    assert used["fc.H2"] == pytest.approx(used["crane fc"] / SHARE, rel=1e-12)
    [reading] = [
        one for one in hook_readings(recording, series.last_sample(recording)) if one.name == "fc.H2"
    ]
    assert reading.rated == pytest.approx(SHARE * RATED * gravity, rel=5e-3)
    assert reading.used == used["fc.H2"]
    # The first page had 12.5 % of 3000 t for the crane, and a table below 68 % for its hook.
    [row] = [one for one in boom_rows(Subject(recording)) if one["name"].startswith("fc")]
    assert row["name"] == "fc.H2"
    assert float(row["may"]) == pytest.approx(SHARE * RATED / 1e3, rel=5e-3)
    assert float(row["checked"]) == pytest.approx(100 * used["fc.H2"], abs=0.05)  # as printed
    assert recording.metrics()["rating_utilisation.fc"] == pytest.approx(float(row["used"]) / 100, abs=5e-4)


def test_without_it_a_lone_hook_has_the_row() -> None:
    """Before the lift too, when its hook block and rigging hang on it and nothing is on the others."""
    for changes, rated in (((), {"crane fc", "fc.H2"}), (((_SAID, ""),), {"crane fc"})):
        assert set(values_of(at_rest(0.0, *changes), "hoist_load_of_rating")) == rated


def test_more_than_its_share_is_an_event() -> None:
    """Events looked at the whole row alone: a hook past its share was no `overload`, but a failed check."""
    # Before the lift 94 t of hook block, falls and rigging hang on it, times 1.33: 4.2 % of 3000 t.
    recording = at_rest(0.0, (_SAID, "hooks_share: 3 %, "))
    assert last(recording, "hoist_load", "fc.H2") == pytest.approx(94e3 * recording.rig.gravity, rel=0.02)
    assert [name for _, _, name in recording.events("overload")] == ["fc.H2"]
    assert [name for _, _, name in at_rest(HANGS).events("overload")] == []
