"""Samples that are so far apart that crests come and go between them.

Heel, trim and freeboard are those of samples. A barge in waves of 2.4 m every 6 s, across it, heels by 13.2°
and dips its deck's edge by 0.99 m; with samples 6 s apart, each at the same place in the waves, it heels
by 7.4° and keeps 1.71 m of freeboard, which was an ok beside an event of its deck under water, and nothing
said that more was missed. Three hours of a sea at 20 ms are half a million samples, so that people do take
fewer.
"""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import waves
from gantline.checks import Verdict
from gantline.results.recording import Recording
from gantline.simulation import simulate
from of_recording import checks_of

PERIOD = 6.0
SWELL = {"height": "2.4 m", "period": f"{PERIOD} s", "direction": "90 deg"}


def run_of(folder: Path, apart: float, **more: dict[str, str]) -> Recording:
    path = waves.in_waves(
        folder,
        {"swell": SWELL, **more},
        duration="120 s",
        simulation={"sample_interval": f"{apart!r} s"},
        limits={"freeboard": "0.3 m", "heel": "10 deg"},
    )
    return simulate(path)


def told(run: Recording) -> list[str]:
    return [one for one in run.attributes["warnings"] if one.startswith("samples")]


def test_a_deck_under_water_between_samples_fails(tmp_path: Path) -> None:
    """The event knows the moment; the height there is zero."""
    run = run_of(tmp_path, PERIOD)
    least = run.metrics()["least_freeboard"]
    (first, *_) = [
        time for time, kind, name in run.events() if (kind, name) == ("flooding", "barge.deck_edge")
    ]
    assert least > 0.3
    (check,) = checks_of(run, "freeboard")
    assert check.verdict is Verdict.FAILED
    assert (check.value, check.element) == (0.0, "barge")
    assert check.time == pytest.approx(first)
    assert check.remark == "its deck_edge goes under water between two samples: barge"
    # With samples that see it, it is their least.
    (check,) = checks_of(run_of(tmp_path, 0.1), "freeboard")
    assert check.verdict is Verdict.FAILED
    assert check.value == pytest.approx(-0.99, abs=5e-3)  # as the story has it, to a hundredth


def test_samples_that_miss_crests_are_told(tmp_path: Path) -> None:
    """Between two samples Δt apart a wave may be higher than at both by 1 − cos(πΔt/T): 100 % from half a
    period on, 4.9 % at a tenth, about which nothing is said.
    """
    (said,) = told(run_of(tmp_path, 3.0))
    assert said == (
        "samples 3.00 s apart miss up to 100 % of the height of waves every 6.0 s: heel, trim, freeboard, "
        "angles and distances are those of samples; a 'sample_interval' of 0.6 s has their peaks"
    )
    assert not told(run_of(tmp_path, PERIOD / 10))
    assert f"up to {100 * (1 - math.cos(math.pi / 6)):.0f} % of" in told(run_of(tmp_path, 1.0))[0]


def test_ripples_beside_a_swell(tmp_path: Path) -> None:
    """What is missed of 1 cm every 2 s is little beside 2.4 m: 0.4 % of all, with the 0.3 % of the swell."""
    ripples = {"height": "1 cm", "period": "2.2 s", "direction": "90 deg"}
    assert not told(run_of(tmp_path, 0.5, ripples=ripples))
