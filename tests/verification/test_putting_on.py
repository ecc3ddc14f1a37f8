"""Slings that steps of the plan put on: forces by hand before and after, slack at first, what is refused."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
import pytest

import gantline
from gantline.checks import Verdict, check_recording
from gantline.results.recording import Recording
from gantline.scenario import Scenario, parse_scenario
from gantline.simulation import Simulation, SimulationError
from hooked_lift import hooked_lift
from mechanics import G
from spreader_lifts import BAR, LOAD, one_bar

MASS, EA, DAMPING = 200e3, 200e6, 0.1
WEIGHT = MASS * G
#: A load of 10 m by 6 m by 4 m on the ground, under one hook: slings of 10 m to lugs 4 m aside of it, and
#: those that are put on later, of 12 m to lugs 3 m aside. All are slack where the hook is at first.
HOOK = {"A": (0.0, 0.0, 12.5)}
LUGS = {"1": (-4.0, 0.0, 4.0), "2": (4.0, 0.0, 4.0), "3": (-3.0, 0.0, 4.0), "4": (3.0, 0.0, 4.0)}
SLINGS = {"A1": ("A", "1", 10.0), "A2": ("A", "2", 10.0), "B1": ("A", "3", 12.0), "B2": ("A", "4", 12.0)}
GROUND = "ground: {level: 0 m, stiffness: 200 MN/m, damping: 10 MN s/m, friction: 0.5}\n"
RESLUNG = """\
plan:
  - {step: up,      hoist: A, speed: 0.1 m/s, by: 2 m}
  - {step: look,    hold: 15 s}
  - {step: down,    lower: A, speed: 0.1 m/s, by: 2 m}
  - {step: re-sling, hold: 5 s, detach: [sling.A1, sling.A2], attach: [sling.B1, sling.B2]}
  - {step: up again, hoist: A, speed: 0.1 m/s, by: 5 m}
  - {step: end,     hold: until_end}
"""


def lift(
    hooks: Mapping[str, tuple[float, float, float]],
    lugs: Mapping[str, tuple[float, float, float]],
    slings: Mapping[str, tuple[str, str, float]],
    more: str,
    duration: float,
    *,
    axial_stiffness: float | None = EA,
    height: float = 0.0,
) -> Scenario:
    """A load at rest, on the ground at height 0; slings that stretch have dampers, so that forces settle."""
    text = hooked_lift(
        hooks,
        lugs,
        slings,
        mass=MASS,
        axial_stiffness=axial_stiffness,
        position=(0.0, 0.0, height),
        more=more,
    )
    text = text.replace("duration: 10 s", f"duration: {duration} s").replace("as_given", "rest")
    text = text.replace(" N}}\n", f" N, damping_time: {DAMPING} s}}}}\n", 1)
    if height == 0.0:
        text = text.replace("  lugs:", "  stands_on: ground\n  lugs:").replace("start: rest\n", "")
    return parse_scenario(text)


def reslung(
    method: str = "",
    axial_stiffness: float | None = EA,
    slings: Mapping[str, tuple[str, str, float]] = SLINGS,
) -> Scenario:
    return lift(HOOK, LUGS, slings, GROUND + method + RESLUNG, 130.0, axial_stiffness=axial_stiffness)


def pull(length: float, aside: float, count: int = 2, axial_stiffness: float | None = EA) -> float:
    """Tension of slings that share the weight alike [N]: n T cos a = m g, sin a = aside/(L (1 + T/EA))."""
    force = WEIGHT / count
    for _ in range(50):
        stretched = length * (1.0 + (0.0 if axial_stiffness is None else force / axial_stiffness))
        force = WEIGHT / count / math.sqrt(1.0 - (aside / stretched) ** 2)
    return force


def at(recording: Recording, rope: str, time: float) -> float:
    return float(np.interp(time, recording.time, recording.column("rope_tension", f"sling.{rope}")))


def begin_of(recording: Recording, step: str) -> float:
    (time,) = (time for time, _, name in recording.events("step_begin") if name == step)
    return time


@pytest.mark.parametrize(
    ("method", "stiffness"), [("", EA), ("", None), ("simulation: {integrator: del, step: 1 ms}\n", EA)]
)
def test_a_load_is_slung_anew_on_the_ground(method: str, stiffness: float | None) -> None:
    """Two slings carry m g/(2 cos a) each: 10 m to 4 m aside, then 12 m to 3 m aside; the others nothing."""
    recording = Simulation(reslung(method, stiffness)).run()
    change = begin_of(recording, "re-sling")
    held, hung = begin_of(recording, "down"), recording.time[-1]
    for name, length, aside, when in (("A1", 10.0, 4.0, held), ("B1", 12.0, 3.0, hung)):
        # The damper takes what still rings 15 s after the hoist has stopped.
        assert at(recording, name, when) == pytest.approx(pull(length, aside, 2, stiffness), rel=1e-4)
    for name, off in (("A1", recording.time > change), ("B1", recording.time < change)):
        assert np.abs(recording.column("rope_tension", f"sling.{name}")[off]).max() == 0.0
        # What is not there is drawn as one point.
        shown = recording["rope_point"].values[off][:, recording.points_of_ropes[f"sling.{name}"]]
        assert np.ptp(shown, axis=1).max() == 0.0
    events = [
        (time, kind, name) for time, kind, name in recording.events() if kind in ("attached", "detached")
    ]
    assert sorted(events) == [
        (change, kind, f"sling.{name}")
        for kind, names in (("attached", ("B1", "B2")), ("detached", ("A1", "A2")))
        for name in names
    ]
    assert recording.column("energy", "parting")[-1] == 0.0
    # What each method promises of the balance: the remainder of `del` is rounding.
    assert recording.metrics()["energy_remainder"] < 1e-5
    metrics = recording.metrics()
    assert metrics["attaching_time.sling.B1"] == change
    # While the load is clear every sling that is on carries; those that are not count nowhere.
    assert metrics["least_sling_tension_when_clear"] > 0.0
    checks = {one.name: one for one in check_recording(recording)}
    assert "slings_carry" not in checks
    assert checks["detached_slack"].verdict is Verdict.OK


def two_springs() -> Scenario:
    """A load hangs plumb on 10 m of rope from A; from B, 5 m higher over it, 14.9 m are put on."""
    plan = """\
plan:
  - {step: alone,   hold: 5 s}
  - {step: down,    lower: B, speed: 0.1 m/s, by: 0.2 m}
  - {step: put on,  hold: 1 s, attach: sling.B1}
  - {step: take up, hoist: B, speed: 0.02 m/s, by: 0.15 m}
  - {step: end,     hold: until_end}
"""
    hooks = {"A": (0.0, 0.0, 20.0), "B": (0.0, 0.0, 25.0)}
    slings = {"A1": ("A", "1", 10.0), "B1": ("B", "1", 14.9)}
    lugs = {"1": (0.0, 0.0, 4.0)}
    return lift(hooks, lugs, slings, plan, 60.0, height=6.0)


def test_two_slings_share_by_their_stiffness() -> None:
    """T_B = k_A k_B/(k_A + k_B) (hoisted - slack), k = EA/L; T_A = m g - T_B.

    The load hangs e_A = m g/k_A below the unstretched sling of A: from B, lowered by 0.2 m, to the lug it is
    15 m - 0.2 m + e_A. B1 of 14.9 m is 0.1 m - e_A slack there, and B goes up by 0.15 m.
    """
    scenario = two_springs()
    recording = Simulation(scenario).run()
    k_a, k_b = EA / 10.0, EA / 14.9
    slack = 14.9 - (15.0 - 0.2 + WEIGHT / k_a)
    assert 0.0 < slack < 0.15
    shared = k_a * k_b / (k_a + k_b) * (0.15 - slack)
    end = recording.time[-1]
    # As exact as hook heights and tensions are: 1e-4 m of the 0.15 m by which B goes up would be 7e-4.
    assert at(recording, "B1", end) == pytest.approx(shared, rel=1e-4)
    assert at(recording, "A1", end) == pytest.approx(WEIGHT - shared, rel=1e-4)
    put_on = begin_of(recording, "put on")
    # It goes on slack: what A carries does not change by it.
    there = (recording.time > put_on) & (recording.time < put_on + 1.0)
    carried = recording.column("rope_tension", "sling.A1")[there]
    assert np.ptp(carried) < 1e-6 * WEIGHT
    # The same at rest, without a run; and nothing of B1 before it is on.
    statics = gantline.Statics(scenario)
    assert statics.equilibrium(put_on).tension("sling.B1") == 0.0
    rest = statics.equilibrium(end)
    assert rest.tension("sling.B1") == pytest.approx(shared, rel=1e-6)
    first, last = (
        rest.recording["rope_point"].values[-1][recording.points_of_ropes["sling.B1"][i]] for i in (0, -1)
    )
    assert float(np.linalg.norm(last - first)) == pytest.approx(14.9 * (1.0 + shared / EA), rel=1e-6)


def test_a_sling_that_is_too_short_cannot_be_put_on() -> None:
    """From the hook 8.5 m over the lugs to a lug 3 m aside are sqrt(8.5^2 + 3^2) m; a sling has 9 m."""
    slings = SLINGS | {"B1": ("A", "3", 9.0)}
    simulation = Simulation(reslung(slings=slings))
    with pytest.raises(SimulationError) as caught:
        simulation.run()
    error = caught.value
    distance = math.hypot(8.5, 3.0)
    # The load stands as deep in the ground as it did at the start, less than a millimetre.
    said = f"it is to be put on here, is 9.000 m long and {distance - 9.0:.2f}"
    assert error.element == "sling.B1"
    assert error.cause.startswith(said), error.cause
    assert error.time == pytest.approx(begin_of(error.recording, "re-sling"))
    assert error.recording.attributes["status"] == "failed"
    assert error.state


@pytest.mark.parametrize("paused", [30.0, 56.0, 70.0])
def test_a_run_that_is_taken_up_again_gives_the_same_bytes(paused: float) -> None:
    """Before the change of slings, while those that are put on hang slack, and while they carry."""
    whole = Simulation(reslung())
    expected = whole.run()
    first = Simulation(reslung())
    first.run(until=paused)
    second = Simulation(reslung())
    second.restore(first.save())
    again = second.run()
    assert again.dataset.equals(expected.dataset)


def test_a_sling_comes_and_goes_and_comes_again() -> None:
    """Both slings of B hold half of the weight while they are on, the first time and the second: m g/2."""
    plan = """\
plan:
  - {step: on,     hold: 1 s, attach: [sling.B1, sling.B2]}
  - {step: up,     hoist: [A, B], speed: 0.1 m/s, by: 2 m}
  - {step: look,   hold: 20 s}
  - {step: down,   lower: [A, B], speed: 0.1 m/s, by: 2 m}
  - {step: off,    hold: 1 s, detach: [sling.B1, sling.B2]}
  - {step: away,   hoist: B, speed: 0.1 m/s, by: 1 m}
  - {step: back,   lower: B, speed: 0.1 m/s, by: 1 m}
  - {step: on again, hold: 1 s, attach: [sling.B1, sling.B2]}
  - {step: up once more, hoist: [A, B], speed: 0.1 m/s, by: 2 m}
  - {step: end,    hold: until_end}
"""
    hooks = {"A": (-4.0, 0.0, 13.5), "B": (4.0, 0.0, 13.5)}
    lugs = {"1": (-4.0, -2.0, 4.0), "2": (-4.0, 2.0, 4.0), "3": (4.0, -2.0, 4.0), "4": (4.0, 2.0, 4.0)}
    slings = {"A1": ("A", "1", 10.0), "A2": ("A", "2", 10.0), "B1": ("B", "3", 10.0), "B2": ("B", "4", 10.0)}
    recording = Simulation(lift(hooks, lugs, slings, GROUND + plan, 150.0)).run()
    force = pull(10.0, 2.0, 4)
    for when in (begin_of(recording, "down"), recording.time[-1]):
        # What is left of the swing of a load on two hooks that are plumb over their lugs.
        assert at(recording, "B1", when) == pytest.approx(force, rel=2e-3)
    kinds = [kind for _, kind, name in recording.events() if name == "sling.B1" and kind.endswith("tached")]
    assert kinds == ["attached", "detached", "attached"]
    off = (recording.time > begin_of(recording, "off")) & (recording.time < begin_of(recording, "on again"))
    assert recording.column("rope_tension", "sling.B1")[off].max() == 0.0
    assert recording.metrics()["energy_remainder"] < 1e-5


def test_slings_below_a_bar_are_put_on() -> None:
    """The bar hangs from the start; each of the two slings below it then carries half of the load, m g/2."""
    text = one_bar(0.0).replace(
        "plan:\n", "plan:\n  - {step: on, hold: 1 s, attach: [sling.down_1, sling.down_2]}\n"
    )
    recording = Simulation(parse_scenario(text)).run()
    up, down = (recording.column("rope_tension", f"sling.{name}_1") for name in ("up", "down"))
    # Two slings of 8 m, 4 m aside, hold the bar of 3 t alone: T = m g/(2 cos 30 deg); it stretches by 1e-5.
    alone = BAR * G / (2 * math.cos(math.radians(30)))
    assert up[0] == pytest.approx(alone, rel=1e-4)
    assert down[recording.time < 1.0].max() == 0.0
    # What still rings 18 s after the hoist has stopped.
    assert down[-1] == pytest.approx(LOAD * G / 2, rel=1e-3)
