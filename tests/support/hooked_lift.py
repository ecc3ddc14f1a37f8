"""Lift files of a load that hangs on slings from one hook or several."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

#: Two hooks, each with two slings, of which none is quite over its lugs.
TWO_HOOKS = {"A": (-4.3, 0.2, 22.0), "B": (4.1, -0.3, 22.3)}
TWO_HOOKS_LUGS = {"1": (-4.0, 2.0, 4.0), "2": (-4.0, -2.0, 4.0), "3": (4.0, 2.0, 4.0), "4": (4.0, -2.0, 4.0)}
TWO_HOOKS_SLINGS = {
    "S1": ("A", "1", 12.0),
    "S2": ("A", "2", 12.1),
    "S3": ("B", "3", 12.0),
    "S4": ("B", "4", 12.2),
}


def place(at: Sequence[float]) -> str:
    """A place as lift files have it [m]."""
    return "[" + ", ".join(f"{value!r} m" for value in at) + "]"


def hooked_lift(
    hooks: Mapping[str, Sequence[float]],
    lugs: Mapping[str, Sequence[float]],
    slings: Mapping[str, tuple[str, str, float]],
    *,
    mass: float = 200e3,
    centre: Sequence[float] = (0.0, 0.0, 2.0),
    box: Sequence[float] = (10.0, 6.0, 4.0),
    axial_stiffness: float | None = 200e6,
    position: Sequence[float] = (0.0, 0.0, 0.0),
    more: str = "",
) -> str:
    """A lift file of a load on slings.

    Args:
        hooks: Bearing points of hooks [m].
        lugs: Lugs on the load, from the middle of its bottom [m].
        slings: From which hook, or moving sheave, to which lug, and length [m].
        mass: Of the load [kg].
        centre: Its centre of gravity, from the middle of its bottom [m].
        box: Its length, breadth and height [m].
        axial_stiffness: EA of the slings [N]; None for inextensible ones.
        position: Of the middle of its bottom at the start [m].
        more: Further sections.
    """

    rope = (
        "{inextensible: true}" if axial_stiffness is None else f"{{axial_stiffness: {axial_stiffness!r} N}}"
    )
    hoist = "hoist: {speed: 0.1 m/s, acceleration: 0.1 m/s^2}"
    cranes = "\n".join(
        f"  {name}: {{type: fixed_hook, at: {place(at)}, {hoist}}}" for name, at in hooks.items()
    )
    places = "\n".join(f"    {name}: {{at: {place(at)}}}" for name, at in lugs.items())
    ropes = "\n".join(
        f"  {name}: {{from: {top}, to: load.{lug}, length: {length!r} m}}"
        for name, (top, lug, length) in slings.items()
    )
    return f"""\
format: 1
lift: {{title: A load on slings}}
duration: 10 s
start: as_given
ropes: {{kind: {rope}}}
load:
  name: load
  shape: {{box: {place(box)}}}
  position: {place(position)}
  weight: {{calculated: {mass / 1e3!r} t}}
  centre_of_gravity: {{at: {place(centre)}}}
  lugs:
{places}
cranes:
{cranes}
sling_defaults: {{rope: kind}}
slings:
{ropes}
{more}"""


def two_hooks(centre: Sequence[float] = (0.4, 0.1, 2.0)) -> str:
    """A lift file of a load under two hooks that are not quite over their lugs."""
    at = (0.0, 0.0, 6.5)
    return hooked_lift(TWO_HOOKS, TWO_HOOKS_LUGS, TWO_HOOKS_SLINGS, centre=centre, position=at)


def turned_by_two_hooks(more: str = "") -> str:
    """A lift file of 20 t that two hooks lift off and turn by 54 deg; `more` steps, a line each, indented."""
    text = hooked_lift(
        {"main": (0.0, 2.6, 13.0), "tail": (0.0, -3.2, 11.0)},
        {"A": (-2.2, 2.6, 3.0), "B": (2.2, 2.6, 3.0), "C": (-2.2, -3.0, 0.8), "D": (2.2, -3.0, 0.8)},
        {
            "A": ("main", "A", 10.3),
            "B": ("main", "B", 10.3),
            "C": ("tail", "C", 10.5),
            "D": ("tail", "D", 10.5),
        },
        mass=20e3,
        centre=(0.0, 0.0, 1.45),
        box=(4.8, 6.0, 3.0),
        axial_stiffness=20e6,
        more="""\
ground: {friction: 0.5}
plan:
  - {step: lift, hoist: [main, tail], speed: 0.1 m/s, by: 4 m}
  - {step: turn, lower: tail, speed: 0.1 m/s, by: 3 m}
  - {step: on, hoist: main, speed: 0.1 m/s, by: 1.5 m}
"""
        + more,
    )
    text = text.replace("  name: load\n", "  name: load\n  stands_on: ground\n")
    return text.replace("as_given", "rest").replace("duration: 10 s", "duration: 110 s")
