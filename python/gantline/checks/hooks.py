"""Hook load, hoist load, dynamics and levels of hooks."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import combinations

import numpy as np

from gantline.checks.force import NO_STATIC, Raised, as_it_is, hung_otherwise_sentence, kilonewton, over
from gantline.checks.forces import hook_force
from gantline.checks.measure import Caution, Finding, Found, Missing, extreme
from gantline.checks.ratings import SEVERAL, crane_of, kept_back
from gantline.results import series
from gantline.results.cranes.pulled_aside import hooks_that_stay, pull_aside
from gantline.results.gear import Hook
from gantline.results.loads.hook_peaks import hook_peak
from gantline.results.loads.hung_so import hung_otherwise
from gantline.results.loads.standing import all_stands
from gantline.results.recording import Recording
from gantline.results.ropes.parting import DETACHED, while_there
from gantline.results.variable import BoolArray, FloatArray
from gantline.units import format_quantity

#: Levels of rated capacities, that of most first.
_LEVELS = ("crane", "trolley", "hook")
#: How many times the largest upright part of it what pulls along a hook's own ropes may be before it is told
#: [1]; 1.05 is 18 deg.
_ASLANT = 1.05
#: Difference of two levels that nobody reads, who reads them in mm [m]: one that stays rings in its ropes.
_LEVEL = 0.5e-3
#: Levels that differ by less have a digit more than those which do by more [m], or they would look alike.
_MILLIMETRES = 0.01
_PARTED = "its falls have parted"


def hook_load(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Hook load as simulated, of hooks in which something hangs; of all where nothing hangs in any."""
    hooks = recording.rig.hooks
    counts = {hook.name: during & _is_in_use(recording, hook) for hook in hooks}
    if not any(of.any() for of in counts.values()):
        counts = dict.fromkeys(counts, during)
    for hook in hooks:
        column = recording.column("hook_load", hook.name)
        for found in extreme(recording, column, counts[hook.name], hook.name):
            yield _over_all_steps(recording, during, found, 1.0)


def _over_all_steps(recording: Recording, during: BoolArray, found: Found, per: float) -> Found:
    """What was found of a hook's load in samples, over `per` [N], with its largest over all steps.

    Where not all samples count it is as it was found.
    """
    if not during.all() or "hook_peak_load" not in recording:
        return found
    peak, time = hook_peak(recording, found.element, "hook_load")
    return replace(found, value=peak / per, time=time, between=None)


def _is_in_use(recording: Recording, hook: Hook) -> BoolArray:
    """Samples at which a sling of a hook is on, or something of `mechanics` hangs in it, shape (time,)."""
    if hook.bears_mechanics:
        return series.everywhere(recording)
    slings = [one for one in recording.rig.slings if recording.rig.hook_of(one) == hook.name]
    on = while_there(recording, [one.rope for one in slings], [DETACHED])
    return np.asarray(on.any(axis=0), dtype=np.bool_)


def static_hook_load(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Static hook load with the design weight."""
    for hook in recording.rig.hooks:
        force = hook_force(recording, [hook.name], "hook_load", during)
        if force.static is None:
            yield Missing(hook.name, NO_STATIC)
        else:
            yield Found(force.static, hook.name, formula=force.static_text)
            if force.static_caution:
                yield Caution(force.static_caution)


def dynamic_hook_load(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Dynamic hook load: static by the rule's factor, or the simulated peak."""
    for hook in recording.rig.hooks:
        yield from as_it_is(hook_force(recording, [hook.name], "hook_load", during), hook.name)


def hook_dynamic_factor(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Peak over static hook load, both as simulated."""
    for hook in recording.rig.hooks:
        force = recording.column("hook_load", hook.name)
        static, _ = series.greatest_static(recording, force)
        if recording.is_equilibrium:
            yield Missing(hook.name, "an equilibrium has no peak")
        elif not static:
            yield Missing(hook.name, "no static hook load: the load never hung still, clear of its supports")
        else:
            text = f"peak {kilonewton(hook_peak(recording, hook.name, 'hook_load')[0])}"
            text += f" / static {kilonewton(static)}"
            for sampled in extreme(recording, force / static, during, hook.name):
                found = _over_all_steps(recording, during, sampled, static)
                otherwise = None if found.time is None else hung_otherwise(recording, found.time)
                if otherwise:
                    yield Missing(hook.name, hung_otherwise_sentence(otherwise))
                else:
                    yield replace(found, formula=text)


def falls_margin(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """How far the sheaves of a hook block stay below those above: length of the falls less a diameter.

    Falls of a rope that has parted hang nowhere, and have no length.
    """
    for hook in recording.rig.hooks:
        if not hook.falls or not hook.sheave_diameter:
            continue
        falls, whole = _falls(recording, hook)
        counts = during & whole.any(axis=0)
        if during.any() and not counts.any():
            yield Missing(hook.name, _PARTED)
        lengths = np.where(whole | ~whole.any(axis=0), falls, np.inf).min(axis=0)
        for found in extreme(recording, lengths - hook.sheave_diameter, counts, hook.name, smallest=True):
            shortest = found.value + hook.sheave_diameter
            yield replace(
                found, formula=f"falls of {shortest:.2f} m - sheaves of {hook.sheave_diameter:.2f} m"
            )


def rope_torque_of_falls(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Torque of the hoist ropes over the largest that their falls give back, (FT4); from 1 on they twist up.

    Nothing of ropes whose torque nobody knows; of those that usually have one, a word where it would do.
    """
    for hook in recording.rig.hooks:
        if not hook.falls_spread:
            continue
        falls, whole = _falls(recording, hook)
        counts = during & whole.any(axis=0)
        longest = np.where(whole, falls, 0.0).max(axis=0)
        used = hook.rope_torque * longest / hook.falls_spread

        def text(at: int, longest: FloatArray = longest, of: Hook = hook) -> str:
            arm, spread = f"{1e3 * of.rope_torque:.3g} mm", f"{of.falls_spread:.3g} m2"
            return f"torque factor x diameter = {arm} x falls of {longest[at]:.2f} m / spread of {spread}"

        for found in extreme(recording, used, counts, hook.name, text):
            if hook.is_rope_torque_known:
                turned = "" if found.value >= 1.0 else f": it turns by {_degrees(np.arcsin(found.value))}"
                yield replace(found, formula=f"{found.formula}{turned}")
            elif found.value >= 1.0:
                yield Missing(hook.name, "the torque factor of its rope is not known")
                yield Caution(
                    f"with what ropes of six strands usually have the falls of {hook.name} twist "
                    f"up: {found.formula}; 'torque_factor' of the rope says more"
                )


def _falls(recording: Recording, hook: Hook) -> tuple[FloatArray, BoolArray]:
    """Lengths of all falls of a hook [m], and whether their rope has not parted, both (falls, time)."""
    of = [fall.rpartition("/")[0] for fall in hook.falls]
    ropes = sorted(set(of))
    whole = while_there(recording, ropes)[[ropes.index(rope) for rope in of]]
    return np.array([recording.column("segment_length", part) for part in hook.falls]), whole


def _degrees(angle: float) -> str:
    return format_quantity(float(angle), "deg", 0)


def level_difference(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """How far of two hooks that bear the load one has gone up more than the other since it came clear.

    Any two, or any two of those that the limit of the lift file names.
    Only while both have slings on: a hook goes where it likes before its slings are put on, and after they
    have been taken off. One that stays behind so far that its slings go slack counts.
    """
    rig = recording.rig
    bearing: dict[str, list[BoolArray]] = {}
    for sling in rig.slings:
        bearing.setdefault(rig.hook_of(sling), []).append(series.is_on(recording, sling.rope))
    compared = [hook.name for hook in rig.hooks if not rig.level_hooks or hook.name in rig.level_hooks]
    on = {name: np.any(bearing[name], axis=0) for name in compared if name in bearing}
    clear = series.is_clear(recording)
    if recording.is_equilibrium or not clear.any():
        for name in on:
            yield Missing(name, "its rise counts from when a run brings the load clear")
        return
    # Hook blocks stay upright: a bearing goes up as its body does.
    heights = {name: recording.column("body_position", name)[:, 2] for name in on}
    for one, other in combinations(on, 2):
        for together in series.stretches(on[one] & on[other]):
            counts = together & clear
            if not counts.any():
                continue
            first, second = (heights[name] - heights[name][np.argmax(counts)] for name in (one, other))

            def text(
                at: int,
                names: tuple[str, str] = (one, other),
                rises: tuple[FloatArray, ...] = (first, second),
            ) -> str:
                digits = 3 if abs(rises[0][at] - rises[1][at]) >= _MILLIMETRES else 4
                risen = [
                    f"{name} {format_quantity(float(rise[at]), 'm', digits)}"
                    for name, rise in zip(names, rises, strict=True)
                ]
                return f"{', '.join(risen)} up since it came clear"

            apart, names = np.abs(first - second), f"{one} to {other}"
            yield from extreme(recording, apart, during & counts, names, text, alike=_LEVEL)


def of_drive_capacity(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Static hoist load with the design weight over what motor and brake hold by themselves.

    What hangs there as a load is turned, between two holds, is static but for a little, and counts.
    """
    for hook in recording.rig.hooks:
        if not hook.holds:
            continue
        force = hook_force(recording, [hook.name], "hoist_load", during)
        if force.static is None:
            yield Missing(hook.name, NO_STATIC)
            continue
        if force.static_caution:
            yield Caution(force.static_caution)
        holds = hook.holds * _first_layer_over_last(recording, hook.drum, during)
        of_drum = f"{kilonewton(holds)} of its drum"
        if hook.has_weaker_brake:
            yield from _beyond_brake(recording, during, hook, holds)
        if (way := force.on_the_way) is not None:
            yield Found(way.raised / holds, hook.name, way.time, f"{way.text} / {of_drum}")
            continue
        yield Found(force.static / holds, hook.name, formula=f"{force.static_text} / {of_drum}")


def _beyond_brake(recording: Recording, during: BoolArray, hook: Hook, holds: float) -> Iterator[Caution]:
    """That more pulls at a drum while all drives stand than its brake holds, as when a load is caught.

    In a run the motor holds what stands, but for an emergency stop; on a crane the brake does.
    """
    if recording.is_equilibrium:
        return
    ropes = Counter(fall.rpartition("/")[0] for fall in hook.falls)
    # After its parts comes the lead line. As a hoist stops it has what friction adds, which holds from then
    # on: what makes a brake slip on is more than it holds there, and more without any friction too.
    leads = [recording.column("segment_tension", f"{rope}/{parts}") for rope, parts in ropes.items()]
    pulls, brake = np.max(leads, axis=0), holds / len(hook.falls)
    used = np.minimum(pulls / brake, recording.column("hoist_load", hook.name) / holds)
    used = np.where(during & np.append(all_stands(recording), True), used, 0.0)
    at = int(np.argmax(used))
    if used[at] > 1.0:
        yield Caution(
            f"each rope of {hook.name} pulls at its drum with {kilonewton(pulls[at])} at "
            f"{recording.time[at]:.2f} s, while nothing moves, and its brake holds {kilonewton(brake)}: in "
            "the run the motor holds that, and a hoist that stands on its brake slips"
        )


def _first_layer_over_last(recording: Recording, name: str, during: BoolArray) -> float:
    """Diameter of a drum's first layer over that of the last one that rope came on [1]."""
    drum = next((one for one in recording.rig.drums if one.name == name), None)
    if drum is None or name not in recording.coordinates.get("counted_drum", ()) or not during.any():
        return 1.0
    last = float(recording.column("drum_layer", name)[during].max())
    return drum.diameter / (drum.diameter + 2.0 * drum.layer_step * (last - 1.0))


def of_rated_capacity(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Hoist load (or hook load, as the rating says) of hooks, trolleys and cranes over rated capacity.

    Cranes that lift together keep capacity back: of their charts, those without a chart of this, where a
    crane has none of trolleys or hooks. Hooks that move as told may be of one crane: without a rule nothing
    is said of them.
    """
    rig = recording.rig
    charted = {chart.crane for chart in rig.rating_charts}
    levels: dict[str, list[str]] = {}
    for rating in rig.ratings:
        if rating.rated_capacity:
            levels.setdefault(crane_of(rig, rating.hooks[0]), []).append(rating.level)
    for rating in rig.ratings:
        element = rating.name if rating.level == "hook" else f"{rating.level} {rating.name}"
        if not rating.rated_capacity:
            yield Missing(element, "rated capacity not known", is_strength=True)
            continue
        variable = "hoist_load" if rating.includes_hook_block else "hook_load"
        force = hook_force(recording, rating.hooks, variable, during)
        raised = Raised()
        crane = crane_of(rig, rating.hooks[0])
        if crane not in charted and rating.level == min(levels[crane], key=_LEVELS.index):
            kept, cautions = kept_back(recording, crane)
            yield from cautions if rating.level == "crane" else ()
            raised = Raised(kept, f" x {kept:.4g}", (SEVERAL,)) if kept > 1.0 else raised
        yield from over(force, rating.rated_capacity, element, raised)
        yield from _aslant(recording, during, rating.hooks) if rating.level == "hook" else ()


def _aslant(recording: Recording, during: BoolArray, names: Sequence[str]) -> Iterator[Caution]:
    """That hooks which stay where they are, of chain hoists for one, are pulled aside by much.

    A crane is rated for what hangs, upright; a chain hoist for what pulls along its chain, which is more.
    """
    for hook in (one for one in hooks_that_stay(recording) if one.name in names):
        upright, aside = recording.column("hook_load", hook.name), pull_aside(recording, hook)
        along = np.where(during, np.hypot(upright, aside), 0.0)
        compared = float(np.max(upright[during], initial=0.0))
        at = int(np.argmax(along))
        # What a hook bears aslant while it bears little, as two slings go taut before two, is not compared.
        if along[at] > _ASLANT * compared > 0.0:
            lean = format_quantity(float(np.arctan2(aside[at], upright[at])), "deg", 0)
            times = float(along[at]) / compared
            yield Caution(
                f"{hook.name} is pulled {lean} aside, and what is compared is the upright part: along the "
                f"pull, which a chain hoist is rated for, it is up to {times:.3g} times as much"
            )
