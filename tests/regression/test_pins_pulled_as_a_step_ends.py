"""A step that ends as the next one pulls the pins.

`gantline statics --steps` found the lift at the end of a step with the pins that the next one pulls already
pulled: a step that had taken up a fifth of the load showed 0 %, what it required was held against slings
that share without pins, and a run said otherwise.
"""

from __future__ import annotations

import pytest

from gantline.scenario import parse_scenario
from gantline.statics import Statics
from gantline.study import run_steps
from pinned_lift import LIFT, WEIGHT

#: The same lift from the ground on: when the first step ends only the lift itself tells.
GROUND = "ground: {level: 0 m, friction: 0.5, stiffness: 200 MN/m, damping: 2 MN s/m}\nload:"
WAITING = (
    LIFT.replace("load:", GROUND, 1)
    .replace("position: [0 m, 0 m, 2 m]", "position: [0 m, 0 m, 0 m]\n  stands_on: ground")
    .replace("at: [0 m, 0 m, 25 m]", "at: [0 m, 0 m, 22.99 m]")
    .replace("look, hold: 20 s", "look, hoist: hook, speed: 20 mm/s, until: {load_transferred: 20 %}")
)


def test_slings_share_as_the_step_leaves_them() -> None:
    """W/2, nothing and W/2 where it ends, W/3 each once the pins are pulled."""
    found = {one.name: one.state for one in run_steps(Statics(parse_scenario(LIFT)))}
    assert found["look"].time == 20.0
    for name, shares in (("look", (1 / 2, 0.0, 1 / 2)), ("pull", (1 / 3, 1 / 3, 1 / 3))):
        rest = found[name].rest
        assert rest is not None
        for sling, share in zip(("S1", "S2", "S3"), shares, strict=True):
            carried = float(rest.recording.column("rope_tension", f"sling.{sling}")[-1])
            assert carried == pytest.approx(share * WEIGHT, abs=1e-6 * WEIGHT)


def test_what_a_step_waited_for_holds_where_it_ends() -> None:
    """It brakes within 2 mm of a fifth; with the pins pulled sheaves give way, and 0 % is left."""
    found = {one.name: one.state.rest for one in run_steps(Statics(parse_scenario(WAITING)))}
    for name, (least, most) in {"look": (0.2, 0.3), "pull": (0.0, 1e-9)}.items():
        rest = found[name]
        assert rest is not None
        share = float(rest.recording.column("load_transferred", "block")[-1])
        assert least <= share + 1e-12 and share <= most
