"""Rows of the first page: how a load hangs, drifts, swings, and what it comes near."""

from __future__ import annotations

import numpy as np

from gantline.checks import values_of
from gantline.report.subject import ABSENT, Subject, show, typeset
from gantline.results import series
from gantline.results.alike import first_peak
from gantline.results.loads.clearances import watched_during
from gantline.results.loads.contact_peaks import guide_peak
from gantline.results.loads.drift import load_drift
from gantline.results.loads.guides import told_missed
from gantline.results.loads.hinge_peaks import hinge_peak
from gantline.results.loads.hinges import hinge_force
from gantline.results.loads.lift_off import lift_off_in_words
from gantline.results.loads.set_down import set_down_in_words
from gantline.results.loads.upending import is_turned, kept_plumb_in_words, turning_in_words
from gantline.results.rig import Load
from gantline.units import length_digits, telling_digits


def attitude(subject: Subject, told: str = "") -> list[tuple[str, str]]:
    """Wind, lift-off, tilt, yaw, drift, swing, set-down and tightest clearance, in words.

    The tightest clearance is left out where it is that of a pair of which all is `told` elsewhere.
    """
    recording = subject.recording
    rows = _wind(subject)
    if subject.rig.current is not None:
        rows.append(("current", subject.rig.current.in_words))
    lift_off = subject.metrics.get("lift_off_time")
    if any(load.contacts for load in subject.rig.loads) and not recording.is_equilibrium:
        rows.append(("lift-off", lift_off_in_words(recording, 1)))
    for load in subject.rig.loads:
        rows += _of_load(subject, load, lift_off)
    rows += [(what, typeset(words)) for what, words in kept_plumb_in_words(recording)]
    rows += _hinges(subject)
    rows += _tag_lines(subject)
    rows += _guides(subject)
    tightest = tightest_clearance(subject)
    if tightest is not None and tightest[0] != told:
        rows.append(("tightest clearance", " ".join(tightest)))
    return rows


def _wind(subject: Subject) -> list[tuple[str, str]]:
    """The wind of the lift file, and what of gusts came to each load."""
    wind, recording = subject.rig.wind, subject.recording
    if wind is None:
        return []
    rows = [("wind", wind.in_words)]
    if "wind_at_load" in recording and len(recording.time):
        for load in subject.rig.loads:
            speed = recording.column("wind_at_load", load.name)[subject.counts]
            ends = f"{show(float(speed.min()), 'm/s', 1)} to {show(float(speed.max()), 'm/s', 1)}"
            rows.append((f"wind at {load.name}", ends))
    return rows


def _of_load(subject: Subject, load: Load, lift_off: float | None) -> list[tuple[str, str]]:
    recording = subject.recording
    if load.body not in recording.coordinates.get("body", ()):
        return []
    tilt = subject.peak(recording.column("load_tilt", load.name))
    place = recording.column("body_position", load.body)
    drift = load_drift(recording, load)
    clear = series.load_is_clear(recording, load) & subject.counts
    rows = [("largest tilt", _peak(tilt) if tilt else ABSENT)]
    turned = series.load_yaw(recording, load)
    yaw = None if turned is None else subject.peak(np.abs(turned))
    if yaw is not None:
        rows.append(("largest yaw from the start", _peak(yaw)))
    if lift_off is not None:
        at = min(int(np.searchsorted(recording.time, lift_off)), len(drift) - 1)
        rows.append(("drift at lift-off", show(float(drift[at]), "m", 3)))
    swing = _swing_after_travel(subject, load)
    if swing is not None:
        rows.append((f"swing after the last {swing[0]}", show(swing[1], "m", 3)))
    if is_turned(recording, load):
        rows += turning_in_words(recording, load, in_t=True)
    elif clear.any():
        rows.append(("largest drift when clear", show(float(drift[clear].max()), "m", 3)))
    rows.append(("height gained", show(float(place[-1, 2] - place[0, 2]), "m", 2)))
    down = set_down_in_words(recording, load, 1)
    return rows if down is None else [*rows, ("set down", typeset(down))]


def _peak(found: tuple[float, float]) -> str:
    """The largest of an angle and when that was; no time of what rounds to nothing."""
    angle = show(found[0], "deg", 2)
    return angle if angle == show(0.0, "deg", 2) else f"{angle} at {show(found[1], 's', 1)}"


def _hinges(subject: Subject) -> list[tuple[str, str]]:
    """What hinges bear at most, as the section on them has it, and the share of their rated capacity."""
    used = values_of(subject.recording, "hinge_force_of_rated_capacity") if subject.rig.hinges else {}
    rows = []
    for hinge in subject.rig.hinges:
        if subject.counts.any():
            found = hinge_peak(subject.recording, hinge, hinge_force, subject.counts)
            of = f", {show(used[hinge.name], '%', 0)} of rated" if hinge.name in used else ""
            force = f"{show(found[0], 'kN', 1)} at {show(found[1], 's', 1)}"
            rows.append((f"largest force in {hinge.name}", f"{force}{of}"))
    return rows


def _tag_lines(subject: Subject) -> list[tuple[str, str]]:
    """What the tag lines pull with at most."""
    pulls = [(*series.rope_peak(subject.recording, line.rope), line.name) for line in subject.rig.tag_lines]
    if not pulls:
        return []
    force, time, name = pulls[first_peak([one[0] for one in pulls])]
    return [("largest pull of a tag line", f"{name} {show(force, 'kN', 1)} at {show(time, 's', 1)}")]


def _guides(subject: Subject) -> list[tuple[str, str]]:
    """Landing guides that the load missed, and what they bear at most, of the weight that they guide too."""
    rig = subject.rig
    weights = {load.name: load.weight for load in rig.loads}
    presses = [(guide_peak(subject.recording, guide), guide) for guide in rig.guides]
    if not presses:
        return []
    missed = told_missed(rig.guides, map(str, subject.recording.attributes.get("warnings") or ()))
    rows = [("missed by the load", f"guide{'s' * (len(missed) > 1)} {', '.join(missed)}")] if missed else []
    (force, time), guide = presses[first_peak([one[0][0] for one in presses])]
    if force == 0.0:
        return [*rows, ("largest force of a guide", "none is touched")]
    text = f"{guide.name} {show(force, 'kN', 1)} at {show(time, 's', 1)}"
    shares = [f"{show(force / weights[guide.load], '%', 1)} of the weight"]
    # Raised to the design weight, as the check has it.
    used = values_of(subject.recording, "guide_force_of_capacity")
    shares += [f"{show(used[guide.name], '%', 0)} of capacity"] if guide.name in used else []
    return [*rows, ("largest force of a guide", f"{text}, {', '.join(shares)}")]


#: Steps after which a load swings, and hangs where it was taken.
_TAKES = ("traverse", "travel", "lead")


def _swing_after_travel(subject: Subject, load: Load) -> tuple[str, float] | None:
    """Kind of the last step that takes a load along, and the largest swing after it [m]; None without."""
    recording = subject.recording
    swings = "load_swing" in recording and not recording.is_equilibrium
    if not swings or load.name not in recording.coordinates.get("load", ()):
        return None
    goes = {step.step: step.kind for step in subject.rig.plan if step.kind in _TAKES}
    ends = [(time, goes[name]) for time, _, name in recording.events("step_end") if name in goes]
    if not ends:
        return None
    last, kind = max(ends)
    after = recording.time >= last
    return (kind, float(recording.column("load_swing", load.name)[after].max())) if after.any() else None


def tightest_clearance(subject: Subject) -> tuple[str, str] | None:
    """The watched pair nearest to what it has to keep, as the checks have it; how near it is, and when."""
    recording = subject.recording
    pairs = recording.coordinates.get("pair", ())
    if "clearance" not in recording or not pairs:
        return None
    watches = {watch.name: watch for watch in subject.rig.watches}
    watched = {name: watched_during(recording, watch) for name, watch in watches.items()}
    keeps = np.array([watches[name].smallest if name in watches else 0.0 for name in pairs])
    during = np.stack([watched.get(name, np.ones(len(recording.time), bool)) for name in pairs], axis=1)
    during &= subject.counts[:, np.newaxis]
    distance = np.where(during, recording["clearance"].values, np.inf)
    if not np.isfinite(distance).any():
        return None
    at, pair = np.unravel_index(int(np.argmin(distance - keeps)), distance.shape)
    time = float(recording.time[at])
    step = subject.step_at(time)
    place = f" at {show(time, 's', 1)}" + (f", “{step}”" if step else "")
    apart = float(distance[at, pair])
    digits = length_digits(apart)
    found = show(
        apart, "m", telling_digits(apart, keeps[pair], "m", digits) if apart < keeps[pair] else digits
    )
    least = f", at least {keeps[pair]:g} m," if keeps[pair] > 0.0 else ""
    return pairs[pair], f"{found}{least}{place}"
