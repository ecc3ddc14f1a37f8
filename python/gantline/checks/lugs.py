"""Lugs: load over capacity, and slings out of the plane of the main plate."""

from __future__ import annotations

from collections.abc import Iterator

from gantline.checks.forces import Force, Raised, factor, over, sling_forces
from gantline.checks.measure import Finding, Missing, carrying, extreme
from gantline.results import series
from gantline.results.recording import Recording
from gantline.results.variable import BoolArray

_CONSEQUENCE = "lug_consequence_factor"


def out_of_plane_angle(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Angle between a carrying sling and the main plate of its lug."""
    for sling in recording.rig.slings:
        angles = series.out_of_plane_angles(recording, sling)
        for lug in (one for one in sling.lugs if one is not None):
            element = f"{sling.to_load}.{lug}"
            if lug not in angles:
                yield Missing(element, "main plate not known")
            else:
                inside = carrying(recording, sling.rope, during)
                yield from extreme(recording, angles[lug], inside, element)


def load_of_capacity(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Load of a lug over its capacity; forces of several slings at one lug add up, peaks as well."""
    forces = sling_forces(recording, during)
    loads: dict[tuple[str, str], Force] = {}
    for sling in recording.rig.slings:
        own = forces[sling.name]
        for lug_name in (one for one in sling.lugs if one is not None):
            key = sling.to_load or "", lug_name
            loads[key] = own if key not in loads else _together(loads[key], own)
    consequence = factor(recording, _CONSEQUENCE)
    raised = (
        Raised() if consequence is None else Raised(consequence, f" x {consequence:.4g}", (_CONSEQUENCE,))
    )
    for (load_name, lug_name), force in loads.items():
        load = recording.rig.load(load_name)
        lug = load.lugs.get(lug_name) if load is not None else None
        if lug is None or not lug.capacity:
            yield Missing(f"{load_name}.{lug_name}", "lug capacity not known")
        else:
            yield from over(force, lug.capacity, f"{load_name}.{lug_name}", raised)


def _together(one: Force, other: Force) -> Force:
    def total(a: float | None, b: float | None) -> float | None:
        return None if a is None or b is None else a + b

    return Force(
        static=total(one.static, other.static),
        static_text=f"({one.static_text} + {other.static_text})",
        rule=total(one.rule, other.rule),
        rule_text=f"({one.rule_text} + {other.rule_text})",
        peak=total(one.peak, other.peak),
        time=one.time if (one.peak or 0.0) >= (other.peak or 0.0) else other.time,
        factors=tuple(dict.fromkeys((*one.factors, *other.factors))),
        counts_static=one.counts_static and other.counts_static,
        window=one.window,
        lacks_static=one.lacks_static or other.lacks_static,
    )
