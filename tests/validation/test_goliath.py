"""Lift B, a Goliath crane with three equalizers: hand figures from masses and geometry, and its incidents."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from gantline.assembly import assemble
from gantline.results import series
from gantline.results.recording import Recording
from gantline.results.variable import FloatArray
from gantline.scenario import load_scenario, parse_scenario
from gantline.simulation import Simulation
from gantline.statics import Statics
from lift_text import changed
from mechanics import G
from of_recording import step_end
from promises import PROMISES, Promise
from shown import ROOT, unsaid

FILE = Path(__file__).parents[2] / "scenarios" / "goliath" / "scenario.yaml"
HOOKS = ("goliath.U1", "goliath.U2", "goliath.L")
EQUALIZERS = {"E1": "U1", "E2": "U2", "E3": "L"}
#: Angles of the slings from plumb [deg].
ANGLES = {"U1": (6.9, 8.3, 0, 8.3, 6.9), "U2": (6.9, 8.3, 0, 8.3, 6.9), "L": (6.0, 7.2, 0, 8.3, 6.9)}
#: Masses of what hangs in a hook [kg]: 350 t of load on three hooks; frame, five moving sheaves, slings and
#: shackles of one equalizer.
SHARE = 350e3 / 3
RIGGING = 22.5e3


@pytest.fixture(scope="module")
def recording() -> Recording:
    return Simulation(load_scenario(FILE)).run()


@pytest.mark.parametrize("promise", PROMISES)
def test_what_every_scenario_promises(promise: Promise, recording: Recording, tmp_path: Path) -> None:
    """Metrics within the tolerance of their source; its balance closes; and saved, it says the same."""
    promise(ROOT / "scenarios" / "goliath", recording, tmp_path)


def end_of(recording: Recording, step: str) -> int:
    """Last sample of a step."""
    return int(np.searchsorted(recording.time, step_end(recording, step), side="right")) - 1


def during(recording: Recording, step: str, last: float) -> FloatArray:
    """Mask of the last seconds of a step."""
    end = recording.time[end_of(recording, step)]
    mask: FloatArray = (recording.time > end - last) & (recording.time <= end)
    return mask


def slings_of(recording: Recording, equalizer: str) -> FloatArray:
    """Tensions of the five slings of an equalizer, shape (time, 5) [N]."""
    group = EQUALIZERS[equalizer]
    return np.stack([recording.column("rope_tension", f"sling.{group}.{n}") for n in range(1, 6)], axis=1)


def test_the_guide_says_the_travel_that_a_run_prints(recording: Recording) -> None:
    """It said +0.40 m, which is that of the lift at rest at its end; on the way sheaves go 0.03 m further."""
    travel = recording["sheave_travel"].values[series.is_clear(recording)]
    sentence = f"here −{-travel.min():.2f} to +{travel.max():.2f} m of −1.4 to +1.9 m while the load hangs"
    assert unsaid("docs/guides/goliath.md", sentence) == []


def test_slings_ropes_and_hooks_carry_what_masses_say(recording: Recording) -> None:
    """230 kN in the slings, 139.2 t on each hook, hoist loads of 156 t and 166 t: weights by moments."""
    window = during(recording, "hold point 3", 20.0)
    vertical = SHARE / 5 * G
    for equalizer, group in EQUALIZERS.items():
        mean = slings_of(recording, equalizer)[window].mean(axis=0)
        # 6.9 deg, 8.3 deg from plumb, and plumb; shackle and half of the sling hang on the lug beside: 0.5 %
        for tension, angle in zip(mean, ANGLES[group], strict=True):
            assert tension == pytest.approx(vertical / math.cos(math.radians(angle)), rel=0.01)
        assert mean.mean() == pytest.approx(230.6e3, rel=0.01)
        rope = recording.column("rope_tension", f"{equalizer}.equalizing")[window].mean()
        # half of the sling below and of the moving sheave, 300 kg
        assert rope == pytest.approx((vertical + 300 * G) / 2, rel=0.015)
    for hook, hoist in zip(HOOKS, (156e3, 156e3, 166e3), strict=True):
        load = recording.column("hook_load", hook)[window].mean()
        assert load == pytest.approx((SHARE + RIGGING) * G, rel=0.01)
        assert recording.column("hoist_load", hook)[window].mean() == pytest.approx(hoist * G, rel=0.01)


def test_hook_loads_sum_to_weight_and_rigging(recording: Recording) -> None:
    """Masses of load, frames, sheaves, slings and shackles times g; 417.6 t by hand."""
    document = assemble(load_scenario(FILE)).document
    bodies = {body["name"]: body for body in document["bodies"]}
    hanging = set(HOOKS)
    for name, body in bodies.items():
        if body["parent"] in hanging:
            hanging.add(name)
    mass = math.fsum(bodies[name]["mass"] for name in hanging - set(HOOKS)) + bodies["block"]["mass"]
    window = during(recording, "hold point 3", 20.0)
    total = sum(recording.column("hook_load", hook)[window].mean() for hook in HOOKS)
    assert total == pytest.approx(mass * G, rel=1e-3)
    # 350 t and three times 22.5 t by hand
    assert total == pytest.approx(417.6e3 * G, rel=3e-3)


def test_equalizers_share_after_settling_and_while_hoisting(recording: Recording) -> None:
    """Slings of one equalizer pull alike upwards: 2 % after settling, 5 % while hoisting.

    After settling they carry 8 kN each and still bounce by 1 % of that: it is the mean of the last 10 s.
    """
    settled = during(recording, "settle", 10.0)
    first, last = (int(np.searchsorted(recording.time, t)) for t in bounds(recording, "hoist"))
    for equalizer in EQUALIZERS:
        tension = slings_of(recording, equalizer)
        spread = np.ptp(tension, axis=1) / tension.mean(axis=1).clip(min=1.0)
        mean = tension[settled].mean(axis=0)
        assert np.ptp(mean) < 0.02 * mean.mean()
        assert spread[first:last].max() < 0.05


def bounds(recording: Recording, step: str) -> tuple[float, float]:
    (begin,) = [time for time, _, name in recording.events("step_begin") if name == step]
    return begin, step_end(recording, step)


def test_moving_sheaves_travel_as_geometry_says(recording: Recording) -> None:
    """Sheaves end where slings of their length reach their lugs."""
    at = {
        "E1": (0.24, 0.01, -0.50, 0.01, 0.24),
        "E2": (-0.06, 0.31, -0.50, 0.31, -0.06),
        "E3": (-0.19, -0.13, -0.41, 0.40, 0.33),
    }
    window = during(recording, "settle", 1.0)
    for equalizer, travels in at.items():
        for place, travel in enumerate(travels, start=1):
            found = recording.column("sheave_travel", f"{equalizer}.{place}")[window].mean()
            # By hand to a centimetre, with rigid ropes. The hook of E3 swings, and its sheaves with it.
            near = 0.01 if equalizer != "E3" else 0.06
            assert found == pytest.approx(travel, abs=near), (equalizer, place)


def test_hooks_are_level_as_by_hand(recording: Recording) -> None:
    """Just taut and equalised: U at 40.65 m and L at 40.74 m over rails, with the load's datum at 1.5 m."""
    end = end_of(recording, "equalise")
    for hook, level in zip(HOOKS, (40.65, 40.65, 40.74), strict=True):
        assert recording.column("hook_height", hook)[end] == pytest.approx(level, rel=0.01)


def test_the_balance_closes_and_nothing_is_overloaded(recording: Recording) -> None:
    """Remainder below 1e-5; corner loads sum to all weights and the upright parts of hoist loads."""
    assert recording.metrics()["energy_remainder"] < 1e-5
    assert recording.events("overload") == []
    corners = recording["corner_load"].values
    weights = (5000e3 - 20e3) * G
    hoists = sum(
        recording.column("hoist_load", hook) * np.cos(recording.column("falls_out_of_plumb", hook))
        for hook in HOOKS
    )
    assert corners.sum(axis=1) == pytest.approx(weights + hoists, rel=1e-9)


def test_swing_after_the_traverse_is_small(recording: Recording) -> None:
    """0.03 m/s^2 on a pendulum of 25 to 50 m: an amplitude of at most 2 a/omega^2 = 2 a L/g, 0.3 m."""
    window = during(recording, "let it hang", 60.0)
    assert recording.column("load_swing", "block")[window].max() < 2 * 0.03 * 50 / G


def incident(more: str, *changes: tuple[str, str]) -> Recording:
    """The lift with a further section and changes, until a little after."""
    text = changed(FILE.read_text(encoding="utf-8"), ("duration: 1060 s", "duration: 350 s"), *changes)
    begin = text.index("cases:")
    return Simulation(parse_scenario(text[:begin] + more + text[text.index("limits:") :], str(FILE))).run()


@pytest.fixture(scope="module")
def stopped() -> Recording:
    denser = ("sample_interval: 0.1 s", "sample_interval: 20 ms")
    return incident("emergency_stop: {in_step: hoist, after: 20 s}\n", denser)


def test_an_emergency_stop_at_full_hoist_speed_runs_through(stopped: Recording) -> None:
    """Drums go on by v^2/2a; hoist loads swing by less than 2 a/g of their weight."""
    (stop,) = stopped.events("emergency_stop")
    assert stop[2] == "hoist"
    after = stopped.time > stop[0]
    speed, braking = 5 / 60, 0.2
    for hook in HOOKS:
        drum = stopped.column("joint_position", f"{hook}.drum")
        risen = drum[-1] - np.interp(stop[0], stopped.time, drum)
        # where it was at the stop is read between samples of 20 ms: a dt^2/8
        assert risen == pytest.approx(speed**2 / (2 * braking), abs=1e-5)
        load = stopped.column("hoist_load", hook)[after]
        # A sudden acceleration a of the upper end swings a load on a spring by 2 a/g of its weight at most.
        peak = load.max() / load.mean() - 1
        assert 0.01 < peak < 2 * braking / G
    assert stopped.metrics()["energy_remainder"] < 1e-5


def test_it_bounces_as_three_masses_on_three_springs(stopped: Recording) -> None:
    """Girder, hook blocks with frames, load: on girder, falls, and slings with equalizing ropes.

    By hand the girder has no mass: 1.3 Hz. With 17/35 of its mass and its trolleys it is 0.80 Hz.
    """
    sling, equalizing = 0.460 * 44**2 * 100e3 / 20, 100 * 0.460 * 46**2 * 100e3 / 31
    below = 3 / (1 / (5 * sling) + 1 / equalizing)
    falls, girder = 2 * 29.5e6 + 63e6, 60e6

    def slowest(upper: float) -> float:
        masses = np.array([upper, 44e3 + 3 * 21.5e3, 350e3])
        springs = np.array([[girder + falls, -falls, 0], [-falls, falls + below, -below], [0, -below, below]])
        root = np.sqrt(masses)
        return float(np.sqrt(np.linalg.eigvalsh(springs / np.outer(root, root))[0]) / (2 * math.pi))

    # The hand figure has two digits, and the mass of the load alone; hook blocks and frames are in it here.
    assert slowest(1.0) == pytest.approx(1.3, rel=0.05)
    (stop,) = stopped.events("emergency_stop")
    after = stopped.time > stop[0] + 1.0
    total = np.sum([stopped.column("hoist_load", hook) for hook in HOOKS], axis=0)[after]
    window = np.hanning(len(total))
    lines = np.abs(np.fft.rfft((total - total.mean()) * window, n=1 << 16))
    rate = np.fft.rfftfreq(1 << 16, float(stopped.time[1] - stopped.time[0]))[int(lines.argmax())]
    # Falls of 40 m and 33 m in place of 44 m and 34 m, masses of lines and shackles by hand: 3 %.
    assert rate == pytest.approx(slowest(17 / 35 * 2600e3 + 530e3), rel=0.03)


def test_a_sling_that_is_cut_while_hoisting_runs_through() -> None:
    """Four slings are left of five at one hook: each hangs at 5/4 of what it carried."""
    sling = "{from: E1.1, to: block.U1.1, length: 20 m"
    cut = incident("", (sling + "}", sling + ", cut_at: 320 s}"))
    ((time, _, name),) = cut.events("cut")
    assert (time, name) == (320.0, "sling.U1.1")
    # The equalizing rope runs through until the sheave without a sling meets its stop. The load falls at that
    # hook, is caught by the four slings left, and hangs in them.
    stops = [time for time, _, name in cut.events("stop_hit") if name == "E1.1"]
    assert 320.0 < stops[0] < 321.0
    peaks = [series.rope_peak(cut, f"sling.U1.{n}") for n in range(2, 6)]
    assert all(force > 3 * SHARE / 5 * G and 320.0 < at < 322.0 for force, at in peaks)
    hanging = np.mean(
        [cut.column("rope_tension", f"sling.U1.{n}")[cut.time > 340.0].mean() for n in range(2, 6)]
    )
    assert hanging == pytest.approx(SHARE / 4 * G, rel=0.03)
    overloaded = [name for time, _, name in cut.events("overload") if time > 320.0]
    assert "goliath.U1" in overloaded
    assert cut.metrics()["energy_remainder"] < 1e-5


def test_statics_finds_it_hanging_without_a_run() -> None:
    """Plan followed from rest to rest, from keel blocks on which it could slide: 228.9 kN/cos."""
    rest = Statics(load_scenario(FILE)).equilibrium(300.0)
    assert rest.is_stable
    for group in EQUALIZERS.values():
        for number, angle in enumerate(ANGLES[group], start=1):
            by_hand = SHARE / 5 * G / math.cos(math.radians(angle))
            # shackle and half of the sling hang on the lug beside: 0.5 %; the hooks are not quite level
            assert rest.tension(f"sling.{group}.{number}") == pytest.approx(by_hand, rel=0.01)


def test_losses_leave_the_residual_of_the_closed_form() -> None:
    """2 % at each of nine crossings, all slipping one way: parts of the rope are 0.98^j of the first."""
    text = FILE.read_text(encoding="utf-8")
    assert text.count("efficiency: 1.0") == 2
    lossy = text[: text.index("cases:")] + text[text.index("limits:") :]
    lift = parse_scenario(lossy.replace("efficiency: 1.0", "efficiency: 0.98"), str(FILE))
    rest = Statics(lift).equilibrium(300.0, losses="forward")
    parts = 0.98 ** np.arange(9, -1, -1)
    pairs = parts[::2] + parts[1::2]
    assert pairs[::-1] / pairs.mean() == pytest.approx([1.0824, 1.0395, 0.9984, 0.9588, 0.9209], abs=1e-4)
    slings = {sling.name: sling for sling in rest.recording.rig.slings}
    for group in EQUALIZERS.values():
        names = [f"{group}.{number}" for number in range(1, 6)]
        upright = [
            rest.tension(f"sling.{name}")
            * math.cos(float(series.sling_angle(rest.recording, slings[name])[-1]))
            for name in names
        ]
        # Two parts carry a sling with its moving sheave, 300 kg, and half of the sling, 90 kg: 0.1 %.
        carried = np.array(upright) + 300 * G
        assert carried / carried.mean() == pytest.approx(pairs / pairs.mean(), rel=1e-3)


def test_what_the_lower_hook_bears_of_a_ship_block_that_is_turned() -> None:
    """By moments about the lugs that stay (a cos + b sin)/(l cos + h sin) of the 450 t of the ship block.

    It bears nothing from where the centre of gravity is plumb below these, tan = a/-b.
    """
    a, b, length, height = 12.9, -0.5, 23.4, 6.4
    shares = [
        450
        * (a * math.cos(turned) + b * math.sin(turned))
        / (length * math.cos(turned) + height * math.sin(turned))
        for turned in np.radians([0.0, 30.0, 60.0])
    ]
    alone = math.degrees(math.atan2(a, -b))
    said = (
        f"these are {shares[0]:.0f} t level, {shares[1]:.0f} t at 30° and {shares[2]:.0f} t at 60°; "
        f"the two others bear all of it from {alone:.1f}° on"
    )
    assert [round(share) for share in shares] == [248, 209, 157]
    assert unsaid("docs/guides/goliath.md", said) == []
