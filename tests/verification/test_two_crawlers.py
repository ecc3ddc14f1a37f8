"""Two crawler cranes lift one load: shares by moments, capacity kept back, ground that settles under one."""

from __future__ import annotations

import math

import pytest

from crawler_lift import own_mass
from crawler_pair import GEAR, MASSES
from gantline.checks.check import Verdict
from gantline.checks.run import check_recording
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import Simulation
from mechanics import G
from of_recording import check_of

#: Mass of the load and of a hook block [kg]; height of the hooks at the start and distance between them [m].
LOAD, HOOK_BLOCK, HOOK, APART = 200e3, 7e3, 18.0, 20.0

_CRANE = """\
  {name}:
    type: crawler
    position: [{x} m, 16 m]
    heading: 0 deg
    slew: -90 deg
    rating_includes_hook_block: true
    tracks: {{length: 9 m, width: 1.5 m, gauge: 8.4 m, mats: 6 m, allowed_pressure: 150 kPa{tracks}}}
{masses}    rating: {{radius: [12 m, 14 m, 16 m, 18 m, 20 m], rated: [360 t, 283 t, 231 t, 195 t, 168 t],
      off_lead: 1 deg, side_lead: 1 deg}}
    hooks: {{H: {{type: H, height: 18 m}}}}
"""

_LIFT = """\
format: 1
lift: {{title: Two crawler cranes}}
duration: {duration} s
{gear}load:
  name: beam
  shape: {{box: [28 m, 4 m, 3 m]}}
  position: [0 m, 0 m, 0 m]
  weight: {{calculated: 200 t, contingency: 1.00}}
  inertia: homogeneous
  centre_of_gravity: {{at: [2 m, 0 m, 1.5 m]}}
  stands_on: ground
  lugs: {{A: {{at: [-12 m, 0 m, 3 m]}}, B: {{at: [-8 m, 0 m, 3 m]}}, C: {{at: [8 m, 0 m, 3 m]}},
    D: {{at: [12 m, 0 m, 3 m]}}}}
cranes:
{cranes}slings:
  A: {{from: c1.H, to: beam.A, length: {length!r} m, rope: sling}}
  B: {{from: c1.H, to: beam.B, length: {length!r} m, rope: sling}}
  C: {{from: c2.H, to: beam.C, length: {length!r} m, rope: sling}}
  D: {{from: c2.H, to: beam.D, length: {length!r} m, rope: sling}}
plan:
  - {{step: lift off, hoist: [c1.H, c2.H], speed: 1 m/min, until: {{supports: clear}}}}
  - {{step: up, hoist: [c1.H, c2.H], speed: 1 m/min, by: 0.5 m}}
  - step: hold
    hold: until_end
    require: {{hoist_load_of_rating: below 90 %, moment_of_tipping_moment: below 50 %,
      ground_pressure_of_allowed: below 40 %, hook_level_difference: below 20 mm}}
watch:
  - {{between: [c1, beam], smallest: 2 m}}
{rules}simulation: {{tension_tolerance: 100 N, sample_interval: 0.1 s}}
"""


def lifted(tracks: str = "", rules: str = "", duration: float = 160.0) -> Recording:
    """The lift as it was run; `tracks` of the second crane, after a comma."""
    both = (("c1", -10, ""), ("c2", 10, tracks))
    cranes = "".join(_CRANE.format(name=name, x=x, tracks=own, masses=MASSES) for name, x, own in both)
    length = math.hypot(HOOK - 3.0, 2.0)
    text = _LIFT.format(duration=duration, gear=GEAR, cranes=cranes, length=length + 0.01, rules=rules)
    return Simulation(parse_scenario(text)).run()


def test_shares_by_moments_and_what_is_kept_back() -> None:
    """Centre of gravity 2 m off the middle of 20 m: 80 and 120 t; 20 % over them by the chart at 16 m."""
    recording = lifted(rules="rules: {several_cranes: queensland}\n")
    assert recording.metrics()["final_load_transferred"] == 1.0
    last = recording.time > recording.time[-1] - 20.0
    shares = [recording.column("hook_load", f"{crane}.H")[last].mean() / G for crane in ("c1", "c2")]
    # The heavier hook hangs lower: by the tilt the centre of gravity, 16.5 m below, moves away from it.
    tilt = recording.column("load_tilt", "beam")[last].mean()
    assert 0 < tilt < math.radians(0.5)
    aside = LOAD * (HOOK - 1.5) * math.tan(tilt) / APART
    assert shares == pytest.approx([80e3 + aside, 120e3 - aside], rel=1e-3)
    total = sum(
        recording.column("contact_force", corner)[last].mean()
        for crane in recording.rig.crawlers
        for corner in crane.corners
    )
    # While it still rings; at rest it is exact, see test_crawler.
    assert total == pytest.approx((2 * (own_mass() + HOOK_BLOCK) + LOAD + 2.0) * G, rel=1e-4)
    found = check_of(recording, "hoist_load_of_rating")
    assert found.element == "crane c2"
    assert found.value is not None
    peak = recording.column("hoist_load", "c2.H").max()
    assert found.value == pytest.approx(1.2 * peak / (231e3 * G), rel=0.03)
    assert found.value > 1.2 * 127 / 231
    assert found.verdict is Verdict.OK
    assert "several_cranes_factor 1.2: Mobile crane code of practice 2006" in found.source
    assert check_of(recording, "ground_pressure_of_allowed").verdict is Verdict.OK
    assert check_of(recording, "moment_of_tipping_moment").verdict is Verdict.OK
    # Nearest to the beam, whose side is at 2 m, is the track at 16 m - 8.4 m/2 - 1.5 m/2, at its foot.
    assert recording.column("clearance", "c1 - beam")[0] == pytest.approx(11.05 - 2.0, abs=0.02)


def test_a_hold_point_asks_for_shares_of_what_cranes_may() -> None:
    """Charts, tipping, ground and levels at the last sample of the step: as recorded there, and no other."""
    recording = lifted(rules="rules: {several_cranes: queensland}\n")
    asked = {one.name: one for one in check_recording(recording) if one.step == "hold"}
    tipping = recording["tipping_utilisation"].values[-1]
    pressure = recording["ground_pressure"].values[-1] / 150e3
    assert asked["moment_of_tipping_moment"].value == pytest.approx(tipping.max(), rel=1e-12)
    assert asked["ground_pressure_of_allowed"].value == pytest.approx(pressure.max(), rel=1e-12)
    used = asked["hoist_load_of_rating"].value
    assert used is not None and used <= (check_of(recording, "hoist_load_of_rating").value or 0.0)
    assert used >= 1.2 * recording.column("hoist_load", "c2.H")[-1] / (231e3 * G)
    clear = int((recording.column("load_transferred", "beam") == 1.0).argmax())
    risen = recording["hook_height"].values[-1] - recording["hook_height"].values[clear]
    assert asked["hook_level_difference"].value == pytest.approx(abs(risen[0] - risen[1]), abs=1e-12)
    verdicts = {name: one.verdict for name, one in asked.items()}
    assert verdicts == {
        "hook_level_difference": Verdict.OK,
        "hoist_load_of_rating": Verdict.OK,
        "moment_of_tipping_moment": Verdict.OK,
        "ground_pressure_of_allowed": Verdict.FAILED,
    }


def test_without_a_rule_the_check_says_so() -> None:
    """No rule for several cranes: the load as it is, and a warning."""
    found = check_of(lifted(duration=40.0), "hoist_load_of_rating")
    assert found.verdict is Verdict.WARNING
    assert "2 cranes lift together, and no rule keeps capacity back" in found.remark


def test_ground_that_settles_under_one_of_two_cranes() -> None:
    """50 mm under the track below the boom of the second: it leans 0.34 deg, and its hook comes down."""
    settling = ", settling: {at: 100 s, over: 20 s, by: 50 mm, corners: [right.front, right.back]}"
    recording = lifted(tracks=settling, duration=180.0)
    at = [int(recording.time.searchsorted(time)) for time in (99.0, 179.0)]
    lean = recording.column("crane_trim", "c2")[at]
    assert lean[1] - lean[0] == pytest.approx(-math.atan(0.05 / 8.4), rel=0.05)
    # Two hooks carry by moments whatever their levels; falls that leave plumb take off a little.
    shares = [recording.column("hook_load", "c2.H")[one] for one in at]
    assert shares[1] == pytest.approx(shares[0], rel=0.02)
    # The head goes out by 64 m times the lean: the beam holds both hooks together, so the falls lean.
    out = recording.column("crane_radius", "c2.H")[at]
    assert 0.1 < out[1] - out[0] < 0.5
    assert recording.column("contact_force", "c2.left.front").min() > 0
