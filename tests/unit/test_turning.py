"""Hook loads at given tilts of a load that is turned: what is read of recordings, and the first page."""

from __future__ import annotations

import numpy as np
import pytest

import gantline
from gantline.report import render_report
from gantline.report.subject import Subject
from gantline.report.turning import turnings
from gantline.results import Recording
from gantline.results.loads.turning import AtTilt, at_tilts
from gantline.scenario import parse_scenario
from lift_text import changed
from mechanics import G
from sample_lift import WEIGHT, ringing_lift
from upending import between_trolleys, upended

#: Of the column between two trolleys: from lug `a` to its centre of gravity, along and down, and
#: along to lug `b` [m]; its weight and the strength of its slings [N].
ALONG, BELOW, LINE, COLUMN, STRENGTH = 10.5, 1.0, 19.0, 100e3 * G, 1500e3


@pytest.fixture(scope="module")
def column() -> Recording:
    """Hook A hoists by 18.6 m what is 19 m long, to a tilt of asin(18.6/19) = 78.2 deg."""
    lift = changed(
        between_trolleys(upended(18.6), duration=330.0),
        ("centre_of_gravity: {at: [0 m, 0 m, 1.5 m]}", "centre_of_gravity: {at: [1 m, 0 m, 0.5 m]}"),
        ("10 ms, mass: none}", "10 ms, mass: none, minimum_breaking_force: 1500 kN}"),
    )
    return gantline.simulate(parse_scenario(lift))


def test_hooks_share_a_turned_load_by_the_moments_of_its_weight(column: Recording) -> None:
    """Plumb falls: B carries W (a cos t - h sin t)/(l cos t) = W (a - h tan t)/l at the tilt t, A the rest.

    While the hoist goes on the column rings by a few thousandths; before it begins it hangs still.
    """
    states = at_tilts(column, column.rig.loads[0])
    assert [round(np.degrees(state.tilt)) for state in states] == [0, 30, 60, 78]
    for state in states:
        by_b = (ALONG - BELOW * np.tan(state.tilt)) / LINE
        loads = [state.hook_loads[name] / COLUMN for name in ("gol.A", "gol.B")]
        assert loads == pytest.approx([1.0 - by_b, by_b], abs=1e-4 if state is states[0] else 4e-3)
        # B bears more until a - h tan t is half of l, at 45 deg.
        assert state.sling == ("S2" if by_b > 0.5 else "S1")
        assert state.tension == pytest.approx(max(loads) * COLUMN, rel=1e-3)
        assert state.of_breaking_force == pytest.approx(state.tension / STRENGTH, rel=1e-12)
        assert state.supported == 0.0
    assert [state.sling for state in states] == ["S2", "S2", "S1", "S1"]


@pytest.mark.usefixtures("player")
def test_the_first_page_has_them_in_tonnes_as_all_readings_of_hooks(column: Recording) -> None:
    (table,) = turnings(Subject(column))
    assert (table["load"], table["hooks"], table["is_supported"]) == ("column", ["gol.A", "gol.B"], False)
    level = table["rows"][0]
    share = ALONG / LINE
    assert level["hook_loads"] == [f"{100.0 * (1.0 - share):.1f}", f"{100.0 * share:.1f}"]
    used = 100.0 * share * COLUMN / STRENGTH
    assert (level["tilt"], level["sling"], level["used"]) == ("0.0", "S2", f"{used:.0f}")
    html = render_report(column)
    assert "Turning of column" in html and "gol.B <i>t</i>" in html


def turned(*course: tuple[float, float], **given: object) -> list[AtTilt]:
    """What is read of the sample lift, tilted on lines between times [s] and angles [deg]."""
    time = np.linspace(0.0, 40.0, 2001)
    when, angles = np.array(course).T
    recording = ringing_lift(tilt=np.radians(np.interp(time, when, angles)), **given)
    return at_tilts(recording, recording.rig.loads[0])


@pytest.mark.parametrize(
    ("course", "found"),
    [
        # 4 deg/s from 21 s on; one step begins at 20 s and ends at 40 s.
        ([(21.0, 0.0), (39.5, 74.0)], [(20.0, 0.0), (28.5, 30.0), (36.0, 60.0), (40.0, 74.0)]),
        # From 15 s on, in the middle of a step: the last moment within 0.5 deg of the start.
        ([(15.0, 0.0), (35.0, 80.0)], [(15.12, 0.48), (22.5, 30.0), (30.0, 60.0), (40.0, 80.0)]),
        # Another step ends at 20 s.
        ([(12.0, 0.0), (19.0, 56.0)], [(12.06, 0.48), (15.75, 30.0), (20.0, 56.0)]),
        # Not 5 deg past an angle: that has been read.
        ([(15.0, 0.0), (31.0, 64.0)], [(15.12, 0.48), (22.5, 30.0), (30.0, 60.0)]),
        # Laid down.
        ([(15.0, 90.0), (35.0, 10.0)], [(15.12, 89.52), (22.5, 60.0), (30.0, 30.0), (40.0, 10.0)]),
        # To and fro: the first time that an angle is passed, the first moment within 0.5 deg of the largest.
        (
            [(15.0, 0.0), (25.0, 40.0), (30.0, 20.0), (35.0, 38.0)],
            [(15.12, 0.48), (22.5, 30.0), (24.88, 39.52)],
        ),
        # Not turned, or turned before it hung: nothing passes.
        ([(15.0, 0.0), (35.0, 28.0)], []),
        ([(0.0, 40.0), (35.0, 50.0)], []),
    ],
)
def test_when_tilts_are_passed(course: list[tuple[float, float]], found: list[tuple[float, float]]) -> None:
    read = [(state.time, np.degrees(state.tilt)) for state in turned(*course)]
    assert [value for one in read for value in one] == pytest.approx(
        [value for one in found for value in one], abs=1e-6
    )


def test_a_load_turned_about_its_foot_stands_on_supports_meanwhile() -> None:
    """It comes clear at 10 s, tilted by 32 deg; supports bear all of it until then. A step ends at 40 s."""
    states = turned((2.0, 0.0), (22.0, 80.0))
    assert [np.degrees(state.tilt) for state in states] == pytest.approx([0.48, 30.0, 60.0, 80.0])
    assert [state.supported for state in states] == pytest.approx([WEIGHT, WEIGHT, 0.0, 0.0])
