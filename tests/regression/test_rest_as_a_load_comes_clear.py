"""A load lifted in wind slides on its last corner and turns away: `gantline statics` found no rest then.

What a corner holds follows what presses on it. Here what it held pressed sixty times as much off it: each
search followed at least a sixteenth of the change asked for, lifted the corner off, forgot all that it had
held, and began anew, 200 times. What is followed is as small as it must be now, a corner that has come off
goes half way back, and what no search can tell any more is taken as found.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from gantline.scenario import parse_scenario
from gantline.statics import Losses, Statics

SCENARIO = Path(__file__).parents[2] / "scenarios" / "spreader_bar" / "scenario.yaml"
HANGS = 450e3
"""Less than what hangs from the bar's slings [N]."""


@pytest.mark.parametrize(
    ("speed", "at", "time", "losses"),
    [(4.0, "", 30.0, "held"), (4.0, ", at: [0 m, 0 m, 1.75 m]", 30.0, "none"), (8.0, "", 100.0, "held")],
)
def test_it_hangs_edge_on_to_the_wind(speed: float, at: str, time: float, losses: Losses) -> None:
    """One area, beside the centre of gravity, and nothing that holds the load against turning: it turns until
    the wind finds no area, and the slings of the bar, now across the wind, hang straight. Forces balance to
    1e-9 of what hangs, and their ways are differences of places of 10 m, which leaves 1e-7. Near edge-on the
    force of the wind falls with the square of the angle, so that the last thousandth is beneath that."""
    areas = f"wind_areas: {{end: {{area: 40 m^2, coefficient: 1.2, along: x{at}}}}}"
    wind = f"wind: {{speed: {speed} m/s, direction: 0 deg}}"
    text = SCENARIO.read_text().replace("load:\n", f"{wind}\nload:\n  {areas}\n", 1)
    rest = Statics(parse_scenario(text)).equilibrium(time, losses=losses)
    data = rest.recording.dataset.isel(time=-1)
    assert not data["contact_force"].values.any()
    # The slings come first, from hook to bar, each with its two ends.
    assert list(data["rope"].values[:2]) == ["sling.T1", "sling.T2"]
    ends = data["rope_point"].values[:4].reshape(2, 2, 3)
    ways = ends[:, 0] - ends[:, 1]
    pull = data["rope_tension"].values[:2] @ (ways / np.linalg.norm(ways, axis=1, keepdims=True))
    assert pull[2] > HANGS
    assert pull[:2] == pytest.approx([0.0, 0.0], abs=1e-7 * pull[2])
    along = ends[1, 1] - ends[0, 1]
    assert abs(along[0]) < 1e-3 * np.linalg.norm(along)
