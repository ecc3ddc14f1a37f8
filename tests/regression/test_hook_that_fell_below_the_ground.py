"""A hook that fell below the ground as its hoist ropes broke was told to be lowered less far.

Nothing stops a hook at the ground, and the run warns of that. Where the plan hoists the load there is no
step that lowers the hook that far.
"""

from __future__ import annotations

import gantline
from gantline.scenario import Scenario, parse_scenario
from weak_hoist import hanging

DOWN = "{step: down, lower: crane, speed: 6 m/min, by: 14.5 m}"


def falling(plan: str, duration: float, breaks_at: str) -> Scenario:
    """A load of 10 t in two parts of line that part at a tension."""
    text = hanging(plan, 10.0, "capacity: 200 kN", duration)
    return parse_scenario(text.replace("hoist: {axial", f"hoist: {{breaks_at: {breaks_at}, axial"))


def warned(lift: Scenario) -> str:
    (said,) = (
        one for one in gantline.simulate(lift).attributes["warnings"] if "goes below the ground" in one
    )
    return str(said)


def test_a_hook_whose_ropes_broke_has_fallen() -> None:
    """10.1 t pull at two parts with m g/2 = 49.54 kN; 49.6 kN are passed as the hoist speeds up."""
    up = "{step: up, hoist: crane, speed: 6 m/min, by: 2 m}"
    said = warned(falling(up, 6.0, "49.6 kN"))
    assert said.endswith("nothing stops it there; its hoist ropes have parted")


def test_a_hook_on_whole_ropes_was_lowered() -> None:
    said = warned(falling(DOWN, 170.0, "500 kN"))
    assert said.endswith("nothing stops it there; lower it less far")
