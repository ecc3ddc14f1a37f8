"""Whether landing guides fit the rest of the lift."""

from __future__ import annotations

from gantline.scenario.findings import Findings

__all__ = ["check_guides"]


def check_guides(findings: Findings) -> None:
    """Note what is wrong with landing guides."""
    scenario = findings.scenario
    if scenario.guides and scenario.load is None:
        sentence = "there is no 'load' for guides to bring to its place"
        findings.add(("guides",), f"{sentence}; what bodies touch belongs under 'mechanics'")
    if scenario.guides and scenario.simulation.integrator == "explicit":
        sentence = "'explicit' knows no guides; 'adaptive' or 'del' is right"
        findings.add(("simulation", "integrator"), sentence)
