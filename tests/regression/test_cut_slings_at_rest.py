"""A sling that has been cut counted at rest as one that is slack.

The table of `gantline statics equalizer_sling_cut` had the four that carry at 1.24 to 1.26 of the mean, of
five, and a tension spread of 126 %; `--level` of a lift with a cut sling ended with "hung so A would be
slack".
"""

from __future__ import annotations

import pytest
from typer.testing import CliRunner

import gantline
from gantline.checks import values_of
from gantline.cli.app import app
from gantline.results import series
from gantline.study.lengths import adjust_lengths
from gantline.study.state import State
from gantline.study.state import values_of as quantities_of

FOUR = """\
format: 1
lift: {title: Four slings}
duration: 30 s
ropes: {s: {axial_stiffness: 100 MN, damping_time: 10 ms, mass: none}}
load:
  name: module
  shape: {box: [6 m, 4 m, 3 m]}
  position: [0 m, 0 m, 0.5 m]
  weight: {calculated: 40 t}
  centre_of_gravity: {at: [0.1 m, 0 m, 1.5 m]}
  lugs:
    A: {at: [-2.5 m,  1.5 m, 3 m]}
    B: {at: [ 2.5 m,  1.5 m, 3 m]}
    C: {at: [-2.5 m, -1.5 m, 3 m]}
    D: {at: [ 2.5 m, -1.5 m, 3 m]}
cranes:
  crane: {type: fixed_hook, at: [0.1 m, 0 m, 11.6 m], hoist: {speed: 3 m/min, acceleration: 0.05 m/s^2}}
slings:
  A: {from: crane, to: module.A, length: 8.6 m, rope: s, cut_at: 25 s}
  B: {from: crane, to: module.B, length: 8.6 m, rope: s}
  C: {from: crane, to: module.C, length: 8.6 m, rope: s}
  D: {from: crane, to: module.D, length: 8.6 m, rope: s}
plan:
  - {step: hold, hold: until_end}
"""


def test_shares_are_of_those_that_are_left() -> None:
    """The mean is of the four that carry, and what they share is all there is: their shares add up to 4."""
    rest = gantline.Statics(gantline.load_scenario("equalizer_sling_cut")).equilibrium()
    recording = rest.recording
    shares = series.of_the_mean(recording)
    assert set(shares) == {"S2", "S3", "S4", "S5"}
    assert [sling.name for sling in series.slings_parted(recording)] == ["S1"]
    assert sum(share or 0.0 for share in shares.values()) == pytest.approx(4.0, rel=1e-12)
    tensions = [rest.tension(f"sling.{name}") for name in shares]
    spread = (max(tensions) - min(tensions)) / (sum(tensions) / 4)
    assert values_of(recording, "tension_spread") == pytest.approx({"e1": spread}, rel=1e-12)
    # What cases show as the smallest sling tension is none of a sling that is gone.
    assert set(quantities_of(State("", "", "none", rest.time, rest))["smallest_sling_tension"]) == set(shares)


def test_before_the_cut_all_share() -> None:
    rest = gantline.Statics(gantline.load_scenario("equalizer_sling_cut")).equilibrium(30.0)
    assert len(series.of_the_mean(rest.recording)) == 5
    assert not series.slings_parted(rest.recording)


def test_the_table_says_that_it_parted() -> None:
    out = CliRunner().invoke(app, ["statics", "equalizer_sling_cut"]).output
    row = next(line for line in out.splitlines() if line.strip().startswith("S1 "))
    assert row.split() == ["S1", "-", "-", "-", "parted"]


def test_what_is_left_can_be_made_level() -> None:
    """On three slings a load hangs level for some lengths; the cut one has kept its own."""
    answer = adjust_lengths(gantline.parse_scenario(FOUR), slopes=(0.0, 0.0), time=30.0)
    turned = answer.after.recording.column("load_tilt", "module")[-1]
    assert turned == pytest.approx(0.0, abs=1e-6)
    assert answer.lengths["A"] == answer.given["A"]
