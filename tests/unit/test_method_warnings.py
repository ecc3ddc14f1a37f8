"""What is doubtful about a run for its method: energy from nowhere, and steps that did not settle."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from gantline.results.method_warnings import method_warnings
from gantline.results.rig import Rig

KINDS = ["kinetic", "gravity", "elastic", "drive_work", "contact_damping", "remainder"]
#: [J], of four samples: a load falls on the ground, which takes 200 J and gives them back with as much more.
THROWN = [
    [0.0, 1000.0, 0.0, 0.0, 0.0, 0.0],
    [1000.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [500.0, 0.0, 300.0, 0.0, 200.0, 0.0],
    [0.0, 1200.0, 0.0, 0.0, -200.0, 0.0],
]


def told(energy: list[list[float]], unconverged: int = 0, residual: float = 0.0) -> list[str]:
    columns: Any = {
        "time": np.arange(float(len(energy))),
        "energy": np.array(energy),
        "residual_complementarity": np.full(len(energy), residual),
    }
    settings = {"integrator": {"type": "del", "step": 1e-3}}
    counters = {"steps": 3000, "unconverged": unconverged}
    return method_warnings(settings, Rig.from_json({}), columns, {"energy_kind": KINDS}, counters, 0.0)


def test_a_loss_that_gives_energy_is_told_though_the_balance_closes() -> None:
    """Kept are 1000, 1000, 800 and 1200 J: 400 J of the largest 1000 J come from nowhere, by the last one."""
    [warning] = told(THROWN)
    assert warning.startswith("40 % of the largest energy come from nowhere, the first of it by 3.00 s")


def test_losses_that_take_are_no_doubt() -> None:
    assert not told(THROWN[:3])
    assert not told([])


@pytest.mark.parametrize(("residual", "shown"), [(2.1e6, "2.1 MN"), (0.0, "0 N")])
def test_steps_that_did_not_settle_are_told_with_how_far_forces_are_off(residual: float, shown: str) -> None:
    [warning] = told(THROWN[:3], unconverged=277, residual=residual)
    assert "not settled in 277 of 3000 steps" in warning and f"off their laws by {shown} at most" in warning
