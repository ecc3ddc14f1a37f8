"""Locking pins of moving sheaves and rods: which there are, which are in, what steps of the plan do."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, field

from gantline.scenario.cranes.compensator import Compensator, rod_of, rods
from gantline.scenario.errors import nearest
from gantline.scenario.findings import Findings, Path
from gantline.scenario.model import Scenario
from gantline.scenario.rigging import EqualizerRigging, Rigging

__all__ = ["Pins", "check_pins", "pins_of"]

#: Keys of a step that move pins, with what becomes of a pin: in or not.
_KEYS = {"pull_pins": False, "put_in_pins": True}

_Note = Callable[[Path, str], None]


@dataclass
class Pins:
    """Locking pins by the names of what they hold: moving sheaves, such as `e1.2`, rods of compensators.

    Attributes:
        at_start: whether a pin is in at the start; a sheave or rod whose pin is never in has none.
        pulled: by step of the plan the sheaves and rods whose pins are pulled as it begins.
        put_in: by step of the plan those whose pins are put in as it begins.
    """

    at_start: dict[str, bool] = field(default_factory=dict)
    pulled: list[list[str]] = field(default_factory=list)
    put_in: list[list[str]] = field(default_factory=list)


def check_pins(findings: Findings, rigging: Rigging) -> None:
    """Note locked sheaves that are not there, and steps that pull or put in what they cannot."""
    _follow(findings.scenario, rigging, findings.add)


def pins_of(scenario: Scenario, rigging: Rigging) -> Pins:
    """All pins of a scenario that has been checked."""
    return _follow(scenario, rigging, lambda _path, _sentence: None)


def _follow(scenario: Scenario, rigging: Rigging, note: _Note) -> Pins:
    equalizers = rigging.equalizers
    is_in: dict[str, bool] = {}
    for name, equalizer in equalizers.items():
        locked = _locked(scenario, equalizer, note)
        is_in |= {f"{name}.{place}": place in locked for place in _places(equalizer)}
        _check_rope(equalizer, is_in, _locked_path(scenario, equalizer), note)
    compensators, rod_names = scenario.compensators or {}, rods(scenario)
    is_in |= {rod_of(name): given.locked for name, given in compensators.items()}
    pins, moved, start = Pins(), set[str](), dict(is_in)
    were_in = {sheave for sheave, locked in start.items() if locked}
    for place, step in enumerate(scenario.plan):
        before = dict(is_in)
        for key, wanted in _KEYS.items():
            changed = []
            for word in getattr(step, key):
                where = ("plan", place, key), note
                held = _rod if rod_names.get(word, word) in compensators else _named
                if held is _rod:
                    _check_seals(compensators[rod_names.get(word, word)], word, where)
                for sheave in held(word, wanted, (before, were_in), equalizers, where):
                    changed.append(sheave)
                    is_in[sheave] = wanted
            if len(set(changed)) < len(changed):
                note(("plan", place, key), "names a pin twice; each pin stands once")
            (pins.put_in if wanted else pins.pulled).append(changed)
            if wanted and changed:
                for equalizer in equalizers.values():
                    _check_rope(equalizer, is_in, ("plan", place, key), note)
            moved |= set(changed)
            were_in |= set(changed)  # one that is pulled was in
    pins.at_start = {sheave: locked for sheave, locked in start.items() if locked or sheave in moved}
    return pins


def _places(equalizer: EqualizerRigging) -> range:
    return range(1, len(equalizer.moving_sheaves.along) + 1)


def _locked_path(scenario: Scenario, equalizer: EqualizerRigging) -> Path:
    given = (scenario.equalizers or {})[equalizer.name]
    own = given.travel is not None
    base = ("equalizers", equalizer.name) if own else ("equalizer_types", str(given.type))
    return (*base, "travel", "locked")


def _check_rope(equalizer: EqualizerRigging, is_in: Mapping[str, bool], path: Path, note: _Note) -> None:
    """An equalizing rope that does not stretch and pins that all are in would hold the same twice."""
    if not equalizer.rope.inextensible or not equalizer.has_sheaves:
        return
    if all(is_in[f"{equalizer.name}.{place}"] for place in _places(equalizer)):
        sentence = f"all pins of '{equalizer.name}' are in, and its rope is inextensible"
        note(path, f"{sentence}; leave one out, or give the rope an axial stiffness")


def _unguided(equalizer: EqualizerRigging) -> str:
    """Why a pin holds no moving sheave of an equalizer; empty where it does."""
    if equalizer.moving_sheaves.guided == "vertical":
        return ""
    sentence = f"no frame guides the moving sheaves of '{equalizer.name}', and a pin sits in a guide"
    return f"{sentence}; 'guided: vertical' has pins"


def _locked(scenario: Scenario, equalizer: EqualizerRigging, note: _Note) -> tuple[int, ...]:
    """Moving sheaves, counted from 1, whose pins are in at the start."""
    path, locked, places = _locked_path(scenario, equalizer), equalizer.travel.locked, _places(equalizer)
    if locked and not equalizer.has_sheaves:
        note(path, f"'{equalizer.name}' is approximated: it has no moving sheaves to lock; leave it out")
        return ()
    if locked and (why := _unguided(equalizer)):
        note(path, f"{why}; leave 'locked' out")
        return ()
    if isinstance(locked, bool):
        return tuple(places) if locked else ()
    for place in locked:
        if place not in places:
            sentence = f"there is no moving sheave {place}; they are counted from 1 to {len(places)}"
            note(path, sentence)
    return locked


def _named(
    word: str,
    wanted: bool,
    pins: tuple[Mapping[str, bool], Collection[str]],
    equalizers: Mapping[str, EqualizerRigging],
    where: tuple[Path, _Note],
) -> list[str]:
    """Moving sheaves that a word of a step means and whose pins can be moved: one, or all of an equalizer.

    Args:
        word: Of the step.
        wanted: Whether it puts them in.
        pins: Which are in before the step, and which have been in by then.
        equalizers: All of the lift.
        where: The path of the word, and what notes a finding.
    """
    (path, note), (is_in, were_in) = where, pins
    if word in equalizers:
        return _all_of(equalizers[word], wanted, pins, where)
    if word not in is_in:
        known = [*equalizers, *is_in]
        kinds = "neither an equalizer nor a moving sheave"
        if any(name.rpartition(".")[0] not in equalizers for name in is_in):
            kinds = "no equalizer, no moving sheave and no compensator"
        note(path, f"'{word}' is {kinds}; {nearest(word, known)}")
        return []
    of_sheave = equalizers.get(word.rpartition(".")[0])
    if of_sheave is not None and (why := _unguided(of_sheave)):
        note(path, why)
        return []
    if is_in[word] == wanted:
        if wanted:
            right = "is in already; let a step before pull it"
        elif word in were_in:
            right = "has been pulled already"
        else:
            equalizer, _, place = word.rpartition(".")
            locked = equalizers[equalizer].travel.locked
            places = sorted({int(place), *(() if isinstance(locked, bool) else locked)})
            right = f"is not in; 'travel: {{locked: {places}}}' puts it in at the start"
        note(path, f"the pin of '{word}' {right}")
        return []
    return [word]


def _all_of(
    equalizer: EqualizerRigging,
    wanted: bool,
    pins: tuple[Mapping[str, bool], Collection[str]],
    where: tuple[Path, _Note],
) -> list[str]:
    """All moving sheaves of an equalizer whose pins can be moved, as `_named` has them."""
    (path, note), (is_in, were_in), name = where, pins, equalizer.name
    if not equalizer.has_sheaves:
        note(path, f"'{name}' is approximated: it has no moving sheaves, and no pins")
        return []
    if why := _unguided(equalizer):
        note(path, why)
        return []
    sheaves = [f"{name}.{place}" for place in _places(equalizer)]
    free = [sheave for sheave in sheaves if is_in[sheave] != wanted]
    if not free and (wanted or any(sheave in were_in for sheave in sheaves)):
        note(path, f"all pins of '{name}' {'are in' if wanted else 'have been pulled'} already")
    elif not free:
        note(path, f"no pin of '{name}' is in; 'travel: {{locked: true}}' puts them in at the start")
    return free


def _check_seals(given: Compensator, word: str, where: tuple[Path, _Note]) -> None:
    """A pin that goes out and friction of seals would hold the same rod; one of them is simulated."""
    path, note = where
    if given.seal_friction > 0.0:
        sentence = f"'{word}' has seal friction, and a pin that steps move; one joint has only one of them"
        note(path, f"{sentence}: leave 'seal_friction' out, or 'locked: true' on for all of the lift")


def _rod(
    word: str,
    wanted: bool,
    pins: tuple[Mapping[str, bool], Collection[str]],
    _equalizers: Mapping[str, EqualizerRigging],
    where: tuple[Path, _Note],
) -> list[str]:
    """The rod of the compensator that a word of a step means, if its pin can be moved; as `_named`."""
    (path, note), (is_in, were_in) = where, pins
    name = word if word in is_in else rod_of(word)
    if is_in[name] != wanted:
        return [name]
    if wanted:
        right = "is in already; let a step before pull it"
    elif name in were_in:
        right = "has been pulled already"
    else:
        right = "is not in; 'locked: true' puts it in at the start"
    note(path, f"the pin of '{word}' {right}")
    return []
