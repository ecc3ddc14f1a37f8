"""Rating charts: what hangs against what may, where the hook is at every moment, and where charts hold."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Literal

import numpy as np

from gantline.checks.booms import lean_at_design
from gantline.checks.design_weight import design_ratio
from gantline.checks.force import UNRAISED, UNRAISED_IN_WATER, Force, kilonewton, to_design
from gantline.checks.forces import factor, hook_force
from gantline.checks.gauges import lifting_beside_cranes
from gantline.checks.measure import Caution, Finding, Found, Missing, Refused, extreme
from gantline.results import series
from gantline.results.cranes.rating import (
    RatedGroup,
    at_one_place,
    bears,
    chart_load,
    chart_places,
    rated_groups,
    rated_if_raised,
    rated_load,
    rows_at,
    within_rows,
)
from gantline.results.cranes.rating_chart import RatingChart
from gantline.results.loads.hinges import is_shut
from gantline.results.loads.hook_peaks import hook_peak
from gantline.results.loads.hung_so import most_on_the_way, never_hung_so
from gantline.results.recording import Recording
from gantline.results.rig import Rig
from gantline.results.variable import BoolArray, FloatArray
from gantline.units import format_quantity

SEVERAL = "several_cranes_factor"
#: What a chart may be limited to of a hook, and the variables that are held against it.
_OF_HOOK = {"off_lead": "off_lead", "side_lead": "side_lead"}
#: Share of what slings of one crane pull up to which those of the others bear nothing [1]: slack ones sway.
_BEARS_NOTHING = 1e-3
#: Share of its most from which a hook bears so much that its lead pulls at the boom [1].
_UNDER_LOAD = 0.25
#: Share of the least that is rated at holds below which a place is another one than these [1].
_LESS_RATED = 0.99


def load_of_rating(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Hoist load (or hook load) over the rated load of the chart, of cranes and of each of several hooks."""
    for chart in recording.rig.rating_charts:
        kept, cautions = kept_back(recording, chart.crane)
        yield from cautions
        for group in rated_groups(chart):
            yield from _of_row(recording, during, chart, group, kept)
            if kept > 1.0:
                yield from _alone(recording, during, chart, group, kept)
    yield from _without_chart(recording)


def kept_back(recording: Recording, crane: str) -> tuple[float, list[Caution]]:
    """The rule's factor on what hangs from a crane, 1 if it lifts alone; a caution if no rule has one.

    Winches and jacks that bear a part of the load share it as a second crane does. The table of a rule knows
    cranes alone.
    """
    lifting, beside = _lifting(recording), lifting_beside_cranes(recording)
    if crane not in lifting or (len(lifting) < 2 and not beside):
        return 1.0, []
    kept = factor(recording, SEVERAL)
    if kept is None:
        keys = "'several_cranes_factor' of 'rules' does"
        who = f"{len(lifting)} cranes lift together"
        if len(lifting) < 2:
            who = f"{crane} lifts together with {', '.join(beside)}"
        else:
            keys = f"'several_cranes' or {keys}"
        return 1.0, [Caution(f"{who}, and no rule keeps capacity back; {keys}")]
    return kept, []


def _alone(
    recording: Recording, during: BoolArray, chart: RatingChart, group: RatedGroup, kept: float
) -> Iterator[Caution]:
    """That a crane uses too much by the factor for several while it bears the load alone, and what without.

    The rule is for cranes that share a load. None known says that it ends where others have let go: it stays.
    """
    alone = bears_alone(recording, chart.crane)
    most, least = (
        max((one.value for one in found if isinstance(one, Found)), default=0.0)
        for found in ([*_of_row(recording, during & mask, chart, group, kept)] for mask in (alone, ~alone))
    )
    if most > recording.rig.limits.get("hoist_load_of_rating", 1.0):
        beside = f", and with it at most {100 * least:.1f} % while others bear too" if least > 0.0 else ""
        yield Caution(
            f"the factor of {kept:.4g} is for cranes that share a load, and no rule known here says that it "
            f"ends where one bears it alone, as {chart.crane} does for a while; {group.element} uses "
            f"{100 * most / kept:.1f} % there without it{beside}"
        )


def bears_alone(recording: Recording, crane: str) -> BoolArray:
    """Samples at which a crane bears what hangs, and slings of no other one do, shape (time,).

    None where ropes or bodies of `mechanics` lead to another, or jacks bear a part: what these bear of the
    load is not known here.
    """
    rig = recording.rig
    if lifting_beside_cranes(recording):
        return np.zeros(len(recording.time), dtype=np.bool_)
    by_mechanics = {crane_of(rig, hook.name) for hook in rig.hooks if hook.bears_mechanics}
    if (by_mechanics | {*rig.lifting_by_mechanics}) - {crane}:
        return np.zeros(len(recording.time), dtype=np.bool_)
    borne = {True: np.zeros(len(recording.time)), False: np.zeros(len(recording.time))}
    for sling in rig.slings:
        if hook := rig.hook_of(sling):
            borne[crane_of(rig, hook) == crane] += series.sling_tension(recording, sling)
    return np.asarray(borne[False] <= _BEARS_NOTHING * borne[True], dtype=np.bool_) & (borne[True] > 0.0)


def crane_of(rig: Rig, hook: str) -> str:
    """The crane to which a hook belongs; of one that moves as told the group of a crane or trolley."""
    crane = next((one.crane for one in rig.hooks if one.name == hook), hook)
    groups = {one.level: one.name for one in rig.ratings if hook in one.hooks and one.level != "hook"}
    return groups.get("crane", groups.get("trolley", crane)) if crane == hook else crane


def _lifting(recording: Recording) -> set[str]:
    """The cranes from whose hooks slings hang, or that bear the load by `mechanics`."""
    rig = recording.rig
    hooks = {rig.hook_of(sling) for sling in rig.slings}
    return {crane_of(rig, hook.name) for hook in rig.hooks if hook.name in hooks} | {
        *rig.lifting_by_mechanics
    }


def _without_chart(recording: Recording) -> Iterator[Missing]:
    """Cranes that lift with a boom of which nothing says what may hang at their radius.

    One number is enough where the boom keeps its angle.
    """
    rig = recording.rig
    charted = {chart.crane for chart in rig.rating_charts}
    rated = {one.name for one in rig.ratings if one.level == "crane" and one.rated_capacity}
    for boom in rig.booms:
        is_said = boom.name in charted or (boom.range is None and boom.name in rated)
        if boom.name in _lifting(recording) and not is_said:
            yield Missing(boom.name, "no rating chart")


def _of_row(
    recording: Recording,
    during: BoolArray,
    chart: RatingChart,
    group: RatedGroup,
    kept: float,
) -> Iterator[Finding]:
    element, hooks, share = group.element, group.hooks, group.share
    load = chart_load(recording, chart, hooks)
    places = chart_places(recording, chart, hooks)
    outside = during & (load > 0) & ~within_rows(chart, hooks, places).all(axis=1)
    if outside.any():
        yield Refused(element, _outside(recording, chart, hooks, places, outside))
        return
    rated = rated_load(recording, chart, group)
    beyond = never_hung_so(recording) | _beyond_holds(recording, chart, hooks, rated)
    windows = series.quiet_windows(recording)
    used = np.divide(load, rated, out=np.zeros_like(load), where=rated > 0.0)
    if windows and (way := most_on_the_way(recording, used, beyond & (load > 0.0))) is not None:
        windows.append(way)
    yield from _by_rule(recording, during, (group, kept), chart, places, windows)
    if recording.is_equilibrium:
        return
    loaded = during & (load > 0)
    if loaded.any() and not rated[loaded].all():
        at = int(np.flatnonzero(loaded & (rated <= 0))[0])
        reason = (
            f"nothing may hang at {shown_places(chart, hooks, places[at])}, at {recording.time[at]:.2f} s"
        )
        yield Refused(element, reason)
        return
    load = _with_peak(recording, during, chart, hooks, load)
    ratios, all_raised = (_ratios(recording, chart, hooks, which) for which in (beyond, loaded))
    share_of = kept * load / np.where(loaded, rated, 1.0)
    used, with_design = (np.where(loaded, raised * share_of, 0.0) for raised in (ratios, all_raised))
    names = (SEVERAL,) if kept > 1 else ()

    def text(at: int) -> str:
        raised = f" x {kept:.4g}" if kept > 1 else ""
        of_row = f"{share * 100:.4g} % of " if share < 1 else ""
        row = f"{of_row}{kilonewton(rated[at] / share)} at {shown_places(chart, hooks, places[at])}"
        return f"{kilonewton(load[at])}{to_design(float(ratios[at]))}{raised} / {row}"

    for found in extreme(recording, used, loaded, element, text):
        most = float(with_design.max())
        if len(hooks) == 1 and during.all():
            # What it has between samples is in it.
            found = replace(found, between=None)
        yield replace(found, factors=names, at_design=most if most > found.value else None)


def _with_peak(
    recording: Recording, during: BoolArray, chart: RatingChart, hooks: Sequence[str], load: FloatArray
) -> FloatArray:
    """What hangs in one hook, its largest over all steps at the sample nearest to that, shape (time,) [N].

    A boom goes nowhere between two samples. What hangs in several hooks, or where not all samples count, is
    as samples have it.
    """
    if len(hooks) != 1 or not during.all():
        return load
    peak, time = hook_peak(recording, hooks[0], "hoist_load" if chart.includes_hook_block else "hook_load")
    at = int(np.argmin(np.abs(recording.time - time)))
    raised = load.copy()
    raised[at] = max(load[at], peak) if load[at] > 0.0 else load[at]
    return raised


def _ratios(recording: Recording, chart: RatingChart, hooks: Sequence[str], beyond: BoolArray) -> FloatArray:
    """By what the load of a chart is raised to the design weight at each sample, shape (time,) [1].

    Where they hang as they do at a hold, and not `beyond` that, shape (time,), the hold has it, and it is 1.
    Hook blocks and falls weigh what they weigh.
    """
    hangs = np.sum([recording.column("hook_load", name) for name in hooks], axis=0)
    whole = hangs
    if chart.includes_hook_block:
        whole = np.sum([recording.column("hoist_load", name) for name in hooks], axis=0)
    more = (design_ratio(recording) - 1.0) * np.clip(hangs / np.where(whole > 0.0, whole, np.inf), 0.0, 1.0)
    return np.where(beyond, 1.0 + more, 1.0)


def _beyond_holds(
    recording: Recording, chart: RatingChart, hooks: tuple[str, ...], rated: FloatArray
) -> BoolArray:
    """Samples at which the loads hang where less is rated than wherever they hung still, shape (time,).

    None of a crane that lifts alone, of which the rule counts all the way, and of loads in water, which hang
    with other weights there.
    """
    clear = series.is_clear(recording) & ~_hangs(recording, chart, hooks)
    loaded = chart_load(recording, chart, hooks) > 0
    held = [rated[window & loaded] for window in series.quiet_windows(recording)]
    least = min((float(one.min()) for one in held if one.size), default=0.0)
    if any(load.in_water is not None for load in recording.rig.loads):
        least = 0.0
    return np.asarray(clear & (rated < _LESS_RATED * least), dtype=np.bool_)


def _by_rule(
    recording: Recording,
    during: BoolArray,
    of: tuple[RatedGroup, float],
    chart: RatingChart,
    places: FloatArray,
    windows: Sequence[BoolArray],
) -> Iterator[Finding]:
    """The design weight with the rule's dynamics against the least that is rated over some times.

    These are those that the load hung still, and that between them at which most of the chart is used. Of a
    crane that lifts alone against the least while the load hangs at all: it bears the same all the way. What
    hung in it while a hinge held the load counts where it hung alone.

    Args:
        recording: The recording.
        during: Samples that count.
        of: Hooks that the chart rates together, and the factor of several cranes.
        chart: The chart.
        places: Where hooks are, as `chart_places` has them.
        windows: These times, each of shape (time,).
    """
    group, kept = of
    element, hooks = group.element, group.hooks
    all_the_way = _hangs(recording, chart, hooks) & during
    held = _held(recording)
    variable = "hoist_load" if chart.includes_hook_block else "hook_load"
    highest = hook_force(recording, hooks, variable, during)
    if not windows and highest.lacks_static:
        yield Caution(UNRAISED)
    elif highest.is_heavier:
        yield Caution(UNRAISED_IN_WATER)
    for whole in windows:
        window = _to_its_end(whole) & during
        hangs = all_the_way & ~held[whole].any()
        # A hook in which nothing hangs but its own slings lifts nothing, as for its radius and leads.
        load = chart_load(recording, chart, hooks)
        if not (load[whole] > 0.0).any() or not (load[window | hangs] > 0.0).any():
            continue
        force: Force = hook_force(recording, hooks, variable, during, whole)
        still = force.rule if force.rule is not None else force.static
        if still is None or still <= 0:
            continue
        # Hook blocks and falls are not raised, so that hooks with rows of their own change their shares.
        rated = rated_if_raised(recording, chart, group, _raised_by(recording, hooks, variable, still, whole))
        at = int(np.argmin(np.where(window | hangs, rated, np.inf)))
        least = float(rated[at])
        if least <= 0:
            yield Refused(element, "nothing may hang where the load hangs still")
            return
        text = f"{force.rule_text if force.rule is not None else force.static_text}"
        raised = f" x {kept:.4g}" if kept > 1 else ""
        names = (*force.factors, *((SEVERAL,) if kept > 1 else ()))
        where = "" if window[at] else f" at {shown_places(chart, hooks, places[at])}"
        yield Found(
            kept * still / least, element, None, f"({text}){raised} / {kilonewton(least)}{where}", names
        )


def _to_its_end(window: BoolArray) -> BoolArray:
    """A time that the loads hung still, with the sample at which it ends, shape (time,).

    That is the last sample of a hold, for which its requirements are: the next step begins to move there.
    """
    ended: BoolArray = window | np.append(False, window[:-1])
    return ended


def _raised_by(
    recording: Recording, hooks: Sequence[str], variable: str, still: float, window: BoolArray
) -> float:
    """How many times as much hangs in hooks by the rule than did while the load hung still [1]."""

    def static(name: str) -> float:
        total = np.sum([recording.column(name, hook) for hook in hooks], axis=0)
        return series.static_value(recording, total, window) or 0.0

    hung = static("hook_load")
    return 1.0 if hung <= 0.0 else (still - static(variable) + hung) / hung


def _hangs(recording: Recording, chart: RatingChart, hooks: tuple[str, ...]) -> BoolArray:
    """Samples at which the whole load hangs in these hooks, shape (time,); none if others may bear it too.

    A hinge that holds the load bears a part of it, which changes as it turns.
    """
    others = (hook for hook in recording.rig.hooks if hook.name not in chart.hooks)
    alone = _lifting(recording) == {chart.crane} and not lifting_beside_cranes(recording)
    alone = alone and set(hooks) == set(chart.hooks)
    if not alone or recording.is_equilibrium or any(hook.bears_mechanics for hook in others):
        return np.zeros(len(recording.time), dtype=np.bool_)
    hanging: BoolArray = series.is_clear(recording) & (chart_load(recording, chart, hooks) > 0)
    return hanging & ~_held(recording)


def _held(recording: Recording) -> BoolArray:
    """Samples at which a hinge holds a load, shape (time,)."""
    held = np.zeros(len(recording.time), dtype=np.bool_)
    for hinge in recording.rig.hinges:
        held |= is_shut(recording, hinge)
    return held


def shown_places(chart: RatingChart, hooks: Sequence[str], places: FloatArray, digits: int = 2) -> str:
    """Where hooks are, of those at one place of the boom that with the least rated load.

    Args:
        chart: Their chart.
        hooks: The hooks.
        places: As `chart_places` has them at one moment, shape (hooks,).
        digits: Of a radius or angle.
    """
    rows, worst = rows_at(chart, hooks, places[None])[0], []
    for several in at_one_place(chart, hooks):
        least = min((hooks.index(hook) for hook in several), key=rows.__getitem__)
        worst.append(_shown(chart.of(hooks[least]), float(places[least]), digits))
    return " and ".join(worst)


def _outside(
    recording: Recording,
    chart: RatingChart,
    hooks: Sequence[str],
    places: FloatArray,
    outside: BoolArray,
) -> str:
    at = int(np.flatnonzero(outside)[0])
    beyond = int(np.argmin(within_rows(chart, hooks, places)[at]))
    of = chart.of(hooks[beyond])
    rows = f"{_shown(of, of.at[0])} to {_shown(of, of.at[-1])}"
    when = f"at {recording.time[at]:.2f} s"
    whose = f"the chart of {hooks[beyond]}" if hooks[beyond] in chart.own else "the chart"
    column = places[:, beyond]
    first = _shown_outside(of, float(column[at]))
    by = np.where(outside, np.maximum(of.at[0] - column, column - of.at[-1]), -np.inf)
    last = int(np.argmax(by))
    farthest = _shown_outside(of, float(column[last]))
    and_then = f" ({farthest} at {recording.time[last]:.2f} s)" if farthest != first else ""
    return f"{of.over} of {first} {when}{and_then} is outside of {whose}, {rows}: no lift"


def _shown_outside(chart: RatingChart, place: float) -> str:
    """A place with as many digits as it takes to tell it from both ends of a chart."""
    ends = (chart.at[0], chart.at[-1])
    for digits in range(2, 6):
        shown = _shown(chart, place, digits)
        if all(shown != _shown(chart, end, digits) for end in ends):
            return shown
    return shown


def _shown(chart: RatingChart, place: float, digits: int = 2) -> str:
    return format_quantity(place, "deg" if chart.over == "angle" else "m", digits)


def beyond_rating(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Heel, trim, off-lead, side-lead and waves under load, over the largest for which the chart holds.

    Leads are those of hooks that bear something: an empty one beside them may swing. So are the attitudes of
    charts, where hooks have their own.
    """
    for chart in recording.rig.rating_charts:
        loaded = during & (chart_load(recording, chart, tuple(chart.hooks)) > 0)
        bearing = {hook: loaded & bears(recording, chart, hook) for hook in chart.hooks}
        shared = [bearing[hook] for hook in chart.shared]
        charts = {hook: (own, bearing[hook]) for hook, own in chart.own.items()}
        if shared:
            charts = {chart.crane: (chart, np.any(shared, axis=0) if chart.own else loaded)} | charts
        for of, (one, during_its_loads) in charts.items():
            for key in ("heel", "trim"):
                limit = getattr(one, key)
                if limit is not None:
                    yield from _lean(recording, during_its_loads, limit, (key, chart.crane, of))
            yield from _in_waves(recording, during_its_loads, one.significant_height, of)
        for key, variable in _OF_HOOK.items():
            for hook in chart.hooks:
                limit = getattr(chart.of(hook), key)
                if limit is not None:
                    values = np.abs(recording.column(variable, hook))
                    yield from _lead(recording, values, bearing[hook], limit, (key, hook))


def _in_waves(recording: Recording, during: BoolArray, limit: float | None, of: str) -> Iterator[Finding]:
    """The waves of the lift, under load, over the largest for which a chart holds [m]."""
    sea, element = recording.rig.sea, f"significant_height {of}"
    if limit is None or not recording.rig.is_in_waves:
        return
    if sea is None:
        yield Missing(element, "a vessel moves by a record, and its waves are not known")
        return
    text = f"{sea.significant_height:.4g} m / {limit:.4g} m"
    used = np.full(len(recording.time), sea.significant_height / limit)
    yield from extreme(recording, used, during, element, lambda _: text)


def _lean(
    recording: Recording, during: BoolArray, limit: float, of: tuple[Literal["heel", "trim"], str, str]
) -> Iterator[Found]:
    """Heel or trim of what bears a boom over its limit, with the design weight on its vessel too."""
    key, crane, element = of
    values = np.abs(recording.column(f"crane_{key}", crane))
    for found in _over(recording, values, during, limit, f"{key} {element}"):
        worst = float(np.abs(lean_at_design(recording, crane, key))[during].max()) / limit
        yield replace(found, at_design=worst if worst > found.value else None)


def _lead(
    recording: Recording, values: FloatArray, during: BoolArray, limit: float, of: tuple[str, str]
) -> Iterator[Finding]:
    """A lead over its limit; past that under little load, also what it comes to under more."""
    key, hook = of
    load = recording.column("hook_load", hook)
    for found in _over(recording, values, during, limit, f"{key} {hook}"):
        yield found
        at = int(np.argmax(np.where(during, values, -1.0)))
        most = float(load[during].max())
        under_load = during & (load >= _UNDER_LOAD * most)
        if values[at] > limit and not under_load[at]:
            left, lead = (math.degrees(float(one)) for one in (values[at], values[under_load].max()))
            yield Caution(
                f"{key} of {left:.2f} deg with {kilonewton(load[at])} in {hook}, "
                f"{100.0 * load[at] / most:.0f} % of its most; with a quarter of that and more {lead:.2f} deg"
            )


def _over(
    recording: Recording, values: FloatArray, during: BoolArray, limit: float, element: str
) -> Iterator[Found]:
    def text(at: int) -> str:
        return f"{math.degrees(values[at]):.3f} deg / {math.degrees(limit):.4g} deg"

    yield from extreme(recording, values / limit, during, element, text)
