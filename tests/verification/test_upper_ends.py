"""Ropes are checked at their upper ends, which carry half of their own weight over the tension at the middle.

By hand for a plumb rope and for a hook in parts of line, and against ropes of distributed weight where slings
stand askew. The checks' figures are taken from what they write out.
"""

from __future__ import annotations

import math

import pytest

import gantline
from gantline.checks import check_recording
from gantline.results.recording import Recording
from gantline.results.ropes.upper_end import peak_at_upper_end, utilisation
from gantline.scenario import parse_scenario
from mechanics import G

LOAD = 20e3  # kg
#: Of the ropes [kg/m], [N]: far heavier than real ones, so that it shows.
MASS, STRENGTH = 40.0, 4e6
DYNAMIC = 1.2
SAFETY = {"load_factor": 1.3, "consequence_factor": 1.3, "material_factor": 1.35, "termination_factor": 1.25}
RULE = ", ".join(f"{name}: {value}" for name, value in SAFETY.items())

HOOK = "{{type: fixed_hook, at: [0 m, 0 m, {} m], hoist: {{speed: 5 m/min, acceleration: 0.02 m/s^2}}}}"


def hung(hook: str, slings: str, lugs: str, weight: str = "lumped", stiffness: float = 1e12) -> Recording:
    """The load on its slings for a second, from rest."""
    text = f"""\
format: 1
lift: {{title: Heavy ropes}}
duration: 1 s
start: rest
ropes:
  heavy:
    {{axial_stiffness: {stiffness} N, mass: {MASS} kg/m, diameter: 50 mm, damping_time: 5 ms,
    minimum_breaking_force: {STRENGTH} N}}
  light: {{axial_stiffness: 1e12 N, mass: none, damping_time: 5 ms}}
load:
  name: module
  shape: {{box: [72 m, 4 m, 2 m]}}
  position: [0 m, 0 m, 10 m]
  weight: {{calculated: {LOAD} kg}}
  centre_of_gravity: {{at: [0 m, 0 m, 0 m]}}
  lugs: {lugs}
cranes:
  hook: {hook}
slings: {slings}
plan:
  - {{step: hold, hold: until_end}}
rules: {{dynamic_amplification_factor: {DYNAMIC}, {RULE}}}
limits: {{rope_factor_on_breaking_force: 1, rope_load_of_breaking_force: 100 %}}
"""
    return gantline.simulate(parse_scenario(text.replace("WEIGHT", weight)))


def test_a_plumb_rope_carries_all_its_weight_at_the_top() -> None:
    """(M + m L) g, of which half a rope's weight is over the tension at its middle."""
    length = 60.0
    recording = hung(
        HOOK.format(71),
        "{S: {from: hook, to: module.L, length: 60 m, rope: heavy, rope_weight: WEIGHT}}",
        "{L: {at: [0 m, 0 m, 1 m]}}",
    )
    top = (LOAD + MASS * length) * G
    peak = peak_at_upper_end(recording, "sling.S")
    assert peak is not None
    # A stretch of 2e-7 and the equilibrium of the start, to 1e-9, are all that is left out.
    assert peak.tension == pytest.approx(top, rel=1e-6)
    assert peak.own_weight == pytest.approx(MASS * length * G / 2, rel=1e-6)
    assert utilisation(recording, "sling.S") == pytest.approx(top / STRENGTH, rel=1e-6)
    checks = {one.name: one.value for one in check_recording(recording)}
    assert checks["rope_factor_on_breaking_force"] == pytest.approx(STRENGTH / top, rel=1e-6)


def test_slings_that_stand_askew_agree_with_ropes_of_distributed_weight() -> None:
    """The tension at the upper end of a catenary.

    What is left is what sag does: as a rope of weight W sags it gets shorter, of its length, by up to
    (W/T)^2/24, and what it carries changes in that order: here 6e-4 of 9e-4.
    """
    sling = "{from: hook, to: module.A, length: 55 m, rope: heavy, rope_weight: WEIGHT}"
    slings = f"{{A: {sling}, B: {sling.replace('module.A', 'module.B')}}}"
    lugs = "{A: {at: [-35 m, 0 m, 1 m]}, B: {at: [35 m, 0 m, 1 m]}}"
    lumped, sagging = (
        hung(HOOK.format(53.4), slings, lugs, weight, stiffness=1e9) for weight in ("lumped", "distributed")
    )
    for rope in ("sling.A", "sling.B"):
        one, other = (peak_at_upper_end(recording, rope) for recording in (lumped, sagging))
        assert one is not None
        assert other is not None
        assert one.tension == pytest.approx(other.tension, rel=(MASS * 55.0 * G / other.tension) ** 2 / 24)
        # It is no small part that is added: the tension at the middle is less by 5.6 %.
        assert one.own_weight > 0.05 * other.tension


def test_falls_carry_what_hangs_below_the_upper_sheaves() -> None:
    """W/n + m g (H + pi d/4) at the upper sheaves: W of load and hook block, H the height of the falls.

    The rope that lies half around a sheave of the hook block hangs in two parts of line.
    """
    parts, upper, level, height, diameter = 8, 90.0, 20.0, 2.0, 1.0
    recording = hung(
        f"""
    type: fixed_hook
    at: [0 m, 0 m, {level} m]
    block: {{mass: 1 t, height: {height} m}}
    reeving: {{ropes: 1, parts_each: {parts}, rope: heavy, sheave_diameter: {diameter} m,
      sheave_efficiency: 1.0, upper_sheaves_at: {upper} m, rope_weight: WEIGHT}}
    drum: {{diameter: 1.6 m, spare_turns: 3, wraps_at_start: 3}}
    hoist: {{speed: 5 m/min, acceleration: 0.02 m/s^2}}""",
        "{S: {from: hook, to: module.L, length: 9 m, rope: light}}",
        "{L: {at: [0 m, 0 m, 1 m]}}",
    )
    (rope,) = {segment.rpartition("/")[0] for hook in recording.rig.hooks for segment in hook.falls}
    falls = upper - level - height
    by_hand = (LOAD + 1e3) * G / parts + MASS * G * (falls + math.pi * diameter / 4)
    peak = peak_at_upper_end(recording, rope)
    assert peak is not None
    # The falls stretch by 3e-7 of their length, and lean by what the upper sheaves are farther apart.
    assert peak.tension == pytest.approx(by_hand, rel=1e-5)
    checks = {one.name: one for one in check_recording(recording)}
    used = checks["rope_load_of_breaking_force"]
    assert used.value == pytest.approx(DYNAMIC * math.prod(SAFETY.values()) * by_hand / STRENGTH, rel=1e-5)
    middle, own = (by_hand - MASS * G * falls / 2) / 1e3, MASS * G * falls / 2e3
    both = f"{middle:.1f} kN + own weight {own:.1f} kN"
    assert checks["rope_factor_on_breaking_force"].formula == f"4000.0 kN / ({both})"
    assert used.formula.startswith(f"max((static {both}) x {DYNAMIC}, peak {both}) x ")
