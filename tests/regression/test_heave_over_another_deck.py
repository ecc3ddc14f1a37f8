"""A hook that goes from one `relative_to` to another, or to the ground, was jerked.

Heave compensation began anew in such a step, from rest: what it had moved the hook with, 0.25 m/s in the
middle of a wave, stopped as suddenly as its acceleration let it, and what it had to compensate from then on
counted from nothing within 4 s. A load of 140 t picked up from a barge, whose hook was then kept still over
the ground, pulled with 1743 kN a quarter of a second later, for 1389 kN before. What the boom head heaves
goes on now, and from the heave of one deck to that of the other it takes 4 s.
"""

from __future__ import annotations

from importlib.resources import files

import numpy as np

import gantline
from compensated import EASE, HOOK, VESSEL, deck_below, head_of, place_of, slow
from gantline.scenario import parse_scenario
from gantline.scenario.cranes.heave import FILTER
from lift_text import changed

#: When the step ends that keeps the hook still above the deck [s].
TURNS = 31.3


def test_from_a_deck_to_the_ground_without_haste() -> None:
    """(HC1) over the heave of the boom head, of which that of the deck is taken off less and less.

    To 0.6 %, as over one deck.
    """
    name = files("gantline.scenarios") / "off_a_barge.yaml"
    text = name.read_text(encoding="utf-8")
    begin, end = text.index("\nplan:\n"), text.index("\nwatch:\n")
    plan = (
        f"  - {{step: above deck, hold: {TURNS} s, compensate_heave: H1, relative_to: cargo}}\n"
        "  - {step: above ground, hold: until_end, compensate_heave: H1}\n"
    )
    can = "heave_compensation: {speed: 2 m/s, acceleration: 2 m/s^2}"
    text = changed(
        text[:begin] + f"\nplan:\n{plan}" + text[end:],
        ("duration: 200 s", "duration: 50 s"),
        ("emergency_acceleration: 0.1 m/s^2}", f"emergency_acceleration: 0.1 m/s^2, {can}}}"),
    )
    recording = gantline.Simulation(parse_scenario(text, str(name))).run()
    time = recording.time
    place = place_of(recording, VESSEL, head_of(recording))
    deck = deck_below(recording, "cargo", place)
    counts, ground = (np.clip((time[1:] - since) / EASE, 0.0, 1.0) for since in (0.0, TURNS))
    rises = counts * (np.diff(place[:, 2]) - (1.0 - ground) * np.diff(deck))
    heave = np.concatenate([[0.0], np.cumsum(rises)])
    wanted = slow(time, heave, FILTER) - heave
    added = recording.column("heave_compensation", HOOK)
    late = time > TURNS
    assert np.ptp(deck[late]) > 0.1 and np.ptp(wanted[late]) > 0.1
    assert np.sqrt(np.mean((added - wanted) ** 2)) < 6e-3 * np.sqrt(np.mean(wanted**2))
