"""Gusts: their spectrum, how they travel, what they do to bodies; closed forms and own integrations."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from scipy.integrate import quad, solve_ivp

import gantline
from gantline.assembly import assemble
from gantline.results.afloat.wind import Wind
from gantline.results.rig import Rig
from gantline.scenario import load_scenario
from gantline.statics import Statics
from json_lift import plain_lift

Array = npt.NDArray[np.float64]

G, AIR = 9.81, 1.225
MEAN, LENGTH, TURBULENCE = 12.0, 120.0, 0.2
#: ½ ρ C A of 40 m² with the coefficient 1.2 [N s²/m²].
C = 0.5 * AIR * 1.2 * 40.0
AREA = {"area": "40 m^2", "coefficient": 1.2, "along": "x"}
SPRING = {"upper": "0 m", "stiffness": "3 kN/m", "damping": "20 N s/m"}


def windy(**gusts: Any) -> dict[str, Any]:
    given = gusts or {"turbulence": TURBULENCE}
    return {"speed": f"{MEAN} m/s", "direction": "0 deg", "gusts": {"length": f"{LENGTH} m", **given}}


def wind_of(path: Path) -> Wind:
    wind = Rig.from_json(assemble(load_scenario(path)).rig).wind
    assert wind is not None
    return wind


def sprung(folder: Path, *, stops: dict[str, str] | None = SPRING, **given: Any) -> Path:
    """A body of 2 t on a slider along x, held by a spring if there are stops, whose area is 90 m downwind."""
    joint = {"type": "slider", "axis": [1, 0, 0], **({} if stops is None else {"stops": stops})}
    body = {"joint": joint, "mass": "2000 kg", "wind_areas": {"side": {**AREA, "at": ["90 m", "0 m", "0 m"]}}}
    return plain_lift(folder, {"body": body}, wind=given.pop("wind", windy()), **given)


def spectrum(frequency: float) -> float:
    """S/σ² over n in hertz, as EN 1991-1-4 has it [s]."""
    x: float = frequency * LENGTH / MEAN
    return 6.8 * x / math.pow(1 + 10.2 * x, 5 / 3) / frequency


def gust_of(wind: Wind) -> Callable[[float, float], float]:
    """η(x, t) by the equation of the page, from the amplitudes and phases of the document alone."""
    assert wind.gusts is not None
    parts = [(one["amplitude"], one["frequency"], one["phase"]) for one in wind.gusts.components]
    a, omega, phase = np.array(parts).T
    rise: float = wind.gusts.rise_time

    def gust(x: float, time: float) -> float:
        s = min(time / rise, 1.0)
        growth = s * s * s * (10 - 15 * s + 6 * s * s)
        return growth * float((a * np.cos(omega * (x / MEAN - time) + phase)).sum())

    return gust


def test_energy_lies_where_the_spectrum_has_it(tmp_path: Path) -> None:
    """Of σ² all is there, to rounding, and below each frequency as much as Kaimal's form has between ten
    minutes and two seconds, by numerical integration, to half of one part in a hundred and its rounding.
    """
    wind = wind_of(sprung(tmp_path))
    assert wind.gusts is not None
    amplitudes = np.array([one["amplitude"] for one in wind.gusts.components])
    frequencies = np.array([one["frequency"] for one in wind.gusts.components]) / (2 * math.pi)
    assert (amplitudes**2 / 2).sum() == pytest.approx((TURBULENCE * MEAN) ** 2, rel=1e-12)
    whole = quad(spectrum, 1 / 600, 0.5, epsabs=1e-12, limit=200)[0]
    for index in range(0, len(frequencies), 7):
        below = quad(spectrum, 1 / 600, frequencies[index], epsabs=1e-12, limit=200)[0] / whole
        assert below == pytest.approx((index + 0.5) / len(frequencies), abs=1e-9)


def test_gusts_travel_with_the_mean(tmp_path: Path) -> None:
    """What is here now is U τ downwind after τ, and the same everywhere across the wind (Taylor 1938)."""
    wind = wind_of(sprung(tmp_path))
    times, here = np.linspace(30.0, 90.0, 301), np.zeros((301, 2))
    later = wind.speed_at(times + 5.0, here + np.array([5.0 * MEAN, -40.0]))
    assert wind.speed_at(times, here) == pytest.approx(later, abs=1e-10)
    assert wind.speed_at(np.zeros(1), np.zeros((1, 2))) == pytest.approx(MEAN, abs=1e-12)


@pytest.mark.parametrize("gusts", [{"speed": "17 m/s"}, {"turbulence": TURBULENCE}])
def test_the_speed_of_gusts_is_that_of_ten_minutes(tmp_path: Path, gusts: dict[str, Any]) -> None:
    """Highest means over 3 s of 300 records of ten minutes are on average the speed of gusts, to three
    standard errors of that average, and to 2 % of what is above the mean, as peaks come in clusters, which
    Davenport's formula does not know.
    """
    found, wind = [], None
    for seed in range(300):
        wind = wind_of(sprung(tmp_path, wind=windy(**gusts, seed=seed)))
        assert wind.gusts is not None
        omega = np.array([one["frequency"] for one in wind.gusts.components])
        parts = np.array([[one["amplitude"], one["phase"]] for one in wind.gusts.components])
        times = np.arange(0.0, 600.0, 0.5)
        # Mean of cos over 3 s about each time.
        share = np.sin(1.5 * omega) / (1.5 * omega)
        waves = np.cos(parts[:, 1] - np.outer(times, omega)) @ (parts[:, 0] * share)
        found.append(MEAN + waves.max())
    assert wind is not None and wind.gust_speed is not None
    if "speed" in gusts:
        assert wind.gust_speed == 17.0
    above = wind.gust_speed - MEAN
    assert np.mean(found) - MEAN == pytest.approx(
        above, abs=3 * np.std(found) / math.sqrt(300) + 0.02 * above
    )


def response(path: Path, duration: float, stiffness: float = 3e3, damping: float = 20.0) -> Any:
    """x, v and the work of the wind of that body [m, m/s, J], to 1e-11."""
    gust = gust_of(wind_of(path))

    def rates(time: float, state: Array) -> list[float]:
        x, v, _ = state
        u = MEAN + gust(90.0 + x, time)
        force = C * abs(u - v) * (u - v)
        return [v, (force - stiffness * x - damping * v) / 2e3, force * u]

    return solve_ivp(
        rates, (0.0, duration), [0.0, 0.0, 0.0], method="DOP853", rtol=1e-11, atol=1e-9, dense_output=True
    ).sol


def test_a_body_on_a_spring_in_gusts(tmp_path: Path) -> None:
    """Beside an integration of m ẍ + d ẋ + k x = c |u − ẋ| (u − ẋ), u = U + η(90 m + x, t): motion and work.
    By its estimate a step lets an error of speed of ten position tolerances per second through, 1e-6 of the
    deflection of 1.4 m here, where the spring forgets it within 2m/(d + 2cU) = 5 s.
    """
    path = sprung(tmp_path, duration="60 s", simulation={"position_tolerance": "0.0001 mm"})
    run = gantline.simulate(path)
    wanted = response(path, 60.0)(run.time)
    assert np.abs(run.column("body_position", "body")[:, 0] - wanted[0]).max() < 1e-5
    kinds = list(run.coordinates["energy_kind"])
    energy = {kind: run["energy"].values[:, kinds.index(kind)] for kind in kinds}
    # Between the ends of steps books are linear.
    assert energy["fluid_work"][-1] == pytest.approx(wanted[2, -1], rel=1e-8)
    assert np.abs(energy["remainder"]).max() < 1e-9 * wanted[2, -1]
    assert np.all(np.diff(energy["drag"]) >= 0)
    # The gusts count: in steady wind it would come to rest.
    assert np.ptp(run.column("body_position", "body")[run.time > 40.0, 0]) > 0.1


def test_del_in_gusts_is_of_order_two(tmp_path: Path) -> None:
    """`del` has the wind at the middle of a step, so that half the step is a quarter of the error of the
    velocity of a body that is carried along.
    """
    errors = []
    for step in (0.02, 0.01):
        settings = {"integrator": "del", "step": f"{step} s"}
        path = sprung(tmp_path, stops=None, duration="40 s", simulation=settings)
        run, wanted = gantline.simulate(path), response(path, 40.0, stiffness=0.0, damping=0.0)
        errors.append(np.abs(run.column("body_velocity", "body")[:, 0] - wanted(run.time)[1]).max())
    # Terms of fourth order are (ωh)² of those, 4e-3 and 1e-3 at the shortest gusts, which carry a hundredth.
    assert errors[0] / errors[1] == pytest.approx(4.0, rel=1e-3)


def test_a_pendulum_in_gusts(tmp_path: Path) -> None:
    """A bar whose area turns along with it, and goes with it to another place in the gusts: along the area's
    axis F = −c |w| w_x, w = (Lθ̇ − u cos θ, u sin θ). Within 1e-5 of the swing, as for the body on a spring.
    """
    mass, length, inertia = 500.0, 8.0, 900.0
    bar = {
        "joint": {"type": "hinge", "axis": [0, -1, 0]},
        "mass": f"{mass} kg",
        "centre_of_gravity": ["0 m", "0 m", f"{-length} m"],
        "inertia": {axis: f"{inertia} kg m^2" for axis in ("xx", "yy", "zz")},
        "wind_areas": {"face": {**AREA, "at": ["0 m", "0 m", f"{-length} m"]}},
    }
    path = plain_lift(
        tmp_path, {"bar": bar}, wind=windy(), duration="60 s", simulation={"position_tolerance": "0.0001 mm"}
    )
    gust = gust_of(wind_of(path))

    def rates(time: float, state: Array) -> list[float]:
        angle, rate = state
        sine, cosine = math.sin(angle), math.cos(angle)
        u = MEAN + gust(length * sine, time)
        along, across = length * rate - u * cosine, u * sine
        force = -C * math.hypot(along, across) * along
        return [rate, (force * length - mass * G * length * sine) / (mass * length**2 + inertia)]

    run = gantline.simulate(path)
    wanted = solve_ivp(
        rates, (0.0, 60.0), [0.0, 0.0], method="DOP853", rtol=1e-11, atol=1e-11, t_eval=run.time
    ).y[0]
    place = run.column("body_position", "bar")
    assert np.abs(np.arctan2(place[:, 0], -place[:, 2]) - wanted).max() < 1e-5 * np.ptp(wanted)


def test_at_rest_there_is_the_mean_alone(tmp_path: Path) -> None:
    """Statics have c U² over the stiffness of the spring."""
    rest = Statics(sprung(tmp_path)).equilibrium().recording
    assert rest.column("body_position", "body")[-1, 0] == pytest.approx(C * MEAN**2 / 3e3, rel=1e-9)
