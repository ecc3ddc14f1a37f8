"""What a rope does on a sheave: wrap angle through any turn, lift-off and return, fleet angle; eyes."""

from __future__ import annotations

import math

import numpy as np
import pytest

from mechanics import (
    Floats,
    G,
    Json,
    Run,
    adaptive,
    body,
    document,
    end,
    eye,
    hinge,
    point,
    rope,
    sheave,
    simulate,
    slider,
)

RADIUS = 0.5


def driven(joint: Json, ramps: list[Json]) -> Json:
    """A joint with the motion "d" that starts at rest, and the drives of its document."""
    joint["drive"] = "d"
    return {"drives": [{"name": "d", "ramps": ramps}]}


def deflected(*, may_lift_off: bool, method: str = "adaptive", turns: int = 1) -> tuple[Run, Floats]:
    """A taut rope from (-4, 0, 0) over the top of a sheave at (0, 0, -0.5) to a point that rises and sinks.

    Returns the run and the height z of the point, which begins and ends at (4, 0, -1).
    """
    up = slider(position=-1.0)
    ramps = []
    for turn in range(turns):
        for at, velocity in ((0.5, 1.0), (2.5, -1.0)):
            ramps.append({"at": at + 4 * turn, "duration": 0.5, "velocity": velocity, "shape": "smooth"})
    drives = driven(up, ramps)
    bodies = [body("end", up, 10.0, position=(4, 0, 0))]
    guide = sheave(None, (0, 0, -RADIUS), (0, 1, 0), RADIUS, may_lift_off=may_lift_off)
    ropes = [rope("r", 7.99, [end(None, (-4, 0, 0)), guide, end("end")], 1e6)]
    system = document(bodies, ropes=ropes, **drives)
    run = simulate(system, 4.0 * turns) if method == "del" else adaptive(system, 4.0 * turns)
    return run, run.joint("end")


def routed(run: Run) -> Floats:
    """Straight parts and arc of the rope [m]."""
    straight: Floats = run.columns["segment_length"].sum(axis=1)
    return straight + RADIUS * run.columns["wrap_angle"][:, 0]


def wrapped(z: Floats) -> tuple[Floats, Floats]:
    """Length and wrap of that rope as if it were held in the groove.

    With c = (0, -r) the left part leaves (-4, 0) level, at (0, 0): length 4. On the right w = (4, z + r) runs
    from the centre to the end, the tangent is l = sqrt(|w|^2 - r^2), and the radius to where it touches is at
    the angle acos(r/|w|) before w.
    """
    w = np.hypot(4.0, z + RADIUS)
    touch = np.arctan2(z + RADIUS, 4.0) + np.arccos(RADIUS / w)
    wrap = math.pi / 2 - touch
    return 4.0 + RADIUS * wrap + np.sqrt(w**2 - RADIUS**2), wrap


def test_rope_leaves_the_sheave_and_comes_back() -> None:
    """Below z = 0 it wraps, above it runs straight: l = sqrt(64 + z^2); at z = 0 both are 8 m long."""
    run, z = deflected(may_lift_off=True)
    length, wrap = wrapped(z)
    straight = z > 0
    length[straight] = np.hypot(8.0, z[straight])
    assert straight.any() and not straight.all()
    assert np.abs(routed(run) - length).max() < 1e-9
    # Between its looks at a step of half a second the method gives tensions by a polynomial.
    assert run.tension("r") == pytest.approx(1e6 * (length - 7.99) / 7.99, abs=20.0)
    angle = run.columns["wrap_angle"][:, 0]
    assert np.abs(angle - np.where(straight, 0.0, wrap)).max() < 1e-9
    # Times by the motion itself: z rises through 0 in the middle of its travel, and falls through it.
    times = [time for time, _ in run.events("rope_off_sheave") + run.events("rope_on_sheave")]
    assert [name for _, name in run.events("rope_off_sheave")] == ["r/sheave_1"]
    assert len(times) == 2
    for time in times:
        assert np.interp(time, run.time, z) == pytest.approx(0.0, abs=1e-4), "samples 0.01 s apart"


def test_rope_that_may_not_leave_is_followed_as_if_it_were_held() -> None:
    """The same closed form of the groove goes on above z = 0, with a negative arc."""
    run, z = deflected(may_lift_off=False)
    length, wrap = wrapped(z)
    assert wrap.min() < -0.1
    assert np.abs(routed(run) - length).max() < 1e-9
    assert np.abs(run.columns["wrap_angle"][:, 0] - wrap).max() < 1e-9
    assert len(run.events("rope_off_sheave")) == len(run.events("rope_on_sheave")) == 1


def test_rope_leaves_the_sheave_with_del() -> None:
    """The fixed step knows the same lengths; it changes side at the end of a step."""
    run, z = deflected(may_lift_off=True, method="del")
    length, _ = wrapped(z)
    length[z > 0] = np.hypot(8.0, z[z > 0])
    # Both lengths and their slopes are equal at z = 0; a step of 1 ms goes 1 mm beyond, and z^2/16 = 6e-8 m.
    assert np.abs(routed(run) - length).max() < 7e-8
    assert len(run.events("rope_off_sheave")) == len(run.events("rope_on_sheave")) == 1


def interrupted_pendulum(*, may_lift_off: bool) -> Run:
    """Galileo's pendulum: 100 kg on 4 m of rope beside a sheave, which it meets on one side of its swing."""
    start = math.radians(30.0)
    bodies = [body("bob", point((-4 * math.sin(start), 0.0, -4 * math.cos(start))), 100.0)]
    # The sheave touches the plumb line on its right, 2 m down; a rope that swings right bends about it.
    guide = sheave(None, (0.2, 0, -2.0), (0, -1, 0), 0.2, may_lift_off=may_lift_off)
    return adaptive(
        document(bodies, ropes=[rope("r", 4.0, [end(None), guide, end("bob")], 1e7)]),
        8.0,
        tension_tolerance=1e-2,
        position_tolerance=1e-9,
    )


def test_interrupted_pendulum_rises_to_its_height() -> None:
    """It loses nothing on the sheave: on both sides it turns at the same height, wrapped or not."""
    run = interrupted_pendulum(may_lift_off=True)
    x, height = run.body("bob")[:, 0], run.body("bob")[:, 2]
    stored = run.energy("kinetic") + run.energy("gravity") + run.energy("elastic")
    assert np.abs(stored - stored[0]).max() < 1e-6 * run.energy("kinetic").max()
    assert run.energy_remainder < 1e-8
    turns = np.flatnonzero(np.diff(np.sign(np.diff(height))) < 0) + 1
    left, right = [turn for turn in turns if x[turn] < 0], [turn for turn in turns if x[turn] > 0]
    assert len(left) > 0 and len(right) > 1
    # At 100 samples a second a turn is seen within 5 ms: g/2 t^2 = 0.1 mm; the rope stretches by 0.4 mm, and
    # rings.
    assert height[right] == pytest.approx(-4 * math.cos(math.radians(30.0)), abs=2e-3)
    # Each half swing to the right begins and ends at the plumb line, where the wrap is zero.
    events = sorted(run.events("rope_on_sheave") + run.events("rope_off_sheave"))
    assert len(events) == len(np.flatnonzero(np.diff(np.sign(x))))
    for time, name in events:
        assert name == "r/sheave_1"
        assert np.interp(time, run.time, x) == pytest.approx(0.0, abs=2e-3)
    angle = run.columns["wrap_angle"][:, 0]
    assert np.all(angle >= 0.0) and np.all(angle[x < -0.01] == 0.0)


def test_pendulum_askew_keeps_its_books() -> None:
    """Where both parts have different fleet angles the rope snaps straight: the audit says what that does.

    The two parts of 2 m, bent by k, are k^2/2 m longer than the straight way. Fleet angles of 4 deg change
    the stored energy by about 1e-4 of the kinetic energy at each pass; the books must close all the same.
    """
    bodies = [body("bob", point((-2.0, 0.2, -3.4)), 100.0)]
    guide = sheave(None, (0.2, 0, -2.0), (0, -1, 0), 0.2, may_lift_off=True)
    ropes = [rope("r", 3.9443, [end(None), guide, end("bob")], 1e7, 0.001)]
    run = adaptive(document(bodies, ropes=ropes), 10.0, tension_tolerance=0.1)
    assert len(run.events("rope_off_sheave")) == len(run.events("rope_on_sheave")) == 3
    assert 3.0 < math.degrees(np.abs(run.columns["fleet_angle"]).max()) < 5.0
    assert run.energy_remainder < 1e-6
    assert np.abs(run.energy("method")).max() < 1e-3 * run.energy("kinetic").max()


def test_wrap_goes_on_past_a_whole_turn() -> None:
    """A rope end that is carried round a sheave winds on: the wrap grows by the angle turned."""
    arm = hinge(position=0.0)
    drives = driven(arm, [{"at": 0.0, "duration": 0.5, "velocity": 1.5, "shape": "smooth"}])
    bodies = [body("arm", arm, 1.0, inertia=(1, 1, 1))]
    ends = [end(None, (0, 0, -6)), sheave(None, (0, 0, 0), (0, 1, 0), RADIUS), end("arm", (3, 0, 0))]
    run = adaptive(document(bodies, ropes=[rope("r", None, ends, 1e4)], **drives), 6.0, sample_interval=0.05)
    wrap = run.columns["wrap_angle"][:, 0]
    turned = run.joint("arm")
    assert turned[-1] > 2 * math.pi
    assert np.abs(wrap - wrap[0] - turned).max() < 1e-9
    # The same from samples further apart than half a turn.
    rough = adaptive(document(bodies, ropes=[rope("r", None, ends, 1e4)], **drives), 6.0, sample_interval=3.0)
    assert rough.columns["wrap_angle"][-1, 0] == pytest.approx(wrap[-1], abs=1e-6)


def test_fleet_angle_of_a_rope_that_runs_on_askew() -> None:
    """From (r, b, 0) up to a sheave in the plane y = 0 that it touches at (r, 0, h): sin(phi) = b/l."""
    bodies = [body("load", slider(damping=1e4), 100.0, position=(-RADIUS, 0, 0))]
    ends = [end(None, (RADIUS, 0.3, 0)), sheave(None, (0, 0, 10), (0, -1, 0), RADIUS), end("load")]
    run = adaptive(document(bodies, ropes=[rope("r", None, ends, 1e7, 0.01)]), 1.0)
    arriving, leaving = np.moveaxis(run.columns["fleet_angle"][:, 0], 1, 0)
    # The axis points to -y: a rope on the side of +y has a negative angle.
    assert arriving == pytest.approx(-math.asin(0.3 / math.hypot(0.3, 10.0)), abs=1e-12)
    assert leaving == pytest.approx(0.0, abs=1e-12)


def test_ring_on_a_rope_comes_to_rest_where_the_rope_is_bisected() -> None:
    """A ring slides on a rope of length L between supports at a distance d and of any height.

    Without friction both parts have one tension and so one angle a to the plumb line: sin(a) = d/L and
    T = m g/(2 cos(a)). With the supports h apart in height the parts differ by h/cos(a).
    """
    distance, rise, length, mass, stiffness = 6.0, 1.5, 8.0, 200.0, 1e8
    sine = distance / length
    cosine = math.sqrt(1 - sine**2)
    first = (length - rise / cosine) / 2  # to the lower support
    bodies = [
        body("carriage", slider((1, 0, 0), damping=300.0), 1.0, position=(first * sine + 0.3, 0, 0)),
        body("ring", slider(damping=300.0), mass, parent="carriage", position=(0, 0, -first * cosine + 0.2)),
    ]
    ends = [end(None), eye("ring"), end(None, (distance, 0, rise))]
    run = adaptive(
        document(bodies, ropes=[rope("r", length, ends, stiffness, 0.01)]), 120.0, sample_interval=1.0
    )
    x, _, z = run.body("ring")[-1]
    # The rope stretches by T L/EA: 0.12 mm of 8 m.
    assert (x, z) == pytest.approx((first * sine, -first * cosine), abs=5e-4)
    assert run.columns["segment_tension"][-1] == pytest.approx(mass * G / (2 * cosine), rel=1e-4)
    assert np.array_equal(*run.columns["segment_tension"].T), "one tension on both sides, at all times"
    pull = np.array([[-x, 0, -z], [distance - x, 0, rise - z]])
    angles = np.arctan2(np.abs(pull[:, 0]), pull[:, 2])
    assert angles[0] == pytest.approx(angles[1], abs=1e-5)


def test_an_eye_is_the_limit_of_a_small_sheave() -> None:
    """A load on a rope over a held guide: the smaller the sheave the closer to the eye, as its radius."""

    def last(guide: Json) -> float:
        bodies = [
            body("load", point((1.0, 0.5, 0.0), (0.5, 0.0, 0.0)), 100.0),
            body("weight", slider(), 90.0, position=(0, 0, 2)),
        ]
        system = document(bodies, ropes=[rope("r", None, [end("weight"), guide, end("load")], 1e6, 0.01)])
        return float(adaptive(system, 1.0).body("load")[-1, 2])

    exact = last(eye(None, (0, 0, 8)))
    errors = [abs(last(sheave(None, (0, 0, 8), (0, 1, 0), radius)) - exact) for radius in (1e-2, 1e-3)]
    assert errors[1] < 2e-3
    assert errors[0] / errors[1] == pytest.approx(10.0, rel=0.1)
