"""Masses of next to nothing: what has one weighs more than a gram in any lift, and in a laboratory too."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from pydantic import BaseModel

from gantline.scenario import Scenario
from gantline.scenario.errors import Doubt
from gantline.scenario.findings import Path

__all__ = ["doubtful_masses"]

#: What is lighter is a slip [kg]: of a model at 1 : 100 a body of 1 t weighs a gram.
_LEAST = 1e-3
#: Keys of what has a mass for its length, and of settings.
_OTHERS = ("ropes", "simulation")


def doubtful_masses(scenario: Scenario) -> Iterator[Doubt]:
    """Each `mass` of the lift file that is more than nothing and less than a gram."""
    for key in type(scenario).model_fields:
        if key not in _OTHERS:
            yield from _within(getattr(scenario, key), (key,))


def _within(what: object, path: Path) -> Iterator[Doubt]:
    if path[-1] == "mass" and isinstance(what, float) and 0.0 < what < _LEAST:
        sentence = f"{path[-2]} has a mass of {what:.3g} kg, less than a gram; a number or unit has slipped"
        yield Doubt(path, sentence)
    elif isinstance(what, BaseModel):
        for key in type(what).model_fields:
            yield from _within(getattr(what, key), (*path, key))
    elif isinstance(what, Mapping):
        for name, one in what.items():
            yield from _within(one, (*path, name))
