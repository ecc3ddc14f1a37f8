"""A load that pulled pins dropped on the ground was told to be kept farther away, as no step lowered it.

Under its pins 120 t hung on the outer two of three slings, the middle one 200 mm too long. Each moving sheave
free, all three share, and the load comes down by a third of that. A load whose sling breaks or is taken off
while it carries had the same advice.
"""

from __future__ import annotations

import pytest

import gantline
from four_slings import LIFT as FOUR
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from lift_text import changed
from of_recording import checks_of
from pinned_lift import LIFT

#: How much too long the middle sling is [m], and when pins are pulled [s].
LONG, PULLED = 0.2, 20.0


def helps(recording: Recording) -> str:
    """What the check says behind the speed."""
    (found,) = checks_of(recording, "set_down_softly")
    return found.remark.split("; ", 1)[1]


def over_ground(gap: float) -> Recording:
    """The load so high over the ground [m] as its slings are without force."""
    ground = f"ground: {{level: {2.0 - gap} m, friction: 0.4}}\n"
    return gantline.simulate(parse_scenario(changed(LIFT, ("load:\n", f"{ground}load:\n"))))


def test_pins_that_are_pulled() -> None:
    """It comes to rest 200/3 = 67 mm lower, and stretches some 35 mm: 60 mm are not enough."""
    assert LONG / 3 > 0.06
    recording = over_ground(0.06)
    (down,) = (time for time, _, name in recording.events("set_down") if name == "block")
    assert PULLED < down < PULLED + 0.2
    wanted = f"pins are pulled at {PULLED:.2f} s, and it drops by what they held: pull them as it stands"
    assert helps(recording) == wanted


def test_high_enough() -> None:
    """What drops by 67 mm at once swings by as much below that, at most."""
    assert checks_of(over_ground(2 * LONG / 3 + 0.1), "set_down_softly") == []


@pytest.mark.parametrize(
    ("key", "said"),
    [
        ("cut", "sling.D is cut at {:.2f} s, and it drops: see 'rope_parted'"),
        ("detach", "sling.D is taken off at {:.2f} s, and it drops: take it off slack"),
    ],
)
def test_slings_that_are_gone(key: str, said: str) -> None:
    """A hook that lets go of all four while the load hangs 0.2 m over the ground."""
    gone = f"[{', '.join(f'sling.{one}' for one in 'ABCD')}]"
    last = "hold point, hold: 20 s}"
    plan = (last, f"{last}\n  - {{step: gone, hold: until_end, {key}: {gone}}}")
    recording = gantline.simulate(parse_scenario(changed(FOUR, plan)))
    (when,) = (time for time, _, step in recording.events("step_begin") if step == "gone")
    assert helps(recording) == said.format(when)
