"""Sheaves that cannot well be meant: losses where there are none, and no room for a groove."""

from __future__ import annotations

from collections.abc import Iterator

from gantline.assembly.cranes.reeving import reeved_hooks
from gantline.scenario import Rigging, Scenario
from gantline.scenario.errors import Doubt
from gantline.scenario.findings import Path
from gantline.scenario.rigging import SHEAVES, EqualizerRigging, sheave_levels

__all__ = ["doubtful_sheaves"]

#: What a rope bends about is its pitch diameter less its own: below twice the rope's that is thinner than it,
#: and rules ask for 11 times and more (ISO 4308-1) [1].
_TIGHTEST = 2.0


def doubtful_sheaves(scenario: Scenario, rigging: Rigging) -> Iterator[Doubt]:
    """Each place that gives losses to sheaves that are none, and each sheave thinner than its rope."""
    yield from _thin_in_falls(scenario)
    for name, equalizer in rigging.equalizers.items():
        yield from _thin(scenario, name, equalizer)
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


def _thin(scenario: Scenario, name: str, equalizer: EqualizerRigging) -> Iterator[Doubt]:
    thick = equalizer.rope.diameter
    if thick is None:
        return
    for key in SHEAVES:
        diameter = getattr(equalizer, key).pitch_diameter
        if diameter < _TIGHTEST * thick:
            given = (scenario.equalizers or {})[name]
            own = getattr(given, key) is not None
            path = ("equalizers", name) if own else ("equalizer_types", str(given.type))
            sentence = f"the {key.replace('_', ' ')} of {name} have a pitch diameter of {1e3 * diameter:g} mm"
            yield Doubt((*path, key, "pitch_diameter"), f"{sentence}, {_slipped(thick)}")


def _thin_in_falls(scenario: Scenario) -> Iterator[Doubt]:
    """The same of sheaves of hooks."""
    for hook in reeved_hooks(scenario):
        thick = (scenario.ropes or {})[hook.reeving.rope].diameter
        diameter = hook.reeving.diameter(thick)
        if thick is not None and diameter < _TIGHTEST * thick:
            sentence = f"the sheaves of {hook.name} have a diameter of {1e3 * diameter:g} mm"
            path = (*hook.hook.paths["reeving"], "sheave_diameter")
            yield Doubt(path, f"{sentence}, {_slipped(thick)}")


def _slipped(thick: float) -> str:
    usual = "11 to 25 times that is usual, and a unit has slipped"
    return f"their rope is {1e3 * thick:g} mm thick; {usual}"
