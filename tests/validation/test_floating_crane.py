"""Lift C, a floating crane that lifts 1000 t off a quay: hand figures, equilibrium, and its incidents."""

from __future__ import annotations

import math
import re
from pathlib import Path
from time import perf_counter

import numpy as np
import pytest
from scipy.optimize import fsolve

from gantline.assembly import assemble
from gantline.checks import check_recording
from gantline.plot.moments import stages as stages_of
from gantline.plot.views import stages
from gantline.results.recording import Recording
from gantline.results.variable import FloatArray
from gantline.scenario import Scenario, load_scenario, parse_scenario
from gantline.scenario.afloat.mooring import line_weight
from gantline.simulation import Simulation, SimulationError
from gantline.statics import Equilibrium, Statics
from gantline.statics.inclining import metacentric_heights
from lift_text import changed, without
from mechanics import G
from of_recording import step_end
from promises import PROMISES, Promise
from shown import ROOT

FILE = Path(__file__).parents[2] / "scenarios" / "floating_crane" / "scenario.yaml"
HOOKS = ("H1", "H2", "H3", "H4")
#: Angles of the slings of each equalizer from plumb [deg]: 3.2 m in 24.2 m, 1.6 m in 24.0 m.
ANGLES = (7.6, 3.8, 0.0, 3.8, 7.6)
#: Mass of the load [kg], and of frame, five moving sheaves, equalizing rope, slings and shackles of one hook.
LOAD, RIGGING = 1000e3, 24.0e3
#: Length and breadth of the hull, head of the boom at 60 deg in the axes of the vessel [m].
LENGTH, BREADTH, HEAD = 105.6, 46.0, (153.0, 104.26)
SEA = 1025.0


def read(text: str) -> Scenario:
    return parse_scenario(text, str(FILE))


TEXT = FILE.read_text(encoding="utf-8")
PLAIN = without(TEXT, "cases")


@pytest.fixture(scope="module")
def recording() -> Recording:
    begun = perf_counter()
    found = Simulation(load_scenario(FILE)).run()
    took = perf_counter() - begun
    print(f"{found.time[-1]:.0f} s in {took:.1f} s, {found.time[-1] / took:.0f} times real time")
    return found


@pytest.mark.parametrize("promise", PROMISES)
def test_what_every_scenario_promises(promise: Promise, recording: Recording, tmp_path: Path) -> None:
    """Metrics within the tolerance of their source; its balance closes; and saved, it says the same."""
    promise(ROOT / "scenarios" / "floating_crane", recording, tmp_path)


@pytest.fixture(scope="module")
def held() -> tuple[Statics, Equilibrium]:
    """The lift at rest when the load has just come clear."""
    question = Statics(read(PLAIN))
    return question, question.equilibrium(1110.0)


@pytest.fixture(scope="module")
def alone() -> tuple[Statics, Equilibrium]:
    """Vessel and crane without load, rigging and moorings."""
    nothing = without(
        PLAIN,
        *("plan", "watch", "mooring_lines", "load", "supports", "sling_defaults", "slings"),
        *("equalizers", "equalizer_types"),
    )
    question = Statics(read(nothing))
    return question, question.equilibrium()


def vessel(recording: Recording, name: str, sample: int = -1) -> float:
    return float(recording.column(f"vessel_{name}", "barge")[sample])


def end_of(recording: Recording, step: str) -> int:
    """Last sample of a step."""
    return int(np.searchsorted(recording.time, step_end(recording, step), side="right")) - 1


def slings_of(recording: Recording, hook: str) -> FloatArray:
    """Tensions of the five slings under a hook, shape (time, 5) [N]."""
    return np.stack([recording.column("rope_tension", f"sling.{hook}.{n}") for n in range(1, 6)], axis=1)


def spread(tension: FloatArray) -> FloatArray:
    found: FloatArray = np.ptp(tension, axis=1) / tension.mean(axis=1).clip(min=1.0)
    return found


def test_before_the_lift_it_is_trimmed_by_the_stern(alone: tuple[Statics, Equilibrium]) -> None:
    """20 812 t, drafts 5.53 m and 2.83 m, 1.46 deg by the stern, GM 32.2 and 206.7 m by hand: within 2 %."""
    question, rest = alone
    assert rest.is_stable or rest.neutral == 3, "nothing holds surge, sway and yaw"
    found = rest.recording
    assert vessel(found, "displacement") == pytest.approx(20_812e3, rel=1e-3)
    drafts = [vessel(found, f"draft_{end}") for end in ("aft", "forward")]
    assert drafts == pytest.approx([5.53, 2.83], rel=0.02)
    assert math.degrees(vessel(found, "trim")) == pytest.approx(1.46, rel=0.02)
    heights = metacentric_heights(question, rest)["barge"]
    assert (heights.transverse, heights.longitudinal) == pytest.approx((32.2, 206.7), rel=0.02)


def test_holding_the_load_it_floats_on_even_keel(held: tuple[Statics, Equilibrium]) -> None:
    """21 908 t at 4.40 m, GM 25.6 m and 191.4 m, by hand: within 2 %. Moorings add 0.1 m to GM."""
    question, rest = held
    found = rest.recording
    assert rest.is_stable
    assert vessel(found, "displacement") == pytest.approx(21_908e3, rel=2e-3)
    assert vessel(found, "draft") == pytest.approx(4.40, rel=0.005)
    assert abs(math.degrees(vessel(found, "trim"))) < 0.1
    assert abs(math.degrees(vessel(found, "heel"))) < 1e-6
    heights = metacentric_heights(question, rest)["barge"]
    # Four hooks in a row under one stiff load: it heels along with the vessel, and its weight counts below
    # the boom head, see `row_of_hooks`.
    assert heights.longitudinal == pytest.approx(191.4, rel=0.02)
    assert heights.transverse == pytest.approx(25.6 + row_of_hooks(), rel=0.02)


def row_of_hooks() -> float:
    """What a row of hooks under one stiff load adds to GM for heel [m].

    The load turns with the row. Its centre of gravity is 6 m below the lugs, and so its weight comes back to
    the middle of the row by 6 m times the heel.
    """
    return LOAD * 6.0 / 21_908e3


def test_the_boom_head_comes_ahead_and_down(
    alone: tuple[Statics, Equilibrium], held: tuple[Statics, Equilibrium]
) -> None:
    """2.78 m down and 2.55 m ahead of the middle of the waterline, by hand: within 2 %."""
    places = []
    for _, rest in (alone, held):
        trim, draft = vessel(rest.recording, "trim"), vessel(rest.recording, "draft")
        x, z = HEAD[0] - LENGTH / 2, HEAD[1] - draft
        ahead = x * math.cos(trim) - z * math.sin(trim)
        above = x * math.sin(trim) + z * math.cos(trim)
        places.append((ahead, above))
        sheaves = rest.recording.column("body_position", "fc.H1/upper_sheaves")[-1, 2]
        # The sheave block hangs 1.3 m below its pin; half the falls are lumped where they run over it.
        assert sheaves == pytest.approx(above - 1.3, abs=0.15)
    (aft, high), (ahead, low) = places
    assert ahead - aft == pytest.approx(2.55, rel=0.02)
    assert high - low == pytest.approx(2.78, rel=0.02)


def test_slings_ropes_and_hooks_carry_what_masses_say(recording: Recording) -> None:
    """490.5 kN upwards in each sling, 247 kN in the equalizing ropes, 274 t on each hook: within 2 %."""
    at = end_of(recording, "hold point 6")
    for number, hook in enumerate(HOOKS, start=1):
        tension = slings_of(recording, hook)[at]
        upwards = tension * np.cos(np.radians(ANGLES))
        assert upwards == pytest.approx(490.5e3, rel=0.02)
        rope = recording.column("rope_tension", f"E{number}.equalizing")[at]
        assert rope == pytest.approx(247e3, rel=0.02)
        assert recording.column("hook_load", f"fc.{hook}")[at] == pytest.approx(274e3 * G, rel=0.02)
        # By hand 354 t, with 30 t of falls; 32 parts of 11.9 kg/m, 47 m long, and lead lines have 19.8 t.
        assert recording.column("hoist_load", f"fc.{hook}")[at] == pytest.approx(
            (354 - 30 + 19.8) * 1e3 * G, rel=0.005
        )


def test_hook_loads_sum_to_weight_and_rigging(recording: Recording) -> None:
    """Masses of load, frames, sheaves, slings and shackles times g, by the model and by hand."""
    document = assemble(load_scenario(FILE)).document
    bodies = {body["name"]: body for body in document["bodies"]}
    hooks = {f"fc.{hook}" for hook in HOOKS}
    hanging = set(hooks)
    for name, body in bodies.items():
        if body["parent"] in hanging:
            hanging.add(name)
    own = hanging - hooks
    mass = math.fsum(bodies[name]["mass"] for name in own) + bodies["load"]["mass"]
    at = end_of(recording, "hold point 6")
    total = sum(recording.column("hook_load", hook)[at] for hook in hooks)
    # The load still bobs by a few tonnes in ten thousand.
    assert total == pytest.approx(mass * G, rel=1e-3)
    assert total == pytest.approx((LOAD + 4 * RIGGING) * G, rel=3e-3)


def test_equalizers_share_after_settling_and_from_then_on(recording: Recording) -> None:
    """Slings of one equalizer differ by less than 2 %; their angles alone make 0.88 %."""
    settled = end_of(recording, "settle")
    for hook in HOOKS:
        found = spread(slings_of(recording, hook))
        assert found[settled:].max() < 0.02
        assert found[-1] == pytest.approx(1 / math.cos(math.radians(7.6)) - 1, rel=0.02)


def test_moving_sheaves_travel_as_geometry_says(recording: Recording) -> None:
    """+0.07, +0.11, -0.35, +0.11, +0.07 m by hand, with rigid slings."""
    at = end_of(recording, "hold point 6")
    for equalizer in ("E1", "E2", "E3", "E4"):
        found = [recording.column("sheave_travel", f"{equalizer}.{n}")[at] for n in range(1, 6)]
        # Slings of 24 m under 490 kN stretch alike but for 1 mm; the frame of an equalizer hangs level.
        assert found == pytest.approx([0.07, 0.11, -0.35, 0.11, 0.07], abs=0.02)


def test_the_vessel_ends_on_even_keel_with_its_falls_plumb(recording: Recording) -> None:
    """Within 0.1 deg of even keel from lift-off on, falls within 0.5 deg of plumb at each hold point."""
    clear = recording.time > recording.metrics()["lift_off_time"] + 10.0
    for name in ("trim", "heel"):
        angle = np.degrees(recording.column(f"vessel_{name}", "barge"))
        assert np.abs(angle[clear]).max() < 0.1
    assert np.degrees(np.abs(recording["off_lead"].values[clear])).max() < 0.5
    failed = [check.name for check in check_recording(recording) if check.verdict == "failed"]
    assert failed == []


def test_hauling_follows_the_head(recording: Recording) -> None:
    """While the load is taken up the vessel goes astern by what its head comes ahead, then by 30 m."""
    astern = recording.column("body_position", "barge")[:, 0]
    start, held = 0, end_of(recording, "hold point 5")
    turned, draft = recording.column("vessel_trim", "barge"), recording.column("vessel_draft", "barge")
    heads = []
    for at in (start, held):
        x, z = HEAD[0] - LENGTH / 2, HEAD[1] - draft[at]
        heads.append(x * math.cos(turned[at]) - z * math.sin(turned[at]))
    hook = recording.column("body_position", "fc.H2")[:, 0]
    # The hooks stay over the load, which lies on its stools, to a quarter of a degree of 48 m of falls.
    assert hook[held] - hook[start] == pytest.approx(0.0, abs=0.25)
    assert heads[1] - heads[0] == pytest.approx(2.36, abs=0.05)
    assert astern[end_of(recording, "further astern")] - astern[held] == pytest.approx(-30.0, abs=0.25)
    assert hook[-1] - hook[held] == pytest.approx(-30.0, abs=0.25)


def test_displaced_weight_is_total_weight(held: tuple[Statics, Equilibrium]) -> None:
    """Masses, what winches have paid out, and what lines pull down by the elastic catenary: 1e-6."""
    question, rest = held
    scenario = read(PLAIN)
    found = rest.recording
    masses = math.fsum(body["mass"] for body in question.assembly.document["bodies"])
    owner = found["rope_of_point"].values
    down = 0.0
    for name, line in (scenario.mooring_lines or {}).items():
        path = found["rope_point"].values[-1, owner == f"mooring.{name}"]
        ends = path[np.argsort(np.linalg.norm(path - np.array(line.to), axis=1))]
        lower, upper = ends[0], ends[-1]
        assert lower == pytest.approx(line.to, abs=1e-9)
        tension = found.column("mooring_tension", name)[-1]
        stiffness = (scenario.ropes or {})[line.rope].stiffness
        assert stiffness is not None
        weight = line_weight(scenario, line)
        length, at_top = hung(upper - lower, tension, weight, stiffness)
        assert line.sea_bed is None or at_top > weight * length, "the whole line is off the bed"
        assert line.pretension is not None
        paid_out = found.column("joint_position", f"mooring.{name}.winch")[-1]
        down += at_top - weight * paid_out / (1 + line.pretension / stiffness)
    displaced = vessel(found, "displacement")
    assert displaced == pytest.approx(masses + down / G, rel=1e-6)
    assert displaced - masses > 5e3, "moorings are part of it"


def hung(apart: FloatArray, tension: float, weight: float, stiffness: float) -> tuple[float, float]:
    """Unstretched length [m] of an elastic catenary and its vertical force at the upper end [N].

    By Irvine's formulas, of a line off the bed, between ends so far apart, with a tension at the upper one.
    """
    reach, rise = math.hypot(apart[0], apart[1]), float(apart[2])

    def misses(unknown: FloatArray) -> list[float]:
        length, upwards = unknown[0], unknown[1] * 1e4
        level = math.sqrt(tension**2 - upwards**2)
        below = upwards - weight * length
        other = math.hypot(level, below)
        x = level / weight * (math.asinh(upwards / level) - math.asinh(below / level))
        z = (tension - other) / weight
        z += (upwards**2 - below**2) / (2 * stiffness * weight)
        return [x + level * length / stiffness - reach, z - rise]

    slope = rise / math.hypot(reach, rise)
    guess = [math.hypot(reach, rise), (tension * slope + weight * reach / 2) / 1e4]
    found = fsolve(misses, guess, xtol=1e-11)
    assert max(map(abs, misses(found))) < 1e-8
    return float(found[0]), float(found[1]) * 1e4


@pytest.mark.parametrize(("hook", "more"), [("H2", 18e3), ("H1", 8e3)])
def test_hook_levels_decide_who_carries(
    held: tuple[Statics, Equilibrium], recording: Recording, hook: str, more: float
) -> None:
    """10 mm at an inner hook are about 18 t, at an outer one about 8 t.

    Four springs k in a row under a stiff load: at the place y the share 1 - 1/4 - y^2/sum(y^2) of k 10 mm.
    """
    line = re.search(rf"^      {hook}: .*$", PLAIN, re.M)
    assert line is not None
    higher = line[0].replace("48.45 m", "48.46 m")
    rest = Statics(read(changed(PLAIN, (line[0], higher)))).equilibrium(1110.0)
    loads = [one.recording.column("hook_load", f"fc.{hook}")[-1] for one in (held[1], rest)]
    found = loads[1] - loads[0]
    places = {"H1": 11.25, "H2": 3.75, "H3": -3.75, "H4": -11.25}
    share = 0.75 - places[hook] ** 2 / sum(y**2 for y in places.values())
    scenario = read(PLAIN)
    hoist, sling, equalizing = (
        (scenario.ropes or {})[name].stiffness or 0.0 for name in ("hoist_54", "sling_64", "equalizing_46")
    )
    # Rope that winds up takes its strain along, so that hoisting does not change how the hooks share: it is
    # the falls in which the load was taken up that count, not those in which it hangs in the end.
    owner, points = recording["rope_of_point"].values, recording["rope_point"].values[0]
    falls, ring = (
        float(np.linalg.norm(np.diff(points[owner == name], axis=0), axis=1).sum())
        for name in ("hoist.fc.H2.1", "E2.equalizing")
    )
    soft = falls / (2 * 16**2 * hoist) + 24.16 / (5 * sling) + ring / (10**2 * equalizing)
    # Arcs on sheaves, sling angles, and the load that swings out as it tilts: a few per cent.
    assert found == pytest.approx(share / soft * 0.01, rel=0.04)
    assert found == pytest.approx(more * G, rel=0.07)


def test_the_balance_closes_and_it_runs_again_as_it_ran(recording: Recording) -> None:
    """Remainder below 1e-5; another run has the same bits, at least until the load is half taken up."""
    assert recording.metrics()["energy_remainder"] < 1e-5
    assert recording.attributes["warnings"] == []
    assert recording.events("overload") == []
    found = Simulation(load_scenario(FILE)).run(until=step_end(recording, "to 50 percent"))
    samples = len(found.time)
    assert recording.time[samples - 1] == found.time[-1] < recording.time[-1]
    assert np.array_equal(found["rope_tension"].values, recording["rope_tension"].values[:samples])


def test_pictures_show_its_stages(recording: Recording) -> None:
    """Steps side by side are one stage, anchors do not decide the scale, and water ends at the quay."""
    assert [name for name, *_ in stages_of(recording)] == [
        "start",
        "slings taut",
        "lift-off",
        "end of 'hoist'",
        "end of 'astern'",
        "end of 'further astern'",
    ]
    drawn = stages(recording)
    assert drawn is not None
    panels = [panel for panel in drawn.axes if panel.get_title()]
    assert len(panels) == 6
    for panel in panels:
        left, right = panel.get_xlim()
        # The vessel, 30 m astern of its place, to the far side of the load.
        assert left < -136 and right > 61 and right - left < 240
        # The bar of lengths lies below the panel, at no place of the lift.
        within = [line for line in panel.lines if line.get_transform() == panel.transData]
        lines = [np.asarray(line.get_xydata()) for line in within]
        surfaces = [line for line in lines if len(line) and np.all(line[:, 1] == 0.0)]
        assert [(line[:, 0].min(), line[:, 0].max()) for line in surfaces] == [(left, 12.0)]


#: Height of hooks that hold the load clear of its stools [m].
HUNG = 49.15


def hanging(seconds: float, plan: str, higher: float = 0.0) -> str:
    """The lift as it is at hold point 5 from the start on: incidents need not wait for what leads there.

    The vessel has followed its head by 2.36 m, and sheaves find their places first. Hooks may be higher [m].
    """
    text = without(PLAIN, "supports", "plan", "watch")
    text = changed(
        text,
        ("  stands_on: stools\n", ""),
        ("position: [47.4 m, 0 m, 5.0 m]", f"position: [47.4 m, 0 m, {5.35 + higher} m]"),
        ("position: [-102.89 m, 0 m]", "position: [-105.25 m, 0 m]"),
        ("draft: 4.18 m", "draft: 4.4 m"),
        ("trim: 1.35 deg", "trim: 0 deg"),
        ("duration: 2750 s", f"duration: {seconds} s"),
    ).replace("height: 48.45 m", f"height: {HUNG + higher} m")
    return f"{text}\nplan:\n  - {{step: pins, pull_pins: [E1, E2, E3, E4], hold: 20 s}}\n{plan}"


EVERY_SLING = ", ".join(f"sling.{hook}.{number}" for hook in HOOKS for number in range(1, 6))
LOST = f"  - {{step: loss, cut: [{EVERY_SLING}], hold: until_end}}\n"
DENSER = ("sample_interval: 2 s", "sample_interval: 0.25 s")


def test_an_incident_begins_as_the_lift_is_then(recording: Recording) -> None:
    """Hook loads to a thousandth, places to 5 cm: what `hanging` is worth."""
    begun = Simulation(read(hanging(20.0, ""))).run()
    at = end_of(recording, "hold point 5")
    for hook in HOOKS:
        loads = [found.column("hook_load", f"fc.{hook}") for found in (begun, recording)]
        assert loads[0][-1] == pytest.approx(loads[1][at], rel=1e-3)
    assert vessel(begun, "draft") == pytest.approx(vessel(recording, "draft", at), abs=0.01)
    assert abs(math.degrees(vessel(begun, "trim") - vessel(recording, "trim", at))) < 0.05
    for body, apart in (("barge", (0.05, 0.01, 0.01)), ("load", (0.05, 0.01, 0.05))):
        places = [found.column("body_position", body) for found in (begun, recording)]
        assert (np.abs(places[0][-1] - places[1][at]) < apart).all(), body


def test_sudden_loss_of_the_load(recording: Recording) -> None:
    """The vessel swings about the trim that it had before, by 1.527 times: 20 % of critical damping leave
    exp(-0.2 pi/sqrt(1 - 0.2^2)) = 0.527 of a swing. Nothing goes under.
    """
    lost = Simulation(read(changed(hanging(170.0, LOST), DENSER))).run()
    cut = lost.events("cut")
    assert len(cut) == 20
    after = lost.time > cut[0][0]
    trim = np.degrees(lost.column("vessel_trim", "barge"))
    settled = trim[lost.time > 140.0].mean()
    before = math.degrees(vessel(recording, "trim", 0))
    assert settled == pytest.approx(before, rel=0.01), "rigging hangs from the hooks as before"
    share = math.exp(-0.2 * math.pi / math.sqrt(1 - 0.2**2))
    # Heave has part of it, whose freeboard counts, and falls and boom spring: 3 %.
    assert trim[after].max() == pytest.approx(settled * (1 + share), rel=0.03)
    freeboard = lost.column("vessel_freeboard", "barge")[after].min()
    # At the stern, 7.5 m deep, by trim and mean draft. That comes from 4.40 m by 1000 t/(1.025 · 4858 m²),
    # 0.20 m, and goes at most as much beyond: 4.2 m to 0.2 m either way.
    assert freeboard == pytest.approx(7.5 - 4.2 - LENGTH / 2 * math.sin(math.radians(trim.max())), abs=0.2)
    assert freeboard > 1.0 and lost.events("flooding") == []
    assert lost.metrics()["energy_remainder"] < 1e-5


def test_sudden_loss_without_damping_swings_nearly_three_degrees(recording: Recording) -> None:
    """As meant by hand: twice the trim of before, 2.7 deg, and 2.9 deg if 96 t of rigging are lost too."""
    undamped = ("heave: 20 %, pitch: 20 %", "heave: 0 %, pitch: 0 %")
    lost = Simulation(read(changed(hanging(48.0, LOST), DENSER, undamped))).run()
    after = lost.time > lost.events("cut")[0][0]
    trim = np.degrees(lost.column("vessel_trim", "barge"))
    before = math.degrees(vessel(recording, "trim", 0))
    assert trim[after].max() == pytest.approx(2 * before, rel=0.03)
    assert trim[after].max() * 1096 / 1000 == pytest.approx(2.92, rel=0.03)
    # Heave and pitch have nearly one period, so the mean draft then has gone 0.2 m beyond 4.2 m too, which
    # the hand figure of 0.6 m leaves out. 2 cm: the periods, and some tonnes of lines.
    freeboard = lost.column("vessel_freeboard", "barge")[after].min()
    stern = LENGTH / 2 * math.sin(math.radians(trim[after].max()))
    assert freeboard == pytest.approx(7.5 - 4.0 - stern, abs=0.02)


def test_bow_lines_that_are_forgotten_break_the_stern_lines() -> None:
    """Hauled astern with the bow lines made fast: at 45 deg the stern lines have more to pull than these at
    31 deg, and part at their 1351 kN; the vessel springs ahead, to where the others hold it.
    """
    steps = PLAIN[PLAIN.index("  - {step: astern, haul:") : PLAIN.index("watch:")].rstrip()
    (veered,) = [line for line in steps.splitlines(keepends=True) if "{step: bow lines, " in line]
    breaks = ("diameter: 44 mm, ", "diameter: 44 mm, breaks_at: minimum_breaking_force, ")
    text = changed(hanging(420.0, steps + "\n"), (veered, ""), breaks)
    broken = Simulation(read(text)).run()
    events = broken.events("broken")
    assert {name for _, _, name in events} == {"mooring.stern.ps", "mooring.stern.sb"}
    at = int(np.searchsorted(broken.time, events[0][0]))
    tension = broken.column("mooring_tension", "stern.ps")
    assert tension[at + 1 :].max() == 0.0
    assert 1.0e6 < tension.max() < 1351e3
    ahead = broken.column("body_position", "barge")[:, 0]
    assert ahead[at:].max() > ahead[at - 1] + 0.5
    failed = {check.name for check in check_recording(broken) if check.verdict == "failed"}
    assert {"rope_parted", "mooring_tension_of_breaking_force"} <= failed
    assert broken.metrics()["energy_remainder"] < 1e-5


def test_tanks_that_are_filled_on_one_side_capsize_it() -> None:
    """6700 t into the port tanks while the load hangs: the deck's edge goes under, then it capsizes."""
    amounts = {"row1.1": 1400, "row2.1": 700, "row3.1": 2300, "row4.1": 2300}
    pumps = "".join(
        f"  - {{step: fill {tank}, starts: {'with' if place else 'after'}_previous, rate: 40000 t/h, "
        f"pump: {{from: sea, to: barge.{tank}}}, by: {amount} t}}\n"
        for place, (tank, amount) in enumerate(amounts.items())
    )
    text = hanging(640.0, pumps + "  - {step: end, hold: until_end}\n", 10.0)
    # How its slings snatch while it goes over took most of the time: it is over within 0.1 s of when it is to
    # the usual tolerances, 171.0 s.
    coarse = {"tension_tolerance": 100e3, "position_tolerance": 0.01}
    with pytest.raises(SimulationError) as failed:
        Simulation(read(text), **coarse).run()
    message = str(failed.value)
    assert "barge: it has capsized over its port side" in message
    assert "barge.deck_edge went under at" in message
    until = failed.value.recording
    assert until.attributes["status"] == "failed"
    (under,) = [time for time, _, name in until.events("flooding") if name == "barge.deck_edge"][:1]
    (over,) = until.events("capsized")
    assert under < over[0] and over[2].startswith("barge")
