"""Checks of simulated lifts against figures worked out by hand."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from typer.testing import CliRunner

from gantline import simulate
from gantline.checks import check_recording, values_of
from gantline.cli.app import app
from gantline.results import series
from gantline.results.loads.skew import skew_loads
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from of_recording import checks_of
from sample_lift import sample_recording, sample_rig

G = 9.81


def run(text: str, **overrides: Any) -> Recording:
    return simulate(parse_scenario(text), **overrides)


# 300 t on four slings from one hook. EA is 80 GPa on 0.785 d^2 (0027/ND rev 11, 5.6.13), d = 60 mm; sling S1
# is short. The lugs are at the corners of a square of 4 m.
EA = 80e9 * 0.785 * 0.06**2
LENGTH = 10.0
FOUR = f"""\
format: 1
lift: {{title: Four slings}}
duration: 60 s
start: as_given
ropes: {{sling: {{axial_stiffness: {EA} N, damping_time: 50 ms, diameter: 60 mm}}}}
load:
  name: block
  shape: {{box: [6 m, 6 m, 2 m]}}
  position: [0 m, 0 m, 0 m]
  weight: {{calculated: 300 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 1 m]}}
  lugs:
    L1: {{at: [-2 m, -2 m, 2 m], capacity: 100 t}}
    L2: {{at: [ 2 m, -2 m, 2 m], capacity: 100 t}}
    L3: {{at: [ 2 m,  2 m, 2 m], capacity: 100 t}}
    L4: {{at: [-2 m,  2 m, 2 m], capacity: 100 t}}
cranes:
  hook: {{type: fixed_hook, at: [0 m, 0 m, HEIGHT m], hoist: {{speed: 1 m/min, acceleration: 0.1 m/s^2}}}}
slings:
  S1: {{from: hook, to: block.L1, length: SHORT m, rope: sling}}
  S2: {{from: hook, to: block.L2, length: {LENGTH} m, rope: sling}}
  S3: {{from: hook, to: block.L3, length: {LENGTH} m, rope: sling}}
  S4: {{from: hook, to: block.L4, length: {LENGTH} m, rope: sling}}
simulation: {{sample_interval: 100 ms}}
"""


def four_slings(short: float, rules: str = "") -> Recording:
    """Hung where slings of perfect lengths are in balance, so that it comes to rest soon."""
    strain = 300e3 * G / 4 / math.sqrt(1 - 8 / LENGTH**2) / EA
    height = 2.0 + math.sqrt((LENGTH * (1 + strain)) ** 2 - 8.0)
    text = FOUR.replace("HEIGHT", repr(height)).replace("SHORT", repr(LENGTH - short))
    return run(rules + text)


@pytest.mark.parametrize("short", [0.0, 0.005, 0.02])
def test_one_short_sling_of_four(short: float) -> None:
    """A rigid load gives way to all that lengths ask but their one free pattern, +1 -1 +1 -1.

    Along it the stretches add up to the missing length: x = k d/4 upon the force W/(4 cos) of each, so that
    the factor is 1 + k d cos/W. Here k = EA/L, L stretched by 0.34 %, and the attitude changes by a
    thousandth: a quarter of a per cent of what is above 1, allowed is half of one.
    """
    recording = four_slings(short)
    cosine = math.sqrt(1 - 8 / LENGTH**2)
    expected = 1.0 + EA / LENGTH * short * cosine / (300e3 * G)
    skews = {one.sling: one for one in skew_loads(recording)}
    for sling in ("S1", "S3"):
        assert skews[sling].factor == pytest.approx(expected, abs=0.005 * (expected - 1.0) + 1e-6)
    for sling in ("S2", "S4"):
        assert skews[sling].factor == pytest.approx(2.0 - expected, abs=0.005 * (expected - 1.0) + 1e-6)
    assert recording.metrics()["skew_load_factor"] == pytest.approx(expected, rel=0.002)
    assert all(one.lengths_decide for one in skews.values())


def test_the_skew_load_factor_of_the_rule_is_for_slings_whose_lengths_decide() -> None:
    """Force with perfect lengths x 1.25 x 1.1, above what 10 mm add; under an equalizer (below) no 1.25."""
    recording = four_slings(0.01, "rules: {skew_load_factor: 1.25, dynamic_amplification_factor: 1.1}\n")
    used = values_of(recording, "lug_load_of_capacity")
    for skew in skew_loads(recording):
        lug = f"block.L{skew.sling[1]}"
        assert used[lug] == pytest.approx((skew.perfect or 0.0) * 1.25 * 1.1 / (100e3 * G), rel=1e-6)
    (check,) = checks_of(recording, "lug_load_of_capacity")
    assert " with perfect lengths x 1.25) x 1.1, peak " in check.formula
    assert (
        check.source
        == "by definition; skew_load_factor 1.25: lift file; dynamic_amplification_factor 1.1: lift file"
    )


# One hook of lift B: a third of 350 t, and an equalizer of 20 t with five moving sheaves of 300 kg. Five
# slings of 158.4 kg and ten shackles of 21 kg: 22.5 t of rigging in all. Hook block and falls 17 t.
HOOK_OF_B = """\
format: 1
lift: {title: One hook of a Goliath crane}
duration: 40 s
start: as_given
ropes:
  sling: {construction: 6x36 IWRC, grade: 1960, diameter: 44 mm, damping_time: 50 ms}
  equalizing: {axial_stiffness: 97.3 MN, damping_time: 50 ms, mass: none, diameter: 46 mm}
shackles: {wb40: {working_load_limit: 40 t, mass: 21 kg, bow_diameter: 97 mm, pin_diameter: 51 mm}}
lug_types: {PL40: {main_plate: xz, capacity: 40 t}}
load:
  name: block
  shape: {box: [12 m, 12 m, 6 m]}
  position: [0 m, 0 m, 0 m]
  weight: {calculated: 116.6667 t, contingency: 1.05}
  centre_of_gravity: {at: [0 m, 0 m, 3 m]}
  lugs:
    L1: {at: [-3.2 m, 0 m, 6 m], type: PL40}
    L2: {at: [-1.6 m, 0 m, 6 m], type: PL40}
    L3: {at: [ 0.0 m, 0 m, 6 m], type: PL40}
    L4: {at: [ 1.6 m, 0 m, 6 m], type: PL40}
    L5: {at: [ 3.2 m, 0 m, 6 m], type: PL40}
cranes:
  U1:
    type: fixed_hook
    at: [0 m, 0 m, 34.68 m]
    rated_capacity: 300 t
    rating_includes_hook_block: true
    hook_block_mass: 17 t
    hoist: {speed: 5 m/min, acceleration: 0.02 m/s^2}
hook_groups:
  upper: {type: trolley, hooks: U1, rated_capacity: 600 t, rating_includes_hook_block: true}
equalizers:
  E1:
    hangs_from: U1
    rated_capacity: 330 t
    frame: {mass: 20 t, length: 8 m, width: 1.6 m, height: 3.3 m, centre_of_gravity_below_hook: 5.0 m}
    hinge: {damping: 100 kN m s}
    rope: equalizing
    rope_ends:      {along: [-3.6 m, 3.6 m], below_hook: 6.65 m}
    fixed_sheaves:  {along: [-2.4 m, -0.8 m, 0.8 m, 2.4 m], below_hook: 6.65 m, pitch_diameter: 0.8 m}
    moving_sheaves:
      {along: [-3.2 m, -1.6 m, 0 m, 1.6 m, 3.2 m], below_hook: 8.65 m, pitch_diameter: 0.8 m, mass: 300 kg}
    travel: {up: 1.4 m, down: 1.9 m}
sling_defaults: {rope: sling, length: 20 m, shackles: {top: wb40, bottom: wb40}}
slings:
  S1: {from: E1.1, to: block.L1}
  S2: {from: E1.2, to: block.L2}
  S3: {from: E1.3, to: block.L3}
  S4: {from: E1.4, to: block.L4}
  S5: {from: E1.5, to: block.L5}
rules: {preset: nd_0027_onshore, termination_factor: 1.12}
simulation: {sample_interval: 100 ms}
"""


@pytest.fixture(scope="module")
def hook_of_b() -> Recording:
    return run(HOOK_OF_B)


def test_hook_loads_of_a_goliath_hook(hook_of_b: Recording) -> None:
    """Static 139.2 t, with contingency 145.0 t; x 1.05 = 152.3 t; with hook block and falls 169.3 of 300 t.

    0.5 t of slings and shackles hang on the lugs and are raised with the load, 0.03 t on the safe side.
    """
    checks = {one.name: one for one in check_recording(hook_of_b)}
    metrics = hook_of_b.metrics()
    assert metrics["static_hook_load"] / G == pytest.approx(139.2e3, abs=50.0)
    assert (checks["static_hook_load"].value or 0.0) / G == pytest.approx(145.0e3, abs=60.0)
    rated = checks["hoist_load_of_rated_capacity"]
    assert rated.element == "U1"
    assert "+ hook block and falls 166.8 kN" in rated.formula
    by_rule = (139.17e3 + 0.05 * 117.17e3) * 1.05 + 17e3
    assert values_of(hook_of_b, "hoist_load_of_rated_capacity")["trolley upper"] == pytest.approx(
        max(by_rule, metrics["peak_hoist_load"] / G) / 600e3, rel=1e-3
    )
    assert rated.source.endswith("0027/ND rev 11, table 5-1, onshore, by design weight")


def test_slings_of_a_goliath_hook(hook_of_b: Recording) -> None:
    """23.33 t = 228.9 kN at each lug, plus 100 kg of sling and shackle; no skew under an ideal equalizer."""
    for skew in skew_loads(hook_of_b):
        assert skew.force == pytest.approx((23.333e3 + 100.2) * G, rel=1e-3)
        assert skew.factor == pytest.approx(1.0, abs=1e-4)
    static = values_of(hook_of_b, "shackle_load_of_working_load_limit")
    assert static["S3 bottom"] == pytest.approx((23.333 + 0.1002) * 1.05 / 40, rel=2e-3)
    # D/d 97/44: 1/(1 - 0.5/sqrt(97/44)) = 1.508, above 1.12 for the ferrule; MBF 1351 kN; 1.3 x 1.3 x 1.5.
    bending = 1 / (1 - 0.5 / math.sqrt(97 / 44))
    # The upper end bears the other half of the sling too: 0.409 x 44 x 44/100 kg/m.
    own = 20.0 / 2 * 0.409 * 44**2 / 100 * G
    by_rule = ((23.333e3 + 100.2) * G * 1.05 + own) * 1.05
    force = max(by_rule, series.rope_peak(hook_of_b, "sling.S3")[0] + own)
    used = values_of(hook_of_b, "rope_load_of_breaking_force")
    assert used["sling.S3"] == pytest.approx(force * 2.535 * bending / 1351e3, rel=2e-3)


def test_what_an_equalizer_saves_in_one_command(tmp_path: Path) -> None:
    """Five plumb slings under one frame, the middle one 10 mm short; with pins in all moving sheaves.

    Load and frame are rigid: of the missing length the middle sling takes 4/5 upon its share, k d (1 - 1/5)
    on (W + lumps)/5, k = EA/L with 89.06 MN on 20 m; the other four give a quarter of that each. Nothing
    turns, so it is exact but for what still rings: 1e-5. With sheaves the factor is 1.
    """
    lift = tmp_path / "lift.yaml"
    short = HOOK_OF_B.replace("to: block.L3}", "to: block.L3, length: 19.99 m}")
    lift.write_text(short, encoding="utf-8")
    words = ["compare", str(lift), "--b", "equalizers=locked", "--no-plots", "-o", str(tmp_path / "out")]
    result = CliRunner().invoke(app, words)
    assert result.exit_code == 0, result.output
    factor = json.loads((tmp_path / "out" / "comparison.json").read_text())["metrics"]["skew_load_factor"]
    share = (116.6667e3 / 5 + 100.2) * G
    expected = 1.0 + 0.8 * (100e9 * 0.460 * 0.044**2 / 20.0) * 0.01 / share
    assert factor["a"] == pytest.approx(1.0, abs=1e-4)
    assert factor["b"] == pytest.approx(expected, abs=1e-5)
    assert "\n  skew load factor" in result.stdout


@settings(max_examples=60)
@given(
    tilt=st.floats(-0.6, 0.6, allow_subnormal=False),
    yaw=st.floats(-math.pi, math.pi, allow_subnormal=False),
    normal=st.tuples(*[st.floats(-1.0, 1.0, allow_subnormal=False)] * 3).filter(
        lambda v: math.hypot(*v) > 0.1
    ),
)
def test_angles_of_slings_in_any_attitude(
    tilt: float, yaw: float, normal: tuple[float, float, float]
) -> None:
    """From vertical and from horizontal they make 90 deg; out of plane is what the cross product gives."""
    unit = np.array(normal) / math.hypot(*normal)
    rig = sample_rig()
    for lug in rig["loads"][0]["lugs"].values():
        lug["main_plate_normal"] = list(unit)
    one = sample_recording(
        np.zeros(1), tension=np.full((1, 5), 1e5), tilt=np.array([tilt]), yaw=np.array([yaw]), rig=rig
    )
    vertical, horizontal = (values_of(one, f"sling_angle_from_{of}") for of in ("vertical", "horizontal"))
    aside = values_of(one, "lug_out_of_plane_angle")
    turned = np.array(
        [
            math.cos(tilt) * unit[0] + math.sin(tilt) * unit[2],
            unit[1],
            -math.sin(tilt) * unit[0] + math.cos(tilt) * unit[2],
        ]
    )
    for sling in one.rig.slings:
        along = series.sling_direction(one, sling)[0]
        assert vertical[sling.name] + horizontal[sling.name] == pytest.approx(math.pi / 2, abs=1e-12)
        assert math.cos(vertical[sling.name]) == pytest.approx(along[2], abs=1e-9)
        across = math.atan2(abs(float(turned @ along)), float(np.linalg.norm(np.cross(turned, along))))
        assert aside[f"block.{sling.to_lug}"] == pytest.approx(across, abs=1e-7)
