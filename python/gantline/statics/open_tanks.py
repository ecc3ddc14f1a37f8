"""What runs through holes below the water as a vessel is inclined.

A room that is open to the sea has its level outside: as she heels the lower one takes water, and that heels
her on. An equilibrium holds what is in it. With w_k how her body moves under a kilogram at the middle of the
surface in tank k, A_k the surface, and n(x) how far its middle rises as she moves by x, x_0 without that
liquid,

    sum_k n_j(w_k) m_k + m_j/(rho_j A_j) = -n_j(x_0) ,    x = x_0 + sum_k w_k m_k ,

m_k being what runs in, (HO6) of `docs/concepts/holes.md`. Of one that heels alone that is GM less rho A y^2
over the displacement: lost buoyancy.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from gantline.hydro.tank import liquid_in_box
from gantline.results.recording import Recording
from gantline.results.rotation import axes
from gantline.scenario.afloat.tanks import (
    bodies_afloat,
    has_sea,
    hole_turns,
    holed_tanks,
    with_contents,
)
from gantline.scenario.afloat.water import BallastTank, Water

if TYPE_CHECKING:
    from gantline.statics.lift import Statics

__all__ = ["with_what_has_run", "with_what_runs"]

Floats = npt.NDArray[np.float64]

#: As far as that from the level outside it no longer runs [m].
_LEVEL = 0.1
#: Share of its capacity that is air or liquid at least in a tank with a surface.
_SURFACE = 1e-6


def with_what_has_run(question: Statics, recording: Recording, sample: int = -1) -> Statics:
    """A lift with what has run through holes of its tanks by a sample of a recording, which no plan knows."""
    holed = holed_tanks(question.scenario)
    if not holed:
        return question
    contents = {name: float(recording.column("tank_content", name)[sample]) for name in holed}
    return type(question)(with_contents(question.scenario, contents))


def with_what_runs(
    question: Statics, recording: Recording, body: str, motions: Floats, *, at_level: bool = False
) -> Floats:
    """How a body answers to weights, with what runs through its holes meanwhile.

    Tanks count that have a surface and a hole below the water outside, open at the start or by a step
    of the plan: one that is closed again, too, and, unless `at_level`, one that has not come to its level.

    Args:
        question: The lift.
        recording: How it rests, of its equilibrium that was found last.
        body: Name of a body that floats.
        motions: Of its centre of gravity and its turns under 1 kg m more along its x and y, and under a
            kilogram more at its centre of gravity, with what is in tanks held, shape (3, 6) [m, rad].
        at_level: Whether tanks count only that have come to their level.

    Returns:
        The first two of them with what runs, shape (2, 6).
    """
    places = _surfaces(question, recording, body, at_level)
    if not places:
        return motions[:2]
    turn = axes(recording.column("body_orientation", body)[-1])
    levers = np.array([lever for lever, _ in places])
    # A kilogram at a lever: at the centre of gravity, moved along the body's axes until it is there.
    shifts = np.linalg.solve(turn[:2, :2], levers[:, :2].T).T
    moves = motions[2] + shifts @ motions[:2]
    rises = np.array([_rise(motions[:2], lever) for lever in levers])
    together = np.array([_rise(moves, lever) for lever in levers])
    runs = np.linalg.solve(together + np.diag([1.0 / mass for _, mass in places]), -rises)
    found: Floats = motions[:2] + runs.T @ moves
    return found


def _rise(motions: Floats, lever: Floats) -> Floats:
    """By how much a point of a body rises under motions of its centre and its turns (n, 6): (n,) [m]."""
    rises: Floats = motions[:, 2] + motions[:, 3] * lever[1] - motions[:, 4] * lever[0]
    return rises


def _surfaces(
    question: Statics, recording: Recording, body: str, at_level: bool
) -> list[tuple[Floats, float]]:
    """Surfaces that follow the sea, in a body and what is fixed to it.

    Returns:
        Of each its middle from the centre of gravity of the body (3,) [m], and mass for a metre more [kg/m].
    """
    if not has_sea(question.scenario):
        return []
    own = recording.column("body_position", body)[-1]
    bodies = bodies_afloat(question.scenario)
    outside = (question.scenario.water or Water()).level
    return [
        (place - own, mass)
        for name in _fixed_to(question, body)
        if name in bodies
        for place, mass in _surfaces_in(question, recording, name, bodies[name].tanks or {})
        if not at_level or abs(place[2] - outside) < _LEVEL
    ]


def _fixed_to(question: Statics, body: str) -> list[str]:
    """The body, and all that moves as it does."""
    found = [body]
    for one in question.assembly.document["bodies"]:  # parents come before what they bear
        if one["joint"]["type"] == "fixed" and one.get("parent") in found:
            found.append(one["name"])
    return found


def _surfaces_in(
    question: Statics, recording: Recording, body: str, tanks: Mapping[str, BallastTank]
) -> Iterator[tuple[Floats, float]]:
    """Surfaces that follow the sea in tanks of a body: their middles (3,) [m], mass of a metre [kg/m]."""
    given = next(one for one in question.assembly.document["bodies"] if one["name"] == body)
    centre = np.array(given["centre_of_gravity"], dtype=float)
    turn = axes(recording.column("body_orientation", body)[-1])
    at = recording.column("body_position", body)[-1]
    level = (question.scenario.water or Water()).level
    turns = hole_turns(question.scenario)
    for name, tank in tanks.items():
        content = float(recording.column("tank_content", f"{body}.{name}")[-1])
        holes = (
            at[2] + turn[2] @ (np.array(hole.at) - centre)
            for own, hole in (tank.holes or {}).items()
            if not hole.closed or turns[f"{body}.{name}.{own}"]
        )
        if _has_surface(tank, content) and any(hole < level for hole in holes):
            liquid = liquid_in_box(tank.box, turn[2], content / tank.density)
            yield at + turn @ (np.array(tank.bottom) + liquid.middle - centre), tank.density * liquid.area


def _has_surface(tank: BallastTank, content: float) -> bool:
    return _SURFACE * tank.capacity < content < (1.0 - _SURFACE) * tank.capacity
