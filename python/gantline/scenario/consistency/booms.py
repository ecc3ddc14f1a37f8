"""Whether booms, what luffs them and the hooks at their heads can be built as written."""

from __future__ import annotations

import math

from gantline.scenario.consistency.hooks import check_carried_hook
from gantline.scenario.cranes.boom import FloatingCrane, PlacedBoom
from gantline.scenario.cranes.charts import Chart, boom_charts
from gantline.scenario.cranes.crawler import Crawler
from gantline.scenario.cranes.luffing import Tackles
from gantline.scenario.errors import nearest
from gantline.scenario.findings import Findings, Path
from gantline.scenario.plan.movers import mover
from gantline.scenario.plan.positions import boom_angles
from gantline.scenario.plan.steps import LuffStep
from gantline.scenario.rope_weight import check_rope_weight

__all__ = ["check_booms", "check_luffing"]


def check_booms(findings: Findings) -> None:
    """Note everything that is wrong with booms beyond the reeving of their hooks."""
    for chart in boom_charts(findings.scenario):
        _check_chart(findings, chart)
    for name, crane in (findings.scenario.cranes or {}).items():
        if isinstance(crane, FloatingCrane | Crawler):
            _check_own_charts(findings, name, crane)
        vessels = findings.scenario.vessels or {}
        if isinstance(crane, FloatingCrane) and crane.vessel is not None and crane.vessel not in vessels:
            sentence = f"'{crane.vessel}' is not a name of 'vessels'; {nearest(crane.vessel, vessels)}"
            findings.add(("cranes", name, "vessel"), sentence)
        if not isinstance(crane, FloatingCrane) or crane.outreach_from is not None or crane.slewing_axis:
            continue
        vessel = vessels.get(crane.vessel or "")
        if vessel is not None and vessel.hull.extent is None:
            sentence = f"the bow of '{crane.vessel}', whose hull is a mesh, is not known here"
            right = "say from where outreach counts, such as 'outreach_from: 105.6 m'"
            findings.add(("cranes", name, "outreach_from"), f"{sentence}; {right}")
    for placed in findings.scenario.booms.values():
        _check_angle(findings, placed)
        if placed.tackles is not None:
            _check_tackles(findings, placed, placed.tackles)
        for hook, one in placed.hooks.items():
            path = (*placed.path, "hooks", hook)
            check_carried_hook(findings, path, one, "boom")
            if not placed.boom.length + one.along > 0.0:
                length = f"{placed.boom.length:g} m"
                sentence = f"{one.along:g} m from the head of a boom of {length} is behind its heel pins"
                right = "outwards from the head is positive, such as '2.5 m'"
                findings.add((*path, "along"), f"{sentence}; {right}")


def check_luffing(findings: Findings) -> None:
    """Note steps that turn a boom in tackles by an angle from one that nobody knows before the run."""
    scenario = findings.scenario
    for place, (step, before) in enumerate(zip(scenario.plan, boom_angles(scenario), strict=True)):
        if not isinstance(step, LuffStep) or step.by is None:
            continue
        for text in step.moved:
            one = mover(scenario, step.kind, text)
            if one is not None and one.gear is not None and not before[one.name][1]:
                sentence = (
                    f"where '{one.name}' is by then only the run can tell, and with it how much rope to take"
                )
                right = f"write 'to: {math.degrees(before[one.name][0] + step.by):g} deg' or another angle"
                findings.add(("plan", place, "by"), f"{sentence}; {right}")


def _check_own_charts(findings: Findings, name: str, crane: FloatingCrane | Crawler) -> None:
    """Every hook has one chart, that of its crane or its own."""
    path: Path = ("cranes", name)
    own = [hook for hook, one in crane.hooks.items() if one.rating is not None]
    others = [hook for hook, one in crane.hooks.items() if one.rating is None]
    for hook in others if own and crane.rating is None else ():
        sentence = f"this hook has no rating chart, nor has {name}, and '{own[0]}' has one of its own"
        right = f"give it a 'rating' too, or {name} one for all hooks without their own"
        findings.add((*path, "hooks", hook), f"{sentence}; {right}")
    if crane.rating is not None and not others:
        sentence = f"each hook of {name} has a rating chart of its own, so that this one rates none"
        right = "leave it out, or the 'rating' of the hook that it is for"
        findings.add((*path, "rating"), f"{sentence}; {right}")
    for hook in own:
        rating = crane.hooks[hook].rating
        if rating is not None and rating.hooks_share is not None:
            sentence = f"this chart is for '{hook}' alone, which has the whole row"
            where = (*path, "hooks", hook, "rating", "hooks_share")
            findings.add(where, f"{sentence}; leave 'hooks_share' out")


def _check_chart(findings: Findings, of: Chart) -> None:
    """A chart counts from where its crane does: read from elsewhere it would rate another load."""
    crane, chart, path = (findings.scenario.cranes or {})[of.crane], of.rating, of.path
    if isinstance(crane, FloatingCrane) and crane.slewing_axis is None and chart.over == "radius":
        sentence = "this crane has no 'slewing_axis' from which a radius counts"
        counts = "the heel pins" if crane.vessel is None else "the bow"
        right = f"'outreach' is right, which counts from {counts}, or from another x as 'outreach_from' says"
        findings.add((*path, "radius"), f"{sentence}; {right}")
    slews = isinstance(crane, Crawler) or (
        isinstance(crane, FloatingCrane) and crane.slewing_axis is not None
    )
    if slews and chart.over == "outreach":
        sentence = "a crane that slews has no bow from which an outreach counts"
        findings.add((*path, "outreach"), f"{sentence}; 'radius' is right, from its slewing axis")


def _check_angle(findings: Findings, placed: PlacedBoom) -> None:
    if placed.luffing is None:
        return
    low, high = placed.luffing.range_
    angle = placed.boom.angle
    if not low <= angle <= high:
        found, least, most = (f"{math.degrees(one):g} deg" for one in (angle, low, high))
        findings.add(
            (*placed.path, "boom", "angle"), f"{found} is outside of the range of luffing, {least} to {most}"
        )


def _check_tackles(findings: Findings, placed: PlacedBoom, tackles: Tackles) -> None:
    path: Path = (*placed.path, "luffing", "tackles")
    ropes = findings.scenario.ropes or {}
    kind = ropes.get(tackles.rope)
    if kind is None:
        sentence = f"'{tackles.rope}' is not a name of 'ropes'; {nearest(tackles.rope, ropes)}"
        findings.add((*path, "rope"), sentence)
    elif kind.inextensible:
        sentence = f"rope '{tackles.rope}' is inextensible, and a rope on a drum has to stretch"
        findings.add((*path, "rope"), f"{sentence}; give it an axial stiffness")
    elif (bent := kind.bent(tackles.rope, "a luffing rope")) is not None:
        findings.add((*path, "rope"), bent)
    else:
        check_rope_weight(
            lambda key, sentence: findings.add((*path, key), sentence),
            tackles.rope,
            kind,
            tackles.rope_weight,
            over_sheaves="a luffing rope",
            gravity=findings.scenario.simulation.gravity,
        )
    gear, luffing = placed.gear, placed.luffing
    assert gear is not None and luffing is not None  # there are tackles
    for key in ("vertical_stiffness", "side_stiffness"):
        if getattr(placed.boom, key) is not None:
            sentence = "a boom in luffing tackles gives as their ropes stretch"
            findings.add((*placed.path, "boom", key), f"{sentence}; leave this out, or the tackles")
    steepest = luffing.range_[1]
    if not steepest < gear.direction < steepest + math.pi:
        found, most = (f"{math.degrees(one):g} deg" for one in (gear.direction, steepest))
        sentence = f"from the heel pins this is at {found}, and the boom goes up to {most}"
        right = "tackles pull it up from a top that is higher and behind"
        findings.add((*path, "from"), f"{sentence}; {right}")
