"""Waves and what they do: lengths, spectra, steady motion by complex numbers, energy, water on deck."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import waves
from afloat import DRAFT, LENGTH, barge, lift_of, written
from floating import SEA
from gantline.hydro.database import read_database
from gantline.hydro.waves import jonswap, sea, wave_number
from gantline.results.recording import Recording
from gantline.simulation import simulate

OMEGA = 0.7
PERIOD = 2 * math.pi / OMEGA
LOW = {"height": "2 mm", "period": f"{PERIOD!r} s", "direction": "30 deg"}


def of_sixty_periods(folder: Path, wave: dict[str, str], vessel: dict[str, Any]) -> Recording:
    """The barge in a regular wave of `PERIOD`, by tight tolerances."""
    times = {"duration": f"{60 * PERIOD!r} s", "simulation": {"sample_interval": f"{PERIOD / 16!r} s"}}
    path = waves.in_waves(folder, {"swell": wave}, vessel, **times)
    return simulate(path, tension_tolerance=0.1, position_tolerance=1e-8)


def last_periods(run: Recording, count: int) -> Any:
    return run.time > run.time[-1] - count * PERIOD + 1e-9


@pytest.mark.parametrize("depth", [None, 5.0, 30.0, 1e4])
def test_dispersion(depth: float | None) -> None:
    """ω² = g κ tanh κd, to rounding, from swell of 60 s to ripples; deep water is the limit of depth."""
    frequency = 2 * np.pi / np.array([60.0, 20.0, 8.0, 3.0, 1.0])
    number = wave_number(frequency, 9.81, depth)
    share = 1.0 if depth is None else np.tanh(number * depth)
    assert 9.81 * number * share == pytest.approx(frequency**2, rel=1e-13)


def test_moments_of_the_spectrum() -> None:
    """m₀ = H_s²/16, and for γ = 1, S = (5/16) H_s² ω_p⁴ ω⁻⁵ exp(−(5/4)(ω_p/ω)⁴): by trapezoids to 1e-5."""
    peak = 2 * np.pi / 8.0
    omega = peak * np.geomspace(0.2, 40.0, 40_001)
    for enhancement in (1.0, 3.3, 7.0):
        assert np.trapezoid(jonswap(omega, 2.0, 8.0, enhancement), omega) == pytest.approx(0.25, rel=1e-5)
    ratio = omega / peak
    pierson_moskowitz = 5 / 16 * 4.0 / peak * ratio**-5.0 * np.exp(-1.25 * ratio**-4.0)
    # What the grid's end at 40 ω_p leaves out is (1/40)⁴.
    assert jonswap(omega, 2.0, 8.0, 1.0) == pytest.approx(pierson_moskowitz, rel=1e-5)


def test_a_sea_has_the_energy_of_its_spectrum() -> None:
    """Σ a²/2 = m₀ whatever the number of waves; each lies where as much energy is on both sides of it."""
    for count in (10, 100):
        found = sea(2.0, 8.0, 0.3, enhancement=3.3, count=count, seed="1/sea")
        assert (found.amplitude**2 / 2).sum() == pytest.approx(0.25, rel=1e-12)
        omega = 2 * np.pi / 8.0 * np.geomspace(0.2, 40.0, 40_001)
        density = jonswap(omega, 2.0, 8.0, 3.3)
        below = np.array([np.trapezoid(density[omega <= f], omega[omega <= f]) for f in found.frequency])
        # One step of the grid of the test, 0.013 %, at the steepest place.
        assert below / 0.25 == pytest.approx((np.arange(count) + 0.5) / count, abs=1e-3)
    other = sea(2.0, 8.0, 0.3, enhancement=3.3, count=10, seed="2/sea")
    assert not np.allclose(other.phase, sea(2.0, 8.0, 0.3, enhancement=3.3, count=10, seed="1/sea").phase)


@pytest.mark.parametrize(
    ("direction", "heading"), [(30.0, 0.0), (-60.0, 0.0), (180.0, 0.0), (75.0, 45.0), (250.0, 100.0)]
)
def test_steady_motion_in_a_regular_wave(tmp_path: Path, direction: float, heading: float) -> None:
    """Six complex amplitudes against (−ω²(M + A) − iωB + C)⁻¹ F e^{iκ·x}, F of the database's own formula.

    The wave is 2 mm high, so that heading and place, which nothing holds, stay; what they change falls with
    its height, and is 1e-5 of the motion here. The barge lies 20 m ahead and 10 m beside the world's origin,
    where the phase of the wave is zero.
    """
    by = math.radians(heading)
    middle = np.array([20.0, 10.0])
    stern = middle - LENGTH / 2 * np.array([math.cos(by), math.sin(by)])
    given = {"position": [f"{part} m" for part in stern], "heading": f"{heading} deg"}
    wave = {**LOW, "direction": f"{direction} deg"}
    run = of_sixty_periods(tmp_path, wave, given)
    towards = math.radians(direction)
    along = OMEGA**2 / waves.G * (middle @ [math.cos(towards), math.sin(towards)])
    force = waves.force_per_metre(OMEGA, towards - by) * 1e-3 * np.exp(1j * along)
    expected = waves.response(OMEGA, force)
    found = waves.motion(run, OMEGA, by)
    scale = np.repeat([np.abs(expected[:3]).max(), np.abs(expected[3:]).max()], 3)
    assert np.abs(found - expected) / scale == pytest.approx(np.zeros(6), abs=1e-5)


@pytest.mark.parametrize("phase", [0.0, 90.0, 200.0, -45.0])
def test_crests_pass_later_by_the_phase(tmp_path: Path, phase: float) -> None:
    """η = g H/2 cos(k·x - ωt + ε) at the barge, which answers as late: heave and all else is that of ε = 0 by
    e^{iε}, of (WV1). A crest passes the origin of the world ε/ω after the start and every period after that.
    """
    middle = np.array([20.0, 10.0])
    given = {"position": [f"{middle[0] - LENGTH / 2} m", f"{middle[1]} m"]}
    wave = {**LOW, "phase": f"{phase} deg"}
    run = of_sixty_periods(tmp_path, wave, given)
    towards, late = math.radians(30.0), math.radians(phase)
    along = OMEGA**2 / waves.G * (middle @ [math.cos(towards), math.sin(towards)])
    grown = last_periods(run, 40)
    surface = 1e-3 * np.cos(along - OMEGA * run.time + late)
    # Amidships goes to and fro by up to a = 1 mm with the waves: k a² = 5e-8 m.
    assert run.column("vessel_wave_elevation", "barge")[grown] == pytest.approx(surface[grown], abs=5e-8)
    force = waves.force_per_metre(OMEGA, towards) * 1e-3 * np.exp(1j * (along + late))
    expected = waves.response(OMEGA, force)
    found = waves.motion(run, OMEGA, 0.0)
    scale = np.repeat([np.abs(expected[:3]).max(), np.abs(expected[3:]).max()], 3)
    assert np.abs(found - expected) / scale == pytest.approx(np.zeros(6), abs=1e-5)
    assert run.rig.sea is not None
    crest = (late / OMEGA) % PERIOD + 50 * PERIOD  # when one passes the origin
    assert run.rig.sea.at(np.array([crest]), np.zeros((1, 2)))[0] == pytest.approx(1e-3, rel=1e-9)


def test_a_sea_is_the_sum_of_its_waves(tmp_path: Path) -> None:
    """Heave, roll and pitch of the barge in a low sea of 12 waves: the sum of twelve steady motions, forces
    between the frequencies of the file as it reads them. What began with the waves has died down after 400 s,
    roll the slowest, by exp(-0.08 · 400) = 1e-14; elevation amidships is the sum of the waves,
    to 1e-4 of them, as far as the barge moves aside.
    """
    train = {"significant_height": "1 mm", "peak_period": "8 s", "direction": "20 deg", "components": "12"}
    amidships = {"position": [f"{-LENGTH / 2} m", "0 m"]}
    settings = {"sample_interval": "0.5 s"}
    path = waves.in_waves(tmp_path, {"sea": train}, amidships, duration="500 s", simulation=settings)
    run = simulate(path, tension_tolerance=0.1, position_tolerance=1e-8)
    towards = math.radians(20.0)
    parts = sea(1e-3, 8.0, towards, enhancement=3.3, count=12, seed="1/sea")
    forces, _ = read_database(tmp_path / "barge.nc").excitation_at(parts.frequency, towards, SEA)
    given = zip(parts.frequency, forces, parts.amplitude * np.exp(1j * parts.phase), strict=True)
    late = run.time > 400.0
    motions, elevation = np.zeros((6, late.sum())), np.zeros(late.sum())
    for omega, force, wave in given:
        turning = wave * np.exp(-1j * omega * run.time[late])
        motions += np.outer(waves.response(omega, force), turning).real
        elevation += turning.real
    heave = run.variables["body_position"].values[late, 0, 2]
    heel, trim = (run.column(f"vessel_{name}", "barge")[late] for name in ("heel", "trim"))
    for found, expected in zip((heave, heel, -trim), motions[2:5], strict=True):
        assert found - found.mean() == pytest.approx(expected - expected.mean(), abs=1e-4 * np.ptp(expected))
    assert run.column("vessel_wave_elevation", "barge")[late] == pytest.approx(elevation, abs=1e-7)


@pytest.mark.parametrize("integrator", ["adaptive", "del"])
def test_energy_of_waves(tmp_path: Path, integrator: str) -> None:
    """In steady motion waves put in what the water takes: over ten periods `fluid_work` = `drag`; and both
    are the mean power ½ Re(F · conj(−iω ξ)) of the complex amplitudes, times the time. What the waves begin
    with sends the barge slowly on its way: 3 mm/s, and ω is what it meets them with. That is 0.02 %
    more, which is 0.1 % of the power, as roll is near its resonance.
    """
    given: dict[str, Any] = {
        "duration": f"{40 * PERIOD!r} s",
        "simulation": {"sample_interval": f"{PERIOD / 10!r} s"},
    }
    wave = {**LOW, "height": "20 cm"}
    path = waves.in_waves(tmp_path, {"swell": wave}, **given)
    exact = integrator == "adaptive"
    run = simulate(path, integrator=integrator, step=None if exact else PERIOD / 800)
    kinds = dict(zip(run.coordinates["energy_kind"], run.variables["energy"].values.T, strict=True))
    late = [-101, -1]
    put_in, taken = (np.diff(kinds[kind][late])[0] for kind in ("fluid_work", "drag"))
    towards = math.radians(30.0)
    along = OMEGA**2 / waves.G * (LENGTH / 2) * math.cos(towards)
    force = waves.force_per_metre(OMEGA, towards) * 0.1 * np.exp(1j * along)
    place = run.variables["body_position"].values[late, 0, :2]
    drift = np.diff(place, axis=0)[0] / (10 * PERIOD)
    met = OMEGA - OMEGA**2 / waves.G * float(drift @ [math.cos(towards), math.sin(towards)])
    velocity = -1j * met * waves.response(met, force)
    expected = 0.5 * np.real(force @ velocity.conj()) * 10 * PERIOD
    # del is of first order: 4 % with 200 steps to a period, 2 % with 400, 1 % with 800.
    assert put_in == pytest.approx(expected, rel=2e-3 if exact else 2e-2)
    assert taken == pytest.approx(expected, rel=2e-3 if exact else 2e-2)
    # adaptive at its default tolerance; del books buoyancy by trapezoids: 5.6e-6 with 400 steps to a period,
    # 1.4e-6 with 800.
    assert abs(kinds["remainder"]).max() < (1e-7 if exact else 2e-6) * kinds["fluid_work"].max()


def test_water_comes_on_deck_with_a_crest(tmp_path: Path) -> None:
    """A barge that waves pass under without a trace, its deck 0.4 m above still water, in waves of 1 m that
    have grown in 36 s: its edge goes under where the first of its corners does, stays under while the crest
    is along its sides, 0.4 − 0.5 max cos(κx − ωt) over 0 ≤ x ≤ L, and comes out with the last. Between two
    of the 24 points over the length of a wave a crest is lower by up to 0.5 (1 − cos π/24) = 4.3 mm.
    """
    low = barge(hull={"box": [f"{LENGTH} m", "30 m", f"{DRAFT + 0.4} m"]})
    wave = {"height": "1 m", "period": "12 s", "direction": "0 deg"}
    path = written(tmp_path, lift_of(low, waves={"swell": wave}, duration="62 s", start="as_given"))
    run = simulate(path)
    assert any("pass under barge without a trace" in text for text in run.attributes["warnings"])
    omega = 2 * math.pi / 12.0
    kinds = [(time, kind) for time, kind, _ in run.events() if time > 36.0]
    assert len(kinds) >= 4
    for time, kind in kinds:
        before, after = least(omega, np.array([time - 1e-6, time + 1e-6]))
        assert (before > 0.0 > after) if kind == "flooding" else (before < 0.0 < after)
    grown = run.time >= 36.0
    over = run.column("vessel_freeboard", "barge")[grown] - least(omega, run.time[grown])
    assert over.min() > -1e-9
    assert over.max() < 0.5 * (1 - math.cos(math.pi / 24))


def least(omega: float, time: Any) -> Any:
    """Least height of the sides from stern to bow above the waves, 0.4 − 0.5 cos(κx − ωt) [m]."""
    length, phase = omega**2 / 9.81 * LENGTH, omega * time % (2 * math.pi)
    at_ends = np.maximum(np.cos(phase), np.cos(length - phase))
    return 0.4 - 0.5 * np.where(phase <= length, 1.0, at_ends)
