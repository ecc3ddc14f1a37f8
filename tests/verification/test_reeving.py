"""Hooks in whole reeving, by yard words: closed forms of docs/concepts/winch.md, through lift files."""

from __future__ import annotations

import math

import numpy as np
import pytest

from gantline.assembly import assemble
from gantline.checks import check_recording
from gantline.checks.check import Verdict
from gantline.results.recording import Recording
from gantline.results.ropes.flows import drum_fleet_angle
from gantline.scenario import ScenarioError, parse_scenario
from gantline.simulation import Simulation
from mechanics import G

HOOK_BLOCK, LOAD = 6e3, 94e3
WEIGHT = (HOOK_BLOCK + LOAD) * G

LIFT = """
format: 1
lift: {{title: Hooks in whole reeving}}
duration: {duration} s
ropes:
  hoist: {{axial_stiffness: {stiffness} MN, damping_time: 10 ms, mass: none, diameter: 42 mm}}
cranes:
{cranes}
mechanics:
  bodies:
{bodies}
plan:
{plan}
simulation: {{tension_tolerance: {tolerance} N, position_tolerance: 0.0001 mm, sample_interval: 0.1 s}}
"""

CRANE = """
  {name}:
    type: fixed_hook
    at: [{x} m, 0 m, 10 m]
    block: {{mass: 6 t, height: 2 m}}
    reeving:
      {{ropes: {ropes}, parts_each: {parts}, rope: hoist, {sheaves}sheave_diameter_ratio: 20,
       upper_sheaves_at: 40 m}}
    drum: {{diameter: 1.6 m, {drum}}}
    hoist: {{speed: 60 m/min, acceleration: 0.5 m/s^2{motor}}}
"""

BODY = "    load_{name}: {{parent: {name}, joint: {{type: fixed}}, mass: 94 t}}"


def lift(
    parts: list[int],
    plan: str,
    *,
    duration: float = 20.0,
    ropes: int = 1,
    sheaves: str = "",
    drum: str = "rotating_mass: 500 kg",
    motor: str = "",
    stiffness: float = 1e4,
    tolerance: float = 1.0,
) -> Simulation:
    """Hooks h<p> of p parts each with 94 t under a hook block of 6 t; `plan` moves them."""
    names = [f"h{count}" for count in parts]
    cranes = [
        CRANE.format(
            name=name, x=10 * place, ropes=ropes, parts=count, sheaves=sheaves, drum=drum, motor=motor
        )
        for place, (name, count) in enumerate(zip(names, parts, strict=True))
    ]
    text = LIFT.format(
        duration=duration,
        stiffness=stiffness,
        tolerance=tolerance,
        cranes="".join(cranes),
        bodies="\n".join(BODY.format(name=name) for name in names),
        plan=plan.format(hooks=", ".join(names)),
    )
    return Simulation(parse_scenario(text, "reeving.yaml"))


def segments(recording: Recording, rope: str) -> list[float]:
    """Tension of every part of a rope at the end [N], from its dead end; the last is the lead line."""
    tension = recording.variables["segment_tension"].values
    names = list(recording.coordinates["segment"])
    return [float(tension[-1, at]) for at, name in enumerate(names) if name.startswith(f"{rope}/")]


@pytest.mark.parametrize("verb", ["hoist", "lower"])
@pytest.mark.parametrize("factor", [1.09, 1.045, 1.04, 1.02])
def test_lead_line_of_hooks_with_1_to_20_parts(factor: float, verb: str) -> None:
    """Raising F/W = (K − 1)/(1 − K⁻ᴺ), lowering (K − 1)/(K (Kᴺ − 1)), W the weight on the hook block.

    N parts carry the hook block over N sheaves, of which the last sends the lead line to the drum. The ropes
    have strains of 1e-6, which change the ratio at a sheave by as much (F8).
    """
    counts = list(range(1, 21))
    recording = lift(
        counts,
        f"  - {{{{step: move, {verb}: [{{hooks}}], speed: 0.6 m/min, "
        "acceleration: 0.02 m/s^2, brake_from: 39 s}}",
        duration=30.0 + 10.0,
        sheaves=f"sheaves: {{efficiency: {1 / factor!r}, rotating_mass: 10 kg}}, ",
        stiffness=1e6,
    ).run()
    late = int(np.searchsorted(recording.variables["time"].values, 38.0))
    names = list(recording.coordinates["segment"])
    for count in counts:
        own = [at for at, name in enumerate(names) if name.startswith(f"hoist.h{count}.1/")]
        tension = recording.variables["segment_tension"].values[late, own]
        assert len(own) == count + 1
        assert tension[:-1].sum() == pytest.approx(WEIGHT, rel=1e-6)
        by_lowering = factor * (factor**count - 1)
        expected = (factor - 1) / (1 - factor**-count if verb == "hoist" else by_lowering)
        assert tension[-1] / WEIGHT == pytest.approx(expected, rel=1e-6), count
    assert recording.attributes["energy_remainder"] < 1e-8


@pytest.mark.parametrize("ropes", [1, 2])
def test_speed_of_the_hook_is_that_of_the_rope_over_its_parts(ropes: int) -> None:
    """v_hook = v_rope/p, to the way; both ropes of a hook carry W/2p in each part; books close.

    With ropes that stretch by 2 per mille: what winds up takes its stretch along, so that the hook goes as
    fast as the drum, and not 1.002 times that.
    """
    plan = "  - {{step: up, hoist: [{hooks}], speed: 30 m/min, by: 8 m}}"
    recording = lift([1, 2, 7, 8], plan, duration=40.0, ropes=ropes, stiffness=500.0 / ropes).run()
    names = list(recording.coordinates["body"])
    for place, count in enumerate([1, 2, 7, 8]):
        height = recording.variables["body_position"].values[:, names.index(f"h{count}"), 2]
        speed = recording.variables["body_velocity"].values[:, names.index(f"h{count}"), 2]
        cruise = (recording.variables["time"].values > 8.0) & (recording.variables["time"].values < 15.0)
        assert speed[cruise].mean() == pytest.approx(0.5, rel=2e-4), count
        assert height[-1] - height[0] == pytest.approx(8.0, abs=2e-4), count
        paid_out = recording.variables["rope_paid_out"].values[:, place]
        assert paid_out[-1] == pytest.approx(-8.0 * count, abs=1e-9)
        for rope in range(1, ropes + 1):
            tension = segments(recording, f"hoist.h{count}.{rope}")
            assert tension == pytest.approx([WEIGHT / count / ropes] * (count + 1), rel=1e-6)
    assert recording.attributes["energy_remainder"] < 1e-8


def test_a_hook_starts_at_rest_in_its_ropes() -> None:
    """Unstretched lengths are such that the falls carry what hangs on the hook: nothing moves."""
    recording = lift([1, 4, 5, 20], "  - {{step: wait, hold: 5 s}}", duration=5.0, stiffness=200.0).run()
    names = list(recording.coordinates["body"])
    for count in (1, 4, 5, 20):
        height = recording.variables["body_position"].values[:, names.index(f"h{count}"), 2]
        assert np.abs(height - height[0]).max() < 1e-9


def test_a_motor_that_is_too_weak_lets_the_hook_down() -> None:
    """a = (W − p F)/(m + p² I/r²): the drum goes p times as fast as the hook, with p² of its inertia."""
    pull, count = 0.8 * WEIGHT / 4, 4
    plan = "  - {{step: up, hoist: [{hooks}], speed: 6 m/min, brake_from: 1.9 s}}"
    recording = lift([count], plan, duration=2.0, motor=f", capacity: {pull / 1e3!r} kN").run()
    speed = recording.variables["body_velocity"].values[:, list(recording.coordinates["body"]).index("h4"), 2]
    within = recording.variables["time"].values > 0.5
    slope = np.polyfit(recording.variables["time"].values[within], speed[within], 1)[0]
    expected = -(WEIGHT - count * pull) / (HOOK_BLOCK + LOAD + count**2 * 500.0)
    assert slope == pytest.approx(expected, rel=1e-4)


@pytest.mark.parametrize(("brake", "holds"), [("", 1.5), (", brake: {0!r} kN", 2.0)])
def test_an_emergency_stop_slips_until_the_hook_rests(brake: str, holds: float) -> None:
    """Way v² (m + p² I/r²)/2(p F − W) against the capacity F, or against a brake of its own."""
    count, speed = 4, 0.5
    pull = WEIGHT / count
    motor = f", capacity: {1.5 * pull / 1e3!r} kN" + brake.format(2.0 * pull / 1e3)
    plan = "  - {{step: down, lower: [{hooks}], speed: 30 m/min, emergency_stop_at: 8 s}}"
    # Stiff rope: the drum and the load stop as one.
    recording = lift([count], plan, duration=12.0, motor=motor, stiffness=1e6).run()
    height = recording.variables["body_position"].values[
        :, list(recording.coordinates["body"]).index("h4"), 2
    ]
    slipped = 0.5 * speed**2 * (HOOK_BLOCK + LOAD + count**2 * 500.0) / ((holds - 1.0) * WEIGHT)
    # 1 s of acceleration at 0.5 m/s², then 7 s at speed; within 1 ms the motor is asked to stop.
    expected = 0.25 + 7.0 * speed + slipped
    assert height[0] - height[-1] == pytest.approx(expected, abs=5e-4)
    assert recording.attributes["energy_remainder"] < 1e-8


@pytest.mark.parametrize("brake", [180.0, 200.0])
def test_an_emergency_stop_on_the_fourth_layer(brake: float) -> None:
    """The brake holds 1/ρ of its force, the hook goes ρ times as fast: ρ v² (m ρ² + p² I/r²)/2(p F − ρ W).

    ρ is the radius of the layer over that of the first, v the speed of rope on that.
    """
    drum = "layers: 5, wraps_per_layer: 40, wraps_at_start: 140, rotating_mass: 500 kg"
    plan = """\
  - {{step: down, lower: [{hooks}], speed: 30 m/min, emergency_stop_at: 8 s}}
  - {{step: end, hold: until_end}}"""
    motor = f", capacity: 300 kN, brake: {brake!r} kN"
    recording = lift([8], plan, drum=drum, duration=12.0, motor=motor, stiffness=1e6).run()
    ratio, speed = 1.0 + 3 * np.sin(np.pi / 3) * 0.042 / 0.8, 0.5
    slipped = 0.5 * speed**2 * ((HOOK_BLOCK + LOAD) * ratio**2 + 8**2 * 500.0)
    slipped /= 8 * brake * 1e3 - ratio * WEIGHT
    height = recording.column("body_position", "h8")[:, 2]
    # As on the first layer, 1 s of acceleration and 7 s at speed; ropes are stiff.
    assert height[0] - height[-1] == pytest.approx(ratio * (0.25 + 7.0 * speed + slipped), abs=1e-5)
    assert set(recording.column("drum_layer", "h8.drum")) == {4.0}


def test_turns_and_layers_of_a_drum_are_recorded_and_too_few_fail() -> None:
    """4 m up on 8 parts are 32 m of rope: two turns of the first layer, the rest of the second."""
    drum = "layers: 2, wraps_per_layer: 10, wraps_at_start: 8, spare_turns: 3, rotating_mass: 500 kg"
    up = "  - {{step: up, hoist: [{hooks}], speed: 30 m/min, by: 4 m}}"
    recording = lift([8], up, drum=drum).run()
    # The radius of the second is sin 60° of the rope's diameter larger.
    step = np.sin(np.pi / 3) * 0.042
    turns = 10.0 + (8 * 4.0 / np.pi - 2.0 * 1.6) / (1.6 + 2 * step)
    assert recording.variables["drum_wraps"].values[-1, 0] == pytest.approx(turns, abs=1e-9)
    assert recording.variables["drum_layer"].values[[0, -1], 0].tolist() == [1.0, 2.0]
    assert -recording.variables["rope_paid_out"].values[-1, 0] == pytest.approx(32.0, abs=1e-9)
    height = recording.variables["body_position"].values[
        :, list(recording.coordinates["body"]).index("h8"), 2
    ]
    assert height[-1] - height[0] == pytest.approx(4.0, abs=1e-4)
    # Here ropes are stiffer than steel, so that heights are those of their lengths, and that is told.
    (stiff,) = recording.attributes["warnings"]
    assert "EA of 10,000 MN" in stiff
    down = "  - {{step: down, lower: [{hooks}], speed: 30 m/min, by: 4 m}}"
    checks = check_recording(lift([8], down, drum=drum).run())
    [check] = [one for one in checks if one.name == "turns_on_drum"]
    assert check.element == "h8.drum"
    assert check.remark == "1.6 turns are left, and 3 have to stay"


def test_a_rope_leads_aside_onto_its_drum_most_at_the_flanges() -> None:
    """8 turns of 42 mm in a layer of 10, the first sheave 2.5 m off: atan(3 · 0.042/2.5); up past the end of
    the layer atan(5 · 0.042/2.5) = 4.80 deg, where a sample is within 0.02 turns of it. (WI7)
    """
    drum = "layers: 2, wraps_per_layer: 10, wraps_at_start: 8, first_sheave: 2.5 m, rotating_mass: 500 kg"
    up = "  - {{step: up, hoist: [{hooks}], speed: 6 m/min, by: 4 m}}"
    recording = lift([8], up, drum=drum, duration=45.0).run()
    (one,) = recording.rig.drums
    angle = drum_fleet_angle(one, recording.column("drum_wraps", "h8.drum"))
    assert angle is not None
    assert angle[0] == pytest.approx(math.atan(3 * 0.042 / 2.5), rel=1e-12)
    wraps = recording.column("drum_wraps", "h8.drum")
    assert angle[-1] == pytest.approx(math.atan(abs(wraps[-1] - 15.0) * 0.042 / 2.5), rel=1e-12)
    [check] = [one for one in check_recording(recording) if one.name == "drum_fleet_angle"]
    assert (check.element, check.verdict) == ("h8.drum", Verdict.WARNING)
    assert check.limit == pytest.approx(math.radians(4.0))
    assert check.value == pytest.approx(math.atan(5 * 0.042 / 2.5), rel=4e-3)
    assert check.time is not None
    assert wraps[np.searchsorted(recording.time, check.time)] == pytest.approx(10.0, abs=0.02)


def test_a_first_sheave_needs_turns_and_layers() -> None:
    """Without the turns of a layer nothing tells where rope lies across the drum."""
    up = "  - {{step: up, hoist: [{hooks}], speed: 3 m/min, by: 4 m}}"
    with pytest.raises(ScenarioError, match="'first_sheave' needs 'wraps_per_layer' beside it"):
        lift([8], up, drum="first_sheave: 2.5 m, rotating_mass: 500 kg")


def test_a_hook_goes_as_far_as_its_plan_says_on_any_layer() -> None:
    """Ways and heights of steps are the hook's; by rope of the first layer 15 m would be 15.3 to 18.2 m.

    The motor keeps its speed: on layer k the hook is faster by 1 + (k - 1) step/radius.
    """
    drum = "layers: 5, wraps_per_layer: 10, wraps_at_start: 42, rotating_mass: 500 kg"
    plan = """\
  - {{step: wait, hoist: [{hooks}], speed: 6 m/min, until: {{hoist_load: {{hook: h8, above: 990 kN}}}}}}
  - {{step: still, hold: 3 s}}
  - {{step: down, lower: [{hooks}], speed: 60 m/min, by: 3 m}}
  - {{step: rest down, hold: 3 s}}
  - {{step: to, hoist: [{hooks}], speed: 60 m/min, to: 11 m}}
  - {{step: rest, hold: 3 s}}
  - {{step: back, lower: [{hooks}], speed: 60 m/min, to: 2.5 m}}
  - {{step: end, hold: until_end}}"""
    recording = lift([8], plan, drum=drum, duration=40.0).run()
    height = recording.column("body_position", "h8")[:, 2]
    begins = {name: time for time, kind, name in recording.events() if kind == "step_begin"}
    waited, rested, risen = (
        np.interp(begins[step] - before, recording.time, height)
        for step, before in (("down", 0.2), ("to", 0.2), ("back", 0.2))
    )
    start, speed = height[0], np.abs(np.gradient(height, recording.time)).max()
    # The rope hardly stretches, 12 ppm, and what is wound takes its stretch along.
    assert rested == pytest.approx(waited - 3.0, abs=1e-6)
    assert risen == pytest.approx(start + 1.0, abs=1e-6)
    assert height[-1] == pytest.approx(start - 7.5, abs=1e-6)
    assert set(recording.column("drum_layer", "h8.drum")) == {4.0, 5.0}
    assert speed == pytest.approx(1.0 + 4 * np.sin(np.pi / 3) * 0.042 / 0.8, rel=2e-3)


def test_a_program_sees_a_hook_where_it_is_on_any_layer() -> None:
    """Height and speed of the hook 9 s into hauling, one layer higher than at the start."""
    drum = "layers: 5, wraps_per_layer: 10, wraps_at_start: 17, rotating_mass: 500 kg"
    run = lift([8], "  - {{step: wait, hold: until_end}}", drum=drum)
    run.command("h8", speed=0.9)
    run.advance_to(9.0)
    height, speed = run.drive_state("h8")
    # 100 t ring on ropes of 10 GN by what the motor's start and the climbs leave.
    assert height == pytest.approx(run.now("body_position", "h8")[2], abs=1e-4)
    assert speed == pytest.approx(run.now("body_velocity", "h8")[2], rel=1e-2)
    assert speed / 0.9 == pytest.approx(1.0 + 2 * np.sin(np.pi / 3) * 0.042 / 0.8, rel=1e-9)


def test_a_drum_without_room_is_refused() -> None:
    """28 turns do not go on two layers of 10."""
    drum = "layers: 2, wraps_per_layer: 10, wraps_at_start: 28, rotating_mass: 500 kg"
    with pytest.raises(ScenarioError, match="28 wraps do not go on a drum that has room for 20"):
        lift([2], "  - {{step: wait, hold: 1 s}}", drum=drum)


@pytest.mark.parametrize("efficiency", [1.0, 0.98, 0.95])
def test_a_hook_block_comes_down_as_long_as_it_pulls_its_lead_lines(efficiency: float) -> None:
    """(WI6), K → 1: W = p m g l. One that is just short enough is silent."""
    ropes, parts, metre = 2, 10, 8.0
    ratio = 1.0 / efficiency
    share = sum(ratio**part for part in range(1, parts + 1))
    longest = HOOK_BLOCK / (ropes * share * metre)
    if efficiency < 1.0:
        assert share == pytest.approx(ratio * (ratio**parts - 1.0) / (ratio - 1.0), rel=1e-12)

    def told(length: float) -> list[str]:
        crane = CRANE.format(
            name="h10",
            x=0,
            parts=parts,
            ropes=ropes,
            drum="rotating_mass: 500 kg",
            motor="",
            sheaves=f"sheaves: {{efficiency: {efficiency}}}, lead_line: {length:.6f} m, ",
        )
        text = LIFT.format(
            duration=1,
            stiffness=1e4,
            tolerance=1.0,
            cranes=crane,
            bodies=BODY.format(name="h10"),
            plan="  - {step: wait, hold: 1 s}",
        ).replace("mass: none", f"mass: {metre} kg/m")
        return [one for one in assemble(parse_scenario(text)).warnings if "does not come down" in one]

    assert told(0.999 * longest) == []
    (said,) = told(1.1 * longest)
    pulled = HOOK_BLOCK * G / ropes / share
    assert f"lowered, it pulls {pulled / 1e3:.2f} kN on each lead line" in said
    assert "one of 6.6 t does" in said
