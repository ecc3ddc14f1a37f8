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
    """One run of the core, with all that it records."""

    def __init__(
        self, lift: Lift, tolerance: float, duration: float, interval: float = SAMPLE_INTERVAL
    ) -> None:
        core = import_module("gantline._core")
        settings = settings_document(tolerance, duration, interval)
        self.simulation: Any = core.Simulation(gantline_document(lift), settings)

    def integrate(self) -> None:
        """To the end."""
        status = self.simulation.run()
        if status["status"] != "done":
            raise Unfit(str(status.get("message", status["status"])))

    def tensions(self) -> FloatArray:
        """Sling tensions (time, sling) [N]."""
        rope = self.simulation.names()["rope"]
        slings = [index for index, name in enumerate(rope) if name.startswith("sling")]
        return np.asarray(self.simulation.columns()["rope_tension"])[:, slings]


class SilentRun:
    """A run that records only start and end; its tensions come from a second run, bit by bit the same."""

    def __init__(self, lift: Lift, tolerance: float, duration: float) -> None:
        self._silent = GantlineRun(lift, tolerance, duration, interval=duration)
        self._recorded = GantlineRun(lift, tolerance, duration)

    def integrate(self) -> None:
        """To the end."""
        self._silent.integrate()

    def tensions(self) -> FloatArray:
        """Sling tensions (time, sling) [N]."""
        self._recorded.integrate()
        return self._recorded.tensions()


class Gantline:
    """The value of a setting is the tolerance of tensions [N].

    A recording holds far more than the sling tensions that the race asks for, the whole motion, all segments
    and the energies; without `recording` it is left out, which shows what integration alone takes.
    """

    def __init__(self, recording: bool) -> None:
        self.name = "gantline" if recording else "gantline, not recording"
        self._run = GantlineRun if recording else SilentRun

    def version(self) -> str:
        """As installed."""
        return str(import_module("gantline").__version__)

    def settings(self, lift: Lift) -> Sequence[Setting]:
        """The same tolerances for all lifts."""
        return [Setting("adaptive, tolerance [N]", tolerance) for tolerance in TOLERANCES]

    candidates = settings

    def prepare(self, lift: Lift, setting: Setting, duration: float) -> GantlineRun | SilentRun:
        """Built, at its start."""
        return self._run(lift, setting.value, duration)


def reference(lift: Lift) -> FloatArray:
    """Sling tensions (time, sling) [N] of the whole lift at a tight tolerance."""
    run = GantlineRun(lift, REFERENCE_TOLERANCE, lift.duration)
    run.integrate()
    return run.tensions()
