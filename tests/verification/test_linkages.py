"""Linkages whose loop an inextensible rope closes, against equations of motion of their own."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import gantline
from shown import MECHANICS, lift_on

G = 9.81
Floats = np.ndarray[Any, Any]
#: Crank, its mass at the pin and the piston of the slider crank of the guide; its rod [m, kg].
CRANK, AT_PIN, PISTON, ROD = 0.5, 4.0, 20.0, 1.5
#: Bars from their hinges to their pins, their masses half way, and how far the hinges are apart [m, kg].
BARS, MASSES, APART = (1.0, 1.4), (10.0, 8.0), 2.0
TIGHT: dict[str, Any] = {"tension_tolerance": 1e-4, "position_tolerance": 1e-8}


def _piston(angle: Any) -> tuple[Any, Any, Any]:
    """z = -r cos θ - s with s = √(L² - r² sin² θ), z' and z'' over θ [m]."""
    sin, cos = np.sin(angle), np.cos(angle)
    s = np.sqrt(ROD**2 - (CRANK * sin) ** 2)
    ds = -(CRANK**2) * sin * cos / s
    dds = -(CRANK**2) * (cos**2 - sin**2) / s - ds**2 / s
    return -CRANK * cos - s, CRANK * sin - ds, CRANK * cos - dds


def test_a_slider_crank_whose_rod_is_pulled() -> None:
    """Slider crank of the guide: J dω/dt + m z' z'' ω² = -(m_c r sin θ + m z') g with J = m_c r² + m z'².

    The rod pulls the piston up with m (g + dv/dt).
    """

    def faster(angle: Any, rate: Any) -> Any:
        _, dz, ddz = _piston(angle)
        pull = -(AT_PIN * CRANK * np.sin(angle) + PISTON * dz) * G - PISTON * dz * ddz * rate**2
        return pull / (AT_PIN * CRANK**2 + PISTON * dz**2)

    run = gantline.simulate(gantline.parse_scenario(lift_on(MECHANICS, "A slider crank")), **TIGHT)
    angle, rate = solve_ivp(
        lambda _, y: [y[1], faster(*y)],
        (0.0, 3.0),
        [np.radians(70), 0.0],
        "DOP853",
        run.time,
        rtol=1e-12,
        atol=1e-12,
    ).y
    z, dz, ddz = _piston(angle)
    upwards = dz * faster(angle, rate) + ddz * rate**2
    pull = PISTON * (G + upwards) * ROD / -(z + CRANK * np.cos(angle))
    assert not run.events("slack")
    assert run.column("joint_position", "crank") == pytest.approx(angle, abs=1e-6)
    assert run.column("rope_tension", "rod") == pytest.approx(pull, abs=1e-5 * pull.max())


def _pins(angles: Floats) -> tuple[Floats, Floats]:
    """From the second pin to the first, and the derivatives over both angles [m]; x, z in the first axis."""
    (a, b), (first, second) = BARS, angles
    way = [-a * np.sin(first) - APART + b * np.sin(second), -a * np.cos(first) + b * np.cos(second)]
    by = [[-a * np.cos(first), b * np.cos(second)], [a * np.sin(first), -b * np.sin(second)]]
    return np.array(way), np.array(by)


def test_four_bars_whose_coupler_is_pulled() -> None:
    """Two bars that gravity pulls apart, tied by a coupler of constant length l: I dω/dt = Q - T ∂l/∂q."""
    start = np.radians([-40.0, 35.0])

    def hinged(name: str, x: float, at: int) -> dict[str, Any]:
        joint = {"type": "hinge", "axis": [0, 1, 0], "position": f"{np.degrees(start[at])} deg"}
        middle = [0, 0, f"{-BARS[at] / 2} m"]
        body = {"at": [f"{x} m", 0, "3 m"], "joint": joint, "mass": f"{MASSES[at]} kg"}
        return {name: body | {"centre_of_gravity": middle}}

    pins = [
        {"type": "end", "body": name, "at": [0, 0, f"{-bar} m"]} for name, bar in zip("ab", BARS, strict=True)
    ]
    lift = gantline.parse_scenario(
        {
            "format": 1,
            "lift": {"title": "Four bars"},
            "duration": "1 s",
            "ropes": {"coupler": {"inextensible": "true"}},
            "mechanics": {
                "bodies": hinged("a", 0.0, 0) | hinged("b", APART, 1),
                "ropes": {"coupler": {"rope": "coupler", "length": "as_routed", "route": pins}},
            },
        }
    )
    inertia = np.array([mass * (bar / 2) ** 2 for mass, bar in zip(MASSES, BARS, strict=True)])

    def pulled(state: Floats) -> tuple[Floats, float]:
        """Accelerations [rad/s²] and tension [N]; with e from pin to pin e·d²e/dt² = -|de/dt|²."""
        angles, rates = state[:2], state[2:]
        way, by = _pins(angles)
        turned = np.array([[BARS[0] * np.sin(angles[0]), -BARS[1] * np.sin(angles[1])],
                           [BARS[0] * np.cos(angles[0]), -BARS[1] * np.cos(angles[1])]])  # fmt: skip
        weight = -np.array(MASSES) * G * np.array(BARS) / 2 * np.sin(angles)
        along = way @ by
        wanted = -((by @ rates) @ (by @ rates)) - way @ (turned @ rates**2)
        per_length = (along @ (weight / inertia) - wanted) / (along @ (along / inertia))
        return (weight - per_length * along) / inertia, per_length * float(np.hypot(*way))

    run = gantline.simulate(lift, **TIGHT)
    found = solve_ivp(
        lambda _, y: [*y[2:], *pulled(y)[0]],
        (0.0, 1.0),
        [*start, 0.0, 0.0],
        "DOP853",
        run.time,
        rtol=1e-12,
        atol=1e-12,
    ).y
    tension = np.array([pulled(state)[1] for state in found.T])
    assert not run.events("slack") and tension.min() > 0.0
    assert run.column("joint_position", "a") == pytest.approx(found[0], abs=1e-6)
    assert run.column("joint_position", "b") == pytest.approx(found[1], abs=1e-6)
    assert run.column("rope_tension", "coupler") == pytest.approx(tension, abs=1e-5 * tension.max())
