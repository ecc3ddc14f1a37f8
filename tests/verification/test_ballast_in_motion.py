"""A crane barge that is pumped quickly while it rolls and its load swings, against equations of their own.

Those of `tests/support/crane_barge.py`, with contents that are told over time. Liquid that joins has the
velocity of the barge there, and what leaves takes its own along, so that at each moment the equations are
those of a barge with these contents (Meshchersky with no relative velocity): its mass, centre and inertia
with the liquids frozen upright, boxes of m/12 (b² + h²), and their surfaces level. scipy's DOP853 solves it.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from crane_barge import MASS, TANKS, TIP, Tank, inertia_of_all, rates, rotation, system
from mechanics import Floats, adaptive, body
from rigid import across

#: When pumps begin and stop [s], and how long they take to come to their rates and to stop [s].
BEGIN, STOP, RAMP = 0.4, 2.6, 0.5
CENTRE = np.array([0.3, -0.2, 3.0])


def pumped(time: float, rate: float) -> float:
    """Mass that has come in [kg]: half a ramp is lost where a pump starts, and won where it stops."""

    def since(begin: float) -> float:
        late = max(0.0, time - begin)
        return late**2 / (2 * RAMP) if late < RAMP else late - RAMP / 2

    return rate * (since(BEGIN) - since(STOP))


def frozen(tank: Tank) -> tuple[float, Floats, Floats]:
    """Mass, centre, and inertia about the barge's origin (6, 6) of a liquid that lies upright."""
    mass, depth = tank.density * tank.volume, tank.volume / tank.size[0] / tank.size[1]
    sides = np.array([tank.size[0], tank.size[1], depth])
    centre = tank.lowest + sides / 2
    arm = across(centre)
    own = mass / 12 * np.diag((sides**2).sum() - sides**2)
    return mass, centre, np.block([[mass * np.eye(3), -mass * arm], [mass * arm, own - mass * arm @ arm]])


@pytest.mark.parametrize("flows", [(-2.5e4, 2.5e4), (1.2e4, -3e4)], ids=["to and fro", "from the sea"])
def test_a_barge_that_is_pumped_while_its_load_swings(flows: tuple[float, float]) -> None:
    """Place, attitude and load over 4 s in which up to 66 t of 240 t go from tank to tank, or come aboard."""
    duration, own = 4.0, inertia_of_all(CENTRE)

    def moving(time: float, state: Floats) -> Floats:
        tanks = [
            replace(tank, volume=tank.volume + pumped(time, flow) / tank.density)
            for tank, flow in zip(TANKS, flows, strict=True)
        ]
        liquids = [frozen(tank) for tank in tanks]
        mass = MASS + sum(liquid for liquid, _, _ in liquids)
        centre = (MASS * CENTRE + sum(liquid * place for liquid, place, _ in liquids)) / mass
        inertia = own + sum(matrix for _, _, matrix in liquids)
        return rates(time, state, centre, inertia, mass=mass, tanks=tanks)

    q = np.array([0.99, 0.08, -0.03, 0.1])
    q /= np.linalg.norm(q)
    turn, place = rotation(q), np.array([0, 0, -3.6])
    load = place + turn @ TIP + np.array([1.0, 2.0, -11.8])
    velocity = turn.T @ np.array([0.5, 0.3, -0.4])
    start = np.concatenate([place, q, velocity, [0.05, 0.03, 0.02], load, np.zeros(3)])
    times = np.linspace(0, duration, 9)
    own_way = solve_ivp(
        moving, (0, duration), start, "DOP853", times, rtol=1e-8, atol=1e-9, max_step=0.05
    ).y.T
    given = system(start, CENTRE)
    given["drives"] = []
    tanks = [force for force in given["forces"] if force["type"] == "tank"]
    for number, (tank, flow) in enumerate(zip(tanks, flows, strict=True)):
        content, pump = f"content{number}", f"pump{number}"
        tank["pumped"] = {"content": content, "level": 0.0}
        given["bodies"].append(body(content, {"type": "content", "drive": pump}, 0.0, parent="barge"))
        ramps = [{"at": at, "duration": RAMP, "velocity": rate} for at, rate in ((BEGIN, flow), (STOP, 0.0))]
        given["drives"].append({"name": pump, "ramps": ramps})
    run = adaptive(
        given, duration, tension_tolerance=0.1, position_tolerance=1e-8, sample_interval=duration / 8
    )
    places = np.array([one[:3] + rotation(one[3:7]) @ CENTRE for one in own_way])
    # 0.1 N and 10 nm in a step; 2e-7 m at the load were found of random ones, 6e-6 where a deck goes under.
    assert np.abs(run.body("barge") - places).max() < 1e-6
    assert np.abs(run.body("load") - own_way[:, 13:16]).max() < 5e-6
    alike = (run.body("barge", "body_orientation") * own_way[:, 3:7]).sum(axis=1)
    assert np.abs(np.abs(alike / np.linalg.norm(own_way[:, 3:7], axis=1)) - 1.0).max() < 1e-12
    for number, flow in enumerate(flows):
        moved = [pumped(time, flow) for time in times]
        assert run.joint(f"content{number}") == pytest.approx(moved, rel=1e-12, abs=1e-6)
    assert run.energy_remainder < 1e-7
