"""A vessel that nothing holds turns and drifts in waves, whose forces stayed those of where it was first.

In a sea of 1 m a barge of 100 m turned by 14° in 40 minutes and by 81° in 67; the moment that had pitched it
rolled it by 19°, and after 91 minutes it capsized. Nothing said why. Forces follow its slow place and heading
now; what they do not follow is told.
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import waves
from afloat import LENGTH
from gantline.assembly import assemble
from gantline.results.afloat.unfollowed import unfollowed
from gantline.results.rotation import heading
from gantline.scenario import load_scenario
from gantline.simulation import simulate
from mechanics import adaptive

PERIOD = 8.0
OMEGA = 2 * math.pi / PERIOD
SWELL = {"height": "10 cm", "period": f"{PERIOD} s", "direction": "90 deg"}
#: Of deep water, g/ω [m/s].
SPEED = waves.G / OMEGA
#: How far slow places are behind an acceleration of one, 10/(0.2 ω)² [s^2].
BEHIND = 10 / (0.2 * OMEGA) ** 2


def said_of(
    folder: Path,
    speed: float = 0.0,
    acceleration: float = 0.0,
    turning: float = 0.0,
    begins: float = 0.0,
    lasts: float = 200.0,
    **changes: Any,
) -> list[str]:
    """What is said of 200 s from 5 s on in which the point of the forces goes across [m/s] and from there
    ever faster [m/s^2], and the barge turns ever faster [rad/s^2], while it surges and yaws in each wave.
    What grows faster begins so many seconds later.
    """
    path = waves.in_waves(folder, {"swell": SWELL}, {"heading": "20 deg"})
    document: dict[str, Any] = assemble(load_scenario(path)).document
    force = document["forces"][-1]
    force |= changes
    # A wave half as long in time, of 1 µm, has no energy; means are over the slowest.
    (wave,) = document["sea"]["components"]
    document["sea"]["components"].append({**wave, "frequency": 2.0 * OMEGA, "amplitude": 1e-6})
    # Off the point of the forces: what turns moves its centre, and not that point.
    document["bodies"][0]["centre_of_gravity"] = [38.0, 1.0, 5.0]
    time = np.linspace(0.0, 200.0, 801)
    grown = np.maximum(time - begins, 0.0) ** 2 / 2
    by = math.radians(20.0) + turning * grown + 0.05 * np.sin(OMEGA * time)
    along, across = 0.7 * np.cos(OMEGA * time), speed * time + acceleration * grown
    arm = (np.array(force["origin"]) - np.array(document["bodies"][0]["centre_of_gravity"]))[:2]
    shift = np.array([np.cos(by) * arm[0] - np.sin(by) * arm[1], np.sin(by) * arm[0] + np.cos(by) * arm[1]])
    place = np.column_stack([along - shift[0], across - shift[1], np.zeros_like(time)])
    none = np.zeros_like(time)
    turns = np.column_stack([np.cos(by / 2), none, none, np.sin(by / 2)])
    columns = {"time": 5.0 + time, "body_position": place[:, None], "body_orientation": turns[:, None]}
    kept = {name: values[time <= lasts] for name, values in columns.items()}
    return unfollowed(document, kept, {"body": ["barge"]})


def test_what_is_not_followed_is_told(tmp_path: Path) -> None:
    """A tenth of the speed of the waves; turns and ways that gather speed so fast that the slow heading is
    10° behind and the slow place a quarter of a wave; directions that the file has not.
    """
    assert said_of(tmp_path, 0.099 * SPEED) == []
    (fast,) = said_of(tmp_path, -0.101 * SPEED)
    assert f"barge: from 13 s on it moves at up to {0.101 * SPEED:.2g} m/s, more than a tenth as fast" in fast
    # Of less than three waves nothing is said.
    assert said_of(tmp_path, -0.2 * SPEED, lasts=23.9) == []
    assert len(said_of(tmp_path, -0.2 * SPEED, lasts=24.5)) == 1
    most = math.radians(10.0) / BEHIND
    assert said_of(tmp_path, turning=0.98 * most) == []
    (turns,) = said_of(tmp_path, turning=-1.02 * most)
    assert "turns so fast that they feel a heading up to 10 deg behind" in turns
    # The largest is told, and since when: three means over 8 s, 8 s apart, reach 12 s to either side.
    (later,) = said_of(tmp_path, turning=-1.02 * most, begins=92.0)
    assert later == turns.replace("from 17 s", "from 109 s")
    quarter = math.pi / 2 * SPEED / OMEGA / BEHIND
    assert not any("gathers way" in text for text in said_of(tmp_path, acceleration=0.98 * quarter))
    both = said_of(tmp_path, acceleration=1.02 * quarter)
    assert any("gathers way so fast that they feel a place up to 25 m behind" in text for text in both)
    # Ways over 8 s have their middle at 188 s at last.
    assert f"moves at up to {1.02 * quarter * 188.0:.2g} m/s" in both[0]
    later = said_of(tmp_path, acceleration=1.02 * quarter, begins=92.0)[-1]
    assert "from 109 s on it gathers way so fast that they feel a place up to 25 m behind" in later
    # Waves run 70° from the bow; the barge turns by 26°, so that they run 44° from it in the end.
    known = {"directions": np.radians([0.0, 50.0, 100.0, 160.0, 220.0, 280.0, 340.0]).tolist()}
    assert said_of(tmp_path, turning=0.5 * most, **known) == []
    known["directions"] = np.radians([-61.0, -11.0, 50.0, 100.0, 160.0, 220.0, 270.0]).tolist()
    (unknown,) = said_of(tmp_path, turning=0.5 * most, **known)
    assert "turns to where their file has no waves, in a gap of more than 60 deg" in unknown
    # From 320° on to the first one is a gap, too.
    known["directions"] = np.radians([50.0, 110.0, 160.0, 220.0, 270.0, 320.0]).tolist()
    assert said_of(tmp_path, turning=0.5 * most, **known) == [unknown]


def test_a_run_that_stays_says_nothing(tmp_path: Path) -> None:
    """Waves of 10 cm for 30 s move the barge by centimetres."""
    path = waves.in_waves(tmp_path, {"swell": SWELL}, {"heading": "20 deg"}, duration="30 s")
    assert not any(" s on it " in text for text in simulate(path).attributes["warnings"])


def steady(path: Path, turn: float = 0.0) -> tuple[float, Any]:
    """Heading [rad] and complex amplitudes of the barge in the end, sent turning at the start [rad]."""
    document: dict[str, Any] = assemble(load_scenario(path)).document
    yaw = document["bodies"][0]["mass"] * waves.RADII[2] ** 2 + waves.ADDED[5, 5]
    rate = turn * waves.DAMPING[5, 5] / yaw
    joint = document["bodies"][0]["joint"]
    if turn:
        joint["velocity"], joint["angular_velocity"] = [0.0, -rate * LENGTH / 2, 0.0], [0.0, 0.0, rate]
    run = adaptive(document, 270.0, tension_tolerance=0.1, sample_interval=0.25)
    orientation = run.body("barge", "body_orientation")
    lies = float(np.unwrap(heading(orientation[run.time > 180.0])).mean())
    return lies, waves.amplitudes(run.time, run.body("barge"), orientation, 2 * math.pi / 9.0, lies)


@pytest.mark.parametrize("turn", [60.0, -75.0])
def test_a_barge_that_turns_is_not_rolled_by_what_pitched_it(tmp_path: Path, turn: float) -> None:
    """The barge in waves of 1 m from ahead, sent turning until they come from its side, rolls and pitches as
    one that has lain there, which itself turns by a quarter of a degree: 3 % of an amplitude in a degree.
    With the moments that pitched it, it capsized within a minute.
    """
    swell = {"height": "1 m", "period": "9 s", "direction": "180 deg"}
    lies, found = steady(waves.in_waves(tmp_path, {"swell": swell}), math.radians(turn))
    # It has turned about as far as it was sent: what follows is against a barge at the heading that it has.
    assert math.degrees(lies) == pytest.approx(turn, rel=0.05)
    there = {"heading": f"{math.degrees(lies)} deg"}
    _, expected = steady(waves.in_waves(tmp_path, {"swell": swell}, there))
    # A quarter of a degree is 0.8 % of the larger amplitude.
    assert np.abs(found[3:5]) == pytest.approx(np.abs(expected[3:5]), abs=0.01 * np.abs(expected[3]))
