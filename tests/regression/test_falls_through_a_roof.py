"""Falls that ran through a roof beam, and a tag line through a column of the hall: GO, without a warning.

Slings were looked at where they go through structures and hulls; what hangs above the hook was not, nor was
what holds the load's heading, though nothing in a run holds any of them off. The beam would have been in
the way of the falls from the first minute, and the tag line would have bent about the column. So it was with
falls and slings of one crane through the boom of another.
"""

from __future__ import annotations

from math import hypot

import pytest

from crawler_pair import GEAR, MASSES
from gantline.checks import Check, Verdict, check_recording, verdict_of
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from gantline.statics import Statics
from lift_text import changed
from of_recording import checks_of

#: Along x: where the falls hang plumb, from the crane's slewing axis at its radius, and half the load [m].
FALLS, HALF = -8.0 + 16.0, 2.0
#: Where the tag line goes, and how high its ends are [m].
FAR, HIGH, LOW = 30.0, 1.5, 1.0


def lift(beam: float = FALLS, aside: float = 0.0, more: str = "") -> str:
    """A crawler crane lifts 30 t; a beam with its middle at x, a column so far aside of the tag line [m]."""
    return f"""\
format: 1
lift: {{title: Under a roof}}
duration: 60 s
{GEAR}structures:
  beam: {{type: box, x: [{beam - 0.5} m, {beam + 0.5} m], y: [-6 m, 6 m], z: [24 m, 25 m]}}
  column: {{type: box, x: [14 m, 15 m], y: [{aside - 1.0} m, {aside + 1.0} m], z: [0 m, 12 m]}}
load:
  name: cube
  shape: {{box: [{2 * HALF} m, 3 m, 3 m]}}
  position: [{FALLS} m, 0 m, 0 m]
  weight: {{calculated: 30 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 1.5 m]}}
  stands_on: ground
  lugs: {{A: {{at: [-1.5 m, 0 m, 3 m], capacity: 30 t}}, B: {{at: [1.5 m, 0 m, 3 m], capacity: 30 t}}}}
cranes:
  c1:
    type: crawler
    position: [-8 m, 0 m]
    heading: 0 deg
    slew: 0 deg
    tracks: {{length: 9 m, width: 1.5 m, gauge: 8.4 m, mats: 6 m}}
{MASSES}    luffing: {{speed: 3 deg/min, acceleration: 0.02 deg/s^2, range: [30 deg, 82 deg]}}
    hooks: {{H: {{type: H, height: 10 m}}}}
tag_lines:
  east: {{at: [{HALF} m, 0 m, {HIGH} m], to: [{FAR} m, 0 m, {LOW} m], rope: hoist, pull: 1 kN}}
slings:
  A: {{from: c1.H, to: cube.A, rope: sling, length: 7.2 m}}
  B: {{from: c1.H, to: cube.B, rope: sling, length: 7.2 m}}
plan:
  - {{step: up, hoist: c1.H, speed: 3 m/min, by: 1 m}}
  - {{step: look, hold: until_end}}
{more}"""


def told(recording: Recording) -> dict[str, Check]:
    return {one.element: one for one in checks_of(recording, "falls_and_lines_outside")}


def test_a_lead_line_leads_elsewhere() -> None:
    """It goes along the boom to the drum, as long as `lead_line` says, and is drawn plumb below its head: a
    crane that said how long was told that its falls go through what stands below its hook.
    """
    long = ("parts_each", "lead_line: 60 m, parts_each")
    below = changed(lift(aside=12.0), ("z: [24 m, 25 m]", "z: [5 m, 6 m]"), long)
    assert told(simulate(parse_scenario(below))) == {}


def test_falls_through_a_beam_and_a_tag_line_through_a_column() -> None:
    recording = simulate(parse_scenario(lift()))
    found = told(recording)
    assert sorted(found) == ["hoist.c1.H.1", "tag.east"]
    assert {one.verdict for one in found.values()} == {Verdict.WARNING}
    assert "through 'beam'" in found["hoist.c1.H.1"].remark
    # Before anything moves the line leaves the column 15 m - 10 m from the load, going down by 0.5 m in 20 m.
    out = (15.0 - FALLS - HALF) * hypot(1.0, (HIGH - LOW) / (FAR - FALLS - HALF))
    assert found["tag.east"].remark.startswith(
        f"tag.east through 'column', up to {out:.2f} m from their ends"
    )
    assert verdict_of(check_recording(recording)).startswith("GO WITH WARNINGS")


def test_at_rest() -> None:
    assert sorted(told(Statics(parse_scenario(lift())).equilibrium().recording)) == [
        "hoist.c1.H.1",
        "tag.east",
    ]


WATCHED = "watch: [{between: [ropes, beam], smallest: 0 m}, {between: [tag.east, column], smallest: 0 m}]\n"


@pytest.mark.parametrize(
    ("beam", "aside", "more"),
    [(FALLS - 2.0, 3.0, ""), (FALLS, 0.0, WATCHED)],
    ids=["beside", "watched"],
)
def test_nothing_is_said(beam: float, aside: float, more: str) -> None:
    """Falls are 0.7 m broad, and the beam ends 1.5 m beside their middle."""
    assert told(simulate(parse_scenario(lift(beam, aside, more)))) == {}


def beside(hook: float = 10.0, length: float = 7.2) -> str:
    """A second crane to starboard, its boom along y, over the load and through what hangs there.

    Its head is 30 m before its slewing axis, which is 24 m to starboard.
    """
    luffed = MASSES.replace("radius: 16 m", "radius: 30 m")
    second = f"""\
  c2:
    type: crawler
    position: [{FALLS} m, -24 m]
    heading: 90 deg
    slew: 0 deg
    tracks: {{length: 9 m, width: 1.5 m, gauge: 8.4 m, mats: 6 m}}
{luffed}    hooks: {{H: {{type: H, height: 20 m}}}}
tag_lines:
"""
    return changed(
        lift(FALLS - 2.0, 3.0),
        ("tag_lines:\n", second),
        ("height: 10 m", f"height: {hook} m"),
        ("cube.A, rope: sling, length: 7.2 m", f"cube.A, rope: sling, length: {length} m"),
        ("cube.B, rope: sling, length: 7.2 m", f"cube.B, rope: sling, length: {length} m"),
    )


def test_falls_through_the_boom_of_another_crane() -> None:
    """Heel pins 2.5 m high and 1.6 m before the axis: the boom is there 22.4 m of 28.4 m on its way out."""
    high = 2.5 + 22.4 / 28.4 * (63.0**2 - 28.4**2) ** 0.5
    assert high == pytest.approx(46.9, abs=0.05), "below the other's head, 63 m, and over its hook"
    found = told(simulate(parse_scenario(beside())))
    assert sorted(found) == ["hoist.c1.H.1"]
    assert "through 'c2.boom'" in found["hoist.c1.H.1"].remark


def test_slings_through_the_boom_of_another_crane() -> None:
    """50 m long they lead through it from a hook over it, 53 m high."""
    recording = simulate(parse_scenario(beside(53.0, 50.2)))
    assert told(recording) == {}
    (found,) = checks_of(recording, "sling_outside_structures")
    assert found.remark.startswith("A, B through 'c2.boom'")
