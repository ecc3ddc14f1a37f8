"""Compensators: what checks, tables, pictures and `gantline check` say of them, and what is refused."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from gantline.assembly import assemble
from gantline.assembly.cranes.compensator_stages import stages
from gantline.checks import Check, Verdict, check_recording
from gantline.checks.compensators import stroke_margin
from gantline.checks.measure import Caution
from gantline.cli.summary import summary
from gantline.plot.traces import rod_out
from gantline.report.first_page import stop_if
from gantline.report.subject import Subject
from gantline.results import Recording
from gantline.results.cranes.compensators import borne, counted, in_words, met_while
from gantline.scenario import Scenario, ScenarioError, parse_scenario, resolve
from gantline.simulation import simulate
from gantline.statics import Statics
from lift_text import changed
from shown import ROOT, lift_on

TEXT = lift_on(ROOT / "docs" / "concepts" / "compensator.md", "A manifold under a passive compensator")
SEALS = "    seal_friction: 20 kN\n"
PULL = "{rod_in: 600 kN, rod_out: 900 kN}"


def lift(*pieces: tuple[str, str]) -> Scenario:
    return parse_scenario(changed(TEXT, *pieces), "lift.yaml")


def checks_of(recording: Recording) -> dict[str, Check]:
    return {check.name: check for check in check_recording(recording)}


def doubts(*pieces: tuple[str, str]) -> list[str]:
    return [
        doubt.sentence for doubt in assemble(lift(*pieces)).doubts if doubt.path.startswith("compensators")
    ]


def refusal(*pieces: tuple[str, str]) -> str:
    with pytest.raises(ScenarioError) as problem:
        assemble(lift(*pieces))
    return str(problem.value)


@pytest.fixture(scope="module")
def run() -> Recording:
    return simulate(lift(), duration=20.0)


def test_what_hangs_is_held_against_its_rated_capacity(run: Recording) -> None:
    """By hand: 70 t of 100 t, the rule without a factor; the peak is that of both slings upright."""
    checks = checks_of(run)
    static = checks["compensator_load_of_rated_capacity"]
    assert static.value == pytest.approx(0.70, abs=1e-3)
    assert static.verdict is Verdict.OK
    upright = np.cos(np.arcsin(2.0 / 9.8))
    peak = 2.0 * run.column("rope_tension", "sling.S1").max() * upright / (100e3 * 9.81)
    assert checks["compensator_peak_of_rated_capacity"].value == pytest.approx(peak, rel=1e-3)


def test_one_of_unknown_capacity_is_a_warning() -> None:
    """Neither what hangs from it nor the peak of that is held against anything; the rest of it is checked."""
    text = ("    rated_capacity: 100 t                          # of all that hangs below it\n", "")
    checks = checks_of(simulate(lift(text), duration=20.0))
    for name in ("compensator_load_of_rated_capacity", "compensator_peak_of_rated_capacity"):
        assert (checks[name].verdict, checks[name].value) == (Verdict.WARNING, None)
        assert checks[name].remark == "rated capacity not known: PHC"
    assert checks["compensator_stroke_margin"].value is not None
    assert doubts(text) == []


def test_the_margin_of_the_stroke_counts_once_the_load_is_clear(run: Recording) -> None:
    """Until then the rod stands on its inner stop, as it is meant to."""
    out = run.column("rod_out", "PHC")
    # The gas pulls 600 kN into a stop of 100 MN/m, which gives 6 mm.
    assert out[0] == pytest.approx(0.0, abs=0.01)
    check = checks_of(run)["compensator_stroke_margin"]
    metrics = run.metrics()
    assert check.value == pytest.approx(metrics["least_rod_out.PHC"] / 3.0)
    assert check.element == "PHC in"
    assert check.verdict is Verdict.NOT_CHECKED
    assert metrics["stroke_margin.PHC"] == check.value
    assert metrics["largest_rod_out.PHC"] == out.max()


def with_stops(run: Recording, *times: float) -> Recording:
    """The recording with the rod at a stop at these times [s] besides, and another joint at its own."""
    events = sorted(
        [*run.events(), *((time, "stop_hit", "PHC.rod") for time in times), (15.0, "stop_hit", "other")]
    )
    names = ("event_time", "event_kind", "event_name")
    columns = zip(names, map(np.array, zip(*events, strict=True)), strict=True)
    changed = {name: replace(run[name], values=values) for name, values in columns}
    return Recording({**run.variables, **changed}, run.coordinates, run.attributes)


def test_a_stop_that_is_met_between_samples_is_told(run: Recording) -> None:
    """Where the load is clear at both samples around it, of checks of the whole lift alone."""
    phc = run.rig.compensators[0]
    first = int(np.argmax(counted(run, phc)))
    assert not counted(run, phc)[:first].any() and counted(run, phc)[first:].all()
    at, before = float(run.time[first]), float(run.time[first - 1])
    meant = with_stops(run, 0.0, before, (before + at) / 2, at)
    assert list(met_while(meant, phc)) == list(met_while(run, phc)) == []
    late = float(run.time[first + 1])
    for times, again in (((late,), ""), ((late, 15.01, before), ", 2 times in all")):
        hit = with_stops(run, *times)
        check = checks_of(hit)["compensator_stroke_margin"]
        said = f"PHC.rod met its stop at {late:.2f} s, with the load hanging{again}"
        assert check.verdict is Verdict.WARNING and check.remark.endswith(said)
        everywhere = np.ones(len(hit.time), dtype=np.bool_)
        assert Caution(said) in list(stroke_margin(hit, everywhere))
        part = everywhere.copy()
        part[0] = False
        assert not any(isinstance(one, Caution) for one in stroke_margin(hit, part))


def test_how_a_margin_is_said(run: Recording) -> None:
    """The least way from the nearer stop, with the load clear, over the stroke of 3 m."""
    least = run.metrics()["least_rod_out.PHC"]
    assert checks_of(run)["compensator_stroke_margin"].formula == f"{least:.3f} m / 3.000 m"


def test_what_it_says_is_what_was_recorded(run: Recording) -> None:
    """Of samples at which the load is clear; the other end of the stroke is 3 m away. 70 t hang from it.

    Friction holds the rod where it has come out the most.
    """
    phc = run.rig.compensators[0]
    out = run.column("rod_out", "PHC")
    clear = (run["contact_force"].values == 0.0).all(axis=1)
    least, most, last = out[clear].min(), out[clear].max(), out[-1]
    assert least < last == most
    assert run.metrics()["least_rod_out.PHC"] == least
    assert run.metrics()["largest_rod_out.PHC"] == most
    assert run.metrics()["stroke_margin.PHC"] == pytest.approx(min(least, 3.0 - most) / 3.0, rel=1e-12)
    upright = borne(run, phc)
    at = int(np.argmax(upright))
    said = dict(in_words(run, phc))
    assert list(said) == ["rod out", "stroke used", "pull of the gas", "hangs from it"]
    assert said["rod out"] == f"{least:.3f} m to {most:.3f} m when clear, {last:.3f} m at the end"
    margins = f"margins {least:.3f} m to the inner stop, {3.0 - most:.3f} m to the outer one"
    assert said["stroke used"] == f"{100 * (most - least) / 3.0:.1f} % of 3.000 m, {margins}"
    gas = run.column("rope_tension", "PHC.gas").max() / 1e3
    pulls = "600.0 kN with the rod in, 900.0 kN with it out"
    assert said["pull of the gas"] == f"{gas:.1f} kN at most; {pulls}"
    peak = f"{upright[at] / 1e3:.1f} kN at most, at {run.time[at]:.2f} s"
    static, _, rest = said["hangs from it"].partition(" kN static, ")
    assert rest == peak and float(static) == pytest.approx(70 * 9.81, rel=1e-3)
    hit = dict(in_words(with_stops(run, 3.0, 7.25), phc))
    assert hit["stop met"] == "at 3.00 s, 2 times in all"


@pytest.mark.parametrize(("limit", "verdict"), [("20 %", Verdict.OK), ("40 %", Verdict.FAILED)])
def test_a_margin_can_be_asked_for(limit: str, verdict: Verdict) -> None:
    text = ("load_tilt: 5 deg", f"load_tilt: 5 deg, compensator_stroke_margin: {limit}")
    checks = checks_of(simulate(lift(text), duration=20.0))
    assert checks["compensator_stroke_margin"].verdict is verdict


def test_a_rod_that_meets_its_outer_stop_warns() -> None:
    """Gas of 500 kN to 650 kN under 706 kN: it gives all of its stroke, and the load hangs on the stop."""
    run = simulate(
        lift(("{rod_in: 600 kN, rod_out: 900 kN}", "{rod_in: 500 kN, rod_out: 650 kN}")), duration=30.0
    )
    check = checks_of(run)["compensator_stroke_margin"]
    assert check.verdict is Verdict.WARNING
    assert check.element == "PHC out"
    assert check.value is not None
    assert check.value < 0.0
    (event,) = [one for one in run.events("stop_hit") if one[2] == "PHC.rod"][:1]
    assert any(f"PHC.rod met its stop at {event[0]:.2f} s" in text for text in run.attributes["warnings"])
    assert run.column("rod_out", "PHC")[-1] == pytest.approx(3.0, abs=0.01)


def test_what_the_table_says(run: Recording) -> None:
    lines = summary(run, check_recording(run), lambda verdict: verdict.value)
    at = lines.index("Compensator PHC")
    assert "1.264 m when clear" in lines[at + 1]
    assert "of 3.000 m, margins 1.07" in lines[at + 2]
    assert not any(line.startswith("Rope ") for line in lines)


def test_its_picture_has_both_stops(run: Recording) -> None:
    figure = rod_out(run)
    assert figure is not None
    panel = figure.axes[0]
    assert {text.get_text() for text in panel.texts} >= {"outer stop, 3 m", "inner stop"}


def test_one_that_is_locked_has_no_margin_and_a_pin() -> None:
    run = simulate(lift((SEALS, "    locked: true\n")), duration=10.0)
    checks = checks_of(run)
    assert checks["compensator_stroke_margin"].value is None
    assert "PHC.rod" in run.coordinates["pin"]
    assert "stroke_margin.PHC" not in run.metrics()
    said = dict(in_words(run, run.rig.compensators[0]))
    assert said["rod out"] == "0.000 m at the end, locked or the load never clear"
    pin = np.abs(run.column("pin_force", "PHC.rod")).max() / 1e3
    assert said["locking pin"] == f"{pin:.1f} kN at most" and "stroke used" not in said
    # Of 72 t that hang the gas pulls 600 kN, and as chords of its law at most 1e-4 of that more, (PC4);
    # the pin holds the rest. The snatch of the lift-off has died away by then: less than a newton is left.
    rest = 72e3 * 9.81 - 600e3
    assert rest - 1e-4 * 600e3 <= run.column("pin_force", "PHC.rod")[-1] <= rest


def test_a_pin_is_pulled_and_put_in_by_the_plan() -> None:
    """Freed, the rod comes out; once it is at rest a pin goes in and it stays."""
    steps = (
        "\n  - {step: free, hold: 30 s, pull_pins: PHC}\n  - {step: lock, hold: until_end, put_in_pins: PHC}"
    )
    text = ("\n  - {step: hold, hold: until_end}", steps)
    damped = ("    damping: 20 kN s/m\n", "    damping: 200 kN s/m\n")
    run = simulate(lift((SEALS, "    locked: true\n"), text, damped))
    out = run.column("rod_out", "PHC")
    kinds = [kind for _, kind, name in run.events() if name == "PHC.rod" and kind.startswith("pin")]
    assert kinds == ["pin_pulled", "pin_put_in"]
    pulled, put_in = (time for time, kind, _ in run.events() if kind.startswith("pin"))
    words = dict(in_words(run, run.rig.compensators[0]))["locking pin"]
    assert words.endswith(f" kN at most, pulled at {pulled:.2f} s, put in at {put_in:.2f} s")
    assert out[0] == pytest.approx(0.0, abs=1e-6)
    column = 3.0 / (1.0 - (600 / 900) ** (1 / 1.1))
    assert out[-1] == pytest.approx(column * (1.0 - (600e3 / (72e3 * 9.81)) ** (1 / 1.1)), abs=5e-3)
    assert run.metrics()["largest_rod_out.PHC"] <= out.max()


def test_it_weighs_what_it_weighs_where_the_design_weight_is_more() -> None:
    """Contingency of 10 % on 70 t alone: 77 t + 8 t in the hook, and 77 t on the compensator of 100 t."""
    heavier = (
        "weight: {calculated: 70 t}",
        "weight: {calculated: 70 t, contingency: 1.1, simulate: calculated}",
    )
    checks = checks_of(simulate(lift(heavier), duration=40.0))
    assert checks["static_hook_load"].value == pytest.approx(85e3 * 9.81, rel=2e-3)
    assert checks["compensator_load_of_rated_capacity"].value == pytest.approx(0.77, rel=2e-3)


def test_a_lift_that_begins_with_its_rod_out() -> None:
    """The load hangs from the start, 1.341 m below where it does with the rod in: (PC1) under 706 kN."""
    pieces: list[tuple[str, str]] = [
        ("  position: [0 m, 0 m, 0 m]\n  stands_on: ground\n", "  position: [0 m, 0 m, 5 m]\n"),
        ("at: [0 m, 0 m, 19 m]", "at: [0 m, 0 m, 25.42 m]"),
        (SEALS, "    out_at_start: 1.341 m\n"),
    ]
    rest = Statics(lift(*pieces)).equilibrium(0.0)
    assert rest.recording.column("rod_out", "PHC")[-1] == pytest.approx(1.341, abs=2e-3)
    assert rest.tension("PHC.gas") == pytest.approx(72e3 * 9.81, rel=1e-6)


def test_what_gantline_check_warns_of() -> None:
    assert doubts() == []
    (stays_in,) = doubts((PULL, "{rod_in: 700 kN, rod_out: 900 kN}"))
    assert stays_in.startswith(
        "in air 706 kN hang on the gas of PHC, its rod counted, no more than it holds, 720 kN"
    )
    assert "the rod stays in" in stays_in
    (stays_out,) = doubts((PULL, "{rod_in: 500 kN, rod_out: 650 kN}"))
    assert "650 kN: the rod stays out" in stays_out
    (seals,) = doubts((PULL, "{rod_in: 500 kN, rod_out: 700 kN}"))
    assert seals.endswith("only its seals, 20.0 kN, may keep the rod off its outer stop")
    (capacity,) = doubts(("    rated_capacity: 100 t  ", "    rated_capacity: 80 t  "))
    assert capacity.startswith(
        "the gas of PHC pulls with 900 kN at the end of the stroke, and it may carry 785 kN"
    )
    locked, strong = (SEALS, "    locked: true\n"), (PULL, "{rod_in: 720 kN, rod_out: 900 kN}")
    assert doubts(locked, strong) == []
    freed = ("{step: hold, hold: until_end}", "{step: hold, hold: until_end, pull_pins: PHC}")
    (stays_in,) = doubts(locked, strong, freed)
    assert "no more than it holds, 720 kN with the rod in: the rod stays in" in stays_in


#: Own period of 72 t on the gas, (PC5) with the rod as far out as it goes for that, (PC1).
COLUMN = 3.0 / (1.0 - (600 / 900) ** (1 / 1.1)) * (600e3 / (72e3 * 9.81)) ** (1 / 1.1)
OWN_PERIOD = 2 * math.pi * math.sqrt(72e3 / (1.1 * 72e3 * 9.81 / COLUMN))
BARGE = """\
vessels:
  barge:
    draft: 4 m
    hull: {box: [100 m, 30 m, 8 m]}
    masses: {all: {mass: 12300 t, at: [50 m, 0 m, 5 m]}}
    radii_of_gyration: [11 m, 27 m, 27 m]
    position: [-200 m, 0 m]
"""


def test_cylinder_and_rod_are_solid_round_bars() -> None:
    """m (3 r² + l²)/12 across and m r²/2 along, about the middle: 6 t of 0.6 m × 4 m, 2 t of 0.25 m × 3.5 m.

    The cylinder is below its bearing, the rod above its own.
    """
    bodies = {body["name"]: body for body in assemble(lift()).document["bodies"]}
    for name, mass, radius, length, middle in (
        ("PHC", 6e3, 0.3, 4.0, -2.0),
        ("PHC.rod", 2e3, 0.125, 3.5, 1.75),
    ):
        across = mass * (3 * radius**2 + length**2) / 12
        expected = [across, across, mass * radius**2 / 2, 0.0, 0.0, 0.0]
        assert bodies[name]["inertia"] == pytest.approx(expected, rel=1e-12)
        assert bodies[name]["centre_of_gravity"] == pytest.approx([0.0, 0.0, middle])


@pytest.mark.parametrize(
    ("ratio", "said"),
    [
        (0.5, "the load goes 2 times as far"),
        (0.895, "the load goes 9.5 times as far"),
        (0.905, "the load goes more than 10 times as far"),
        (1.08, "the load goes more than 10 times as far"),
        (1.25, "the load goes 4 times as far"),
        (1.999, "the load goes 1 times as far"),
        (2.001, None),
    ],
)
def test_waves_that_are_too_slow_for_a_compensator(ratio: float, said: str | None) -> None:
    """1/|1 - (T0/T)²|, (PC6), which is less than one below T0/√2; there are none where no vessel is."""
    period = OWN_PERIOD / math.sqrt(ratio)
    waves = f"waves: {{swell: {{height: 0.1 m, period: {period!r} s, direction: 30 deg}}}}\n"
    load = ("load:\n", f"water: {{level: -9 m}}\n{waves}{BARGE}load:\n")
    found = [one for one in doubts(load) if "period" in one]
    assert len(found) == (said is not None)
    if said is not None:
        own = f"has a period of {OWN_PERIOD:.1f} s of its own, and swell one of {period:.1f} s"
        least = f"damping aside; below {OWN_PERIOD / math.sqrt(2):.1f} s it goes less"
        assert found[0].endswith(f"{own}: {said} as its hook, {least}")


def test_what_it_holds_counts_its_seals() -> None:
    """706 kN hang on it; with the rod in it holds 687 kN and 20 kN of its seals, or so much less."""
    (stays_in,) = doubts((PULL, "{rod_in: 687 kN, rod_out: 900 kN}"))
    assert "no more than it holds, 707 kN with the rod in, seals counted: the rod stays in" in stays_in
    assert doubts((PULL, "{rod_in: 686 kN, rod_out: 900 kN}")) == []
    (alone,) = doubts((PULL, "{rod_in: 707 kN, rod_out: 900 kN}"), (SEALS, ""))
    assert "no more than it holds, 707 kN with the rod in: the rod stays in" in alone
    (kept,) = doubts((PULL, "{rod_in: 500 kN, rod_out: 687 kN}"))
    assert "only its seals, 20.0 kN, may keep" in kept
    (stays_out,) = doubts((PULL, "{rod_in: 500 kN, rod_out: 686 kN}"))
    assert "686 kN: the rod stays out" in stays_out
    capacity = "    rated_capacity: 100 t  "
    assert doubts((capacity, "    rated_capacity: 91.8 t  ")) == []
    (told,) = doubts((capacity, "    rated_capacity: 91.7 t  "))  # 900 kN are 91.74 t
    assert "pulls with 900 kN at the end of the stroke, and it may carry 900 kN" in told


def test_in_the_water_less_hangs_on_it() -> None:
    """By hand: 70 t less 25 m³ x 1.025 t/m³ are 44.4 t; with the rod 455 kN, which 600 kN hold in."""
    masses = "added_mass: [20 t, 30 t, 60 t], drag_coefficients: [2, 2, 2]"
    wet = f"  in_water: {{displaced_volume: 25 m^3, {masses}}}\n"
    (sentence,) = doubts(("  lugs:\n", f"{wet}  lugs:\n"), ("load:\n", "water: {level: -9 m}\nload:\n"))
    assert sentence.startswith("in the water 455 kN hang on the gas of PHC")


def test_in_the_water_its_period_is_that_of_the_added_mass_too() -> None:
    """(PC5) of 72 t and 60 t of added mass; 5 m³ x 1.025 t/m³ less hang on the gas, and the rod is less far
    out: its column, (PC1), is as long as 0.6 MN over that pull to the power of 1/1.1 makes it.
    """
    masses = "added_mass: [20 t, 30 t, 60 t], drag_coefficients: [2, 2, 2]"
    wet = f"  in_water: {{displaced_volume: 5 m^3, {masses}}}\n"
    given = lift(("  lugs:\n", f"{wet}  lugs:\n"), ("load:\n", "water: {level: -9 m}\nload:\n"))
    in_air, in_water = stages(given, resolve(given))
    pull = (72e3 - 5.0 * 1025.0) * 9.81
    column = 3.0 / (1.0 - (600 / 900) ** (1 / 1.1)) * (600e3 / pull) ** (1 / 1.1)
    assert in_water.pull == pytest.approx(pull, rel=1e-9)
    assert in_air.period == pytest.approx(OWN_PERIOD, rel=1e-9)
    assert in_water.period == pytest.approx(2 * math.pi * math.sqrt(132e3 * column / (1.1 * pull)), rel=1e-9)


CHARGE = "gas: {charge_pressure: 6 MPa, piston_area: 0.1 m^2, volume: 1 m^3}"
MISTAKES: dict[str, tuple[Any, ...]] = {
    "neither pull nor gas": (
        ("    pull: {rod_in: 600 kN, rod_out: 900 kN}        # of the gas, seals aside\n", ""),
        "lift.yaml:25: compensators.PHC: neither 'pull' nor 'gas' found; 'pull: {rod_in: 600 kN, rod_out: "
        "900 kN}' says what it pulls with",
    ),
    "both": (
        (
            "    gas_exponent",
            f"    {CHARGE}\n    gas_exponent",
        ),
        "lift.yaml:31: compensators.PHC.gas: 'pull' and 'gas' stand together; a compensator has one of them",
    ),
    "pull that falls": (
        ("rod_out: 900 kN", "rod_out: 90 kN"),
        "lift.yaml:30: compensators.PHC.pull.rod_out: 90.0 kN is not more than 600.0 kN with the rod in; the "
        "gas is compressed as the rod comes out",
    ),
    "pull that rises by nothing": (
        ("rod_out: 900 kN", "rod_out: 600.0000000000001 kN"),
        "lift.yaml:30: compensators.PHC.pull.rod_out: 600.0 kN is not more than 600.0 kN with the rod in",
    ),
    "cylinder too short": (
        ("length: 4 m, diameter", "length: 2 m, diameter"),
        "lift.yaml:28: compensators.PHC.cylinder: a cylinder of 2 m has no room for a stroke of 3 m; "
        "'length' of the cylinder is at least its stroke",
    ),
    "bearings too near": (
        ("    length: 4.5 m", "    length: 3.5 m"),
        "lift.yaml:26: compensators.PHC.length: 3.5 m from bearing to bearing is less than the 4 m of its "
        "cylinder; the rod's bearing is below the cylinder, rod in",
    ),
    "rod too thick": (
        ("diameter: 0.25 m", "diameter: 0.65 m"),
        "lift.yaml:29: compensators.PHC.rod: a rod of 0.65 m does not go into a cylinder of 0.6 m; the "
        "diameter of the rod is the smaller one",
    ),
    "too little gas": (
        (
            "pull: {rod_in: 600 kN, rod_out: 900 kN}",
            CHARGE.replace("1 m^3", "0.3 m^3"),
        ),
        "lift.yaml:30: compensators.PHC.gas: 0.3 m^3 of gas are no more than the 0.3 m^3 that the stroke "
        "takes; its volume is that with the rod in, with accumulators",
    ),
    "pressure in bar": (
        (
            "pull: {rod_in: 600 kN, rod_out: 900 kN}",
            CHARGE.replace("6 MPa", "60 bar"),
        ),
        "lift.yaml:30: compensators.PHC.gas.charge_pressure: '60 bar'",
    ),
    "out too far": (
        (SEALS, "    out_at_start: 4 m\n"),
        "lift.yaml:32: compensators.PHC.out_at_start: 4 m is more than the stroke of 3 m; the rod starts "
        "between its stops",
    ),
    "exponent of a digit too few": (
        ("gas_exponent: 1.1", "gas_exponent: 0.11"),
        "lift.yaml:31: compensators.PHC.gas_exponent: 0.11 is no exponent of a gas; from 1 of slow motion to "
        "1.4 of fast motion is right, under high pressure up to 2",
    ),
    "nothing holds it": (
        ("from: hook, to: PHC", "from: hook, to: manifold.L1"),
        "lift.yaml:25: compensators.PHC: no sling holds it; a sling with 'to: PHC' does",
    ),
    "nothing hangs from it": (
        ("{rope: sling, from: PHC, to: manifold.L1", "{rope: sling, from: hook, to: manifold.L1"),
        ("{rope: sling, from: PHC, to: manifold.L2", "{rope: sling, from: hook, to: manifold.L2"),
        "lift.yaml:25: compensators.PHC: nothing hangs from it; a sling with 'from: PHC' does",
    ),
    "in a circle": (
        ("from: hook, to: PHC", "from: PHC, to: PHC"),
        "lift.yaml:25: compensators.PHC: hangs in a circle (PHC -> PHC); at the top there is a moving sheave "
        "or a hook",
    ),
    "misspelt in 'from'": (
        ("from: PHC, to: manifold.L1", "from: PCH, to: manifold.L1"),
        "lift.yaml:38: slings.S1.from: 'PCH' is no moving sheave, no hook and no compensator; did you "
        "mean 'PHC'?",
    ),
    "misspelt in 'to'": (
        ("from: hook, to: PHC", "from: hook, to: PCH"),
        "lift.yaml:37: slings.grommet.to: 'PCH' is not a lug; did you mean 'PHC'?",
    ),
    "inextensible": (
        ("grommet: {axial_stiffness: 200 MN, damping_time: 10 ms, ", "grommet: {inextensible: true, "),
        "lift.yaml:37: slings.grommet: is inextensible, and a compensator hangs on it or carries it; give "
        "its rope an axial stiffness",
    ),
    "a name twice": (
        ("  name: manifold", "  name: PHC.rod"),
        "'PHC.rod' is already the name of the rod of a compensator; the load needs another name",
    ),
    "a pin beside seals": (
        ("hold: until_end", "hold: until_end, put_in_pins: PHC"),
        "lift.yaml:42: step 'hold', plan[2].put_in_pins: 'PHC' has seal friction, and a pin that steps "
        "move; one joint "
        "has only one of them: leave 'seal_friction' out, or 'locked: true' on for all of the lift",
    ),
    "a pin that is not in": (
        (SEALS, ""),
        ("hold: until_end", "hold: until_end, pull_pins: PHC"),
        "plan[2].pull_pins: the pin of 'PHC' is not in; 'locked: true' puts it in at the start",
    ),
    "a pin of nothing": (
        ("hold: until_end", "hold: until_end, pull_pins: PHX"),
        "plan[2].pull_pins: 'PHX' is no equalizer, no moving sheave and no compensator; known here: "
        "'PHC.rod'",
    ),
    "explicit": (
        ("limits: {rule", "simulation: {integrator: explicit, step: 1 ms}\nlimits: {rule"),
        "'explicit' knows no friction of sheaves and joints and no brakes; 'adaptive' or 'del' is right here",
    ),
}


@pytest.mark.parametrize("mistake", MISTAKES)
def test_what_is_refused(mistake: str) -> None:
    *pieces, says = MISTAKES[mistake]
    assert says in refusal(*pieces)


def test_a_rod_that_goes_in_as_the_load_is_set_down_is_no_warning() -> None:
    """It meets its inner stop under the load that stands, as it is meant to; that is an event alone."""
    down = (
        "  - {step: set down, lower: hook, by: 3.9 m, speed: 12 m/min}\n  - {step: hold, hold: until_end}\n"
    )
    run = simulate(lift(("  - {step: hold, hold: until_end}\n", down)), duration=50.0)
    assert [name for _, _, name in run.events("stop_hit")] == ["PHC.rod"]
    assert not any("met its stop" in text for text in run.attributes["warnings"])
    assert "met its stop" not in checks_of(run)["compensator_stroke_margin"].remark
    assert checks_of(run)["compensator_stroke_margin"].verdict is Verdict.NOT_CHECKED


def test_the_first_page_says_when_to_stop(run: Recording) -> None:
    assert "the rod of PHC is on a stop, the load clear" in stop_if(Subject(run))
