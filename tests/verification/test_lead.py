"""Steps that lead a load: hooks on line and circle to rounding, what drives do, what swings, shares."""

from __future__ import annotations

import math
from functools import cache

import numpy as np
import pytest

import gantline
from gantline.results.progress import spans
from gantline.results.recording import Recording
from gantline.results.variable import FloatArray
from gantline.scenario import parse_scenario
from gantline.simulation import Simulation
from led_pair import AHEAD, AXES, BEAM, BOOM, LED, led_text
from mechanics import G

#: Methods, each by its settings.
METHODS = ["", ", integrator: del, step: 10 ms"]
#: A quarter turn in which each hook goes round the middle between both at 12 m.
TURNED = "{step: round, lead: [a.H, b.H], turn: 40 deg, speed: 6 m/min, acceleration: 0.02 m/s^2}"
#: Rounding of places some 20 m from the origin, by angles that come from series of a dozen terms [m].
ROUNDING = 2e-12


@cache
def run(text: str) -> Recording:
    return gantline.simulate(parse_scenario(text))


def heads(recording: Recording, crane: str) -> tuple[FloatArray, FloatArray]:
    """Where a boom head is from above by its recorded angles (LD3), x and y [m]."""
    angle, slew = recording.column("boom_angle", crane), recording.column("slew_angle", crane)
    radius = AHEAD + BOOM * np.cos(angle)
    x, y = AXES["ab".index(crane)]
    return x + radius * np.cos(slew), y + radius * np.sin(slew)


def share_at(recording: Recording, length: float, speed: float, acceleration: float) -> FloatArray:
    """Share of a way that has been gone by the closed form of its ramps (P1), from time 0."""
    ramp = speed / acceleration
    total = length / speed + ramp
    time = np.clip(recording.time, 0.0, total)
    left = total - time
    gone = np.where(
        time < ramp,
        acceleration * time**2 / 2,
        np.where(left < ramp, length - acceleration * left**2 / 2, speed * (time - ramp / 2)),
    )
    share: FloatArray = gone / length
    return share


@pytest.mark.parametrize("settings", METHODS, ids=["adaptive", "del"])
def test_heads_go_along_a_line(settings: str) -> None:
    """(LD1) without a turn: both heads at p + sigma b all along, sigma by ramps, exact but for rounding."""
    recording = run(led_text(settings=settings))
    share = share_at(recording, math.hypot(3.0, 5.0, 2.0), 0.1, 0.02)
    for crane, (x, _) in zip("ab", AXES, strict=True):
        east, north = heads(recording, crane)
        assert east == pytest.approx(x + 3.0 * share, abs=ROUNDING)
        assert north == pytest.approx(17.0 + 5.0 * share, abs=ROUNDING)


@pytest.mark.parametrize("settings", METHODS, ids=["adaptive", "del"])
def test_heads_go_round_a_circle(settings: str) -> None:
    """(LD1) with a turn alone: both heads on the circle of 12 m about (0, 17 m), 24 m apart all along."""
    recording = run(led_text(TURNED, settings=settings))
    angle = math.radians(40.0)
    turned = angle * share_at(recording, 12.0 * angle, 0.1, 0.02)
    for crane, side in (("a", -12.0), ("b", 12.0)):
        east, north = heads(recording, crane)
        assert east == pytest.approx(side * np.cos(turned), abs=ROUNDING)
        assert north == pytest.approx(17.0 + side * np.sin(turned), abs=ROUNDING)
    # The beam goes along: its heading is that of the line between the hooks, but for what it swings.
    assert recording.metrics()["peak_load_yaw"] == pytest.approx(angle, abs=math.radians(0.2))


@pytest.mark.parametrize("settings", METHODS, ids=["adaptive", "del"])
def test_the_hook_goes_up_as_the_way_does(settings: str) -> None:
    """(LD6): the hook's height rises by 2 sigma, whatever the boom head does; the boom goes out 7 m lower.

    Falls that lean by b shorten by L b^2/2 of up to 17 m; stretch changes by what swings, a share of b^2/2 of
    0.1 mm.
    """
    recording = run(led_text(settings=settings))
    share = share_at(recording, math.hypot(3.0, 5.0, 2.0), 0.1, 0.02)
    for crane in "ab":
        height = recording.column("hook_height", f"{crane}.H")
        lean = recording.column("falls_out_of_plumb", f"{crane}.H").max()
        assert height - height[0] == pytest.approx(2.0 * share, abs=17.0 * lean**2 / 2 + 1e-5)
        head = BOOM * (np.sin(recording.column("boom_angle", crane)) - math.sin(math.radians(60.0)))
        assert head[-1] < -3.0


def test_velocities_and_accelerations_are_those_of_the_way() -> None:
    """(LD7) amid the way, where sigma goes evenly: slew and boom by differences of (LD4), to their square.

    Recorded 0.2 s apart: central differences of the recording itself against those of the closed form.
    """
    recording = run(led_text())
    share = share_at(recording, math.hypot(3.0, 5.0, 2.0), 0.1, 0.02)
    east, north = 3.0 * share, 17.0 + 5.0 * share
    slew = np.arctan2(north, east)
    boom = np.arccos((np.hypot(east, north) - AHEAD) / BOOM)
    for variable, wanted in (("slew_angle", slew), ("boom_angle", boom)):
        found = recording.column(variable, "a")
        for order in (1, 2):
            rates = np.diff(found, order), np.diff(wanted, order)
            assert rates[0] == pytest.approx(rates[1], abs=1e-13)


def test_the_load_swings_no_more_than_a_pendulum() -> None:
    """(LD8): 2 a/g as it accelerates and cruises, 4 a/g in all, on a way along the beam, which stays level.

    It comes to 2 a/g within half a percent, as a pendulum does whose ramp lasts more than half of its period
    of 8 s; hook blocks are 4 % of the mass. Across it rocks about its lugs as well, as three pendulums.
    """
    lean = 0.02 / G
    for by, most in (("[8 m, 0 m, 0 m]", 2.0), ("[0 m, 6 m, 0 m]", 2.0 * 1.2)):
        recording = run(led_text(LED.replace("[3 m, 5 m, 2 m]", by)))
        end = spans(recording)["over"][1]
        cruises = recording.time < end - 5.0
        for crane in "ab":
            falls = recording.column("falls_out_of_plumb", f"{crane}.H")
            assert 1.99 * lean < falls[cruises].max() < most * lean
            assert falls.max() < 4.0 * lean


@pytest.mark.parametrize("aside", [0.0, 3.0])
def test_shares_stay_on_a_level_way(aside: float) -> None:
    """(LD9): W (w - x)/w and W x/w with w = 24 m before and after, and in the mean over the way.

    Stretch of 0.2 TN tilts the beam by a micron; what swings changes a share by lever times lean, of the
    hooks' height over the centre of gravity: 8 m of 24 m and 0.0015 rad along the beam. Whole rides go by.
    """
    level = LED.replace("2 m]", "0 m]")
    recording = run(led_text(level, aside=aside, duration=120.0))
    shares = [recording.column("hook_load", f"{crane}.H") for crane in "ab"]
    wanted = BEAM * G * np.array([(12.0 - aside) / 24.0, (12.0 + aside) / 24.0])
    for share, value in zip(shares, wanted, strict=True):
        # Slings have no mass, and so have shackles: there are none.
        assert share[0] == pytest.approx(value, rel=1e-6)
        assert share == pytest.approx(value, rel=8.0 / 24.0 * 0.0015 * 4)
        assert share.mean() == pytest.approx(value, rel=2e-4)


def test_ways_follow_one_another() -> None:
    """There and back, and the second begins where the first ended: cranes stand as they did at the start."""
    back = LED.replace("over", "back").replace("[3 m, 5 m, 2 m]", "[-3 m, -5 m, -2 m]")
    recording = run(led_text(LED, back, duration=160.0))
    for crane in "ab":
        for variable in ("boom_angle", "slew_angle"):
            angle = recording.column(variable, crane)
            assert np.ptp(angle) > 0.1
            assert angle[-1] == pytest.approx(angle[0], abs=1e-13)
        height = recording.column("rope_paid_out", f"{crane}.H.drum")
        assert height[-1] == pytest.approx(height[0], abs=1e-9)


def test_a_way_begins_where_the_run_has_left_the_hoists() -> None:
    """A hoist at 0.05 m/s that brakes from 7.3 s goes 0.05 m/s times 7.3 s, and the way 2 m up from there.

    Falls of 13 m that lean by 4 a/g are 0.4 mm shorter.
    """
    hoist = "{step: up, hoist: [a.H, b.H], speed: 3 m/min, brake_from: 7.3 s}"
    recording = run(led_text(hoist, LED, duration=120.0))
    for crane in "ab":
        height = recording.column("hook_height", f"{crane}.H")
        assert height[-1] - height[0] == pytest.approx(0.365 + 2.0, abs=13.0 * (4 * 0.02 / G) ** 2 / 2)


@pytest.mark.parametrize("settings", METHODS, ids=["adaptive", "del"])
def test_the_same_bytes_from_a_state_saved_amid_the_way(settings: str) -> None:
    """A run that is taken up at 30 s of a way of 67 s is the run that was not interrupted."""
    scenario = parse_scenario(led_text(settings=settings))
    whole = Simulation(scenario).run()
    first = Simulation(scenario)
    first.run(until=30.0)
    again = Simulation(scenario)
    again.restore(first.save())
    taken_up = again.run()
    for name in ("body_position", "rope_tension", "joint_position", "energy"):
        assert np.array_equal(whole[name].values, taken_up[name].values)


@pytest.mark.parametrize("settings", METHODS, ids=["adaptive", "del"])
def test_an_emergency_stop_amid_the_way(settings: str) -> None:
    """Each drive goes on from its velocity v and stops in v^2/2a with its own deceleration, at 30 s.

    From the closed form of (LD4) at 30 s: the hoist stops with 0.5 m/s^2, slewing and luffing with theirs.
    """
    recording = run(led_text(settings=settings, rest="emergency_stop: {at: 30 s}\n"))
    share = share_at(recording, math.hypot(3.0, 5.0, 2.0), 0.1, 0.02)
    at = int(np.searchsorted(recording.time, 30.0))
    east, north = 3.0 * share, 17.0 + 5.0 * share
    slew = np.arctan2(north, east)
    boom = np.arccos((np.hypot(east, north) - AHEAD) / BOOM)
    for variable, way in (("slew_angle", slew), ("boom_angle", boom)):
        rate = (way[at + 1] - way[at - 1]) / (recording.time[at + 1] - recording.time[at - 1])
        stops = way[at] + math.copysign(rate**2 / (2 * math.radians(0.5)), rate)
        found = recording.column(variable, "a")
        assert found[at] == pytest.approx(way[at], abs=1e-12)
        # The rate by central differences 0.4 s apart misses a share of 1e-6.
        assert found[-1] == pytest.approx(stops, abs=1e-7)


def test_a_program_takes_one_drive_out_of_the_way() -> None:
    """Slewing of b is told to stop at 30 s: v^2/2a on from there, and crane a goes on along its line."""
    simulation = Simulation(parse_scenario(led_text()))
    simulation.advance_to(30.0)
    place, velocity = simulation.drive_state("b", motion="slew")
    simulation.command("b", speed=0.0, acceleration=0.001, motion="slew")
    recording = simulation.run()
    assert velocity < -1e-3
    stopped = recording.column("slew_angle", "b")[-1]
    assert stopped == pytest.approx(place - velocity**2 / 0.002, abs=1e-12)
    share = share_at(recording, math.hypot(3.0, 5.0, 2.0), 0.1, 0.02)
    assert heads(recording, "a")[1] == pytest.approx(17.0 + 5.0 * share, abs=1e-9)


def test_energy_balances_while_it_leads() -> None:
    """Work of all drives against weight and what is lost: by `adaptive` to rounding."""
    assert abs(float(run(led_text()).metrics()["energy_remainder"])) < 1e-10
