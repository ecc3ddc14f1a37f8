"""Heights at which things cannot well be, in lifts that come with gantline with a number changed."""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import parse_scenario
from reference_lift import ROOT

PINS = ("heel_pins: {at: [84 m, 0 m, 7.5 m]", "heel_pins: {at: [84 m, 0 m, 75 m]")
TOP = ("from: [60 m, 5 m, 38 m]", "from: [60 m, 5 m, 105.5 m]")


def doubts(scenario: str, *pairs: tuple[str, str]) -> list[tuple[str, str]]:
    """Path and sentence of each doubt about a lift of which some texts are changed."""
    path = ROOT / "scenarios" / scenario / "scenario.yaml"
    text = path.read_text(encoding="utf-8")
    for old, new in pairs:
        assert old in text, old
        text = text.replace(old, new)
    found = assemble(parse_scenario(text, str(path))).doubts
    return [(one.path, one.sentence) for one in found]


@pytest.mark.parametrize(
    ("scenario", "pairs", "path", "said"),
    [
        (
            "upending",
            [("height: 2.5 m", "height: 25 m")],
            "cranes.main.boom.heel_pins.height",
            "the heel pins of main.boom are 25.0 m over the ground, and it is 63.0 m long; a digit has",
        ),
        (
            "off_a_barge",
            [PINS, TOP],
            "cranes.sheerleg.boom.heel_pins.at",
            # 75 m over the keel of a hull that is 6.5 m deep.
            "the heel pins of sheerleg.boom are 68.5 m over the deck, and it is 55.0 m long; a digit",
        ),
        (
            "floating_crane_and_crawlers",
            [("level: 0 m}", "level: 5 m}")],
            "water.level",
            "the ground at 3.5 m is 1.50 m under water, and is taken as dry under crane c1, crane c2; a",
        ),
        (
            "goliath",
            [("\nload:", "\nwater: {density: 1025 kg/m^3, level: 2 m}\nload:")],
            "water.level",
            "the ground at 0 m is 2.00 m under water, and is taken as dry under supports keel_blocks; a",
        ),
        (
            "goliath",
            [("[-35 m, 0 m, 1.5 m]", "[-35 m, 0 m, 2.0 m]"), ("  stands_on: keel_blocks\n", "")],
            "load.position",
            "to leave what it stands on, and it begins 0.50 m over "
            "'keel_blocks.1.1': see its position, and 'stands_on'",
        ),
        (
            "off_a_barge",
            [("102.8 m, 0 m, 3.5 m", "102.8 m, 0 m, 4.0 m")],
            "load.position",
            "step 'lift off' waits for module to leave what it stands on, and it begins 0.50 m over",
        ),
    ],
)
def test_what_is_told(scenario: str, pairs: list[tuple[str, str]], path: str, said: str) -> None:
    found = [sentence for at, sentence in doubts(scenario, *pairs) if at == path]
    assert len(found) == 1
    assert said in found[0]


@pytest.mark.parametrize(
    ("scenario", "pairs"),
    [
        # On the grillage but for less than slings stretch; and where the plan waits for nothing to come off.
        ("off_a_barge", [("102.8 m, 0 m, 3.5 m", "102.8 m, 0 m, 3.55 m")]),
        (
            "off_a_barge",
            [("102.8 m, 0 m, 3.5 m", "102.8 m, 0 m, 4.0 m"), ("until: {supports: clear}", "by: 1 m")],
        ),
        # A pedestal: a third of the boom over the deck.
        ("off_a_barge", [("84 m, 0 m, 7.5 m], apart: 14 m", "84 m, 0 m, 25 m], apart: 14 m"), TOP]),
    ],
)
def test_what_is_not(scenario: str, pairs: list[tuple[str, str]]) -> None:
    assert doubts(scenario, *pairs) == doubts(scenario)
