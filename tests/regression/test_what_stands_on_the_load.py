"""A load with a container on top was never clear of its supports, since the container pressed on it.

The contact of a load and a body counted as one of the load's supports, whichever of the two stood on the
other. So `until: {supports: clear}` never came, the hoist went on, and nothing was known of what hangs
still: no static hook load, and so none with the contingency. What stands on the load from the start is now
carried by it: its contact is a group of its own, as `group` of the lift file could have it.

Nor could such a lift start at rest where the container just touched the load: that was put where it has sunk
into the ground, 1.2 mm down, and left a gap in which friction held nothing: `nothing holds it, it falls
without end`. It goes down with the load now.
"""

from __future__ import annotations

import numpy as np
import pytest

from gantline.assembly import assemble
from gantline.checks import check_recording
from gantline.results import Recording
from gantline.scenario import Scenario, parse_scenario
from gantline.simulation import simulate
from gantline.statics import Statics

#: Load and container [kg].
LOAD, CONTAINER = 100e3, 10e3
CONTINGENCY = 1.1
GRAVITY = 9.81


def lift(height: float = 4.195, place: str = "ground", *, stacked: bool = False) -> Scenario:
    """A box of 3 m, on the ground or on stools of 1 m, and a container with its middle so high [m].

    Where `stacked`, another one stands on that.
    """
    like = "inertia: {xx: 9.6 t m^2, yy: 18.1 t m^2, zz: 18.1 t m^2}, shape: {box: [4 m, 2.4 m, 2.4 m]}"
    first, above = (f"{{type: free, position: [0.5 m, 0 m, {z} m]}}" for z in (height, height + 2.4))
    second = f"second: {{joint: {above}, mass: {CONTAINER / 1e3} t, {like}}}" if stacked else ""
    law = "stiffness: 100 MN/m, damping: 1 MN s/m, friction: 0.3"
    between = f"more: {{between: [second, container], {law}}}" if stacked else ""
    foot = 0.0 if place == "ground" else 1.0
    grid = "{under: box, grid: {x: [-4 m, 4 m], y: [-2 m, 2 m]}, height: 1 m, stiffness: 100 MN/m}"
    stools = "" if place == "ground" else f"supports: {{stools: {grid}}}"
    slings = "".join(f"  {name}: {{from: crane, to: box.{name}}}\n" for name in "ABCD")
    return parse_scenario(f"""
format: 1
lift: {{title: A container on a load}}
duration: 40 s
ground: {{level: 0 m, friction: 0.4, stiffness: 200 MN/m, damping: 2 MN s/m}}
ropes: {{sling: {{axial_stiffness: 100 MN, damping_time: 10 ms, mass: none}}}}
{stools}
load:
  name: box
  shape: {{box: [10 m, 6 m, 3 m]}}
  position: [0 m, 0 m, {foot} m]
  weight: {{calculated: {LOAD / 1e3} t, contingency: {CONTINGENCY}, simulate: calculated}}
  centre_of_gravity: {{at: [0 m, 0 m, 1.5 m]}}
  stands_on: {place}
  lugs:
    A: {{at: [ 4 m,  2.5 m, 3 m]}}
    B: {{at: [ 4 m, -2.5 m, 3 m]}}
    C: {{at: [-4 m,  2.5 m, 3 m]}}
    D: {{at: [-4 m, -2.5 m, 3 m]}}
cranes:
  crane:
    type: fixed_hook
    at: [0 m, 0 m, {13.0 + foot} m]
    hoist: {{speed: 6 m/min, acceleration: 0.05 m/s^2}}
sling_defaults: {{rope: sling, length: 11.12 m}}
slings:
{slings}mechanics:
  bodies:
    container: {{joint: {first}, mass: {CONTAINER / 1e3} t, {like}}}
    {second}
  body_contacts:
    on: {{between: [container, box], {law}}}
    {between}
plan:
  - {{step: off, hoist: crane, speed: 1 m/min, until: {{supports: clear}}}}
  - {{step: up, hoist: crane, speed: 3 m/min, by: 1 m}}
  - {{step: end, hold: until_end}}
""")


@pytest.fixture(scope="module")
def recording() -> Recording:
    return simulate(lift())


def test_the_load_comes_clear_with_what_stands_on_it(recording: Recording) -> None:
    """The ground lets it go as the slings carry both."""
    assert [name for _, _, name in recording.events("lift_off")][:1] == ["box"]
    assert recording.column("load_transferred", "box")[-1] == 1.0
    hanging = float(np.mean(recording.column("hook_load", "crane")[-250:]))  # it swings about that
    assert hanging == pytest.approx((LOAD + CONTAINER) * GRAVITY, rel=1e-5)


def test_the_static_hook_load_is_known(recording: Recording) -> None:
    """It is raised with the contingency, on the safe side with what stands on the load, too."""
    (check,) = (one for one in check_recording(recording) if one.name == "static_hook_load")
    assert check.value == pytest.approx(CONTINGENCY * (LOAD + CONTAINER) * GRAVITY, rel=1e-5)


@pytest.mark.parametrize(
    ("place", "height", "containers"), [("ground", 4.2, 1), ("stools", 5.2, 1), ("ground", 4.2, 2)]
)
def test_it_starts_where_it_just_touches(place: str, height: float, containers: int) -> None:
    """Its middle is 1.2 m above the top of the load, which sinks in by some millimetres."""
    scenario = lift(height, place, stacked=containers == 2)
    rest = Statics(scenario).equilibrium(0.0, losses="held").recording
    pressed = [rest.column("contact_force", f"on/{number}")[-1] for number in range(1, 9)]
    assert sum(pressed) == pytest.approx(containers * CONTAINER * GRAVITY, rel=1e-6)
    at = rest.column("body_position", "container")[-1]
    assert np.hypot(at[0] - 0.5, at[1]) < 1e-4  # friction holds it


@pytest.mark.parametrize(("height", "group"), [(4.195, "container"), (1.0, "box")])
def test_what_is_carried(height: float, group: str) -> None:
    """What is all above the middle of the load stands on it; a stool beside or below it bears it."""
    document = assemble(lift(height=height)).document
    assert {pair["group"] for pair in document["pairs"] if pair["name"] == "on"} == {group}
