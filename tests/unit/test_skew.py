"""Skew load factors: forces with perfect lengths, against closed forms."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gantline.checks import values_of
from gantline.checks.forces import sling_forces
from gantline.overrides import SettingError
from gantline.results import series
from gantline.results.loads.skew import largest_skew, perfect_forces, skew_loads
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import Simulation
from lift_text import BASE, MECHANICS
from sample_lift import ALONG, HOOK, LENGTHS, LUGS, sample_recording, sample_rig

Array = npt.NDArray[np.float64]
HEIGHT = HOOK - 8.65 - 5.0
COSINE = np.array([HEIGHT / math.hypot(x - a, y, HEIGHT) for a, (x, y) in zip(ALONG, LUGS, strict=True)])
#: The sample's lugs let opposite corners carry more and the others less: no force, no moment in all.
PATTERN = np.array([1.0, -1.0, 0.0, -1.0, 1.0])


def at_rest(tension: Array, rig: dict[str, Any] | None = None, **given: Any) -> Recording:
    return sample_recording(np.zeros(1), tension=tension[None, :], rig=rig or sample_rig(), **given)


def locked_rig() -> dict[str, Any]:
    rig = sample_rig()
    rig["equalizers"][0]["locked"] = [f"e1.{place}" for place in range(1, 6)]
    for rope in rig["ropes"][1:]:
        rope["axial_stiffness"] = 200e6
    return rig


def test_an_ideal_equalizer_has_no_skew() -> None:
    """Every moving sheave bears 600 kN upright, so slings that slant carry more."""
    found = skew_loads(at_rest(600e3 / COSINE))
    assert [skew.factor for skew in found] == pytest.approx([1.0] * len(LUGS), abs=1e-12)
    assert not any(skew.lengths_decide for skew in found)


def test_losses_of_sheaves_are_skew() -> None:
    """Nine crossings at 2 % loss, all slipping one way: 1.082 to 0.921 of the mean."""
    crossing = 0.98 ** -np.arange(10.0)  # tension of each part of the equalizing rope, of the last one
    share = crossing[:-1:2] + crossing[1::2]
    share = share / share.mean()
    factors = [skew.factor for skew in skew_loads(at_rest(600e3 * share / COSINE))]
    assert factors == pytest.approx(share, rel=1e-12)
    assert sorted(share, reverse=True) == pytest.approx([1.082, 1.040, 0.998, 0.959, 0.921], abs=6e-4)


def test_locked_sheaves_let_lengths_decide() -> None:
    """Forces of perfect lengths are those of a rigid load that moves: k cos(angle) (a + b x + c y)."""
    x, y = np.array(LUGS).T
    stiffness = 200e6 / np.array(LENGTHS)
    perfect = stiffness * COSINE * (0.07 + 0.002 * x + 0.001 * y)
    uneven = perfect + 40e3 * PATTERN / COSINE
    skews = skew_loads(at_rest(uneven, locked_rig()))
    assert [skew.perfect for skew in skews] == pytest.approx(perfect, rel=1e-9)
    assert all(skew.lengths_decide for skew in skews)
    assert largest_skew(at_rest(uneven, locked_rig())) == pytest.approx((uneven / perfect).max(), rel=1e-9)


def test_a_force_that_holds_its_own_skew_is_not_multiplied() -> None:
    """The rule's factor is on the force with perfect lengths; the larger of both counts."""
    x, y = np.array(LUGS).T
    perfect = 200e6 / np.array(LENGTHS) * COSINE * (0.07 + 0.002 * x + 0.001 * y)
    uneven = perfect + 300e3 * PATTERN / COSINE
    rig = locked_rig()
    rig["factors"] = {"skew_load_factor": {"value": 1.25, "source": "rule"}}
    used = values_of(at_rest(uneven, rig), "lug_load_of_capacity")
    assert uneven[0] > 1.25 * perfect[0] and uneven[1] < 1.25 * perfect[1]
    expected = np.maximum(uneven, 1.25 * perfect) / (80e3 * 9.81)
    assert [used[f"block.L{place}"] for place in range(1, 6)] == pytest.approx(expected, rel=1e-9)


def test_a_formula_says_what_is_raised_to_the_design_weight() -> None:
    """300 t simulated, 315 t designed for: both the force and that with perfect lengths times 1.05."""
    x, y = np.array(LUGS).T
    perfect = 200e6 / np.array(LENGTHS) * COSINE * (0.07 + 0.002 * x + 0.001 * y)
    rig = locked_rig()
    rig["loads"][0] |= {"simulated_mass": 300e3, "design_mass": 315e3}
    rig["factors"] = {"skew_load_factor": {"value": 1.25, "source": "rule"}}
    recording = at_rest(perfect, rig)
    force = sling_forces(recording, series.everywhere(recording))["S1"]
    assert force.static == pytest.approx(1.05 * 1.25 * perfect[0], rel=1e-9)
    plain = f"{perfect[0] / 1e3:.1f} kN"
    design = "x 1.05 to the design weight"
    assert force.static_text == f"max(static {plain} {design}, {plain} with perfect lengths {design} x 1.25)"


def test_pins_that_have_been_pulled_hold_no_longer() -> None:
    events = [(0.0, "pin_pulled", f"e1.{place}") for place in range(1, 6)]
    skews = skew_loads(at_rest(600e3 / COSINE, locked_rig(), events=events))
    assert [skew.lengths_decide for skew in skews] == [False] * 5
    events.append((0.0, "pin_put_in", "e1.3"))
    skews = skew_loads(at_rest(600e3 / COSINE, locked_rig(), events=events))
    assert [skew.lengths_decide for skew in skews] == [True] * 5


def test_what_lengths_decide_needs_stiffness() -> None:
    rig = locked_rig()
    del rig["ropes"][3]["axial_stiffness"]
    skews = skew_loads(at_rest(600e3 / COSINE, rig))
    assert {(skew.factor, skew.reason) for skew in skews} == {
        (None, "axial stiffness of its slings not known")
    }
    assert largest_skew(at_rest(600e3 / COSINE, rig)) is None


def test_a_sling_that_would_be_slack_has_no_factor() -> None:
    x = np.array(LUGS)[:, 0]
    perfect = 200e6 / np.array(LENGTHS) * COSINE * 0.02 * (2.5 - x)  # nothing at x = 2.5 m
    found = skew_loads(at_rest(perfect, locked_rig()))
    assert [skew.factor is None for skew in found] == [False, True, False, False, True]
    assert found[1].reason == "with perfect lengths it would be slack"


def test_slings_that_lie_down_have_none() -> None:
    recording = at_rest(600e3 / COSINE, load_z=np.array([HOOK]))
    assert {skew.reason for skew in skew_loads(recording)} == {"its slings do not hang"}


def directions(angles: list[float], spread: list[float]) -> Array:
    """Unit vectors of slings at these headings, this far from the vertical; shape (3, n)."""
    heading, aside = np.array(angles), np.array(spread)
    return np.stack([np.sin(aside) * np.cos(heading), np.sin(aside) * np.sin(heading), np.cos(aside)])


@pytest.mark.parametrize("short", [0.0, 0.25, 0.9])
def test_four_slings_of_which_one_is_short(short: float) -> None:
    """Equal slings at 90 deg of each other: diagonals share as 1 + x, 1 - x; perfect is the mean."""
    gradient = directions([0.0, math.pi / 2, math.pi, 1.5 * math.pi], [0.3] * 4)
    perfect = np.full(4, 1e6)
    pattern = np.array([1.0, -1.0, 1.0, -1.0])
    found = perfect_forces(gradient, np.full(4, 5e7), perfect * (1.0 + short * pattern))
    assert found == pytest.approx(perfect, rel=1e-12)


@settings(max_examples=200)
@given(
    headings=st.lists(st.floats(0.0, 2 * math.pi, allow_subnormal=False), min_size=4, max_size=8),
    aside=st.floats(0.1, 1.0),
    stiffness=st.floats(0.2, 5.0),
    seed=st.integers(0, 2**32 - 1),
)
def test_perfect_forces_keep_their_sum_and_are_the_softest(
    headings: list[float], aside: float, stiffness: float, seed: int
) -> None:
    """Same force on the hook, and no other forces that do the same have less elastic energy."""
    random = np.random.default_rng(seed)
    count = len(headings)
    gradient = directions(headings, list(aside * random.uniform(0.5, 1.0, count)))
    singular = np.linalg.svd(gradient, compute_uv=False)
    if singular[-1] < 0.02 * singular[0]:  # slings nearly in one plane: near what counts as no lever
        return
    k = np.where(random.uniform(size=count) < 0.5, stiffness, 1.0) * 1e7
    tension = random.uniform(1e5, 1e6, count)
    perfect = perfect_forces(gradient, k, tension)
    assert gradient @ perfect == pytest.approx(gradient @ tension, rel=1e-8, abs=1e-3)
    *_, kernel = np.linalg.svd(gradient)
    for free in kernel[3:]:
        assert float(free @ (perfect / k)) == pytest.approx(0.0, abs=1e-9 * float(np.abs(perfect / k).sum()))


def pins_of(simulation: Simulation) -> dict[str, bool | None]:
    """Whether the pin of each moving sheave is in at the start; None without one."""
    joints = {body["name"]: body["joint"] for body in simulation.assembly.document["bodies"]}
    return {sheave: joints[sheave]["pin"] for sheave in ("e1.1", "e1.2")}


def test_a_lift_with_all_its_equalizers_locked() -> None:
    adaptive = BASE.replace("integrator: del, step: 1 ms", "integrator: adaptive")
    simulation = Simulation(parse_scenario(adaptive), equalizers="locked")
    assert simulation.assembly.rig["equalizers"][0]["locked"] == ["e1.1", "e1.2"]
    assert pins_of(simulation) == {"e1.1": True, "e1.2": True}
    with pytest.raises(SettingError, match="equalizers: 'free' is none; 'locked' pins all moving sheaves"):
        Simulation(parse_scenario(adaptive), equalizers="free")
    with pytest.raises(SettingError, match="no equalizer of this lift has moving sheaves to lock"):
        Simulation(parse_scenario(MECHANICS), equalizers="locked")


def test_equalizers_that_are_locked_stay_so_whatever_the_plan_does_to_pins() -> None:
    """By the plan sheave 2 is pinned, let go and sheave 1 pinned; locked, no step touches a pin."""
    lift = BASE.replace("integrator: del, step: 1 ms", "integrator: adaptive")
    lift = lift.replace("travel: {up: 1 m", "travel: {locked: [2], up: 1 m")
    lift = lift.replace("hold: until_end}", "hold: until_end, pull_pins: e1.2, put_in_pins: e1.1}")
    scenario = parse_scenario(lift)
    free, locked = Simulation(scenario), Simulation(scenario, equalizers="locked")
    assert pins_of(free) == {"e1.1": False, "e1.2": True}
    assert [step.get("pulls") for step in free.assembly.document["plan"]][-1] == ["e1.2"]
    assert pins_of(locked) == {"e1.1": True, "e1.2": True}
    assert all(not {"pulls", "pins"} & set(step) for step in locked.assembly.document["plan"])
    assert scenario.plan[-1].pull_pins == ("e1.2",)  # the lift itself is as it was


def test_an_inextensible_rope_cannot_be_locked_as_well() -> None:
    lift = BASE.replace("integrator: del, step: 1 ms", "integrator: adaptive")
    rigid = lift.replace(
        "thick: {axial_stiffness: 100 MN, damping_time: 2 ms}", "thick: {inextensible: true}"
    )
    with pytest.raises(SettingError, match="equalizers: the rope of 'e1' is inextensible, and pins in all"):
        Simulation(parse_scenario(rigid), equalizers="locked")


def test_a_sling_over_an_extension_sheave_shares_with_none() -> None:
    """The other four share by length under the locked equalizer, so does all that follows one of them."""
    rig = locked_rig()
    rig["slings"][4]["over"] = "e1.5"
    *four, over = skew_loads(at_rest(600e3 / COSINE, rig))
    assert [skew.sling for skew in four] == ["S1", "S2", "S3", "S4"]
    assert all(skew.lengths_decide and skew.perfect is not None for skew in four)
    assert (over.sling, over.perfect, over.lengths_decide) == ("S5", None, True)
    assert over.reason == "it follows the sling that its extension sheave hangs on"
    assert over.force == pytest.approx(600e3 / COSINE[4])
    rig["equalizers"][0]["locked"] = []
    assert [skew.lengths_decide for skew in skew_loads(at_rest(600e3 / COSINE, rig))] == [False] * 5


def test_how_slings_share_is_not_known_with_extension_sheaves_below() -> None:
    rig = locked_rig()
    rig["slings"][1].update(to_load=None, to_lug=None, lugs=[None])
    skews = skew_loads(at_rest(600e3 / COSINE, rig))
    assert {skew.reason for skew in skews} == {"how they share depends on extension sheaves below them"}
    assert all(skew.perfect is None and skew.lengths_decide for skew in skews)
    rig["equalizers"][0]["locked"] = []  # sheaves that move share alike, whatever hangs below
    assert [skew.factor for skew in skew_loads(at_rest(600e3 / COSINE, rig))] == pytest.approx([1.0] * 5)
