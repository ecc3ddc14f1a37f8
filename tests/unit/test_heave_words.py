"""Heave compensation in the lift file: what is refused, and with which words."""

from __future__ import annotations

import pytest

from compensated import BARGE, compensated, compensated_text
from gantline.assembly import assemble
from gantline.scenario import ScenarioError, parse_scenario
from lift_text import changed

STEP = "  - {step: still, hold: until_end, compensate_heave: H1}\n"


def refused(text: str) -> str:
    with pytest.raises(ScenarioError) as caught:
        parse_scenario(text, "lift.yaml")
    return str(caught.value).partition(": ")[2]


@pytest.mark.parametrize(
    ("new", "says"),
    [
        (
            "compensate_heave: H2",
            "step 'still', plan[1].compensate_heave: 'H2' is not a hook; known here: 'sheerleg.H1'",
        ),
        (
            "compensate_heave: [H1, sheerleg.H1]",
            "step 'still', plan[1].compensate_heave: names a hook twice; each hook stands once",
        ),
        (
            "compensate_heave: H1, relative_to: berge",
            "step 'still', plan[1].relative_to: 'berge' is not a vessel; did you mean 'barge'?",
        ),
        (
            "compensate_heave: H1, relative_to: platform",
            "step 'still', plan[1].relative_to: 'platform' is not a vessel; known here: 'barge'; "
            "without it that is the "
            "ground, and all that stands on it",
        ),
        (
            "compensate_heave: H1, relative_to: barge",
            "step 'still', plan[1].relative_to: 'barge' bears 'sheerleg.H1' itself, whose boom head "
            "does not heave "
            "against it; name another vessel, or none",
        ),
        (
            "relative_to: barge",
            "step 'still', plan[1].relative_to: 'relative_to' stands beside 'compensate_heave'; found "
            "it alone",
        ),
    ],
)
def test_steps_that_compensate_what_cannot_be(new: str, says: str) -> None:
    found = refused(compensated_text(changed(STEP, ("compensate_heave: H1", new))))
    assert found == says


def test_a_hoist_that_cannot_says_what_it_needs() -> None:
    assert refused(compensated_text(STEP, can="")) == (
        "step 'still', plan[1].compensate_heave: the hoist of 'H1' does not compensate heave; give it "
        "some, such as "
        "'heave_compensation: {speed: 1 m/s, acceleration: 1 m/s^2}'"
    )


def test_a_hook_on_land_does_not_heave() -> None:
    hoist = "{speed: 6 m/min, acceleration: 0.02 m/s^2}"
    land = f"  quay: {{type: fixed_hook, at: [0 m, 40 m, 30 m], hoist: {hoist}}}\n"
    text = compensated_text(STEP.replace("H1", "quay"))
    text = changed(text, ("cranes:\n", f"cranes:\n{land}"))
    assert refused(text) == (
        "step 'still', plan[1].compensate_heave: 'quay' hangs from no crane on a vessel, and so "
        "nothing of it heaves; "
        "leave it out"
    )


def test_the_filter_has_a_time_if_none_is_given() -> None:
    (hook,) = compensated(STEP).hooks.values()
    assert hook.hoist.heave_compensation is not None
    assert (hook.hoist.heave_compensation.filter, hook.hoist.heave_compensation.stroke) == (25.0, None)


def test_without_waves_it_is_doubted() -> None:
    """What is in the file and does nothing is told."""
    text = compensated_text(STEP)
    swell = text[text.index("waves:\n") : text.index("ropes:\n")]
    doubts = assemble(parse_scenario(changed(text, (swell, "")), str(BARGE))).doubts
    sentence = "step 'still' compensates heave, and there are no waves that heave anything"
    assert sentence in [doubt.sentence for doubt in doubts]
    sea = assemble(compensated(STEP))
    assert sentence not in [doubt.sentence for doubt in sea.doubts]
