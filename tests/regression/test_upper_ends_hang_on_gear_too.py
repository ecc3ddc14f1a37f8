"""Upper halves of slings and the shackles there hung in the gear above, and on its lugs, by no check.

A lumped sling gives half of itself to either end. The lower half and the lower shackle come up by its
tension; the upper ones are on the spreader, moving sheave or compensator rod itself, and neither its rated
capacity nor its lugs had them: 2 % of two short heavy slings below a bar.
"""

from __future__ import annotations

import pytest

from gantline.checks.run import values_of
from gantline.results import Recording
from gantline.scenario import parse_scenario
from gantline.statics import Statics
from lift_text import changed
from mechanics import G
from pinned_lift import LIFT, WEIGHT
from spreader_lifts import LOAD, two_below_one

#: Of a sling and metre [kg/m], of a shackle [kg]; lengths of slings below bars and between them [m].
ROPE, SHACKLE, LOWER, MIDDLE = 60.0, 150.0, 3.0, 3.0
#: Of each of two bars below one [kg], by what contingency raises what comes by tensions.
BAR, CONTINGENCY = 1e3, 1.05


def hung() -> Recording:
    """A load in the middle below two bars below one, in slings that weigh something, at rest."""
    text = changed(
        two_below_one(),
        ("damping_time: 20 ms, mass: none", f"damping_time: 20 ms, mass: {ROPE} kg/m, diameter: 60 mm"),
        ("sling_defaults: {rope: sling}", "sling_defaults: {rope: sling, shackles: {top: sh, bottom: sh}}"),
        ("\nload:\n", f"\nshackles: {{sh: {{working_load_limit: 100 t, mass: {SHACKLE} kg}}}}\nload:\n"),
        ("[0.3 m, 0 m, 1.5 m]", "[0 m, 0 m, 1.5 m]"),
        ("size: [0.3 m, 4.4 m, 0.3 m]", "size: [0.3 m, 4.4 m, 0.3 m]\n    rated_capacity: 40 t"),
        ("0.15 m], main_plate: yz}", "0.15 m], main_plate: yz, capacity: 40 t}"),
    )
    return Statics(parse_scenario(text)).equilibrium().recording


def end(length: float) -> float:
    """Mass at either end of a sling [kg]."""
    return ROPE * length / 2.0 + SHACKLE


def test_of_a_spreader_they_are_below_it() -> None:
    """Two levels by hand: tensions with the design weight, and upper ends as they weigh."""
    used = values_of(hung(), "spreader_load_of_rated_capacity")
    module = LOAD + 4.0 * end(LOWER)
    across = G * (CONTINGENCY * module / 2.0 + 2.0 * end(LOWER))
    assert used["left"] == pytest.approx(across / (40e3 * G), rel=1e-9)
    bars = module + 4.0 * end(LOWER) + 2.0 * BAR + 2.0 * end(MIDDLE)
    whole = G * (CONTINGENCY * bars + 2.0 * end(MIDDLE))
    assert used["bar"] == pytest.approx(whole / (80e3 * G), rel=1e-9)


def test_of_a_lug_they_are_on_it() -> None:
    """Below a bar a lug has the upper end of its sling beside the tension, above one the tension alone."""
    used = values_of(hung(), "lug_load_of_capacity")
    bars = LOAD + 8.0 * end(LOWER) + 2.0 * BAR + 2.0 * end(MIDDLE)
    tension = CONTINGENCY * bars / 2.0
    assert used["bar.B1"] == pytest.approx((tension + end(MIDDLE)) / 60e3, rel=1e-9)
    assert used["left.A"] == pytest.approx(tension / 40e3, rel=1e-9)


def test_of_an_equalizer_they_are_on_its_sheaves() -> None:
    """Three plumb slings below moving sheaves, with both of their ends and the load."""
    text = changed(
        LIFT,
        (
            "damping_time: 20 ms, mass: none, minimum_breaking_force: 3000",
            f"damping_time: 20 ms, mass: {ROPE} kg/m, minimum_breaking_force: 3000",
        ),
        ("hangs_from: hook", "hangs_from: hook\n    rated_capacity: 140 t"),
    )
    used = values_of(
        Statics(parse_scenario(text)).equilibrium().recording, "equalizer_load_of_rated_capacity"
    )
    slings = ROPE * (12.0 + 12.2 + 12.0)
    assert used["e1"] == pytest.approx((WEIGHT / G + slings) / 140e3, rel=1e-6)
