"""A barge between two mooring lines that are drawn to 46 % of what breaks them."""

from __future__ import annotations

#: Without limits and rules; each line is drawn to 460 kN of 1 MN.
MOORED = """\
format: 1
lift: {title: A moored barge}
duration: 2 s
water: {level: 0 m}
ropes: {line: {axial_stiffness: 20 MN, minimum_breaking_force: 1 MN, mass: none, damping_time: 10 ms}}
vessels:
  bg:
    draft: 4 m
    hull: {box: [60 m, 20 m, 6 m]}
    masses: {hull: {mass: 4920 t, at: [30 m, 0 m, 3 m]}}
    radii_of_gyration: [6 m, 16 m, 16 m]
mooring_lines:
  bow:
    {vessel: bg, type: spring, fairlead: [60 m, 0 m, 4 m], to: [90 m, 0, 0], rope: line, pretension: 460 kN}
  stern:
    {vessel: bg, type: spring, fairlead: [0 m, 0 m, 4 m], to: [-30 m, 0, 0], rope: line, pretension: 460 kN}
"""
