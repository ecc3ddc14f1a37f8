"""Four equal slings with a curve had skew load factors of errors of length that they did not have.

What each would bear with perfect lengths came from one stiffness for the whole curve, so that the softer
slings of a load with its centre of gravity aside seemed too long: up to 1.056 with lengths that are
perfect.
"""

from __future__ import annotations

import numpy as np
import pytest

from gantline.results.gear import Rope
from gantline.results.skew import perfect_forces_of, skew_loads
from gantline.scenario import parse_scenario
from gantline.statics import Statics

CURVE = ((0.01, 40e3), (0.02, 150e3), (0.03, 380e3), (0.06, 1400e3))
STRAINS = ", ".join(f"{100 * strain:g} %" for strain, _ in CURVE)
TENSIONS = ", ".join(f"{force / 1e3:g} kN" for _, force in CURVE)
LIFT = """\
format: 1
lift: {{title: Four round slings}}
duration: 1 s
start: rest
ropes:
  sling: {{curve: {{strain: [{strains}], tension: [{tensions}]}}, mass: none, damping_time: 10 ms}}
load:
  name: module
  shape: {{box: [8 m, 6 m, 4 m]}}
  position: [0 m, 0 m, 6 m]
  weight: {{calculated: 60 t}}
  centre_of_gravity: {{at: [0.6 m, 0.3 m, 1.8 m]}}
  lugs:
    A: {{at: [ 3 m,  2 m, 4 m]}}
    B: {{at: [ 3 m, -2 m, 4 m]}}
    C: {{at: [-3 m,  2 m, 4 m]}}
    D: {{at: [-3 m, -2 m, 4 m]}}
cranes:
  crane: {{type: fixed_hook, at: [0 m, 0 m, 18.1 m], hoist: {{speed: 6 m/min, acceleration: 0.05 m/s^2}}}}
sling_defaults: {{rope: sling}}
slings:
  A: {{from: crane, to: module.A, length: {length!r} m}}
  B: {{from: crane, to: module.B, length: 9 m}}
  C: {{from: crane, to: module.C, length: 9 m}}
  D: {{from: crane, to: module.D, length: 9 m}}
plan:
  - {{step: hold, hold: until_end}}
"""


def hung(length: float) -> dict[str, tuple[float, float]]:
    """Forces as they are and with perfect lengths [N], of a lift with sling A this long [m]."""
    text = LIFT.format(strains=STRAINS, tensions=TENSIONS, length=length)
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
