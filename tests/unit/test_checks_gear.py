"""Checks of hooks, slings, shackles, lugs and ropes against numbers worked out by hand.

The lift is `ringing_lift`: slings S1 to S5 at rest carry 600, 606, 594, 600, 600 kN and ring with 100 kN at
1 Hz; the frame with its sheaves weighs 21.5 t.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from gantline.checks import Check, Verdict, check_recording, has_failed, values_of, verdict_of
from gantline.checks.forces import hook_force, sling_forces
from gantline.checks.slings import bending_factor
from gantline.results.recording import Recording
from of_recording import checks_of
from sample_lift import ALONG, HOOK, LUGS, SLINGS, ringing_lift, sample_recording, sample_rig

G = 9.81
RINGING = math.sin(2 * math.pi * 0.24)  # the highest sample of the ringing: samples are 0.02 s apart
STATIC = [600e3, 606e3, 594e3, 600e3, 600e3]
PEAK = 606e3 + 101e3 * RINGING  # of S2
RIGGING = 21.5e3 * G
HEIGHT = HOOK - 8.65 - 5.0  # from the lugs to the moving sheaves
COSINE = [HEIGHT / math.hypot(x - a, y, HEIGHT) for a, (x, y) in zip(ALONG, LUGS, strict=True)]


def factors(**values: float) -> dict[str, Any]:
    return {name: {"value": value, "source": "test rule"} for name, value in values.items()}


def check(recording: Recording, name: str) -> Check:
    (found,) = checks_of(recording, name)
    return found


def checked(name: str, rig: dict[str, Any]) -> Check:
    return check(ringing_lift(rig=rig), name)


def equilibrium(rig: dict[str, Any] | None = None, contact: float = 0.0) -> Recording:
    """The same lift at rest, as statics give it: one sample."""
    return sample_recording(
        np.zeros(1), tension=np.array([STATIC]), contact=np.full((1, 4), contact), rig=rig or sample_rig()
    )


def design_rig(**limits: Any) -> dict[str, Any]:
    """Simulated with the calculated weight; a contingency of 1.05 upon it."""
    rig = sample_rig(**limits)
    rig["loads"][0] |= {"simulated_mass": 300e3, "calculated_mass": 300e3, "design_mass": 315e3}
    return rig


def test_static_hook_load_is_that_of_the_design_weight() -> None:
    """What the slings carry is raised by 1.05, what hangs between them and the hook is not."""
    carried = sum(force * cosine for force, cosine in zip(STATIC, COSINE, strict=True))
    found = checked("static_hook_load", design_rig(static_hook_load=3.4e6))
    assert found.value == pytest.approx(sum(STATIC) + RIGGING + 0.05 * carried, rel=1e-9)
    assert (found.verdict, found.element, found.time) == (Verdict.OK, "test_hook", None)
    assert found.formula == f"(static 3210.9 kN + {0.05e-3 * carried:.1f} kN to the design weight)"
    assert checked("static_hook_load", design_rig(static_hook_load=3.3e6)).verdict is Verdict.FAILED


def test_every_load_has_a_design_weight_of_its_own() -> None:
    """S1 hangs on a load with a contingency of 1.05, S5 beside it on one with 1.2; both carry 600 kN."""
    rig = design_rig()
    rig["loads"].append({**rig["loads"][0], "name": "beside", "design_mass": 360e3})
    rig["slings"][4]["to_load"] = "beside"
    recording = ringing_lift(rig=rig)
    forces = sling_forces(recording, recording.time >= 0.0)
    assert forces["S1"].static == pytest.approx(1.05 * 600e3, rel=1e-9)
    assert forces["S5"].static == pytest.approx(1.2 * 600e3, rel=1e-9)


def test_what_hung_still_at_another_time_is_no_force_of_this_one() -> None:
    """Of the first 5 s only the frame counts, although slings bear 3 MN in the window after 20 s."""
    recording = ringing_lift(rig=design_rig())
    force = hook_force(recording, ["test_hook"], "hook_load", recording.time < 5.0)
    assert force.static is not None
    assert force.static > sum(STATIC)
    assert force.dynamic == pytest.approx(RIGGING, rel=1e-9)


def test_a_simulated_peak_is_never_multiplied_by_the_rules_factor() -> None:
    static, peak = sum(STATIC) + RIGGING, 5 * (600e3 + 100e3 * RINGING) + RIGGING
    rig = sample_rig(dynamic_hook_load=4e6)
    rig["factors"] = factors(dynamic_amplification_factor=1.1)
    found = checked("dynamic_hook_load", rig)
    assert found.value == pytest.approx(peak, rel=1e-6)  # 3707 kN, not 4078 kN
    assert found.formula == f"max(static {static / 1e3:.1f} kN x 1.1, peak {peak / 1e3:.1f} kN)"
    assert found.time is not None
    rig["factors"] = factors(dynamic_amplification_factor=1.2)
    found = checked("dynamic_hook_load", rig)
    assert found.value == pytest.approx(1.2 * static, rel=1e-6)
    assert found.time is None
    assert "dynamic_amplification_factor 1.2: test rule" in found.source


def test_hoist_load_of_trolley_and_crane() -> None:
    """The rule's factor is on what hangs in the hook, not on hook block and falls (50 kN)."""
    static = sum(STATIC) + RIGGING
    rig = sample_rig()
    rig["factors"] = factors(dynamic_amplification_factor=1.2)
    rig["ratings"] = [
        {"name": "test_hook", "level": "hook", "hooks": ["test_hook"], "rated_capacity": 400e3 * G},
        {
            "name": "upper",
            "level": "trolley",
            "hooks": ["test_hook"],
            "rated_capacity": 395e3 * G,
            "includes_hook_block": True,
        },
    ]
    found = checked("hoist_load_of_rated_capacity", rig)
    assert (found.element, found.limit, found.verdict) == ("trolley upper", 1.0, Verdict.FAILED)
    assert found.value == pytest.approx((1.2 * static + 50e3) / (395e3 * G), rel=1e-6)
    rig["ratings"][1]["rated_capacity"] = None
    found = checked("hoist_load_of_rated_capacity", rig)
    assert (found.element, found.verdict) == ("test_hook", Verdict.WARNING)
    assert found.remark == "not checked, rated capacity not known: trolley upper"


def test_rated_capacity_counts_though_nobody_sets_a_limit() -> None:
    rig = sample_rig()
    rig["hooks"][0]["rated_capacity"] = 350e3 * G
    found = checked("hoist_load_of_rated_capacity", rig)
    assert (found.verdict, found.source) == (Verdict.FAILED, "by definition")
    rig["hooks"][0]["rated_capacity"] = None
    found = checked("hoist_load_of_rated_capacity", rig)
    assert (found.verdict, found.remark) == (Verdict.WARNING, "rated capacity not known: test_hook")


def test_an_equalizer_is_rated_for_what_hangs_still() -> None:
    carried = sum(force * cosine for force, cosine in zip(STATIC, COSINE, strict=True))
    found = checked("equalizer_load_of_rated_capacity", design_rig())
    assert found.value == pytest.approx(1.05 * carried / (330e3 * G), rel=1e-6)
    assert "peak" in found.formula


def test_dynamics_of_a_sling() -> None:
    found = checked("sling_dynamic_factor", sample_rig(sling_dynamic_factor=1.2))
    assert found.value == pytest.approx(1.0 + RINGING / 6.0, rel=1e-6)  # 100 kN upon 600 kN, in all alike
    assert found.verdict is Verdict.OK


def test_what_slings_that_are_off_leave_to_the_others_is_no_dynamics() -> None:
    """From 10 s on four slings carry 750 kN each, from 16 s on five 600 kN, and that stands from 20 s on."""
    rig = sample_rig(sling_dynamic_factor=1.2, hook_dynamic_factor=1.2)
    rig["starts_off"] = ["sling.S5"]
    time = np.linspace(0.0, 40.0, 2001)
    four = ((time >= 10.0) & (time < 16.0))[:, np.newaxis]
    tension = np.where(four, [750e3] * 4 + [0.0], (time >= 16.0)[:, np.newaxis] * 600e3)
    on = [(16.0, "attached", "sling.S5")]
    recording = ringing_lift(rig=rig, tension=tension, events=on)
    found = check(recording, "sling_dynamic_factor")
    assert found.value == 1.0 and found.element == "S5"
    assert "whenever the load hung still, other slings were on or whole than at the peak" in found.remark
    assert recording.metrics()["dynamic_amplification_factor"] == 1.0
    # A load that hung still on the four, before the hoist began at 16 s, has that for its static force.
    work = np.clip(time - 16.0, 0.0, 1.0)
    held = ringing_lift(rig=rig, tension=tension, events=on, energy={"drive_work": work, "gravity": work})
    assert check(held, "sling_dynamic_factor").value == pytest.approx(1.0)
    assert values_of(held, "sling_dynamic_factor").keys() == {f"S{number}" for number in range(1, 6)}
    # Where none comes or goes the same peak is dynamics: 750 kN of 600 kN.
    rig["starts_off"] = []
    whole = ringing_lift(rig=rig, tension=tension, events=[])
    assert check(whole, "sling_dynamic_factor").value == pytest.approx(1.25)


def test_an_equalizer_without_slings_has_no_spread() -> None:
    """A step required `tension_spread: below 5 %` while no sling was on, and had 0 %."""
    rig = sample_rig(tension_spread_when_clear=0.05)
    rig["plan"][0]["require"] = {"tension_spread": {"below": 0.05}}
    rig["starts_off"] = SLINGS
    begun = [(0.0, "step_begin", "hoist"), (20.0, "step_end", "hoist"), (20.0, "step_begin", "hold")]
    recording = ringing_lift(rig=rig, events=[*begun, *((30.0, "attached", rope) for rope in SLINGS)])
    (found,) = [one for one in check_recording(recording) if one.name == "tension_spread" and one.step]
    assert (found.verdict, found.value) == (Verdict.WARNING, None)
    assert found.remark == "none of its slings is on: e1"


def test_both_sling_angles_are_of_one_sling() -> None:
    vertical = checked("sling_angle_from_vertical", sample_rig())
    horizontal = checked("sling_angle_from_horizontal", sample_rig(sling_angle_from_horizontal=1.37))
    assert vertical.element == horizontal.element == "S2"
    assert vertical.value == pytest.approx(math.acos(COSINE[1]))
    assert horizontal.value == pytest.approx(math.asin(COSINE[1]))
    assert horizontal.verdict is Verdict.FAILED  # 78.1 deg is less than 78.5 deg
    assert (
        checked("sling_angle_from_horizontal", sample_rig(sling_angle_from_horizontal=1.36)).verdict == "ok"
    )


def test_sling_angles_of_the_whole_lift_are_those_of_its_lowest_hook() -> None:
    """The hook comes 2 m down by 25 s and goes up again; both angles are of S2 there."""
    time = np.linspace(0.0, 40.0, 2001)
    down = 2.0 * np.sin(math.pi * np.clip(time - 10.0, 0.0, 30.0) / 30.0) ** 2
    lift = ringing_lift(hook=HOOK - down)
    cosine = (HEIGHT - 2.0) / math.hypot(LUGS[1][0] - ALONG[1], LUGS[1][1], HEIGHT - 2.0)
    for name, angle in (("vertical", math.acos(cosine)), ("horizontal", math.asin(cosine))):
        found = check(lift, f"sling_angle_from_{name}")
        assert found.element == "S2"
        assert found.time == pytest.approx(25.0)
        assert found.value == pytest.approx(angle, rel=1e-9)


# 0027/ND rev 11, table 7-1.
BENDING = [
    (1.0, 2.00),
    (1.5, 1.69),
    (2.0, 1.55),
    (3.0, 1.41),
    (4.0, 1.33),
    (5.0, 1.29),
    (6.0, 1.26),
    (7.0, 1.23),
]


@pytest.mark.parametrize(("ratio", "factor"), BENDING)
def test_bending_factor(ratio: float, factor: float) -> None:
    assert bending_factor(ratio) == pytest.approx(factor, abs=0.005)  # printed with two decimals


def test_bending_leaves_nothing_about_a_quarter_of_a_rope() -> None:
    assert bending_factor(0.25) is None
    assert bending_factor(0.26) == pytest.approx(1 / (1 - 0.5 / math.sqrt(0.26)))


def shackled(bow: float | None = 0.12, **shackle: Any) -> dict[str, Any]:
    """All slings 64 mm thick with 75 t shackles at both ends."""
    rig = sample_rig()
    one = {"name": "wb75", "working_load_limit": 75e3 * G, "bow_diameter": bow, **shackle}
    for sling in rig["slings"]:
        sling["shackles"] = {"top": one, "bottom": one}
    for rope in rig["ropes"][1:]:
        rope["diameter"] = 0.064
    return rig


def test_bending_ratio_of_a_sling() -> None:
    """64 mm on a bow of 120 mm: D/d 1.875, factor 1/(1 - 0.5/sqrt(1.875)) = 1.575."""
    found = checked("sling_bending_ratio", shackled())
    assert found.value == pytest.approx(1.875)
    assert found.formula == "120 mm / 64 mm, bending factor 1.575"
    assert (found.verdict, found.has_no_limit) == (Verdict.NOT_CHECKED, True)
    assert checked("sling_bending_ratio", shackled(bow=None)).remark.startswith("bow diameter not known: S1")


@pytest.mark.parametrize("smaller", ["top", "bottom"])
def test_of_both_bows_of_a_sling_the_smaller_counts(smaller: str) -> None:
    """64 mm on 100 mm: D/d 1.5625, factor 1/(1 - 0.5/1.25) = 5/3, also on the force of its rope."""
    rig = shackled()
    for sling in rig["slings"]:
        sling["shackles"][smaller] = sling["shackles"][smaller] | {"bow_diameter": 0.1}
    found = checked("sling_bending_ratio", rig)
    assert found.value == pytest.approx(1.5625)
    assert found.element == f"S1 {smaller}"
    rig["factors"] = factors(**RULE)
    used = values_of(ringing_lift(rig=rig), "rope_load_of_breaking_force")["sling.S2"]
    assert used == pytest.approx(PEAK * 1.3 * 1.3 * 1.5 * 5.0 / 3.0 / 3039e3, rel=1e-6)


def test_static_load_of_a_shackle() -> None:
    found = checked("shackle_load_of_working_load_limit", shackled())
    assert found.value == pytest.approx(606e3 / (75e3 * G), rel=1e-6)
    assert (found.element, found.verdict) == ("S2 top", Verdict.OK)


@pytest.mark.parametrize(
    ("angle", "remains"),
    [
        (9.9, 1.0),
        (10.0, 1.0),
        (10.5, 0.85),
        (20.0, 0.85),
        (30.0, 0.75),
        (45.0, 0.70),
        (55.0, 0.60),
        (90.0, 0.5),
    ],
)
def test_side_load_of_a_shackle(angle: float, remains: float) -> None:
    """S3 hangs plumb (594 kN), and its lug is turned out of plumb by the angle. Crosby's chart."""
    rig = shackled()
    turned = math.radians(angle)
    rig["loads"][0]["lugs"]["L3"]["main_plate_normal"] = [0.0, math.cos(turned), math.sin(turned)]
    rig["slings"] = [rig["slings"][2]]
    found = checked("shackle_load_of_working_load_limit", rig)
    assert found.value == pytest.approx(594e3 / (remains * 75e3 * G), rel=1e-6)
    if remains < 1.0:
        assert found.element == "S3 bottom"
        assert f"x {remains:g} at {angle:.1f} deg aside" in found.formula


def test_side_load_beyond_the_chart_fails() -> None:
    rig = shackled()
    rig["shackle_side_load"] = {"rows": [[math.radians(5.0), 1.0]], "source": "own chart"}
    for name in ("shackle_load_of_working_load_limit", "shackle_dynamic_load_of_strength"):
        found = checked(name, rig)
        assert (found.verdict, found.value, found.element) == (Verdict.FAILED, None, "S1 bottom")
        assert "pulled 6.2 deg aside, beyond the chart of side loads: S1 bottom" in found.remark


def test_dynamic_load_of_a_shackle() -> None:
    """Least of WLL x factor (772.5 kN), MBF/3, proof load; 0027/ND rev 11, 8.2.6."""
    rig = shackled(minimum_breaking_force=3000e3, proof_load=1500e3)
    rig["factors"] = factors(dynamic_amplification_factor=1.05, shackle_breaking_factor=3.0)
    found = checked("shackle_dynamic_load_of_strength", rig)
    assert found.value == pytest.approx(PEAK / (75e3 * G * 1.05), rel=1e-6)
    strength = "min(WLL 735.8 kN x 1.05, MBF 3000.0 kN / 3, proof load 1500.0 kN)"
    assert found.formula == f"peak {PEAK / 1e3:.1f} kN / {strength}; static 606.0 kN x 1.05"
    rig["factors"] = factors(dynamic_amplification_factor=1.05, shackle_breaking_factor=4.5)
    assert checked("shackle_dynamic_load_of_strength", rig).value == pytest.approx(
        PEAK / (3000e3 / 4.5), rel=1e-6
    )
    rig = shackled(proof_load=650e3)
    found = checked("shackle_dynamic_load_of_strength", rig)
    assert found.value == pytest.approx(PEAK / 650e3, rel=1e-6)
    assert found.verdict == Verdict.FAILED
    # The factor is on the working load limit alone.
    rig["factors"] = factors(dynamic_amplification_factor=1.05)
    assert checked("shackle_dynamic_load_of_strength", rig).value == pytest.approx(PEAK / 650e3, rel=1e-6)


def test_a_shackle_is_pulled_aside_at_another_time_than_at_its_peak() -> None:
    """At 30 s, between two peaks, the load is tilted by 25 deg in one sample.

    S3 carries 594 kN there, where side load leaves 75 % of strength: 594 kN/0.75 = 792 kN, more
    than its peak of 692.8 kN, which comes straight.
    """
    rig = shackled()
    rig["loads"][0]["lugs"]["L3"]["main_plate_normal"] = [1.0, 0.0, 0.0]
    rig["slings"] = [rig["slings"][2]]
    time = np.linspace(0.0, 40.0, 2001)
    tilt = np.where(np.abs(time - 30.0) < 0.01, math.radians(25.0), 0.0)
    found = check(ringing_lift(rig=rig, tilt=tilt), "shackle_dynamic_load_of_strength")
    assert found.value == pytest.approx(594e3 / (0.75 * 75e3 * G), rel=1e-6)
    assert found.element == "S3 bottom"
    assert found.time == pytest.approx(30.0)


def test_a_breaking_force_that_the_rule_asks_for_and_nobody_gives() -> None:
    rig = shackled()
    rig["factors"] = factors(shackle_breaking_factor=3.0)
    found = checked("shackle_dynamic_load_of_strength", rig)
    assert found.verdict is Verdict.WARNING
    assert found.remark == "minimum breaking force of wb75 not known, which the rule asks for"


def test_load_of_a_lug() -> None:
    found = checked("lug_load_of_capacity", sample_rig())
    assert found.element == "block.L2"
    assert found.value == pytest.approx(PEAK / (80e3 * G), rel=1e-6)
    rig = sample_rig()
    rig["factors"] = factors(lug_consequence_factor=1.3)
    found = checked("lug_load_of_capacity", rig)
    assert found.value == pytest.approx(1.3 * PEAK / (80e3 * G), rel=1e-6)
    assert found.verdict is Verdict.FAILED
    rig["loads"][0]["lugs"]["L4"]["capacity"] = None
    assert "not checked, lug capacity not known: block.L4" in checked("lug_load_of_capacity", rig).remark


def test_slings_at_one_lug_add_up_as_vectors() -> None:
    """The ropes of the recording stay where they are; c is the cosine between the first and the second."""
    rig = sample_rig()
    rig["slings"][1]["to_lug"] = "L1"
    found = checked("lug_load_of_capacity", rig)
    assert found.element == "block.L1"
    ways = [np.array([a - x, -y, HEIGHT]) for a, (x, y) in zip(ALONG, LUGS, strict=True)][:2]
    c = float(ways[0] @ ways[1] / np.prod([np.linalg.norm(way) for way in ways]))
    first = 600e3 + 100e3 * RINGING
    together = math.sqrt(first**2 + PEAK**2 + 2.0 * first * PEAK * c)
    assert found.value == pytest.approx(together / (80e3 * G), rel=1e-6)


RULE = {"load_factor": 1.3, "consequence_factor": 1.3, "material_factor": 1.5, "termination_factor": 1.0}


def test_utilisation_of_a_rope() -> None:
    """F x 1.3 x 1.3 x 1.5 x 1.575 (bending, above termination) / MBF; 0027/ND rev 11, 7.2 and 7.3."""
    rig = shackled()
    rig["factors"] = factors(**RULE)
    found = checked("rope_load_of_breaking_force", rig)
    bending = 1 / (1 - 0.5 / math.sqrt(120 / 64))
    assert found.element == "sling.S2"
    assert found.value == pytest.approx(PEAK * 1.3 * 1.3 * 1.5 * bending / 3039e3, rel=1e-6)
    assert found.verdict is Verdict.OK  # 92.7 %
    assert found.formula == f"peak {PEAK / 1e3:.1f} kN x 1.3 x 1.3 x 1.5 x bending 1.575 / 3039.0 kN"
    rig["factors"] = factors(**RULE, wear_factor=1.2)
    assert checked("rope_load_of_breaking_force", rig).verdict is Verdict.FAILED


def test_the_least_safety_factor_and_the_termination() -> None:
    """1.3 x 1.0 x 1.5 = 1.95 is less than 2.3; a termination of 1.6 is more than bending."""
    rig = shackled()
    rig["factors"] = factors(
        **{**RULE, "consequence_factor": 1.0, "termination_factor": 1.6}, least_safety_factor=2.3
    )
    assert values_of(ringing_lift(rig=rig), "rope_load_of_breaking_force")["sling.S2"] == pytest.approx(
        PEAK * 2.3 * 1.6 / 3039e3, rel=1e-6
    )


def test_an_equalizing_rope_bends_about_its_sheaves() -> None:
    """46 mm on 0.8 m: D/d 17.39, factor 1.136; half of the mean sling tension."""
    rig = shackled()
    rig["factors"] = factors(**RULE)
    rig["ropes"][0]["diameter"] = 0.046
    rig["bends"] = [{"rope": "e1.equalizing", "element": "e1.equalizing/sheave_1", "diameter": 0.8}]
    found = checked("sheave_bending_ratio", rig)
    assert found.value == pytest.approx(800 / 46)
    assert found.element == "e1.equalizing/sheave_1"
    used = values_of(ringing_lift(rig=rig), "rope_load_of_breaking_force")["e1.equalizing"]
    bending = 1 / (1 - 0.5 / math.sqrt(800 / 46))
    assert used == pytest.approx((300e3 + 50e3 * RINGING) * 2.535 * bending / 1476e3, rel=1e-6)


def test_what_utilisation_needs_is_named() -> None:
    found = checked("rope_load_of_breaking_force", shackled())
    assert found.verdict is Verdict.NOT_CHECKED
    assert found.remark.startswith("the rules have no load_factor, consequence_factor, material_factor, term")
    rig = shackled(bow=0.01)
    rig["factors"] = factors(**RULE)
    found = checked("rope_load_of_breaking_force", rig)
    assert found.verdict is Verdict.FAILED
    assert found.remark.startswith("bent so sharply that no strength is left: sling.S1")


def test_an_equilibrium_goes_through_the_same_code() -> None:
    rig = sample_rig(static_hook_load=3.3e6, load_tilt=0.03)
    at_rest = equilibrium(rig)
    found = check(at_rest, "static_hook_load")
    assert found.value == pytest.approx(sum(STATIC) + RIGGING)
    assert found.verdict == Verdict.OK
    assert check(at_rest, "skew_load_factor").value is not None
    assert check(at_rest, "load_tilt").verdict is Verdict.WARNING  # no tilt stiffness
    assert {one.time for one in check_recording(at_rest)} == {None}


def test_what_came_before_an_equilibrium_does_not_count() -> None:
    """The first of two samples is the start, from which travel is counted; nothing else looks at it."""
    travel = np.array([[0.0] * 5, [0.95, 0.0, -0.7, 0.0, 0.0]])
    tension = np.array([[2e6] * 5, STATIC])
    rig = sample_rig(dynamic_hook_load=4e6)
    rig["factors"] = factors(dynamic_amplification_factor=1.1)
    both = sample_recording(np.array([0.0, 40.0]), tension=tension, travel=travel, rig=rig)
    both = Recording(both.variables, both.coordinates, {**both.attributes, "status": "at rest at 40 s"})
    assert check(both, "dynamic_hook_load").value == pytest.approx(1.1 * (sum(STATIC) + RIGGING))
    assert check(both, "equalizer_travel_used").value == pytest.approx(0.5)
    assert check(both, "lug_load_of_capacity").value == pytest.approx(1.1 * 606e3 / (80e3 * G))
    assert values_of(both, "hook_dynamic_factor") == {}
    rig["limits"]["sling_factor_on_breaking_force"] = 4.0
    both = Recording(both.variables, both.coordinates, {**both.attributes, "rig": rig})
    assert check(both, "sling_factor_on_breaking_force").value == pytest.approx(3039 / 606)


def test_an_equilibrium_has_no_dynamics_of_its_own() -> None:
    at_rest = equilibrium()
    for name in ("hook_dynamic_factor", "sling_dynamic_factor", "dynamic_hook_load"):
        found = check(at_rest, name)
        assert found.verdict is Verdict.NOT_CHECKED
        assert "an equilibrium has no peak" in found.remark
    found = check(at_rest, "lug_load_of_capacity")
    assert found.value == pytest.approx(606e3 / (80e3 * G))
    assert found.verdict == Verdict.WARNING
    assert found.remark.startswith("static only: an equilibrium has no peak")
    rig = sample_rig(dynamic_hook_load=4e6)
    rig["factors"] = factors(dynamic_amplification_factor=1.1)
    at_rest = equilibrium(rig)
    assert check(at_rest, "dynamic_hook_load").value == pytest.approx(1.1 * (sum(STATIC) + RIGGING))
    found = check(at_rest, "lug_load_of_capacity")
    assert found.value == pytest.approx(1.1 * 606e3 / (80e3 * G))
    assert found.verdict == Verdict.OK


def test_an_equilibrium_may_stand_on_its_supports() -> None:
    """Static values are those of the one sample, clear or not."""
    assert check(equilibrium(contact=50e3), "static_hook_load").value == pytest.approx(sum(STATIC) + RIGGING)


def test_a_run_that_ended_at_once_is_no_equilibrium() -> None:
    rig = sample_rig()
    recording = equilibrium(rig)
    ended = Recording(
        recording.variables, recording.coordinates, {**recording.attributes, "status": "failed"}
    )
    assert check(ended, "dynamic_hook_load").formula.startswith("peak ")


def test_without_a_static_force_there_is_only_the_peak() -> None:
    """The load stands on its corners to the end."""
    rig = sample_rig()
    rig["factors"] = factors(dynamic_amplification_factor=1.5)
    contact = np.full((2001, 4), 1e5)
    recording = ringing_lift(rig=rig, contact=contact)
    assert check(recording, "static_hook_load").verdict is Verdict.NOT_CHECKED
    assert check(recording, "skew_load_factor").remark.startswith("no static force")
    found = check(recording, "lug_load_of_capacity")
    assert found.formula == f"peak {PEAK / 1e3:.1f} kN / 784.8 kN"


def test_a_lift_without_gear_lists_no_checks() -> None:
    rig = {**sample_rig(), "loads": [], "hooks": [], "equalizers": [], "slings": [], "ropes": []}
    assert check_recording(ringing_lift(rig=rig)) == []
    assert verdict_of([]) == "NO VERDICT: nothing has been checked"


def test_the_verdict_names_what_governs() -> None:
    checks = check_recording(ringing_lift(rig=sample_rig(load_tilt=0.03)))
    assert not has_failed(checks)
    text = verdict_of(checks)
    peaks = f"hoist_load_of_rated_capacity {(5 * (600e3 + 100e3 * RINGING) + RIGGING) / (400e3 * G):.0%}"
    assert text.startswith(
        f"GO WITH WARNINGS; nearest to their limits: {peaks.replace('%', ' %')}, equalizer_load_of_rated_"
    )
    assert " not checked, " in text and text.endswith(" without a limit")
    failed = check_recording(ringing_lift(rig=sample_rig(sling_factor_on_breaking_force=5.0)))
    used = f"{5.0 * PEAK / 3039e3:.0%}".replace("%", " %")
    assert verdict_of(failed).startswith(f"NO-GO: 1 failed, sling_factor_on_breaking_force {used}; 1 warning")
    four = [Check(f"c{place}", Verdict.FAILED, "", value=1.0 + place, limit=1.0) for place in range(4)]
    parted = Check("rope_parted", Verdict.FAILED, "")
    assert verdict_of([*four, parted]).startswith(
        "NO-GO: 5 failed, rope_parted, c3 400 %, c2 300 % and 2 more;"
    )


def test_utilisation_of_a_least_value() -> None:
    one = Check("x", Verdict.OK, "", value=5.0, limit=4.0, at_least=True)
    assert one.utilisation == pytest.approx(0.8)
    assert Check("x", Verdict.FAILED, "", value=0.0, limit=4.0, at_least=True).utilisation is None
    assert Check("x", Verdict.OK, "", value=0.0, limit=0.0).utilisation is None


def test_slings_of_the_sample_are_named_as_its_ropes() -> None:
    assert [f"sling.{name}" for name in values_of(ringing_lift(), "skew_load_factor")] == SLINGS
