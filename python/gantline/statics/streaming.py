"""Motions that lead away from an equilibrium, also where wind, current or waves push: K is not symmetric."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any, Final

import numpy as np
import numpy.typing as npt

#: ω² of what nothing holds [1/s²], as in the core, and the rate at which what builds up counts [1/s].
_NEUTRAL: Final = 1e-6
_GROWS: Final = math.sqrt(_NEUTRAL)

Floats = npt.NDArray[np.float64]


def streams(document: Mapping[str, Any]) -> bool:
    """Whether wind, current or waves push a body at rest, in water that does not remember.

    The mass of water that does is another for each motion.
    """
    forces: Sequence[Mapping[str, Any]] = document.get("forces", ())
    blows = any(any(force.get("stream", ())) or force.get("settled", False) for force in forces)
    return blows and all(force["type"] != "memory" for force in forces)


def _free(found: Mapping[str, Any]) -> tuple[Floats, Floats, Floats, Floats]:
    """A base of what is not held, shape (n, k), with M, D and K on it, shape (k, k)."""
    mass, held = found["mass"], found["held"]
    if not len(held):
        return np.eye(len(mass)), mass, found["damping"], found["stiffness"]
    _, sizes, ways = np.linalg.svd(held)
    base = ways[np.count_nonzero(sizes > 1e-12 * sizes.max(initial=0.0)) :].T
    reduced = (base.T @ found[kind] @ base for kind in ("mass", "damping", "stiffness"))
    return base, *reduced


def leading_away(found: Mapping[str, Any]) -> tuple[int, int, int]:
    """How many motions lead straight away, how many by swinging ever farther, and how many nothing holds.

    A motion leads away where ω² of K x = ω² M x is below zero. Where the stream couples two so that their ω²
    are complex they build up together unless D takes more than that gives: a root of det(λ² M + λ D + K) that
    turns round and grows by e within 1000 s leads away too.

    Args:
        found: Matrices of the core's `linear`.
    """
    _, mass, damping, stiffness = _free(found)
    size = len(mass)
    squares = np.linalg.eigvals(np.linalg.solve(mass, stiffness))
    away, neutral = _straight(squares), int(np.count_nonzero(abs(squares) <= _NEUTRAL))
    if (abs(squares.imag) <= _NEUTRAL).all():
        return away, 0, neutral
    rates = np.linalg.solve(mass, np.hstack([-stiffness, -damping]))
    roots = np.linalg.eigvals(np.vstack([np.eye(size, 2 * size, size), rates]))
    grows = np.count_nonzero((roots.real > _GROWS) & (roots.imag > _GROWS))
    return away, int(grows), neutral


def leading_straight(squares: Floats, counted: int) -> tuple[int, int]:
    """How many motions lead away of those that the core has counted, and how many of them nothing holds.

    The core counts by the signs of pivots, with pins, brakes and ropes without compliance as soft as its
    search has them. That makes nothing stiffer: of a load in a hinge with a plumb axis, which nothing turns,
    the moment of its weight bends the pins, and ω² is below zero by that. Modes hold them exactly.

    Args:
        squares: ω² of so many slowest modes, shape (counted,) [1/s²].
        counted: How many motions the core says lead away.
    """
    if len(squares) < counted:  # not all are known
        return counted, 0
    return int(np.count_nonzero(squares < -_NEUTRAL)), int(np.count_nonzero(abs(squares) <= _NEUTRAL))


def leads_straight(found: Mapping[str, Any]) -> bool:
    """Whether a motion leads away without turning round.

    Args:
        found: Matrices of the core's `linear`.
    """
    _, mass, _, stiffness = _free(found)
    return _straight(np.linalg.eigvals(np.linalg.solve(mass, stiffness))) > 0


def _straight(squares: npt.NDArray[Any]) -> int:
    """How many ω² lead away without turning round."""
    return int(np.count_nonzero((abs(squares.imag) <= _NEUTRAL) & (squares.real < -_NEUTRAL)))


def motions(found: Mapping[str, Any]) -> list[tuple[float, Floats]]:
    """ω² and x with xᵀ M x = 1 of K x = ω² M x, slowest first.

    Two that the stream couples so that their ω² are complex have its real part, and both halves of x.

    Args:
        found: Matrices of the core's `linear`.
    """
    base, mass, _, stiffness = _free(found)
    squares, shapes = np.linalg.eig(np.linalg.solve(mass, stiffness))
    pairs = []
    for square, shape in zip(squares, shapes.T, strict=True):
        part = shape.imag if square.imag < 0.0 else shape.real
        size = math.sqrt(part @ mass @ part)
        pairs.append((float(square.real), base @ part / size))
    return sorted(pairs, key=lambda pair: pair[0])
