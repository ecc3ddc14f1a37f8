"""Landing guides: what becomes of them in document, table and report, and messages on wrong ones."""

from __future__ import annotations

import numpy as np
import pytest

import gantline
from gantline.assembly import assemble
from gantline.checks import check_recording
from gantline.cli.guides_table import guides_table
from gantline.report.attitude import attitude
from gantline.report.subject import Subject
from gantline.results.loads.guides import Guide, guide_state
from gantline.scenario import ScenarioError, parse_scenario
from guided_lift import guided_lift

CONE = "cone: {length: 0.5 m, tip_diameter: 0.2 m}"
POST = f"post: {{at: [3.5 m, 0.1 m, 0 m], diameter: 0.4 m, height: 1 m, {CONE}}}"
FRAME = (
    "frame: {at: [3.5 m, 0 m, 0 m], clearance: 30 mm, height: 0.6 m, flare: {length: 0.4 m, angle: 30 deg}}"
)
RAISED, LOWERED = (POST.replace("3.5 m, 0.1 m, 0 m", f"3.5 m, 0.1 m, {z} m") for z in (0.2, -0.1))
SLOPE = "slope: {length: 0.6 m, angle: 20 deg}"
WALL = f"wall: {{at: [0 m, -2 m, 0 m], faces: 90 deg, breadth: 2 m, height: 1 m, {SLOPE}}}"
BUMPER = "bumper: {at: [0 m, -1.7 m, 0 m], diameter: 0.4 m}"


def lift(*guides: str, height: float = 2.0) -> str:
    """The load, clear of its guides if not said otherwise, with guides called g1, g2, ..."""
    lines = "".join(f"  g{n}: {{{given}}}\n" for n, given in enumerate(guides, start=1))
    return guided_lift(lines, height=height)


def test_a_post_and_a_frame() -> None:
    """A wall for each side, its knee clear of the post, as broad as the flares reach."""
    document = assemble(parse_scenario(lift(f"{POST}, {FRAME}, friction: 0.2"))).document
    sides = {one["name"]: one for one in document["landings"]}
    assert list(sides) == [f"guide.g1.{side}" for side in ("fore", "aft", "port", "starboard")]
    fore = sides["guide.g1.fore"]
    assert fore["post"]["base"] == [3.5, 0.1, 0.0]
    assert (fore["post"]["radius"], fore["post"]["cone"], fore["post"]["tip_radius"]) == (0.2, 0.5, 0.1)
    # The centre of gravity is 1 m over the underside.
    assert fore["wall"]["knee"] == pytest.approx([3.5 + 0.2 + 0.03, 0.0, -1.0])
    assert fore["wall"]["normal"] == pytest.approx([-1.0, 0.0, 0.0])
    assert fore["wall"]["breadth"] == pytest.approx(2 * (0.23 + 0.4 * 0.5))
    assert fore["damping_time"] == pytest.approx(0.01)


def test_a_wall_and_a_bumper() -> None:
    """The wall stands upside down, its knee on top; the bumper is a post that points down."""
    [pair] = assemble(parse_scenario(lift(f"{WALL}, {BUMPER}, friction: 0.2"))).document["landings"]
    assert pair["wall"]["knee"] == pytest.approx([0.0, -2.0, 1.0])
    assert pair["wall"]["normal"] == pytest.approx([0.0, 1.0, 0.0])
    assert pair["wall"]["up"] == [0.0, 0.0, -1.0]
    assert pair["post"]["base"] == pytest.approx([0.0, -1.7, -0.5])
    assert pair["post"]["axis"] == [0.0, 0.0, -1.0]


def test_what_check_shows() -> None:
    """Where posts stand in frames at the start, and what these catch: 0.03 + 0.4 sin 30° + 0.2 − 0.1 m."""
    assembly = assemble(
        parse_scenario(lift(f"{POST}, {FRAME}, friction: 0.2", f"{WALL}, {BUMPER}, friction: 0.2"))
    )
    _, post, wall = guides_table(assembly.guide_fits, 140)
    assert "g1" in post and "0.000 m fore, 0.100 m port" in post and "0.330 m" in post
    # 0.3 m from the wall less half of the bumper; the slope runs 0.6 sin 20° m.
    assert "before the face of the wall" in wall and "0.100 m" in wall and "0.205 m" in wall
    assert assembly.warnings == ()


@pytest.mark.parametrize(
    ("old", "new", "warning"),
    [
        (
            "0.1 m, 0 m], dia",
            "0.5 m, 0 m], dia",
            "its post is 0.50 m to port of the middle of its frame, which catches it up to 0.33 m",
        ),
        ("0.1 m, 0 m], dia", "0.5 m, 0 m], dia", "it would stand on the rim, the tip of the post"),
        ("0.1 m, 0 m], dia", "0.9 m, 0 m], dia", "it would come down beside it"),
        (
            "angle: 30 deg",
            "angle: 79 deg",
            "guide g1 leans by 79 deg from upright: with friction 0.2 a load stays on it",
        ),
    ],
)
def test_doubts(old: str, new: str, warning: str) -> None:
    """Loads that miss, and faces that hold them."""
    text = lift(f"{POST}, {FRAME}, friction: 0.2")
    assert assemble(parse_scenario(text)).warnings == ()
    assert any(warning in one for one in assemble(parse_scenario(text.replace(old, new))).warnings)


def test_a_bumper_that_comes_down_behind_its_wall() -> None:
    """Told with how far behind."""
    text = lift(f"{WALL}, {BUMPER}, friction: 0.2").replace("[0 m, -1.7 m, 0 m]", "[0 m, -2.2 m, 0 m]")
    [warning] = assemble(parse_scenario(text)).warnings
    assert (
        "its bumper comes down 0.40 m behind the face of its wall, which catches it up to 0.21 m" in warning
    )


def test_a_bumper_that_comes_down_beside_the_ends_of_its_wall() -> None:
    """Told where its whole round passes the end: half the breadth and its radius, 1.2 m aside."""
    text = lift(f"{WALL}, {BUMPER}, friction: 0.2")
    assert assemble(parse_scenario(text.replace("at: [0 m, -1.7 m", "at: [1.19 m, -1.7 m"))).warnings == ()
    [warning] = assemble(parse_scenario(text.replace("at: [0 m, -1.7 m", "at: [1.21 m, -1.7 m"))).warnings
    assert "its bumper comes down 1.21 m aside of the middle of its wall, which is 2.00 m broad" in warning
    assert "it would come down beside it" in warning


def test_a_plate_that_passes_beside_its_post() -> None:
    """A frame of one side has nothing across: 0.43 m of half its breadth and 0.2 m of the post catch."""
    text = lift(f"{POST}, {FRAME}, friction: 0.2").replace("clearance", "sides: fore, clearance")
    assert assemble(parse_scenario(text.replace("0.1 m, 0 m], dia", "0.62 m, 0 m], dia"))).warnings == ()
    [warning] = assemble(parse_scenario(text.replace("0.1 m, 0 m], dia", "0.64 m, 0 m], dia"))).warnings
    assert "its post is 0.64 m aside of the middle of its frame, whose sides are 0.86 m broad" in warning


@pytest.mark.parametrize(
    ("given", "told"),
    [
        # Knee and shoulder are 1 m up: the post, 0.1 m to port, is 0.1 m less 30 mm of clearance in the side.
        (
            POST.replace("3.5 m, 0.1 m, 0 m", "3.5 m, 0.1 m, 0.2 m") + f", {FRAME}",
            "post of guide g1 is 0.070 m",
        ),
        # 0.1 m of 0.5 m up the cone it has narrowed by 20 mm, which leaves 50 mm.
        (
            POST.replace("3.5 m, 0.1 m, 0 m", "3.5 m, 0.1 m, -0.1 m") + f", {FRAME}",
            "post of guide g1 is 0.050 m",
        ),
        # The bumper's foot is at the knee: 0.2 m of it and 50 mm from the wall.
        (f"{WALL}, {BUMPER}".replace("-1.7 m", "-1.85 m"), "bumper of guide g1 is 0.050 m inside its wall"),
    ],
)
def test_guides_that_are_in_each_other_as_the_lift_begins(given: str, told: str) -> None:
    """A force of their depth at once would throw the load aside, and nothing else said so."""
    [warning] = assemble(parse_scenario(lift(f"{given}, friction: 0.2", height=1.0))).warnings
    assert told in warning and "as the lift begins, which throws the load aside" in warning


@pytest.mark.parametrize(
    ("given", "message"),
    [
        (
            f"{POST}, friction: 0.2",
            r"g1: a guide has 'post' and 'frame', or 'wall' and 'bumper'; found 'post'",
        ),
        (f"{POST}, {BUMPER}, friction: 0.2", r"found 'post' and 'bumper'"),
        (f"{POST}, {FRAME}", r"g1: 'friction' is missing"),
        (
            f"{POST}, {FRAME}, friction: 0.2".replace("tip_diameter: 0.2 m", "tip_diameter: 0.4 m"),
            r"post\.cone: the tip, 0.4 m, is not thinner than the post, 0.4 m",
        ),
        (
            f"{POST}, {FRAME}, friction: 0.2".replace("30 deg", "85 deg"),
            r"frame\.flare\.angle: a slope of 85 deg from upright guides nothing; less than 80 deg is right",
        ),
        (
            f"{POST}, {FRAME}, friction: 0.2".replace("clearance", "sides: [fore, fore], clearance"),
            r"frame\.sides: a frame has one to four sides, each once: fore, aft, port, starboard",
        ),
        (
            f"{POST}, {FRAME}, friction: 0.2".replace("clearance", "sides: [left], clearance"),
            r"frame\.sides: .*found 'left'",
        ),
        (
            f"{POST}, {FRAME}, friction: 0.2".replace("at: [3.5 m, 0 m", "at: [35 m, 0 m"),
            r"frame\.at: this part of the guide is 32 m outside the load's box",
        ),
    ],
)
def test_wrong_ones(given: str, message: str) -> None:
    """One clear sentence each, with its line."""
    with pytest.raises(ScenarioError, match=rf":\d+: guides\..*{message}") as caught:
        assemble(parse_scenario(lift(given)))
    assert len(caught.value.problems) == 1


def test_guides_want_a_load_and_a_method_that_knows_them() -> None:
    """Both told."""
    text = lift(f"{POST}, {FRAME}, friction: 0.2") + "simulation: {integrator: explicit, step: 1 ms}\n"
    with pytest.raises(ScenarioError, match="'explicit' knows no guides; 'adaptive' or 'del' is right"):
        parse_scenario(text)


def test_force_of_a_guide() -> None:
    """Sides at right angles put together, of two that look at each other the larger, (LG8)."""
    names = ("fore", "aft", "port")
    guide = Guide("g", "module", {side: [f"{side}/1", f"{side}/2"] for side in names})
    columns = {"contact_force": np.array([[3.0, 4.0, 0.0, 6.0, 20.0, 4.0]])}
    contacts = [f"{side}/{place}" for side in names for place in (1, 2)]
    variables, labels = guide_state(columns, {"contact": contacts}, [guide])
    assert labels == {"guide": ["g"]}
    assert variables["guide_force"].values[0, 0] == pytest.approx((7.0**2 + 24.0**2) ** 0.5)


def test_what_is_told_of_a_run() -> None:
    """Check, metric and the row of the report."""
    plan = "  - {step: lower, lower: crane, speed: 3 m/min, by: 0.8 m}\n  - {step: rest, hold: until_end}\n"
    # Aside of the hook alone a load on one hook turns out of the way: along its length it cannot.
    post = POST.replace("3.5 m, 0.1 m", "3.6 m, 0 m")
    given = f"  g: {{{post}, {FRAME}, friction: 0.2, capacity: 50 kN}}\n"
    text = guided_lift(given, plan=plan, duration=22.0)
    heavier = "contingency: 1.1, simulate: calculated}"
    text = text.replace("calculated: 30000.0 kg}", f"calculated: 30000.0 kg, {heavier}")
    recording = gantline.simulate(parse_scenario(text))
    peak = float(recording.column("guide_force", "g").max())
    assert peak > 1e3
    metrics = recording.metrics()
    assert metrics["peak_guide_force.g"] == peak
    assert metrics["peak_guide_force_of_capacity"] == pytest.approx(peak / 50e3)
    [check] = [one for one in check_recording(recording) if one.name == "guide_force_of_capacity"]
    assert check.value == pytest.approx(1.1 * peak / 50e3)
    rows = dict(attitude(Subject(recording)))
    assert rows["largest force of a guide"].startswith(f"g {peak / 1e3:.1f} kN at ")
    assert "of the weight, " in rows["largest force of a guide"]
    assert rows["largest force of a guide"].endswith(f" {110 * peak / 50e3:.0f} % of capacity")
