"""A page drew the load 0.21 m off where it had been as a sling was cut.

The page of a long lift has about 1500 of its samples as frames, with straight lines between. They were spread
evenly: while a load rings at 3 Hz after a sling is cut there were 4 of them in a swing, and as many in a
swing's time while it hung still before. `equalizer_sling_cut` was 225 mm off, and is 33 mm off with as many.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from gantline.results import Recording, Variable
from gantline.viewer.frames import DRAWN_OFF, frames
from sample_lift import HOOK, sample_recording

Array = npt.NDArray[np.float64]

TIME = np.linspace(0.0, 100.0, 10_001)
MOST = 1000
#: The load heaves, or turns about y, at 1 Hz from 40 s to 45 s, and rests before and after.
SWINGS = (TIME >= 40.0) & (TIME <= 45.0)
SWING = np.where(SWINGS, np.sin(2 * np.pi * TIME), 0.0)


def furthest(values: Array, at: npt.NDArray[np.int64]) -> float:
    """Largest distance of values, shape (time, parts), from straight lines between the samples `at`."""
    read = np.stack([np.interp(TIME, TIME[at], one[at]) for one in values.T], axis=1)
    return float(np.linalg.norm(read - values, axis=1).max())


def test_a_load_that_swings_for_a_moment_is_drawn_where_it_was() -> None:
    """Lines of the length h are within A ω² h²/8 of A sin ωt, 48 mm for a thousand even ones.

    For 1 mm of 0.49 m, h = √(8·0.001/0.49)/2π = 20.3 ms; of 5 s, 246 of them, less than half of a thousand.
    """
    recording = sample_recording(TIME, tension=np.full((len(TIME), 5), 1e5), load_z=2.5 + 0.49 * SWING)
    at = frames(recording, MOST)
    assert len(at) <= MOST
    assert furthest(recording.column("body_position", "block"), at) <= DRAWN_OFF
    even = np.linspace(0, len(TIME) - 1, MOST).round().astype(np.int64)
    assert furthest(recording.column("body_position", "block"), even) > 20 * DRAWN_OFF


def test_corners_of_a_load_that_turns_count() -> None:
    """The upper corner of the load, 10 m by 10 m by 5 m, is 7.5 m from the middle about which it tilts."""
    recording = sample_recording(TIME, tension=np.full((len(TIME), 5), 1e5), tilt=0.05 * SWING)
    corner = np.array([5.0, 5.0, 2.5])
    c, s = np.cos(0.05 * SWING), np.sin(0.05 * SWING)
    path = np.stack([c * corner[0] + s * corner[2], 0 * c + corner[1], c * corner[2] - s * corner[0]], axis=1)
    assert furthest(path, frames(recording, MOST)) <= DRAWN_OFF


def test_quaternions_of_opposite_signs_are_one_attitude() -> None:
    """A recording whose quaternions change sign while a load rests needs no frame for that."""
    recording = sample_recording(TIME, tension=np.full((len(TIME), 5), 1e5))
    old = recording["body_orientation"]
    signs = np.where(np.arange(len(TIME)) < len(TIME) // 3, 1.0, -1.0)[:, None, None]
    turned = Variable(old.dims, signs * old.values, old.unit, old.description)
    other = Recording(
        {**recording.variables, "body_orientation": turned}, recording.coordinates, recording.attributes
    )
    assert frames(other, MOST).tolist() == frames(recording, MOST).tolist()


def test_a_lift_at_constant_speed_needs_no_more_than_the_even_ones() -> None:
    recording = sample_recording(TIME, tension=np.full((len(TIME), 5), 1e5), hook=HOOK + 0.1 * TIME)
    assert len(frames(recording, MOST)) == MOST // 2


def test_what_is_too_much_for_all_frames_has_its_worst_places_first() -> None:
    """At 5 Hz all the time, by 1 m in the end and by 1 mm before, of which no line is further off than 2 mm.

    With all 500 that are not even in the last 20 s, h = 40 ms, lines there are A ω² h²/8 = 0.2 m off.
    """
    wide = np.where(TIME >= 80.0, 1.0, 0.001)
    recording = sample_recording(
        TIME, tension=np.full((len(TIME), 5), 1e5), load_z=2.5 + wide * np.sin(10 * np.pi * TIME)
    )
    at = frames(recording, MOST)
    assert len(at) == MOST
    more = np.setdiff1d(at, np.linspace(0, len(TIME) - 1, MOST // 2).round().astype(np.int64))
    assert (TIME[more] >= 80.0 - 2 * 100.0 / (MOST // 2)).all()
