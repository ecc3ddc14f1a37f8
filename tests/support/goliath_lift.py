"""Lift files of a Goliath crane with one trolley and one hook, and a mass that hangs in it."""

from __future__ import annotations

#: Heights of upper sheaves and of the hook's bearing at the start, bearing to sheaves of the hook block [m].
TOP, HOOK, TO_SHEAVES = 88.0, 35.0, 3.0
#: Length of the falls [m].
FALLS = TOP - HOOK - TO_SHEAVES
#: Masses of hook block and of what hangs in the hook [kg].
HOOK_BLOCK, HUNG = 12e3, 88e3
PARTS = 8

_LIFT = """\
format: 1
lift: {{title: A Goliath crane}}
duration: {duration} s
start: {start}
ropes:
  hoist: {{axial_stiffness: {stiffness} MN, damping_time: 10 ms, mass: none, diameter: 42 mm}}
hook_types:
  H:
    rated_capacity: 100 t
    highest: 72 m
    block: {{mass: 12 t, height: 3 m}}
    reeving: {{parts_each: {parts}, rope: hoist, sheave_diameter: 1 m, upper_sheaves_at: 88 m}}
    drum: {{diameter: 1.6 m}}
    hoist: {{speed: 10 m/min, acceleration: 0.05 m/s^2{hoist}}}
cranes:
  gol:
    type: goliath
    rated_capacity: 150 t
    span: 148 m
    girder: {{underside: 80 m, mass: 2600 t{girder}}}
    legs: {{fixed: 700 t, hinged: 450 t, bogies: 700 t, base: 32 m}}
    travel: {{speed: 30 m/min, acceleration: 0.03 m/s^2, range: [-100 m, 100 m]}}
    wind_limit: 16 m/s
    hook_approach: 14 m
    hook_distance: 12 m
    trolleys:
      one:
        mass: 300 t
        rated_capacity: 120 t
        position: -20 m
        traverse: {{speed: 30 m/min, acceleration: 0.03 m/s^2, range: [-60 m, 60 m]}}
        hooks:
          A: {{type: H, height: {hook} m}}
{more}mechanics:
  bodies:
{bodies}
{ropes}plan:
{plan}
simulation: {{tension_tolerance: {tolerance} N, position_tolerance: 0.001 mm, sample_interval: 0.1 s}}
"""

FIXED = "    hung: {parent: gol.A, joint: {type: fixed}, mass: 88 t}"


def goliath_lift(
    plan: str,
    *,
    duration: float = 120.0,
    start: str = "as_given",
    hoist: str = "",
    girder: str = "",
    stiffness: float = 1e4,
    bodies: str = FIXED,
    ropes: str = "",
    more: str = "",
    tolerance: float = 1.0,
) -> str:
    """A lift file; `plan` is one step per line, not indented.

    Args:
        plan: Steps.
        duration: Of the lift [s].
        start: How it starts.
        hoist: More keys of the hoist, after a comma.
        girder: More keys of the girder, after a comma; it is rigid without.
        stiffness: EA of the hoist rope [MN].
        bodies: What hangs, bodies of `mechanics`.
        ropes: Further parts of `mechanics`.
        more: Further sections.
        tolerance: Of tensions [N].
    """
    steps = "\n".join(f"  - {line}" for line in plan.splitlines())
    return _LIFT.format(
        duration=duration,
        start=start,
        hoist=hoist,
        girder=girder,
        stiffness=stiffness,
        parts=PARTS,
        hook=HOOK,
        bodies=bodies,
        ropes=ropes,
        more=more,
        plan=steps,
        tolerance=tolerance,
    )
