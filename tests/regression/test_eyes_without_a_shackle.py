"""Slings with a shackle at one end were `ok` by its bow, whatever the eye at their other end bent about.

An eye of 64 mm on a pin of its own diameter keeps half of its strength, on a bow of 105 mm 61 %: where 90 %
of it was used by the bow, the pin would have had 110 %. Two shackles, one without a bow, were `not checked`.
"""

from __future__ import annotations

import pytest

from gantline.checks import check_recording
from gantline.checks.check import Check, Verdict
from gantline.simulation import simulate
from tanked_load import document, hold, lift

BOW, ROPE = 105.0, 64.0  # [mm]
BARE = "not checked, no shackle there, and about what the eye bends is not known ('bends_about' of the sling)"
FACTORS = ("load_factor", "consequence_factor", "material_factor", "termination_factor")


def _checks(ends: dict[str, str]) -> dict[str, Check]:
    rope = {
        "axial_stiffness": "2000 MN",
        "damping_time": "20 ms",
        "mass": "none",
        "diameter": f"{ROPE} mm",
        "minimum_breaking_force": "3 MN",
    }
    slings = {name: {**one, "shackles": ends} for name, one in document(None)["slings"].items()}
    scenario = lift(
        None,
        [hold("hang", "until_end")],
        duration="20 s",
        ropes={"stiff": rope},
        shackles={"bow": {"working_load_limit": "60 t", "bow_diameter": f"{BOW} mm"}},
        slings=slings,
        rules=dict.fromkeys(FACTORS, 1.1),
        limits={"rule": "a rule", "sling_bending_ratio": 1.5},
    )
    return {check.name: check for check in check_recording(simulate(scenario))}


@pytest.mark.parametrize(("end", "bare"), [("top", "bottom"), ("bottom", "top")])
def test_the_eye_at_the_other_end_is_told(end: str, bare: str) -> None:
    """D/d of the bow counts, and the check says that it is not all."""
    checks = _checks({end: "bow"})
    assert checks["sling_bending_ratio"].value == pytest.approx(BOW / ROPE)
    for name in ("sling_bending_ratio", "rope_load_of_breaking_force"):
        assert checks[name].verdict is Verdict.WARNING
        assert f"{BARE}: A {bare}, B {bare}" in checks[name].remark


def test_shackles_at_both_ends_leave_nothing_open() -> None:
    """So they are `ok`, as they were."""
    checks = _checks({"top": "bow", "bottom": "bow"})
    assert checks["sling_bending_ratio"].verdict is Verdict.OK
    assert checks["rope_load_of_breaking_force"].verdict is Verdict.OK
