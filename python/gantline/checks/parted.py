"""Ropes that parted, and what the others carried then: whether they would have held, a reader asks first."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from gantline.checks.check import PARTED, Check, Verdict
from gantline.results import series
from gantline.results.recording import Recording
from gantline.results.ropes.parting import PLANNED, Parting, partings
from gantline.results.variable import FloatArray
from gantline.units import format_quantity

#: A sling that has less than this of its largest tension is slack beside those that carry [1].
_SLACK = 0.01


def parted(recording: Recording) -> Iterator[Check]:
    """One that failed for each rope that was cut or broke, other than as planned."""
    for parting in partings(recording):
        if parting.kind not in PLANNED:
            carried = f"{parting.kind}, it carried {format_quantity(parting.tension, 'kN', 1)}"
            yield Check(
                PARTED,
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
    loads = {name: _most_after(recording, name, tension, parting) for name, tension in tensions.items()}
    shares = {name: load / force for name, load in loads.items() if (force := strength[name]) is not None}
    if not shares:
        return
    most = max(shares, key=lambda name: shares[name])
    if shares[most] <= 0.0:
        yield "no sling carries anything after that"
        return
    at = int(np.argmax(np.where(after, tensions[most], 0.0)))
    share = format_quantity(shares[most], "%", 0)
    tension = format_quantity(loads[most], "kN", 1)
    text = f"after that {most} has most, {tension}, {share} of its minimum breaking force"
    gone = {one.rope for one in partings(recording) if one.time <= recording.time[at]}
    slack = [
        name
        for name, one in tensions.items()
        if name not in gone and series.is_on(recording, name)[at] and one[at] <= _SLACK * np.max(one)
    ]
    yield f"{text}, with {', '.join(slack)} slack" if slack else text


def _most_after(recording: Recording, rope: str, tension: FloatArray, parting: Parting) -> float:
    """Largest tension of a rope after another has parted [N]: that of all steps, where it is after that."""
    peak, time = series.rope_peak(recording, rope)
    most = float(np.max(tension, where=recording.time > parting.time, initial=0.0))
    return max(most, peak) if time > parting.time else most
