"""A lift file's text with some of its values replaced; all else, comments too, stays as it was written."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from ruamel.yaml import YAML
from ruamel.yaml.events import (
    Event,
    MappingEndEvent,
    MappingStartEvent,
    ScalarEvent,
    SequenceEndEvent,
    SequenceStartEvent,
)

from gantline.scenario.errors import PathPart

__all__ = ["text_with"]


def text_with(text: str, values: Mapping[tuple[PathPart, ...], str]) -> str:
    """The text of a lift file in which the scalars at some paths are others.

    Args:
        text: Of a lift file that has been read without an error.
        values: New scalars by path, keys of mappings and places in lists.

    Raises:
        KeyError: If there is no scalar at a path.
    """
    spans = {path: span for path, span in _scalars(text) if path in values}
    missing = next((path for path in values if path not in spans), None)
    if missing is not None:
        raise KeyError(".".join(str(part) for part in missing))
    for path, (start, end) in sorted(spans.items(), key=lambda item: item[1], reverse=True):
        text = text[:start] + values[path] + text[end:]
    return text


def _scalars(text: str) -> Iterator[tuple[tuple[PathPart, ...], tuple[int, int]]]:
    """Each scalar that is a value: its path, and where it stands in the text."""
    # Of every open collection what comes next: the place in a list, the key in a mapping, None before it.
    ahead: list[PathPart | None] = []
    for event in YAML(typ="safe", pure=True).parse(text):
        if isinstance(event, ScalarEvent) and ahead and ahead[-1] is None:
            ahead[-1] = event.value
        elif isinstance(event, ScalarEvent):
            yield tuple(part for part in ahead if part is not None), _span(event)
            _go_on(ahead)
        elif isinstance(event, MappingStartEvent):
            ahead.append(None)
        elif isinstance(event, SequenceStartEvent):
            ahead.append(0)
        elif isinstance(event, (MappingEndEvent, SequenceEndEvent)):
            ahead.pop()
            _go_on(ahead)


def _go_on(ahead: list[PathPart | None]) -> None:
    """After a value."""
    if ahead:
        ahead[-1] = ahead[-1] + 1 if isinstance(ahead[-1], int) else None


def _span(event: Event) -> tuple[int, int]:
    return event.start_mark.index, event.end_mark.index
