"""Hinges of loads: what becomes of them in recordings, checks and tables, and messages on wrong ones."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from gantline.assembly import assemble
from gantline.checks import Verdict, check_recording
from gantline.report.attitude import attitude
from gantline.report.subject import Subject
from gantline.results.loads.hinge_peaks import in_words
from gantline.results.loads.hinges import is_shut
from gantline.results.recording import Recording, open_recording
from gantline.scenario import ScenarioError, parse_scenario
from gantline.simulation import Simulation, simulate
from gantline.statics import Statics
from gantline.study.lost_load import lose_load
from hinged_mast import FOOT, HEAD, MAST, RAISE, WEIGHT, mast
from reference_lift import ROOT

#: A hook over the lug as the mast lies: it bears W a/b, the foot the rest.
OVER = (19.0, 0.0, 60.0)
BY_FOOT = WEIGHT * (1.0 - FOOT / HEAD)
HOLD = "  - {step: hold, hold: 20 s, report: [hinge_force]}\n"
OPEN = HOLD + "  - {step: let go, hold: 5 s, open_hinges: foot}\n"


def short(plan: str, **rest: str) -> str:
    """The mast as it lies under its hook."""
    more = rest.pop("more", "simulation: {sample_interval: 0.1 s}")
    return mast(plan, hook=OVER, more=more, **rest).replace("900 s", "24 s")


@pytest.fixture(scope="module")
def run() -> Recording:
    return simulate(parse_scenario(short(OPEN, hinge=", rated_capacity: 60 t")))


def test_a_recording_has_the_hinge_and_none_of_its_pins(run: Recording) -> None:
    """Five pins hold it in the core; people see one hinge with three forces, a moment and an angle."""
    assert list(run.coordinates["hinge"]) == ["foot"]
    assert "pin" not in run.coordinates and "pin_force" not in run
    assert list(run.coordinates["joint"]) == ["main", "foot"]
    push = run.column("hinge_push", "foot")
    assert run.column("hinge_force", "foot") == pytest.approx(np.linalg.norm(push, axis=1))
    assert push[100] == pytest.approx([0.0, 0.0, -BY_FOOT], abs=1e-8 * WEIGHT)
    transferred = run.column("load_transferred", "mast")
    assert transferred[100] == pytest.approx(FOOT / HEAD, rel=1e-9)
    (hinge,) = run.rig.hinges
    shut = is_shut(run, hinge)
    assert run.time[shut][-1] == 20.0 and not push[~shut].any()
    assert [(time, name) for time, _, name in run.events("hinge_opened")] == [(20.0, "foot")]


def test_a_recording_is_read_as_it_was_written(run: Recording, tmp_path: Path) -> None:
    run.save(tmp_path / "run.nc")
    again = open_recording(tmp_path / "run.nc")
    assert again.rig.hinges == run.rig.hinges
    assert (again["hinge_push"].values == run["hinge_push"].values).all()


def test_one_moment_has_what_a_recording_has() -> None:
    simulation = Simulation(parse_scenario(short(HOLD)))
    simulation.advance_to(1.0)
    assert simulation.now("hinge_force", "foot") == pytest.approx(BY_FOOT, rel=1e-9)
    assert simulation.now("load_transferred", "mast") == pytest.approx(FOOT / HEAD, rel=1e-9)


def test_its_force_is_held_against_its_capacity(run: Recording) -> None:
    """528 kN of 60 t; raised by the contingency where calculated weight is simulated."""
    (check,) = (one for one in check_recording(run) if one.name == "hinge_force_of_rated_capacity")
    largest = run.metrics()["peak_hinge_force.foot"]
    assert check.verdict is Verdict.OK and check.value == pytest.approx(largest / (60e3 * 9.81))
    assert largest == pytest.approx(BY_FOOT, rel=1e-9)
    text = short(HOLD, hinge=", rated_capacity: 60 t").replace(
        f"{MAST} kg}}", f"{MAST} kg, contingency: 1.3}}"
    )
    (raised,) = (
        one
        for one in check_recording(simulate(parse_scenario(text)))
        if one.name == "hinge_force_of_rated_capacity"
    )
    assert raised.verdict is Verdict.FAILED
    assert raised.value == pytest.approx(1.3 * largest / (60e3 * 9.81), rel=1e-6)


def test_the_first_page_has_what_it_bears(run: Recording) -> None:
    """W (1 - a/b) of the 60 t that it is rated for."""
    facts = dict(attitude(Subject(run)))
    force = float(run.column("hinge_force", "foot").max())
    assert force == pytest.approx(BY_FOOT, rel=1e-6)
    shown = facts["largest force in foot"]
    assert shown.startswith(f"{force / 1e3:.1f} kN at ")
    assert shown.endswith(f", {100.0 * force / (60e3 * 9.81):.0f} % of rated")


def test_a_hinge_that_bears_is_not_opened(run: Recording) -> None:
    """W (1 - 18/39) = 528.2 kN fall at once: failed, with what it bore and what would be right."""
    (check,) = (one for one in check_recording(run) if one.name == "hinge_opens_unloaded")
    assert check.verdict is Verdict.FAILED and check.time == 20.0
    assert check.remark.startswith("it bore 528.2 kN, 53.8 % of what mast weighs; bring its hook over it")
    words = dict(in_words(run, run.rig.hinges[0]))
    assert words["opened"] == "at 20.00 s; it bore 528.2 kN"


def test_upright_under_its_hook_it_opens_unloaded() -> None:
    """The hook takes the weight before: 564 kN are missing, on a sling of 97 m that has 2.06 MN/m, 0.28 m."""
    plan = """\
  - {step: raise, hoist: main, speed: 6 m/min, until: {load_tilt: {above: 80 deg}}}
  - {step: slow, hoist: main, speed: 0.5 m/min, acceleration: 1 mm/s^2, until: {load_tilt: {above: 89 deg}}}
  - {step: settle, hold: 60 s, require: {load_tilt: above 87 deg}}
  - {step: take, hoist: main, speed: 0.1 m/min, acceleration: 1 mm/s^2, by: 285 mm}
  - {step: hold, hold: 60 s}
  - {step: let go, hold: until_end, open_hinges: foot}
"""
    text = mast(plan).replace("900 s", "950 s").replace("5 GN", "200 MN")
    run = simulate(parse_scenario(text))
    (check,) = (one for one in check_recording(run) if one.name == "hinge_opens_unloaded")
    assert check.verdict is Verdict.OK
    assert run.column("load_transferred", "mast")[-1] == 1.0
    assert run.column("load_tilt", "mast")[-1] == pytest.approx(math.radians(90.0), abs=math.radians(4.0))


def test_no_verdict_on_a_load_that_a_hinge_keeps_upright() -> None:
    """Its lug may be below its centre of gravity: what the hinge keeps from turning over is not told so."""
    recording = Statics(parse_scenario(mast(RAISE))).equilibrium(0.0).recording
    names = {check.name for check in check_recording(recording)}
    assert "hangs_stably" not in names
    tilt = next(one for one in check_recording(recording) if one.name == "load_tilt")
    assert tilt.verdict is not Verdict.WARNING


def test_a_hook_may_be_weaker_than_its_load_while_a_hinge_bears_the_rest() -> None:
    """60 t for a head that weighs 47 t of 100 t; a hinge that opens leaves all of it to the hook.

    Nor is such a hook told that it stands beside the centre of gravity of what it lifts off.
    """

    def told(plan: str) -> list[str]:
        text = short(plan).replace("type: fixed_hook,", "type: fixed_hook, rated_capacity: 60 t,")
        stands = "supports: {head: {under: mast, grid: {x: [15 m], y: [-0.5 m, 0.5 m]}, height: 10 m, "
        stands += "stiffness: 200 MN/m, damping: 2 MN s/m, friction: 0.3}}\nplan:\n"
        text = text.replace("plan:\n", stands, 1).replace("  weight:", "  stands_on: head\n  weight:", 1)
        return [one for one in assemble(parse_scenario(text)).warnings if "mast" in one or "weighs" in one]

    lift = "  - {step: lift, hoist: main, speed: 1 m/min, until: {supports: clear}}\n"
    assert told(lift) == []
    assert told(lift + OPEN) == ["the load weighs 100 t, and what its slings hang from may carry 60 t in all"]


def test_a_load_in_a_hinge_is_not_lost() -> None:
    text = (
        mast(RAISE, hinge=", held_by: barge")
        + """
vessels:
  barge:
    draft: 4 m
    position: [-60 m, 0 m]
    hull: {box: [100 m, 30 m, 8 m]}
    masses: {hull: {mass: 12000 t, at: [50 m, 0 m, 5 m]}}
    radii_of_gyration: [11 m, 27 m, 27 m]
"""
    )
    question = Statics(parse_scenario(text))
    with pytest.raises(ValueError, match="hinge 'foot' holds 'mast', which stays in it; --time says when"):
        lose_load(question, question.equilibrium(0.0), "mast")


def test_a_hinge_is_where_its_load_has_it() -> None:
    """`to` may be 20 mm off; the hinge then stands where the load has its place for it."""
    near = assemble(parse_scenario(mast(RAISE, hinge=", to: [-20 m, 0.01 m, 11 m]"))).document
    alone = assemble(parse_scenario(mast(RAISE))).document
    assert near == alone


HINGE = "hinges: {foot: {at: [-20 m, 0 m, 1 m], axis: [0, 1, 0]}}"


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (
            "axis: [0, 1, 0]",
            "axis: [0, 1, 0], to: [-21 m, 0 m, 11.2 m]",
            "hinges.foot.to: the load has its place for it at (-20, 0, 11) m in the world at the start, 1.02 "
            "m off; it fits with the load's 'position' at (-1, 0, 10.2) m",
        ),
        (
            "axis: [0, 1, 0]",
            "axis: [0, 0, 0]",
            "hinges.foot.axis: found [0, 0, 0], which points nowhere; [0, 1, 0] is across the load",
        ),
        (
            "axis: [0, 1, 0]",
            "axis: [0, 1, 0], held_by: barge",
            "hinges.foot.held_by: 'barge' is not a vessel or a part of a crane; leave it out for a hinge in "
            "the yard",
        ),
        (
            HINGE,
            HINGE[:-1] + ", head: {at: [19 m, 0 m, 1 m], axis: [0, 1, 0]}}",
            "hinges.head: 'foot' holds the load already, and a load turns in one hinge; two in one line are "
            "one, 'at' in the middle of both",
        ),
        (
            "axis: [0, 1, 0]",
            "axis: [0, 1, 0], friction: 10 kN m",
            "hinges.foot.friction: 'foot' has friction, and a step opens it: the load would feel it when it "
            "hangs free; leave 'friction' out, or 'open_hinges'",
        ),
        (
            "open_hinges: foot",
            "open_hinges: fot",
            "plan[2].open_hinges: 'fot' is not a hinge; did you mean 'foot'",
        ),
        (
            "hold: 20 s,",
            "hold: 20 s, open_hinges: foot,",
            "plan[2].open_hinges: step 'hold' has opened 'foot' already; a hinge opens once",
        ),
        (
            "hold: 20 s,",
            "hold: until_met, until: {load_transferred: 50 %},",
            "plan[1].until.load_transferred: a hinge bears a part of the load, which no step can wait for; "
            "wait for 'supports: clear', 'load_tilt' or 'hoist_load'",
        ),
        (
            "start: rest",
            "start: settled",
            "start: 'settled' is for a load that lies free, and a hinge holds this one; 'start: rest' is "
            "right",
        ),
        (
            "{sample_interval: 0.1 s}",
            "{integrator: explicit, step: 1 ms}",
            "simulation.integrator: 'explicit' knows no hinges of loads; 'adaptive' or 'del' is right",
        ),
        (
            "foot: {at",
            "main: {at",
            "hinges.main: 'main' is already the name of a crane; a hinge needs another name",
        ),
        ("axis: [0, 1, 0]", "axis: y", "hinges.foot.axis: "),
        ("at: [-20 m, 0 m, 1 m], axis", "axis", "hinges.foot: 'at' is missing; a hinge needs it"),
    ],
)
def test_messages(old: str, new: str, message: str) -> None:
    text = short(OPEN)
    assert old in text
    with pytest.raises(ScenarioError) as caught:
        assemble(parse_scenario(text.replace(old, new, 1), "lift.yaml"))
    assert message in str(caught.value)
    assert "Traceback" not in str(caught.value)


def test_nothing_is_followed_while_a_hinge_holds_the_load() -> None:
    """As while a foot stands: the way to where falls come plumb is not that of the hook beside."""
    text = (ROOT / "scenarios" / "upending" / "scenario.yaml").read_text(encoding="utf-8")
    hinged = text.replace("plan:\n", "hinges: {foot: {at: [16 m, 0 m, 1.8 m], axis: [0, 1, 0]}}\nplan:\n", 1)
    message = "hinge 'foot' holds the load, and falls askew; nothing is followed: 'to' or 'by' gives the way"
    with pytest.raises(ScenarioError, match=message):
        parse_scenario(hinged)


def test_a_hinge_without_a_load() -> None:
    text = f"""
format: 1
lift: {{title: Nothing}}
duration: 1 s
{HINGE}
mechanics: {{bodies: {{b: {{joint: {{type: fixed}}, mass: 1 kg}}}}}}
"""
    with pytest.raises(ScenarioError, match="there is no 'load' for a hinge to hold"):
        parse_scenario(text)


def test_a_part_of_a_load_can_be_waited_for_once_the_hinge_is_open() -> None:
    plan = OPEN + "  - {step: up, hoist: main, speed: 1 m/min, until: {load_transferred: 50 %}}\n"
    text = short(plan).replace("ropes:", "ground: {level: 0 m, friction: 0.4}\nropes:", 1)
    last = parse_scenario(text).plan[-1]
    assert last.until is not None and last.until.load_transferred == 0.5
