"""The crane barge of the scenario `crane_barge_in_swell`, whose hoist compensates heave."""

from __future__ import annotations

import re
from importlib.resources import files

import numpy as np
import numpy.typing as npt
from scipy.spatial.transform import Rotation

from gantline.results import Recording
from gantline.scenario import Scenario, parse_scenario
from gantline.scenario.cranes.heave import FILTER
from lift_text import changed

BARGE = files("gantline.scenarios") / "crane_barge_in_swell.yaml"
HOOK, VESSEL = "sheerleg.H1", "barge"

#: Within this it begins and ends [s].
EASE = 4.0

Array = npt.NDArray[np.float64]


def compensated_text(
    plan: str, *, can: str = "speed: 1 m/s, acceleration: 1 m/s^2", lasts: str = "120 s"
) -> str:
    """Its lift file, with these steps and what the hoist can do against heave, if anything."""
    text = BARGE.read_text(encoding="utf-8")
    for section, instead in (("plan", f"plan:\n{plan}"), ("watch", ""), ("cases", ""), ("limits", "")):
        text, count = re.subn(
            rf"^{section}:.*?(?=^\w)", instead, text, count=1, flags=re.DOTALL | re.MULTILINE
        )
        assert count == 1, section
    stops = "emergency_acceleration: 0.1 m/s^2"
    more = f", heave_compensation: {{{can}}}" if can else ""
    return changed(text, ("duration: 300 s", f"duration: {lasts}"), (stops, f"{stops}{more}"))


def compensated(plan: str, **how: str) -> Scenario:
    """The lift of `compensated_text`."""
    return parse_scenario(compensated_text(plan, **how), str(BARGE))


def place_of(recording: Recording, vessel: str, point: Array) -> Array:
    """Where the place of a vessel is over time (time, xyz) that is at a point at the start [m]."""
    centre = recording.column("body_position", vessel)
    turned = _turned(recording, vessel)
    place: Array = centre + turned @ (turned[0].T @ (point - centre[0]))
    return place


def deck_below(recording: Recording, vessel: str, points: Array) -> Array:
    """How high the level of a vessel through its centre of gravity is plumb below points (time, xyz) [m]."""
    normal = _turned(recording, vessel)[..., 2]
    off = points - recording.column("body_position", vessel)
    level: Array = points[:, 2] - np.sum(normal * off, axis=1) / normal[:, 2]
    return level


def _turned(recording: Recording, body: str) -> Array:
    """Rotation matrices of a body (time, 3, 3)."""
    turns = Rotation.from_quat(recording.column("body_orientation", body), scalar_first=True)
    matrices: Array = turns.as_matrix()
    return matrices


def head_of(recording: Recording) -> Array:
    """Where the upper sheaves hang at the start [m]."""
    place: Array = recording.column("body_position", f"{HOOK}/upper_sheaves")[0]
    return place


def expected(time: Array, heave: Array) -> Array:
    """(HC1): what a hoist adds that compensates from the start, 4 s of which count more and more [m]."""
    share = np.clip(time[1:] / EASE, 0.0, 1.0)
    counted = heave[0] + np.concatenate([[0.0], np.cumsum(share * np.diff(heave))])
    added: Array = slow(time, counted, FILTER) - counted
    return added


def slow(time: Array, height: Array, within: float) -> Array:
    """What a first-order filter keeps of a height that is straight between its samples: ds/dt = (z - s)/τ."""
    found = np.empty_like(height)
    found[0] = height[0]
    for k, h in enumerate(np.diff(time)):
        keeps, slope = np.exp(-h / within), (height[k + 1] - height[k]) / h
        lags = found[k] - height[k] + slope * within
        found[k + 1] = height[k + 1] - slope * within + lags * keeps
    return found
