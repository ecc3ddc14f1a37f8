"""Locking pins in lift files: words, document, recording."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from gantline.assembly import assemble
from gantline.checks import check_recording
from gantline.cli.summary import summary
from gantline.results.recording import Recording
from gantline.scenario import ScenarioError, parse_scenario
from gantline.simulation import simulate
from lift_text import BASE
from of_recording import checks_of

ADAPTIVE = BASE.replace("simulation: {integrator: del, step: 1 ms, ", "simulation: {")
#: Plumb slings, the centre of gravity 0.1 m towards the second lug; the pins are pulled when the load hangs.
UNEVEN = (
    ADAPTIVE.replace("centre_of_gravity: {at: [0 m,", "centre_of_gravity: {at: [0.1 m,")
    .replace("[-3 m, 0 m, 3 m]", "[-0.8 m, 0 m, 3 m]")
    .replace("[ 3 m, 0 m, 3 m]", "[ 0.8 m, 0 m, 3 m]")
    .replace("travel: {up: 1 m", "travel: {locked: true, up: 1 m")
    .replace("speed: 3 m/min, start_at: 0 s, brake_from: 10 s", "speed: 6 m/min, start_at: 0 s, by: 2.5 m")
    .replace("hold: until_end}", "hold: 10 s}\n  - {step: let go, hold: until_end, pull_pins: e1}")
    .replace("duration: 20 s", "duration: 60 s")
)


def document(text: str) -> dict[str, Any]:
    return assemble(parse_scenario(text)).document


def pins(text: str) -> list[bool | None]:
    joints = {one["name"]: one["joint"] for one in document(text)["bodies"]}
    return [joints[f"e1.{place}"]["pin"] for place in (1, 2)]


def locked(word: str, text: str = ADAPTIVE) -> str:
    return text.replace("travel: {up: 1 m", f"travel: {{locked: {word}, up: 1 m")


def test_which_sheaves_have_pins_and_which_are_in() -> None:
    assert pins(ADAPTIVE) == [None, None]
    assert pins(locked("true")) == [True, True]
    assert pins(locked("false")) == [None, None]
    assert pins(locked("2")) == pins(locked("[2]")) == [None, True]
    pulled = "hold: until_end, pull_pins: e1, put_in_pins: e1.1}"
    assert pins(locked("2").replace("hold: until_end}", pulled)) == [False, True]


def test_steps_say_what_becomes_of_pins() -> None:
    text = locked("true").replace(
        "hold: until_end}",
        "hold: 1 s, pull_pins: [e1.2, e1.1]}\n  - {step: again, hold: until_end, put_in_pins: e1}",
    )
    steps = document(text)["plan"]
    assert [step.get("pulls") for step in steps] == [None, ["e1.2", "e1.1"], None]
    assert [step.get("pins") for step in steps] == [None, None, ["e1.1", "e1.2"]]


def test_explicit_knows_no_pins() -> None:
    text = locked("true", BASE).replace("integrator: del", "integrator: explicit")
    with pytest.raises(ScenarioError, match="'explicit' knows no pins; 'adaptive' or 'del' is right"):
        parse_scenario(text)


def test_pins_and_an_inextensible_rope_do_not_hold_the_same_twice() -> None:
    rigid = ADAPTIVE.replace(
        "thick: {axial_stiffness: 100 MN, damping_time: 2 ms}", "thick: {inextensible: true}"
    )
    says = "all pins of 'e1' are in, and its rope is inextensible; leave one out, or give the rope"
    with pytest.raises(ScenarioError, match=f"travel.locked: {says}"):
        parse_scenario(locked("true", rigid))
    again = rigid.replace("hold: until_end}", "hold: until_end, put_in_pins: e1.2}")
    with pytest.raises(ScenarioError, match=rf"plan\[2\]\.put_in_pins: {says}"):
        parse_scenario(locked("1", again))
    assert simulate(parse_scenario(locked("1", rigid)), duration=2.0).attributes["energy_remainder"] < 1e-6


@pytest.mark.parametrize("integrator", ["adaptive", "del"])
def test_pinned_sheaves_hold_until_they_are_let_go(integrator: str) -> None:
    run = simulate(parse_scenario(UNEVEN), integrator=integrator, step=2e-3 if integrator == "del" else None)
    ((when, _, first), (_, _, second)) = run.events("pin_pulled")
    assert (first, second) == ("e1.1", "e1.2")
    before, travel = run.time < when, run["sheave_travel"].values
    assert np.abs(travel[before]).max() < 1e-9
    force = run["pin_force"].values
    assert run.coordinates["pin"] == ("e1.1", "e1.2")
    assert (force[~before][1:] == 0.0).all()
    # In: lugs at -0.8 and 0.8 m share by moments about the centre of gravity, 1.5 m below them, which is
    # 0.1 m off and goes back as the load tilts on its slings; means over 8 s, in which the load rings. The
    # pins hold that and the sheaves of 200 kg.
    held = before & (run.time > when - 8.0)
    tilt = float(run.column("load_tilt", "block")[held].mean())
    half, off = 0.8 * np.cos(tilt), 0.1 * np.cos(tilt) - 1.5 * np.sin(tilt)
    slings = np.stack([run.column("rope_tension", f"sling.{s}") for s in ("S1", "S2")], axis=1)
    tension = slings[held].mean(axis=0)
    assert tension[1] / tension[0] == pytest.approx((half + off) / (half - off), rel=1e-3)
    assert force[held].mean(axis=0) == pytest.approx(tension + 200 * 9.81, rel=1e-3)
    # Out: the sheave of the sling that carried more comes down.
    assert travel[-1, 1] > 0.0 > travel[-1, 0]
    assert abs(np.ptp(slings[-1])) < 0.1 * np.ptp(tension)
    assert run.attributes["energy_remainder"] < 1e-3
    (line,) = [line for line in summary(run, [], str) if "locking pins" in line]
    assert line.endswith(f"pulled at {when:.2f} s")
    assert "(e1.2 at" in line


@pytest.mark.parametrize(("capacity", "verdict"), [(60, "ok"), (30, "failed"), (None, "not checked")])
def test_pins_are_held_against_their_capacity(capacity: float | None, verdict: str) -> None:
    """The pin of the sling near the centre of gravity bears more than half of the load, and its sheave.

    All of it is raised by the contingency of 1.05.
    """
    said = "" if capacity is None else f", pin_capacity: {capacity} t"
    text = UNEVEN.replace("travel: {locked: true", f"travel: {{locked: true{said}")
    run = simulate(parse_scenario(text), duration=50.0)
    (check,) = checks_of(run, "pin_force_of_capacity")
    assert check.verdict == verdict
    if capacity is None:
        assert (check.value, check.remark) == (None, "no capacity: pins of e1")
        return
    peak = np.abs(run["pin_force"].values).max() / 1e3
    assert check.value == pytest.approx(1.05 * peak / (capacity * 9.81), rel=1e-12)
    assert (check.element, peak > (30.0 + 0.2) * 9.81) == ("pin of e1.2", True)
    assert check.formula == f"({peak:.1f} kN x 1.05 to the design weight) / {capacity * 9.81:.1f} kN"
    # What pushes sheaves up their guides bears on their pins as what pulls them down.
    upwards = replace(run["pin_force"], values=-run["pin_force"].values)
    pushed = Recording({**run.variables, "pin_force": upwards}, run.coordinates, run.attributes)
    assert [one.value for one in checks_of(pushed, "pin_force_of_capacity")] == [check.value]


def test_an_equalizer_without_pins_has_no_such_check() -> None:
    run = simulate(parse_scenario(ADAPTIVE), duration=1.0)
    assert "pin_force_of_capacity" not in {check.name for check in check_recording(run)}
