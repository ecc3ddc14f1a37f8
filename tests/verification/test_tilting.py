"""What keeps a hanging load upright, and how far it is from letting go, against closed forms."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from gantline.scenario import Scenario, load_scenario, parse_scenario
from gantline.scenario.file.variants import with_value
from gantline.statics import Statics
from gantline.study import Tilting, margins_of, tilting_of
from hooked_lift import hooked_lift
from mechanics import G
from plumb_lift import AXIAL_STIFFNESS, LENGTH, TRIANGLE, WEIGHT, plumb_lift

REFERENCE = load_scenario(Path(__file__).resolve().parents[2] / "scenarios" / "equalizer")
TEXT = REFERENCE.text
LOAD = "block"  # as the lift file calls it


def tilting(scenario: Scenario) -> Tilting:
    question = Statics(scenario)
    (found,) = tilting_of(question, question.equilibrium(), question.modes())
    return found


def plain(text: str) -> str:
    """A lift file of `plumb_lift` without cases."""
    return text.replace("cases:\n", "")


def under(height: float) -> Scenario:
    """300 t on four plumb slings, the centre of gravity so far below its lugs [m]."""
    at = f"at: [0 m, 0 m, {2.5 - height} m], envelope"
    return parse_scenario(plain(plumb_lift("")).replace("at: [0 m, 0 m, 2.5 m], envelope", at))


@pytest.mark.parametrize("depth", [0.0, 1.5])
def test_four_plumb_slings(depth: float) -> None:
    """Four plumb slings of stiffness k: moment over tilt is k Σ y² + W h, the first of it the rig's."""
    found = tilting(under(depth))
    stiffness = AXIAL_STIFFNESS / LENGTH * 4 * 2.5**2
    # Slings that are longer by their strain of 0.37 % bring a moment of W (y² + x²)/2L too: 1e-3 of it.
    assert found.soft.stiffness == pytest.approx(stiffness + WEIGHT * depth, rel=2e-3)
    assert found.stiff.stiffness == pytest.approx(found.soft.stiffness, rel=1e-9)
    assert found.soft.rig == pytest.approx(stiffness / WEIGHT, rel=2e-3)
    assert found.depth == pytest.approx(depth, abs=1e-9)
    assert found.loose is None


def test_slings_straight_to_one_hook() -> None:
    """Three slings that do not stretch hold load and hook as one body: it tilts as if hung from the hook."""
    lugs = {"1": (4.0, 0.0, 4.0), "2": (-2.0, 3.0, 4.0), "3": (-2.0, -3.0, 4.0)}
    slings = {f"S{lug}": ("hook", lug, math.hypot(*at[:2], 10.0)) for lug, at in lugs.items()}
    scenario = parse_scenario(
        hooked_lift({"hook": (0, 0, 20.0)}, lugs, slings, axial_stiffness=None, position=(0, 0, 6.0))
    )
    found = tilting(scenario)
    # Its centre of gravity is 12 m below the hook, and 2 m below its lugs.
    assert found.soft.height == pytest.approx(12.0, rel=1e-6)
    assert found.soft.rig == pytest.approx(10.0, rel=1e-6)
    assert found.tilt_per_metre == pytest.approx((1 / 12.0, 1 / 12.0), rel=1e-6)
    # A pendulum of 200 t, a box of 10 × 6 × 4 m, about its stiffer side: T = 2π √((I + m H²)/(m g H)).
    inertia = 200e3 / 12 * (6.0**2 + 4.0**2)
    period = 2 * math.pi * math.sqrt((inertia + 200e3 * 12.0**2) / (200e3 * G * 12.0))
    other = 2 * math.pi * math.sqrt((200e3 / 12 * (10.0**2 + 4.0**2) + 200e3 * 12.0**2) / (200e3 * G * 12.0))
    assert found.period is not None
    assert min(abs(found.period / one - 1) for one in (period, other)) < 1e-6


def test_three_slings_that_do_not_stretch_are_rigid() -> None:
    """On three plumb slings that do not stretch no moment tilts a load."""
    found = tilting(parse_scenario(plain(plumb_lift("", lugs=TRIANGLE, rope="{inextensible: true}"))))
    # But for what statics leaves of a length that cannot change, 1e-9 of 3 cm.
    assert found.soft.height > 1e6


def test_the_reference_lift_by_hand() -> None:
    """Lift A: tan θ = e/h, 2.29° for 100 mm at h = 2.5 m, and 5.2 s; five crossed slings take 0.2 m away."""
    found = tilting(REFERENCE)
    assert found.depth == pytest.approx(2.5, abs=1e-9)
    assert abs(found.soft.rig) < 0.1 * found.depth
    assert found.stiff.rig == pytest.approx(0.0, abs=0.01)
    assert found.period_on_lugs == pytest.approx(5.2, abs=0.03)
    assert found.period == pytest.approx(4.0, abs=0.05)
    hung = "tan(tilt) = e/2.50 m with plumb slings, 2.29 deg for 100 mm of centre of gravity"
    assert str(found.loose) == f"the slings of e1 give {LOAD} no tilt stiffness: {hung}"
    # What the sensitivities say of 100 mm, the lift solved anew says too, but for tan and its argument.
    for axis, per_metre in zip("xy", found.tilt_per_metre, strict=True):
        moved = Statics(with_value(REFERENCE, f"load.centre_of_gravity.at.{axis}", "1 mm")).equilibrium()
        tilt = float(moved.recording.column("load_tilt", LOAD)[-1])
        assert tilt == pytest.approx(1e-3 * per_metre, rel=1e-5)


def test_a_centre_of_gravity_above_the_lugs() -> None:
    """With its centre of gravity above the middle of its lugs a load has a negative stiffness."""
    tall = TEXT.replace("box: [10 m, 10 m, 5 m]", "box: [10 m, 10 m, 9 m]")
    found = tilting(parse_scenario(tall.replace("at: [0 m, 0 m, 2.5 m]\n", "at: [0 m, 0 m, 6 m]\n")))
    assert found.depth == pytest.approx(-1.0, abs=1e-9)
    assert found.soft.stiffness < 0.0
    assert found.period_on_lugs is None
    assert str(found.loose).endswith("and its centre of gravity is not below the middle of its lugs")


def test_margins_of_four_plumb_slings() -> None:
    """Aside until slings are slack: W/4 (1 ∓ e/y) of a pair is none where e = y, over the other lugs."""
    found = {margin.direction: margin for margin in margins_of(under(0.0), Statics(under(0.0)).equilibrium())}
    assert found["+x"].cause in ("SB, SC slack", "SC, SB slack")
    # The strain of the loaded side, 0.7 %, turns the load, which stands on its lugs' level.
    assert found["+x"].distance == pytest.approx(2.5, rel=0.01)
    assert found["−y"].distance == pytest.approx(2.5, rel=0.01)
    assert found["up"].cause == "nothing; further on it is outside the load"


def test_margins_of_the_reference_lift() -> None:
    """Aside until tan θ = e/h is at its limit; up until h, less what crossed slings take away, is gone."""
    rest = Statics(REFERENCE).equilibrium()
    found = {margin.direction: margin for margin in margins_of(REFERENCE, rest)}
    measured = tilting(REFERENCE)
    assert found["up"].cause == "unstable"
    assert found["up"].distance == pytest.approx(measured.soft.height, abs=2e-3)
    for way, per_metre in zip("xy", measured.tilt_per_metre, strict=True):
        for sign in "+−":
            margin = found[f"{sign}{way}"]
            assert margin.cause == "tilt beyond its limit of 2.00 deg"
            assert margin.distance == pytest.approx(math.radians(2.0) / per_metre, rel=0.02)


def test_a_margin_that_is_used_up() -> None:
    """A lift that tilts beyond its limit as it is has none left."""
    off = with_value(REFERENCE, "load.centre_of_gravity.at.x", "0.1 m")
    margins = margins_of(off, Statics(off).equilibrium())
    assert {margin.distance for margin in margins} == {0.0}


def equalizers(places: dict[str, tuple[float, float]]) -> Scenario:
    """A load under several equalizers as that of the reference lift, two slings each."""
    start = TEXT.index("  e1:\n")
    end = TEXT.index("\nslings:")
    frame = TEXT[start:end].rstrip()
    frame = frame.replace("[-2.4 m, -0.8 m, 0.8 m, 2.4 m]", "[0 m]").replace(
        "along: [-3.6 m, 3.6 m]", "along: [-1.2 m, 1.2 m]"
    )
    frame = frame.replace("[-3.2 m, -1.6 m, 0 m, 1.6 m, 3.2 m]", "[-0.8 m, 0.8 m]")
    lugs, slings = {}, {}
    for name, (x, y) in places.items():
        for number, along in enumerate((-0.8, 0.8), start=1):
            lugs[f"{name}.{number}"] = (x + along, y, 4.0)
            slings[f"{name}.{number}"] = (f"E{name}.{number}", f"{name}.{number}", 10.0)
    text = hooked_lift(
        {name: (x, y, 25.0) for name, (x, y) in places.items()}, lugs, slings,
        box=(30.0, 10.0, 4.0), position=(0.0, 0.0, 2.4),
        more="equalizers:\n" + "\n".join(
            frame.replace("  e1:", f"  E{name}:").replace("test_hook", name) for name in places
        ) + "\n",
    )  # fmt: skip
    text = text.replace("ropes: {kind", "ropes: {equalizing: {axial_stiffness: 100 MN}, kind")
    return parse_scenario(text)


def test_equalizers_in_one_line() -> None:
    """Equalizers in one line leave the load free to tilt about it, three that are not do not."""
    line = equalizers({"A": (-8.0, -2.0), "B": (0.0, 0.0), "C": (8.0, 2.0)})
    found = tilting(line)
    assert found.loose is not None and found.loose.line is not None
    assert found.loose.line == pytest.approx(np.array([4.0, 1.0]) / math.hypot(4, 1), abs=1e-9)
    assert found.loose.depth == pytest.approx(2.0)
    # About the line its own weight alone, h = 2 m.
    assert found.soft.direction == pytest.approx(found.loose.line, abs=1e-3)
    assert found.soft.height == pytest.approx(2.0, abs=0.02)
    assert found.stiff.rig > 100.0
    corner = equalizers({"A": (-8.0, -3.0), "B": (-8.0, 3.0), "C": (8.0, 0.0)})
    assert tilting(corner).loose is None
    assert tilting(corner).soft.rig > 50.0
    # Pins turn the frames into rigid ones.
    locked = parse_scenario(line.text.replace("locked: false", "locked: true"))
    assert tilting(locked).loose is None
