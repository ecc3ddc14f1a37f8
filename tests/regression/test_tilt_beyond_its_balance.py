"""A step waited for 80 deg of a load that hung from two hooks alone at 77.6 deg, and was in order by `check`.

The other hook let its end down until its slings were slack, and went on down until the run was over.
"""

from __future__ import annotations

import math

from gantline.assembly import assemble
from gantline.scenario import parse_scenario
from hooked_lift import hooked_lift

#: Lugs of the higher end, 8.2 m before the centre of gravity and 1.8 m above; of the lower end on one line.
HIGH, LOW, CENTRE = (-8.0, 3.6), (8.0, 2.0), (0.2, 0.0, 1.8)
#: From the lugs to the centre of gravity there are 8.2 m along and 1.8 m down.
BALANCE = math.degrees(math.atan2(8.2, 1.8))
TURN = "{step: turn, lower: L, speed: 0.1 m/s, until: {load_tilt: {above: ASKED}}}"


def told(*plan: str, more: str = "") -> list[str]:
    lugs = {"A1": (HIGH[0], 6.0, HIGH[1]), "A2": (HIGH[0], -6.0, HIGH[1])}
    lugs |= {"B1": (LOW[0], 3.0, LOW[1]), "B2": (LOW[0], -3.0, LOW[1])}
    hooks = {"U1": (-8.0, 6.0, 26.0), "U2": (-8.0, -6.0, 26.0), "L": (8.0, 0.0, 26.0)}
    slings = {
        "A1": ("U1", "A1", 12.4),
        "A2": ("U2", "A2", 12.4),
        "B1": ("L", "B1", 14.4),
        "B2": ("L", "B2", 14.4),
    }
    steps = "".join(f"  - {step}\n" for step in (*plan, "{step: end, hold: until_end}"))
    text = hooked_lift(
        hooks,
        lugs,
        slings,
        mass=240e3,
        centre=CENTRE,
        box=(16.0, 18.0, 4.0),
        position=(0.0, 0.0, 10.0),
        more=f"plan:\n{steps}{more}",
    )
    doubts = (doubt.of("lift") for doubt in assemble(parse_scenario(text)).doubts)
    return [said for said in doubts if "waits for a tilt" in said]


def test_lowering_the_other_end_turns_it_no_farther() -> None:
    assert round(BALANCE, 1) == 77.6
    (said,) = told(TURN.replace("ASKED", "80 deg"))
    assert (
        "plan[1].until: step 'turn' waits for a tilt above 80.0 deg, and from U1 and U2 alone the load"
        in said
    )
    assert "the load hangs at 77.6 deg: the slings of its other end hang slack from there on" in said


def test_nor_does_hoisting_this_one() -> None:
    hoist = "{step: turn, hoist: [U1, U2], speed: 0.1 m/s, until: {load_tilt: {above: ASKED}}}"
    assert "from U1 and U2 alone the load hangs at 77.6 deg" in told(hoist.replace("ASKED", "85 deg"))[0]
    assert not told(hoist.replace("ASKED", "77 deg"))


def test_what_it_comes_to_is_in_order() -> None:
    """Of the other end as the higher one the balance is atan2(7.8, 0.2), 88.5 deg."""
    assert not told(TURN.replace("ASKED", "77 deg"))
    other = "{step: turn, hoist: L, speed: 0.1 m/s, until: {load_tilt: {above: ASKED}}}"
    assert not told(other.replace("ASKED", "88 deg"))
    assert "from L alone the load hangs at 88.5 deg" in told(other.replace("ASKED", "90 deg"))[0]


def test_nothing_is_said_where_slings_come_and_go_or_all_hooks_move() -> None:
    rest, off = "{step: rest, hold: 1 s}", "{step: off, hold: 1 s, detach: sling.B1}"
    assert told(rest, TURN.replace("ASKED", "80 deg"))
    assert not told(rest, off, TURN.replace("ASKED", "80 deg"))
    every = "{step: turn, lower: [U1, U2, L], speed: 0.1 m/s, until: {load_tilt: {above: 80 deg}}}"
    assert not told(every)
