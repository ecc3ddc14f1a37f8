"""A quantity that is within its limit at every sample, and past it between two of them.

A load that sways every 10 s, by samples 2 s apart, has its largest tilt between them: 1.856 deg was ok where
the limit is 1.87 deg and the load came to 1.90 deg. The parabola through a largest sample and its neighbours
says how far it may have come; where that is past the limit the check warns.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from gantline.checks import Check, Verdict, check_recording
from of_recording import check_of
from sample_lift import sample_recording, sample_rig

PERIOD, MEAN, SWAY = 10.0, 1.0, 0.9  # [s], [deg], [deg]


def tilt(away: float) -> float:
    """Tilt at a time [s] from a crest [deg]."""
    return MEAN + SWAY * math.cos(2 * math.pi * away / PERIOD)


def checked(interval: float, limit: float, late: float) -> Check:
    """The check of a tilt with crests `late` [s] after 5 s and every 10 s on; the limit in degrees."""
    time = np.arange(0.0, 40.0 + 1e-9, interval)
    sway = np.array([tilt(moment - 5.0 - late) for moment in time])
    hung = np.outer(np.ones(len(time)), np.full(5, 600e3))
    rig = sample_rig(load_tilt=math.radians(limit))
    checks = check_recording(sample_recording(time, rig=rig, tension=hung, tilt=np.radians(sway)))
    return next(one for one in checks if one.name == "load_tilt")


def told(check: Check) -> bool:
    return "between two samples" in check.remark


@pytest.mark.parametrize("late", [0.5, 0.7, 1.3])
def test_a_crest_between_samples_is_told(late: float) -> None:
    """y0 + (y+ - y-)^2/(8 (2 y0 - y- - y+)) of the samples 2 s before, at and after 6 s."""
    before, here, after = (tilt(away - late) for away in (-1.0, 1.0, 3.0))
    vertex = here + (after - before) ** 2 / (8.0 * (2.0 * here - before - after))
    assert here < vertex < MEAN + SWAY
    limit = (here + vertex) / 2.0
    found = checked(2.0, limit, late)
    assert math.degrees(found.value or 0.0) == pytest.approx(here, rel=1e-9)
    assert found.verdict is Verdict.WARNING
    words, _, rest = found.remark.partition(" deg: a shorter 'sample_interval' tells")
    shown = float(words.removeprefix("between two samples it may have come to "))
    # With as many digits as it takes to read it as past the limit.
    assert rest and limit < shown == pytest.approx(vertex, abs=5e-3)
    assert not told(checked(2.0, vertex + 1e-6, late))


def test_near_samples_know_their_crests() -> None:
    """20 ms apart, with a limit 0.01 mdeg above the crest; a sample at it has (0.01 s)^2 x 2e-5 s^-2 less."""
    found = checked(0.02, MEAN + SWAY + 1e-5, 0.51)
    assert not told(found)
    assert math.degrees(found.value or 0.0) == pytest.approx(MEAN + SWAY, abs=2e-5)


def test_what_fails_fails() -> None:
    found = checked(2.0, 1.5, 0.5)
    assert found.verdict is Verdict.FAILED
    assert not told(found)


def test_what_comes_to_rest_at_its_limit_does_not_pass_it() -> None:
    """0.1 deg/s up to 1.9 deg, and there it stays: the parabola over the kink goes 1/8 of 0.2 deg higher."""
    time = np.arange(0.0, 40.0 + 1e-9, 2.0)
    hung = np.outer(np.ones(len(time)), np.full(5, 600e3))
    rig = sample_rig(load_tilt=math.radians(1.901))
    recording = sample_recording(time, rig=rig, tension=hung, tilt=np.radians(np.minimum(0.1 * time, 1.9)))
    found = check_of(recording, "load_tilt")
    assert not told(found)
