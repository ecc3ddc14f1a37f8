"""Adjusting of lengths, the approximated mechanism, against closed forms."""

from __future__ import annotations

import math

import numpy as np
import pytest

from adjusting import LENGTH, held, omega, pair, step_map
from mechanics import adaptive, finished, simulate, simulation

MASS, EA = 1000.0, 1e6


@pytest.mark.parametrize("kind", ["del", "explicit"])
@pytest.mark.parametrize("factor", [0.1, 0.7, 1.0, 1.5])
def test_differences_of_held_ropes_shrink_by_one_minus_the_factor(kind: str, factor: float) -> None:
    """Ends stand still: T_i - mean after n steps is (1 - f)^n of the start, Σ ΔL = 0, for any stiffness.

    The mean is Σ ε T/Σ ε = Σ e/Σ ε. Else there is rounding: 1e-15 of 10 m over a stretch of 20 mm.
    """
    stiffness = np.array([1e6, 2e6, 5e6])
    run = simulate(held(stiffness, factor), 0.02, type=kind)
    stretch = 1e-3 * np.arange(21, 24)
    lengths = LENGTH - stretch
    tension = run.columns["rope_tension"]
    start = stretch * stiffness / lengths
    mean = stretch.sum() / np.sum(lengths / stiffness)
    # `del` says the tension of a step before it is adjusted, `explicit` that of the state which it leaves.
    steps = np.arange(21) if kind == "explicit" else np.maximum(np.arange(21) - 1, 0)
    expected = mean + (start - mean) * ((1 - factor) ** steps)[:, None]
    assert np.abs(tension - expected).max() < 1e-9 * start.max()
    lengthening = run.columns["rope_lengthening"]
    assert np.abs(lengthening.sum(axis=1)).max() < 1e-15
    whole = (start - mean) * lengths / stiffness * (1 - (1 - factor) ** 20)
    assert lengthening[-1] == pytest.approx(whole, rel=1e-9)


def test_energy_that_adjusting_takes_is_booked() -> None:
    """Held ropes at f = 1: ½ Σ ε (T_i - mean)² is gone after one step, and the books close to rounding."""
    stiffness = np.array([1e6, 2e6, 5e6])
    run = simulate(held(stiffness, 1.0), 0.01, type="explicit")
    stretch = 1e-3 * np.arange(21, 24)
    compliance = (LENGTH - stretch) / stiffness
    start = stretch / compliance
    mean = stretch.sum() / compliance.sum()
    assert run.energy("adjusting")[1:] == pytest.approx(
        0.5 * np.sum(compliance * (start - mean) ** 2), rel=1e-9
    )
    assert run.energy_remainder < 1e-12


@pytest.mark.parametrize("kind", ["del", "explicit"])
@pytest.mark.parametrize("factor", [0.05, 0.5, 1.2])
def test_a_mass_between_two_ropes_follows_the_map_of_a_step(kind: str, factor: float) -> None:
    """Stretch and velocity after n steps are those of the linear map, damping included.

    The path is straight, so nothing is left out; the tolerance is rounding of 10 m in a stretch of 1 mm.
    """
    h, tau, w = 1e-2, 2e-3, omega(MASS, EA)
    run = simulate(pair(MASS, EA, factor, damping_time=tau), 0.3, step=h, type=kind)
    state, wanted = np.array([1e-3, 0.0]), []
    position = 1e-3
    for _ in range(31):
        wanted.append([position, state[1]])
        state = step_map(kind, h, w, factor, tau) @ state
        position += h * state[1]
    found = np.stack([run.joint("m"), run.body("m", "body_velocity")[:, 0]], axis=1)
    scale = np.abs(wanted).max(axis=0)
    # Between samples a velocity is that of the step: at the start it is not yet 0.
    assert np.abs((found - wanted) / scale)[1:].max() < 1e-9
    assert run.energy_remainder < 1e-9


def growth(kind: str, factor: float, reach: float, steps: int = 60) -> float:
    """Largest velocity in the second half of a run over that in the first, hω = `reach`.

    Infinite where the run ended since the method had put in half of all energy.
    """
    h = reach / omega(MASS, EA)
    begun = simulation(pair(MASS, EA, factor, start=1e-7), steps * h, step=h, type=kind)
    status = begun.run()
    if status["status"] == "failed":
        assert "the method has put in" in status["cause"]
        return math.inf
    run = finished(begun, status)
    speed = np.abs(run.body("m", "body_velocity")[1:, 0])
    return float(speed[steps // 2 :].max() / speed[: steps // 2].max())


@pytest.mark.parametrize(
    ("kind", "factor", "reach", "stable"),
    [
        # explicit: |λ| < 1 where f < 1 and h²ω² < (4 - 2f)/(1 - f); without adjusting 2, at f = 0.5 √6.
        ("explicit", 0.0, 1.98, True),
        ("explicit", 0.0, 2.02, False),
        ("explicit", 0.5, 2.43, True),
        ("explicit", 0.5, 2.47, False),
        ("explicit", 0.98, 0.5, True),
        ("explicit", 1.02, 0.5, False),
        # del: where f < 2 + h²ω²/2.
        ("del", 1.9, 0.1, True),
        ("del", 2.05, 0.1, False),
        ("del", 3.9, 2.0, True),
        ("del", 4.1, 2.0, False),
    ],
)
def test_thresholds_of_stability(kind: str, factor: float, reach: float, stable: bool) -> None:
    """Jury's conditions on the map of a step: differences of tension grow on one side of the limit only."""
    radius = float(np.abs(np.linalg.eigvals(step_map(kind, reach, 1.0, factor))).max())
    assert (radius < 1) == stable or factor == 0.0
    assert (growth(kind, factor, reach) < 1.05) == stable


def test_adjusting_has_a_time_of_its_own() -> None:
    """Held ropes: of a difference (1 - f)^(0.1 s/h) is left after 0.1 s; by half the step its square."""
    left = []
    for step in (1e-3, 5e-4):
        run = simulate(held([1e6, 1e6], 0.02), 0.1, step=step, type="explicit", sample_interval=0.1)
        difference = np.diff(run.columns["rope_tension"], axis=1)[:, 0]
        left.append(difference[-1] / difference[0])
    assert left[0] == pytest.approx(0.98**100, rel=1e-6)
    assert left[1] == pytest.approx(left[0] ** 2, rel=1e-6)


@pytest.mark.parametrize("kind", ["del", "explicit"])
def test_slack_ropes_are_shortened_until_they_carry(kind: str) -> None:
    """A rope 1 mm too long beside one that carries T: it loses ε T f/2 per step, the other gains as much."""
    system = held([1e6, 1e6], 0.01)
    system["ropes"][0]["length"] = LENGTH + 1e-3
    run = simulate(system, 1.0, type=kind)
    assert [name for _, name in run.events("taut")] == ["r1"]
    assert np.abs(run.columns["rope_lengthening"].sum(axis=1)).max() < 1e-14
    tension = run.columns["rope_tension"]
    assert tension[0, 0] == 0.0
    # 1 mm that is pulled in of 22 mm leaves 10.5 mm for each.
    assert tension[-1] == pytest.approx(10.5e-3 * 1e6 / LENGTH, rel=2e-3)


@pytest.mark.parametrize("kind", ["del", "explicit"])
def test_a_saved_run_goes_on_with_the_same_bytes(kind: str) -> None:
    """The state remembers what has been adjusted."""
    system = pair(MASS, EA, 0.3, damping_time=2e-3)
    whole = simulation(system, 1.0, type=kind)
    whole.run()
    first = simulation(system, 1.0, type=kind)
    first.run(None, 0.4)
    second = simulation(system, 1.0, type=kind)
    second.restore(first.save())
    status = second.run()
    for name, values in whole.columns().items():
        assert np.array_equal(values, finished(second, status).columns[name]), name
    assert np.ptp(whole.columns()["rope_lengthening"]) > 0


def test_what_cannot_be_adjusted_is_refused() -> None:
    """By a sentence that names it and says what would be right."""
    system = held([1e6, 1e6], 0.5)
    with pytest.raises(ValueError, match=r"e adjusts lengths once per step.*use del or explicit"):
        adaptive(system, 1.0)

    def refusal(**changes: object) -> str:
        with pytest.raises(ValueError) as refused:
            simulate({**system, "adjusters": [{**system["adjusters"][0], **changes}]}, 1.0)
        return str(refused.value)

    assert "its factor is 0" in refusal(factor=0.0)
    assert "there is no rope `r3`" in refusal(ropes=["r1", "r3"])
    assert "takes two" in refusal(ropes=["r1"])
    assert "`r1` is adjusted twice" in refusal(ropes=["r1", "r1"])
    system["ropes"][1]["material"] = {"type": "inextensible"}
    system["ropes"][1]["length"] = LENGTH
    assert "`r2` is inextensible" in refusal()
