"""An engine that was lowered past an edge was "picked up again ... for 646.2 s: pay out more slack".

It met a beam on its way down at 849.7 s, slid off at 853.8 s and went on down with its hook. What lets a load
go in the step that lowers it, so that it hangs lower from then on, picks nothing up.
"""

from __future__ import annotations

from gantline import simulate
from gantline.scenario import parse_scenario
from of_recording import checks_of
from onto_a_deck import onto_a_deck

#: The load hangs 0.3 m above a deck, meets it 6 s after it begins to go down, at 12 s, and goes on to 0.6 m
#: below that, while the deck goes away from under it to 2 m below.
LIFT = onto_a_deck(
    "  - {step: down, lower: hook, speed: 3 m/min, by: 0.9 m}",
    "{at: 13 s, duration: 0.5 s, velocity: -0.4 m/s}, {at: 18 s, duration: 0.5 s, velocity: 0 m/s}",
    end=26.0,
)


def test_it_has_not_been_picked_up() -> None:
    recording = simulate(parse_scenario(LIFT))
    kinds = [kind for _, kind, name in recording.events() if name == "box"]
    assert kinds[0] == "set_down" and kinds[-1] == "lift_off"  # it stood, and hangs in the end
    assert checks_of(recording, "stays_set_down") == []
