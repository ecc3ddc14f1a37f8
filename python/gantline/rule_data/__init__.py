"""Factors and limits of rules that lifts are checked by, each with the source it was read in."""

from gantline.rule_data.presets import (
    FACTORS,
    FOUR_SLINGS,
    LIFT_FILE,
    PRESETS,
    SEVERAL_CRANES,
    SIDE_LOAD,
    SIDE_LOAD_SOURCE,
    DynamicRow,
    Preset,
    Sourced,
    dynamic_factor,
    several_cranes,
)

__all__ = [
    "FACTORS",
    "FOUR_SLINGS",
    "LIFT_FILE",
    "PRESETS",
    "SEVERAL_CRANES",
    "SIDE_LOAD",
    "SIDE_LOAD_SOURCE",
    "DynamicRow",
    "Preset",
    "Sourced",
    "dynamic_factor",
    "several_cranes",
]
