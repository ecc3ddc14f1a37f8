"""What a recording says of ropes that parted and of stops that were met."""

from __future__ import annotations

import numpy as np
import pytest

from gantline.checks import Verdict, check_recording, has_failed
from gantline.cli.summary import summary
from gantline.results.recording import Recording
from gantline.results.ropes.parting import Met, partings, stops_met
from of_recording import checks_of
from sample_lift import ringing_lift, sample_rig

CUT = (12.5, "cut", "sling.S2")


def lift(*events: tuple[float, str, str], **rig: object) -> Recording:
    return ringing_lift(events=list(events), rig=sample_rig(**rig))


def test_nothing_parted() -> None:
    recording = lift()
    assert partings(recording) == []
    assert stops_met(recording.events()) == []
    assert not [name for name in recording.metrics() if name.startswith("part")]
    assert not any(line.startswith("Parted") for line in table_of(recording))


def table_of(recording: Recording) -> list[str]:
    return summary(recording, check_recording(recording), lambda verdict: f"  {verdict.value:<11}")


def test_a_cut_rope_and_what_it_carried_just_before() -> None:
    """At 12.5 s there is a sample: 606 kN, the ringing is at zero; between samples the one before counts."""
    [parting] = partings(lift(CUT))
    assert (parting.rope, parting.kind, parting.time) == ("sling.S2", "cut", 12.5)
    assert parting.tension == pytest.approx(606e3)
    [between] = partings(lift((12.515, "cut", "sling.S1")))
    assert between.tension == pytest.approx(600e3 + 100e3 * np.sin(2 * np.pi * 12.5), abs=1.0)


def test_a_broken_rope_carried_its_breaking_force() -> None:
    rig = sample_rig()
    rig["ropes"][1]["breaks_at"] = 650e3
    [parting] = partings(ringing_lift(events=[(12.515, "broken", "sling.S1")], rig=rig))
    assert (parting.kind, parting.tension) == ("broken", 650e3)


def test_a_rope_parts_once() -> None:
    assert [one.time for one in partings(lift(CUT, (13.0, "broken", "sling.S2")))] == [12.5]


def test_metrics_checks_and_table() -> None:
    recording = lift(CUT)
    metrics = recording.metrics()
    assert metrics["parted_ropes"] == 1
    assert metrics["parting_time.sling.S2"] == 12.5
    assert metrics["parting_tension.sling.S2"] == pytest.approx(606e3)
    [check] = checks_of(recording, "rope_parted")
    assert (check.verdict, check.element, check.time) == (
        Verdict.FAILED,
        "sling.S2",
        12.5,
    )
    others = "after that sling.S1 has most, 699.8 kN, 23 % of its minimum breaking force"
    assert check.remark == f"cut, it carried 606.0 kN; {others}"
    assert has_failed([check])
    found = next(line for line in table_of(recording) if line.startswith("  sling.S2"))
    assert found.split() == ["sling.S2", "cut", "12.500", "s", "606.0", "kN", "19.9", "%"]


def test_stops_that_were_met() -> None:
    hits = [(3.0, "stop_hit", "e1.1"), (3.1, "stop_left", "e1.1"), (4.0, "stop_hit", "e1.1")]
    other = (5.0, "stop_hit", "e1.4")
    recording = lift(*hits, other, equalizer_travel_used=0.9)
    assert stops_met(recording.events()) == [Met("e1.1", 3.0, 2), Met("e1.4", 5.0, 1)]
    [check] = checks_of(recording, "equalizer_travel_used")
    assert (check.verdict, check.remark) == (
        Verdict.WARNING,
        "e1.1 met its stop at 3.00 s, e1.4 met its stop at 5.00 s",
    )
    rows = [" ".join(line.split()) for line in table_of(recording) if line.startswith("  stop met")]
    assert rows == ["stop met e1.1 at 3.00 s, 2 times in all", "stop met e1.4 at 5.00 s"]
