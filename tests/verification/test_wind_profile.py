"""Wind that grows with height, (WC9): what pushes at which height, by hand and beside an own integration."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import gantline
from gantline.assembly import assemble
from gantline.results.rig import Rig
from gantline.scenario import load_scenario, shipped
from gantline.statics import Statics
from json_lift import plain_lift

G, AIR = 9.81, 1.225
#: ½ ρ C A of the area of all bodies here [kg/m].
PUSH = 0.5 * AIR * 1.2 * 40.0


def wind(speed: float, **profile: Any) -> dict[str, Any]:
    return {"speed": f"{speed} m/s", "direction": "0 deg", "profile": profile}


def pendulum(height: float, mass: float = 8000.0) -> dict[str, Any]:
    """A mass [kg] on a bar of 20 m, its middle so high above 0 where it hangs plumb."""
    return {
        "joint": {"type": "hinge", "axis": [0, -1, 0]},
        "at": ["0 m", "0 m", f"{height + 20.0} m"],
        "mass": f"{mass} kg",
        "centre_of_gravity": ["0 m", "0 m", "-20 m"],
        "inertia": {axis: "9000 kg m^2" for axis in ("xx", "yy", "zz")},
        "wind_areas": {
            "face": {
                "area": "40 m^2", "coefficient": 1.2, "along": "x", "at": ["0 m", "0 m", "-20 m"]
            }
        },
    }  # fmt: skip


@pytest.mark.parametrize(
    ("profile", "share"),
    [
        # EN 1991-1-4, table 4.1: 3 mm, and 1 m in a town, where it blows below 10 m as at 10 m.
        ({"terrain": "sea"}, lambda z: math.log(z / 0.003) / math.log(10.0 / 0.003)),
        ({"terrain": "town"}, lambda z: math.log(max(z, 10.0)) / math.log(10.0)),
        ({"roughness": "0.2 m", "height": "40 m"}, lambda z: math.log(z / 0.2) / math.log(200.0)),
        ({"exponent": 0.14, "height": "50 m"}, lambda z: (z / 50.0) ** 0.14),
    ],
)
@pytest.mark.parametrize("height", [6.0, 85.0])
def test_a_pendulum_leans_by_the_wind_at_its_height(
    profile: dict[str, Any], share: Any, height: float, tmp_path: Path
) -> None:
    """tan θ = c (s(z) U)²/mg with z of where it hangs then, the area turning with the bar: by fixed points to
    rounding; the equilibrium to 1e-9.
    """
    found = Statics(plain_lift(tmp_path, {"bar": pendulum(height)}, wind=wind(14.0, **profile))).equilibrium()
    angle = 0.0
    for _ in range(100):
        z = height + 20.0 * (1.0 - math.cos(angle))
        angle = math.atan(PUSH * (14.0 * share(z)) ** 2 / (8000.0 * G))
    x = found.recording.dataset["body_position"].values[-1, 0, 0]
    assert x == pytest.approx(20.0 * math.sin(angle), rel=1e-9)


def test_a_pendulum_that_swings_up_into_stronger_wind(tmp_path: Path) -> None:
    """Let go plumb 4 m above the ground in 25 m/s at 10 m by the power 0.3, it swings to 34 deg and the wind
    grows by a fifth on the way; beside an own integration of (mL² + I) θ̈ = L (c |w| wₓ − mg sin θ), wₓ across
    the bar, to 2e-5 m. The books close.
    """
    profile = {"exponent": 0.3, "height": "10 m"}
    simulation = {"integrator": "adaptive", "position_tolerance": "0.001 mm"}
    path = plain_lift(
        tmp_path,
        {"bar": pendulum(4.0, 3000.0)},
        wind=wind(25.0, **profile),
        duration="12 s",
        simulation=simulation,
    )
    done = gantline.simulate(path)

    def rates(_: float, state: Any) -> list[float]:
        angle, speed = state
        blows = 25.0 * (max(4.0 + 20.0 * (1.0 - math.cos(angle)), 1.0) / 10.0) ** 0.3
        across = 20.0 * speed - blows * math.cos(angle)
        along = blows * math.sin(angle)
        force = -PUSH * math.hypot(across, along) * across
        moment = 20.0 * (force - 3000.0 * G * math.sin(angle))
        return [speed, moment / (3000.0 * 400.0 + 9000.0)]

    time = done.time
    own = solve_ivp(rates, (0.0, 12.0), [0.0, 0.0], rtol=1e-11, atol=1e-12, t_eval=time, method="DOP853")
    x = done.dataset["body_position"].values[:, 0, 0]
    assert np.degrees(own.y[0].max()) > 34.0
    assert x == pytest.approx(20.0 * np.sin(own.y[0]), abs=2e-5)
    energy = done.dataset["energy"]
    kinds = {str(kind): energy.sel(energy_kind=kind).values for kind in energy["energy_kind"].values}
    assert np.abs(kinds["remainder"]).max() < 1e-8 * kinds["fluid_work"].max()


def test_a_hoisted_load_comes_into_stronger_wind(tmp_path: Path) -> None:
    """`wind_at_load` is s(z) U at the load's centre of gravity, heights counting from the lower of ground and
    water, and steady wind has it where it grows.
    """
    end = {"area": "40 m^2", "coefficient": 1.2, "along": "x"}
    given = {"wind": wind(10.0, terrain="fields"), "load.wind_areas": {"end": end}}
    lift = load_scenario(shipped()["spreader_bar"]).changed(given)
    done = gantline.simulate(lift, duration=60.0)
    (load,) = done.rig.loads
    z = done.column("body_position", load.body)[:, 2]
    assert lift.ground is not None and lift.ground.level == 0.0
    expected = 10.0 * np.log(np.maximum(z, 2.0) / 0.05) / math.log(10.0 / 0.05)
    assert done.column("wind_at_load", load.name) == pytest.approx(expected, rel=1e-12)
    quay = lift.changed({"water": {"level": "-4 m"}})
    assert quay.wind_profile is not None and quay.wind_profile.level == -4.0


def test_limits_of_cranes_are_held_against_the_wind_at_their_top() -> None:
    """A Goliath crane's girder: of 10 m/s at 10 m over a flat site, gusts of 14 m/s there, what is added to
    the mean is added to gusts, since their strength is the same at any height (EN 1991-1-4, 4.4).
    """
    blowing = {"speed": "10 m/s", "direction": "0 deg", "gusts": {"speed": "14 m/s"}}
    lift = load_scenario(shipped()["goliath"]).changed({"wind": blowing | {"profile": {"terrain": "flat"}}})
    (given,) = [crane for crane in (lift.cranes or {}).values() if crane.type == "goliath"]
    top = given.rail_level + given.girder.underside
    (crane,) = Rig.from_json(assemble(lift).rig).cranes
    level = min(lift.ground.level if lift.ground else 0.0, lift.water.level if lift.water else 0.0)
    grown = 10.0 * math.log((top - level) / 0.01) / math.log(1000.0)
    assert crane.wind == pytest.approx(14.0 + grown - 10.0, rel=1e-12)
    assert crane.wind is not None and crane.wind > 15.0
