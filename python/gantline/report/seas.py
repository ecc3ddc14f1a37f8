"""Section of the seas in which the lift was simulated, as `gantline seas` found it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from gantline.report.section import Section
from gantline.report.subject import ABSENT, Subject, show
from gantline.results.file.saved_seas import SavedExtreme, SavedSea, SavedSeas, degrees


class Seas(Section):
    """Up to which height of waves the lift keeps its limits, by their period and direction."""

    anchor = "seas"
    title = "Seas"
    template = "seas.html"

    def content(self, subject: Subject) -> dict[str, Any] | None:
        """What the template is given."""
        found = subject.beside.seas
        if found is None:
            return None
        kinds = [(direction, period) for direction in found.directions for period in found.periods]
        stoppers = [sea for kind in kinds if (sea := found.stopper(*kind)) is not None]
        return {
            "waves": found.waves,
            "is_regular": found.is_regular,
            "records": found.records,
            "duration": show(found.duration, "s", 0) if found.duration > 0.0 else "",
            "short": found.short,
            "fields": [_field(found, direction) for direction in found.directions],
            "stops": [_stop(sea) for sea in stoppers if not _reason(sea)],
            "extremes": [
                _extreme(sea, sea.extreme)
                for kind in kinds
                if (sea := found.highest_allowed(*kind)) is not None and sea.extreme is not None
            ],
            "past": list(dict.fromkeys(sea.by for sea in found.seas if sea.only_warns)),
            "reasons": _reasons(stoppers),
        }


def allowed_seas(found: SavedSeas) -> str:
    """Up to which heights it is a go, from the lowest to the highest of all periods and directions."""
    heights = [0.0 if height is None else height for height in found.allowed.values()]
    low, high = (f"{height:g} m" if height else "none" for height in (min(heights), max(heights)))
    if low == high:
        return low if low == "none" else f"up to {low}"
    span = f"none or up to {high}" if low == "none" else f"up to {low} to {high}"
    return f"{span}, by period and direction"


def _field(found: SavedSeas, direction: float) -> dict[str, Any]:
    """Seas of one direction, the highest first."""
    by_period = {period: found.of(direction, period)[::-1] for period in found.periods}
    return {
        "towards": degrees(direction),
        "periods": [f"{period:g} s" for period in found.periods],
        "rows": [
            {"height": f"{height:g} m", "cells": [_cell(seas[row]) for seas in by_period.values()]}
            for row, height in enumerate(found.heights[::-1])
        ],
        "allowed": [
            "none" if (height := found.allowed[direction, period]) is None else f"{height:g} m"
            for period in found.periods
        ],
    }


def _cell(sea: SavedSea) -> dict[str, str]:
    told = sea.told.lower()
    if sea.only_warns:
        return {"tone": "warn", "text": f"{sea.share} {told}"}
    tone = "good" if sea.is_allowed else "bad" if sea.has_verdict and sea.starts else "warn"
    if not sea.is_run:
        return {"tone": "", "text": told}
    if not sea.has_verdict:
        # A share within its limit by itself reads as if the sea were allowed.
        return {"tone": tone, "text": f"{sea.share} {told}".lstrip()}
    return {"tone": tone, "text": sea.share or told or "go"}


def _reasons(stoppers: Sequence[SavedSea]) -> list[str]:
    """Why seas have no verdict, each reason once behind all seas of which it is true."""
    found: dict[str, list[str]] = {}
    for sea in stoppers:
        if reason := _reason(sea):
            found.setdefault(reason, []).append(
                f"{sea.height:g} m, {sea.period:g} s, {degrees(sea.direction)}"
            )
    return [f"{'; '.join(seas)}: {reason}" for reason, seas in found.items()]


def _reason(sea: SavedSea) -> str:
    """Why a sea has no verdict, in a sentence; empty of one in which a check failed."""
    if sea.cause:
        return f"{sea.told.lower()}: {sea.cause}"
    return "" if sea.has_verdict else sea.verdict


def _extreme(sea: SavedSea, extreme: SavedExtreme) -> dict[str, str]:
    return {
        "towards": degrees(sea.direction),
        "period": f"{sea.period:g} s",
        "height": f"{sea.height:g} m",
        "uses": extreme.share,
        "tone": "bad" if extreme.used > 1.0 else "good",
        "by": f"{extreme.check} {extreme.element}".strip(),
    }


def _stop(sea: SavedSea) -> dict[str, str]:
    return {
        "towards": degrees(sea.direction),
        "period": f"{sea.period:g} s",
        "height": f"{sea.height:g} m",
        "used": sea.share or ABSENT,
        "record": str(sea.record),
        "by": sea.by,
    }
