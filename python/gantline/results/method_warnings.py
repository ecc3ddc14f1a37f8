"""What is doubtful about a run for the method by which it was made: its steps, its tolerance, its books."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from gantline.results.metrics import energy_bound
from gantline.results.rig import Rig
from gantline.results.stability import energy_gain
from gantline.results.variable import Columns, Names
from gantline.units import format_by_size, format_quantity

__all__ = ["method_warnings"]

#: Longest fixed steps that follow how a lift rings, by method [s]. `del` damps a swing of f by π f h of
#: critical: 100 t on slings, 4 Hz, has a dynamic factor of 1.230, and 1.207 with 5 ms, 1.128 with 40 ms.
_LONG_STEP = {"del": 5e-3, "explicit": 0.05}
#: Largest tolerance of tension, as a share of what a sling bears of the load. Of four lifts dynamic factors
#: are wrong by up to 1.4 % with it, by -3.3 to 6 % with three times as much, by 21 % with ten times.
_WIDE = 0.01
#: Energy from nowhere above which a run is doubtful, of the largest energy [1]: what `del` takes and gives in
#: turn where a vessel rolls by 20 deg is a thousandth, in steps of 1 ms.
_GAIN = 0.01
#: A support that throws its load up does so at the end of a step, and energies are on a line along that:
#: they pass a bound as much before it, or as little after, where samples lie between [s].
_LONGEST, _JUST = 5.0, 0.1
#: How fast lifts on slings and falls ring, for the warning [Hz].
_RINGING = 4.0


def method_warnings(
    settings: Mapping[str, Any],
    rig: Rig,
    columns: Columns,
    names: Names,
    counters: Mapping[str, int],
    remainder: float,
) -> list[str]:
    """A sentence for each such doubt.

    Args:
        settings: Of the run.
        rig: What was lifted with what.
        columns: What was recorded, SI units.
        names: Along the columns.
        counters: What the run counted.
        remainder: Energy that the audit cannot place, of the largest energy [1].
    """
    integrator = settings["integrator"]
    warnings = _unbalanced(settings, remainder) + _from_nowhere(integrator, columns, names)
    warnings += _unsettled(counters, columns)
    return warnings + _long_steps(integrator) + _wide_tolerance(integrator, rig)


def _unbalanced(settings: Mapping[str, Any], remainder: float) -> list[str]:
    """A warning of a balance of energy that does not close."""
    bound = energy_bound(settings)
    if remainder <= bound:
        return []
    missed = f"remainder {remainder:.2g} of the largest energy, bound {bound:g}"
    return [f"the energy balance does not close: {missed}"]


def _from_nowhere(integrator: Mapping[str, Any], columns: Columns, names: Names) -> list[str]:
    """A warning of a run that gains energy, which the method puts in: the balance closes with that."""
    if not len(columns["time"]):
        return []
    gain, since = energy_gain(columns["energy"], names["energy_kind"], columns["time"], _GAIN)
    if since is None:
        return []
    share = f"{100 * gain:.2g} % of the largest energy come from nowhere, the first of it by {since:.2f} s"
    # The steps of `adaptive` are as short as its tolerances ask for.
    support = _met_from_beside(columns, names, since) if integrator["type"] == "adaptive" else None
    if support is None:
        return [f"{share}: steps are too long for what moves here"]
    pushed = (
        f"{support} pushes up a load that comes over it from beside, below its top, or slides on it askew"
    )
    return [f"{share}: {pushed}, whatever that takes; keep the load clear of it until it is let down on it"]


def _met_from_beside(columns: Columns, names: Names, since: float) -> str | None:
    """The support that a load came over as energy came from nowhere [s]; None where none did."""
    supports = {at: name for at, name in enumerate(names["contact"]) if name.startswith("support.")}
    time = columns["time"]
    bears = columns["contact_force"][:, list(supports)] > 0.0
    begins = np.argwhere(bears[1:] & ~bears[:-1])
    met = [(float(time[sample + 1]), list(supports.values())[at]) for sample, at in begins]
    # One that has thrown its load up between two samples is known by what it did to friction.
    events = zip(columns["event_time"], names["event_kind"], names["event_name"], strict=True)
    met += [(float(at), name) for at, kind, name in events if kind in ("slip", "stick")]
    near = [one for one in met if one[1] in supports.values() and -_JUST <= one[0] - since <= _LONGEST]
    return min(near)[1] if near else None


def _unsettled(counters: Mapping[str, int], columns: Columns) -> list[str]:
    """A warning of steps whose iterations were capped, with how far forces are off their laws."""
    count = counters["unconverged"]
    if not count:
        return []
    steps = f"{count} of {counters['steps']} steps"
    largest = format_by_size(float(columns["residual_complementarity"].max(initial=0.0)), "force", 2)
    what = "friction, and which ropes and contacts carry, were left open"
    return [f"not settled in {steps}: {what}, forces off their laws by {largest} at most; try a shorter step"]


def _long_steps(integrator: Mapping[str, Any]) -> list[str]:
    """A warning of fixed steps that are too long to see what a lift is simulated for."""
    step, method = integrator.get("step", 0.0), integrator["type"]
    if step <= _LONG_STEP.get(method, math.inf):
        return []
    sentence = f"steps of {step:g} s: what rings within a few of them is not followed"
    if method == "del":
        share = format_quantity(min(math.pi * _RINGING * step, 1.0), "%", 0)
        much = f"at {_RINGING:g} Hz by {share} of critical"
        sentence = f"steps of {step:g} s: the method damps what rings, and peaks with it, {much}"
    return [f"{sentence}; 1 ms is usual"]


def _wide_tolerance(integrator: Mapping[str, Any], rig: Rig) -> list[str]:
    """A warning of a tolerance of tensions that is no longer small beside them."""
    tolerance = integrator.get("tension_tolerance")
    if tolerance is None or not rig.slings:
        return []
    borne = sum(load.weight for load in rig.loads) / len(rig.slings)
    if tolerance <= _WIDE * borne:
        return []
    much, beside = (format_quantity(value, "kN", 1) for value in (tolerance, borne))
    sentence = f"a tolerance of {much} is wide beside the {beside} that a sling bears"
    return [f"{sentence}: peaks may be wrong by more than that"]
