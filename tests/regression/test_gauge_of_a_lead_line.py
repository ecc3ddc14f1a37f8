"""The first page had 26.8 t for the gauge of a winch whose lead line pulled with 22.6 t.

Two tackles of four parts, sheaves that take 4 % each, let a load of 200 t down and hold it there. The table
of what gauges should read had the tightest part of each rope, with what hangs at its top: as a load is let
down that is the part at the dead end, and a winch on the ground has the least. A lift stops where a gauge
differs by more than 10 % from that table.

And a rope that lies on one drum with both of its ends, as a bight does, stood there twice.
"""

from __future__ import annotations

import pytest

from gantline.report.subject import Subject
from gantline.report.winches import winch_rows
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from gantline.statics import Statics

#: What a sheave leaves of the tension [1], the load [t], rope [t/m], parts of line and their length [m].
LEAVES, LOAD, ROPE, PARTS, LENGTH = 0.96, 200.0, 10e-3, 4, 24.0
#: Places of the drum below the upper sheaves [m].
BELOW = 30.0
_LIFT = """\
format: 1
lift: {title: A load in two ropes}
duration: 200 s
start: rest
ropes:
  rope: {axial_stiffness: 200 MN, mass: 10 kg/m, damping_time: 20 ms}
load:
  name: section
  shape: {box: [40 m, 12 m, 4 m]}
  position: [0 m, 0 m, 2 m]
  weight: {calculated: 200 t}
  centre_of_gravity: {at: [0 m, 0 m, 2 m]}
mechanics:
  drums:
"""


def _lift(routes: dict[str, str]) -> str:
    """The load in a rope on each of two drums, by their routes."""
    drive = "{speed: 4 m/min, acceleration: 5 mm/s^2}"
    drums = "".join(f"    {name}: {{diameter: 1 m, rotating_mass: 1 t, drive: {drive}}}\n" for name in routes)
    ropes = "".join(
        f"    on_{name}: {{rope: rope, length: as_routed, route: [{route}]}}\n"
        for name, route in routes.items()
    )
    steps = (
        f"  - {{step: down, pay_out: [{', '.join(routes)}], speed: 4 m/min, by: 4 m}}\n"
        "  - {step: hold, hold: until_end}\n"
    )
    return f"{_LIFT}{drums}  ropes:\n{ropes}plan:\n{steps}"


def _tackle(drum: str, x: float) -> str:
    """Four plumb parts of 24 m, and the lead line from above them down to a drum on the ground."""

    def sheave(body: str, y: float, z: float, bulge: int) -> str:
        way = f"enter: [{x} m, {y} m, {z} m], leave: [{x} m, {y + 1} m, {z} m], bulge: [0, 0, {bulge}]"
        return f"{{type: half_turn, body: {body}, {way}, efficiency: {LEAVES}, rotating_mass: 20 kg}}"

    dead = f"{{type: end, body: world, at: [{x} m, -1.5 m, {BELOW} m]}}"
    lead = f"{{type: end, body: world, at: [{x} m, 2.5 m, 0 m], drum: {drum}}}"
    return ", ".join(
        (
            dead,
            sheave("section", -1.5, 2, -1),
            sheave("world", -0.5, BELOW, 1),
            sheave("section", 0.5, 2, -1),
            sheave("world", 1.5, BELOW, 1),
            lead,
        )
    )


def test_a_gauge_has_the_line_that_comes_to_it() -> None:
    """As the load is let down each sheave takes from part to part: T_k = T_lead/η^k, and they bear W/2.

    W has the lower half of what the parts weigh; the lead line's own lower half hangs below its middle. What
    sticks as the winches stand still leaves less than 1 % of what the sheaves took.
    """
    run = simulate(parse_scenario(_lift({"w1": _tackle("w1", -15.0), "w2": _tackle("w2", 15.0)})))
    borne = LOAD / 2 + PARTS * ROPE * LENGTH / 2
    lead = borne / sum(LEAVES**-part for part in range(1, PARTS + 1)) - ROPE * BELOW / 2
    rows, _ = winch_rows(Subject(run))
    assert [row["name"] for row in rows] == ["w1", "w2"]
    for row in rows:
        assert float(row["static"]) == pytest.approx(lead, rel=0.01)
        assert float(row["peak"]) > 1.1 * lead


def test_a_bight_on_one_drum_is_one_rope() -> None:
    """A quarter of the load and of what the parts weigh hangs in each part, and half of that part above."""

    def bight(drum: str, x: float) -> str:
        ends = [
            f"{{type: end, body: world, at: [{x} m, {y} m, {BELOW} m], drum: {drum}}}" for y in (-0.5, 0.5)
        ]
        way = f"enter: [{x} m, -0.5 m, 2 m], leave: [{x} m, 0.5 m, 2 m], bulge: [0, 0, -1]"
        return f"{ends[0]}, {{type: half_turn, body: section, {way}}}, {ends[1]}"

    text = _lift({"w1": bight("w1", -15.0), "w2": bight("w2", 15.0)})
    rows, left_out = winch_rows(Subject(Statics(parse_scenario(text)).equilibrium(time=0.0).recording))
    assert [(row["name"], row["rope"], left_out) for row in rows] == [("w1", "on_w1", 0), ("w2", "on_w2", 0)]
    for row in rows:
        assert float(row["static"]) == pytest.approx(LOAD / 4 + ROPE * LENGTH, abs=0.051)
