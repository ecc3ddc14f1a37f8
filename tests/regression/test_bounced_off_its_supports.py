"""A load that bounced off its supports by a millimetre and stood on them again was a GO without that word.

`until: {supports: clear}` held at the top of the bounce and the hook braked there; a shell ring of 62 t then
stood with 0.4 % of its weight on a stool for the rest of the lift. Table and report said "lift-off"
and, check by check, that no static force was known; nothing said that the load had not been lifted.
"""

from __future__ import annotations

from gantline.checks import Check, Verdict, check_recording
from gantline.report import render_report
from gantline.results import series
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate

_LIFT = """\
format: 1
lift: {title: A load that bounces off its supports}
duration: 60 s
ropes:
  sling: {axial_stiffness: 40 MN, damping_time: 50 ms, mass: none, minimum_breaking_force: 900 kN}
load:
  name: shell
  shape: {box: [8 m, 8 m, 2 m]}
  position: [0 m, 0 m, 0.3 m]
  weight: {calculated: 60 t}
  centre_of_gravity: {at: [0.02 m, 0 m, 1 m]}
  stands_on: stools
  lugs: {A: {at: [-3 m, 3 m, 2 m]}, B: {at: [-3 m, -3 m, 2 m]}, C: {at: [3 m, 3 m, 2 m]},
    D: {at: [3 m, -3 m, 2 m]}}
supports:
  stools: {under: shell, grid: {x: [-3 m, 3 m], y: [-3 m, 3 m]}, height: 0.3 m, stiffness: 20 MN/m}
cranes:
  hook: {type: fixed_hook, at: [0 m, 0 m, 12 m], hoist: {speed: 6 m/min, acceleration: 0.05 m/s^2}}
sling_defaults: {rope: sling, length: 10.65 m}
slings:
  A: {from: hook, to: shell.A}
  B: {from: hook, to: shell.B}
  C: {from: hook, to: shell.C}
  D: {from: hook, to: shell.D}
plan:
  - {step: lift off, hoist: hook, speed: 0.3 m/min, until: {supports: clear}}
  - {step: hold, hold: until_end}
"""


def _told(recording: Recording) -> dict[str, Check]:
    return {check.name: check for check in check_recording(recording)}


def test_a_load_that_stands_again_is_told() -> None:
    recording = simulate(parse_scenario(_LIFT))
    (load,) = recording.rig.loads
    share = float(series.support_force(recording, load)[-1]) / load.weight
    assert 0.0 < share < 0.05  # it stands, and nearly all of it hangs
    told = _told(recording)
    assert told["hangs_still"].verdict is Verdict.WARNING
    remark = str(told["hangs_still"].remark)
    assert remark.startswith("no static force is known: hold the load still for 5 s, clear of its supports; ")
    assert f"at the end with {100.0 * share:.2f} % of its weight: hoist it farther" in remark


def test_the_first_page_says_it_before_what_is_not_known_for_it() -> None:
    """Its three places were taken by checks that have no static force, and said no more than that."""
    text = _LIFT + "rules: {preset: nd_0027_onshore, termination_factor: 1.0}\n"
    page = render_report(simulate(parse_scenario(text))).split("Weights")[0]
    first, _, rest = page.partition("stands on its supports again")
    assert rest
    assert "peak of the simulated weight alone" not in first


def test_a_load_that_is_hoisted_on_is_not() -> None:
    farther = "  - {step: on, hoist: hook, speed: 1 m/min, by: 0.1 m}\n  - {step: hold"
    recording = simulate(parse_scenario(_LIFT.replace("  - {step: hold", farther)))
    assert "hangs_still" not in _told(recording)
