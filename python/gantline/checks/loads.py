"""Loads: tilt, yaw, what keeps them upright, what supports give up and tag lines bear, slings in them."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import replace

import numpy as np

from gantline.checks.check import Check, Verdict
from gantline.checks.lugs import BEARS
from gantline.checks.measure import Caution, Finding, Missing, extreme, named
from gantline.results import series
from gantline.results.loads.through import (
    OverEdge,
    Through,
    lines_through,
    slings_over_edges,
    slings_through_loads,
    slings_through_structures,
)
from gantline.results.loads.tilting import loose_tilt
from gantline.results.loads.upending import is_turned
from gantline.results.loads.upright import heels_over, top_heavy, unknown_whether_upright
from gantline.results.recording import Recording
from gantline.results.rig import Load
from gantline.results.variable import BoolArray
from gantline.units import format_quantity

#: Of loads that are turned as nothing says they should be.
_SAY_SO = (
    "a step with 'until: {load_tilt: {above: 89 deg}}', or 'require: {load_tilt: above 85 deg}', "
    "says that the load is turned on purpose"
)
#: Angle between a load in a run and at rest from which on it hangs elsewhere in the run [rad].
_ASIDE = math.radians(2.0)


def tilt(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Angle of a load's own z axis from plumb."""
    for load in recording.rig.loads:
        yield from extreme(recording, recording.column("load_tilt", load.name), during, load.name)
        if (
            is_turned(recording, load)
            and "load_tilt" not in recording.rig.limits
            and not _is_meant(recording)
        ):
            yield Caution(_SAY_SO)
        loose = loose_tilt(recording, load)
        if loose is not None:
            yield Caution(str(loose))


def _is_meant(recording: Recording) -> bool:
    """Whether a step of the plan says that the load is turned, or a hinge in which it turns."""
    return bool(recording.rig.hinges) or any(step.turns for step in recording.rig.plan)


def yaw(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Change of a load's heading from the start, to either side."""
    for load in recording.rig.loads:
        turned = series.load_yaw(recording, load)
        if turned is None:
            yield Missing(load.name, "it is turned upside down, so that it has no heading")
        else:
            yield from extreme(recording, np.abs(turned), during, load.name)


def transferred(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """1 - support forces over weight."""
    for load in recording.rig.loads:
        yield from extreme(recording, recording.column("load_transferred", load.name), during, load.name)


def on_their_tip(recording: Recording) -> list[Check]:
    """A failure for each load or spreader that hung still unstably: nothing in a run need push it.

    Of a load that ropes of `mechanics` bear, or with liquid in its tanks, an equilibrium tells, where the run
    has found one.
    """
    meaning = "what hangs comes back where something pushes it"
    checks = []
    for heavy in top_heavy(recording):
        high = f"what weighs on it is {heavy.too_high:.2f} m too high to hang stably"
        remark = f"{high}: any push turns it over, even where the run has none"
        checks.append(
            Check("hangs_stably", Verdict.FAILED, meaning, element=heavy.name, time=heavy.time, remark=remark)
        )
    for heavy in heels_over(recording):
        high = f"what weighs on it is {heavy.too_high:.2f} m too high to hang stably in these slings"
        remark = f"hoisted, it heels over on what it stands on in place of coming clear: {high}"
        checks.append(
            Check("hangs_stably", Verdict.FAILED, meaning, element=heavy.name, time=heavy.time, remark=remark)
        )
    for one in recording.rig.loads:
        checks += _resting(one, meaning)
    for one in [] if recording.is_equilibrium else unknown_whether_upright(recording):
        held = f"in {named(one.other_ropes)}" if one.other_ropes else f"with liquid in {named(one.tanks)}"
        none = f"no equilibrium was found in which {one.name} hangs clear {held}"
        remark = f"{none}: whether a push rolls it over is not known; 'gantline statics' shows where it rests"
        checks.append(Check("hangs_stably", Verdict.WARNING, meaning, element=one.name, remark=remark))
    return checks


def _resting(load: Load, meaning: str) -> Iterator[Check]:
    """A failure of the first time that a load hung still unstably by an equilibrium, else a warning."""
    check = Check("hangs_stably", Verdict.FAILED, meaning, element=load.name)
    for one in [one for one in load.resting if one.leads_away][:1]:
        remark = (
            f"at rest it is unstable: {one.leads_away}; any push sets that going, even where the run has none"
        )
        yield replace(check, time=one.time, remark=remark)
        return
    # In slings alone a load that still swings is aside of where it rests, too, and comes back.
    for one in [one for one in load.resting if one.aside > _ASIDE and load.other_ropes][:1]:
        angle = format_quantity(one.aside, "deg", 1)
        remark = f"by statics it comes to rest {angle} from where the run has it: 'gantline statics' shows it"
        yield replace(check, verdict=Verdict.WARNING, time=one.time, remark=remark)


def held_by_tag_lines(recording: Recording) -> list[Check]:
    """A warning for each tag line that pulls as if it bore the load: no hook, crane or lug knows of that."""
    checks = []
    for load in recording.rig.loads:
        for line in recording.rig.tag_lines:
            most, time = series.rope_peak(recording, line.rope)
            if most <= BEARS * load.weight:
                continue
            weight = series.load_weight(recording, load)
            share = format_quantity(most / float(np.interp(time, recording.time, weight)), "%", 0)
            remark = (
                f"it pulls with up to {share} of the weight of {load.name}, which no hook and no lug knows of"
            )
            meaning = (
                f"tag lines pull with at most {format_quantity(BEARS, '%', 0)} of the weight of their load"
            )
            checks.append(
                Check(
                    "tag_lines_bear_nothing",
                    Verdict.WARNING,
                    meaning,
                    element=line.name,
                    time=time,
                    remark=remark,
                )
            )
    return checks


def run_through(recording: Recording) -> list[Check]:
    """A warning for each load that slings which carry run through, or hang from within or below."""
    ways: dict[tuple[str, bool], list[Through]] = {}
    for one in slings_through_loads(recording):
        ways.setdefault((one.thing, one.at is None), []).append(one)
    checks = []
    for (load, is_inside), found in ways.items():
        worst = max(found, key=lambda one: one.at or 0.0)
        slings = named(one.name for one in found)
        remark = f"{slings} hung from within or below '{load}'"
        if not is_inside:
            remark = f"{slings} through the skin of '{load}', up to {worst.at:.2f} m from their ends"
        meaning = "slings that carry stay outside of the load as drawn"
        check = Check("sling_outside_load", Verdict.WARNING, meaning, element=worst.name, time=worst.time)
        checks.append(replace(check, remark=remark))
    return checks


def bent_over_edges(recording: Recording) -> list[Check]:
    """A warning for each load whose edges slings go over near their lugs."""
    found: dict[str, list[OverEdge]] = {}
    for one in slings_over_edges(recording):
        found.setdefault(one.load, []).append(one)
    checks = []
    for load, those in found.items():
        worst = max(those, key=lambda one: one.deep)
        remark = (
            f"{named(one.name for one in those)} over an edge of '{load}': up to {worst.deep:.2f} m deep "
            f"through it as drawn, out of it {worst.at:.2f} m from the lug; a rope bends about the edge that "
            "it meets, and no force is reduced for that: stand the lug higher, or lead the sling clear"
        )
        meaning = "slings lead from their lugs clear of the load as drawn"
        check = Check("sling_over_edge", Verdict.WARNING, meaning, element=worst.name, time=worst.time)
        checks.append(replace(check, remark=remark))
    return checks


def run_through_structures(recording: Recording) -> list[Check]:
    """A warning for each structure, hull or boom that slings which carry run through."""
    meaning = "slings that carry stay outside of structures, hulls and booms of other cranes as drawn"
    return _through(slings_through_structures(recording), "sling_outside_structures", meaning)


def lines_run_through(recording: Recording) -> list[Check]:
    """A warning for each load, structure, hull or boom that falls and tag lines which carry run through."""
    meaning = "falls and tag lines that carry stay outside of loads, structures, hulls and booms as drawn"
    return _through(lines_through(recording), "falls_and_lines_outside", meaning)


def _through(every: Iterable[Through], name: str, meaning: str) -> list[Check]:
    ways: dict[str, list[Through]] = {}
    for one in every:
        ways.setdefault(one.thing, []).append(one)
    checks = []
    for thing, found in ways.items():
        worst = max(found, key=lambda one: one.at or 0.0)
        remark = (
            f"{named(one.name for one in found)} through '{thing}', up to {worst.at:.2f} m from their ends, "
            "as if it were not there; a pair under 'watch' takes the place of this"
        )
        check = Check(name, Verdict.WARNING, meaning, element=worst.name)
        checks.append(replace(check, time=worst.time, remark=remark))
    return checks
