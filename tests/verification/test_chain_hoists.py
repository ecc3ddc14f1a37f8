"""Chain hoists in slings: loads that they level, and forces that they share, against equations of their own.

`levelled.Levelled` has the equations: six of balance, and dL = ds/(1 + ε) of what a hoist has paid out.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from books import LOSSES, STORED, WORK, energy
from gantline import Recording, Statics, simulate
from gantline.scenario import Scenario, parse_scenario
from gantline.simulation import Simulation
from levelled import ASLANT, EA, FOUR, TWO, G, Levelled

#: Of each lift, what its hoists haul in [m].
LIFTS = {"two": (TWO, 0.3), "four": (FOUR, 0.02), "aslant": (ASLANT, 0.3)}
lifts = pytest.mark.parametrize("name", LIFTS)


def hoists(lift: Levelled) -> list[str]:
    return [name for name, leg in lift.legs.items() if leg.hoist]


def levelling(lift: Levelled, by: float, *, more: str = "", duration: float = 40.0) -> Scenario:
    """2 s of rest, the hoists haul in (or pay out, where `by` [m] is below 0) side by side, rest."""
    of = ", ".join(f"sling.{name}" for name in hoists(lift))
    plan = f"""\
  - {{step: hang, hold: 2 s}}
  - {{step: level, {"haul" if by > 0 else "veer"}: [{of}], speed: 1 m/min, by: {abs(by)!r} m}}
  - {{step: look, hold: until_end}}"""
    return parse_scenario(lift.text(plan, duration=duration, more=more))


@lifts
def test_rest_after_hauling(name: str) -> None:
    """Tensions of all slings at rest after their hoists have hauled in, beside six equations of balance."""
    lift, by = LIFTS[name]
    rest = Statics(levelling(lift, by)).equilibrium()
    own, _ = lift.at_rest(lift.hauled(dict.fromkeys(hoists(lift), -by)))
    # Two searches for the same balance, of which the own one leaves 1e-13 of the weight.
    for sling, tension in own.items():
        assert rest.tension(f"sling.{sling}") == pytest.approx(tension, rel=1e-7)
    assert rest.recording.column("chain_paid_out", hoists(lift)[0])[-1] == pytest.approx(-by, rel=1e-12)


def test_a_beam_on_two_slings_is_determinate() -> None:
    """Hauling in turns a load on two plumb slings, and leaves their forces to its weight and its lever arms.

    With its lugs 2c apart and h above its centre of gravity, which is e from their middle, a tilt θ gives
    T = W (c ± (e + h tan θ))/2c where slings stay plumb: they lean by c (1 − cos θ)/ℓ, and what that to the
    power of two does is left out.
    """
    lift, by = LIFTS["two"]
    recording = Statics(levelling(lift, by)).equilibrium().recording
    tilt = float(recording.column("load_tilt", "module")[-1])
    weight, c, e, h = lift.mass * G, 4.0, 1.0, 2.0
    before, _ = lift.at_rest()
    # What the slings stretch tilts it the other way before; and the hoist takes its sling along stretched.
    stretched = {name: leg.length * before[name] / EA for name, leg in lift.legs.items()}
    assert math.sin(tilt) == pytest.approx((by + stretched["A"] - stretched["B"]) / (2 * c), rel=2e-2)
    for name, sign in (("A", -1.0), ("B", 1.0)):
        tension = float(recording.column("rope_tension", f"sling.{name}")[-1])
        assert tension == pytest.approx(weight * (c + sign * (e + h * math.tan(tilt))) / (2 * c), rel=1e-3)


def test_one_of_four_slings() -> None:
    """A rigid load on four plumb slings of the stiffness k: one that gets shorter by δ takes k δ/4.

    The load follows by turns and lifts as far as it can; what is left is the pattern (1, −1, 1, −1)/4 of
    forces that it does not feel. With the lugs 2 m over the centre of gravity, and slings that stretch by
    0.7 %, second-order terms are 3.5 % of that in a pair, and cancel in its mean.
    """
    lift, by = FOUR, 0.005
    before, _ = lift.at_rest()
    rest = Statics(levelling(lift, by)).equilibrium()
    change = {name: rest.tension(f"sling.{name}") - before[name] for name in lift.legs}
    stiffness = EA / lift.legs["A"].length
    strain = before["A"] / EA
    # dL = −δ/(1 + ε) of the sling, which gives k (1 + ε) δ/(1 + ε).
    share = stiffness * by / 4.0
    assert 0.5 * (change["A"] + change["C"]) == pytest.approx(share, rel=5.0 * strain**2 + 5e-4)
    assert 0.5 * (change["B"] + change["D"]) == pytest.approx(-share, rel=5.0 * strain**2 + 5e-4)
    assert change["C"] > change["A"] > 0.0


@lifts
def test_a_run_comes_to_the_rest_of_its_lengths(name: str) -> None:
    """Where everything stops at the end of a run, forces are those of the lengths to which it hauled, and
    these are those of hauling at rest but for what the load swung meanwhile.
    """
    lift, by = LIFTS[name]
    scenario = levelling(lift, by)
    run = Simulation(scenario)
    recording = run.run()
    still = Statics(scenario).equilibrium_of(run.save())
    hauled, length = lift.hauled(dict.fromkeys(hoists(lift), -by)), {}
    for sling in hoists(lift):
        ends = still.recording["rope_point"].values[-1, still.recording.points_of_ropes[f"sling.{sling}"]]
        span = float(np.linalg.norm(ends[0] - ends[-1]))
        length[sling] = span / (1.0 + still.tension(f"sling.{sling}") / EA)
        # Forces of the run are off those at rest by up to 3 %, strains by 3e-4, and to and fro.
        swing = float(np.ptp(recording.column("rope_tension", f"sling.{sling}"))) / EA
        assert length[sling] == pytest.approx(hauled[sling], abs=0.05 * by * swing)
    own, _ = lift.at_rest(length)
    for sling, tension in own.items():
        assert still.tension(f"sling.{sling}") == pytest.approx(tension, rel=1e-6)


@pytest.mark.parametrize("by", [0.3, -0.3])
def test_work_of_a_chain_hoist(by: float) -> None:
    """What hoists put in is the sum of T ds, and stands in the books: positive while they haul in."""
    lift = ASLANT
    recording = simulate(levelling(lift, by), sample_interval=0.01)
    work, time = recording.column("energy", "drive_work"), recording.time
    done = 0.0
    for name in hoists(lift):
        tension, out = (
            recording.column("rope_tension", f"sling.{name}"),
            recording.column("chain_paid_out", name),
        )
        middle = 0.5 * (tension[1:] + tension[:-1])
        done -= float(middle @ np.diff(out))
    assert math.copysign(1.0, done) == math.copysign(1.0, by)
    # Trapezia over 0.01 s, of motions that take 0.3 s and are 1 % of the force: 1e-5 of them.
    assert work[-1] - work[0] == pytest.approx(done, rel=1e-5)
    assert float(time[-1]) == 40.0
    balance = energy(recording, STORED) + energy(recording, LOSSES) - energy(recording, WORK)
    assert np.ptp(balance) < 1e-8 * abs(done)


def test_by_either_method() -> None:
    """`del` comes to the forces of `adaptive`, with the error of its step."""
    lift, by = LIFTS["aslant"]
    ends = {
        method: simulate(levelling(lift, by, more=f"simulation: {{integrator: {method}{step}}}\n"))
        for method, step in (("adaptive", ""), ("del", ", step: 1 ms"))
    }
    for name in lift.legs:
        one, other = (mean_of_hold(recording, name) for recording in ends.values())
        assert one == pytest.approx(other, rel=1e-4)


def mean_of_hold(recording: Recording, sling: str) -> float:
    """Tension over the last ten seconds [N]."""
    late = recording.time > 30.0
    return float(recording.column("rope_tension", f"sling.{sling}")[late].mean())


def test_saved_while_it_hauls() -> None:
    """A run that is saved in the midst of the step goes on to the same bytes; and so does another run."""
    scenario = levelling(*LIFTS["aslant"])
    whole, again, broken = (Simulation(scenario) for _ in range(3))
    whole.run()
    again.run()
    assert broken.run(until=9.87).column("chain_paid_out", "B")[-1] == pytest.approx(-0.125, abs=0.02)
    second = Simulation(scenario)
    second.restore(broken.save())
    second.run()
    assert whole.save() == again.save() == second.save()


def test_asked_by_a_program() -> None:
    """A program moves a chain hoist as the plan does, between the ends of its range."""
    lift = TWO
    plan = "  - {step: hang, hold: until_end}"
    run = Simulation(parse_scenario(lift.text(plan, duration=40.0, hoist=", range: [-0.1 m, 0.2 m]")))
    run.command("sling.B", speed=-1.0 / 60.0, motion="veer")
    run.advance_to(30.0)
    out, speed = run.drive_state("sling.B", motion="veer")
    assert (out, speed) == pytest.approx((-0.1, 0.0), abs=1e-9)
    assert run.now("chain_paid_out", "B") == pytest.approx(-0.1)


@pytest.mark.parametrize("kind", ["length", "stiffness"])
def test_sensitivities_of_a_sling_that_was_hauled_in(kind: str) -> None:
    """Derivatives over the length that a sling then has, and over its stiffness, beside equations of balance.

    Six-point differences of ±1 to 3 mm, or 0.1 % of EA, are good to 1e-6 of the largest.
    """
    lift, by = LIFTS["aslant"]
    question = Statics(levelling(lift, by))
    question.equilibrium()
    [found] = question.sensitivities([(kind, "sling.B")])
    lengths = lift.hauled(dict.fromkeys(hoists(lift), -by))

    def forces(step: float) -> np.ndarray:
        other = dict(lengths)
        if kind == "length":
            other["B"] += step
            return np.array(list(lift.at_rest(other)[0].values()))
        return np.array(list(lift.at_rest(other, {"B": 1.0 + step})[0].values()))

    size = 1e-3
    weights = (3 / 4, -3 / 20, 1 / 60)
    slope = sum(w * (forces(k * size) - forces(-k * size)) for k, w in enumerate(weights, start=1)) / size
    scale = 1.0 if kind == "length" else 1.0 / EA
    asked = np.array([found.of(f"sling.{name}") for name in lift.legs])
    assert asked == pytest.approx(scale * np.asarray(slope), abs=1e-6 * float(np.abs(scale * slope).max()))
