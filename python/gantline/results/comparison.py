"""Two recordings of a lift side by side: key numbers, ropes, hooks, hinges, motion, how sound each run was.

Differences are B less A, relative ones are of A. Ropes, hooks, hinges, loads and bodies belong together by
name; where each recording has exactly one hook, hinge, load or equalizer left over, these belong together
whatever their names.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from gantline.results import series
from gantline.results.alike import first_largest, first_peak
from gantline.results.common_time import CommonTime, Deviation
from gantline.results.file.form import FormError
from gantline.results.file.gaps import without_gaps
from gantline.results.file.validity import hold_recording
from gantline.results.loads.hinge_peaks import hinge_peak
from gantline.results.loads.hinges import hinge_force
from gantline.results.loads.hook_peaks import hook_peak
from gantline.results.recording import Recording, open_recording, recorded
from gantline.results.rig import Rig
from gantline.results.ropes.parting import Parting, partings
from gantline.results.stability import Stability, stability_of
from gantline.units import format_quantity


@dataclass(frozen=True)
class Difference:
    """One number of A and of B; None where one does not have it.

    Attributes:
        a: Of A.
        b: Of B.
    """

    a: float | None
    b: float | None

    @property
    def absolute(self) -> float | None:
        """B - A, in the unit of both; None if one is missing."""
        return None if self.a is None or self.b is None else self.b - self.a

    @property
    def relative(self) -> float | None:
        """The same over the magnitude of A [1]; None if one is missing, or A is zero and B is not."""
        if self.absolute is None or self.absolute == 0.0:
            return self.absolute
        return self.absolute / abs(self.a) if self.a else None


@dataclass(frozen=True)
class Peak:
    """Largest value of a series.

    Attributes:
        value: SI.
        time: When [s].
    """

    value: float
    time: float


@dataclass(frozen=True)
class ForceComparison:
    """A force that both recordings have: tension of a rope, hook load, or force of a load in its hinge.

    Attributes:
        name: In A.
        name_b: In B.
        peak_a: Of A [N, s]; of ropes and hooks over all steps, of hinges over the samples.
        peak_b: Of B, in the same way.
        deviation: B - A over the common time [N]; None without common time.
    """

    name: str
    name_b: str
    peak_a: Peak
    peak_b: Peak
    deviation: Deviation | None


@dataclass(frozen=True)
class MotionComparison:
    """A body that both recordings have.

    Attributes:
        name: Of the load, or of the body, in A.
        name_b: The same in B.
        body: Its body in A.
        body_b: Its body in B.
        position: Distance of the centres of gravity [m]; None without common time.
        attitude: Angle by which the attitudes differ [rad]; None without common time.
    """

    name: str
    name_b: str
    body: str
    body_b: str
    position: Deviation | None
    attitude: Deviation | None


@dataclass(frozen=True, eq=False)
class Comparison:
    """Two recordings and how they differ; differences are B - A.

    Attributes:
        a: The first recording.
        b: The second recording.
        names: What A and B are called.
        common: The times at which series are compared; None if there are none.
        metrics: Every metric that one of them has, by the names of `gantline.results.metrics`.
        counters: Steps, rejected attempts and what else the integrator counted.
        ropes: Ropes that both have.
        hooks: Hook load of the hooks that both have; none where a run failed before its first sample.
        hinges: Force between load and hinge of the hinges that both have, in the same way.
        loads: Motion of the loads that both have.
        bodies: Motion of all bodies that both have, loads among them.
        only_a: Names that only A has, by kind: `sling`, `equalizer`, `hook`, `hinge`, `load`, `rope` (neither
            sling nor equalizing rope), and, where neither has loads, `body`. Kinds without any are absent.
        only_b: The same for B.
        stability: How sound the runs of A and B were.
        parted: Ropes of A and of B that were cut, broke or were taken off.
    """

    a: Recording
    b: Recording
    names: tuple[str, str]
    common: CommonTime | None
    metrics: Mapping[str, Difference]
    counters: Mapping[str, Difference]
    ropes: Sequence[ForceComparison]
    hooks: Sequence[ForceComparison]
    hinges: Sequence[ForceComparison]
    loads: Sequence[MotionComparison]
    bodies: Sequence[MotionComparison]
    only_a: Mapping[str, Sequence[str]]
    only_b: Mapping[str, Sequence[str]]
    stability: tuple[Stability, Stability]
    parted: tuple[Sequence[Parting], Sequence[Parting]]

    def __repr__(self) -> str:
        a, b = self.names
        both = f"{len(self.metrics)} metrics, {len(self.ropes)} ropes, {len(self.hooks)} hooks"
        return f"<Comparison of {a!r} with {b!r}: {both}, {len(self.bodies)} bodies>"

    def to_json(self) -> dict[str, Any]:
        """All numbers as a JSON object, SI units, under the names of the attributes; null for none."""
        times = self.common.times if self.common else None
        document = {
            "names": list(self.names),
            "methods": [method_of(self.a), method_of(self.b)],
            "common_time": None if times is None else [float(times[0]), float(times[-1])],
            "metrics": {name: _difference_json(value) for name, value in self.metrics.items()},
            "counters": {name: _difference_json(value) for name, value in self.counters.items()},
            **{
                kind: [dataclasses.asdict(one) for one in getattr(self, kind)]
                for kind in ("ropes", "hooks", "hinges", "loads", "bodies")
            },
            "only_a": {kind: list(names) for kind, names in self.only_a.items()},
            "only_b": {kind: list(names) for kind, names in self.only_b.items()},
            "stability": [dataclasses.asdict(side) for side in self.stability],
            "parted": [[dataclasses.asdict(one) for one in side] for side in self.parted],
        }
        return dict(without_gaps(document))


def compare(
    a: Recording | str | Path, b: Recording | str | Path, *, names: tuple[str, str] | None = None
) -> Comparison:
    """Compare two recordings: `compare(simulate("equalizer"), simulate("equalizer", integrator="del"))`.

    Args:
        a: A recording, or the file of one.
        b: The same.
        names: What they are called in tables and pictures; their titles and methods if not given.

    Returns:
        What both have in common, and how far they differ.

    Raises:
        FileNotFoundError: If there is no such file.
        TypeError: If `names` are not two texts.
        ValueError: If a file is not a recording of gantline, or a recording that a program has put together
            lacks what recordings of lifts have.
    """
    are_two = isinstance(names, tuple | list) and len(names) == 2
    if names is not None and not (are_two and all(isinstance(name, str) for name in names)):
        raise TypeError(f"names: {names!r} are not two texts, such as ('before', 'after')")
    a, b = (_whole(one, which) for one, which in ((a, "A"), (b, "B")))
    common = _common_time(a, b)
    rig_a, rig_b = a.rig, b.rig
    loads = _pairs((load.name for load in rig_a.loads), (load.name for load in rig_b.loads), lone=True)
    bodies_a, bodies_b = ({load.name: load.body for load in rig.loads} for rig in (rig_a, rig_b))
    sampled = bool(len(a.time) and len(b.time))
    only_a, only_b = _only(a, b)
    differ = tolerances_of(a) != tolerances_of(b)
    return Comparison(
        a=a,
        b=b,
        names=names or (_name(a, differ), _name(b, differ)),
        common=common,
        metrics=_differences(a.metrics(), b.metrics()),
        counters=_differences(a.attributes.get("counters") or {}, b.attributes.get("counters") or {}),
        ropes=[_rope(a, b, common, pair) for pair in _rope_pairs(a, b)],
        hooks=_forces(a, b, common, "hook", "hook_load") if sampled else [],
        hinges=_forces(a, b, common, "hinge", "hinge_force") if sampled else [],
        loads=[_motion(a, b, common, pair, (bodies_a[pair[0]], bodies_b[pair[1]])) for pair in loads],
        bodies=[_motion(a, b, common, pair, pair) for pair in _paired_labels(a, b, "body")],
        only_a=only_a,
        only_b=only_b,
        stability=(stability_of(a), stability_of(b)),
        parted=(partings(a), partings(b)),
    )


def _whole(given: Recording | str | Path, which: str) -> Recording:
    """A recording that has what is compared; one of a file has been held against that as it was read."""
    if isinstance(given, str | Path):
        return open_recording(given)
    try:
        hold_recording(recorded(given))
    except FormError as problem:
        right = "CommonTime of gantline.results.common_time compares series of any program"
        raise ValueError(f"{which} is no whole recording of a lift: {problem}; {right}") from None
    return given


def _common_time(a: Recording, b: Recording) -> CommonTime | None:
    """The times at which two recordings are compared; of one at rest its moment alone, which is its last."""
    moments = {float(one.time[-1]) for one in (a, b) if one.is_equilibrium and len(one.time)}
    if not moments:
        return CommonTime.of(a.time, b.time)
    moment = moments.pop()
    is_in_both = all(len(one.time) and one.time[0] <= moment <= one.time[-1] for one in (a, b))
    return CommonTime(np.array([moment]), a.time, b.time) if is_in_both and not moments else None


def tolerances_of(recording: Recording) -> tuple[float | None, float | None]:
    """What the error of a step might be, of tensions [N] and positions [m]; None where nothing says."""
    settings = recording.attributes["settings"]["integrator"]
    return settings.get("tension_tolerance"), settings.get("position_tolerance")


def method_of(recording: Recording, *, with_tolerances: bool = True) -> str:
    """The integrator of a recording with what it went by: `del, step 1 ms`; tolerances too, or not."""
    settings = dict(recording.attributes["settings"]["integrator"])
    if not with_tolerances:
        settings |= {"tension_tolerance": None, "position_tolerance": None}
    words = [str(settings["type"])]
    if settings.get("step"):
        words.append(f"step {_short(settings['step'], 'ms')}")
    if settings.get("tension_tolerance"):
        words.append(f"tension tolerance {_short(settings['tension_tolerance'], 'N')}")
    if settings.get("position_tolerance"):
        words.append(f"position tolerance {_short(settings['position_tolerance'], 'mm')}")
    if settings.get("paper"):
        words.append("as in the paper")
    elif settings.get("geometric_stiffness") is False:
        words.append("without geometric stiffness")
    return ", ".join(words)


def _name(recording: Recording, with_tolerances: bool) -> str:
    return f"{recording.title} ({method_of(recording, with_tolerances=with_tolerances)})"


def peak_sling(recording: Recording) -> str | None:
    """Name of the sling with the largest tension over all steps; None without slings or samples."""
    slings = recording.rig.slings
    if not slings or not len(recording.time):
        return None
    most = first_largest(slings, lambda sling: series.rope_peak(recording, sling.rope)[0], "kN")
    return None if most is None else most.name


def _short(value: float, unit: str) -> str:
    """A quantity without the zeros that no one wrote."""
    number, _, name = format_quantity(value, unit, 9).partition(" ")
    return f"{float(number):g} {name}"


def _difference_json(value: Difference) -> dict[str, float | None]:
    return {"a": value.a, "b": value.b, "difference": value.absolute, "relative": value.relative}


def _differences(a: Mapping[str, float], b: Mapping[str, float]) -> dict[str, Difference]:
    return {name: Difference(a.get(name), b.get(name)) for name in (*a, *(n for n in b if n not in a))}


def _pairs(a: Iterable[str], b: Iterable[str], *, lone: bool = False) -> list[tuple[str, str]]:
    """Names that belong together, in the order of A; with `lone` also the one that each has left over."""
    left_b = list(b)
    pairs, left_a = [], []
    for name in a:
        if name in left_b:
            left_b.remove(name)
            pairs.append((name, name))
        else:
            left_a.append(name)
    if lone and len(left_a) == len(left_b) == 1:
        pairs.append((left_a[0], left_b[0]))
    return pairs


def _paired_labels(a: Recording, b: Recording, dim: str, *, lone: bool = False) -> list[tuple[str, str]]:
    return _pairs(a.coordinates.get(dim, ()), b.coordinates.get(dim, ()), lone=lone)


def _rope_pairs(a: Recording, b: Recording) -> list[tuple[str, str]]:
    """Ropes by name; the equalizing rope also where its only equalizer has another name."""
    pairs = _paired_labels(a, b, "rope")
    known_a, known_b = ({pair[side] for pair in pairs} for side in (0, 1))
    ropes_a, ropes_b = (
        {
            e.name: e.equalizing_rope
            for e in one.rig.equalizers
            if e.equalizing_rope in one.coordinates.get("rope", ())
        }
        for one in (a, b)
    )
    for name_a, name_b in _pairs(ropes_a, ropes_b, lone=True):
        pair = ropes_a[name_a], ropes_b[name_b]
        if pair[0] not in known_a and pair[1] not in known_b:
            pairs.append(pair)
    return pairs


def _rope(a: Recording, b: Recording, common: CommonTime | None, pair: tuple[str, str]) -> ForceComparison:
    return ForceComparison(
        *pair,
        Peak(*series.rope_peak(a, pair[0])),
        Peak(*series.rope_peak(b, pair[1])),
        _force_deviation(a, b, common, "rope_tension", pair),
    )


def _forces(
    a: Recording, b: Recording, common: CommonTime | None, dim: str, variable: str
) -> list[ForceComparison]:
    """A force of each hook or hinge that both have; of hinges samples alone are known."""
    return [
        ForceComparison(
            *pair,
            _peak(a, variable, pair[0]),
            _peak(b, variable, pair[1]),
            _force_deviation(a, b, common, variable, pair),
        )
        for pair in _paired_labels(a, b, dim, lone=True)
    ]


def _peak(recording: Recording, variable: str, name: str) -> Peak:
    if variable == "hook_load":
        return Peak(*hook_peak(recording, name, variable))
    if variable == "hinge_force":
        (hinge,) = (one for one in recording.rig.hinges if one.name == name)
        return Peak(*hinge_peak(recording, hinge, hinge_force))
    force = recording.column(variable, name)
    at = first_peak(force)
    return Peak(float(force[at]), float(recording.time[at]))


def _force_deviation(
    a: Recording, b: Recording, common: CommonTime | None, variable: str, pair: tuple[str, str]
) -> Deviation | None:
    if common is None:
        return None
    difference = common.difference(a.column(variable, pair[0]), b.column(variable, pair[1]))
    return common.deviation("N", difference)


def _motion(
    a: Recording, b: Recording, common: CommonTime | None, names: tuple[str, str], bodies: tuple[str, str]
) -> MotionComparison:
    if common is None:
        return MotionComparison(*names, *bodies, None, None)
    place, attitude = (
        (a.column(variable, bodies[0]), b.column(variable, bodies[1]))
        for variable in ("body_position", "body_orientation")
    )
    return MotionComparison(
        *names,
        *bodies,
        common.deviation("m", common.distance(*place)),
        common.deviation("rad", common.turn(*attitude)),
    )


def _only(a: Recording, b: Recording) -> tuple[dict[str, list[str]], dict[str, list[str]]]:
    named_a, named_b = _named(a.rig, a), _named(b.rig, b)
    # Of a lift in yard words bodies say nothing that loads and gear do not; without a sample there are none.
    if a.rig.loads or b.rig.loads or not (len(a.time) and len(b.time)):
        del named_a["body"], named_b["body"]
    only_a: dict[str, list[str]] = {}
    only_b: dict[str, list[str]] = {}
    for kind in named_a:
        lone = kind in ("equalizer", "hook", "hinge", "load")
        pairs = _pairs(named_a[kind], named_b[kind], lone=lone)
        for side, named, only in ((0, named_a, only_a), (1, named_b, only_b)):
            both = {pair[side] for pair in pairs}
            left = [name for name in named[kind] if name not in both]
            if left:
                only[kind] = left
    return only_a, only_b


def _named(rig: Rig, recording: Recording) -> dict[str, list[str]]:
    """Names by kind. An equalizing rope goes with its equalizer."""
    known = {sling.rope for sling in rig.slings} | {e.equalizing_rope for e in rig.equalizers}
    ropes = [rope.name for rope in rig.ropes] or recording.coordinates.get("rope", ())
    return {
        "sling": [sling.name for sling in rig.slings],
        "equalizer": [e.name for e in rig.equalizers],
        "hook": [hook.name for hook in rig.hooks],
        "hinge": [hinge.name for hinge in rig.hinges],
        "load": [load.name for load in rig.loads],
        "rope": [rope for rope in ropes if rope not in known],
        "body": list(recording.coordinates.get("body", ())),
    }
