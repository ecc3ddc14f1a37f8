"""Collects what is wrong with a scenario while its parts are checked one after the other."""

from __future__ import annotations

from gantline.scenario.errors import PathPart, Problem, ScenarioError
from gantline.scenario.model import Scenario

__all__ = ["Findings", "Path"]

Path = tuple[PathPart, ...]


class Findings:
    """Problems of one scenario, each with the line it belongs to.

    Attributes:
        scenario: the scenario that is checked.
        problems: what was found so far.
    """

    def __init__(self, scenario: Scenario) -> None:
        self.scenario = scenario
        self.problems: list[Problem] = []

    def add(self, path: Path, sentence: str) -> None:
        """Note a problem at a path of the file."""
        self.problems.append(self.scenario.problem(path, sentence))

    def refuse_explicit(self, what: str, instead: str = "") -> None:
        """Note what the baseline `explicit` cannot simulate, if the lift asks for it.

        Args:
            what: Things of the lift, as `pins`.
            instead: What would be right too.
        """
        if self.scenario.simulation.integrator == "explicit":
            sentence = f"'explicit' knows no {what}; 'adaptive' or 'del' is right here"
            self.add(("simulation", "integrator"), f"{sentence}, or {instead}" if instead else sentence)

    def raise_any(self) -> None:
        """Stop if anything was found.

        Raises:
            ScenarioError: with everything found.
        """
        if self.problems:
            raise ScenarioError(self.scenario.source, self.problems)
