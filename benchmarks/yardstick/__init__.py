"""The yardstick: a C program for the lifts E(n) alone, compiled for this machine when it is first used."""

from __future__ import annotations

import ctypes
import hashlib
import math
import os
import shlex
import subprocess
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from benchmarks.contract import SAMPLE_INTERVAL, FloatArray, Setting, Unfit, sample_count
from benchmarks.lifts import Lift

SOURCE = Path(__file__).parent / "equalizer_lift.c"
BUILD = Path(__file__).resolve().parents[2] / "build" / "bench"
FLAGS = ("-O3", "-march=native", "-shared", "-fPIC")
VECTOR_FLAGS = (
    *("-fno-math-errno", "-fno-trapping-math", "-fno-signed-zeros", "-fassociative-math"),
    *("-freciprocal-math", "-ffinite-math-only", "-fopenmp-simd"),
)
"""With these the compiler may reorder sums, and so works on several sheaves at a time. Not by `-ffast-math`:
that sets subnormal numbers to zero in all of the process that loads the library, and others then fail."""
PACES = (14, 12, 10, 9, 8, 7)


class _Lift(ctypes.Structure):
    """As `Lift` in the C source."""

    _fields_ = (
        ("frame_inertia", ctypes.c_double),
        ("yaw_damping", ctypes.c_double),
        ("sheave_mass", ctypes.c_double),
        ("axle_height", ctypes.c_double),
        ("start_drop", ctypes.c_double),
        ("load_mass", ctypes.c_double),
        ("load_inertia", ctypes.c_double * 3),
        ("load_height", ctypes.c_double),
        ("lug_height", ctypes.c_double),
        ("equalizing_stiffness", ctypes.c_double),
        ("damping_time", ctypes.c_double),
        ("gravity", ctypes.c_double),
    )


def compiler() -> list[str]:
    """The C compiler's command."""
    return shlex.split(os.environ.get("CC", "cc"))


def library(vectorised: bool) -> ctypes.CDLL:
    """The compiled program."""
    command = [*compiler(), *FLAGS, *(VECTOR_FLAGS if vectorised else ())]
    key = hashlib.sha256(SOURCE.read_bytes() + " ".join(command).encode()).hexdigest()[:12]
    path = BUILD / f"equalizer_lift-{key}.so"
    if not path.exists():
        BUILD.mkdir(parents=True, exist_ok=True)
        subprocess.run([*command, str(SOURCE), "-o", str(path), "-lm"], check=True)
    return ctypes.CDLL(str(path))


class YardstickRun:
    """One run of the compiled program."""

    def __init__(self, lift: Lift, pace: int, duration: float, vectorised: bool) -> None:
        self._lift = _Lift(
            lift.frame_inertia,
            lift.yaw_damping,
            lift.sheave_mass,
            lift.axle_height,
            lift.start_drop,
            lift.load_mass,
            lift.load_inertia,
            lift.load_height,
            lift.load_box[2] / 2,
            lift.equalizing_stiffness,
            lift.damping_time,
            lift.gravity,
        )
        columns = [
            lift.sheave_x,
            [lug[0] for lug in lift.lugs],
            [lug[1] for lug in lift.lugs],
            lift.sling_lengths,
            lift.sling_stiffness,
        ]
        self._columns = [np.ascontiguousarray(column, dtype=np.float64) for column in columns]
        self._n, self._pace, self._samples = lift.sheaves, pace, sample_count(duration)
        self._out = np.zeros((self._samples, lift.sheaves + 1))
        self._run = library(vectorised).run

    def integrate(self) -> None:
        """Run to the end and record."""
        failed = self._run(
            self._n,
            ctypes.byref(self._lift),
            *(ctypes.c_void_p(column.ctypes.data) for column in self._columns),
            ctypes.c_double(SAMPLE_INTERVAL / self._pace),
            self._pace,
            self._samples,
            ctypes.c_void_p(self._out.ctypes.data),
        )
        if failed or not math.isfinite(self._out[-1].sum()):
            raise Unfit("no memory, or the step is longer than stability allows")

    def tensions(self) -> FloatArray:
        """Sling tensions (time, sling) [N]."""
        return self._out[:, :-1]


class Yardstick:
    """Fixed steps of the Runge-Kutta method of order four; the value of a setting is the step [ms]."""

    def __init__(self, vectorised: bool) -> None:
        self.name = "C for E(n), vectorised" if vectorised else "C for E(n)"
        self._vectorised = vectorised

    def version(self) -> str:
        """Of the compiler."""
        asked = [*compiler(), "-dumpfullversion", "-dumpversion"]
        return subprocess.run(asked, check=True, capture_output=True, text=True).stdout.strip()

    def settings(self, lift: Lift) -> Sequence[Setting]:
        """Down to where stability ends, whatever the lift."""
        return [Setting("RK4, h [ms]", 1e3 * SAMPLE_INTERVAL / pace) for pace in PACES]

    candidates = settings

    def prepare(self, lift: Lift, setting: Setting, duration: float) -> YardstickRun:
        """Ready to run."""
        pace = round(1e3 * SAMPLE_INTERVAL / setting.value)
        return YardstickRun(lift, pace, duration, self._vectorised)
