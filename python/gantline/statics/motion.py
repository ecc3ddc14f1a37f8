"""What moves in a natural motion, in words."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from typing import Any

import numpy as np

from gantline.assembly.spatial import inertia_matrix
from gantline.results.alike import ROUNDING, first_peak
from gantline.results.rotation import axes
from gantline.statics.answers import Floats

Body = Mapping[str, Any]

#: Share of the kinetic energy from which on a body is named as taking part in a motion.
_TAKES_PART = 0.25
#: Share of its kinetic energy from which on a body is said to move, or to turn.
_SHOWS = 0.3
#: Share of a vessel's translation, or of its turning, from which on a motion of it is named.
_NAMED = 0.25
#: What a vessel does along its x, y and z, and about them.
_OF_VESSELS = ("surges", "sways", "heaves"), ("rolls", "pitches", "yaws")
#: Cosine from which on a direction is called by the name of an axis.
_ALONG = 0.98


def in_words(
    motion: Floats,
    names: Sequence[str],
    bodies: Mapping[str, Body],
    turned: Floats,
    flows: Mapping[str, float] | None = None,
    drums: Collection[str] = (),
    vessels: Collection[str] = (),
) -> str:
    """What moves: the bodies, drums and sheaves with the most kinetic energy.

    Args:
        motion: Velocity of each body's centre of gravity and its angular velocity, world axes, (body, 6).
        names: Of the bodies.
        bodies: What the document says of them, and of flows.
        turned: Attitudes of the bodies, unit quaternions, (body, 4).
        flows: Velocity of rope over each sheave or off each drum by its name.
        drums: Which of these are drums.
        vessels: Which bodies are vessels, whose motions have names of their own, along their own axes.
    """
    flows = flows or {}
    energies = np.array(
        [_energies(bodies[name], *one) for name, *one in zip(names, motion, turned, strict=True)]
    ).reshape(-1, 2)
    of_flows = [0.5 * float(bodies[name]["joint"]["inertia"]) * speed**2 for name, speed in flows.items()]
    total = np.array([*energies.sum(axis=1), *of_flows])
    if total.sum() <= 0.0:
        return "rope runs over sheaves"
    share = total / total.sum()
    # Shares that are one but for rounding stand in the order of the bodies.
    share = np.round(share / ROUNDING) * ROUNDING
    order = np.argsort(-share, kind="stable")
    named = [index for index in order if share[index] >= _TAKES_PART][:2] or order[:1]
    runs = [f"drum {name} turns" if name in drums else f"sheave {name} turns" for name in flows]

    def moves(index: int) -> str:
        if names[index] in vessels:
            return _sails(names[index], motion[index], energies[index], turned[index])
        return _moves(names[index], motion[index], energies[index])

    return ", ".join(moves(index) if index < len(names) else runs[index - len(names)] for index in named)


def drums_of(document: Mapping[str, Any]) -> set[str]:
    """Names of the flows by which drums pay rope out; others are rope over sheaves."""
    guides = (guide for rope in document.get("ropes", ()) for guide in rope["route"])
    return {guide["drum"]["flow"] for guide in guides if guide.get("drum")}


def _energies(body: Body, motion: Floats, quaternion: Floats) -> tuple[float, float]:
    """Kinetic energy of a body's translation and rotation."""
    inertia = inertia_matrix(body["inertia"])
    spin = axes(quaternion).T @ motion[3:]
    mass = float(np.asarray(body["mass"], dtype=float))
    return 0.5 * mass * float(motion[:3] @ motion[:3]), 0.5 * float(spin @ inertia @ spin)


def _sails(name: str, motion: Floats, energies: Floats, quaternion: Floats) -> str:
    own = np.reshape(motion, (2, 3)) @ axes(quaternion)
    parts: list[str] = []
    for words, along, energy in zip(_OF_VESSELS, own, energies, strict=True):
        if energy >= _SHOWS * energies.sum():
            share = along**2 / (along @ along)
            parts += [word for word, part in zip(words, share, strict=True) if part >= _NAMED]
    return f"{name} {' and '.join(parts)}"


def _moves(name: str, motion: Floats, energies: Floats) -> str:
    shift, turn = energies / energies.sum()
    parts = []
    if shift >= _SHOWS:
        parts.append(f"moves along {_direction(motion[:3])}")
    if turn >= _SHOWS:
        parts.append(f"turns about {_direction(motion[3:])}")
    return f"{name} {' and '.join(parts)}"


def _direction(vector: Floats) -> str:
    unit = vector / np.linalg.norm(vector)
    for axis, name in enumerate("xyz"):
        if abs(unit[axis]) >= _ALONG:
            return name
    unit = unit if unit[first_peak(np.abs(unit))] > 0 else -unit
    return f"({', '.join(f'{round(part, 2) + 0.0:.2f}' for part in unit)})"
