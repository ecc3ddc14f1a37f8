"""Texts with units, None and other slips that ended inside, and a mode that was shown as another.

`gantline.hydro.Attitude("2 m")` ended in `hydrostatics` with "can't multiply sequence by non-int of type
'numpy.float64'", `float_free(..., density="1.025 t/m^3")` with "unsupported operand type(s) for /". A density
of `hydrostatics` was taken as it came and failed where mass was asked for. `equilibrium(losses=None)` ended
with "'None' is not an instance of 'str'", `write_report(..., beside="folder")` with "'str' object has no
attribute 'cases'", `command(..., motion=[])` with "unhashable type", `run_sweep(lift, None, ...)` within
`re`, and `margins_of(..., farthest=-1.0)` said that there was a margin of −1 m.

`swing` went by the number of a mode alone: after another `modes()`, or with a mode of another lift, it showed
whatever had that number now under the words of the old one. After another equilibrium it said that there was
"no mode 0", which stands as mode 1 wherever modes are told.
"""

from __future__ import annotations

import copy
import pickle
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import gantline
from gantline import cad, hydro, study

BOX = hydro.box_hull((100.0, 30.0, 8.0))
CENTRE = (50.0, 0.0, 3.0)
NONE: Any = None
TEXT: Any = "2 m"
WATER: Any = "1.025 t/m^3"
LIST: Any = []
ONE: Any = 1
HALF: Any = 2.5


def at_rest() -> gantline.Statics:
    return gantline.Statics("pulleys")


def recorded() -> gantline.Recording:
    return gantline.simulate("pulleys", duration=0.1)


def by_adaptive() -> gantline.Simulation:
    return gantline.Simulation("pulleys", duration=0.1, integrator="adaptive")


@pytest.mark.parametrize(
    ("ask", "told"),
    [
        (lambda: hydro.hydrostatics(BOX, hydro.Attitude(TEXT)), "draft: '2 m' is no number of metres"),
        (
            lambda: hydro.hydrostatics(BOX, hydro.Attitude(2.0), WATER),
            "density: '1.025 t/m.3' is no number of",
        ),
        (lambda: hydro.float_free(BOX, 1e7, CENTRE, density=WATER), "density: '1.025 t/m.3' is no number of"),
        (lambda: hydro.float_free(BOX, 1e7, CENTRE, start=hydro.Attitude(NONE)), "draft: None is no number"),
        (lambda: hydro.righting_arms(BOX, 1e7, CENTRE, [0.1], density=WATER), "density: .* is no number of"),
        (
            lambda: hydro.righting_arms(BOX, 1e7, CENTRE, [0.1], correction=TEXT),
            "correction: '2 m' is no number",
        ),
        (lambda: hydro.Tank(TEXT, 10.0), "length: '2 m' is no number of metres"),
        (
            lambda: hydro.raked_barge((100.0, 30.0, 8.0), TEXT, 1.0),
            "barge: rake: '2 m' is no number of metres",
        ),
        (lambda: hydro.wigley_hull(10.0, 1.0, 1.0, NONE), "wigley: freeboard: None is no number of metres"),
        (lambda: cad.Assumptions(density=WATER), "density: '1.025 t/m.3' is no number of kilograms"),
        (lambda: cad.read(NONE), "a CAD file is needed, not NoneType"),
        (lambda: at_rest().equilibrium(increment=ONE), "increment: a list is needed, not int"),
        (
            lambda: recorded().column("joint_position", LIST),
            "one name along joint_position is needed, not list",
        ),
        (lambda: recorded().events(LIST), "kind: one kind of event is needed, not list"),
        (lambda: gantline.Report(recorded(), beside=TEXT), "what lies beside a recording is needed, not str"),
        (
            lambda: study.solve_ballast("floating_crane", tanks=ONE),
            "tanks: a list of names is needed, not int",
        ),
        (lambda: study.solve_ballast("floating_crane", time=TEXT), "time: '2 m' is no number of seconds"),
        (
            lambda: study.adjust_lengths("spreader_bar", shares=ONE),
            "shares: a dictionary by slings is needed",
        ),
        (
            lambda: list(study.run_sweep("pulleys", NONE, "1 t", "2 t", 2)),
            "path: a text is needed, not NoneType",
        ),
    ],
)
def test_what_is_no_number_or_name_is_told(ask: Callable[[], object], told: str) -> None:
    """Each names the argument and what it counts in."""
    with pytest.raises(TypeError, match=told):
        ask()


@pytest.mark.parametrize(
    ("ask", "told"),
    [
        (
            lambda: at_rest().equilibrium(losses=NONE),
            "losses: None is none; they are none, forward, backward or",
        ),
        (
            lambda: at_rest().equilibrium(losses=LIST),
            r"losses: \[\] is none; they are none, forward, backward",
        ),
        (lambda: at_rest().lose(LIST), r"the lift has no load \[\]"),
        (
            lambda: study.adjust_lengths("spreader_bar", slopes=(0.0, 0.0), most=-1.0),
            "most: -1 m is no change",
        ),
        (
            lambda: study.finer_simulation(by_adaptive(), recorded()),
            "recording is by del, and the simulation by adaptive",
        ),
        (lambda: hydro.wigley_hull(10.0, 1.0, 1.0, 1.0, HALF), "stations: 2.5 is no whole number from 1 on"),
        (
            lambda: hydro.Hull("skin", TEXT, [[0, 1, 2]]),
            "skin: its vertices and triangles are no mesh; vertices",
        ),
        (lambda: hydro.Hull("skin", LIST, [[0, 1, 2]]), "skin: a hull needs vertices and triangles"),
        (lambda: study.run_seas("crane_barge_in_swell", records=HALF), "records: 2.5 is no whole number"),
        (lambda: study.solve_ballast("floating_crane", vessel=ONE), "'1' is not a vessel with tanks"),
    ],
)
def test_what_is_none_of_what_there_is_is_told(ask: Callable[[], object], told: str) -> None:
    """A wrong value, not a wrong kind."""
    with pytest.raises(ValueError, match=told):
        ask()


def test_a_database_takes_lists_of_numbers() -> None:
    """Lists had no `shape`; a displacement in words went into the file that was written."""
    matrices = [[[1e6 if row == column else 0.0 for column in range(6)] for row in range(6)]] * 2
    given: dict[str, Any] = {
        "name": "barge",
        "source": "made here",
        "frequencies": [0.5, 1.0],
        "added_mass": matrices,
        "damping": matrices,
        "infinite_added_mass": matrices[0],
        "reference": [0.0, 0.0, 0.0],
    }
    made = hydro.HydrodynamicDatabase(**given)
    assert made.added_mass.shape == (2, 6, 6)
    for key, wrong, told in (
        ("frequencies", None, "what is given as its frequencies is no array of numbers"),
        ("frequencies", [[0.5, 1.0]], "its frequencies are no single row"),
        ("damping", "nothing", "what is given as its damping is no array of numbers"),
        ("displacement", "20 000 m^3", "'20 000 m.3' is no number, and its displacement is one"),
        ("density", WATER, "'1.025 t/m.3' is no number, and its density is one"),
    ):
        with pytest.raises(hydro.DatabaseError, match=told):
            hydro.HydrodynamicDatabase(**given | {key: wrong})


def test_a_verb_that_is_none_is_told() -> None:
    """As a misspelt one is."""
    with pytest.raises(gantline.CommandError, match=r"motion: \[\] is none"):
        gantline.Simulation("equalizer", duration=0.1).command("test_hook", speed=0.1, motion=LIST)


def test_margins_look_some_way() -> None:
    """No margin is below zero."""
    lift = gantline.load_scenario("equalizer")
    rest = gantline.Statics(lift).equilibrium()
    for wrong in (-1.0, 0.0):
        with pytest.raises(ValueError, match="is no way to look along; one above zero is needed"):
            study.margins_of(lift, rest, farthest=wrong)


def test_a_mode_is_shown_as_itself_or_not_at_all() -> None:
    """By what it is, not by its number: of the equilibrium before, or of another lift, it is refused."""
    lift = gantline.Statics("spreader_bar")
    old = lift.modes(4)
    lift.equilibrium(time=0.0)
    stranger = gantline.Statics("equalizer").modes(4)
    stale = "is none of those found last; ask modes.. anew after each equilibrium"
    with pytest.raises(ValueError, match=stale):
        lift.swing(old[0])
    new = lift.modes(4)
    with pytest.raises(ValueError, match=stale):
        lift.swing(stranger[3])
    # What another process sends back is the same mode.
    assert lift.swing(pickle.loads(pickle.dumps(new[3])), frames=3).sizes["time"] == 3
    for wrong, told in (
        ({"amplitude": TEXT}, "amplitude: '2 m' is no"),
        ({"frames": HALF}, "frames: 2.5 is no"),
    ):
        with pytest.raises(ValueError, match=told):
            lift.swing(new[0], **wrong)


def test_a_report_takes_no_folder_for_what_lies_beside(tmp_path: Path) -> None:
    """And says that it looks there by itself."""
    wrong: Any = str(tmp_path)
    with pytest.raises(TypeError, match="found in the folder of the report where it is not given"):
        gantline.write_report(recorded(), tmp_path / "report.html", beside=wrong)


def test_a_simulation_is_neither_copied_nor_pickled() -> None:
    """`copy` shared what ran between both; `pickle` named a type of the core."""
    one = gantline.Simulation("pulleys", duration=0.1)
    for ask in (copy.copy, copy.deepcopy, pickle.dumps):
        with pytest.raises(TypeError, match="cannot be copied or pickled; `save` gives its state"):
            ask(one)
