"""`--refine` of a lift without ropes and checks said nothing, whatever the finer run came to.

A double pendulum let go from 170° was 3.3 m from where the finer run had it, and all that stood under
`Numerical error` was what the tolerances had been, below it that the energy balance closes. Now the body that
is farthest from its place in the finer run is told, and the first page has it where no figure of a check was
compared.
"""

from __future__ import annotations

import numpy as np
import pytest

import gantline
from gantline.report.first_page import FirstPage
from gantline.report.subject import Subject
from gantline.results.recording import Recording
from gantline.results.refinement import refinement_of
from gantline.study import finer_simulation, refined

#: Two points on rods of 1 m, chaotic from here.
LIFT = """
format: 1
lift: {title: Double pendulum}
duration: 6 s
mechanics:
  bodies:
    upper:
      at: [0, 0, 3 m]
      joint: {type: hinge, axis: [0, 1, 0], position: 170 deg}
      mass: 10 kg
      centre_of_gravity: [0, 0, -1 m]
    lower:
      parent: upper
      at: [0, 0, -1 m]
      joint: {type: hinge, axis: [0, 1, 0], position: 10 deg}
      mass: 10 kg
      centre_of_gravity: [0, 0, -1 m]
"""


@pytest.fixture(scope="module")
def pair() -> tuple[Recording, Recording]:
    simulation = gantline.Simulation(gantline.parse_scenario(LIFT))
    recording = simulation.run()
    return recording, finer_simulation(simulation, recording).run()


def test_the_body_that_is_farthest_from_its_place_is_told(pair: tuple[Recording, Recording]) -> None:
    """By the samples of both runs, which are at the same times."""
    apart = np.linalg.norm(pair[0]["body_position"].values - pair[1]["body_position"].values, axis=2)
    when, which = np.unravel_index(np.argmax(apart), apart.shape)
    found = refinement_of(refined(*pair))
    assert found is not None and found.apart is not None
    assert found.figures == []
    assert found.apart.body == pair[0].coordinates["body"][which] == "lower"
    assert found.apart.distance == pytest.approx(apart[when, which], rel=1e-12)
    assert found.apart.time == pair[0].time[when]
    assert found.apart.distance > 5e-3
    assert list(found.sentences())[-1] == found.apart.sentence


def test_the_first_page_tells_it_where_there_is_no_figure(pair: tuple[Recording, Recording]) -> None:
    whole = refined(*pair)
    found = refinement_of(whole)
    assert found is not None and found.apart is not None
    content = FirstPage().content(Subject(whole))
    assert f"with {found.how} {found.apart.sentence}" in str(content)


def test_a_recording_of_before_has_none(pair: tuple[Recording, Recording]) -> None:
    whole = refined(*pair)
    old = {key: value for key, value in whole.attributes["refinement"].items() if key != "apart"}
    again = refinement_of(
        Recording(whole.variables, whole.coordinates, {**whole.attributes, "refinement": old})
    )
    assert again is not None and again.apart is None
