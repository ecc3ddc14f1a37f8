"""Cranes that lean under load, ashore or with their vessel, where no chart says that they may."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from gantline.checks.booms import lean_at_design
from gantline.checks.check import Check, Verdict
from gantline.results.recording import Recording
from gantline.results.rotation import tilt
from gantline.results.variable import FloatArray
from gantline.units import format_quantity

__all__ = ["out_of_level"]

#: Lean of the tracks up to which a chart without a word on that holds [rad]: 1 % of slope. Plausible, no
#: document; makers rate cranes that stand level, and many say within how much.
_LEVEL = math.atan(0.01)
#: The same of a vessel, which heels as its crane lifts [rad]: 2 % of what hangs pulls across a boom then, as
#: by a side-lead that warns.
_AFLOAT = math.atan(0.02)
#: Share of the most that its hooks bear from which on a lean counts [1]: without it a counterweight leans it.
_LOADED = 0.25


@dataclass(frozen=True)
class _Lean:
    """How a crane leans.

    Attributes:
        crane: Its name.
        hooks: Its hooks.
        angle: From level, shape (time,) [rad].
        most: What a chart without a word on that holds for [rad].
        what: What leans, and what its rating does not say, in words around the angle.
        meaning: What is compared.
    """

    crane: str
    hooks: Sequence[str]
    angle: FloatArray
    most: float
    what: tuple[str, str]
    meaning: str


def out_of_level(recording: Recording) -> list[Check]:
    """A warning for each crane that leans under load, where its chart does not say that it may.

    Its falls hang plumb all the same, and pull across a boom that leans aside: no lead tells of it.
    """
    found = (_told(recording, lean) for lean in (*_ashore(recording), *_afloat(recording)))
    return [check for check in found if check is not None]


def _ashore(recording: Recording) -> Iterator[_Lean]:
    """Of crawler and mobile cranes."""
    for crane in recording.rig.crawlers:
        charts = [one for one in recording.rig.rating_charts if one.crane == crane.name]
        if charts and all(one.heel is not None and one.trim is not None for one in charts):
            continue
        what = (
            "its tracks lean by",
            "cranes are rated level, and as much of what hangs pulls across a boom that leans aside; 'heel' "
            "and 'trim' of its rating say what its chart allows",
        )
        lean = tilt(recording.column("body_orientation", crane.tracks))
        meaning = "a crane whose chart has no 'heel' and 'trim' leans by at most 1 % under load"
        yield _Lean(crane.name, crane.hooks, lean, _LEVEL, what, meaning)


def _afloat(recording: Recording) -> Iterator[_Lean]:
    """Of cranes on vessels, as they lie with the design weight too."""
    charts = {chart.crane: chart for chart in recording.rig.rating_charts}
    ways: tuple[tuple[Literal["heel", "trim"], str, str], ...] = (
        ("heel", "across", "its falls hang plumb, and as much of what hangs pulls across its boom"),
        ("trim", "along", "charts hold within an attitude"),
    )
    for boom in recording.rig.booms:
        chart, hooks = charts.get(boom.name), [hook.name for hook in boom.hooks]
        for way, where, why in ways if boom.vessel else ():
            if chart is not None and all(getattr(chart.of(hook), way) is not None for hook in hooks):
                continue
            lean = np.maximum(
                np.abs(recording.column(f"crane_{way}", boom.name)),
                np.abs(lean_at_design(recording, boom.name, way)),
            )
            lacking, allows = f"whose chart has no '{way}'", "of its rating says what its chart allows"
            if chart is None:
                lacking, allows = "without a chart", "of a rating, which it has not, says what is allowed"
            what = f"it leans {where} its boom by", f"{why}; '{way}' {allows}"
            meaning = f"a crane afloat {lacking} leans {where} its boom by at most 2 % under load"
            yield _Lean(boom.name, hooks, lean, _AFLOAT, what, meaning)


def _told(recording: Recording, lean: _Lean) -> Check | None:
    """The warning of a crane that leans by more than its chart holds for without a word, under load."""
    borne = np.zeros(len(recording.time))
    for hook in lean.hooks:
        borne += recording.column("hook_load", hook)
    angle = np.where(borne < _LOADED * borne.max(initial=0.0), 0.0, lean.angle)
    if recording.is_equilibrium:
        angle[:-1] = 0.0
    if not angle.max(initial=0.0) > lean.most:
        return None
    worst = int(np.argmax(angle))
    slope = format_quantity(math.tan(float(angle[worst])), "%", 1)
    degrees = format_quantity(float(angle[worst]), "deg", 2)
    before, after = lean.what
    return Check(
        "stands_level",
        Verdict.WARNING,
        lean.meaning,
        element=lean.crane,
        time=None if recording.is_equilibrium else float(recording.time[worst]),
        remark=f"{before} {degrees}, {slope}, under load: {after}",
    )
