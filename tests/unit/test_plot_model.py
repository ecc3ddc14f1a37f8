"""Pictures of CAD models: what is in front, what shines through, where things are."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt
import pytest
from matplotlib.text import Text

from gantline.plot.model import Piece, model_figure
from gantline.plot.raster import View, rendered

Array = npt.NDArray[np.float64]

TOP = View.along(np.array([0.0, 0.0, 1.0]))
RED, GREEN = np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0])


def sheet(z: float, size: float = 1.0) -> Array:
    """A square about the z axis, two triangles (2, 3, 3)."""
    corners = size * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]], dtype=float)
    square = np.concatenate([corners, np.full((4, 1), z)], axis=1)
    return np.stack([square[[0, 1, 2]], square[[0, 2, 3]]])


def image(*sheets: tuple[Array, bool]) -> Array:
    drawn, _ = rendered(
        [each for each, _ in sheets],
        [np.full(len(each), number, dtype=float) for number, (each, _) in enumerate(sheets)],
        np.stack([RED, GREEN])[: len(sheets)],
        [is_skin for _, is_skin in sheets],
        TOP,
        (60, 60),
    )
    return drawn


def test_what_is_above_hides_what_is_below() -> None:
    middle = image((sheet(0.0), False), (sheet(1.0, 0.5), False))[30, 30]
    assert middle[1] > 0.5 and middle[0] == 0.0
    middle = image((sheet(1.0), False), (sheet(0.0, 0.5), False))[30, 30]
    assert middle[0] > 0.5 and middle[1] == 0.0


def test_a_skin_lets_through_what_is_below() -> None:
    middle = image((sheet(1.0), True), (sheet(0.0, 0.5), False))[30, 30]
    assert middle[0] > 0.2 and middle[1] > 0.2 and middle[3] == 1.0
    hidden = image((sheet(0.0), True), (sheet(1.0, 0.5), False))[30, 30]
    assert hidden[0] == 0.0, "a skin below does not show"


def test_two_sheets_through_one_another_meet_in_the_middle() -> None:
    tilted = sheet(0.0)
    tilted[..., 2] = 0.5 * tilted[..., 0]
    row = image((sheet(0.0), False), (tilted, False))[30]
    assert row[10, 0] > 0.5 > row[10, 1] and row[50, 1] > 0.5 > row[50, 0]


def test_the_image_stands_where_the_model_is() -> None:
    drawn, (left, right, bottom, top) = rendered(
        [sheet(0.0) + np.array([10.0, 5.0, 0.0])], [np.zeros(2)], RED[None], [False], TOP, (80, 40)
    )
    assert drawn.shape == (40, 80, 4)
    assert (left + right) / 2 == pytest.approx(10.0) and (bottom + top) / 2 == pytest.approx(5.0)
    across = np.flatnonzero(drawn[20, :, 3] > 0.5)
    metres = left + (across[[0, -1]] + [0, 1]) * (right - left) / 80
    assert metres == pytest.approx([9.0, 11.0], abs=2 * (right - left) / 80)


def test_a_sheet_seen_edge_on_is_a_line() -> None:
    side = View.along(np.array([0.0, -1.0, 0.0]))
    wall = np.array([[[-1.0, 0, -1], [1, 0, -1], [1, 0, 1]]])
    drawn, _ = rendered(
        [sheet(0.0), wall], [np.zeros(2), np.ones(1)], np.stack([RED, GREEN]), [False, False], side, (60, 60)
    )
    assert (drawn[..., 0] > drawn[..., 1]).any(axis=0).sum() > 20


def test_views_are_right_handed() -> None:
    for toward in ((0.0, 0.0, 1.0), (0.0, -1.0, 0.0), (-0.6, -0.6, 0.5)):
        view = View.along(np.array(toward))
        assert np.cross(view.right, view.up) == pytest.approx(view.toward)
    assert TOP.right == pytest.approx([1.0, 0.0, 0.0]) and TOP.up == pytest.approx([0.0, 1.0, 0.0])


def test_a_figure_says_what_it_shows() -> None:
    figure = model_figure(
        "Deck", "12 t", [Piece("4 plates", sheet(0.0, 3.0), np.zeros(2), is_skin=True)], np.zeros(3)
    )
    texts = {text.get_text() for text in figure.findobj(Text)}
    assert {"Deck", "12 t", "4 plates", "side view", "x 6.00 m", "y 6.00 m"} <= texts
