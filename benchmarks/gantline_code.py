"""gantline itself, by its core: the integrator `adaptive` over tolerances."""

from __future__ import annotations

import json
from collections.abc import Sequence
from importlib import import_module
from typing import Any

import numpy as np

from benchmarks.contract import SAMPLE_INTERVAL, FloatArray, Setting, Unfit
from benchmarks.lifts import Lift, gantline_document

METRES_PER_NEWTON = 1e-6  # position tolerance over tension tolerance
REFERENCE_TOLERANCE = 0.1  # N; ten times tighter changes the tensions by less than 1e-8 of the final ones
TOLERANCES = (30.0, 100.0, 300.0, 1e3, 3e3, 1e4, 2e4, 4e4)


def settings_document(tolerance: float, duration: float, interval: float) -> str:
    """The settings of a run as gantline's core reads them; tolerance of tensions [N]."""
    integrator = {
        "type": "adaptive",
        "tension_tolerance": tolerance,
        "position_tolerance": tolerance * METRES_PER_NEWTON,
    }
    return json.dumps({"integrator": integrator, "duration": duration, "sample_interval": interval})


class GantlineRun:
    """One run of the core: the motion and the forces of all ropes at every sample."""

    def __init__(
        self, lift: Lift, tolerance: float, duration: float, interval: float = SAMPLE_INTERVAL
    ) -> None:
        core = import_module("gantline._core")
        settings = settings_document(tolerance, duration, interval)
        self.simulation: Any = core.Simulation(gantline_document(lift), settings)
        self._rope_tension: FloatArray | None = None

    def integrate(self) -> None:
        """To the end."""
        status = self.simulation.run()
        if status["status"] != "done":
            raise Unfit(str(status.get("message", status["status"])))
        self._rope_tension = self.simulation.rope_tension()

    def tensions(self) -> FloatArray:
        """Sling tensions (time, sling) [N]."""
        rope = self.simulation.names()["rope"]
        slings = [index for index, name in enumerate(rope) if name.startswith("sling")]
        return np.asarray(self._rope_tension)[:, slings]


class Gantline:
    """The value of a setting is the tolerance of tensions [N]."""

    name = "gantline"

    def version(self) -> str:
        """As installed."""
        return str(import_module("gantline").__version__)

    def settings(self, lift: Lift) -> Sequence[Setting]:
        """The same tolerances for all lifts."""
        return [Setting("adaptive, tolerance [N]", tolerance) for tolerance in TOLERANCES]

    candidates = settings

    def prepare(self, lift: Lift, setting: Setting, duration: float) -> GantlineRun:
        """Built, at its start."""
        return GantlineRun(lift, setting.value, duration)


def reference(lift: Lift) -> FloatArray:
    """Sling tensions (time, sling) [N] of the whole lift at a tight tolerance."""
    run = GantlineRun(lift, REFERENCE_TOLERANCE, lift.duration)
    run.integrate()
    return run.tensions()
