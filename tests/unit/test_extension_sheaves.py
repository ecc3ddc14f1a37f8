"""Extension sheaves in lift files: what is assembled, where they hang at the start, results, pictures."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from extension_lifts import DEEP, PAIRED, SHEAVE
from gantline.assembly import Assembly, assemble
from gantline.checks import Verdict, check_recording, values_of
from gantline.cli.summary import summary
from gantline.plot import views
from gantline.results import series
from gantline.scenario import parse_scenario
from gantline.simulation import simulate

EA = 100e6
G = 9.81
#: Shackles at all slings, and the lug L2 turned by a quarter and weaker.
BOWS = """shackles:
  bow: {working_load_limit: 40 t, mass: 7 kg}
sling_defaults: {rope: sling, shackles: {top: bow, bottom: bow}}"""
ACROSS = "-3 m,  2 m, 3 m], main_plate: yz, capacity: 20 t"


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
    assert set(aside) == {("block", "L1"), ("block", "L2")}
    assert aside["block", "L1"][-1] == pytest.approx(math.asin(abs(last[0][1])), abs=1e-6)
    assert series.out_of_plane_angles(recording, slings["S1"]) == {}
    text = "\n".join(summary(recording, [], str))
    assert "S1x" in text
    limited = PAIRED + "limits: {lug_out_of_plane_angle: 5 deg, sling_angle_from_vertical: 40 deg}\n"
    checks = {one.name: one for one in check_recording(simulate(parse_scenario(limited), duration=40.0))}
    assert checks["lug_out_of_plane_angle"].verdict is Verdict.FAILED
    assert checks["lug_out_of_plane_angle"].element in {f"block.L{number}" for number in range(1, 5)}
    assert checks["sling_angle_from_vertical"].verdict is Verdict.OK


def test_both_lugs_of_a_sling_are_checked() -> None:
    """L1 and L2 under S1x: plates across y and across x, 40 t and 20 t. The larger angle counts for shackles.

    What S1x pulls is the same at both ends: peak over capacity at each lug. From its lug to X1 it leans by u;
    out of a plate with normal n that is asin(|u n|): at L1 between 10 deg and 20 deg, where Crosby's chart
    leaves a shackle 85 % of its working load limit, at L2 less than 10 deg, where it leaves all.
    """
    text = PAIRED.replace("sling_defaults: {rope: sling}", BOWS)
    text = text.replace("-3 m,  2 m, 3 m], main_plate: xz, capacity: 40 t", ACROSS)
    recording = simulate(parse_scenario(text + "limits: {skew_load_factor: 1.1}\n"), duration=40.0)
    sling = next(one for one in recording.rig.slings if one.name == "S1x")
    tension = series.sling_tension(recording, sling)
    peak = series.rope_peak(recording, sling.rope)[0]
    of_capacity = values_of(recording, "lug_load_of_capacity")
    assert set(of_capacity) == {f"block.L{number}" for number in range(1, 5)}
    assert of_capacity["block.L1"] == pytest.approx(peak / (40e3 * G), rel=1e-12)
    assert of_capacity["block.L2"] == pytest.approx(peak / (20e3 * G), rel=1e-12)
    aside = values_of(recording, "lug_out_of_plane_angle")
    still = {}
    for lug, across in (("L1", 1), ("L2", 0)):
        at = recording.column("body_position", "block") + np.array(recording.rig.loads[0].lugs[lug].at)
        way = recording.column("body_position", "X1") - at
        angle = np.arcsin(np.abs(way[:, across]) / np.linalg.norm(way, axis=1))
        # The load hangs as good as level and square to the world.
        largest = float(angle[series.is_carrying(tension)].max())
        assert aside[f"block.{lug}"] == pytest.approx(largest, abs=1e-3)
        still[lug] = math.degrees(angle[-1])
    assert still["L2"] < 10.0 < still["L1"] < 20.0
    used = values_of(recording, "shackle_load_of_working_load_limit")
    static = series.static_value(recording, tension)
    assert static is not None
    assert used["S1x bottom"] == pytest.approx(static / (0.85 * 40e3 * G), rel=1e-9)
    assert "S1x top" not in used
    assert used["S1 bottom"] == used["S1 top"]  # below S1 hangs a sheave, which turns into the pull
    # The table has the worse of both lugs, as the checks have it.
    rows = "\n".join(summary(recording, [], str)).split("\nUsed")[1].splitlines()
    row = next(row for row in rows if row.split()[:1] == ["S1x"])
    angle_text = f"{math.degrees(max(aside['block.L1'], aside['block.L2'])):.1f}"
    assert row.split()[-4:] == [f"{100 * of_capacity['block.L2']:.1f}", "%", angle_text, "deg"]
    checks = {one.name: one for one in check_recording(recording)}
    bends = "bends about an extension sheave, whose diameter counts in pictures only: S1x, S2x"
    assert bends in checks["sling_bending_ratio"].remark
    skew = checks["skew_load_factor"]
    assert skew.verdict is Verdict.WARNING
    assert skew.value == pytest.approx(1.0, abs=1e-6)
    assert skew.remark == "not checked, it follows the sling that its extension sheave hangs on: S1x, S2x"


def test_pictures_show_them() -> None:
    scene = assembled(PAIRED).scene
    drawn = {one["body"]: one for one in scene["sheaves"] if one["body"] in ("X1", "X2")}
    assert set(drawn) == {"X1", "X2"}
    # X1 serves lugs along y, so its axis is x.
    assert np.abs(drawn["X1"]["axis"]) == pytest.approx([1.0, 0.0, 0.0])
    assert drawn["X1"]["radius"] == 0.25
    assert {one["name"]: one["kind"] for one in scene["bodies"]}["X1"] == "sheave"
    assert views.system(simulate(parse_scenario(PAIRED), duration=12.0)) is not None
