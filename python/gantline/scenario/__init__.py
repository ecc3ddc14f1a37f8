"""Lift files: read, checked, with every quantity in SI units."""

from gantline.scenario.errors import Problem, ScenarioError, StartError
from gantline.scenario.model import Scenario
from gantline.scenario.reading import FILE_NAME, load_scenario, parse_scenario
from gantline.scenario.rigging import Rigging, resolve
from gantline.scenario.schema import json_schema, schema_text
from gantline.scenario.shipped import shipped
from gantline.scenario.template import template

__all__ = [
    "FILE_NAME",
    "Problem",
    "Rigging",
    "Scenario",
    "ScenarioError",
    "StartError",
    "json_schema",
    "load_scenario",
    "parse_scenario",
    "resolve",
    "schema_text",
    "shipped",
    "template",
]
