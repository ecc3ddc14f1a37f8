"""A load that is lost at once: vessels without it, their swing and the areas below their righting arms."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq

from afloat import BREADTH, DEPTH, KG, LENGTH, MASS, barge, lift_of, written
from floating import SEA
from gantline.hydro import Righting, box_hull
from gantline.simulation import simulate
from gantline.statics import NoEquilibriumError, Statics
from gantline.statics.inclining import metacentric_heights
from gantline.study import LostLoad, lose_load
from mechanics import G

#: Load, its own height and that from which it hangs, by a rope of this length [kg, m].
LOAD, HEIGHT, ABOVE, ROPE = 400e3, 4.0, 60.0, 30.0
#: Slope of the work of righting that a search for the equilibrium leaves, over a metre of arm.
FOUND = 1e-8


def hung(vessel: dict[str, Any], at: tuple[float, float], **changes: Any) -> dict[str, Any]:
    """The barge with the load below a place of its own, (x, y) over its stern and centre plane [m]."""
    bottom = ABOVE - ROPE - HEIGHT - 4.0  # the barge floats at about 4 m
    given = lift_of(
        vessel,
        ropes={"falls": {"axial_stiffness": "4000 MN", "damping_time": "20 ms"}},
        load={
            "name": "module",
            "shape": {"box": ["8 m", "8 m", f"{HEIGHT} m"]},
            "datum": "bottom_centre",
            "position": [f"{at[0]} m", f"{at[1]} m", f"{bottom} m"],
            "weight": {"calculated": f"{LOAD} kg", "contingency": 1.0, "simulate": "calculated"},
            "centre_of_gravity": {"at": ["0 m", "0 m", f"{HEIGHT / 2} m"]},
        },
        mechanics={
            "ropes": {
                "falls": {
                    "rope": "falls",
                    "length": f"{ROPE} m",
                    "route": [
                        {"type": "end", "body": "barge", "at": [f"{at[0]} m", f"{at[1]} m", f"{ABOVE} m"]},
                        {"type": "end", "body": "module", "at": ["0 m", "0 m", f"{HEIGHT} m"]},
                    ],
                }
            }
        },
    )
    return {**given, **changes}


def lost(folder: Path, given: dict[str, Any]) -> tuple[Statics, LostLoad]:
    question = Statics(written(folder, given))
    return question, lose_load(question, question.equilibrium(), "module")


def balanced(offset: float, **changes: Any) -> dict[str, Any]:
    """The barge with 500 t that low aside of its centre plane, to port positive [m]."""
    masses = barge()["masses"] | {
        "ballast": {"mass": "500 t", "at": [f"{LENGTH / 2} m", f"{offset} m", "2 m"]}
    }
    return barge(masses=masses, **changes)


def test_areas_of_a_box_with_counter_ballast(tmp_path: Path) -> None:
    """While the deck of a box is dry and its bottom wet, the section of the water turns about its middle:

    GZ = sin φ (GM + BM tan²φ/2) + y_G cos φ, whose integral is GM (1 − cos φ) + BM (1/cos φ + cos φ − 2)/2 +
    y_G sin φ, and a point at (y, z) goes under where tan φ = (z − T)/−y. Everything is known of it without
    the load; with the load the ballast holds it half.
    """
    vessel = balanced(-14.0, openings={"vent": [f"{LENGTH / 2} m", "-14 m", "7 m"]})
    question, found = lost(tmp_path, hung(vessel, (LENGTH / 2, 35.0)))
    (swing,) = found.swings
    mass = MASS + 500e3
    draft = mass / (SEA * LENGTH * BREADTH)
    bm = BREADTH**2 / (12 * draft)
    gm = draft / 2 + bm - (MASS * KG + 500e3 * 2.0) / mass
    aside = 500e3 * -14.0 / mass

    def arm(angle: float) -> float:
        return math.sin(angle) * (gm + bm * math.tan(angle) ** 2 / 2) + aside * math.cos(angle)

    def work(angle: float) -> float:
        straight = gm * (1 - math.cos(angle)) + aside * math.sin(angle)
        return straight + bm * (1 / math.cos(angle) + math.cos(angle) - 2) / 2

    assert swing.away == pytest.approx(-math.pi / 2), "the load hangs to port"
    after = brentq(arm, 0.0, 0.2, xtol=1e-14)
    # The height of the centre of gravity is found by derivatives of an equilibrium that is right to 1e-9 of
    # forces, and GM is what is left of heights some times as large.
    assert swing.after == pytest.approx(after, rel=1e-7)
    question.equilibrium()
    heel = float(question.equilibrium().recording.column("vessel_heel", "barge")[-1])
    assert swing.before == pytest.approx(heel, abs=1e-12) and heel < -0.01
    assert swing.flooding == pytest.approx(math.atan((7.0 - draft) / 14.0), rel=1e-7)
    assert swing.end == swing.flooding
    assert swing.left == pytest.approx(work(heel) - work(after), rel=1e-6)
    assert swing.taken == pytest.approx(work(swing.flooding) - work(after), rel=1e-6)
    assert swing.ratio == pytest.approx(swing.taken / swing.left)
    farthest = brentq(lambda angle: work(angle) - work(heel), after, 0.25, xtol=1e-14)
    assert swing.farthest == pytest.approx(farthest, rel=1e-7)
    lowest = (7.0 - draft) * math.cos(farthest) - 14.0 * math.sin(farthest)
    assert swing.freeboard == pytest.approx(lowest, rel=1e-6)
    dry = np.abs(swing.angles) < math.atan((DEPTH - draft) / (BREADTH / 2))
    expected = [arm(angle) for angle in swing.angles[dry]]
    assert dry.sum() > 20 and swing.arms[dry] == pytest.approx(expected, abs=1e-6)


@pytest.mark.parametrize("at", [(95.0, 22.0), (8.0, -30.0), (50.0, -40.0), (120.0, 0.0)])
def test_swings_any_way(tmp_path: Path, at: tuple[float, float]) -> None:
    """What weighs on the barge without the load is known, and so are the arms of its box about any axis."""
    _, found = lost(tmp_path, hung(barge(), at))
    (swing,) = found.swings
    # Away from the load, and more along the barge than that, since it is stiffer there.
    across, along = -at[1], -(at[0] - LENGTH / 2)
    assert math.copysign(1.0, math.sin(swing.away)) == math.copysign(1.0, across) or across == 0.0
    assert math.copysign(1.0, math.cos(swing.away)) == math.copysign(1.0, along) or along == 0.0
    ahead = swing.away + math.pi / 2  # the axis of the swing, the way it heels to starboard
    turn = np.array(
        [
            [math.cos(ahead), math.sin(ahead), 0.0],
            [-math.sin(ahead), math.cos(ahead), 0.0],
            [0.0, 0.0, 1.0],
        ]
    )
    box = box_hull([LENGTH, BREADTH, DEPTH])
    hull = type(box)("box", box.mesh[0] @ turn.T, box.mesh[1])
    righting = Righting(hull, MASS, turn @ [LENGTH / 2, 0.0, KG], density=SEA)
    expected = [righting.at(float(angle)) for angle in swing.angles]
    # About a level axis the height of the centre of gravity is found from how the barge yields, 1e-7 of GM.
    assert swing.arms == pytest.approx([there.arm for there in expected], abs=2e-6)
    assert swing.after == pytest.approx(0.0, abs=FOUND)
    first, rest = righting.at(swing.before), righting.at(swing.after)
    assert swing.left == pytest.approx(first.work - rest.work, rel=1e-6)


def test_rest_without_the_load(tmp_path: Path) -> None:
    """It rests as the lift does whose file has no load and no falls, and rights itself as much there."""
    vessel = balanced(-6.0)
    _, found = lost(tmp_path, hung(vessel, (90.0, 10.0)))
    bare = Statics(written(tmp_path, lift_of(vessel)))
    rest = bare.equilibrium()
    for name in ("draft_aft", "draft_forward", "heel", "trim", "displacement", "freeboard"):
        here, there = (one.recording.column(f"vessel_{name}", "barge")[-1] for one in (found.rest, rest))
        assert here == pytest.approx(there, rel=FOUND)
    assert found.heights["barge"].yielding == pytest.approx(
        metacentric_heights(bare, rest)["barge"].yielding, rel=1e-6, abs=1e-9
    )
    assert found.rest.recording.column("rope_tension", "falls")[-1] == 0.0


def test_the_lift_has_its_load_again(tmp_path: Path) -> None:
    """Losing a load changes nothing of what is asked afterwards of the lift itself."""
    path = written(tmp_path, hung(barge(), (90.0, 10.0)))
    question = Statics(path)
    before = question.equilibrium()
    question.lose("module")
    again = question.equilibrium()
    for name in before.recording:
        first, second = before.recording[name].values, again.recording[name].values
        assert first.tobytes() == second.tobytes() if first.dtype.kind == "f" else list(first) == list(second)


def test_free_surfaces_raise_the_centre_of_gravity(tmp_path: Path) -> None:
    """GM is less by i/V, the second moment of a tank's surface over what the barge displaces; so are arms."""
    length, breadth, content = 20.0, 10.0, 800e3
    depth = content / (SEA * length * breadth)
    tank = {"box": ["20 m", "10 m", "7 m"], "bottom": ["50 m", "0 m", "0 m"], "content": f"{content} kg"}
    _, found = lost(tmp_path, hung(barge(tanks={"middle": tank}), (LENGTH / 2, 15.0)))
    (swing,) = found.swings
    mass = MASS + content
    kg = (MASS * KG + content * depth / 2) / mass + length * breadth**3 / 12 * SEA / mass
    righting = Righting(box_hull([LENGTH, BREADTH, DEPTH]), mass, [LENGTH / 2, 0.0, kg], density=SEA)
    assert swing.left == pytest.approx(righting.at(swing.before).work - righting.at(0.0).work, rel=1e-6)


def test_the_swing_of_a_simulation(tmp_path: Path) -> None:
    """Undamped roll turns where all that the load has left is in the arms. Heave, 0.13 m either way, changes
    arms and takes a part: within 0.2 %.
    """
    given = hung(barge(), (LENGTH / 2, 20.0), duration="20 s")
    _, found = lost(tmp_path, given)
    (swing,) = found.swings
    given["mechanics"]["ropes"]["falls"]["cut_at"] = "1 s"
    run = simulate(written(tmp_path, given), duration=20.0, sample_interval=0.05)
    heel = run.column("vessel_heel", "barge")
    assert heel[0] == pytest.approx(swing.before, abs=1e-6)
    assert swing.farthest is not None
    assert heel.max() == pytest.approx(swing.farthest, rel=2e-3)


def test_a_vessel_that_does_not_come_back(tmp_path: Path) -> None:
    """With as much ballast as the load needs, and an opening low on that side, it swings past the opening."""
    vessel = balanced(-14.0, openings={"hatch": [f"{LENGTH / 2} m", "-15 m", "5.2 m"]})
    _, found = lost(tmp_path, hung(vessel, (LENGTH / 2, 35.0)))
    (swing,) = found.swings
    assert swing.flooding is not None and swing.farthest is not None
    assert swing.after < swing.flooding < swing.farthest
    assert swing.taken < swing.left and not swing.is_held and not found.is_sound


def test_a_vessel_that_capsizes_without_its_load(tmp_path: Path) -> None:
    """4000 t of ballast 14 m aside, held by a load on the other side, have no rest without it."""
    masses = barge()["masses"] | {"ballast": {"mass": "4000 t", "at": [f"{LENGTH / 2} m", "-14 m", "14 m"]}}
    question = Statics(written(tmp_path, hung(barge(masses=masses, draft="5 m"), (LENGTH / 2, 140.0))))
    rest = question.equilibrium()
    with pytest.raises(NoEquilibriumError, match="capsizes"):
        lose_load(question, rest, "module")


def test_openings_under_water_with_the_load_on(tmp_path: Path) -> None:
    """400 t at y = 20 m heel the barge to port; a hatch there is under before the load is lost.

    Of a box at rest at the draft T amidships, heeled by φ, a point (y, z) is under where z < T + y tan φ,
    z up from its keel and y to port.
    """
    port = barge(openings={"hatch": ["50 m", "14 m", "4.5 m"], "vent": ["50 m", "-14 m", "7 m"]})
    question, found = lost(tmp_path, hung(port, (LENGTH / 2, 20.0)))
    before = question.equilibrium().recording
    heel, draft = (float(before.column(name, "barge")[-1]) for name in ("vessel_heel", "vessel_draft"))
    assert draft + 14.0 * math.tan(heel) < 4.5 < draft - 14.0 * math.tan(heel) < 5.0
    assert found.under_with_load == {"barge": ["hatch"]} and found.flooded == {"barge": ["hatch"]}
    assert not found.is_sound and all(swing.is_held for swing in found.swings)
    # A higher one is dry there.
    dry = barge(openings={"hatch": [f"{LENGTH / 2} m", "14 m", "5 m"]})
    _, found = lost(tmp_path, hung(dry, (LENGTH / 2, 20.0)))
    assert found.under_with_load == {} and found.is_sound


def resting(aside: float, shorter: float, **more: Any) -> dict[str, Any]:
    """The load stands 4 m over the water, `aside` of the centre plane, its rope shorter than its way [m]."""
    given = hung(barge(), (LENGTH / 2, aside), **more)
    given["load"]["position"][2] = "4 m"
    straight = ABOVE - 4.0 - HEIGHT - 4.0
    # The place of its end counts from the load's centre of gravity.
    given["mechanics"]["ropes"]["falls"]["length"] = f"{straight - HEIGHT / 2 - shorter!r} m"
    return given


CONTACT = {"stiffness": "40000 MN/m", "damping": "400 MN s/m", "friction": 0.3}


def test_of_a_load_that_stands_ashore_its_share_is_lost(tmp_path: Path) -> None:
    """A vessel heels by what its rope bears, and not by the load's weight; without that it is upright.

    What is left in it is the work of its arms between the two.
    """
    given = resting(24.0, 0.6, ground={"level": "4 m", **CONTACT})
    question = Statics(written(tmp_path, given))
    rest = question.equilibrium()
    transferred = float(rest.recording.column("load_transferred", "module")[-1])
    assert 0.2 < transferred < 0.8
    found = lose_load(question, rest, "module")
    assert not found.stands and found.is_sound
    (swing,) = found.swings
    assert swing.after == pytest.approx(0.0, abs=1e-6)
    righting = Righting(box_hull([LENGTH, BREADTH, DEPTH]), MASS, [LENGTH / 2, 0.0, KG], density=SEA)
    pull = float(rest.recording.column("rope_tension", "falls")[-1])
    assert pull == pytest.approx(transferred * LOAD * G, rel=1e-3)
    assert swing.left == pytest.approx(righting.at(-swing.before).work - righting.at(0.0).work, rel=1e-6)


@pytest.mark.parametrize("shorter", [0.01, -0.1])
def test_a_load_that_rests_aboard_is_not_lost(tmp_path: Path, shorter: float) -> None:
    """Its slings let it go onto the deck: a vessel without it is not what comes of that."""
    given = resting(5.0, shorter)
    given["mechanics"]["body_contacts"] = {"on_deck": {"between": ["module", "barge"], **CONTACT}}
    question = Statics(written(tmp_path, given))
    rest = question.equilibrium(losses="held")
    words = r"at 1 s barge bears \d\S* % of 'module', which stays aboard where its slings let it go; --time"
    with pytest.raises(ValueError, match=words):
        lose_load(question, rest, "module")
