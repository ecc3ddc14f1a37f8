"""Words of slings that steps of the plan put on: which are on when, what they weigh, what reports say."""

from __future__ import annotations

import math

import pytest

import gantline
from gantline.assembly import assemble
from gantline.checks import check_recording
from gantline.cli.rest_table import slings_of
from gantline.cli.summary import summary
from gantline.report.first_page import FirstPage
from gantline.report.sketch import sketches
from gantline.report.subject import Subject
from gantline.results.rig import Rig
from gantline.scenario import ScenarioError, parse_scenario
from gantline.scenario.plan.slinging import first_put_on, slings_on, starts_off
from gantline.scenario.rigging import resolve
from gantline.simulation import Simulation
from gantline.study.state import State, values_of
from hooked_lift import hooked_lift
from lift_text import BASE, changed
from of_recording import checks_of

HOOKS = {"A": (-4.0, 0.0, 13.0), "B": (4.0, 0.0, 13.0)}
LUGS = {"1": (-4.0, 0.0, 4.0), "2": (4.0, 0.0, 4.0)}
SLINGS = {"S1": ("A", "1", 10.0), "S2": ("B", "2", 10.0)}
PLAN = """\
ground: {level: 0 m, stiffness: 200 MN/m, damping: 10 MN s/m, friction: 0.5}
plan:
  - {step: wait,   hold: 1 s}
  - {step: hook on, hold: 1 s, attach: [sling.S1, sling.S2]}
  - {step: up,     hoist: [A, B], speed: 0.1 m/s, until: {slings: taut}}
  - {step: down,   lower: [A, B], speed: 0.1 m/s, by: 1 m}
  - {step: let go, hold: 1 s, detach: sling.S2}
  - {step: slack,  lower: A, speed: 0.1 m/s, until: {slings: slack}}
  - {step: again,  hold: until_end, attach: sling.S2}
"""


def lift(plan: str = PLAN, old: str = "", new: str = "") -> str:
    text = hooked_lift(HOOKS, LUGS, SLINGS, more=plan).replace("start: as_given\n", "")
    text = text.replace("  lugs:", "  stands_on: ground\n  lugs:").replace("duration: 10 s", "duration: 60 s")
    assert old in text
    return text.replace(old, new) if old else text


def test_which_slings_are_on_in_which_step() -> None:
    scenario = parse_scenario(lift())
    assert starts_off(scenario) == {"S1", "S2"}
    assert first_put_on(scenario) == {"S1": 1, "S2": 1}
    both, one = {"S1", "S2"}, {"S1"}
    assert list(slings_on(scenario)) == [set(), both, both, both, one, one, both]
    assert Rig.from_json(assemble(scenario).rig).starts_off == ["sling.S1", "sling.S2"]


def test_a_sling_that_is_taken_off_first_is_on_at_the_start() -> None:
    plan = PLAN.replace(", attach: [sling.S1, sling.S2]", "").replace("duration: 10 s", "duration: 60 s")
    scenario = parse_scenario(lift(plan))
    assert starts_off(scenario) == set()
    assert [one.starts_on for one in resolve(scenario).slings.values()] == [True, True]


def test_steps_wait_for_the_slings_that_are_on() -> None:
    """Where no slings are named those count that are on in the step."""
    document = assemble(parse_scenario(lift())).document
    taut, slack = (document["plan"][place]["until"] for place in (2, 5))
    assert taut["groups"] == [["sling.S1", "sling.S2"]]
    assert slack["segments"] == [["sling.S1", 0]]
    assert document["plan"][1]["attaches"] == ["sling.S1", "sling.S2"]


def test_a_sling_hangs_with_its_weight_on_its_hook_until_it_is_put_on() -> None:
    """10 m of 30 kg/m are 300 kg: halves at the ends of a sling that is on, all at the hook of another."""
    heavy = "{kind: {axial_stiffness: 200000000.0 N, mass: 30 kg/m}}"
    text = lift(old="{kind: {axial_stiffness: 200000000.0 N}}", new=heavy)
    text = text.replace("{rope: kind}", "{rope: kind, rope_weight: lumped}")
    one = text.replace("attach: [sling.S1, sling.S2]", "attach: sling.S2")
    bodies = {body["name"]: body["mass"] for body in assemble(parse_scenario(one)).document["bodies"]}
    assert (bodies["A"], bodies["B"]) == pytest.approx((150.0, 300.0))
    assert bodies["load"] == pytest.approx(200e3 + 150.0)


def test_a_sling_may_be_too_short_as_long_as_it_is_not_on() -> None:
    """At 13 m the hook is 9 m over its lug: 8 m are too short at the start, and not after 2 m down."""
    short = lift(old="length: 10.0 m", new="length: 8.0 m")
    lowered = short.replace(
        "{step: wait,   hold: 1 s}", "{step: wait, lower: [A, B], speed: 0.1 m/s, by: 2 m}"
    )
    assemble(parse_scenario(lowered))
    with pytest.raises(ScenarioError) as caught:
        assemble(parse_scenario(short))
    # The load stands less than 3 mm deep in the ground.
    assert str(caught.value).partition("plan[2].attach: ")[2].startswith("'sling.S1' is 8 m and 1.00"), (
        caught.value
    )
    assert str(caught.value).endswith("lower the hook before, or make the sling longer")


def test_a_sling_that_cannot_reach_its_lug_is_told_so() -> None:
    """12 m aside of its lug and 10 m long: no height makes that up."""
    far = lift(old="at: [-4.0 m, 0.0 m, 13.0 m]", new="at: [-16.0 m, 0.0 m, 13.0 m]")
    with pytest.raises(ScenarioError) as caught:
        assemble(parse_scenario(far))
    distance = math.hypot(12.0, 9.0)
    assert f"to its lug it is {distance:.2f}" in str(caught.value)
    assert "12.000 m of that sideways, which no height of the hook makes up" in str(caught.value)


@pytest.mark.parametrize("ending", ["until: {slings: taut, of: sling.S1}", "by: 3 m"])
def test_nothing_is_said_of_what_only_the_run_can_know(ending: str) -> None:
    """Where a sling has been on the load may have moved; and a hook that waits for something is anywhere."""
    plan = PLAN.replace(", attach: [sling.S1, sling.S2]", ", attach: sling.S1").replace(
        "until: {slings: taut}", ending
    )
    plan = plan.replace("  - {step: let go, hold: 1 s, detach: sling.S2}\n", "")
    short = lift(plan, "S2: {from: B, to: load.2, length: 10.0 m}", "S2: {from: B, to: load.2, length: 8 m}")
    assert not [one for one in assemble(parse_scenario(short)).warnings if "S2" in one]


def test_summary_first_page_and_sketch() -> None:
    recording = gantline.simulate(parse_scenario(lift()))
    (put_on,) = {time for time, _, _ in recording.events("attached") if time < 10.0}
    assert put_on == 1.0
    lines = summary(recording, check_recording(recording), lambda verdict: f"  {verdict.value:<11}")
    rows = [line.split() for line in lines]
    assert ["Put", "on", "at"] in rows and ["sling.S1", "1.000", "s"] in rows
    subject = Subject(recording)
    content = FirstPage().content(subject)
    assert content["steps"]["rows"][1]["does"] == "put on S1, S2"
    gone = {one["name"]: (one["gone"], one["is_parted"]) for one in content["slings"]}
    again = next(time for time, _, name in recording.events("attached") if time > 10.0)
    off = recording.events("detached")[0][0]
    assert gone["S1"] == ("on 1.0 s", False)
    assert gone["S2"] == (f"on 1.0 s, off {off:.1f} s, on {again:.1f} s", False)
    assert any(mark.style == "sk-sling" for mark in sketches(subject)[0].marks)
    # Until they are on there are none to be drawn.
    first = Simulation(parse_scenario(lift()))
    early = Subject(first.run(until=0.5))
    assert not any(mark.style in ("sk-sling", "sk-lug") for mark in sketches(early)[0].marks)
    assert not checks_of(early.recording, "slings_carry")


def test_slings_that_cannot_be_put_on() -> None:
    """Those that have nodes, and those that hold other gear."""
    nodes = lift(old="{rope: kind}", new="{rope: kind, rope_weight: distributed, rope_nodes: 3}").replace(
        "200000000.0 N}}", "200000000.0 N, mass: 30 kg/m}}"
    )
    with pytest.raises(ScenarioError) as caught:
        parse_scenario(nodes)
    why = "it has nodes, and would have to lie somewhere before; 'rope_weight: lumped' is right"
    assert str(caught.value).splitlines()[0].endswith(f"plan[2].attach: 'sling.S1' cannot be put on: {why}")
    bar = "spreaders:\n  bar: {mass: 5 t, size: [8 m, 1 m, 1 m], lugs: {t: {at: [0 m, 0 m, 0.5 m]}}}\n"
    held = lift(old="to: load.1", new="to: bar.t").replace("ground:", f"{bar}ground:")
    with pytest.raises(ScenarioError) as caught:
        parse_scenario(held)
    why = "'bar' would fall without it; slings to lugs of the load can be put on"
    assert f"plan[2].attach: 'sling.S1' cannot be put on: {why}" in str(caught.value)


def test_a_moving_sheave_without_its_sling_is_told() -> None:
    """Until a sling is put on, nothing holds the sheave down."""
    one = changed(BASE, ("hold: until_end}", "hold: until_end, attach: sling.S1}"))
    whole, later = (assemble(parse_scenario(text)).warnings for text in (BASE, one))
    told = [[text for text in warnings if "no sling hangs from" in text] for warnings in (whole, later)]
    assert told[0] == [] and len(told[1]) == 1 and "moving sheave e1.1" in told[1][0]


def test_equilibria_have_the_slings_that_are_on_then() -> None:
    """After 0.5 s none is on, after 1.5 s both are; nothing is said of slings that are not there."""
    question = gantline.Statics(parse_scenario(lift()))
    early = question.equilibrium(0.5)
    assert slings_of(early, []) == []
    assert values_of(State("as given", "", "none", 0.5, early))["sling_tension"] == {}
    later = question.equilibrium(1.5)
    assert [line.split()[0] for line in slings_of(later, [])[1:]] == ["S1", "S2"]
    assert later.recording.events() == [(0.0, "attached", "sling.S1"), (0.0, "attached", "sling.S2")]


HANGING = """\
plan:
  - {step: hang, hold: 1 s}
  - {step: anew, hold: 1 s, attach: [sling.S2, sling.S1]}
"""


def hanging(length: float = 9.0, plan: str = HANGING) -> str:
    """A load that hangs on slings of this length whose ends are 9 m apart at the start."""
    slings = {name: (hook, lug, length) for name, (hook, lug, _) in SLINGS.items()}
    return hooked_lift(HOOKS, LUGS, slings, more=plan)


def test_slings_that_a_hanging_load_needs_from_the_start_are_told() -> None:
    """`attach` says that they are off before; that a load stands on nothing tells of a mistake."""
    said = "slings S1, S2 are off until 'anew' puts them on; the load stands on nothing at the start"
    (warning,) = assemble(parse_scenario(hanging())).warnings
    assert warning.startswith(said) and warning.endswith("on from the start needs no 'attach'")
    # 9 m and 2 % more: as rough as positions may be. What is longer is put on slack.
    assert assemble(parse_scenario(hanging(9.18))).warnings
    assert not assemble(parse_scenario(hanging(9.2))).warnings
    one = hanging().replace("[sling.S2, sling.S1]", "sling.S2")
    assert assemble(parse_scenario(one)).warnings[0].startswith("sling S2 is off until 'anew' puts it on; ")
    # A load that stands is hooked on, taut or not.
    standing = lift(old="length: 10.0 m", new="length: 9.0 m")
    assert not [text for text in assemble(parse_scenario(standing)).warnings if "is off until" in text]


def test_a_load_that_falls_until_its_slings_are_put_on() -> None:
    with pytest.raises(ScenarioError) as caught:
        Simulation(parse_scenario(hanging().replace("start: as_given\n", "")))
    cause = "it cannot start at rest: nothing holds it, it falls without end"
    assert str(caught.value).endswith(f"load: {cause}; S1, S2 are off until 'attach' of the plan")


@pytest.mark.parametrize(
    ("step", "message"),
    [
        (
            "{step: part, hold: 1 s, cut: sling.S1}",
            "sling.S1 has 'cut_at: 1 s', and step 'part' cuts it: the earlier counts",
        ),
        (
            "{step: off, hold: 1 s, detach: sling.S1}\n  - {step: on, hold: 1 s, attach: sling.S1}",
            "sling.S1 has 'cut_at: 1 s', before step 'on' puts it on: it stays cut, and is not put on",
        ),
    ],
)
def test_a_time_of_a_cut_beside_what_steps_do(step: str, message: str) -> None:
    """A case may cut at any time, so these are no mistakes of the file as such."""
    cut = hanging(plan=f"plan:\n  - {{step: hang, hold: 1 s}}\n  - {step}\n").replace(
        "load.1, length: 9.0 m", "load.1, length: 9.0 m, cut_at: 1 s"
    )
    assert assemble(parse_scenario(cut)).warnings == (message,)


def test_waits_leave_out_slings_that_have_been_cut() -> None:
    """A sling that a step has cut is never taut again."""
    plan = HANGING.replace("attach: [sling.S2, sling.S1]", "cut: sling.S2")
    plan += "  - {step: wait, hold: until_met, until: {slings: taut}}\n"
    document = assemble(parse_scenario(hanging(plan=plan))).document
    assert document["plan"][2]["until"]["groups"] == [["sling.S1"]]


def test_a_moving_sheave_carries_one_sling_over_the_whole_plan() -> None:
    """Taking one off and putting another on is no way round it: what is right is said."""
    text = changed(
        BASE,
        (
            "  S2: {from: e1.2",
            "  S3: {from: e1.1, to: block.L3, length: 13 m, rope: sling}\n  S2: {from: e1.2",
        ),
        ("hold: until_end}", "hold: until_end, detach: sling.S1, attach: sling.S3}"),
    )
    with pytest.raises(
        ScenarioError, match=r"'e1\.1' already carries .* one that a step puts on may hang from"
    ):
        parse_scenario(text)
