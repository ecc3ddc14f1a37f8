"""Shackles: static load over working load limit, dynamic load over strength, both with side load.

The shackle at the upper end bears the weight of its sling too: the tension of a lumped rope has half of it.
The shackle at a lug lies in the plane of its main plate, so its side load angle is the out-of-plane angle of
the sling. One at the upper end, or below an extension sheave, hangs free and turns into the pull. A sling
over an extension sheave has one at each lower end: what counts is the larger angle.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cache

import numpy as np

from gantline.checks.design_weight import design_ratio
from gantline.checks.force import DYNAMIC, NO_DYNAMIC, NO_STATIC, OWN_WEIGHT, Force, kilonewton, to_design
from gantline.checks.forces import at_upper_end, factor, sling_forces
from gantline.checks.measure import Caution, Finding, Found, Missing, Refused
from gantline.results import series
from gantline.results.gear import Sling
from gantline.results.loads.hung_so import most_on_the_way, never_hung_so, on_the_way
from gantline.results.recording import Recording
from gantline.results.ropes.upper_end import own_weight
from gantline.results.strength import Shackle, SideLoad
from gantline.results.variable import BoolArray, FloatArray
from gantline.units import format_quantity

_BREAKING = "shackle_breaking_factor"
#: Angles that differ by less are one, so that a row of the chart ends where it says [rad].
_SAME_ANGLE = 1e-9


def remaining(chart: SideLoad, angle: float) -> float | None:
    """What a side load angle [rad] leaves of a working load limit [1]; None beyond the chart."""
    return next((row[1] for row in chart.rows if angle <= row[0] + _SAME_ANGLE), None)


def static_load(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Static load of a shackle over its working load limit, reduced for side load."""
    for sling, end, shackle, holds in _shackles(recording, during):
        element = f"{sling.name} {end}"
        limit = shackle.working_load_limit
        if not limit:
            yield Missing(element, "working load limit not known")
        elif holds[0].force.static is None:
            yield Missing(element, NO_STATIC)
        else:
            yield max((_of_limit(recording, element, limit, hold) for hold in holds), key=_share)
            if holds[0].force.static_caution:
                yield Caution(holds[0].force.static_caution)


def _of_limit(recording: Recording, element: str, limit: float, hold: _Hold) -> Found | Refused:
    """Static load of a hold [N] over what side load leaves of a working load limit [N]."""
    assert hold.force.static is not None  # asked of loads that hung still
    left = remaining(recording.rig.shackle_side_load, hold.angle)
    if left is None:
        return _beyond(element, hold.angle)
    text = f"{hold.force.static_text} / ({_limit(limit, left, hold.angle)})"
    factors = tuple(name for name in hold.force.factors if name != DYNAMIC)
    return Found(hold.force.static / (limit * left), element, formula=text, factors=factors)


def _share(finding: Found | Refused) -> float:
    """The share of a strength that is used [1]; what a chart does not know comes first."""
    return finding.value if isinstance(finding, Found) else np.inf


def dynamic_load(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Dynamic load of a shackle over the least of its strengths.

    These are working load limit times the rule's dynamic amplification factor (reduced for side load),
    minimum breaking force over the rule's factor on it, and proof load; 0027/ND rev 11, 8.2.6.
    """
    for sling, end, shackle, holds in _shackles(recording, during):
        element, force = f"{sling.name} {end}", holds[0].force
        if not shackle.working_load_limit:
            yield Missing(element, "working load limit not known")
        elif force.dynamic is None:
            yield Missing(element, NO_DYNAMIC)
        else:
            moments = _moments(recording, during, sling, end, holds)
            yield from _dynamic(recording, element, shackle, moments)
            if force.caution:
                yield Caution(force.caution)


def _at_end(recording: Recording, sling: Sling, end: str, force: Force, during: BoolArray) -> Force:
    """What the shackle at an end of a sling bears of its force."""
    return at_upper_end(recording, sling.rope, force, during) if end == "top" else force


@dataclass(frozen=True)
class _Hold:
    """How a shackle is pulled while the loads hang still.

    Attributes:
        force: What it bears.
        angle: Side load angle [rad].
    """

    force: Force
    angle: float


@dataclass(frozen=True)
class _Moment:
    """A load of a shackle.

    Attributes:
        load: [N].
        time: When it acts [s]; None by the rule.
        angle: Side load angle [rad].
        force: The force that it is of.
        ratio: By what it is raised to the design weight [1].
    """

    load: float
    time: float | None
    angle: float
    force: Force
    ratio: float = 1.0


def _moments(
    recording: Recording, during: BoolArray, sling: Sling, end: str, holds: Sequence[_Hold]
) -> list[_Moment]:
    """By the rule with angles at rest; the peak; and the sample at which side load leaves least.

    Without a rule the static force takes its place: that of the design weight may be more than the peak.
    """
    chart = recording.rig.shackle_side_load
    moments: list[_Moment] = []
    for hold in holds:
        of = hold.force
        still = of.rule if of.rule is not None else of.static if of.counts_static else None
        if still is not None:
            moments.append(_Moment(still, None, hold.angle, of))
    force = holds[0].force
    if force.peak is not None and force.time is not None:
        angles = _angles(recording, sling, end)
        tension = series.sling_tension(recording, sling)
        if end == "top":
            tension = tension + own_weight(recording, sling.rope)
        ratios = np.ones(len(tension))
        if force.static is not None and not force.is_heavier:
            ratio = design_ratio(recording, sling.to_load, force.window)
            ratios = np.where(never_hung_so(recording), ratio, 1.0)
        worst = _worst(chart, ratios * tension, angles, during)
        near = int(np.argmin(np.abs(recording.time - force.time)))
        highest = force.peak * force.peak_ratio
        moments.append(_Moment(highest, force.time, float(angles[near]), force, force.peak_ratio))
        time, ratio = float(recording.time[worst]), float(ratios[worst])
        moments.append(_Moment(float(tension[worst]) * ratio, time, float(angles[worst]), force, ratio))
    return moments


def _dynamic(
    recording: Recording, element: str, shackle: Shackle, moments: Sequence[_Moment]
) -> Iterator[Finding]:
    found: list[Found] = []
    for one in moments:
        left = remaining(recording.rig.shackle_side_load, one.angle)
        if left is None:
            yield _beyond(element, one.angle)
            return
        strength, text = _strength(recording, shackle, left, one.angle)
        own = f" with {OWN_WEIGHT}" if one.force.own_weight > 0.0 else ""
        peak = f"peak {kilonewton(one.load / one.ratio)}{own}{to_design(one.ratio)}"
        said, other = peak, one.force.rule_text
        if one.time is None:
            said = one.force.rule_text or one.force.static_text
            other = "" if one.force.peak is None else f"peak {kilonewton(one.force.peak)}{own}"
        formula = f"{said} / {text}{f'; {other}' if other else ''}"
        factors = (*one.force.factors, *([_BREAKING] if "MBF" in text else []))
        more = one.force.peak_at_design if one.time == one.force.time else 0.0
        at_design = more / strength if more > one.load else None
        found.append(Found(one.load / strength, element, one.time, formula, factors, at_design=at_design))
    most = max((one.at_design for one in found if one.at_design is not None), default=0.0)
    worst = max(found, key=_share)
    yield replace(worst, at_design=most if most > worst.value else None)
    if factor(recording, _BREAKING) is not None and not shackle.minimum_breaking_force:
        yield Caution(f"minimum breaking force of {shackle.name} not known, which the rule asks for")


def _strength(recording: Recording, shackle: Shackle, left: float, angle: float) -> tuple[float, str]:
    """The least strength of a shackle against dynamic loads [N], and how it comes about."""
    dynamic = factor(recording, DYNAMIC) or 1.0
    limit = shackle.working_load_limit or 0.0
    by_limit = _limit(limit, left, angle) + (f" x {dynamic:.4g}" if dynamic > 1.0 else "")
    strengths = [(limit * left * dynamic, by_limit)]
    breaking = factor(recording, _BREAKING)
    if shackle.minimum_breaking_force and breaking is not None:
        text = f"MBF {kilonewton(shackle.minimum_breaking_force)} / {breaking:.4g}"
        strengths.append((shackle.minimum_breaking_force / breaking, text))
    if shackle.proof_load:
        strengths.append((shackle.proof_load, f"proof load {kilonewton(shackle.proof_load)}"))
    least = min(strength for strength, _ in strengths)
    texts = [text for _, text in strengths]
    return least, f"({texts[0]})" if len(texts) == 1 else f"min({', '.join(texts)})"


def _limit(limit: float, left: float, angle: float) -> str:
    aside = f" x {left:.4g} at {format_quantity(angle, 'deg', 1)} aside" if left < 1.0 else ""
    return f"WLL {kilonewton(limit)}{aside}"


def _beyond(element: str, angle: float) -> Refused:
    """The chart says nothing of so large an angle."""
    return Refused(
        element, f"pulled {format_quantity(angle, 'deg', 1)} aside, beyond the chart of side loads"
    )


def _worst(chart: SideLoad, tension: FloatArray, angles: FloatArray, during: BoolArray) -> int:
    """Sample at which tension over what side load leaves is largest."""
    return int(np.argmax(np.where(during, _for_plumb(chart, tension, angles), -np.inf)))


def _for_plumb(chart: SideLoad, tension: FloatArray, angles: FloatArray) -> FloatArray:
    """Tension without side load that would use as much of a shackle [N]."""
    bounds = np.array([row[0] + _SAME_ANGLE for row in chart.rows])
    left = np.array([*(row[1] for row in chart.rows), 1e-12])
    as_plumb: FloatArray = tension / left[np.searchsorted(bounds, angles)]
    return as_plumb


def _angles(recording: Recording, sling: Sling, end: str) -> FloatArray:
    """Side load angle while the sling carries [rad], else 0, shape (time,)."""
    by_lug = series.out_of_plane_angles(recording, sling)
    own = {(of, lug) for of, lug in zip(sling.lugs_of, sling.lugs, strict=True)}
    if end == "top":
        own = {(sling.from_body, sling.from_lug)}
    aside = [angles for lug, angles in by_lug.items() if lug in own]
    still = np.zeros(len(recording.time))
    if not aside:
        return still
    is_carrying = series.is_carrying(series.sling_tension(recording, sling))
    return np.where(is_carrying, np.max(aside, axis=0), still)


def _static_angle(recording: Recording, window: BoolArray | None, sling: Sling, end: str) -> float:
    return series.static_value(recording, _angles(recording, sling, end), window) or 0.0


def _shackles(recording: Recording, during: BoolArray) -> Iterator[tuple[Sling, str, Shackle, list[_Hold]]]:
    """Shackles, with how each is pulled where its sling bears most at rest, then where side load leaves less.

    A load that is turned may pull a shackle with less force farther aside at another of its hold points, or
    between two of them.
    """
    most = sling_forces(recording, during)
    windows = series.quiet_windows(recording)
    of_window = cache(lambda at: sling_forces(recording, during, windows[at]))
    chart = recording.rig.shackle_side_load
    for sling in recording.rig.slings:
        for end, shackle in sling.shackles.items():
            angle = _static_angle(recording, most[sling.name].window, sling, end)
            holds = [_Hold(_at_end(recording, sling, end, most[sling.name], during), angle)]
            for at, window in enumerate(windows):
                aside = _static_angle(recording, window, sling, end)
                if aside > angle and remaining(chart, aside) != remaining(chart, angle):
                    force = _at_end(recording, sling, end, of_window(at)[sling.name], during)
                    holds.append(_Hold(force, aside))
            as_plumb = _for_plumb(
                chart, series.sling_tension(recording, sling), _angles(recording, sling, end)
            )
            way = most_on_the_way(recording, as_plumb, on_the_way(recording))
            if way is not None and (aside := _static_angle(recording, way, sling, end)) > angle:
                force = sling_forces(recording, during, way)[sling.name]
                holds.append(_Hold(_at_end(recording, sling, end, force, during), aside))
            yield sling, end, shackle, holds
