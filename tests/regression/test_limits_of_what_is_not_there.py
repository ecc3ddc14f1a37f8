"""Limits of a lift file that the lift has nothing for were lost in a count.

`wind_of_limit: 80 %` of a lift in the hook of a crane that is no Goliath crane, or `freeboard: 1 m` of a
barge that the lift file does not have as a vessel, are held against nothing, and the verdict was a GO with
"2 not checked". It names them now. Limits of presets, which are for every lift, stay in the count. A limit
that a later version of gantline knows was `not checked` too, and is a warning: nobody knows whether it held.
"""

from __future__ import annotations

from typing import Any

from gantline.checks import Check, Verdict, check_recording, verdict_of
from sample_lift import ringing_lift, sample_rig

_VAIN = "; the lift has nothing that these limits are about: "


def checks(sources: dict[str, str] | None = None, **limits: Any) -> list[Check]:
    """Of a lift without vessel, wind and Goliath crane."""
    rig = sample_rig(**limits)
    rig["limit_sources"] = {name: "lift file" for name in limits} if sources is None else sources
    return check_recording(ringing_lift(rig=rig))


def test_the_verdict_names_them() -> None:
    """In the order of the table, behind the counts."""
    found = checks(freeboard=1.0, wind_of_limit=0.8, load_tilt=0.04)
    vain = [check for check in found if check.is_vain]
    assert [(check.name, check.verdict) for check in vain] == [
        ("wind_of_limit", Verdict.NOT_CHECKED),
        ("freeboard", Verdict.NOT_CHECKED),
    ]
    assert all(check.to_json()["is_vain"] for check in vain)
    assert verdict_of(found).endswith(f"{_VAIN}wind_of_limit, freeboard")
    assert "that this limit is about" in vain[0].remark


def test_what_is_checked_or_of_a_preset_is_not_named() -> None:
    """The same limit of a preset, and limits that are held against something."""
    assert _VAIN not in verdict_of(checks(load_tilt=0.04))
    of_preset = checks(sources={"wind_of_limit": "plausible, no document"}, wind_of_limit=0.8)
    assert _VAIN not in verdict_of(of_preset)
    assert next(one for one in of_preset if one.name == "wind_of_limit").verdict is Verdict.NOT_CHECKED


def test_a_limit_of_a_later_version_is_a_warning() -> None:
    """Of a quantity, and of what a step requires."""
    rig = sample_rig(colour=1.0)
    rig["plan"][0]["require"] = {"shade": {"below": 1.0}}
    found = {check.name: check for check in check_recording(ringing_lift(rig=rig))}
    for name, said in (
        ("colour", "this limit is not known here"),
        ("shade", "this quantity is not known here"),
    ):
        assert (found[name].verdict, found[name].remark) == (Verdict.WARNING, said)
