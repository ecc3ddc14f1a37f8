"""The final table of a lift, in the units and the order in which a lifting engineer reads it."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from gantline.checks import Check, Verdict, values_of
from gantline.cli.check_table import check_table
from gantline.cli.table import ABSENT, pairs, table
from gantline.cli.vessels import vessels
from gantline.results import series
from gantline.results.equalising import equalising
from gantline.results.gear import Equalizer
from gantline.results.metrics import energy_bound, metrics_of
from gantline.results.parting import partings, stops_met
from gantline.results.recording import Recording
from gantline.results.rig import Rig
from gantline.units import format_quantity


def show(value: float | None, unit: str, digits: int) -> str:
    """A value with its unit, or a dash."""
    return ABSENT if value is None else format_quantity(value, unit, digits)


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
    metrics = metrics_of(recording)
    parts = [
        heading(rig),
        _loads(recording, metrics),
        _slings(recording),
        _parted(recording),
        _used(recording),
        *(_equalizer(recording, equalizer) for equalizer in rig.equalizers),
        _hooks(recording),
        vessels(recording),
        _ropes(recording),
        _wraps(recording),
        _losses(recording),
        _drums(recording),
        _hold_points(recording),
        check_table(checks, str(rig.limits.get("rule") or ""), style=style, width=width, full=False),
        _trust(recording, metrics),
    ]
    return [line for part in parts if part for line in (*part, "")]


def heading(rig: Rig) -> list[str]:
    """Number, revision, title and remark of a lift."""
    revision = f" rev {rig.revision}" if rig.number and rig.revision else ""
    title = "  ".join(word for word in (f"{rig.number or ''}{revision}", rig.title) if word)
    return [line for line in (title, rig.remark) if line]


def weights(rig: Rig) -> list[str]:
    """Weights of the loads, calculated and design."""
    lines = []
    for load in rig.loads:
        text = f"Load {load.name}: simulated weight {show(load.weight / rig.gravity, 't', 1)}"
        if load.calculated_mass is not None and load.contingency is not None and load.design_mass is not None:
            calculated, design = show(load.calculated_mass, "t", 1), show(load.design_mass, "t", 1)
            text += f"; calculated {calculated} x contingency {load.contingency:.2f} = design {design}"
        lines.append(text)
    return lines


def _loads(recording: Recording, metrics: dict[str, float]) -> list[str]:
    rows: list[tuple[str, str]] = []
    for load in recording.rig.loads:
        tilt = series.peak(recording, recording.column("load_tilt", load.name))
        transferred = recording.column("load_transferred", load.name)
        clear = series.load_is_clear(recording, load)
        place = recording.column("body_position", load.body)
        drift = np.linalg.norm(place[:, :2] - place[0, :2], axis=1)
        rise = float(place[-1, 2] - place[0, 2])
        rows += [
            ("load transferred", f"{show(float(transferred[-1]), '%', 1)} at the end"),
            ("tilt", f"{show(tilt[0], 'deg', 2)} at most, at {show(tilt[1], 's', 2)}" if tilt else ABSENT),
            (
                "drift when clear",
                f"{show(float(drift[clear].max()), 'm', 3)} at most" if clear.any() else ABSENT,
            ),
            ("height above start", f"{show(rise, 'm', 3)} at the end"),
        ]
    if not rows:
        return []
    lift_off = metrics.get("lift_off_time")
    rows.insert(
        0,
        ("lift-off", f"at {show(lift_off, 's', 2)}" if lift_off is not None else "never clear of a support"),
    )
    return [*weights(recording.rig), *pairs("", rows)[1:]]


def _slings(recording: Recording) -> list[str]:
    clear = series.is_clear(recording)
    window = series.quiet_window(recording)
    rows = []
    for sling in recording.rig.slings:
        tension = series.sling_tension(recording, sling)
        force, time = series.rope_peak(recording, sling.rope)
        angle = series.sling_angle(recording, sling)
        carrying = series.is_carrying(tension)
        rows.append(
            (
                sling.name,
                show(series.static_value(recording, tension, window), "kN", 1),
                show(force, "kN", 1),
                show(time, "s", 2),
                show(float(tension[clear].min()) if clear.any() else None, "kN", 1),
                show(series.static_value(recording, angle, window), "deg", 1),
                show(float(angle[carrying].max()) if carrying.any() else None, "deg", 1),
            )
        )
    head = ("Sling", "static", "peak", "at", "least clear", "angle", "largest")
    return table(head, rows, "lrrrrrr") if rows else []


def _parted(recording: Recording) -> list[str]:
    """Ropes that were cut or broke."""
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
    return table(("Parted", "", "at", "tension", "of minimum breaking force"), rows, "llrrr") if rows else []


def _used(recording: Recording) -> list[str]:
    """What each sling uses of its rope, shackles and lug."""
    shackles = values_of(recording, "shackle_load_of_working_load_limit")
    lugs = values_of(recording, "lug_load_of_capacity")
    aside = values_of(recording, "lug_out_of_plane_angle")
    rows = []
    for sling in recording.rig.slings:
        leads = [f"{sling.to_load}.{lug}" for lug in sling.lugs if lug is not None]
        own = [shackles[name] for end in sling.shackles if (name := f"{sling.name} {end}") in shackles]
        force = series.rope_peak(recording, sling.rope)[0]
        rows.append(
            (
                sling.name,
                show(_share(force, sling.minimum_breaking_force), "%", 1),
                show(max(own, default=None), "%", 1),
                show(max((lugs[lug] for lug in leads if lug in lugs), default=None), "%", 1),
                show(max((aside[lug] for lug in leads if lug in aside), default=None), "deg", 1),
            )
        )
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


def _equalizer(recording: Recording, equalizer: Equalizer) -> list[str]:
    rows: list[tuple[str, str]] = []
    if equalizer.mechanism == "approximated":
        rows += _lengthening(recording, equalizer)
    if equalizer.equalizing_rope:
        rope = equalizer.equalizing_rope
        force, time = series.rope_peak(recording, rope)
        static = series.static_value(recording, recording.column("rope_tension", rope))
        rows.append(
            (
                "equalizing rope",
                f"{show(static, 'kN', 1)} static, {show(force, 'kN', 1)} peak at {show(time, 's', 2)}"
                f"{_of_breaking_force(recording, rope)}",
            )
        )
    clear = series.is_clear(recording)
    if equalizer.slings and clear.any():
        spread = series.tension_spread(recording, equalizer)
        most, last = float(spread[clear].max()), float(spread[-1])
        rows.append(
            ("tension spread", f"{show(most, '%', 2)} at most when clear, {show(last, '%', 2)} at the end")
        )
    rows += _equalising(recording, equalizer)
    rows += _pins(recording, equalizer)
    met = [one for one in stops_met(recording.events()) if one.joint in equalizer.moving_sheaves]
    rows += [("stop met", f"{one.joint} at {show(one.time, 's', 2)}{_again(one.times)}") for one in met]
    rows += [
        (f"travel used {way}", _travel(recording, equalizer, sign, stroke))
        for way, sign, stroke in (("up", -1.0, equalizer.travel_up), ("down", 1.0, equalizer.travel_down))
        if stroke and equalizer.moving_sheaves and equalizer.mechanism == "sheaves"
    ]
    return pairs(f"Equalizer {equalizer.name}", rows) if rows else []


def _equalising(recording: Recording, equalizer: Equalizer) -> list[tuple[str, str]]:
    """How long it took until the slings carry alike, where all of them have ever been taut."""
    found = equalising(recording, equalizer)
    if not equalizer.slings:
        return []
    bound = show(recording.rig.equalised_below, "%", 0 if recording.rig.equalised_below >= 0.01 else 2)
    if found is None:
        return [("time to equalise", f"{ABSENT}, the spread does not end below {bound} with all slings taut")]
    text = f"{show(found.time, 's', 2)} to a spread below {bound}, from {show(found.begin, 's', 2)} on"
    return [("time to equalise", text)]


def _pins(recording: Recording, equalizer: Equalizer) -> list[tuple[str, str]]:
    """What its locking pins held, and when they were pulled and put in."""
    pins = [pin for pin in recording.coordinates.get("pin", ()) if pin in equalizer.moving_sheaves]
    if not pins:
        return []
    force = {pin: np.abs(recording.column("pin_force", pin)) for pin in pins}
    pin = max(pins, key=lambda name: float(force[name].max()))
    time = float(recording.time[int(force[pin].argmax())])
    text = f"{show(float(force[pin].max()), 'kN', 1)} at most ({pin} at {show(time, 's', 2)})"
    for kind, words in (("pin_pulled", "pulled"), ("pin_put_in", "put in")):
        times = sorted({when for when, _, name in recording.events(kind) if name in pins})
        if times:
            text += f", {words} at {' and '.join(show(when, 's', 2) for when in times)}"
    return [("locking pins", text)]


def _again(times: int) -> str:
    return f", {times} times in all" if times > 1 else ""


def _of_breaking_force(recording: Recording, rope: str) -> str:
    share = series.utilisation(recording, rope)
    return "" if share is None else f", {show(share, '%', 1)} of minimum breaking force"


def _lengthening(recording: Recording, equalizer: Equalizer) -> Iterator[tuple[str, str]]:
    """What takes the place of travel where lengths are adjusted."""
    factor = f", adjusting factor {equalizer.adjusting_factor:g}" if equalizer.adjusting_factor else ""
    yield "mechanism", f"approximated{factor}: no sheave moves, slings change their length"
    change = {rope: recording.column("rope_lengthening", rope) for rope in equalizer.slings}
    for title, sign in (("longer", 1.0), ("shorter", -1.0)):
        rope = max(change, key=lambda name: float((sign * change[name]).max()))
        curve = sign * change[rope]
        most, time = float(curve.max()), float(recording.time[int(curve.argmax())])
        sling = rope.removeprefix("sling.")
        yield title, f"{show(most, 'm', 3)} at most ({sling} at {show(time, 's', 2)}), not limited"


def _travel(recording: Recording, equalizer: Equalizer, sign: float, stroke: float) -> str:
    travel = {sheave: sign * recording.column("sheave_travel", sheave) for sheave in equalizer.moving_sheaves}
    sheave = max(travel, key=lambda name: float(travel[name].max()))
    furthest = max(0.0, float(travel[sheave].max()))
    time = float(recording.time[int(travel[sheave].argmax())])
    text = f"{show(furthest / stroke, '%', 1)} of {show(stroke, 'm', 3)} ({sheave} at {show(time, 's', 2)})"
    clear = series.is_clear(recording)
    if clear.any():
        furthest = max(0.0, *(float(values[clear].max()) for values in travel.values()))
        text += f", {show(furthest / stroke, '%', 1)} when clear"
    return f"{text}, margin {show(stroke - furthest, 'mm', 0)}"


def _hooks(recording: Recording) -> list[str]:
    window = series.quiet_window(recording)
    shares = values_of(recording, "hoist_load_of_rated_capacity")
    rows = []
    for hook in recording.rig.hooks:
        for name in ("hook_load", "hoist_load"):
            force = recording.column(name, hook.name)
            static = series.static_value(recording, force, window)
            highest, time = float(force.max()), float(recording.time[int(force.argmax())])
            is_rated_for = name == ("hoist_load" if hook.rating_includes_hook_block else "hook_load")
            used = shares.get(hook.name) if is_rated_for else None
            rows.append(
                (
                    hook.name if name == "hook_load" else "",
                    name.replace("_", " "),
                    show(static, "kN", 1),
                    show(highest, "kN", 1),
                    show(time, "s", 2),
                    ABSENT if not static else f"{highest / static:.3f}",
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
    rows: list[tuple[str, ...]] = []
    for rope in recording.coordinates.get("rope", ()):
        if rope in shown:
            continue
        force, time = series.rope_peak(recording, rope)
        last = float(recording.column("rope_tension", rope)[-1])
        unit, digits = ("kN", 1) if force >= 1e3 else ("N", 3)
        used = show(series.utilisation(recording, rope), "%", 1)
        rows.append((rope, show(last, unit, digits), show(force, unit, digits), show(time, "s", 2), used))
    head: tuple[str, ...] = ("Rope", "at the end", "peak", "at", "of minimum breaking force (peak)")
    if all(row[-1] == ABSENT for row in rows):  # nothing to say in a column of dashes
        head, rows = head[:-1], [row[:-1] for row in rows]
    return table(head, rows, "l" + "r" * (len(head) - 1)) if rows else []


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
        worst = max(own, key=lambda sheave: float(ratios[sheave.name].max()))
        ratio = ratios[worst.name]
        force = np.array([recording.column("sheave_tension", sheave.name)[-1] for sheave in own])
        unit, digits = ("kN", 1) if force.max() >= 1e3 else ("N", 3)
        rows.append(
            (
                rope,
                f"{float(ratio.max()):.4f}",
                f"{float(series.slip_ratio(recording, worst)[int(ratio.argmax())]):.4f}",
                worst.name,
                show(float(recording.time[int(ratio.argmax())]), "s", 2),
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
    rows = []
    for drum in recording.rig.drums:
        paid_out = recording.column("rope_paid_out", drum.name)
        extremes = (show(float(paid_out[-1]), "m", 3), show(float(paid_out.min()), "m", 3))
        fewest = recording.metrics().get(f"least_drum_wraps.{drum.name}")
        turns = "" if fewest is None else f"{fewest:.1f}"
        rows.append((drum.name, *extremes, show(float(paid_out.max()), "m", 3), turns))
    head = ("Drum", "rope paid out at the end", "least", "most", "fewest turns")
    return table(head, rows, "lrrrr") if rows else []


def _hold_points(recording: Recording) -> list[str]:
    from gantline.checks import end_of_step

    lines: list[str] = []
    for step in recording.rig.plan:
        at = end_of_step(recording, step.step) if step.report else None
        if at is None:
            continue
        sample = int(np.argmax(at))
        measured = {measure: ", ".join(_measure(recording, measure, sample)) for measure in step.report}
        rows = [(measure.replace("_", " "), text) for measure, text in measured.items() if text]
        lines += pairs(f"At the end of '{step.step}', {show(float(recording.time[sample]), 's', 2)}", rows)
    return lines


def _measure(recording: Recording, measure: str, sample: int) -> Iterator[str]:
    """Values of a measure that a step reports, at one sample."""
    rig = recording.rig
    hooks = {hook.name: hook.name for hook in rig.carried_hooks}
    at_booms = {hook.name: hook.name for boom in rig.booms for hook in boom.hooks}
    sources: dict[str, tuple[str, str, int, dict[str, str]]] = {
        "sling_tension": ("rope_tension", "kN", 1, {sling.name: sling.rope for sling in rig.slings}),
        "equalizing_rope_tension": (
            "rope_tension",
            "kN",
            1,
            {e.name: e.equalizing_rope for e in rig.equalizers},
        ),
        "equalizer_travel": (
            "sheave_travel",
            "m",
            3,
            {s: s for e in rig.equalizers for s in e.moving_sheaves},
        ),
        "hook_load": ("hook_load", "kN", 1, {hook.name: hook.name for hook in rig.hooks}),
        "hoist_load": ("hoist_load", "kN", 1, {hook.name: hook.name for hook in rig.hooks}),
        "load_tilt": ("load_tilt", "deg", 2, {load.name: load.name for load in rig.loads}),
        "load_transferred": ("load_transferred", "%", 1, {load.name: load.name for load in rig.loads}),
        "load_swing": ("load_swing", "m", 3, {load.name: load.name for load in rig.loads if hooks}),
        "hook_height": ("hook_height", "m", 3, hooks),
        "falls_out_of_plumb": ("falls_out_of_plumb", "deg", 3, hooks),
        "off_lead": ("off_lead", "deg", 3, at_booms),
        "side_lead": ("side_lead", "deg", 3, at_booms),
        "crane_radius": ("crane_radius", "m", 2, at_booms),
        "boom_angle": ("boom_angle", "deg", 2, {boom.name: boom.name for boom in rig.booms}),
        "luffing_pull": ("luffing_pull", "kN", 0, {boom.name: boom.name for boom in rig.booms if boom.ropes}),
        "corner_load": (
            "corner_load",
            "kN",
            0,
            {name: name for crane in rig.cranes for name in crane.corners},
        ),
        "ground_pressure": (
            "ground_pressure",
            "kPa",
            1,
            {name: name for crane in rig.crawlers for name in crane.corners},
        ),
        "tipping_utilisation": (
            "tipping_utilisation",
            "%",
            1,
            {crane.name: crane.name for crane in rig.crawlers},
        ),
    }
    afloat = {vessel.name: vessel.name for vessel in rig.vessels}
    of_vessels = (("draft", "m", 3), ("heel", "deg", 2), ("trim", "deg", 2), ("freeboard", "m", 2))
    sources |= {name: (f"vessel_{name}", unit, digits, afloat) for name, unit, digits in of_vessels}
    if measure not in sources:
        yield "not known here"
        return
    variable, unit, digits, names = sources[measure]
    for name, label in names.items():
        if label:
            yield f"{name} {show(float(recording.column(variable, label)[sample]), unit, digits)}"


def _trust(recording: Recording, metrics: dict[str, float]) -> list[str]:
    remainder = metrics.get("energy_remainder")
    lines = []
    if remainder is not None:
        bound = energy_bound(recording.attributes["settings"])
        verdict = "the balance closes" if remainder <= bound else "THE BALANCE DOES NOT CLOSE"
        lines.append(f"Energy remainder {remainder:.1e} of the largest energy, bound {bound:.0e}: {verdict}")
    warnings = recording.attributes.get("warnings") or []
    return lines + [f"Warning: {warning}" for warning in warnings]
