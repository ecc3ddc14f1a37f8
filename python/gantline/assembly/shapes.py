"""Shapes of everything that has one, which of them may touch, and which distances are watched.

A shape is a list of parts on one body, in its frame [m]: `{"type": "box", "size": ..., "centre": ...}`,
`{"type": "convex", "vertices": ...}` or `{"type": "mesh", "vertices": ..., "triangles": ...}`. Shapes are
named as people name what they belong to, parts of it with a dot: `dock.walls`, `goliath.legs.1`. A name
stands for the shape of that name and for all whose names go on after it with a dot.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np

from gantline.assembly.afloat.vessels import vessel_shape
from gantline.assembly.cranes.boom import boom_shape
from gantline.assembly.cranes.compensators import compensator_shapes
from gantline.assembly.cranes.crawler import crawler_shape, crawlers
from gantline.assembly.cranes.goliath import crane_shape, goliaths
from gantline.assembly.cranes.reeving import hook_block_shape, reeved_hooks
from gantline.assembly.loads.carried import carried
from gantline.assembly.loads.lifted import LiftedLoad
from gantline.assembly.loads.supports import every_support, pad_shape, support_contact
from gantline.assembly.parts import Json, Parts, box_shape
from gantline.assembly.spatial import about_axis
from gantline.scenario import Rigging, Scenario
from gantline.scenario.cranes.compensator import rod_of
from gantline.scenario.cranes.crane import EqualizerFrame
from gantline.scenario.cranes.crawler import tracks_body
from gantline.scenario.cranes.hooks import full_name
from gantline.scenario.cranes.slewing import upper_body
from gantline.scenario.errors import PathPart, nearest
from gantline.scenario.ground import Ground
from gantline.scenario.loads.structures import CylinderStructure, Dock, dock_of
from gantline.scenario.watch import Watch

__all__ = [
    "add_shapes",
    "add_touching",
    "add_watches",
    "frame_shape",
    "load_parts",
    "members",
    "pair_name",
    "round_boxes",
    "spreader_shape",
    "watch_name",
    "watched_hook",
]

#: Thickness of the walls and the floor of a dock as things by themselves [m].
_THICK = 1.0
#: Sides of what stands for a cylinder: its corners are 0.5 % of the radius outside of it.
_SIDES = 32
#: How far the ground reaches around a dock, and how deep below its floor [m].
_GROUND_REACH, _GROUND_DEPTH = 2000.0, 50.0
#: Half of what a hook without reeving takes up, whose hook block nothing says [m]: a hand's breadth.
_HOOK = 0.1
#: Corners of a face that count, of a box and of a convex part.
_CORNERS = {"box": 4, "convex": 16}
#: What a girder stands on, and what the same is called of a crane of the other kind.
_STANDS = {"legs": "end_carriages", "end_carriages": "legs"}


def add_shapes(parts: Parts, scenario: Scenario, rigging: Rigging, lifted: LiftedLoad | None) -> None:
    """Give a shape to load, ground, structures, supports, lifting gear, cranes, vessels, plain bodies."""
    load = scenario.load
    if load is not None and lifted is not None:
        parts.add_shape(load.name, load.name, load_parts(lifted))
    _add_surroundings(parts, scenario)
    for name, equalizer in rigging.equalizers.items():
        parts.add_shape(name, name, [frame_shape(equalizer.frame)])
    for name in scenario.spreaders or {}:
        parts.add_shape(name, name, [spreader_shape(scenario, name)])
    for name, compensator in (scenario.compensators or {}).items():
        for own, box in zip((name, rod_of(name)), compensator_shapes(compensator), strict=True):
            parts.add_shape(own, own, [box])
    _add_cranes(parts, scenario)
    for name in scenario.vessels or {}:
        shape = vessel_shape(scenario, name)
        if shape["type"] == "mesh":
            shape = {"type": "convex", "vertices": shape["hull"]}
        parts.add_shape(name, name, [shape])
    plain = scenario.mechanics.bodies if scenario.mechanics is not None else {}
    for name, body in plain.items():
        if body.shape is not None:
            parts.add_shape(name, name, [box_shape(body.shape.box, body.shape.centre)])


def _add_surroundings(parts: Parts, scenario: Scenario) -> None:
    """Ground, structures, supports."""
    dock = dock_of(scenario)
    ground = scenario.ground
    if ground is not None:
        parts.add_shape("ground", None, _ground(ground, dock))
    for name, structure in (scenario.structures or {}).items():
        if isinstance(structure, Dock):
            level = 0.0 if ground is None else ground.level
            parts.add_shape(f"{name}.walls", None, _walls(structure, level))
            parts.add_shape(f"{name}.floor", None, [_floor(structure)])
        elif isinstance(structure, CylinderStructure):
            parts.add_shape(name, None, [_round(structure)])
        else:
            turn = about_axis((0.0, 0.0, 1.0), structure.heading)
            box = box_shape(structure.size, structure.middle)
            parts.add_shape(name, None, [{**box, "orientation": list(turn)} if structure.heading else box])
    pads = {pad["name"]: pad for pad in parts.supports}
    for _, support in every_support(scenario):
        if (pad := pads.get(support_contact(support))) is not None:
            parts.add_shape(support.name, None, [pad_shape(pad, support.height)])


def _add_cranes(parts: Parts, scenario: Scenario) -> None:
    """What of cranes a load may meet: legs, end carriages, booms, crawlers but their mats."""
    for name, crane in goliaths(scenario).items():
        stands_on = "end_carriages" if crane.legs is None else "legs"
        for side, box in enumerate((crane_shape(scenario, name) or {})["boxes"], start=1):
            parts.add_shape(f"{name}.{stands_on}.{side}", name, [box])
    for placed in scenario.booms.values():
        parts.add_shape(placed.name, placed.name, (boom_shape(scenario, placed.name) or {})["boxes"])
    for name in crawlers(scenario):
        for part in (tracks_body(name), upper_body(name)):
            boxes = crawler_shape(scenario, part, mats=False)  # a load may come over the mats
            parts.add_shape(part, part, (boxes or {})["boxes"])


def spreader_shape(scenario: Scenario, name: str) -> Json:
    """The box of a spreader, in the frame of its body, whose origin is its middle."""
    return box_shape((scenario.spreaders or {})[name].size, (0.0, 0.0, 0.0))


def frame_shape(frame: EqualizerFrame) -> Json:
    """The box of an equalizer's frame, in the frame of its body, whose origin is the bearing of its hook."""
    size = (frame.length, frame.width, frame.height)
    return box_shape(size, (0.0, 0.0, -frame.centre_of_gravity_below_hook))


def load_parts(lifted: LiftedLoad) -> list[Json]:
    """Parts of the load's shape, in the frame of its body, whose origin is its centre of gravity."""
    body = lifted.body
    if body.mesh is not None:
        pieces = body.pieces or (body.hull,)
        return [{"type": "convex", "vertices": (piece - lifted.centre).tolist()} for piece in pieces]
    size, middle = np.ptp(body.box, axis=0), np.mean(body.box, axis=0)
    return [box_shape(size, middle - lifted.centre)]


def _box(x: Sequence[float], y: Sequence[float], z: Sequence[float]) -> Json:
    """A box of the world by its extents."""
    extents = (x, y, z)
    size = [most - least for least, most in extents]
    return box_shape(size, [(most + least) / 2 for least, most in extents])


def _round(structure: CylinderStructure) -> Json:
    """An upright cylinder of the world as a prism about it, whose sides touch it in their middles."""
    (x, y), part = structure.at, 2 * math.pi / _SIDES
    out = structure.diameter / 2 / math.cos(part / 2)
    corners = [
        (x + out * math.cos((k + 0.5) * part), y + out * math.sin((k + 0.5) * part)) for k in range(_SIDES)
    ]
    return {"type": "convex", "vertices": [[*corner, z] for corner in corners for z in structure.z]}


def round_boxes(structure: CylinderStructure) -> list[Json]:
    """The same prism as boxes from each side to the one across, for pictures."""
    part, low, high = 2 * math.pi / _SIDES, *structure.z
    size = (structure.diameter, structure.diameter * math.tan(part / 2), high - low)
    box = box_shape(size, (*structure.at, (low + high) / 2))
    turns = (list(about_axis((0.0, 0.0, 1.0), k * part)) for k in range(_SIDES // 2))
    return [{**box, "orientation": turn} for turn in turns]


def _around(hole: Dock, reach: tuple[float, float], z: tuple[float, float]) -> list[Json]:
    """Four boxes around a hole, as far as `reach` beyond its sides along x and y."""
    (x0, x1), (y0, y1) = hole.x, hole.y
    along, across = reach
    return [
        _box((x0 - along, x0), (y0 - across, y1 + across), z),
        _box((x1, x1 + along), (y0 - across, y1 + across), z),
        _box((x0, x1), (y0 - across, y0), z),
        _box((x0, x1), (y1, y1 + across), z),
    ]


def _ground(ground: Ground, dock: Dock | None) -> list[Json]:
    if dock is None:
        reach = (-_GROUND_REACH, _GROUND_REACH)
        return [_box(reach, reach, (ground.level - _GROUND_DEPTH, ground.level))]
    return _around(dock, (_GROUND_REACH, _GROUND_REACH), (dock.floor - _GROUND_DEPTH, ground.level))


def _walls(dock: Dock, level: float) -> list[Json]:
    return _around(dock, (_THICK, _THICK), (dock.floor, level))


def _floor(dock: Dock) -> Json:
    return _box(dock.x, dock.y, (dock.floor - _THICK, dock.floor))


def members(shapes: Mapping[str, Json], name: str) -> list[str]:
    """Shapes that a name stands for."""
    return [shape for shape in shapes if shape == name or shape.startswith(f"{name}.")]


def pair_name(one: str, other: str) -> str:
    """Name of a pair of things that touch."""
    return f"{one}.{other}"


def add_touching(parts: Parts, scenario: Scenario) -> None:
    """Let the load touch the ground around a dock and all structures; bodies touch what `mechanics` says.

    Raises:
        ScenarioError: if a contact of bodies names what has no shape.
    """
    load, ground = scenario.load, scenario.ground or Ground.model_construct()
    if load is not None:
        if scenario.ground is not None and dock_of(scenario) is not None:
            own = pair_name(load.name, "ground")
            parts.pairs.append(_pair(parts, own, load.name, (load.name, "ground"), _law(ground)))
        for name, structure in (scenario.structures or {}).items():
            law = [
                getattr(ground if getattr(structure, key) is None else structure, key)
                for key in ("stiffness", "damping", "friction")
            ]
            shapes = members(parts.shapes, name)
            if isinstance(structure, Dock) and scenario.ground is not None:
                shapes.remove(f"{name}.walls")  # the sides of the ground around it
            parts.pairs += [
                _pair(parts, pair_name(load.name, shape), load.name, (load.name, shape), law)
                for shape in shapes
            ]
    contacts = scenario.mechanics.body_contacts if scenario.mechanics is not None else None
    by_itself = {frozenset(pair["shapes"]) for pair in parts.pairs}
    for name, contact in (contacts or {}).items():
        path = ("mechanics", "body_contacts", name, "between")
        one, other = (_known(parts, scenario, path, word) for word in contact.between)
        bodies = [body for shape in (*one, *other) if (body := parts.shapes[shape]["body"]) is not None]
        if not bodies:
            raise scenario.error(path, "neither of the two can move; one of them is a body")
        group, law = contact.group or carried(parts, scenario, bodies), _law(contact)
        for first in one:
            for second in other:
                if frozenset((first, second)) in by_itself:
                    # The contact would be there twice, of twice the stiffness.
                    said = f"{first} and {second} touch by themselves, as the load does all 'structures'"
                    right = "leave this out; a structure has 'stiffness', 'damping' and 'friction' of its own"
                    raise scenario.error(path, f"{said}: {right}")
                own = name if len(one) == len(other) == 1 else f"{name}.{first}.{second}"
                parts.pairs.append(_pair(parts, own, group, (first, second), law))


def _law(given: object) -> list[float]:
    return [getattr(given, key) for key in ("stiffness", "damping", "friction")]


def _pair(parts: Parts, name: str, group: str, shapes: tuple[str, str], law: Sequence[float]) -> Json:
    """Two that touch, at as many places as where two convex faces meet may have corners: those of both."""
    stiffness, damping, friction = law
    corners = [max(_CORNERS[part["type"]] for part in parts.shapes[shape]["parts"]) for shape in shapes]
    return {
        "name": name,
        "group": group,
        "shapes": list(shapes),
        "stiffness": stiffness,
        "damping_time": damping / stiffness,
        "friction": friction,
        "places": sum(corners),
    }


def _known(parts: Parts, scenario: Scenario, path: tuple[PathPart, ...], name: str) -> list[str]:
    found = members(parts.shapes, name)
    if not found:
        parted = [shape.split(".") for shape in parts.shapes]
        # Not all have room in a sentence: what is whole comes first, parts of it last.
        known = dict.fromkeys(words[0] for words in parted)
        known |= dict.fromkeys(scenario.hooks) if path[0] == "watch" else {}
        known |= {".".join(words[:count]): None for words in parted for count in range(2, len(words) + 1)}
        crane, _, part = name.rpartition(".")
        stand = f"{crane}.{_STANDS.get(part)}"
        right = (
            nearest(stand if stand in known else name, known)
            if known
            else "give it one: 'shape: {box: [1 m, 1 m, 1 m]}'"
        )
        sentence = f"'{name}' has no shape; {right}"
        raise scenario.error(path, sentence)
    return found


def add_watches(parts: Parts, scenario: Scenario, diameters: Mapping[str, float | None]) -> None:
    """Distances to record, one for each pair that the lift file watches.

    Args:
        parts: the system with all its shapes and ropes.
        scenario: the lift.
        diameters: of ropes, by their names [m]; None where it is not known.

    Raises:
        ScenarioError: if a name stands for nothing.
    """
    for place, watch in enumerate(scenario.watch):
        path = ("watch", place, "between")
        hooks = [_hook(parts, scenario, name) for name in watch.between]
        ropes = [
            _ropes(parts, name) if hook is None else []
            for hook, name in zip(hooks, watch.between, strict=True)
        ]
        if all(ropes):
            raise scenario.error(path, "distances between ropes are not recorded; one of the two has a shape")
        if any(ropes) and any(hooks):
            sentence = "distances of a hook to ropes are not recorded, as falls and slings lead to it"
            raise scenario.error(path, f"{sentence}; hooks are watched against what has a shape")
        shapes = [
            [hook] if hook is not None else [] if own else _known(parts, scenario, path, name)
            for hook, own, name in zip(hooks, ropes, watch.between, strict=True)
        ]
        if alike := [one for one in shapes[0] if one in shapes[1]]:
            both = "both are" if len(shapes[0]) == len(shapes[1]) == 1 else "both have"
            raise scenario.error(path, f"{both} '{alike[0]}'; two things have a distance")
        sides = []
        for side in (0, 1):
            against = {(parts.shapes | parts.hook_shapes)[one]["body"] for one in shapes[1 - side]}
            watched = [
                one
                for rope in ropes[side]
                for one in _watched(parts, rope, against, watch.from_ends, diameters)
            ]
            sides.append({"shapes": shapes[side], "ropes": watched})
        name = watch_name(watch)
        if any(one["name"] == name for one in parts.watches):
            raise scenario.error(path, f"'{name}' is watched already; once is right")
        parts.watches.append({"name": name, "between": sides})


def watched_hook(parts: Parts, scenario: Scenario, name: str) -> str | None:
    """Full name of the hook that a watched name means; None where it means anything else."""
    return None if members(parts.shapes, name) else full_name(name, scenario.hooks)


def _hook(parts: Parts, scenario: Scenario, name: str) -> str | None:
    """The same, of a hook that has a shape from then on."""
    hook = watched_hook(parts, scenario, name)
    if hook is None:
        return None
    reeved = next((one for one in reeved_hooks(scenario) if one.name == hook), None)
    box = (
        box_shape([2 * _HOOK] * 3, (0.0, 0.0, 0.0))
        if reeved is None
        else hook_block_shape(parts, scenario, reeved)
    )
    parts.hook_shapes[hook] = {"name": hook, "body": hook, "parts": [box]}
    return hook


def watch_name(watch: Watch) -> str:
    """Name of a pair that is watched, with the steps over which it is."""
    ends = (("from", watch.from_step), ("to", watch.to_step))
    return " ".join([" - ".join(watch.between), *(f"{word} '{step}'" for word, step in ends if step)])


def _ropes(parts: Parts, name: str) -> list[str]:
    """Ropes that a name stands for, unless a shape has it."""
    if members(parts.shapes, name):
        return []
    if name == "ropes":
        return list(parts.rope_names)
    prefix = "sling." if name == "slings" else f"{name}."
    return [rope for rope in parts.rope_names if rope == name or rope.startswith(prefix)]


def _watched(
    parts: Parts, rope: str, against: set[str | None], left_out: float, diameters: Mapping[str, float | None]
) -> list[Json]:
    """The pieces of a rope, without what is near an end that is made fast on what it is held against."""
    pieces = [one for one in parts.ropes if one["name"] == rope or one["name"].startswith(f"{rope}/")]
    radius = (diameters.get(rope) or 0.0) / 2
    found = [{"rope": piece["name"], "radius": radius, "without": [0.0, 0.0]} for piece in pieces]
    for end, order in ((0, range(len(pieces))), (1, range(len(pieces) - 1, -1, -1))):
        outermost = pieces[0 if end == 0 else -1]["route"][0 if end == 0 else -1]
        left = left_out if outermost["body"] in against else 0.0
        for index in order:
            found[index]["without"][end] = left
            left = max(0.0, left - (pieces[index]["length"] or 0.0))
    return found
