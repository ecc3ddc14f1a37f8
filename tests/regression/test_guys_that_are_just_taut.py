"""A mast that stands between guys which are just taut, and pull with nothing, is stable.

Whichever way it leans, guys on the other side hold it. Of what does not pull nothing counted, though: masts
with guys of the length `as_routed` were "UNSTABLE: one motion leads away", exit code 1, with an e-fold in
0.9 s, and "the stable equilibrium there" was the same one.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import pytest

from gantline.scenario import parse_scenario
from gantline.statics import Statics
from mechanics import G

MASS, HIGH, FOOT, EA = 4000.0, 12.0, 5.0, 20e6
INERTIA = 48e3 + MASS * (HIGH / 2) ** 2


def mast(joint: str, sides: Sequence[float], kind: str = "guy", length: str = "as_routed") -> Statics:
    """Its foot on a joint, and guys from its top to places around it at these angles [deg]."""
    ends = [f"[{FOOT * math.cos(turn)!r} m, {FOOT * math.sin(turn)!r} m, 0 m]" for turn in np.radians(sides)]
    guys = "\n".join(
        f"    g{i}: {{rope: {kind}, length: {length}, route: [{{type: end, body: world, at: {at}}}, "
        f"{{type: end, body: mast, at: [0 m, 0 m, {HIGH} m]}}]}}"
        for i, at in enumerate(ends)
    )
    text = f"""
format: 1
lift: {{title: A mast on guys}}
duration: 5 s
start: rest
ropes:
  guy: {{axial_stiffness: {EA} N, mass: none}}
  rod: {{inextensible: true, mass: none}}
mechanics:
  bodies:
    mast:
      joint: {joint}
      mass: {MASS} kg
      centre_of_gravity: [0 m, 0 m, {HIGH / 2} m]
      inertia: {{xx: 48 t m^2, yy: 48 t m^2, zz: 1 t m^2}}
  ropes:
{guys}
"""
    return Statics(parse_scenario(text))


HINGE, BALL = "{type: hinge, axis: [0, 1, 0]}", "{type: ball}"


@pytest.mark.parametrize(
    ("joint", "sides", "neutral"),
    [(HINGE, [0, 180], 0), (BALL, [0, 90, 180, 270], 1), (BALL, [10, 100, 190, 280], 1)],
    ids=["hinge", "ball", "turned"],
)
def test_guys_hold_it_to_either_side(joint: str, sides: Sequence[float], neutral: int) -> None:
    """(I + m l²) ω² = EA/L (h d/L)² - m g l of one guy at a time, or of one of two pairs each way.

    Guys at right angles hold as one each way; about itself a mast on a ball turns freely.
    """
    statics = mast(joint, sides)
    rest = statics.equilibrium()
    assert (rest.unstable, rest.neutral, rest.is_stable) == (0, neutral, True)
    length = math.hypot(HIGH, FOOT)
    square = (EA / length * (HIGH * FOOT / length) ** 2 - MASS * G * HIGH / 2) / INERTIA
    found = [mode.square for mode in statics.modes(3)]
    assert found[neutral:] == pytest.approx([square] * (len(found) - neutral), rel=1e-9)
    assert [abs(rest.tension(rope)) < 1e-6 for rope in statics.linear_model().ropes] == [True] * len(sides)


@pytest.mark.parametrize("sides", [[0, 120, 240], [20, 140, 260], [0, 72, 144, 216, 288], [0, 100, 200]])
def test_guys_all_around_hold_a_ball(sides: Sequence[float]) -> None:
    """Of three, one alone may hold the mast along itself, and each of the others to one side of that."""
    statics = mast(BALL, sides)
    rest = statics.equilibrium()
    assert (rest.unstable, rest.neutral) == (0, 1)
    assert [mode.square > 0 for mode in statics.modes(3)][1:] == [True, True]


def test_guys_that_do_not_stretch() -> None:
    """Rods that are just long enough leave a hinge no motion at all, and a ball the turn about the mast."""
    for joint, sides, neutral in ((HINGE, [0, 180], 0), (BALL, [0, 90, 180, 270], 1)):
        rest = mast(joint, sides, "rod").equilibrium()
        assert (rest.unstable, rest.neutral) == (0, neutral)


@pytest.mark.parametrize(
    ("joint", "sides", "away"),
    [
        (HINGE, [0], 1),
        (HINGE, [0, 0], 1),
        (BALL, [0, 180], 2),
        (BALL, [0, 90], 2),
        (BALL, [0, 80, 160], 2),
        (BALL, [0, 90, 180], 2),
    ],
)
def test_what_they_do_not_hold_leads_away(joint: str, sides: Sequence[float], away: int) -> None:
    """Guys on one side alone, or two opposite ones of a ball: ω² = -m g l/(I + m l²), as none pulls."""
    statics = mast(joint, sides)
    rest = statics.equilibrium()
    assert rest.unstable == away
    square = -MASS * G * HIGH / 2 / INERTIA
    assert [mode.square for mode in statics.modes(away)] == pytest.approx([square] * away, rel=1e-9)


def test_a_guy_that_holds_by_rounding_holds_one_side_alone() -> None:
    """Let go towards a guy of √(12² + 5²) m = 13 m it comes to rest plumb, and leads away to the other side.

    What the search leaves of a tension of none, 1e-10 N, made the guy count, and the mast stable.
    """
    lean = HINGE.replace("}", ", position: 0.1 deg}")
    for sides, unstable in (([180], 1), ([180, 180], 1), ([0, 180], 0)):
        rest = mast(lean, sides, length="13 m").equilibrium()
        assert rest.recording.column("joint_position", "mast")[-1] == pytest.approx(0.0, abs=1e-9)
        assert rest.unstable == unstable
