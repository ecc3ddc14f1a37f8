"""Whether steps ask for mooring lines and tag lines that the plan has cut."""

from __future__ import annotations

from gantline.scenario.afloat.mooring import line_rope
from gantline.scenario.cranes.hooks import full_name
from gantline.scenario.findings import Findings
from gantline.scenario.plan.movers import movers
from gantline.scenario.plan.slinging import ropes_cut
from gantline.scenario.plan.steps import LineStep

__all__ = ["check_cut_lines"]


def check_cut_lines(findings: Findings) -> None:
    """Note steps that move a line, or wait for its tension, once a step has cut it."""
    scenario = findings.scenario
    winches = movers(scenario, "line")
    for place, (step, cut) in enumerate(zip(scenario.plan, ropes_cut(scenario), strict=True)):
        if isinstance(step, LineStep):
            for text in step.moved:
                name = full_name(text, winches)
                if name is not None and (name in cut or line_rope(name) in cut):
                    sentence = f"'{text}' has been cut by then"
                    findings.add(("plan", place, step.verb), f"{sentence}; there is nothing to {step.verb}")
        reached = step.until.mooring_tension if step.until is not None else None
        if reached is not None and line_rope(reached.line) in cut:
            sentence = f"'{reached.line}' has been cut by then"
            path = ("plan", place, "until", "mooring_tension", "line")
            findings.add(path, f"{sentence}; wait for a line that holds")
