"""Lifts B (Goliath crane, 350 t) and C (floating crane, 1000 t) at rest, each hook at a place of its own.

Gear and loads are plausible and assumed, as a yard would plan such lifts. Trolleys, girder, boom and vessel
are left out: hooks hang from the world, rigid or in the falls of their reeving.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from hooked_lift import place

#: Hooks of lift B over the load, from the middle of its bottom [m].
GOLIATH_HOOKS = {"U1": (-10.0, 6.0), "U2": (-10.0, -6.0), "L": (14.0, 0.0)}
#: Its lugs [m], and lengths of their slings [m].
GOLIATH_LUGS = {
    "U1.1": (-13.2, 8.4, 10.4), "U1.2": (-13.2, 3.6, 10.7), "U1.3": (-10.0, 6.0, 11.0),
    "U1.4": (-6.8, 3.6, 10.7), "U1.5": (-6.8, 8.4, 10.4),
    "U2.1": (-13.2, -3.6, 10.7), "U2.2": (-13.2, -8.4, 10.4), "U2.3": (-10.0, -6.0, 11.0),
    "U2.4": (-6.8, -8.4, 10.4), "U2.5": (-6.8, -3.6, 10.7),
    "L.1": (10.8, 2.4, 7.9), "L.2": (10.8, -2.4, 7.9), "L.3": (14.0, 0.0, 11.0),
    "L.4": (17.2, -2.4, 10.4), "L.5": (17.2, 2.4, 10.4),
}  # fmt: skip
GOLIATH_LENGTHS = {lug: 23.0 if lug in ("L.1", "L.2") else 20.0 for lug in GOLIATH_LUGS}
#: Hooks of lift C, from the middle of the load's bottom; y across the boom plane [m].
FLOATING_HOOKS = {"P2": (0.0, 11.25), "P1": (0.0, 3.75), "S1": (0.0, -3.75), "S2": (0.0, -11.25)}
_FLOATING_ALONG = (-6.4, -3.2, 0.0, 3.2, 6.4)
_FLOATING_LENGTHS = (24.2, 24.0, 24.4, 24.0, 24.2)
#: Its lugs [m], five in a row under each hook, and lengths of their slings [m].
FLOATING_LUGS = {
    f"{hook}.{number}": (along, y, 11.0)
    for hook, (_, y) in FLOATING_HOOKS.items()
    for number, along in enumerate(_FLOATING_ALONG, start=1)
}
FLOATING_LENGTHS = {lug: _FLOATING_LENGTHS[int(lug[-1]) - 1] for lug in FLOATING_LUGS}

_EQUALIZER = """\
    rated_capacity: 330 t
    frame: {mass: 20 t, length: 8 m, width: 1.6 m, height: 3.3 m, centre_of_gravity_below_hook: 5.0 m}
    rope: equalizing_46
    rope_ends:      {along: [-3.6 m, 3.6 m], below_hook: 6.65 m}
    fixed_sheaves:  {along: [-2.4 m, -0.8 m, 0.8 m, 2.4 m], below_hook: 6.65 m, pitch_diameter: 0.8 m}
    sheaves: {SHEAVE}
    moving_sheaves:
      along: [-3.2 m, -1.6 m, 0 m, 1.6 m, 3.2 m]
      below_hook: 8.65 m
      mass: 300 kg
      pitch_diameter: 0.8 m
    travel: {up: 1.4 m, down: 1.9 m}
"""


def _lift(
    hooks: Mapping[str, tuple[float, float, float]],
    reeving: Mapping[str, str],
    load: str,
    lugs: Mapping[str, Sequence[float]],
    lengths: Mapping[str, float],
    ropes: str,
    sling: str,
    shackle: str,
    efficiency: float,
) -> str:
    sheave = f"efficiency: {efficiency}" + (", rotating_mass: 150 kg" if efficiency < 1.0 else "")
    hoist = "hoist: {speed: 5 m/min, acceleration: 0.02 m/s^2}"
    cranes = "\n".join(
        f"  {name}: {{type: fixed_hook, at: {place(at)}, {reeving.get(name, '')}{hoist}}}"
        for name, at in hooks.items()
    )
    equalizers = "\n".join(f"  E{name}: {{type: EQ5-300, hangs_from: {name}}}" for name in hooks)
    places = "\n".join(f"    {name}: {{at: {place(at)}, capacity: 80 t}}" for name, at in lugs.items())
    slings = "\n".join(
        f"  {name}: {{from: E{name}, to: load.{name}, length: {lengths[name]!r} m}}" for name in lugs
    )
    return f"""\
format: 1
lift: {{title: A lift by hand}}
duration: 10 s
start: as_given
ropes:
{ropes}
shackles:
{shackle}
load:
  name: load
{load}
  lugs:
{places}
equalizer_types:
  EQ5-300:
{_EQUALIZER.replace("SHEAVE", sheave)}
cranes:
{cranes}
equalizers:
{equalizers}
sling_defaults: {{rope: {sling}, shackles: {{top: wide, bottom: wide}}}}
slings:
{slings}
"""


def _kind(name: str, diameter: int, stretches: bool, weighs: bool) -> str:
    given = "construction: 6x36 IWRC, grade: 1960" if stretches else "inextensible: true"
    return f"  {name}: {{{given}, diameter: {diameter} mm{'' if weighs else ', mass: none'}}}"


def goliath_lift(
    levels: Mapping[str, float],
    *,
    falls: bool = False,
    stretches: bool = True,
    weighs: bool = True,
    contingency: float = 1.0,
    efficiency: float = 1.0,
    centre: Sequence[float] = (-2.0, 0.0, 4.8),
) -> str:
    """Lift file of lift B.

    Args:
        levels: Bearing point of each hook [m].
        falls: Whether hooks hang in the falls of their reeving, else they are held.
        stretches: Whether slings and equalizing ropes do.
        weighs: Whether slings, shackles and equalizing ropes do.
        contingency: Of the weight that is simulated.
        efficiency: Of the sheaves of the equalizers.
        centre: Centre of gravity from the middle of the bottom [m].
    """
    reeving = {}
    if falls:
        upper = (
            "block: {mass: 12 t, height: 3.0 m}, reeving: {ropes: 2, parts_each: 8, rope: hoist_42, "
            "sheave_diameter: 1.0 m, upper_sheaves_at: 88 m}, drum: {diameter: 1.6 m, layers: 1}, "
        )
        lower = (
            "block: {mass: 20 t, height: 3.5 m}, reeving: {ropes: 2, parts_each: 12, rope: hoist_44, "
            "sheave_diameter: 1.1 m, upper_sheaves_at: 78 m}, drum: {diameter: 1.8 m, layers: 1}, "
        )
        reeving = {"U1": upper, "U2": upper, "L": lower}
    load = f"""\
  shape: {{box: [43 m, 23 m, 11 m]}}
  position: [0 m, 0 m, 2.5 m]
  weight: {{calculated: 350 t, contingency: {contingency}, simulate: design}}
  centre_of_gravity: {{at: {place(centre)}}}
  inertia: {{xx: 17640 t m^2, yy: 58140 t m^2, zz: 69350 t m^2, xy: 600 t m^2, xz: -1260 t m^2}}"""
    kinds = [
        _kind("sling_44", 44, stretches, weighs),
        _kind("equalizing_46", 46, stretches, weighs),
        _kind("hoist_42", 42, True, True),
        _kind("hoist_44", 44, True, True),
    ]
    hooks = {name: (*GOLIATH_HOOKS[name], level) for name, level in levels.items()}
    return _lift(
        hooks, reeving, load, GOLIATH_LUGS, GOLIATH_LENGTHS, "\n".join(kinds), "sling_44",
        f"  wide: {{working_load_limit: 40 t, mass: {21 if weighs else 0} kg}}", efficiency,
    )  # fmt: skip


def floating_lift(
    levels: Mapping[str, float],
    *,
    falls: bool = False,
    stretches: bool = True,
    weighs: bool = True,
    centre: Sequence[float] = (0.0, 0.0, 5.0),
) -> str:
    """Lift file of lift C, hooks fixed in the world: options as for `goliath_lift`."""
    load = f"""\
  shape: {{box: [27 m, 34 m, 11 m]}}
  position: [0 m, 0 m, 10.4 m]
  weight: {{calculated: 1000 t}}
  centre_of_gravity: {{at: {place(centre)}}}
  inertia: {{xx: 106400 t m^2, yy: 70800 t m^2, zz: 157100 t m^2}}"""
    kinds = [
        _kind("sling_64", 64, stretches, weighs),
        _kind("equalizing_46", 46, stretches, weighs),
        _kind("hoist_54", 54, True, True),
    ]
    reeved = (
        "block: {mass: 50 t, height: 3.0 m}, reeving: {ropes: 2, parts_each: 16, rope: hoist_54, "
        "sheave_diameter: 1.2 m, upper_sheaves_at: 103 m}, drum: {diameter: 2.0 m, layers: 1}, "
    )
    hooks = {name: (*FLOATING_HOOKS[name], level) for name, level in levels.items()}
    return _lift(
        hooks, dict.fromkeys(hooks, reeved) if falls else {}, load, FLOATING_LUGS, FLOATING_LENGTHS,
        "\n".join(kinds), "sling_64",
        f"  wide: {{working_load_limit: 75 t, mass: {48 if weighs else 0} kg}}", 1.0,
    )  # fmt: skip
