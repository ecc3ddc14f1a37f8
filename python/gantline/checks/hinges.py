"""Hinges and grippers of loads: what they bear, and whether they open without letting a force go."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from gantline.checks.check import Check, Verdict
from gantline.checks.design_weight import largest_ratios
from gantline.checks.forces import raised_of_capacity
from gantline.checks.measure import Caution, Finding, Missing
from gantline.results import series
from gantline.results.loads.hinge_peaks import hinge_peak
from gantline.results.loads.hinges import (
    HINGE_OPENED,
    Hinge,
    borne_by_pins,
    hinge_force,
    hinge_moment,
    is_shut,
)
from gantline.results.recording import Recording
from gantline.results.rig import Load
from gantline.results.variable import BoolArray, FloatArray
from gantline.units import format_quantity

__all__ = ["of_rated_capacity", "opened"]

#: Share of its load's weight that a hinge may bear as it opens [1].
_LET_GO = 0.02
#: Two pins of a hinge are so far apart or more: plausible, no document [m].
_PINS_APART = 1.0
_UNKNOWN = "it opens as the lift begins, so what it bore is not known; a 'hold' before it tells"


def of_rated_capacity(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Force between load and hinge, whichever way, raised to the design weight, over its rated capacity.

    Of one of two pins with their distance twice what the one bears that bears most.
    """
    for hinge in recording.rig.hinges:
        if hinge.rated_capacity is None:
            yield Missing(hinge.name, "rated capacity not known", is_strength=True)
            continue
        ratios = largest_ratios(recording, [hinge.load])
        force = borne_by_pins(recording, hinge)
        most = hinge_peak(recording, hinge, borne_by_pins)
        yield from raised_of_capacity(
            recording, during, hinge.name, force, ratios, hinge.rated_capacity, most
        )
        if hinge.pins_apart is None:
            yield from _askew(recording, hinge, ratios * during, hinge.rated_capacity)


def _askew(recording: Recording, hinge: Hinge, ratios: FloatArray, capacity: float) -> Iterator[Caution]:
    """A moment askew that is in no force, where pins as near as those of hinges are would not bear it.

    Pins less than b apart bear more than the capacity C with F + 2 M/b = C.
    """
    left = capacity - ratios * hinge_force(recording, hinge)
    moment = ratios * hinge_moment(recording, hinge)
    nearest = np.divide(2.0 * moment, left, out=np.zeros_like(left), where=left > 0.0)
    at = int(np.argmax(nearest))
    if nearest[at] > _PINS_APART:
        askew = format_quantity(float(moment[at]), "kN m", 1)
        apart = format_quantity(float(nearest[at]), "m", 2)
        yield Caution(
            f"its moment askew of {askew} is not in that: two pins less than {apart} apart bear more than is "
            "rated; 'pins_apart' counts it"
        )


def opened(recording: Recording) -> list[Check]:
    """A check for each hinge that a step opens: what it still bears then makes the load swing, at once.

    It has failed where that is more than a fiftieth of the load's weight. The simulation goes on without the
    hinge all the same. What was borne an equilibrium no longer has, nor a run in which it opens at once.
    """
    if recording.is_equilibrium:
        return []
    checks = []
    hinges = {hinge.name: hinge for hinge in recording.rig.hinges}
    for time, _, name in recording.events(HINGE_OPENED):
        hinge = hinges[name]
        load = recording.rig.load(hinge.load)
        if load is None:
            continue
        before = np.flatnonzero(is_shut(recording, hinge))
        verdict, remark = Verdict.WARNING, _UNKNOWN
        if before.size:
            weight = series.load_weight(recording, load)[before[-1]]
            verdict, remark = _let_go(float(hinge_force(recording, hinge)[before[-1]]), load, float(weight))
        checks.append(
            Check(
                "hinge_opens_unloaded",
                verdict,
                f"a hinge that opens bears next to nothing: {100 * _LET_GO:.0f} % of its load's weight "
                "may be left",
                element=name,
                time=time,
                remark=remark,
            )
        )
    return checks


def _let_go(force: float, load: Load, weight: float) -> tuple[Verdict, str]:
    """What a force is that a hinge lets go [N] of a load that weighs so much then [N], and what is right."""
    share = f"{100.0 * force / weight:.3g} % of what {load.name} weighs"
    borne = f"it bore {format_quantity(force, 'kN', 1)}, {share}"
    if force <= _LET_GO * weight:
        return Verdict.OK, borne
    right = "bring its hook over it, and hoist or lower until the hinge bears next to nothing"
    return Verdict.FAILED, f"{borne}; {right}"
