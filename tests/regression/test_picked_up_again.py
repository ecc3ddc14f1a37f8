"""A load that was set down and picked up again was told that "creep, or a brake before it, is usual".

A manifold stood on the sea bed with slack slings when its plan ended heave compensation: a swell picked it
up and dropped it six times at up to 32 m/min. No step lowered it then, so creep helps nothing; where it came
down by less than 6 m/min nothing told of it at all. A deck that came up again under what had just lifted off
was told the same.
"""

from __future__ import annotations

from gantline import simulate
from gantline.checks import Check, check_recording
from gantline.scenario import parse_scenario
from onto_a_deck import onto_a_deck

#: The load hangs 0.3 m above the deck; at 0.05 m/s it stands 6 s after it begins to go down, at 12 s.
DOWN = "  - {step: set down, lower: hook, speed: 3 m/min, until: {supports: touched}}"
SLACK = "  - {step: slack, lower: hook, speed: 3 m/min, by: 0.5 m}"
STANDS = "{at: 23 s, duration: 0.5 s, velocity: 0.01 m/s}"
#: From 16 s on by 1 m down, and from 20 s on by 1.2 m up, at 0.4 m/s or 24 m/min.
DIPS = ", ".join(
    f"{{at: {at} s, duration: 0.5 s, velocity: {speed} m/s}}"
    for at, speed in ((16, -0.4), (18.5, 0.0), (20, 0.4), (23, 0.0))
)


def told(
    plan: str, motion: str, *, height: float = 0.3, hook: float = 7.3, waves: str = ""
) -> dict[str, Check]:
    """What is said of a load that is set down, by the name of the check."""
    text = onto_a_deck(plan, motion, height=height, hook=hook) + waves
    names = ("set_down_softly", "stays_set_down")
    return {one.name: one for one in check_recording(simulate(parse_scenario(text))) if one.name in names}


def test_a_load_that_stays_where_it_is_set_down() -> None:
    assert told(DOWN, STANDS) == {}


def test_a_load_that_its_deck_leaves_and_meets_again() -> None:
    """The deck goes down 1 m, while the slings have next to no slack: the load hangs from then on."""
    found = told(DOWN, DIPS)
    again, hard = found["stays_set_down"], found["set_down_softly"]
    # From 16 s on the deck goes down 0.4 t² m: beyond slack and give in less than half a second.
    assert again.time is not None and 16.0 < again.time < 16.5
    assert "it is picked up again in 'end', once, for" in again.remark
    assert again.remark.endswith("s at most: pay out more slack, as soon as it stands")
    assert hard.remark.startswith("it meets what is below it at 24.")
    assert hard.remark.endswith("; it had been set down, and was picked up again")


def test_slack_enough_leaves_it_on_its_deck() -> None:
    """Three times 0.5 m of slack for 1 m of deck."""
    more = SLACK.replace("0.5 m", "1.5 m").replace("3 m/min", "30 m/min")
    assert "stays_set_down" not in told(f"{DOWN}\n{more}", DIPS)


def test_what_a_step_takes_up_again_is_not_told() -> None:
    up = "  - {step: up again, hoist: hook, speed: 6 m/min, by: 0.5 m}"
    assert "stays_set_down" not in told(f"{DOWN}\n{up}", STANDS)


def test_a_deck_that_comes_up_under_what_has_just_lifted_off() -> None:
    """It starts with slack slings; the deck goes down and up under it, within 5 s of its lift-off."""
    off = "  - {step: off, hoist: hook, speed: 3 m/min, by: 0.4 m}"
    rises = ", ".join(
        f"{{at: {at} s, duration: 0.5 s, velocity: {speed} m/s}}"
        for at, speed in ((11, -0.4), (12, 0.0), (13, 0.4), (15, 0.0))
    )
    found = told(off, rises, height=0.0, hook=6.8)
    assert "stays_set_down" not in found
    assert found["set_down_softly"].remark.endswith("; it had just lifted off; hoist it off faster")


def test_a_deck_that_comes_up_a_wave_later() -> None:
    """It hoists on at 1.2 m/min for 8 s, 0.16 m, and the deck is back then; "no step lowers it then; keep it
    farther away" was what `off_a_barge` said of 5.1 s.

    Without waves what hung for as long had come off for good, and met something else.
    """
    off = "  - {step: off, hoist: hook, speed: 1.2 m/min, by: 0.4 m}"
    rises = ", ".join(
        f"{{at: {at} s, duration: 0.5 s, velocity: {speed} m/s}}"
        for at, speed in ((11, -0.4), (12, 0.0), (19, 0.4), (20.5, 0.0))
    )
    assert told(off, rises, height=0.0, hook=6.8)["set_down_softly"].remark.endswith("keep it farther away")
    waves = "waves: {swell: {height: 1 m, period: 8 s, direction: 0 deg}}\n"
    found = told(off, rises, height=0.0, hook=6.8, waves=waves)
    helps = "hoist it off faster, or wait for less sea"
    assert found["set_down_softly"].remark.endswith(f"; it had just lifted off; {helps}")
