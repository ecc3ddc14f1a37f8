"""Crawler cranes: pressure on the ground and stability against tipping."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from gantline.checks.below_hooks import hoist_ratios
from gantline.checks.check import Check, Verdict
from gantline.checks.measure import Finding, Found, Missing, Refused, extreme
from gantline.results.cranes.crawler import Crawler, raised_state
from gantline.results.recording import Recording
from gantline.results.rotation import axes
from gantline.results.surroundings import ground_of
from gantline.results.variable import BoolArray, FloatArray
from gantline.units import format_quantity

#: Ends of tracks in the order of `Crawler.corners`, along and across the heading.
_ENDS = ((1, 1), (-1, 1), (1, -1), (-1, -1))
#: How far the end of a track moves as a crane rocks [m].
_ROCKS = 0.05


def ground_pressure(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Pressure on the ground with the design weight over what it bears, at the ends of all tracks."""
    for crane in recording.rig.crawlers:
        if not crane.allowed_pressure:
            yield Missing(crane.name, "what the ground bears is not known")
            continue
        pressures, _ = _as_designed(recording, crane)
        allowed = format_quantity(crane.allowed_pressure, "kPa", 1)
        for corner, pressure in zip(crane.corners, pressures.T, strict=True):
            simulated = recording.column("ground_pressure", corner)
            for found in extreme(recording, pressure / crane.allowed_pressure, during, corner):
                value = found.value * crane.allowed_pressure
                raised = _raised_from(value, found, simulated, recording, "kPa")
                shown = f"({raised})" if raised else format_quantity(value, "kPa", 1)
                yield replace(found, formula=f"{shown} / {allowed}")


def tipping(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Moment of what hangs with the design weight over that of the crane's own, about its worst line."""
    for crane in recording.rig.crawlers:
        simulated = recording.column("tipping_utilisation", crane.name)
        tipped = [time for time, _, name in recording.events("tipping") if name == crane.name]
        within = during & (simulated >= 1 - 1e-9)
        if within.any():
            at = tipped[0] if tipped else float(recording.time[int(np.flatnonzero(within)[0])])
            yield Refused(crane.name, f"it tips at {at:.2f} s: nothing is left under one side")
            continue
        _, used = _as_designed(recording, crane)
        for found in extreme(recording, used, during, crane.name):
            yield replace(found, formula=_raised_from(found.value, found, simulated, recording, "%"))


def highest_pressure(recording: Recording, crane: Crawler, during: BoolArray) -> float:
    """Largest pressure on the ground under a crane with the design weight [Pa]."""
    return float(_as_designed(recording, crane)[0][during].max())


def highest_tipping(recording: Recording, crane: Crawler, during: BoolArray) -> float:
    """Largest utilisation of a crane against tipping with the design weight [1]."""
    return float(_as_designed(recording, crane)[1][during].max())


def _as_designed(recording: Recording, crane: Crawler) -> tuple[FloatArray, FloatArray]:
    """Pressures at the ends of tracks, shape (time, 4) [Pa], and utilisation against tipping, (time,) [1].

    The larger of those of the simulated weight, with which a counterweight leans more, and of the design
    weight.
    """
    both = recording.kept(("crawler_as_designed", crane.name), lambda: _raised(recording, crane))
    return both[:, :4], both[:, 4]


def _raised(recording: Recording, crane: Crawler) -> FloatArray:
    pressures = np.stack([recording.column("ground_pressure", one) for one in crane.corners], axis=1)
    used = recording.column("tipping_utilisation", crane.name)
    by = hoist_ratios(recording, crane.hooks)
    if (by > 1.0).any():
        columns = {name: one.values for name, one in recording.variables.items() if not one.is_text}
        pressed, tips = raised_state(columns, recording.coordinates, crane, by)
        pressures, used = np.maximum(pressures, pressed), np.maximum(used, tips)
    return np.column_stack([pressures, used])


def _raised_from(value: float, found: Found, simulated: FloatArray, recording: Recording, unit: str) -> str:
    """A value in words, and what it is of the simulated weight; empty where that is as much."""
    then = float(np.interp(found.time or 0.0, recording.time, simulated))
    if value <= then * (1.0 + 1e-9):
        return ""
    shown = format_quantity(value, unit, 1)
    return f"{shown} with the design weight, {format_quantity(then, unit, 1)} simulated"


def left_ground(recording: Recording) -> list[Check]:
    """A failure for each crawler crane that takes an end of a track over an edge: its ground is level here.

    At the start it stands where the lift file says, on the floor of a dry dock maybe.
    """
    ground = ground_of(recording)
    if ground is None or not len(recording.time):
        return []
    checks = []
    for crane in recording.rig.crawlers:
        turn = axes(recording.column("body_orientation", crane.tracks))
        place = recording.column("body_position", crane.tracks)
        for corner, (along, across) in zip(crane.corners, _ENDS, strict=True):
            at = np.array([along * crane.length, across * crane.gauge, 0.0]) / 2 - np.asarray(crane.centre)
            points = place + turn @ at
            under = ground.under(points)
            # One that stands at the very edge and rocks does not go over it.
            goes = np.linalg.norm(points[:, :2] - points[0, :2], axis=1) > _ROCKS
            gone = np.flatnonzero(goes & (under != under[0]))
            if gone.size:
                when = float(recording.time[gone[0]])
                deep = format_quantity(abs(under[gone[0]] - under[0]), "m", 2)
                lower = "lower" if under[gone[0]] < under[0] else "higher"
                remark = f"it goes over an edge at {when:.2f} s: the ground is {deep} {lower} there"
                meaning = "tracks stay on the ground on which they begin"
                checks.append(
                    Check(
                        "tracks_on_ground", Verdict.FAILED, meaning, element=corner, time=when, remark=remark
                    )
                )
                break
    return checks
