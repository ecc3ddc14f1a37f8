"""Lift files: read, checked, with every quantity in SI units."""

from gantline.scenario.errors import Problem, ScenarioError, StartError
from gantline.scenario.file.alone import check_library
from gantline.scenario.file.reading import FILE_NAME, load_scenario, parse_scenario
from gantline.scenario.file.schema import (
    json_schema,
    library_schema,
    library_schema_text,
    schema_text,
)
from gantline.scenario.file.shipped import shipped
from gantline.scenario.file.template import template
from gantline.scenario.model import Scenario
from gantline.scenario.rigging import Rigging, resolve

__all__ = [
    "FILE_NAME",
    "Problem",
    "Rigging",
    "Scenario",
    "ScenarioError",
    "StartError",
    "check_library",
    "json_schema",
    "library_schema",
    "library_schema_text",
    "load_scenario",
    "parse_scenario",
    "resolve",
    "schema_text",
    "shipped",
    "template",
]
