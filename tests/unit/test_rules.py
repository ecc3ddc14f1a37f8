"""Rules, limits, lug types and groups of hooks in a lift file, and what checks get of them."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from gantline.assembly import assemble
from gantline.results.rig import Rig
from gantline.rule_data import FACTORS, PRESETS, SIDE_LOAD, dynamic_factor
from gantline.scenario import parse_scenario
from gantline.scenario.limits import Limits, Rules
from lift_text import BASE, MECHANICS, spoiled

LIMITS = "limits: {rule: example, load_tilt: 2 deg}"


def rig(limits: str, text: str = BASE) -> dict[str, Any]:
    return assemble(parse_scenario(text.replace(LIMITS, limits))).rig


def test_presets_name_what_lift_files_can_set() -> None:
    assert set(FACTORS) == set(Rules.model_fields) - {"preset", "several_cranes", "shackle_side_load"}
    for preset in PRESETS.values():
        assert preset.title
        assert set(preset.factors) <= set(FACTORS)
        assert set(preset.limits) <= set(Limits.model_fields) - {"rule"}
        for one in (*preset.factors.values(), *preset.limits.values()):
            assert one.source and one.value > 0.0
        assert bool(preset.dynamic) == bool(preset.dynamic_source)


# 0027/ND rev 11, table 5-1; below 3 t as 3 t, up to 100 t offshore 1 + 0.25 sqrt(100/weight).
TABLE = [
    ("onshore", 50.0, 1.10),
    ("onshore", 100.0, 1.10),
    ("onshore", 100.1, 1.05),
    ("onshore", 1000.0, 1.05),
    ("onshore", 5000.0, 1.03),
    ("inshore", 25.0, 1.07 + 0.05 * 2.0),
    ("inshore", 300.0, 1.12),
    ("inshore", 367.5, 1.10),
    ("offshore", 1.0, 1.0 + 0.25 * math.sqrt(100 / 3)),
    ("offshore", 25.0, 1.0 + 0.25 * 2.0),
    ("offshore", 2500.0, 1.15),
    ("offshore", 2501.0, 1.10),
]


@pytest.mark.parametrize(("place", "tonnes", "factor"), TABLE)
def test_dynamic_amplification_factor_by_weight(place: str, tonnes: float, factor: float) -> None:
    found = dynamic_factor(PRESETS[f"nd_0027_{place}"], 1e3 * tonnes)
    assert found is not None
    assert found.value == pytest.approx(factor)
    assert place in found.source


def test_a_factor_by_weight_needs_a_weight() -> None:
    assert dynamic_factor(PRESETS["nd_0027_onshore"], None) is None
    found = dynamic_factor(PRESETS["example_yard"], None)
    assert found is not None
    assert found.value == 1.05


def test_what_the_lift_file_says_goes_before_the_preset() -> None:
    """60 t with a contingency of 1.05 are 63 t: onshore 1.10."""
    of = rig(
        "rules: {preset: nd_0027_onshore, wear_factor: 1.2}\nlimits: {rule: own, sling_bending_ratio: 2}"
    )
    assert of["factors"]["wear_factor"] == {"value": 1.2, "source": "own"}
    assert of["factors"]["dynamic_amplification_factor"]["value"] == pytest.approx(1.10)
    assert of["factors"]["consequence_factor"]["source"].startswith("0027/ND rev 11, 7.5.1")
    assert "termination_factor" not in of["factors"]
    assert of["limits"] == {"rule": "own", "sling_bending_ratio": 2.0}
    assert of["limit_sources"] == {"sling_bending_ratio": "own"}


def test_limits_of_a_preset() -> None:
    of = rig("rules: {preset: example_yard}\nlimits: {load_tilt: 1 deg}")
    assert of["limits"]["rule"] == "A yard's own rule, for example"
    assert of["limits"]["load_tilt"] == pytest.approx(math.radians(1.0))
    assert of["limits"]["lug_out_of_plane_angle"] == pytest.approx(math.radians(10.0))
    assert of["limit_sources"]["load_tilt"] == "lift file"
    assert of["limit_sources"]["lug_out_of_plane_angle"] == "plausible, no document"


def test_the_chart_of_side_loads() -> None:
    of = rig(LIMITS)["shackle_side_load"]
    assert [tuple(row) for row in of["rows"]] == list(SIDE_LOAD)
    assert of["source"] == "Crosby side loading reduction chart"
    own = "rules: {shackle_side_load: [{up_to: 5 deg, remains: 100 %}, {up_to: 45 deg, remains: 70 %}]}"
    of = rig(f"{own}\n{LIMITS}")["shackle_side_load"]
    assert of["source"] == "example"
    assert np.array(of["rows"]) == pytest.approx(
        np.array([[math.radians(5.0), 1.0], [math.radians(45.0), 0.7]])
    )


def test_lug_types() -> None:
    text = spoiled(
        "    L3: {at: [ 0 m, 0 m, 3 m], capacity: 40 t}\n", "    L3: {at: [0 m, 0 m, 3 m], type: P}\n"
    )
    text = text.replace("load:\n", "lug_types: {P: {main_plate: yz, capacity: 50 t}}\nload:\n")
    lugs = rig(LIMITS, text)["loads"][0]["lugs"]
    assert (lugs["L3"]["capacity"], lugs["L3"]["main_plate_normal"]) == (50e3 * 9.81, [1.0, 0.0, 0.0])
    assert (lugs["L1"]["capacity"], lugs["L1"]["main_plate_normal"]) == (40e3 * 9.81, [0.0, 1.0, 0.0])
    both = text.replace("type: P}", "type: P, main_plate: xz}")
    lug = rig(LIMITS, both)["loads"][0]["lugs"]["L3"]
    assert (lug["capacity"], lug["main_plate_normal"]) == (50e3 * 9.81, [0.0, 1.0, 0.0])
    oblique = text.replace("main_plate: yz", "main_plate: {turned: 30 deg}")
    oblique = oblique.replace("3 m], capacity", "3 m], main_plate: {normal: [0, 3, -4]}, capacity", 1)
    lugs = rig(LIMITS, oblique)["loads"][0]["lugs"]
    # (cos 30, sin 30, 0) lies in it.
    assert lugs["L3"]["main_plate_normal"] == pytest.approx([-0.5, math.sqrt(0.75), 0.0], abs=1e-15)
    assert lugs["L1"]["main_plate_normal"] == pytest.approx([0.0, 0.6, -0.8], abs=1e-15)


def test_rated_capacities_of_hooks_and_their_groups() -> None:
    group = "hook_groups: {upper: {type: trolley, hooks: hook, rated_capacity: 90 t}}\n"
    found = Rig.from_json(rig(group + LIMITS)).ratings
    assert [(one.name, one.level, tuple(one.hooks)) for one in found] == [
        ("hook", "hook", ("hook",)),
        ("upper", "trolley", ("hook",)),
    ]
    assert [one.rated_capacity for one in found] == [100e3 * 9.81, 90e3 * 9.81]


def test_a_rig_without_ratings_has_those_of_its_hooks() -> None:
    old = {"hooks": [{"name": "h", "rated_capacity": 5.0, "rating_includes_hook_block": True}]}
    (one,) = Rig.from_json(old).ratings
    assert (one.name, one.level, one.rated_capacity, one.includes_hook_block) == ("h", "hook", 5.0, True)


def test_the_smallest_bend_of_each_rope() -> None:
    """Half turns on moving sheaves are 0.8 m, that over the fixed sheave of 0.8 m."""
    (bend,) = rig(LIMITS)["bends"]
    assert (bend["rope"], bend["diameter"]) == ("e1.equalizing", pytest.approx(0.8))
    small = BASE.replace("fixed_sheaves: {along: [0 m], below_hook: 3 m, pitch_diameter: 0.8 m}",
                         "fixed_sheaves: {along: [0 m], below_hook: 3 m, pitch_diameter: 0.5 m}")  # fmt: skip
    (bend,) = rig(LIMITS, small)["bends"]
    assert (bend["element"], bend["diameter"]) == ("e1.equalizing/sheave_2", pytest.approx(0.5))


def test_ropes_of_mechanics_bend_about_their_sheaves() -> None:
    """A half turn from x = -0.2 m to 0.2 m."""
    (bend,) = assemble(parse_scenario(MECHANICS)).rig["bends"]
    assert bend == {"rope": "rope", "element": "rope/sheave_1", "diameter": pytest.approx(0.4)}


def test_the_rig_tells_which_sheaves_are_locked() -> None:
    assert rig(LIMITS)["equalizers"][0]["locked"] == []
    pinned = spoiled("travel: {up: 1 m, down: 1 m}", "travel: {up: 1 m, down: 1 m, locked: true}")
    adaptive = pinned.replace("integrator: del, step: 1 ms", "integrator: adaptive")
    assert rig(LIMITS, adaptive)["equalizers"][0]["locked"] == ["e1.1", "e1.2"]
    for word in ("2", "[2]"):  # counted out, one sheave of two
        some = adaptive.replace("locked: true", f"locked: {word}")
        assert rig(LIMITS, some)["equalizers"][0]["locked"] == ["e1.2"]


def test_the_bound_of_equalising_is_no_limit() -> None:
    """It is a field of the rig, with a default of 5 %; whoever sets it gets no check of it."""
    of = rig("limits: {equalised_below: 2 %, load_tilt: 1 deg}\n")
    assert of["equalised_below"] == pytest.approx(0.02)
    assert set(of["limits"]) == set(of["limit_sources"]) == {"load_tilt"}
    assert Rig.from_json(of).equalised_below == pytest.approx(0.02)
    assert Rig.from_json(rig("limits: {load_tilt: 1 deg}\n")).equalised_below == 0.05
