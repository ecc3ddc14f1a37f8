"""A load on two hooks, an equalizer under one of them: a sling is cut, sheaves run onto their stops, and
the load bumps a soft support with friction. In one plane, against equations of its own.

The load has x, z and its turn θ about y; moving sheaves are s₁ and s₂ below their start. Slings A, to a hook,
B and C, to the sheaves, the equalizing rope E over both, stops and support follow

    T = max(0, k (e + τ ė))     P = max(0, k_s (± s - s₀ ± τ_s ṡ))     N = max(0, k_n (d + τ_n ḋ))

and a corner that touches is held by (CO2) and (CO3) of docs/concepts/contact.md from its anchor c:

    F = k_n (x - c + τ_n ẋ), ċ = 0 where |F| ≤ μN;   else F = ± μN, ċ = ẋ - (F/k_n - (x - c))/τ_n.

scipy's LSODA solves that, anew from the cut on.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from mechanics import Floats, G, Json, adaptive, body, contact, document, end, free, half_turn, rope, slider

LOAD, INERTIA, SHEAVE = 80e3, 9.8e5, 400.0
#: Lugs and lower corners on the load, x and z [m]; where it starts.
LUGS = {"A": (-5.0, 1.5), "B": (1.5, 1.5), "C": (4.5, 1.5)}
CORNERS, START = ((-5.0, -1.5), (5.0, -1.5)), 6.0
#: The hook of A; dead ends of the equalizing rope at the same height, and the moving sheaves below.
HIGH, HOOK, SHEAVES, DROP, RADIUS = 20.0, -5.0, (1.8, 4.2), 2.0, 0.4
STOP = {"lower": -1.0, "upper": 1.0, "stiffness": 30e6, "damping_time": 0.003}
SLING_EA, EQUALIZING_EA, TAU = 50e6, 40e6, 0.004
PAD, STIFF, SOFT = 4.3, 2e6, 0.02
CUT, END = 3.0, 6.0

#: Of straight parts and half turns of the equalizing rope at the start.
ROUND = 4 * DROP + math.pi * (2 * RADIUS + (SHEAVES[1] - SHEAVES[0]) / 2 - RADIUS)
SPANS = {"A": HIGH - START - 1.5, "E": ROUND}
for name, sheave in zip("BC", SHEAVES, strict=True):
    SPANS[name] = math.dist((sheave, HIGH - DROP - RADIUS), (LUGS[name][0], START + 1.5))
#: About what each bears at the start, as a share of the weight.
SHARES = {"A": 0.42, "B": 0.29, "C": 0.29, "E": 0.145}
EA = {"A": SLING_EA, "B": SLING_EA, "C": SLING_EA, "E": EQUALIZING_EA}
LENGTHS = {name: SPANS[name] / (1 + SHARES[name] * LOAD * G / EA[name]) for name in SPANS}


def on_load(at: tuple[float, float], state: Floats) -> tuple[Floats, Floats]:
    """Where a point of the load is, and its derivative over θ."""
    cos, sin = math.cos(state[2]), math.sin(state[2])
    arm = np.array([at[0] * cos + at[1] * sin, at[1] * cos - at[0] * sin])
    return state[:2] + arm, np.array([arm[1], -arm[0]])


def ropes(state: Floats) -> dict[str, tuple[float, Floats]]:
    """Present length of each and its derivatives over x, z, θ, s₁, s₂."""
    tops = {"A": (HOOK, HIGH)}
    tops |= {
        name: (sheave, HIGH - DROP - RADIUS - state[3 + k])
        for k, (name, sheave) in enumerate(zip("BC", SHEAVES, strict=True))
    }
    found = {"E": (ROUND + 2 * (state[3] + state[4]), np.array([0, 0, 0, 2.0, 2.0]))}
    for name, top in tops.items():
        place, turned = on_load(LUGS[name], state)
        length = math.dist(place, top)
        along = (place - np.array(top)) / length
        slopes = np.array([*along, along @ turned, 0.0, 0.0])
        if name != "A":
            slopes["BC".index(name) + 3] = along[1]
        found[name] = (length, slopes)
    return found


def tensions(state: Floats, cut: bool) -> dict[str, tuple[float, Floats]]:
    pulls = {}
    for name, (length, slopes) in ropes(state).items():
        stretch = length - LENGTHS[name] + TAU * float(slopes @ state[5:10])
        gone = cut and name == "B"
        pulls[name] = (0.0 if gone else max(0.0, EA[name] / LENGTHS[name] * stretch), slopes)
    return pulls


def rates(time: float, state: Floats, cut: bool, friction: float) -> Floats:
    """Of x, z, θ, s₁, s₂, their speeds and the anchors of both corners."""
    v = state[5:10]
    force = np.array([0.0, -LOAD * G, 0.0, SHEAVE * G, SHEAVE * G])
    for pull, slopes in tensions(state, cut).values():
        force -= pull * slopes
    for k in (3, 4):
        for side, end_at in ((1, STOP["upper"]), (-1, STOP["lower"])):
            pressed = side * (state[k] - end_at) + STOP["damping_time"] * side * v[k]
            force[k] -= side * max(0.0, STOP["stiffness"] * pressed)
    slides = []
    for corner, anchor in zip(CORNERS, state[10:], strict=True):
        place, turned = on_load(corner, state)
        normal = max(0.0, STIFF * (PAD - place[1] - SOFT * (v[1] + turned[1] * v[2])))
        across, speed = place[0] - anchor, v[0] + turned[0] * v[2]
        held = STIFF * (across + SOFT * speed)
        bound = friction * normal
        if normal == 0.0:  # a corner in the air will stick where it touches
            held, slide = 0.0, speed + across / 1e-5
        elif abs(held) <= bound:
            slide = 0.0
        else:
            held = math.copysign(bound, held)
            slide = speed - (held / STIFF - across) / SOFT
        force[:2] += [-held, normal]
        force[2] += normal * turned[1] - held * turned[0]
        slides.append(slide)
    return np.concatenate([v, force / [LOAD, LOAD, INERTIA, SHEAVE, SHEAVE], slides])


def lift(friction: float) -> Json:
    """The same as a document of the core."""
    below = (0, 0, -RADIUS)
    moving = [
        body(f"m{k}", slider((0, 0, -1), stops=STOP), SHEAVE, position=(x, 0, HIGH - DROP))
        for k, x in enumerate(SHEAVES)
    ]
    middle = (SHEAVES[0] + RADIUS + SHEAVES[1] - RADIUS) / 2
    over = half_turn(None, (middle, 0, HIGH), middle - SHEAVES[0] - RADIUS, True)
    under = [half_turn(f"m{k}", (0, 0, 0), RADIUS, False) for k in (0, 1)]
    route = [
        end(None, (SHEAVES[0] - RADIUS, 0, HIGH)), under[0], over, under[1],
        end(None, (SHEAVES[1] + RADIUS, 0, HIGH)),
    ]  # fmt: skip
    lugs = {name: end("load", (x, 0, z)) for name, (x, z) in LUGS.items()}
    tops = {"A": end(None, (HOOK, 0, HIGH)), "B": end("m0", below), "C": end("m1", below)}
    slings = [rope(name, LENGTHS[name], [tops[name], lugs[name]], SLING_EA, TAU) for name in "ABC"]
    slings[1]["cut_at"] = CUT
    law: dict[str, Any] = {
        "plane_point": [0, 0, PAD],
        "stiffness": STIFF,
        "damping_time": SOFT,
        "friction": friction,
    }
    return document(
        [body("load", free((0, 0, START)), LOAD, inertia=(INERTIA, INERTIA, INERTIA)), *moving],
        ropes=[*slings, rope("E", LENGTHS["E"], route, EQUALIZING_EA, TAU)],
        contacts=[contact(f"c{k}", "load", (x, 0, z), **law) for k, (x, z) in enumerate(CORNERS)],
    )


@pytest.mark.parametrize("friction", [0.0, 0.3])
def test_a_load_bumps_its_support_after_a_cut(friction: float) -> None:
    """Load and sheaves over 3 s from the cut on to 2e-6 m: a sheave that a blow sends on a micrometre a
    second wrong goes as far. 1e-6 m of a sling are 5 to 6 N.
    """
    times = {"duration": END, "sample_interval": 0.01}
    run = adaptive(lift(friction), tension_tolerance=0.1, position_tolerance=1e-9, **times)
    before = run.time <= CUT + 1e-9
    state = np.array([0.0, START, 0.0, 0.0, 0.0, *[0.0] * 5, CORNERS[0][0], CORNERS[1][0]])
    found = []
    for cut, at in ((False, run.time[before]), (True, run.time[run.time >= CUT - 1e-9])):
        own = solve_ivp(
            rates, (at[0], at[-1]), state, "LSODA", at, args=(cut, friction),
            rtol=1e-9, atol=1e-11, max_step=0.002,
        )  # fmt: skip
        assert own.success
        state = own.y[:, -1]
        found.append(own.y.T[1 if cut else 0 :])
    own_states = np.concatenate(found)
    place, turned = run.body("load"), run.body("load", "body_orientation")
    assert place[:, 0] == pytest.approx(own_states[:, 0], abs=2e-6)
    assert place[:, 2] == pytest.approx(own_states[:, 1], abs=2e-6)
    assert 2 * np.arctan2(turned[:, 2], turned[:, 0]) == pytest.approx(own_states[:, 2], abs=2e-7)
    for k in (0, 1):
        assert run.joint(f"m{k}") == pytest.approx(own_states[:, 3 + k], abs=2e-6)
    known = [tensions(state, time > CUT + 1e-9) for time, state in zip(run.time, own_states, strict=True)]
    for name in "ABC":
        assert run.tension(name) == pytest.approx(np.array([pulls[name][0] for pulls in known]), abs=20.0)
    assert {"stop_hit", "set_down", "slack", "taut"} <= set(run.names["event_kind"])
    assert run.energy_remainder < 1e-9
