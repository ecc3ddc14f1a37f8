"""A lift a second time with a finer method, to say how far its figures are the method's."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict
from typing import Any

import numpy as np

from gantline.arguments import needed
from gantline.checks import NO_WARNINGS, Check, Verdict, check_recording
from gantline.results import series
from gantline.results.comparison import Comparison, compare
from gantline.results.loads.lift_off import lift_off_time
from gantline.results.recording import Recording, recorded
from gantline.results.refinement import Apart, Figure, Refinement
from gantline.simulation import Simulation

__all__ = ["finer_simulation", "refined"]

#: What the finer run has of the settings of the lift, see docs/concepts/refinement.md.
_SHARES = {"tension_tolerance": 0.1, "position_tolerance": 0.1, "step": 0.25}
#: Ropes that carry less than this share of what the rope with the most carries are not compared.
_LITTLE = 0.1


def finer_simulation(simulation: Simulation, recording: Recording) -> Simulation:
    """The same lift with tolerances a tenth, or steps a quarter as long.

    Args:
        simulation: The lift.
        recording: What it recorded, for the tolerances that it used.

    Raises:
        TypeError: If one of them is something else.
        ValueError: If the recording is by another method.
    """
    needed(simulation, Simulation, "a simulation", "gantline.Simulation makes one of a lift")
    recorded(recording)
    used: dict[str, Any] = dict(simulation.settings["integrator"])
    kind, ran = used.pop("type"), recording.attributes["settings"]["integrator"]
    if ran.get("type") != kind:
        raise ValueError(
            f"the recording is by {ran.get('type')}, and the simulation by {kind}; its own is right"
        )
    for name, share in _SHARES.items():
        if name in used:
            used[name] = share * ran[name]
    times = {name: simulation.settings[name] for name in ("duration", "sample_interval")}
    return Simulation(simulation.scenario, integrator=kind, **used, **times)


def refined(recording: Recording, finer: Recording) -> Recording:
    """The same recording, which also says how far its figures moved in a finer run.

    Where checks came out otherwise that is a warning of the recording.

    Args:
        recording: As run.
        finer: Of the finer run, see `finer_simulation`.

    Raises:
        ValueError: If one of the runs did not get to its end, they are not of one lift and duration, or the
            second is no finer.
        TypeError: If one of them is no recording.
    """
    for one in (recording, finer):
        status = recorded(one).attributes["status"]
        if status != "done":
            raise ValueError(f"a run shows its error at its end, and its status is {status!r}")
    lasts, other = (one.attributes["settings"]["duration"] for one in (recording, finer))
    if lasts != other or recording.attributes["scenario"] != finer.attributes["scenario"]:
        sentence = f"they are no runs of one lift and one duration ({lasts:g} s and {other:g} s)"
        raise ValueError(f"{sentence}; `finer_simulation` makes the finer one")
    used, less = (run.attributes["settings"]["integrator"] for run in (recording, finer))
    if not any(less[name] < used[name] for name in _SHARES if name in used and name in less):
        raise ValueError("the second run is no finer than the first; `finer_simulation` makes one that is")
    found = _refinement(recording, finer)
    attributes = {**recording.attributes, "refinement": asdict(found)}
    if found.verdicts:
        otherwise = f"with {found.how} checks come out otherwise: {'; '.join(found.verdicts)}"
        attributes["warnings"] = [*attributes.get("warnings", ()), otherwise]
    return Recording(recording.variables, recording.coordinates, attributes)


def _refinement(recording: Recording, finer: Recording) -> Refinement:
    before, after = (check_recording(one) for one in (recording, finer))
    paired = list(_pairs(before, after))
    used = finer.attributes["settings"]["integrator"]
    compared = compare(recording, finer)
    clear = [lift_off_time(one) for one in (recording, finer)]
    return Refinement(
        settings={name: used[name] for name in _SHARES if name in used},
        figures=[
            Figure(
                one.name,
                one.element,
                one.value,
                other.value,
                one.limit,
                one.unit,
                one.digits,
                one.at_least,
                one.step,
            )
            for one, other in paired
            if one is not None and other is not None and one.value is not None and other.value is not None
            if np.isfinite([one.value, other.value]).all()
        ],
        verdicts=[_otherwise(one, other) for one, other in paired if _differ(one, other)],
        tension=_tension(recording, compared),
        lift_off=None if clear[0] is None or clear[1] is None else clear[1] - clear[0],
        apart=_apart(compared),
    )


def _pairs(before: Sequence[Check], after: Sequence[Check]) -> Iterator[tuple[Check | None, Check | None]]:
    """Checks that belong together: by name and step, and by element where there are several of these."""
    groups: dict[tuple[str, str], tuple[list[Check], list[Check]]] = defaultdict(lambda: ([], []))
    for side, checks in enumerate((before, after)):
        for check in checks:
            groups[check.name, check.step][side].append(check)
    for ones, others in groups.values():
        if len(ones) == len(others) == 1:
            yield ones[0], others[0]
            continue
        elements = dict.fromkeys(check.element for check in (*ones, *others))
        for element in elements:
            first, second = (
                next((check for check in side if check.element == element), None) for side in (ones, others)
            )
            yield first, second


def _outcome(check: Check | None) -> Verdict:
    """A check that is not made has nothing to complain of."""
    return Verdict.OK if check is None or check.verdict is Verdict.NOT_CHECKED else check.verdict


def _differ(one: Check | None, other: Check | None) -> bool:
    """Whether a check comes out otherwise. Warnings of long steps and wide tolerances are gone with these."""
    are_gone = one is not None and one.name == NO_WARNINGS and _outcome(other) is Verdict.OK
    return _outcome(one) != _outcome(other) and not are_gone


def _otherwise(one: Check | None, other: Check | None) -> str:
    check = one or other
    assert check is not None
    step = f"(end of '{check.step}')" if check.step else ""
    what = " ".join(filter(None, (check.name, check.element, step)))
    sides = [f"{_outcome(side).value}{_value(side)}" for side in (one, other)]
    return f"{what} {sides[0]} as run, {sides[1]} so"


def _value(check: Check | None) -> str:
    return "" if check is None or check.value is None else f" with {check.shown(check.value)}"


def _tension(recording: Recording, compared: Comparison) -> float | None:
    """Largest rms difference of a rope's tension, of its own largest [1]."""
    peaks: Mapping[str, float] = {
        rope: series.rope_peak(recording, rope)[0] for rope in recording.coordinates.get("rope", ())
    }
    least = _LITTLE * max(peaks.values(), default=0.0)
    shares = [
        one.deviation.rms / peaks[one.name]
        for one in compared.ropes
        if one.deviation is not None and peaks[one.name] > least
    ]
    return max(shares, default=None)


def _apart(compared: Comparison) -> Apart | None:
    """The body that is farthest from where it is in the finer run."""
    found = [
        Apart(one.name, one.position.largest, one.position.time)
        for one in compared.bodies
        if one.position is not None and one.position.largest > 0.0
    ]
    return max(found, key=lambda one: one.distance, default=None)
