"""Slings that pull across the plates of their lugs.

The capacity of a lug is that in the plane of its main plate. A load of 380 t was upended about its y axis on
lugs whose plates stood along that axis, so that the slings bent them by up to 60 deg: `lug_load_of_capacity`
was `ok`, the angle stood in the table as `not checked`, and nothing else was said.

Nor was it up to 45 deg, once that was told. Pulled a aside with F, at the height h over the foot of a plate
of the breadth b and thickness t, the foot has 6 F h sin(a)/(b t^2): at 44 deg and h = 4 t 17 times the
F/(b t) of its plane.
"""

from __future__ import annotations

import math

import pytest

import gantline
from gantline.checks import Verdict, check_recording
from gantline.scenario import parse_scenario
from plated_lift import plated_lift


@pytest.mark.parametrize(
    ("angle", "plate", "verdict"),
    [(8, "xz", Verdict.NOT_CHECKED), (15, "xz", Verdict.WARNING), (50, "yz", Verdict.NOT_CHECKED)],
)
def test_it_is_told(angle: float, plate: str, verdict: Verdict) -> None:
    """Two slings at the angle from plumb, in the yz plane: so far out of the plane of a plate along x."""
    checks = check_recording(
        gantline.simulate(parse_scenario(plated_lift(math.radians(angle), plate)), duration=1.0)
    )
    (found,) = [one for one in checks if one.name == "lug_out_of_plane_angle"]
    assert found.verdict is verdict
    assert found.value == pytest.approx(math.radians(angle if plate == "xz" else 0.0), abs=math.radians(0.5))
