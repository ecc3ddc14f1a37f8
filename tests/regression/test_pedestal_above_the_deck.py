"""Slewing cranes afloat were drawn with a pedestal of three tenths of the height of their heel pins.

That of the monopile's vessel ended 6 m above her deck, in the air. It goes down to the hull below the slewing
axis, by its mesh; what has no hull there keeps the old length, and what is lower than the deck has none.
Posts of A-frames of cranes that do not slew began at the height of the heel pins, a metre or two above it.
"""

from __future__ import annotations

import numpy as np
import pytest

from gantline.assembly import assemble
from gantline.assembly.afloat.hulls import HullMesh, box_mesh
from gantline.scenario import load_scenario, shipped


def test_the_pedestal_stands_on_the_deck() -> None:
    """Hull of 16 m; heel pins at 36 m, 3 m above the top of the pedestal."""
    lift = assemble(load_scenario(shipped()["monopile"]))
    upper = next(body for body in lift.scene["bodies"] if body["name"] == "rc.upper")
    spans = [
        (box["centre"][2] - box["size"][2] / 2, box["centre"][2] + box["size"][2] / 2)
        for box in upper["shape"]["boxes"]
    ]
    assert min(spans) == pytest.approx((16.0, 33.0), abs=1e-12)


def test_the_posts_of_an_a_frame_stand_on_the_deck() -> None:
    """Hull of 7.5 m, heel pins at 9 m: the posts began at the height of the pins."""
    lift = assemble(load_scenario(shipped()["floating_crane"]))
    crane = next(body for body in lift.scene["bodies"] if body["name"] == "fc")
    posts = [box for box in crane["shape"]["boxes"] if box["size"][2] > 10.0]
    assert len(posts) == 2
    for post in posts:
        assert post["centre"][2] - post["size"][2] / 2 == pytest.approx(7.5, abs=1e-12)


@pytest.mark.parametrize(
    ("place", "top"), [((0.0, 0.0), 7.0), ((4.999, -1.999), 7.0), ((5.001, 0.0), None), ((0.0, 2.001), None)]
)
def test_a_box_goes_up_to_its_top(place: tuple[float, float], top: float | None) -> None:
    """A box of 10 m by 4 m by 6 m that begins at 1 m."""
    assert box_mesh((10.0, 4.0, 6.0), (0.0, 0.0, 1.0)).top_at(*place) == (
        None if top is None else pytest.approx(top, abs=1e-12)
    )


def test_a_slope_is_as_high_as_it_is_there() -> None:
    """z = 1 + x/2 + y/4 over the triangle, with another below it."""
    corners = [[0.0, 0.0, 1.0], [4.0, 0.0, 3.0], [0.0, 4.0, 2.0]]
    mesh = HullMesh(
        np.array([*corners, *([x, y, 0.0] for x, y, _ in corners)]), np.array([[0, 1, 2], [3, 5, 4]])
    )
    assert mesh.top_at(1.0, 2.0) == pytest.approx(1.0 + 0.5 + 0.5, abs=1e-12)
    assert mesh.top_at(3.0, 3.0) is None
