"""An inextensible rope that had parted, or was off, came back when another one went taut beside it.

An impact asks which inextensible ropes take part: those whose ends are farther apart than they are long and
go on moving apart. Ropes that were no longer there were asked too, and one whose load had dropped into
another rope acted again: it pulled the load back to its old length at once.
"""

from __future__ import annotations

import math

import pytest

from mechanics import G, Json, adaptive, body, document, end, point, rope

#: A mass 1 m below the world on a short rope, and a slack one of 5 m that holds it from 3 m aside: taut 4 m
#: down.
_SHORT, _LONG, _ASIDE = 1.0, 5.0, 3.0
_FALL = math.sqrt(_LONG**2 - _ASIDE**2) - _SHORT


def _swing() -> Json:
    short = rope("short", _SHORT, [end(None), end("m")], None) | {"cut_at": 0.1}
    long = rope("long", _LONG, [end(None, (_ASIDE, 0, 0)), end("m")], None)
    return document([body("m", point((0, 0, -_SHORT)), 1000.0)], ropes=[short, long])


def test_a_rope_that_was_cut_takes_no_part_in_an_impact() -> None:
    """Cut at 0.1 s it falls by 3 m; of its speed what is along the long rope is lost, the rest swings on.

    v² after is 2 g h (3/5)²: across the rope, whose slope is 4 : 3 there. Lowest it is 5 m below the anchor.
    """
    found = adaptive(_swing(), 1.5)
    assert [name for _, name in found.events("cut")] == ["short"]
    assert [name for _, name in found.events("taut")] == ["long"]
    taut = 0.1 + math.sqrt(2 * _FALL / G)
    assert found.events("taut")[0][0] == pytest.approx(taut, abs=1e-6)
    assert found.tension("short")[found.time > 0.1].max() == 0.0
    place = found.body("m")
    speed = ((found.body("m", "body_velocity")) ** 2).sum(axis=1)
    after = found.time > taut + 0.01
    height = place[after, 2] + _SHORT + _FALL
    # Energy of the swing from the moment after the impact, whose height is 0 here.
    assert speed[after] + 2 * G * height == pytest.approx(2 * G * _FALL * (3 / 5) ** 2, rel=1e-6)
