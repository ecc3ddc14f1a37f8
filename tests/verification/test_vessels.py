"""Vessels in the words of a lift file against closed forms and hand figures."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from floating import SEA, pitch_and_roll
from gantline.assembly import assemble
from gantline.scenario import load_scenario
from gantline.statics import Statics

LENGTH, BREADTH, DEPTH, DRAFT, KG = 100.0, 30.0, 8.0, 4.0, 5.0
MASS = SEA * LENGTH * BREADTH * DRAFT
AHEAD, ABOVE = 65.0, 60.0


def barge(**changes: Any) -> dict[str, Any]:
    """A barge of 100 × 30 × 8 m that weighs 12 300 t."""
    return {
        "draft": f"{DRAFT} m",
        "hull": {"box": [f"{LENGTH} m", f"{BREADTH} m", f"{DEPTH} m"]},
        "masses": {"hull": {"mass": f"{MASS} kg", "at": [f"{LENGTH / 2} m", "0 m", f"{KG} m"]}},
        "radii_of_gyration": ["11 m", "27 m", "27 m"],
        **changes,
    }


def afloat(folder: Path, vessel: dict[str, Any], **changes: Any) -> Path:
    """The lift file with one vessel; JSON is YAML."""
    given = {
        "format": 1,
        "lift": {"title": "A barge"},
        "duration": "1 s",
        "vessels": {"barge": vessel},
        **changes,
    }
    path = folder / "lift.yaml"
    path.write_text(json.dumps(given), encoding="utf-8")
    return path


def test_barge_with_a_load_ahead_of_its_bow(tmp_path: Path) -> None:
    """1000 t at 65 m ahead of the middle and 60 m up: T = ∇/LB = 4.325 m, GM_L = T/2 + L²/12T − KG = 185.70 m
    and with it 1.508°. Exactly: B stands below G, t (GM + BM t²/2) = x_G with t = tan θ; no deck is wet.
    """
    masses = barge()["masses"] | {
        "load": {"mass": "1000 t", "at": [f"{LENGTH / 2 + AHEAD} m", "0 m", f"{ABOVE} m"]}
    }
    question = Statics(afloat(tmp_path, barge(masses=masses, heading="30 deg", trim="1 deg", heel="2 deg")))
    rest = question.equilibrium()
    assert (rest.unstable, rest.neutral) == (0, 3), "nothing holds surge, sway and yaw"
    total = MASS + 1e6
    draft = total / (SEA * LENGTH * BREADTH)
    kg, lever = (MASS * KG + 1e6 * ABOVE) / total, 1e6 * AHEAD / total
    bm = LENGTH**2 / (12 * draft)
    gm = draft / 2 + bm - kg
    assert (draft, gm) == pytest.approx((4.325, 185.70), abs=0.005)
    assert math.degrees(lever / gm) == pytest.approx(1.508, abs=0.0005)
    (tangent,) = (root.real for root in np.roots([bm / 2, 0, gm, -lever]) if abs(root.imag) < 1e-9)
    bow, side = pitch_and_roll(rest.recording["body_orientation"].values[-1, 0])
    # The equilibrium is found to 1e-9 of the forces, and GM is a twentieth of a hull's size: 1e-9 of the
    # angle.
    assert math.tan(-bow) == pytest.approx(tangent, rel=2e-9)
    assert side == pytest.approx(0, abs=1e-9)


def test_a_vessel_starts_as_it_is_said_to_lie(tmp_path: Path) -> None:
    """Drafts of a box trimmed by t and heeled by h: the water is T along its z from the keel at half length,
    and higher towards stern and starboard by tan t and tan h / cos t along its axes.
    """
    trim, heel, heading = math.radians(1.5), math.radians(-4.0), math.radians(30.0)
    said = {"position": ["10 m", "-5 m"], "heading": "30 deg", "heel": "-4 deg", "trim": "1.5 deg"}
    scenario = load_scenario(afloat(tmp_path, barge(**said), water={"level": "0.7 m"}, start="as_given"))
    (body,) = assemble(scenario).document["bodies"]
    assert body["joint"]["position"][:2] == [10.0, -5.0]
    w, x, y, z = body["joint"]["orientation"]
    turn = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )
    # Its bow points 30° from x towards y, and rises by the trim.
    bow = [math.cos(trim) * math.cos(heading), math.cos(trim) * math.sin(heading), math.sin(trim)]
    assert turn[:, 0] == pytest.approx(bow, abs=1e-15)
    # Port rises where it heels to starboard.
    assert turn[2, 1] == pytest.approx(math.cos(trim) * math.sin(heel), abs=1e-15)
    for at in ((0.0, 0.0), (100.0, 15.0), (30.0, -15.0)):
        up = math.tan(trim) / math.cos(heel) * (50.0 - at[0]) - math.tan(heel) * at[1]
        place = np.array(body["joint"]["position"]) + turn @ [*at, DRAFT + up]
        assert place[2] == pytest.approx(0.7, abs=1e-12)
