"""Hooks whose slings have been taken off: what they do then was held against charts and other hooks.

The upper ends of the slings go on hanging in the hook, 0.3 t of them, and so it bore something: with its
boom lowered out of the chart it was a NO-GO, `outside of the chart: no lift`, and its swinging was the
attitude for which the chart holds. And the level of a hook that went away, 3.2 m lower than that which had
taken over, was a difference of hooks that bear the load. An equalizer or spreader of which the load never
hung still was not checked at all, at a peak of a hundred and forty per cent of what it is rated for.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import gantline
from four_slings import HANDED_OVER
from gantline.checks import Verdict
from gantline.checks.readings import hook_readings
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from of_recording import check_of, checks_of
from rated_lift import T, recording
from sample_lift import WEIGHT, ringing_lift, sample_rig

#: Mass of what slings have lumped on a hook [t]; hook block and falls are 9 t.
OWN, FALLS = 0.3, 9.0


def with_slings_on_it(radius: list[float], load: list[float], lead: float = 0.0) -> Recording:
    plain = recording([[one] for one in radius], [[one] for one in load], lead=lead)
    rig = plain.attributes["rig"]
    hooks = [{**hook, "direct_weight": OWN * T} for hook in rig["hooks"]]
    return Recording(plain.variables, plain.coordinates, {**plain.attributes, "rig": {**rig, "hooks": hooks}})


def test_slings_that_hang_in_a_hook_are_no_lift() -> None:
    """100 t at 14 m, of 283 t; then nothing but the slings at 30 m, where the chart has no row."""
    of = with_slings_on_it([14.0, 30.0], [100.0, FALLS + OWN])
    found = check_of(of, "hoist_load_of_rating")
    assert (found.verdict, found.time) == (Verdict.OK, 0.0)
    assert found.value == pytest.approx(100 / 283)
    (reading,) = hook_readings(of, np.array([False, True]))
    assert (reading.rated, reading.used, reading.is_outside) == (0.0, None, False)
    beyond = with_slings_on_it([14.0, 30.0], [100.0, FALLS + OWN + 0.001])
    assert check_of(beyond, "hoist_load_of_rating").verdict is Verdict.FAILED
    (reading,) = hook_readings(beyond, np.array([False, True]))
    assert reading.is_outside


@pytest.mark.parametrize(("more", "verdict"), [(0.001, Verdict.FAILED), (0.0, None)])
def test_such_a_hook_may_swing(more: float, verdict: Verdict | None) -> None:
    of = with_slings_on_it([14.0, 14.0], [FALLS + OWN + more] * 2, lead=math.radians(1.1))
    found = checks_of(of, "attitude_of_rating")
    assert [check.verdict for check in found] == ([] if verdict is None else [verdict])


def test_the_level_of_a_hook_counts_while_its_slings_are_on() -> None:
    """It goes up 0.2 m with the load, and 0.9 m down as the second has gone 0.5 m up; then 2.5 m more."""
    end = "  - {step: let it hang, hold: until_end}\n"
    off = ", ".join(f"sling.{name}" for name in "ABCD")
    away = f"  - {{step: off, detach: [{off}], lower: crane, speed: 3 m/min, by: 2.5 m}}\n"
    text = HANDED_OVER.replace(end, away + end).replace("duration: 70 s", "duration: 160 s")
    text = text.replace("speed: 1 m/min, by: 0.1 m", "speed: 1 m/min, by: 0.9 m")
    text += "limits: {hook_level_difference: 1.5 m}\n"
    found = check_of(gantline.simulate(parse_scenario(text)), "hook_level_difference")
    assert found.verdict is Verdict.OK
    # From when the load comes clear the hook brakes from 1 m/min at 0.05 m/s², before the first 0.2 m; that
    # it is clear is seen one sample of 20 ms later at most.
    creep = 1.0 / 60.0
    braking = creep**2 / (2.0 * 0.05)
    assert found.value == pytest.approx(0.5 + 0.9 - 0.2 - braking, abs=0.02 * creep)


@pytest.mark.parametrize("rated", [1.3, 0.7])
def test_an_equalizer_that_never_hung_still_is_held_against_its_peak(rated: float) -> None:
    rig = sample_rig()
    rig["equalizers"][0]["rated_capacity"] = rated * WEIGHT
    found = check_of(
        ringing_lift(rig=rig, contact=np.full((2001, 4), 1e5)), "equalizer_load_of_rated_capacity"
    )
    peak = float(found.formula.removeprefix("peak ").split()[0]) * 1e3
    assert found.value == pytest.approx(peak / (rated * WEIGHT), abs=1e-4)
    assert found.verdict is (Verdict.WARNING if rated > 1.0 else Verdict.FAILED)
    assert "no static force: the load never hung still" in found.remark
