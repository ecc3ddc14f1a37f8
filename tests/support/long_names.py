"""A lift whose names are as long as names may be: a load, its lugs, a hook and slings."""

from __future__ import annotations

#: Each of at most 64 characters; a lug's with that of its load is longer.
LOAD = "upper_part_of_the_engine_room_with_its_funnel_and_all_platforms"
HOOK = "the_northern_goliath_crane_of_dock_nine_main_hook_upper_trolley"
LUG = "lug_of_frame_one_hundred_and_seventeen_on_the_starboard_side_"
SLING = "sling_between_the_hook_and_lug_of_frame_117_starboard_side_"
_PLACES = ((4, 4), (4, -4), (-4, 4), (-4, -4))
_LUGS = "\n".join(
    f"    {LUG}{k}: {{at: [{x} m, {y} m, 3 m], capacity: 60 t}}" for k, (x, y) in enumerate(_PLACES)
)
_SLINGS = "\n".join(
    f"  {SLING}{k}: {{from: {HOOK}, to: {LOAD}.{LUG}{k}, length: 9.75 m, rope: sling}}" for k in range(4)
)

LONG_NAMES = f"""
format: 1
lift: {{title: A load with long names}}
duration: 8 s
start: settled
ground: {{level: 0 m, friction: 0.5, stiffness: 200 MN/m, damping: 2 MN s/m}}
ropes:
  sling: {{axial_stiffness: 20 MN, damping_time: 20 ms, mass: none}}
load:
  name: {LOAD}
  shape: {{box: [10 m, 10 m, 3 m]}}
  position: [0 m, 0 m, 0 m]
  weight: {{calculated: 100 t, contingency: 1.0}}
  centre_of_gravity: {{at: [0 m, 0 m, 1 m]}}
  stands_on: ground
  lugs:
{_LUGS}
cranes:
  {HOOK}:
    type: fixed_hook
    at: [0 m, 0 m, 10.9 m]
    rated_capacity: 150 t
    hoist: {{speed: 6 m/min, acceleration: 0.05 m/s^2}}
slings:
{_SLINGS}
plan:
  - {{step: hoist, hoist: {HOOK}, by: 0.4 m, speed: 5 m/min}}
  - {{step: hold, hold: until_end}}
"""
