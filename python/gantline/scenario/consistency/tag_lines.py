"""Whether tag lines fit the rest of the lift."""

from __future__ import annotations

from gantline.scenario.consistency.mechanics import of_slings_alone, yard_bodies
from gantline.scenario.errors import nearest
from gantline.scenario.findings import Findings, Path
from gantline.scenario.tag_line import TagLine, tag_rope

__all__ = ["check_tag_lines"]


def check_tag_lines(findings: Findings) -> None:
    """Note everything that is wrong with tag lines."""
    scenario = findings.scenario
    lines = scenario.tag_lines or {}
    if lines and scenario.load is None:
        sentence = "there is no 'load' for tag lines to hold"
        findings.add(("tag_lines",), f"{sentence}; ropes of bodies belong under 'mechanics'")
        return
    plain = scenario.mechanics
    known = [*yard_bodies(scenario), *(plain.bodies if plain is not None else {})]
    for name, line in lines.items():
        path: Path = ("tag_lines", name)
        if plain is not None and tag_rope(name) in (plain.ropes or {}):
            sentence = f"'{tag_rope(name)}' is already the name of a rope of 'mechanics'"
            findings.add(path, f"{sentence}; use another name")
        if line.held_by is not None and line.held_by not in (*known, "world"):
            right = nearest(line.held_by, known)
            own = of_slings_alone(scenario, line.held_by)
            if own is not None:
                right = "a vessel, a part of a crane, a hook or a body may hold a tag line"
            sentence = own or f"'{line.held_by}' is not a vessel, a part of a crane or a body"
            findings.add((*path, "held_by"), f"{sentence}; {right}")
        elif scenario.load is not None and line.held_by == scenario.load.name:
            sentence = "the load cannot hold its own tag line"
            findings.add((*path, "held_by"), f"{sentence}; leave it out for a place in the yard")
        _check_rope(findings, path, line)


def _check_rope(findings: Findings, path: Path, line: TagLine) -> None:
    kinds = findings.scenario.ropes or {}
    kind = kinds.get(line.rope)
    if kind is None:
        findings.add((*path, "rope"), f"'{line.rope}' is not a name of 'ropes'; {nearest(line.rope, kinds)}")
    elif kind.inextensible:
        sentence = f"rope '{line.rope}' does not stretch, which a tag line has to"
        findings.add((*path, "rope"), f"{sentence}; give it an 'axial_stiffness' or a 'construction'")
    elif line.pull is not None and (bent := kind.bent(line.rope, "a line whose 'pull' is kept")) is not None:
        findings.add((*path, "rope"), f"{bent}, or make the line fast: 'pretension' in place of 'pull'")
    elif line.winch is not None and (bent := kind.bent(line.rope, "a line on a winch")) is not None:
        findings.add((*path, "rope"), f"{bent}, or leave 'winch' out")
