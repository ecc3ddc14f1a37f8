"""Whether an equalizer can be built and simulated."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise

from gantline.scenario.cranes.crane import EqualizerParts
from gantline.scenario.findings import Findings, Path
from gantline.scenario.rigging import SHEAVES, EqualizerRigging, SlingRigging, sheave_levels
from gantline.scenario.sheave import SheaveWords, check_losses, said_twice, taken_together

__all__ = ["check_equalizer"]

_ROUNDING = 1e-9

#: Notes a problem at a dotted key of the equalizer, or of its type if the type says it.
_Add = Callable[[str, str], None]
_Levels = Sequence[tuple[Path, SheaveWords]]


def check_equalizer(findings: Findings, equalizer: EqualizerRigging, slings: Sequence[SlingRigging]) -> None:
    """Note everything that is wrong with an equalizer and its slings, or that cannot be simulated yet."""
    given = (findings.scenario.equalizers or {})[equalizer.name]
    before = len(findings.problems)

    def add(key: str, sentence: str) -> None:
        parts = key.split(".")
        own = getattr(given, parts[0]) is not None
        base = ("equalizers", equalizer.name) if own else ("equalizer_types", str(given.type))
        findings.add((*base, *parts), sentence)

    _check_sheaves(findings, equalizer)
    _check_mechanism(add, findings, equalizer, slings)
    _check_guides(add, findings, equalizer)
    _check_counts(add, equalizer)
    if len(findings.problems) == before:
        _check_order(add, equalizer)
        _check_places(add, equalizer)


def _check_sheaves(findings: Findings, equalizer: EqualizerRigging) -> None:
    scenario = findings.scenario
    given = (scenario.equalizers or {})[equalizer.name]
    kind = (scenario.equalizer_types or {}).get(given.type or "")
    rope = given.rope or (kind.rope if kind is not None else None)
    if (bent := equalizer.rope.bent(str(rope), "an equalizing rope")) is not None:
        findings.add(("equalizers", equalizer.name), bent)
    for key in SHEAVES:
        levels = sheave_levels(scenario, equalizer.name, key)
        part = next(path for path, _ in levels if path[-1] == key)

        def add(word: str, sentence: str, levels: _Levels = levels, part: Path = part) -> None:
            said = (path for path, words in levels if word and getattr(words, word) is not None)
            findings.add((*next(said), word) if word else part, sentence)

        words = taken_together([words for _, words in levels])
        losses = equalizer.sheave_losses[key]
        check_losses(add, words, losses, str(rope), equalizer.rope.inextensible)
    holders: list[tuple[EqualizerParts, Path]] = [(given, ("equalizers", equalizer.name))]
    if kind is not None:
        holders.append((kind, ("equalizer_types", str(given.type))))
    for holder, path in holders:
        for key in SHEAVES:
            for shared, own in said_twice(holder.sheaves, getattr(holder, key)):
                sentence = f"'{shared}' of all sheaves stands beside '{own}' of '{key}'; say it in one place"
                findings.add((*path, "sheaves", shared), sentence)


def _check_mechanism(
    add: _Add, findings: Findings, equalizer: EqualizerRigging, slings: Sequence[SlingRigging]
) -> None:
    factor = equalizer.adjusting_factor
    if equalizer.has_sheaves:
        if factor is not None:
            sentence = "belongs to 'mechanism: approximated'; moving sheaves need no factor"
            add("adjusting_factor", f"{sentence}, leave it out")
        return
    if factor is None:
        add("mechanism", "'approximated' needs an 'adjusting_factor', such as 0.01")
    elif factor == 0:
        add("adjusting_factor", "at 0 nothing is adjusted; a number above 0 is right, such as 0.01")
    if equalizer.travel.stops:
        sentence = f"'{equalizer.name}' is approximated: it has no moving sheaves that stops could end"
        add("travel.stops", f"{sentence}; leave it out")
    if len(slings) < 2:
        sentence = f"'approximated' adjusts the lengths of slings against each other; there are {len(slings)}"
        add("mechanism", f"{sentence}, at least 2 are right")
    for sling in slings:
        path = ("slings", sling.name)
        if sling.rope.inextensible:
            sentence = f"is inextensible, and '{equalizer.name}' is approximated: it adjusts stretch"
            findings.add(path, f"{sentence}; give its rope an axial stiffness")
        if sling.rope.curve is not None:
            sentence = f"has a curve, and '{equalizer.name}' is approximated: it adjusts by one stiffness"
            findings.add(path, f"{sentence}; give its rope an axial stiffness")
        if sling.weight.nodes:
            sentence = f"has nodes, and '{equalizer.name}' is approximated: it adjusts whole ropes"
            findings.add(path, f"{sentence}; 'rope_weight: lumped' or 'none' is right")
    if findings.scenario.simulation.integrator == "adaptive":
        sentence = "adjusts lengths once per step, and 'adaptive' chooses its steps"
        add("mechanism", f"'approximated' {sentence}; write 'simulation: {{integrator: del, step: 1 ms}}'")


def _check_guides(add: _Add, findings: Findings, equalizer: EqualizerRigging) -> None:
    """What sheaves that hang free in their rope cannot be together with."""
    if equalizer.moving_sheaves.guided == "vertical":
        return
    if not equalizer.has_sheaves:
        sentence = f"'{equalizer.name}' is approximated: its slings hang from the frame"
        add("moving_sheaves.guided", f"{sentence}; leave 'guided' out")
        return
    if equalizer.rope.inextensible:
        sentence = "an inextensible equalizing rope runs over sheaves in guides alone"
        add("moving_sheaves.guided", f"{sentence}; give it an axial stiffness, or write 'guided: vertical'")
    findings.refuse_explicit("moving sheaves that hang free", instead="'guided: vertical'")


def _check_counts(add: _Add, equalizer: EqualizerRigging) -> None:
    ends = len(equalizer.rope_ends.along)
    fixed, moving = len(equalizer.fixed_sheaves.along), len(equalizer.moving_sheaves.along)
    if ends != 2:
        what = "end" if ends == 1 else "ends"
        add("rope_ends.along", f"found {ends} rope {what}; an equalizing rope has 2")
    if fixed != moving - 1:
        sentence = f"found {fixed} fixed and {moving} moving sheaves"
        add("fixed_sheaves.along", f"{sentence}; right is one fixed sheave fewer than moving ones")


def _check_order(add: _Add, equalizer: EqualizerRigging) -> None:
    ends, fixed, moving = equalizer.rope_ends, equalizer.fixed_sheaves, equalizer.moving_sheaves
    uppers = [ends.along[0], *fixed.along, ends.along[1]]
    between = zip(uppers[:-1], moving.along, uppers[1:], strict=True)
    if any(not left < middle < right for left, middle, right in between):
        sentence = (
            "along the frame a rope end comes first, then moving and fixed sheaves in turn, then a rope end"
        )
        add("moving_sheaves.along", f"{sentence}; these positions do not")
    for key, sheaves in (("fixed_sheaves", fixed), ("moving_sheaves", moving)):
        closest = _closest(sheaves.along)
        if closest < sheaves.pitch_diameter - _ROUNDING:
            sentence = f"sheaves of {sheaves.pitch_diameter:g} m that are {closest:g} m apart overlap"
            add(f"{key}.along", f"{sentence}; set them at least a diameter apart")


def _check_places(add: _Add, equalizer: EqualizerRigging) -> None:
    ends, fixed, moving = equalizer.rope_ends, equalizer.fixed_sheaves, equalizer.moving_sheaves
    half = equalizer.frame.length / 2
    for key, part in (("rope_ends", ends), ("fixed_sheaves", fixed), ("moving_sheaves", moving)):
        farthest = max(part.along, key=abs)
        if abs(farthest) > half + _ROUNDING:
            sentence = f"{farthest:g} m is outside the frame, which ends at {half:g} m from its middle"
            add(f"{key}.along", f"{sentence}; put it inside, or make the frame longer")
    depth = moving.below_hook - max(ends.below_hook, fixed.below_hook)
    if depth <= 0:
        sentence = f"the moving sheaves start {-depth:g} m above the fixed sheaves or rope ends"
        add("moving_sheaves.below_hook", f"{sentence}; they hang below them")
    elif equalizer.travel.up >= depth:
        sentence = (
            f"{equalizer.travel.up:g} m up takes the moving sheaves into the fixed ones, {depth:g} m above"
        )
        add("travel.up", f"{sentence}; a smaller travel is right")


def _closest(along: Sequence[float]) -> float:
    ordered = sorted(along)
    gaps = [after - before for before, after in pairwise(ordered)]
    return min(gaps, default=float("inf"))
