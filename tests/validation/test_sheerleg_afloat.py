"""A 3600 t sheerleg with 1000 t on its hooks and before: hand figures of drafts, trim, stability and periods.

The figures are small-angle ones of a box hull, 105.6 × 46 × 7.5 m, of plausible weights, from the keel and
from the stern: hull and A-frame 9100 t at (47.6, 0, 8.1) m; boom 1500 t, 110 m long at 60° from heel pins at
(98, 0, 9) m, centre at 48 %; gear at its head 460 t; ballast in eight tanks of 26.4 × 11.5 m, 3311 t in the
first row and 6441 t in the second; load and rigging 1096 t at the boom head.
"""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from floating import pitch_and_roll
from gantline._core import Statics
from gantline.assembly import assemble
from gantline.hydro import Tank, box_hull, float_free, free_surface_correction
from gantline.scenario import load_scenario

LENGTH, BREADTH, DEPTH = 105.6, 46.0, 7.5
OWN = np.array([47.6, 0.0, 8.1])
HEAD = np.array([98 + 110 * math.cos(math.radians(60)), 0.0, 9 + 110 * math.sin(math.radians(60))])
BOOM = np.array([98.0, 0, 9]) + 0.48 * (HEAD - np.array([98.0, 0, 9]))
ROWS = [(13.2, 3311.0), (39.6, 6441.0)]  # x of the middle [m], content [t]


def metres(place: np.ndarray[Any, Any]) -> str:
    return ", ".join(f"{part:.12g} m" for part in place)


def lift(on_hooks: float) -> str:
    """The lift file; `on_hooks` [t] hang at the boom head."""
    keel = np.array([LENGTH / 2, 0, 0]) - OWN
    tanks = [
        f"        t{row}{place}: {{box: [26.4 m, 11.5 m, {DEPTH} m], content: {content / 4} t, "
        f"bottom: [{metres(np.array([x, 11.5 * (place - 1.5), 0]) - OWN)}]}}"
        for row, (x, content) in enumerate(ROWS)
        for place in range(4)
    ]
    weights = {"boom": (1500, BOOM), "gear": (460, HEAD), **({"held": (on_hooks, HEAD)} if on_hooks else {})}
    others = [
        f"    {name}: {{parent: vessel, at: [{metres(place - OWN)}], joint: {{type: fixed}}, mass: {mass} t}}"
        for name, (mass, place) in weights.items()
    ]
    return "\n".join(
        [
            "format: 1",
            "lift: {title: A sheerleg afloat}",
            "duration: 1 s",
            "start: rest",
            "mechanics:",
            "  bodies:",
            "    vessel:",
            f"      joint: {{type: free, position: [0 m, 0 m, {8.1 - 4.4} m]}}",
            "      mass: 9100 t",
            "      inertia: {"
            f"xx: {9100 * 15**2} t m^2, yy: {9100 * 28.5**2} t m^2, zz: {9100 * 30**2} t m^2}}",
            f"      hull: {{box: [{LENGTH} m, {BREADTH} m, {DEPTH} m], keel: [{metres(keel)}]}}",
            "      added_mass: {heave: 85000 t, roll: 7.5e6 t m^2, pitch: 6.3e7 t m^2,",
            f"        at: [{metres(np.array([LENGTH / 2, 0, 0]) - OWN)}]}}",
            "      tanks:",
            *tanks,
            *others,
        ]
    )


def at_rest(folder: Path, on_hooks: float) -> tuple[float, float, list[float], list[float]]:
    """Trim by the stern [deg], heel [deg], drafts aft and forward [m], periods [s]."""
    path = folder / "lift.yaml"
    path.write_text(lift(on_hooks), encoding="utf-8")
    question = Statics(assemble(load_scenario(path)).document_text())
    found = question.settle()
    assert found["unstable"] == 0
    columns, names = question.columns(), question.names()
    vessel = names["body"].index("vessel")
    bow, side = pitch_and_roll(columns["body_orientation"][0, vessel])
    # `body_position` is of the centre of gravity, ballast included.
    content = sum(content for _, content in ROWS)
    ballast = [np.array([x, 0, content / 4 / 1.025 / 26.4 / 11.5 / 2]) * content for x, content in ROWS]
    centre = (9100 * OWN + sum(ballast)) / (9100 + content)
    height = columns["body_position"][0, vessel, 2]
    drafts = [
        -(height - (centre[0] - x) * math.sin(bow) - centre[2] * math.cos(bow)) / math.cos(bow)
        for x in (0.0, LENGTH)
    ]
    squares = question.modes()["square"]
    periods = sorted(2 * math.pi / math.sqrt(square) for square in squares if square > 1e-3)
    return math.degrees(bow), math.degrees(side), drafts, periods


def test_before_the_lift_it_is_trimmed_by_the_stern(tmp_path: Path) -> None:
    """20 812 t at 4.18 m mean draft; 1.46° by the stern, drafts 5.53 m aft and 2.83 m forward: within 2 %.

    Periods of heave, pitch and roll are said to be about 9, 9 and 8.5 s; coupled, as they are, within 8 %.
    """
    trim, heel, (aft, forward), periods = at_rest(tmp_path, 0.0)
    assert trim == pytest.approx(1.46, rel=0.02)
    assert (aft, forward) == pytest.approx((5.53, 2.83), rel=0.02)
    assert (aft + forward) / 2 == pytest.approx(4.18, rel=0.005)
    assert heel == pytest.approx(0, abs=1e-6)
    assert periods == pytest.approx([8.5, 9, 9], rel=0.08)


def test_holding_the_load_it_floats_on_even_keel(tmp_path: Path) -> None:
    """21 908 t at 4.40 m; within 0.1° of even keel, drafts of both ends within 2 %."""
    trim, heel, (aft, forward), _ = at_rest(tmp_path, 1096.0)
    assert abs(trim) < 0.1 and abs(heel) < 1e-6
    assert (aft, forward) == pytest.approx((4.40, 4.40), rel=0.02)


@pytest.mark.parametrize(("held", "wanted"), [(0.0, (32.2, 206.7)), (1096.0, (25.6, 191.4))])
def test_metacentric_heights_with_free_surface(held: float, wanted: tuple[float, float]) -> None:
    """With eight slack tanks 32.2 and 206.7 m before, 25.6 and 191.4 m holding the load: within 2 %."""
    weights = [(9100, OWN), (1500, BOOM), (460, HEAD), (held, HEAD)]
    weights += [(content, np.array([x, 0, content / 4 / 1.025 / 26.4 / 11.5 / 2])) for x, content in ROWS]
    mass = sum(weight for weight, _ in weights)
    centre = sum(weight * place for weight, place in weights) / mass
    found = float_free(box_hull((LENGTH, BREADTH, DEPTH)), mass * 1e3, centre)
    correction = free_surface_correction([Tank(26.4, 11.5)] * 8, mass * 1e3)
    assert found.hydrostatics.gm(centre, correction) == pytest.approx(wanted, rel=0.02)


def test_the_lift_file_is_json_for_the_core(tmp_path: Path) -> None:
    """Eight tanks, a hull and added mass: ten forces on one body."""
    path = tmp_path / "lift.yaml"
    path.write_text(lift(0.0), encoding="utf-8")
    forces = json.loads(assemble(load_scenario(path)).document_text())["forces"]
    assert sorted(force["type"] for force in forces) == ["added_mass", "buoyancy", *["tank"] * 8]
