"""A load that stands on a deck, in a lift without ground.

Far from land there is no `ground:`; a load that stands on a barge touches its deck by `body_contacts` of
`mechanics`, and the guide to lifts afloat says that conditions of the plan count this contact as any other.
They do, and yet a plan that waits for `load_transferred` was refused, since neither ground nor supports were
in the file: whoever wrote the lift had to invent a ground below the sea.
"""

from __future__ import annotations

import pytest

from gantline import simulate
from gantline.scenario import ScenarioError, parse_scenario
from hung_box import hung_box
from lift_text import changed
from mechanics import G
from of_recording import step_end

LIFT = (
    """\
format: 1
lift: {title: Off a deck at sea}
duration: 12 s
ropes: {soft: {axial_stiffness: 20 MN, damping_time: 10 ms}}
"""
    + hung_box("0 m, 0 m, 0 m", "0 m, 0 m, 6.9 m", "speed: 6 m/min, acceleration: 1 m/s^2")
    + """\
mechanics:
  bodies:
    deck: {joint: {type: fixed}, mass: 1 t, shape: {box: [4 m, 4 m, 1 m], centre: [0 m, 0 m, -0.5 m]}}
  body_contacts:
    on_deck: {between: [box, deck], stiffness: 100 MN/m, damping: 1 MN s/m, friction: 0.3}
plan:
  - {step: off, hoist: hook, speed: 3 m/min, until: {supports: clear}}
  - {step: end, hold: until_end}
"""
)


def test_plan_waits_for_the_deck_to_be_clear() -> None:
    """It comes clear when the slings are taut and stretched by W L/EA: 0.1 m + 25 mm at 0.05 m/s, 2.5 s."""
    recording = simulate(parse_scenario(LIFT))
    stretch = 10e3 * G * 5.0 / 20e6
    start = 0.5 * 0.05 / 1.0  # half of the ramp to 0.05 m/s at 1 m/s² [s]
    lift_off = recording.metrics()["lift_off_time"]
    # The deck gives 0.25 mm to each corner; the load lags as it is pulled up.
    assert lift_off == pytest.approx((0.1 + stretch) / 0.05 + start, abs=0.1)
    ended = step_end(recording, "off")
    assert lift_off < ended < lift_off + 0.1  # brakes within 0.05 s


def test_nothing_to_stand_on() -> None:
    """A load that touches nothing has nothing to leave."""
    other = "    other: {joint: {type: free}, mass: 1 t, shape: {box: [1 m, 1 m, 1 m]}}\n"
    text = changed(LIFT, ("[box, deck]", "[deck, other]"), ("    deck:", f"{other}    deck:"))
    with pytest.raises(ScenarioError, match="waits for a load to leave the ground; there is no 'load' on a"):
        parse_scenario(text)
