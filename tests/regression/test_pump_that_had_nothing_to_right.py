"""Pumps that were to right a vessel pumped nothing, and no line said so.

A module was set down on the port side of a barge, half of it, and a step was to pump until its heel was
`below: 0.1 deg`. Heel counts to starboard: to port it is below every bound, the step was over as it began,
and the rest of the module came on a barge that leaned already. It was a go.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.checks import Check, Verdict, check_recording
from gantline.scenario import parse_scenario

#: A box of 40 by 12 m that displaces 984 t at 2 m, with 20 t of it aside or ahead, and a tank on each side.
LIFT = """
format: 1
lift: {{title: A barge that is righted}}
duration: 900 s
start: rest
water: {{density: 1.025 t/m^3, level: 0 m}}
vessels:
  barge:
    position: [0 m, 0 m]
    draft: 2 m
    hull: {{box: [40 m, 12 m, 4 m]}}
    masses:
      hull: {{mass: 764 t, at: [20 m, 0 m, 2 m]}}
      cargo: {{mass: 20 t, at: [{ahead} m, {aside} m, 5 m]}}
    radii_of_gyration: [4 m, 11 m, 11 m]
    tanks:
      ps: {{box: [10 m, 4 m, 3 m], bottom: [20 m, 4 m, 0.2 m], content: 50 t}}
      sb: {{box: [10 m, 4 m, 3 m], bottom: [20 m, -4 m, 0.2 m], content: 50 t}}
      fore: {{box: [4 m, 8 m, 3 m], bottom: [36 m, 0 m, 0.2 m], content: 50 t}}
      aft: {{box: [4 m, 8 m, 3 m], bottom: [4 m, 0 m, 0.2 m], content: 50 t}}
    added_mass: {{at: [20 m, 0 m, 0 m], heave: 900 t, roll: 8000 t m^2, pitch: 90000 t m^2}}
    water_damping: {{critical: {{heave: 20 %, pitch: 20 %, roll: 20 %}}}}
plan:
  - {{step: right her, pump: {{from: {source}, to: {to}}}, rate: 200 t/h, until: {{{until}}}}}
  - {{step: hold, hold: until_end}}
"""
#: From which tank to which, by what she is righted of.
PUMPS = {"heel": ("barge.ps", "barge.sb"), "trim": ("barge.aft", "barge.fore")}


def told(
    key: str, side: str, ahead: float = 20.0, aside: float = 0.0, check: str = "plan_moves"
) -> Check | None:
    source, to = PUMPS[key]
    until = f"{key}: {{vessel: barge, {side}}}"
    text = LIFT.format(ahead=ahead, aside=aside, source=source, to=to, until=until)
    checks = check_recording(gantline.simulate(parse_scenario(text)))
    return next((one for one in checks if one.name == check), None)


@pytest.mark.parametrize(
    ("key", "side", "ahead", "aside", "other"),
    [
        ("heel", "below: 0.1 deg", 20.0, 4.0, "'above: -0.10 deg'"),
        ("heel", "above: -0.1 deg", 20.0, -4.0, "'below: 0.10 deg'"),
        ("trim", "below: 0.05 deg", 34.0, 0.0, "'above: -0.05 deg'"),
    ],
)
def test_a_vessel_that_leans_the_other_way_is_told(
    key: str, side: str, ahead: float, aside: float, other: str
) -> None:
    """She heels by 20 t x 4 m/(984 t x 4.7 m) = 1 deg, and trims by 20 t x 14 m/(984 t x 66 m) = 0.25 deg.

    4.7 m = 1 m + 6 m (BM) − 1.83 m (KG) − 0.47 m (free surfaces); 66 m likewise.
    """
    found = told(key, side, ahead, aside)
    assert found is not None and found.verdict is Verdict.WARNING
    waits = f"{key} of barge {side.replace(':', '')}"
    assert found.remark.startswith(f"'right her' pumps nothing: it waits for {waits}, and that is")
    assert found.remark.endswith(f"{other} waits for less")


def test_what_pumps_or_needs_no_pumping_is_not_told() -> None:
    """She leans the way that the step rights, lies upright, or is to lean on purpose and does."""
    assert told("heel", "above: -0.1 deg", aside=4.0) is None
    assert told("heel", "below: 0.1 deg") is None
    assert told("heel", "below: -0.1 deg", aside=4.0) is None


def test_a_heel_that_does_not_come_is_told_with_how_far_it_is() -> None:
    """50 t over 8 m are 400 t m, 5 deg over 984 t x 4.7 m: from 1 deg to port they do not bring her to 9."""
    found = told("heel", "above: 9 deg", aside=4.0, check="plan_finished")
    assert found is not None
    assert "waits for heel of barge above 9 deg: " in found.remark


def test_a_plain_body_afloat_has_no_heel_of_a_recording() -> None:
    """It may be waited for as well, and there is no `vessel_heel` of it to look at."""
    text = """
format: 1
lift: {title: A plain barge is righted}
duration: 60 s
start: rest
mechanics:
  bodies:
    barge:
      joint: {type: free, position: [0 m, 0 m, 0 m]}
      mass: 900 t
      inertia: {xx: 15000 t m^2, yy: 110000 t m^2, zz: 110000 t m^2}
      hull: {box: [40 m, 12 m, 4 m], keel: [0 m, 0 m, -2 m]}
      tanks:
        ps: {box: [10 m, 4 m, 3 m], bottom: [0 m, 4 m, -1.8 m], content: 60 t}
        sb: {box: [10 m, 4 m, 3 m], bottom: [0 m, -4 m, -1.8 m], content: 40 t}
plan:
  - {step: right it, pump: {PUMP}, rate: 200 t/h, until: {heel: {vessel: barge, below: 0.1 deg}}}
  - {step: on, pump: {PUMP}, rate: 200 t/h, until: {heel: {vessel: barge, above: 9 deg}}}
"""
    run = gantline.simulate(parse_scenario(text.replace("PUMP", "from: barge.ps, to: barge.sb")))
    names = [one.name for one in check_recording(run)]
    assert "plan_moves" not in names and "plan_finished" in names
