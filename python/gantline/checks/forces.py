"""Static and dynamic forces as rules want them.

*Static* is the mean over the quiet window, or over an earlier time that the loads hung still, or between two
of these, if the element carried more then; it is raised from the simulated weight to the design weight.
*By the rule* is static times the rule's dynamic amplification factor. A simulated peak already holds the
dynamics: it is never multiplied by that factor, both are shown, and the larger one is checked. Where the
rules have no factor the static force itself takes its place: a peak is that of the simulated weight, which
the design weight may pass standing still. So it is with skew: the rule's factor is on the force with perfect
lengths, never on one that holds its own skew.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType

import numpy as np

from gantline.checks.below_hooks import to_design_weight
from gantline.checks.design_weight import design_ratio
from gantline.checks.force import DYNAMIC, OWN_WEIGHT, SKEW, Force, OnTheWay, kilonewton, to_design
from gantline.checks.measure import Found, crest, extreme
from gantline.results import series
from gantline.results.alike import earliest_peak
from gantline.results.gear import Sling
from gantline.results.loads.hook_peaks import hook_peak
from gantline.results.loads.hung_so import has_hung_as_heavy, how_on_the_way, never_hung_so, window_of_most
from gantline.results.loads.skew import skew_loads
from gantline.results.recording import Recording
from gantline.results.ropes.pinned import pinned_as_at
from gantline.results.ropes.upper_end import own_weight, peak_at_upper_end
from gantline.results.variable import BoolArray, FloatArray


def factor(recording: Recording, name: str) -> float | None:
    """A factor of the rule [1]; None if the rule has none."""
    found = recording.rig.factors.get(name)
    return None if found is None else found.value


def sling_forces(
    recording: Recording, during: BoolArray, window: BoolArray | None = None
) -> Mapping[str, Force]:
    """Static and dynamic force of every sling, by name.

    Where lengths decide how slings share, static is the larger of the simulated force and that with perfect
    lengths times the rule's skew load factor (of the simulated one where that with perfect lengths is not
    known).

    Args:
        recording: The recording.
        during: Samples whose peak counts.
        window: Time that the loads hung still, of which static is asked; for each sling that with the most
            if not given.
    """
    asked = during.tobytes(), None if window is None else window.tobytes()
    return recording.kept(("sling_forces", *asked), lambda: _sling_forces(recording, during, window))


def _sling_forces(recording: Recording, during: BoolArray, window: BoolArray | None) -> Mapping[str, Force]:
    by_length = {one.sling: one for one in skew_loads(recording, window) if one.lengths_decide}
    rule = factor(recording, SKEW)
    forces = {}
    for sling in recording.rig.slings:
        force = _force(recording, series.sling_tension(recording, sling), sling.to_load, window)
        skew = by_length.get(sling.name)
        if window is None and rule is not None and how_on_the_way(recording, force.window):
            there = skew_loads(recording, force.window)
            skew = next((one for one in there if one.sling == sling.name and one.lengths_decide), None)
        if skew is not None and rule is not None:
            perfect = skew.force if skew.perfect is None else skew.perfect
            force = _with_skew(recording, force, perfect, sling.to_load, rule)
        force = _with_peak(recording, force, sling.rope, during)
        ratio = design_ratio(recording, sling.to_load, force.window)
        tension = series.tightest_tension(recording, sling.rope)
        forces[sling.name] = _with_raised_peak(recording, force, tension, during, ratio)
    return MappingProxyType(forces)


def force_together(
    recording: Recording,
    slings: Sequence[Sling],
    together: FloatArray,
    during: BoolArray,
    ropes: Sequence[str] = (),
) -> Force:
    """Static and dynamic force of slings and ropes that pull at one place, as they are at one time.

    Static is that of the time that the loads hung still at which it is largest. Factors and contingency raise
    the force of each; of their sum counts the share that they pull together, and no less than the force of
    one alone. A peak between samples counts where one alone had it.

    Args:
        recording: The recording.
        slings: The slings.
        together: What they pull together in their directions, shape (time,) [N].
        during: Samples whose peak counts.
        ropes: Ropes that are no slings, each as often as ends of it are there; one at least of them and of
            slings.
    """
    tensions = [series.sling_tension(recording, sling) for sling in slings]
    size = np.sum([*tensions, *(recording.column("rope_tension", rope) for rope in ropes)], axis=0)
    alone: list[Force] = []
    found: list[Force] = []
    windows: list[BoolArray | None] = [*series.quiet_windows(recording)]
    if how_on_the_way(recording, way := window_of_most(recording, together)):
        windows.append(way)
    for window in windows or [None]:
        forces = sling_forces(recording, during, window)
        alone = [forces[sling.name] for sling in slings]
        alone += [rope_force(recording, rope, during, window) for rope in ropes]
        sums = 0.0 if window is None else float(size[window].sum())
        share = 1.0 if window is None or sums <= 0.0 else float(together[window].sum()) / sums
        found += [_sum(alone, share), *(replace(one, peak=None, time=None) for one in alone)]
    force = max(found, key=lambda one: one.rule or one.static or 0.0)
    force = _with_peak_of(recording, force, together, during)
    loads = {sling.to_load for sling in slings} or {None}
    ratio = max(design_ratio(recording, load, force.window) for load in loads)
    # Peaks of each alone are the same whatever the window.
    highest = max([force, *alone], key=lambda one: one.raised_peak or 0.0)
    force = replace(
        force,
        peak=highest.peak,
        time=highest.time,
        peak_ratio=highest.peak_ratio,
        crest=crest(recording.time, together, during),
    )
    return _under_pins(recording, _with_raised_peak(recording, force, together, during, ratio))


def _sum(forces: Sequence[Force], share: float) -> Force:
    """What share of forces of one time pulls together, without peaks."""

    def total(values: Iterable[float | None]) -> float | None:
        known = [value for value in values if value is not None]
        return share * sum(known) if len(known) == len(forces) else None

    aslant = f" x {share:.4g} as vectors" if share < 0.99995 else ""
    return Force(
        static=total(one.static for one in forces),
        static_text=f"({' + '.join(one.static_text for one in forces)}){aslant}",
        rule=total(one.rule for one in forces),
        rule_text=f"({' + '.join(one.rule_text for one in forces)}){aslant}",
        factors=tuple(dict.fromkeys(name for one in forces for name in one.factors)),
        window=forces[0].window,
        lacks_static=any(one.lacks_static for one in forces),
    )


def rope_force(recording: Recording, rope: str, during: BoolArray, still: BoolArray | None = None) -> Force:
    """Static and dynamic force of a rope that is no sling; of the tightest segment over lossy sheaves.

    What a load weighs more in water than it leaves to be borne comes into hoist ropes as it comes into their
    hook, with hook block and falls beside it, and into none that hold vessels or keep a heading.

    Args:
        recording: The recording.
        rope: Its name.
        during: Samples whose peak counts.
        still: Time that the loads hung still, of which static is asked; that with the most if not given.
    """
    sheaves = [sheave for sheave in recording.rig.sheaves if sheave.rope == rope]
    segments = {segment for sheave in sheaves for segment in sheave.segments}
    columns = [recording.column("segment_tension", segment) for segment in sorted(segments)]
    columns = columns or [recording.column("rope_tension", rope)]
    hooks = [hook.name for hook in recording.rig.hooks if rope in {_rope_of(fall) for fall in hook.falls}]
    forces = []
    for column in columns:
        outer = rope in recording.rig.outer_ropes
        if still is not None:
            window = still
        elif outer:
            window = series.greatest_static(recording, column)[1]
        else:
            window = window_of_most(recording, column)
        ratio = design_ratio(recording, window=window)
        if hooks or outer:
            ratio = max(design_ratio(recording), _hoist_ratio(recording, hooks, window))
        forces.append(replace(_raised(recording, column, ratio, window), contingency=max(ratio, 1.0)))
    force = max(forces, key=lambda force: force.static or 0.0)
    return _with_peak(recording, force, rope, during)


def force_of_weight(recording: Recording, rope: str, during: BoolArray) -> Force | None:
    """Force of a rope at its upper end with the design weight, without factors of a rule on its lengths.

    None of mooring and tag lines, in which the weight of a load has no share that is known.
    """
    if rope in recording.rig.outer_ropes:
        return None
    sling = next((one for one in recording.rig.slings if one.rope == rope), None)
    if sling is None:
        force = rope_force(recording, rope, during)
    else:
        force = _force(recording, series.sling_tension(recording, sling), sling.to_load)
        ratio = design_ratio(recording, sling.to_load, force.window)
        tension = series.tightest_tension(recording, rope)
        force = _with_raised_peak(recording, force, tension, during, ratio)
    return at_upper_end(recording, rope, force, during)


def _rope_of(segment: str) -> str:
    return segment.rpartition("/")[0]


def _hoist_ratio(recording: Recording, hooks: Sequence[str], window: BoolArray) -> float:
    """Hoist load of a hook with the design weight over that as simulated, while it hangs still; 1 of none."""
    loads = [series.static_value(recording, recording.column("hoist_load", hook), window) for hook in hooks]
    return max(
        (
            1.0 + to_design_weight(recording, [hook], window) / load
            for hook, load in zip(hooks, loads, strict=True)
            if load
        ),
        default=1.0,
    )


def hook_force(
    recording: Recording,
    hooks: Iterable[str],
    variable: str,
    during: BoolArray,
    window: BoolArray | None = None,
) -> Force:
    """Static and dynamic hook load or hoist load of one or more hooks together.

    Only what hangs in the hook is raised by the rule's factor, not hook block and falls. Spreaders and
    compensators weigh what they weigh, and so does what is in tanks of a load that hangs in these hooks
    alone: the design weight is one of loads. How several hooks share a liquid is not known, and all of it is
    raised.

    Args:
        recording: The recording.
        hooks: Names of the hooks.
        variable: `hook_load` or `hoist_load`.
        during: Samples whose peak counts; that of one hook is over all steps where all of them do.
        window: Time that the loads hung still, of which static is asked; that with the most if not given.
    """
    names = list(hooks)
    hook_load = np.sum([recording.column("hook_load", name) for name in names], axis=0)
    total = np.sum([recording.column(variable, name) for name in names], axis=0)
    window = window_of_most(recording, total) if window is None else window
    static = series.static_value(recording, hook_load, window)
    falls = series.static_value(recording, total - hook_load, window) or 0.0
    more = to_design_weight(recording, names, window)
    force = replace(_hook_force(recording, static, more, falls, window), window=window)
    force = _with_peak_of(recording, force, total, during)
    if force.peak is not None and len(names) == 1:
        peak, time = hook_peak(recording, names[0], variable, during)
        force = replace(force, peak=peak, time=time)
    elif force.peak is not None:
        # When the ropes of all of them pulled most together no step has kept.
        force = replace(force, crest=crest(recording.time, total, during))
    if static is None or force.static is None or not static + falls:
        return force
    return _with_raised_peak(recording, force, total, during, force.static / (static + falls))


def sum_force(recording: Recording, values: FloatArray, load: str | None, during: BoolArray) -> Force:
    """Static and dynamic force of a series that goes with the weight of a load, shape (time,) [N]."""
    force = _with_peak_of(recording, _force(recording, values, load), values, during)
    force = replace(force, crest=crest(recording.time, values, during))
    ratio = design_ratio(recording, load, force.window)
    return _with_raised_peak(recording, force, values, during, ratio)


def _hook_force(
    recording: Recording, static: float | None, more: float, falls: float, window: BoolArray
) -> Force:
    if static is None:
        return _without_static(recording, design_ratio(recording))
    hanging = _static_text(recording, static, window)
    if more > 0.0:
        hanging = f"({hanging} + {kilonewton(more)} to the design weight)"
    of_falls = f" + hook block and falls {kilonewton(falls)}" if falls else ""
    force = Force(static + more + falls, hanging + of_falls)
    dynamic = factor(recording, DYNAMIC)
    if dynamic is None:
        return force
    rule = (static + more) * dynamic + falls
    text = f"{hanging} x {dynamic:.4g}{of_falls}"
    return replace(force, rule=rule, rule_text=text, factors=(DYNAMIC,))


def _force(
    recording: Recording, values: FloatArray, load: str | None, window: BoolArray | None = None
) -> Force:
    window = window_of_most(recording, values) if window is None else window
    return _raised(recording, values, design_ratio(recording, load, window), window)


def _raised(recording: Recording, values: FloatArray, ratio: float, window: BoolArray) -> Force:
    static = series.static_value(recording, values, window)
    if static is None:
        return _without_static(recording, ratio)
    text = f"{_static_text(recording, static, window)}{to_design(ratio)}"
    return with_rule(recording, Force(static * ratio, text, window=window))


def _static_text(recording: Recording, static: float, window: BoolArray) -> str:
    how = how_on_the_way(recording, window)
    return f"static {kilonewton(static)}{f' {how}' if how else ''}"


def _without_static(recording: Recording, ratio: float) -> Force:
    is_raised = ratio > 1.0 or factor(recording, DYNAMIC) is not None
    return Force(None, "", lacks_static=is_raised)


def raised_of_capacity(
    recording: Recording,
    during: BoolArray,
    element: str,
    force: FloatArray,
    ratios: FloatArray,
    capacity: float,
    of_steps: tuple[float, float] | None = None,
) -> Iterator[Found]:
    """Largest force of an element, all of it raised to the design weight, over its capacity.

    Args:
        recording: The recording.
        during: Samples that count, shape (time,).
        element: Its name.
        force: Its force, shape (time,) [N].
        ratios: By which it is raised at every sample, shape (time,) [1].
        capacity: Its capacity [N].
        of_steps: Its largest force over all steps [N] and when that was [s], where that is known; it counts
            where all samples do.
    """

    def raising(time: float) -> float:
        return float(np.interp(time, recording.time, ratios))

    for found in extreme(recording, ratios * force / capacity, during, element):
        if of_steps is not None and during.all():
            highest = (raising(of_steps[1]) * of_steps[0] / capacity, of_steps[1])
            value, time = earliest_peak(highest, (found.value, found.time or 0.0))
            found = replace(found, value=value, time=time, between=None)
        ratio = raising(found.time or 0.0)
        simulated = kilonewton(found.value / ratio * capacity)
        raised = f"({simulated}{to_design(ratio)})" if ratio > 1.0 else simulated
        yield replace(found, formula=f"{raised} / {kilonewton(capacity)}")


def with_rule(recording: Recording, force: Force) -> Force:
    """With the static force times the rule's dynamic amplification factor, if it has one."""
    dynamic = factor(recording, DYNAMIC)
    if dynamic is None or force.static is None:
        return force
    text = f"{force.static_text} x {dynamic:.4g}"
    factors = tuple(dict.fromkeys((*force.factors, DYNAMIC)))
    return replace(force, rule=force.static * dynamic, rule_text=text, factors=factors)


def at_upper_end(
    recording: Recording, rope: str, force: Force, during: BoolArray, *, of_chain_hoist: bool = True
) -> Force:
    """A force of a rope with what its upper end has to carry of its own weight.

    Args:
        recording: The recording.
        rope: Name of the rope.
        force: Its force, at the middle of a rope whose weight is lumped.
        during: Samples that count.
        of_chain_hoist: Whether what the chain hoist of a sling weighs is part of it.
    """
    more = own_weight(recording, rope, of_chain_hoist=of_chain_hoist)
    if not more.any():
        return force
    own = series.static_value(recording, more, force.window)
    if own is not None:
        force = _with_own_weight(recording, force, own)
    if (way := force.on_the_way) is not None:
        hangs = float(np.interp(way.time, recording.time, more))
        force = replace(force, on_the_way=replace(way, peak=way.peak + hangs))
    if force.peak is None:
        return force
    if force.peak_ratio > 1.0:
        hangs = float(np.interp(force.time or 0.0, recording.time, more))
        return replace(force, peak=force.peak + hangs, own_weight=hangs)
    highest = peak_at_upper_end(recording, rope, during, of_chain_hoist=of_chain_hoist)
    if highest is None:
        return force
    return replace(force, peak=highest.tension, time=highest.time, own_weight=highest.own_weight)


def with_upper_ends(recording: Recording, slings: Iterable[Sling], force: Force) -> Force:
    """What slings pull at gear above them, with what their upper ends hang on it beside that.

    Shackles and halves of slings weigh what they weigh: contingency is one of loads.
    """
    own = sum(sling.upper_weight for sling in slings)
    if own == 0.0:
        return force
    force = _with_own_weight(recording, force, own)
    if (way := force.on_the_way) is not None:
        force = replace(force, on_the_way=replace(way, peak=way.peak + own))
    if force.peak is None:
        return force
    higher = None if force.crest is None else force.crest + own
    return replace(force, peak=force.peak + own, own_weight=own, crest=higher)


def _with_own_weight(recording: Recording, force: Force, own: float) -> Force:
    """A static force with own weight [N], which the rule's factor raises too."""
    if force.static is None:
        return force
    text = f"({force.static_text} + {OWN_WEIGHT} {kilonewton(own)})"
    return with_rule(recording, replace(force, static=force.static + own, static_text=text))


def _with_skew(recording: Recording, force: Force, perfect: float, load: str | None, rule: float) -> Force:
    """With the larger of static force and that with perfect lengths [N] times the rule's skew load factor.

    Both are raised to the design weight: `force` is so already, `perfect` is of the simulated one.
    """
    if force.static is None:
        return force
    ratio = design_ratio(recording, load, force.window)
    by_rule = f"{kilonewton(perfect)} with perfect lengths{to_design(ratio)} x {rule:.4g}"
    text = f"max({force.static_text}, {by_rule})"
    static = max(force.static, perfect * ratio * rule)
    return with_rule(recording, Force(static, text, factors=(SKEW,), window=force.window))


def _with_peak(recording: Recording, force: Force, rope: str, during: BoolArray) -> Force:
    """With the peak of a rope: over all steps if all samples count, else over these."""
    force = _with_peak_of(recording, force, series.tightest_tension(recording, rope), during)
    if force.peak is not None and during.all():
        highest = earliest_peak(series.rope_peak(recording, rope), (force.peak, force.time or 0.0))
        force = replace(force, peak=highest[0], time=highest[1])
    return _under_pins(recording, force)


def _under_pins(recording: Recording, force: Force) -> Force:
    """With that its peak governs, at a time of pins under which the loads never hung still.

    A sling that is slack under pins, and takes its share once they are pulled, has no static force then: a
    factor of the rule on that is one on nothing.
    """
    if force.peak is None or force.static is None or force.raised_peak != force.dynamic:
        return force
    if not _raises(recording):
        return force
    still = np.any(series.quiet_windows(recording), axis=0)
    alike = still & pinned_as_at(recording, force.time or 0.0)
    return force if alike.any() else replace(force, is_under_other_pins=True)


def _with_raised_peak(
    recording: Recording, force: Force, values: FloatArray, during: BoolArray, ratio: float
) -> Force:
    """With the largest of its values [N] as which the loads never hung still, raised, where that governs.

    What slings and hooks bear as a load is turned, or goes from one to another, is static but for a little,
    and goes with the weight; no static value of a hold has it.
    """
    if recording.is_equilibrium or force.static is None or force.is_heavier:
        return force
    static, force = force.static, replace(force, contingency=max(ratio, 1.0))
    highest = series.peak(recording, values, during & never_hung_so(recording))
    if highest is None:
        return force
    if highest[0] * ratio > static:
        force = replace(force, on_the_way=OnTheWay(*highest, ratio))
    if ratio <= 1.0 or highest[0] * ratio <= (force.dynamic or 0.0):
        return force
    return replace(force, peak=highest[0], time=highest[1], peak_ratio=ratio)


def _raises(recording: Recording) -> bool:
    """Whether contingency or a factor of the rule raises static forces."""
    return design_ratio(recording) > 1.0 or any(factor(recording, one) for one in (DYNAMIC, SKEW))


def _with_peak_of(recording: Recording, force: Force, values: FloatArray, during: BoolArray) -> Force:
    highest = None if recording.is_equilibrium else series.peak(recording, values, during)
    if highest is None:
        return force
    counts = bool(during.all() or force.window is None or during[force.window].all())
    lighter = force.static is not None and not has_hung_as_heavy(recording, highest[1], force.window)
    return replace(
        force,
        peak=highest[0],
        time=highest[1],
        counts_static=counts,
        is_of_less=lighter,
        is_heavier=lighter and _raises(recording),
    )
