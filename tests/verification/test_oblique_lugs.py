"""Lugs whose main plates lie along no two axes of the load."""

from __future__ import annotations

import math

import pytest

import gantline
from gantline.results.series import out_of_plane_angles
from gantline.scenario import parse_scenario
from plated_lift import plated_lift

LEAN = math.radians(35.0)


def angles(plate: str) -> list[float]:
    """Angles of the slings at A and B to such plates at the start [rad]."""
    recording = gantline.simulate(parse_scenario(plated_lift(LEAN, plate)), duration=0.1)
    found = {
        lug: float(series[0])
        for sling in recording.rig.slings
        for (_, lug), series in out_of_plane_angles(recording, sling).items()
    }
    return [found["A"], found["B"]]


@pytest.mark.parametrize("turned", [0.0, 30.0, 90.0, 120.0, -45.0])
def test_upright_plate_that_is_turned(turned: float) -> None:
    """A sling that leans by a in yz leaves a plate turned by t from xz by asin(sin a |cos t|)."""
    expected = math.asin(math.sin(LEAN) * abs(math.cos(math.radians(turned))))
    # At the start the load stands as the lift file has it: slings lean by rounding less or more.
    assert angles(f"{{turned: {turned} deg}}") == pytest.approx([expected, expected], abs=1e-12)


def test_plate_that_leans() -> None:
    """A normal in yz, of any length, across the sling at A; the one at B leans the other way, by 2 a."""
    normal = f"{{normal: [0, {3 * math.cos(LEAN)!r}, {3 * math.sin(LEAN)!r}]}}"
    expected = [0.0, math.asin(math.sin(2 * LEAN))]
    assert angles(normal) == pytest.approx(expected, abs=1e-12)


@pytest.mark.parametrize(("turned", "word"), [(0.0, "xz"), (90.0, "yz")])
def test_turned_plates_are_those_with_a_word(turned: float, word: str) -> None:
    """A plate xz turned by a right angle is one in yz."""
    assert angles(f"{{turned: {turned} deg}}") == pytest.approx(angles(word), abs=1e-15)
