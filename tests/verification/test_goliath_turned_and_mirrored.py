"""One lift under a Goliath crane, turned half way round, mirrored and moved along its rails: all is the same.

Three hooks of two trolleys hoist, traverse and travel with a load that hangs askew in wind, between a tag
line to the ground and one to a leg; nothing in it is symmetric. Rails lie along y of the world whatever is
done to a lift, so it turns by 180 deg alone, and moves along them. Ropes of the hooks weigh nothing and lose
nothing: reeving has a hand of its own, its lead line on one side.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pytest

from gantline.checks import check_recording
from gantline.results import Recording
from gantline.scenario import Scenario, parse_scenario
from gantline.simulation import simulate
from gantline.statics import Statics


@dataclass(frozen=True)
class Seat:
    """Where a lift stands: y times `side`, then x and y times `turn`, then moved along the rails [m]."""

    side: int = 1
    turn: int = 1
    north: float = 0.0

    @property
    def across(self) -> int:
        """Sign of y of the world, and so of what is across the girder."""
        return self.side * self.turn

    def heading(self, angle: float) -> str:
        """A direction in the world."""
        return f"{self.side * angle + (0 if self.turn > 0 else 180)} deg"

    def own(self, x: float, y: float, z: float) -> str:
        """A place in axes of the load."""
        return f"[{x} m, {self.side * y} m, {z} m]"

    def crane(self, x: float, y: float, z: float) -> str:
        """A place in axes of the crane, which are those of the world."""
        return f"[{self.turn * x} m, {self.across * y} m, {z} m]"

    def world(self, x: float, y: float, z: float) -> str:
        """A place in the world."""
        return f"[{self.turn * x} m, {self.across * y + self.north!r} m, {z} m]"

    def between(self, sign: int, low: float, high: float, more: float = 0.0) -> str:
        """A range that a sign turns round."""
        least, most = sorted((sign * low + more, sign * high + more))
        return f"[{least!r} m, {most!r} m]"

    def corner(self, name: str) -> str:
        """The corner of the crane that stands where this one did."""
        leg, _, side = name.rpartition(".")
        return f"{leg}.{ {'front': 'back', 'back': 'front'}[side] if self.across < 0 else side }"


def lift(seat: Seat) -> Scenario:
    """The lift in its seat."""
    turn, across = seat.turn, seat.across
    text = f"""
format: 1
lift: {{title: A lift under a Goliath crane}}
duration: 100 s
ground: {{level: 0 m, friction: 0.3}}
wind: {{speed: 9 m/s, direction: {seat.heading(65)}}}
ropes:
  sling: {{axial_stiffness: 300 MN, damping_time: 5 ms, mass: 20 kg/m, diameter: 90 mm}}
  hoist: {{axial_stiffness: 200 MN, damping_time: 10 ms, mass: none, diameter: 54 mm}}
  tag: {{axial_stiffness: 1 MN, damping_time: 50 ms, mass: none}}
load:
  name: module
  shape: {{box: [18 m, 8 m, 5 m]}}
  position: {seat.world(-20, 4, 5)}
  heading: {seat.heading(12)}
  weight: {{calculated: 160 t, contingency: 1.1}}
  inertia: {{xx: 1500 t m^2, yy: 5000 t m^2, zz: 6000 t m^2, xy: {200 * seat.side} t m^2, xz: -300 t m^2}}
  centre_of_gravity: {{at: {seat.own(0.6, -0.4, 2)}}}
  wind_areas: {{side: {{area: 90 m^2, coefficient: 1.2, along: y, at: {seat.own(1, 1, 2)}}}}}
  lugs:
    A: {{at: {seat.own(7, 2, 5)}, main_plate: {{turned: {20 * seat.side} deg}}}}
    B: {{at: {seat.own(7, -2, 5)}}}
    C: {{at: {seat.own(-7, 2, 5)}}}
    D: {{at: {seat.own(-7, -2, 5)}}}
hook_types:
  H:
    rated_capacity: 100 t
    highest: 60 m
    block: {{mass: 7 t, height: 2 m}}
    reeving: {{ropes: 2, parts_each: 6, rope: hoist, sheave_diameter: 0.7 m, upper_sheaves_at: 70 m}}
    drum: {{diameter: 0.8 m}}
    hoist: {{speed: 10 m/min, acceleration: 0.05 m/s^2}}
cranes:
  g:
    type: goliath
    rating_includes_hook_block: true
    span: 130 m
    position: {3 * across + seat.north!r} m
    girder: {{underside: 66 m, mass: 2000 t, vertical_stiffness: 50 MN/m}}
    legs: {{fixed: 600 t, hinged: 400 t, bogies: 500 t, fixed_leg_at: {-65 * turn} m, base: 30 m}}
    travel: {{speed: 30 m/min, acceleration: 0.05 m/s^2, range: {seat.between(across, -80, 90, seat.north)}}}
    hook_approach: 10 m
    hook_distance: 8 m
    trolleys:
      up:
        mass: 200 t
        position: {-27 * turn} m
        traverse: {{speed: 25 m/min, acceleration: 0.04 m/s^2, range: {seat.between(turn, -50, 40)}}}
        hooks:
          U1: {{type: H, across: {3 * across} m, height: 25 m}}
          U2: {{type: H, across: {-1.5 * across} m, along: {0.4 * turn} m, height: 25.2 m}}
      low:
        mass: 150 t
        position: {-13 * turn} m
        traverse: {{speed: 25 m/min, acceleration: 0.04 m/s^2, range: {seat.between(turn, -50, 50)}}}
        hooks: {{L: {{type: H, across: {1 * across} m, along: {-0.5 * turn} m, height: 24.5 m}}}}
sling_defaults: {{rope: sling}}
slings:
  A: {{from: g.L, to: module.A, length: 15.2 m}}
  B: {{from: g.L, to: module.B, length: 15.3 m}}
  C: {{from: g.U1, to: module.C, length: 15.6 m}}
  D: {{from: g.U2, to: module.D, length: 15.9 m}}
tag_lines:
  ground: {{at: {seat.own(9, 4, 1)}, to: {seat.world(-5, 35, 1)}, rope: tag, pull: 3 kN}}
  leg: {{at: {seat.own(9, -4, 1)}, to: {seat.crane(65, 4, 5)}, held_by: g, rope: tag, pretension: 2 kN}}
plan:
  - {{step: hoist, hoist: [U1, U2], speed: 3 m/min, by: 0.8 m}}
  - {{step: follow, traverse: low, starts: with_previous, speed: 10 m/min, keep_plumb: L}}
  - {{step: along, traverse: [up, low], speed: 12 m/min, by: {6 * turn} m}}
  - {{step: travel, travel: g, starts: with_previous, speed: 12 m/min, by: {-5 * across} m}}
  - {{step: back, travel: g, speed: 6 m/min, to: {0 * across + seat.north!r} m}}
  - {{step: end, hold: until_end}}
limits: {{falls_out_of_plumb: 5 deg, lug_out_of_plane_angle: 40 deg, hoist_load_of_rated_capacity: 100 %}}
simulation: {{sample_interval: 0.2 s}}
"""
    return parse_scenario(text)


SEATS = [Seat(side=-1), Seat(turn=-1), Seat(north=57.3), Seat(-1, -1, -31.7)]
MEASURED = (
    "rope_tension",
    "hook_load",
    "hoist_load",
    "hook_height",
    "falls_out_of_plumb",
    "corner_load",
    "load_swing",
    "load_tilt",
)


def largest_differences(found: Recording, base: Recording, seat: Seat) -> dict[str, float]:
    """Of each of what is measured, as a share of its largest value."""
    shares = {}
    for name in MEASURED:
        wanted, measured = base[name].values, found[name].values
        if name == "corner_load":
            corners = list(found.coordinates["corner"])
            measured = measured[:, [corners.index(seat.corner(one)) for one in base.coordinates["corner"]]]
        shares[name] = float(np.abs(measured - wanted).max() / np.abs(wanted).max())
    return shares


def verdicts(recording: Recording) -> list[tuple[str, str]]:
    return [(check.name, str(check.verdict)) for check in check_recording(recording)]


@pytest.fixture(scope="module")
def at_rest() -> Recording:
    return Statics(lift(Seat())).equilibrium().recording


@pytest.mark.parametrize("seat", SEATS)
def test_at_rest(seat: Seat, at_rest: Recording) -> None:
    """The end of the plan at rest: what is measured is the same but for rounding, and so are verdicts."""
    found = Statics(lift(seat)).equilibrium().recording
    # Searches end where forces balance to 1e-9.
    assert max(largest_differences(found, at_rest, seat).values()) < 1e-8
    assert verdicts(found) == verdicts(at_rest)


@pytest.fixture(scope="module")
def in_motion() -> Recording:
    return simulate(lift(Seat()), tension_tolerance=5.0, position_tolerance=1e-6)


@pytest.mark.parametrize("seat", SEATS)
def test_in_motion(seat: Seat, in_motion: Recording) -> None:
    """The whole plan in motion, to the tolerance of its tensions."""
    found = simulate(lift(seat), tension_tolerance=5.0, position_tolerance=1e-6)
    # 5 N of 600 kN: methods choose their steps by errors that do not turn with the lift.
    assert max(largest_differences(found, in_motion, seat).values()) < 1e-5
    assert verdicts(found) == verdicts(in_motion)
