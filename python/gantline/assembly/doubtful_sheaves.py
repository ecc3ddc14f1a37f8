"""Losses of sheaves that an equalizer without sheaves cannot have."""

from __future__ import annotations

from collections.abc import Iterator

from gantline.scenario import Rigging, Scenario
from gantline.scenario.errors import Doubt
from gantline.scenario.findings import Path
from gantline.scenario.rigging import SHEAVES, sheave_levels

__all__ = ["doubtful_sheaves"]


def doubtful_sheaves(scenario: Scenario, rigging: Rigging) -> Iterator[Doubt]:
    """Each place that gives losses to sheaves of an equalizer whose lengths are adjusted instead."""
    for name, equalizer in rigging.equalizers.items():
        if equalizer.has_sheaves:
            continue
        lost: dict[Path, dict[str, float]] = {}
        for key in SHEAVES:
            ratio = equalizer.sheave_losses[key].ratio()
            if ratio > 1.0:
                lost.setdefault(_place(scenario, name, key), {})[key] = 1.0 - 1.0 / ratio
        for path, losses in lost.items():
            which = "its sheaves" if len(losses) > 1 else f"its {next(iter(losses)).replace('_', ' ')}"
            share = f"{100.0 * max(losses.values()):.3g} % of the tension at each"
            left_out = f"what {which} lose, {share}, is left out, and slings come to one tension"
            sentence = f"{name} is approximated, without sheaves: {left_out}"
            yield Doubt(path, f"{sentence}; 'mechanism: sheaves' has these losses")


def _place(scenario: Scenario, name: str, key: str) -> Path:
    """Where the lift file says what such sheaves of an equalizer lose."""
    return next(
        path
        for path, words in sheave_levels(scenario, name, key)
        if words.bearing_efficiency < 1.0 or words.groove_friction is not None
    )
