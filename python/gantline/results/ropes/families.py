"""Ropes in families, so that a plot of many needs few colours."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from gantline.results.rig import Rig

__all__ = ["MOST", "families", "shortened_inside"]

#: Colours that can be told apart.
MOST = 8
_MOST_OF_A_NAME = 21  # characters: longer ones would leave no room for what they stand beside


def families(rig: Rig, ropes: Sequence[str]) -> dict[str, str]:
    """What each rope belongs to: slings to their equalizer or hook, falls to their hook, and so on.

    Where that makes more than `MOST` families, hoist and luffing ropes are one each, then slings.

    Args:
        rig: What was lifted with what.
        ropes: Their names.

    Returns:
        Family by rope, in the order of `ropes`.
    """
    found: dict[str, str] = {}
    for finely in (("slings", "cranes"), ("slings",), ()):
        family = _family_of(rig, finely)
        found = {rope: family.get(rope, "other ropes") for rope in ropes}
        if len(set(found.values())) <= MOST:
            break
    return found


def shortened_inside(name: str) -> str:
    """A name for a picture: of a long one both ends, in which names of one kind differ."""
    half = (_MOST_OF_A_NAME - 1) // 2
    return name if len(name) <= _MOST_OF_A_NAME else f"{name[:half]}…{name[-half:]}"


def _family_of(rig: Rig, finely: Sequence[str]) -> Mapping[str, str]:
    """Family by rope of all ropes that have one."""

    def named(word: str, of: str, kind: str) -> str:
        return f"{word} of {of}" if kind in finely and of else word

    slings = {
        one.rope: named("slings", gear.name if gear is not None else one.from_body, "slings")
        for one in rig.slings
        for gear in [rig.equalizer_of(one) or rig.gear_above(one)]
    }
    equalizing = {one.equalizing_rope: "equalizing ropes" for one in rig.equalizers}
    equalizing |= {one.gas: "gas" for one in rig.compensators}
    falls = {
        fall.rpartition("/")[0]: named("hoist ropes", hook.name, "cranes")
        for hook in rig.hooks
        for fall in hook.falls
    }
    luffing = {rope: named("luffing ropes", boom.name, "cranes") for boom in rig.booms for rope in boom.ropes}
    moorings = {line.rope: "mooring lines" for line in rig.mooring_lines}
    tags = {line.rope: "tag lines" for line in rig.tag_lines}
    return {**tags, **moorings, **luffing, **falls, **equalizing, **slings}
