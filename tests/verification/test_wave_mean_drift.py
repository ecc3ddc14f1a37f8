"""Mean drift forces and wave drift damping: formulas against waves thrown back whole and differences, a barge
that makes slow way in waves and a current against a linear system, and one that lies moored."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from typer.testing import CliRunner

import gantline
import waves
from afloat import DRAFT, KG, LENGTH, MASS
from drifting import HEADING, follows, growing, linear
from gantline.assembly import assemble
from gantline.assembly.afloat.mean_drift import mean_drift as about_the_middle
from gantline.cli.app import app
from gantline.hydro.database import ForcesAround
from gantline.hydro.database.around import cubics_around
from gantline.hydro.mean_drift import Drifting, mean_drift
from gantline.hydro.waves import Components, wave_number
from gantline.scenario import load_scenario
from gantline.statics import Statics
from mechanics import adaptive

#: A wave of 2 m and 8 s.
AMPLITUDE, PERIOD = 1.0, 8.0
OMEGA = 2 * math.pi / PERIOD
#: Every degree.
AROUND = np.arange(360) * math.tau / 360


def all_around(values: Any) -> ForcesAround:
    """Surge, sway and yaw of one wave (360, 3)."""
    return ForcesAround(AROUND, cubics_around(AROUND, values[np.newaxis].astype(complex)))


def wave(drift: Any, frequency: float, towards: float) -> Drifting:
    """A wave by its D over frequency and direction, the derivative over frequency by differences."""
    one = Components(np.array([frequency]), np.array([AMPLITUDE]), np.zeros(1), towards)
    here, after, before = (drift(frequency + step, AROUND) for step in (0.0, 1e-5, -1e-5))
    return Drifting(one, all_around(here), all_around((after - before) / 2e-5))


def at_heading(
    one: Drifting, heading: float, current: tuple[float, float] = (0.0, 0.0), depth: float | None = None
) -> Any:
    """B and C of one wave (3, 4)."""
    headings = np.array([heading])
    return mean_drift([one], headings, length=LENGTH, current=current, gravity=waves.G, depth=depth)[0]


def test_waves_thrown_back_whole_damp_by_their_momentum() -> None:
    """A wall that goes with U along waves of deep water, κ = ω²/G, E = ½ρGa².

    It meets them at ω − κU and throws back as many: what it throws back has ω_r, ω_r + ω_r²U/G = ω − κU, so
    ω_r = ω − 2κU and κ_r = κ(1 − 4ωU/G) to the first order. Waves carry E/ω (G/2ω − U) of action to it, and
    with each E/ω κ of momentum, so

        F = E/ω (G/2ω − U)(κ + κ_r) = E (1 − 4ωU/G),

    of 1 m² of a², E (4ω/G) per speed is lost: to rounding.
    """
    energy = 0.5 * 1025.0 * waves.G

    def drift(_frequency: float, directions: Any) -> Any:
        return energy * np.stack([np.ones_like(directions), 0 * directions, 0 * directions], axis=1)

    found = at_heading(wave(drift, OMEGA, 0.3), 0.3)
    assert found[0, 0] == pytest.approx(energy * 4 * OMEGA / waves.G, rel=1e-12)
    assert found[0, 1] == pytest.approx(0.0, abs=1e-9 * energy)


def made_up(frequency: float, directions: Any) -> Any:
    """D of surge, sway and yaw (n, 3), smooth."""
    cos, sin, size = np.cos(directions), np.sin(directions), 1e4 * (1 + math.sin(3 * frequency))
    return size * np.stack([cos + 0.3 * cos**2, 2 * sin + sin * cos, 20 * sin * cos + 5], axis=1)


@pytest.mark.parametrize("depth", [None, 15.0])
def test_rates_are_those_of_what_waves_carry_along_rays(depth: float | None) -> None:
    """B and C against central differences of

        F(U, V) = a² (ω_e/σ) (c(σ) − w cos χ)/c(ω_e) D(ω_e, χ + ray),  ray = angle of c e − w against e,

    ω_e = ω − κ e·U the frequency of encounter, σ = ω_e + κ e·w that in the water, c = dω/dκ by differences
    too: to 1e-6, which differences leave. A vessel at rest in a current meets ω.
    """
    towards, heading, current = 0.8, 0.35, np.array([0.6, -0.4])
    chi = towards - heading
    along = np.array([math.cos(chi), math.sin(chi)])

    def number(frequency: float) -> float:
        return float(wave_number(np.array([frequency]), waves.G, depth)[0])

    def group(frequency: float) -> float:
        return 2e-5 / (number(frequency + 1e-5) - number(frequency - 1e-5))

    def force(own: Any, stream: Any) -> Any:
        """At way U and stream V, vessel axes."""
        through = own - stream
        met = OMEGA - number(OMEGA) * along @ own
        inside = met + number(met) * along @ through
        carried = met / inside * (group(inside) - along @ through) / group(met)
        ray = group(met) * along - through
        return AMPLITUDE**2 * carried * made_up(met, np.array([math.atan2(ray[1], ray[0])]))[0]

    cos, sin = math.cos(heading), math.sin(heading)
    stream = np.array([cos * current[0] + sin * current[1], cos * current[1] - sin * current[0]])
    found = at_heading(wave(made_up, OMEGA, towards), heading, (current[0], current[1]), depth)
    step, still = 1e-4, np.zeros(2)
    for k in range(2):
        way = step * np.eye(2)[k]
        lost = (force(-way, still) - force(way, still)) / (2 * step)
        assert found[:, k] == pytest.approx(lost, rel=1e-6, abs=1e-6 * np.abs(lost).max())
    pushed = force(still, still) + (force(still, step * stream) - force(still, -step * stream)) / (2 * step)
    assert found[:, 3] == pytest.approx(pushed, rel=1e-6, abs=1e-6 * np.abs(pushed).max())
    assert found[2, 2] == pytest.approx(found[1, 1] * LENGTH**2 / 12)


def coefficient(frequency: float, direction: float) -> Any:
    """Surge, sway and yaw over the amplitude squared: next to nothing at the wave's frequency, and steep."""
    size = 50.0 + 3e6 * (frequency - OMEGA)
    return size * np.array([0.5 * math.cos(direction), math.sin(direction), 2 * math.sin(direction)])


@pytest.mark.parametrize("current", [None, 1.5], ids=["still water", "current"])
def test_a_barge_loses_way_as_waves_take_it(tmp_path: Path, current: float | None) -> None:
    """A free barge, sent off with 0.5 mm/s of surge, 0.3 mm/s of sway and a turn, against a linear system:

        B = a²/G [(ω² ∂D/∂ω + 4ωD) e + 2ω ∂D/∂β t],    F = a² D + a²/G [4ωD e·V + 2ω ∂D/∂β t·V],

    B₆₆ = B₂₂ L²/12, deep water, e along and t across the wave as seen from the barge. Within 120 s it loses
    half of its speed. It turns by 0.03°, and a spline over directions that are 30° apart is off by as little:
    samples agree to 0.05 % of the largest motion.
    """
    sea = {"swell": {"height": f"{2 * AMPLITUDE} m", "period": f"{PERIOD} s", "direction": "70 deg"}}
    given: dict[str, Any] = {}
    if current is not None:
        given["current"] = {"speed": f"{current} m/s", "direction": "100 deg"}
    path = waves.in_waves(tmp_path, sea, {"heading": f"{math.degrees(HEADING)} deg"}, **given)

    def water(frequencies: Any) -> tuple[Any, Any]:
        added, damping = waves.constant(frequencies)
        return added, damping / 100

    waves.database(tmp_path, water, drift=table(coefficient), push=1e-12)
    document: dict[str, Any] = assemble(load_scenario(path)).document
    start = (5e-4, 3e-4, 5e-6)
    cos, sin = math.cos(HEADING), math.sin(HEADING)
    # Of its origin, which is aft.
    sway = start[1] - LENGTH / 2 * start[2]
    level = [cos * start[0] - sin * sway, sin * start[0] + cos * sway, 0.0]
    document["bodies"][0]["joint"] |= {"velocity": level, "angular_velocity": [0.0, 0.0, start[2]]}
    fine = dict(tension_tolerance=0.01, position_tolerance=1e-10, sample_interval=0.5)
    run = adaptive(document, 120.0, **fine)

    chi = math.radians(70.0) - HEADING
    along, across = np.array([math.cos(chi), math.sin(chi)]), np.array([-math.sin(chi), math.cos(chi)])
    here, shape = coefficient(OMEGA, chi), coefficient(OMEGA + 1e-3, chi) - coefficient(OMEGA - 1e-3, chi)
    turned = (coefficient(OMEGA, chi + 1e-5) - coefficient(OMEGA, chi - 1e-5)) / 2e-5
    square = AMPLITUDE**2 / waves.G
    of_rays = square * (4 * OMEGA * np.outer(here, along) + 2 * OMEGA * np.outer(turned, across))
    rates = np.zeros((6, 6))
    rates[np.ix_([0, 1, 5], [0, 1])] = of_rays + square * OMEGA**2 * np.outer(shape / 2e-3, along)
    rates[5, 5] = rates[1, 1] * LENGTH**2 / 12
    force = AMPLITUDE**2 * here
    if current is not None:
        way = math.radians(100.0) - HEADING
        force = force + of_rays @ (current * np.array([math.cos(way), math.sin(way)]))
    time = np.arange(0.0, 120.005, 0.01)
    growth = growing(time, [(2 * AMPLITUDE, PERIOD, 70.0)])[:, np.newaxis] ** 2
    damping = waves.DAMPING / 100 + growth[:, :, np.newaxis] * rates
    expected = linear(time, growth * force, damping, start)
    follows(run, time, expected, 5e-4)


def moored(folder: Path, drift: Any, **given: Any) -> Path:
    """The barge on a level line over its bow and one over its stern, along x, in waves from astern.

    Per a² they push it by `drift` of surge, sway and yaw, with next to nothing of first order.
    """
    rope = {"mass": "0.001 kg/m", "axial_stiffness": "2 MN", "minimum_breaking_force": "1 MN"}

    def line(fairlead: float, to: float) -> dict[str, Any]:
        ends = {"fairlead": [f"{fairlead} m", "0 m", f"{KG} m"], "to": [f"{to} m", "0 m", f"{KG - DRAFT} m"]}
        return {"vessel": "barge", "rope": "stay", "pretension": "100 kN", **ends}

    sea = {"swell": {"height": f"{2 * AMPLITUDE} m", "period": f"{PERIOD} s", "direction": "0 deg"}}
    lines = {"bow": line(LENGTH, LENGTH + 200.0), "stern": line(0.0, -200.0)}
    start = {"start": "rest", "duration": "120 s", **given}
    path = waves.in_waves(folder, sea, ropes={"stay": rope}, mooring_lines=lines, **start)

    def water(frequencies: Any) -> tuple[Any, Any]:
        added, damping = waves.constant(frequencies)
        return added, 0 * damping

    waves.database(folder, water, drift=drift, push=1e-12)
    return path


def table(shape: Any) -> Any:
    """Drift forces of all frequencies and directions of the file (n, k, 3)."""
    return np.array([[shape(w, b) for b in waves.DIRECTIONS] for w in waves.FREQUENCIES])


def ahead(frequency: float, _direction: float) -> list[float]:
    """A surge of 20 kN/m² at the wave's frequency, growing fast with it."""
    return [2e4 + 3e6 * (frequency - OMEGA), 0.0, 0.0]


def test_a_file_about_a_point_to_port_pushes_as_one_about_the_middle(tmp_path: Path) -> None:
    """F at P is F at M with the moment r × F, r = (l, b) from M to P: N_M = N_P + l F_y − b F_x.

    Drift forces whose yaw is less by that, in a file for a point 12 m astern and 3 m to port of the middle,
    are those of the file about the middle, to the rounding of differences over 2e-5 rad/s.
    """
    scenario = load_scenario(moored(tmp_path, table(ahead)))
    vessel = (scenario.vessels or {})["barge"]
    box = np.array([[0.0, -10.0], [LENGTH, 10.0]])
    along, aside = -12.0, 3.0

    def astern(frequency: float, directions: Any) -> Any:
        surge, sway, yaw = made_up(frequency, directions).T
        return np.stack([surge, sway, yaw - along * sway + aside * surge], axis=1)

    def around(drift: Any, at: tuple[float, float, float]) -> Any:
        assert vessel.wave_forces is not None
        given = vessel.wave_forces.model_copy(update={"at": at})
        force = about_the_middle(scenario, "barge", given, [wave(drift, OMEGA, 0.8)], box)
        return np.array(force["around"])

    middle = around(made_up, (LENGTH / 2, 0.0, DRAFT))
    beside = around(astern, (LENGTH / 2 + along, aside, DRAFT))
    assert np.abs(beside - middle).max() < 1e-9 * np.abs(middle).max()


def test_a_moored_barge_lies_where_its_lines_hold_what_waves_push(tmp_path: Path) -> None:
    """At rest lines pull by a² D = 20 kN more ahead than astern; a run from there stays there.

    Taut lines of 200 m with EA = 2 MN: the barge goes to leeward by a² D/(2 EA/L), L what they have loose,
    200 m/(1 + 100 kN/EA), to 1e-4, by the sag of a rope of 1 g/m less than that.
    """
    path = moored(tmp_path, table(ahead))
    found = Statics(path).equilibrium().recording
    pull = [found.column("rope_tension", f"mooring.{end}")[-1] for end in ("stern", "bow")]
    assert pull[0] - pull[1] == pytest.approx(2e4, rel=1e-5)
    loose = 200.0 / (1 + 1e5 / 2e6)
    away = found.column("body_position", "barge")[-1][0] - LENGTH / 2
    assert away == pytest.approx(2e4 / (2 * 2e6 / loose), rel=1e-3)
    said = CliRunner().invoke(app, ["statics", str(path)]).output
    assert "barge lies 0.95 m ahead of where the lift file has it\n" in said
    run = gantline.simulate(path)
    place = run.column("body_position", "barge")[:, 0] - LENGTH / 2
    assert place == pytest.approx(away, abs=1e-5)


def test_one_that_starts_as_given_is_pushed_as_waves_grow(tmp_path: Path) -> None:
    """Not in equilibrium and not held: it begins where it is put, and swings about where it would lie."""
    place = gantline.simulate(moored(tmp_path, table(ahead), start="as_given")).column(
        "body_position", "barge"
    )
    lies = 2e4 * 200.0 / 1.05 / 4e6
    way = place[:, 0] - LENGTH / 2
    assert way[0] == 0.0 and way.max() > 1.3 * lies


@pytest.mark.parametrize(("method", "step"), [("adaptive", {}), ("del", {"step": "10 ms"})])
def test_what_waves_take_is_their_work(tmp_path: Path, method: str, step: dict[str, str]) -> None:
    """The water of this barge takes nothing: `drag` is 0, to rounding of what waves put in."""
    path = moored(tmp_path, table(ahead), start="as_given", simulation={"integrator": method, **step})
    run = gantline.simulate(path)
    energies = {kind: run.column("energy", kind) for kind in ("fluid_work", "drag")}
    assert abs(energies["fluid_work"]).max() > 1e4
    assert abs(energies["drag"]).max() < 1e-9 * abs(energies["fluid_work"]).max()


def test_modes_have_what_waves_take(tmp_path: Path) -> None:
    """Surge on the lines: ω² = 2 EA/(L (M + A)), damped by B/(2 ω (M + A)).

    B = a²/G (ω² ∂D/∂ω + 4 ω D) of the wave.
    """
    statics = Statics(moored(tmp_path, table(ahead)))
    statics.equilibrium()
    mass = MASS + waves.ADDED[0, 0]
    square = 2 * 2e6 / (200.0 / 1.05) / mass
    rate = (OMEGA**2 * 3e6 + 4 * OMEGA * 2e4) / waves.G
    surge = min(statics.modes(), key=lambda mode: abs(mode.square - square))
    assert surge.square == pytest.approx(square, rel=1e-3)
    assert surge.damping_ratio == pytest.approx(rate / (2 * math.sqrt(square) * mass), rel=2e-3)
