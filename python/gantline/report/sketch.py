"""Side view and plan of a lift to scale, as lines and texts for a template to draw."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np

from gantline.report.sketch_names import (
    Box,
    around_dot,
    beside_dot,
    fits_above,
    has_room,
    hides_none,
    names_beside,
    names_in_a_row,
    on_paper,
    text_box,
)
from gantline.report.sketch_paper import HEIGHT, MARGIN, PLATE, WIDTH, Mark, Paper, drawn_path, outline
from gantline.report.subject import Subject
from gantline.results.loads.hinges import is_shut
from gantline.results.loads.upending import is_turned
from gantline.results.recording import Recording
from gantline.results.rig import Load, Rig
from gantline.results.ropes.families import shortened_inside
from gantline.results.ropes.parting import PLANNED, partings
from gantline.results.rotation import axes
from gantline.results.series import load_is_clear
from gantline.results.surroundings import (
    Ground,
    Structure,
    ground_of,
    structures_of,
    water_cut,
    water_level,
)
from gantline.results.variable import FloatArray
from gantline.units import format_quantity
from gantline.viewer.shapes import vector

_SIDES = {
    "x": np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]),
    "y": np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]),
}
_PLAN = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
#: What is drawn upon what; cranes and supports lie below.
_ORDER = {"hull": 0, "load": 1, "frame": 2, "hook": 3}
#: Lengths of a scale bar [m]; the longest are for runs that flew apart.
_ROUND = tuple(first * 10.0**power for power in range(-2, 12) for first in (1.0, 2.0, 5.0))

#: Where along a sling its number is tried, the best first.
_ALONG = (0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8, 0.1, 0.9)

#: Where above and below its lug a number is tried in a plan, the best first; the further ones are clear of a
#: centre of gravity on the lug [mm].
_BESIDE_LUG = (-2.2, -3.8, 3.8)

#: Shortest sling on paper that bears its number in a side view: some lines of text long [mm].
_NUMBERED = 14.0

#: Corners of a box of half sizes 1.
_SIGNS = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], dtype=np.float64)

#: Kind of each body, and points in space of each of its parts.
_Solids = dict[str, tuple[str, list[FloatArray]]]


@dataclass(frozen=True)
class Sketch:
    """A view to scale.

    Attributes:
        title: What is seen from where.
        width: Of the paper [mm].
        height: Of the paper [mm].
        scale: Metres per millimetre of paper.
        bar: Length of the scale bar [m].
        marks: What is drawn, in order.
    """

    title: str
    width: float
    height: float
    scale: float
    bar: float
    marks: list[Mark]

    @property
    def bar_width(self) -> float:
        """The scale bar on paper [mm]."""
        return self.bar / self.scale

    @property
    def plate(self) -> float:
        """What lies under title and scale bar, from the lower end of the paper [mm]."""
        return PLATE


@dataclass(frozen=True)
class _Moment:
    """A sample of a recording."""

    recording: Recording
    sample: int

    @property
    def rig(self) -> Rig:
        """What was lifted with what."""
        return self.recording.rig

    @property
    def time(self) -> float:
        """When that is [s]."""
        return float(self.recording.time[self.sample])

    def place(self, body: str) -> FloatArray:
        """Where a body is then, (3,) [m]."""
        place: FloatArray = self.recording.column("body_position", body)[self.sample]
        return place

    def turn(self, body: str) -> FloatArray:
        """Its axes then, (3, 3)."""
        return axes(self.recording.column("body_orientation", body)[self.sample])

    def has(self, body: str) -> bool:
        """Whether there is such a body."""
        return body in self.recording.coordinates.get("body", ())


def sketches(subject: Subject) -> list[Sketch]:
    """Side view and plan at the end of the recording; none if it has nothing to draw.

    A load that is turned is drawn as it comes clear: at the end some of its slings may be off. The side view
    looks across its turning. A lift of which a sling parts is drawn before that, with all its slings.
    """
    recording = subject.recording
    scene: Mapping[str, Any] = recording.attributes.get("scene") or {}
    if not scene.get("bodies") or not len(recording.time):
        return []
    turned = next((load for load in subject.rig.loads if is_turned(recording, load)), None)
    moment = _Moment(recording, _sample(recording, turned))
    solids = _solids(moment, scene)
    ropes = _ropes(moment)
    near = [path for name, path in ropes.items() if name not in subject.rig.outer_ropes]
    parts = [one for _, pieces in solids.values() for one in pieces] + near
    if not parts:
        return []
    bearings = [moment.place(name) for name in _hook_bodies(moment)]
    around = [one for one in structures_of(recording) if one.stands(moment.time)]
    under = [one.boxes.reshape(-1, 3) for one in around if one.kind == "support"]
    lift = extent = np.concatenate([*parts, np.reshape(bearings, (-1, 3)), *under])
    ground = ground_of(recording)
    if ground is not None:
        extent = np.concatenate([lift, ground.near(lift)])
    carried = [one for kind, pieces in solids.values() if kind in ("load", "frame") for one in pieces]
    # A compensator is as wide whichever way it is seen.
    slender = {one.body for one in subject.rig.compensators}
    wide = [pieces for name, (kind, pieces) in solids.items() if kind == "frame" and name not in slender]
    frames = [one for pieces in wide for one in pieces]
    # Hooks side by side would cover each other, seen along the line that they are in.
    shown = np.concatenate([*(frames or carried or parts), np.reshape(bearings, (-1, 3))])
    along = _along(moment, shown) if turned is None else _across_turn(recording, turned)
    view = _SIDES[along]
    when = f" at {format_quantity(moment.time, 's', 1)}"
    paper = Paper(view, extent)
    axis = "xy".index(along)
    behind = _water(paper, subject, axis, lift) + _standing(paper, around)
    behind += _ground_line(paper, ground, axis, lift)
    side = _draw(moment, f"side view{when}, {along} to the right", view, paper, solids, ropes, behind)
    paper = Paper(_PLAN, np.concatenate(carried) if carried else extent)
    behind = _holes(paper, ground, water_level(recording)) + _standing(paper, around)
    plan = _draw(moment, f"plan{when}, x to the right", _PLAN, paper, solids, ropes, behind)
    return [side, plan]


def _sample(recording: Recording, turned: Load | None) -> int:
    """The sample that is drawn."""
    chosen = len(recording.time) - 1 if turned is None else _as_it_turns(recording, turned)
    slings = {sling.rope for sling in recording.rig.slings}
    parted = [one.time for one in partings(recording) if one.kind not in PLANNED and one.rope in slings]
    before = int(np.searchsorted(recording.time, min(parted))) - 1 if parted else chosen
    return max(0, min(chosen, before))


def _as_it_turns(recording: Recording, load: Load) -> int:
    """The sample at which a load that is turned comes clear; of one in a hinge that halfway of its turn.

    What a hinge holds lies as it comes clear, as it lay before: nothing would tell that it is raised.
    """
    clear = load_is_clear(recording, load)
    first = int(np.argmax(clear))
    held = [is_shut(recording, hinge) for hinge in recording.rig.hinges if hinge.load == load.name]
    tilt = recording.column("load_tilt", load.name)
    turned = np.where(clear & np.any(held, axis=0), np.abs(tilt - tilt[first]), 0.0) if held else np.zeros(1)
    return int(np.argmax(turned >= 0.5 * turned.max())) if turned.max() > 0.0 else first


def _across_turn(recording: Recording, load: Load) -> str:
    """The axis of the world, to the right in a side view, towards which a load leans as it turns.

    That is half way of its leaning: a load that has come upright may slew after that, or yaw.
    """
    upright = axes(recording.column("body_orientation", load.body))[:, :2, 2]
    leans = np.linalg.norm(upright, axis=1)
    lean = np.abs(upright[np.argmax(leans >= 0.5 * leans.max())])
    return "x" if lean[0] >= lean[1] else "y"


def _along(moment: _Moment, shown: FloatArray) -> str:
    """The axis of the world that a side view has to the right.

    Of the boom; of several cranes with booms that along which their hooks are farther apart, since booms side
    by side would cover each other; without any the longer one.
    """
    booms = [one for one in moment.rig.booms if moment.has(one.boom)]
    cranes = {one.name for one in booms}
    hooks = [one for one in moment.rig.hooks if one.crane in cranes and moment.has(one.name)]
    if len({one.crane for one in hooks}) > 1:
        way = np.ptp([moment.place(one.name) for one in hooks], axis=0)
    elif booms:
        way = np.abs(moment.turn(booms[0].boom)[:, 0])
    else:
        way = np.ptp(shown, axis=0)
    return "x" if way[0] >= way[1] else "y"


def _solids(moment: _Moment, scene: Mapping[str, Any]) -> _Solids:
    """Kind of each body that has a shape, and points in space of each of its parts."""
    found: _Solids = {}
    for entry in scene["bodies"]:
        parts = _parts(entry.get("shape"))
        if not moment.has(entry["name"]) or not parts:
            continue
        turn, place = moment.turn(entry["name"]), moment.place(entry["name"])
        centre = np.asarray(vector(entry.get("centre_of_gravity")))
        placed = [place + (points - centre) @ turn.T for points in parts]
        found[entry["name"]] = (str(entry.get("kind", "body")), placed)
    return found


def _parts(shape: Mapping[str, Any] | None) -> list[FloatArray]:
    if not shape:
        return []
    boxes = shape.get("boxes") or ([shape] if shape.get("type") == "box" else [])
    if boxes:
        return [_corners(box) for box in boxes]
    given = shape.get("vertices", shape.get("points"))
    return [] if given is None else [np.asarray(given, dtype=np.float64).reshape(-1, 3)]


def _corners(box: Mapping[str, Any]) -> FloatArray:
    half = _SIGNS * np.asarray(vector(box["size"])) / 2
    corners: FloatArray = np.asarray(vector(box.get("centre"))) + half
    return corners


def _ropes(moment: _Moment) -> dict[str, FloatArray]:
    recording = moment.recording
    if "rope_point" not in recording:
        return {}
    points, places = recording["rope_point"].values[moment.sample], recording.points_of_ropes
    gases = {one.gas for one in recording.rig.compensators}
    shown = [name for name in recording.coordinates["rope"] if name in places and name not in gases]
    paths = {name: points[places[name]] for name in shown}
    # What has parted or is not on is one point.
    return {name: path for name, path in paths.items() if np.ptp(path, axis=0).any()}


def _draw(
    moment: _Moment,
    title: str,
    view: FloatArray,
    paper: Paper,
    solids: _Solids,
    ropes: Mapping[str, FloatArray],
    behind: list[Mark],
) -> Sketch:
    marks = list(behind)
    order = sorted(solids.items(), key=lambda item: _ORDER.get(item[1][0], 0))
    plan = view is _PLAN
    for _, (kind, pieces) in order:
        style = f"sk-solid sk-{kind if kind in _ORDER else 'other'}"
        marks += [Mark("area", style, drawn_path(outline(paper.place(points)))) for points in pieces]
    slings = {sling.rope for sling in moment.rig.slings}
    at_loads = slings.union(*(load.other_ropes for load in moment.rig.loads))
    for name, path in ropes.items():
        if name in moment.rig.outer_ropes:
            marks += paper.line(path, "sk-rope")
            continue
        if plan and slings and name not in at_loads:
            continue  # what hangs above would cover where slings are
        marks.append(Mark("line", "sk-sling" if name in slings else "sk-rope", drawn_path(paper.place(path))))
    marks += _hangers(moment, paper, solids) if not plan else []
    sides = {} if plan else _sides(moment, paper, solids)
    hinges = _hinges(moment, paper)
    above = _centres(moment, paper) + _hooks(moment, paper, ropes, hinges, sides, plan=plan)
    for x, y in hinges.values():  # a ring with a dot, as a pin is drawn
        above += [Mark("dot", style, x=float(x), y=float(y)) for style in ("sk-hinge", "sk-pin")]
    marks += _numbers(moment, paper, ropes, above, plan=plan) + above
    return Sketch(title, WIDTH, HEIGHT, paper.scale, scale_bar(paper.scale), marks)


def scale_bar(scale: float) -> float:
    """A round length that has room below a sketch [m].

    Args:
        scale: Of the sketch, metres by millimetre of paper.
    """
    return max((one for one in _ROUND if one / scale <= 0.3 * WIDTH), default=_ROUND[0])


def _standing(paper: Paper, around: list[Structure]) -> list[Mark]:
    """Structures, and supports upon them."""
    order = sorted(around, key=lambda one: one.kind == "support")
    return [mark for one in order for box in one.boxes for mark in paper.area(box, f"sk-solid sk-{one.kind}")]


def _ground_line(paper: Paper, ground: Ground | None, axis: int, lift: FloatArray) -> list[Mark]:
    """The ground in a side view, with the holes that the lift is over."""
    if ground is None:
        return []
    line = ground.profile(axis, paper.ends(), lift)
    points = np.zeros((len(line), 3))
    points[:, axis], points[:, 2] = line.T
    return [Mark("line", "sk-ground", drawn_path(paper.place(points)))]


def _water(paper: Paper, subject: Subject, axis: int, lift: FloatArray) -> list[Mark]:
    """The water in a side view, cut where the lift is."""
    level = water_level(subject.recording)
    if level is None:
        return []
    low = paper.lowest()
    marks = []
    for corners in water_cut(ground_of(subject.recording), level, axis, (paper.ends(), low), lift):
        points = np.zeros((4, 3))
        points[:, axis], points[:, 2] = corners.T
        marks += paper.area(points, "sk-water")
        marks.append(Mark("line", "sk-surface", drawn_path(paper.place(points[2:]))))
    return marks


def _holes(paper: Paper, ground: Ground | None, water: float | None) -> list[Mark]:
    """Holes of the ground in a plan; none that goes on beyond the paper on all sides."""
    if ground is None:
        return []
    whole = np.array([WIDTH, HEIGHT]) - 2 * MARGIN
    marks = []
    for hole in ground.holes:
        rim = np.array([(x, y, ground.level) for x in hole.x for y in hole.y])
        if (np.ptp(paper.shown(rim), axis=0) < whole - 1e-9).any():
            is_wet = water is not None and hole.floor < water
            marks += paper.area(rim, "sk-water" if is_wet else "sk-hole")
    return marks


def _hangers(moment: _Moment, paper: Paper, solids: _Solids) -> list[Mark]:
    """From the bearing of its hook to the ends of each equalizer's frame."""
    marks = []
    hooks = _hook_bodies(moment)
    for equalizer in moment.rig.equalizers:
        if equalizer.body not in solids or equalizer.hook not in hooks:
            continue
        bearing = paper.place(moment.place(equalizer.hook))
        frame = paper.place(np.concatenate(solids[equalizer.body][1]))
        left, right, top = frame[:, 0].min(), frame[:, 0].max(), frame[:, 1].min()
        inset = 0.14 * (right - left)
        marks += [
            Mark("line", "sk-hanger", drawn_path(np.array([bearing, (x, top)])))
            for x in (left + inset, right - inset)
        ]
    return marks


def _numbers(
    moment: _Moment, paper: Paper, ropes: Mapping[str, FloatArray], above: list[Mark], *, plan: bool
) -> list[Mark]:
    """Lugs as dots, and the number of each sling beside its lug or on its way, clear of what lies above."""
    shown = [(name, paper.place(path)) for name, path in _carrying(moment.rig, ropes)]
    lugs = [path[-1] for _, path in shown]
    marks = [Mark("dot", "sk-lug", x=float(x), y=float(y)) for x, y in lugs]
    # In a plan hooks are over the slings that hang from them: numbers rather keep off their dots there, and
    # always in a side view, which has room.
    hooks = [np.array([mark.x, mark.y]) for mark in above if plan and mark.kind == "dot"]
    taken = [
        _box(mark) for mark in above if mark.kind == "centre" or (not plan and mark.kind in ("dot", "text"))
    ]
    if not plan:
        long = [(name, path) for name, path in shown if np.linalg.norm(path[-1] - path[0]) >= _NUMBERED]
        ends = [(path[0], path[-1]) for _, path in long]
        row = names_in_a_row(ends, [name for name, _ in long], WIDTH - MARGIN, taken)
        if row is not None:
            return marks + _row([name for name, _ in long], row)
    for name, path in shown:
        upper, lug = path[0], path[-1]
        tries = [upper + part * (lug - upper) for part in _ALONG]
        if not plan and np.linalg.norm(lug - upper) < _NUMBERED:
            continue  # its number would hide it; the plan has it
        if plan:
            tries = [*(lug + np.array([0.0, down]) for down in _BESIDE_LUG), *tries]
            # Of lugs in a row from top to bottom those between the others have room at their sides.
            tries += [lug + np.array([side * beside_dot(name), 0.0]) for side in (1.0, -1.0)]
        boxes = [text_box(on_paper(float(x), name, WIDTH), float(y), name, is_bold=True) for x, y in tries]
        boxes = [box for box in boxes if fits_above(box, HEIGHT - PLATE)]
        free = [box for box in boxes if has_room(box, taken) and (not plan or hides_none(box, lugs))]
        if not free:  # too many beside each other: those that have room stand for them
            continue
        chosen = next((box for box in free if hides_none(box, hooks)), free[0])
        taken.append(chosen)
        left, right, height = chosen
        marks.append(Mark("text", "sk-number", x=(left + right) / 2, y=height, text=name))
    return marks


def _carrying(rig: Rig, ropes: Mapping[str, FloatArray]) -> list[tuple[str, FloatArray]]:
    """Slings by their numbers, and other ropes at a load by their names, as of strand jacks: from above."""
    own = dict.fromkeys(rope for load in rig.loads for rope in load.other_ropes)
    named = {sling.rope: shortened_inside(sling.name) for sling in rig.slings} | {one: one for one in own}
    found = [(name, ropes[rope]) for rope, name in named.items() if rope in ropes]
    return [(name, path[::-1] if path[0, 2] < path[-1, 2] else path) for name, path in found]


def _row(names: list[str], row: list[tuple[float, float, FloatArray | None]]) -> list[Mark]:
    """Names of slings in a row, each with what leads from it to its sling."""
    marks = []
    for x, y, led in row:
        if led is not None:
            marks.append(Mark("line", "sk-leader", drawn_path(np.array([(x, y), led]))))
            marks.append(Mark("dot", "sk-led", x=float(led[0]), y=float(led[1])))
    numbers = [
        Mark("text", "sk-number", x=x, y=y, text=name) for name, (x, y, _) in zip(names, row, strict=True)
    ]
    return marks + numbers


def _box(mark: Mark) -> Box:
    """What a mark takes from numbers on paper."""
    if mark.kind == "text":
        return text_box(mark.x, mark.y, mark.text, mark.anchor)
    return around_dot(np.array([mark.x, mark.y]))


def _centres(moment: _Moment, paper: Paper) -> list[Mark]:
    marks = []
    for load in moment.rig.loads:
        if moment.has(load.body):
            centre = moment.place(load.body)
            turned = moment.turn(load.body)
            if any(load.centre_envelope):
                corners = _SIGNS * np.asarray(load.centre_envelope, dtype=np.float64)
                marks += paper.area(centre + corners @ turned.T, "sk-envelope")
            place = paper.place(centre)
            marks.append(Mark("centre", "sk-centre", x=float(place[0]), y=float(place[1])))
    return marks


def _hinges(moment: _Moment, paper: Paper) -> dict[str, FloatArray]:
    """Where on paper hinges hold loads then."""
    return {
        hinge.name: paper.place(moment.place(hinge.name))
        for hinge in moment.rig.hinges
        if moment.has(hinge.name) and is_shut(moment.recording, hinge)[moment.sample]
    }


def _sides(moment: _Moment, paper: Paper, solids: _Solids) -> dict[str, FloatArray]:
    """Where on paper a name stands beside the cylinder of each compensator, the middle of its right side."""
    sides = {}
    for one in moment.rig.compensators:
        if one.body in solids:
            points = paper.place(np.concatenate(solids[one.body][1]))
            sides[one.name] = np.array([points[:, 0].max(), points[:, 1].mean()])
    return sides


def _hooks(
    moment: _Moment,
    paper: Paper,
    ropes: Mapping[str, FloatArray],
    hinges: Mapping[str, FloatArray],
    sides: Mapping[str, FloatArray],
    *,
    plan: bool,
) -> list[Mark]:
    """Hooks as dots; in a side view with their names, where these do not lie on each other.

    And names of hinges, and of what else has one at its side.
    """
    names = _hook_bodies(moment)
    places = [paper.place(moment.place(name)) for name in names]
    marks = [Mark("dot", "sk-hook", x=float(x), y=float(y)) for x, y in places]
    if plan:
        return marks
    near = [paper.place(path) for name, path in ropes.items() if name not in moment.rig.outer_ropes]
    straight = [pair for path in near for pair in pairwise(path)]
    # The name of a hinge rather does not lie on the load, which goes from there to its middle.
    loads = {load.name: load.body for load in moment.rig.loads}
    turning = [one for one in moment.rig.hinges if one.name in hinges and one.load in loads]
    straight += [(hinges[one.name], paper.place(moment.place(loads[one.load]))) for one in turning]
    # A line takes its ends and some places between: enough for names, which are higher than those lie apart.
    along = [one + part * (other - one) for one, other in straight for part in (0.0, *_ALONG, 1.0)]
    drawn: list[Box] = [(float(x), float(x), float(y)) for x, y in along]
    places = [*places, *hinges.values(), *sides.values()]
    shown = [*_short(moment, names), *map(shortened_inside, hinges), *sides]
    placed = names_beside(places, shown, WIDTH - MARGIN, drawn)
    return marks + [Mark("text", "sk-name", x=x, y=y, text=text, anchor=side) for x, y, text, side in placed]


def _short(moment: _Moment, names: list[str]) -> list[str]:
    """Names of hooks without that of their crane, where there is one crane."""
    cranes = {hook.crane for hook in moment.rig.hooks}
    crane = next(iter(cranes)) if len(cranes) == 1 else ""
    return [name.removeprefix(f"{crane}.") if crane else name for name in names]


def _hook_bodies(moment: _Moment) -> list[str]:
    """Hooks that are bodies of the recording."""
    return [hook.name for hook in moment.rig.hooks if moment.has(hook.name)]
