"""Whether the load is a body that can exist, and stands where it says it stands."""

from __future__ import annotations

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
    ground = findings.scenario.ground
    if base != "ground":
        findings.add(("load", "stands_on"), f"'{base}' cannot carry the load yet; 'ground' can")
    elif ground is None:
        sentence = "the load stands on the ground but there is no 'ground' in this file"
        findings.add(("load", "stands_on"), f"{sentence}; add 'ground: {{level: 0 m}}'")
    elif findings.scenario.load_has_settled and abs(load.position[2] - ground.level) > _STANDING:
        gap = load.position[2] - ground.level
        where = "above" if gap > 0 else "below"
        sentence = f"the load stands on the ground but its underside is {abs(gap):g} m {where} it"
        findings.add(("load", "position"), f"{sentence}; right is z = {ground.level:g} m")
