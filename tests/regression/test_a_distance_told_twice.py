"""The first page told the distance of a pair that is too near twice, at the top by how much it is too near.

A watch of 1 m that found 0.908 m stood there as `failed clearance margin, slings - skid: -0.092 m, at least
0.000 m, at 158.7 s`, and further down as `tightest clearance slings - skid 0.908 m, at least 1 m, at
158.7 s`: one finding in two numbers. Now it stands at the top, as the distance.
"""

from __future__ import annotations

import numpy as np
import pytest

from fake_core import SETTINGS
from gantline.report.first_page import FirstPage
from gantline.report.subject import Subject
from gantline.results.recording import Recording
from gantline.results.variable import Variable

DISTANCE = "0.400 m, at least 0.5 m, at 1.0 s"


def page(smallest: float, margin: float) -> tuple[list[dict[str, str]], list[tuple[str, str]]]:
    """What failed at the top of the first page, and what is said of the attitude."""
    apart = np.array([[0.6], [0.4], [0.7]])
    variables = {
        "time": Variable(("time",), np.arange(3.0), "s", ""),
        "clearance": Variable(("time", "pair"), apart, "m", ""),
    }
    watch = {"name": "hull - wall", "between": ["hull", "wall"], "smallest": smallest}
    given = {"rig": {"watches": [watch], "limits": {"clearance_margin": margin}}, "settings": SETTINGS}
    content = FirstPage().content(Subject(Recording(variables, {"pair": ["hull - wall"]}, given)))
    return content["verdict"]["failed"], content["attitude"]


def test_a_pair_that_is_too_near_is_told_once_by_its_distance() -> None:
    failed, attitude = page(0.5, 0.0)
    assert failed == [{"about": "clearance margin, hull - wall", "text": DISTANCE}]
    assert "tightest clearance" not in dict(attitude)


@pytest.mark.parametrize(
    ("smallest", "margin", "failed"),
    [
        (0.3, 0.0, []),  # it keeps its distance
        # A margin beyond it is another thing than the distance: 0.4 m - 0.3 m for 0.2 m.
        (0.3, 0.2, ["0.100 m, at least 0.200 m, at 1.0 s"]),
    ],
)
def test_what_is_not_the_same_stands_in_both_places(
    smallest: float, margin: float, failed: list[str]
) -> None:
    found, attitude = page(smallest, margin)
    assert [one["text"] for one in found] == failed
    assert dict(attitude)["tightest clearance"] == "hull - wall 0.400 m, at least 0.3 m, at 1.0 s"
