"""Tag lines: what becomes of them in the document and on the first page, and messages on wrong ones."""

from __future__ import annotations

import pytest

import gantline
from gantline.assembly import assemble
from gantline.report.attitude import attitude
from gantline.report.subject import Subject
from gantline.scenario import ScenarioError, parse_scenario
from reference_lift import ROOT

LIFT = (ROOT / "scenarios" / "spreader_bar" / "scenario.yaml").read_text()
KIND = """ropes:
  tag: {axial_stiffness: 150 kN, damping_time: 0.2 s, mass: none, minimum_breaking_force: 30 kN}
"""
WEST = "at: [-5.5 m, -2 m, 0.2 m], to: [-5.5 m, -27 m, 0 m], rope: tag, pull: 1 kN"


def held(line: str = WEST) -> str:
    """The scenario `spreader_bar` with a tag line."""
    return LIFT.replace("ropes:\n", KIND, 1).replace("plan:\n", f"tag_lines:\n  west: {{{line}}}\nplan:\n", 1)


def test_line_on_a_tugger() -> None:
    """A rope on a flow whose motor keeps the pull, as long as under that between its ends."""
    document = assemble(parse_scenario(held())).document
    [rope] = [one for one in document["ropes"] if one["name"] == "tag.west"]
    first, last = rope["route"]
    # The centre of gravity is at (0.15, 0.05, 1.6) m of the load; what slings lump on it moves it.
    assert first["body"] == "module"
    assert first["at"] == pytest.approx([-5.65, -2.05, -1.4], abs=0.01)
    assert (last["body"], last["drum"]["flow"]) == (None, "tag.west.tugger")
    # The ends are (25² + 0.2²)^(1/2) m apart.
    assert rope["length"] == pytest.approx((25.0**2 + 0.2**2) ** 0.5 / (1.0 + 1e3 / 150e3))
    [flow] = [one for one in document["bodies"] if one["name"] == "tag.west.tugger"]
    assert (flow["joint"]["capacity"], flow["joint"]["keeps_pull"]) == (1e3, True)


def test_cut_by_the_plan_and_told() -> None:
    """The plan lets go of it by its name among ropes; the first page has its largest pull."""
    text = held().replace("step: hoist, ", "step: hoist, cut: tag.west, ")
    recording = gantline.simulate(parse_scenario(text.replace("duration: 120 s", "duration: 80 s")))
    [(time, _, _)] = [event for event in recording.events("cut") if event[2] == "tag.west"]
    tension = recording.column("rope_tension", "tag.west")
    assert tension[recording.time < time].min() > 900.0
    assert tension[recording.time > time].max() == 0.0
    rows = dict(attitude(Subject(recording)))
    assert rows["largest pull of a tag line"].startswith("west 1.00 kN at ")


@pytest.mark.parametrize(
    ("line", "message"),
    [
        (
            WEST.replace(", pull: 1 kN", ""),
            "a tag line has one of 'pull', 'length' and 'pretension'; found none",
        ),
        (f"{WEST}, length: 30 m", "one of 'pull', 'length' and 'pretension'; found 'pull' and 'length'"),
        (
            WEST.replace("pull: 1 kN", "length: 30 m, speed: 1 m/s"),
            r"speed: 'speed' is of a line whose 'pull'",
        ),
        (f"{WEST}, held_by: barge", r"held_by: 'barge' is not a vessel, a part of a crane or a body"),
        (f"{WEST}, held_by: module", "the load cannot hold its own tag line"),
        (WEST.replace("rope: tag", "rope: tug"), r"rope: 'tug' is not a name of 'ropes'; did you mean 'tag'"),
        (WEST.replace("1 kN", "30 kN"), r"pull: 30 kN are more than it holds, 30 kN; pull less"),
        (WEST.replace("pull: 1 kN", "length: 24 m"), r"length: the line is 24 m, but its ends are 25.0008 m"),
        (WEST.replace("[-5.5 m, -27 m, 0 m]", "[-5.5 m, -2 m, 0.2 m]"), r"to: is where it is made fast"),
        (f"{WEST}, winch: {{speed: 1 m/s, acceleration: 1 m/s^2}}", r"winch: a line whose 'pull' is kept"),
        (f"{WEST}, cut_at: 1000 s", r"cut_at: 1000 s is after the end of the lift"),
        (WEST.replace("1 kN", "1 kg"), r"pull: "),
        (
            WEST.replace(
                "pull: 1 kN",
                "pretension: 20 kN, winch: {speed: 1 m/s, acceleration: 1 m/s^2, capacity: 5 kN}",
            ),
            r"winch: the winch slips at 5 kN, and the line shall pull 20 kN from the start; a stronger winch",
        ),
        (
            WEST.replace("at: [-5.5 m, -2 m,", "at: [-5.5 m, -22 m,"),
            r"at: this end of the line is 20 m outside the load's box; positions are measured from its",
        ),
    ],
)
def test_wrong_ones(line: str, message: str) -> None:
    """One clear sentence each, with its line."""
    with pytest.raises(ScenarioError, match=rf":\d+: tag_lines\.west.*{message}") as caught:
        assemble(parse_scenario(held(line)))
    assert len(caught.value.problems) == 1


@pytest.mark.parametrize(
    ("old", "new", "warning"),
    [
        (
            "at: [-5.5 m, -2 m,",
            "at: [-5.5 m, -4 m,",
            "the end of tag line west on the load lies 2 m outside the load's box",
        ),
        (
            "-27 m, 0 m]",
            "-27 m, -3 m]",
            "tag line west is held 3 m under the ground: 'to' is a place in the world",
        ),
        (
            "-27 m, 0 m]",
            "-27000 m, 0 m]",
            "tag line west is 26,998 m long at the start; a unit has slipped, m for mm",
        ),
        (
            "pull: 1 kN",
            "pull: 1 kN, speed: 30 m/s",
            "tag line west is hauled in at up to 30 m/s; a unit has slipped, m/s for m/min",
        ),
        (
            "pull: 1 kN",
            "pull: 1 kN, rotating_mass: 20 t",
            "what moves with tag line west weighs 20 t; a unit has slipped, t for kg",
        ),
    ],
)
def test_doubtful_ones(old: str, new: str, warning: str) -> None:
    """What can be simulated and cannot well be meant is a warning; the module is 12 m by 4 m in plan."""
    assert assemble(parse_scenario(held())).warnings == ()
    assert assemble(parse_scenario(held(WEST.replace(old, new)))).warnings == (warning,)


def test_in_a_dock_the_floor_is_what_one_stands_on() -> None:
    """A line that is held 8 m down in a dock is held on its floor, and 9 m down under it."""
    dock = "structures: {dock: {type: dock, x: [-60 m, 0 m], y: [-60 m, -10 m], floor: -8 m}}\nplan:\n"
    for depth, told in ((8, ()), (9, ("tag line west is held 1 m under the floor of the dock",))):
        text = held(WEST.replace("-27 m, 0 m]", f"-27 m, -{depth} m]")).replace("plan:\n", dock, 1)
        said = assemble(parse_scenario(text)).warnings
        assert tuple(one.partition(": ")[0] for one in said) == told


def test_cases_cut_no_lines() -> None:
    """They say how a lift without the line is written."""
    case = "  lost: {cut: tag.west}\n  heavy:  "
    right = r"'set: \{tag_lines\.west\.cut_at: 0 s\}' is the lift without it"
    with pytest.raises(ScenarioError, match=rf":\d+: cases\.lost\.cut: 'tag\.west' is a line, .*; {right}"):
        parse_scenario(held().replace("  heavy:  ", case, 1))


def test_needs_a_load_and_no_explicit_steps() -> None:
    """Without a load there is nothing to hold; `explicit` knows no motors of limited force."""
    with pytest.raises(ScenarioError, match="there is no 'load' for tag lines to hold"):
        parse_scenario(
            "format: 1\nlift: {title: x}\nduration: 1 s\n" + KIND + f"tag_lines: {{west: {{{WEST}}}}}\n"
            "mechanics: {bodies: {b: {joint: {type: free}, mass: 1 t}}}\n"
        )
    with pytest.raises(
        ScenarioError, match="'explicit' knows no friction of sheaves and joints and no brakes"
    ):
        parse_scenario(held() + "simulation: {integrator: explicit, step: 1 ms}\n")


def test_steps_haul_lines_with_a_winch() -> None:
    """By the name of the rope or of the line; one without a winch, or on a tugger, is told."""
    made_fast = WEST.replace("pull: 1 kN", "length: as_routed")
    step = "  - {step: turn, haul: west, by: 1 m, speed: 1 m/min}\n  - {step: take up slack"
    text = held(made_fast).replace("  - {step: take up slack", step, 1)
    with pytest.raises(
        ScenarioError, match=r":\d+: step 'turn', plan\[1\]\.haul: .*'tag\.west'.* no 'winch'"
    ):
        parse_scenario(text)
    with pytest.raises(ScenarioError, match=r"haul: 'tag\.west' hauls and gives way by itself, to keep its"):
        parse_scenario(text.replace("length: as_routed", "pull: 1 kN", 1))
    fast = f"{made_fast}, winch: {{speed: 1 m/s, acceleration: 1 m/s^2, capacity: 5 kN}}"
    document = assemble(parse_scenario(text.replace(made_fast, fast))).document
    [move] = document["plan"][0]["moves"]
    assert move["drive"] == "tag.west.tugger.drive"
    far = parse_scenario(text.replace(made_fast, fast).replace("by: 1 m,", "by: 30 m,"))
    hauls = "by step 'turn' 4.999 m more are hauled in than there is of tag.west, which is 25 m long"
    assert assemble(far).warnings[0] == f"{hauls} at the start"
    assert move["velocity"] == pytest.approx(-1.0 / 60.0)  # hauling takes line in


def test_name_that_is_taken() -> None:
    """A rope of `mechanics` may not bear the name."""
    text = held() + (
        "mechanics: {ropes: {tag.west: {rope: tag, length: as_routed, "
        "route: [{type: end, body: module}, {type: end, body: world}]}}}\n"
    )
    with pytest.raises(ScenarioError, match=r"'tag\.west' is already the name of a rope of 'mechanics'"):
        parse_scenario(text)
