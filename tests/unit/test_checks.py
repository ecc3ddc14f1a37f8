"""Checks: verdicts at, below and above each limit."""

import math
from dataclasses import replace

import numpy as np
import pytest

from gantline.checks import (
    LIMITS,
    Check,
    Verdict,
    check_recording,
    end_of_step,
    governing,
    has_failed,
    verdict_of,
)
from gantline.results.recording import Recording
from gantline.results.rig import Step
from sample_lift import WEIGHT, ringing_lift, sample_recording, sample_rig

HIGHEST = 600e3 + 100e3 * math.sin(2 * math.pi * 0.24)


def only(recording: Recording) -> Check:
    """The check of the one requirement of a step, or else of the one limit that is set."""
    required = any(step.require for step in recording.rig.plan)
    checks = check_recording(recording)
    (check,) = [one for one in checks if (one.step if required else one.name in recording.rig.limits)]
    return check


def with_limit(**limits: object) -> Check:
    return only(ringing_lift(rig=sample_rig(**limits)))


def with_travel(up: float = 0.0, down: float = 0.0) -> Check:
    travel = np.zeros((3, 5))
    travel[1, 0], travel[1, 1] = -up, down
    rig = sample_rig(equalizer_travel_used=0.9)
    return only(sample_recording(np.arange(3.0), tension=np.full((3, 5), 1e5), travel=travel, rig=rig))


def test_every_limit_of_a_lift_file_can_be_checked() -> None:
    from gantline.scenario.limits import Limits
    from gantline.scenario.plan.bounds import Require

    # The rule says from where limits come, the bound of equalising by what a time is counted.
    known = (set(Limits.model_fields) | set(Require.model_fields)) - {"rule", "equalised_below"}
    assert known <= set(LIMITS)


def test_travel_over_its_limit_is_a_warning_and_over_its_stroke_a_failure() -> None:
    assert with_travel(up=0.9 * 1.4).verdict is Verdict.OK
    warning = with_travel(down=0.93 * 1.9)
    assert warning.verdict is Verdict.WARNING
    assert (warning.element, warning.time) == ("e1.2 down", 1.0)
    assert warning.value == pytest.approx(0.93)
    failed = with_travel(up=1.01 * 1.4)
    assert (failed.verdict, failed.element) == (Verdict.FAILED, "e1.1 up")
    assert failed.remark == "e1.1 up 101.0 % at 1.00 s: it would have met its stop, which is not simulated"


def test_checks_are_kept_and_nobody_changes_them_for_another() -> None:
    recording = ringing_lift(rig=sample_rig(load_tilt=0.1))
    first = check_recording(recording)
    told = list(first)
    first.clear()
    assert check_recording(recording) == told
    assert all(one is other for one, other in zip(check_recording(recording), told, strict=True))


def test_what_is_no_number_fails() -> None:
    # A file that somebody else wrote, or that is damaged: a comparison with NaN is false whatever is asked.
    found = with_travel(up=math.nan)
    assert (found.verdict, found.element) == (Verdict.FAILED, "e1.1 up")


def test_travel_past_the_stroke_before_the_load_is_clear_is_a_warning() -> None:
    travel = np.zeros((3, 5))
    travel[:, 2] = [0.0, -1.05 * 1.4, -0.5 * 1.4]
    contact = np.array([[1.0] * 4, [1.0] * 4, [0.0] * 4])
    rig = sample_rig(equalizer_travel_used=0.9)
    recording = sample_recording(
        np.arange(3.0), tension=np.full((3, 5), 1e5), travel=travel, contact=contact, rig=rig
    )
    check = only(recording)
    assert (check.verdict, check.time) == (Verdict.WARNING, 2.0)
    assert check.value == pytest.approx(0.5)
    assert check.remark.startswith("e1.3 up 105.0 % at 1.00 s")
    metrics = recording.metrics()
    assert metrics["travel_used_up"] == pytest.approx(1.05)
    assert metrics["travel_used_up_when_clear"] == pytest.approx(0.5)


def test_no_limit_allows_travel_beyond_the_stroke_of_a_load_that_hangs() -> None:
    travel = np.zeros((3, 5))
    travel[1, 0] = 1.05 * 1.9
    rig = sample_rig(equalizer_travel_used=1.2)
    recording = sample_recording(np.arange(3.0), tension=np.full((3, 5), 1e5), travel=travel, rig=rig)
    assert only(recording).verdict is Verdict.FAILED


@pytest.mark.parametrize(("time", "verdict"), [(0.5, Verdict.WARNING), (2.5, Verdict.FAILED)])
def test_a_stop_that_is_met_warns_before_lift_off_and_fails_after_it(time: float, verdict: Verdict) -> None:
    contact = np.array([[1.0] * 4, [1.0] * 4, [0.0] * 4, [0.0] * 4])
    check = only(
        sample_recording(
            np.arange(4.0),
            tension=np.full((4, 5), 1e5),
            contact=contact,
            events=[(time, "stop_hit", "e1.2")],
            rig=sample_rig(equalizer_travel_used=0.9),
        )
    )
    assert check.verdict is verdict
    assert f"met its stop at {time:.2f} s" in check.remark
    assert "e1.2" in check.remark


@pytest.mark.parametrize(
    ("way", "sampled", "value", "time", "formula"),
    [
        # Between samples at the stop and back.
        (-1.4, 0.95, 1.0, 2.5, "1.400 m / 1.400 m"),
        (1.9, 0.95, 1.0, 2.5, "1.900 m / 1.900 m"),
        # A stop gives a little.
        (-1.4, 1.02, 1.02, 3.0, "1.428 m / 1.400 m"),
    ],
)
def test_a_stop_that_is_met_uses_all_of_the_stroke(
    way: float, sampled: float, value: float, time: float, formula: str
) -> None:
    contact = np.array([[1.0] * 4, [1.0] * 4, [0.0] * 4, [0.0] * 4])
    travel = np.zeros((4, 5))
    travel[3, 1] = sampled * way
    check = only(
        sample_recording(
            np.arange(4.0),
            tension=np.full((4, 5), 1e5),
            contact=contact,
            travel=travel,
            events=[(2.5, "stop_hit", "e1.2")],
            rig=sample_rig(equalizer_travel_used=0.9),
        )
    )
    assert check.verdict is Verdict.FAILED
    assert check.value == pytest.approx(value)
    assert check.time == time
    assert check.utilisation == pytest.approx(value / 0.9)
    assert check.element == ("e1.2 up" if way < 0.0 else "e1.2 down")
    assert check.formula == formula
    assert check.remark == "met its stop at 2.50 s, with the load hanging: e1.2"


def test_travel_required_at_the_end_of_a_step_warns_up_to_the_whole_stroke() -> None:
    travel = np.full((2001, 5), 0.0)
    travel[1:, 0] = 0.93 * 1.9
    rig = rig_with_requirement("hoist", equalizer_travel_used={"below": 0.9})
    assert only(ringing_lift(travel=travel, rig=rig)).verdict is Verdict.WARNING


def test_load_tilt() -> None:
    tilt = np.linspace(0.0, 0.02, 2001)
    within = only(ringing_lift(tilt=tilt, rig=sample_rig(load_tilt=0.0201)))
    assert within.verdict is Verdict.WARNING
    assert within.remark.endswith(
        "tan(tilt) = e/2.50 m with plumb slings, 2.29 deg for 100 mm of centre of gravity"
    )
    unlimited = {check.name: check for check in check_recording(ringing_lift(tilt=tilt, rig=sample_rig()))}
    assert (unlimited["load_tilt"].verdict, unlimited["load_tilt"].limit) == (Verdict.WARNING, None)
    assert unlimited["load_tilt"].remark == within.remark
    failed = only(ringing_lift(tilt=tilt, rig=sample_rig(load_tilt=0.0199)))
    assert (failed.verdict, failed.element, failed.time) == (Verdict.FAILED, "block", 40.0)


def test_load_yaw() -> None:
    """To either side, from where it was at the start; more than half a turn too."""
    clock = np.linspace(0.0, 40.0, 2001)
    yaw = 1.0 - 0.1 * clock
    assert only(ringing_lift(load_yaw=yaw, rig=sample_rig(load_yaw=4.01))).verdict is Verdict.OK
    failed = only(ringing_lift(load_yaw=yaw, rig=sample_rig(load_yaw=3.99)))
    assert (failed.verdict, failed.element, failed.time) == (Verdict.FAILED, "block", 40.0)
    assert failed.value == pytest.approx(4.0, rel=1e-12)
    turned_over = only(ringing_lift(tilt=0.08 * clock, rig=sample_rig(load_yaw=1.0)))
    assert (turned_over.verdict, turned_over.value) == (Verdict.WARNING, None)
    assert "no heading" in turned_over.remark


def test_angles_count_only_while_a_sling_carries() -> None:
    angle = math.atan2(math.hypot(4.1, 2.5), 36.483 - 8.65 - 5.0)  # S2, see test_metrics
    check = with_limit(sling_angle_from_vertical=angle + 1e-6)
    assert (check.verdict, check.element) == (Verdict.OK, "S2")
    assert check.time is not None
    assert check.time >= 10.0
    assert with_limit(sling_angle_from_vertical=angle - 1e-6).verdict is Verdict.FAILED


def test_out_of_plane_angle_is_named_by_its_lug() -> None:
    check = with_limit(lug_out_of_plane_angle=math.radians(10.0))
    assert check.verdict is Verdict.OK
    assert check.element in ("block.L1", "block.L5")  # 2.5 m across the plate on the shortest way
    assert check.value == pytest.approx(math.asin(2.5 / math.hypot(0.7, 2.5, 22.833)))


def test_factor_on_breaking_force_is_a_least_value() -> None:
    factor = 3039e3 / (1.01 * HIGHEST)
    check = with_limit(sling_factor_on_breaking_force=4.0)
    assert (check.verdict, check.element) == (Verdict.OK, "S2")
    assert check.value == pytest.approx(factor)
    assert with_limit(sling_factor_on_breaking_force=factor + 0.01).verdict is Verdict.FAILED


def test_factor_on_breaking_force_of_every_rope() -> None:
    factor = 1476e3 / (HIGHEST / 2)  # the equalizing rope; slings have 3039/707
    check = with_limit(rope_factor_on_breaking_force=factor - 0.01)
    assert (check.verdict, check.element, check.remark) == (Verdict.OK, "e1.equalizing", "")
    assert check.value == pytest.approx(factor)
    assert with_limit(rope_factor_on_breaking_force=factor + 0.01).verdict is Verdict.FAILED
    assert with_limit(sling_factor_on_breaking_force=factor + 0.01).verdict is Verdict.OK


def test_a_factor_for_slings_or_for_all_ropes_is_asked_for() -> None:
    """In the row of all ropes, whose worst may be a luffing rope: either limit answers it."""
    check = next(
        one for one in check_recording(ringing_lift()) if one.name == "rope_factor_on_breaking_force"
    )
    assert check.remark == (
        "neither limits nor rules say how far below its breaking force a sling has to stay: write "
        "'sling_factor_on_breaking_force' under 'limits', or 'rope_factor_on_breaking_force' for all ropes"
    )


def test_ropes_of_unknown_strength_are_named() -> None:
    rig = sample_rig(rope_factor_on_breaking_force=2.0)
    del rig["ropes"][0]["minimum_breaking_force"]
    check = only(ringing_lift(rig=rig))
    assert (check.verdict, check.element) == (Verdict.WARNING, "sling.S2")
    assert check.remark == "not checked, minimum breaking force not known: e1.equalizing"
    rig["limits"] = {"rope_factor_on_breaking_force": 100.0}
    assert only(ringing_lift(rig=rig)).verdict is Verdict.FAILED
    for rope in rig["ropes"]:
        rope["minimum_breaking_force"] = None
    check = only(ringing_lift(rig=rig))
    assert (check.verdict, check.value) == (Verdict.WARNING, None)
    assert check.remark.endswith("not known: e1.equalizing, sling.S1, sling.S2 and 3 more")


def test_slings_of_unknown_strength_are_named() -> None:
    rig = sample_rig(sling_factor_on_breaking_force=4.0)
    rig["slings"][3]["minimum_breaking_force"] = None
    check = only(ringing_lift(rig=rig))
    assert (check.verdict, check.element) == (Verdict.WARNING, "S2")
    assert check.remark == "not checked, minimum breaking force not known: S4"


def test_smallest_tension_counts_only_when_clear() -> None:
    least = 0.99 * (600e3 - 100e3 * math.sin(2 * math.pi * 0.26))
    check = with_limit(smallest_sling_tension_when_clear=10e3)  # the slings are slack until 10 s
    assert (check.verdict, check.element) == (Verdict.OK, "S3")
    assert check.value == pytest.approx(least, rel=1e-3)
    assert with_limit(smallest_sling_tension_when_clear=500e3).verdict is Verdict.FAILED


def test_spread_counts_only_when_clear() -> None:
    time = np.arange(4.0)
    tension = np.array(
        [[1.0, 2, 3, 4, 5], [1, 2, 3, 4, 5], [100, 101, 100, 100, 99], [100, 100, 100, 100, 100]]
    )
    contact = np.array([[1.0] * 4, [1.0] * 4, [0.0] * 4, [0.0] * 4])
    recording = sample_recording(
        time, tension=tension, contact=contact, rig=sample_rig(tension_spread_when_clear=0.05)
    )
    check = only(recording)
    assert (check.verdict, check.time) == (Verdict.OK, 2.0)
    assert check.value == pytest.approx(0.02)


def test_hook_dynamic_factor() -> None:
    static = 5 * 600e3 + 21.5e3 * 9.81
    factor = (5 * HIGHEST + 21.5e3 * 9.81) / static
    check = with_limit(hook_dynamic_factor=1.3)
    assert check.verdict is Verdict.OK
    assert check.value == pytest.approx(factor, rel=1e-6)
    assert with_limit(hook_dynamic_factor=factor - 0.01).verdict is Verdict.FAILED


def test_hoist_load_counts_where_the_rating_includes_the_hook_block() -> None:
    hook_load = 5 * HIGHEST + 21.5e3 * 9.81
    assert with_limit(hoist_load_of_rated_capacity=1.0).value == pytest.approx(hook_load / (400e3 * 9.81))
    rig = sample_rig(hoist_load_of_rated_capacity=0.9)
    rig["hooks"][0]["rating_includes_hook_block"] = True
    check = only(ringing_lift(rig=rig))
    assert check.value == pytest.approx((hook_load + 50e3) / (400e3 * 9.81))
    assert check.verdict is Verdict.FAILED


def test_an_unknown_limit_is_reported_and_not_dropped() -> None:
    check = with_limit(wind_speed=16.0)
    assert (check.name, check.verdict) == ("wind_speed", Verdict.WARNING)
    assert "not known" in check.remark


def test_the_rule_is_no_limit() -> None:
    checks = check_recording(ringing_lift(rig=sample_rig(rule="example")))
    assert "rule" not in [check.name for check in checks]
    assert {check.name for check in checks} <= set(LIMITS)


def test_a_limit_of_a_load_that_never_came_clear_warns() -> None:
    contact = np.full((3, 4), WEIGHT / 8)
    rig = sample_rig(tension_spread_when_clear=0.05)
    recording = sample_recording(np.arange(3.0), tension=np.full((3, 5), 1e5), contact=contact, rig=rig)
    check = only(recording)
    assert check.verdict is Verdict.WARNING
    assert "never came clear" in check.remark


def test_a_lift_without_what_a_limit_is_about_is_not_checked() -> None:
    rig = {**sample_rig(load_tilt=0.03), "loads": []}
    assert only(ringing_lift(rig=rig)).verdict is Verdict.NOT_CHECKED


def rig_with_requirement(step: str, **require: dict[str, float]) -> dict[str, object]:
    rig = sample_rig()
    rig["plan"] = [{"step": step, "kind": "hoist", "require": require}]
    return rig


def test_a_requirement_counts_at_the_end_of_its_step() -> None:
    tilt = np.where(
        np.linspace(0.0, 40.0, 2001) < 15.0, 0.05, 0.01
    )  # upright again before the step ends at 20 s
    rig = rig_with_requirement("hoist", load_tilt={"below": 0.02})
    check = only(ringing_lift(tilt=tilt, rig=rig))
    assert (check.verdict, check.step, check.time) == (Verdict.OK, "hoist", 20.0)
    assert check.value == pytest.approx(0.01)
    strict = rig_with_requirement("hoist", load_tilt={"below": 0.005})
    assert only(ringing_lift(tilt=tilt, rig=strict)).verdict is Verdict.FAILED


def test_a_requirement_from_below() -> None:
    rig = rig_with_requirement("hoist", sling_tension={"above": 550e3})
    check = only(ringing_lift(rig=rig))
    assert (check.verdict, check.element) == (Verdict.OK, "S3")  # the least: 0.99 of 600 kN at a full second
    assert check.value == pytest.approx(594e3)
    rig = rig_with_requirement("hoist", sling_tension={"above": 595e3})
    assert only(ringing_lift(rig=rig)).verdict is Verdict.FAILED


def test_a_requirement_of_a_step_that_did_not_end_is_not_checked() -> None:
    rig = rig_with_requirement("set down", load_tilt={"below": 0.02})
    check = only(ringing_lift(rig=rig))
    assert (check.verdict, check.step) == (Verdict.NOT_CHECKED, "set down")


def test_the_end_of_a_step_is_its_last_sample() -> None:
    recording = ringing_lift()
    mask = end_of_step(recording, Step("hoist"))
    assert mask is not None
    assert recording.time[mask] == [20.0]
    assert end_of_step(recording, Step("lower")) is None


def test_values_read_in_the_units_of_people() -> None:
    check = with_limit(load_tilt=math.radians(2.0))
    assert check.shown(check.limit) == "2.00 deg"
    assert with_limit(smallest_sling_tension_when_clear=10e3).shown(10e3) == "10.0 kN"
    assert check.shown(None) == ""


def test_only_a_failure_fails() -> None:
    assert not has_failed([with_travel(up=0.95 * 1.4), with_limit(wind_speed=1.0)])
    assert has_failed([with_travel(up=1.1 * 1.4)])


def test_a_go_past_a_limit_says_so() -> None:
    # 93 % of the stroke are past the 90 % of the lift file and within the stroke: no failure, no plain GO.
    sentence = verdict_of([with_travel(down=0.93 * 1.9)])
    assert sentence.startswith("GO WITH WARNINGS; past a limit that only warns: equalizer_travel_used 103 %;")
    assert "nearest" not in sentence
    assert verdict_of([with_travel(down=0.5 * 1.9)]).startswith("GO; nearest to their limits")


def test_a_go_past_two_limits_names_both_the_farthest_first() -> None:
    tilt, travel = (
        Check(name, Verdict.WARNING, "", value=value, limit=1.0)
        for name, value in (("load_tilt", 1.1), ("equalizer_travel_used", 1.3))
    )
    within = Check("sling_tension", Verdict.OK, "", value=0.5, limit=1.0)
    past = "past a limit that only warns: equalizer_travel_used 130 %, load_tilt 110 %;"
    assert past in verdict_of([tilt, travel, within])


@pytest.mark.parametrize(("limit", "verdict"), [(1.0, Verdict.FAILED), (1.08, Verdict.OK)])
def test_travel_at_any_time_counts_before_the_load_is_clear(limit: float, verdict: Verdict) -> None:
    """Of three samples that far apart it may have come to 1.05 + 0.5^2/(8 x 1.6) = 1.0695."""
    travel = np.zeros((3, 5))
    travel[:, 2] = [0.0, -1.05 * 1.4, -0.5 * 1.4]
    contact = np.array([[1.0] * 4, [1.0] * 4, [0.0] * 4])
    check = only(
        sample_recording(
            np.arange(3.0),
            tension=np.full((3, 5), 1e5),
            travel=travel,
            contact=contact,
            rig=sample_rig(equalizer_travel_at_any_time=limit),
        )
    )
    assert (check.verdict, check.element, check.time) == (verdict, "e1.3 up", 1.0)
    assert check.value == pytest.approx(1.05)


def test_travel_at_any_time_is_listed_where_a_limit_names_it_only() -> None:
    names = {check.name for check in check_recording(ringing_lift(rig=sample_rig()))}
    assert "equalizer_travel_at_any_time" not in names


def test_the_governing_check_uses_most_of_its_limit() -> None:
    def check(name: str, verdict: Verdict, value: float | None, limit: float | None) -> Check:
        return Check(name, verdict, "", value=value, limit=limit)

    near, nearer = check("a", Verdict.OK, 0.8, 1.0), check("b", Verdict.OK, 1.8, 2.0)
    least = replace(check("c", Verdict.OK, 2.0, 1.9), at_least=True)
    unlimited, unknown = (
        check("d", Verdict.NOT_CHECKED, 5.0, None),
        check("e", Verdict.NOT_CHECKED, None, 1.0),
    )
    assert governing([near, nearer, unlimited, unknown]) is nearer
    assert governing([near, nearer, least]) is least
    assert governing([near, replace(near, name="alike")]) is near
    refused = check("f", Verdict.FAILED, None, 1.0)
    assert governing([near, replace(near, value=9.0, verdict=Verdict.FAILED), refused]) is refused
    assert governing([unlimited, unknown]) is None
