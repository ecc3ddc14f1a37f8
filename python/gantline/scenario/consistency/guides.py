"""Whether landing guides fit the rest of the lift."""

from __future__ import annotations

from gantline.scenario.consistency.mechanics import of_slings_alone, yard_bodies
from gantline.scenario.errors import nearest
from gantline.scenario.findings import Findings
from gantline.scenario.model import Scenario

__all__ = ["check_guides"]


def check_guides(findings: Findings) -> None:
    """Note what is wrong with landing guides."""
    scenario = findings.scenario
    if scenario.guides and scenario.load is None:
        sentence = "there is no 'load' for guides to bring to its place"
        findings.add(("guides",), f"{sentence}; what bodies touch belongs under 'mechanics'")
    if scenario.guides:
        findings.refuse_explicit("guides")
    for name, guide in (scenario.guides or {}).items():
        if guide.holder is not None and (wrong := _no_holder(scenario, guide.holder)) is not None:
            findings.add(("guides", name, "held_by"), wrong)


def _no_holder(scenario: Scenario, name: str) -> str | None:
    """Why something cannot hold a post or a wall, and what can; nothing of one that can."""
    bodies = scenario.mechanics.bodies if scenario.mechanics is not None else {}
    load = scenario.load.name if scenario.load is not None else None
    known = [one for one in (*yard_bodies(scenario), *bodies) if one != load and one not in scenario.hooks]
    if name not in (*known, load):
        own = of_slings_alone(scenario, name)
        if name in scenario.hooks:
            own = f"'{name}' is a hook"
        right = "a vessel, a part of a crane or a body of 'mechanics' may hold a guide"
        sentence = own or f"'{name}' is not a vessel, a part of a crane or a body"
        return f"{sentence}; {nearest(name, known) if known and own is None else right}"
    on: str | None = name
    seen = set()
    while on in bodies and on not in seen:
        seen.add(on)
        on = bodies[on].parent
    if on is not None and on == load:
        what = "the load" if name == load else f"'{name}' is on the load, which"
        return f"{what} cannot hold its own guide; leave it out for a post or wall in the world"
    return None
