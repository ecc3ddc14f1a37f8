"""What a run counts, in words."""

from __future__ import annotations

from collections.abc import Mapping

__all__ = ["counted_in_words"]

_WORDS = {
    "unconverged": "steps in which it was not settled what carries",
    "rejected": "attempts rejected",
    "cut": "steps cut at a change of modes",
    "fill": "entries of the factors",
}


def counted_in_words(counters: Mapping[str, int]) -> list[tuple[str, int]]:
    """Each counter of a recording under its name for people; one without such a name keeps its own."""
    return [(_WORDS.get(name, name), int(count)) for name, count in counters.items()]
