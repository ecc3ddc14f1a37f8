"""A whole lift in swell of 2 mm: every body and rope swings as the matrices of its rest say.

The crane barge with its boom, luffing tackles, falls, slings, module and mooring lines. M, D and K, with the
added mass and damping that its water has at the frequency of the swell, and P and R of the ropes are those of
`linear_model`; the run knows none of them. With X of the file about its reference point and J of the barge

    (−ω² M − iω D + K) x = Jᵀ (F, N)      F, N: a X e^(ik·p) at the point p      δT = (P − iω R) x

The barge lies level, since matrices have the axes of her hull and a run with waves level ones: a trim of
0.25 deg makes 1 % of the difference. Sheaves lose nothing, which is no matter of straight lines.
"""

from __future__ import annotations

import math
import re
from pathlib import Path

import numpy as np

import gantline
from gantline.hydro import read_database
from mechanics import Floats

FOLDER = Path(__file__).resolve().parents[2] / "scenarios" / "crane_barge_in_swell"
G, HEIGHT, DIRECTION = 9.81, 2e-3, math.radians(150.0)
#: One of the file's [s], and how long the barge swings until her slowest motion of 41 s is gone.
PERIOD, DURATION = 6.0, 900.0
OMEGA = 2 * math.pi / PERIOD
#: Of her axes: the reference point of the file.
AT = np.array([45.0, 0.0, 3.0])


def lift() -> gantline.Scenario:
    """The scenario in its first step, in regular waves."""
    text = (FOLDER / "scenario.yaml").read_text(encoding="utf-8")
    changes = (
        (r"(?m)^  swell:.*$", f"  swell: {{height: {HEIGHT} m, period: {PERIOD} s, direction: 150 deg}}"),
        (r"(?ms)^plan:.*?^watch:.*?\n\n", "plan:\n  - {step: hold, hold: until_end}\n\n"),
        (r"(?ms)^cases:.*?\n\n", ""),
        (r"(?m)^duration: 300 s$", f"duration: {DURATION} s"),
        (r"sheave_efficiency: 0.98", "sheave_efficiency: 1.0"),
        (
            r"sample_interval: 0.1 s",
            "sample_interval: 0.1 s, position_tolerance: 0.0001 mm, tension_tolerance: 0.1 N",
        ),
    )
    for was, words in changes:
        text, count = re.subn(was, words, text)
        assert count == 1, was
    return gantline.parse_scenario(text, str(FOLDER / "scenario.yaml"))


def amplitude(values: Floats, time: Floats) -> complex:
    """c of Re c e^(−iωt) beside what goes on evenly, of whole periods."""
    phase = OMEGA * time
    parts = np.column_stack([np.cos(phase), np.sin(phase), np.ones_like(time), time - time.mean()])
    cos, sin, *_ = np.linalg.lstsq(parts, values, rcond=None)[0]
    return complex(cos, sin)


def test_bodies_and_ropes_swing_by_the_matrices() -> None:
    """Complex amplitudes of places and tensions, to 1e-3 of the largest of each body and each rope.

    A step may miss 1e-7 m, and the least of these motions are 1e-4 m.
    """
    scenario = lift()
    statics = gantline.Statics(scenario)
    rest = statics.equilibrium(time=0.0).recording
    assert abs(rest.column("vessel_trim", "barge")[-1]) < 1e-5
    model = statics.linear_model(OMEGA)
    database = read_database(FOLDER / "crane_barge.nc")
    assert database.excitation is not None and database.directions is not None
    (k,) = np.flatnonzero(np.isclose(database.frequencies, OMEGA, rtol=1e-6))
    (j,) = np.flatnonzero(np.isclose(database.directions, DIRECTION))
    # The barge lies along x of the world; her own centre of gravity is that of the lift file's masses.
    centre = rest.column("body_position", "barge")[-1]
    body = next(one for one in statics.assembly.document["bodies"] if one["name"] == "barge")
    arm = AT - np.array(body["centre_of_gravity"])
    ahead = np.array([math.cos(DIRECTION), math.sin(DIRECTION)])
    phase = OMEGA**2 / G * (ahead @ (centre + arm)[:2])
    pushed = HEIGHT / 2 * np.exp(1j * phase) * database.excitation[k, j]
    force, moment = pushed[:3], pushed[3:] + np.cross(arm, pushed[:3])
    jacobian = model.body_motion[model.bodies.index("barge")]
    free = len(model.coordinates)
    dynamic = -(OMEGA**2) * model.mass - 1j * OMEGA * model.damping + model.stiffness
    whole = np.block([[dynamic, model.held.T], [model.held, np.zeros((len(model.held),) * 2)]])
    right = np.zeros(len(whole), dtype=complex)
    right[:free] = jacobian.T @ np.concatenate([force, moment])
    x = np.linalg.solve(whole, right)[:free]

    run = gantline.simulate(scenario)
    late = run.time > DURATION - 50 * PERIOD
    time = run.time[late]
    for name in ("barge", "sheerleg.boom", "sheerleg.H1", "module"):
        wanted = model.body_motion[model.bodies.index(name)][:3] @ x
        places = run.column("body_position", name)[late]
        found = np.array([amplitude(places[:, axis], time) for axis in range(3)])
        assert np.abs(found - wanted).max() < 1e-3 * np.abs(wanted).max(), name
    for place, name in enumerate(model.ropes):
        pull = (model.tension[place] - 1j * OMEGA * model.tension_rate[place]) @ x
        assert abs(amplitude(run.column("rope_tension", name)[late], time) - pull) < 1e-3 * abs(pull), name
