"""Friction of stiff contacts at coarse tolerances, booked as less than nothing.

The anchor of a sliding contact follows its law within a damping time, 10 µs where none is given: what the
tolerance lets a force be wrong by was metres per second of it. Books took friction from that and not from
where the anchor went, and what was too much from `method`: a hull of 2000 t that slides along two fenders
had lost −4.6 MJ to friction of the 0.7 MJ that it came with, 3.4 MJ to the method and 1.8 MJ in dampers.
The motion was right.
"""

from __future__ import annotations

import pytest

from mechanics import adaptive, body, contact, document, end, free, rope

MASS, FRICTION = 2e6, 0.3


@pytest.mark.parametrize("stiffness", [3e5, 5e6])
def test_a_hull_that_slides_along_its_fenders(stiffness: float) -> None:
    """Undamped springs press it against the wall: what is gone of ½ m v² and of the springs is friction.

    What the tolerance of 2 kN and 0.1 mm lets through is `method`, a thousandth of the energy; with neither
    gravity nor dampers there is nothing else.
    """
    hull = body(
        "hull",
        free((0, 0, 0), velocity=[0.8, 0.2, 0], angular_velocity=[0, 0, 0.01]),
        MASS,
        inertia=(20 * MASS, 120 * MASS, 130 * MASS),
    )
    wall = {"plane_point": [0, 7.1, 0], "plane_normal": [0, -1, 0]}
    fenders = [
        contact(f"fender{x}", "hull", (x, 7, 0), stiffness=stiffness, friction=FRICTION, **wall)
        for x in (-12, 12)
    ]
    springs = [
        rope(f"spring{x}", 50.0, [end("hull", (x, 7, 0)), end(None, (x, 60, 0))], 5e6) for x in (-15, 15)
    ]
    system = {**document([hull], contacts=fenders, ropes=springs), "gravity": [0, 0, 0]}
    run = adaptive(system, 10.0, tension_tolerance=2e3, position_tolerance=1e-4, sample_interval=0.05)
    stored = run.energy("kinetic") + run.energy("elastic")
    lost, coarse = stored[0] - stored[-1], 1e-3 * stored[0]
    friction = run.energy("friction")
    assert lost > 0.3 * stored[0]
    assert friction[-1] == pytest.approx(lost, abs=coarse)
    for kind in ("method", "contact_damping"):
        assert abs(run.energy(kind)).max() < coarse, kind
