"""Distances that are watched and supports, in results and checks, on numbers that are given."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from gantline.checks.contacts import clearance_margin, of_capacity
from gantline.checks.measure import Finding, Found, Missing
from gantline.report.attitude import attitude
from gantline.report.subject import Subject
from gantline.results import series
from gantline.results.loads.clearances import clearance_events, contact_warnings
from gantline.results.loads.contact_peaks import contact_peak
from gantline.results.recording import Recording
from gantline.results.rig import Rig
from gantline.results.variable import FloatArray, Variable

TIME = np.arange(6.0)
#: A wall that is 2 m away at least but for the time between, and a rope that touches the load at 3 s.
DISTANCE = np.array([[4.0, 0.5], [3.0, 0.4], [1.0, 0.3], [1.5, 0.0], [2.5, 0.2], [4.0, np.inf]])
FORCE = np.array([[80e3, 10e3], [90e3, 20e3], [120e3, 0.0], [0.0, 0.0], [0.0, 0.0], [0.0, 0.0]])
RIG: dict[str, Any] = {
    "watches": [
        {"name": "hull - wall", "between": ["hull", "wall"], "smallest": 2.0},
        {"name": "slings - hull", "between": ["slings", "hull"]},
    ],
    "supports": [
        {"name": "support.keel.1", "group": "keel", "load": "hull", "capacity": 100e3},
        {"name": "support.keel.2", "group": "keel", "load": "hull"},
    ],
}
NAMES = {
    "pair": ["hull - wall", "slings - hull"],
    "contact": ["support.keel.1", "support.keel.2"],
    "event_kind": ["step_begin", "support_removed", "off_support"],
    "event_name": ["hoist", "support.keel.1", "support.keel.2"],
}


def columns() -> dict[str, FloatArray]:
    events = np.array([0.0, 2.5, 2.75])
    return {"time": TIME, "clearance": DISTANCE, "contact_force": FORCE, "event_time": events}


def recording() -> Recording:
    variables = {
        "time": Variable(("time",), TIME, "s", ""),
        "clearance": Variable(("time", "pair"), DISTANCE, "m", ""),
        "contact_force": Variable(("time", "contact"), FORCE, "N", ""),
    }
    coordinates = {"pair": NAMES["pair"], "contact": NAMES["contact"]}
    return Recording(variables, coordinates, {"rig": RIG})


def test_events_are_where_a_distance_goes_through_its_limit() -> None:
    """3 m to 1 m within a second passes 2 m after half of it; 1.5 m to 2.5 m too."""
    found, names = clearance_events(Rig.from_json(RIG), columns(), dict(NAMES))
    events = list(zip(found["event_time"], names["event_kind"], names["event_name"], strict=True))
    assert events == [
        (0.0, "step_begin", "hoist"),
        (1.5, "too_close", "hull - wall"),
        (2.5, "support_removed", "support.keel.1"),
        (2.75, "off_support", "support.keel.2"),
        (3.0, "too_close", "slings - hull"),
        (3.0, "clear_again", "slings - hull"),
        (3.5, "clear_again", "hull - wall"),
    ]


def test_a_pair_that_starts_too_close_is_so_at_the_start() -> None:
    rig = Rig.from_json({"watches": [{"name": "hull - wall", "between": ["hull", "wall"], "smallest": 5.0}]})
    found, names = clearance_events(rig, columns(), dict(NAMES))
    assert (found["event_time"][1], names["event_kind"][1]) == (0.0, "too_close")
    assert names["event_kind"].count("clear_again") == 0


def test_nothing_changes_where_nothing_is_watched() -> None:
    given, names = columns(), dict(NAMES)
    assert clearance_events(Rig(), given, names) == (given, names)


def test_warnings_say_how_close_and_when() -> None:
    assert contact_warnings(Rig.from_json(RIG), columns(), NAMES) == [
        "hull comes within 1.00 m of wall at 2.00 s, below 2 m from 2.00 s on",
        "slings and hull touch, for the first time at 3.00 s",
        "support.keel.1 is taken away at 2.50 s under 120 kN",
        "the load leaves support.keel.2 beyond its edge at 2.75 s",
    ]


def at_samples(found: Finding) -> Finding:
    """What was found, without what it may have been between samples."""
    return replace(found, between=None) if isinstance(found, Found) else found


def test_checks_hold_supports_against_capacity_and_pairs_against_their_distance() -> None:
    given = recording()
    found = list(of_capacity(given, series.everywhere(given)))
    assert [at_samples(one) for one in found] == [
        Found(1.2, "support.keel.1", 2.0, "120.0 kN / 100.0 kN"),
        Missing("support.keel.2", "no capacity"),
    ]
    margins = clearance_margin(given, series.everywhere(given))
    assert [at_samples(one) for one in margins] == [
        Found(-1.0, "hull - wall", 2.0, "1.000 m - 2 m"),
        Found(0.0, "slings - hull", 3.0, "0.000 m - 0 m"),
    ]


def test_the_first_page_names_the_pair_that_is_nearest_to_what_it_has_to_keep() -> None:
    """The slings come to 0 m and need not keep any; the hull comes to 1 m and has to keep 2 m."""
    (row,) = [text for name, text in attitude(Subject(recording())) if name == "tightest clearance"]
    assert row == "hull - wall 1.00 m, at least 2 m, at 2.0 s"


def test_peaks_and_metrics() -> None:
    given = recording()
    assert contact_peak(given, "support.keel.1") == (120e3, 2.0)
    metrics = given.metrics()
    assert metrics["peak_support_force"] == 120e3
    assert metrics["peak_support_force.support.keel.2"] == pytest.approx(20e3)
    assert metrics["smallest_clearance.hull - wall"] == 1.0


def test_a_pair_counts_between_its_steps() -> None:
    """Close from 1.5 s to 3.5 s; watched from 2 s to 3 s it is so as its step begins, and stays so."""
    watch = {"name": "hull - wall", "between": ["hull", "wall"], "smallest": 2.0, "from_step": "over"}
    names = {**NAMES, "event_kind": ["step_begin", "step_end"], "event_name": ["over", "over"]}
    given = {**columns(), "event_time": np.array([2.0, 3.0])}
    rig = Rig.from_json({"watches": [{**watch, "to_step": "over"}]})
    found, told = clearance_events(rig, given, names)
    assert [(time, kind) for time, kind in zip(found["event_time"], told["event_kind"], strict=True)] == [
        (2.0, "step_begin"),
        (2.0, "too_close"),
        (3.0, "step_end"),
    ]
    assert contact_warnings(rig, given, names) == [
        "hull comes within 1.00 m of wall at 2.00 s, below 2 m from 2.00 s on"
    ]
    not_begun = Rig.from_json({"watches": [{**watch, "from_step": "later"}]})
    assert clearance_events(not_begun, given, names) == (given, names)
    assert contact_warnings(not_begun, given, names) == []
