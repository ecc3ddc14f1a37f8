"""Equilibria of lifts whose drums have turned: what they let go depends on the strain of what was wound."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from gantline import _core
from gantline.results import Recording
from gantline.scenario import Scenario, parse_scenario
from gantline.simulation import Simulation
from gantline.statics import Statics
from mechanics import G, Json, adaptive, body, document, drum, end, flow, rope, slider
from resting import at_rest

SCENARIO = Path(__file__).resolve().parents[2] / "scenarios" / "reeved_hoist" / "scenario.yaml"
LOAD = "block"  # as the lift file calls it
MASS, EA = 10e3, 1e8
#: Strain of the rope under the load, 1e-3.
STRAIN = MASS * G / EA
DEPTH = 110.0
#: A motor that holds twice the load.
MOTOR = {"capacity": 2 * MASS * G, "power": 1e9}


def ramps_of(*changes: tuple[float, float, float]) -> list[Json]:
    """Ramps of (start [s], duration [s], velocity [m/s])."""
    return [{"at": at, "duration": lasts, "velocity": v, "shape": "smooth"} for at, lasts, v in changes]


UP_AND_DOWN = ramps_of((0.0, 1.0, -2.0), (20.0, 1.0, 0.0), (25.0, 1.0, 2.0), (45.0, 1.0, 0.0))


def hoist(ramps: list[Json], *, laid_under: float | None = None, **motor: float) -> Json:
    """A load at rest on one fall under a drum."""
    top = drum(None, (0, 0, 0), "winch")
    top["drum"] |= {"laid_under": laid_under}
    bodies = [
        body("load", slider(), MASS, position=(0, 0, -DEPTH)),
        flow("winch", 500.0, drive="winch", **motor),
    ]
    fall = rope("fall", DEPTH / (1 + STRAIN), [end("load"), top], EA, 0.1)
    return document(bodies, ropes=[fall], drives=[{"name": "winch", "ramps": ramps}])


@pytest.mark.parametrize(("wound", "slack"), [(0.01, 0.0), (0.05, 0.0), (0.05, 0.02)])
def test_winding_between_two_fixed_ends(wound: float, slack: float) -> None:
    """dL/dW = −1/(1 + ε) with 1 + ε = l/L gives T = EA (exp((W − s)/l) − 1), s the slack at the start.

    The trapezoidal rule over N parts leaves W³/12 N² l² of unstretched rope; parts are so short that W ε/N²
    is below 1e-6 m, with ε = W/l: that is 1e-6 W/12 l, 1e-8 of the stretch W.
    """
    distance = 10.0
    bodies = [flow("winch", 500.0, drive="winch")]
    route = [end(None, (0, 0, 0)), drum(None, (0, 0, distance), "winch")]
    drive = {"name": "winch", "ramps": ramps_of((0.0, 1.0, -wound / 10), (10.0, 1.0, 0.0))}
    system = document(bodies, ropes=[rope("r", distance + slack, route, EA)], drives=[drive])
    rest = at_rest(system, 20.0)
    assert rest.joint("winch") == pytest.approx(-wound, rel=1e-12)
    assert rest.tensions == pytest.approx([EA * math.expm1((wound - slack) / distance)], rel=2e-8)


@pytest.mark.parametrize("motor", [{}, MOTOR])
def test_a_load_rises_by_what_goes_over_the_rim(motor: dict[str, float]) -> None:
    """Under one tension all the way up and down the stretch goes onto the drum and comes off again."""
    system = hoist(UP_AND_DOWN, **motor)
    for time in (10.5, 22.0, 30.0, 60.0):
        rest = at_rest(system, time)
        # Multipliers of a motor are found to 1e-11 m.
        assert rest.body("load")[2] + DEPTH == pytest.approx(-rest.joint("winch"), abs=1e-10)
        assert rest.tensions == pytest.approx([MASS * G], rel=1e-10)
    assert at_rest(system, 22.0).joint("winch") == pytest.approx(-40.0, abs=1e-10)
    assert at_rest(system, 60.0).body("load")[2] == pytest.approx(-DEPTH, abs=1e-10)


def test_rope_wound_under_little_stretches_when_it_comes_off() -> None:
    """Rope wound with ε_d lets a load sink by s (1 + ε)/(1 + ε_d) where s goes over the rim."""
    ramps = ramps_of((0.0, 1.0, 0.5), (20.0, 1.0, 0.0))
    rest = at_rest(hoist(ramps, laid_under=0.5 * MASS * G), 30.0)
    sunk = 10.0 * (1 + STRAIN) / (1 + 0.5 * STRAIN)
    assert rest.body("load")[2] == pytest.approx(-DEPTH - sunk, abs=1e-10)


def test_equal_to_a_run_damped_to_rest() -> None:
    """Where a run rings out after a gentle hoist of 4 m: starting and stopping winds strains of ± 0.3 %."""
    system = hoist(ramps_of((0.0, 10.0, -0.2), (20.0, 10.0, 0.0)))
    rest = at_rest(system, 90.0)
    run = adaptive(system, 90.0, sample_interval=10.0)
    assert run.tension("fall")[-1] == pytest.approx(rest.tensions[0], rel=1e-10)
    # The run winds ε a/g more of 1 m while it starts, and as much less while it stops, of another length.
    assert run.body("load")[-1, 2] == pytest.approx(rest.body("load")[2], abs=1e-6)


def of_the_reeved_hoist(efficiency: float) -> Scenario:
    """The scenario up to where it looks round, for as long as that takes to come to rest."""
    text = SCENARIO.read_text(encoding="utf-8")
    lower = text.index("  - {step: lower")
    end_of_plan = text.index("  - {step: end")
    text = (text[:lower] + text[end_of_plan:]).replace("duration: 180 s", "duration: 300 s")
    return parse_scenario(text.replace("sheave_efficiency: 0.98", f"sheave_efficiency: {efficiency}"))


def differences(core: Any, run: Recording) -> tuple[float, float]:
    """Of all segments' tensions, relative, and of all positions [m]."""
    columns = core.columns()
    tension = columns["segment_tension"][-1] / run["segment_tension"].values[-1] - 1
    place = columns["body_position"][-1] - run["body_position"].values[-1]
    return float(np.abs(tension).max()), float(np.abs(place).max())


@pytest.mark.parametrize("efficiency", [0.98, 1.0])
def test_the_reeved_hoist_where_a_run_has_got_to(efficiency: float) -> None:
    """From a run that still rings to where it comes to rest: wound rope, stuck sheaves, motors that hold."""
    lift = of_the_reeved_hoist(efficiency)
    run = Simulation(lift)
    run.run(until=110.0)
    question = Statics(lift)
    rest = question.equilibrium_of(run.save())
    ended = run.run()
    assert np.abs(ended["body_velocity"].values[-1]).max() < 1e-9
    tension, place = differences(question._core, ended)
    # A sheave that still creeps at 110 s sticks elsewhere than one that has stopped there.
    assert tension < 1e-6
    assert place < 1e-6
    assert rest.neutral == 1


def test_the_reeved_hoist_by_its_plan() -> None:
    """Followed from rest to rest: between where a run gets to and there lie the moments of the conditions.

    The load swings in the run, and is clear of its supports 26 ms later: 0.1 mm at 0.25 m/min.
    """
    lift = of_the_reeved_hoist(1.0)
    rest = Statics(lift).equilibrium(150.0)
    ended = Simulation(lift).run()
    height = [one.column("body_position", LOAD)[-1, 2] for one in (rest.recording, ended)]
    assert height[0] == pytest.approx(height[1], abs=1.1e-4)
    assert height[0] - 2.5 > 5.0
    weight = rest.recording.column("hoist_load", "hook")[-1]
    assert weight == pytest.approx(ended.column("hoist_load", "hook")[-1], rel=1e-6)


def test_a_motor_that_is_too_weak() -> None:
    """It pulls with all it has, and the load stays where it stands."""
    text = of_the_reeved_hoist(1.0).text.replace("capacity: 260 kN", "capacity: 60 kN")
    rest = Statics(parse_scenario(text)).equilibrium(60.0)
    for name in ("hoist.hook.1", "hoist.hook.2"):
        assert rest.tension(name) == pytest.approx(60e3, rel=1e-8)
    assert 0.3 < float(rest.recording.column("load_transferred", LOAD)[-1]) < 0.4


def test_a_state_of_another_lift() -> None:
    """What a run has saved belongs to one lift, whatever the settings."""
    system = json.dumps(hoist(UP_AND_DOWN))
    settings = json.dumps({"integrator": {"type": "adaptive"}, "duration": 1.0, "sample_interval": 0.5})
    saved = _core.Simulation(system, settings).save()
    assert _core.Statics(system).settle_saved(saved, "none")["time"] == 0.0
    other = _core.Statics(json.dumps(hoist([])))
    with pytest.raises(ValueError, match="it was saved from another lift"):
        other.settle_saved(saved, "none")
    with pytest.raises(ValueError, match="the saved state cannot be used"):
        other.settle_saved(b"nothing", "none")
