"""Whether the load is a body that can exist, and stands where it says it stands."""

from __future__ import annotations

from gantline.scenario.check_supports import top_of
from gantline.scenario.errors import nearest
from gantline.scenario.findings import Findings
from gantline.scenario.load import Load, LoadInertia

__all__ = ["check_load"]

#: A load at rest may be given this far from the ground it stands on [m].
_STANDING = 1e-3
_ROUNDING = 1 + 1e-9
_FROM = "positions are measured from its bottom centre"


def check_load(findings: Findings, load: Load) -> None:
    """Note everything that is wrong with the load."""
    length, breadth, height = load.shape.box
    x, y, z = load.centre_of_gravity.at
    if abs(x) > length / 2 or abs(y) > breadth / 2 or not 0 <= z <= height:
        sentence = f"({x:g}, {y:g}, {z:g}) m is outside the load's box; {_FROM}"
        findings.add(("load", "centre_of_gravity", "at"), sentence)
    types = findings.scenario.lug_types or {}
    for name, lug in load.lugs.items():
        if lug.type is not None and lug.type not in types:
            sentence = f"'{lug.type}' is not a name of 'lug_types'; {nearest(lug.type, types)}"
            findings.add(("load", "lugs", name, "type"), sentence)
        beside = max(abs(lug.at[0]) - length / 2, abs(lug.at[1]) - breadth / 2)
        off = max(beside, -lug.at[2], lug.at[2] - height)
        if off > max(load.shape.box) / 2:
            findings.add(
                ("load", "lugs", name, "at"), f"this lug is {off:g} m outside the load's box; {_FROM}"
            )
    if isinstance(load.inertia, LoadInertia):
        _check_inertia(findings, load.inertia)
    if load.stands_on is not None:
        _check_standing(findings, load, load.stands_on)
    if findings.scenario.simulation.gravity == 0:
        findings.add(("simulation", "gravity"), "gravity is zero; a load needs gravity above zero")


def _check_inertia(findings: Findings, inertia: LoadInertia) -> None:
    a, b, c = inertia.xx, inertia.yy, inertia.zz
    d, e, f = inertia.xy, inertia.xz, inertia.yz
    minor = a * b - d * d
    determinant = a * (b * c - f * f) - d * (d * c - f * e) + e * (d * f - b * e)
    largest = max(a, b, c)
    if largest > (a + b + c - largest) * _ROUNDING or minor <= 0 or determinant <= 0:
        sentence = "no body has such an inertia; each of xx, yy, zz is at most the sum of the other two"
        findings.add(("load", "inertia"), f"{sentence}, and products are small")


def _check_standing(findings: Findings, load: Load, base: str) -> None:
    scenario = findings.scenario
    ground, supports = scenario.ground, scenario.supports or {}
    if base in supports:
        _check_on_supports(findings, load, base)
    elif base != "ground":
        sentence = f"'{base}' is not a group of 'supports' and not 'ground'"
        findings.add(("load", "stands_on"), f"{sentence}; {nearest(base, ['ground', *supports])}")
    elif ground is None:
        sentence = "the load stands on the ground but there is no 'ground' in this file"
        findings.add(("load", "stands_on"), f"{sentence}; add 'ground: {{level: 0 m}}'")
    elif findings.scenario.load_has_settled and abs(load.position[2] - ground.level) > _STANDING:
        gap = load.position[2] - ground.level
        where = "above" if gap > 0 else "below"
        sentence = f"the load stands on the ground but its underside is {abs(gap):g} m {where} it"
        findings.add(("load", "position"), f"{sentence}; right is z = {ground.level:g} m")


def _check_on_supports(findings: Findings, load: Load, group: str) -> None:
    top = top_of(findings.scenario, group)
    if findings.scenario.start == "settled":
        sentence = "'settled' is for a load on the ground"
        findings.add(("start",), f"{sentence}; one on supports starts at 'rest', or 'as_given'")
    elif findings.scenario.load_has_settled and abs(load.position[2] - top) > _STANDING:
        gap = load.position[2] - top
        where = "above" if gap > 0 else "below"
        sentence = (
            f"the load stands on {group} but its underside is {abs(gap):g} m {where} the highest of them"
        )
        findings.add(("load", "position"), f"{sentence}; right is z = {top:g} m")
