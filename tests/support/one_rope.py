"""One undamped rope, in closed form: a mass dropped until it is taut or hoisted off the ground, sheaves."""

from __future__ import annotations

import math

from mechanics import G, Json, body, contact, document, end, half_turn, rope, slider

#: Mass [kg]; axial stiffness [N] and length [m] of the rope; how far the mass falls before that is taut [m].
_DROPPED, _EA, _LENGTH, _FALL = 1000.0, 1e7, 10.0, 0.5
#: When the rope goes taut [s].
TAUT = math.sqrt(2 * _FALL / G)
#: T = m g (1 + √(1 + 2 k h/(m g))), k = EA/L, h the fall: what it holds where the mass turns back [N].
DROP_PEAK = _DROPPED * G * (1 + math.sqrt(1 + 2 * _EA / _LENGTH * _FALL / (_DROPPED * G)))

#: Mass of the load [kg]; length of its rope and its slack at the start [m]; speed [m/s]; stiffness [N/m].
_LOAD, _HOISTED, _SLACK, _SPEED = 1e5, 20.0, 0.005, 0.1
_STIFFNESS = 1.5e8 / _HOISTED
#: Of the load [N].
WEIGHT = _LOAD * G
#: 1 + v √(k/m)/g: the highest tension over the weight.
LIFT_OFF_FACTOR = 1 + _SPEED * math.sqrt(_STIFFNESS / _LOAD) / G
#: When the rope carries the weight: after its slack and its stretch [s].
LIFT_OFF = (_SLACK + WEIGHT / _STIFFNESS) / _SPEED
#: Of the ground [N/m]: all but rigid.
GROUND = 1e12


def drop() -> Json:
    """A mass `m` above the place where its rope `r` goes taut, at rest."""
    return document(
        [body("m", slider(), _DROPPED, position=(0, 0, _FALL))],
        ropes=[rope("r", _LENGTH, [end(None, (0, 0, _LENGTH)), end("m")], _EA)],
    )


def lift_off(depth: float = 0.0) -> Json:
    """A hook that hoists at constant speed, the rope `r`, and a load that is a `depth` [m] in the ground."""
    return document(
        [
            body("hook", slider(drive="hoist"), 0.0, position=(0, 0, 0.5 + _HOISTED - _SLACK)),
            body("load", slider(position=-depth), _LOAD, position=(0, 0, 0.5)),
        ],
        ropes=[rope("r", _HOISTED, [end("hook"), end("load")], _STIFFNESS * _HOISTED)],
        contacts=[contact("c", "load", (0, 0, -0.5), stiffness=GROUND)],
        drives=[{"name": "hoist", "ramps": [{"at": 0.0, "duration": 1e-6, "velocity": _SPEED}]}],
    )


def two_sheaves(length: float = 50 + 4 * math.pi * 0.5) -> Json:
    """Section 4.1 of the paper: five vertical parts of 10 m, two moving sheaves of 20 kg, a box of 11 kg."""
    route = [
        end(None, (0, 0, 30)),
        half_turn("left", (0, 0, 0), 0.5, over=False),
        half_turn(None, (1.5, 0, 30), 0.5, over=True),
        half_turn("right", (0, 0, 0), 0.5, over=False),
        half_turn(None, (3.5, 0, 30), 0.5, over=True),
        end("box"),
    ]
    return document(
        [
            body("left", slider(), 20.0, position=(0.5, 0, 20)),
            body("right", slider(), 20.0, position=(2.5, 0, 20)),
            body("box", slider(), 11.0, position=(4, 0, 20)),
        ],
        ropes=[rope("rope", length, route, None)],
    )
