"""Wave forces of a file whose origin is far from the vessel, as that of one of several bodies is.

Phases count from the file's origin, and between its frequencies and directions forces are linear. 200 m away
a phase turns by a radian from one frequency to the next, and a mean of two numbers that point apart is a
smaller one: a barge of which the file has its origin 200 m astern felt 81 % of its forces in waves of 8.7 s,
between two frequencies of the file, and 59 % of its pitching moment where they run between two of its
directions too; nothing was said. What a file has of one side was mirrored in the plane of its origin, beside
which the vessel may lie. Forces are linear now with phases from the middle of the vessel, wherever the file
counts them from, and mirrored in the vessel's own plane.
"""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import waves
from afloat import DRAFT, LENGTH
from gantline.assembly import assemble
from gantline.hydro import read_database, write_database
from gantline.scenario import load_scenario

#: Between two frequencies of the file, 0.70 and 0.75 rad/s.
OMEGA = 0.725
#: In a direction of the file, and between two of them, on the side that it does not have.
TOWARDS = (150.0, -165.0)
#: Of the middle of the barge's waterline from the origin of the file [m].
AWAY = ((-200.0, 0.0), (60.0, 90.0), (LENGTH / 2, 0.0))


def phased_from(folder: Path, place: tuple[float, float]) -> None:
    """The same file, whose origin is that far from the middle of the barge: a wave that has the phase zero
    there comes by its middle with κ·r, in deep water κ = ω²/g (in the half of the directions it has).
    """
    known = read_database(folder / "barge.nc")
    assert known.excitation is not None
    along = np.cos(known.directions) * place[0] + np.sin(known.directions) * place[1]
    turned = np.exp(1j * np.outer(known.frequencies**2 / waves.G, along))[:, :, np.newaxis]
    at = np.array([*place, 0.0])
    write_database(replace(known, excitation=known.excitation * turned, reference=at), folder / "barge.nc")


def force(path: Path) -> tuple[np.ndarray, np.ndarray]:
    """X of the only wave (directions, 6), and where its phase counts from aboard (x, y)."""
    document = assemble(load_scenario(path)).document
    found = next(one for one in document["forces"] if one["type"] == "wave")
    per_metre = np.array(found["phasors"])[0, :, 0]  # of cubics what they have at the directions themselves
    return per_metre[..., 0] + 1j * per_metre[..., 1], np.array(found["origin"][:2])


@pytest.mark.parametrize("towards", TOWARDS)
@pytest.mark.parametrize("away", AWAY)
def test_the_origin_of_a_file_does_not_matter(
    tmp_path: Path, away: tuple[float, float], towards: float
) -> None:
    """Forces between frequencies, in all directions, are those of the file with its origin amidships, to
    rounding: e^(iκ·r) and back.
    """
    wave = {"height": "2 cm", "period": f"{2 * math.pi / OMEGA!r} s", "direction": f"{towards} deg"}
    path = waves.in_waves(tmp_path, {"swell": wave})
    near, middle = force(path)
    phased_from(tmp_path, away)
    far, place = force(path)
    assert place == pytest.approx([LENGTH / 2, 0.0])
    assert middle == pytest.approx([LENGTH / 2, 0.0])
    assert far == pytest.approx(near, rel=1e-9, abs=1e-9 * float(np.abs(near).max()))


def test_a_file_for_water_of_a_depth(tmp_path: Path) -> None:
    """Its phases turn by the waves of its own depth: of 15 m, κ tanh 15κ = ω²/g."""
    wave = {"height": "2 cm", "period": f"{2 * math.pi / OMEGA!r} s", "direction": "150 deg"}
    path = waves.in_waves(tmp_path, {"swell": wave}, water={"density": "1025 kg/m^3", "depth": "15 m"})
    near, _ = force(path)
    known = read_database(tmp_path / "barge.nc")
    assert known.excitation is not None
    number = known.frequencies**2 / waves.G
    for _ in range(200):  # κ = ω²/(g tanh 15κ), taken half-way: converges to rounding in 100
        number = (number + known.frequencies**2 / waves.G / np.tanh(15.0 * number)) / 2
    turned = np.exp(1j * np.outer(number, 200.0 * np.cos(known.directions)))[:, :, np.newaxis]
    shifted = replace(
        known, excitation=known.excitation * turned, reference=np.array([200.0, 0.0, 0.0]), water_depth=15.0
    )
    write_database(shifted, tmp_path / "barge.nc")
    far, _ = force(path)
    assert far == pytest.approx(near, rel=1e-9, abs=1e-9 * float(np.abs(near).max()))


def test_the_point_of_the_forces_may_be_anywhere(tmp_path: Path) -> None:
    """A file about a point 30 m ahead of the middle, phases from there: those amidships are κ·r earlier."""
    wave = {"height": "2 cm", "period": f"{2 * math.pi / 0.7!r} s", "direction": "150 deg"}
    path = waves.in_waves(tmp_path, {"swell": wave})
    near, _ = force(path)
    text = path.read_text(encoding="utf-8")
    amidships, ahead = (f'"at": ["{x} m", "0 m", "{DRAFT} m"]' for x in (LENGTH / 2, LENGTH / 2 + 30.0))
    path.write_text(text.replace(amidships, ahead), encoding="utf-8")
    there, place = force(path)
    assert place == pytest.approx([LENGTH / 2, 0.0])
    document = assemble(load_scenario(path)).document
    directions = next(one for one in document["forces"] if one["type"] == "wave")["directions"]
    turned = np.exp(-1j * 0.7**2 / waves.G * -30.0 * np.cos(directions))[:, np.newaxis]
    assert there == pytest.approx(near * turned, rel=1e-9, abs=1e-9 * float(np.abs(near).max()))
