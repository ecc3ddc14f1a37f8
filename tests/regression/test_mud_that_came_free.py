"""A load that was lifted off its bed as the page on loads in water says was NO-GO: the mud had parted.

Mud and suction are a rope of `mechanics` that breaks at what it takes to come free. As it did `rope_parted`
failed, and no lift with it could ever be a go. It came free. A lashing of a known strength that breaks, and
one that breaks while the load stands on its deck, are lost as before.
"""

from __future__ import annotations

import pytest

from gantline.results.recording import Recording
from gantline.results.ropes.parting import partings
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from of_recording import checks_of

HELD = 200e3  # [N]


def run(
    strength: str = "", stiffness: float = 100e6, duration: float = 15.0, length: float = 1.0
) -> Recording:
    """A box on the ground with a rope below it, of `length` [m], that holds it down until that has `HELD`.

    The ground gives way by 0.7 mm under it, so that with 1 GN it comes free before the box has come off.
    """
    return simulate(
        parse_scenario(f"""\
format: 1
lift: {{title: Mud}}
duration: {duration} s
ground: {{level: 0 m, friction: 0.5, stiffness: 200 MN/m, damping: 2 MN s/m}}
ropes:
  sling: {{axial_stiffness: 90 MN, damping_time: 10 ms, minimum_breaking_force: 3 MN, mass: none}}
  mud: {{axial_stiffness: {stiffness} N, damping_time: 10 ms, mass: none{strength}}}
load:
  name: box
  shape: {{box: [8 m, 6 m, 3 m]}}
  weight: {{calculated: 60 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 1 m]}}
  stands_on: ground
  lugs: {{L: {{at: [0 m, 0 m, 3 m], capacity: 200 t}}}}
cranes:
  hook:
    {{type: fixed_hook, at: [0 m, 0 m, 13 m], rated_capacity: 200 t,
      hoist: {{speed: 6 m/min, acceleration: 0.1 m/s^2}}}}
slings: {{S: {{from: hook, to: box.L, rope: sling, length: 10.05 m}}}}
mechanics:
  ropes:
    mud:
      rope: mud
      length: {length} m
      breaks_at: {HELD} N
      route: [{{type: end, body: box, at: [0 m, 0 m, -1 m]}},
              {{type: end, body: world, at: [0 m, 0 m, -1 m]}}]
plan:
  - {{step: up, hoist: hook, speed: 6 m/min, by: 1 m}}
  - {{step: hold, hold: until_end}}
""")
    )


@pytest.mark.parametrize("stiffness", [100e6, 1e9])
def test_it_came_free(stiffness: float) -> None:
    done = run(stiffness=stiffness)
    (mud,) = partings(done)
    assert (mud.kind, mud.tension) == ("came free", HELD)
    assert not checks_of(done, "rope_parted")


def test_a_rope_of_known_strength_is_lost() -> None:
    done = run(", minimum_breaking_force: 250 kN")
    assert [one.kind for one in partings(done)] == ["broken"]
    assert len(checks_of(done, "rope_parted")) == 1


def test_what_breaks_while_the_load_stands_is_lost() -> None:
    """Stretched from the start on by 3 mm of 1 m, less what the box sinks in, before anything is hoisted."""
    done = run(duration=1.0, length=0.997)
    assert [one.kind for one in partings(done)] == ["broken"]
    assert len(checks_of(done, "rope_parted")) == 1
