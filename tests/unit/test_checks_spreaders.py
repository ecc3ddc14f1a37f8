"""Checks of lifts with spreaders: rated capacity, lugs at both ends of a sling, shackles, hook load."""

from __future__ import annotations

import math

import pytest

from gantline.checks import Verdict, values_of
from gantline.report.carried import spreader_row
from gantline.report.subject import Subject
from gantline.results.loads.spreaders import thrust
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from gantline.statics import Statics
from mechanics import G
from of_recording import check_of
from spreader_lifts import BAR, LOAD, one_bar, two_below_one, two_hooks

DESIGN = 1.05


def at_rest(text: str) -> Recording:
    return Statics(parse_scenario(text)).equilibrium().recording


def test_rated_capacity_below_a_spreader() -> None:
    """Of the load alone, with contingency."""
    found = check_of(at_rest(one_bar()), "spreader_load_of_rated_capacity")
    assert found.value == pytest.approx(DESIGN * LOAD / 80e3, rel=1e-4)
    assert (found.element, found.verdict, found.limit) == ("bar", Verdict.OK, 1.0)
    found = check_of(at_rest(one_bar().replace("rated_capacity: 80 t", "rated_capacity: 62 t")), found.name)
    assert found.verdict is Verdict.FAILED
    found = check_of(at_rest(one_bar().replace("    rated_capacity: 80 t\n", "")), found.name)
    assert (found.verdict, found.remark) == (Verdict.WARNING, "rated capacity not known: bar")


def test_thrust_in_a_bar() -> None:
    """(W + B)/2 tan a of a load in the middle, by (SP3); contingency raises all of it, B on the safe side."""
    recording = at_rest(one_bar(0.0))
    upper = recording.column("rope_tension", "sling.up_1")[-1]
    sine = 4.0 / (8.0 * (1.0 + upper / 100e6))
    by_hand = (LOAD + BAR) * G / 2 * sine / math.sqrt(1.0 - sine**2)
    assert thrust(recording, recording.rig.spreaders[0])[-1] == pytest.approx(by_hand, rel=1e-6)
    limited = one_bar(0.0).replace("limits: {", "rules: {dynamic_amplification_factor: 1.1}\nlimits: {")
    limited = limited.replace("load_tilt", "spreader_thrust: 200 kN, load_tilt")
    found = check_of(at_rest(limited), "spreader_thrust")
    assert found.value == pytest.approx(1.1 * DESIGN * by_hand, rel=1e-6)
    assert (found.element, found.verdict) == ("bar", Verdict.FAILED)


def test_the_first_page_has_the_checks_of_a_spreader() -> None:
    """Its rated capacity is 80 t; without the rule's factor there is no dynamic thrust at rest."""
    rule = "rules: {dynamic_amplification_factor: 1.1}\nlimits: {"
    recording = at_rest(one_bar().replace("limits: {", rule))
    row = spreader_row(Subject(recording), recording.rig.spreaders[0])
    used = 100 * values_of(recording, "spreader_load_of_rated_capacity")["bar"]
    pushed = values_of(recording, "spreader_thrust")["bar"] / 1e3
    turned = math.degrees(values_of(recording, "spreader_tilt")["bar"])
    assert (row["name"], row["rated"]) == ("bar", "80")
    assert float(row["mass"]) == pytest.approx(BAR / 1e3, abs=0.005)
    told = [float(row[name]) for name in ("used", "thrust", "tilt")]
    assert told == [
        pytest.approx(used, abs=0.05),
        pytest.approx(pushed, abs=0.5),
        pytest.approx(turned, abs=5e-3),
    ]
    bare = at_rest(one_bar().replace("    rated_capacity: 80 t\n", ""))
    row = spreader_row(Subject(bare), bare.rig.spreaders[0])
    assert (row["rated"], row["used"], row["thrust"]) == ("–", "–", "–")


def test_nothing_pushes_a_bar_between_plumb_slings() -> None:
    """Two hooks hold it: 1 kN of 300 kN is left, since the load tilts by 0.1 deg."""
    recording = at_rest(two_hooks())
    assert 0.0 <= thrust(recording, recording.rig.spreaders[0])[-1] < 1e3


def test_a_spreader_has_no_contingency() -> None:
    """The design weight is one of the load: hook load W x 1.05 + B."""
    recording = at_rest(one_bar())
    assert check_of(recording, "static_hook_load").value == pytest.approx((DESIGN * LOAD + BAR) * G, rel=1e-6)
    # Nor have those that hang below another, here two of 1 t each.
    nested = check_of(at_rest(two_below_one()), "static_hook_load")
    assert nested.value == pytest.approx((DESIGN * LOAD + BAR + 2e3) * G, rel=1e-6)
    # Between two hooks each bears its share of the bar.
    shares = values_of(at_rest(two_hooks()), "static_hook_load")
    assert sum(shares.values()) == pytest.approx((DESIGN * LOAD + BAR) * G, rel=1e-6)


def test_lugs_at_both_ends() -> None:
    """Of upper and lower lugs of the bar and of the load; those of a sling carry alike."""
    recording = at_rest(one_bar())
    lugs = values_of(recording, "lug_load_of_capacity")
    assert set(lugs) == {"bar.A1", "bar.A2", "bar.B1", "bar.B2", "module.L1", "module.L2"}
    assert 60.0 * lugs["bar.B1"] == pytest.approx(80.0 * lugs["module.L1"], rel=1e-9)
    upper = recording.column("rope_tension", "sling.up_2")[-1]
    assert lugs["bar.A2"] == pytest.approx(DESIGN * upper / (60e3 * G), rel=1e-9)
    weak = one_bar().replace(
        "B2: {at: [4 m, 0 m, -0.2 m], capacity: 60 t}", "B2: {at: [4 m, 0 m, -0.2 m], capacity: 30 t}"
    )
    found = check_of(at_rest(weak), "lug_load_of_capacity")
    assert (found.verdict, found.element) == (Verdict.FAILED, "bar.B2")


def test_slings_out_of_the_plane_of_a_lug() -> None:
    """Upper slings stand at 30 deg along the bar: across a plate that stands across it."""
    text = one_bar(0.0).replace("A1: {", "A1: {main_plate: yz, ")
    recording = at_rest(text)
    aside = values_of(recording, "lug_out_of_plane_angle")
    length = 8.0 * (1.0 + recording.column("rope_tension", "sling.up_1")[-1] / 100e6)
    assert aside["bar.A1"] == pytest.approx(math.asin(4.0 / length), rel=1e-6)
    assert aside["bar.A2"] == pytest.approx(0.0, abs=1e-6)


def test_side_load_of_a_shackle_at_a_spreader() -> None:
    """Crosby's chart leaves 75 % of the working load limit at 30 deg aside, and all at the other end."""
    text = one_bar(0.0).replace("A1: {", "A1: {main_plate: yz, ")
    shackle = "shackles: {S: {working_load_limit: 85 t}}\nslings:"
    text = text.replace("slings:", shackle).replace(
        "length: 8 m}", "length: 8 m, shackles: {top: S, bottom: S}}"
    )
    recording = at_rest(text)
    used = values_of(recording, "shackle_load_of_working_load_limit")
    straight = DESIGN * recording.column("rope_tension", "sling.up_1")[-1] / (85e3 * G)
    assert used["up_1 top"] == pytest.approx(straight, rel=1e-6)
    assert used["up_1 bottom"] == pytest.approx(straight / 0.75, rel=1e-6)
    assert used["up_2 bottom"] == pytest.approx(straight, rel=1e-3)


def test_a_bar_that_is_lowered_into_the_load() -> None:
    """The bar hangs 6 m over the load's upper side and goes down by 6.5 m: as deep as it is high, 0.4 m."""
    text = (
        one_bar(0.0)
        .replace("hoist: hook, by: 2 m", "lower: hook, by: 6.5 m")
        .replace("{step: hoist,", "{step: down,")
    )
    recording = simulate(parse_scenario(text.replace("duration: 60 s", "duration: 140 s")))
    found = check_of(recording, "no_overlap")
    assert (found.verdict, found.element) == (Verdict.FAILED, "module to bar")
