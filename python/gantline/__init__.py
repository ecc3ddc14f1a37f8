"""Simulate heavy lifts: what every rope, sheave, lug and hook carries, and when.

The names below load what they need when first used, so `import gantline` costs nothing; so do the parts that
the reference of Python tells of, such as `gantline.study`.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from gantline import cad as cad
    from gantline import checks as checks
    from gantline import export as export
    from gantline import hydro as hydro
    from gantline import plot as plot
    from gantline import report as report
    from gantline import results as results
    from gantline import rope_data as rope_data
    from gantline import rule_data as rule_data
    from gantline import scenario as scenario
    from gantline import statics as statics
    from gantline import study as study
    from gantline import units as units
    from gantline.assembly.plan.commands import CommandError
    from gantline.overrides import SettingError
    from gantline.report import Report, write_report
    from gantline.results.comparison import Comparison, compare
    from gantline.results.recording import Recording, open_recording
    from gantline.scenario import Scenario, ScenarioError, load_scenario, parse_scenario
    from gantline.simulation import Simulation, SimulationError, simulate
    from gantline.statics import Equilibrium, NoEquilibriumError, Statics

    __version__: str

__all__ = [
    "CommandError",
    "Comparison",
    "Equilibrium",
    "NoEquilibriumError",
    "Recording",
    "Report",
    "Scenario",
    "ScenarioError",
    "SettingError",
    "Simulation",
    "SimulationError",
    "Statics",
    "__version__",
    "compare",
    "load_scenario",
    "open_recording",
    "parse_scenario",
    "simulate",
    "write_report",
]

#: Packages and modules of which the reference tells; `gantline.study` needs no import of its own.
_PARTS = (
    "cad",
    "checks",
    "export",
    "hydro",
    "plot",
    "report",
    "results",
    "rope_data",
    "rule_data",
    "scenario",
    "statics",
    "study",
    "units",
)

_HOMES = {
    "CommandError": "gantline.assembly.plan.commands",
    "SettingError": "gantline.overrides",
    "Comparison": "gantline.results.comparison",
    "compare": "gantline.results.comparison",
    "Recording": "gantline.results.recording",
    "open_recording": "gantline.results.recording",
    "Scenario": "gantline.scenario",
    "ScenarioError": "gantline.scenario",
    "load_scenario": "gantline.scenario",
    "parse_scenario": "gantline.scenario",
    "Simulation": "gantline.simulation",
    "SimulationError": "gantline.simulation",
    "simulate": "gantline.simulation",
    "Equilibrium": "gantline.statics",
    "NoEquilibriumError": "gantline.statics",
    "Statics": "gantline.statics",
    "Report": "gantline.report",
    "write_report": "gantline.report",
}


# A type checker sees the imports above: this here would tell it that a name is anything, a misspelt one too.
if not TYPE_CHECKING:

    def __getattr__(name: str) -> Any:
        if name == "__version__":
            from gantline.version import version

            return version()
        if name in _HOMES:
            return getattr(import_module(_HOMES[name]), name)
        if name in _PARTS:
            return import_module(f"gantline.{name}")
        raise AttributeError(f"module 'gantline' has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted([*__all__, *_PARTS])
