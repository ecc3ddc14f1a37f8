"""Eyes of slings on what is no shackle: the prong of a hook, a pin, a trunnion.

What bending takes of the rope there is (K5) of its diameter, 1/(1 - 0.5/sqrt(D/d)), as over the bow of a
shackle; of two ends the sharper counts.
"""

from __future__ import annotations

import math
from typing import Any

import pytest

from gantline.checks import check_recording
from gantline.checks.check import Check, Verdict
from gantline.scenario import ScenarioError
from gantline.statics import Statics
from tanked_load import document, hold, lift

BOW, ROPE, BREAKS = 105.0, 64.0, 3e6  # [mm], [mm], [N]
FACTORS = ("load_factor", "consequence_factor", "material_factor", "termination_factor")


def checks_of(defaults: dict[str, Any], own: dict[str, Any]) -> dict[str, Check]:
    """Of four slings of 64 mm that carry a load, all as these words say, at rest."""
    rope = {
        "axial_stiffness": "2000 MN",
        "damping_time": "20 ms",
        "mass": "none",
        "diameter": f"{ROPE} mm",
        "minimum_breaking_force": f"{BREAKS} N",
    }
    slings = {name: {**one, **own} for name, one in document(None)["slings"].items()}
    scenario = lift(
        None,
        [hold("hang", "until_end")],
        duration="20 s",
        ropes={"stiff": rope},
        shackles={"bow": {"working_load_limit": "60 t", "bow_diameter": f"{BOW} mm"}},
        sling_defaults=defaults,
        slings=slings,
        rules=dict.fromkeys(FACTORS, 1.1),
        limits={"rule": "a rule", "sling_bending_ratio": 1.0},
    )
    return {check.name: check for check in check_recording(Statics(scenario).equilibrium().recording)}


@pytest.mark.parametrize(
    ("ends", "diameter"),
    [
        ({"bends_about": {"top": "300 mm", "bottom": "160 mm"}}, 160.0),
        ({"bends_about": {"top": "80 mm"}, "shackles": {"bottom": "bow"}}, 80.0),
        ({"bends_about": {"bottom": "300 mm"}, "shackles": {"top": "bow"}}, BOW),
    ],
)
def test_the_sharper_end_counts(ends: dict[str, Any], diameter: float) -> None:
    """D/d by the smaller diameter, and what it leaves of 3 MN with four factors of which three multiply."""
    checks = checks_of({}, ends)
    assert checks["sling_bending_ratio"].value == pytest.approx(diameter / ROPE)
    assert checks["sling_bending_ratio"].verdict is Verdict.OK
    bending = 1.0 / (1.0 - 0.5 / math.sqrt(diameter / ROPE))
    used = checks["rope_load_of_breaking_force"]
    factor = BREAKS / (checks["rope_factor_on_breaking_force"].value or 0.0)
    assert used.value == pytest.approx(factor * 1.1**3 * max(1.1, bending) / BREAKS, rel=1e-9)
    assert "not known" not in used.remark


def test_shackles_of_a_sling_take_the_place_of_what_all_lie_on() -> None:
    """And what a sling lies on for itself that of the shackles of all others."""
    ends = {"bends_about": {"top": "70 mm", "bottom": "80 mm"}}
    assert checks_of(ends, {})["sling_bending_ratio"].value == pytest.approx(70 / ROPE)
    own = {"shackles": {"top": "bow"}}
    assert checks_of(ends, own)["sling_bending_ratio"].value == pytest.approx(80 / ROPE)


@pytest.mark.parametrize(
    ("defaults", "own", "message"),
    [
        (
            {},
            {"shackles": {"top": "bow"}, "bends_about": {"top": "80 mm"}},
            "bends_about.top: the top has a shackle, whose 'bow_diameter' the eye lies on; leave it out",
        ),
        (
            {"shackles": {"bottom": "bow"}, "bends_about": {"bottom": "80 mm"}},
            {},
            "sling_defaults.bends_about.bottom: the bottom has a shackle",
        ),
        (
            {"shackles": {"bottom": "bow"}},
            {"bends_about": {"bottom": "80 mm"}},
            "bends_about.bottom: the bottom has a shackle",
        ),
        (
            {},
            {"bends_about": {"top": "80 m"}},
            "80000 mm is no diameter for the eye of a sling; from 4 mm to 5 m is right",
        ),
    ],
)
def test_one_end_lies_on_one_thing(defaults: dict[str, Any], own: dict[str, Any], message: str) -> None:
    """Refused in one sentence, whichever of both is for all slings."""
    with pytest.raises(ScenarioError) as refused:
        checks_of(defaults, own)
    assert message in str(refused.value)
