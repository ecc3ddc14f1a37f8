"""Which series a page shows, in which group and unit."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from gantline.results import series
from gantline.results.loads.aside import swing_of
from gantline.results.loads.drift import load_drift
from gantline.results.loads.hinge_peaks import hinge_peak
from gantline.results.loads.hinges import hinge_force
from gantline.results.loads.hook_peaks import hook_peak
from gantline.results.recording import Recording
from gantline.results.ropes.families import families
from gantline.results.variable import FloatArray


@dataclass(frozen=True, eq=False)
class Curve:
    """One series over time.

    Attributes:
        group: The plot that it belongs to.
        name: Its full name in the recording.
        label: How a legend names it.
        unit: Unit that people read it in.
        factor: From SI to that unit.
        values: SI, shape (time,).
        family: What it belongs to with others of its group; empty if it stands for itself.
        peak: Largest value over all steps and its time [s], where that is known; SI.
    """

    group: str
    name: str
    label: str
    unit: str
    factor: float
    values: FloatArray
    family: str = ""
    peak: tuple[float, float] | None = None


def curves(recording: Recording) -> Iterator[Curve]:
    """All series that a page shows, group by group."""
    yield from _ropes(recording)
    equalizer_of = {sheave: one.name for one in recording.rig.equalizers for sheave in one.moving_sheaves}
    smallest = {watch.name: watch.smallest for watch in recording.rig.watches}
    for group, variable, unit, factor in (
        ("travel", "sheave_travel", "m", 1.0),
        ("rods", "rod_out", "m", 1.0),
        ("hinges", "hinge_force", "kN", 1e-3),
        ("hook_load", "hook_load", "kN", 1e-3),
        ("hoist_load", "hoist_load", "kN", 1e-3),
        ("transferred", "load_transferred", "%", 100.0),
        ("tilt", "load_tilt", "deg", 180.0 / np.pi),
        ("pins", "pin_force", "kN", 1e-3),
        ("chain", "chain_paid_out", "m", 1.0),
        ("lengthening", "rope_lengthening", "m", 1.0),
        ("wraps", "drum_wraps", "", 1.0),
        ("heave", "heave_compensation", "m", 1.0),
        ("draft", "vessel_draft", "m", 1.0),
        ("heel", "vessel_heel", "deg", 180.0 / np.pi),
        ("trim", "vessel_trim", "deg", 180.0 / np.pi),
        ("freeboard", "vessel_freeboard", "m", 1.0),
        ("waves", "vessel_wave_elevation", "m", 1.0),
        ("wind", "wind_at_load", "m/s", 1.0),
        ("clearance", "clearance", "m", 1.0),
    ):
        if variable in recording:
            dim = recording[variable].dims[1]
            for at, name in enumerate(recording.coordinates[dim]):
                values = recording[variable].values[:, at]
                least = smallest.get(name, 0.0) if group == "clearance" else 0.0
                label = f"{name} (≥ {least:g} m)" if least > 0.0 else name
                peak = _between_samples(recording, variable, at)
                yield Curve(group, name, label, unit, factor, values, equalizer_of.get(name, ""), peak)
    yield from _loads(recording)
    yield from _tanks(recording)
    if "energy" in recording:
        for at, kind in enumerate(recording.coordinates["energy_kind"]):
            label = kind.replace("_", " ")
            yield Curve("energy", kind, label, "MJ", 1e-6, recording["energy"].values[:, at])


def _between_samples(recording: Recording, variable: str, at: int) -> tuple[float, float] | None:
    """The peak over all steps of an entry of a variable, and its time [s]; None of what samples have."""
    if variable == "hinge_force":
        return hinge_peak(recording, recording.rig.hinges[at], hinge_force)
    if variable in ("hook_load", "hoist_load"):
        return hook_peak(recording, recording.rig.hooks[at].name, variable)
    return None


def _ropes(recording: Recording) -> Iterator[Curve]:
    slings = {sling.rope: sling.name for sling in recording.rig.slings}
    named = {one.equalizing_rope: f"{one.name} equalizing" for one in recording.rig.equalizers}
    named |= {one.gas: f"{one.name} gas" for one in recording.rig.compensators}
    names = recording.coordinates.get("rope", ())
    family = families(recording.rig, names)
    for name in names:
        label = slings.get(name) or named.get(name, name)
        tension = recording.column("rope_tension", name)
        peak = series.rope_peak(recording, name)
        yield Curve("tension", name, label, "kN", 1e-3, tension, family[name], peak)


def _tanks(recording: Recording) -> Iterator[Curve]:
    """What is in the tanks that steps of the plan pump, or with holes: what is in others stays as it is."""
    changing = dict.fromkeys(tank for step in recording.rig.plan for tank in step.tanks)
    changing |= dict.fromkeys(tank.name for tank in recording.rig.tanks if tank.holes)
    for name in changing if "tank_content" in recording else ():
        yield Curve("tanks", name, name, "t", 1e-3, recording.column("tank_content", name))


def _loads(recording: Recording) -> Iterator[Curve]:
    for load in recording.rig.loads:
        if load.body not in recording.coordinates.get("body", ()):
            continue
        place = recording.column("body_position", load.body)
        yield Curve("drift", load.name, load.name, "m", 1.0, load_drift(recording, load))
        yield Curve("height", load.name, load.name, "m", 1.0, place[:, 2] - place[0, 2])
        if load.contacts:
            yield Curve("support", load.name, load.name, "kN", 1e-3, series.borne(recording, load))
    for name, swing in swing_of(recording).items():
        yield Curve("swing", name, name, "m", 1.0, swing)
    clear = series.is_clear(recording)
    for equalizer in recording.rig.equalizers:
        if equalizer.slings and clear.any():
            # Of slack slings it says nothing, and hides what it comes to once they carry.
            counts = clear & series.is_loaded(recording, equalizer)
            spread = np.where(counts, series.tension_spread(recording, equalizer), np.nan)
            yield Curve("spread", equalizer.name, equalizer.name, "%", 100.0, spread)
