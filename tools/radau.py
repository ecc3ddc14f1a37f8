"""Compares `adaptive` with an off-the-shelf Radau IIA of order 5, that of scipy, on the benchmark lift E(5).

Both are measured against an explicit method of order 8 at rtol 1e-11, of scipy too, on a second formulation
of the lift: minimal coordinates, written out here. In the first seconds of the lift slings go taut and slack;
from 5 s on it is smooth. Needs scipy, and prints the tables of docs/concepts/adaptive.md.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

import numpy as np
import numpy.typing as npt
from scipy.integrate import solve_ivp

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from benchmarks.lifts import Lift, equalizer_lift, gantline_document

from gantline._core import Simulation

FloatArray = npt.NDArray[np.float64]

LIFT = equalizer_lift(5)
SAMPLE = 0.01  # s
#: From here on every rope stays taut [s].
SMOOTH_FROM = 5.0
FACTORS = (30.0, 10.0, 3.0, 1.0, 0.1, 0.01)
RELATIVE = (1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 1e-5)


class Minimal:
    """E(n) in minimal coordinates, free of constraints.

    The state is yaw of the frame, drops of the sheaves, position and quaternion of the load; then their
    rates, with the angular velocity in body axes.
    """

    def __init__(self, lift: Lift) -> None:
        """The constants of `lift`."""
        self.lift = lift
        n = self.n = lift.sheaves
        self.row = np.array(lift.sheave_x)
        self.lugs = np.array([(x, y, lift.load_box[2] / 2) for x, y in lift.lugs])
        self.length = np.array(lift.sling_lengths)
        self.stiffness = np.array(lift.sling_stiffness)
        self.yaw_inertia = lift.frame_inertia + lift.sheave_mass * float(np.sum(self.row**2))
        self.inertia = np.array(lift.load_inertia)
        self.positions = 1 + n + 7
        self.calls = 0

    def start(self) -> FloatArray:
        """At rest, the shortest sling just taut."""
        y = np.zeros(self.positions + 1 + self.n + 6)
        y[1 + self.n : 8 + self.n] = (0, 0, self.lift.load_height, 1, 0, 0, 0)
        return y

    def forces(self, y: FloatArray) -> tuple[FloatArray, ...]:
        """Sling tensions, their directions from sheave to lug, lug arms, equalizing tension."""
        n, lift = self.n, self.lift
        rotation = matrix(y[4 + n : 8 + n])
        rates = y[self.positions :]
        yaw, drops = y[0], y[1 : 1 + n]
        along = np.array([np.cos(yaw), np.sin(yaw), 0.0])
        across = np.array([-np.sin(yaw), np.cos(yaw), 0.0])
        sheaves = np.outer(self.row, along)
        sheaves[:, 2] = lift.sheave_height - drops
        speeds = np.outer(self.row * rates[0], across)
        speeds[:, 2] = -rates[1 : 1 + n]
        arms = self.lugs @ rotation.T
        spin = rotation @ rates[4 + n : 7 + n]
        parts = y[1 + n : 4 + n] + arms - sheaves
        lengths = np.linalg.norm(parts, axis=1)
        parts /= lengths[:, None]
        rate = np.sum(parts * (rates[1 + n : 4 + n] + np.cross(spin, arms) - speeds), axis=1)
        tension = np.maximum(0.0, self.stiffness * (lengths - self.length + lift.damping_time * rate))
        stretch = 2 * np.sum(drops) + lift.damping_time * 2 * np.sum(rates[1 : 1 + n])
        return tension, parts, arms, np.maximum(0.0, lift.equalizing_stiffness * stretch), across, rotation

    def rate(self, _time: float, y: FloatArray) -> FloatArray:
        """ẏ."""
        self.calls += 1
        n, lift = self.n, self.lift
        tension, parts, arms, equalizing, across, rotation = self.forces(y)
        pulls = tension[:, None] * parts
        rates = y[self.positions :]
        omega = rates[4 + n : 7 + n]
        out = np.empty_like(y)
        out[: 4 + n] = rates[: 4 + n]
        w, v = y[4 + n], y[5 + n : 8 + n]
        # The quaternion is pulled back to unit length, or Newton's matrix is singular along it in effect.
        slack = 1 - w * w - v @ v
        out[4 + n] = -0.5 * v @ omega + slack * w
        out[5 + n : 8 + n] = 0.5 * (w * omega + np.cross(v, omega)) + slack * v
        accelerations = out[self.positions :]
        accelerations[0] = (
            np.sum(self.row * (pulls @ across)) - lift.yaw_damping * rates[0]
        ) / self.yaw_inertia
        accelerations[1 : 1 + n] = lift.gravity + (-pulls[:, 2] - 2 * equalizing) / lift.sheave_mass
        accelerations[1 + n : 4 + n] = -np.sum(pulls, axis=0) / lift.load_mass
        accelerations[3 + n] -= lift.gravity
        torque = rotation.T @ -np.sum(np.cross(arms, pulls), axis=0)
        accelerations[4 + n :] = (torque - np.cross(omega, self.inertia * omega)) / self.inertia
        return out


def matrix(quaternion: FloatArray) -> FloatArray:
    """Rotation matrix of a quaternion, w first."""
    w, x, y, z = quaternion / np.linalg.norm(quaternion)
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def exact(system: Minimal, until: float, times: FloatArray | None = None) -> FloatArray:
    """States by an explicit method of order 8 at rtol 1e-11: at `until`, or at `times`, one to a column."""
    found = solve_ivp(system.rate, (0, until), system.start(), "DOP853", times, rtol=1e-11, atol=1e-12)
    states: FloatArray = found.y if times is not None else found.y[:, -1]
    return states


def document(system: Minimal, y: FloatArray) -> str:
    """The lift for gantline, at the state `y`."""
    n, rates = system.n, y[system.positions :]
    spec = json.loads(gantline_document(system.lift))
    joints = {body["name"]: body["joint"] for body in spec["bodies"]}
    joints["frame"].update(position=y[0], velocity=rates[0])
    for i in range(n):
        joints[f"sheave{i}"].update(position=y[1 + i], velocity=rates[1 + i])
    quaternion = y[4 + n : 8 + n] / np.linalg.norm(y[4 + n : 8 + n])
    joints["load"].update(position=list(y[1 + n : 4 + n]), orientation=list(quaternion))
    joints["load"].update(velocity=list(rates[1 + n : 4 + n]), angular_velocity=list(rates[4 + n : 7 + n]))
    return json.dumps(spec)


def by_adaptive(text: str, duration: float, factor: float) -> tuple[FloatArray, str]:
    """Sling tensions at the samples with `factor` times the default tolerances, and what it cost."""
    method = {"tension_tolerance": 52.0 * factor, "position_tolerance": 1e-4 * factor}
    settings = {"duration": duration, "sample_interval": SAMPLE, "integrator": {"type": "adaptive", **method}}
    run = Simulation(text, json.dumps(settings))
    assert run.run()["status"] == "done"
    count = run.counters()
    # Seven stages of an attempt after the first, which is known; five looks at a step for events and books,
    # and four more where it is cut.
    evaluations = 7 * count["factorisations"] + 5 * count["steps"] + 4 * count["cut"]
    row = f"{count['steps']} | {count['rejected']} | {evaluations} | {count['factorisations']} real"
    return np.array(run.columns()["rope_tension"])[:, 1:], row


def by_radau(system: Minimal, y: FloatArray, times: FloatArray, relative: float) -> tuple[FloatArray, str]:
    """Sling tensions at the samples, and what it cost; evaluations apart from those for Jacobians."""
    system.calls = 0
    tolerances = {"rtol": relative, "atol": 0.1 * relative}
    found = solve_ivp(system.rate, times[[0, -1]], y, "Radau", dense_output=True, **tolerances)
    assert found.success, found.message
    evaluations = f"{found.nfev} + {system.calls - found.nfev}"
    row = f"{len(found.t) - 1} | | {evaluations} | {found.nlu // 2} real, as many complex"
    return np.array([system.forces(state)[0] for state in found.sol(times).T]), row


def main() -> None:
    """Print both tables."""
    system = Minimal(LIFT)
    for begin in (0.0, SMOOTH_FROM):
        count = round((LIFT.duration - begin) / SAMPLE) + 1
        times = np.linspace(begin, LIFT.duration, count)
        whole = exact(system, LIFT.duration, times)
        y = exact(system, begin) if begin else system.start()
        reference = np.array([system.forces(state)[0] for state in whole.T])

        def error(tensions: FloatArray, reference: FloatArray = reference) -> float:
            return float(np.sqrt(np.mean((tensions - reference) ** 2)) / reference[-1].mean())

        print(f"\nE(5) from {begin:g} s to {LIFT.duration:g} s")
        print("| method | rms error | steps | rejected | force evaluations | factorisations |")
        print("|---|---|---|---|---|---|")
        text = document(system, y)
        for factor in FACTORS:
            tensions, row = by_adaptive(text, LIFT.duration - begin, factor)
            print(f"| `adaptive`, {52 * factor:g} N | {error(tensions):.1e} | {row} |")
        for relative in RELATIVE:
            tensions, row = by_radau(system, y, times, relative)
            print(f"| Radau IIA, rtol {relative:g} | {error(tensions):.1e} | {row} |")


if __name__ == "__main__":
    main()
