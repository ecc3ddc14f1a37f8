"""Sections of tables: equalizers, checks, energy and accuracy, the lift file, versions."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from gantline.checks import Check, Verdict
from gantline.report.first_page import fingerprint
from gantline.report.section import Section
from gantline.report.subject import ABSENT, Subject, show, typeset
from gantline.results import series
from gantline.results.counted import counted_in_words
from gantline.results.file.gaps import gaps
from gantline.results.gear import Equalizer
from gantline.results.recording import Recording
from gantline.results.refinement import in_per_cent, refinement_of
from gantline.results.ropes.equalising import equalising
from gantline.results.ropes.parting import stops_met
from gantline.version import version

#: Units of the settings that have one, as recordings keep them.
_SETTING_UNITS = {
    "duration": "s",
    "sample_interval": "s",
    "step": "s",
    "tension_tolerance": "N",
    "position_tolerance": "m",
}


class Equalizers(Section):
    """Travel, spread, stops and pins of each equalizer."""

    anchor = "equalizers"
    title = "Equalizers"
    template = "equalizers.html"

    def content(self, subject: Subject) -> dict[str, Any] | None:
        """What the template is given."""
        found = [_equalizer(subject, one) for one in subject.rig.equalizers]
        return {"equalizers": found} if found else None


def _equalizer(subject: Subject, equalizer: Equalizer) -> dict[str, Any]:
    recording = subject.recording
    facts: list[tuple[str, str]] = [("hangs from", equalizer.hook or ABSENT)]
    if equalizer.equalizing_rope:
        force, time = series.rope_peak(recording, equalizer.equalizing_rope)
        static = subject.static(recording.column("rope_tension", equalizer.equalizing_rope))
        facts.append(
            (
                "equalizing rope",
                f"{show(static, 'kN', 1)} static, {show(force, 'kN', 1)} at most, at {show(time, 's', 2)}",
            )
        )
    if equalizer.slings and subject.clear.any():
        most = series.spread_when_clear(recording, equalizer)
        last = float(series.tension_spread(recording, equalizer)[-1])
        text = f"{show(most, '%', 2)} at most when clear, {show(last, '%', 2)} at the end"
        facts.append(("tension spread", text))
    tilt = subject.peak(series.frame_tilt(recording, equalizer)) if equalizer.tilts else None
    if tilt is not None:
        facts.append(("tilt of the frame", f"{show(tilt[0], 'deg', 2)} at most, at {show(tilt[1], 's', 2)}"))
    found = equalising(recording, equalizer) if equalizer.slings else None
    if found is not None:
        facts.append(("time to equalise", f"{show(found.time, 's', 2)}, from {show(found.begin, 's', 2)} on"))
    met = [one for one in stops_met(recording.events()) if one.joint in equalizer.moving_sheaves]
    facts += [("stop met", f"{one.joint} at {show(one.time, 's', 2)}{one.again}") for one in met]
    if equalizer.travel_up or equalizer.travel_down:
        facts.append(("stops", "simulated" if equalizer.stops else "not simulated"))
    return {"name": equalizer.name, "facts": facts, "sheaves": _sheaves(subject, equalizer)}


def _sheaves(subject: Subject, equalizer: Equalizer) -> list[dict[str, Any]]:
    """Travel of each moving sheave, with bars of its stroke."""
    if "sheave_travel" not in subject.recording or equalizer.mechanism != "sheaves":
        return []
    rows = []
    during = subject.clear if subject.clear.any() else subject.counts
    for name in equalizer.moving_sheaves:
        travel = subject.recording.column("sheave_travel", name)
        up, down = max(0.0, float(-travel[during].min())), max(0.0, float(travel[during].max()))
        rows.append(
            {
                "name": name,
                "end": show(float(travel[-1]), "m", 3),
                "up": show(up, "m", 3),
                "down": show(down, "m", 3),
                "up_used": _used(subject, up, equalizer.travel_up),
                "down_used": _used(subject, down, equalizer.travel_down),
            }
        )
    return rows


def _used(subject: Subject, travel: float, stroke: float | None) -> dict[str, Any] | None:
    if not stroke:
        return None
    used = travel / stroke
    tone = "bad" if used > 1.0 else "warn" if used > subject.most_travel else "good"
    return {"text": show(used, "%", 0), "share": min(1.0, used), "tone": tone}


class Checks(Section):
    """Every check with its value, limit, formula, source and moment."""

    anchor = "checks"
    title = "Checks"
    template = "checks.html"

    def content(self, subject: Subject) -> dict[str, Any] | None:
        """What the template is given."""
        if not subject.checks:
            return None
        return {
            "rule": str(subject.rig.limits.get("rule") or ""),
            "rows": [_check(one) for one in subject.checks],
        }


def _check(check: Check) -> dict[str, Any]:
    used = check.utilisation
    tones = {Verdict.OK: "good", Verdict.WARNING: "warn", Verdict.FAILED: "bad", Verdict.NOT_CHECKED: "none"}
    sign = "" if check.limit is None else "≥ " if check.at_least else "≤ "
    place = [check.element, f"at {check.time:.2f} s" if check.time is not None else ""]
    place.append(f"end of “{check.step}”" if check.step else "")
    return {
        "name": check.name.replace("_", " "),
        "verdict": "no limit" if check.has_no_limit else check.verdict.value,
        "tone": tones[check.verdict],
        "value": typeset(check.shown(check.value)) or ABSENT,
        "limit": f"{sign}{typeset(check.shown(check.limit))}" or ABSENT,
        "used": show(used, "%", 0),
        "share": min(1.0, used or 0.0),
        "place": ", ".join(part for part in place if part),
        "meaning": check.meaning,
        "formula": check.formula,
        "source": check.source,
        "remark": check.remark,
    }


class Energy(Section):
    """Energy balance and what the run says of its own accuracy."""

    anchor = "energy"
    title = "Energy and accuracy"
    template = "energy.html"

    def content(self, subject: Subject) -> dict[str, Any]:
        """What the template is given."""
        recording = subject.recording
        rows = []
        if "energy" in recording and len(recording.time):
            for kind in recording.coordinates["energy_kind"]:
                curve = recording.column("energy", kind)
                if np.abs(curve).max() > 0.0:
                    rows.append(
                        (
                            kind.replace("_", " "),
                            *(_energy(value) for value in (curve[0], curve[-1], curve.min(), curve.max())),
                        )
                    )
        counters = recording.attributes.get("counters") or {}
        return {
            "rows": rows,
            "sentences": [*_accuracy(recording), *subject.stability.sentences()],
            "refinement": _refinement(recording),
            "warnings": [*gaps(recording), *map(str, recording.attributes.get("warnings") or ())],
            "counters": [
                (name, f"{count:,}".replace(",", "\u2009")) for name, count in counted_in_words(counters)
            ],
        }


def _energy(value: float) -> str:
    """Energy [J] in kJ, with four digits where that leaves some behind the point and whole kJ above."""
    kilojoules = 1e-3 * float(value)
    size = abs(kilojoules)
    digits = 0 if size >= 1000.0 else 1 if size >= 100.0 else 2 if size >= 10.0 else 3
    return f"{kilojoules:z,.{digits}f}".replace(",", "\u2009").replace("-", "\u2212")


def _accuracy(recording: Recording) -> Iterator[str]:
    """What the method was told to keep, as far as the settings say; a lift at rest has made no step."""
    if recording.is_equilibrium:
        return
    settings = recording.attributes.get("settings") or {}
    integrator = settings.get("integrator") or {}
    method = integrator.get("type")
    if method is None:
        return
    kept = [
        f"{words} to {show(float(integrator[name]), unit, digits)}"
        for name, words, unit, digits in (
            ("tension_tolerance", "tensions", "N", 1),
            ("position_tolerance", "positions", "mm", 3),
        )
        if isinstance(integrator.get(name), int | float)
    ]
    step = integrator.get("step")
    if kept:
        yield f"method {method}: each step keeps {' and '.join(kept)}"
    elif isinstance(step, int | float):
        yield f"method {method}: steps of {show(float(step), 'ms', 3)}, whose error is not controlled"
    else:
        yield f"method {method}"
    interval = settings.get("sample_interval")
    if isinstance(interval, int | float):
        every = show(float(interval), "s", 3)
        yield f"curves have a sample each {every}; peaks of tension are those of all steps"


def _refinement(recording: Recording) -> dict[str, Any] | None:
    """What a finer run found; None of a lift that had none."""
    found = refinement_of(recording)
    if found is None:
        return None
    rows = [
        {
            "name": one.name.replace("_", " "),
            "element": ", ".join(filter(None, (one.element, f"end of “{one.step}”" if one.step else ""))),
            "value": typeset(one.shown(one.value)),
            "finer": typeset(one.shown(one.finer)),
            "moved": f"{in_per_cent(one.moved)}{' of its limit' if one.is_of_limit else ''}",
        }
        for one in found.told
    ]
    return {"rows": rows, "sentences": list(found.sentences())}


class LiftFile(Section):
    """The lift file as it was simulated, with settings and versions."""

    anchor = "input"
    title = "Input"
    template = "lift_file.html"

    def content(self, subject: Subject) -> dict[str, Any]:
        """What the template is given."""
        attributes = subject.recording.attributes
        settings = attributes.get("settings") or {}
        shown = [(str(key).replace("_", " "), _setting(str(key), value)) for key, value in settings.items()]
        facts = [
            ("simulated by gantline", str(attributes.get("gantline_version", ""))),
            ("report by gantline", version()),
            ("lift file, SHA-256", fingerprint(subject)),
        ]
        size = subject.recording.sizes
        of_what = (("time", "sample", "samples"), ("rope", "rope", "ropes"), ("body", "body", "bodies"))
        counts = ((size.get(dimension, 0), one, several) for dimension, one, several in of_what)
        held = ", ".join(f"{count} {one if count == 1 else several}" for count, one, several in counts)
        facts.append(("recording", held))
        return {"about": [*facts, *shown], "text": str(attributes.get("scenario", ""))}


def _setting(name: str, value: Any) -> str:
    if isinstance(value, dict):
        said = [(key, _setting(key, one)) for key, one in value.items() if one is not None]
        # What kind of a thing it is needs no key before it.
        return ", ".join(text if key == "type" else f"{key.replace('_', ' ')} {text}" for key, text in said)
    if isinstance(value, bool):
        return "yes" if value else "no"
    if name in _SETTING_UNITS and isinstance(value, int | float):
        return f"{value:.6g} {_SETTING_UNITS[name]}"
    return str(value)
