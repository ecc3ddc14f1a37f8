"""Spreaders: loads on bars and frames under slings, against equations of their own.

In the plane of a bar, with lugs at (±a, c) above its middle and (±a, -c) below it, the load (weight W, lugs
at (±a, h) from its centre of gravity less an offset e) and the bar (weight B) are each in balance by two
forces and a moment. With places of bar and load and the turns of both as unknowns, six equations; the slings
give T = EA max(0, ℓ/L - 1).

Across the bar hook, lugs above, lugs below, lugs of the load and centre of gravity are a chain of pendulums.
With the angles θ of the sling planes, φ of the bar, ψ of the lower slings and χ of the load from plumb,

    y_bar = H θ + c φ,   y_load = H θ + 2 c φ + ℓ ψ + h χ,
    2 V = (B + W)(H θ² + c φ²) + W (c φ² + ℓ ψ² + h χ²).

Four plumb slings of stiffness k at the corners of a rigid load have one way to share that no force and no
moment needs, (1, -1, -1, 1): one that is longer by δ bears k δ/4 less, and so does the one across.
"""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import numpy.typing as npt
import pytest
from scipy.linalg import eigh
from scipy.optimize import fsolve
from scipy.spatial.transform import Rotation

from gantline.results.loads.skew import skew_loads
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from gantline.statics import Statics
from mechanics import G
from spreader_lifts import BAR, LOAD, frame, one_bar, two_below_one, two_hooks

Floats = npt.NDArray[np.float64]
Triple = tuple[float, float, float]

EA = 100e6
W, B = LOAD * G, BAR * G
A, C, H_LUGS = 4.0, 0.2, 1.5
UPPER, LOWER = 8.0, 6.0


def turned(place: Floats, at: tuple[float, float]) -> Floats:
    """Where a point of a body at (x, z, turn) is."""
    x, z, turn = place
    cosine, sine = math.cos(turn), math.sin(turn)
    return np.array([x + cosine * at[0] - sine * at[1], z + sine * at[0] + cosine * at[1]])


def balance(places: Floats, tops: list[Floats], offset: float) -> tuple[Floats, list[float]]:
    """What is missing from balance of bar and load, and the tensions of the upper and lower slings."""
    bar, load = places[:3], places[3:]
    above, below = [(-A, C), (A, C)], [(-A, -C), (A, -C)]
    lugs = [(-A - offset, H_LUGS), (A - offset, H_LUGS)]
    missing = np.array([0.0, -B, 0.0, 0.0, -W, 0.0])
    tensions = []

    def pull(first: int, place: Floats, at: Floats, force: Floats) -> None:
        arm = at - place[:2]
        missing[first : first + 3] += [*force, arm[0] * force[1] - arm[1] * force[0]]

    for top, at in zip(tops, above, strict=True):
        end = turned(bar, at)
        length = float(np.linalg.norm(top - end))
        tensions.append(EA * max(0.0, length / UPPER - 1.0))
        pull(0, bar, end, tensions[-1] * (top - end) / length)
    for at, lug in zip(below, lugs, strict=True):
        upper, lower = turned(bar, at), turned(load, lug)
        length = float(np.linalg.norm(upper - lower))
        tensions.append(EA * max(0.0, length / LOWER - 1.0))
        force = tensions[-1] * (upper - lower) / length
        pull(0, bar, upper, -force)
        pull(3, load, lower, force)
    return missing, tensions


def at_rest(offset: float) -> tuple[Floats, list[float]]:
    """Places of bar and load, the hook at the origin, and tensions."""
    down = math.sqrt(UPPER**2 - A**2) + C
    start = np.array([0.0, -down - 0.01, 0.0, offset, -down - C - LOWER - H_LUGS - 0.02, 0.0])
    hook = [np.zeros(2)] * 2
    found = fsolve(lambda places: balance(places, hook, offset)[0], start, xtol=1e-13)
    missing, tensions = balance(found, hook, offset)
    assert np.abs(missing).max() < 1e-6 * W
    return found, tensions


@pytest.mark.parametrize("offset", [0.0, 0.3, -0.8])
def test_a_bar_at_rest(offset: float) -> None:
    """Tensions and turns of bar and load are those of the six equations, wherever the centre of gravity is.

    1e-7: both are solved to many more digits; `fsolve` leaves up to 1e-9 of W.
    """
    rest = Statics(parse_scenario(one_bar(offset))).equilibrium()
    places, wanted = at_rest(offset)
    found = [rest.tension(f"sling.{name}") for name in ("up_1", "up_2", "down_1", "down_2")]
    assert found == pytest.approx(wanted, rel=1e-7)
    for body, turn in (("bar", places[2]), ("module", places[5])):
        w, x, y, z = rest.recording.column("body_orientation", body)[-1]
        # About y, downwards at its end along x positive: the other way than the angle in the x-z plane.
        assert 2.0 * math.atan2(y, w) == pytest.approx(-turn, abs=1e-7)
        assert [x, z] == pytest.approx([0.0, 0.0], abs=1e-7)


def test_a_load_in_the_middle_by_hand() -> None:
    """Level: T cos α = (W + B)/2 above and W/2 below; α from the stretched length."""
    rest = Statics(parse_scenario(one_bar(0.0))).equilibrium()
    upper = rest.tension("sling.up_1")
    cosine = math.sqrt(1.0 - (A / (UPPER * (1.0 + upper / EA))) ** 2)
    assert upper * cosine == pytest.approx((W + B) / 2, rel=1e-9)
    assert rest.tension("sling.down_1") == pytest.approx(W / 2, rel=1e-9)


def test_periods_across_a_bar() -> None:
    """A chain of four pendulums; slings that stretch do not matter across, to the first order.

    1e-5: the periods of the statics are by differences of forces over small motions.
    """
    rest = Statics(parse_scenario(one_bar(0.0)))
    rest.equilibrium()
    places, (_, _, lower, _) = at_rest(0.0)
    high, low = -places[1] - C, LOWER * (1.0 + lower / EA)
    bar, load = np.array([high, C, 0.0, 0.0]), np.array([high, 2 * C, low, H_LUGS])
    inertia = np.diag([0.0, BAR * (0.4**2 + 0.4**2) / 12, 0.0, LOAD * (6.0**2 + 3.0**2) / 12])
    mass = BAR * np.outer(bar, bar) + LOAD * np.outer(load, load) + inertia
    stiffness = np.diag([(B + W) * high, B * C + W * 2 * C, W * low, W * H_LUGS])
    wanted = 2.0 * math.pi / np.sqrt(eigh(stiffness, mass, eigvals_only=True))
    found = np.array([mode.period for mode in rest.modes() if mode.period is not None])
    for period in wanted:
        assert np.abs(found / period - 1.0).min() < 1e-5


def test_the_start() -> None:
    """Slings below hang slack over a load that stands; those above hold the bars, to each its share.

    `as_given` takes the start as it is put together: 1e-6 of the weight of the lightest bar.
    """
    text = two_below_one().replace("duration: 60 s", "duration: 0.1 s\nstart: as_given")
    recording = simulate(parse_scenario(text))
    tension = {
        name: recording.column("rope_tension", f"sling.{name}")[0] for name in ("up_1", "mid_1", "down_1")
    }
    assert tension["mid_1"] == pytest.approx(1e3 * G, abs=1e-2)
    length = UPPER * (1.0 + tension["up_1"] / EA)
    cosine = math.sqrt(1.0 - (A / length) ** 2)
    assert tension["up_1"] * cosine == pytest.approx((BAR + 2e3) / 2 * G, abs=1e-2)
    assert tension["down_1"] == 0.0


def test_bars_below_a_bar() -> None:
    """Lugs in pairs across the load bear half of what their bar does: nothing depends on lengths."""
    recording = Statics(parse_scenario(two_below_one())).equilibrium().recording
    skews = {one.sling: one for one in skew_loads(recording)}
    assert all(
        one.factor == pytest.approx(1.0, abs=1e-9) and not one.lengths_decide for one in skews.values()
    )
    for side, pair in ((1, ("down_1", "down_2")), (2, ("down_3", "down_4"))):
        # The slings above and below the bar across stand alike to 1e-4.
        held = skews[f"mid_{side}"].force - 1e3 * G
        assert [skews[name].force for name in pair] == pytest.approx([held / 2] * 2, rel=1e-4)


def test_a_bar_between_two_hooks() -> None:
    """By moments about its ends, plumb slings: W (1/2 ± e/2a) below, half of the bar's weight more above.

    1e-3 of W: 0.3 m of offset tilt the load by 0.1 deg, since both slings of a side stretch.
    """
    rest = Statics(parse_scenario(two_hooks())).equilibrium()
    for side, sign in ((1, -1.0), (2, 1.0)):
        wanted = W * (0.5 + sign * 0.3 / (2 * A))
        assert rest.tension(f"sling.down_{side}") == pytest.approx(wanted, abs=1e-3 * W)
        assert rest.tension(f"sling.up_{side}") == pytest.approx(wanted + B / 2, abs=1e-3 * W)


def test_a_frame_with_a_sling_that_is_longer() -> None:
    """k δ/4 from one sling to the next; perfect lengths would share alike.

    2e-3: k of the longer sling is 1/600 less, and the load leans to it by δ/4 over the way between its lugs.
    """
    longer = 0.01
    recording = Statics(parse_scenario(frame(longer))).equilibrium().recording
    skews = {one.sling: one for one in skew_loads(recording)}
    change = EA / LOWER * longer / 4
    for place, sign in ((1, -1.0), (2, 1.0), (3, 1.0), (4, -1.0)):
        below, above = skews[f"down_{place}"], skews[f"up_{place}"]
        assert below.lengths_decide and above.lengths_decide
        assert below.force - W / 4 == pytest.approx(sign * change, abs=2e-3 * W / 4)
        assert below.perfect == pytest.approx(W / 4, rel=2e-3)
        assert above.perfect == pytest.approx(above.force, rel=1e-4)


SCENARIO = Path(__file__).parents[2] / "scenarios" / "spreader_bar" / "scenario.yaml"


def test_the_scenario() -> None:
    """Two bodies in space on six slings, with shackles and weights of ropes: twelve equations.

    1e-6 of the tensions; `fsolve` leaves less than 1e-9 of the weight.
    """
    rest = Statics(SCENARIO).equilibrium()
    stiffness = {one.name: one.axial_stiffness or 0.0 for one in rest.recording.rig.ropes}
    mass = {one.name: one.mass for one in rest.recording.rig.ropes}
    assert mass["sling.T1"] == pytest.approx(0.409e-2 * 44**2 * 9.0, rel=1e-9)  # EN 12385-4: 6x36 IWRC
    hook, bar, module = Body(0.0, (0, 0, 0)), Body(2600.0, (0, 0, 0)), Body(45e3, (0.15, 0.05, 1.6))
    pulls = [
        ("T1", 9.0, hook, (0, 0, 0), bar, (-4.5, 0, 0.25)),
        ("T2", 9.0, hook, (0, 0, 0), bar, (4.5, 0, 0.25)),
        ("NW", 5.0, bar, (-4.5, 0, -0.25), module, (-4.5, 1.5, 3.5)),
        ("SW", 5.0, bar, (-4.5, 0, -0.25), module, (-4.5, -1.5, 3.5)),
        ("NE", 5.0, bar, (4.5, 0, -0.25), module, (4.5, 1.5, 3.5)),
        ("SE", 5.0, bar, (4.5, 0, -0.25), module, (4.5, -1.5, 3.5)),
    ]
    for name, _, above, top, below, lug in pulls:  # a shackle of 21 kg and half of the sling at both ends
        above.lumps.append((21.0 + mass[f"sling.{name}"] / 2, np.array(top)))
        below.lumps.append((21.0 + mass[f"sling.{name}"] / 2, np.array(lug)))
    tension: dict[str, float] = {}

    def missing(unknown: Floats) -> Floats:
        bar.put(unknown[:6])
        module.put(unknown[6:])
        for name, length, above, top, below, lug in pulls:
            way = above.at(top) - below.at(lug)
            size = float(np.linalg.norm(way))
            tension[name] = stiffness[f"sling.{name}"] * max(0.0, size / length - 1.0)
            below.pull(lug, tension[name] * way / size)
            above.pull(top, -tension[name] * way / size)
        return np.concatenate([bar.missing, module.missing])

    start = np.array([0.0, 0.0, -8.1, 0.0, 0.0, 0.0, 0.0, 0.0, -16.7, 0.0, 0.0, 0.0])
    assert np.abs(missing(fsolve(missing, start, xtol=1e-13))).max() < 1e-3
    assert {name: rest.tension(f"sling.{name}") for name in tension} == pytest.approx(tension, rel=1e-6)


class Body:
    """A mass with lumps, put somewhere; forces and moments on it are added up from its weight on."""

    def __init__(self, mass: float, centre: Triple) -> None:
        self.lumps = [(mass, np.array(centre))]
        self.missing = np.zeros(6)
        self.place, self.turn = np.zeros(3), np.eye(3)

    def put(self, pose: Floats) -> None:
        self.place, self.turn = pose[:3], Rotation.from_rotvec(pose[3:]).as_matrix()
        self.missing = np.zeros(6)
        for mass, at in self.lumps:
            self.pull(at, np.array([0.0, 0.0, -mass * G]))

    def at(self, point: Floats | Triple) -> Floats:
        found: Floats = self.place + self.turn @ np.asarray(point)
        return found

    def pull(self, point: Floats | Triple, force: Floats) -> None:
        self.missing += np.concatenate([force, np.cross(self.turn @ np.asarray(point), force)])
