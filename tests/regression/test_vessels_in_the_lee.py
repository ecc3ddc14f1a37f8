"""Two vessels side by side in waves: each feels them as if alone, and only the documentation said so.

`off_a_barge` has a cargo barge 1 m before the bow of a crane barge 30 m wide, in a swell onto that bow. What
the one does to the waves at the other is left out, and the lift was a GO without a word.
"""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import waves
from afloat import BREADTH, LENGTH
from gantline.assembly import assemble
from gantline.assembly.doubts.lee import distance_in_plan
from gantline.scenario import load_scenario

SWELL = {"swell": {"height": "1 m", "period": "8 s", "direction": "0 deg"}}
#: Corners of an oblong about its middle [m].
OBLONG = np.array([[-3.0, -1.0], [3.0, -1.0], [3.0, 1.0], [-3.0, 1.0]])


def warnings_of(folder: Path, sea: dict[str, Any], beside: tuple[float, float], heading: float) -> str:
    """Of the barge with another one like it, whose stern is at a place [m] and which is turned [deg]."""
    path = waves.in_waves(folder, sea)
    lift = json.loads(path.read_text(encoding="utf-8"))
    placed = {"position": [f"{at} m" for at in beside], "heading": f"{heading} deg"}
    lift["vessels"]["other"] = {**lift["vessels"]["barge"], **placed}
    path.write_text(json.dumps(lift), encoding="utf-8")
    return "\n".join(assemble(load_scenario(path)).warnings)


@pytest.mark.parametrize(
    ("beside", "heading", "apart"),
    [
        ((0.0, BREADTH + 20.0), 0.0, "20.0 m"),
        ((0.0, BREADTH / 2 + 2.0), 90.0, "2.0 m"),
        ((LENGTH + 12.0, BREADTH + 16.0), 0.0, "20.0 m"),  # from corner to corner
        ((0.0, BREADTH + 31.0), 0.0, None),
        ((LENGTH + 18.1, BREADTH + 24.1), 0.0, None),
    ],
)
def test_close_vessels_are_a_warning(
    tmp_path: Path, beside: tuple[float, float], heading: float, apart: str | None
) -> None:
    said = warnings_of(tmp_path, SWELL, beside, heading)
    wanted = f"barge and other lie {apart} apart, nearer than a breadth, 30.0 m"
    assert (wanted in said) if apart else ("apart" not in said)


def test_still_water_has_no_lee(tmp_path: Path) -> None:
    assert "apart" not in warnings_of(tmp_path, {}, (0.0, BREADTH + 5.0), 0.0)


def _to_sides(points: Any, outline: Any) -> float:
    """Least distance of points to the sides of an outline [m], one side after the other."""
    least = math.inf
    for start, end in zip(outline, np.roll(outline, -1, axis=0), strict=True):
        along = end - start
        share = np.clip((points - start) @ along / (along @ along), 0.0, 1.0)
        least = min(least, float(np.linalg.norm(points - start - share[:, np.newaxis] * along, axis=1).min()))
    return least


@given(st.floats(0.0, 7.0), st.floats(6.5, 30.0), st.floats(0.0, 7.0), st.floats(0.0, 7.0))
def test_distance_is_that_of_corners_to_sides(bearing: float, apart: float, one: float, other: float) -> None:
    """Outlines that do not meet are nearest at a corner of one; circles about these are 6.33 m across."""

    def turned(angle: float) -> Any:
        cos, sin = math.cos(angle), math.sin(angle)
        return OBLONG @ np.array([[cos, sin], [-sin, cos]])

    first = turned(one)
    second = turned(other) + apart * np.array([math.cos(bearing), math.sin(bearing)])
    nearest = min(_to_sides(first, second), _to_sides(second, first))
    assert distance_in_plan(first, second) == pytest.approx(nearest, abs=1e-12 * apart)


def test_outlines_that_overlap_are_not_apart() -> None:
    assert distance_in_plan(OBLONG, OBLONG + np.array([1.0, 0.5])) == 0.0
