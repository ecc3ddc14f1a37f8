"""`del` with `paper` is eq. (15) of Ham, Roh and Lee (2016) to the letter.

The paper's matrix equation is written out here with numpy and solved densely, step by step; it knows q[k] and
q[k-1] only. gantline works with velocities on a sparse pattern. Both must give the same motion to rounding.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from mechanics import Floats, G, body, document, end, half_turn, point, rope, simulate, slider

#: g and G at a configuration.
Rows = Callable[[Floats], tuple[Floats, Floats]]

H = 1e-3
STEPS = 400


def eq_15(m: Floats, force: Floats, rows: Rows, compliance: Floats, q: Floats) -> Floats:
    """Positions of all steps by eq. (15), from rest; `rows(q)` gives g and G."""
    history = [q, q]  # at rest: q[-1] = q[0]
    mass = np.diag(m)
    for _ in range(STEPS):
        before, now = history[-2], history[-1]
        g, gradient = rows(now)
        left = np.block([[mass, -gradient.T], [gradient, np.diag(compliance) / H**2]])
        right = np.concatenate([mass @ (2 * now - before) + H**2 * force, -g + gradient @ now])
        history.append(np.linalg.solve(left, right)[: len(q)])
    return np.array(history[1:])


def test_two_points_on_elastic_ropes() -> None:
    """A double pendulum of points: constant M, G that turns, both ropes taut throughout."""
    top, first, second = np.array([0.0, 0, 10]), np.array([1.0, 0.5, 8]), np.array([2.5, 0.5, 6.5])
    ea, masses = 1e6, (30.0, 70.0)
    lengths = [float(np.linalg.norm(part)) - 1e-3 for part in (first - top, second - first)]
    system = document(
        [body("a", point(first), masses[0]), body("b", point(second), masses[1])],
        ropes=[
            rope("upper", lengths[0], [end(None, top), end("a")], ea),
            rope("lower", lengths[1], [end("a"), end("b")], ea),
        ],
    )

    def rows(q: Floats) -> tuple[Floats, Floats]:
        a, b = q[:3], q[3:]
        n1, n2 = (a - top) / np.linalg.norm(a - top), (b - a) / np.linalg.norm(b - a)
        g = np.array([np.linalg.norm(a - top) - lengths[0], np.linalg.norm(b - a) - lengths[1]])
        return g, np.array([[*n1, 0, 0, 0], [*-n2, *n2]])

    m = np.repeat(masses, 3)
    force = m * np.tile([0, 0, -G], 2)
    paper = eq_15(m, force, rows, np.array(lengths) / ea, np.concatenate([first, second]))
    run = simulate(system, STEPS * H, step=H, paper=True)
    assert run.columns["rope_tension"][1:].min() > 0, "all rows must act for eq. (15) to apply"
    ours = np.hstack([run.body("a"), run.body("b")])
    # Rounding of two different elimination orders, grown over 400 steps of a stiff system.
    assert np.abs(ours - paper).max() < 1e-10


def test_inextensible_rope_over_sheaves() -> None:
    """The chain of sheaves of section 4.1, ε = 0, against the same dense equation."""
    system = document(
        [
            body("m1", slider(), 20.0, position=(0.5, 0, 20)),
            body("m2", slider(), 20.0, position=(2.5, 0, 20)),
            body("box", slider(), 11.0, position=(4, 0, 20)),
        ],
        ropes=[
            rope(
                "rope",
                5 * 10 + 4 * np.pi * 0.5,
                [
                    end(None, (0, 0, 30)),
                    half_turn("m1", (0, 0, 0), 0.5, over=False),
                    half_turn(None, (1.5, 0, 30), 0.5, over=True),
                    half_turn("m2", (0, 0, 0), 0.5, over=False),
                    half_turn(None, (3.5, 0, 30), 0.5, over=True),
                    end("box"),
                ],
                None,
            )
        ],
    )

    def rows(q: Floats) -> tuple[Floats, Floats]:
        return np.array([-2 * q[0] - 2 * q[1] - q[2]]), np.array([[-2.0, -2.0, -1.0]])

    m = np.array([20.0, 20.0, 11.0])
    paper = eq_15(m, -G * m, rows, np.zeros(1), np.zeros(3))
    run = simulate(system, STEPS * H, step=H, paper=True)
    ours = np.stack([run.joint(name) for name in ("m1", "m2", "box")], axis=1)
    assert np.abs(ours - paper).max() < 1e-12


@pytest.mark.parametrize("paper", [True, False])
def test_geometric_stiffness_is_what_paper_leaves_out(paper: bool) -> None:
    """The same taut pendulum with and without K differs; only the bare scheme is the paper's."""
    first = np.array([3.0, 0, 6])
    length = (
        float(np.linalg.norm(first - [0, 0, 10])) - 2e-3
    )  # about the stretch that the weight gives: stays taut
    system = document(
        [body("a", point(first), 50.0)], ropes=[rope("r", length, [end(None, (0, 0, 10)), end("a")], 1e6)]
    )

    def rows(q: Floats) -> tuple[Floats, Floats]:
        d = q - np.array([0, 0, 10])
        return np.array([np.linalg.norm(d) - length]), (d / np.linalg.norm(d))[None, :]

    m = np.full(3, 50.0)
    reference = eq_15(m, m * [0, 0, -G], rows, np.array([length / 1e6]), first)
    run = simulate(system, STEPS * H, step=H, paper=paper)
    assert run.tension("r")[1:].min() > 0
    ours = run.body("a")
    difference = np.abs(ours - reference).max()
    assert (difference < 1e-10) == paper
