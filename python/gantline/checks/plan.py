"""Whether a run got through its plan, its steps moved, its hoists followed, and it lifted anything."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from gantline.checks.check import HANGS_STILL, LOAD_LIFTED, PLAN_FINISHED, Check, Verdict
from gantline.checks.held_down import held_down
from gantline.checks.measure import named
from gantline.checks.picked_up import what_helps
from gantline.results import progress, series
from gantline.results.ending import waiting
from gantline.results.gear import Drum
from gantline.results.loads.lift_off import hangs_from_the_start, lift_off_time
from gantline.results.recording import Recording
from gantline.results.rig import Load, Step
from gantline.results.ropes.parting import PLANNED, partings
from gantline.results.status import INCOMPLETE
from gantline.results.variable import FloatArray
from gantline.units import format_quantity, quantity

#: A load of which less than this share ever hangs has not been lifted [1].
_LIFTED_FROM = 0.05
#: Motors that pull all they can for longer in all are told [s]; at starts and stops that is nothing.
_LONG = 1.0
#: Steps that move hooks.
_HOISTS = ("hoist", "lower")
#: Steps that turn drums of `mechanics`, which hoist where they wait for what a load stands on to come clear.
_JACKS = ("haul_in", "pay_out")
_OF_SUPPORTS = ("supports ", "load transferred ")
#: Why a step moved nothing, by the key that ends it; a recording of an older version has none.
_STILL = {
    "until": "what it waits for held as it began",
    "to": "it was there as it began",
    "brake_from": "its 'brake_from' was over as it began",
    "emergency_stop_at": "its 'emergency_stop_at' was over as it began",
}
#: Keys that name a time.
_TIMES = ("brake_from", "emergency_stop_at")
#: Steps in which boom heads go up and down.
_HEADS = {"luff", "lead"}
#: How far a hook goes the other way than its step says before that is told [m].
_BACK = 0.1
#: Steps that take a load along and do not lower it.
_TAKES_ALONG = {"luff", "slew", "lead", "traverse", "travel"}
#: Steps that lower a load, or that bring what it hangs from or stands over somewhere else.
_LOWERS = {"lower", "pay_out", "haul_in", "pump", *_TAKES_ALONG}
#: A load that has hung clear for so long was not being set down; one that comes off bounces for less [s].
_HUNG = 5.0
#: Share of a load's weight from which it is told that it hangs at the start.
_HANGS = 0.02
#: What goes on down after it has met something was not set down on it; contacts that give come to less [m].
_WENT_ON = 0.1
#: A load that is turned by more meanwhile is laid down about what it met [rad].
_LAID = np.radians(10.0)
#: Speed at which a load that is set down makes nobody wonder, beyond rounding of a hoist's own [m/s].
_HARD = 0.1 + 1e-3
#: Way that a hook may lose against motor or brake [m]: its rope stretches, and rings.
_LOST = 0.05


def unfinished(recording: Recording) -> list[Check]:
    """A warning where a run ends before its plan, or broke off: what did not happen has not been checked.

    One that broke off in its last hold has done all that its plan moves, and has not shown that the load
    hangs quietly after that.
    """
    left = progress.unfinished(recording)
    ended = INCOMPLETE.get(str(recording.attributes.get("status")), "ends")
    if left is None and ended == "ends":
        return []
    at = f" in '{left.under_way[0]}'{_waiting(recording, left.under_way)}" if left and left.under_way else ""
    not_begun = f"; not begun: {named(left.not_begun)}" if left is not None and left.not_begun else ""
    stopped = [time for time, _, _ in recording.events("emergency_stop")]
    after = f", after the emergency stop at {stopped[0]:.4g} s" if stopped else ""
    end = f"{recording.time[-1]:.4g} s" if len(recording.time) else "its start"
    remark = f"the run {ended} at {end}{at}{after}{not_begun}"
    return [Check(PLAN_FINISHED, Verdict.WARNING, "all steps of the plan within the run", remark=remark)]


def _waiting(recording: Recording, under_way: Sequence[str]) -> str:
    """What the first step that waits for something waits for, and how near that is; empty if none does."""
    step, what = waiting(recording, under_way)
    if not step:
        return ""
    which = "which" if step == under_way[0] else f"beside '{step}', which"
    return f", {which} waits for {what}"


def not_lifted(recording: Recording) -> list[Check]:
    """A warning for each load with slings that stays on its supports: nothing that it carries was tried.

    Of an equilibrium the last sample counts; before it stands how the lift file has the load.
    """
    checks = []
    for load in recording.rig.loads if recording.rig.slings else ():
        if load.name not in recording.coordinates.get("load", ()) or not len(recording.time):
            continue
        hung = recording.column("load_transferred", load.name)
        most = float(hung[-1] if recording.is_equilibrium else hung.max())
        if most < _LIFTED_FROM:
            remark = f"'{load.name}' is not lifted, {max(100 * most, 0.0):.0f} % of its weight hangs at most"
            meaning = "loads are lifted"
            checks.append(Check(LOAD_LIFTED, Verdict.WARNING, meaning, element=load.name, remark=remark))
    return checks


def steps_move(recording: Recording) -> list[Check]:
    """A warning where steps moved nothing, or hoisted a hook down or lowered it up."""
    remarks = [*_stood_still(recording), *_pumped_nothing(recording), *_went_back(recording)]
    if not remarks:
        return []
    return [Check("plan_moves", Verdict.WARNING, "steps move what they say", remark="; ".join(remarks))]


def _stood_still(recording: Recording) -> Iterator[str]:
    """Steps that moved nothing: what they wait for held, or their time was over, as they began.

    A vessel that floats elsewhere than the lift file has it may take the load before the first step does; and
    `above` that was meant as `below` makes a step that is over at once. A step before that waits for a
    condition may take longer than a time of the next one allows. What only hauls or traverses until something
    holds has nothing to do where it does; drums that wait for supports hoist, as strand jacks do.
    """
    begins = {name: time for time, _, name in recording.events("step_begin")}
    ends = {name: time for time, _, name in recording.events("step_end")}
    moving = [one for one in recording.rig.plan if _is_hoisting(one) or one.ends_by in _TIMES]
    at_once = [step for step in moving if step.step in ends and ends[step.step] == begins.get(step.step)]
    if not at_once:
        return
    still: dict[str, list[str]] = {}
    for step in at_once:
        still.setdefault(_STILL.get(step.ends_by, _STILL["until"]), []).append(step.step)
    yield from (f"{why}, and nothing moved: {named(names)}" for why, names in still.items())
    hung = [
        f"{100.0 * share:.0f} % of {load.name} {_hangs(recording, load)}"
        for load in recording.rig.loads
        if (share := float(recording.column("load_transferred", load.name)[0])) > _HANGS
    ]
    if hung and begins[at_once[0].step] == recording.time[0]:
        yield f"{' and '.join(hung)} before the plan begins"


def _is_hoisting(step: Step) -> bool:
    """Whether a step hoists or lowers, by hooks or by drums."""
    return step.kind in _HOISTS or (step.kind in _JACKS and step.until.startswith(_OF_SUPPORTS))


def _pumped_nothing(recording: Recording) -> Iterator[str]:
    """Pumps that were to right a vessel and did nothing, since she leans farther the other way.

    Heel counts to starboard and trim by the stern, so that one to port is below every bound: the sign has
    slipped. A vessel that lies within the bound on either side needs no pumping.
    """
    ends = {name: time for time, _, name in recording.events("step_end")}
    begins = {name: time for time, _, name in recording.events("step_begin")}
    for step in recording.rig.plan:
        if step.kind != "pump" or not step.seen_by or ends.get(step.step) != begins.get(step.step, np.nan):
            continue
        side, bound = _bound_of(step.until)
        angle = float(np.interp(begins[step.step], recording.time, recording.column(*step.seen_by[:2])))
        if side * bound >= 0.0 and abs(angle) > abs(bound):
            positive = "to starboard" if step.seen_by[0] == "vessel_heel" else "by the stern"
            meant = f"'{'above' if side > 0.0 else 'below'}: {format_quantity(-abs(bound) * side, 'deg', 2)}'"
            is_then = f"{format_quantity(angle, 'deg', 2)} as it begins, positive {positive}"
            waits = f"it waits for {step.until}, and that is {is_then}"
            yield f"'{step.step}' pumps nothing: {waits}; {meant} waits for less"


def _bound_of(until: str) -> tuple[float, float]:
    """Side, +1 of `below` and −1 of `above`, and angle [rad] of `heel of barge below 0.1 deg`."""
    _, side, value, unit = until.rsplit(" ", 3)
    return (1.0 if side == "below" else -1.0), quantity(f"{value} {unit}", "angle")


def _went_back(recording: Recording) -> Iterator[str]:
    """Steps that end at a height from which their hook was on the other side as they began.

    Where a step before waits for a condition, only the run knows where the hook is, and the drive goes to the
    height from either side. A boom head that goes up or down meanwhile takes its hook along; what a vessel
    does is less than what counts here.
    """
    spans = progress.spans(recording)
    heads = [spans[step.step] for step in recording.rig.plan if step.kind in _HEADS and step.step in spans]
    for step in recording.rig.plan:
        if step.to is None or step.kind not in _HOISTS or step.step not in spans:
            continue
        begin, end = spans[step.step]
        if any(since < end and begin < until for since, until in heads):
            continue
        up = 1.0 if step.kind == "hoist" else -1.0
        for hook in (one.name for one in recording.rig.hooks if f"{one.name}.hoist" in step.drives):
            heights = recording.column("body_position", hook)[:, 2]
            first, last = (float(one) for one in np.interp((begin, end), recording.time, heights))
            if up * (step.to - first) < -_BACK and up * (last - first) < -_BACK:
                went = "goes down" if up > 0.0 else "goes up"
                way = f"from {format_quantity(first, 'm', 2)} to {format_quantity(last, 'm', 2)}"
                yield f"'{step.step}' is to {step.kind} {hook}, which {went} {way}"


def _hangs(recording: Recording, load: Load) -> str:
    """What bears the share of a load that its supports do not, at the start."""
    wet = load.in_water is not None and recording.column("displaced_volume", load.in_water)[0] > 0.0
    return "is borne by the water and its slings" if wet else "hangs"


def never_still(recording: Recording) -> list[Check]:
    """A warning where static values are means over motion, or not known: nothing hung clear for long enough.

    The shorter the time is over which they are means, the more of the motion they have.
    """
    least = format_quantity(series.time_to_hang_still(recording.rig), "s", 0)
    if series.moves_all_along(recording):
        times = recording.time[series.quiet_window(recording)]
        over = f"{times[0]:.4g} to {times[-1]:.4g} s, in which the plan moves it"
        remark = (
            f"static forces are means over {over}: hold the load still for {least}, clear of its supports"
        )
    elif not recording.is_equilibrium and not series.quiet_windows(recording) and _has_come_off(recording):
        remark = f"no static force is known: hold the load still for {least}, clear of its supports"
        remark += "".join(f"; {again}" for again in _back_on_supports(recording))
    else:
        return []
    return [Check(HANGS_STILL, Verdict.WARNING, f"the load hangs still for {least} once", remark=remark)]


def _has_come_off(recording: Recording) -> bool:
    """Whether loads came clear of their supports, by slings; a mechanism has nothing to hang still."""
    return bool(recording.rig.slings) and lift_off_time(recording) is not None


def _back_on_supports(recording: Recording) -> Iterator[str]:
    """Loads that hardly came off: a bounce freed them, no step lowers them after it, and they stand again.

    `until: {supports: clear}` holds at the top of such a bounce, and the hook brakes there.
    """
    lowers = _lowering(recording)
    first = lift_off_time(recording)
    for load in recording.rig.loads:
        weight = series.load_weight(recording, load)
        share = float(series.borne(recording, load)[-1] / weight[-1])
        spans = progress.spans(recording).items()
        is_lowered = any(step in lowers and end > (first or 0.0) for step, (_, end) in spans)
        if share > 0.0 and not is_lowered and first is not None:
            yield (
                f"{load.name} comes off at {first:.4g} s and stands on its supports again, at the end with "
                f"{format_quantity(share, '%', 2)} of its weight: hoist it farther once they are clear"
            )


def came_down(recording: Recording) -> list[Check]:
    """A check for each load that meets something while a step takes it along.

    A boom that goes down lowers its hooks, and nobody may have thought of that; what follows drags the load:
    a warning. What slews, traverses or travels comes no lower, and runs into what is in its way: a failure.
    Of one that something holds down `held_down` tells.
    """
    kinds = {step.step: step.acts_as for step in recording.rig.plan}
    loads = {load.name for load in recording.rig.loads}
    spans = progress.spans(recording)
    first: dict[str, Check] = {}
    for time, _, name in recording.events("set_down"):
        steps = [step for step, (begin, end) in spans.items() if begin < time <= end]
        if name in loads and steps and all(kinds.get(step) in _TAKES_ALONG for step in steps):
            luffs = any(kinds[step] == "luff" for step in steps)
            verdict = Verdict.WARNING if luffs else Verdict.FAILED
            met = "it comes down on what is below it" if luffs else "it runs into what is in its way"
            remark = f"{met} in '{progress.BESIDE.join(steps)}', which does not lower it"
            meaning = "loads that are taken along stay clear"
            check = Check("stays_clear", verdict, meaning, element=name, time=time, remark=remark)
            first.setdefault(name, check)
    found = held_down(recording)
    held = len(found)
    for more in (lambda _: first.values(), _driven_against, _caught):
        found += [one for one in more(recording) if one.element not in {other.element for other in found}]
    return found[held:]


def _driven_against(recording: Recording) -> Iterator[Check]:
    """A warning for each load that hangs clear and meets what stands still, while no step lowers or moves it.

    Wind does that, a tag line that is hauled or let go, a swing, or what is pumped from one end of the load
    to the other. Where a rope has parted, that is told.
    """
    lowers, within = _lowering(recording), _pumped_within(recording)
    spans = progress.spans(recording)
    lost = min((one.time for one in partings(recording) if one.kind not in PLANNED), default=np.inf)
    for load in recording.rig.loads:
        since = 0.0 if hangs_from_the_start(recording, load) else None
        for time, kind, name in recording.events():
            if name != load.name or kind not in ("lift_off", "set_down"):
                continue
            steps = [step for step, (begin, end) in spans.items() if begin < time <= end]
            is_lowered = any(step in lowers for step in steps)
            hung = 0.0 if since is None or kind == "lift_off" else time - since
            since = time if kind == "lift_off" else None
            stands = any(contact not in load.meets for contact in _met(recording, load, time))
            if hung >= _HUNG and stands and not is_lowered and time < lost:
                where = f" in '{progress.BESIDE.join(steps)}'" if steps else ""
                remark = f"it meets what is in its way{where}, after {hung:.3g} s of hanging clear: see"
                tilts = "how it tilts by what is pumped in it, " if within.intersection(steps) else ""
                remark = f"{remark} {tilts}wind, tag lines and how it swings"
                meaning = "loads that hang clear stay so until a step lowers them"
                yield Check("stays_clear", Verdict.WARNING, meaning, element=name, time=time, remark=remark)
                break


def _caught(recording: Recording) -> Iterator[Check]:
    """A warning for each load that is lowered onto what stands still, and comes clear of it further down.

    An edge caught it, and it slid off, or it swings against a side. What sets a load down and takes it up
    again hoists it or takes a support away; what lays one down turns it.
    """
    kinds = {step.step: step.acts_as for step in recording.rig.plan}
    lowers = _lowering(recording)
    spans = progress.spans(recording)
    removed = [one.removed_at for one in recording.rig.supports if one.removed_at is not None]
    raised = [begin for step, (begin, _) in spans.items() if kinds.get(step) == "hoist"]
    for load in recording.rig.loads:
        hangs, met, steps = hangs_from_the_start(recording, load), None, []
        for time, kind, name in recording.events():
            if name != load.name or kind not in ("lift_off", "set_down"):
                continue
            if kind == "set_down" and met is None and hangs:
                steps = [step for step, (begin, end) in spans.items() if begin < time <= end]
                stands = any(contact not in load.meets for contact in _met(recording, load, time))
                met = time if stands and any(step in lowers for step in steps) else None
            elif kind == "lift_off" and met is not None:
                if any(met < moment <= time for moment in raised + removed):
                    met = None
                elif _went_on(recording, load, met, time) > _WENT_ON:
                    where = progress.BESIDE.join(steps)
                    remark = (
                        f"it meets what is in its way in '{where}' and goes on down past it: an edge catches"
                    )
                    remark = f"{remark} it, or it swings against a side"
                    meaning = "loads that are lowered stay clear until they are set down"
                    check = Check("stays_clear", Verdict.WARNING, meaning, element=name, remark=remark)
                    yield replace(check, time=met)
                    break
            hangs = kind == "lift_off"


def _lowering(recording: Recording) -> set[str]:
    """Steps that lower a load, or that bring what it hangs from or stands over somewhere else."""
    within = _pumped_within(recording)
    return {one.step for one in recording.rig.plan if one.acts_as in _LOWERS and one.step not in within}


def _pumped_within(recording: Recording) -> set[str]:
    """Steps that pump from one tank of a load to another of it: that tilts it, and lowers it by nothing."""
    own = [set(load.tanks) for load in recording.rig.loads]
    pumps = [one for one in recording.rig.plan if one.pumps]
    return {one.step for one in pumps if any(tanks.issuperset(one.pumps) for tanks in own)}


def _went_on(recording: Recording, load: Load, begin: float, end: float) -> float:
    """How much lower the centre of gravity of a load is at the second time than at the first [m].

    0 of a load that is turned meanwhile: what is laid down about its foot goes down as it stands.
    """
    heights = np.interp((begin, end), recording.time, recording.column("body_position", load.body)[:, 2])
    tilts = np.interp((begin, end), recording.time, recording.column("load_tilt", load.name))
    return float(heights[0] - heights[1]) if abs(tilts[1] - tilts[0]) < _LAID else 0.0


def hit(recording: Recording) -> list[Check]:
    """A warning for each load that comes down hard on what is below it, the hardest time of it.

    Speeds are those of the centre of gravity at the sample before, against the deck that it meets.
    """
    checks = []
    for load in recording.rig.loads:
        down = [time for time, _, name in recording.events("set_down") if name == load.name]
        if not down:
            continue
        speeds = [_closing(recording, load, time) for time in down]
        worst = int(np.argmax(speeds))
        if speeds[worst] > _HARD:
            met, when = format_quantity(speeds[worst], "m/min", 1), down[worst]
            remark = f"it meets what is below it at {met}; {what_helps(recording, load, when)}"
            meaning = f"loads are set down with at most {format_quantity(_HARD, 'm/min', 0)}"
            check = Check("set_down_softly", Verdict.WARNING, meaning, element=load.name, remark=remark)
            checks.append(replace(check, time=float(down[worst])))
    return checks


def _met(recording: Recording, load: Load, time: float) -> list[str]:
    """Contacts of a load that bear at the first sample from a time [s] on at which any does."""
    after = int(np.searchsorted(recording.time, time, side="left"))
    forces = {contact: recording.column("contact_force", contact)[after:] for contact in load.contacts}
    bears = np.flatnonzero(np.any([force > 0.0 for force in forces.values()], axis=0))
    return [contact for contact, force in forces.items() if bears.size and force[bears[0]] > 0.0]


def _closing(recording: Recording, load: Load, time: float) -> float:
    """How fast a load comes down on what it meets at a time [m/s]; of several the one that it meets fastest.

    Which that is tell the contacts that bear at the first sample from then on at which any does.
    """
    before = max(int(np.searchsorted(recording.time, time, side="left")) - 1, 0)
    place = recording.column("body_position", load.body)[before]
    down = -float(recording.column("body_velocity", load.body)[before, 2])
    met = {load.meets.get(contact) for contact in _met(recording, load, time)}
    return down + max((_rise(recording, body, place, before) for body in met), default=0.0)


def _rise(recording: Recording, body: str | None, place: FloatArray, at: int) -> float:
    """How fast a body goes up below a place [m], at a sample [m/s]; 0 of the ground."""
    if body is None or body not in recording.coordinates["body"]:
        return 0.0
    position, velocity, spin = (
        recording.column(name, body)[at]
        for name in ("body_position", "body_velocity", "body_angular_velocity")
    )
    return float((velocity + np.cross(spin, place - position))[2])


def fell_behind(recording: Recording) -> list[Check]:
    """Hoists whose motor or brake pulled all it could while the drum did not follow.

    One that merely comes late is a warning. One whose hook runs down faster than it went as its drum began to
    slip lets the load go, however short that is: a failure.
    """
    return [
        check
        for drum in recording.rig.drums
        if drum.paid_out < 0.0 and not drum.flow and (check := _slipped(recording, drum)) is not None
    ]


def ran_out(recording: Recording) -> list[Check]:
    """A warning for each winch of `mechanics` or of a line that slips for longer than a second.

    It says the longest time. One of constant tension is meant to; of any other nothing else says that what
    hangs on it has come down, or that its vessel was not hauled as far as the plan has it.
    """
    drums = [drum.name for drum in recording.rig.drums if drum.paid_out > 0.0]
    out_of = {name: recording.column("rope_paid_out", name) for name in drums}
    slipping = [line.slipping_winch for line in recording.rig.mooring_lines]
    slipping += [line.slipping_winch for line in recording.rig.tag_lines]
    winches = [name for name in slipping if name is not None]
    out_of |= {name: recording.column("joint_position", name) for name in winches}
    checks = []
    for name, paid_out in out_of.items():
        spans = _slips(recording, name)
        begin, end = max(spans, key=lambda span: span[1] - span[0], default=(0.0, 0.0))
        if end - begin <= _LONG:
            continue
        out = np.interp((begin, end), recording.time, paid_out)
        remark = f"from {begin:.4g} s on, for {end - begin:.3g} s, motor or brake pull all they can"
        if out[1] - out[0] > _LOST:
            remark += f", and do not hold: {out[1] - out[0]:.2f} m of rope run out meanwhile"
        meaning = "drums of winches follow the plan"
        checks.append(Check("winch_follows", Verdict.WARNING, meaning, element=name, remark=remark))
    return checks


def _slips(recording: Recording, drum: str) -> list[tuple[float, float]]:
    """From when to when a drum slips against its motor or brake [s]; nothing before there are samples."""
    if not len(recording.time):
        return []
    begins = [time for time, _, name in recording.events("drum_slips") if name == drum]
    ends = [time for time, _, name in recording.events("drum_holds") if name == drum]
    # One that slips at the end of the run has not come to hold again.
    ends += [float(recording.time[-1])] * (len(begins) - len(ends))
    return list(zip(begins, ends, strict=True))


def _slipped(recording: Recording, drum: Drum) -> Check | None:
    check = Check("hoist_follows", Verdict.WARNING, "drums of hoists follow the plan", element=drum.name)
    ran_away = _ran_away(recording, drum)
    if ran_away > _LOST:
        began = f"it begins {ran_away:.2f} m below where the lift file has it"
        remark = (
            f"motor or brake do not hold what hangs before the lift begins, and the hook runs away: {began}"
        )
        return replace(check, verdict=Verdict.FAILED, time=float(recording.time[0]), remark=remark)
    spans = _slips(recording, drum.name)
    lost, since = max(((_lost(recording, drum, span), span[0]) for span in spans), default=(0.0, 0.0))
    lasted = sum(end - begin for begin, end in spans)
    if lost <= _LOST and lasted <= _LONG:
        return None
    remark = f"from {spans[0][0]:.4g} s on, for {lasted:.3g} s, motor or brake pull all they can"
    if lost <= _LOST:
        rise = sum(_risen(recording, drum, span) for span in spans)
        remark += f", while the hook goes {'down' if rise < 0.0 else 'up'} by {abs(rise):.2f} m"
        return replace(check, remark=remark)
    remark += f", and do not hold: the hook runs away, {lost:.2f} m lower than at the speed that it had"
    return replace(check, verdict=Verdict.FAILED, time=since, remark=remark)


def _risen(recording: Recording, drum: Drum, span: tuple[float, float]) -> float:
    """How far a hook goes up from the first to the last moment of a span of time [m]."""
    out = np.interp(span, recording.time, recording.column("rope_paid_out", drum.name))
    return float(out[1] - out[0]) / drum.paid_out


def _ran_away(recording: Recording, drum: Drum) -> float:
    """How far a hook comes down on the way to the rest in which a run begins [m]."""
    if recording.is_equilibrium or not len(recording.time):
        return 0.0
    return float(recording.column("rope_paid_out", drum.name)[0]) / -drum.paid_out


def _lost(recording: Recording, drum: Drum, span: tuple[float, float]) -> float:
    """How much further down a hook comes while its drum slips than at the speed with which that began [m]."""
    begin, end = span
    time, out = recording.time, recording.column("rope_paid_out", drum.name)
    last = int(np.searchsorted(time, begin, side="right")) - 1
    speed = max(0.0, float((out[last] - out[last - 1]) / (time[last] - time[last - 1]))) if last > 0 else 0.0
    inside = (time >= begin) & (time <= end)
    if not inside.any():
        return 0.0
    further = out[inside] - np.interp(begin, time, out) - speed * (time[inside] - begin)
    return float(further.max()) / -drum.paid_out
