"""A load whose hook was kept still against heave for 90 s, and was told that it never hung still.

A load hangs still while drives do no work, and a hoist that compensates heave works all the time. The skid
of `onto_a_platform`, with its hook kept still from the start until it is set down, had no static forces: no
contingency and no factor of a rule came into the check of any capacity, and the warning was to hold it
still for 5 s. What hangs from a hook that is kept still hangs stiller than from one that stands.
"""

from __future__ import annotations

import pytest

from compensated import HOOK, compensated
from gantline.results import Recording, series
from gantline.simulation import Simulation
from gantline.statics import Statics
from of_recording import checks_of

STILL = "  - {step: still, hold: 60 s, compensate_heave: H1}\n"
LOWERED = f"{STILL}  - {{step: down, lower: H1, speed: 1 m/min, by: 2 m, compensate_heave: H1}}\n"


@pytest.fixture(scope="module")
def lowered() -> Recording:
    """Lowered after a minute, by a step that goes on as the run ends."""
    return Simulation(compensated(LOWERED, lasts="100 s")).run()


def test_it_hangs_still_while_nothing_else_moves_its_hook(lowered: Recording) -> None:
    """Until the step that lowers it begins, to a sample; at its end it is clear and moves."""
    still, _ = series.quiet_windows(lowered)
    assert lowered.time[still][0] == 0.0
    assert lowered.time[still][-1] == pytest.approx(60.0, abs=0.11)
    assert not checks_of(lowered, "hangs_still")


def test_its_static_hook_load_is_that_of_its_equilibrium(lowered: Recording) -> None:
    """Which is in still water; a mean over a minute of waves leaves less than 1e-3."""
    still, _ = series.quiet_windows(lowered)
    static = series.static_value(lowered, lowered.column("hook_load", HOOK), still)
    rest = Statics(compensated(LOWERED, lasts="100 s")).equilibrium(0.0).recording
    assert static == pytest.approx(rest.column("hook_load", HOOK)[-1], rel=1e-3)
    (check,) = checks_of(lowered, "static_hook_load")
    assert check.value is not None
    assert "never hung still" not in check.remark
