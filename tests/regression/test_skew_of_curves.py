"""Four equal slings with a curve had skew load factors of errors of length that they did not have.

What each would bear with perfect lengths came from one stiffness for the whole curve, so that the softer
slings of a load with its centre of gravity aside seemed too long: up to 1.056 with lengths that are
perfect.
"""

from __future__ import annotations

import numpy as np
import pytest

from gantline.results.gear import Rope
from gantline.results.loads.skew import perfect_forces_of, skew_loads
from gantline.scenario import parse_scenario
from gantline.statics import Statics
from on_a_curve import on_a_curve

CURVE = ((0.01, 40e3), (0.02, 150e3), (0.03, 380e3), (0.06, 1400e3))


def hung(length: float) -> dict[str, tuple[float, float]]:
    """Forces as they are and with perfect lengths [N], of a lift with sling A this long [m]."""
    text = on_a_curve(CURVE, mass=60e3, height=4.0, centre=(0.6, 0.3, 1.8), first=length)
    recording = Statics(parse_scenario(text)).equilibrium().recording
    return {one.sling: (one.force, one.perfect or 0.0) for one in skew_loads(recording)}


def test_equal_slings_with_a_curve_have_no_skew() -> None:
    """Perfect lengths: what the slings bear. Lugs go 0.2 m on arcs of 9 m, which leaves little."""
    for force, perfect in hung(9.0).values():
        assert force / perfect == pytest.approx(1.0, abs=2e-3)


def test_a_short_sling_has_the_factor_of_both_equilibria() -> None:
    """20 mm of 9 m: force with the short sling over that with the perfect one, as the core hangs the load.

    The load tilts by 0.2 deg more, which moves directions of slings by 0.3 %.
    """
    perfect, short = hung(9.0), hung(8.98)
    assert short["A"][0] > 1.03 * perfect["A"][0]
    for sling, (force, of) in short.items():
        assert force / of == pytest.approx(force / perfect[sling][0], rel=1e-2)


def test_forces_whose_stretches_fit() -> None:
    """Two stiff diagonals of 10 m over one hook: the strains of either diagonal come to as much."""
    ropes = [Rope("curved", axial_stiffness=1e7, curve=CURVE), Rope("even", axial_stiffness=2e7)] * 2
    gradient = np.array([[0.3, 0.0, -0.3, 0.0], [0.0, 0.3, 0.0, -0.3], [0.95] * 4])
    tension = np.array([500e3, 20e3, 520e3, 60e3])
    found = perfect_forces_of(ropes, np.full(4, 10.0), gradient, tension)
    assert gradient @ found == pytest.approx(gradient @ tension, abs=1e-3)
    strains, forces = (np.array((0.0, *values)) for values in zip(*CURVE, strict=True))
    first, third = (float(np.interp(found[place], forces, strains)) for place in (0, 2))
    assert first + third == pytest.approx((found[1] + found[3]) / 2e7, rel=1e-7)


@pytest.mark.parametrize("tension", [-10e3, 0.0, 20e3, 40e3, 100e3, 1400e3, 2000e3])
def test_strain_under_a_tension(tension: float) -> None:
    """Its inverse by hand: along the first line below it, along the last beyond it."""
    rope = Rope("r", axial_stiffness=1e7, curve=CURVE)
    found = rope.strain(tension)
    assert found is not None
    places = [(0.0, 0.0), *CURVE]
    index = next((k for k in range(1, 4) if tension <= places[k][1]), 4)
    (begin, low), (end, high) = places[index - 1], places[index]
    assert found[0] == pytest.approx(begin + (tension - low) * (end - begin) / (high - low), abs=1e-12)
    assert found[1] == pytest.approx((end - begin) / (high - low), rel=1e-12)
