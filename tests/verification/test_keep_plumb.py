"""Steps that keep falls plumb: their way by geometry, how far they stay behind, and what they do not follow.

A line of lugs of the length l, level at first, one end a height h over the other: sin t = h/l. With both
falls plumb one hook is nearer to the other by l (1 - cos t). Hoisted at v, t' = v/(l cos t), so that the
trolley goes v tan t and accelerates with a = v^2/(l cos^3 t).
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np
import pytest

import gantline
from gantline.checks import check_recording
from gantline.cli.summary import summary
from gantline.report.attitude import attitude
from gantline.report.subject import Subject
from gantline.results.progress import spans
from gantline.results.recording import Recording
from gantline.results.variable import FloatArray
from gantline.scenario import parse_scenario
from gantline.simulation import Simulation
from gantline.statics import Statics
from mechanics import G
from of_recording import step_end
from shown import unsaid
from upending import HOIST, LINE, TOP, TRAVERSE, WAIT, below_a_bar, between_trolleys, by_crawlers, upended

#: Time between looks [s], as `crates/gantline-core/src/plan/follow.rs` has it.
LOOK = 1.0
#: Speed of the hoist [m/s], how far it hoists [m].
SPEED, BY = 4.0 / 60.0, 17.0
#: When the hoist begins to brake [s]: a way s at v with ramps of a lasts s/v + v/a.
BRAKES = WAIT + BY / SPEED


@cache
def run(text: str) -> Recording:
    return gantline.simulate(parse_scenario(text))


def aside(recording: Recording, *hooks: str) -> FloatArray:
    """The farthest that falls are out of plumb, shape (time,) [deg]."""
    each = np.array([recording.column("falls_out_of_plumb", hook) for hook in hooks])
    worst: FloatArray = np.degrees(each.max(axis=0))
    return worst


def turned(recording: Recording) -> tuple[FloatArray, FloatArray]:
    """Cosine of the angle of the lugs by what the drum has taken up, and the way of the trolley [1, m]."""
    hoisted = recording.column("joint_position", "gol.A.drum")
    trolley = recording.column("joint_position", "gol.two")
    return np.sqrt(1.0 - (hoisted / LINE) ** 2), trolley - trolley[0]


def late_by(recording: Recording) -> tuple[FloatArray, FloatArray]:
    """How far the trolley is from the closed form, and what that leaves out, while A hoists steadily [m]."""
    cosine, way = turned(recording)
    sine = np.sqrt(1.0 - cosine**2)
    late = 13 / 4 * SPEED**2 / (LINE * cosine**3) * LOOK**2
    early = 31 / 4 * 3 * SPEED**3 * sine / (LINE**2 * cosine**5) * LOOK**3
    next_term = 631 / 48 * 3 * SPEED**4 * (1.0 + 4.0 * sine**2) / (LINE**3 * cosine**7) * LOOK**4
    stretch = 0.5e6 * 14.0 / 20e9 * sine / cosine
    steady = (recording.time > WAIT + 10.0) & (recording.time < BRAKES)
    assert way[steady].min() < -9.0
    error: FloatArray = np.abs(way + LINE * (1.0 - cosine) - late + early)
    return error[steady], (next_term + stretch + 1e-5)[steady]


@pytest.mark.parametrize("settings", ["", ", integrator: del, step: 10 ms"], ids=["adaptive", "del"])
@pytest.mark.parametrize("slings", [(8.0, 8.0), (4.0, 14.0), (14.0, 4.0)])
def test_the_trolley_goes_as_lugs_come_nearer(slings: tuple[float, float], settings: str) -> None:
    """x = -l (1 - cos t), and behind that by 13/4 a T^2 - 31/4 a' T^3, a' = 3 v^3 sin t/(l^2 cos^5 t).

    The recursion in the theory gives these, and 631/48 a'' T^4, a'' = 3 v^4 (1 + 4 sin^2 t)/(l^3 cos^7 t),
    as the next term: what may be missing. Ropes are stiff, 20 GN: the 0.5 MN that each hook bears stretch
    14 m of sling by 0.35 mm, which at the angle t shifts the lugs by tan t times that. 10 um for what the
    load still swings.
    """
    recording = run(between_trolleys(upended(), slings=slings, settings=settings, duration=270.0, rope=2e4))
    error, left_out = late_by(recording)
    assert np.all(error < left_out)


def test_the_trolley_goes_as_lugs_below_a_bar_come_nearer() -> None:
    """The same with a bar across between hook and lugs: what pulls is looked at down to the load."""
    error, left_out = late_by(run(below_a_bar(between_trolleys(upended(), duration=270.0, rope=2e4))))
    assert np.all(error < left_out)


def test_falls_stay_plumb_that_lean_without() -> None:
    """Behind by e, falls that share the weight lean by e/(L_A + L_B), L from upper sheaves to lug.

    The middle of the column accelerates with a/2, for which both lean by a/2g. Half as much again for the
    swing that hoisting and the trolley's ramps have made.
    """
    held = run(between_trolleys(upended(follow=None)))
    led = run(between_trolleys(upended()))
    until = led.time < BRAKES
    cosine, _ = turned(led)
    most = SPEED**2 / (LINE * cosine[until].min() ** 3)
    lean = 13 / 4 * most * LOOK**2 / (2.0 * (TOP - 30.0) - BY) + most / 2.0 / G
    worst = aside(led, "gol.A", "gol.B")[until].max()
    assert worst < 1.5 * np.degrees(lean)
    assert aside(held, "gol.A", "gol.B").max() > 8.0


@pytest.mark.parametrize("end", ["by: 17.0 m", "until: {load_tilt: {above: 63.4 deg}}"], ids=["by", "until"])
def test_it_stops_with_the_hoist_as_far_as_it_can(end: str) -> None:
    """Its place goes u v/2a_h on as the hoist brakes from v, u = v tan t, and it u^2/2a_f: so it goes beyond.

    It begins as the hoist does, which the plan knows, or within half a look of a condition that is met.
    """
    recording = run(between_trolleys(upended().replace("by: 17.0 m", end)))
    brakes = step_end(recording, "upend") - SPEED / HOIST
    cosine, way = turned(recording)
    at = int(np.searchsorted(recording.time, brakes))
    fast = SPEED * np.sqrt(1.0 - cosine[at] ** 2) / cosine[at]
    farther = fast**2 / 2.0 / TRAVERSE - fast * SPEED / 2.0 / HOIST
    late = 0.0 if end.startswith("by") else LOOK / 2.0 * fast
    back = way[-1] - way[at:].min()
    assert back < farther + late
    if end.startswith("by"):
        said = f"That is {farther:.3f} m ({back:.3f} m in the run) for the trolleys of the table"
        assert unsaid("docs/concepts/plan_and_drives.md", said) == []


def test_it_keeps_its_limits_and_ends_by_itself() -> None:
    """A trolley that may go 2 m/min and accelerate with 0.05 m/s^2, by differences of its places.

    On its way it falls behind where v tan t is more than that. It ends when it has come there, or brakes 20 s
    after the hoist has ended.
    """
    recording = run(between_trolleys(upended(follow=2.0), duration=330.0))
    place, every = recording.column("joint_position", "gol.two"), float(np.diff(recording.time)[0])
    speed = np.diff(place) / every
    # Sums of ramps of 10 m with rounding of 1e-15, over 0.2 s and 0.04 s^2.
    assert np.abs(speed).max() == pytest.approx(2.0 / 60.0, rel=1e-9)
    assert np.abs(np.diff(speed) / every).max() < TRAVERSE * (1.0 + 1e-9)
    ended = {name: time for time, _, name in recording.events("step_end")}
    # A way s at speed v with ramps of a lasts s/v + v/a.
    assert ended["upend"] == pytest.approx(WAIT + BY / SPEED + SPEED / HOIST, rel=1e-12)
    assert ended["follow"] == pytest.approx(ended["upend"] + 20.0 + 2.0 / 60.0 / TRAVERSE, abs=LOOK)
    assert place[-1] == place[recording.time > ended["follow"]][0]


def test_it_stops_at_the_end_of_its_range() -> None:
    """At 5 m, to rounding; the column turns on, and falls come out of plumb."""
    recording = run(between_trolleys(upended(), least=5.0))
    place = recording.column("joint_position", "gol.two")
    assert place.min() == pytest.approx(5.0, abs=1e-9)
    assert aside(recording, "gol.A", "gol.B").max() > 2.0


def test_an_emergency_stop_ends_it() -> None:
    """At 200 s the trolley goes with u = v tan t, brakes by u^2/2a, and looks no more.

    By the recursion in the theory it has the speed of its place at looks, less 10/3 a' T^2; what comes next
    is less than a tenth of that, by which a' changes in 3 T.
    """
    stopped = run(between_trolleys(upended()) + "emergency_stop: {at: 200 s}\n")
    place, time = stopped.column("joint_position", "gol.two"), stopped.time
    at = int(np.searchsorted(time, 200.0))
    cosine, _ = turned(stopped)
    wanted = SPEED * np.sqrt(1.0 - cosine[at] ** 2) / cosine[at]
    jerk = 3 * SPEED**3 * np.sqrt(1.0 - cosine[at] ** 2) / (LINE**2 * cosine[at] ** 5)
    less = 10 / 3 * jerk * LOOK**2
    expected = (wanted - less) ** 2 / 2.0 / TRAVERSE
    assert place[at] - place[-1] == pytest.approx(expected, abs=0.1 * less * wanted / TRAVERSE)
    # A place is its last one and what the drive lacks of it, rounded twice in the step that comes to rest;
    # after it the difference is exact.
    still = place[time > 200.0 + wanted / TRAVERSE]
    assert np.abs(still - place[-1]).max() <= 2 * np.spacing(place[-1])


@pytest.mark.parametrize("slings", [(8.0, 8.0), (4.0, 14.0)])
def test_a_load_that_swings_is_not_chased(slings: tuple[float, float]) -> None:
    """Trolley `one` begins 0.4 m off: the column swings, and trolley `two` comes to be off as much.

    From then on both falls lean alike, and the trolley stands but for what is of second order: lugs that
    swing by 0.22 m on 48 m rise by 0.5 mm. So what swings goes on as it did, within a tenth: hook blocks
    swing with other periods than the column, which a stretch of 30 s does not show alike.
    """
    plan = """\
{step: nothing, hold: 100 s}
{step: follow, traverse: two, starts: with_previous, speed: 10 m/min, keep_plumb: gol.B}
{step: end, hold: until_end}"""
    recording = run(between_trolleys(plan, duration=160.0, west=-9.9, slings=slings, start="as_given"))
    place = recording.column("joint_position", "gol.two")
    late = recording.time > 20.0
    swing = recording.column("body_position", "column")[:, 0]
    during = [(recording.time > at) & (recording.time < at + 30.0) for at in (20.0, 120.0)]
    first, last = (np.ptp(swing[one]) for one in during)
    assert place[-1] == pytest.approx(9.1, abs=0.5e-3)
    assert np.ptp(place[late]) < 0.5e-3
    assert first > 0.4
    assert last == pytest.approx(first, rel=0.1)


def test_falls_are_plumb_in_equilibrium_on_the_way() -> None:
    """A plan that follows is followed from rest to rest: as far behind as a run, and no swing."""
    at = 200.0
    found = Statics(parse_scenario(between_trolleys(upended()))).equilibrium(at).recording
    cosine, way = turned(found)
    behind = 13 / 4 * SPEED**2 / (LINE * cosine[-1] ** 3) * LOOK**2
    assert way[-1] == pytest.approx(-LINE * (1.0 - cosine[-1]) + behind, abs=0.5e-3)


def column(*, follows: bool) -> str:
    """Off the ground, then upended by one crawler crane while the other follows, or stands."""
    lines = [
        "{step: lift, hoist: [main.H, tail.H], speed: 2 m/min, by: 4 m}",
        "{step: upend, hoist: main.H, speed: 3 m/min, until: {load_tilt: {above: 75 deg}}}",
    ]
    if follows:
        lines.append("{step: follow, travel: tail, starts: with_previous, speed: 1 km/h, keep_plumb: tail.H}")
    return "\n".join([*lines, "{step: rest, hold: 20 s}"])


def test_a_tail_crane_follows_a_column() -> None:
    """At 75 deg, 3 m/min and l = 38 m, a = 3.8 mm/s^2: 12 mm behind on 80 m and more, and a/2g, are 0.02 deg.

    0.04 deg more for what the column has swung since both cranes took it off the ground.
    """
    recording = run(by_crawlers(column(follows=True)))
    (begins, ends) = spans(recording)["upend"]
    # To where the hoist brakes, 0.05 m/s with 0.02 m/s^2.
    during = (recording.time > begins) & (recording.time < ends - 2.5)
    worst = aside(recording, "main.H", "tail.H")[during].max()
    assert worst < 0.06
    # The whole way, as near as falls of 40 m are plumb within 0.01 deg.
    tilt = recording.column("load_tilt", "column")[-1]
    travelled = recording.column("joint_position", "tail/along")[-1]
    assert travelled == pytest.approx(38.0 * (1.0 - np.cos(tilt)), abs=40.0 * np.radians(0.01))
    said = summary(recording, check_recording(recording), lambda verdict: verdict.value)
    (kept,) = (line for line in said if "falls kept plumb" in line)
    assert "tail.H within" in kept and "'follow'" in kept
    assert ("falls kept plumb", kept.split("  ")[-1].strip()) in attitude(Subject(recording))
    # l (1 - cos t) by l sin t is tan t: fastest at the end, 3 m/min of the other hook times tan 75 deg.
    told = dict(attitude(Subject(recording)))["travelled to keep plumb"].split()
    assert told[:2] == ["tail", "from"] and told[2:5] == ["0.00", "m", "to"]
    assert float(told[5]) == pytest.approx(travelled, abs=0.005)
    assert float(told[8]) == pytest.approx(3.0 * np.tan(np.radians(75.0)), rel=0.03)


def test_runs_that_follow_give_the_same_bytes(tmp_path: Path) -> None:
    """Twice, and once more from a state that was saved on the way, byte by byte."""
    scenario = parse_scenario(between_trolleys(upended(), duration=120.0))
    saved = []
    for name, taken_up in (("a.nc", False), ("b.nc", False), ("c.nc", True)):
        simulation = Simulation(scenario)
        simulation.advance_to(70.3)
        if taken_up:
            state = simulation.save()
            simulation = Simulation(scenario)
            simulation.restore(state)
        saved.append(simulation.run().save(tmp_path / name).read_bytes())
    assert saved[0] == saved[1] == saved[2]
