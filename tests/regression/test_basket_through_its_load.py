"""A bundle of pipes rolled over in baskets whose falls went through it, and nothing said that they did.

It was 2.75 m broad and 0.914 m high, its baskets over eyes at its lower edges, up to a bar in the middle.
Such falls lean by 12 deg and come out of the top 0.19 m from its side. Real slings bend about the upper
edges and hold the bundle there, above its centre of gravity; these pulled from below it, and it turned
right over."""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import parse_scenario
from lift_text import changed
from pipe_in_baskets import pipe_in_baskets


def doubts(hooks: float, *changes: tuple[str, str]) -> list[str]:
    """What is said of a pipe, a box of 1 m, in two baskets below hooks of such a height [m]."""
    text = changed(pipe_in_baskets(hooks=hooks, rope="axial_stiffness: 60 MN"), *changes)
    return [one for one in assemble(parse_scenario(text)).warnings if " through " in one]


def test_how_deep_they_cut_is_told() -> None:
    """Eyes at its sides, 0.5 m below its top and 1.2 m below the hook: it leans by 0.5/1.2.

    t below the top it is 0.5/1.2 (0.5 m - t) from the side: both are 0.147 m.
    """
    lean = 0.5 / 1.2
    assert 0.5 * lean / (1 + lean) == pytest.approx(0.147, abs=5e-4)
    [doubt] = doubts(3.7)
    assert doubt == (
        "west and east go through pipe, up to 0.15 m deep, between eyes on it and west: a rope bends about "
        "the edge that it meets; lead it over an eye there too, or the load rolls in it as it would not"
    )


def test_a_box_that_stands_for_what_is_round_is_in_order() -> None:
    """3.5 m below the hook: 0.5 m * 0.143/1.143 = 63 mm."""
    assert not doubts(6.0)


def test_eyes_at_the_upper_edges_too_are_in_order() -> None:
    """Top and centre of gravity are 0.6 m apart."""
    changes = []
    for x in (-3.0, 3.0):
        below = ", ".join(f"{{type: eye, body: pipe, at: [{x} m, {y} m, 0.1 m]}}" for y in (0.5, -0.5))
        first, last = (f"{{type: eye, body: pipe, at: [{x} m, {y} m, 0.6 m]}}" for y in (0.5, -0.5))
        changes.append((below, f"{first}, {below}, {last}"))
    assert not doubts(3.7, *changes)
