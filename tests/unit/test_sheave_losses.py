"""Losses and inertia of sheaves: from the words of a lift file to the document and the results."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from gantline.cli.summary import summary
from gantline.results import series
from gantline.results.recording import Recording
from gantline.scenario import ScenarioError, parse_scenario
from gantline.scenario.sheave import SheaveWords, sheave_losses
from gantline.simulation import simulate
from lift_text import BASE, spoiled
from tackle import TACKLE, assembled, flows

G = 9.81
SCENARIOS = Path(__file__).resolve().parents[2] / "scenarios"
MOVING = "below_hook: 5 m, pitch_diameter: 0.8 m"
FIXED = "below_hook: 3 m, pitch_diameter: 0.8 m"

#: The lift that tests spoil, by steps that follow it.
ADAPTIVE = BASE.replace("integrator: del, step: 1 ms", "integrator: adaptive")


def words(**said: Any) -> SheaveWords:
    return SheaveWords().model_copy(update=said)


@pytest.mark.parametrize(
    ("said", "ratio"),
    [
        ({}, 1.0),
        ({"bearing": "ideal"}, 1.0),
        ({"bearing": "roller"}, 1 / 0.98),
        ({"bearing": "plain"}, 1 / 0.96),
        ({"loss": 0.04}, 1 / 0.96),
        ({"efficiency": 0.97}, 1 / 0.97),
        # in series: what gives way first counts
        ({"bearing": "plain", "groove_friction": 0.1}, 1 / 0.96),
        ({"bearing": "plain", "groove_friction": 0.01}, math.exp(0.01 * math.pi)),
        ({"bearing": "seized", "groove_friction": 0.1}, math.exp(0.1 * math.pi)),
        ({"bearing": "seized", "groove_friction": 0.0}, 1.0),
    ],
)
def test_ratio_at_which_a_sheave_slips(said: dict[str, Any], ratio: float) -> None:
    losses = sheave_losses(words(**said), 0.4, 9.0, 300.0)
    assert losses.ratio() == pytest.approx(ratio, rel=1e-14)


def test_what_moves_with_the_rope() -> None:
    """I/r² of a solid disc is m/2; where the groove slips, what lies on half a turn of the sheave."""

    def inertia(own_mass: float | None = None, **said: Any) -> float:
        return sheave_losses(words(**said), 0.4, 9.0, own_mass).inertia

    assert inertia(bearing="plain", sheave_mass=120.0) == 60.0
    assert inertia(bearing="plain", rotating_mass=50.0, own_mass=300.0) == 50.0
    assert inertia(bearing="plain", moment_of_inertia=8.0) == pytest.approx(8.0 / 0.16)
    assert inertia(bearing="plain", own_mass=300.0) == 150.0
    assert inertia(own_mass=300.0) == 0.0, "an ideal sheave has none unless it is said"
    assert inertia(sheave_mass=120.0) == 60.0
    assert inertia(bearing="seized", groove_friction=0.1, sheave_mass=120.0) == 0.0
    seized = sheave_losses(words(bearing="seized", groove_friction=0.1), 0.4, 9.0)
    assert seized.on_sheave == pytest.approx(9.0 * math.pi * 0.4)
    assert seized.slips
    assert not sheave_losses(words(bearing="plain", sheave_mass=120.0), 0.4, 9.0).slips
    turning = sheave_losses(
        words(bearing="plain", groove_friction=0.1, sheave_mass=120.0), 0.4, 9.0, wrap=1.0
    )
    assert turning.slips
    assert turning.on_sheave == pytest.approx(9.0 * 0.4)


def test_ideal_sheaves_need_no_flow() -> None:
    explicit = BASE.replace(MOVING, f"{MOVING}, efficiency: 1.0, rotating_mass: 0 kg")
    for text in (BASE, explicit.replace(FIXED, f"{FIXED}, bearing: ideal")):
        assembly = assembled(text)
        assert not flows(assembly) and assembly.rig["sheaves"] == []
        assert not any("flow" in guide for guide in assembly.document["ropes"][0]["route"])


def test_equalizer_with_losses() -> None:
    assembly = assembled(spoiled("    hinge: {damping: 1 kN m s}\n", "    sheaves: {bearing: roller}\n"))
    names = ["e1/moving_1", "e1/fixed_1", "e1/moving_2"]
    assert list(flows(assembly)) == names, "in the order of the rope"
    # no mass of the sheaves is said: half of the 200 kg of a moving sheave
    assert [joint["inertia"] for joint in flows(assembly).values()] == [100.0] * 3
    route = assembly.document["ropes"][0]["route"]
    assert [(guide["flow"], guide["ratio"]) for guide in route[1:-1]] == [(name, 1 / 0.98) for name in names]
    first = assembly.rig["sheaves"][0]
    assert first["segments"] == ["e1.equalizing/0", "e1.equalizing/1"]
    assert (first["rope"], first["inertia_from"]) == ("e1.equalizing", "half of 200 kg")
    assert not any("/" in body["name"] for body in assembly.scene["bodies"])


def test_an_equalizer_says_more_than_its_type() -> None:
    """Own sheaves first, then what it says of all, then the sheaves of its type, then the type's of all."""
    head, _, rest = BASE.partition("equalizers:\n  e1:\n    hangs_from: hook\n")
    parts, slings, tail = rest.partition("slings:\n")

    def ratios(own: str, moving: str = "", of_type: str = "") -> tuple[float, float]:
        kind = parts.replace(MOVING, MOVING + moving) + of_type
        text = f"{head}equalizer_types:\n  T:\n{kind}equalizers:\n  e1: {{type: T, hangs_from: hook{own}}}\n"
        sheaves = assembled(text + slings + tail).rig["sheaves"]
        ratio = {sheave["name"]: sheave["ratio"] for sheave in sheaves}
        return ratio.get("e1/moving_1", 1.0), ratio.get("e1/fixed_1", 1.0)

    roller, plain, mine = 1 / 0.98, 1 / 0.96, 1 / 0.97
    assert ratios("") == (1.0, 1.0)
    assert ratios("", of_type="    sheaves: {bearing: plain}\n") == (plain, plain)
    shared = "    sheaves: {sheave_mass: 90 kg}\n"
    assert ratios("", moving=", bearing: roller", of_type=shared) == (roller, 1.0)
    assert ratios(", sheaves: {loss: 3 %}", moving=", bearing: roller") == pytest.approx((mine, mine))
    own = ", fixed_sheaves: {along: [0 m], below_hook: 3 m, pitch_diameter: 0.8 m, bearing: plain}"
    assert ratios(own) == (1.0, plain)


def test_hinges_with_friction() -> None:
    def joints(text: str) -> dict[str, Any]:
        return {one["name"]: one["joint"] for one in assembled(text).document["bodies"]}

    plain = joints(ADAPTIVE)
    assert plain["e1"]["friction"] == 0.0
    rough = joints(spoiled("hinge: {damping: 1 kN m s}", "hinge: {friction: 5 kN m}", ADAPTIVE))
    assert rough["e1"]["friction"] == 5e3


@pytest.fixture(scope="module")
def tackle() -> Recording:
    return simulate(parse_scenario(TACKLE))


def test_a_tackle_has_its_lead_line_factor(tackle: Recording) -> None:
    """F/W = (K − 1)/(1 − K⁻⁴) hauling in, (K − 1)/(K (K⁴ − 1)) paying out, K = 1/0.96."""
    k, weight = 1 / 0.96, 20e3 * G
    for time, expected in ((8.0, (k - 1) / (1 - k**-4)), (16.0, (k - 1) / (k * (k**4 - 1)))):
        at = int(np.searchsorted(tackle.time, time))
        lead = tackle.column("segment_tension", "fall/4")[at]
        # 50 kN on 200 MN is a strain of 2.5e-4, which shifts ratios by (K − 1) times as much at each sheave.
        assert lead / weight == pytest.approx(expected, rel=1e-4)


def test_variables_of_sheaves_and_drums(tackle: Recording) -> None:
    sheaves = [f"fall/sheave_{place}" for place in (1, 2, 3, 4)]
    assert list(tackle.coordinates["sheave"]) == sheaves
    assert tackle["rope_passed"].dims == ("time", "sheave") and tackle["rope_passed"].unit == "m"
    assert tackle["sheave_tension"].dims == ("time", "sheave", "side")
    assert tackle["rope_paid_out"].dims == ("time", "drum")
    assert tackle.column("rope_paid_out", "winch")[-1] == pytest.approx(-1.0, abs=1e-9)
    assert np.array_equal(
        tackle.column("rope_passed", sheaves[1]), tackle.column("joint_position", sheaves[1])
    )
    # Hauled in by 1 m, a part of line is 0.25 m shorter: what three of them were longer, unstretched, has
    # passed the third sheave. Half turns of 0.3 m belong to the parts on either side, half each.
    passed = 0.0
    for part, arcs in enumerate((0.5, 1.0, 1.0)):
        length = tackle.column("segment_length", f"fall/{part}") + arcs * math.pi * 0.3
        natural = length / (1 + tackle.column("segment_tension", f"fall/{part}") / 200e6)
        passed += natural[0] * (1 + tackle.column("segment_tension", f"fall/{part}")[0] / 200e6) - natural[-1]
    assert tackle.column("rope_passed", sheaves[2])[-1] == pytest.approx(passed, abs=1e-6)
    assert passed == pytest.approx(0.75, abs=4e-3)
    before, after = tackle.column("sheave_tension", sheaves[3])[-1]
    assert before == tackle.column("segment_tension", "fall/3")[-1]
    assert after == tackle.column("segment_tension", "fall/4")[-1]
    mean = np.mean([tackle.column("segment_tension", f"fall/{part}") for part in range(5)], axis=0)
    assert tackle.column("rope_tension", "fall") == pytest.approx(mean, rel=1e-12)


def test_metrics_and_table_of_losses(tackle: Recording) -> None:
    metrics = tackle.metrics()
    assert metrics["final_joint_travel.winch"] == pytest.approx(-1.0, abs=1e-9)
    assert metrics["peak_sheave_tension_ratio"] >= 1 / 0.96 * (1 - 1e-3)
    assert 1.0 < metrics["final_sheave_tension_ratio"] <= 1 / 0.96 * (1 + 1e-4)
    lines = summary(tackle, [], str)
    head = next(place for place, line in enumerate(lines) if line.startswith("Rope with losses"))
    assert "1.0417" in lines[head + 1] and "fall/sheave_" in lines[head + 1]
    drums = next(place for place, line in enumerate(lines) if line.startswith("Drum"))
    assert lines[drums + 1].split() == ["winch", "-1.000", "m", "-2.000", "m", "0.000", "m", "-"]
    assert lines[0] == "A tackle"


def test_a_recording_with_sheaves_can_be_kept(tackle: Recording, tmp_path: Path) -> None:
    from gantline import open_recording

    opened = open_recording(tackle.save(tmp_path / "tackle.nc"))
    assert np.array_equal(opened["sheave_tension"].values, tackle["sheave_tension"].values)
    assert opened.rig.sheaves == tackle.rig.sheaves and opened.rig.drums[0].name == "winch"
    assert opened.dataset["rope_passed"].sel(sheave="fall/sheave_1").shape == tackle.time.shape


def test_reference_lift_with_losses() -> None:
    """Slings of the reference lift end with tensions that differ, within what nine sheaves can hold."""
    text = (SCENARIOS / "equalizer" / "scenario.yaml").read_text(encoding="utf-8")
    assert text.count("efficiency: 1.0, rotating_mass: 0 kg") == 2
    lossy = text.replace("efficiency: 1.0, rotating_mass: 0 kg", "bearing: roller")
    recording = simulate(parse_scenario(lossy))
    metrics = recording.metrics()
    # All sheaves slipping one way: sling 1 over sling 5 is η⁻⁸, η = 0.98.
    spread = np.ptp(0.98 ** (2.0 * np.arange(5))) / np.mean(0.98 ** (2.0 * np.arange(5)))
    assert 0.005 < metrics["final_tension_spread"] < spread
    assert metrics["energy_remainder"] < 1e-6
    # The sheaves' own inertia, 150 kg, adds to friction while the load still rings.
    assert 1 / 0.98 * 0.999 < metrics["peak_sheave_tension_ratio"] < 1.03
    table = summary(recording, [], str)
    assert any("tension spread" in line for line in table)
    assert any(line.startswith("Rope with losses") for line in table)


#: 1 t over a sheave with true tangents, 90° of it, to the winch.
DEFLECTED = """\
format: 1
lift: {title: A deflection sheave}
duration: 4 s
ropes:
  hoist: {axial_stiffness: 50 MN, damping_time: 20 ms, mass: 9 kg/m}
mechanics:
  bodies:
    weight: {joint: {type: slider, axis: [0, 0, 1]}, mass: 1 t, at: [-0.5 m, 0 m, 0 m]}
  drums:
    winch: {diameter: 0.8 m, rotating_mass: 2 t, drive: {speed: 30 m/min, acceleration: 0.2 m/s^2}}
  ropes:
    line:
      rope: hoist
      length: as_routed
      route:
        - {type: end, body: weight}
        - {type: sheave, body: world, at: [0 m, 0 m, 10 m], axis: [0, 1, 0], diameter: 1 m, PASSING}
        - {type: end, body: world, at: [5 m, 0 m, 10.5 m], drum: winch}
plan:
  - {step: raise, haul_in: winch, speed: 12 m/min, by: 0.4 m}
  - {step: hold, hold: until_end}
"""


@pytest.mark.parametrize(
    ("passing", "ratio", "slips"),
    [
        ("bearing: plain, sheave_mass: 60 kg", 1 / 0.96, False),
        ("bearing: seized, groove_friction: 0.1", math.exp(0.1 * math.pi / 2), True),
        ("bearing: plain, groove_friction: 0.01, sheave_mass: 60 kg", math.exp(0.01 * math.pi / 2), True),
    ],
)
def test_deflection_sheave_with_losses(passing: str, ratio: float, slips: bool) -> None:
    """While it is hauled steadily the winch holds the weight times 1/η or e^{μπ/2}, whichever is less."""
    run = simulate(parse_scenario(DEFLECTED.replace("PASSING", passing)))
    sheave = run.rig.sheaves[0]
    steady = (run.time > 1.2) & (run.time < 1.8)
    assert series.tension_ratio(run, sheave)[steady] == pytest.approx(ratio, rel=1e-3)
    assert series.slip_ratio(run, sheave)[-1] == pytest.approx(ratio, rel=1e-6)
    slip = run.column("groove_slip", sheave.name) if "groove_slip" in run.variables else np.zeros(1)
    # 0.4 m less the rope's stretch; the third sheave stands, its bearing holding more than its groove.
    assert slip[-1] == pytest.approx(0.4 if slips else 0.0, abs=2e-3)


def test_a_rope_does_not_leave_a_sheave_with_losses() -> None:
    text = DEFLECTED.replace("PASSING", "bearing: plain, sheave_mass: 60 kg, may_lift_off: true")
    with pytest.raises(ScenarioError, match="a rope does not leave a sheave with losses or inertia"):
        assembled(text)
