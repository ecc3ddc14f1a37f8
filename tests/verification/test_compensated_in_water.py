"""A load half in water, on a gas spring below a hook that waves move, against equations of its own.

The hook goes by h = H g(t) cos(ωt - ε - φ), as a vessel's RAOs have it. The cylinder m₁, at the height z,
hangs below it on a rope of k = EA/L, and the load m₂ on the gas (PC1), its rod out by x, with a damper c and
seals of the friction R, all plumb:

    m₁ z̈ = T - N - m₁ g     (m₂ + Σ s a) (z̈ - ẍ) = N - m₂ g + F     N = F(x) + c ẋ + R ẋ/√(ẋ² + v₀²)

T = k (e + τ ė) of the rope's stretch e, and F by (LW1) to (LW3) over 32 cells, each at its own place in the
wave, without what Σ s a already has. By v₀ seals creep that hold. scipy's LSODA solves that.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from in_water import RHO, growth, lattice, sea, share, submerged, within
from mechanics import Floats, G, Json, adaptive, body, document, end, rope, slider

OMEGA, WAVE, LATE, RISE = 0.8, 0.9, 0.3, 5.0
KAPPA = OMEGA**2 / G
#: Of the hook, and how much later than the crest it moves [m, rad].
HEAVE, BEHIND = 0.63, 0.5
CYLINDER, LOAD = 5e3, 90e3
EA, FALL, TAU = 120e6, 10.0, 0.01
#: Gas at both ends of its stroke, its exponent, and the column that it stands for.
PULL, STROKE, POWER = (500e3, 900e3), 3.0, 1.2
COLUMN = STROKE / (1 - (PULL[0] / PULL[1]) ** (1 / POWER))
BEARINGS, DAMPER = 6.0, 25e3
#: The load's box, 8 x 5 x 4 m, in layers of four cells; where it hangs along the wave.
LAYER, TALL, ALONG = 0.5, 4.0, 12.0
HALF = (8 / math.sqrt(12), 5 / math.sqrt(12))
VOLUME, ADDED, DRAG = 25.0, (50e3, 60e3, 150e3), (30e3, 40e3, 60e3)
HEIGHTS = np.arange(LAYER / 2, TALL, LAYER) - TALL / 2
PLACES = (ALONG - HALF[0], ALONG + HALF[0])
#: Each stands for the two at ± y.
SHARE = 1 / (HEIGHTS.size * len(PLACES))
#: v₀ [m/s].
CREEP = 1e-5

#: Ways of the rod, and what the gas pulls with there; straight lines between them, as a curve has.
WAYS = np.linspace(-0.05 * STROKE, 1.04 * STROKE, 400)
GAS = PULL[0] * (COLUMN / (COLUMN - WAYS)) ** POWER
OUT = COLUMN * (1 - (PULL[0] / ((LOAD - RHO * VOLUME / 2) * G)) ** (1 / POWER))
REACH = TALL / 2 + BEARINGS


def water(time: float, z: float, v: float) -> tuple[float, float]:
    """F [N], and Σ s a [kg], of the load with its middle at the height z [m] and the speed v [m/s]."""
    g, later = float(growth(time, RISE)), min(1.0, time / RISE)
    dg = 30 * later**2 * (1 - later) ** 2 / RISE
    angles = [KAPPA * place - OMEGA * time + LATE for place in PLACES]
    waves = [(WAVE * math.cos(angle), WAVE * math.sin(angle)) for angle in angles]
    ats = z + HEIGHTS
    depths = g * np.array(waves)[:, :1] - ats
    decays = (OMEGA * np.exp(KAPPA * np.minimum(ats, 0.0))).tolist()
    volume, added, drag = SHARE * VOLUME, SHARE * ADDED[2], SHARE * DRAG[2]
    force = all_wet = 0.0
    # On plain numbers: arrays of so few take longer.
    for (cos, sin), below, shares in zip(waves, depths.tolist(), share(depths, LAYER).tolist(), strict=True):
        pace = dg * cos + g * OMEGA * sin - v
        for decay, depth, wet in zip(decays, below, shares, strict=True):
            if wet == 0.0:
                continue
            slope = max(0.0, 1 - abs(depth) / LAYER) / LAYER
            across, up, rate = g * decay * cos, g * decay * sin, decay * (dg * sin - g * OMEGA * cos)
            w = v - up
            force += wet * (RHO * volume * (G + rate) + added * rate - drag * math.hypot(across, w) * w)
            force -= slope * max(0.0, pace) * added * w
            all_wet += wet
    return force, all_wet * added


def hook(time: Any) -> tuple[Any, Any]:
    """Its height over that at the start [m] and its speed [m/s]."""
    later, angle = within(time / RISE, 0.0, 1.0), OMEGA * time - LATE - BEHIND
    dg = 30 * later**2 * (1 - later) ** 2 / RISE
    g = growth(time, RISE)
    return HEAVE * g * np.cos(angle), HEAVE * (dg * np.cos(angle) - g * OMEGA * np.sin(angle))


def tension(time: Any, z: Any, v: Any) -> Any:
    """Of the rope, z and v being the way and the speed of the cylinder."""
    high, speed = hook(time)
    hangs = (CYLINDER + LOAD - RHO * VOLUME / 2) * G
    return np.maximum(0.0, hangs + EA / FALL * (high - z + TAU * (speed - v)))


def rates(time: float, state: Floats, friction: float) -> list[float]:
    """Of z, x and their speeds."""
    z, x, v, u = state.tolist()
    pull = np.interp(x, WAYS, GAS) + DAMPER * u + friction * u / math.hypot(u, CREEP)
    force, along = water(time, z + OUT - x, v - u)
    rises = float(tension(time, z, v) - pull) / CYLINDER - G
    return [v, u, rises, rises - (pull - LOAD * G + force) / (LOAD + along)]


def lift(friction: float) -> Json:
    """The same as a document of the core."""
    high = REACH + OUT
    hangs = (CYLINDER + LOAD - RHO * VOLUME / 2) * G
    gas_length = (BEARINGS + WAYS[0]) / 1.01
    strains = (BEARINGS + WAYS) / gas_length - 1
    gas = rope("gas", gas_length, [end("cylinder"), end("load", (0, 0, TALL / 2))], None)
    gas["material"] = {"type": "curved", "points": np.stack([strains, GAS], axis=1).tolist()}
    fall = rope("fall", FALL, [end("hook", (ALONG, 0, 0)), end("cylinder")], EA, TAU)
    cells = lattice(
        (0, 0, HEIGHTS[0]),
        half=HALF,
        height=LAYER,
        layers=8,
        volume=VOLUME,
        added=ADDED,
        quadratic=DRAG,
    )
    top = high + FALL * (1 + hangs / EA)
    rod = slider((0, 0, -1), position=OUT, damping=DAMPER, friction=friction)
    bodies = [
        body("hook", slider(drive="waves"), 0.0, position=(0, 0, top)),
        body("cylinder", slider(), CYLINDER, position=(ALONG, 0, high)),
        body("load", rod, LOAD, parent="cylinder", position=(0, 0, -REACH)),
    ]
    hook_waves = sea((OMEGA, HEAVE, 0.0, LATE + BEHIND), rise_time=RISE)
    return document(
        bodies,
        ropes=[fall, {**gas, "is_stretched": True}],
        forces=[submerged("load", cells)],
        sea=sea((OMEGA, WAVE, 0.0, LATE), rise_time=RISE),
        drives=[{"name": "waves", "waves": hook_waves}],
    )


@pytest.mark.parametrize("friction", [0.0, 15e3])
def test_a_load_on_a_compensator_goes_in_and_out(friction: float) -> None:
    """Rod, rope and cylinder over two and a half periods from rest. Both keep to 1e-6 m; seals creep by
    v₀ = 1e-5 m/s for the seconds in which they hold, which is 1e-4 m of the rod. A micrometre of the rope
    is 12 N: 100 N are a thousandth of how its pull swings.
    """
    duration = 20.0
    tolerances = {"tension_tolerance": 1.0, "position_tolerance": 1e-8}
    run = adaptive(lift(friction), duration, sample_interval=0.05, **tolerances)
    own = solve_ivp(
        rates, (0, duration), [0.0, OUT, 0.0, 0.0], "LSODA", run.time, args=(friction,),
        rtol=1e-8, atol=1e-10, max_step=0.02,
    )  # fmt: skip
    assert own.success
    z, x, v, _ = own.y
    crept, pulled = (1e-6, 2.0) if friction == 0.0 else (1e-4, 100.0)
    assert run.joint("load") == pytest.approx(x, abs=crept)
    assert run.joint("cylinder") == pytest.approx(z, abs=crept)
    assert run.tension("fall") == pytest.approx(tension(run.time, z, v), abs=pulled)
    middle = z + OUT - x
    assert middle.min() < -0.8 and middle.max() > 0.8, "it must go in and out by some layers"
    assert run.energy_remainder < 1e-7
