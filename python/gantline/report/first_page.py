"""The first page: what a toolbox talk and an approval need, on one sheet of A4."""

from __future__ import annotations

from collections.abc import Container
from typing import Any

import numpy as np

from gantline.checks import (
    NO_WARNINGS,
    Check,
    Outcome,
    Verdict,
    foremost,
    hold_points,
    outcome_of,
    past_limits,
    winch_gauges,
)
from gantline.checks.check import ALL_KNOWN, HANGS_STILL, LOAD_LIFTED, PLAN_FINISHED
from gantline.checks.forces import hook_force
from gantline.report.afloat import afloat_facts, vessel_tables
from gantline.report.attitude import attitude, tightest_clearance
from gantline.report.booms import boom_rows
from gantline.report.carried import READ_OVER, READINGS, equalizer_row, hook_row, sling_rows, spreader_row
from gantline.report.case_runs import no_go_cases, simulated_cases
from gantline.report.rest import unsound_cases, what_if
from gantline.report.section import Section
from gantline.report.sketch import sketches
from gantline.report.steps import first_steps
from gantline.report.subject import ABSENT, Subject, as_given, number, share, show, typeset
from gantline.report.turning import turnings
from gantline.report.winches import gauges_with_room, winch_rows
from gantline.results import series
from gantline.results.cranes.boom import Boom
from gantline.results.cranes.crane import Crane
from gantline.results.file.saved import digest_of
from gantline.results.gear import Hook
from gantline.results.loads.hook_peaks import hook_peak
from gantline.results.metrics import energy_bound
from gantline.results.progress import spans
from gantline.results.refinement import in_per_cent, refinement_of
from gantline.results.rig import Load, Rig
from gantline.results.status import INCOMPLETE
from gantline.results.variable import BoolArray

_MOST_SLINGS = 16
#: Of lifts afloat, whose vessels take room on the sheet.
_MOST_SLINGS_AFLOAT = 4
_MOST_NAMED = 4
_MOST_WARNINGS = 3
#: Failed checks with their numbers, and such as are no more than named after them.
_MOST_FAILED = 3
_MOST_FAILED_NAMED = 12
#: Warnings that tell why all others say little.
_FIRST = (HANGS_STILL, PLAN_FINISHED, LOAD_LIFTED, ALL_KNOWN)
#: Tilt at which a lift is stopped where it sets no limit of its own [rad]: 1 deg.
_USUAL_TILT = float(np.deg2rad(1.0))

#: Where whoever signs writes a wind limit that nobody has told.
_BLANK = "not in the lift file; from the crane's manual: ______ m/s"
_OF_NO_CRANE = "wind exceeds the limit of what lifts (not in the lift file; from its manual: ______ m/s)"

#: What a tenth of a tonne shows of a weight [kg].
_SHOWN = 50.0
#: A dynamic factor that is so much more than another one is shown as more [1].
_MORE = 0.005

#: What a load cell in a rope has to show, which no table has.
_IN_CURVES = "the tension of its rope under “Tensions and travel”"


class FirstPage(Section):
    """Verdict, sketch, weights, hooks, slings, equalizers, attitude, steps, trust, signatures."""

    anchor = "lift"
    title = "Lift"
    template = "first_page.html"

    def content(self, subject: Subject) -> dict[str, Any]:
        """What the template is given."""
        most_slings = _MOST_SLINGS_AFLOAT if subject.rig.vessels else _MOST_SLINGS
        slings, slings_left_out = sling_rows(subject, most_slings)
        winches, winches_left_out = winch_rows(subject)
        failed = _failed(subject)[:_MOST_FAILED]
        # What failed stands at the top with its distance, and is not told again.
        too_near = next((check.element for check in failed if _is_distance(check)), "")
        return {
            "rig": subject.rig,
            "is_lift": subject.rig.is_lift,
            "cranes": list(dict.fromkeys(hook.crane or hook.name for hook in subject.rig.hooks)),
            "version": str(subject.recording.attributes.get("gantline_version", "")),
            "fingerprint": fingerprint(subject),
            "ending": _ending(subject),
            "broke_off": _broke_off(subject),
            "verdict": _verdict(subject),
            "sketches": sketches(subject),
            "weights": _weights(subject),
            "hooks": [hook_row(subject, hook) for hook in subject.rig.hooks],
            "winches": winches,
            "winches_left_out": winches_left_out,
            "cranes_travel": bool(subject.rig.cranes),
            "readings": [f"{100 * part:.0f} %" for part in READINGS],
            "slings": slings,
            "slings_left_out": slings_left_out,
            "spreaders": [spreader_row(subject, one) for one in subject.rig.spreaders],
            "equalizers": [equalizer_row(subject, one) for one in subject.rig.equalizers],
            "when_clear": " when clear" if subject.clear.any() else "",
            "turnings": turnings(subject),
            "attitude": attitude(subject, too_near),
            "vessels": vessel_tables(subject),
            "afloat": afloat_facts(subject),
            "booms": boom_rows(subject),
            "stands_on_tracks": bool(subject.rig.crawlers),
            "steps": first_steps(subject),
            # Nobody lifts by the page of a run that broke off.
            "stop_if": [] if _broke_off(subject) else stop_if(subject),
            "what_if": what_if(subject),
            "simulated_cases": simulated_cases(subject),
            "trust": _trust(subject),
        }


def fingerprint(subject: Subject) -> str:
    """The first digits of the SHA-256 of the lift file's text."""
    text = str(subject.recording.attributes.get("scenario", ""))
    return digest_of(text)[:12] if text else ABSENT


def _verdict(subject: Subject) -> dict[str, Any]:
    checks = subject.checks
    head, ending = outcome_of(checks).value, subject.ending
    is_bad = head == Outcome.NO_GO or _broke_off(subject)
    tone = "bad" if is_bad else "none" if head.startswith("NO") else "good"
    warned = [check for check in checks if check.verdict is Verdict.WARNING]
    if tone == "good" and warned:
        tone = "warn"
    failed = _failed(subject)
    compared = [
        one for one in checks if one.utilisation is not None and one.verdict is not Verdict.NOT_CHECKED
    ]
    missing = [
        check.name for check in checks if check.verdict is Verdict.NOT_CHECKED and not check.has_no_limit
    ]
    without = [check.name for check in checks if check.has_no_limit]
    unsound, no_go = unsound_cases(subject), no_go_cases(subject)
    # A plan that holds as drawn is no clear go where what may differ from it does not hold.
    if tone == "good" and (unsound or no_go):
        tone = "warn"
    own = set(subject.rig.limits).difference(subject.rig.assumed_limits)
    return {
        "head": head,
        "tone": tone,
        # No more than what was simulated has a verdict.
        "up_to": "" if ending is None else ending.up_to,
        "failed": [_failure(subject, check) for check in failed[:_MOST_FAILED]],
        "failed_too": _named_failures(failed[_MOST_FAILED:]),
        "warned": [
            _warning(subject, check, own) for check in _foremost_warnings(checks, is_told=ending is not None)
        ],
        "warnings": len(warned),
        "unsound": unsound,
        "no_go_cases": no_go,
        # What failed is past its limit and has been told with its numbers.
        "nearest": [] if failed else foremost(compared)[:3],
        "missing": _listed(missing) if missing else "",
        "without": _listed(without) if without else "",
        "beyond": beyond(subject.rig),
    }


def _failed(subject: Subject) -> list[Check]:
    """What failed, the foremost first."""
    return foremost([check for check in subject.checks if check.verdict is Verdict.FAILED])


def _is_distance(check: Check) -> bool:
    """Whether a check is of the distance that a watched pair has to keep, and of no margin beyond."""
    return check.name == "clearance_margin" and check.limit == 0.0


def _broke_off(subject: Subject) -> bool:
    """Whether the run itself did not reach its end, and not its plan alone."""
    return subject.ending is not None and subject.ending.how in INCOMPLETE


def _ending(subject: Subject) -> dict[str, Any] | None:
    """That a run did not get through its lift: at the top of the page, above all that it seems to say."""
    ending = subject.ending
    if ending is None:
        return None
    is_no_go = outcome_of(subject.checks) is Outcome.NO_GO
    passed = "; it is NO-GO all the same, by what failed before" if is_no_go else ""
    return {
        "is_failure": ending.how == "failed",
        "head": ending.head,
        "happened": ending.happened[0].upper() + ending.happened[1:],
        "cause_is": "likely cause" if ending.how == "failed" else "why",
        "cause": ending.cause,
        "advice": ending.advice,
        "no_go": f"{ending.no_go}{passed}",
    }


def _failure(subject: Subject, check: Check) -> dict[str, str]:
    """A failed check with what it found, what is allowed, when, and what the check itself has to say."""
    bound = (
        ""
        if check.limit is None
        else f"{'at least' if check.at_least else 'at most'} {typeset(check.shown(check.limit))}"
    )
    found = ", ".join(
        part for part in (typeset(check.shown(check.value)), bound, _when(subject, check)) if part
    )
    tightest = tightest_clearance(subject) if _is_distance(check) else None
    if tightest is not None and tightest[0] == check.element:
        found = tightest[1]  # how near, and not by how much it is too near
    name = check.name.replace("_", " ")
    about = ", ".join(part for part in (name, check.element) if part)
    return {"about": about, "text": "; ".join(part for part in (found, check.remark) if part)}


def _when(subject: Subject, check: Check) -> str:
    """When a check governs, with the step of the plan; empty where its value belongs to no one time."""
    if check.step:
        return f"at the end of “{check.step}”"
    if check.time is None or subject.recording.is_equilibrium:
        return ""
    step = subject.step_at(check.time)
    return f"at {show(check.time, 's', 1)}" + (f", “{step}”" if step else "")


def _named_failures(failed: list[Check]) -> str:
    """Further failed checks, with what they use of their limits."""
    named = [
        check.name.replace("_", " ")
        + ("" if check.utilisation is None else f" {100 * check.utilisation:.0f} %")
        for check in failed[:_MOST_FAILED_NAMED]
    ]
    more = f" and {len(failed) - len(named)} more" if len(failed) > len(named) else ""
    return ", ".join(named) + more


def _foremost_warnings(checks: list[Check], *, is_told: bool) -> list[Check]:
    """Warnings that the first page spells out: what is past its limit, and what has a remark of its own.

    `is_told`: that the run did not get through its plan stands above all of them.

    Why there is no verdict comes first, and that a load never hung still, before what all is not known for
    that; then what came to pass in the run, such as a load that is dropped on its bed, before what limits and
    rules do not say.
    """
    past = past_limits(checks)
    others = [one for one in checks if one.verdict is Verdict.WARNING and one not in past and one.remark]
    others = [one for one in others if not (is_told and one.name == PLAN_FINISHED)]
    others.sort(key=lambda one: (one.name not in _FIRST, not _came_to_pass(one)))
    return [*past, *others][:_MOST_WARNINGS]


def _came_to_pass(check: Check) -> bool:
    """Whether a warning is of what a run did: it has no number, or one past the least that may be."""
    if check.value is None or check.limit is None:
        return check.value is None and check.limit is None and check.name != NO_WARNINGS
    return check.at_least and check.value < check.limit


def _warning(subject: Subject, check: Check, own: Container[str]) -> dict[str, str]:
    """A warning with what is past its limit, and when; `own` are limits of the lift file."""
    share = check.utilisation
    value, limit = (typeset(check.shown(one)) for one in (check.value, check.limit))
    past = ", ".join(
        part
        for part in (
            value,
            f"past {'its limit of ' if check.name in own else ''}{limit}",
            _when(subject, check),
        )
        if part
    )
    text = "; ".join(
        part for part in (past if share is not None and share > 1.0 else "", check.remark) if part
    )
    # What lift file and run warn of says itself what it is about.
    about = "" if check.name == NO_WARNINGS else check.name.replace("_", " ")
    return {"about": ", ".join(part for part in (about, check.element) if part), "text": text}


def _listed(names: list[str]) -> str:
    names = [name.replace("_", " ") for name in dict.fromkeys(names)]
    more = f" and {len(names) - _MOST_NAMED} more" if len(names) > _MOST_NAMED else ""
    return ", ".join(names[:_MOST_NAMED]) + more


def beyond(rig: Rig) -> str:
    """What no check of the program looks at in this lift, in words."""
    tracks = {one.name for one in rig.crawlers}
    # What has a boom and no tracks is afloat.
    booms = {one.name for one in rig.booms}
    under = [
        *(["supports"] if rig.supports else ["load"] if any(load.contacts for load in rig.loads) else []),
        *(["crane"] if any(hook.crane not in tracks | booms for hook in rig.hooks) else []),
        *(["tracks"] if any(one.allowed_pressure is None for one in rig.crawlers) else []),
    ]
    parts = ["local strength of the load at its lugs", "wind on cranes and ropes" if rig.wind else "wind"]
    if under:
        # A load that goes on or off a vessel may stand on her deck, which no recording tells from the ground.
        ground = "ground or deck" if rig.vessels else "ground"
        parts.append(f"bearing capacity of the {ground} under the {' and '.join(under)}")
    only = [one.name for one in rig.crawlers if one.allowed_pressure is not None]
    of = "" if len(only) == len(tracks) else f" of {', '.join(only)}"
    looked = f"; ground under the tracks{of} only against the allowed pressure given" if only else ""
    return ", ".join(parts[:-1]) + f" and {parts[-1]}" + looked


def _weights(subject: Subject) -> list[tuple[str, str]]:
    """From calculated weight to hoist load, as the trade counts [t]."""
    rig = subject.rig
    rows: list[tuple[str, str]] = []
    for load in rig.loads:
        if load.calculated_mass is not None and load.contingency is not None:
            rows.append((f"{load.name}, calculated", show(load.calculated_mass, "t", 1)))
            rows.append(
                (f"× contingency {load.contingency:.2f} = design weight", show(load.design_mass, "t", 1))
            )
        else:
            rows.append((f"{load.name}, as simulated", show(_simulated_mass(rig, load), "t", 1)))
    if not rig.hooks:
        return rows
    hooks = [hook.name for hook in rig.hooks]
    force = hook_force(subject.recording, hooks, "hook_load", subject.counts)
    if force.static is not None:
        liquid = _in_tanks(subject, force.window)
        if liquid:
            rows.append(("+ in its tanks, as given", show(liquid, "t", 1)))
        designed = liquid + sum(load.design_mass or _simulated_mass(rig, load) for load in rig.loads)
        # Contingency raises rigging too that hangs between a load and its slings: so the sum adds up.
        rigging = force.static / rig.gravity - designed
        # What a hinge, jacks or other ropes bear is on no hook; a hinge may be pulled against. No sum then.
        is_sum = not rig.hinges and not winch_gauges(subject.recording) and rigging > -_SHOWN
        if rig.loads and rigging > 0.0 and is_sum:
            # A longer name takes two lines on paper, and a full first page the next sheet.
            name = "rigging and tag lines" if rig.tag_lines else "rigging below the hooks"
            rows.append((f"+ {name}", show(rigging, "t", 1)))
        rows.append((f"{'= ' if is_sum else ''}static hook load", show(force.static / rig.gravity, "t", 1)))
    factor = rig.factors.get("dynamic_amplification_factor")
    if factor is not None and force.rule is not None:
        text = f"× dynamic amplification factor of the rule {factor.value:.2f}"
        rows.append((text, show(force.rule / rig.gravity, "t", 1)))
        simulated = force.peak_at_design / force.static if force.static else 0.0
        if simulated >= factor.value + _MORE:
            text = f"× factor simulated, more than that of the rule: {simulated:.2f}"
            rows.append((text, show(force.peak_at_design / rig.gravity, "t", 1)))
    if len(hooks) == 1:
        largest, _ = hook_peak(subject.recording, hooks[0], "hoist_load", subject.counts)
    else:
        hoisted = np.sum([subject.recording.column("hoist_load", hook) for hook in hooks], axis=0)
        largest = float(hoisted[subject.counts].max())
    # Of what one crane, with all hooks of the lift, is rated for with its hook blocks, or one hook alone.
    level = "crane" if any(rating.level == "crane" for rating in rig.ratings) else "hook"
    rated = [one for one in rig.ratings if one.level == level and set(one.hooks) == set(hooks)]
    of = rated[0].rated_capacity if len(rated) == 1 and rated[0].includes_hook_block else None
    text = show(largest / rig.gravity, "t", 1)
    if of:
        used = show(share(largest, of), "%", 0)
        text += f" of {as_given(of / rig.gravity)} t, {used}"
    rows.append(("largest hoist load, simulated", text))
    return [*rows, *_corner_loads(subject)]


def _in_tanks(subject: Subject, window: BoolArray | None) -> float:
    """What is in tanks of loads while they hang still [kg]: it has no contingency."""
    recording, liquid = subject.recording, 0.0
    for load in recording.rig.loads:
        own = series.load_weight(recording, load) - load.weight
        liquid += series.static_value(recording, own, window) or 0.0
    return liquid / recording.rig.gravity


def _corner_loads(subject: Subject) -> list[tuple[str, str]]:
    """What the rails of a Goliath crane bear at most, as the check has it, and its limit if there is one."""
    rows = []
    for check in subject.checks:
        if check.name == "corner_load" and check.value is not None:
            of = f" of {check.shown(check.limit)}" if check.limit is not None else ""
            rows.append((f"largest corner load, {check.element}", f"{check.shown(check.value)}{of}"))
    return rows


def _simulated_mass(rig: Rig, load: Load) -> float:
    return load.simulated_mass or load.weight / rig.gravity


def stop_if(subject: Subject) -> list[str]:
    """When to stop the lift: the usual bounds, or the lift's own where it has some."""
    limits = subject.rig.limits
    # As their tables call what is read; ropes of `mechanics` without a drum are in curves alone.
    tables = {"load cell": "“Hooks”"} if subject.rig.hooks else {}
    tables |= {"gauge": "“Winches and jacks”"} if winch_gauges(subject.recording) else {}
    read = " or ".join(tables) or "load cell"
    cell = f"the mean of a {read} over some waves" if subject.rig.is_in_waves else f"a {read}"
    reading = f"its reading in the table {' or '.join(tables.values())}" if tables else _IN_CURVES
    # What a hinge bears changes as its load turns, which readings at shares of the weight do not tell.
    turned = [hinge.load for hinge in subject.rig.hinges if subject.rig.hooks]
    if turned and next(hold_points(subject.recording), None) is not None:
        reading += f", as {turned[0]} turns from those under “Hooks at hold points”"
    found = [f"{cell} differs by more than 10 % from {reading}{_in_water(subject)}"]
    found.append(_tilt(subject, limits.get("load_tilt")))
    if any(one.mechanism == "sheaves" for one in subject.rig.equalizers):
        found.append(f"a sheave is over {show(subject.most_travel, '%', 0)} of its stroke")
    found += _rods(subject)
    return [*found, *_waves(subject), *_wind(subject), *_current(subject)]


def _rods(subject: Subject) -> list[str]:
    """How near the rod of a compensator may come to a stop; while the load stands it is in."""
    rig = subject.rig
    least = rig.limits.get("compensator_stroke_margin")
    where = f"nearer to a stop than {show(float(least), '%', 0)} of its stroke" if least else "on a stop"
    return [f"the rod of {one.name} is {where}, the load clear" for one in rig.compensators]


def _in_water(subject: Subject) -> str:
    """What load cells read at hold points where water bears a part of the load; their table has it in air."""
    recording, rig = subject.recording, subject.rig
    if all(load.in_water is None for load in rig.loads) or not (wet := series.is_wet(recording)).any():
        return ""
    last = rig.time_to_average or READ_OVER
    cells = [(hook.name, recording.column("hoist_load", hook.name)) for hook in rig.hooks]
    cells += [(gauge.name, gauge.reads) for gauge in gauges_with_room(subject)[0]]
    found = []
    for point in (one for one in hold_points(recording) if one.step.kind == "hold") if cells else ():
        begin, end = spans(recording)[point.step.step]
        late = (recording.time >= max(begin, end - last)) & (recording.time <= end)
        if not late.any() or not wet[late].all():
            continue
        loads = [(name, series.mean_over(recording.time[late], load[late])) for name, load in cells]
        means = [
            (f"{name} " if len(cells) > 1 else "") + number(load / rig.gravity, "t", 1)
            for name, load in loads
        ]
        found.append(f"{' / '.join(means)} t in “{point.step.step}”")
    return f", which is that in air; in water from {', '.join(found) or 'what water leaves of it'}"


def _tilt(subject: Subject, limit: Any) -> str:
    """Which tilt stops the lift; of a load that is turned on purpose that off the plan."""
    usual = show(_USUAL_TILT, "deg", 1)
    if limit:
        return f"tilt is over {show(float(limit), 'deg', 1)}"
    recording = subject.recording
    loads = subject.rig.loads if "load_tilt" in recording else ()
    still = [subject.static(recording.column("load_tilt", load.name)) or 0.0 for load in loads]
    if max(still, default=0.0) > _USUAL_TILT:
        stands = f"in which it hangs still at up to {show(max(still), 'deg', 1)}"
        return f"tilt is more than {usual} off the plan, {stands}"
    tilts = (recording.column("load_tilt", load.name)[subject.counts] for load in loads)
    most = max((float(tilt.max()) for tilt in tilts), default=0.0)
    if most > _USUAL_TILT and any(step.turns for step in subject.rig.plan):
        return f"tilt is more than {usual} off the plan, in which it tilts by up to {show(most, 'deg', 1)}"
    return f"tilt is over {usual}"


def _waves(subject: Subject) -> list[str]:
    """The lift was simulated in its own waves; of higher, longer and other ones nothing here tells."""
    sea = subject.rig.sea
    return [
        f"{train.name} is over {' or '.join(train.height_and_period)}, or from elsewhere"
        for train in (() if sea is None else sea.trains)
    ] + [
        f"{vessel.name} moves more than its record has it"
        for vessel in subject.rig.vessels
        if vessel.grows_over > 0.0
    ]


def _wind(subject: Subject) -> list[str]:
    """When wind stops the lift; a crane out of doors whose limit nobody has said has one in its own papers.

    Of more wind than the lift was simulated in, and of other directions, nothing here tells.
    """
    rig = subject.rig
    cranes: list[Crane | Boom | Hook] = [*rig.cranes, *rig.booms, *rig.fixed_hooks]
    known = {crane.name: crane.wind_limit for crane in cranes if crane.wind_limit is not None}
    in_halls = {crane.name for crane in rig.cranes if rig.wind is None and not crane.has_legs}
    grows = rig.wind is not None and rig.wind.profile is not None
    at_top = " at its top" if grows else ""
    found = [
        f"wind is over {show(limit, 'm/s', 0)}{at_top}, the limit of {name}" for name, limit in known.items()
    ]
    if not cranes and not rig.hooks:
        found.append(_OF_NO_CRANE)
    elif any(hook.crane not in {*known, *in_halls} for hook in rig.hooks) or not (known or in_halls):
        whose = "the crane's limit" if not known else "the limit of any other crane"
        found.append(f"wind exceeds {whose} ({_BLANK})")
    if rig.wind is not None:
        gusts = rig.wind.gust_speed
        what, most = ("wind is", rig.wind.speed) if gusts is None else ("gusts are", gusts)
        where = rig.wind.height_in_words
        found.append(f"{what} over {show(most, 'm/s', 1)}{where}, or from elsewhere")
    return found


def _current(subject: Subject) -> list[str]:
    """The lift was simulated in its own current; of any other nothing here tells."""
    current = subject.rig.current
    return [] if current is None else [f"current is over {show(current.speed, 'm/s', 1)}, or from elsewhere"]


def _trust(subject: Subject) -> str:
    stability = subject.stability
    how, *parts = stability.sentences()
    # Where it ended too early stands at the top of the page.
    parts = parts if subject.ending is not None else [how, *parts]
    settings = subject.recording.attributes.get("settings") or {}
    method = str((settings.get("integrator") or {}).get("type", ""))
    bound = energy_bound(settings) if method else None
    remainder = stability.energy_remainder
    head = f"Method {method}: " if method else ""
    if remainder is not None and bound is not None:
        closes = "closes" if remainder <= bound else "DOES NOT CLOSE"
        rest_of = f"{remainder:.1e} of the largest energy" if remainder else "rounding"
        head += f"the energy balance {closes} to {rest_of} (bound {bound:.0e}); "
    rest = [one for one in parts if not one.startswith("energy remainder")]
    finer = refinement_of(subject.recording)
    if finer is not None and finer.figures:
        most = finer.told[0].name.replace("_", " ") if finer.told else ""
        differ = f"differ by up to {in_per_cent(finer.moved)}, most {most}" if most else "are the same"
        rest.append(f"with {finer.how} the figures of the checks {differ}")
    elif finer is not None and finer.apart is not None:
        rest.append(f"with {finer.how} {finer.apart.sentence}")
    return head + "; ".join(rest)
