"""Chain hoists of slings: what becomes of them in the document and in results, messages on wrong ones."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import gantline
from gantline.assembly import assemble
from gantline.checks import check_recording, values_of
from gantline.cli.chain_hoist_table import chain_hoist_table
from gantline.report.chain_hoists import ChainHoists
from gantline.report.subject import Subject
from gantline.results.cranes.chain_hoists import sling_lengths
from gantline.results.ropes.upper_end import own_weight
from gantline.scenario import ScenarioError, parse_scenario
from gantline.statics import Statics
from gantline.study import adjust_lengths
from gantline.viewer.curves import curves
from gantline.viewer.turning import natural_lengths
from levelled import ASLANT, TWO, G
from reference_lift import ROOT

LEVEL = """\
  - {step: hang, hold: 2 s}
  - {step: level, haul: [sling.B, C], speed: 1 m/min, by: 0.3 m}
  - {step: look, hold: until_end}"""
MASS = "mass: 9 kg/m"
HOIST = ", acceleration: 0.1 m/s^2, rated_capacity: 80 t, range: [-0.5 m, 1 m], mass: 400 kg"
LIFT = ASLANT.text(LEVEL, duration=40.0, hoist=HOIST)
SCENARIOS = ROOT / "scenarios"


def changed(*pairs: tuple[str, str]) -> str:
    text = LIFT
    for old, new in pairs:
        assert old in text
        text = text.replace(old, new)
    return text


def messages(text: str) -> str:
    with pytest.raises(ScenarioError) as refused:
        gantline.Simulation(parse_scenario(text))
    return str(refused.value)


def test_a_drum_at_the_upper_end() -> None:
    """The sling ends on a flow of given motion, whose mass and rated capacity results know of."""
    assembled = assemble(parse_scenario(LIFT))
    [rope] = [one for one in assembled.document["ropes"] if one["name"] == "sling.B"]
    assert [guide.get("drum") for guide in rope["route"]] == [
        {"flow": "sling.B.chain_hoist", "rate": 1.0},
        None,
    ]
    assert rope["length"] == 7.8
    hook = next(one for one in assembled.document["bodies"] if one["name"] == "hB")
    assert hook["mass"] == 400.0
    [one, other] = assembled.rig["chain_hoists"]
    assert (one["name"], other["name"]) == ("B", "C")
    assert one["rated_capacity"] == pytest.approx(80e3 * G)
    assert one["weight"] == pytest.approx(400.0 * G)


def test_without_an_acceleration() -> None:
    """It comes to its highest speed, 2 m/min, within 1 s."""
    plan = LEVEL.replace("[sling.B, C]", "sling.B").replace("speed: 1 m/min", "speed: 2 m/min")
    run = gantline.simulate(parse_scenario(TWO.text(plan, duration=20.0)), sample_interval=0.05)
    out = np.interp([2.0, 2.5, 3.0, 5.0], run.time, run.column("chain_paid_out", "B"))
    # s = a t²/2 with a = (1/30) m/s², then v t less what the start took, v/2 s.
    v = 2.0 / 60.0
    assert out == pytest.approx([0.0, -v * 0.125, -v * 0.5, -v * 2.5], abs=1e-6)


def test_load_of_rated_capacity() -> None:
    """The largest force of its sling over 80 t; of an equilibrium that at rest, and one that is not known."""
    recording = gantline.simulate(parse_scenario(LIFT))
    used = values_of(recording, "chain_hoist_load_of_rated_capacity")
    for name in ("B", "C"):
        peak = float(recording.column("rope_peak_tension", f"sling.{name}"))
        assert used[name] == pytest.approx(peak / (80e3 * G))
    rest = Statics(parse_scenario(LIFT)).equilibrium()
    at_rest = values_of(rest.recording, "chain_hoist_load_of_rated_capacity")
    assert at_rest["C"] == pytest.approx(rest.tension("sling.C") / (80e3 * G))
    weak = gantline.simulate(parse_scenario(changed(("rated_capacity: 80 t", "rated_capacity: 50 t"))))
    [check] = [one for one in check_recording(weak) if one.name == "chain_hoist_load_of_rated_capacity"]
    assert (check.verdict.value, check.element) == ("failed", "C")
    unknown = gantline.simulate(parse_scenario(changed((" rated_capacity: 80 t,", ""))))
    [check] = [one for one in check_recording(unknown) if one.name == "chain_hoist_load_of_rated_capacity"]
    assert check.verdict.value == "warning"
    assert "rated capacity not known: B, C" in check.remark


def test_lengths_where_they_count() -> None:
    """A sling is as long as its hoist has made it, in the report, in the player and in its stiffness."""
    recording = gantline.simulate(parse_scenario(LIFT))
    slings = {sling.name: sling for sling in recording.rig.slings}
    assert sling_lengths(recording, slings["A"]) == pytest.approx(7.8)
    assert sling_lengths(recording, slings["B"])[[0, -1]] == pytest.approx([7.8, 7.5])
    at = recording.coordinates["rope"].index("sling.B")
    assert natural_lengths(recording, range(len(recording.time)))[at] is None
    assert [one.name for one in curves(recording) if one.group == "chain"] == ["B", "C"]


def test_weight_of_a_chain_hoist_at_the_upper_end() -> None:
    """The shackle there bears it, the one at the lug does not; of a slack sling too."""
    recording = gantline.simulate(parse_scenario(LIFT))
    assert own_weight(recording, "sling.B") == pytest.approx(400.0 * G)
    assert own_weight(recording, "sling.A") == pytest.approx(0.0)


def test_tables() -> None:
    """How far each went, and what it carries, in the table of a run, of an equilibrium and in the report."""
    recording = gantline.simulate(parse_scenario(LIFT))
    head, *rows = chain_hoist_table(recording)
    assert re.split(r"  +", head) == [
        "Chain hoist", "paid out at the end", "least", "most", "range", "largest force", "of rated capacity"
    ]  # fmt: skip
    assert rows[0].split("  ")[1].strip() == "B"
    assert "-0.300 m  -0.300 m  0.000 m  -0.50 m to 1.00 m" in rows[0]
    content = ChainHoists().content(Subject(recording))
    assert content is not None
    assert [(one["name"], one["last"], one["range"], one["rated"]) for one in content["hoists"]] == [
        ("B", "−0.300", "−0.50 to 1.00", "80"),
        ("C", "−0.300", "−0.50 to 1.00", "80"),
    ]
    rest = Statics(parse_scenario(LIFT)).equilibrium()
    assert chain_hoist_table(rest.recording)[0].split()[:4] == ["Chain", "hoist", "paid", "out"]
    other = ASLANT.text("  - {step: hang, hold: until_end}", duration=1.0).replace(
        ", chain_hoist: {speed: 2 m/min}", ""
    )
    assert ChainHoists().content(Subject(gantline.simulate(parse_scenario(other)))) is None


def test_past_its_range_in_a_run() -> None:
    """A step that ends on a condition goes as far as that takes; the run tells where that is too far."""
    text = changed(("by: 0.3 m", "brake_from: 38 s"), ("[-0.5 m, 1 m]", "[-0.5 m, 0 m]"))
    checks = check_recording(gantline.simulate(parse_scenario(text)))
    found = [one for one in checks if one.name == "stays_in_range"]
    assert [one.element for one in found] == ["sling.B", "sling.C"]
    assert "its range is -0.50 m to 0.00 m; end the step by 'by', or earlier" in found[0].remark.replace(
        "−", "-"
    )
    # From 2 s on at 1 m/min, with half of what it takes to start: 0.5 m are hauled in at 32.08 s.
    assert found[0].time == pytest.approx(2.0 + 30.0 + 0.5 / 60.0 / 0.1, abs=0.2)


def test_level_by_chain_hoists() -> None:
    """What levels a load, hauled in as the answer says, has it level; past the range the answer says so."""
    # Its load begins 0.6 m higher, for the shorter slings to reach.
    text = changed(
        ("position: [0 m, 0 m, 0 m]", "position: [0 m, 0 m, 0.6 m]"), ("1.2 m, 0.3 m, 2.0", "1.2 m, 0 m, 2.0")
    )
    lift = parse_scenario(text)
    answer = adjust_lengths(lift, slopes=(0.0, 0.0), slings=["B", "C"], time=0.0)
    ways = answer.chain_hoists
    assert set(ways) == {"B", "C"}
    assert all(way < 0.0 for way in ways.values())
    text = text.replace("by: 0.3 m", f"by: {-ways['B']!r} m").replace("range: [-0.5 m, 1 m], ", "")
    rest = Statics(parse_scenario(text)).equilibrium()
    before = float(answer.before.recording.column("load_tilt", "module")[-1])
    # What is left is by how much the strain at which it hauls differs from the mean of both ends, squared.
    assert float(rest.recording.column("load_tilt", "module")[-1]) < 1e-4 * before
    assert answer.to_json()["chain_hoists"] == ways


@pytest.mark.parametrize("at", ["equalizer", "spreader_bar"])
def test_in_other_gear(at: str) -> None:
    """Below a moving sheave, and below a spreader: the books close, and it hauls in what the plan says."""
    text = (SCENARIOS / at / "scenario.yaml").read_text(encoding="utf-8")
    sling = {"equalizer": "S2", "spreader_bar": "NW"}[at]
    hoist = ", chain_hoist: {speed: 2 m/min, rated_capacity: 80 t, mass: 200 kg}"
    text = re.sub(rf"(  {sling}: {{from.*?)(, (?:shackles|rope): )", rf"\1{hoist}\2", text, count=1)
    hook = {"equalizer": "test_hook, speed: 0.1 m/s", "spreader_bar": "crane, speed: 1 m/min"}[at]
    text = re.sub(
        r"plan:\n(.*?\n\n)",
        f"plan:\n  - {{step: up, hoist: {hook}, until: {{supports: clear}}}}\n"
        f"  - {{step: haul, haul: sling.{sling}, speed: 1 m/min, by: 0.1 m}}\n"
        "  - {step: end, hold: until_end}\n\n",
        text,
        count=1,
        flags=re.DOTALL,
    )
    recording = gantline.simulate(parse_scenario(text))
    assert recording.column("chain_paid_out", sling)[-1] == pytest.approx(-0.1)
    assert recording.metrics()["energy_remainder"] < 1e-6


def test_of_an_approximated_equalizer() -> None:
    """Its slings are adjusted all the time."""
    text = (SCENARIOS / "mechanisms" / "scenario.yaml").read_text(encoding="utf-8")
    text = text.replace(
        "length: 26 m, rope: sling,", "length: 26 m, rope: sling, chain_hoist: {speed: 1 m/min},", 1
    )
    assert "'e1' adjusts the length of this sling all the time; 'mechanism: sheaves' is right" in messages(
        text
    )


def test_put_on_by_a_step() -> None:
    """A sling with a chain hoist may be put on later, and takes up load from then on."""
    plan = """\
  - {step: "on", hold: 1 s, attach: [sling.A, sling.B, sling.C, sling.D]}
  - {step: taut, haul: [sling.B, sling.C], speed: 2 m/min, by: 0.4 m}
  - {step: look, hold: until_end}"""
    text = ASLANT.text(plan, duration=30.0, more="ground: {friction: 0.5}\n")
    text = text.replace("  position: [0 m, 0 m, 0 m]", "  stands_on: ground").replace("7.8 m", "7.95 m")
    recording = gantline.simulate(parse_scenario(text))
    tension = recording.column("rope_tension", "sling.C")
    assert tension[recording.time < 1.0].max() == 0.0
    assert tension[-1] > 50e3
    assert recording.metrics()["energy_remainder"] < 1e-6


@pytest.mark.parametrize(
    ("pairs", "message"),
    [
        ([("[sling.B, C]", "sling.X")], r"haul: 'sling.X' is not a mooring or tag line, nor a sling with a"),
        ([("[sling.B, C]", "sling.A")], r"haul: sling 'A' has no 'chain_hoist' that could move it; give it"),
        ([("[sling.B, C]", "[sling.B, B]")], r"haul: names a sling twice; each sling stands once"),
        ([("speed: 1 m/min", "speed: 3 m/min")], r"speed: 3 m/min is faster than 'sling.B' can move; its"),
        ([("by: 0.3 m", "by: 0.3")], r"by: '0.3' has no unit; a length is written like"),
        ([("by: 0.3 m", "by: -0.3 m")], r"by: '-0.3 m' is negative; this length has to be above zero"),
        (
            [("by: 0.3 m", "by: 0.6 m")],
            r"by: 'sling.B' would be 0.6 m shorter than at the start; the range of its chain hoist is -0.5",
        ),
        (
            [("haul: [sling.B, C]", "veer: sling.B"), ("by: 0.3 m", "by: 1.1 m")],
            r"by: 'sling.B' would be 1.1 m longer than at the start; the range of its chain hoist is",
        ),
        (
            [("haul: [sling.B, C]", "haul: sling.B, acceleration: 1 m/s^2")],
            r"acceleration: 1 m/s\^2 is more than 'sling.B' can do; its most is 0.1 m/s\^2",
        ),
        ([("[-0.5 m, 1 m]", "[1 m, 0 m]")], r"range: a range goes from the least to the largest change; fou"),
        ([("[-0.5 m, 1 m]", "[0.5 m, 1 m]")], r"range: a range of changes of length has 0 in it, where the"),
        (
            [("[-0.5 m, 1 m]", "[-8 m, 1 m]")],
            r"chain_hoist.range: 8 m to haul in are all of the sling, 7.8 m from end to end; its least",
        ),
        ([("[-0.5 m, 1 m]", "0.5 m")], r"range: found '0.5 m'; a list of 2 is needed"),
        ([("{speed: 2 m/min, accel", "{accel")], r"chain_hoist: 'speed' is missing; the chain hoist of a"),
        ([("rated_capacity: 80 t", "wll: 80 t")], r"'wll' is not a key .*; did you mean 'rated_capacity'\?"),
        ([("chain_hoist: {", "turnbuckle: {")], r"'turnbuckle' is not a key .* mean 'chain_hoist'\?"),
        ([("haul: [", "shorten: [")], r"'shorten' is not what a step can do; did you mean 'haul'\?"),
        (
            [("rope: sling_60}", "rope: sling_60, rope_weight: distributed}"), ("mass: none", MASS)],
            r"chain_hoist: this sling has nodes, of fixed lengths between them; 'rope_weight: lumped' or",
        ),
        (
            [("axial_stiffness: 60.0 MN, damping_time: 0.2 s", "inextensible: true")],
            r"chain_hoist: this sling is inextensible; give its rope an axial stiffness",
        ),
        (
            [("axial_stiffness: 60.0 MN", "curve: {strain: [1 %, 2 %], tension: [600 kN, 1300 kN]}")],
            r"chain_hoist: rope 'sling_60' has a curve, and a sling with a chain hoist needs one stiffness",
        ),
        (
            [("hold: 2 s", "hold: 2 s, cut: sling.B")],
            r"haul: 'sling.B' has been cut by then; there is nothing to haul",
        ),
    ],
)  # fmt: skip
def test_what_cannot_be(pairs: list[tuple[str, str]], message: str) -> None:
    found = messages(changed(*pairs))
    assert re.search(message, found), found


def test_over_an_extension_sheave() -> None:
    text = """\
format: 1
lift: {title: A hoist where none can be}
duration: 1 s
ropes: {s: {axial_stiffness: 60 MN, damping_time: 0.1 s}}
cranes: {crane: {type: fixed_hook, at: [0 m, 0 m, 10 m], hoist: {speed: 1 m/min, acceleration: 0.1 m/s^2}}}
load:
  {name: box, shape: {box: [4 m, 2 m, 1 m]}, weight: {calculated: 10 t},
   centre_of_gravity: {at: [0 m, 0 m, 0.5 m]}, position: [0 m, 0 m, 0 m],
   lugs: {P: {at: [-1 m, 0 m, 1 m]}, Q: {at: [1 m, 0 m, 1 m]}}}
extension_sheaves: {X: {mass: 100 kg}}
slings:
  up: {from: crane, to: X, length: 4 m, rope: s}
  down: {over: X, to: [box.P, box.Q], length: 10 m, rope: s, chain_hoist: {speed: 1 m/min}}
plan: [{step: hang, hold: until_end}]
"""
    found = messages(text)
    assert (
        "slings.down.chain_hoist: this sling runs over 'X', from end to end; a chain hoist is in one with"
        in found
    )


def test_a_mooring_line_of_the_same_name() -> None:
    """Steps name both; a lift file in which they could not be told apart is refused."""
    line = "mooring_lines:\n  sling.B: {vessel: hB, fairlead: [0 m, 0 m, 0 m], to: [9 m, 0 m, 0 m], "
    line += "rope: sling_60, length: 9 m}\n"
    found = messages(LIFT.replace("plan:\n", f"{line}plan:\n"))
    assert "steps would not know the mooring line 'sling.B' from this sling; it needs another name" in found


@pytest.mark.parametrize(
    ("pairs", "doubt"),
    [
        (
            [("speed: 2 m/min", "speed: 2 m/s")],
            "hauls in at up to 120 m/min; a unit has slipped, m/s for m/min",
        ),
        ([("mass: 400 kg", "mass: 400 t")], "weighs 400 t, and may carry 80 t; a unit has slipped, t for kg"),
        (
            [("by: 0.3 m", "by: 8 m"), (", range: [-0.5 m, 1 m]", "")],
            "by step 'level' 0.2 m more are hauled in than there is of sling.B, which is 7.8 m long at the",
        ),
        (
            [("by: 0.3 m", "by: 0.3 m, detach: [sling.B]")],
            "step 'level' takes sling.B off as it begins, and moves its chain hoist then; it",
        ),
    ],
)
def test_what_cannot_be_meant(pairs: list[tuple[str, str]], doubt: str) -> None:
    warnings = assemble(parse_scenario(changed(*pairs))).warnings
    assert any(doubt in one for one in warnings), warnings


def test_an_emergency_stop() -> None:
    """All that the plan moves stops, chain hoists with their acceleration."""
    stop = changed(("plan:\n", "emergency_stop: {in_step: level, after: 5 s}\nplan:\n"))
    recording = gantline.simulate(parse_scenario(stop))
    out = recording.column("chain_paid_out", "B")
    v, a = 1.0 / 60.0, 0.1
    assert out[-1] == pytest.approx(-(v * 5.0 - v * v / (2 * a) + v * v / (2 * a)), abs=1e-9)
    assert math.isclose(out[-1], out[recording.time > 9.0][0], abs_tol=1e-12)


@given(
    low=st.floats(-5.0, 5.0, allow_nan=False).map(lambda x: round(x, 3)),
    high=st.floats(-5.0, 5.0, allow_nan=False).map(lambda x: round(x, 3)),
    by=st.floats(0.001, 5.0).map(lambda x: round(x, 3)),
    hauls=st.booleans(),
)
@settings(max_examples=60, deadline=None)
def test_whatever_its_range_a_step_is_read_or_told(low: float, high: float, by: float, hauls: bool) -> None:
    """A range with 0 in it, and a step that ends in it, are read; any other is one message with its line."""
    text = LIFT.replace("[-0.5 m, 1 m]", f"[{low!r} m, {high!r} m]").replace("by: 0.3 m", f"by: {by!r} m")
    text = text if hauls else text.replace("haul: [", "veer: [")
    is_range = low < high and low <= 0.0 <= high
    is_right = is_range and (by <= -low + 1e-9 if hauls else by <= high + 1e-9)
    try:
        parse_scenario(text)
    except ScenarioError as refused:
        assert not is_right
        assert all(problem.line is not None for problem in refused.problems)
        assert ("range" in str(refused)) is True
    else:
        assert is_right
