"""Sheaves with losses and inertia, drums, brakes: closed forms of docs/concepts/flows.md, by `adaptive`."""

from __future__ import annotations

import math

import numpy as np
import pytest

from lossy_rigs import (
    CAPSTAN,
    DAMPING_TIME,
    LARGE,
    SMALL,
    STIFF,
    WINDLASS,
    Reeving,
    atwood,
    hauled,
    windlass,
)
from mechanics import G, Run, adaptive, body, document, drum, end, flow, rope, slider


def test_atwood_machine_with_a_sheave_of_mass() -> None:
    """a = (m₂ − m₁) g/(m₁ + m₂ + M/2), T₁ = m₁ (g + a), T₂ = m₂ (g − a): 0.8175 m/s², 106.275 and 107.91 N.

    The disc has M = 4 kg, I/r² = M/2. Strains of 1e-7 shift tensions by T ε; ringing is over after 0.5 s.
    """
    run = adaptive(atwood(10.0, 12.0, 2.0), 1.0, tension_tolerance=1e-6)
    speed, late = -run.body("heavy", "body_velocity")[:, 2], 50
    measured = (speed[-1] - speed[late]) / (run.time[-1] - run.time[late])
    assert measured == pytest.approx(2 * G / 24, rel=1e-6)
    assert run.columns["segment_tension"][-1] == pytest.approx([106.275, 107.91], rel=1e-6)
    # The rope that has passed lags behind the way of the weights by their stretch, T ℓ/EA = 0.5 µm.
    assert run.joint("sheave")[-1] == pytest.approx(G / 24, abs=1e-6)


def test_capstan_in_steady_slip() -> None:
    """T₂/T₁ = e^{μπ} = 1.3691 over half a turn with μ = 0.1, weight hauled up and let down steadily."""
    assert pytest.approx(1.3691, abs=5e-5) == CAPSTAN
    for way, expected in ((-1, CAPSTAN), (1, 1 / CAPSTAN)):
        ramp = {"at": 0.0, "duration": 0.3, "velocity": 0.1 * way, "shape": "smooth"}
        run = adaptive(hauled(CAPSTAN, STIFF, DAMPING_TIME, ramp), 2.0)
        weight_side, winch_side = run.columns["segment_tension"][-1]
        assert weight_side == pytest.approx(1000 * G, rel=1e-9)
        assert winch_side / weight_side == pytest.approx(expected, rel=1e-6)


#: I/r² of sheaves [kg]: with inertia, and light.
INERTIAS = pytest.mark.parametrize("inertia", [10.0, 0.0], ids=["inertia", "light"])


@INERTIAS
def test_capstan_slips_between_weights(inertia: float) -> None:
    """T₂ (1 − σ) − T₁ (1 + σ) = (I/r²) a, σ = (ρ − 1)/(ρ + 1): corrected for the inertia of the flow."""
    light, heavy = 10.0, 20.0
    share = (CAPSTAN - 1) / (CAPSTAN + 1)
    pull, hold = heavy * (1 - share), light * (1 + share)
    expected = (pull - hold) / (pull + hold + inertia) * G
    run = adaptive(atwood(light, heavy, inertia, ratio=CAPSTAN), 1.0, tension_tolerance=1e-6)
    tension = run.columns["segment_tension"][-1]
    assert tension == pytest.approx([light * (G + expected), heavy * (G - expected)], rel=1e-6)
    assert run.energy_remainder < 1e-8


@INERTIAS
def test_capstan_sticks_for_an_hour(inertia: float) -> None:
    """13 over 10 kg is less than e^{μπ}: tensions are the weights, and the rope does not creep in 3600 s."""
    run = adaptive(atwood(10.0, 13.0, inertia, ratio=CAPSTAN), 3600.0, sample_interval=10.0)
    low, high = run.columns["segment_tension"][-1]
    # The tolerance of a step is 1 mN of 100 N; an hour of damped ringing leaves far less of it.
    assert high / low == pytest.approx(1.3, rel=1e-8)
    # A regularised law would creep at a share of its slip velocity: 1e-6 m/s makes 3.6 mm.
    assert np.abs(run.joint("sheave")).max() < 1e-9


def test_ratio_in_steady_slip_of_a_stretched_rope() -> None:
    """T₂ (1 + ε₂/2 − σ) = T₁ (1 + ε₁/2 + σ): to first order T₂/T₁ = ρ (1 − ε₁ (ρ + 1)² (ρ − 1)/(4 ρ))."""
    strain, ratio = 8e-4, 1.09
    ramp = {"at": 0.0, "duration": 1.0, "velocity": -0.01, "shape": "smooth"}
    run = adaptive(hauled(ratio, 1000 * G / strain, 0.1, ramp), 20.0, tension_tolerance=1e-4)
    low, high = run.columns["segment_tension"][-1]
    assert low == pytest.approx(1000 * G, rel=1e-6)
    expected = ratio * (1 - strain * (ratio + 1) ** 2 * (ratio - 1) / (4 * ratio))
    assert expected < ratio * (1 - 7e-5)
    # Terms of second order in strain are below 1e-7; 1e-6 is what ringing has left after 20 s.
    assert high / low == pytest.approx(expected, rel=1e-6)


def reeved(reeving: Reeving, speed: float) -> Run:
    """A load hauled in (or paid out) long enough to be in steady motion."""
    bodies, line, drive = reeving.parts(speed)
    return adaptive(
        document(bodies, ropes=[line], drives=[drive]), 2.0, tension_tolerance=1e-3, sample_interval=0.5
    )


def tensions(run: Run, name: str) -> list[float]:
    """Tension of every part of a rope at the end [N], from its dead end."""
    at = [place for place, part in enumerate(run.names["segment"]) if part.startswith(f"{name}/")]
    return [float(force) for force in run.columns["segment_tension"][-1, at]]


@pytest.mark.parametrize("raising", [True, False], ids=["raising", "lowering"])
@pytest.mark.parametrize("factor", [1.09, 1.045, 1.04, 1.02])
@INERTIAS
def test_lead_line_of_tackles(inertia: float, factor: float, raising: bool) -> None:
    """Raising F/W = (K − 1)/(1 − K⁻ᴺ), lowering F/W = (K − 1)/(K (Kᴺ − 1)), for N = 1 to 20 parts.

    N parts carry the load and N sheaves turn the rope; the last one, above, sends the lead line down to the
    drum, so that the lead line itself carries nothing. Part j counted from the lead line has F/Kʲ while
    raising and F Kʲ while lowering, and W is their sum.
    """
    for n in range(1, 21):
        # By itself: side by side, all take the steps that one of them needs as its sheaves begin to turn.
        run = reeved(Reeving("t", n, 1000.0, factor, n % 2 == 0, inertia), 0.1 if raising else -0.1)
        expected = (factor - 1) / (1 - factor**-n if raising else factor * (factor**n - 1))
        assert tensions(run, "t")[-1] / (1000 * G) == pytest.approx(expected, rel=1e-6), n
        assert run.energy_remainder < 1e-8


SPREADS = {
    0.01: [1.0406, 1.0199, 0.9996, 0.9797, 0.9602],
    0.02: [1.0824, 1.0395, 0.9984, 0.9588, 0.9209],
    0.04: [1.1696, 1.0779, 0.9934, 0.9155, 0.8437],
}


@pytest.mark.parametrize("loss", [0.01, 0.02, 0.04])
@INERTIAS
def test_residual_spread_of_an_equalizer(inertia: float, loss: float) -> None:
    """Sling j of five: η^{2j} over its mean, η = 1 − loss, after rope has run one way over nine sheaves.

    A sling carries the two parts of its moving sheave. The load under the five is guided, so that it rises
    alike under all of them; the drum hauls in at one end, and each crossing towards the dead end has
    T_out = η T_in.
    """
    run = reeved(Reeving("e", 9, 30e3, 1 / (1 - loss), True, inertia), 0.1)
    parts = tensions(run, "e")
    assert len(parts) == 10
    slings = np.array([first + second for first, second in zip(parts[::2], parts[1::2], strict=True)])[::-1]
    assert slings.sum() == pytest.approx(30e3 * G, rel=1e-9)
    expected = (1 - loss) ** (2.0 * np.arange(5))
    assert slings / slings.mean() == pytest.approx(expected / expected.mean(), rel=1e-6)
    assert slings / slings.mean() == pytest.approx(SPREADS[loss], abs=5e-5)


def test_equalizer_without_loss() -> None:
    """Sheaves that have inertia and no losses let all slings carry the same once motion is steady."""
    run = reeved(Reeving("e", 9, 30e3, 1.0, first_on_load=True), 0.1)
    assert tensions(run, "e") == pytest.approx([30e3 * G / 10] * 10, rel=1e-9)


def test_chinese_windlass_turned() -> None:
    """F/W = (R − r)/(2 R) at a crank of radius R; the load rises by (1 − r/R)/2 of what the crank goes."""
    assert pytest.approx(0.033333, abs=5e-7) == WINDLASS
    run = adaptive(windlass(drive="crank"), 5.0)
    steady = run.time > 3.0
    way, height = -run.joint("shaft")[steady], run.body("load")[steady, 2]
    work = run.energy("drive_work")[steady]
    weight = 3000.0 * G
    assert (work[-1] - work[0]) / (way[-1] - way[0]) / weight == pytest.approx(WINDLASS, rel=3e-6)
    # What winds up is stretched by ε = W/2EA, what comes off had been wound without stretch and gets longer
    # by it.
    stretched = (LARGE - SMALL * (1 + weight / 2 / STIFF)) / (2 * LARGE)
    assert (height[-1] - height[0]) / (way[-1] - way[0]) == pytest.approx(stretched, rel=1e-8)


@pytest.mark.parametrize(("of_needed", "holds"), [(1 + 1e-5, True), (1 - 1e-5, False)])
def test_chinese_windlass_held_by_a_brake(of_needed: float, holds: bool) -> None:
    """A brake on the shaft holds from W (R − r)/(2 R) on; 1e-5 below that it slips, and the load sinks.

    The rope starts with the stretch of its load. What the brake lacks moves the shaft and W/g (F/W)² with it.
    """
    weight, seconds = 3000.0 * G, 100.0
    system = windlass(brake=of_needed * WINDLASS * weight)
    system["ropes"][0]["length"] = (20 + 0.29 * math.pi) / (1 + weight / 2 / STIFF)
    run = adaptive(system, seconds, sample_interval=1.0)
    moved = run.joint("shaft")[-1]
    if holds:
        assert abs(moved) < 1e-9
    else:
        lacking = 1e-5 * WINDLASS * weight
        moves = 50 + 3000.0 * WINDLASS**2
        assert moved == pytest.approx(lacking / moves * seconds**2 / 2, rel=1e-4)


def test_hoisting_through_100_m_keeps_the_books() -> None:
    """Work of the drum is weight times height, stretch and loss, while the taut rope gets 100 m shorter.

    The rope that winds up takes its strain along; every joule of it is in the balance.
    """
    bodies = [body("load", slider(), 10e3, position=(0, 0, -110)), flow("winch", 500.0, drive="winch")]
    route = [end("load"), drum(None, (0, 0, 0), "winch")]
    ramps = [
        {"at": 0.0, "duration": 5.0, "velocity": -2.0, "shape": "smooth"},
        {"at": 50.0, "duration": 5.0, "velocity": 0.0, "shape": "smooth"},
    ]
    system = document(
        bodies, ropes=[rope("r", 109.9, route, 1e8, 0.01)], drives=[{"name": "winch", "ramps": ramps}]
    )
    run = adaptive(system, 70.0, sample_interval=0.1)
    assert run.joint("winch")[-1] == pytest.approx(-100.0, abs=1e-9)
    work = run.energy("drive_work")[-1]
    assert work > 10e3 * G * 100 * 0.99
    assert run.energy_remainder < 1e-8


def test_tension_of_a_rope_with_losses() -> None:
    """`rope_tension` is the mean over the segments, the peak is over all of them."""
    run = reeved(Reeving("t", 4, 1000.0, 1.09, first_on_load=True), 0.1)
    parts = run.columns["segment_tension"]
    assert run.tension("t") == pytest.approx(parts.mean(axis=1), rel=1e-12)
    assert run.peak("t") >= parts.max() * (1 - 1e-9) > run.tension("t").max()
