"""Impacts of inextensible ropes on joints that dry friction holds, or that a drive moves.

Friction that held a joint took part in impacts like a wall, whatever it could bear: 100 N stopped 20 kg at
2 m/s at once. Friction of a joint that an impact threw back kept its old direction, was taken for one that
rests, and was gone from then on. A drive that went on through an impact did no work in it, and books
called what it had put in a loss below zero.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from mechanics import Floats, Json, Run, adaptive, body, document, end, hinge, point, rope, simulate, slider

ALONG = (1.0, 0.0, 0.0)
#: Unstretched length of the rope between two bodies that start at one place [m].
LENGTH = 1.0
#: A rope is caught within five tolerances of position of 0.1 µm; at 2 m/s and more that is this much later
#: [s].
CAUGHT = 2.5e-7


def joined(first: Json, second: Json, **rest: list[Json]) -> Json:
    """Two bodies `a` and `b` without gravity, an inextensible rope between their origins."""
    ropes = [rope("r", LENGTH, [end("a"), end("b")], None)]
    return {**document([first, second], ropes=ropes, **rest), "gravity": [0, 0, 0]}


def speed(run: Run, name: str) -> Floats:
    """Along x (time,) [m/s]."""
    return run.body(name, "body_velocity")[:, 0]


@pytest.mark.parametrize("friction", [1e-6, 100.0, 400.0])
def test_friction_does_not_hold_against_an_impact(friction: float) -> None:
    """v₊ = m₂ v/(m₁ + m₂), ½ m₁ m₂ v²/(m₁ + m₂) is lost; then F/(m₁ + m₂) brakes both until they rest."""
    held, thrown, start = 30.0, 20.0, 2.0
    bodies = (
        body("a", slider(ALONG, friction=friction), held),
        body("b", slider(ALONG, velocity=start), thrown),
    )
    run = adaptive(joined(*bodies), 1.0)
    [(taut, _)] = run.events("taut")
    assert taut == pytest.approx(LENGTH / start, abs=1e-9)
    braking = friction / (held + thrown)
    after = thrown * start / (held + thrown) - braking * (run.time - taut)
    expected = np.where(run.time < taut, 0.0, np.maximum(0.0, after))
    compared = np.abs(run.time - taut) > CAUGHT
    # Braking begins up to CAUGHT later; 1e-12 is rounding.
    assert np.abs(speed(run, "a") - expected)[compared].max() < braking * CAUGHT + 1e-12
    assert run.energy("impact")[-1] == pytest.approx(
        held * thrown * start**2 / (2 * (held + thrown)), rel=1e-12
    )


def test_friction_that_an_impact_does_not_reach_goes_on_to_hold() -> None:
    """A pull across a slider moves it no more than before: v₊ = 0 of both, all of ½ m v² is lost."""
    thrown, start = 20.0, 2.0
    bodies = (
        body("a", slider((0, 1, 0), friction=10.0), 30.0),
        body("b", slider(ALONG, velocity=start), thrown),
    )
    run = adaptive(joined(*bodies), 1.0)
    assert np.abs(run.joint("a")).max() == 0.0
    assert np.abs(speed(run, "b")[run.time > LENGTH / start + CAUGHT]).max() < 1e-12
    assert run.energy("impact")[-1] == pytest.approx(thrown * start**2 / 2, rel=1e-12)
    assert run.energy("friction")[-1] == 0.0


def test_friction_of_a_hinge_does_not_hold_against_an_impact() -> None:
    """A load caught by the end of an arm that lies across its way: ω₊ = m v r/(I + m r²)."""
    arm, inertia, thrown, start = 1.5, 80.0, 20.0, 2.0
    bodies = (
        body("hub", hinge((0, 0, 1), friction=50.0), 10.0, position=(0, -arm, 0), inertia=(1, 1, inertia)),
        body("b", point((0, 0, 0), (start, 0, 0)), thrown),
    )
    system = {
        **document(bodies, ropes=[rope("r", LENGTH, [end("hub", (0, arm, 0)), end("b")], None)]),
        "gravity": [0, 0, 0],
    }
    run = adaptive(system, LENGTH / start + 1e-4, sample_interval=1e-4)
    # The pull along x at (0, r) turns the arm to negative angles.
    expected = thrown * start * arm / (inertia + thrown * arm**2)
    turned = run.columns["body_angular_velocity"][-1, run.names["body"].index("hub"), 2]
    # Friction takes M t/(I + m r²) in the 0.1 ms since.
    assert turned == pytest.approx(-expected, abs=50.0 * 1e-4 / inertia)
    assert abs(turned) < expected
    lost = thrown * start**2 / 2 - (inertia + thrown * arm**2) * expected**2 / 2
    # Caught 0.5 µm late, the arm still straight across: second order.
    assert run.energy("impact")[-1] == pytest.approx(lost, rel=1e-9)


def test_friction_is_against_the_velocity_after_an_impact() -> None:
    """A slider that brakes with F/m is thrown back by a heavier load, and both brake with F/(m₁ + m₂)."""
    light, heavy, friction = 20.0, 60.0, 30.0
    bodies = (
        body("a", slider(ALONG, velocity=1.0, friction=friction), light),
        body("b", slider(ALONG, velocity=-2.0), heavy),
    )
    run = adaptive(joined(*bodies), 1.0)
    [(taut, _)] = run.events("taut")
    # They part by t − F t²/2m₁ + 2 t = L.
    rate = friction / light
    assert taut == pytest.approx((3.0 - math.sqrt(9.0 - 2.0 * rate * LENGTH)) / rate, abs=1e-9)
    before = light * (1.0 - rate * taut) - 2.0 * heavy
    after = before / (light + heavy) + friction / (light + heavy) * (run.time - taut)
    compared = run.time > taut + CAUGHT
    # The light one is caught up to CAUGHT later, and braked by 1.5 m/s² meanwhile.
    assert np.abs(speed(run, "a") - after)[compared].max() < 2 * rate * CAUGHT
    assert after[-1] < -1.0, "it must still move at the end"


@pytest.mark.parametrize("method", ["adaptive", "del"])
def test_a_drive_works_in_an_impact(method: str) -> None:
    """A load at rest that a rope hauled in at u catches: u p = m u² of work, ½ m u² kinetic, ½ m u² lost."""
    hauled, puller, pull = 40.0, 1.0, 0.7
    bodies = (body("a", slider(ALONG, drive="haul"), puller), body("b", slider(ALONG), hauled))
    ramps = [{"at": 0.0, "duration": 0.1, "velocity": pull}]
    system = joined(*bodies, drives=[{"name": "haul", "ramps": ramps}])
    run = adaptive(system, 3.0) if method == "adaptive" else simulate(system, 3.0, step=1e-3)
    assert speed(run, "b")[-1] == pytest.approx(pull, abs=1e-12)
    energy = hauled * pull**2
    # The puller has come to speed by its drive. A step of `del` has one force: h/2 of 0.1 s more, and its
    # loss is shared between impact and method.
    own = puller * pull**2 / 2
    late = 1e-12 if method == "adaptive" else 1.01 * own * 1e-3 / 0.1
    assert run.energy("drive_work")[-1] == pytest.approx(energy + own, rel=1e-12, abs=late)
    lost = run.energy("impact")[-1] + run.energy("method")[-1]
    assert lost == pytest.approx(energy / 2, rel=1e-9, abs=late)
    if method == "adaptive":
        assert run.energy("impact")[-1] == pytest.approx(energy / 2, rel=1e-9)
