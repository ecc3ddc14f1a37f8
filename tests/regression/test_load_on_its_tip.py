"""A load with its centre of gravity above its lugs was a GO, as long as nothing in the lift file was askew.

Two plumb slings hold 60 t by lugs 0.1 m below the centre of gravity: any push turns the load over. A run of a
lift that is symmetrical to the last bit has no push but rounding, and tilted by 0.0016 deg in 50 s: GO. The
equilibrium was called unstable by `gantline statics` alone, under a verdict of GO.
"""

from __future__ import annotations

import numpy as np
import pytest

import gantline
from gantline.checks import Check, Verdict, check_recording, verdict_of
from gantline.results.loads.upright import top_heavy
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from of_recording import checks_of
from spreader_lifts import frame, one_bar, two_below_one, two_hooks

CENTRE = 1.5  # of the load over its bottom [m]


def lift(lugs: float, steps: str = "") -> str:
    """A load under a bar, held by two plumb slings at lugs at a height over its bottom [m]."""
    text = one_bar(0.0).replace("16.0 m]", f"{13.0 + lugs!r} m]")
    for x in ("-4", "4"):
        text = text.replace(f"[{x} m, 0 m, 3 m], capacity: 80", f"[{x} m, 0 m, {lugs!r} m], capacity: 80")
    return text.replace(
        "  - {step: hold, hold: until_end}\n", f"{steps}  - {{step: hold, hold: until_end}}\n"
    )


def run(text: str) -> Recording:
    return gantline.simulate(parse_scenario(text))


def checked(recording: Recording) -> list[Check]:
    return checks_of(recording, "hangs_stably")


@pytest.mark.parametrize("above", [0.05, 0.1])
def test_fails_though_it_has_not_turned(above: float) -> None:
    """About the line of its lugs its stiffness is W times their height over the centre of gravity."""
    recording = run(lift(CENTRE - above))
    assert np.degrees(recording.column("load_tilt", "module").max()) < 0.01
    [check] = checked(recording)
    assert (check.element, check.verdict) == ("module", Verdict.FAILED)
    assert f"{above:.2f} m too high" in check.remark
    assert top_heavy(recording)[0].too_high == pytest.approx(above, rel=1e-3)
    assert verdict_of(check_recording(recording)).startswith("NO-GO")


def test_one_that_is_set_down_again_is_told() -> None:
    """It hung so at an earlier hold; at the end it stands."""
    down = "  - {step: look, hold: 8 s}\n  - {step: down, lower: hook, by: 1.9 m, speed: 6 m/min}\n"
    recording = run(lift(CENTRE - 0.05, down).replace("duration: 60 s", "duration: 80 s"))
    assert recording.column("load_transferred", "module")[-1] < 0.9
    [check] = checked(recording)
    assert check.time is not None and check.time < 56.0


@pytest.mark.parametrize(
    "text", [lift(CENTRE + 0.05), one_bar(), two_below_one(), frame(), two_hooks()], ids=lambda _: ""
)
def test_nothing_is_said_of_what_hangs_stably(text: str) -> None:
    assert not checked(run(text))


@pytest.mark.parametrize("lugs", [1.4, 1.6, 3.0])
def test_height_agrees_with_statics(lugs: float) -> None:
    """An equilibrium is unstable where a run is told so: the core's own curvature of all coordinates."""
    text = lift(lugs)
    rest = gantline.Statics(parse_scenario(text)).equilibrium(time=60.0)
    assert rest.is_stable is not bool(top_heavy(run(text)))
    assert rest.is_stable is not bool(checked(rest.recording))
