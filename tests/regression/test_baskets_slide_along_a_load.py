"""Two baskets on one hook slide towards each other along a smooth pipe, and nothing but a guide said so.

An eye stays where it is on its body, so `gantline check` found the lift in order and its run hung still. Each
basket is pulled along the pipe with T sin a and pressed on it with T cos a, a being what its falls lean by,
and stays where friction is more than tan a. With 11 m of sling round eyes 2 * 0.5 m apart a leg is 5 m long;
with the hook 3 m aside of the basket it is sqrt(5^2 - 0.5^2 - 3^2) = 3.97 m above: tan a = 3/3.97 = 0.76.
"""

from __future__ import annotations

import math

import pytest

from gantline.assembly import assemble
from gantline.scenario import parse_scenario
from pipe_in_baskets import Basket, pipe_in_baskets


def doubts(*baskets: Basket, height: float = 0.1) -> list[str]:
    """What is said of the baskets of a pipe; `height` is that of their eyes [m]."""
    text = pipe_in_baskets(baskets, hooks=6.0, eyes=height, rope="axial_stiffness: 60 MN")
    return [one for one in assemble(parse_scenario(text)).warnings if one.startswith("baskets ")]


def test_on_one_hook_they_slide() -> None:
    [doubt] = doubts(("west", 0.0, -3.0), ("east", 0.0, 3.0))
    friction = 3.0 / math.sqrt(5.0**2 - 0.5**2 - 3.0**2)
    assert math.degrees(math.atan(friction)) == pytest.approx(37.1, abs=0.05)  # as it is rounded
    assert friction == pytest.approx(0.756, abs=5e-4)
    assert doubt == (
        "baskets west and east lean along pipe by 37 deg, towards each other: where friction is less than "
        "0.76, and 0.1 to 0.2 is usual, they slide along it, and here they stay where their eyes are; hang "
        "them plumb, from two hooks or a bar, or choke them"
    )


def test_hooks_that_are_farther_apart_than_baskets_draw_them_off() -> None:
    [doubt] = doubts(("west", -4.0, -3.0), ("east", 4.0, 3.0))
    assert "away from each other" in doubt


@pytest.mark.parametrize("aside", [0.0, 0.45])
def test_falls_that_friction_holds_are_in_order(aside: float) -> None:
    """0.45 m aside of 4.96 m is tan a = 0.09, less than steel on steel has at the least, 0.1."""
    assert not doubts(("west", aside - 3.0, -3.0), ("east", 3.0 - aside, 3.0))


def test_a_load_that_hangs_aside_of_its_hooks_goes_below_them() -> None:
    """Both lean the same way, as far as a load swings."""
    assert not doubts(("west", -2.0, -3.0), ("east", 4.0, 3.0))


def test_shackles_at_lugs_on_top_do_not_slide() -> None:
    """The top of the box is 0.6 m above its centre of gravity."""
    assert not doubts(("west", 0.0, -3.0), ("east", 0.0, 3.0), height=0.6)
    assert doubts(("west", 0.0, -3.0), ("east", 0.0, 3.0), height=0.5)
