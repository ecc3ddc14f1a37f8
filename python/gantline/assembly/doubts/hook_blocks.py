"""Hook blocks that would not come down by themselves, without a load."""

from __future__ import annotations

from collections.abc import Iterator

from gantline.assembly.cranes.reeving import reeved_hooks
from gantline.scenario import Scenario
from gantline.scenario.errors import Doubt
from gantline.units import format_quantity

__all__ = ["doubtful_hook_blocks"]


def doubtful_hook_blocks(scenario: Scenario) -> Iterator[Doubt]:
    """Each hook block too light to pull the weight of its lead line as it is lowered, (WI6)."""
    gravity = scenario.simulation.gravity
    for hook in reeved_hooks(scenario):
        reeving = hook.reeving
        kind = (scenario.ropes or {})[reeving.rope]
        ratio = reeving.losses(kind.diameter, kind.mass_per_length).ratio()
        # Of n parts each pulls 1/K times the one before it, so that the lead line has the least.
        parts = sum(ratio**part for part in range(1, reeving.parts_each + 1))
        pulls = hook.hook_block.mass * gravity / reeving.ropes / parts
        hangs = kind.mass_per_length * gravity * reeving.lead_line
        if pulls < hangs:
            pull, weight = format_quantity(pulls, "kN", 2), format_quantity(hangs, "kN", 2)
            enough = format_quantity(hook.hook_block.mass * hangs / pulls, "t", 1)
            length = format_quantity(reeving.lead_line, "m", 1)
            sentence = (
                f"without a load the hook block of {hook.name} does not come down: lowered, it pulls {pull} "
                f"on each lead line, and {length} of rope down to the drum weigh {weight}; one of {enough} "
                "does, or more weight at the hook"
            )
            yield Doubt((*hook.hook.paths["reeving"], "lead_line"), sentence)
