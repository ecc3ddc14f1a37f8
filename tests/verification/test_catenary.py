"""Ropes of distributed weight against the elastic catenary.

The nodes start where the rope hangs at rest, which the lift file's translation solves for; the simulator,
which knows nothing of that, then has to hold them there, and the forces on the ends are read off its joints.
So the simulator is held to be in balance, and the balance to be the catenary's.
"""

from __future__ import annotations

import csv
import math
from pathlib import Path

import numpy as np
import pytest

from gantline.assembly.ropes.catenary import end_mass, hang, node_masses
from gantline.assembly.ropes.rope_weight import length_that_pulls
from gantline.scenario.gear import RopeMaterial
from gantline.scenario.rope_weight import RopeWeight
from hanging import Catenary, lift, run
from mechanics import Floats

TABLE = Path(__file__).resolve().parents[3] / "shared" / "data" / "catenary" / "elastic_catenary_rows.csv"

#: Force at the upper end chosen, ends from the closed form: sagging below its lower end, taut and stretched
#: by a hundredth, shallow, steep, level.
CASES = {
    "sagging": Catenary(40e3, 70e3, 500.0, 5e9, 200.0),
    "stretched": Catenary(0.9e6, 0.7e6, 100.0, 1e8, 150.0),
    "shallow": Catenary(300e3, 15e3, 200.0, 1e9, 147.0),
    "steep": Catenary(5e3, 30e3, 120.0, 2e8, 160.0),
    "level": Catenary(50e3, 10e3, 100.0, 1e9, 200.0),
}


@pytest.mark.parametrize("case", CASES.values(), ids=CASES)
def test_forces_at_the_ends_of_a_catenary(case: Catenary) -> None:
    """50 nodes: horizontal and vertical force of both ends to 1e-5 of Irvine's closed form, start and end."""
    hanging = run(lift(case.reach, case.length, case.stiffness, case.weight, 50))
    upper, lower = (case.horizontal, case.upper), (case.horizontal, case.lower)
    for sample in (0, -1):
        assert hanging.upper[sample] == pytest.approx(upper, rel=1e-5)
        assert hanging.lower[sample] == pytest.approx(lower, rel=1e-5)


@pytest.mark.parametrize("case", CASES.values(), ids=CASES)
def test_a_rope_that_hangs_at_rest_stays_there(case: Catenary) -> None:
    """No node moves 1 nm in 5 s, nine orders below the sag: the start is the simulator's own balance."""
    hanging = run(lift(case.reach, case.length, case.stiffness, case.weight, 50))
    assert hanging.moved < 1e-9
    assert hanging.recording.events() == []


@pytest.mark.parametrize("case", CASES.values(), ids=CASES)
def test_tension_at_the_ends_as_recorded(case: Catenary) -> None:
    """`rope_end_tension` is sqrt(H^2 + V^2) of either end, `rope_tension` the larger, to 1e-5 of 50 nodes."""
    recording = run(lift(case.reach, case.length, case.stiffness, case.weight, 50)).recording
    lower, upper = (np.hypot(case.horizontal, end) for end in (case.lower, case.upper))
    assert recording["rope_end_tension"].values[-1, 0] == pytest.approx([lower, upper], rel=1e-5)
    assert recording["rope_tension"].values[-1, 0] == pytest.approx(max(lower, upper), rel=1e-5)
    assert recording["rope_peak_tension"].values[0] == pytest.approx(max(lower, upper), rel=1e-5)


def test_a_rope_of_the_length_that_a_wanted_pull_takes() -> None:
    """Level, H = 50 kN and V = 10 kN at both ends: T = √(H² + V²) is that of 100 m, of which 0.65 m are sag.

    T goes with 1/√sag: 2e-5 of it, to which 50 nodes have the forces of the ends, are 4e-5 of 0.65 m.
    """
    case = CASES["level"]
    kind = RopeMaterial.model_construct(axial_stiffness=case.stiffness)
    weight = RopeWeight("distributed", case.weight / 9.81, 50)
    ends = np.zeros(3), np.array([case.reach[0], 0.0, case.reach[1]])
    length, _ = length_that_pulls(*ends, math.hypot(case.horizontal, case.upper), kind, weight, 9.81)
    assert length == pytest.approx(case.length, abs=4e-5 * 0.65)


def ends_missed(case: Catenary, nodes: int, masses: Floats, at_end: float) -> float:
    """Largest error of the forces at the ends, of the largest of them."""
    first, last = np.zeros(3), np.array([case.reach[0], 0.0, case.reach[1]])
    forces = hang(first, last, case.length, case.stiffness, masses).forces
    found = np.array([forces[0, 0], forces[-1, 2] + at_end, forces[0, 2] - at_end])
    exact = np.array([case.horizontal, case.upper, case.lower])
    return float(np.abs(found - exact).max() / np.hypot(case.horizontal, case.upper))


@pytest.mark.parametrize("name", ["sagging", "stretched", "shallow", "level"])
def test_order_of_convergence_at_rest(name: str) -> None:
    """Halves at the ends (plain lumping) err by h^2, with the end correction by h^3 and far less.

    The correction shifts the tension of the first two segments by 1/16 and -1/48 of what a segment weighs;
    its own error is half the sum of the squares of these shifts, h^3/461 times the second derivative of the
    integrand, beside which errors of h^4 still show. In "steep" 20 segments do not resolve the bend yet.
    """
    case = CASES[name]
    weight = case.weight * case.length
    plain, corrected = [], []
    for segments in (20, 40, 80):
        nodes = segments - 1
        equal = np.full(nodes, weight / segments)
        plain.append(ends_missed(case, nodes, equal, weight / segments / 2))
        corrected.append(ends_missed(case, nodes, node_masses(weight, nodes), end_mass(weight, nodes)))
    assert np.log2(np.divide(plain[:-1], plain[1:])) == pytest.approx([2.0, 2.0], abs=0.1)
    assert np.log2(np.divide(corrected[:-1], corrected[1:])).min() > 2.8
    assert corrected[-1] < plain[-1] / 100


def test_a_plumb_rope() -> None:
    """Hung by one end: tension w L at the top, 0 at the bottom, longer by w L^2/(2 EA).

    The midpoint rule is exact for a tension that is linear, so the tolerance is rounding.
    """
    weight, length, stiffness = 160.0, 100.0, 1e8
    stretched = length + weight * length**2 / (2 * stiffness)
    hanging = run(lift((0.0, stretched), length, stiffness, weight, 50))
    assert hanging.upper[-1] == pytest.approx([0.0, weight * length], abs=1e-4)
    assert hanging.lower[-1] == pytest.approx([0.0, 0.0], abs=1e-4)
    assert hanging.moved < 1e-9


def test_a_rope_slack_between_ends_that_are_plumb() -> None:
    """Two plumb legs: the lower end carries half of what is slack, (L - z)/2 w, the upper all the rest.

    Whichever node is the lowest, a leg is right to one segment; L - z is 4 of 50 segments here.
    """
    weight, length, nodes = 160.0, 50.0, 49
    hanging = run(lift((0.0, 46.0), length, 1e9, weight, nodes))
    segment = weight * length / (nodes + 1)
    assert hanging.lower[-1, 1] == pytest.approx(-2.0 * weight, abs=segment)
    assert hanging.upper[-1, 1] - hanging.lower[-1, 1] == pytest.approx(weight * length, rel=1e-9)
    assert hanging.moved < 1e-9


def table() -> list[dict[str, float]]:
    """The rows of the table beside this checkout, none where there is none."""
    if not TABLE.exists():
        return []
    with TABLE.open(encoding="utf-8", newline="") as file:
        return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]


@pytest.mark.skipif(not TABLE.exists(), reason="the table of catenaries is not beside this checkout")
@pytest.mark.parametrize("nodes", [50, 100])
def test_rows_of_the_table(nodes: int) -> None:
    """Every row to 1e-5: horizontal force and both vertical ones (MoorPy's catenary; up to seven digits)."""
    rows = table()
    assert rows
    for row in rows:
        reach = (row["x_m"], row["z_m"])
        hanging = run(lift(reach, row["L_m"], row["EA_N"], row["w_N_per_m"], nodes))
        for sample in (0, -1):
            assert hanging.upper[sample, 0] == pytest.approx(row["H_N"], rel=1e-5)
            assert hanging.upper[sample, 1] == pytest.approx(row["V_upper_end_N"], rel=1e-5)
            assert hanging.lower[sample, 1] == pytest.approx(row["V_lower_end_N"], rel=1e-5)
        assert hanging.moved < 1e-9


@pytest.mark.skipif(not TABLE.exists(), reason="the table of catenaries is not beside this checkout")
def test_rows_of_the_table_are_converged_to() -> None:
    """With 25, 50, 100 nodes the distance falls, to 1e-6: the digits that the table has."""
    for row in table():
        missed = []
        exact = np.array([row["H_N"], row["V_upper_end_N"], row["V_lower_end_N"]])
        for nodes in (25, 50, 100):
            weight = row["w_N_per_m"] * row["L_m"]
            masses, at_end = node_masses(weight, nodes), end_mass(weight, nodes)
            last = np.array([row["x_m"], 0.0, row["z_m"]])
            forces = hang(np.zeros(3), last, row["L_m"], row["EA_N"], masses).forces
            found = np.array([forces[0, 0], forces[-1, 2] + at_end, forces[0, 2] - at_end])
            missed.append(float(np.abs(found / exact - 1).max()))
        assert missed[0] > missed[1] > missed[2]
        assert missed[2] < 1e-6
