"""A barge had a GM of 26 m with a load across its deck and that of another, and nobody said why.

GM is what an inclining experiment finds: the barge that heels lifts one side of the load, which leans on the
other barge, so this one rights her, too. That holds only as long as the load presses on both sides: 50 t at
2 m from the middle. By herself she has 15 m. `gantline statics --steps` said so of a load that is partly
lifted, and not of one that stands in two places.
"""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from program import called

#: Of each barge [m, t], and the load [t].
LENGTH, BREADTH, OWN, KG, LOAD = 30.0, 20.0, 1230.0, 1.5, 100.0
SEA = 1.025


def _barge(name: str, side: int) -> str:
    """A barge that begins 1 m to one side."""
    heading = "0 deg" if side > 0 else "180 deg"
    return f"""
  {name}:
    position: [{side} m, 0 m]
    heading: {heading}
    draft: {OWN / (SEA * LENGTH * BREADTH)} m
    hull: {{box: [{LENGTH} m, {BREADTH} m, 4 m]}}
    masses: {{hull: {{mass: {OWN} t, at: [15 m, 0 m, {KG} m]}}}}
    radii_of_gyration: [6 m, 9 m, 9 m]
    water_damping: {{critical: {{heave: 20 %, pitch: 20 %, roll: 20 %}}}}
"""


def _lines(vessel: str, side: int) -> str:
    """Four springs to the sides hold her."""
    ends = [(x, y) for x in (1, 29) for y in (9, -9)]
    return "".join(
        f"  {vessel}.{number}: {{vessel: {vessel}, fairlead: [{x} m, {y} m, 2 m], "
        f"to: [{side * (1 + 3 * x - 40)} m, {side * 5 * y} m, 0 m], rope: soft, pretension: 20 kN, "
        "type: spring}\n"
        for number, (x, y) in enumerate(ends)
    )


@pytest.mark.parametrize(
    ("across", "said"),
    [(True, "box stands on east and west, and holds one to the other"), (False, None)],
    ids=["across", "on one"],
)
def test_it_is_said(tmp_path: Path, across: bool, said: str | None) -> None:
    """GM = T/2 + B^2/12T - KG with half of the load, its middle 1.5 m over the deck of 4 m."""
    path = tmp_path / "lift.yaml"
    place = 0.0 if across else 12.0
    contacts = "".join(
        f"    {name}: {{between: [box, {name}], stiffness: 100 MN/m, damping: 1 MN s/m, friction: 0.3}}\n"
        for name in ("east", "west")
    )
    path.write_text(
        f"""
format: 1
lift: {{title: A load on two barges}}
duration: 10 s
water: {{density: {SEA} t/m^3, level: 0 m}}
ropes: {{soft: {{axial_stiffness: 4 MN, damping_time: 0.1 s, mass: none}}}}
load:
  name: box
  shape: {{box: [16 m, 4 m, 3 m]}}
  position: [{place} m, 0 m, 2 m]
  weight: {{calculated: {LOAD} t}}
  centre_of_gravity: {{at: [0 m, 0 m, 1.5 m]}}
  lugs: {{A: {{at: [0 m, 0 m, 3 m]}}}}
vessels:{_barge("east", 1)}{_barge("west", -1)}
mooring_lines:
{_lines("east", 1)}{_lines("west", -1)}
cranes:
  crane: {{type: fixed_hook, at: [{place} m, 0 m, 14 m], hoist: {{speed: 6 m/min, acceleration: 0.05 m/s^2}}}}
slings: {{S: {{from: crane, to: box.A, length: 11 m, rope: soft}}}}
mechanics:
  body_contacts:
{contacts}
plan:
  - {{step: look, hold: until_end}}
""",
        encoding="utf-8",
    )
    lines = called("statics", path, "--steps", "--held").stdout.splitlines()
    notes = [line.strip() for line in lines if "inclining experiment" in line]
    assert notes == ([f"GM as an inclining experiment finds it: {said}"] if said else [])
    if said:
        weight = OWN + LOAD / 2
        draft = weight / (SEA * LENGTH * BREADTH)
        alone = draft / 2 + BREADTH**2 / (12 * draft) - (OWN * KG + LOAD / 2 * 5.5) / weight
        last = json.loads(called("statics", path, "--steps", "--held", "--json").stdout)["steps"][-1]
        assert last["vessels"]["east"]["gm_transverse"] > alone + 5.0
