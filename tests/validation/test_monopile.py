"""The pile of `scenarios/monopile` against moments about its pins, its crane against its chart."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import gantline
from gantline.checks import check_recording, has_failed, hold_points, hook_readings
from gantline.plot.moments import stages
from gantline.report.carried import hook_row
from gantline.report.subject import Subject
from gantline.results.recording import Recording
from mechanics import G
from of_recording import step_end
from promises import PROMISES, Promise
from shown import ROOT

SCENARIO = Path(__file__).parents[2] / "scenarios" / "monopile"
#: Along the pile from the pins to centre of gravity and trunnions, and down from them to its axis [m].
CENTRE, TRUNNIONS, BELOW = 34.5, 70.0, 2.0
#: Of the pile, and of its slings, which lead half of theirs to the trunnions [N].
WEIGHT, SLINGS = 1000e3 * G, 2 * 24 * 120 * G


@pytest.fixture(scope="module")
def pile() -> Recording:
    return gantline.simulate(SCENARIO)


@pytest.mark.parametrize("promise", PROMISES)
def test_what_every_scenario_promises(promise: Promise, pile: Recording, tmp_path: Path) -> None:
    """Metrics within the tolerance of their source; its balance closes; and saved, it says the same."""
    promise(ROOT / "scenarios" / "monopile", pile, tmp_path)


def held(recording: Recording, step: str, last: float = 45.0) -> np.ndarray:
    """The last seconds of a hold."""
    end = step_end(recording, step)
    during: np.ndarray = (recording.time > end - last) & (recording.time <= end)
    return during


@pytest.mark.parametrize(("number", "tilt"), [(2, 0.0), (3, 30.0), (4, 60.0), (5, 84.0)])
def test_hook_load_by_the_moments_about_the_pins(pile: Recording, number: int, tilt: float) -> None:
    """V (l cos t + e sin t) - H (l sin t - e cos t) = W (a cos t + e sin t), V up and H away from the crane.

    The falls lean by H/V. The bucket bears what is left: W - V, and H.
    """
    during = held(pile, f"hold point {number}")
    angle = float(pile.column("load_tilt", "pile")[during].mean())
    assert math.degrees(angle) == pytest.approx(tilt, abs=0.1)
    along, up = math.cos(angle), math.sin(angle)
    lean = -math.tan(float(pile.column("off_lead", "rc.H1")[during].mean()))
    lever = TRUNNIONS * along + BELOW * up - lean * (TRUNNIONS * up - BELOW * along)
    own = SLINGS / 2
    pull = (WEIGHT * (CENTRE * along + BELOW * up) + own * (TRUNNIONS * along + BELOW * up)) / lever
    hook = float(pile.column("hook_load", "rc.H1")[during].mean())
    # Pile and falls go on swinging; at 84 deg 0.01 deg of lean are 0.1 % of the lever.
    assert hook == pytest.approx(pull + own, rel=2e-3 if number == 5 else 1e-3)
    hinge = float(pile.column("hinge_force", "bucket")[during].mean())
    assert hinge == pytest.approx(math.hypot(WEIGHT + SLINGS - hook, lean * pull), rel=1e-3)


def test_it_hangs_free_of_its_bucket_before_that_opens(pile: Recording) -> None:
    """2 m beside the pins upright: by the formula above at 90 deg all of the weight is on the hook.

    It is hoisted until the load cell reads 1095 t of the 1098.4 t that hang: 3.4 t may be left.
    """
    opened = step_end(pile, "hold point 6")
    before = held(pile, "hold point 6")
    assert pile.column("hinge_force", "bucket")[before].max() < 3.4e-3 * WEIGHT
    after = pile.time > opened + 5.0
    assert np.abs(pile.column("hook_load", "rc.H1")[after] - WEIGHT - SLINGS).max() < 2e-3 * WEIGHT
    assert (pile.column("load_transferred", "pile")[after] == 1.0).all()


def test_every_hold_has_its_own_place_on_the_chart(pile: Recording) -> None:
    """The hoist load there, slings and pile raised by 1.03, over what is rated between two rows."""
    rows = (28, 40, 50, 60, 80, 100, 120), (2500, 2500, 2200, 1800, 1250, 900, 650)
    points = {point.step.step: point.at for point in hold_points(pile)}
    for number in (2, 3, 4, 5, 6, 7):
        (reading,) = hook_readings(pile, points[f"hold point {number}"])
        assert reading.radius is not None
        rated = float(np.interp(reading.radius, *rows)) * 1e3 * G
        raised = reading.hoist_load + 0.03 * reading.hook_load
        # Of a hold the mean counts, and at 84 deg the pile swings by 1 % to either side of it.
        assert reading.used == pytest.approx(raised / rated, rel=1e-2), number


def test_load_cells_of_the_first_page(pile: Recording) -> None:
    """Hook block, falls and half of the slings, 95.5 t, with shares of pile and the rest, 1002.9 t."""
    (hook,) = pile.rig.hooks
    row = hook_row(Subject(pile), hook)
    for reading, share in zip(row["readings"], (0.25, 0.5, 0.75, 1.0), strict=True):
        assert float(reading) == pytest.approx(1002.9 * share + 95.5, rel=5e-4)


def test_nothing_of_it_fails_or_warns(pile: Recording) -> None:
    """Checks against the limits of its lift file."""
    checks = check_recording(pile)
    assert not has_failed(checks) and not pile.attributes["warnings"]


def test_stages_show_it_upright(pile: Recording) -> None:
    """At a third and two thirds of a right angle, and as its hinge opens."""
    assert [name for name, *_ in stages(pile)] == [
        "start",
        "lift-off",
        "tilted by 30 deg",
        "tilted by 60 deg",
        "bucket opens",
        "end of 'slew over the side'",
    ]
