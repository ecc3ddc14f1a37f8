"""Who hangs on whom: names looked up, types and defaults filled in."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from gantline.scenario.cranes.chain_hoist import ChainHoist
from gantline.scenario.cranes.compensator import rod_of
from gantline.scenario.cranes.crane import (
    Equalizer,
    EqualizerFrame,
    FixedSheaves,
    Hinge,
    MovingSheaves,
    RopeEnds,
    Travel,
)
from gantline.scenario.cranes.hooks import full_name
from gantline.scenario.errors import nearest
from gantline.scenario.extension import (
    ExtensionRigging,
    SlingEnd,
    check_sling_over,
    extensions_of,
    sling_ends,
)
from gantline.scenario.findings import Findings, Path
from gantline.scenario.gear import RopeMaterial, Shackle, Sling, SlingDefaults
from gantline.scenario.model import Scenario
from gantline.scenario.plan.slinging import starts_off
from gantline.scenario.rope_weight import RopeWeight, RopeWeightWord, check_rope_weight, rope_weight
from gantline.scenario.sheave import SheaveLosses, SheaveWords, sheave_losses, taken_together
from gantline.scenario.sling_ends import Upper, lower_end, upper_end
from gantline.scenario.tolerance import LARGEST_TOLERANCE

__all__ = [
    "SHEAVES",
    "EqualizerRigging",
    "Rigging",
    "SlingRigging",
    "resolve",
    "sheave_levels",
]

#: Keys of an equalizer's sheaves.
SHEAVES = ("fixed_sheaves", "moving_sheaves")
_EQUALIZER_MAY_HAVE = ("hinge", "rated_capacity", "rope_weight", "mechanism", "adjusting_factor")
_EQUALIZER_NEEDS = ("frame", "rope", "rope_ends", "fixed_sheaves", "moving_sheaves", "travel")


@dataclass(frozen=True)
class EqualizerRigging:
    """An equalizer with all its parts.

    Attributes:
        sheave_losses: what one of its `fixed_sheaves` and one of its `moving_sheaves` do to the rope.
    """

    name: str
    hook: str
    heading: float
    rated_capacity: float | None
    frame: EqualizerFrame
    hinge: Hinge
    rope: RopeMaterial
    weight: RopeWeight
    rope_ends: RopeEnds
    fixed_sheaves: FixedSheaves
    moving_sheaves: MovingSheaves
    travel: Travel
    sheave_losses: dict[str, SheaveLosses]
    mechanism: str
    adjusting_factor: float | None

    @property
    def has_sheaves(self) -> bool:
        """Whether its sheaves move; else its slings hang from its frame, and their lengths are adjusted."""
        return self.mechanism == "sheaves"


@dataclass(frozen=True)
class SlingRigging:
    """A sling from a moving sheave, hook or other gear to a lug or further gear, or over an extension sheave.

    Attributes:
        hook: hook under which it hangs; empty for a sling over an extension sheave, or under a spreader or
            compensator.
        equalizer: equalizer from which it hangs; None for none.
        sheave: the moving sheave there, counted from 1.
        spreader: spreader from which it hangs; None for none.
        upper_lug: the lug there.
        compensator: compensator from whose rod it hangs; None for none.
        over: extension sheave that it runs over, from end to end.
        ends: its lower ends: one, or two if it runs over a sheave.
        length: bearing to bearing, unloaded [m].
        tolerance: what the length may be off, plus and minus [m].
        starts_on: whether it is on at the start, and not put on by a step of the plan.
        chain_hoist: what changes its length as steps say; None for nothing.
        bends_about: diameters of what its eyes lie on without a shackle, at `top` and `bottom` [m].
    """

    name: str
    hook: str
    equalizer: str | None
    sheave: int | None
    spreader: str | None
    upper_lug: str | None
    compensator: str | None
    over: str | None
    ends: tuple[SlingEnd, ...]
    length: float
    tolerance: float
    rope: RopeMaterial
    weight: RopeWeight
    top: tuple[str, Shackle] | None
    bottom: tuple[str, Shackle] | None
    starts_on: bool = True
    chain_hoist: ChainHoist | None = None
    bends_about: Mapping[str, float] = field(default_factory=dict)

    @property
    def upper_body(self) -> str:
        """Name of the body that holds the upper end, or of the extension sheave that it runs over."""
        beside = self.over or self.spreader
        if beside is not None:
            return beside
        if self.compensator is not None:
            return rod_of(self.compensator)
        return self.hook if self.equalizer is None else f"{self.equalizer}.{self.sheave}"

    @property
    def lugs(self) -> tuple[str, ...]:
        """Lugs of the load at its lower ends."""
        return tuple(end.lug for end in self.ends if end.lug is not None and end.spreader is None)

    @property
    def above(self) -> str | None:
        """Spreader, extension sheave or compensator that bears it; None of one in a hook or equalizer."""
        return self.over or self.spreader or self.compensator


@dataclass(frozen=True)
class Rigging:
    """All equalizers, slings and extension sheaves of a lift."""

    equalizers: dict[str, EqualizerRigging]
    slings: dict[str, SlingRigging]
    extensions: dict[str, ExtensionRigging]


def resolve(scenario: Scenario) -> Rigging:
    """Look up every name of the rigging.

    Raises:
        ScenarioError: with every name that leads nowhere and every part that is missing.
    """
    findings = Findings(scenario)
    equalizers = {}
    for name in scenario.equalizers or {}:
        one = _equalizer(findings, name)
        if one is not None:
            equalizers[name] = one
    slings = {}
    holders: dict[str, str] = {}
    off = starts_off(scenario)
    for name in scenario.slings or {}:
        sling = _sling(findings, name)
        if sling is None:
            continue
        slings[name] = replace(sling, starts_on=name not in off)
        if sling.equalizer is not None and sling.upper_body in holders:
            sentence = (
                f"moving sheave '{sling.upper_body}' already carries sling '{holders[sling.upper_body]}'"
            )
            right = "each moving sheave carries one sling"
            if name in off:
                right += " over the whole plan; one that a step puts on may hang from a hook or spreader"
            findings.add(("slings", name, "from"), f"{sentence}; {right}")
        holders.setdefault(sling.upper_body, name)
    _check_ends_that_say_nothing(findings)
    extensions = extensions_of(findings, scenario.slings or {}, slings)
    findings.raise_any()
    return Rigging(equalizers, slings, extensions)


def _equalizer(findings: Findings, name: str) -> EqualizerRigging | None:
    given = (findings.scenario.equalizers or {})[name]
    path = ("equalizers", name)
    before = len(findings.problems)
    _check_hook(findings, name, given)
    parts: dict[str, Any] = {}
    kind = None
    if given.type is not None:
        types = findings.scenario.equalizer_types or {}
        kind = types.get(given.type)
        if kind is None:
            sentence = f"'{given.type}' is not a name of 'equalizer_types'; {nearest(given.type, types)}"
            findings.add((*path, "type"), sentence)
            return None
    for key in (*_EQUALIZER_NEEDS, *_EQUALIZER_MAY_HAVE):
        parts[key] = getattr(given, key)
        if parts[key] is None and kind is not None:
            parts[key] = getattr(kind, key)
    missing = [key for key in _EQUALIZER_NEEDS if parts[key] is None]
    for key in missing:
        findings.add(path, f"'{key}' is missing; an equalizer needs it, or a type that has it")
    if "rope" not in missing:
        where = (*path, "rope") if given.rope is not None else ("equalizer_types", str(given.type), "rope")
        parts["rope"] = _material(findings, parts["rope"], where)
    if len(findings.problems) > before:
        return None
    parts["hinge"] = parts["hinge"] or Hinge()
    parts["mechanism"] = parts["mechanism"] or "sheaves"
    parts["weight"] = _equalizing_rope_weight(findings, name, parts["rope"], parts.pop("rope_weight"))
    own_mass, rope_mass = parts["moving_sheaves"].mass, parts["rope"].mass_per_length
    losses = {}
    for key in SHEAVES:
        words = taken_together([said for _, said in sheave_levels(findings.scenario, name, key)])
        losses[key] = sheave_losses(words, parts[key].pitch_diameter / 2, rope_mass, own_mass)
    hook = full_name(given.hangs_from, findings.scenario.hooks) or given.hangs_from
    return EqualizerRigging(name=name, hook=hook, heading=given.heading, sheave_losses=losses, **parts)


def sheave_levels(scenario: Scenario, name: str, key: str) -> list[tuple[Path, SheaveWords]]:
    """Places that say something of losses and inertia of an equalizer's sheaves, the one that counts first.

    Args:
        scenario: the lift.
        name: name of the equalizer.
        key: `fixed_sheaves` or `moving_sheaves`.
    """
    given = (scenario.equalizers or {})[name]
    kind = (scenario.equalizer_types or {}).get(given.type or "")
    own, of_type = ("equalizers", name), ("equalizer_types", str(given.type))
    order: list[tuple[Path, SheaveWords | None]] = [((*own, "sheaves"), given.sheaves)]
    if getattr(given, key) is not None:  # takes the place of those of the type, with all their words
        order.insert(0, ((*own, key), getattr(given, key)))
    elif kind is not None:
        order.append(((*of_type, key), getattr(kind, key)))
    if kind is not None:
        order.append(((*of_type, "sheaves"), kind.sheaves))
    return [(path, words) for path, words in order if words is not None]


def _equalizing_rope_weight(
    findings: Findings, name: str, kind: RopeMaterial, way: RopeWeightWord | None
) -> RopeWeight:
    given = (findings.scenario.equalizers or {})[name]
    own = given.rope_weight is not None
    base = ("equalizers", name) if own else ("equalizer_types", str(given.type))
    rope = given.rope or (findings.scenario.equalizer_types or {})[str(given.type)].rope
    check_rope_weight(
        lambda key, sentence: findings.add((*base, key), sentence),
        str(rope),
        kind,
        way,
        over_sheaves="an equalizing rope",
        gravity=findings.scenario.simulation.gravity,
    )
    return rope_weight(kind, way, None)


def _check_hook(findings: Findings, name: str, given: Equalizer) -> None:
    equalizers = findings.scenario.equalizers or {}
    hook, hooks = given.hangs_from, findings.scenario.hooks
    if hook in hooks or (hook not in equalizers and full_name(hook, hooks) is not None):
        return
    chain = [name]
    while hook in equalizers and hook not in chain:
        chain.append(hook)
        hook = equalizers[hook].hangs_from
    if hook in chain:
        loop = " -> ".join([*chain, hook])
        sentence = f"hangs in a circle ({loop}); an equalizer hangs from the hook of a crane"
    elif given.hangs_from in equalizers:
        sentence = f"'{given.hangs_from}' is an equalizer; an equalizer hangs from the hook of a crane"
    else:
        sentence = f"'{given.hangs_from}' is not a hook; {nearest(given.hangs_from, hooks)}"
    findings.add(("equalizers", name, "hangs_from"), sentence)


def _material(findings: Findings, name: str, path: Path) -> RopeMaterial | None:
    ropes = findings.scenario.ropes or {}
    if name not in ropes:
        findings.add(path, f"'{name}' is not a name of 'ropes'; {nearest(name, ropes)}")
    return ropes.get(name)


def _tolerance(findings: Findings, given: Sling, length: float | None, path: Path) -> float:
    """What the length of a sling may be off [m]."""
    defaults = findings.scenario.sling_defaults
    tolerance = given.tolerance
    if tolerance is None and defaults is not None:
        tolerance = defaults.tolerance
    if tolerance is None or length is None:
        return 0.0
    off = tolerance.of(length)
    if off > LARGEST_TOLERANCE * length:
        sentence = f"a sling of {length:g} m that is {off:g} m too long or too short is none"
        where = (*path, "tolerance") if given.tolerance is not None else path
        findings.add(where, f"{sentence}; at most a tenth is right, such as 'tolerance: 25 mm'")
    return off


def _sling(findings: Findings, name: str) -> SlingRigging | None:
    given = (findings.scenario.slings or {})[name]
    defaults = findings.scenario.sling_defaults or SlingDefaults()
    path = ("slings", name)
    before = len(findings.problems)
    upper: Upper | None = Upper()
    if given.from_ is not None:
        upper = upper_end(findings, given.from_, (*path, "from"))
    words = sling_ends(findings, given, path)
    ends = [lower_end(findings, word, (*path, "to")) for word in words or ()]
    length = given.length if given.length is not None else defaults.length
    if length is None:
        findings.add(path, "'length' is missing; a sling needs it (effective length, unloaded)")
    rope_name = given.rope if given.rope is not None else defaults.rope
    rope = None
    if rope_name is None:
        findings.add(path, "'rope' is missing; a sling needs it (a name of 'ropes')")
    else:
        where = (*path, "rope") if given.rope is not None else ("sling_defaults", "rope")
        rope = _material(findings, rope_name, where)
    shackles = given.shackles if given.shackles is not None else defaults.shackles
    base = (*path, "shackles") if given.shackles is not None else ("sling_defaults", "shackles")
    top = None
    if given.over is None:  # what all slings have at their tops is none of a sling that runs over a sheave
        top = _shackle(findings, shackles.top if shackles else None, (*base, "top"))
    bottom = _shackle(findings, shackles.bottom if shackles else None, (*base, "bottom"))
    tolerance = _tolerance(findings, given, length, path)
    weight = _sling_weight(findings, name, str(rope_name), rope)
    if rope is not None and weight is not None:
        check_sling_over(findings, given, rope, weight, path)
    if len(findings.problems) > before or upper is None or length is None or rope is None or weight is None:
        return None
    lower = tuple(end for end in ends if end is not None)
    found = SlingRigging(name, *upper, given.over, lower, length, tolerance, rope, weight, top, bottom)
    return replace(found, chain_hoist=given.chain_hoist, bends_about=_bends(findings, given, found))


def _bends(findings: Findings, given: Sling, found: SlingRigging) -> dict[str, float]:
    """Diameters of what the eyes of a sling lie on where no shackle is [m].

    What all slings lie on is none of one that has a shackle there for itself, or runs over a sheave.
    """
    defaults = findings.scenario.sling_defaults or SlingDefaults()
    own, own_shackles = given.bends_about is not None, given.shackles is not None
    bends = given.bends_about or defaults.bends_about
    path: Path = ("slings", found.name) if own else ("sling_defaults",)
    lies: dict[str, float] = {}
    for end, shackle in (("top", found.top), ("bottom", found.bottom)):
        diameter: float | None = getattr(bends, end) if bends is not None else None
        if diameter is None:
            continue
        if shackle is not None and own >= own_shackles:
            sentence = f"the {end} has a shackle, whose 'bow_diameter' the eye lies on"
            findings.add((*path, "bends_about", end), f"{sentence}; leave it out")
        elif end == "top" and given.over is not None and own:
            sentence = "a sling that runs over a sheave has no eye at its top"
            findings.add((*path, "bends_about", end), f"{sentence}; leave it out")
        elif shackle is None and (end == "bottom" or given.over is None):
            lies[end] = diameter
    return lies


def _check_ends_that_say_nothing(findings: Findings) -> None:
    """Empty `shackles` and `bends_about`; a sling has such to be without what all slings have."""
    scenario = findings.scenario
    defaults = scenario.sling_defaults or SlingDefaults()
    everywhere: list[tuple[Path, SlingDefaults]] = [(("sling_defaults",), defaults)]
    everywhere += [(("slings", name), sling) for name, sling in (scenario.slings or {}).items()]
    for key, such in (("shackles", "wb40"), ("bends_about", "300 mm")):
        for path, given in everywhere:
            ends, of_all = getattr(given, key), getattr(defaults, key)
            is_empty = ends is not None and ends.top is None and ends.bottom is None
            if is_empty and (given is defaults or of_all is None):
                sentence = f"'{key}' has neither 'top' nor 'bottom' and says nothing"
                findings.add((*path, key), f"{sentence}; such as {{top: {such}}} is right, or leave it out")


def _sling_weight(findings: Findings, name: str, rope: str, kind: RopeMaterial | None) -> RopeWeight | None:
    given = (findings.scenario.slings or {})[name]
    defaults = findings.scenario.sling_defaults or SlingDefaults()
    way = given.rope_weight if given.rope_weight is not None else defaults.rope_weight
    nodes = given.rope_nodes if given.rope_nodes is not None else defaults.rope_nodes
    if kind is None:
        return None  # the rope itself has been reported

    def add(key: str, sentence: str) -> None:
        own = getattr(given, key) is not None
        findings.add((*(("slings", name) if own else ("sling_defaults",)), key), sentence)

    # Nodes that all slings have by default are none of a sling that says another way for itself.
    nodes_said = given.rope_nodes is not None or (nodes is not None and given.rope_weight is None)
    gravity = findings.scenario.simulation.gravity
    check_rope_weight(add, rope, kind, way, nodes_said=nodes_said, gravity=gravity)
    return rope_weight(kind, way, nodes)


def _shackle(findings: Findings, name: str | None, path: Path) -> tuple[str, Shackle] | None:
    if name is None:
        return None
    shackles = findings.scenario.shackles or {}
    if name not in shackles:
        findings.add(path, f"'{name}' is not a name of 'shackles'; {nearest(name, shackles)}")
        return None
    return name, shackles[name]
