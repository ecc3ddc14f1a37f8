"""A pipe of 10 t without lugs in baskets of 11 m: ropes of `mechanics` through two eyes below it each."""

from __future__ import annotations

from collections.abc import Sequence

#: Name of a basket, where its hook is and where its eyes are along the pipe [m].
Basket = tuple[str, float, float]
#: One plumb below each of two hooks.
TWO = (("west", -3.0, -3.0), ("east", 3.0, 3.0))


def pipe_in_baskets(
    baskets: Sequence[Basket] = TWO,
    *,
    hooks: float,
    eyes: float = 0.1,
    bottom: float = 2.0,
    rope: str = "axial_stiffness: 20 MN",
    duration: float = 1.0,
    more: str = "",
) -> str:
    """A lift file.

    Args:
        baskets: Those at one place share a hook, which has the name of the first.
        hooks: Height of the hooks [m].
        eyes: Height of the eyes over the bottom of the pipe; its centre of gravity is at 0.4 m [m].
        bottom: Height of the bottom of the pipe [m].
        rope: What the baskets are made of.
        duration: Of the lift [s].
        more: Further sections.
    """
    names = {hook: name for name, hook, _ in reversed(baskets)}
    cranes = "".join(
        f"  {name}: {{type: fixed_hook, at: [{x} m, 0 m, {hooks} m], "
        "hoist: {speed: 3 m/min, acceleration: 0.05 m/s^2}}\n"
        for x, name in names.items()
    )
    ropes = ""
    for name, hook, x in baskets:
        below = ", ".join(f"{{type: eye, body: pipe, at: [{x} m, {y} m, {eyes} m]}}" for y in (0.5, -0.5))
        end = f"{{type: end, body: {names[hook]}}}"
        ropes += f"    {name}: {{rope: basket, length: 11 m, route: [{end}, {below}, {end}]}}\n"
    return f"""\
format: 1
lift: {{title: A pipe in baskets}}
duration: {duration} s
ropes: {{basket: {{{rope}, damping_time: 10 ms}}}}
load:
  name: pipe
  shape: {{box: [10 m, 1 m, 1 m]}}
  position: [0 m, 0 m, {bottom} m]
  weight: {{calculated: 10 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 0.4 m]}}
cranes:
{cranes}mechanics:
  ropes:
{ropes}{more}"""
