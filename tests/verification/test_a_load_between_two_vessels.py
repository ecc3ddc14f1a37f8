"""A load on four ropes between two vessels that a swell moves by their RAOs, against its equations of motion.

Two of the ropes lead to masts of `one`, two to masts of `two`, which lies the other way round and has answers
of its own. What a vessel does is written out from docs/concepts/wave_motion.md: the point of its table at s
goes by Re X a g(t) exp(i (κ e·s − ω t)), X from the direction in its own axes, and turns by yaw, pitch and
roll about the axes of the vessel. The load is a rigid body: m v̇ = Σ T e + m g, and in its own axes
I ω̇ = Σ l × Rᵀ T e − ω × I ω, with T = max(0, EA/L (ℓ − L + τ ℓ̇)) of the rope to the lug at l.
"""

from __future__ import annotations

import json
import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicSpline
from scipy.spatial.transform import Rotation

from gantline.hydro.raos import DisplacementRaos, write_raos
from gantline.simulation import simulate
from mechanics import Floats, G
from rigid import points_of, rates_of

PERIOD, HEIGHT, TOWARDS = 8.0, 1.5, math.radians(40.0)
OMEGA = 2 * math.pi / PERIOD
DRAFT, DURATION = 4.0, 32.0
#: The load [kg, kg m²], where it hangs [m], its ropes [N, s].
MASS, INERTIA, PLACE = 120e3, np.array([4e5, 9e5, 1.1e6]), np.array([56.0, 30.0, 12.0])
EA, DAMPED = 30e6, 0.01
LUGS = np.array([[4.0, -2.0, 1.5], [-4.0, -2.0, 1.5], [4.0, 2.0, 1.5], [-4.0, 2.0, 1.5]])
#: Of their masts, in the world as all is at rest.
TOPS = np.array([[60.0, 25.0, 45.0], [52.0, 25.0, 45.0], [60.0, 36.0, 41.0], [52.0, 36.0, 41.0]])
#: A little short, so that at the start each pulls with EA·0.0015.
LENGTHS = 0.9985 * np.linalg.norm(TOPS - PLACE - LUGS, axis=1)
#: Of the table, both with the swell in a row of it: as seen from `one` it runs to 40°, from `two` to −160°.
FREQUENCIES, DIRECTIONS = np.array([0.4, 0.6, OMEGA, 1.0]), np.radians(np.arange(-160.0, 181.0, 20.0))


@dataclass(frozen=True)
class Vessel:
    """Stern [m], heading [rad] and the point of the table, from stern and keel [m].

    `answers`: X = (c₀ + c₁ cos β + c₂ sin β) 0.5/ω, shape (3, 6).
    """

    stern: Floats
    heading: float
    at: Floats
    answers: Floats

    def table(self, omega: float, direction: float) -> Any:
        by = self.answers[0] + self.answers[1] * math.cos(direction) + self.answers[2] * math.sin(direction)
        return by * 0.5 / omega

    @property
    def upright(self) -> Rotation:
        return Rotation.from_euler("z", self.heading)

    def aboard(self, place: Floats) -> Floats:
        """From stern and keel to a place in the world, as it lies at rest."""
        return np.array(self.upright.inv().apply(place - [*self.stern, -DRAFT]))

    def way(self, aboard: Floats, time: Floats) -> Floats:
        """Places of a point aboard in the world, shape (n, 3)."""
        share = np.clip(time / (3 * PERIOD), 0.0, 1.0)
        growth = share**3 * (10.0 - 15.0 * share + 6.0 * share**2)
        pointed = self.upright.apply(self.at) + np.array([*self.stern, -DRAFT])
        phase = OMEGA**2 / G * (pointed[:2] @ [math.cos(TOWARDS), math.sin(TOWARDS)])
        size = HEIGHT / 2 * self.table(OMEGA, TOWARDS - self.heading) * np.exp(1j * phase)
        moved = growth[:, np.newaxis] * (np.exp(-1j * OMEGA * time)[:, np.newaxis] * size).real
        turned = self.upright * Rotation.from_euler("ZYX", moved[:, :2:-1])
        found = pointed + self.upright.apply(moved[:, :3]) + turned.apply(aboard - self.at)
        return np.array(found)


def answers(seed: int) -> Any:
    """Of any vessel: some tenths of a metre and degrees in such a swell."""
    real, imaginary = np.random.default_rng(seed).normal(size=(2, 3, 6))
    return (real + 1j * imaginary) * [0.5, 0.5, 0.6, 0.02, 0.012, 0.006]


VESSELS = {
    "one": Vessel(np.zeros(2), 0.0, np.array([50.0, 3.0, 8.0]), answers(1)),
    "two": Vessel(np.array([20.0, 75.0]), math.radians(200.0), np.array([70.0, -2.0, 7.0]), answers(2)),
}
MASTS = ("one", "one", "two", "two")


def lift(folder: Path) -> Path:
    """The lift file beside both tables."""

    def metres(values: Floats) -> list[str]:
        return [f"{float(value)!r} m" for value in values]

    afloat = {}
    for name, vessel in VESSELS.items():
        motion = np.array([[vessel.table(w, b) for b in DIRECTIONS] for w in FREQUENCIES])
        write_raos(DisplacementRaos(name, FREQUENCIES, DIRECTIONS, motion), folder / f"{name}.csv")
        afloat[name] = {
            "position": metres(vessel.stern),
            "heading": f"{math.degrees(vessel.heading)!r} deg",
            "draft": f"{DRAFT} m",
            "hull": {"box": ["100 m", "20 m", "8 m"]},
            "wave_motion": {"raos": f"{name}.csv", "phases": "lag", "at": metres(vessel.at)},
        }
    ropes = {
        f"r{k}": {
            "rope": "fall",
            "length": f"{float(LENGTHS[k])!r} m",
            "stretched": True,
            "route": [
                {"type": "end", "body": mast, "at": metres(VESSELS[mast].aboard(TOPS[k]))},
                {"type": "end", "body": "load", "at": metres(LUGS[k])},
            ],
        }
        for k, mast in enumerate(MASTS)
    }
    inertia = {f"{axis}{axis}": f"{part} kg m^2" for axis, part in zip("xyz", INERTIA.tolist(), strict=True)}
    load = {"at": metres(PLACE), "joint": {"type": "free"}, "mass": f"{MASS} kg", "inertia": inertia}
    swell = {
        "height": f"{HEIGHT} m",
        "period": f"{PERIOD} s",
        "direction": f"{math.degrees(TOWARDS)!r} deg",
    }
    given = {
        "format": 1,
        "lift": {"title": "A load between two vessels"},
        "duration": f"{DURATION} s",
        "start": "as_given",
        "water": {"level": "0 m"},
        "waves": {"swell": swell},
        "ropes": {
            "fall": {"axial_stiffness": f"{EA} N", "damping_time": f"{DAMPED} s", "mass": "none"}
        },
        "vessels": afloat,
        "mechanics": {"bodies": {"load": load}, "ropes": ropes},
        "simulation": {"sample_interval": "0.1 s", "gravity": f"{G} m/s^2"},
    }  # fmt: skip
    path = folder / "lift.yaml"
    path.write_text(json.dumps(given), encoding="utf-8")
    return path


def pulled(time: float, load: Floats, tops: Any, speeds: Any) -> tuple[Floats, Floats, Floats]:
    """Tensions (4,), directions of the ropes from the lugs, and the places of these, shape (4, 3)."""
    lugs, moving = points_of(load, LUGS)
    aside = tops(time) - lugs
    long = np.sqrt((aside**2).sum(axis=1))
    along = aside / long[:, np.newaxis]
    faster = (along * (speeds(time) - moving)).sum(axis=1)
    return np.maximum(0.0, EA / LENGTHS * (long - LENGTHS + DAMPED * faster)), along, lugs


def own(times: Floats) -> tuple[Floats, Floats]:
    """Place, attitude, velocity and spin (n, 13) of the load, and tensions (n, 4)."""
    # Splines through ways 20 ms apart are exact to h⁴ ω⁴/384 of these, 1e-10.
    fine = np.arange(0.0, DURATION + 0.03, 0.02)
    ways = [VESSELS[mast].way(VESSELS[mast].aboard(top), fine) for mast, top in zip(MASTS, TOPS, strict=True)]
    tops = CubicSpline(fine, np.stack(ways, axis=1))
    speeds = tops.derivative()

    def rates(time: float, load: Floats) -> Floats:
        tensions, along, lugs = pulled(time, load, tops, speeds)
        return rates_of(load, MASS, np.diag(INERTIA), tensions[:, np.newaxis] * along, lugs)

    start = np.array([*PLACE, 1.0, *[0.0] * 9])
    found = solve_ivp(rates, (0.0, DURATION), start, "DOP853", times, rtol=1e-9, atol=1e-10).y.T
    return found, np.array([pulled(time, y, tops, speeds)[0] for time, y in zip(times, found, strict=True)])


def test_a_load_on_ropes_from_two_vessels(tmp_path: Path) -> None:
    """Place and attitude of the load, and tensions, as the swell grows and after.

    A step of the run leaves 1e-6 m, some hundred of them, one way or the other, 2e-5 m. A rope has
    EA/L = 1.1 MN/m at the most, so that these are 22 N; a table of 12 digits and the spline are far below.
    """
    run = simulate(lift(tmp_path), tension_tolerance=1.0, position_tolerance=1e-6)
    found, tensions = own(run.time)
    ropes = np.stack([run.column("rope_tension", f"r{k}") for k in range(4)], axis=1)
    attitude = run.column("body_orientation", "load")
    size = np.linalg.norm(found[:, 3:7], axis=1)
    turned = np.abs((attitude * found[:, 3:7]).sum(axis=1) / size)
    assert np.abs(run.column("body_position", "load") - found[:, :3]).max() < 2e-5
    # Of the angle θ between both attitudes, 1 - cos θ/2; at the lugs, 4.7 m off, 2e-5 m.
    assert (1.0 - turned).max() < (2e-5 / 4.7) ** 2 / 8
    assert np.abs(ropes - tensions).max() < 22.0
    # It is a motion worth the name: ropes carry from a fifth of their share to twice as much as that.
    assert np.ptp(found[:, :3], axis=0).max() > 0.5
    assert tensions.min() < 0.2 * MASS * G / 4 and tensions.max() > 2 * MASS * G / 4
