"""Ropes that parted, and what the others carried then: whether they would have held, a reader asks first."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from gantline.checks.check import Check, Verdict
from gantline.results import series
from gantline.results.recording import Recording
from gantline.results.ropes.parting import PLANNED, Parting, partings
from gantline.units import format_quantity

#: A sling that has less than this of its largest tension is slack beside those that carry [1].
_SLACK = 0.01


def parted(recording: Recording) -> Iterator[Check]:
    """One that failed for each rope that was cut or broke, other than as planned."""
    for parting in partings(recording):
        if parting.kind not in PLANNED:
            carried = f"{parting.kind}, it carried {format_quantity(parting.tension, 'kN', 1)}"
            yield Check(
                "rope_parted",
                Verdict.FAILED,
                "a rope was cut or broke",
                element=parting.rope,
                time=parting.time,
                remark="; ".join([carried, *_others(recording, parting)]),
            )


def _others(recording: Recording, parting: Parting) -> Iterator[str]:
    """Which sling was nearest to its breaking force afterwards, when, and which hung slack beside it.

    Slings alone: by them hangs what fell on the others. Nothing where none has a breaking force, or the one
    that parted was none of them.
    """
    names = {sling.rope for sling in recording.rig.slings}
    after = recording.time > parting.time
    if parting.rope not in names or not np.any(after):
        return
    strength = {rope.name: rope.minimum_breaking_force for rope in recording.rig.ropes if rope.name in names}
    tensions = {name: series.tightest_tension(recording, name) for name in strength if name != parting.rope}
    shares = {
        name: np.where(after, tension, 0.0) / force
        for name, tension in tensions.items()
        if (force := strength[name]) is not None
    }
    if not shares:
        return
    most = max(shares, key=lambda name: float(np.max(shares[name])))
    at = int(np.argmax(shares[most]))
    if shares[most][at] <= 0.0:
        yield "no sling carries anything after that"
        return
    share = format_quantity(float(shares[most][at]), "%", 0)
    tension = format_quantity(float(tensions[most][at]), "kN", 1)
    text = f"after that {most} has most, {tension}, {share} of its minimum breaking force"
    gone = {one.rope for one in partings(recording) if one.time <= recording.time[at]}
    slack = [
        name
        for name, one in tensions.items()
        if name not in gone and series.is_on(recording, name)[at] and one[at] <= _SLACK * np.max(one)
    ]
    yield f"{text}, with {', '.join(slack)} slack" if slack else text
