"""Holes of tanks in a lift file: what is refused, what is doubted, what is told of them."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from ballasted import barge
from ballasted import lift as afloat
from ballasted import tank as tank_afloat
from gantline.assembly import assemble
from gantline.report.afloat import afloat_facts
from gantline.report.subject import Subject
from gantline.results.afloat.tanks import ran_through_holes
from gantline.results.rig import Rig
from gantline.scenario import ScenarioError
from gantline.scenario.afloat.tanks import contents_along
from gantline.simulation import Simulation
from gantline.statics import Statics
from gantline.study.ballast_question import QuestionError, tanks_that_may_change
from tanked_load import hold, lift, pump, tank


def holed(content: float = 24.0, **changes: Any) -> dict[str, Any]:
    """Tanks of a load of which one has a hole in its bottom, with so much in it [t]."""
    hole = {"at": ["0 m", "0 m", "0.5 m"], "area": "0.05 m^2", **changes}
    return {"inside": tank((0, 0, 0.5), content, holes={"valve": hole})}


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"discharge": 1.2}, "passes no hole; it is above 0 and at most 1: 0.6 of sharp edges"),
        ({"discharge": 0}, "a share of 0 of the ideal flow passes no hole"),
        ({"area": "17 m^2"}, "a hole of 17 m^2 has no room in a tank whose largest side has 16 m^2"),
        ({"at": ["0 m", "0 m", "0.4 m"]}, "it is at 0.4 m along z, its tank from 0.5 m to 3.5 m"),
        ({"at": ["3 m", "0 m", "1 m"]}, "it is at 3 m along x, its tank from -2 m to 2 m"),
        ({"area": "0.05"}, "area"),
    ],
)
def test_a_hole_that_cannot_be(changes: dict[str, Any], said: str) -> None:
    with pytest.raises(ScenarioError) as caught:
        lift(holed(**changes))
    assert said in str(caught.value)
    assert "load.tanks.inside.holes.valve" in str(caught.value)


def test_a_tank_with_holes_is_not_pumped() -> None:
    with pytest.raises(ScenarioError, match=r"'module\.inside' has holes, through which it drains or floods"):
        lift(holed(), [pump("drain", ("module.inside", "sea"), "100 t/h", by="1 t")])


def test_nobody_knows_what_is_in_it_after_the_start() -> None:
    along = contents_along(lift(holed(), [hold("wait"), hold("more")]))
    bounds = [(one["module.inside"].least, one["module.inside"].most) for one in along]
    assert bounds[0] == (24e3, 24e3)
    assert bounds[1] == bounds[2] == pytest.approx((0.0, 4 * 4 * 3 * 1025.0))
    share = {"step": "up", "hoist": "crane", "speed": "1 m/min", "until": {"load_transferred": "50 %"}}
    ground = {"level": "10 m", "friction": 0.5, "stiffness": "200 MN/m", "damping": "2 MN s/m"}
    with pytest.raises(ScenarioError) as caught:
        lift(holed(), [share], ground=ground, load={"stands_on": "ground", "tanks": holed()})
    assert "this waits for a share of a weight that changes: from 0 t to 49.2 t may be in" in str(
        caught.value
    )
    assert str(caught.value).endswith("wait for 'supports' or 'hoist_load'")


def opened(**keys: str) -> dict[str, Any]:
    """A step that opens or closes holes."""
    return {"step": " ".join(keys), "hold": "5 s", **keys}


@pytest.mark.parametrize(
    ("closed", "plan", "said"),
    [
        (True, [opened(open_holes="vlave")], "plan[1].open_holes: 'vlave' is not a hole of a tank, or"),
        (False, [opened(open_holes="valve")], "open already: it is from the start on; 'closed: true' has it"),
        (True, [opened(close_holes="valve")], "'valve' is closed already: it begins so"),
        (
            True,
            [opened(open_holes="valve"), {**opened(open_holes="module.inside.valve"), "step": "again"}],
            "plan[2].open_holes: 'module.inside.valve' is open already: step 'open_holes' has left it so",
        ),
        (
            True,
            [opened(open_holes="valve", close_holes="valve")],
            "plan[1].close_holes: 'valve' is opened and closed, or named twice, by one step; a step for each",
        ),
    ],
)
def test_a_hole_that_is_turned_for_nothing(closed: bool, plan: list[dict[str, Any]], said: str) -> None:
    with pytest.raises(ScenarioError) as caught:
        lift(holed(closed=closed), plan)
    assert said in str(caught.value)


def test_holes_are_opened_where_there_are_none() -> None:
    with pytest.raises(ScenarioError, match="no tank of this lift has 'holes'"):
        lift({"inside": tank((0, 0, 0.5), 24.0)}, [opened(open_holes="valve")])


def test_a_closed_tank_keeps_its_content_until_a_step_opens_it() -> None:
    """Only from then on may anything be in it; it keeps that open question when it is closed again."""
    plan = [hold("sealed"), opened(open_holes="valve"), opened(close_holes="valve")]
    along = [one["module.inside"] for one in contents_along(lift(holed(closed=True), plan))]
    bounds = [(one.least, one.most) for one in along]
    assert bounds[:2] == [(24e3, 24e3)] * 2
    assert bounds[2] == bounds[3] == pytest.approx((0.0, 4 * 4 * 3 * 1025.0))


def test_what_the_core_is_told() -> None:
    plan = [hold("sealed"), opened(open_holes="valve"), opened(close_holes="valve")]
    [force] = [one for one in assemble(lift(holed(closed=True), plan)).document["forces"] if "pumped" in one]
    [told] = force["pumped"]["holes"]
    assert (told["closed"], told["turns"]) == (True, [(1, True), (2, False)])


def test_a_closed_hole_that_nothing_opens_is_doubted() -> None:
    told = "the hole valve of module.inside is closed, and no step opens it: it lets nothing pass"
    assert told in warnings(lift(holed(closed=True), [hold("wait")]))
    opens = lift(holed(closed=True), [hold("wait"), opened(open_holes="valve")])
    assert not any("lets nothing pass" in one for one in warnings(opens))


def test_what_is_doubted() -> None:
    """Water that floods a load and does not carry it, and waves that run past."""
    scenario = lift(holed(), water={"level": "0 m"})
    assert any("carries nothing of module: give the load 'in_water'" in one for one in warnings(scenario))
    assert not any("holes" in one for one in warnings(lift(holed())))


def warnings(scenario: Any) -> list[str]:
    """What a lift is warned of as it is assembled."""
    return list(assemble(scenario).warnings)


def test_what_a_run_tells() -> None:
    """Still running at the end: a warning; done: from when on, in the report."""
    short = Simulation(lift(holed(), duration="120 s")).run()
    assert any("still runs through the holes of module.inside" in one for one in short.attributes["warnings"])
    assert "still runs" in dict(afloat_facts(Subject(short)))["holes of module.inside"]
    whole = Simulation(lift(holed())).run()
    assert not any("holes" in one for one in whole.attributes["warnings"])
    assert "24.0 t in it at the start" in dict(afloat_facts(Subject(whole)))["holes of module.inside"]


def test_from_when_on_it_has_what_is_in_it_in_the_end() -> None:
    rig = Rig.from_json(
        {"gravity": 9.81, "tanks": [{"name": "a", "capacity": 1e3, "holes": ["h"]}, {"name": "b"}]}
    )
    content = np.array([500.0, 300.0, 100.5, 100.0, 100.0])
    (ran,) = ran_through_holes(rig, np.arange(5.0), {"a": content, "b": np.zeros(5)})
    assert (ran.first, ran.last, ran.until, ran.goes_on) == (500.0, 100.0, 2.0, False)


def test_equilibria_say_that_nothing_runs() -> None:
    rest = Statics(lift(holed())).equilibrium(10.0).recording
    said = "nothing runs through the holes of module.inside in equilibria"
    assert any(said in one for one in rest.attributes["warnings"])
    assert rest.column("tank_content", "module.inside")[-1] == 24e3


def test_ballast_leaves_tanks_with_holes_as_they_are() -> None:
    room = tank_afloat((50, 0, 0), 0.0)
    room["holes"] = {"gash": {"at": ["50 m", "0 m", "0 m"], "area": "1 m^2"}}
    both = afloat(barge({"room": room, "aft": tank_afloat((15, 0, 1), 0.0)}))
    assert tanks_that_may_change(both, "barge", None) == ["aft"]
    with pytest.raises(QuestionError, match=r"barge.room has holes, so that its content does not stay"):
        tanks_that_may_change(both, "barge", ["room"])
    with pytest.raises(QuestionError, match="all tanks of barge have holes"):
        tanks_that_may_change(afloat(barge({"room": room})), "barge", None)
