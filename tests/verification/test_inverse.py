"""Lengths of slings and places of hooks with which a load hangs as wanted, against closed forms."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from extension_lifts import DEEP, PAIRED
from gantline.results import series
from gantline.results.rotation import axes
from gantline.scenario import Scenario, load_scenario, parse_scenario
from gantline.scenario.file.variants import with_value
from gantline.statics import Equilibrium, Statics
from gantline.study import CannotBeError, adjust_lengths, plumb_hooks
from hooked_lift import TWO_HOOKS_LUGS, hooked_lift, two_hooks
from lift_text import spoiled
from mechanics import Floats, G
from plumb_lift import AXIAL_STIFFNESS, LENGTH, WEIGHT, plumb_lift

REFERENCE = Path(__file__).resolve().parents[2] / "scenarios" / "equalizer"
LOAD = "block"  # as the reference lift calls it
OFFSET = (0.3, -0.2)
HOOK = (0.0, 0.0, 20.0)
#: Three lugs at one level, and where the load hangs about, on slings of some 10 m.
LUGS = {"1": (4.0, 0.0, 4.0), "2": (-3.0, 2.5, 4.0), "3": (-3.0, -2.5, 4.0)}


def bridle(
    axial_stiffness: float | None, lengths: tuple[float, float, float] = (10.8, 10.8, 10.8)
) -> Scenario:
    slings = {f"S{lug}": ("hook", lug, length) for lug, length in zip(LUGS, lengths, strict=True)}
    text = hooked_lift(
        {"hook": HOOK}, LUGS, slings,
        centre=(*OFFSET, 2.0), axial_stiffness=axial_stiffness, position=(0.0, 0.0, 6.1),
    )  # fmt: skip
    return parse_scenario(text)


def attitude(rest: Equilibrium, load: str = "load") -> Floats:
    """The axes of a load, in the columns."""
    found: Floats = axes(rest.recording.column("body_orientation", load)[-1])
    return found


@pytest.mark.parametrize("axial_stiffness", [None, 50e6])
def test_level_under_one_hook(axial_stiffness: float | None) -> None:
    """Level under one hook: L = √(|lug − centre of gravity|² + h²)/(1 + T/EA) for one depth h of all lugs."""
    answer = adjust_lengths(bridle(axial_stiffness), slopes=(0.0, 0.0))
    assert answer.residual < 1e-9
    assert attitude(answer.after)[:, 2] == pytest.approx([0, 0, 1], abs=2e-9)
    stretched = np.array(
        [
            length
            * (1 + (answer.after.tension(f"sling.{sling}") / axial_stiffness if axial_stiffness else 0.0))
            for sling, length in answer.lengths.items()
        ]
    )
    aside = np.array([math.dist(at[:2], OFFSET) for at in LUGS.values()])
    depth = np.sqrt(stretched**2 - aside**2)
    # Slopes of 1e-9 over 7 m between the lugs.
    assert depth == pytest.approx([depth.mean()] * 3, abs=1e-8)
    # The plumb line of the hook goes through the centre of gravity.
    assert answer.after.recording.column("body_position", "load")[-1, :2] == pytest.approx([0, 0], abs=1e-7)
    if axial_stiffness is None:
        # Of all depths that with the least change, Σ (L − L₀)² → Σ (L − L₀) dL/dh = 0 with dL/dh = h/L;
        # exact to the changes of the last step.
        change = np.array([answer.lengths[one] - answer.given[one] for one in answer.lengths])
        assert float(change @ (depth / stretched)) == pytest.approx(0.0, abs=1e-6)
        assert np.linalg.norm(change) > 0.1


def test_a_wanted_list_and_heading() -> None:
    """Slopes of the load's own axes and its heading under two hooks, as asked for to 1e-9."""
    answer = adjust_lengths(parse_scenario(two_hooks()), slopes=(0.02, -0.01), heading=0.05)
    own = attitude(answer.after)
    assert math.asin(own[2, 0]) == pytest.approx(0.02, abs=1e-9)
    assert math.asin(own[2, 1]) == pytest.approx(-0.01, abs=1e-9)
    assert math.atan2(own[1, 0], own[0, 0]) == pytest.approx(0.05, abs=1e-9)


def test_wanted_shares_of_four_plumb_slings() -> None:
    """Equal shares of four plumb slings, one short by δ: the least change is ± δ/4 of each."""
    short = 0.02
    text = plumb_lift("").replace(
        "SA: {from: A, to: girder.A}", f"SA: {{from: A, to: girder.A, length: {LENGTH - short} m}}"
    )
    text = text.replace("cases:\n", "").replace("duration: 10 s", "duration: 10 s\nstart: as_given")
    answer = adjust_lengths(parse_scenario(text), shares=dict.fromkeys(("SA", "SB", "SC", "SD"), 0.25))
    # The centre of gravity is level with the lugs, so nothing acts on what a slope of 1 mrad makes of shares.
    assert answer.residual < 2e-9
    # What the load's motions do not take up is the pattern (1, −1, 1, −1).
    change = np.array([answer.lengths[f"S{one}"] - answer.given[f"S{one}"] for one in "ABCD"])
    assert change == pytest.approx(np.array([1, -1, 1, -1]) * short / 4, rel=1e-6)
    for one in "ABCD":
        pulls = answer.after.tension(f"sling.S{one}") * math.cos(
            series.sling_angle(answer.after.recording, answer.after.recording.rig.slings["ABCD".index(one)])[
                -1
            ]
        )
        assert pulls == pytest.approx(WEIGHT / 4, rel=1e-8)
    assert answer.before.tension("sling.SA") > WEIGHT / 4 + 0.2 * AXIAL_STIFFNESS / LENGTH * short


def test_shares_below_a_spreader_are_of_the_load_and_above_it_of_what_hangs_in_the_hook() -> None:
    """NW takes 26 % of what the module weighs, with the shackles on it, and T1 then 49 % of that and the bar:
    not of the sum of both tiers, which is twice the load.
    """

    def vertical(rest: Equilibrium, name: str) -> float:
        top, bottom = (one[-1] for one in series.rope_ends(rest.recording, f"sling.{name}"))
        along = (top - bottom) / np.linalg.norm(top - bottom)
        return rest.tension(f"sling.{name}") * float(along[2])

    spreader = REFERENCE.parent / "spreader_bar"
    answer = adjust_lengths(spreader, shares={"NW": 0.26, "T1": 0.49})
    again = Statics(answer.scenario).equilibrium()
    masses = {
        one["name"]: one["mass"] for one in Statics(load_scenario(spreader)).assembly.document["bodies"]
    }
    module = G * masses["module"]
    # Residuals of 1e-9, shares and forces of the equilibrium.
    assert vertical(again, "NW") == pytest.approx(0.26 * module, rel=1e-7)
    assert vertical(again, "T1") == pytest.approx(0.49 * (module + G * masses["bar"]), rel=1e-7)


@pytest.mark.parametrize(("name", "lift"), [("S1x", PAIRED), ("S2", DEEP)])
def test_slings_over_extension_sheaves_have_no_share(name: str, lift: str) -> None:
    """Said in a sentence; it was an error of Python."""
    with pytest.raises(CannotBeError, match=rf"^{name} has no share: .* runs over an extension sheave$"):
        adjust_lengths(parse_scenario(lift), shares={name: 0.4})


def test_two_hooks_come_over_their_lugs() -> None:
    """Tandem lift on two slings: without side pull each hook is over its lug, wherever that hangs then."""
    lugs = {"1": (-4.0, 0.0, 4.0), "2": (4.0, 0.0, 4.0)}
    text = hooked_lift(
        {"A": (-4.5, 0.3, 20.0), "B": (4.2, -0.4, 20.0)}, lugs,
        {"S1": ("A", "1", 10.0), "S2": ("B", "2", 10.0)},
        centre=(0.5, 0.0, 2.0), position=(0.0, 0.0, 6.1),
    )  # fmt: skip
    answer = plumb_hooks(parse_scenario(text))
    recording = answer.after.recording
    own = attitude(answer.after)
    centre = recording.column("body_position", "load")[-1]
    for hook, lug in (("A", "1"), ("B", "2")):
        at = centre + own @ (np.array(lugs[lug]) - (0.5, 0.0, 2.0))
        # 1e-9 of the vertical force over slings of 10 m.
        assert answer.places[hook] == pytest.approx(at[:2], abs=2e-8)
        assert np.abs(answer.side_pulls[hook][1]).max() < 1e-9 * 200e3 * G
    # The least of all shifts that do it leaves the middle of both hooks where it was.
    moved = np.array([np.subtract(answer.places[hook], answer.given[hook]) for hook in "AB"])
    assert moved.sum(axis=0) == pytest.approx([0, 0], abs=1e-7)


def standing(hook: tuple[float, float]) -> Scenario:
    """A load with its centre of gravity at OFFSET that stands under one hook, which lifts it in 20 s."""
    slings = {f"S{lug}": ("hook", lug, 10.9) for lug in LUGS}
    moves = "hoist: hook, speed: 0.1 m/s, acceleration: 0.1 m/s^2, start_at: 0 s, brake_from: 8 s"
    plan = f"plan:\n  - {{step: up, {moves}}}"
    text = hooked_lift({"hook": (*hook, 14.0)}, LUGS, slings, centre=(*OFFSET, 2.0), more=f"{plan}\n")
    return parse_scenario(
        text.replace(
            "start: as_given", "ground: {level: 0 m, friction: 0.5, stiffness: 200 MN/m, damping: 2 MN s/m}"
        ).replace("  lugs:", "  stands_on: ground\n  lugs:")
    )


def test_one_hook_comes_over_the_centre_of_gravity() -> None:
    """A standing load comes off without drift where the hook is over its centre of gravity."""
    answer = plumb_hooks(standing((0.1, 0.4)))
    assert answer.places["hook"] == pytest.approx(OFFSET, abs=1e-7)
    assert answer.drift is not None
    # The hook was off by that.
    assert answer.drift == pytest.approx((math.dist((0.1, 0.4), OFFSET), 0.0), abs=1e-7)


def test_the_reference_lift_with_its_centre_of_gravity_aside() -> None:
    """Centre of gravity 100 mm along x: moving the hook by what the load drifts takes the drift away."""
    off = with_value(load_scenario(REFERENCE), "load.centre_of_gravity.at.x", "0.1 m")
    answer = plumb_hooks(off)
    assert answer.drift is not None
    # The frame's heading, which nothing holds, comes to rest a little otherwise under another hook.
    assert math.hypot(*answer.places["test_hook"]) == pytest.approx(answer.drift[0], rel=1e-4)
    assert answer.drift[1] < 1e-7
    # Solved once more, without derivatives.
    again = Statics(answer.scenario).equilibrium().recording.column("body_position", LOAD)
    assert again[-1, :2] == pytest.approx(again[0, :2], abs=1e-7)


def test_an_ideal_equalizer_cannot_be_levelled() -> None:
    """Lengths under one equalizer do not turn the load back: refused with the reason."""
    off = with_value(load_scenario(REFERENCE), "load.centre_of_gravity.at.x", "0.1 m")
    with pytest.raises(
        CannotBeError, match=r"under e1 slings pull alike whatever their lengths: move the centre"
    ):
        adjust_lengths(off, slopes=(0.0, 0.0))


def test_what_cannot_be_is_said() -> None:
    """Too far, contradictory, standing, no slings: each in a sentence."""
    two = parse_scenario(two_hooks())
    with pytest.raises(
        CannotBeError, match=r"^too far: S\d would be \d+ mm (longer|shorter), and may be 20 mm$"
    ):
        adjust_lengths(two, slopes=(0.0, 0.0), most=0.02)
    with pytest.raises(CannotBeError, match="lengths of slings cannot do all of what is wanted at once"):
        adjust_lengths(two, slopes=(0.0, 0.0), shares={"S1": 0.25, "S2": 0.6})
    with pytest.raises(CannotBeError, match=r"^load does not hang clear at 0 s, it still stands$"):
        plumb_hooks(standing((0.0, 0.0)), time=0.0)
    with pytest.raises(CannotBeError, match="only a lift with a load on slings"):
        plumb_hooks(load_scenario(REFERENCE.parent / "pulleys"), time=0.0)


def test_slings_with_nodes_are_refused() -> None:
    """Slings whose weight is distributed have no sensitivities here: a sentence, whatever is asked."""
    kind = "kind: {axial_stiffness: 200e6 N, mass: 8 kg/m, diameter: 44 mm}"
    text = two_hooks().replace("kind: {axial_stiffness: 200000000.0 N}", kind)
    text = text.replace(
        "sling_defaults: {rope: kind}", "sling_defaults: {rope: kind, rope_weight: distributed}"
    )
    scenario = parse_scenario(text)
    sentence = r"no sensitivities to these quantities \(S1, S2, S3, S4 with distributed weight\)$"
    with pytest.raises(CannotBeError, match=sentence):
        adjust_lengths(scenario, slopes=(0.0, 0.0))
    with pytest.raises(CannotBeError, match=sentence):
        plumb_hooks(scenario)


def test_what_is_not_there_is_named() -> None:
    """Names of slings and hooks, and a question without a wish."""
    two = parse_scenario(two_hooks())
    with pytest.raises(ValueError, match="'S9' is not a sling; known here"):
        adjust_lengths(two, slopes=(0.0, 0.0), slings=["S9"])
    with pytest.raises(ValueError, match="nothing is wanted of the load"):
        adjust_lengths(two)
    with pytest.raises(ValueError, match="'C' is not a hook in which slings hang"):
        plumb_hooks(two, hooks=["C"])


def test_a_slack_sling_is_no_answer() -> None:
    """A fourth sling that hangs slack: level by two of the other three is refused, or cannot be."""
    lengths = zip(TWO_HOOKS_LUGS, (12.0, 12.0, 12.0, 12.6), strict=True)
    text = hooked_lift(
        {"hook": (0.0, 0.0, 22.0)}, TWO_HOOKS_LUGS,
        {f"S{lug}": ("hook", lug, length) for lug, length in lengths},
        centre=(-0.5, 0.3, 2.0), position=(0.0, 0.0, 7.0),
    )  # fmt: skip
    with pytest.raises(CannotBeError, match=r"^hung so S4 would be slack$"):
        adjust_lengths(parse_scenario(text), slopes=(0.0, 0.0), slings=["S1", "S2"])
    two = two_hooks().replace("to: load.4, length: 12.2 m", "to: load.4, length: 14 m")
    with pytest.raises(CannotBeError, match=r"cannot do all of what is wanted at once; slack: S1, S4$"):
        adjust_lengths(parse_scenario(two), slopes=(0.0, 0.0))


def test_travel_beyond_its_limit_is_no_answer() -> None:
    """An equalizer whose sheave would have to travel beyond its stroke."""
    text = (REFERENCE / "scenario.yaml").read_text(encoding="utf-8")
    text = spoiled("travel: {up: 1.4 m, down: 1.9 m", "travel: {up: 1.2 m, down: 1.7 m", text)
    with pytest.raises(CannotBeError, match=r"^hung so e1\.\d would travel 1\.\d+ m up, and has 1\.2 m$"):
        adjust_lengths(parse_scenario(text), slopes=(0.0, 0.0))
