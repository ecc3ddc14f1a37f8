"""Hook blocks that do not come down by themselves without a load, or bear inside of their sheaves."""

from __future__ import annotations

from collections.abc import Iterator

from gantline.assembly.cranes.reeving import reeved_hooks
from gantline.scenario import Scenario
from gantline.scenario.errors import Doubt
from gantline.scenario.findings import Path
from gantline.units import format_quantity

__all__ = ["doubtful_hook_blocks"]


def doubtful_hook_blocks(scenario: Scenario) -> Iterator[Doubt]:
    """Each hook block too low for its sheaves, or too light to pull its lead line as it is lowered, (WI6)."""
    yield from _low(scenario)
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


def _low(scenario: Scenario) -> Iterator[Doubt]:
    """Each hook block whose hook bears inside of its sheaves."""
    told: set[Path] = set()
    for hook in reeved_hooks(scenario):
        path: Path = (*hook.hook.paths["hook_block"], "height")
        diameter = hook.reeving.diameter((scenario.ropes or {})[hook.reeving.rope].diameter)
        if hook.hook_block.height < diameter / 2 and path not in told:
            told.add(path)
            height, thick = (f"{1e3 * one:,.6g} mm" for one in (hook.hook_block.height, diameter))
            low = f"the hook block of {hook.name} has its sheaves {height} above the bearing of its hook"
            sentence = f"{low}, and they have a diameter of {thick}; a unit has slipped"
            yield Doubt(path, sentence)
