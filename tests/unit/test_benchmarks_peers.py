"""Models of the benchmark lifts in other codes, where installed: the same motion, with errors that fall."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

from gantline import _core

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from benchmarks.contract import Code, Setting  # noqa: E402
from benchmarks.gantline_code import GantlineRun  # noqa: E402
from benchmarks.lifts import equalizer_lift, gantline_document  # noqa: E402
from benchmarks.measure import errors  # noqa: E402
from benchmarks.peers.at_rest import AT_REST  # noqa: E402
from benchmarks.peers.exudyn import Exudyn  # noqa: E402
from benchmarks.peers.mujoco import MuJoCo  # noqa: E402
from benchmarks.peers.opensim import OpenSim  # noqa: E402
from benchmarks.worker import Worker  # noqa: E402

DURATION = 2.0  # s: free fall, all slings going taut, the highest tensions, slack again
GENERALIZED = "GeneralizedAlpha 1e-8, h [ms]"

PAIRS = [
    pytest.param(MuJoCo(nested=False), "implicitfast, h [ms]", (1.0, 0.25), id="mujoco"),
    pytest.param(MuJoCo(nested=True), "implicitfast, h [ms]", (4.0, 1.0), id="mujoco-nested"),
    pytest.param(Exudyn(reeving=True), GENERALIZED, (10.0, 2.5), id="exudyn-reeving"),
    pytest.param(Exudyn(reeving=False), GENERALIZED, (10.0, 2.5), id="exudyn"),
    pytest.param(OpenSim(), "CPodes, accuracy", (1e-3, 1e-5), id="opensim"),
    pytest.param(OpenSim(), "CPodes points, accuracy", (1e-3, 1e-5), id="opensim-points"),
]


@pytest.mark.parametrize(("code", "method", "values"), PAIRS)
@pytest.mark.parametrize("n", [5, 8])
def test_a_finer_setting_comes_nearer_to_gantline(
    n: int, code: Code, method: str, values: tuple[float, float]
) -> None:
    worker = Worker(code)
    try:
        if worker.version() is None:
            pytest.skip(f"{code.name} is not installed")
        lift = equalizer_lift(n)
        reference = GantlineRun(lift, tolerance=0.1, duration=DURATION)
        reference.integrate()
        scale = lift.load_mass * lift.gravity / n
        rms = []
        for value in values:
            outcome = worker.run(lift, Setting(method, value), DURATION)
            assert outcome.tension is not None, outcome.failure
            rms.append(errors(outcome.tension, reference.tensions(), scale).rms)
        coarse, fine = rms
        assert coarse < 0.05
        assert fine < 0.5 * coarse
    finally:
        worker.stop()


@pytest.mark.parametrize("code", AT_REST, ids=lambda code: code.name)
def test_each_finds_the_rest_of_a_lift(code: Code) -> None:
    """Of its settings for E(5) one at least ends within 1e-6 of gantline's equilibrium."""
    worker = Worker(code)
    try:
        if worker.version() is None:
            pytest.skip(f"{code.name} is not installed")
        lift = equalizer_lift(5)
        core = _core.Statics(gantline_document(lift))
        core.settle()
        exact = core.columns()["rope_tension"][-1][1:]
        ends = [worker.run(lift, setting, 0.0).tension for setting in code.settings(lift)]
        found = [np.abs(end[-1] - exact).max() / exact.mean() for end in ends if end is not None]
        assert min(found) < 1e-6
    finally:
        worker.stop()
