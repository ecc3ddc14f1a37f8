"""Books of the step that begins with a cut, closed as if nothing had been cut.

Where four looks at a step do not tell what flowed it is looked at more closely. That began from the state
before the plan acted: with the line that is cut as the step begins still in place, and drives that set off
then at rest. A hull whose mooring line was cut had 46 % of its energy too much in its books; the motion was
right.
"""

from __future__ import annotations

import pytest

from mechanics import Json, adaptive, body, document, slider

MASS, BED, CUT = 2e6, -12.0, 0.7


def line(name: str, x: float, y: float, weight: float) -> Json:
    """A mooring line to the sea bed that its vessel stretches to 200 kN at the start."""
    return {
        "type": "mooring",
        "name": name,
        "body": "hull",
        "at": [0, 0, 0],
        "to": [x, y, BED],
        "weight": weight,
        "axial_stiffness": 4e7,
        "damping_time": 0.2,
        "pretension": 2e5,
        "sea_bed": BED,
    }


@pytest.mark.parametrize("tolerance", [(2e3, 1e-4), (1.0, 1e-7)], ids=["coarse", "fine"])
def test_a_line_is_cut_and_the_books_close(tolerance: tuple[float, float]) -> None:
    """Kinetic + gravity + elastic energy and all losses stay what they were, to 1e-5 at any tolerance.

    Beyond that a run says that its books do not close.
    """
    lines = [
        line("a", 25, 25, 150.0),
        line("b", -25, 28, 670.0),
        {**line("c", -25, -30, 260.0), "cut_at": CUT},
    ]
    drag = {"type": "drag", "name": "water", "body": "hull", "at": [0, 0, 0], "stream": [0.5, -0.3, 0]}
    drag |= {"damping": [[0.0] * 6 for _ in range(6)], "quadratic": [2e4, 6e4, 1e5, 0, 0, 0]}
    along = body("along", slider((1, 0, 0), velocity=0.6), 1.0)
    hull = body("hull", slider((0, 1, 0), velocity=0.6), MASS, parent="along")
    system = document([along, hull], forces=[*lines, drag])
    run = adaptive(system, 6.0, tension_tolerance=tolerance[0], position_tolerance=tolerance[1])
    assert run.events("cut") == [(CUT, "c")]
    assert run.energy_remainder < 1e-5
