"""What the final table says of one equalizer."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from gantline.cli.table import ABSENT, pairs, show
from gantline.results import series
from gantline.results.alike import first_peak
from gantline.results.gear import Equalizer
from gantline.results.recording import Recording
from gantline.results.ropes import upper_end
from gantline.results.ropes.equalising import equalising
from gantline.results.ropes.parting import stops_met
from gantline.results.ropes.travel import Way, most_used, ways_of


def equalizer_table(recording: Recording, equalizer: Equalizer) -> list[str]:
    """Tension, spread, time to equalise, pins, stops and travel of an equalizer; empty without any."""
    rows: list[tuple[str, str]] = []
    if equalizer.mechanism == "approximated":
        rows += _lengthening(recording, equalizer)
    if equalizer.equalizing_rope:
        rope = equalizer.equalizing_rope
        force, time = series.rope_peak(recording, rope)
        static, _ = series.greatest_static(recording, recording.column("rope_tension", rope))
        rows.append(
            (
                "equalizing rope",
                f"{show(static, 'kN', 1)} static, {show(force, 'kN', 1)} peak at {show(time, 's', 2)}"
                f"{of_breaking_force(recording, rope)}",
            )
        )
    clear = series.is_clear(recording)
    if equalizer.slings and clear.any():
        most = series.spread_when_clear(recording, equalizer)
        last = float(series.tension_spread(recording, equalizer)[-1])
        rows.append(
            ("tension spread", f"{show(most, '%', 2)} at most when clear, {show(last, '%', 2)} at the end")
        )
    rows += _equalising(recording, equalizer)
    rows += _pins(recording, equalizer)
    met = [one for one in stops_met(recording.events()) if one.joint in equalizer.moving_sheaves]
    rows += [("stop met", f"{one.joint} at {show(one.time, 's', 2)}{one.again}") for one in met]
    for word in ("up", "down"):
        own = list(ways_of(recording, equalizer, word))
        rows += [(f"travel used {word}", _travel(recording, own))] if own else []
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
    pin = pins[first_peak([float(force[name].max()) for name in pins])]
    time = float(recording.time[first_peak(force[pin])])
    text = f"{show(float(force[pin].max()), 'kN', 1)} at most ({pin} at {show(time, 's', 2)})"
    for kind, words in (("pin_pulled", "pulled"), ("pin_put_in", "put in")):
        times = sorted({when for when, _, name in recording.events(kind) if name in pins})
        if times:
            text += f", {words} at {' and '.join(show(when, 's', 2) for when in times)}"
    return [("locking pins", text)]


def of_breaking_force(recording: Recording, rope: str) -> str:
    """What share of its minimum breaking force a rope had to carry, if that is known."""
    share = upper_end.utilisation(recording, rope)
    return "" if share is None else f", {show(share, '%', 1)} of minimum breaking force"


def _lengthening(recording: Recording, equalizer: Equalizer) -> Iterator[tuple[str, str]]:
    """What takes the place of travel where lengths are adjusted."""
    factor = f", adjusting factor {equalizer.adjusting_factor:g}" if equalizer.adjusting_factor else ""
    yield "mechanism", f"approximated{factor}: no sheave moves, slings change their length"
    change = {rope: recording.column("rope_lengthening", rope) for rope in equalizer.slings}
    for title, sign in (("longer", 1.0), ("shorter", -1.0)):
        rope = list(change)[first_peak([float((sign * one).max()) for one in change.values()])]
        curve = sign * change[rope]
        most, time = float(curve.max()), float(recording.time[first_peak(curve)])
        sling = rope.removeprefix("sling.")
        yield title, f"{show(most, 'm', 3)} at most ({sling} at {show(time, 's', 2)}), not limited"


def _travel(recording: Recording, own: Sequence[Way]) -> str:
    """How much of one stroke the sheaves of an equalizer use, which are all that have it."""
    stroke, clear = own[0].stroke, series.is_clear(recording)
    way = own[first_peak([float(one.travel.max()) for one in own])]
    used = most_used(own, series.everywhere(recording))
    time = float(recording.time[first_peak(way.travel)])
    text = f"{show(used, '%', 1)} of {show(stroke, 'm', 3)} ({way.sheave} at {show(time, 's', 2)})"
    if clear.any():
        used = most_used(own, clear)
        text += f", {show(used, '%', 1)} when clear"
    return f"{text}, margin {show((1.0 - used) * stroke, 'mm', 0)}"
