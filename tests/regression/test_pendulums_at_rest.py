"""What stands on joints alone and starts at rest was told that its energy balance does not close.

A double pendulum at rest has no spring that holds energy: what moves there is rounding, 1e-29 J, and the
remainder of its books is as much. It was "1.6e+00 of the largest energy, bound 1e-05: THE BALANCE DOES NOT
CLOSE", with a warning, and "GAINS ENERGY" in a comparison.
"""

from __future__ import annotations

import pytest

from gantline.results.stability import stability_of
from gantline.scenario import parse_scenario
from gantline.simulation import simulate

LIFT = """
format: 1
lift: {title: A double pendulum}
duration: 2 s
start: START
mechanics:
  bodies:
    upper:
      at: [0 m, 0 m, 3 m]
      joint: {type: hinge, axis: [0, 1, 0], position: 30 deg}
      mass: 10 kg
      centre_of_gravity: [0.1 m, 0 m, -1 m]
    lower:
      parent: upper
      at: [0 m, 0 m, -1 m]
      joint: {type: hinge, axis: [0, 1, 0]}
      mass: 10 kg
      centre_of_gravity: [0.3 m, 0 m, -1 m]
"""


@pytest.mark.parametrize("height", ["3 m", "63.7 m"])
def test_at_rest_its_books_are_closed(height: str) -> None:
    recording = simulate(parse_scenario(LIFT.replace("START", "rest").replace("3 m]", f"{height}]")))
    assert recording.attributes["energy_remainder"] < 1e-6
    assert not recording.attributes["warnings"]
    assert stability_of(recording).is_sound


def test_what_swings_is_held_against_its_own_energy() -> None:
    """From 30 deg it swings with 25 J, 1e8 of what its weight does along 1e-9 m: these count as before."""
    recording = simulate(parse_scenario(LIFT.replace("START", "as_given")))
    energy = recording["energy"]
    kinds = recording.coordinates["energy_kind"]
    largest = float(energy.values[:, list(kinds).index("kinetic")].max())
    remainder = abs(energy.values[:, list(kinds).index("remainder")]).max()
    assert recording.attributes["energy_remainder"] >= 0.5 * remainder / largest > 0.0
