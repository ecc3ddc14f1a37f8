"""Landing guides that stand on a vessel or a body: where they are, what is drawn, what cannot hold them."""

from __future__ import annotations

import numpy as np
import pytest

from gantline.assembly import assemble
from gantline.cli.guides_table import guides_table
from gantline.results.recording import Recording
from gantline.scenario import ScenarioError, parse_scenario
from gantline.simulation import simulate
from guided_lift import guided_lift
from lift_text import changed

#: A post and a wall on the deck of a barge, 8 m over her keel; she lies with her bow to port, her stern 20 m
#: to starboard of the load's middle.
_POST = (
    "  p: {held_by: barge, post: {at: [20 m, -3.5 m, 8 m], diameter: 0.4 m, height: 1 m, "
    "cone: {length: 0.5 m, tip_diameter: 0.2 m}}, frame: {at: [3.5 m, 0 m, 0 m], clearance: 30 mm, "
    "height: 0.6 m, flare: {length: 0.4 m, angle: 30 deg}}, friction: 0.2}\n"
)
_WALL = (
    "  w: {held_by: barge, wall: {at: [18 m, 0 m, 8 m], faces: 0 deg, breadth: 2 m, height: 1 m}, "
    "bumper: {at: [0 m, -1.7 m, 0 m], diameter: 0.4 m}, friction: 0.2}\n"
)
_BARGE = """\
water: {density: 1025 kg/m^3, level: 0 m}
vessels:
  barge:
    draft: 4 m
    position: [0 m, -20 m]
    heading: 90 deg
    hull: {box: [100 m, 30 m, 8 m]}
    masses: {all: {mass: 12300 t, at: [50 m, 0 m, 4 m]}}
    radii_of_gyration: [9 m, 27 m, 27 m]
"""
_GROUND = ("ground: {level: 0 m, friction: 0.3}\n", "")


def _afloat(guides: str = _POST + _WALL, *more: tuple[str, str], **given: object) -> str:
    text = guided_lift(guides, height=6.0, more=_BARGE, **given)  # type: ignore[arg-type]
    return changed(text, _GROUND, *more)


def test_posts_and_walls_go_with_a_vessel() -> None:
    """In the axes of the vessel, as fairleads are: 8 m over her keel is 4 m over the water."""
    assembly = assemble(parse_scenario(_afloat()))
    pairs = {one["name"]: one for one in assembly.document["landings"]}
    post, wall = pairs["guide.p.fore"]["post"], pairs["guide.w.wall"]["wall"]
    assert (post["body"], post["base"]) == ("barge", [20.0, -3.5, 8.0])
    assert (wall["body"], wall["knee"]) == ("barge", [18.0, 0.0, 9.0])
    assert wall["normal"] == pytest.approx([1.0, 0.0, 0.0])


def test_check_shows_them_from_above_where_the_vessel_lies() -> None:
    """The post stands at (3.5, 0) m, in the middle of its frame; the wall faces port, 0.1 m off."""
    assembly = assemble(parse_scenario(_afloat()))
    _, post, wall = guides_table(assembly.guide_fits, 140)
    assert "0.000 m fore, 0.000 m port" in post
    assert "before the face of the wall" in wall and "0.100 m" in wall
    assert not any("guide" in one for one in assembly.warnings)


def test_one_that_is_missed_is_told() -> None:
    text = _afloat(_POST.replace("-3.5 m, 8 m", "-4.5 m, 8 m"))
    [warning] = [one for one in assemble(parse_scenario(text)).warnings if "misses guide p" in one]
    assert "its post is 1.00 m to fore of the middle of its frame" in warning


def test_what_is_drawn_stands_on_the_vessel() -> None:
    """Bodies of her own, not structures of the world: post 1.5 m and wall 1 m high, its face along its x."""
    scene = assemble(parse_scenario(_afloat())).scene
    assert "structures" not in scene
    bodies = {one["name"]: one for one in scene["bodies"]}
    tops = {}
    for name in ("p", "w"):
        boxes = bodies[f"guide.{name}.stand"]["shape"]["boxes"]
        tops[name] = max(box["centre"][2] + box["size"][2] / 2 for box in boxes)
        assert min(box["centre"][2] - box["size"][2] / 2 for box in boxes) == pytest.approx(0.0)
    assert tops == pytest.approx({"p": 1.5, "w": 1.0})
    [face] = bodies["guide.w.stand"]["shape"]["boxes"]
    assert face["centre"][0] + face["size"][0] / 2 == pytest.approx(0.0)


def _lowered() -> Recording:
    """1.8 m down: the frame is 0.2 m over the deck, with its post up to the tip in it."""
    plan = "  - {step: down, lower: crane, speed: 6 m/min, by: 1.8 m}\n  - {step: rest, hold: until_end}\n"
    aside = ("heading: 90 deg", "heading: 90.5 deg")
    return simulate(parse_scenario(_afloat(_POST, aside, plan=plan, duration=40.0), "x.yaml"))


def test_a_load_finds_its_post_on_a_vessel() -> None:
    """Turned by half a degree the post is 0.17 m off; nothing holds her, and she gives way."""
    recording = _lowered()
    force = recording.column("guide_force", "p")
    assert force.max() > 1e3
    stand, frame = (recording.column("body_position", name)[-1] for name in ("guide.p.stand", "guide.p"))
    assert np.hypot(*(stand - frame)[:2]) < 0.03 + 0.4 * 0.6
    assert not any("misses guide" in one for one in recording.attributes["warnings"])


@pytest.mark.parametrize(("x", "told"), [(3.5, True), (30.0, False)])
def test_a_post_of_the_world_amid_a_vessel_is_told(x: float, told: bool) -> None:
    """The barge is 30 m broad: her side is 15 m fore of the load's middle."""
    text = _afloat(_POST.replace("held_by: barge, ", "").replace("20 m, -3.5 m, 8 m", f"{x} m, 0 m, 4 m"))
    found = [one for one in assemble(parse_scenario(text)).warnings if "guide p stands in the world" in one]
    assert len(found) == told
    assert all(
        one.endswith("'held_by: barge' has it stand on her, at a place in her own axes") for one in found
    )


_HOLDERS = "a vessel, a part of a crane or a body of 'mechanics' may hold a guide"


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("barg", "'barg' is not a vessel, a part of a crane or a body; did you mean 'barge'?"),
        ("crane", f"'crane' is a hook; {_HOLDERS}"),
        ("module", "the load cannot hold its own guide"),
        ("box", "'box' is on the load, which cannot hold its own guide"),
    ],
)
def test_what_cannot_hold_one(name: str, message: str) -> None:
    box = "mechanics: {bodies: {box: {parent: module, joint: {type: fixed}, mass: 1 t}}}\n"
    text = _afloat(_POST.replace("held_by: barge", f"held_by: {name}")) + box
    with pytest.raises(ScenarioError) as caught:
        parse_scenario(text)
    [problem] = caught.value.problems
    assert problem.path == "guides.p.held_by"
    assert message in problem.sentence


def test_the_world_holds_those_that_say_nothing_else() -> None:
    text = _afloat(_POST.replace("held_by: barge", "held_by: world"))
    assembly = assemble(parse_scenario(text))
    assert assembly.document["landings"][0]["post"]["body"] is None
    assert [one["name"] for one in assembly.scene["structures"]] == ["guide.p"]
