"""Cases of lift files against closed forms."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from gantline.results import series
from gantline.scenario import load_scenario, parse_scenario
from gantline.scenario.file.variants import without_cases
from gantline.statics import Statics
from gantline.study import CasesResult, State, run_cases, values_of
from gantline.study.moment import begin_of_step
from lift_text import changed
from mechanics import G
from plumb_lift import AXIAL_STIFFNESS, INEXTENSIBLE, LENGTH, SQUARE, TRIANGLE, WEIGHT, plumb_lift

ROOT = Path(__file__).resolve().parents[2]
REFERENCE = (ROOT / "scenarios" / "equalizer" / "scenario.yaml").read_text(encoding="utf-8")
STIFFNESS = AXIAL_STIFFNESS / LENGTH


def cases(text: str) -> CasesResult:
    return run_cases(parse_scenario(text))


def tensions(state: State) -> list[float]:
    return list(values_of(state)["sling_tension"].values())


def reference(case: str, *changes: tuple[str, str]) -> CasesResult:
    """The reference lift with one case."""
    return cases(f"{changed(REFERENCE, *changes)}\ncases:\n  one: {case}\n")


def upright(state: State) -> np.ndarray:
    """Vertical force of each sling [N]."""
    assert state.rest is not None
    recording = state.rest.recording
    slings = [sling for sling in recording.rig.slings if sling.name not in state.cut]
    return np.array(
        [state.rest.tension(one.rope) * math.cos(series.sling_angle(recording, one)[-1]) for one in slings]
    )


def test_corners_of_the_envelope() -> None:
    """Three plumb slings that do not stretch: lever rule, Σ T (1, x, y) = W (1, x_c, y_c) in each corner."""
    text = plumb_lift(
        "corners: {vary: load.centre_of_gravity.envelope, corners: all}",
        lugs=TRIANGLE, rope=INEXTENSIBLE, envelope="[100 mm, 0.2 m, 0 m]",
    )  # fmt: skip
    states = cases(text).of("corners")
    assert [state.variant for state in states] == ["−x −y", "−x +y", "+x −y", "+x +y"]
    levers = np.array([(1.0, x, y) for x, y in TRIANGLE.values()]).T
    for state, (x, y) in zip(states, [(-0.1, -0.2), (-0.1, 0.2), (0.1, -0.2), (0.1, 0.2)], strict=True):
        expected = np.linalg.solve(levers, WEIGHT * np.array([1.0, x, y]))
        assert tensions(state) == pytest.approx(expected, rel=1e-9)


def test_hook_levels() -> None:
    """Two opposite hooks of four higher by δ: the load stays level, T = W/4 ± EA δ/2L, to the last digit."""
    level = 2e-3
    states = cases(plumb_lift("levels: {vary: {cranes.A.at.z: [0 m, 2 mm], cranes.C.at.z: [2 mm]}}")).of(
        "levels"
    )
    assert [state.variant for state in states] == [
        "cranes.A.at.z +0 m, cranes.C.at.z +2 mm",
        "cranes.A.at.z +2 mm, cranes.C.at.z +2 mm",
    ]
    half = AXIAL_STIFFNESS * level / (2 * LENGTH)
    expected = [WEIGHT / 4 + sign * half for sign in (1, -1, 1, -1)]
    assert tensions(states[1]) == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize("tolerance", ["0.01 %", "1 mm"])
def test_worst_pattern_of_lengths(tolerance: str) -> None:
    """Opposite slings long and the others short by t: level by symmetry, so T_i = EA (D/L_i − 1) exactly.

    D is how far hooks are above lugs, from Σ T_i = W. By sensitivities it is W/4 ± k t (1 + W/4EA).
    """
    off = 1e-4 * LENGTH
    states = cases(plumb_lift("off: {vary: slings.tolerance, pattern: worst}", tolerance=tolerance)).of("off")
    assert len(states) == 2
    for state, sign in zip(states, (-1, 1), strict=True):
        lengths = LENGTH + sign * off * np.array([1.0, -1.0, 1.0, -1.0])
        distance = (WEIGHT / AXIAL_STIFFNESS + 4) / np.sum(1 / lengths)
        assert tensions(state) == pytest.approx(AXIAL_STIFFNESS * (distance / lengths - 1), rel=1e-9)
        change = STIFFNESS * off * (1 + WEIGHT / 4 / AXIAL_STIFFNESS)
        expected = [WEIGHT / 4 - sign * change * one for one in (1, -1, 1, -1)]
        assert list(state.first_order.values()) == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize(("pattern", "count", "parts"), [("each", 8, 1), ("worst_pair", 2, 2)])
def test_lengths_of_single_slings_and_of_pairs(pattern: str, count: int, parts: int) -> None:
    """Each sling off by δ changes the loads by 1 ± kδ/W of W/4, a pair of opposite effect by twice that.

    In the limit of small δ/L; at δ = 1e-7 L the geometry leaves less than 1e-4 of the change.
    """
    text = plumb_lift(f"off: {{vary: slings.tolerance, pattern: {pattern}}}", tolerance="0.00001 %")
    states = cases(text).of("off")
    assert len(states) == count
    change = parts * STIFFNESS * 1e-7 * LENGTH / 4 * (1 + WEIGHT / 4 / AXIAL_STIFFNESS)
    for state in states:
        found = np.array(tensions(state)) - WEIGHT / 4
        assert np.abs(found) == pytest.approx(change, rel=1e-4)
        # Neighbours answer the other way.
        assert (np.sign(found) == np.sign(found[0]) * np.array([1, -1, 1, -1])).all()
        assert list(state.first_order.values()) == pytest.approx(tensions(state), rel=1e-9)


def test_the_worst_pattern_is_the_worst() -> None:
    """Of all 16 patterns of signs none loads a sling more than those chosen; slings of different lengths."""
    longer = "slings:\n  SA: {length: 10.0004 m, from"
    text = plumb_lift("off: {vary: slings.tolerance, pattern: worst}", tolerance="0.01 %")
    text = text.replace("slings:\n  SA: {from", longer).replace("SB: {from", "SB: {tolerance: 0.02 %, from")
    chosen = cases(text).of("off")
    every = "vary: {" + ", ".join(
        f"slings.S{name}.length: [{-off} mm, {off} mm]"
        for name, off in zip(SQUARE, (1.00004, 2.0, 1.0, 1.0), strict=True)
    ) + "}"  # fmt: skip
    written = text
    for name in "BCD":
        written = written.replace(f"S{name}: {{", f"S{name}: {{length: 10 m, ")
    brute = cases(written.replace("vary: slings.tolerance, pattern: worst", every)).of("off")
    assert len(brute) == 16
    highest = np.max([tensions(state) for state in chosen], axis=0)
    lowest = np.min([tensions(state) for state in chosen], axis=0)
    assert highest == pytest.approx(np.max([tensions(state) for state in brute], axis=0), rel=1e-9)
    assert lowest == pytest.approx(np.min([tensions(state) for state in brute], axis=0), rel=1e-9)


def test_the_worst_pattern_where_sheaves_slip() -> None:
    """Of all 32 patterns none is worse than those chosen, with nine sheaves of 2 % slipping either way."""
    lossy = ("efficiency: 1.0, rotating_mass: 0 kg", "efficiency: 0.98, rotating_mass: 150 kg")
    chosen = reference("{vary: slings.tolerance, pattern: worst}", lossy).of("one")
    varied = ", ".join(
        f"slings.S{number}.length: [{-2.5e-3 * length} m, {2.5e-3 * length} m]"
        for number, length in zip(range(1, 6), (23, 26, 26, 26, 23), strict=True)
    )
    brute = reference(f"{{vary: {{{varied}}}}}", lossy).of("one")
    assert len(brute) == 3 * 32
    for losses in ("none", "forward", "backward"):
        for most in (np.max, np.min):
            found, wanted = (
                most([tensions(state) for state in states if state.losses == losses], axis=0)
                for states in (chosen, brute)
            )
            # An equalizer leaves some ten newtons of 60 mm. Patterns of losses are worse by 0.02 N than those
            # without.
            assert found == pytest.approx(wanted, abs=0.01)
            assert np.ptp([tensions(state) for state in brute if state.losses == losses], axis=0).max() > 10.0


def test_one_of_five_slings_cut() -> None:
    """Under an ideal equalizer whose free sheave meets its stop the other four bear W/4 each, upright."""
    stops = ("travel: {up: 1.4 m, down: 1.9 m,", "travel: {up: 1.4 m, down: 1.9 m, stops: true,")
    state = reference("{cut: S3, at_step: hold, after: 1 s}", stops).of("one")[0]
    assert state.time == pytest.approx(27.0, abs=1e-8)  # the hook is at rest at 26 s
    assert upright(state) == pytest.approx(WEIGHT / 4, rel=1e-9)
    travel = values_of(state)["sheave_travel"]
    assert travel["e1.3"] == pytest.approx(-1.4, abs=0.01)  # into its stop by 1.2 MN / 100 MN/m
    assert travel["e1.3"] < -1.4


def test_losses_are_bounded_both_ways() -> None:
    """Ten parts in the ratio 0.98 from one to the next; a sling bears two of them less its sheave, in all W.

    That is for rope that does not stretch. Strain, T/EA = 3e-3, makes a ratio differ by its change at the
    sheave, 2 % of 3e-3 = 6e-5, and there are 4.5 of them from the middle to the ends: 2.7e-4.
    """
    spun = ("rotating_mass: 0 kg", "rotating_mass: 150 kg")
    kinds = (f"equalizers.e1.{kind}_sheaves.efficiency: 0.98" for kind in ("moving", "fixed"))
    states = reference(f"{{set: {{{', '.join(kinds)}}}}}", spun).of("one")
    assert [state.losses for state in states] == ["none", "forward", "backward"]
    crossing = 0.98 ** np.arange(10.0)
    pairs = crossing[:-1:2] + crossing[1::2]
    of_sheave = 300.0 * G
    expected = pairs / pairs.sum() * (WEIGHT + 5 * of_sheave) - of_sheave
    assert upright(states[0]) == pytest.approx(WEIGHT / 5, rel=1e-9)
    highest = crossing[0] / pairs.sum() * (WEIGHT + 5 * of_sheave)
    for state in states[1:]:
        assert values_of(state)["rope_tension"]["e1.equalizing"] == pytest.approx(highest, rel=2.7e-4)
        assert sorted(upright(state)) == pytest.approx(sorted(expected), rel=2.7e-4)
    assert (np.diff(upright(states[1])) * np.diff(upright(states[2])) < 0).all()


def test_a_step_that_waits_begins_when_it_begins() -> None:
    """Cut as the step begins a sling bears nothing from the moment found on, and its share just before."""
    scenario = without_cases(load_scenario(ROOT / "scenarios" / "equalizer_yard"))
    begin = begin_of_step(Statics(scenario), "hoist")
    assert begin is not None and 10.0 < begin < scenario.duration
    step = "{step: hoist,         hoist"
    assert step in scenario.text
    cut = Statics(parse_scenario(scenario.text.replace(step, f"{{cut: sling.S1, {step[1:]}")))
    assert cut.equilibrium(begin - 1e-6).tension("sling.S1") > 500e3
    assert cut.equilibrium(begin + 1e-6).tension("sling.S1") == 0.0
