"""Landing guides: posts and walls in the world or on a body, frames and bumpers on the load."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from gantline.assembly.loads.lifted import LiftedLoad
from gantline.assembly.parts import Json, Parts
from gantline.assembly.spatial import Array, about_axis
from gantline.scenario import Scenario
from gantline.scenario.loads.guide import (
    SIDES,
    Bumper,
    GuideFrame,
    GuidePost,
    GuideWall,
    LandingGuide,
    Slope,
    guide_body,
    guide_contact,
    guide_stand,
)

__all__ = ["add_guides", "guide_rig", "guide_shape", "guide_structures", "stand_shape"]

#: How thick frames and walls are drawn [m].
_THICK = 0.03
#: By how many boxes a cone and a flare are drawn, and by how many turned squares a round.
_STEPS, _SQUARES = 4, 3
_UP, _DOWN = [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]


def add_guides(parts: Parts, scenario: Scenario, lifted: LiftedLoad) -> None:
    """Add landing guides; the load and what holds them are there.

    Each has a body without mass on the load, for pictures, and one on the body that holds it.
    """
    assert scenario.load is not None
    for name, guide in (scenario.guides or {}).items():
        at = np.array((guide.frame or guide.bumper_there).at) - lifted.centre
        parts.add_body(guide_body(name), {"type": "fixed"}, parent=scenario.load.name, position=at.tolist())
        if guide.holder is not None:
            foot, faces = guide.foot
            parts.add_body(
                guide_stand(name),
                {"type": "fixed"},
                parent=guide.holder,
                position=list(foot),
                orientation=about_axis((0.0, 0.0, 1.0), faces),
            )
        for side, pair in _pairs(guide, scenario.load.name, at):
            parts.landings.append(
                {
                    "name": guide_contact(name, side),
                    "group": guide_body(name),
                    **pair,
                    "stiffness": guide.stiffness,
                    "damping_time": guide.damping / guide.stiffness,
                    "friction": guide.friction,
                }
            )


def _pairs(guide: LandingGuide, load: str, at: Array) -> Iterator[tuple[str, Json]]:
    """Post and wall of each face of a guide; `at` is its frame or bumper from the load's centre [m]."""
    if guide.frame is None:
        bumper, wall = guide.bumper_there, guide.wall_there
        post: Json = {
            "body": load,
            "base": [float(at[0]), float(at[1]), float(at[2]) + bumper.length],
            "axis": _DOWN,
            "radius": bumper.diameter / 2,
            "height": bumper.length,
        }
        yield "wall", {"post": post, "wall": _standing_wall(wall, guide.holder)}
        return
    post = _standing_post(guide.post_there, guide.holder)
    for side in guide.frame.sides:
        yield side, {"post": post, "wall": _frame_wall(guide.frame, guide.post_there, side, load, at)}


def _standing_post(post: GuidePost, holder: str | None) -> Json:
    cone = {} if post.cone is None else {"cone": post.cone.length, "tip_radius": post.tip_radius}
    return {
        "body": holder,
        "base": list(post.at),
        "axis": _UP,
        "radius": post.diameter / 2,
        "height": post.height,
        **cone,
    }


def _standing_wall(wall: GuideWall, holder: str | None) -> Json:
    x, y, z = wall.at
    return {
        "body": holder,
        "knee": [x, y, z + wall.height],
        "normal": [math.cos(wall.faces), math.sin(wall.faces), 0.0],
        "up": _DOWN,
        "height": wall.height,
        "breadth": wall.breadth,
        **_leaning(wall.slope),
    }


def _frame_wall(frame: GuideFrame, post: GuidePost, side: str, load: str, at: Array) -> Json:
    """A side of a frame: broad enough that flares meet where they end."""
    out = np.array([*SIDES[side], 0.0])
    away = post.diameter / 2 + frame.clearance
    run = 0.0 if frame.flare is None else frame.flare.run
    return {
        "body": load,
        "knee": (at + away * out).tolist(),
        "normal": [-float(part) for part in out],
        "up": _UP,
        "height": frame.height,
        "breadth": 2 * (away + run),
        **_leaning(frame.flare),
    }


def _leaning(slope: Slope | None) -> Json:
    return {} if slope is None else {"flare": slope.length, "angle": slope.angle}


def guide_rig(scenario: Scenario) -> Json:
    """What results need to know of guides; nothing in a lift without."""
    assert scenario.load is not None or not scenario.guides
    guides = [
        {
            "name": name,
            "load": scenario.load.name if scenario.load is not None else None,
            "sides": {
                side: [f"{guide_contact(name, side)}/{place}" for place in (1, 2)] for side in guide.sides
            },
            "capacity": guide.capacity,
        }
        for name, guide in (scenario.guides or {}).items()
    ]
    return {"guides": guides} if guides else {}


def guide_structures(scenario: Scenario) -> list[Json]:
    """Posts and walls that stand in the world as its boxes, for pictures."""
    return [
        {"name": guide_body(name), "kind": "structure", "boxes": _in_world(guide)}
        for name, guide in (scenario.guides or {}).items()
        if guide.holder is None
    ]


def stand_shape(guide: LandingGuide) -> Json:
    """A post or a wall as boxes from its foot, its face along x, for pictures; a round is one of them."""
    return {"type": "boxes", "boxes": _post_boxes(guide) if guide.frame is not None else _wall_boxes(guide)}


def _in_world(guide: LandingGuide) -> list[Json]:
    """Boxes of what stands in the world; a round is squares turned against each other, as broad as it."""
    foot, faces = guide.foot
    if guide.frame is None:
        return [_turned(box, foot, faces) for box in _wall_boxes(guide)]
    part, narrow = math.pi / (2 * _SQUARES), math.cos(math.pi / (4 * _SQUARES)) / math.sqrt(2)
    squares = []
    for box in _post_boxes(guide):
        across, _, height = box["size"]
        square = {**box, "size": [across * narrow, across * narrow, height]}
        squares += [_turned(square, foot, one * part) for one in range(_SQUARES)]
    return squares


def _turned(box: Json, foot: Sequence[float], angle: float) -> Json:
    """A box from a foot, turned about the vertical through it, in the world."""
    x, y, z = box["centre"]
    cosine, sine = math.cos(angle), math.sin(angle)
    centre = [foot[0] + x * cosine - y * sine, foot[1] + x * sine + y * cosine, foot[2] + z]
    turn = list(about_axis((0.0, 0.0, 1.0), angle))
    return {"type": "box", "size": box["size"], "centre": centre, "orientation": turn}


def _post_boxes(guide: LandingGuide) -> list[Json]:
    """A post from its foot: a box for its upright part, and some for its cone."""
    post = guide.post_there
    pieces = [(0.0, post.height, post.diameter)]
    if post.cone is not None:
        rise, less = post.cone.length / _STEPS, (post.cone.tip_diameter - post.diameter) / _STEPS
        pieces += [
            (post.height + step * rise, rise, post.diameter + (step + 0.5) * less) for step in range(_STEPS)
        ]
    return [
        {"size": [across, across, height], "centre": [0.0, 0.0, low + height / 2]}
        for low, height, across in pieces
    ]


def _wall_boxes(guide: LandingGuide) -> list[Json]:
    """A wall from the middle of its foot, its face along x."""
    wall = guide.wall_there
    pieces = [(0.0, 0.0, wall.height), *_stairs(wall.slope, wall.height, 1.0)]
    return [
        {"size": [_THICK, wall.breadth, height], "centre": [-(back + _THICK / 2), 0.0, low + height / 2]}
        for back, low, height in pieces
    ]


def _stairs(slope: Slope | None, start: float, way: float) -> Iterator[tuple[float, float, float]]:
    """A slope as steps: how far back each is, where it begins, and its height [m]; `way` is 1 upwards."""
    if slope is None:
        return
    rise = slope.length * math.cos(slope.angle) / _STEPS
    for step in range(_STEPS):
        low = start + way * step * rise if way > 0 else start - (step + 1) * rise
        yield slope.run * (step + 0.5) / _STEPS, low, rise


def guide_shape(guide: LandingGuide) -> Json:
    """A frame or a bumper as boxes from its place on the load, for pictures."""
    if guide.frame is None:
        return {"type": "boxes", "boxes": [_bumper_box(guide.bumper_there)]}
    frame, away = guide.frame, guide.post_there.diameter / 2 + guide.frame.clearance
    pieces = [(0.0, 0.0, frame.height), *_stairs(frame.flare, 0.0, -1.0)]
    boxes = [_side_box(SIDES[side], away, piece) for side in frame.sides for piece in pieces]
    return {"type": "boxes", "boxes": boxes}


def _bumper_box(bumper: Bumper) -> Json:
    side = bumper.diameter
    return {"size": [side, side, bumper.length], "centre": [0.0, 0.0, bumper.length / 2]}


def _side_box(out: Sequence[float], away: float, piece: tuple[float, float, float]) -> Json:
    back, low, height = piece
    from_middle, breadth = away + back + _THICK / 2, 2 * (away + back)
    along_x = out[0] != 0.0
    return {
        "size": [_THICK if along_x else breadth, breadth if along_x else _THICK, height],
        "centre": [out[0] * from_middle, out[1] * from_middle, low + height / 2],
    }
