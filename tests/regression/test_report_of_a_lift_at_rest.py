"""Reports of lifts at rest that told what lies before that as if it had been simulated.

A recording of an equilibrium has two samples, where the lift starts and where it rests, and the last alone
counts. Checks and metrics knew that; the report of such a recording took the largest and least of both, and
what lies between on a straight line. `upending` at rest as its column stands upright had a table of hook
loads at 0, 30, 60 and 90 deg, at 500 s and 1000 s, with 0.3 t for the tail crane at 30 deg; a lift-off at
1500 s, the time that was asked for; and a tightest clearance of 0.41 m at 0 s for 0.56 m.
`crane_barge_in_swell` had slings that carry at least 96 kN when clear, for 316 kN. Metrics had those. There
were plots with a straight line from the one to the other, "curves have a sample each 0.100 s; peaks of
tension are those of all steps" below them, and equalizers that took 0.00 s to equalise, as a metric too.
"""

from __future__ import annotations

import math

import pytest

import gantline
from gantline.report.attitude import attitude
from gantline.report.booms import boom_rows
from gantline.report.carried import hook_row, sling_rows
from gantline.report.first_page import stop_if
from gantline.report.plots import HookLoads, Tensions
from gantline.report.subject import Subject
from gantline.report.tables import Energy, Equalizers
from gantline.report.turning import turnings
from gantline.results import series
from gantline.results.loads.upending import kept_plumb_in_words


@pytest.fixture(scope="module")
def upright() -> Subject:
    return Subject(gantline.Statics("upending").equilibrium().recording)


@pytest.fixture(scope="module")
def hanging() -> Subject:
    return Subject(gantline.Statics("crane_barge_in_swell").equilibrium().recording)


def test_nobody_looked_at_how_it_was_turned(upright: Subject) -> None:
    assert upright.recording.is_equilibrium and len(upright.recording.time) == 2
    assert upright.metrics["peak_load_tilt"] > math.radians(89.0)
    assert turnings(upright) == [] and kept_plumb_in_words(upright.recording) == []
    # How far it is turned it tells all the same.
    assert any("hangs still at up to 90.0 deg" in line for line in stop_if(upright))


def test_nothing_lifts_off_and_comes_near_where_it_starts(upright: Subject) -> None:
    rows = dict(attitude(upright))
    nearest = upright.metrics["smallest_clearance.slings - column"]
    start = upright.recording.column("clearance", "slings - column")[0]
    assert "lift-off" not in rows and start < nearest - 0.1
    assert rows["tightest clearance"].startswith(f"slings - column {nearest:.3f} m, ")


def test_cranes_stand_as_they_do_at_rest(upright: Subject, hanging: Subject) -> None:
    """One radius and no range of them, pressures under tracks and heights of hooks then."""
    for subject in (upright, hanging):
        recording = subject.recording
        for row, boom in zip(boom_rows(subject), subject.rig.booms, strict=True):
            (radius,) = (recording.column("crane_radius", hook.name)[-1] for hook in boom.hooks)
            assert row["radius"] == f"{radius:.1f}"
        for hook in subject.rig.hooks:
            assert (
                hook_row(subject, hook)["highest"] == f"{recording.column('hook_height', hook.name)[-1]:.2f}"
            )
    pressures = {row["name"]: row["pressure"] for row in boom_rows(upright)}
    for crane in upright.rig.crawlers:
        pressure = upright.metrics[f"peak_ground_pressure.{crane.name}"]
        assert pressures[crane.name] == f"{pressure / 1e3:.0f}"


def test_slings_carry_at_least_what_they_carry_at_rest(hanging: Subject) -> None:
    """All four carry 316 kN; two of them 96 kN where the lift starts."""
    tension = {row["name"]: row for row in sling_rows(hanging, 9)[0]}
    for sling in hanging.rig.slings:
        last = series.sling_tension(hanging.recording, sling)[-1]
        assert tension[sling.name]["least"] == f"{last / 1e3:.0f}" == tension[sling.name]["static"]
    least = hanging.metrics["least_sling_tension_when_clear"]
    starts = min(series.sling_tension(hanging.recording, one)[0] for one in hanging.rig.slings)
    assert starts < 0.5 * least
    angles = [float(row["angle"]) for row in tension.values()]
    assert max(angles) == pytest.approx(
        math.degrees(hanging.metrics["peak_sling_angle_from_vertical"]), abs=0.05
    )


def test_nothing_is_told_of_the_way_there(hanging: Subject) -> None:
    assert Tensions().content(hanging) is None and HookLoads().content(hanging) is None
    assert not any("curves" in one or "step" in one for one in Energy().content(hanging)["sentences"])


def test_a_lift_at_rest_took_no_time_to_equalise() -> None:
    """Metrics and table of an equalizer whose slings hang within the bound."""
    rest = Subject(gantline.Statics("equalizer").equilibrium().recording)
    assert 0.0 < rest.metrics["final_tension_spread"] < rest.rig.equalised_below
    assert not any(name.startswith("time_to_equalise") for name in rest.metrics)
    content = Equalizers().content(rest)
    assert content is not None
    assert "time to equalise" not in dict(content["equalizers"][0]["facts"])
