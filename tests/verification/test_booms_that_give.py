"""Booms that give upright and aside, by the stiffness of the crane at the head, against closed forms.

The crane is the sheerleg of `boom_lift` without tackles: 110 m, 1500 t with its centre at 48 %, head gear of
140 t, at 60 degrees unless said otherwise. k_v is 15 MN/m and k_s 6 MN/m, so that with R = 110 m cos 60 deg

    K_v = k_v R^2 = 45.4 GN m/rad,   K_s = k_s (110 m)^2 = 72.6 GN m/rad.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import gantline
from boom_lift import (
    BOOM,
    BOOM_INERTIA,
    CENTRE,
    HEAD_GEAR,
    HEEL,
    HOOK_BLOCK,
    LENGTH,
    SHEAVE_BLOCK,
    boom_lift,
    head,
    simulated,
    weight_moment,
)
from gantline.scenario import parse_scenario
from gantline.statics import Statics
from mechanics import Floats, G

ANGLE = math.radians(60.0)
UPRIGHT = 15e6 * (LENGTH * math.cos(ANGLE)) ** 2
ASIDE = 6e6 * LENGTH**2
#: Of boom and head gear about the heel pins along its own z: the two legs are 28 m apart at their feet.
INERTIA_ASIDE = BOOM_INERTIA + BOOM * 28.0**2 / 12
VERTICAL = "vertical_stiffness: 15 MN/m"
BOTH = f"{VERTICAL}, side_stiffness: 6 MN/m"


def gives(keys: str, lift: str) -> str:
    """The lift with a boom that gives."""
    return lift.replace("mass: 1500 t,", f"mass: 1500 t, {keys},")


def nearly_empty(lift: str) -> str:
    """The lift with next to nothing at the head beside its gear: 3 kg of hook and sheave block and load."""
    for mass in ("{mass: 50 t, height", "sheave_block_mass: 8 t", "mass: 300 t"):
        lift = lift.replace(
            mass, mass.replace("50 t", "1 kg").replace("8 t", "1 kg").replace("300 t", "1 kg")
        )
    return lift


def to_the_ground(angle: float, length: str) -> str:
    """A rope from the hook, 40 m up, to 30 m below the head of a boom at an angle [rad]."""
    foot = f"{{type: end, body: world, at: [{head(angle)[0]!r} m, 0 m, 30 m]}}"
    route = f"[{{type: end, body: fc.H1}}, {foot}]"
    return f"  ropes:\n    pull: {{rope: luff, length: {length}, route: {route}}}\n"


def squares(lift: str) -> list[float]:
    """Of the frequencies in which it swings [rad^2/s^2]."""
    statics = Statics(parse_scenario(lift))
    statics.equilibrium(0.0)
    return [mode.square for mode in statics.modes()]


def test_it_stands_as_the_lift_file_has_it_with_what_hangs_there() -> None:
    """Springs are loaded by boom, hook blocks and what hangs freely: nothing moves, and nothing is lost."""
    recording = simulated(gives(BOTH, boom_lift(duration=2.0)))
    assert recording["boom_angle"].values == pytest.approx(ANGLE, abs=1e-12)
    assert recording.metrics()["energy_remainder"] < 1e-11


@pytest.mark.parametrize("angle", [40.0, 60.0, 75.0])
def test_a_pull_at_the_head_bends_it_down(angle: float) -> None:
    """A rope from the hook to the ground, 0.15 m too short, against moments about the heel pins.

    M0 - K_v (theta - theta0) = M(theta) + moment of T, where M is that of what hangs freely and M0 at theta0;
    T leans, since the head goes ahead as it sinks. To the first order it sinks by the force over k_v, and by
    what the weight has more of lever then.
    """
    start = math.radians(angle)
    below = to_the_ground(start, "9.85 m")
    lift = boom_lift(duration=0.1, start="rest", angle=angle, ropes=below, luff_stiffness=200.0)
    lift = gives(VERTICAL, lift)
    recording = simulated(lift)
    found = float(recording["boom_angle"].values[0, 0])
    pull = float(recording.column("rope_tension", "pull")[0])
    stiffness = 15e6 * (LENGTH * math.cos(start)) ** 2
    on_head = SHEAVE_BLOCK + HOOK_BLOCK + 300e3
    spring = weight_moment(start, on_head) - stiffness * (found - start)
    assert pull > 1e6
    hook = recording.dataset["body_position"].sel(body="fc.H1").values[0]
    way = np.array((head(start)[0], 0.0, 30.0)) - hook
    (aside, _, down), ahead, high = pull * way / np.linalg.norm(way), *head(found)
    borne = weight_moment(found, on_head) - down * (ahead - HEEL[0]) + aside * (high - HEEL[1])
    # The sheave block leans along with its falls, by 1e-3: its centre is 0.6 m below the head.
    assert spring == pytest.approx(borne, rel=1e-6)
    softer = 1 - weight_moment(start, on_head) * math.tan(start) / stiffness
    upright = (borne - weight_moment(found, on_head)) / (LENGTH * math.cos(found))
    # Levers grow as it sinks, by tan(theta) (theta0 - theta): 1.2 % at 75 deg.
    assert head(start)[1] - head(found)[1] == pytest.approx(upright / 15e6 / softer, rel=0.02)


def test_it_swings_upright_as_a_spring_and_a_mass() -> None:
    """omega^2 = (K_v - M tan theta)/I, (BM8): as the boom sinks the moment of its weight grows."""
    expected = (UPRIGHT - weight_moment(ANGLE, 3.0) * math.tan(ANGLE)) / BOOM_INERTIA
    found = squares(nearly_empty(gives(VERTICAL, boom_lift(start="rest"))))
    # 3 kg of 1640 t hang there.
    assert min(abs(one / expected - 1) for one in found) < 1e-5


def test_it_swings_aside_as_a_spring_and_a_mass() -> None:
    """omega^2 = (K_s - g sin theta sum(m s))/I_z, (BM9): the boom leans over as it goes aside."""
    leans = G * math.sin(ANGLE) * LENGTH * (CENTRE * BOOM + HEAD_GEAR)
    expected = (ASIDE - leans) / INERTIA_ASIDE
    for keys in (BOTH, "side_stiffness: 6 MN/m"):
        found = squares(nearly_empty(gives(keys, boom_lift(start="rest"))))
        assert min(abs(one / expected - 1) for one in found) < 1e-5


#: Luffed down by 5 deg at 10 deg/min, with 5 % of damping.
OUT = "{step: out, luff: fc, speed: 10 deg/min, acceleration: 0.05 deg/s^2, to: 55 deg}"
LUFFED = nearly_empty(gives(f"{VERTICAL}, damping: 5 %", boom_lift(OUT, duration=20.0)))


def test_it_lags_behind_the_angle_that_it_is_told() -> None:
    """Against the equation of the boom alone.

    I theta'' = M(theta0) - K (phi + tau phi') - M(theta), phi = theta - told(t); the speed of what is told
    grows by 0.05 deg/s^2 and falls likewise. tau = 2 zeta sqrt(I/K), by which damping is given.
    """
    recording = simulated(LUFFED)
    speed, ramp = math.radians(10 / 60), 10 / 60 / 0.05
    damping_time = 2 * 0.05 * math.sqrt(BOOM_INERTIA / UPRIGHT)

    def told(time: float) -> tuple[float, float]:
        run = min(time, ramp)
        way = speed * (run * run / ramp / 2 + max(time - ramp, 0.0))
        return ANGLE - way, -speed * run / ramp

    def rate(time: float, state: Floats) -> list[float]:
        angle, turning = told(time)
        lag, lagging = state[0] - angle, state[1] - turning
        moment = weight_moment(ANGLE, 3.0) - UPRIGHT * (lag + damping_time * lagging)
        return [state[1], (moment - weight_moment(float(state[0]), 3.0)) / BOOM_INERTIA]

    solved = solve_ivp(
        rate, (0, 20), [ANGLE, 0.0], t_eval=recording.time, rtol=1e-11, atol=1e-13, max_step=0.1
    )
    found = recording["boom_angle"].values[:, 0]
    # It lags by up to 0.5 mrad; 1 um at the head is 1e-8 rad.
    lag = np.array([angle - told(time)[0] for time, angle in zip(recording.time, found, strict=True)])
    assert float(np.ptp(lag)) > 3e-4
    assert found == pytest.approx(solved.y[0], abs=3e-7)
    assert recording.metrics()["energy_remainder"] < 1e-6


def test_by_del_it_lags_alike_to_the_first_order() -> None:
    """Half of the step leaves half of the difference to `adaptive`, 2.1e-6 rad at 1 ms."""
    lift = parse_scenario(LUFFED)
    exact = gantline.simulate(lift)["boom_angle"].values
    off = [
        float(np.abs(gantline.simulate(lift, integrator="del", step=step)["boom_angle"].values - exact).max())
        for step in (2e-3, 1e-3)
    ]
    assert off[1] < 3e-6
    assert off[0] / off[1] == pytest.approx(2.0, rel=0.05)


def test_lifting_a_load_off_keeps_the_books() -> None:
    """A hook hauled against a rope to the ground until that bears 150 t: energy of both springs is booked."""
    plan = "{step: up, hoist: fc.H1, speed: 3 m/min, by: 0.5 m}\n{step: hold, hold: until_end}"
    below = to_the_ground(ANGLE, "10 m")
    lift = boom_lift(plan, duration=20.0, start="rest", ropes=below, luff_stiffness=80.0)
    recording = simulated(gives(BOTH, lift))
    assert float(recording.column("rope_tension", "pull").max()) > 1.5e6
    assert float(recording["boom_angle"].values[:, 0].min()) < ANGLE - 1e-3
    assert recording.metrics()["energy_remainder"] < 1e-6


#: A light boom of 60 m at 60 deg whose crane gives by 10 MN/m, and ropes that hardly stretch.
OFF_A_DECK = """\
format: 1
lift: {title: A load off a deck}
duration: 3 s
ground: {friction: 0.5}
ropes:
  stiff: {axial_stiffness: 1e4 MN, damping_time: 1 ms, mass: none, diameter: 54 mm,
    minimum_breaking_force: 4500 kN}
load:
  name: crate
  shape: {box: [3 m, 3 m, 3 m]}
  weight: {calculated: 100 t}
  centre_of_gravity: {at: [0 m, 0 m, 1.5 m]}
  position: [30 m, 0 m, 0 m]
  stands_on: ground
  lugs: {top: {at: [0 m, 0 m, 3 m]}}
hook_types:
  H:
    block: {mass: 100 kg, height: 1 m}
    reeving: {ropes: 1, parts_each: 4, rope: stiff, sheave_diameter: 1.2 m, below_head: 1.3 m,
      sheave_block_mass: 10 kg}
    drum: {diameter: 1.6 m}
    hoist: {speed: 30 m/min, acceleration: 2 m/s^2}
cranes:
  pc:
    type: floating_crane
    position: [0 m, 0 m, 0 m]
    outreach_from: 0 m
    boom: {heel_pins: {at: [0 m, 0 m, 20 m], apart: 3 m}, length: 60 m, angle: 60 deg, mass: 500 kg,
      vertical_stiffness: 10 MN/m, damping: 0 %}
    hooks:
      H: {type: H, height: 10 m}
slings:
  S: {from: pc.H, to: crate.top, length: 7.02 m, rope: stiff}
plan:
  - {step: up, hoist: pc.H, speed: 12 m/min, by: 3 m}
  - {step: hold, hold: until_end}
simulation: {sample_interval: 5 ms}
"""


def test_a_load_that_is_jerked_off_pulls_as_the_rule_for_pedestal_cranes_has_it() -> None:
    """W (1 + v sqrt(K/(g W))): the dynamic coefficient of API Spec 2C (sixth edition, 2004).

    Hoisted at v = 12 m/min off ground that stays, a load of m = 100 t pulls with W as it leaves, and with
    v sqrt(K m) more a quarter of its period 2 pi sqrt(m/K) later.
    """
    recording = simulated(OFF_A_DECK)
    pull = recording.column("rope_tension", "sling.S")
    mass, stiffness, speed = 100e3, 10e6, 0.2
    expected = mass * G * (1 + speed * math.sqrt(stiffness / mass) / G)
    # The ground springs back at 1.2 % of v, ropes take 1.6 % of K and the weight 0.6 %: 2.3 % of what is
    # above the weight, which is a fifth of it; and the boom itself weighs 0.2 t at its head.
    assert float(pull.max()) == pytest.approx(expected, rel=0.01)
    leaves = next(time for time, _, _ in recording.events("lift_off"))
    quarter = math.pi / 2 * math.sqrt(mass / stiffness)
    assert float(recording.time[np.argmax(pull)]) - leaves == pytest.approx(quarter, rel=0.1)
