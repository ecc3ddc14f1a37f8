"""A sled and a pendulum with dry friction aboard a vessel that moves by its RAOs, against own equations.

Three ways and three turns of one beam sea have the place p(t) and the axes R(t) = yaw pitch roll of the
vessel, with their derivatives (WM1). Aboard, r goes along with a coordinate q by u = dr/dq, to which du/dq is
square; nor has what goes along u any Coriolis force there, u·Rᵀ R' u = 0. With dry friction F, spring and
damper of the stops of the sled included,

    |u|² q'' = - F/m - u·Rᵀ (p'' + R'' r - g)

for a sled along y, u = (0, 1, 0), and a mass on a rod about x, u = l (0, cos q, sin q). Friction is
F tanh(q'/v) here, with v far below every speed, which creeps by v where it should hold; scipy's LSODA solves
that.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from gantline.simulation import simulate
from mechanics import Floats, G

PERIOD, HEIGHT, DIRECTION, LASTS = 8.0, 2.4, math.radians(70.0), 40.0
OMEGA, DRAFT = 2 * math.pi / PERIOD, 4.0
#: Per metre of wave, m or deg, and lags [deg]: surge, sway, heave, roll, pitch, yaw.
NAMES = ("surge", "sway", "heave", "roll", "pitch", "yaw")
RAOS = np.array([0.3, 0.7, 0.9, 9.0, 1.5, 0.8])
LAGS = np.array([20.0, -90.0, 5.0, 80.0, -60.0, 140.0])
#: Point of the RAOs, and where the sled begins and the pendulum hangs, from stern and keel [m].
POINT, SLED, HUNG = np.array([55.0, 2, 9]), np.array([60.0, -3, 8.5]), np.array([30.0, 4, 22])
SLED_MASS, HELD, STROKE, STOP, TAU = 20e3, 2e4, 1.2, 2e6, 0.02
HUNG_MASS, ROD, TURNS_BY = 5e3, 8.0, 6e4
#: Speed at which friction has 76 % of its size [m/s or rad/s].
STEEP = 1e-7
#: What waves have at the point, as it lies at the start.
AHEAD = np.array([math.cos(DIRECTION), math.sin(DIRECTION)]) * OMEGA**2 / G
UNITS = np.array([1.0, 1.0, 1.0, *[math.pi / 180] * 3])
AMPLITUDES = HEIGHT / 2 * RAOS * UNITS * np.exp(1j * (np.radians(LAGS) + AHEAD @ POINT[:2]))

Moved = tuple[Floats, Floats, Floats]


def motions(time: float) -> Moved:
    """All six, their speeds and accelerations; they grow over three periods."""
    swing = AMPLITUDES * np.exp(-1j * OMEGA * time)
    value, rate, second = swing.real, (-1j * OMEGA * swing).real, -(OMEGA**2) * swing.real
    rise = 3 * PERIOD
    s = min(time / rise, 1.0)
    grown = s**3 * (10 - 15 * s + 6 * s**2)
    growing = 30 * s**2 * (1 - s) ** 2 / rise
    faster = 60 * s * (1 - s) * (1 - 2 * s) / rise**2
    return (
        grown * value,
        growing * value + grown * rate,
        faster * value + 2 * growing * rate + grown * second,
    )


def turn(axis: int, angle: float, rate: float, second: float) -> Moved:
    """A rotation matrix about an axis, with both derivatives."""
    cross = np.cross(np.eye(3), np.eye(3)[axis])
    cross = -cross.T
    here = np.eye(3) + math.sin(angle) * cross + (1 - math.cos(angle)) * cross @ cross
    return here, rate * cross @ here, second * cross @ here + rate**2 * cross @ cross @ here


def product(one: Moved, other: Moved) -> Moved:
    """Of matrices with both derivatives."""
    (a, a1, a2), (b, b1, b2) = one, other
    return a @ b, a1 @ b + a @ b1, a2 @ b + 2 * a1 @ b1 + a @ b2


def aboard(time: float, place: Floats, way: Floats) -> float:
    """u·Rᵀ (p'' + R'' r - g)."""
    _, _, accelerated = moved = motions(time)
    yaw, pitch, roll = (turn(axis, *(float(part[3 + axis]) for part in moved)) for axis in (2, 1, 0))
    axes, _, faster = product(product(yaw, pitch), roll)
    return float(way @ axes.T @ (accelerated[:3] + faster @ (place - POINT) + np.array([0.0, 0.0, G])))


def sled(time: float, state: Floats) -> list[float]:
    q, speed, _ = state
    friction = HELD * math.tanh(speed / STEEP)
    ends = max(0.0, STOP * (q - STROKE + TAU * speed)) - max(0.0, STOP * (-q - STROKE - TAU * speed))
    along = np.array([0.0, 1.0, 0.0])
    return [speed, -(friction + ends) / SLED_MASS - aboard(time, SLED + q * along, along), friction * speed]


def pendulum(time: float, state: Floats) -> list[float]:
    q, speed, _ = state
    friction = TURNS_BY * math.tanh(speed / STEEP)
    place = HUNG + ROD * np.array([0.0, math.sin(q), -math.cos(q)])
    felt = aboard(time, place, ROD * np.array([0.0, math.cos(q), math.sin(q)]))
    return [speed, -(friction / HUNG_MASS + felt) / ROD**2, friction * speed]


def written(folder: Path) -> Path:
    """The lift file and its table, which is the same for all directions and periods."""
    columns = ",".join(
        f"{name} [{'m' if unit == 1.0 else 'deg'}/m],{name} phase [deg]"
        for name, unit in zip(NAMES, UNITS, strict=True)
    )
    values = ",".join(f"{rao},{lag}" for rao, lag in zip(RAOS, LAGS, strict=True))
    lines = [f"{way},{period},{values}" for way in range(0, 360, 45) for period in (6.0, PERIOD, 12.0)]
    table = "\n".join([f"direction [deg],period [s],{columns}", *lines])
    (folder / "barge.csv").write_text(f"{table}\n", encoding="utf-8")

    def metres(place: Floats) -> list[str]:
        return [f"{part} m" for part in place]

    stops = {"lower": f"{-STROKE} m", "upper": f"{STROKE} m", "stiffness": f"{STOP} N/m"}
    slides: dict[str, Any] = {"type": "slider", "axis": [0, 1, 0], "friction": f"{HELD} N"}
    slides["stops"] = {**stops, "damping": f"{STOP * TAU} N s/m"}
    swings = {"type": "hinge", "axis": [1, 0, 0], "friction": f"{TURNS_BY} N m"}
    hangs = {"centre_of_gravity": ["0 m", "0 m", f"{-ROD} m"], "mass": f"{HUNG_MASS} kg"}
    given = {
        "format": 1,
        "lift": {"title": "Friction aboard"},
        "duration": f"{LASTS} s",
        "start": "as_given",
        "water": {},
        "waves": {
            "swell": {
                "height": f"{HEIGHT} m",
                "period": f"{PERIOD} s",
                "direction": f"{math.degrees(DIRECTION)} deg",
            }
        },
        "vessels": {
            "barge": {
                "draft": f"{DRAFT} m",
                "hull": {"box": ["100 m", "30 m", "8 m"]},
                "wave_motion": {"raos": "barge.csv", "phases": "lag", "at": metres(POINT)},
            }
        },
        "mechanics": {
            "bodies": {
                "sled": {"parent": "barge", "at": metres(SLED), "joint": slides, "mass": f"{SLED_MASS} kg"},
                "bob": {"parent": "barge", "at": metres(HUNG), "joint": swings, **hangs},
            }
        },
    }
    path = folder / "lift.yaml"
    path.write_text(json.dumps(given), encoding="utf-8")
    return path


def test_what_sticks_and_slides_aboard(tmp_path: Path) -> None:
    """Ways over 40 s within what STEEP lets creep, 4e-6, some three times; the heat of friction to 1e-6."""
    run = simulate(written(tmp_path), position_tolerance=1e-8, tension_tolerance=1.0)
    heat = 0.0
    own: tuple[tuple[str, Callable[[float, Floats], list[float]]], ...] = (("sled", sled), ("bob", pendulum))
    for name, rates in own:
        solved = solve_ivp(
            rates, (0, LASTS), [0.0] * 3, "LSODA", run.time, rtol=1e-8, atol=1e-10, max_step=0.05
        ).y
        found = run.column("joint_position", name)
        assert np.ptp(found) > 1.0, "it must go"
        assert np.abs(found - solved[0]).max() < 3 * STEEP * LASTS
        heat += solved[2, -1]
    held = np.diff(run.column("joint_position", "sled"))[run.time[1:] > 3 * PERIOD] == 0.0
    assert 0.1 < held.mean() < 0.9, "it must stick and slide"
    kinds = run.coordinates["energy_kind"]
    assert run.variables["energy"].values[-1, kinds.index("friction")] == pytest.approx(heat, rel=1e-6)
    assert {name for _, _, name in run.events("stop_hit")} == {"sled"}
    assert run.attributes["energy_remainder"] < 1e-12
