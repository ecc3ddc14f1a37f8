"""A brake that holds a load, and would not with all sheaves slipping one way.

`gantline statics` asks for both bounds beside the equilibrium. Where one had none, the answer was that
alone: "there is no equilibrium: nothing holds it, it falls without end", of a load that hangs, and not with
which losses.
"""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from gantline.cli.app import app
from mechanics import G

MASS, EFFICIENCY = 20e3, 0.96
LIFT = """\
format: 1
lift: {title: Four parts between two drums}
duration: 5 s
start: rest
ropes: {r: {axial_stiffness: 60 MN, damping_time: 20 ms, diameter: 26 mm}}
mechanics:
  bodies:
    head: {at: [0 m, 0 m, 40 m], joint: {type: fixed}}
    load: {at: [0 m, 0 m, 20 m], joint: {type: slider, axis: [0, 0, 1]}, mass: 20 t}
  drums:
    winch: {diameter: 0.8 m, rotating_mass: 2 t, drive: {speed: 60 m/min, acceleration: 0.5 m/s^2}}
    other: {diameter: 0.6 m, rotating_mass: 1 t, brake: BRAKE kN}
  ropes:
    a:
      rope: r
      length: as_routed
      route:
        - {type: end, body: world, at: [-0.6 m, 0 m, 40 m], drum: other}
        - {type: half_turn, body: load, enter: [-0.6 m, 0 m, 0 m], leave: [0 m, 0 m, 0 m], bulge: [0, 0, -1], LOSSES}
        - {type: half_turn, body: head, enter: [0 m, 0 m, 0 m], leave: [0.6 m, 0 m, 0 m], bulge: [0, 0, 1], LOSSES}
        - {type: half_turn, body: load, enter: [0.6 m, 0 m, 0 m], leave: [1.2 m, 0 m, 0 m], bulge: [0, 0, -1], LOSSES}
        - {type: end, body: world, at: [1.2 m, 0 m, 40 m], drum: winch}
plan: [{step: end, hold: until_end}]
""".replace("LOSSES", f"efficiency: {EFFICIENCY}, rotating_mass: 30 kg")  # noqa: E501
#: The dead end of four parts that lower, K^3 W/(1 + K + K^2 + K^3), 52.09 kN; without losses W/4, 49.05 kN.
RATIO = 1 / EFFICIENCY
DEAD_END = RATIO**3 * MASS * G / sum(RATIO**k for k in range(4))


@pytest.mark.parametrize(("brake", "code", "nowhere"), [(51.0, 3, ["backward"]), (52.5, 0, [])])
def test_the_equilibrium_is_told_all_the_same(
    tmp_path: Path, brake: float, code: int, nowhere: list[str]
) -> None:
    assert (brake * 1e3 < DEAD_END) is bool(nowhere) and brake * 1e3 > MASS * G / 4
    lift = tmp_path / "lift.yaml"
    lift.write_text(LIFT.replace("BRAKE", str(brake)), encoding="utf-8")
    shown = CliRunner().invoke(app, ["statics", str(lift)])
    assert shown.exit_code == code
    said = " ".join(shown.stdout.split())
    assert "a 49.050 kN" in said
    assert ("slipping against the rope there is no equilibrium at t = 5 s: nothing holds it" in said) is bool(
        nowhere
    )
    document = json.loads(CliRunner().invoke(app, ["statics", str(lift), "--json"]).stdout)
    assert document["rope_tension"]["a"] == pytest.approx(MASS * G / 4, rel=1e-9)
    assert [one["losses"] for one in document["bounds_without_equilibrium"]] == nowhere
    assert [one["losses"] for one in document["bounds"]] == ["forward", "backward"][: 2 - len(nowhere)]
