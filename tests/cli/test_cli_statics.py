"""`gantline statics`, as people use it."""

from __future__ import annotations

import json
import math
import re
import subprocess
from pathlib import Path

import pytest
from typer.testing import CliRunner

import gantline
from gantline.cli.app import app
from lift_text import changed
from program import called

ROOT = Path(__file__).resolve().parents[2]
LOAD = "block"  # as the lift file calls it
REFERENCE = ROOT / "scenarios" / "equalizer" / "scenario.yaml"


def statics(*arguments: object) -> subprocess.CompletedProcess[str]:
    return called("statics", *arguments)


def lift(folder: Path, *changes: tuple[str, str]) -> Path:
    path = folder / "lift.yaml"
    path.write_text(changed(REFERENCE.read_text(encoding="utf-8"), *changes), encoding="utf-8")
    return path


def test_the_reference_lift(tmp_path: Path) -> None:
    result = statics("equalizer", "--sensitivities", "--modes", 2, "-o", tmp_path / "out")
    assert result.returncode == 0, result.stderr
    assert "Equilibrium at 40 s: stable" in result.stdout
    # The independent solution: 589.746 kN over its angle from the plumb.
    assert re.search(r"S1 +589\.746 kN +0\.9981 +3\.57 deg", result.stdout)
    assert re.search(LOAD + r" 1 t heavier +1\.966 kN", result.stdout)
    names = sorted(path.name for path in (tmp_path / "out").iterdir())
    assert names == ["equilibrium.nc", "motion_1.nc", "motion_2.nc"]
    recording = gantline.open_recording(tmp_path / "out" / "motion_2.nc")
    assert recording.time[-1] == pytest.approx(10.567, abs=1e-3)
    assert str(recording.attributes["status"]).startswith(f"mode 2: {LOAD} moves along")


def test_attitude_follows_the_centre_of_gravity() -> None:
    """By hand: one equalizer pulls with one force, so 0.1 m at a depth of 2.5 m turns the load by atan 0.04
    about the axis across; slings that lean make it a little more, as the table of tilting has it.
    """
    result = statics("equalizer", "--sensitivities", "--modes", 0)
    turned = re.search(r"100 mm along x +(-?[\d.]+) deg +([\d.]+) deg +0\.000 deg\n", result.stdout)
    row = LOAD + r" +\(%s.* ([\d.]+) deg\n"
    by_table = re.search(r" +".join(row % axis for axis in (r"-0\.34", r"0\.94")), result.stdout)
    assert turned is not None and by_table is not None
    soft, stiff = (float(one) for one in by_table.groups())
    # The table has two decimals, of angles and of axes; an axis off by 0.005 is 1 % of the share along x.
    assert stiff == pytest.approx(math.degrees(math.atan(0.04)), abs=0.005)
    # About the soft axis, which is turned by 20°, and the stiff one: what either does to the offset along x.
    along = math.hypot(soft * 0.94, stiff * 0.34)
    assert math.hypot(float(turned[1]), float(turned[2])) == pytest.approx(along, rel=0.01)


def test_an_equilibrium_is_held_against_the_limits(tmp_path: Path) -> None:
    asked = ("smallest_sling_tension_when_clear: 10 kN", "smallest_sling_tension_when_clear: 600 kN")
    path = lift(tmp_path, asked)
    result = statics(path, "--modes", 0)
    assert result.returncode == 1
    # S3 hangs plumb and has the least: 588.600 kN by the independent solution.
    assert re.search(
        r"FAILED +smallest_sling_tension_when_clear +588\.6 kN +>= 600\.0 kN +101\.9 %\s+S3\n", result.stdout
    )
    assert "NO-GO: 1 failed, smallest_sling_tension_when_clear 102 %" in result.stdout
    # It has no limit in this file, and no line of its own.
    assert not re.search(r"^(not checked|ok) +sling_dynamic_factor", result.stdout, re.MULTILINE)
    joined = " ".join(result.stdout.split())
    assert re.search(r" no limit [\w, ]+; not checked either: [\w, ]*sling_dynamic_factor NO-GO", joined)
    found = json.loads(statics(path, "--modes", 0, "--json").stdout)
    failed = [check["name"] for check in found["checks"] if check["verdict"] == "failed"]
    assert failed == ["smallest_sling_tension_when_clear"] and found["verdict"].startswith("NO-GO")


def test_bounds_of_losses(tmp_path: Path) -> None:
    real = ("efficiency: 1.0, rotating_mass: 0 kg", "efficiency: 0.98, rotating_mass: 100 kg")
    lossy = lift(tmp_path, real)
    result = statics(lossy, "--modes", 0)
    # A spread of 16 % fails in both bounds, see below.
    assert result.returncode == 1, result.stderr
    assert "losses of 9 sheaves left out" in result.stdout
    assert re.search(r"S1 +589\.746 kN.* 543\.\d kN +638\.\d kN", result.stdout)


def test_bounds_of_losses_are_held_against_the_limits_too(tmp_path: Path) -> None:
    """0.98 over nine sheaves leave a spread of 16 %, of 5 %; without losses it is 0.78 %, and all was GO."""
    real = ("efficiency: 1.0, rotating_mass: 0 kg", "efficiency: 0.98, rotating_mass: 100 kg")
    lossy = lift(tmp_path, real)
    text = " ".join(statics(lossy, "--modes", 0).stdout.split())
    for way in ("along the rope", "against the rope"):
        said = text.split(f"With all sheaves slipping {way}: ")[1]
        assert said.startswith("NO-GO: 3 failed, tension_spread_when_clear 323 %, load_tilt 146 %")
    found = json.loads(statics(lossy, "--modes", 0, "--json").stdout)
    assert found["verdict"].startswith("GO WITH WARNINGS")
    assert [one["verdict"][:16] for one in found["bounds"]] == ["NO-GO: 3 failed,"] * 2
    assert "With all sheaves" not in statics(lift(tmp_path), "--modes", 0).stdout


def test_an_unstable_lift_ends_with_one(tmp_path: Path) -> None:
    # The centre of gravity 1 m above the lugs' plane: whatever the slings, one equalizer lets it turn over.
    tall = ("box: [10 m, 10 m, 5 m]", "box: [10 m, 10 m, 9 m]")
    above = lift(tmp_path, tall, ("at: [0 m, 0 m, 2.5 m]\n", "at: [0 m, 0 m, 6 m]\n"))
    result = statics(above)
    assert result.returncode == 1, result.stdout + result.stderr
    assert "UNSTABLE: 2 motions lead away" in result.stdout
    assert re.search(r"leads away, e-fold in \d+\.\d+ s +- +" + LOAD + " turns about", result.stdout)
    # The unstable one first; then where it goes.
    upright, beyond = result.stdout.split("Left by itself it goes along motion 1; the stable")
    assert re.search(LOAD + r" +0\.000 deg", upright)
    tilt = re.search(LOAD + r" +([\d.]+) deg", beyond)
    assert tilt is not None
    # Until a corner meets the ground.
    assert float(tilt[1]) > 5.0


def test_where_there_is_none_it_ends_with_three() -> None:
    result = statics("pulleys")
    assert result.returncode == 3
    assert result.stdout == ""
    assert "there is no equilibrium at t = 5 s: the rope is hauled in until two of" in result.stderr


PULLED_ASIDE = """\
format: 1
lift: {title: A box that slings pull aside}
duration: 10 s
start: settled
ground: {level: 0 m, friction: 0.3}
ropes:
  kind: {axial_stiffness: 20 MN}
load:
  name: box
  shape: {box: [4 m, 4 m, 2 m]}
  datum: bottom_centre
  position: [2 m, 0 m, 0 m]
  weight: {calculated: 20 t, contingency: 1.0}
  centre_of_gravity: {at: [0 m, 0 m, 1 m]}
  stands_on: ground
  lugs:
    A: {at: [0 m, 1 m, 2 m]}
    B: {at: [0 m, -1 m, 2 m]}
cranes:
  hook: {type: fixed_hook, at: [0 m, 0 m, 12 m], hoist: {speed: 0.1 m/s, acceleration: 0.1 m/s^2}}
slings:
  SA: {from: hook, to: box.A, length: 10.3 m, rope: kind}
  SB: {from: hook, to: box.B, length: 10.3 m, rope: kind}
plan:
  - {step: take up, hoist: hook, speed: 0.01 m/s, by: 0.065 m}
  - {step: end, hold: until_end}
"""


def test_friction_that_holds(tmp_path: Path) -> None:
    """Sling force and friction by hand: EA (l/L − 1) with l = √(2² + 1² + 10.065²)."""
    path = tmp_path / "aside.yaml"
    path.write_text(PULLED_ASIDE, encoding="utf-8")
    result = statics(path, "--held", "--modes", 0)
    # Of its gear no strength is known, so that there is no verdict.
    assert result.returncode == 4, result.stderr
    distance = math.sqrt(2**2 + 1**2 + 10.065**2)
    tension = 20e3 * (distance / 10.3 - 1)
    found = re.search(r"SA +([\d.]+) kN", result.stdout)
    assert found is not None
    # The contacts of the ground give by tenths of a millimetre, beside 12 mm of stretch.
    assert float(found[1]) == pytest.approx(tension, rel=0.05)
    friction = [float(one) for one in re.findall(r"corner_\d +[\d.]+ kN +([\d.]+) kN", result.stdout)]
    # The contacts of the corners share what two slings pull aside; their tensions are read as printed.
    assert sum(friction) == pytest.approx(2 * float(found[1]) * 2 / distance, rel=0.01)
    ends = re.search(r"box along x +(-[\d.]+) m +([\d.]+) m", result.stdout)
    assert ends is not None
    # Symmetric about the hook, which is 2 m off.
    assert 2 + float(ends[1]) == pytest.approx(-(2 + float(ends[2])), abs=2e-3)


def test_where_a_run_has_got_to(tmp_path: Path) -> None:
    simulation = gantline.Simulation("reeved_hoist")
    simulation.run(until=100.0)
    state = tmp_path / "state.bin"
    state.write_bytes(simulation.save())
    result = statics("reeved_hoist", "--state", state, "--modes", 0)
    assert result.returncode == 0, result.stderr
    assert "Equilibrium at 100." in result.stdout
    assert "friction of contacts and sheaves holds what it can, from where the lift was" in result.stdout
    assert re.search(r"hook +2463\.9 kN +2629\.3 kN", result.stdout)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("equalizer", "--time", "12"), "--time: "),
        (("equalizer", "--time", "-1 s"), "--time: '-1 s' is before the start of the lift; 0 s is the start"),
        (
            ("equalizer", "--state", "nowhere.bin"),
            "--state: nowhere.bin: cannot be read (no such file or directory)",
        ),
        (
            ("equalizer", "--state", REFERENCE),
            "it is no state of a run, or is damaged or cut off; a run of this lift that cannot go on leaves",
        ),
        (("equalizer", "--state", "nowhere.bin", "--time", "1 s"), "--time does not go with it"),
        (("mechanisms",), "e1 adjusts lengths step by step, which statics does not know"),
    ],
)
def test_bad_input_is_named(arguments: tuple[str, ...], message: str) -> None:
    result = statics(*arguments)
    assert result.returncode == 2
    assert message in result.stderr
    assert "Traceback" not in result.stderr


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (
            "--level --held --sensitivities --state nowhere",
            "--state: {state}; --level and --held do not go with it, {of_state} do",
        ),
        ("--state nowhere --held", "--state: {state}; --held does not go with it, {of_state} do"),
        (
            "--state nowhere --sweep x=1..2/3 --time '1 s' --margins",
            "--state: {state}; --time, --margins and --sweep do not go with it, {of_state} do",
        ),
        (
            "--sweep x=1..2/3 --level --margins",
            "--sweep: {sweep}; --margins and --level do not go with it, {of_sweep} do",
        ),
        ("--sweep x=1..2/3 --modes 6", "--sweep: {sweep}; --modes does not go with it, {of_sweep} do"),
        ("--level --margins", "--level: {lengths}; --margins does not go with it, --want, {of_lengths} do"),
        ("--level --modes 6", "--level: {lengths}; --modes does not go with it, --want, {of_lengths} do"),
        ("--want S1=20% --held", "--want: {lengths}; --held does not go with it, --level, {of_lengths} do"),
        ("--lost load --modes 6", "--lost: {loses}; --modes does not go with it, {of_loses} do"),
        ("--plumb --most 1m --held", "--plumb: {hooks}; --most and --held do not go with it, {of_hooks} do"),
    ],
)
def test_what_does_not_go_with_a_question_is_refused(words: str, said: str) -> None:
    """No option is passed over in silence, not even one that is given its default."""
    result = CliRunner().invoke(app, f"statics equalizer {words}")
    expected = said.format(
        state="is about where a run had got to, at a time of its own",
        of_state="--modes, --sensitivities, --json and --output",
        sweep="makes a table of many equilibria",
        of_sweep="--time and --json",
        lengths="finds lengths of slings",
        of_lengths="--adjust, --most, --time, --json and --output",
        loses="shows vessels that lose a load",
        of_loses="--held, --time, --json and --output",
        hooks="moves hooks until none is pulled aside",
        of_hooks="--adjust, --time, --json and --output",
    )
    assert (result.exit_code, result.stdout, result.stderr) == (2, "", f"error: {expected}\n")


def test_what_keeps_a_load_upright(tmp_path: Path) -> None:
    """2.30 m of 2.50 m along the sheaves, 2° at 80 mm; and the warning, in the check of the tilt too."""
    result = statics("equalizer", "--modes", 0, "--margins", "-o", tmp_path / "out")
    assert result.returncode == 0, result.stderr
    assert re.search(
        LOAD + r" +\(-0\.34, 0\.94, 0\) +6\.78 MN m/rad +2\.30 m +2\.50 m +-0\.20 m +2\.49 deg", result.stdout
    )
    assert f"{LOAD} tilts in 4.02 s; by hand, with its lugs held, 5.18 s" in result.stdout
    warning = f"the slings of e1 give {LOAD} no tilt stiffness: tan(tilt) = e/2.50 m"
    assert f"WARNING: {warning}" in result.stdout
    assert re.search(r"\+x +0\.080 m +tilt beyond its limit of 2\.00 deg", result.stdout)
    assert re.search(r"up +2\.302 m +unstable", result.stdout)
    checked = called("check", tmp_path / "out" / "equilibrium.nc")
    assert warning in " ".join(checked.stdout.split())


def test_all_numbers_as_json(tmp_path: Path) -> None:
    result = statics("equalizer", "--json", "--sensitivities", "--modes", 2, "-o", tmp_path / "out")
    assert result.returncode == 0, result.stderr
    document = json.loads(result.stdout)  # where files went is said beside
    assert "Recording " in result.stderr
    assert document["sling_tension"]["S1"] == pytest.approx(589.746e3, abs=1.0)
    assert (document["stable"], document["time"], document["bounds"]) == (True, 40.0, [])
    assert [mode["number"] for mode in document["modes"]] == [1, 2]
    assert document["modes"][1]["period"] == pytest.approx(10.567, abs=1e-3)
    heavier = next(one for one in document["sensitivities"] if one["kind"] == "mass")
    assert heavier["rope_tension"]["sling.S1"] * 1000.0 == pytest.approx(1.966e3, abs=1.0)
    saved = gantline.open_recording(tmp_path / "out" / "equilibrium.nc")
    assert saved.attributes["modes"] == document["modes"]
    assert saved.attributes["statics"]["stable"] is True


def test_margins_as_json() -> None:
    """The same as in the table: a sideways shift of 80 mm tilts the load by 2°."""
    result = statics("equalizer", "--json", "--margins", "--modes", 0)
    margins = {one["direction"]: one for one in json.loads(result.stdout)["margins"]}
    assert margins["+x"]["distance"] == pytest.approx(0.080, abs=1e-3)
    assert margins["+x"]["cause"] == "tilt beyond its limit of 2.00 deg"
    assert margins["up"]["distance"] == pytest.approx(2.302, abs=1e-3)


def test_a_sweep_as_json() -> None:
    path = "cranes.test_hook.at.z"
    result = statics("equalizer", "--sweep", f"{path}=36.4 m..36.5 m/2", "--json")
    document = json.loads(result.stdout)
    assert (result.returncode, document["path"]) == (0, path)
    assert [point["value"] for point in document["points"]] == [36.4, 36.5]
    assert all(point["sling_tension"]["S1"] > 580e3 for point in document["points"])


@pytest.mark.parametrize(
    ("span", "says"),
    [
        ("36.4..36.5", "--sweep: found '36.4'; a length is written like '23 m' or '66 mm'"),
        ("36.4 m..36.5 s", "--sweep: found '36.5 s'; a length is written like '23 m' or '66 mm'"),
    ],
)
def test_values_of_a_sweep_are_like_the_one_in_the_lift_file(span: str, says: str) -> None:
    result = statics("equalizer", "--sweep", f"cranes.test_hook.at.z={span}/2")
    assert (result.returncode, result.stderr.strip()) == (2, f"error: {says}")


@pytest.mark.parametrize("names", ["", ","])
def test_an_empty_choice_is_refused(names: str) -> None:
    result = statics("equalizer", "--level", "--adjust", names)
    assert result.returncode == 2
    assert "--adjust: names nothing" in result.stderr


def test_a_spring_has_no_sensitivities_and_is_not_said_to_be_without_stiffness(tmp_path: Path) -> None:
    """A lift of `mechanics:` alone is told that there is nothing to ask about; 2 kN of EA are not 0.0 MN."""
    path = tmp_path / "pendulum.yaml"
    path.write_text(
        """\
format: 1
lift: {title: Pendulum}
duration: 1 s
ropes: {spring: {axial_stiffness: 2 kN}, rope: {axial_stiffness: 90 MN}}
mechanics:
  bodies:
    bob: {at: [0 m, 0 m, -2 m], joint: {type: point}, mass: 10 kg}
  ropes:
    r: {rope: spring, length: 2 m, route: [{type: end, body: world}, {type: end, body: bob}]}
"""
    )
    result = statics(path, "--sensitivities")
    assert "--sensitivities is about slings and loads, and there are none." in result.stdout
    looked = " ".join(called("check", path).stdout.split())
    assert "spring - 2 kN" in looked and "rope - 90 MN" in looked
    assert "in order (1 body, 1 rope; 1 s to simulate)" in looked
