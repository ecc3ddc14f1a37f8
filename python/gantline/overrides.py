"""Settings of a run in place of those of its lift file."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

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


class SettingError(ValueError):
    """A setting of the simulation is not usable; the message says which and why."""


def with_adjusting_factor(scenario: Scenario, factor: object) -> Scenario:
    """The same lift with another factor [1] for all equalizers that are approximated.

    Raises:
        SettingError: If it is no number above zero, or no equalizer is approximated.
    """
    if not isinstance(factor, int | float) or isinstance(factor, bool) or not 0.0 < factor < math.inf:
        raise SettingError(f"adjusting_factor: {factor!r} is not a number above zero")
    given = scenario.equalizers or {}
    approximated = [name for name, one in resolve(scenario).equalizers.items() if not one.has_sheaves]
    if not approximated:
        raise SettingError("adjusting_factor: no equalizer of this lift has 'mechanism: approximated'")
    changed = {name: given[name].model_copy(update={"adjusting_factor": factor}) for name in approximated}
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
    integrator = dict(settings["integrator"])
    kind = given.pop("integrator", integrator["type"])
    if kind != integrator["type"]:
        try:
            integrator = integrator_settings(kind, scenario.simulation)
        except KeyError:
            raise SettingError(
                f"integrator: {kind!r} is none; there are adaptive, del and explicit"
            ) from None
    merged: dict[str, Any] = {**settings, "integrator": integrator}
    for name, value in given.items():
        wanted = _ABOVE_ZERO.get(name)
        if wanted and not (is_number(value) and math.isfinite(value) and value > 0.0):
            raise SettingError(f"{name}: {value!r} is not {wanted}")
        if wanted and value < SMALLEST:
            raise SettingError(f"{name}: {value!r} is absurdly small; check the number and its unit")
        if name in _OF_RUN:
            merged[name] = float(value)
        elif name in integrator:
            integrator[name] = value
        else:
            known = ", ".join(("integrator", *list(integrator)[1:], *_OF_RUN))
            raise SettingError(f"{name}: not a setting of the integrator {kind}; there are {known}")
    times = wrong_times(merged["duration"], integrator.get("step"), merged["sample_interval"])
    for name, sentence in times:
        raise SettingError(f"{name}: {sentence}")
    return merged


def is_number(value: object) -> bool:
    """Whether it is a number; truth values are none."""
    return isinstance(value, int | float) and not isinstance(value, bool)
