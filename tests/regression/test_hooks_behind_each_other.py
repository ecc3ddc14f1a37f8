"""Pictures of a lift by two cranes on the same rails showed one hook: the other stood behind it.

The pictures `system` and `stages`, and films, were seen along y whatever the lift was, while the first page
of the report turned its side view so that hooks side by side are seen side by side.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from matplotlib.patches import Polygon

import gantline
from gantline.plot import figures
from gantline.plot.drawing import SIDE, side_of
from gantline.plot.film import Film
from gantline.results import Recording


def lift(first: tuple[float, float], second: tuple[float, float], longer: float = 0.0) -> Recording:
    """20 t that come off the ground in two slings under hooks at (x, y), one longer by so much [m]."""
    lugs = [f"[{x} m, {y} m, 2 m]" for x, y in (first, second)]
    hooks = [f"[{x} m, {y} m, 8 m]" for x, y in (first, second)]
    rise = "hoist: {speed: 6 m/min, acceleration: 0.1 m/s^2}"
    return gantline.simulate(
        gantline.parse_scenario(f"""
format: 1
lift: {{title: Two hooks}}
duration: 8 s
ground: {{friction: 0.5}}
ropes: {{sling: {{axial_stiffness: 100 MN, damping_time: 20 ms}}}}
load:
  name: module
  shape: {{box: [12 m, 12 m, 2 m]}}
  weight: {{calculated: 20 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 1 m]}}
  stands_on: ground
  lugs: {{A: {{at: {lugs[0]}}}, B: {{at: {lugs[1]}}}}}
cranes:
  a: {{type: fixed_hook, at: {hooks[0]}, {rise}}}
  b: {{type: fixed_hook, at: {hooks[1]}, {rise}}}
slings:
  A: {{from: a, to: module.A, length: 6.1 m, rope: sling}}
  B: {{from: b, to: module.B, length: {6.1 + longer} m, rope: sling}}
plan:
  - {{step: up, hoist: [a, b], speed: 6 m/min, by: 0.5 m}}
  - {{step: hang, hold: until_end}}
""")
    )


@pytest.fixture(scope="module")
def behind() -> Recording:
    return lift((0.0, -4.0), (0.0, 4.0))


def test_the_side_view_has_hooks_side_by_side(behind: Recording) -> None:
    """Right and up of a side view are y and z, so that the viewer stands at y × z = x."""
    view = side_of(behind)
    hooks = [view.project(behind.column("body_position", name)[0]) for name in ("a", "b")]
    assert view.axis == 1
    assert np.allclose(np.cross(view.right, view.up), view.toward)
    assert math.dist(*hooks) == pytest.approx(8.0, abs=1e-3)


@pytest.mark.parametrize("place", [(4.0, 0.0), (4.0, 5.0)])
def test_hooks_along_x_or_aslant_are_seen_along_y(place: tuple[float, float]) -> None:
    """As all lifts were: x is to the right, and hooks that are aslant do not hide each other."""
    assert side_of(lift((-place[0], -place[1]), place)) is SIDE


def test_pictures_are_drawn_that_way(behind: Recording) -> None:
    """The system says which axes it shows, and the ground goes from one end of its panel to the other."""
    panel = dict(figures(behind))["system"].axes[0]
    earth = next(np.asarray(one.get_xy()) for one in panel.patches if isinstance(one, Polygon))
    assert panel.get_ylabel() == "side view (y, z)"
    assert (earth[:, 0].min(), earth[:, 0].max()) == pytest.approx(panel.get_xlim())


def test_a_film_is_drawn_that_way(behind: Recording) -> None:
    """The left part of a film shows the same of a square load under hooks along y as under hooks along x."""
    one, other = (Film(run, width=640).picture(0) for run in (behind, lift((-4.0, 0.0), (4.0, 0.0))))
    side = slice(None), slice(0, one.shape[1] // 2)
    assert np.array_equal(one[side], other[side])
    assert not np.array_equal(one, other)


def test_the_name_of_lift_off_stands_above_a_tilt_that_stays() -> None:
    """0.1 m on 8 m are 0.7 deg from lift-off on, which ran through the name: a sixth of the panel is free."""
    panel = dict(figures(lift((-4.0, 0.0), (4.0, 0.0), longer=0.1)))["attitude"].axes[0]
    low, high = panel.get_ylim()
    curves = [np.asarray(line.get_ydata()) for line in panel.lines if np.size(line.get_ydata()) > 2]
    highest = max(float(curve.max()) for curve in curves)
    assert panel.get_ylabel() == "Tilt [deg]"
    assert 0.7 < highest < low + (high - low) / 1.2
