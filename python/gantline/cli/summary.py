"""The final table of a lift, in the units and the order in which a lifting engineer reads it."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np

from gantline.checks import Check, Verdict, values_of
from gantline.checks.sling_figures import SlingFigures, sling_figures
from gantline.cli.chain_hoist_table import chain_hoist_table
from gantline.cli.check_table import check_table
from gantline.cli.compensator_table import compensator_table
from gantline.cli.ending import ending_lines
from gantline.cli.equalizer_table import equalizer_table
from gantline.cli.hinge_table import hinge_table
from gantline.cli.hold_points import hold_points
from gantline.cli.refinement import refinement_table
from gantline.cli.table import ABSENT, cut, pairs, show, table
from gantline.cli.vessels import vessels
from gantline.results import series
from gantline.results.alike import first_peak
from gantline.results.loads.contact_peaks import contact_peak
from gantline.results.loads.drift import load_drift
from gantline.results.loads.hook_peaks import hook_peak
from gantline.results.loads.hung_so import has_hung_so
from gantline.results.loads.lift_off import lift_off_in_words
from gantline.results.loads.set_down import set_down_in_words
from gantline.results.loads.upending import is_turned, kept_plumb_in_words, turning_in_words
from gantline.results.metrics import energy_bound
from gantline.results.recording import Recording
from gantline.results.refinement import refinement_of
from gantline.results.rig import Load, Rig
from gantline.results.ropes import upper_end
from gantline.results.ropes.parting import ATTACHED, partings

#: Slings that are listed one by one; the report and the recording have all of them.
_MOST_ROWS = 40
#: Yaw from which on the table tells it [rad].
_YAW_TO_TELL = math.radians(1.0)


def summary(
    recording: Recording, checks: list[Check], style: Callable[[Verdict], str], width: int = 100
) -> list[str]:
    """Lines of the final table.

    Args:
        recording: Of the lift.
        checks: What was checked.
        style: How a verdict is written (with colour on a terminal).
        width: Columns that a line of the checks may have.

    Returns:
        The lines.
    """
    rig = recording.rig
    metrics = recording.metrics()
    slings = sling_figures(recording, rig.slings)
    parts = [
        heading(rig),
        _loads(recording),
        cut(_slings(slings), _MOST_ROWS),
        _parted(recording),
        _put_on(recording),
        cut(_used(slings), _MOST_ROWS),
        chain_hoist_table(recording),
        *(equalizer_table(recording, equalizer) for equalizer in rig.equalizers),
        *(compensator_table(recording, compensator) for compensator in rig.compensators),
        *(hinge_table(recording, hinge) for hinge in rig.hinges),
        _hooks(recording),
        vessels(recording),
        _ropes(recording),
        _fenders(recording),
        _wraps(recording),
        _losses(recording),
        _drums(recording),
        hold_points(recording),
        check_table(checks, str(rig.limits.get("rule") or ""), style=style, width=width, full=False),
        refinement_table(refinement_of(recording)),
        _trust(recording, metrics),
        ending_lines(recording, width),
    ]
    return [line for part in parts if part for line in (*part, "")]


def heading(rig: Rig) -> list[str]:
    """Number, revision, title and remark of a lift, and the waves, the wind and the current that it is in."""
    revision = f" rev {rig.revision}" if rig.number and rig.revision else ""
    title = "  ".join(word for word in (f"{rig.number or ''}{revision}", rig.title) if word)
    waves = [] if rig.sea is None else [f"Waves: {'; '.join(train.in_words for train in rig.sea.trains)}"]
    wind = [] if rig.wind is None else [f"Wind: {rig.wind.in_words}"]
    current = [] if rig.current is None else [f"Current: {rig.current.in_words}"]
    return [*(line for line in (title, rig.remark) if line), *waves, *wind, *current]


def weights(rig: Rig) -> list[str]:
    """Weights of the loads as simulated, with what of the rigging is on them; calculated and design."""
    lines = []
    for load in rig.loads:
        own = load.simulated_mass or load.weight / rig.gravity
        text = f"Load {load.name}: simulated weight {show(own, 't', 1)}"
        # What slings and shackles lump on its lugs, as far as one reads it.
        rigging = show(load.weight / rig.gravity - own, "t", 1)
        beside = [] if rigging == show(0.0, "t", 1) else [f"{rigging} of rigging on it"]
        if load.tanks:
            liquid = sum(tank.content for tank in rig.tanks if tank.name in load.tanks)
            beside.append(f"{show(liquid, 't', 1)} in its tanks at the start")
        text += f", with {' and '.join(beside)}" if beside else ""
        if load.calculated_mass is not None and load.contingency is not None and load.design_mass is not None:
            calculated, design = show(load.calculated_mass, "t", 1), show(load.design_mass, "t", 1)
            text += f"; calculated {calculated} x contingency {load.contingency:.2f} = design {design}"
        lines.append(text)
    return lines


def _in_tanks(recording: Recording, load: Load) -> list[tuple[str, str]]:
    """What is in the tanks of a load, from the start to the end; nothing of one without tanks."""
    if not load.tanks:
        return []
    liquid = (series.load_weight(recording, load) - load.weight) / recording.rig.gravity
    first, last = (show(float(one), "t", 1) for one in (liquid[0], liquid[-1]))
    return [("in its tanks", f"{first} at the start, {last} at the end")]


def _loads(recording: Recording) -> list[str]:
    rows: list[tuple[str, str]] = []
    for load in recording.rig.loads:
        tilt = series.peak(recording, recording.column("load_tilt", load.name))
        transferred = recording.column("load_transferred", load.name)
        place = recording.column("body_position", load.body)
        rise = float(place[-1, 2] - place[0, 2])
        rows += [
            ("load transferred", f"{show(float(transferred[-1]), '%', 1)} at the end"),
            *_in_tanks(recording, load),
            ("tilt", f"{show(tilt[0], 'deg', 2)} at most, at {show(tilt[1], 's', 2)}" if tilt else ABSENT),
            *_yaw(recording, load),
            *(
                turning_in_words(recording, load, in_t=False)
                if is_turned(recording, load)
                else _drift(recording, load)
            ),
            ("height above start", f"{show(rise, 'm', 3)} at the end"),
        ]
        down = set_down_in_words(recording, load, 2)
        rows += [] if down is None else [("set down", down)]
    if not rows:
        return []
    rows += kept_plumb_in_words(recording)
    rows.insert(0, ("lift-off", lift_off_in_words(recording, 2)))
    return [*weights(recording.rig), *pairs("", rows)[1:]]


def _drift(recording: Recording, load: Load) -> list[tuple[str, str]]:
    """How far a load comes off its way as it hangs."""
    clear = series.load_is_clear(recording, load)
    most = show(float(load_drift(recording, load)[clear].max()), "m", 3) if clear.any() else None
    return [("drift when clear", ABSENT if most is None else f"{most} at most")]


def _yaw(recording: Recording, load: Load) -> list[tuple[str, str]]:
    """How far a load turns about plumb, if that is enough to speak of."""
    yaw = series.load_yaw(recording, load)
    most = None if yaw is None else series.peak(recording, np.abs(yaw))
    if most is None or most[0] <= _YAW_TO_TELL:
        return []
    return [("yaw from the start", f"{show(most[0], 'deg', 2)} at most, at {show(most[1], 's', 2)}")]


def _slings(figures: Sequence[SlingFigures]) -> list[str]:
    rows = [
        (
            one.sling.name,
            show(one.static, "kN", 1),
            show(one.peak, "kN", 1),
            show(one.peak_time, "s", 2),
            show(one.least_clear, "kN", 1),
            show(one.static_angle, "deg", 1),
            show(one.largest_angle, "deg", 1),
        )
        for one in figures
    ]
    head = ("Sling", "static", "peak", "at", "least clear", "angle", "largest")
    return table(head, rows, "lrrrrrr") if rows else []


def _parted(recording: Recording) -> list[str]:
    """Ropes that were cut, broke or were taken off."""
    rows = [
        (
            one.rope,
            one.kind,
            show(one.time, "s", 3),
            show(one.tension, "kN", 1),
            show(_share(one.tension, recording.rig.minimum_breaking_force(one.rope)), "%", 1),
        )
        for one in partings(recording)
    ]
    return (
        table(("Parted or off", "", "at", "tension", "of minimum breaking force"), rows, "llrrr")
        if rows
        else []
    )


def _put_on(recording: Recording) -> list[str]:
    """Slings that steps put on."""
    rows = [(rope, show(time, "s", 3)) for time, _, rope in recording.events(ATTACHED)]
    return table(("Put on", "at"), rows, "lr") if rows else []


def _used(figures: Sequence[SlingFigures]) -> list[str]:
    """What each sling uses of its rope, shackles and lug."""
    rows = [
        (
            one.sling.name,
            show(one.of_breaking_force, "%", 1),
            show(one.of_working_load_limit, "%", 1),
            show(one.of_lug_capacity, "%", 1),
            show(one.out_of_plane, "deg", 1),
        )
        for one in figures
    ]
    if not any(cell != ABSENT for row in rows for cell in row[1:]):
        return []
    head = (
        "Used",
        "of minimum breaking force (peak)",
        "of working load limit (static)",
        "of lug capacity",
        "out of plane",
    )
    return table(head, rows, "lrrrr")


def _share(force: float | None, of: float | None) -> float | None:
    return None if force is None or not of else force / of


def _hooks(recording: Recording) -> list[str]:
    shares = values_of(recording, "hoist_load_of_rated_capacity")
    rows = []
    for hook in recording.rig.hooks:
        for name in ("hook_load", "hoist_load"):
            force = recording.column(name, hook.name)
            static, _ = series.greatest_static(recording, force)
            highest, time = hook_peak(recording, hook.name, name)
            is_dynamic = bool(static) and has_hung_so(recording, time)
            is_rated_for = name == ("hoist_load" if hook.rating_includes_hook_block else "hook_load")
            used = shares.get(hook.name) if is_rated_for else None
            rows.append(
                (
                    hook.name if name == "hook_load" else "",
                    name.replace("_", " "),
                    show(static, "kN", 1),
                    show(highest, "kN", 1),
                    show(time, "s", 2),
                    f"{highest / static:.3f}" if static and is_dynamic else ABSENT,
                    show(used, "%", 1),
                )
            )
    if not rows:
        return []
    head = ("Hook", "", "static", "peak", "at", "dynamic factor", "of rated capacity")
    return table(head, rows, "llrrrrr")


def _ropes(recording: Recording) -> list[str]:
    """Ropes that no other part of the table shows: those of `mechanics`."""
    shown = {sling.rope for sling in recording.rig.slings}
    shown |= {equalizer.equalizing_rope for equalizer in recording.rig.equalizers}
    shown |= {compensator.gas for compensator in recording.rig.compensators}
    rows: list[tuple[str, ...]] = []
    for rope in recording.coordinates.get("rope", ()):
        if rope in shown:
            continue
        force, time = series.rope_peak(recording, rope)
        last = float(recording.column("rope_tension", rope)[-1])
        unit, digits = ("kN", 1) if force >= 1e3 else ("N", 3)
        used = show(upper_end.utilisation(recording, rope), "%", 1)
        rows.append((rope, show(last, unit, digits), show(force, unit, digits), show(time, "s", 2), used))
    head: tuple[str, ...] = ("Rope", "at the end", "peak", "at", "of minimum breaking force (peak)")
    if all(row[-1] == ABSENT for row in rows):  # nothing to say in a column of dashes
        head, rows = head[:-1], [row[:-1] for row in rows]
    return table(head, rows, "l" + "r" * (len(head) - 1)) if rows else []


def _fenders(recording: Recording) -> list[str]:
    """What vessels press on fenders with, over all steps."""
    rows: list[tuple[str, ...]] = []
    for fender in recording.rig.fenders:
        force = recording.column("fender_force", fender.name)
        peak, time = contact_peak(recording, fender.contact)
        last = show(float(force[-1]), "kN", 1)
        used = show(fender.used_by(peak), "%", 1)
        rows.append((fender.name, last, show(peak, "kN", 1), show(time, "s", 2), used))
    head = ("Fender", "at the end", "peak", "at", "of capacity (peak)")
    return table(head, rows, "lrrrr") if rows else []


def _wraps(recording: Recording) -> list[str]:
    """Sheaves with true tangents: over which angle the rope lies on them, and how far it runs askew."""
    rows = []
    for sheave in recording.rig.wrapped_sheaves:
        wrap = recording.column("wrap_angle", sheave.name)
        carrying = series.is_carrying(recording.column("rope_tension", sheave.rope))
        fleet = series.peak(recording, series.fleet_angle(recording, sheave), carrying)
        angles = (show(float(wrap.min()), "deg", 1), show(float(wrap.max()), "deg", 1))
        largest = (show(fleet[0], "deg", 2), show(fleet[1], "s", 2)) if fleet else (ABSENT, ABSENT)
        rows.append((sheave.name, *angles, *largest))
    head = ("Sheave", "least wrap", "largest wrap", "largest fleet angle", "at")
    return table(head, rows, "lrrrr") if rows else []


def _losses(recording: Recording) -> list[str]:
    """What losses of sheaves do to each rope: its worst sheave, and how far its segments differ."""
    lossy = [sheave for sheave in recording.rig.sheaves if sheave.has_losses]
    rows = []
    for rope in dict.fromkeys(sheave.rope for sheave in lossy):
        own = [sheave for sheave in lossy if sheave.rope == rope]
        ratios = {sheave.name: series.tension_ratio(recording, sheave) for sheave in own}
        worst = own[first_peak([float(ratios[sheave.name].max()) for sheave in own])]
        ratio = ratios[worst.name]
        at = first_peak(ratio)
        force = np.array([recording.column("sheave_tension", sheave.name)[-1] for sheave in own])
        unit, digits = ("kN", 1) if force.max() >= 1e3 else ("N", 3)
        rows.append(
            (
                rope,
                f"{float(ratio.max()):.4f}",
                f"{float(series.slip_ratio(recording, worst)[at]):.4f}",
                worst.name,
                show(float(recording.time[at]), "s", 2),
                show(float(force.min()), unit, digits),
                show(float(force.max()), unit, digits),
            )
        )
    head = (
        "Rope with losses",
        "worst ratio at a sheave",
        "slips from",
        "",
        "at",
        "least at the end",
        "largest",
    )
    return table(head, rows, "lrrlrrr") if rows else []


def _drums(recording: Recording) -> list[str]:
    """What drums paid out, and where one is rated what its ropes use of that."""
    used = values_of(recording, "drum_load_of_rated_capacity")
    rows = []
    for drum in recording.rig.drums:
        paid_out = recording.column("rope_paid_out", drum.name)
        extremes = (show(float(paid_out[-1]), "m", 3), show(float(paid_out.min()), "m", 3))
        fewest = recording.metrics().get(f"least_drum_wraps.{drum.name}")
        turns = ABSENT if fewest is None else f"{fewest:.1f}"
        row = (drum.name, *extremes, show(float(paid_out.max()), "m", 3), turns)
        of_ropes = [
            used[name]
            for name in (drum.joint, *(f"{drum.joint}/{rope}" for rope in drum.ropes))
            if name in used
        ]
        rows.append((*row, show(max(of_ropes, default=None), "%", 1)) if used else row)
    head = ("Drum", "rope paid out at the end", "least", "most", "fewest turns")
    rated = ("of rated capacity",) if used else ()
    return table((*head, *rated), rows, "l" + "r" * (len(head) + len(rated) - 1)) if rows else []


def _trust(recording: Recording, metrics: dict[str, float]) -> list[str]:
    remainder = metrics.get("energy_remainder")
    lines = []
    if remainder is not None:
        bound = energy_bound(recording.attributes["settings"])
        verdict = "the balance closes" if remainder <= bound else "THE BALANCE DOES NOT CLOSE"
        size = f"{remainder:.1e} of the largest energy" if remainder > 0.0 else "within rounding"
        lines.append(f"Energy remainder {size}, bound {bound:.0e}: {verdict}")
    warnings = recording.attributes.get("warnings") or []
    return lines + [f"Warning: {warning}" for warning in warnings]
