"""Steps that wait for a tilt and for slings, slings that are taken off, and pairs watched over some steps."""

from __future__ import annotations

import math

import numpy as np
import pytest

from gantline.checks import Verdict
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import Simulation
from hooked_lift import hooked_lift
from mechanics import G
from of_recording import checks_of, step_end

#: Two hooks, each plumb over its lug; slings of 10 m that stretch under half a load each.
APART, LENGTH, MASS, EA = 8.0, 10.0, 200e3, 200e6
HOOKS = {"A": (-APART / 2, 0.0, 20.0), "B": (APART / 2, 0.0, 20.0)}
LUGS = {"1": (-APART / 2, 0.0, 4.0), "2": (APART / 2, 0.0, 4.0)}
SLINGS = {"S1": ("A", "1", LENGTH), "S2": ("B", "2", LENGTH)}
#: A hoist at 0.1 m/s brakes with 0.1 m/s^2 in 1 s: that long before the end of a step its condition was met.
BRAKES = 1.0


def run(plan: str, more: str = "", duration: float = 100.0) -> Recording:
    text = hooked_lift(HOOKS, LUGS, SLINGS, mass=MASS, position=(0.0, 0.0, 6.0), more=f"plan:\n{plan}{more}")
    text = text.replace("duration: 10 s", f"duration: {duration} s").replace("as_given", "rest")
    return Simulation(parse_scenario(text)).run()


@pytest.mark.parametrize("wanted", [5.0, 20.0])
def test_a_step_ends_at_a_tilt(wanted: float) -> None:
    """One hook goes up until the load tilts by so much, and the other follows until it is level again."""
    recording = run(
        f"  - {{step: turn, hoist: A, speed: 0.1 m/s, until: {{load_tilt: {{above: {wanted} deg}}}}}}\n"
        "  - {step: look, hold: 5 s}\n"
        "  - {step: back, hoist: B, speed: 0.1 m/s, until: {load_tilt: {below: 1 deg}}}\n"
        "  - {step: end, hold: until_end}\n"
    )
    tilt = np.degrees(recording.column("load_tilt", "load"))
    assert np.interp(step_end(recording, "turn") - BRAKES, recording.time, tilt) == pytest.approx(
        wanted, abs=0.01
    )
    assert np.interp(step_end(recording, "back") - BRAKES, recording.time, tilt) == pytest.approx(
        1.0, abs=0.01
    )


def test_a_slack_sling_is_taken_off_and_the_load_hangs_on_the_other() -> None:
    """A hook goes down until its sling is slack; then all of the weight, m g, is in the other sling."""
    recording = run(
        "  - {step: let go, lower: B, speed: 0.1 m/s, until: {slings: slack, of: sling.S2}}\n"
        "  - {step: further, lower: B, speed: 0.1 m/s, by: 3 m}\n"
        "  - {step: off, hold: 1 s, detach: sling.S2}\n"
        "  - {step: up, hoist: B, speed: 0.1 m/s, by: 8 m}\n"
        "  - {step: end, hold: until_end}\n",
        duration=300.0,
    )
    tension = recording.column("rope_tension", "sling.S2")
    # The step brakes where the sling first carries nothing, which rings by some kN.
    assert np.interp(step_end(recording, "let go") - BRAKES, recording.time, tension) < 1e-3 * MASS * G
    assert tension[recording.time < step_end(recording, "let go") - BRAKES - 1.0].min() > 0.0
    assert recording.events("detached") == [(step_end(recording, "further"), "detached", "sling.S2")]
    off = recording.time > step_end(recording, "further")
    assert tension[off].max() == 0.0
    # Swings of a pendulum have the mean m g over whole periods along plumb, and this one swings for 200 s.
    late = recording.time > recording.time[-1] - 150.0
    upward = recording.column("rope_tension", "sling.S1")[late]
    assert upward.mean() == pytest.approx(MASS * G, rel=0.03)
    (check,) = checks_of(recording, "detached_slack")
    assert (check.verdict, check.remark) == (Verdict.OK, "it carried 0.0 kN")
    assert recording.metrics()["detaching_tension.sling.S2"] == 0.0
    assert "parted_ropes" not in recording.metrics()
    assert recording.metrics()["energy_remainder"] < 1e-5


def test_a_sling_that_still_carries_is_told() -> None:
    """Half the weight, m g/2, and what it held, T^2 L/(2 EA), is booked as parting."""
    recording = run("  - {step: wait, hold: 1 s}\n  - {step: off, hold: 0.1 s, detach: sling.S2}\n")
    (check,) = checks_of(recording, "detached_slack")
    assert check.verdict is Verdict.FAILED
    assert check.utilisation is None and check.remark.startswith("it carried 981.0 kN; let its hook down")
    carried = recording.metrics()["detaching_tension.sling.S2"]
    assert carried == pytest.approx(MASS * G / 2, rel=1e-4)
    lost = recording.column("energy", "parting")[-1]
    assert lost == pytest.approx((MASS * G / 2) ** 2 * LENGTH / (2 * EA), rel=1e-3)


def test_a_pair_is_watched_over_some_steps() -> None:
    """A load at 6 m goes 2 m up and 5 m down: 8 m in between, 3 m at the end, where nothing asks any more."""
    recording = run(
        "  - {step: up, hoist: [A, B], speed: 0.1 m/s, by: 2 m}\n"
        "  - {step: across, hold: 5 s}\n"
        "  - {step: down, lower: [A, B], speed: 0.1 m/s, by: 5 m}\n"
        "  - {step: end, hold: until_end}\n",
        "watch:\n"
        "  - {between: [load, ground], smallest: 7 m, from_step: across, to_step: across}\n"
        "  - {between: [load, ground], smallest: 7 m, from_step: across}\n"
        "ground: {level: 0 m}\n",
    )
    metrics = recording.metrics()
    across, on = "load - ground from 'across' to 'across'", "load - ground from 'across'"
    # The load hangs where its slings have stretched at the start, and goes as far as its hooks.
    start = float(recording.column("clearance", on)[0])
    assert start == pytest.approx(6.0, abs=0.1)
    assert metrics[f"smallest_clearance.{across}"] == pytest.approx(start + 2.0, abs=2e-3)
    assert metrics[f"smallest_clearance.{on}"] == pytest.approx(start - 3.0, abs=2e-3)
    assert [name for _, _, name in recording.events("too_close")] == [on]
    (check,) = checks_of(recording, "clearance_margin")
    assert (check.verdict, check.element) == (Verdict.FAILED, on)
    assert check.value == pytest.approx(start - 3.0 - 7.0, abs=2e-3)
    assert math.isfinite(recording.events("too_close")[0][0])
