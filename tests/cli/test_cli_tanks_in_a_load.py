"""What the program says of tanks in a load: mistakes in the lift file, table, report and warnings."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from gantline.assembly import assemble
from gantline.cli.summary import weights
from gantline.results.rig import Rig
from gantline.scenario import ScenarioError
from gantline.simulation import Simulation
from program import called
from tanked_load import document, hold, lift, pump, tank

INSIDE = {"inside": tank((0, 0, 0.5), 24.0)}
OUT = ("module.inside", "sea")
SEA_AROUND = {"water": {"level": "0 m"}}
GROUND = {"ground": {"level": "0 m"}}
WET: dict[str, Any] = {"added_mass": ["50 t", "80 t", "150 t"], "drag_coefficients": [1.2, 1.2, 1.8]}


@pytest.mark.parametrize(
    ("given", "said"),
    [
        (
            {"tanks": {"inside": tank((0, 0, 0.5), 50.0)}},
            "load.tanks.inside.content: 50 t do not go into it; it holds 49.2 t",
        ),
        (
            {"tanks": {"inside": tank((5, 0, 0.5), 5.0)}},
            "load.tanks.inside: it goes from 3 m to 7 m along x, the load's box from -6 m to 6 m; "
            "a tank is inside of it",
        ),
        (
            {"plan": [pump("drain", ("module.insid", "sea"), "600 t/h", by="3 t")]},
            "step 'drain', plan[1].pump.from: 'module.insid' is not a tank, nor 'sea'; did you mean "
            "'module.inside'?",
        ),
        (
            {"plan": [pump("drain", OUT, "600 t/h", by="30 t")]},
            "step 'drain', plan[1].by: 'module.inside' would run empty: 30 t are pumped from it, and "
            "24 t are in it then",
        ),
        (
            {"plan": [pump("fill", OUT[::-1], "600 t/h", by="3 t")]},
            "step 'fill', plan[1].pump.from: there is no sea in this file: nothing in it has a hull, "
            "and it has no "
            "'water'; 'water: {level: 0 m}' says where it is",
        ),
        (
            {"plan": [pump("fill", OUT[::-1], "600 t/h", by="30 t")], **SEA_AROUND},
            "step 'fill', plan[1].by: 'module.inside' would run over: 30 t are pumped into it, and "
            "there is room for "
            "25.2 t then",
        ),
        (
            {"plan": [{"step": "drain", "pump": {"from": "module.inside"}, "rate": "9 t/h", "by": "3 t"}]},
            "step 'drain', plan[1].pump: 'to' is missing, where it goes: a tank, or 'sea', which is "
            "all outside of tanks",
        ),
        (
            {"plan": [{"step": "drain", "drain": "module.inside", "rate": "9 t/h", "by": "3 t"}]},
            "step 'drain', plan[1]: 'drain' is not what a step can do; did you mean 'pump'?",
        ),
        (
            {"plan": [pump("drain", OUT, "600 t/h", until={"load_transferred": "50 %"})], **GROUND},
            "step 'drain', plan[1].until: this waits for a share of a weight that changes: from 0 t to "
            "24 t may be in the "
            "tanks of the load by then; wait for 'supports' or 'hoist_load', or pump 'by' an amount in a "
            "step of its own before",
        ),
        (
            {"tanks": {"in_water": tank((0, 0, 0.5), 5.0)}},
            "load.tanks.in_water: 'module.in_water' means what water does to it; this tank needs "
            "another name",
        ),
        (
            {"load": {"in_water": {**WET, "displaced_volume": "20 m^3"}}, **SEA_AROUND},
            "load.in_water.displaced_volume: 20 m^3 are no more than the inside of its tanks, 48 m^3; it "
            "displaces that and its members, and what is in the tanks weighs as given",
        ),
        (
            {"load": {"ballast": "20 t"}},
            "load.ballast: 'ballast' is not a key of the load: liquid in it stands under its 'tanks', such "
            "as 'tanks: {inside: {box: [4 m, 4 m, 3 m], bottom: [0 m, 0 m, 0 m], content: 20 t}}'",
        ),
    ],
)
def test_mistakes(given: dict[str, Any], said: str) -> None:
    with pytest.raises(ScenarioError) as found:
        lift(given.pop("tanks", INSIDE), given.pop("plan", ()), **given)
    assert len(found.value.problems) == 1
    assert str(found.value) == f"scenario.yaml:1: {said}"


def test_a_mistake_ends_with_two(tmp_path: Path) -> None:
    lift_file = tmp_path / "mylift.yaml"
    lift_file.write_text(json.dumps(document({"inside": tank((5, 0, 0.5), 5.0)}), indent=1), encoding="utf-8")
    result = called("check", str(lift_file))
    assert result.returncode == 2
    assert "load.tanks.inside: it goes from 3 m to 7 m along x" in result.stderr


def test_two_tanks_of_one_name() -> None:
    body = {"joint": {"type": "fixed"}, "tanks": {"c": tank((0, 0, 0.5), 5.0)}}
    with pytest.raises(
        ScenarioError, match=r"'module\.b\.c' is already a tank of 'module\.b'; this one needs"
    ):
        lift({"b.c": tank((0, 0, 0.5), 5.0)}, mechanics={"bodies": {"module.b": body}})


def test_two_tanks_in_one_place_and_a_load_too_heavy_with_them() -> None:
    tanks = {"a": tank((0, 0, 0.5), 20.0), "b": tank((1, 0, 0.5), 20.0)}
    hoist = {"speed": "6 m/min", "acceleration": "0.05 m/s^2"}
    rated = {"type": "fixed_hook", "at": ["0 m", "0 m", "30 m"], "rated_capacity": "150 t", "hoist": hoist}
    assert list(assemble(lift(tanks, cranes={"crane": rated})).warnings) == [
        "the load weighs 160 t with what is in its tanks, and what its slings hang from may carry 150 t in "
        "all",
        "tanks a and b of module are in one place, 36 m^3 of them: 'bottom' is the middle of a tank's bottom",
    ]


@pytest.mark.parametrize(("at", "is_told"), [("0 m", True), ("0.667 m", False)])
def test_a_hook_stands_over_the_load_with_what_is_in_its_tanks(at: str, is_told: bool) -> None:
    """120 t in the middle and 24 t at 4 m have their centre of gravity at 24 · 4/144 = 0.667 m."""
    hoist = {"speed": "6 m/min", "acceleration": "0.05 m/s^2"}
    crane = {"type": "fixed_hook", "at": [at, "0 m", "19.7 m"], "hoist": hoist}
    scenario = lift(
        {"end": tank((4, 0, 0.5), 24.0)},
        [{"step": "up", "hoist": "crane", "speed": "1 m/min", "until": {"supports": "clear"}}],
        load={"position": ["0 m", "0 m", "0 m"], "stands_on": "ground"},
        cranes={"crane": crane},
        **GROUND,
    )
    told = [one for one in assemble(scenario).warnings if "beside the centre of gravity of module" in one]
    assert [one.partition(" where")[0] for one in told] == (
        ["crane stands 0.67 m beside the centre of gravity of module"] if is_told else []
    )


def test_the_weight_of_a_load_is_told_with_its_tanks() -> None:
    rig = Rig.from_json(assemble(lift(INSIDE)).rig)
    assert weights(rig) == [
        "Load module: simulated weight 120.0 t, with 24.0 t in its tanks at the start; calculated 120.0 t x "
        "contingency 1.00 = design 120.0 t"
    ]


@pytest.mark.usefixtures("blank_pictures")
def test_table_and_report(tmp_path: Path) -> None:
    """Design weight and liquid make the static hook load on the first page: 1.05 × 120 + 24 = 150 t."""
    plan = [hold("full"), pump("drain", OUT, "600 t/h", by="24 t"), hold("empty", "until_end")]
    weight = {"weight": {"calculated": "120 t", "contingency": 1.05}}
    given = document(INSIDE, plan, load=weight)
    lift_file = tmp_path / "mylift.yaml"
    lift_file.write_text(json.dumps(given, indent=1), encoding="utf-8")
    result = called("run", str(lift_file), "-o", str(tmp_path / "out"))
    assert "in its tanks            24.0 t at the start, 0.0 t at the end" in result.stdout
    assert "static_hook_load" in result.stdout
    # 150 t, no contingency on what is in tanks; the same by the rule of the check.
    checked = next(line for line in result.stdout.splitlines() if "static_hook_load" in line)
    assert f"{150e3 * 9.81 / 1e3:.1f} kN" in checked
    page = (tmp_path / "out" / "report.html").read_text(encoding="utf-8")
    assert "+ in its tanks, as given" in page
    assert "rigging below the hooks" not in page
    words = " ".join(page.split())  # no line ends between a number and its unit
    assert "pump from module.inside to sea at 600 t/h, 24 t in all" in words


@pytest.mark.parametrize("has_tank", [True, False])
def test_out_of_the_water_is_told_of_loads_without_tanks(has_tank: bool) -> None:
    """What comes out with a load has no weight where no tank says it, and is told; a tank says it."""
    plan = [hold("below"), {"step": "out", "hoist": "crane", "speed": "6 m/min", "by": "8 m"}]
    tanks = {"inside": tank((0, 0, 0.5), 49.2)} if has_tank else None
    scenario = lift(tanks, plan, load={"in_water": WET}, duration="150 s", water={"level": "16 m"})
    warnings = Simulation(scenario).run().attributes["warnings"]
    told = [one for one in warnings if "after it was wholly wet" in one]
    assert len(told) == (0 if has_tank else 1)
