"""Slings that waves all but unload in the splash zone were told of only against a limit of one's own.

A load of 60 t of which water bears 53 t, let down through waves of 1.5 m, left its hook 5 kN of 65 kN: a
higher crest has its slings slack, and they snatch. No force was large, no sling slack: a GO.
"""

from __future__ import annotations

import math
from functools import cache
from importlib.resources import files

import pytest

from gantline.checks import Verdict
from gantline.results import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from lift_text import changed
from mechanics import G
from of_recording import check_of, checks_of

FILE = files("gantline.scenarios") / "splash_zone.yaml"
#: What the load displaces [m^3]; lengths of its slings, and how far lugs are from below the hook [m].
VOLUME, SLING, ASIDE = 52.0, 9.0, math.hypot(3.0, 2.0)


@cache
def through_waves(height: float, more: str = "") -> Recording:
    """Through waves of a significant height [m], with no limit but this."""
    text = FILE.read_text(encoding="utf-8")
    begin, end = text.index("\nplan:"), text.index("\nsimulation:")
    plan = (
        "\n  - {step: in the air, hold: 10 s}\n  - {step: lower, lower: crane, speed: 12 m/min, by: 13 m}\n"
    )
    text = f"{text[:begin]}\nplan:{plan}limits: {{sling_factor_on_breaking_force: 3{more}}}\n{text[end:]}"
    return simulate(
        parse_scenario(
            changed(
                text,
                ("duration: 260 s", "duration: 80 s"),
                ("significant_height: 1.5 m", f"significant_height: {height} m"),
                ("displaced_volume: 7.6 m^3", f"displaced_volume: {VOLUME} m^3"),
            ),
            str(FILE),
        )
    )


def test_a_tenth_of_what_water_leaves_has_to_stay() -> None:
    """DNV-RP-H103, 4: what water does takes no more than 0.9 of the static weight, wholly wet."""
    recording = through_waves(1.5)
    [load] = recording.rig.loads
    left = load.weight - 1025.0 * G * VOLUME
    tenth = 0.1 * left / 4.0 / math.sqrt(1.0 - (ASIDE / SLING) ** 2)
    assert 1.5e3 < tenth < 2.0e3
    check = check_of(recording, "smallest_sling_tension_when_clear")
    assert check.verdict is Verdict.WARNING
    assert check.limit == pytest.approx(tenth, rel=2e-2)
    assert check.value is not None and check.value < tenth


def test_in_smaller_waves_nothing_is_told() -> None:
    """A third of the height: the hook keeps more than half of what water leaves it."""
    recording = through_waves(0.5)
    assert not checks_of(recording, "smallest_sling_tension_when_clear")


def test_a_limit_of_the_lift_file_takes_its_place() -> None:
    """Who has looked at snap loads may allow it."""
    recording = through_waves(1.5, ", smallest_sling_tension_when_clear: 0 kN")
    assert check_of(recording, "smallest_sling_tension_when_clear").verdict is Verdict.OK
