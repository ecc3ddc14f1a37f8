"""A core that is told what to do, in place of the compiled one."""

from __future__ import annotations

import json
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import gantline._core
import gantline.simulation
from sample_lift import sample_columns, sample_rig, sample_scene

SETTINGS = {
    "integrator": {"type": "del", "step": 0.001, "paper": False, "geometric_stiffness": True},
    "duration": 4.0,
    "sample_interval": 1.0,
}


class FakeCore:
    """Steps a second at a time, tells the time after each, hoists until 3 s, and fails at `fails_at`."""

    fails_at = float("inf")
    remainder = 0.0
    refuses = ""

    def __init__(self, document: str, settings: str) -> None:
        if self.refuses:
            raise ValueError(self.refuses)
        self.document, self.settings = json.loads(document), json.loads(settings)
        self.now = 0
        self.measures = False

    def run(self, on_progress: Callable[[float], bool] | None, until: float | None = None) -> dict[str, Any]:
        end = self.settings["duration"] if until is None else until
        while self.now < end:
            if self.now >= self.fails_at:
                return {
                    "status": "failed",
                    "time": self.now,
                    "element": "sling.S1",
                    "cause": "a pivot is zero",
                }
            self.now += 1
            if on_progress is not None and not on_progress(float(self.now)):
                return {"status": "stopped", "time": self.now}
        return {"status": "done", "time": self.now}

    def time(self) -> float:
        return float(self.now)

    def ended(self) -> bool:
        return bool(self.now >= self.settings["duration"])

    def columns(self, of_pulls: bool = False) -> dict[str, Any]:
        return {"time": np.zeros(0)} if of_pulls else self._sample()[0]

    def names(self) -> dict[str, Any]:
        return self._sample()[1]

    def _sample(self) -> tuple[dict[str, Any], dict[str, Any]]:
        time = np.arange(self.now + 1.0)
        return sample_columns(time, tension=np.full((len(time), 5), 1e5))

    def save(self, alone: bool = False) -> bytes:
        return str(self.now).encode()

    def restore(self, state: bytes) -> None:
        self.now = int(state)

    def energy_remainder(self) -> float:
        return self.remainder

    def current_step(self) -> str | None:
        return "hoist" if self.now < 3 else None

    def current_tension(self) -> list[float]:
        return [self.now * 1e3] * len(self.names()["rope"])

    def measure(self) -> None:
        self.measures = True

    def stages(self) -> dict[str, float]:
        return {"kinematics": 0.003, "assembly": 0.001, "recording": 0.002} if self.measures else {}

    def tolerances(self) -> dict[str, float]:
        return {}

    def counters(self) -> dict[str, int]:
        return {"steps": self.now, "unconverged": 0}


@pytest.fixture
def core(monkeypatch: pytest.MonkeyPatch) -> type[FakeCore]:
    """Lifts of any name run on a core of this class, whose attributes a test may set."""

    class Core(FakeCore):
        pass

    given = {"text": "format: 1\n", "source": "lift.yaml", "starts": "as_given"}
    scenario = SimpleNamespace(**given, mechanics=None, ground=None, water=None, vessels=None, hinges=None)
    assembly = SimpleNamespace(
        document={},
        settings=SETTINGS,
        rig=sample_rig(),
        scene=sample_scene(),
        document_text=lambda: "{}",
        doubts=(),
    )
    monkeypatch.setattr(gantline._core, "Simulation", Core)
    monkeypatch.setattr(gantline.simulation, "load_scenario", lambda lift: scenario)
    monkeypatch.setattr(gantline.simulation, "assemble", lambda scenario: assembly)
    return Core
