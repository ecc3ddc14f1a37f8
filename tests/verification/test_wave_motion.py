"""Vessels that move by their RAOs of displacement, docs/concepts/wave_motion.md."""

from __future__ import annotations

import math
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import waves
from afloat import DRAFT, LENGTH
from carried_barge import AT, HUNG, PORT, carried, free_barge, table
from gantline.hydro.raos import DisplacementRaos, write_raos
from gantline.hydro.waves import sea
from gantline.results.recording import Recording
from gantline.results.rotation import axes
from gantline.results.stability import stability_of
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from table_of_raos import goes_with_the_water

OMEGA = 0.7
PERIOD = 2 * math.pi / OMEGA


def way_of_point(run: Recording, heading: float) -> tuple[Any, Any]:
    """Way of the point along the axes of the heading (n, 3) [m], and small turns about these (n, 3) [rad]."""
    body = run.coordinates["body"].index("barge")
    turn = axes(run.variables["body_orientation"].values[:, body])
    centre = run.variables["body_position"].values[:, body]
    place = centre + turn @ (AT - np.array([LENGTH / 2, 0.0, 5.0]))
    level = np.array(
        [
            [math.cos(heading), math.sin(heading), 0.0],
            [-math.sin(heading), math.cos(heading), 0.0],
            [0.0, 0.0, 1.0],
        ]
    )
    by = level @ turn @ level.T @ np.linalg.inv(level @ turn[0] @ level.T)
    turns = 0.5 * np.stack(
        [by[:, 2, 1] - by[:, 1, 2], by[:, 0, 2] - by[:, 2, 0], by[:, 1, 0] - by[:, 0, 1]], axis=1
    )
    return (place - place[0]) @ level.T, turns


@pytest.mark.parametrize(
    ("direction", "heading"), [(30.0, 0.0), (-60.0, 0.0), (180.0, 0.0), (75.0, 45.0), (250.0, 100.0)]
)
@pytest.mark.parametrize(("method", "step"), [("adaptive", {}), ("del", {"step": "10 ms"})])
def test_it_moves_as_its_table_has_it(
    tmp_path: Path, direction: float, heading: float, method: str, step: dict[str, str]
) -> None:
    """X a e^{i(k·s − ωt)} of the point at s, X of a row of the table: what a wave of 2 mm leaves of second
    order in turns is 1e-8 of a radian. Both methods have what is driven to rounding at ends of steps, between
    which samples lie by the course of a step, to the tolerance of positions here.
    """
    by = math.radians(heading)
    stern = np.array([20.0, 10.0])
    name = table(tmp_path, np.array([0.4, 0.55, OMEGA, 0.9]), PORT)
    assert name == "barge.csv"
    path = carried(
        tmp_path,
        {"swell": {"height": "2 mm", "period": f"{PERIOD!r} s", "direction": f"{direction} deg"}},
        vessel={"position": [f"{part} m" for part in stern], "heading": f"{heading} deg"},
        duration=f"{20 * PERIOD!r} s",
        simulation={"sample_interval": f"{PERIOD / 16!r} s", "integrator": method, **step},
    )
    run = simulate(path, position_tolerance=1e-8 if method == "adaptive" else None)
    late = run.time >= 10 * PERIOD - 1e-9
    ways, turns = way_of_point(run, by)
    towards = math.radians(direction)
    cos, sin = math.cos(by), math.sin(by)
    place = stern + np.array([[cos, -sin], [sin, cos]]) @ AT[:2]
    phase = OMEGA**2 / waves.G * (place @ [math.cos(towards), math.sin(towards)])
    expected = free_barge_at(towards - by) * 1e-3 * np.exp(1j * phase)
    found = np.concatenate([ways, turns], axis=1)[late]
    wanted = (np.exp(-1j * OMEGA * run.time[late])[:, np.newaxis] * expected).real
    scale = np.repeat([np.abs(expected[:3]).max(), np.abs(expected[3:]).max()], 3)
    assert np.abs((found - wanted) / scale).max() < 1e-4


def free_barge_at(direction: float) -> Any:
    """X between the rows of the table by the splines that read it."""
    directions = PORT
    known = np.array([0.4, 0.55, OMEGA, 0.9])
    motion = np.array([[free_barge(w, b) for b in directions] for w in known])
    return DisplacementRaos("barge", known, directions, motion).at(np.array([OMEGA]), direction)[0]


def test_leads_are_lags_the_other_way(tmp_path: Path) -> None:
    """The same numbers told as leads: X becomes its conjugate."""
    from gantline.hydro.raos import read_raos

    table(tmp_path)
    lags, leads = (read_raos(tmp_path / "barge.csv", one) for one in ("lag", "lead"))
    assert leads.motion == pytest.approx(lags.motion.conj(), abs=1e-15)


def test_a_sea_is_the_sum_of_its_waves(tmp_path: Path) -> None:
    """Heave of the point in a sea of 12 waves is the sum of twelve, also while waves grow as g of (WV1)."""
    table(tmp_path)
    train = {"significant_height": "0.5 m", "peak_period": "8 s", "direction": "20 deg", "components": "12"}
    path = carried(tmp_path, {"sea": train}, duration="60 s", simulation={"sample_interval": "0.5 s"})
    run = simulate(path)
    towards = math.radians(20.0)
    parts = sea(0.5, 8.0, towards, enhancement=3.3, count=12, seed="1/sea")
    motion = np.array([[free_barge(w, b) for b in PORT] for w in waves.FREQUENCIES])
    answers = DisplacementRaos("barge", waves.FREQUENCIES, PORT, motion).at(parts.frequency, towards)[:, 2]
    way = AT[:2] @ [math.cos(towards), math.sin(towards)]
    share = np.clip(run.time / 24.0, 0.0, 1.0)
    growth = share**3 * (10.0 - 15.0 * share + 6.0 * share**2)
    expected = np.zeros(len(run.time))
    given = zip(parts.frequency, answers, parts.amplitude, parts.phase, strict=True)
    for omega, answer, size, phase in given:
        turning = answer * size * np.exp(1j * (phase + omega**2 / waves.G * way - omega * run.time))
        expected += growth * turning.real
    heave = way_of_point(run, 0.0)[0][:, 2]
    # The tolerance of positions of a step, 0.1 mm.
    assert np.abs(heave - expected).max() < 1e-4
    assert np.ptp(expected) > 0.15


def test_forces_that_made_the_table_move_it_alike(tmp_path: Path) -> None:
    """The free barge by its wave forces, and carried by the table of its answers: the way of a post aboard,
    and the tension of a rope from which a load swings there, 1 t beside 12 300 t. Harmonics agree to 1e-3:
    the free barge, which nothing holds, is centimetres from its place of the start, where the table has it.
    """
    swell = {"height": "0.5 m", "period": f"{PERIOD!r} s", "direction": "30 deg"}
    hung = {
        **HUNG,
        "duration": f"{40 * PERIOD!r} s",
        "simulation": {"sample_interval": f"{PERIOD / 32!r} s"},
    }
    (tmp_path / "free").mkdir()
    (tmp_path / "carried").mkdir()
    free = simulate(waves.in_waves(tmp_path / "free", {"swell": swell}, **hung))
    table(tmp_path / "carried")
    moved = simulate(carried(tmp_path / "carried", {"swell": swell}, start="as_given", **hung))
    late = free.time > 20 * PERIOD + 1e-9

    def amplitudes(run: Recording) -> Any:
        values = [run.column("rope_tension", "fall"), *run.column("body_position", "post").T]
        return np.array([waves.harmonic(run.time[late], value[late], OMEGA) for value in values])

    by_forces, by_table = amplitudes(free), amplitudes(moved)
    assert np.abs(by_forces[0]) > 100.0
    assert by_table == pytest.approx(by_forces, rel=1e-3)


def test_a_run_taken_up_again_has_the_same_bytes(tmp_path: Path) -> None:
    """What waves do to a drive is the lift's, and no part of a saved state."""
    from gantline.simulation import Simulation

    table(tmp_path)
    swell = {"height": "0.5 m", "period": "8 s", "direction": "30 deg"}
    path = carried(tmp_path, {"swell": swell}, duration="20 s", simulation={"sample_interval": "0.5 s"})
    whole = Simulation(path)
    whole.run()
    first = Simulation(path)
    first.advance_to(7.3)
    second = Simulation(path)
    second.restore(first.save())
    second.run()
    for name in ("body_position", "body_orientation"):
        one, other = (run.recording().variables[name].values for run in (whole, second))
        # Ends of steps are exact whatever their lengths, and samples lie within the tolerance.
        assert np.abs(one - other).max() < 1e-4
    third = Simulation(path)
    third.advance_to(7.3)
    third.run()
    assert second.save() == third.save()


@pytest.mark.parametrize("method", ["adaptive", "del"])
def test_what_waves_put_in_is_their_work(tmp_path: Path, method: str) -> None:
    """Drives of the plan do nothing, so that loads hang still; the books close within the audit's bounds."""
    table(tmp_path)
    swell = {"height": "1 m", "period": "8 s", "direction": "30 deg"}
    settings = {"sample_interval": "0.5 s", "integrator": method}
    path = carried(tmp_path, {"swell": swell}, duration="60 s", simulation=settings, **HUNG)
    run = simulate(path)
    assert np.abs(run.column("energy", "drive_work")).max() == 0.0
    # 1 t goes up and down with the post by 2 m: 20 kJ, and some more as it swings.
    assert np.ptp(run.column("energy", "fluid_work")) > 2e4
    assert stability_of(run).is_sound


def test_tensions_keep_their_tolerance(tmp_path: Path) -> None:
    """20 t on a rope of 10 MN/m, which a tenth of a millimetre loads by 1 kN: samples differ by no more than
    twice the tolerance of 10 N from those at a thousandth of it; where only positions counted, by 31 N.
    """
    table(tmp_path)
    bodies = HUNG["mechanics"]["bodies"]
    held = {**bodies["held"], "at": ["90 m", "5 m", f"{28 - DRAFT} m"], "mass": "20 t"}
    rope = {**HUNG["mechanics"]["ropes"]["fall"], "length": "2 m"}
    hung = {**HUNG, "mechanics": {"bodies": {**bodies, "held": held}, "ropes": {"fall": rope}}}
    swell = {"height": "0.5 m", "period": "8 s", "direction": "30 deg"}
    settings = {"sample_interval": "0.05 s"}
    path = carried(tmp_path, {"swell": swell}, duration="60 s", start="as_given", simulation=settings, **hung)
    fine, coarse = (
        simulate(path, tension_tolerance=tension, position_tolerance=position).column("rope_tension", "fall")
        for tension, position in ((0.01, 1e-9), (10.0, 1e-4))
    )
    assert np.abs(coarse - fine).max() < 20.0


def test_a_crane_slews_aboard(tmp_path: Path) -> None:
    """Machinery, A-frame and counterweight of `revolving_crane` on a vessel that a table carries: their
    centre of gravity goes round the slewing axis by the slew angle, and along with her by (WM1), roll, pitch,
    yaw. To the tolerance of positions, 0.1 mm.
    """
    raos = goes_with_the_water(heave=0.9, pitch=0.8)
    write_raos(raos, tmp_path / "own.csv")
    text = (files("gantline.scenarios") / "revolving_crane.yaml").read_text(encoding="utf-8")
    floats = text[text.index("    masses:  ") : text.index("mooring_lines:")]
    text = text.replace(floats, "    wave_motion: {raos: own.csv, phases: lag, at: [45 m, 1 m, 5 m]}\n\n")
    swell = "waves:\n  swell: {significant_height: 0.8 m, peak_period: 8 s, direction: 120 deg}\nground:"
    text = text.replace("ground:", swell, 1).replace("duration: 720 s", "duration: 300 s")
    run = simulate(parse_scenario(text, str(tmp_path / "lift.yaml")))
    towards = math.radians(120.0)
    parts = sea(0.8, 8.0, towards, enhancement=3.3, count=100, seed="1/swell")
    at, axis = np.array([45.0, 1.0, 5.0]), np.array([60.0, 0.0, 0.0])
    way = at[:2] @ [math.cos(towards), math.sin(towards)]
    phases = parts.phase + parts.frequency**2 / waves.G * way - np.outer(run.time, parts.frequency)
    share = np.clip(run.time / 24.0, 0.0, 1.0)[:, np.newaxis]
    growth = share**3 * (10.0 - 15.0 * share + 6.0 * share**2)
    answer = raos.at(parts.frequency, towards) * parts.amplitude[:, np.newaxis]
    motion = growth * (np.exp(1j * phases) @ answer).real
    masses, places = np.array([90.0, 25.0, 130.0]), np.array([[58, 0, 12], [57, 0, 22], [51, 0, 12.5]])
    lever = masses @ places / masses.sum() - axis
    slews = run.column("slew_angle", "rc")
    aboard = axis + Rotation.from_rotvec(np.outer(slews, [0.0, 0.0, 1.0])).apply(lever) - at
    turned = Rotation.from_euler("xyz", motion[:, 3:]).apply(aboard)
    expected = at - [0.0, 0.0, 3.0] + motion[:, :3] + turned  # her keel is 3 m under the water
    assert np.ptp(slews) > math.radians(20.0) and np.ptp(motion[:, 2]) > 0.3
    assert np.abs(run.column("body_position", "rc.upper") - expected).max() < 1e-4
