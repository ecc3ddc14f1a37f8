"""Crawler crane: tipping, pressure on the ground, slewing, against moments and closed forms."""

from __future__ import annotations

import math

import numpy as np
import pytest

from crawler_lift import (
    AHEAD,
    BEHIND,
    BOOM,
    CENTRE,
    GAUGE,
    GROUND,
    LENGTH,
    MATS,
    TRACK,
    WEIGHT,
    WIDTH,
    crawler_lift,
    head_height,
    own_mass,
    own_moment,
    tipping_mass,
)
from gantline.results.cranes.track_pressure import line_pressures
from gantline.results.recording import Recording
from gantline.results.variable import FloatArray
from gantline.scenario import parse_scenario
from gantline.simulation import Simulation
from gantline.statics import NoEquilibriumError, Statics
from mechanics import G

#: Ground that hardly gives way [N/m]: under 4 MN a corner sinks by 4 µm, the boom head leans out by 30 µm.
HARD = 1e12
#: Radius [m], tipping load over the side and rated load [t] of a 600 t class crane: hand figures, whole
#: tonnes, by moments about the middle of a track, and three quarters of it.
TABLE = (
    (12, 480, 360),
    (14, 377, 283),
    (16, 308, 231),
    (18, 260, 195),
    (20, 223, 168),
    (24, 173, 130),
    (28, 139, 104),
)


def at_rest(text: str) -> Recording:
    return Statics(parse_scenario(text)).equilibrium().recording


def run(text: str) -> Recording:
    return Simulation(parse_scenario(text)).run()


def corners(recording: Recording) -> FloatArray:
    """Forces under the four corners at every sample, shape (time, 4) [N]."""
    return np.stack(
        [recording.column("contact_force", one) for one in recording.rig.crawlers[0].corners], axis=1
    )


def closed_corners(mass: float, moment: float, angle: FloatArray | float) -> FloatArray:
    """Forces under four corners of equal stiffness: mass [kg], moment [kg m] and its direction [rad]."""
    forward, left = np.cos(angle) * moment, np.sin(angle) * moment
    return np.stack(
        [
            G / 4 * (mass + 2 * x * forward / TRACK + 2 * y * left / GAUGE)
            for x, y in ((1, 1), (-1, 1), (1, -1), (-1, -1))
        ],
        axis=-1,
    )


@pytest.mark.parametrize(("radius", "tipping", "rated"), TABLE)
def test_tipping_loads_of_the_hand_figures(radius: float, tipping: float, rated: float) -> None:
    """The crane over its side with 50 t: what that uses of the moment that holds it says when it tips."""
    recording = at_rest(crawler_lift(50e3, radius=float(radius), ground=HARD))
    found = 50.0 / float(recording.column("tipping_utilisation", "c1")[-1])
    # 1 kg of sheaves at the head, and the lean of the ground, are 1e-6 of it and more.
    assert found == pytest.approx(tipping_mass(radius) / 1e3, rel=1e-4)
    assert found == pytest.approx(tipping, abs=0.5)  # whole tonnes
    # The chart is cut to whole tonnes, of figures that were rounded before.
    assert 0.75 * found == pytest.approx(rated, abs=1.0)


def test_boom_of_the_hand_figures() -> None:
    """63 m of boom at 16 m: 76.8 deg, its head 63.8 m up."""
    recording = at_rest(crawler_lift(50e3, ground=HARD))
    assert math.degrees(recording.column("boom_angle", "c1")[-1]) == pytest.approx(76.8, abs=0.05)
    assert recording.column("crane_radius", "c1.H")[-1] == pytest.approx(16.0, abs=1e-3)
    # The sheave block of no mass hangs 1 m below the head.
    head = recording.column("body_position", "c1.H/upper_sheaves")[-1, 2] + 1.0
    assert head == pytest.approx(head_height(16.0), abs=1e-3)
    assert head == pytest.approx(63.8, abs=0.05)


def test_ground_pressure_of_the_hand_figures() -> None:
    """150 t at 16 m over the side: 523 t on one track, 380 kPa on its area, 95 kPa under mats of 6 m."""
    recording = at_rest(crawler_lift(150e3, ground=HARD))
    track = corners(recording)[-1, :2].sum()
    # The moments of the figures give 522.48 t: the hand figure was rounded up on its way.
    assert track / G / 1e3 == pytest.approx(372.5 + 1259.8 / 8.4, abs=0.01)
    assert track / G / 1e3 == pytest.approx(523, rel=1.1e-3)
    for pressure, closed in (("track_pressure", 380e3), ("ground_pressure", 95e3)):
        ends = [recording.column(pressure, f"c1.left.{end}")[-1] for end in ("front", "back")]
        assert np.mean(ends) == pytest.approx(closed, rel=2e-3)  # the figures have three digits
        # 14 parts of one rope pull 3 cm aside of the middle of their sheaves: 150 t x 3 cm, of which each
        # track takes half, are 6 x 4.3 mm/9 m of 523 t at its ends.
        assert ends == pytest.approx([closed, closed], rel=0.01)
    closed = track / TRACK / MATS
    assert np.mean(ends) == pytest.approx(closed, rel=1e-9)


def test_the_ground_bears_what_is_there() -> None:
    """Forces under the four corners add up to the weight of the crane and of what hangs, to 1e-9."""
    for ground in (GROUND, HARD):
        found = corners(at_rest(crawler_lift(150e3, slew=30.0, heading=20.0, ground=ground)))[-1].sum()
        # 1 kg of sheaves at the boom head
        assert found == pytest.approx((own_mass() + 150e3 + 1.0) * G, rel=1e-9)


@pytest.mark.parametrize("heading", [0.0, 35.0])
@pytest.mark.parametrize("slew", [0.0, 15.0, 40.0, 60.0, 90.0, 135.0, 180.0, 250.0, 300.0])
def test_corner_forces_at_every_angle(slew: float, heading: float) -> None:
    """All corners carry: the plane of least elastic energy. Where one is clear: three carry by moments."""
    recording = at_rest(crawler_lift(150e3, slew=slew, heading=heading, ground=HARD))
    moment = own_moment(16.0) + 150e3 * 16.0
    mass = own_mass() + 150e3
    closed = closed_corners(mass, moment, math.radians(slew))
    assert closed.min() > 0  # this load lifts none
    # Falls pull aside of the middle of the boom by less than 0.1 m: 150 t x 0.1 m of moment at most.
    aside = G * 150e3 * 0.1 / 2 * (1 / TRACK + 1 / GAUGE)
    assert corners(recording)[-1] == pytest.approx(closed, abs=aside)


def test_with_one_corner_clear_three_carry_by_moments() -> None:
    """250 t at 16 m, the boom over the left front corner: the right back corner is clear of the ground."""
    angle = math.radians(50.0)
    recording = at_rest(crawler_lift(250e3, slew=50.0, ground=HARD))
    found = corners(recording)[-1]
    mass, moment = own_mass() + 250e3, own_moment(16.0) + 250e3 * 16.0
    x, y = moment / mass * math.cos(angle), moment / mass * math.sin(angle)
    assert closed_corners(mass, moment, angle).min() < 0
    # moments about the lines through the others: right front carries what is right of the left track ...
    right, back = mass * G * (0.5 - y / GAUGE), mass * G * (0.5 - x / TRACK)
    closed = [mass * G - right - back, back, right, 0.0]
    aside = G * 250e3 * 0.1 / 2 * (1 / TRACK + 1 / GAUGE)  # as above
    assert found == pytest.approx(closed, abs=2 * aside)
    assert found[3] == 0.0
    # A strip that does not pull: no end is pressed by more than a triangle, and the clear one by nothing.
    pressures = [recording.column("track_pressure", one)[-1] for one in recording.rig.crawlers[0].corners]
    assert np.array(pressures) * WIDTH == pytest.approx(line_pressures(found[None, :], TRACK)[0], rel=1e-12)
    assert pressures[3] == 0.0


def test_slewing_right_round() -> None:
    """360 deg at 0.3 rev/min with 150 t: forces go round with the boom, as the closed form has them."""
    plan = "{step: round, slew: c1, speed: 0.3 rev/min, by: 360 deg}\n{step: end, hold: until_end}"
    recording = run(crawler_lift(150e3, plan, slew=0.0, ground=1e9, duration=240.0, sample=0.5))
    angle = recording.column("slew_angle", "c1")
    assert angle[0] == 0.0
    assert angle[-1] == pytest.approx(2 * math.pi, abs=1e-9)
    moment, mass = own_moment(16.0) + 150e3 * 16.0, own_mass() + 150e3
    closed = closed_corners(mass, moment, angle)
    omega = 0.3 * 2 * math.pi / 60
    # Swing after 0.1 deg/s^2 at 16 m: at most 2 a/g = 0.6 %, outwards by the turning 0.16 %, of 150 t that
    # pull at a head 64 m up; soft ground lets the head out by 3 cm.
    lean = 2 * math.radians(0.1) * 16 / G + omega**2 * 16 / G
    bound = G * 150e3 * (64 * lean + 0.03) / 2 * (1 / TRACK + 1 / GAUGE)
    assert np.abs(corners(recording) - closed).max() < bound
    assert bound < 0.07 * mass * G  # and not by being wide
    # The hook block turns with the boom.
    hook = recording.column("body_orientation", "c1.H")
    turned = np.unwrap(2 * np.arctan2(hook[:, 3], hook[:, 0]))
    assert turned - turned[0] == pytest.approx(angle, abs=1e-9)
    assert recording.attributes["energy_remainder"] < 1e-5


def test_energy_and_off_lead_of_slewing() -> None:
    """Steadily turning: kinetic energy I omega^2/2, falls out by omega^2 (r + x)/g."""
    plan = "{step: round, slew: c1, speed: 0.3 rev/min, acceleration: 0.002 deg/s^2, by: 5000 deg}"
    recording = run(crawler_lift(60e3, plan, ground=HARD, duration=1200.0, sample=0.5))
    omega = 0.3 * 2 * math.pi / 60
    steady = recording.time > 1000.0
    # What it takes to 1.8 deg/s is 900 s, so slowly that the swing that stays is less than 2 a/g of 16 m.
    falls = head_height(16.0) - 30.0  # pin at the head to the bearing of the hook, where the mass hangs
    reach = 16.0 / (1 - omega**2 * falls / G)  # r' = r + x, x = falls omega^2 r'/g
    lead = recording.column("off_lead", "c1.H")[steady]
    assert lead.mean() == pytest.approx(omega**2 * reach / G, rel=0.01)
    inertia = WEIGHT * BEHIND**2 + 60e3 * reach**2
    level = (16.0 - AHEAD) / LENGTH
    inertia += BOOM * ((AHEAD + CENTRE * (16.0 - AHEAD)) ** 2 + LENGTH**2 / 12 * level**2)
    inertia += BOOM * 2.5**2 / 12  # two legs from heel pins 2.5 m apart
    kinetic = recording.column("energy", "kinetic")[steady]
    assert kinetic.mean() == pytest.approx(inertia * omega**2 / 2, rel=2e-3)
    # What the drives have done is there: kinetic energy, and the load that is higher by falls lead^2/2.
    kinds = ("kinetic", "gravity", "elastic")
    stored = sum(recording.column("energy", kind) - recording.column("energy", kind)[0] for kind in kinds)
    work = recording.column("energy", "drive_work")
    assert (work - stored)[steady] == pytest.approx(0.0, abs=0.02 * work[steady].max())


def test_luffing_tackles_on_the_upper_structure_slew_with_it() -> None:
    """A boom in ropes stands where the told one does; half a turn later the corners have changed sides."""
    tackles = ", tackles: {parts: 20, rope: hoist, from: [-5 m, 0 m, 14 m]}"
    told = corners(at_rest(crawler_lift(120e3, ground=HARD)))[-1]
    plan = "{step: round, slew: c1, speed: 0.2 rev/min, by: 180 deg}\n{step: end, hold: until_end}"
    text = crawler_lift(120e3, plan, luffing=tackles, ground=1e9, duration=240.0)
    hung = corners(run(text))
    # What the ropes have stretched by is in their lengths at the start: the boom stands where it was said,
    # but for the lean of this ground, 3 cm at the head.
    bound = 120e3 * G * 0.03 * (1 / TRACK + 1 / GAUGE) + 1.0
    assert hung[0] == pytest.approx(told, abs=bound)
    # Falls still swing by up to 2 a/g = 0.6 % of 120 t at 64 m.
    swing = 120e3 * G * 64 * 0.006 / 2 * (1 / TRACK + 1 / GAUGE)
    assert hung[-50:].mean(axis=0) == pytest.approx(told[[3, 2, 1, 0]], abs=swing)


def test_at_the_tipping_load_nothing_is_left_under_one_side() -> None:
    """0.99 of it stands, 1.01 of it does not."""
    limit = tipping_mass(16.0)
    stands = at_rest(crawler_lift(0.99 * limit, ground=HARD))
    # The lean of the ground takes a little more.
    assert stands.column("tipping_utilisation", "c1")[-1] == pytest.approx(0.99, abs=1e-4)
    assert corners(stands)[-1].min() > 0
    with pytest.raises(NoEquilibriumError, match="tips over"):
        at_rest(crawler_lift(1.01 * limit, ground=HARD))


def test_soft_ground_tips_earlier() -> None:
    """At 200 MN/m the track sinks by 22 mm under 0.99 of the load that tips on hard ground: that is enough.

    The lean of 22 mm over the gauge takes the head out by 0.17 m, of 11.8 m to the track.
    """
    limit = tipping_mass(16.0)
    at_rest(crawler_lift(0.97 * limit, ground=GROUND))
    with pytest.raises(NoEquilibriumError, match="tips over"):
        at_rest(crawler_lift(0.99 * limit, ground=GROUND))


def test_luffing_out_ends_in_an_event() -> None:
    """The load that tips at 17 m, luffed out from 16 m: a run that goes on, and says when it tipped."""
    plan = "{step: out, luff: c1, speed: 3 deg/min, to: 72 deg}\n{step: end, hold: until_end}"
    recording = run(crawler_lift(tipping_mass(17.0), plan, ground=1e10, duration=24.0, sample=0.02))
    events = recording.events("tipping")
    assert len(events) == 1
    time, _, name = events[0]
    assert name == "c1"
    radius = np.interp(time, recording.time, recording.column("crane_radius", "c1.H"))
    # Falls swing by less than 2 a/g = 2 x 64 m x 0.02 deg/s^2/g, times 64 m over 12.8 m of lever: 2 % at
    # most. They are at 0.2 % when it happens.
    assert radius == pytest.approx(17.0, rel=0.005)
    assert recording.time[-1] == pytest.approx(24.0)
    assert any("crane 'c1' tips at" in text for text in recording.attributes["warnings"])
    assert recording.metrics()["tipping_utilisation.c1"] == 1.0
    assert recording.column("crane_trim", "c1")[-1] < math.radians(-1.0)  # it goes over towards the boom


def test_ground_that_settles_leans_the_crane_as_told() -> None:
    """50 mm under the left track: the crane leans by 50 mm over its gauge, the hook goes 64 m times that."""
    settling = ", settling: {at: 2 s, over: 40 s, by: 50 mm, corners: [left.front, left.back]}"
    plan = "{step: hold, hold: until_end}"
    recording = run(crawler_lift(100e3, plan, tracks=settling, ground=1e10, duration=80.0))
    lean = math.atan(0.05 / GAUGE)
    assert recording.column("crane_trim", "c1")[-1] == pytest.approx(-lean, rel=0.01)
    out = recording.column("crane_radius", "c1.H")
    head = LENGTH * math.sin(math.acos((16.0 - AHEAD) / LENGTH)) + 2.5
    # Falls still swing by the last jerk of the ground.
    assert (out[-1] - out[0]) == pytest.approx(head * lean, rel=0.05)


def test_all_corners_that_settle_let_the_crane_down_level() -> None:
    """50 mm under all of them: 50 mm down, and no lean."""
    settling = ", settling: {at: 1 s, over: 20 s, by: 50 mm}"
    recording = run(crawler_lift(100e3, tracks=settling, ground=1e9, duration=60.0))
    place = recording.column("body_position", "c1.tracks")[:, 2]
    assert place[-1] - place[0] == pytest.approx(-0.05, abs=1e-4)
    assert np.abs(recording.column("crane_heel", "c1") - recording.column("crane_heel", "c1")[0]).max() < 1e-4


def test_uneven_ground_is_a_lean_from_the_start() -> None:
    """Both corners of the left track 42 mm low: 42 mm over 8.4 m, 0.286 deg, on hard ground."""
    recording = at_rest(
        crawler_lift(50e3, tracks=", levels: {left.front: -42 mm, left.back: -42 mm}", ground=HARD)
    )
    assert recording.column("crane_trim", "c1")[-1] == pytest.approx(-math.atan(0.042 / GAUGE), rel=1e-3)


@pytest.mark.parametrize("settles", [False, True])
def test_pressure_on_twisted_ground_is_that_of_the_ends_of_each_track(settles: bool) -> None:
    """The ground under one end of a track 4 mm low, from the start or settled by as much during a run.

    A rigid crane presses its ends in by N/k, so that the twist of the ground is Σ ± N/k. All carry: under
    each track a trapezium, F/L (1 ± 6 e/L) with the e of the forces under its own ends.
    """
    where = ", levels: {right.front: -4 mm}"
    if settles:
        where = ", settling: {at: 1 s, over: 20 s, by: 4 mm, corners: [right.front]}"
    text = crawler_lift(100e3, slew=60.0, tracks=where, duration=50.0)
    recording = at_rest(text) if not settles else run(text)
    found = corners(recording)[-1]
    # 2 s of swing at the end of a run, 1e-4 of the weight; statics leaves 1e-9 of it.
    twist = (found[0] - found[1] - found[2] + found[3]) / GROUND
    assert twist == pytest.approx(0.004, rel=1e-6 if not settles else 1e-3)
    for ends, at in (("left", found[:2]), ("right", found[2:])):
        track = at.sum()
        eccentricity = TRACK / 2 * (at[0] - at[1]) / track
        assert abs(eccentricity) < TRACK / 6
        for end, sign in (("front", 1.0), ("back", -1.0)):
            closed = track / TRACK * (1.0 + sign * 6.0 * eccentricity / TRACK)
            pressure = recording.column("ground_pressure", f"c1.{ends}.{end}")[-1]
            # The pressure takes the ground where it has settled to, the forces also how fast the crane rocks.
            assert pressure == pytest.approx(closed / MATS, rel=1e-8 if not settles else 1e-4)


def test_travel_moves_the_crane_with_its_load() -> None:
    """5 m along tracks that head 30 deg from x, boom and hook along with it."""
    drive = "    travel: {speed: 1 km/h, acceleration: 0.02 m/s^2, range: [0 m, 20 m]}\n"
    plan = "{step: go, travel: c1, speed: 0.5 km/h, by: 5 m}\n{step: end, hold: until_end}"
    recording = run(crawler_lift(20e3, plan, crane=drive, heading=30.0, duration=120.0))
    moved = recording.column("body_position", "c1.tracks")
    way = moved[-1] - moved[0]
    assert way[:2] == pytest.approx([5 * math.cos(math.radians(30)), 2.5], abs=1e-3)
    assert recording.column("contact_force", "c1.left.front").min() > 0
    hook = recording.column("body_position", "c1.H")
    # What stays of the swing is less than 2 a/omega^2 = 2 x 0.02 m/s^2 x 33 m/g.
    assert hook[-1, :2] - hook[0, :2] == pytest.approx(way[:2], abs=0.14)
