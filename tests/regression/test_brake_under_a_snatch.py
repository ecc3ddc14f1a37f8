"""A load fell 0.3 m into its other sling, on a brake that holds 1.2 times its weight: the brake was fine.

A hoist that stands was held by its motor, which is stronger; its brake came in by emergency stops alone. Held
against it was what hangs there at rest, and not what pulls as a load is caught.
"""

from __future__ import annotations

import math

import pytest

import gantline
from gantline.checks import Verdict
from gantline.scenario import parse_scenario
from mechanics import G
from of_recording import check_of
from weak_hoist import PARTS, hanging

#: Mass of the load [t], length of the sling that is cut and how much longer the other is [m].
MASS, LENGTH, SLACK = 10.0, 6.0, 0.3
WEIGHT = MASS * 1e3 * G
#: EA of slings and falls [N]; the falls are 2 parts of 6 m and a lead line, no shorter than 12 m of rope.
STIFF, ROPE = 36e6, 12.0
#: At most, of falls that are as short and nothing that is damped: W (1 + √(1 + 2 h k/W)) [N].
MOST = WEIGHT * (
    1.0 + math.sqrt(1.0 + 2.0 * SLACK / WEIGHT / ((LENGTH + SLACK) / STIFF + ROPE / (PARTS**2 * STIFF)))
)


@pytest.mark.parametrize(
    ("brake", "is_told"), [(1.2 * WEIGHT, True), (1.01 * MOST, False)], ids=["weak", "strong"]
)
def test_a_brake_that_holds_less_than_a_load_that_is_caught(brake: float, is_told: bool) -> None:
    """What falls onto its sling pulls with twice its weight at least."""
    motor = f"capacity: {MOST / PARTS * 1.1} N, brake: {brake / PARTS} N"
    lift = hanging("{step: wait, hold: 20 s}", MASS, motor, 30.0)
    own = f"  S: {{from: crane, to: load.A, length: {LENGTH:g} m, rope: sling}}"
    longer = own.replace(f"length: {LENGTH:g} m", f"length: {LENGTH + SLACK} m")
    cut = own.replace("  S:", "  T:").replace("rope: sling", "rope: sling, cut_at: 5 s")
    assert own in lift
    recording = gantline.simulate(parse_scenario(lift.replace(own, f"{longer}\n{cut}")))
    found = check_of(recording, "hoist_load_of_drive_capacity")
    assert found.verdict is (Verdict.WARNING if is_told else Verdict.OK)
    assert ("its brake holds" in found.remark) == is_told
    pulls = float(recording.column("hoist_load", "crane").max())
    assert 2.0 * WEIGHT < pulls < MOST
