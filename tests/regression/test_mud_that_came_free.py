"""A load that was lifted off its bed as the page on loads in water says was NO-GO: the mud had parted.

Mud and suction are a rope of `mechanics` that breaks at what it takes to come free. As it did `rope_parted`
failed, and no lift with it could ever be a go. It came free. Then every rope of a kind without a breaking
force from the load to what stands was taken for mud, so that a chain that nobody let go of, and that broke as
the load was hoisted, was as planned, and the lift a go. The lift file says what `comes_free`.
"""

from __future__ import annotations

import pytest

from gantline.results.recording import Recording
from gantline.results.ropes.parting import partings
from gantline.scenario import ScenarioError, parse_scenario
from gantline.simulation import simulate
from gantline.statics import Statics
from of_recording import checks_of

HELD = 200e3  # [N]
COMES = "comes_free: true"


def run(
    said: str = COMES, stiffness: float = 100e6, duration: float = 15.0, length: float = 1.0
) -> Recording:
    """A box on the ground with a rope below it, of `length` [m], that holds it down until that has `HELD`.

    The ground gives way by 0.7 mm under it, so that with 1 GN it comes free before the box has come off.
    """
    return simulate(parse_scenario(lift(said, stiffness, duration, length)))


def lift(said: str, stiffness: float = 100e6, duration: float = 15.0, length: float = 1.0) -> str:
    """The same as a lift file, with what is `said` of the rope."""
    return f"""\
format: 1
lift: {{title: Mud}}
duration: {duration} s
ground: {{level: 0 m, friction: 0.5, stiffness: 200 MN/m, damping: 2 MN s/m}}
ropes:
  sling: {{axial_stiffness: 90 MN, damping_time: 10 ms, minimum_breaking_force: 3 MN, mass: none}}
  mud: {{axial_stiffness: {stiffness} N, damping_time: 10 ms, mass: none}}
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
      {said}
      breaks_at: {HELD} N
      route: [{{type: end, body: box, at: [0 m, 0 m, -1 m]}},
              {{type: end, body: world, at: [0 m, 0 m, -1 m]}}]
plan:
  - {{step: up, hoist: hook, speed: 6 m/min, by: 1 m}}
  - {{step: hold, hold: until_end}}
"""


@pytest.mark.parametrize("stiffness", [100e6, 1e9])
def test_it_came_free(stiffness: float) -> None:
    done = run(stiffness=stiffness)
    (mud,) = partings(done)
    assert (mud.kind, mud.tension) == ("came free", HELD)
    assert not checks_of(done, "rope_parted")


def test_equilibria_have_it_until_it_would_come_free() -> None:
    """The hook has risen by x = 0.05 m + 0.1 m/s (t - 1 s). With slings slack by 50 mm at the start, of
    k = 90 MN / 10.05 m, the lug hangs where x - 50 mm - T/k says, the centre of gravity 2 m below it.

    With mud on it, of 100 MN/m, T = W + M and the box has risen by M / 100 MN/m: M = 96 kN after 1.78 s. At
    the end 1235 % of the weight were held down, and no case of a lift off a bed could be a go.
    """
    weight, k, mud = 60e3 * 9.81, 90e6 / 10.05, 100e6
    statics = Statics(parse_scenario(lift(COMES)))
    held = statics.equilibrium(time=1.78).recording.column("rope_tension", "mud")[-1]
    assert held == pytest.approx((0.078 - weight / k) / (1 / k + 1 / mud), rel=1e-6)
    rest = statics.equilibrium(time=15.0).recording
    assert rest.column("rope_tension", "mud")[-1] == 0.0
    assert rest.column("body_position", "box")[-1, 2] == pytest.approx(1.95 - weight / k, rel=1e-6)
    assert not checks_of(rest, "rope_parted")
    assert not checks_of(rest, "let_go_below")


def test_it_has_neither_lug_nor_breaking_force() -> None:
    """Both checks asked for these, and warned that nothing was known of the mud; of a lashing they do."""
    names = ("rope_factor_on_breaking_force", "lug_load_of_capacity")
    mud, lashing = (
        [one.remark for name in names for one in checks_of(run(said), name)] for said in (COMES, "")
    )
    assert len(mud) == len(lashing) == 2
    assert not any("mud" in remark for remark in mud)
    assert all("mud" in remark for remark in lashing)


def test_a_lashing_that_nobody_let_go_of_is_lost() -> None:
    """Of no known strength, as turnbuckles are that have a stiffness alone."""
    done = run("")
    assert [one.kind for one in partings(done)] == ["broken"]
    assert len(checks_of(done, "rope_parted")) == 1


def test_what_breaks_while_the_load_stands_is_lost() -> None:
    """Stretched from the start on by 3 mm of 1 m, less what the box sinks in, before anything is hoisted."""
    done = run(duration=1.0, length=0.997)
    assert [one.kind for one in partings(done)] == ["broken"]
    assert len(checks_of(done, "rope_parted")) == 1


def test_what_cannot_come_free_is_refused() -> None:
    """It does so at a force, and of the load."""
    text = lift(COMES)
    with pytest.raises(ScenarioError, match="what 'comes_free' does so at a force; give it in 'breaks_at'"):
        parse_scenario(text.replace(f"breaks_at: {HELD} N", "breaks_at: never"))
    with pytest.raises(ScenarioError, match="what 'comes_free' holds the load down, and ends at it"):
        parse_scenario(text.replace("type: end, body: box", "type: end, body: hook"))
