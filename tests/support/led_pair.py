"""A beam in the hooks of two cranes that slew and luff, on bases that do not move, and steps that lead it.

Both stand 24 m apart along x, their booms of 30 m over y = 17 m at 60 degrees: heel pins 2 m ahead of the
slewing axis and 3 m up. The beam hangs by one sling from each hook, its lugs below them.
"""

from __future__ import annotations

from gantline.scenario import Scenario, parse_scenario

#: Slewing axes, how far ahead of them heel pins are, length of a boom [m], mass of the beam [kg].
AXES = ((-12.0, 0.0), (12.0, 0.0))
AHEAD, BOOM, BEAM = 2.0, 30.0, 100e3

_CRANE = """\
  {name}:
    type: floating_crane
    position: [{x} m, 0 m, 0 m]
    slewing_axis: [0 m, 0 m]
    slew: 90 deg
    slewing: {{speed: 60 deg/min, acceleration: 0.5 deg/s^2{slewing}}}
    rated_capacity: 100 t
    boom: {{heel_pins: {{at: [2 m, 0 m, 3 m], apart: 3 m}}, length: 30 m, angle: 60 deg, mass: 20 t}}
    luffing: {{speed: 40 deg/min, acceleration: 0.5 deg/s^2, range: [20 deg, 80 deg]{luffing}}}
    hooks: {{H: {{type: hook, height: 14 m{hook}}}}}
"""
_LIFT = """\
format: 1
lift: {{title: Two cranes lead a beam}}
duration: {duration} s
start: rest
ropes:
  hoist: {{axial_stiffness: {rope} MN, damping_time: 10 ms, mass: none, diameter: 32 mm}}
  sling: {{axial_stiffness: {rope} MN, damping_time: 10 ms, mass: none}}
hook_types:
  hook:
    rated_capacity: 100 t
    block: {{mass: 2 t, height: 1.5 m}}
    reeving: {{parts_each: 4, rope: hoist, sheave_diameter: 0.7 m, below_head: 1 m, sheave_block_mass: 1 t}}
    drum: {{diameter: 1 m, layers: 1}}
    hoist: {{speed: 12 m/min, acceleration: 0.2 m/s^2, emergency_acceleration: 0.5 m/s^2}}
load:
  name: beam
  shape: {{box: [26 m, 3 m, 3 m]}}
  datum: bottom_centre
  position: [0 m, 17 m, 5 m]
  weight: {{calculated: 100 t, contingency: 1.00}}
  inertia: homogeneous
  centre_of_gravity: {{at: [{aside} m, 0 m, 1 m]}}
  lugs: {{A: {{at: [-12 m, 0 m, 3 m]}}, B: {{at: [12 m, 0 m, 3 m]}}}}
cranes:
{cranes}slings:
  A: {{from: a.H, to: beam.A, length: 6 m, rope: sling}}
  B: {{from: b.H, to: beam.B, length: 6 m, rope: sling}}
plan:
{plan}
{rest}simulation: {{sample_interval: 0.2 s{settings}}}
"""
#: The plan that tests lead the beam by, unless they say another.
LED = "{step: over, lead: [a.H, b.H], by: [3 m, 5 m, 2 m], speed: 6 m/min, acceleration: 0.02 m/s^2}"


def led_text(
    *steps: str,
    duration: float = 90.0,
    aside: float = 0.0,
    rope: float = 2e5,
    settings: str = "",
    rest: str = "",
    slewing: str = "",
    luffing: str = "",
    hook: str = "",
) -> str:
    """The lift file; `aside` is how far the centre of gravity is towards crane b [m], `rope` EA [MN].

    Settings, and what slewing, luffing and hooks have besides, stand after a comma; `rest` is of the file.
    """
    given = {"slewing": slewing, "luffing": luffing, "hook": hook}
    cranes = "".join(_CRANE.format(name=name, x=x, **given) for name, (x, _) in zip("ab", AXES, strict=True))
    hold = "{step: hold, hold: until_end}"
    plan = "\n".join(f"  - {step}" for step in (*(steps or (LED,)), hold))
    return _LIFT.format(
        duration=duration,
        rope=rope,
        aside=aside,
        cranes=cranes,
        plan=plan,
        rest=rest,
        settings=settings,
    )


def led(*steps: str, **given: object) -> Scenario:
    """The same as a scenario."""
    return parse_scenario(led_text(*steps, **given))  # type: ignore[arg-type]
