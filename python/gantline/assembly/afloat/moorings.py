"""Mooring lines and fenders into forces, ropes, flows and contacts."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np

from gantline.assembly.loads.underground import under_bottom, under_ground
from gantline.assembly.parts import Json, Parts, end, material
from gantline.assembly.ropes.rope_weight import add_free_rope, length_that_pulls, lump_rope
from gantline.assembly.ropes.route import most_strain, taut_length
from gantline.scenario import Scenario
from gantline.scenario.afloat.mooring import (
    Fender,
    MooringLine,
    fender_contact,
    line_rope,
    line_weight,
    weight_on_nodes,
)
from gantline.scenario.cranes.hooks import full_name
from gantline.scenario.errors import Doubt
from gantline.scenario.gear import RopeMaterial
from gantline.scenario.plan.movers import movers
from gantline.scenario.plan.parting import Parting, partings, steps_that_cut
from gantline.scenario.plan.steps import LineStep
from gantline.units import format_by_size, format_quantity

__all__ = [
    "add_moorings",
    "lost_pretensions",
    "mooring_rig",
    "warn_of_hauled",
    "winch_drive",
    "winch_flow",
]

#: Inertia of a winch [kg]: next to nothing beside a vessel.
_INERTIA = 1.0
#: Ropes of steel have 4500 to 5800 kg in a cubic metre of the circle about them, chains more, fibre ropes
#: less than 1200 [kg/m^3].
_STEEL_ROPE = 2500.0
#: Largest strain of a line at the start, but of one whose curve goes further [1].
_MOST_STRAIN = 0.1
#: Lines give and take some of their pretension until they balance; what keeps less has lost it [1].
_KEPT = 0.1


def winch_flow(line: str) -> str:
    """Name of the rope that the winch of a mooring line pays out, among the joints of a recording."""
    return f"{line_rope(line)}.winch"


def winch_drive(line: str) -> str:
    """Name of the drive of the winch of a mooring line."""
    return f"{winch_flow(line)}.drive"


def add_moorings(parts: Parts, scenario: Scenario) -> None:
    """Add mooring lines and fenders; the bodies that they hold are there.

    Raises:
        ScenarioError: if a line is too short for where its vessel is at the start.
    """
    kinds = scenario.ropes or {}
    parting = partings(scenario)
    for name, line in (scenario.mooring_lines or {}).items():
        if line.winch is not None:
            parts.add_drive(winch_drive(name))
            motor = {} if line.winch.capacity is None else {"capacity": line.winch.capacity}
            parts.add_flow(winch_flow(name), _INERTIA, drive=winch_drive(name), **motor)
        kind = kinds[line.rope]
        parts.doubts += _doubtful(scenario, name, line, kind)
        _check_length(parts, scenario, name, line, kind, parting[line_rope(name)])
        if line.type == "spring":
            _add_spring(parts, scenario, name, line, kind)
        elif line.type == "distributed":
            _add_distributed(parts, scenario, name, line, kind)
        else:
            parts.forces.append(_catenary(scenario, name, line, kind, parting[line_rope(name)]))
            if line.winch is not None:
                parts.flows[winch_flow(name)]["parent"] = line.vessel
    for name, fender in (scenario.fenders or {}).items():
        parts.contacts.append(_fender(name, fender))


def _doubtful(scenario: Scenario, name: str, line: MooringLine, kind: RopeMaterial) -> list[Doubt]:
    """What cannot well be meant of where a line is made fast, and of what it weighs under water."""
    doubts, path = list[Doubt](), ("mooring_lines", name)
    below = under_ground(scenario, line.to) or under_bottom(scenario, line.to)
    if below is not None and line.holder is None:
        sentence = f"mooring line {name} is made fast {below}: 'to' is a place in the world"
        doubts.append(Doubt((*path, "to"), sentence))
    if line.type == "catenary" and line.is_under_water and kind.diameter:
        density = kind.mass_per_length / (math.pi / 4 * kind.diameter**2)
        if density < _STEEL_ROPE:
            thick = format_quantity(kind.diameter, "mm", 0)
            shown = f"{kind.mass_per_length:.3g} kg/m of {thick}"
            weighs = f"mooring line {name} weighs under water what is left of as much steel"
            sentence = f"{weighs}; {shown} are no steel, and weigh less there, if they do not float"
            doubts.append(Doubt((*path, "rope"), sentence))
    return doubts


def warn_of_hauled(parts: Parts, scenario: Scenario, rope: str, length: float) -> None:
    """Warn of a step by which more of a line shall be hauled in than there is.

    Args:
        parts: The system, which has the doubt.
        scenario: The lift.
        rope: Name of the line among the ropes.
        length: Its length before [m].
    """
    winches = movers(scenario, "line")
    left = length
    for place, step in enumerate(scenario.plan):
        moved = [full_name(text, winches) for text in step.moved] if isinstance(step, LineStep) else []
        if not isinstance(step, LineStep) or not any(rope in (name, line_rope(name or "")) for name in moved):
            continue
        if step.by is None:
            return  # how far is known in a run
        left += step.sign * step.by
        if left <= 0.0:
            hauled = f"by step '{step.step}' {-left:.4g} m more are hauled in than there is of {rope}"
            parts.doubt(("plan", place, "by"), f"{hauled}, which is {length:.4g} m long at the start")
            return


def _check_length(
    parts: Parts, scenario: Scenario, name: str, line: MooringLine, kind: RopeMaterial, parting: Parting
) -> None:
    """A straight line of no more than its length pulls at least with its stretch: that must not break it."""
    path = ("mooring_lines", name)
    chord = _chord(parts, line)
    if chord == 0:
        raise scenario.start_error((*path, "to"), "is where the fairlead is; a line has two ends")
    limits = [limit for limit in (parting.breaks_at, kind.breaking_force) if limit is not None]
    strain = 0.0 if line.length is None else max(0.0, chord / line.length - 1)
    if strain > 0.0:
        pull, most = kind.pull(strain)[0], max(_MOST_STRAIN, most_strain(kind))
        if (limits and pull >= min(limits)) or strain > most:
            sentence = f"{line.length:g} m are too short for ends that are {chord:.6g} m apart at the start"
            raise scenario.start_error(
                (*path, "length"),
                f"{sentence}: it would pull with {pull / 1e3:.4g} kN; make it longer, or give 'pretension'",
            )
    if line.pretension is not None and limits and line.pretension >= min(limits):
        sentence = f"{line.pretension / 1e3:g} kN are more than it holds, {min(limits) / 1e3:.4g} kN"
        raise scenario.error((*path, "pretension"), f"{sentence}; pull less")
    if line.sea_bed is not None:
        above = float(parts.place(line.vessel, line.fairlead)[2]) - line.sea_bed
        if above <= 0:
            sentence = f"its fairlead is {-above:g} m below the sea bed at the start"
            raise scenario.start_error(
                (*path, "sea_bed"), f"{sentence}; the bed is lower, or the fairlead higher"
            )


def _add_spring(parts: Parts, scenario: Scenario, name: str, line: MooringLine, kind: RopeMaterial) -> None:
    """A rope from the vessel to where it is made fast; `kind` stretches."""
    length = line.length
    if line.pretension is not None:
        length = taut_length(_chord(parts, line), line.pretension, kind)
    drum = (winch_flow(name), 1.0) if line.winch is not None else None
    if length is not None:
        warn_of_hauled(parts, scenario, line_rope(name), length)
    route = [end(line.vessel, line.fairlead, drum), end(line.holder, line.to)]
    parts.add_rope(line_rope(name), length, material(kind), route)


def _chord(parts: Parts, line: MooringLine) -> float:
    """How far its ends are apart at the start [m]."""
    first, last = parts.place(line.vessel, line.fairlead), parts.place(line.holder, line.to)
    return float(np.linalg.norm(first - last))


def _add_distributed(
    parts: Parts, scenario: Scenario, name: str, line: MooringLine, kind: RopeMaterial
) -> None:
    """A rope of nodes from the vessel to where it is made fast; `kind` stretches and has a mass."""
    weight, path = weight_on_nodes(line, kind), ("mooring_lines", name)
    ends = [end(line.vessel, line.fairlead), end(line.holder, line.to)]
    length = line.length
    if line.pretension is not None:
        places = parts.place(line.vessel, line.fairlead), parts.place(line.holder, line.to)
        length, least = length_that_pulls(*places, line.pretension, kind, weight, scenario.simulation.gravity)
        if length is None:
            shown = format_by_size(line.pretension, "force")
            sentence = f"no length gives it a pretension of {shown}"
            own = f"its weight alone pulls with {format_by_size(least, 'force')}"
            raise scenario.start_error((*path, "pretension"), f"{sentence}; {own}")
    assert length is not None  # it has one of both
    lump_rope(parts, line_rope(name), weight, length, ends)
    add_free_rope(parts, scenario, path, line_rope(name), kind, weight, length, ends)
    _warn_of_wet(parts, scenario, name, weight.nodes)


def _warn_of_wet(parts: Parts, scenario: Scenario, name: str, nodes: int) -> None:
    """A line of nodes weighs what it weighs in air, also where it hangs in the water at the start."""
    if scenario.water is None:
        return
    rope = line_rope(name)
    places = [parts.bodies[f"{rope}/{number}"]["joint"]["position"] for number in range(1, nodes + 1)]
    deep = scenario.water.level - min(place[2] for place in places)
    if deep > 0.0:
        hangs = f"mooring line {name} hangs {format_quantity(deep, 'm', 1)} deep in the water at the start"
        sentence = (
            f"{hangs}, and its nodes weigh what they weigh in air: less length, or more pull, keeps it out"
        )
        parts.doubt(("mooring_lines", name), sentence)


def _catenary(scenario: Scenario, name: str, line: MooringLine, kind: RopeMaterial, parting: Parting) -> Json:
    said = {
        "length": line.length,
        "pretension": line.pretension,
        "sea_bed": line.sea_bed,
        "winch": winch_flow(name) if line.winch is not None else None,
        "breaking_force": parting.breaks_at,
        "cut_at": parting.cut_at,
    }
    return {
        "type": "mooring",
        "name": line_rope(name),
        "body": line.vessel,
        "at": list(line.fairlead),
        "to": list(line.to),
        "weight": line_weight(scenario, line),
        "axial_stiffness": kind.stiffness,
        "damping_time": kind.damping_time,
        **{key: value for key, value in said.items() if value is not None},
    }


def lost_pretensions(scenario: Scenario, tensions: Mapping[str, float]) -> list[str]:
    """A sentence for each vessel whose mooring lines have lost their pretension where a lift begins at rest.

    She has gone to where all that pulls her balances. Short lines of steel are slack after some millimetres,
    for which a gap before her fenders is enough: that is no metre, of which `adrift` tells.

    Args:
        scenario: The lift.
        tensions: Tensions of ropes there by their names [N].
    """
    lost: dict[str, list[str]] = {}
    for name, line in (scenario.mooring_lines or {}).items() if scenario.starts_at_rest else ():
        pull = tensions.get(line_rope(name))
        if line.pretension is not None and pull is not None and pull < _KEPT * line.pretension:
            lost.setdefault(line.vessel, []).append(name)
    rests = "she rests where lines, fenders and all else balance, and there they are slack or nearly so"
    right = "see where they lead, and how far she is off her fenders"
    begin = "pull less than a tenth of their pretension at the start"
    return [
        f"mooring lines of {vessel} {begin}: {', '.join(names)}; {rests}: {right}"
        for vessel, names in lost.items()
    ]


def _fender(name: str, fender: Fender) -> Json:
    """A contact of a point with an upright plane, in front of the wall by the thickness of the fender."""
    normal = np.array(fender.normal)
    point = np.array([*fender.wall, 0.0]) + fender.thickness * normal
    return {
        "name": fender_contact(name),
        "group": fender_contact(name),
        "body": fender.vessel,
        "at": list(fender.at),
        **({} if fender.wall_body is None else {"plane_body": fender.wall_body}),
        "plane_point": point.tolist(),
        "plane_normal": normal.tolist(),
        "stiffness": fender.stiffness,
        "damping_time": fender.damping / fender.stiffness,
        "friction": fender.friction,
    }


def mooring_rig(scenario: Scenario) -> Json:
    """What results need to know of mooring lines and fenders; nothing in a lift without."""
    kinds = scenario.ropes or {}
    lines = [
        {
            "name": name,
            "rope": line_rope(name),
            "minimum_breaking_force": kinds[line.rope].breaking_force,
            "slipping_winch": winch_flow(name) if line.winch is not None and line.winch.capacity else None,
            "let_go_in": steps_that_cut(scenario, line_rope(name)),
            **({"hanging_weight": line_weight(scenario, line)} if line.type == "catenary" else {}),
        }
        for name, line in (scenario.mooring_lines or {}).items()
    ]
    fenders = [
        {
            "name": name,
            "contact": fender_contact(name),
            "capacity": fender.capacity,
            "thickness": fender.thickness,
        }
        for name, fender in (scenario.fenders or {}).items()
    ]
    return {key: given for key, given in (("mooring_lines", lines), ("fenders", fenders)) if given}
