"""Slings: skew, dynamics, angles, and how they bend about their shackles."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Sequence

import numpy as np

from gantline.checks.check import Check, Verdict
from gantline.checks.force import NO_STATIC, SKEW, hung_otherwise_sentence, kilonewton
from gantline.checks.lugs import ropes_that_bear
from gantline.checks.measure import Caution, Finding, Found, Missing, carrying, extreme, named
from gantline.results import series
from gantline.results.gear import Sling
from gantline.results.loads.hung_so import hung_otherwise, tells_dynamics
from gantline.results.loads.skew import Skew, skew_loads
from gantline.results.recording import Recording
from gantline.results.ropes.parting import DETACHED, partings
from gantline.results.variable import BoolArray
from gantline.rule_data import FOUR_SLINGS
from gantline.units import format_quantity

#: Share of the largest peak of all slings below which one never carried.
_NOTHING = 0.01
_BARE = "no shackle there, and about what the eye bends is not known ('bends_about' of the sling)"
_CALCULATE = (
    "calculate it, as 'gantline cases' does of 'slings.tolerance', and write 'skew_load_factor' under 'rules'"
)


def idle(recording: Recording) -> list[Check]:
    """A warning where slings carried nothing in a lift whose load came clear: the others had their share.

    A load that is turned, or goes from crane to crane, leaves slings slack at times; never taut is a length,
    or a lug, that is not as it was meant. So is one that is slack while the load hangs clear and others at
    the same hook or bar carry it, though it carried a little for a moment as the load came off.
    """
    clear = series.is_clear(recording)
    counts = clear & series.last_sample(recording) if recording.is_equilibrium else clear
    if not counts.any():
        return []
    slings = [one for one in recording.rig.slings if series.is_on(recording, one.rope).any()]
    peaks = {one.name: series.rope_peak(recording, one.rope)[0] for one in slings}
    nothing = _NOTHING * max(peaks.values(), default=0.0)
    never = [] if recording.is_equilibrium else [name for name, peak in peaks.items() if peak < nothing]
    means = {one.name: _mean_when_clear(recording, one, counts) for one in slings}
    bear = {one.from_body for one in slings if (means[one.name] or 0.0) >= nothing}
    idly = [
        one.name
        for one in slings
        if one.from_body in bear and one.name not in never and _is_below(means[one.name], nothing)
    ]
    remarks = [f"slack over the whole lift: {named(never)}"] if never else []
    if idly:
        remarks.append(f"slack while the load hangs clear, beside others that carry it: {named(idly)}")
    if not remarks:
        return []
    remark = "; ".join(remarks)
    return [Check("slings_carry", Verdict.WARNING, "every sling carries at some time", remark=remark)]


def _mean_when_clear(recording: Recording, sling: Sling, counts: BoolArray) -> float | None:
    """Mean tension of a sling over those of some samples at which it is whole [N]; None where it never is."""
    on = counts & series.are_whole(recording, [sling.rope])[0]
    return float(series.sling_tension(recording, sling)[on].mean()) if on.any() else None


def _is_below(mean: float | None, bound: float) -> bool:
    return mean is not None and mean < bound


def taken_off(recording: Recording) -> list[Check]:
    """A check for each rope that a step takes off: nobody gets a shackle out of one that carries.

    It has failed where more is left than a hundredth of the largest tension up to then, beyond what hangs of
    the rope itself at its upper end. The simulation goes on without the rope all the same. What is left of a
    tension is no share of a limit that a lift comes near. Whether those carried that an equilibrium no longer
    has, it does not know.
    """
    checks = []
    for one in partings(recording):
        if one.kind != DETACHED:
            continue
        before = recording.column("rope_tension", one.rope)[recording.time <= one.time]
        hanging = _own_weight(recording, one.rope)
        failed = one.tension > hanging + _NOTHING * float(before.max(initial=0.0))
        carried = f"it carried {format_quantity(one.tension, 'kN', 1)}"
        weighs = f" and weighs {format_quantity(hanging, 'kN', 1)}" if hanging else ""
        right = "let its hook down until it is slack, and some decimetres more"
        check = Check(
            "detached_slack",
            Verdict.FAILED if failed else Verdict.OK,
            "a sling that is taken off is slack: 1 % of its largest tension may be left"
            + (", beside its own weight" if hanging else ""),
            element=one.rope,
            time=one.time,
            remark=f"{carried}{weighs}; {right}" if failed else f"{carried}{weighs}",
        )
        checks.append(check)
    return checks


def _own_weight(recording: Recording, rope: str) -> float:
    """What a slack rope with nodes may have of itself at its upper end [N]; lumped weight is no tension."""
    known = recording.rig.rope(rope)
    if known is None or not known.nodes:
        return 0.0
    return known.mass * recording.rig.gravity


def no_slings(recording: Recording) -> Iterator[Missing]:
    """Ropes of `mechanics` that carry a load, which limits of slings do not know of."""
    for load in recording.rig.loads:
        yield from ropes_that_bear(recording, load, "is no sling")


def sling_tension(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Tension as simulated."""
    for sling in recording.rig.slings:
        on = during & series.is_on(recording, sling.rope)
        yield from extreme(recording, series.sling_tension(recording, sling), on, sling.name)


def smallest_tension(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Smallest tension."""
    for sling in recording.rig.slings:
        tension = series.sling_tension(recording, sling)
        on = during & series.is_on(recording, sling.rope)
        yield from extreme(recording, tension, on, sling.name, smallest=True)
    yield from no_slings(recording)


def skew_load_factor(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Static force of a sling over its force with perfect lengths."""
    skews = skew_loads(recording)
    if not skews:
        yield from (Missing(sling.name, NO_STATIC) for sling in recording.rig.slings)
    for skew in skews:
        if skew.factor is None or skew.perfect is None:
            yield Missing(skew.sling, skew.reason)
        else:
            text = f"static {kilonewton(skew.force)} / {kilonewton(skew.perfect)} with perfect lengths"
            yield Found(skew.factor, skew.sling, formula=text)
    yield from _of_more_than_four(recording, skews)


def _of_more_than_four(recording: Recording, skews: Sequence[Skew]) -> Iterator[Caution]:
    """A factor that a rule has for four slings, where more below one hook or spreader share by lengths."""
    rule = recording.rig.factors.get(SKEW)
    if rule is None or FOUR_SLINGS not in rule.source:
        return
    decide = {skew.sling for skew in skews if skew.lengths_decide}
    above = Counter(one.from_body for one in recording.rig.slings if one.name in decide and one.over is None)
    for body, count in above.items():
        if count > 4:
            share = f"{count} share by their lengths below {body}"
            yield Caution(f"the rule has {rule.value:g} for {FOUR_SLINGS}, and {share}: {_CALCULATE}")


def sling_dynamic_factor(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Peak over static tension of the same sling, both as simulated."""
    for sling in recording.rig.slings:
        static, _ = series.greatest_static(recording, series.sling_tension(recording, sling))
        highest, time = series.rope_peak(recording, sling.rope)
        if recording.is_equilibrium:
            yield Missing(sling.name, "an equilibrium has no peak")
        elif not static:
            yield Missing(sling.name, NO_STATIC if static is None else "carries nothing at rest")
        elif not tells_dynamics(static, highest):
            yield Missing(sling.name, "all but slack at rest, with less than 5 % of its peak")
        elif otherwise := hung_otherwise(recording, time, of_slings=True):
            yield Missing(sling.name, hung_otherwise_sentence(otherwise))
        else:
            text = f"peak {kilonewton(highest)} / static {kilonewton(static)}"
            yield Found(highest / static, sling.name, time, text)


def angle_from_vertical(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Angle of a carrying sling from the vertical."""
    for sling in recording.rig.slings:
        angle = series.sling_angle(recording, sling)
        yield from extreme(recording, angle, carrying(recording, sling.rope, during), sling.name)
    yield from no_slings(recording)


def angle_from_horizontal(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Angle of a carrying sling from the horizontal."""
    for sling in recording.rig.slings:
        angle = series.sling_angle(recording, sling)

        def text(at: int, angle: np.ndarray = angle) -> str:
            return f"90 deg - {format_quantity(float(angle[at]), 'deg', 1)} from the vertical"

        inside = carrying(recording, sling.rope, during)
        yield from extreme(recording, math.pi / 2 - angle, inside, sling.name, text, smallest=True)
    yield from no_slings(recording)


def bending_factor(ratio: float) -> float | None:
    """What bending about a diameter of `ratio` rope diameters takes of a rope's strength.

    It is a factor on the force, 1/(1 - 0.5/sqrt(D/d)): 0027/ND rev 11, 7.8.1, after IMCA M 179.

    Returns:
        The factor [1]; None where nothing is left (D/d up to 0.25).
    """
    left = 1.0 - 0.5 / math.sqrt(ratio)
    return 1.0 / left if left > 0.0 else None


def bending_text(diameter: float, rope: float) -> str:
    """D/d and its bending factor in words."""
    ratio = diameter / rope
    factor = bending_factor(ratio)
    said = "no strength left" if factor is None else f"bending factor {factor:.3f}"
    return f"{format_quantity(diameter, 'mm', 0)} / {format_quantity(rope, 'mm', 0)}, {said}"


def sling_bend(sling: Sling) -> tuple[float, str] | str:
    """Smallest diameter about which the eyes of a sling bend [m] and its place; or why it is not known."""
    bows = {end: shackle.bow_diameter for end, shackle in sling.shackles.items()}
    known = {end: diameter for end, diameter in {**sling.bends_about, **bows}.items() if diameter is not None}
    if sling.over is not None:
        return "bends about an extension sheave, whose diameter counts in pictures only"
    if None in bows.values():
        return "bow diameter not known"
    if not known:
        return "no shackles given, nor 'bends_about'"
    end = min(known, key=lambda one: known[one])
    return known[end], f"{sling.name} {end}"


def bare_ends(sling: Sling) -> Iterator[Missing]:
    """Ends of a sling of which nothing tells about what their eyes bend, beside one that is known.

    An eye on a pin, a trunnion or a hook may bend more sharply than what is at the other end.
    """
    known = {*sling.shackles, *sling.bends_about}
    if known and sling.over is None:
        for end in ("top", "bottom"):
            if end not in known:
                yield Missing(f"{sling.name} {end}", _BARE)


def sling_bending_ratio(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Diameter of a shackle's bow, or of what else an eye lies on, over that of the sling."""
    for sling in recording.rig.slings:
        rope = recording.rig.rope(sling.rope)
        bend = sling_bend(sling)
        if isinstance(bend, str):
            yield Missing(sling.name, bend)
        elif rope is None or not rope.diameter:
            yield Missing(sling.name, "diameter not known")
        else:
            yield Found(bend[0] / rope.diameter, bend[1], formula=bending_text(bend[0], rope.diameter))
            yield from bare_ends(sling)
