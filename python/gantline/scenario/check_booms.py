"""Whether booms, what luffs them and the hooks at their heads can be built as written."""

from __future__ import annotations

import math

from gantline.scenario.boom import FloatingCrane, PlacedBoom
from gantline.scenario.check_hooks import check_carried_hook
from gantline.scenario.errors import nearest
from gantline.scenario.findings import Findings

__all__ = ["check_booms"]


def check_booms(findings: Findings) -> None:
    """Note everything that is wrong with booms beyond the reeving of their hooks."""
    for name, crane in (findings.scenario.cranes or {}).items():
        vessels = findings.scenario.vessels or {}
        if isinstance(crane, FloatingCrane) and crane.vessel is not None and crane.vessel not in vessels:
            sentence = f"'{crane.vessel}' is not a name of 'vessels'; {nearest(crane.vessel, vessels)}"
            findings.add(("cranes", name, "vessel"), sentence)
        if isinstance(crane, FloatingCrane) and crane.vessel in vessels and crane.outreach_from is None:
            if vessels[crane.vessel].hull.extent is None:
                sentence = f"the bow of '{crane.vessel}', whose hull is a mesh, is not known here"
                right = "say from where outreach counts, such as 'outreach_from: 105.6 m'"
                findings.add(("cranes", name, "outreach_from"), f"{sentence}; {right}")
    for placed in findings.scenario.booms.values():
        _check_angle(findings, placed)
        for hook, one in placed.hooks.items():
            check_carried_hook(findings, (*placed.path, "hooks", hook), one, "boom")


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
