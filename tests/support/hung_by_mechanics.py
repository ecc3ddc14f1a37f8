"""A module on a spreader bar, all of it on ropes of `mechanics`."""

LIFT = """\
format: 1
lift: {title: A module on a spreader bar}
duration: 40 s
ground: {level: 0 m, friction: 0.5, stiffness: 200 MN/m, damping: 2 MN s/m}
ropes:
  sling: {axial_stiffness: 100 MN, damping_time: 20 ms, mass: none}
  thin: {axial_stiffness: 60 MN, damping_time: 20 ms, mass: none, diameter: 28 mm}
load:
  name: module
  shape: {box: [10 m, 3 m, 3 m]}
  position: [0 m, 0 m, 0 m]
  weight: {calculated: 60 t, contingency: 1.05}
  centre_of_gravity: {at: [0.3 m, 0 m, 1.5 m]}
  stands_on: ground
  lugs:
    L1: {at: [-4 m, 0 m, 3 m], capacity: 80 t}
cranes:
  hook:
    type: fixed_hook
    at: [0 m, 0 m, 16 m]
    rated_capacity: 60 t
    hoist: {speed: 6 m/min, acceleration: 0.1 m/s^2}
mechanics:
  bodies:
    bar:
      at: [0 m, 0 m, 9.1 m]
      joint: {type: free}
      mass: 3 t
      inertia: {xx: 0.1 t m^2, yy: 17.7 t m^2, zz: 17.7 t m^2}
  ropes:
    up_1: {rope: sling, length: 8 m, route: [{type: end, body: hook}, {type: end, body: bar, at: [-4 m, 0 m, 0.2 m]}]}
    up_2: {rope: sling, length: 8 m, route: [{type: end, body: bar, at: [4 m, 0 m, 0.2 m]}, {type: end, body: hook}]}
    down_1: {rope: sling, length: 6 m, route: [{type: end, body: bar, at: [-4 m, 0 m, -0.2 m]}, {type: end, body: module, at: [-4.3 m, 0 m, 1.5 m]}]}
    down_2: {rope: sling, length: 6 m, route: [{type: end, body: bar, at: [4 m, 0 m, -0.2 m]}, {type: end, body: module, at: [3.7 m, 0 m, 1.5 m]}]}
plan:
  - {step: hoist, hoist: hook, by: 2 m, speed: 3 m/min}
  - {step: hold, hold: until_end}
limits: {rule: yard}
"""  # noqa: E501
