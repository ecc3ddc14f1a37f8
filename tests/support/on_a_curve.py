"""A lift file of a load that hangs on four slings of tension over strain."""

from __future__ import annotations

from collections.abc import Sequence


def on_a_curve(
    curve: Sequence[tuple[float, float]],
    *,
    mass: float,
    height: float,
    centre: Sequence[float],
    first: float = 9.0,
) -> str:
    """The lift file.

    Args:
        curve: Strains [1] and tensions [N] of the slings.
        mass: Of the load [kg].
        height: Of its box [m].
        centre: Its centre of gravity, from the middle of its bottom [m].
        first: Length of sling A [m]; the others have 9 m.
    """
    strains = ", ".join(f"{strain!r}" for strain, _ in curve)
    tensions = ", ".join(f"{tension!r} N" for _, tension in curve)
    slings = "\n".join(
        f"  {name}: {{from: crane, to: module.{name}, length: {length!r} m}}"
        for name, length in zip("ABCD", (first, 9.0, 9.0, 9.0), strict=True)
    )
    return f"""\
format: 1
lift: {{title: A module on four slings of a curve}}
duration: 1 s
start: rest
ropes:
  sling: {{curve: {{strain: [{strains}], tension: [{tensions}]}}, mass: none, damping_time: 10 ms}}
load:
  name: module
  shape: {{box: [8 m, 6 m, {height!r} m]}}
  position: [0 m, 0 m, 6 m]
  weight: {{calculated: {mass!r} kg}}
  centre_of_gravity: {{at: [{", ".join(f"{part!r} m" for part in centre)}]}}
  lugs:
    A: {{at: [ 3 m,  2 m, 4 m]}}
    B: {{at: [ 3 m, -2 m, 4 m]}}
    C: {{at: [-3 m,  2 m, 4 m]}}
    D: {{at: [-3 m, -2 m, 4 m]}}
cranes:
  crane: {{type: fixed_hook, at: [0 m, 0 m, 18.1 m], hoist: {{speed: 6 m/min, acceleration: 0.05 m/s^2}}}}
sling_defaults: {{rope: sling}}
slings:
{slings}
plan:
  - {{step: hold, hold: until_end}}
"""
