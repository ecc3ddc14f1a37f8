"""Where trolleys and cranes stand so that falls hang plumb: over lugs, over where the load stood."""

from __future__ import annotations

import numpy as np
import pytest

from crawler_pair import GEAR, MASSES
from gantline.results.rotation import axes
from gantline.scenario import Scenario, parse_scenario
from gantline.statics import Equilibrium, Statics
from gantline.study import CannotBeError, HookAnswer, plumb_hooks
from mechanics import Floats, G
from trolley_pair import TROLLEYS

LOAD = "load"
WEIGHT = 120e3 * G
#: Where the load stands, its centre of gravity and its lugs below the two trolleys in its own axes [m].
STANDS, CENTRE = (1.0, 0.5, 0.0), (-0.7, 0.3, 2.0)
LUGS = {"A1": (-9.0, 2.0, 4.0), "A2": (-9.0, -2.0, 4.0), "B1": (8.0, 2.0, 4.0), "B2": (8.0, -2.0, 4.0)}
POSITIONS = {"one": "cranes.gol.trolleys.one.position", "two": "cranes.gol.trolleys.two.position"}
CRANE = "cranes.gol.position"

LOADED = """\
load:
  name: load
  shape: {box: [24 m, 8 m, 4 m]}
  position: STANDS
  weight: {calculated: 120 t}
  centre_of_gravity: {at: CENTRE}
  stands_on: ground
  lugs:
LUGS
sling_defaults: {rope: sling}
slings:
  A1: {from: FIRST, to: load.A1, length: 10 m}
  A2: {from: FIRST, to: load.A2, length: 10 m}
  B1: {from: SECOND, to: load.B1, length: 10 m}
  B2: {from: SECOND, to: load.B2, length: 10 m}
plan:
  - {step: up, hoist: [FIRST, SECOND], speed: 1 m/min, by: 1.5 m}
MORE
"""
#: Each with its boom over the load, 16 m to the right; tandem, and alike but for the drive that slews one.
CRAWLERS = f"""\
format: 1
lift: {{title: Two crawler cranes}}
duration: 400 s
{GEAR}cranes:
  c1:
    type: crawler
    position: [-8.3 m, 17 m]
    slew: -90 deg
    tracks: {{length: 9 m, width: 1.5 m, gauge: 8.4 m, mats: 6 m}}
{MASSES}    hooks:
      H: {{type: H, height: 13.6 m}}
  c2:
    type: crawler
    position: [8.8 m, 17 m]
    slew: -90 deg
    slewing: {{speed: 0.3 rev/min, acceleration: 0.1 deg/s^2}}
    tracks: {{length: 9 m, width: 1.5 m, gauge: 8.4 m, mats: 6 m}}
{MASSES}    hooks:
      H: {{type: H, height: 13.6 m}}
"""


def at(place: tuple[float, float, float]) -> str:
    return "[" + ", ".join(f"{value} m" for value in place) + "]"


def lift(
    more: str = "  - {step: end, hold: until_end}",
    cranes: str = TROLLEYS,
    hooks: tuple[str, str] = ("gol.A", "gol.B"),
) -> Scenario:
    lugs = "\n".join(f"    {name}: {{at: {at(place)}}}" for name, place in LUGS.items())
    text = LOADED.replace("FIRST", hooks[0]).replace("SECOND", hooks[1])
    for word, right in (("STANDS", at(STANDS)), ("CENTRE", at(CENTRE)), ("LUGS", lugs), ("MORE", more)):
        text = text.replace(word, right)
    return parse_scenario(cranes + text)


def lug(rest: Equilibrium, name: str) -> Floats:
    """Where a lug is."""
    recording = rest.recording
    own = axes(recording.column("body_orientation", LOAD)[-1])
    centre = recording.column("body_position", LOAD)[-1]
    found: Floats = centre + own @ (np.array(LUGS[name]) - CENTRE)
    return found


def hook_at(rest: Equilibrium, hook: str) -> Floats:
    """Where a hook is, along x and y."""
    found: Floats = rest.recording.column("body_position", hook)[-1, :2]
    return found


@pytest.fixture(scope="module")
def answer() -> HookAnswer:
    return plumb_hooks(lift())


def test_trolleys_come_over_their_lugs_and_the_crane_over_the_load(answer: HookAnswer) -> None:
    """Two plumb hooks in one line go through the centre of gravity, where it stood, each over its lugs."""
    assert list(answer.values) == [*POSITIONS.values(), CRANE]
    assert answer.residual < 1e-9
    assert answer.values[CRANE] == pytest.approx(STANDS[1] + CENTRE[1], abs=1e-8)
    assert answer.drift is not None
    assert answer.drift[0] > 0.1
    assert answer.drift[1] < 1e-8
    for hook, name, letter in (("gol.A", "one", "A"), ("gol.B", "two", "B")):
        place = (answer.values[POSITIONS[name]], answer.values[CRANE])
        assert answer.places[hook] == place
        # The falls are plumb: the hook hangs where its trolley is.
        assert hook_at(answer.after, hook) == pytest.approx(place, abs=1e-8)
        assert np.linalg.norm(hook_at(answer.before, hook) - answer.given[hook]) > 0.03
        assert np.abs(answer.side_pulls[hook][1]).max() < 1e-9 * WEIGHT
        # Above the middle of its lugs, but for the 0.1 mm that both are apart along x.
        middle = (lug(answer.after, f"{letter}1") + lug(answer.after, f"{letter}2")) / 2
        assert place[0] == pytest.approx(middle[0], abs=1e-4)


def test_the_answer_hangs_as_it_says(answer: HookAnswer) -> None:
    """Solved once more from the lift file with the new places, without derivatives."""
    again = Statics(answer.scenario).equilibrium().recording
    load = again.column("body_position", LOAD)
    assert load[-1, :2] == pytest.approx(load[0, :2], abs=1e-8)
    assert answer.scenario.hooks["gol.A"].place == pytest.approx(answer.places["gol.A"], abs=1e-12)


def test_where_both_trolleys_go_alike_the_answer_is_the_same(answer: HookAnswer) -> None:
    """Drift is against what bears the hooks: 20 m on and 10 m along the rails they hang as before."""
    go = "  - {step: go, traverse: [gol.one, gol.two], speed: 20 m/min, by: 20 m}\n"
    go += "  - {step: on, travel: gol, speed: 20 m/min, by: 10 m}"
    gone = plumb_hooks(lift(go))
    assert gone.values == pytest.approx(answer.values, abs=1e-7)
    assert gone.drift is not None
    assert gone.drift[1] < 1e-8


def test_where_they_go_apart_there_is_no_drift_and_the_least_change_is_taken() -> None:
    """One trolley by 0.4 m: nothing says where the load belongs, so both move alike, against each other."""
    gone = plumb_hooks(lift("  - {step: apart, traverse: gol.two, speed: 2 m/min, by: 0.4 m}"))
    assert gone.drift is None
    one, two = gone.values[POSITIONS["one"]] + 8.3, gone.values[POSITIONS["two"]] - 8.8
    assert one == pytest.approx(-two, abs=1e-7)
    # 17 m between the lugs, on level to 2e-4; the hooks began 17.1 m apart and came to 17.5 m.
    assert two - one == pytest.approx(17.0 - 17.5, abs=1e-4)
    assert gone.values[CRANE] == pytest.approx(0.2, abs=1e-9)


def test_one_hook_of_two_moves_with_its_trolley_alone(answer: HookAnswer) -> None:
    """Without drift it takes both trolleys and the crane; where nothing stands, one trolley will do."""
    says = r"^places of hooks do not act on what is wanted: the place along y$"
    with pytest.raises(CannotBeError, match=says):
        plumb_hooks(lift(), hooks=["gol.A"])
    gone = plumb_hooks(
        lift("  - {step: apart, traverse: gol.two, speed: 2 m/min, by: 0.4 m}"), hooks=["gol.A"]
    )
    assert list(gone.values) == [POSITIONS["one"]]
    assert list(gone.places) == ["gol.A"]
    assert gone.values[POSITIONS["one"]] == pytest.approx(-8.3 + 0.5, abs=1e-4)


def test_two_hooks_of_one_trolley_lean_against_each_other() -> None:
    """The trolley is not pulled aside by both together; each is: 16 m apart, above lugs 17 m apart."""
    hooks = [
        f"{name}: {{type: H, height: 13.6 m, along: {along} m}}" for name, along in (("A", -8), ("B", 8))
    ]
    text = TROLLEYS.replace("hooks: {A: {type: H, height: 13.6 m}}", f"hooks: {{{', '.join(hooks)}}}")
    text = text.replace("position: -8.3 m", "position: 0.8 m")
    both = plumb_hooks(lift(cranes=text[: text.index("      two:")]))
    assert list(both.values) == [POSITIONS["one"], CRANE]
    west, east = (both.side_pulls[hook][1] for hook in ("gol.A", "gol.B"))
    assert west + east == pytest.approx([0, 0], abs=1e-9 * WEIGHT)
    assert west[0] < -1e-3 * WEIGHT
    assert both.drift is not None
    assert both.drift[1] < 1e-8


def test_two_crawler_cranes_come_over_the_lugs_and_the_load_keeps_its_heading() -> None:
    """Cranes that lean on their ground, solved anew: no drift, no turn, falls less than 1e-9 out of plumb."""
    answer = plumb_hooks(lift(cranes=CRAWLERS, hooks=("c1.H", "c2.H")))
    assert list(answer.values) == [
        f"cranes.{crane}.position.{axis}" for crane in ("c1", "c2") for axis in (1, 2)
    ]
    assert answer.steps <= 3  # the derivatives are exact, and the crane leans by little
    again = Statics(answer.scenario).equilibrium().recording
    assert (
        np.abs(again.column("body_position", LOAD)[-1, :2] - again.column("body_position", LOAD)[0, :2]).max()
        < 1e-8
    )
    heading = axes(again.column("body_orientation", LOAD)[-1])[:, 0]
    assert heading[1] == pytest.approx(0.0, abs=1e-9)
    for hook, letter in (("c1.H", "A"), ("c2.H", "B")):
        assert again.column("falls_out_of_plumb", hook)[-1] < 1e-9
        assert answer.before.recording.column("falls_out_of_plumb", hook)[-1] > 5e-4
        middle = (lug(answer.after, f"{letter}1") + lug(answer.after, f"{letter}2")) / 2
        assert hook_at(answer.after, hook)[0] == pytest.approx(middle[0], abs=1e-4)
        # Empty, as the lift starts, cranes lean back by some centimetres at their heads.
        assert answer.places[hook] == pytest.approx(hook_at(answer.after, hook), abs=0.1)


def test_a_crane_that_slews_leaves_no_drift() -> None:
    """Slewed by 2 deg with its load, a crane has taken it along: only plumb falls are asked for then."""
    slew = "  - {step: on, slew: c2, speed: 0.1 rev/min, by: 2 deg}"
    gone = plumb_hooks(lift(slew, CRAWLERS, ("c1.H", "c2.H")))
    assert gone.drift is None
    for hook in ("c1.H", "c2.H"):
        assert np.abs(gone.side_pulls[hook][1]).max() < 1e-8 * WEIGHT
