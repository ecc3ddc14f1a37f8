"""Wave forces of another program against what they have to be in long waves."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from gantline.hydro import read_database
from gantline.results.variable import FloatArray

DATA = Path(__file__).resolve().parents[2].parent / "shared" / "data" / "hydrodynamics"
LENGTH, BREADTH, DRAFT, RHO, G = 100.0, 30.0, 4.0, 1000.0, 9.81


def along(count: int, size: float, first: float) -> FloatArray:
    """Middles of as many parts of a length."""
    return first + (np.arange(count) + 0.5) / count * size


@pytest.mark.parametrize("direction", [0.0, 45.0, 90.0, 135.0])
@pytest.mark.parametrize(("period", "within"), [(20.0, 0.01), (15.0, 0.03)])
def test_long_waves_on_a_barge(period: float, within: float, direction: float) -> None:
    """A body that is short beside the waves is pushed by the pressure of the undisturbed wave and by the
    water that it would move along: X = F_FK + A u̇ + B u (Newman 1977, chapter 6, relative motion), u the
    rigid motion that has the momenta of the displaced water. Waves are 6.2 and 3.5 times as long as the
    barge; amounts, phases, signs and axes of the file's wave forces, from its own A and B, to 1 and 3 % of
    the largest force and moment.
    """
    path = DATA / "barge_100x30x4.dhyd"
    if not path.exists():
        pytest.skip("../shared/data/hydrodynamics is not beside this checkout")
    database = read_database(path)
    omega = 2 * np.pi / period
    k, towards = omega**2 / G, np.radians(direction)
    x, y, z = np.meshgrid(
        along(100, LENGTH, -LENGTH / 2),
        along(30, BREADTH, -BREADTH / 2),
        along(6, DRAFT, -DRAFT),
        indexing="ij",
    )
    wave = np.exp(k * z + 1j * k * (x * np.cos(towards) + y * np.sin(towards)))
    rate = -G * k * np.stack([1j * np.cos(towards) * wave, 1j * np.sin(towards) * wave, wave], axis=-1)
    place = np.stack([x, y, z], axis=-1)
    part = RHO * LENGTH * BREADTH * DRAFT / x.size
    momenta = part * np.concatenate(
        [rate.reshape(-1, 3).sum(axis=0), np.cross(place, rate).reshape(-1, 3).sum(axis=0)]
    )
    at_surface = wave[:, :, -1] / np.exp(k * z[:, :, -1]) * RHO * G * LENGTH * BREADTH / x[:, :, 0].size
    lifted = at_surface.sum(), (y[:, :, 0] * at_surface).sum(), -(x[:, :, 0] * at_surface).sum()
    froude_krylov = momenta + np.array([0, 0, *lifted, 0])
    moving = np.linalg.solve(_rigid(place.reshape(-1, 3), part), momenta)
    added, _ = database.added_mass_at(period, RHO)
    damping, _ = database.damping_at(period, RHO)
    expected = froude_krylov + added @ moving + damping @ moving / (-1j * omega)
    found = database.excitation_at(np.array([omega]), towards, RHO)[0][0]
    for half in (slice(0, 3), slice(3, 6)):
        scale = np.abs(found[half]).max()
        assert np.abs(found[half] - expected[half]).max() < within * scale


def _rigid(places: FloatArray, part: float) -> FloatArray:
    """Mass matrix (6, 6) about the origin of equal parts at places (n, 3)."""
    total = np.zeros((6, 6))
    x, y, z = places.sum(axis=0) * part
    lever = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    total[:3, :3] = part * len(places) * np.eye(3)
    total[:3, 3:], total[3:, :3] = -lever, lever
    squares = np.einsum("ni,nj->ij", places, places) * part
    total[3:, 3:] = np.trace(squares) * np.eye(3) - squares
    return total
