"""Settings of a run in place of those of its lift file."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from contextlib import suppress
from typing import Any, TypeGuard

import numpy as np

from gantline.arguments import is_number
from gantline.assembly import integrator_settings
from gantline.assembly.afloat.recorded_motion import ends_too_early
from gantline.scenario import Scenario, resolve
from gantline.scenario.ground import INTEGRATOR_KEYS
from gantline.scenario.plan.times import wrong_times
from gantline.scenario.quantities import SMALLEST

__all__ = ["SettingError", "overridden", "with_adjusting_factor", "with_locked_equalizers"]

#: Settings of the run; the other settings are those of an integrator.
_OF_RUN = ("duration", "sample_interval")
#: What each number is that is above zero, and the unit that Python has it in.
_ABOVE_ZERO = {
    "step": ("a time above zero", " in seconds"),
    "duration": ("a time above zero", " in seconds"),
    "sample_interval": ("a time above zero", " in seconds"),
    "tension_tolerance": ("a force above zero", " in newtons"),
    "position_tolerance": ("a length above zero", " in metres"),
}
_SWITCHES = ("paper", "geometric_stiffness")
#: What else the times of a run are held against.
_BESIDE_TIMES = ("duration", "integrator")


class SettingError(ValueError):
    """A setting of the simulation is not usable; the message says which and why.

    Attributes:
        names: The setting, and those beside it by which it may have become unusable.
        value: What was given; None where the sentence says it.
        sentence: What is wrong.
        unit: What of the sentence concerns a number without unit alone, as Python has them.
    """

    def __init__(self, names: Sequence[str], sentence: str, value: object = None, unit: str = "") -> None:
        self.names = tuple(names)
        self.value, self.sentence, self.unit = value, sentence, unit
        shown = "" if value is None else f"{value!r} "
        super().__init__(f"{self.names[0]}: {shown}{sentence}{unit}")

    def __reduce__(self) -> tuple[Any, ...]:
        """For pickle: an error of a process that works for another one arrives there whole."""
        return type(self), (self.names, self.sentence, self.value, self.unit)

    def as_typed(self, typed: Mapping[str, tuple[str, str]]) -> str:
        """The message in the words of a command.

        Args:
            typed: Of each setting that was given, how it was named, such as `--step`, and its value as text.
        """
        name = next((name for name in self.names if name in typed), None)
        if name is None:
            return str(self)
        option, text = typed[name]
        shown = "" if self.value is None else f"'{text}' "
        return f"{option}: {shown}{self.sentence}"


def with_adjusting_factor(scenario: Scenario, factor: object) -> Scenario:
    """The same lift with another factor [1] for all equalizers that are approximated.

    Raises:
        SettingError: If it is no number above zero, or no equalizer is approximated.
    """
    if not _is_above_zero(factor):
        raise SettingError(["adjusting_factor"], "is not a number above zero", factor)
    given = scenario.equalizers or {}
    approximated = [name for name, one in resolve(scenario).equalizers.items() if not one.has_sheaves]
    if not approximated:
        sentence = "no equalizer of this lift has 'mechanism: approximated'"
        raise SettingError(["adjusting_factor"], sentence)
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
        sentence = "is none; 'locked' pins all moving sheaves where they start"
        raise SettingError(["equalizers"], sentence, word)
    given = scenario.equalizers or {}
    rigged = {name: one for name, one in resolve(scenario).equalizers.items() if one.has_sheaves}
    if not rigged:
        raise SettingError(["equalizers"], "no equalizer of this lift has moving sheaves to lock")
    rigid = [name for name, one in rigged.items() if one.rope.inextensible]
    if rigid:
        sentence = (
            f"the rope of '{rigid[0]}' is inextensible, and pins in all its sheaves hold the same again"
        )
        raise SettingError(["equalizers"], f"{sentence}; give it an axial stiffness")
    locked = {}
    for name, one in rigged.items():
        # A pin sits in a guide, and what it holds does not move, so the guide itself changes nothing.
        held = {
            "travel": one.travel.model_copy(update={"locked": True}),
            "moving_sheaves": one.moving_sheaves.model_copy(update={"guided": "vertical"}),
        }
        locked[name] = given[name].model_copy(update=held)
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
            raise SettingError([name], _not_of(integrator, name))
        place[name] = _switch(name, value) if name in _SWITCHES else _above_zero(name, value)
    if integrator.get("paper") and given.get("geometric_stiffness"):
        raise SettingError(["geometric_stiffness", "paper"], "paper is without it; leave one of both out")
    times = wrong_times(merged["duration"], integrator.get("step"), merged["sample_interval"])
    for name, sentence in times:
        raise SettingError([name, *_BESIDE_TIMES], sentence)
    if too_early := ends_too_early(scenario, merged["duration"]):
        raise SettingError(["duration"], too_early)
    return merged


def _not_of(integrator: Mapping[str, Any], name: str) -> str:
    """That an integrator has no such setting, with those that have it or else all that it has."""
    owners = [kind for kind, keys in INTEGRATOR_KEYS.items() if name in keys]
    right = f"there are {', '.join(('integrator', *list(integrator)[1:], *_OF_RUN))}"
    if owners:
        right = f"{' and '.join(owners)} {'has' if len(owners) == 1 else 'have'} it"
    return f"not a setting of the integrator {integrator['type']}; {right}"


def _integrator(scenario: Scenario, settings: Mapping[str, Any], kind: object) -> dict[str, Any]:
    """Settings of the integrator that is asked for; of the lift file's where none is."""
    if kind is None or kind == settings["type"]:
        return dict(settings)
    if isinstance(kind, str):
        with suppress(KeyError):
            return integrator_settings(kind, scenario.simulation)
    *others, last = INTEGRATOR_KEYS
    raise SettingError(["integrator"], f"is none; there are {', '.join(others)} and {last}", kind)


def _switch(name: str, value: object) -> bool:
    if not isinstance(value, bool | np.bool_):
        raise SettingError([name], "is neither True nor False", value)
    return bool(value)


def _above_zero(name: str, value: object) -> float:
    if not _is_above_zero(value):
        what, unit = _ABOVE_ZERO[name]
        raise SettingError([name], f"is not {what}", value, unit)
    if value < SMALLEST:
        raise SettingError([name], "is absurdly small; check the number and its unit", value)
    return float(value)


def _is_above_zero(value: object) -> TypeGuard[float]:
    """Whether it is a number above zero that a float can hold."""
    if is_number(value):
        with suppress(OverflowError):
            return 0.0 < float(value) < math.inf
    return False
