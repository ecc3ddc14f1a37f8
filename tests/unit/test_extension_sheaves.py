"""Extension sheaves in lift files: what is assembled, where they hang at the start, results, pictures."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from extension_lifts import DEEP, PAIRED, SHEAVE
from gantline.assembly import Assembly, assemble
from gantline.checks import Verdict, check_recording
from gantline.cli.summary import summary
from gantline.plot import drawing
from gantline.results import series
from gantline.scenario import parse_scenario
from gantline.simulation import simulate

EA = 100e6
G = 9.81


def assembled(text: str) -> Assembly:
    return assemble(parse_scenario(text))


def body(assembly: Assembly, name: str) -> dict[str, Any]:
    return next(one for one in assembly.document["bodies"] if one["name"] == name)


def test_a_sheave_is_a_point_that_its_slings_end_at_and_run_over() -> None:
    assembly = assembled(DEEP)
    assert body(assembly, "X2")["joint"]["type"] == "point"
    routes = {
        rope["name"]: [(guide["type"], guide["body"]) for guide in rope["route"]]
        for rope in assembly.document["ropes"]
    }
    assert routes == {
        "sling.S": [("end", "hook"), ("end", "X1")],
        "sling.S1": [("end", "X2"), ("eye", "X1"), ("end", "X3")],
        "sling.S2": [("end", "block"), ("eye", "X2"), ("end", "block")],
        "sling.S3": [("end", "block"), ("eye", "X3"), ("end", "block")],
    }


def test_sheaves_start_in_balance_on_stretched_slings() -> None:
    """Straight below the hook: 5 m on three sheaves' weight, then 10 m each on that of one, EA = 100 MN."""
    assembly = assembled(DEEP)
    weight = SHEAVE * G
    first = 26.1 - 5.0 * (1 + 3 * weight / EA)
    second = first - 10.0 * (1 + weight / EA)
    assert body(assembly, "X1")["joint"]["position"] == pytest.approx([0, 0, first], abs=1e-9)
    for name in ("X2", "X3"):
        assert body(assembly, name)["joint"]["position"] == pytest.approx([0, 0, second], abs=1e-9)


def test_sheaves_that_are_pulled_aside_at_the_start() -> None:
    """`as_given`, hook 0.5 m higher: the two slings of a sheave pull it up by its weight and no more."""
    higher = DEEP.replace("26.1 m", "26.6 m").replace("start: rest", "start: as_given")
    scenario = parse_scenario(higher)
    recording = simulate(scenario, duration=0.02)
    assert float(recording.column("body_position", "X2")[0, 0]) < -1.0
    tension = [float(recording.column("rope_tension", rope)[0]) for rope in ("sling.S1", "sling.S2")]
    legs = [
        series.sling_direction(recording, sling, end)[0]
        for sling in recording.rig.slings[1:3]
        for end in (0, 1)
    ]
    # What pulls X2 up is the leg of S1 that ends there, what pulls it down are both legs of S2.
    pull = tension[0] * legs[0] - tension[1] * (legs[2] + legs[3])
    assert pull == pytest.approx([0.0, 0.0, SHEAVE * G], abs=1e-2)


def test_masses_of_ropes_and_shackles() -> None:
    """The sheave carries half of a rope over it, each end a quarter; every end has its shackle."""
    text = DEEP.replace("damping_time: 20 ms, mass: none", "damping_time: 20 ms, mass: 10 kg/m").replace(
        "load:\n", "shackles:\n  bow: {working_load_limit: 40 t, mass: 7 kg}\nload:\n", 1
    )
    text = text.replace(
        "sling_defaults: {rope: sling}", "sling_defaults: {rope: sling, shackles: {top: bow, bottom: bow}}"
    )
    assembly = assembled(text)
    assert body(assembly, "hook")["mass"] == pytest.approx(25 + 7)
    assert body(assembly, "X1")["mass"] == pytest.approx(SHEAVE + 25 + 7 + 100)
    assert body(assembly, "X2")["mass"] == pytest.approx(SHEAVE + 50 + 7 + 90)
    assert body(assembly, "block")["mass"] == pytest.approx(60e3 + 4 * (45 + 7))


def test_results_know_both_legs_of_a_sling() -> None:
    recording = simulate(parse_scenario(PAIRED), duration=40.0)
    slings = {sling.name: sling for sling in recording.rig.slings}
    assert [slings["S1"].lugs, slings["S1"].to_load, slings["S1x"].lugs] == [[None], None, ["L1", "L2"]]
    last = {end: series.sling_direction(recording, slings["S1x"], end)[-1] for end in (0, 1)}
    sheave = recording.column("body_position", "X1")[-1]
    for end, lug in enumerate(("L1", "L2")):
        load = recording.rig.loads[0]
        at = recording.column("body_position", "block")[-1] + np.array(load.lugs[lug].at)
        # The load hangs as good as level and square to the world.
        along = (sheave - at) / np.linalg.norm(sheave - at)
        assert last[end] == pytest.approx(along, abs=1e-3)
    aside = series.out_of_plane_angles(recording, slings["S1x"])
    assert set(aside) == {"L1", "L2"}
    assert aside["L1"][-1] == pytest.approx(math.asin(abs(last[0][1])), abs=1e-6)
    assert series.out_of_plane_angles(recording, slings["S1"]) == {}
    text = "\n".join(summary(recording, [], str))
    assert "S1x" in text
    limited = PAIRED + "limits: {lug_out_of_plane_angle: 5 deg, sling_angle_from_vertical: 40 deg}\n"
    checks = {one.name: one for one in check_recording(simulate(parse_scenario(limited), duration=40.0))}
    assert checks["lug_out_of_plane_angle"].verdict is Verdict.FAILED
    assert checks["lug_out_of_plane_angle"].where in {f"block.L{number}" for number in range(1, 5)}
    assert checks["sling_angle_from_vertical"].verdict is Verdict.OK


def test_pictures_show_them() -> None:
    scene = assembled(PAIRED).scene
    drawn = {one["body"]: one for one in scene["sheaves"] if one["body"] in ("X1", "X2")}
    assert set(drawn) == {"X1", "X2"}
    # X1 serves lugs along y, so its axis is x.
    assert np.abs(drawn["X1"]["axis"]) == pytest.approx([1.0, 0.0, 0.0])
    assert drawn["X1"]["radius"] == 0.25
    assert {one["name"]: one["kind"] for one in scene["bodies"]}["X1"] == "sheave"
    assert drawing.system(simulate(parse_scenario(PAIRED), duration=12.0)) is not None
