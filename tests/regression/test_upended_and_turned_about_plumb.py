"""A column that had turned by 31 deg below its hook was set down on its anchor bolts, and nothing told of it.

Upended, its own x axis is upright and has no heading: `load_yaw` was left out of table and report, and a
limit of it was `not checked`. How far it turns about plumb is known of any attitude but upside down. It is in
both now, with where the column is set down.

For the same reason a load that hung still and turned about plumb after that was taken for one turned by more
than 10 deg: `hook_dynamic_factor` of the crane that carried all of it through a hold of 60 s was `not
checked`, since "a hold there does".
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from gantline.checks import Verdict
from gantline.results import series
from gantline.results.loads.hung_so import has_hung_so
from gantline.results.loads.set_down import set_down_in_words
from gantline.results.recording import Recording
from of_recording import checks_of
from sample_lift import ringing_lift, sample_rig

TIME = np.linspace(0.0, 40.0, 2001)
YAW = math.radians(-31.4)


def upended(tilt: float = math.pi / 2, limit: float | None = None) -> Recording:
    """Tilts up to 20 s [rad], then turns about plumb; below it the ground comes again at 38 s."""
    down = TIME >= 38.0
    stands = np.repeat(np.where((TIME < 10.0) | down, 1e6, 0.0)[:, None], 4, axis=1)
    return ringing_lift(
        tilt=tilt * np.clip(TIME / 20.0, 0.0, 1.0),
        load_yaw=YAW * np.clip((TIME - 20.0) / 10.0, 0.0, 1.0),
        contact=stands,
        rig=sample_rig(**({} if limit is None else {"load_yaw": limit})),
        events=[(9.99, "lift_off", "block"), (37.99, "set_down", "block")],
    )


@pytest.mark.parametrize("tilt", [math.pi / 2, math.radians(95.0), math.radians(150.0)])
def test_it_has_turned_about_plumb(tilt: float) -> None:
    """A tilt about a level axis, then a turn about plumb: this is the yaw, whatever the tilt."""
    recording = upended(tilt)
    (load,) = recording.rig.loads
    yaw = series.load_yaw(recording, load)
    assert yaw is not None
    assert yaw[TIME <= 20.0] == pytest.approx(0.0, abs=1e-12)
    assert yaw[-1] == pytest.approx(YAW, rel=1e-9)


def test_upside_down_nothing_tells() -> None:
    """It may have come there about any level axis, which a turn about plumb takes to any other."""
    recording = upended(math.radians(170.0))
    assert series.load_yaw(recording, recording.rig.loads[0]) is None


def test_a_limit_of_its_yaw_decides() -> None:
    (kept,) = checks_of(upended(limit=math.radians(31.5)), "load_yaw")
    assert kept.verdict is Verdict.OK and kept.value == pytest.approx(-YAW)
    (failed,) = checks_of(upended(limit=math.radians(31.3)), "load_yaw")
    assert failed.verdict is Verdict.FAILED


def test_where_it_is_set_down() -> None:
    """Time of the event, the place of its centre of gravity in the sample, which stays, and the turn."""
    recording = upended()
    (load,) = recording.rig.loads
    place = recording.column("body_position", load.body)[-1]
    words = f"at 38.0 s, at the end with its centre of gravity at x {place[0]:.2f} m, y {place[1]:.2f} m"
    assert set_down_in_words(recording, load, 1) == f"{words}, turned by 31.4 deg clockwise"
    assert set_down_in_words(ringing_lift(), load, 1) is None  # hangs at the end


def test_turned_about_plumb_it_hangs_as_it_did() -> None:
    """It hung still, upright, from 20 s on; at 37 s it does so with another heading."""
    work = np.minimum(TIME, 20.0) * 50.0
    recording = ringing_lift(
        tilt=math.pi / 2 * np.clip(TIME / 20.0, 0.0, 1.0),
        load_yaw=YAW * np.clip((TIME - 28.0) / 2.0, 0.0, 1.0),
        energy={"drive_work": np.where(TIME < 28.0, work, work + TIME - 28.0), "gravity": work},
    )
    assert has_hung_so(recording, 37.0)
