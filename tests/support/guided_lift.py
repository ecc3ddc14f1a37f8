"""A load of 30 t on four slings that do not stretch, brought to its place by landing guides."""

from __future__ import annotations

import math

__all__ = ["HOOK", "LUG", "MASS", "guided_lift"]

MASS = 30e3
#: Height of the hook over the underside of the load, and of the lugs, at which the slings begin [m].
HOOK, LUG = 17.0, 2.0


def guided_lift(
    guides: str,
    *,
    at: tuple[float, float] = (0.0, 0.0),
    height: float = 1.0,
    plan: str = "",
    more: str = "",
    duration: float = 5.0,
) -> str:
    """A lift file; the centre of gravity is 1 m over the underside, right below the hook.

    Args:
        guides: Landing guides, each a line, indented.
        at: Where the load hangs, in plan [m].
        height: Of its underside [m].
        plan: Steps, a line each, indented; none if not given.
        more: Further sections.
        duration: Of the lift [s].
    """
    x, y = at
    lugs = {
        name: (sx * 2.0, sy * 1.0)
        for name, sx, sy in (("A", 1, 1), ("B", 1, -1), ("C", -1, 1), ("D", -1, -1))
    }
    length = math.hypot(2.0, 1.0, HOOK - LUG)
    slings = "\n".join(
        f"  {name}: {{from: crane, to: module.{name}, length: {length!r} m, rope: sling}}" for name in lugs
    )
    return f"""\
format: 1
lift: {{title: A load comes down along guides}}
duration: {duration} s
ground: {{level: 0 m, friction: 0.3}}
ropes: {{sling: {{axial_stiffness: 10000 GN, damping_time: 10 ms, mass: none}}}}
load:
  name: module
  shape: {{box: [6 m, 3 m, 2 m]}}
  position: [{x} m, {y} m, {height} m]
  weight: {{calculated: {MASS} kg}}
  centre_of_gravity: {{at: [0 m, 0 m, 1 m]}}
  lugs:
{"".join(f"    {name}: {{at: [{lx} m, {ly} m, {LUG} m]}}{chr(10)}" for name, (lx, ly) in lugs.items())}
cranes:
  crane: {{type: fixed_hook, at: [{x} m, {y} m, {height + HOOK} m],
    hoist: {{speed: 6 m/min, acceleration: 0.05 m/s^2}}}}
slings:
{slings}
guides:
{guides}
{"plan:" + chr(10) + plan if plan else ""}
{more}
"""
