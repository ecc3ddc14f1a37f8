"""Lift files of a load that hangs on plumb slings, each from a hook of its own over its lug."""

from __future__ import annotations

from collections.abc import Mapping

from mechanics import G

MASS = 300e3
WEIGHT = MASS * G
LENGTH = 10.0
#: Height of the lugs, and of the centre of gravity: a tilt brings no moment of the weight about the lugs [m].
LUGS_AT = 2.5
SQUARE = {"A": (2.5, 2.5), "B": (-2.5, 2.5), "C": (-2.5, -2.5), "D": (2.5, -2.5)}
TRIANGLE = {"A": (3.0, 0.0), "B": (-2.0, 2.0), "C": (-2.0, -1.0)}
AXIAL_STIFFNESS = 200e6

ELASTIC = "{axial_stiffness: 200 MN}"
INEXTENSIBLE = "{inextensible: true}"


def plumb_lift(
    cases: str,
    *,
    lugs: Mapping[str, tuple[float, float]] = SQUARE,
    rope: str = ELASTIC,
    tolerance: str = "0 %",
    envelope: str = "[0 m, 0 m, 0 m]",
    more: str = "",
) -> str:
    """A lift file of 300 t on slings of 10 m, with its centre of gravity under the origin.

    Args:
        cases: Its cases, a line each, not indented.
        lugs: Lugs, and hooks over them, by name.
        rope: Kind of rope of the slings.
        tolerance: Of their lengths.
        envelope: Of the centre of gravity.
        more: Further sections.
    """
    shown = "\n".join(f"  {line}" for line in cases.splitlines())
    hooks = "\n".join(
        f"  {name}: {{type: fixed_hook, at: [{x} m, {y} m, {LUGS_AT + LENGTH} m], "
        "hoist: {speed: 0.1 m/s, acceleration: 0.1 m/s^2}}"
        for name, (x, y) in lugs.items()
    )
    places = "\n".join(f"    {name}: {{at: [{x} m, {y} m, {LUGS_AT} m]}}" for name, (x, y) in lugs.items())
    slings = "\n".join(f"  S{name}: {{from: {name}, to: girder.{name}}}" for name in lugs)
    return f"""\
format: 1
lift: {{title: A load on plumb slings}}
duration: 10 s
ropes:
  kind: {rope}
load:
  name: girder
  shape: {{box: [10 m, 10 m, 5 m]}}
  weight: {{calculated: 300 t, contingency: 1.1}}
  centre_of_gravity: {{at: [0 m, 0 m, 2.5 m], envelope: {envelope}}}
  lugs:
{places}
cranes:
{hooks}
sling_defaults: {{rope: kind, length: {LENGTH} m, tolerance: {tolerance}}}
slings:
{slings}
cases:
{shown}
{more}"""
