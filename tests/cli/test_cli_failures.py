"""`gantline run` where the mechanics cannot go on: exit code 3, element, cause, and what there is saved."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from typer.testing import CliRunner

import gantline
from gantline.cli.app import app
from lift_text import DEAD_CENTRE, PAST_THE_END

G = 9.81
ROPE_TWICE = """
format: 1
lift: {title: Two inextensible ropes side by side}
duration: 2 s
simulation: {sample_interval: 50 ms}
ropes:
  thin: {inextensible: true}
mechanics:
  bodies:
    ceiling: {joint: {type: fixed}}
    weight: {at: [0 m, 0 m, -HEIGHT], joint: {type: point}, mass: 40 kg}
  ropes:
    first:  {rope: thin, length: 5 m, route: [{type: end, body: ceiling}, {type: end, body: weight}]}
    second: {rope: thin, length: 5 m, route: [{type: end, body: ceiling}, {type: end, body: weight}]}
"""
# From the hook to the lug are 9 m and what the load stands deep in the ground, less than a millimetre.
TOO_SHORT = """
format: 1
lift: {title: A sling that is too short where it is put on}
duration: 2 s
ground: {level: 0 m, stiffness: 200 MN/m, damping: 10 MN s/m, friction: 0.4}
ropes: {rope: {axial_stiffness: 100 MN, damping_time: 10 ms}}
load:
  name: module
  shape: {box: [12 m, 6 m, 4 m]}
  position: [0 m, 0 m, 0 m]
  stands_on: ground
  weight: {calculated: 10 t}
  centre_of_gravity: {at: [0 m, 0 m, 2 m]}
  lugs: {one: {at: [0 m, 0 m, 4 m]}}
cranes:
  hook: {type: fixed_hook, at: [0 m, 0 m, 13 m], hoist: {speed: 6 m/min, acceleration: 0.1 m/s^2}}
sling_defaults: {rope: rope}
slings:
  long:  {from: hook, to: module.one, length: 9.5 m}
  short: {from: hook, to: module.one, length: 8.5 m}
plan:
  - {step: wait, hold: 1 s}
  - {step: on,   hold: until_end, attach: sling.short}
"""
NO_INERTIA = """
format: 1
lift: {title: A hinge that nothing holds back}
duration: 2 s
mechanics:
  bodies:
    flap: {joint: {type: hinge, axis: [0, 1, 0]}, mass: 40 kg}
"""


def run(folder: Path, text: str, *words: str) -> tuple[int, str]:
    """Exit code, and what was printed as one line of words."""
    lift = folder / "lift.yaml"
    lift.write_text(text, encoding="utf-8")
    result = CliRunner().invoke(app, ["run", str(lift), "-o", str(folder / "out"), "--no-plots", *words])
    return result.exit_code, " ".join(result.output.split())


@pytest.mark.parametrize(
    ("text", "words", "element", "cause", "fails_at", "recorded"),
    [
        # The second rope goes taut with the first, after a fall of 1 m; that step starts before.
        (
            ROPE_TWICE.replace("HEIGHT", "4 m"),
            (),
            "second",
            "an inextensible rope that repeats another",
            (0.0, math.sqrt(2 * 1.0 / G)),
            0.2,
        ),
        (
            ROPE_TWICE.replace("HEIGHT", "4 m"),
            ("--integrator", "del"),
            "second",
            "an inextensible rope that repeats another",
            (math.sqrt(2 * 1.0 / G) - 2e-3, math.sqrt(2 * 1.0 / G) + 2e-3),
            0.45,
        ),
        (DEAD_CENTRE, (), "plumb", "the equations are singular here", (0.0, 0.0), 0.0),
        (
            PAST_THE_END,
            (),
            "sheave",
            "it has come to the next place that fall passes",
            (math.sqrt(2 * 2.0 / G) - 2e-3, math.sqrt(2 * 2.0 / G) + 2e-3),
            0.6,
        ),
        (TOO_SHORT, (), "sling.short", "is 8.500 m long and 0.500 m too short", (1.0, 1.0), 0.9),
        (
            TOO_SHORT,
            ("--integrator", "del"),
            "sling.short",
            "is 8.500 m long and 0.500 m too short",
            (1.0, 1.0),
            0.9,
        ),
    ],
    ids=[
        "redundant ropes",
        "redundant ropes by del",
        "singular at the start",
        "sheave at a dead end",
        "short sling",
        "short sling by del",
    ],
)
def test_time_element_and_cause_are_said_and_what_there_is_is_saved(
    tmp_path: Path,
    text: str,
    words: tuple[str, ...],
    element: str,
    cause: str,
    fails_at: tuple[float, float],
    recorded: float,
) -> None:
    code, said = run(tmp_path, text, *words)
    assert code == 3, said
    assert "Traceback" not in said
    assert f" s at {element}: " in said
    assert cause in said
    time = float(said.split("could not go on at t = ")[1].split()[0])
    assert fails_at[0] - 1e-3 <= time <= fails_at[1] + 1e-3
    recording = gantline.open_recording(tmp_path / "out" / "recording.nc")
    assert recording.attributes["status"] == "failed"
    assert recorded <= recording.time[-1] <= time + 1e-3
    # The last good state belongs to this lift: it can be taken up again, and fails in the same way.
    overrides = {"integrator": "del"} if words else {}
    again = gantline.Simulation(tmp_path / "lift.yaml", **overrides)
    again.restore((tmp_path / "out" / "state.bin").read_bytes())
    with pytest.raises(gantline.SimulationError) as failure:
        again.run()
    assert failure.value.element == element
    assert failure.value.time == pytest.approx(time, abs=1e-3)


TOP_HEAVY = """
format: 1
lift: {title: A barge that is heavy above}
duration: 60 s
start: as_given
vessels:
  barge:
    draft: 4 m
    heel: 2 deg
    hull: {box: [100 m, 30 m, 8 m]}
    masses: {hull: {mass: 12300 t, at: [50 m, 0 m, 22 m]}}
    radii_of_gyration: [11 m, 27 m, 27 m]
"""


def test_a_vessel_that_capsizes_ends_the_run_with_what_there_is(tmp_path: Path) -> None:
    code, said = run(tmp_path, TOP_HEAVY)
    assert code == 3, said
    assert "Traceback" not in said
    assert " s at barge: it has capsized over its starboard side, more than 60° from upright" in said
    assert "before that barge.deck_edge went under at " in said
    recording = gantline.open_recording(tmp_path / "out" / "recording.nc")
    ((time, _, name),) = recording.events("capsized")
    assert name == "barge" and f"t = {time:.3f} s" in said
    assert recording.time[-1] > time - 0.02
    assert math.degrees(recording.column("vessel_heel", "barge")[-1]) > 55


def test_the_table_of_a_run_and_of_a_lift_at_rest_has_its_vessels(tmp_path: Path) -> None:
    floating = TOP_HEAVY.replace("22 m]", "5 m]").replace("start: as_given", "start: rest")
    code, said = run(tmp_path, floating)
    assert code == 0, said
    assert "barge 12300.0 t 4.000 m 4.000 m 0.000 deg 0.000 deg 4.000 m" in said
    result = CliRunner().invoke(app, ["statics", str(tmp_path / "lift.yaml")])
    assert result.exit_code == 0
    words = " ".join(result.output.split())
    assert "barge 12300.0 t 4.000 m 4.000 m 0.000 deg 0.000 deg 4.000 m" in words
    # T/2 + B²/12T − KG and the same with L²; three motions that nothing holds.
    assert "barge 15.75 m 205.33 m" in words
    assert words.count("nothing holds: barge") == 3


def test_a_body_without_inertia_is_refused_before_anything_runs(tmp_path: Path) -> None:
    """Infinite accelerations cannot arise: what would have them is bad input."""
    code, said = run(tmp_path, NO_INERTIA)
    assert code == 2
    assert "flap: it has no inertia in a direction that it can move" in said
    assert not (tmp_path / "out").exists()


def test_a_sling_that_is_certain_to_be_too_short_is_refused_before_anything_runs(tmp_path: Path) -> None:
    """The load stands and nothing has held it: where the hook and the lug are is known."""
    code, said = run(tmp_path, TOO_SHORT.replace("attach: sling.short", "attach: [sling.short, sling.long]"))
    assert code == 2
    assert "lift.yaml:23: step 'on', plan[2].attach: 'sling.short' is 8.5 m and 0.500 m too short" in said
    assert (
        "from 'hook' to its lug it is 9.000 m then; lower the hook before, or make the sling longer" in said
    )
    assert not (tmp_path / "out").exists()
