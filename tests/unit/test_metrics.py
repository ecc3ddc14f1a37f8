"""Metrics: every number worked out by hand beside its assertion."""

import math

import numpy as np
import pytest

from gantline.results import series
from gantline.results.recording import Recording
from gantline.results.variable import Variable
from sample_lift import WEIGHT, ringing_lift, sample_recording, sample_rig

# Ringing of 100 kN at 1 Hz is highest a quarter of a second after a full second; samples are 20 ms apart.
HIGHEST = 600e3 + 100e3 * math.sin(2 * math.pi * 0.24)


def test_peaks_of_the_slings() -> None:
    metrics = ringing_lift().metrics()
    assert metrics["peak_sling_tension"] == pytest.approx(1.01 * HIGHEST)  # sling S2 carries 1 % more
    assert metrics["peak_sling_tension_time"] % 1.0 == pytest.approx(0.25, abs=0.011)
    assert metrics["peak_equalizing_rope_tension"] == pytest.approx(HIGHEST / 2)
    assert metrics["least_sling_tension_when_clear"] == pytest.approx(0.99 * (1200e3 - HIGHEST), rel=1e-3)


def test_static_values_are_means_that_ringing_does_not_move() -> None:
    metrics = ringing_lift().metrics()
    assert metrics["static_sling_tension.sling.S1"] == pytest.approx(600e3, rel=1e-6)
    assert metrics["static_sling_tension.sling.S2"] == pytest.approx(606e3, rel=1e-6)
    assert metrics["static_hook_load"] == pytest.approx(5 * 600e3 + 21.5e3 * 9.81, rel=1e-6)
    assert metrics["static_hoist_load"] == pytest.approx(5 * 600e3 + 21.5e3 * 9.81 + 50e3, rel=1e-6)
    assert metrics["peak_hook_load"] == pytest.approx(5 * HIGHEST + 21.5e3 * 9.81)
    assert metrics["dynamic_amplification_factor"] == pytest.approx(HIGHEST / 600e3, rel=1e-6)


def test_static_values_do_not_count_samples_that_stand_closer_for_more() -> None:
    """Of what grows with time the mean under sin²(π t/20 s) over 20 s is its middle, 10 s, whatever the grid.

    Trapezia of 0.5 s from 10 to 20 s miss of ∫ t sin² dt = 100 s² h²/12 of what its integrand's slope changes
    by there, from 1 to 0; those of 20 ms before miss 600 times less, and ∫ sin² dt = 10 s, flat at both ends,
    none.
    """
    time = np.concatenate([np.linspace(0.0, 10.0, 501), np.linspace(10.5, 20.0, 20)])
    recording = sample_recording(time, tension=np.full((time.size, 5), WEIGHT / 5))
    everywhere = np.ones(time.size, dtype=np.bool_)
    assert series.static_value(recording, time, everywhere) == pytest.approx(10.0 - 0.5**2 / 120.0, abs=1e-5)


def test_the_quiet_window_begins_when_the_last_drive_rests() -> None:
    recording = ringing_lift()
    window = recording.time[series.quiet_window(recording)]
    assert (window[0], window[-1]) == (20.0, 40.0)


def test_the_quiet_window_begins_at_lift_off_while_a_drive_works_to_the_end() -> None:
    time = np.linspace(0.0, 40.0, 2001)
    recording = ringing_lift(energy={"drive_work": 50.0 * time})
    window = recording.time[series.quiet_window(recording)]
    assert (window[0], window[-1]) == (10.0, 40.0)


def test_lengths_that_a_run_adjusts() -> None:
    """S1 comes to be 20 mm longer and ends 10 mm longer, S2 50 mm shorter; the first rope is no sling."""
    lift = ringing_lift()
    lengthening = np.zeros((len(lift.time), 6))
    lengthening[1000, 1], lengthening[1500, 2], lengthening[-1, 1] = 0.02, -0.05, 0.01
    adjusted = Variable(("time", "rope"), lengthening, "m", "")
    metrics = Recording(
        {**lift.variables, "rope_lengthening": adjusted}, lift.coordinates, lift.attributes
    ).metrics()
    assert metrics["largest_rope_lengthening"] == 0.02
    assert metrics["largest_rope_shortening"] == 0.05
    assert metrics["final_rope_lengthening.sling.S1"] == 0.01
    assert metrics["final_rope_lengthening.sling.S2"] == 0.0


def test_breaking_force_over_peak() -> None:
    assert ringing_lift().metrics()["least_factor_on_breaking_force"] == pytest.approx(
        3039e3 / (1.01 * HIGHEST)
    )


def test_utilisation_of_the_minimum_breaking_force() -> None:
    metrics = ringing_lift().metrics()
    used = "utilisation_of_minimum_breaking_force"
    assert metrics[f"{used}.sling.S2"] == pytest.approx(1.01 * HIGHEST / 3039e3)
    assert metrics[f"{used}.e1.equalizing"] == pytest.approx(HIGHEST / 2 / 1476e3)
    assert metrics[f"peak_{used}"] == metrics[f"{used}.e1.equalizing"]


def test_a_rope_whose_minimum_breaking_force_is_not_known_has_no_utilisation() -> None:
    rig = sample_rig()
    rig["ropes"] = [{"name": "sling.S1", "minimum_breaking_force": 3039e3}, {"name": "sling.S2"}]
    metrics = ringing_lift(rig=rig).metrics()
    assert [name for name in metrics if name.startswith("utilisation")] == [
        "utilisation_of_minimum_breaking_force.sling.S1"
    ]
    before = ringing_lift(rig={key: value for key, value in sample_rig().items() if key != "ropes"}).metrics()
    assert [name for name in before if "utilisation" in name] == []


def test_tension_spread_is_largest_less_least_over_mean() -> None:
    metrics = ringing_lift().metrics()
    assert metrics["final_tension_spread"] == pytest.approx(0.02)  # (1.01 - 0.99)/1
    assert metrics["peak_tension_spread_when_clear"] == pytest.approx(0.02)


def test_slack_slings_have_no_spread() -> None:
    recording = sample_recording(np.array([0.0, 1.0]), tension=np.zeros((2, 5)))
    assert recording.metrics()["final_tension_spread"] == 0.0


def test_lift_off_is_the_event_or_else_the_first_clear_sample() -> None:
    assert ringing_lift().metrics()["lift_off_time"] == 9.99
    assert ringing_lift(events=[]).metrics()["lift_off_time"] == 10.0


def test_a_load_that_stays_on_its_supports() -> None:
    time = np.linspace(0.0, 4.0, 5)
    contact = np.full((5, 4), WEIGHT / 8)
    metrics = sample_recording(time, tension=np.full((5, 5), 1e5), contact=contact).metrics()
    assert metrics["final_load_transferred"] == pytest.approx(0.5)
    absent = {
        "lift_off_time",
        "least_sling_tension_when_clear",
        "static_hook_load",
        "dynamic_amplification_factor",
    }
    assert not absent & set(metrics)


def test_travel_used_of_the_stroke_either_way() -> None:
    travel = np.zeros((3, 5))
    travel[1, 2] = -0.7  # of 1.4 m up
    travel[2, 4] = 1.52  # of 1.9 m down
    recording = sample_recording(np.arange(3.0), tension=np.full((3, 5), 1e5), travel=travel)
    metrics = recording.metrics()
    assert metrics["travel_used_up"] == pytest.approx(0.5)
    assert metrics["travel_used_down"] == pytest.approx(0.8)
    assert metrics["final_sheave_travel.e1.5"] == pytest.approx(1.52)
    assert metrics["final_sheave_travel.e1.3"] == pytest.approx(0.0)
    assert metrics["final_joint_travel.e1.5"] == pytest.approx(1.52)


def test_sling_angles_from_the_geometry() -> None:
    recording = sample_recording(np.arange(2.0), tension=np.full((2, 5), 1e5))
    slings = {sling.name: sling for sling in recording.rig.slings}
    # S1: from (-3.2, 0, 36.483 - 8.65) to (-2.5, 2.5, 5.0); S3 hangs plumb over the middle
    aside, high = math.hypot(0.7, 2.5), 36.483 - 8.65 - 5.0
    assert series.sling_angle(recording, slings["S1"]) == pytest.approx(math.atan2(aside, high))
    assert series.sling_angle(recording, slings["S3"]) == pytest.approx(0.0)
    across = math.asin(2.5 / math.hypot(aside, high))  # the main plate stands in the x-z plane
    assert series.out_of_plane_angles(recording, slings["S1"])["block", "L1"] == pytest.approx(across)
    # S2: from (-1.6, 0) to (2.5, 2.5)
    assert recording.metrics()["peak_sling_angle_from_vertical"] == pytest.approx(
        math.atan2(math.hypot(4.1, 2.5), high)
    )


def test_slack_slings_have_no_angle() -> None:
    recording = sample_recording(np.arange(2.0), tension=np.zeros((2, 5)))
    assert "peak_sling_angle_from_vertical" not in recording.metrics()


def test_tilt_and_drift() -> None:
    metrics = ringing_lift(tilt=np.linspace(0.0, 0.02, 2001)).metrics()
    assert metrics["peak_load_tilt"] == pytest.approx(0.02)
    assert metrics["peak_load_drift_when_clear"] == 0.0


def test_yaw_is_the_turn_about_plumb_whatever_the_tilt() -> None:
    """From 0.3 rad to beyond half a turn and back, tilted by 0.1 rad: the change from the start, no jump."""
    turned = 0.3 + np.concatenate([np.linspace(0.0, -4.0, 1001), np.linspace(-4.0, 1.0, 1000)])
    recording = ringing_lift(load_yaw=turned, tilt=np.full(2001, 0.1))
    (load,) = recording.rig.loads
    assert series.load_yaw(recording, load) == pytest.approx(turned - 0.3)
    assert recording.metrics()["peak_load_yaw"] == pytest.approx(4.0)


def test_a_load_that_is_turned_over_has_no_heading() -> None:
    recording = ringing_lift(tilt=np.linspace(0.0, math.pi, 2001))
    assert series.load_yaw(recording, recording.rig.loads[0]) is None
    assert "peak_load_yaw" not in recording.metrics()


def test_energy_remainder_is_that_of_all_steps() -> None:
    # What the core says of all its steps, whatever the samples show.
    energy = {"kinetic": np.full(3, 100.0), "remainder": np.array([0.0, 0.0, 1.0])}
    recording = sample_recording(np.arange(3.0), tension=np.zeros((3, 5)), energy=energy)
    assert recording.metrics()["energy_remainder"] == 1e-4


def test_metrics_of_a_lift_without_load_equalizer_and_hook_are_absent() -> None:
    rig = {**sample_rig(), "loads": [], "hooks": [], "equalizers": [], "slings": []}
    metrics = ringing_lift(rig=rig).metrics()
    assert metrics["final_rope_tension.sling.S1"] == pytest.approx(600e3)
    assert metrics["peak_rope_tension.sling.S2"] == pytest.approx(1.01 * HIGHEST)
    words = ("sling_tension", "hook", "hoist", "travel_used", "load", "lift_off", "spread")
    assert [name for name in metrics if any(word in name.partition(".")[0] for word in words)] == []


def test_every_metric_is_a_finite_float() -> None:
    metrics = ringing_lift().metrics()
    assert all(type(value) is float and math.isfinite(value) for value in metrics.values())
