"""Words of lifts that set a load down: where supports stand, their friction, what they bear."""

from __future__ import annotations

import pytest

import gantline
from gantline.assembly import assemble
from gantline.cli.hold_points import hold_points
from gantline.plot.moments import moments, stages
from gantline.report.first_page import FirstPage
from gantline.report.subject import Subject
from gantline.scenario import ScenarioError, parse_scenario
from gantline.simulation import Simulation
from hooked_lift import hooked_lift
from lift_text import BASE, changed
from mechanics import G

#: A load of 10 m by 6 m on slings of 10 m over four feet, of which one is 8 mm too low.
HOOKS = {"A": (0.0, 0.0, 6.0 + 84.0**0.5)}
LUGS = {"1": (-4.0, 0.0, 4.0), "2": (4.0, 0.0, 4.0)}
SLINGS = {"S1": ("A", "1", 10.0), "S2": ("A", "2", 10.0)}
MASS, STIFFNESS, SHIM = 200e3, 200e6, 8e-3
FEET = """\
supports:
  feet: {under: load, grid: {x: [-4 m, 4 m], y: [-2 m, 2 m]}, height: 1.5 m,
    stiffness: 200 MN/m, friction: 0.3, each: {"2.2": {height: 1.492 m}}}
plan:
  - {step: down, lower: A, speed: 0.1 m/s, until: {supports: touched}}
  - {step: set down, lower: A, speed: 0.01 m/s, until: {slings: slack}}
  - {step: further, lower: A, speed: 0.1 m/s, by: 0.3 m}
  - {step: off, hold: 10 s, detach: [sling.S1, sling.S2], report: [support_force, corner_load]}
"""


def beside(x: float, height: float) -> str:
    return changed(
        BASE,
        (
            "cranes:\n",
            "supports:\n  there: {under: block, measured_from: world, friction: 0.4, "
            f"grid: {{x: [{x} m], y: [0 m]}}, height: {height} m}}\ncranes:\n",
        ),
    )


def test_supports_inside_the_load_are_refused() -> None:
    """The load covers x from -4 m to 4 m, z from 0 to 3 m."""
    with pytest.raises(ScenarioError) as caught:
        parse_scenario(beside(3.9, 2.0))
    assert str(caught.value).endswith(
        "supports.there: 'there.1.1' stands inside the load at the start: its top is at 2 m, the underside "
        "of the load at 0 m; move it to where the load comes down, or the load to where it starts"
    )
    parse_scenario(beside(4.1, 2.0))
    parse_scenario(beside(3.9, 0.05))


@pytest.mark.parametrize("friction", ["", ", friction: 0.3"])
def test_supports_without_a_word_on_friction_are_doubted_where_a_load_comes_down(friction: str) -> None:
    text = hooked_lift(HOOKS, LUGS, SLINGS, mass=MASS, position=(0.0, 0.0, 2.0), more=FEET)
    warnings = assemble(parse_scenario(text.replace(", friction: 0.3", friction))).warnings
    told = [one for one in warnings if one.startswith("nothing says the friction of supports feet")]
    assert len(told) == (not friction)


def test_supports_are_read_at_hold_points() -> None:
    """A foot that is d too low has k d/4 less, and so has that across; the two others have as much more."""
    text = hooked_lift(HOOKS, LUGS, SLINGS, mass=MASS, position=(0.0, 0.0, 2.0), more=FEET)
    text = text.replace("duration: 10 s", "duration: 60 s").replace("as_given", "rest")
    lines = hold_points(Simulation(parse_scenario(text)).run())
    (read,) = (line for line in lines if line.strip().startswith("support force"))
    forces = {
        one.split()[0]: float(one.split()[1]) for one in read.replace("support force", "").strip().split(",")
    }
    even, shift = MASS * G / 4e3, STIFFNESS * SHIM / 4e3
    assert shift > even / 2  # kN: otherwise nothing is tested
    for foot, force in (
        ("1.1", even - shift),
        ("1.2", even + shift),
        ("2.1", even + shift),
        ("2.2", even - shift),
    ):
        # In whole kN, and 0.2 % from rest when it is read.
        assert forces[f"feet.{foot}"] == pytest.approx(max(force, 0.0), abs=0.5 + 0.002 * even)
    assert any(
        line.split()[:2] == ["corner", "load"] and "nothing in this lift has one" in line for line in lines
    )


def test_the_first_page_says_what_is_taken_off() -> None:
    text = hooked_lift(HOOKS, LUGS, SLINGS, mass=MASS, position=(0.0, 0.0, 2.0), more=FEET)
    text = text.replace("duration: 10 s", "duration: 60 s").replace("as_given", "rest")
    subject = Subject(gantline.simulate(parse_scenario(text)))
    content = FirstPage().content(subject)
    steps = content["steps"]["rows"]
    assert [one["does"] for one in steps] == [
        "lower 6 m/min",
        "lower 0.6 m/min",
        "lower 6 m/min by 0.3 m",
        "take off S1, S2",
    ]
    # As planned, and not as a rope that breaks.
    assert [(one["gone"].split()[0], one["is_parted"]) for one in content["slings"]] == [("off", False)] * 2


def test_pictures_show_where_a_load_that_hangs_is_set_down() -> None:
    text = hooked_lift(HOOKS, LUGS, SLINGS, mass=MASS, position=(0.0, 0.0, 2.0), more=FEET)
    text = text.replace("duration: 10 s", "duration: 60 s").replace("as_given", "rest")
    recording = gantline.simulate(parse_scenario(text))
    names = [name for name, *_ in moments(recording)]
    assert names[0] == "start" and names[-1] == "end" and "set-down" in names
    shown = stages(recording)
    assert [name for name, *_ in shown if name.startswith("end of")] == [
        "end of 'down'",
        "end of 'set down'",
        "end of 'further'",
    ]
    assert [one.sample for one in shown] == sorted(one.sample for one in shown)
