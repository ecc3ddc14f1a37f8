"""Factors and limits of rules that lifts are checked by, each with the source it was read in."""

from gantline.rule_data.presets import (
    FACTORS,
    PRESETS,
    SIDE_LOAD,
    SIDE_LOAD_SOURCE,
    DynamicRow,
    Preset,
    Sourced,
    dynamic_factor,
)

__all__ = [
    "FACTORS",
    "PRESETS",
    "SIDE_LOAD",
    "SIDE_LOAD_SOURCE",
    "DynamicRow",
    "Preset",
    "Sourced",
    "dynamic_factor",
]
