"""A load whose lashings a step let go of was NO-GO, by `rope_parted` of each of them.

A load that was hoisted against its lashings failed `let_go_below`, whose remark says that 'cut' of a step
lets go of a lashing. Who did so had four ropes that were "cut": `rope_parted` failed, as of slings that are
lost. Of mooring and tag lines that a step cuts it has said `let go` long since. What a load hangs by, and
what is cut at a time of its own, is lost as before.
"""

from __future__ import annotations

import pytest

from gantline.checks import Verdict, check_recording
from gantline.results.recording import Recording
from gantline.results.ropes.parting import partings
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from of_recording import checks_of

STIFFNESS, LENGTH = 10e6, 1.99  # of a lashing, without stretch [N], [m]
PULL = STIFFNESS * (2.0 / LENGTH - 1.0)  # of one that is 2 m long [N]


def run(let_go: str, to: str, own: str = "") -> Recording:
    """A box on the ground with two lashings, from 1.2 m over it to a point 1.6 m farther out.

    `let_go` are words of the step before it is hoisted, `to` the height of that point [m], `own` words of the
    lashings.
    """
    lashings = "\n".join(
        f"    {name}: {{rope: lashing, length: {LENGTH} m, {own}route: [{{type: end, body: box, "
        f"at: [{4 * side} m, 0 m, 0.2 m]}}, {{type: end, body: world, at: [{5.6 * side} m, 0 m, {to} m]}}]}}"
        for name, side in (("fore", 1.0), ("aft", -1.0))
    )
    return simulate(
        parse_scenario(f"""\
format: 1
lift: {{title: Lashings that a step lets go of}}
duration: 20 s
ground: {{level: 0 m, friction: 0.5, stiffness: 200 MN/m, damping: 2 MN s/m}}
ropes:
  sling: {{axial_stiffness: 90 MN, damping_time: 10 ms, minimum_breaking_force: 1500 kN, mass: none}}
  lashing: {{axial_stiffness: {STIFFNESS} N, damping_time: 20 ms, minimum_breaking_force: 600 kN, mass: none}}
load:
  name: box
  shape: {{box: [8 m, 6 m, 3 m]}}
  weight: {{calculated: 60 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 1 m]}}
  stands_on: ground
  lugs:
    L1: {{at: [-3 m,  2 m, 3 m], capacity: 40 t}}
    L2: {{at: [ 3 m,  2 m, 3 m], capacity: 40 t}}
    L3: {{at: [ 3 m, -2 m, 3 m], capacity: 40 t}}
    L4: {{at: [-3 m, -2 m, 3 m], capacity: 40 t}}
cranes:
  hook:
    {{type: fixed_hook, at: [0 m, 0 m, 14.4 m], rated_capacity: 100 t,
      hoist: {{speed: 2 m/min, acceleration: 0.02 m/s^2}}}}
sling_defaults: {{rope: sling, length: 12 m}}
slings:
  S1: {{from: hook, to: box.L1}}
  S2: {{from: hook, to: box.L2}}
  S3: {{from: hook, to: box.L3}}
  S4: {{from: hook, to: box.L4}}
mechanics:
  ropes:
{lashings}
plan:
  - {{step: fastened, hold: 2 s}}
  - {{step: lashings off, hold: 2 s{let_go}}}
  - {{step: lift off, hoist: hook, speed: 1 m/min, until: {{supports: clear}}}}
  - {{step: hold, hold: until_end}}
""")
    )


def test_a_step_lets_go_of_what_holds_down() -> None:
    """They pull EA (2 m/L − 1): 1.6 m aside and 1.2 m down."""
    done = run(", cut: [fore, aft]", to="0")
    found = {one.rope: one for one in partings(done)}
    assert {name: one.kind for name, one in found.items()} == {"fore": "let go", "aft": "let go"}
    # The load sinks into the ground by 3 mm, which is 1 mm of the 10 mm that they stretch: a fifth at most.
    assert found["fore"].tension == pytest.approx(PULL, rel=0.2)
    assert not checks_of(done, "rope_parted")
    assert not checks_of(done, "let_go_below")


@pytest.mark.parametrize(
    ("let_go", "to", "own"),
    [
        ("", "0", "cut_at: 3 s, "),  # at a time of its own
        (", cut: [fore, aft]", "2.4", ""),  # what bears the load
    ],
)
def test_what_is_lost_has_failed(let_go: str, to: str, own: str) -> None:
    done = run(let_go, to, own)
    assert {one.kind for one in partings(done)} == {"cut"}
    checks = [one for one in check_recording(done) if one.name == "rope_parted"]
    assert [one.verdict for one in checks] == [Verdict.FAILED, Verdict.FAILED]
