"""Settings of a run in place of those of its lift file."""

from __future__ import annotations

import math
from collections.abc import Mapping
from contextlib import suppress
from numbers import Real
from typing import Any, TypeGuard

import numpy as np

from gantline.assembly import integrator_settings
from gantline.scenario import Scenario, resolve
from gantline.scenario.quantities import SMALLEST
from gantline.scenario.times import wrong_times

__all__ = ["SettingError", "is_number", "overridden", "with_adjusting_factor", "with_locked_equalizers"]

#: Settings of the run; the other settings are those of an integrator.
_OF_RUN = ("duration", "sample_interval")
_ABOVE_ZERO = {
    "step": "a time above zero in seconds",
    "duration": "a time above zero in seconds",
    "sample_interval": "a time above zero in seconds",
    "tension_tolerance": "a force above zero in newtons",
    "position_tolerance": "a length above zero in metres",
}
_SWITCHES = ("paper", "geometric_stiffness")


class SettingError(ValueError):
    """A setting of the simulation is not usable; the message says which and why."""


def with_adjusting_factor(scenario: Scenario, factor: object) -> Scenario:
    """The same lift with another factor [1] for all equalizers that are approximated.

    Raises:
        SettingError: If it is no number above zero, or no equalizer is approximated.
    """
    if not _is_above_zero(factor):
        raise SettingError(f"adjusting_factor: {factor!r} is not a number above zero")
    given = scenario.equalizers or {}
    approximated = [name for name, one in resolve(scenario).equalizers.items() if not one.has_sheaves]
    if not approximated:
        raise SettingError("adjusting_factor: no equalizer of this lift has 'mechanism: approximated'")
    changed = {
        name: given[name].model_copy(update={"adjusting_factor": float(factor)}) for name in approximated
    }
    return scenario.model_copy(update={"equalizers": {**given, **changed}})


def with_locked_equalizers(scenario: Scenario, word: object) -> Scenario:
    """The same lift with pins in all moving sheaves throughout: its slings hang as from a rigid frame.

    Raises:
        SettingError: If the word is not `locked`, or there is nothing that pins can lock.
    """
    if word != "locked":
        raise SettingError(f"equalizers: {word!r} is none; 'locked' pins all moving sheaves where they start")
    given = scenario.equalizers or {}
    rigged = {name: one for name, one in resolve(scenario).equalizers.items() if one.has_sheaves}
    if not rigged:
        raise SettingError("equalizers: no equalizer of this lift has moving sheaves to lock")
    rigid = [name for name, one in rigged.items() if one.rope.inextensible]
    if rigid:
        sentence = (
            f"the rope of '{rigid[0]}' is inextensible, and pins in all its sheaves hold the same again"
        )
        raise SettingError(f"equalizers: {sentence}; give it an axial stiffness")
    locked = {
        name: given[name].model_copy(update={"travel": one.travel.model_copy(update={"locked": True})})
        for name, one in rigged.items()
    }
    no_pins = {"pull_pins": (), "put_in_pins": ()}
    plan = [step.model_copy(update=no_pins) for step in scenario.plan]
    return scenario.model_copy(update={"equalizers": {**given, **locked}, "plan": plan})


def overridden(
    scenario: Scenario, settings: Mapping[str, Any], overrides: Mapping[str, Any]
) -> dict[str, Any]:
    """Settings of a run with others in place of some of them.

    Args:
        scenario: The lift, for what it says of other integrators.
        settings: As assembled from it.
        overrides: By name, SI; None leaves a setting as it is.

    Raises:
        SettingError: If there is no such setting, or not with this value.
    """
    given = {name: value for name, value in overrides.items() if value is not None}
    integrator = _integrator(scenario, settings["integrator"], given.pop("integrator", None))
    merged: dict[str, Any] = {**settings, "integrator": integrator}
    for name, value in given.items():
        place = merged if name in _OF_RUN else integrator
        if name not in place or name == "type":
            known = ", ".join(("integrator", *list(integrator)[1:], *_OF_RUN))
            kind = integrator["type"]
            raise SettingError(f"{name}: not a setting of the integrator {kind}; there are {known}")
        place[name] = _switch(name, value) if name in _SWITCHES else _above_zero(name, value)
    times = wrong_times(merged["duration"], integrator.get("step"), merged["sample_interval"])
    for name, sentence in times:
        raise SettingError(f"{name}: {sentence}")
    return merged


def is_number(value: object) -> TypeGuard[float]:
    """Whether it is a number, those of NumPy among them; truth values are none."""
    return isinstance(value, Real) and not isinstance(value, bool)


def _integrator(scenario: Scenario, settings: Mapping[str, Any], kind: object) -> dict[str, Any]:
    """Settings of the integrator that is asked for; of the lift file's where none is."""
    if kind is None or kind == settings["type"]:
        return dict(settings)
    if isinstance(kind, str):
        with suppress(KeyError):
            return integrator_settings(kind, scenario.simulation)
    raise SettingError(f"integrator: {kind!r} is none; there are adaptive, del and explicit")


def _switch(name: str, value: object) -> bool:
    if not isinstance(value, bool | np.bool_):
        raise SettingError(f"{name}: {value!r} is neither True nor False")
    return bool(value)


def _above_zero(name: str, value: object) -> float:
    if not _is_above_zero(value):
        raise SettingError(f"{name}: {value!r} is not {_ABOVE_ZERO[name]}")
    if value < SMALLEST:
        raise SettingError(f"{name}: {value!r} is absurdly small; check the number and its unit")
    return float(value)


def _is_above_zero(value: object) -> TypeGuard[float]:
    """Whether it is a number above zero that a float can hold."""
    if is_number(value):
        with suppress(OverflowError):
            return 0.0 < float(value) < math.inf
    return False
