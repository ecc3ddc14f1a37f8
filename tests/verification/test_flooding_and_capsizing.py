"""Vessels whose deck edges and openings go under water, and those that turn over or sink."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from afloat import DEPTH, DRAFT, MASS, barge, lift_of, written
from gantline.results.recording import Recording
from gantline.scenario import ScenarioError
from gantline.simulation import Simulation, SimulationError, simulate
from gantline.statics import NoEquilibriumError, Statics


def edge_under(run: Recording) -> list[tuple[float, str]]:
    """When the freeboard of the recording changes its sign, by straight lines between its samples."""
    freeboard = run.column("vessel_freeboard", "barge")
    places = np.flatnonzero((freeboard[1:] < 0) != (freeboard[:-1] < 0))
    share = freeboard[places] / (freeboard[places] - freeboard[places + 1])
    times = run.time[places] + share * np.diff(run.time)[places]
    kinds = ["flooding" if freeboard[place] >= 0 else "surfacing" for place in places]
    return list(zip(times.tolist(), kinds, strict=True))


@pytest.mark.parametrize("integrator", ["adaptive", "del"])
def test_flooding_is_told_and_the_run_goes_on(tmp_path: Path, integrator: str) -> None:
    """A barge that is let go with 20° of heel rolls its deck edges under, one after the other: the box has a
    dry deck up to tan φ = 4/15, 14.9°. Times against the recorded freeboard between samples of 20 ms.
    """
    given = lift_of(barge(heel="20 deg"), start="as_given", duration="12 s")
    run = simulate(written(tmp_path, given), integrator=integrator)
    assert run.attributes["status"] == "done"
    events = [event for event in run.events() if event[1] in ("flooding", "surfacing")]
    assert events[0] == (0.0, "flooding", "barge.deck_edge")
    found = edge_under(run)
    assert len(found) >= 4
    assert [(kind, name) for _, kind, name in events[1:]] == [(kind, "barge.deck_edge") for _, kind in found]
    # Freeboard moves at up to 5 m/s and bends by 5 m/s²: within 20 ms by 0.25 mm of a line, 0.1 ms; del moves
    # by straight lines itself.
    assert [time for time, _, _ in events[1:]] == pytest.approx([time for time, _ in found], abs=1e-3)
    told = "barge.deck_edge goes under water at 0.00 s; no water comes in here, as it would"
    assert run.attributes["warnings"].count(told) == 1


@pytest.mark.parametrize(
    ("heel", "depth", "most"),
    [("20 deg", "8 m", 2e-8), ("20 deg", "30 m", 2e-8), ("12 deg", "5.5 m", 1e-6)],
    ids=["both", "bottom", "deck"],
)
def test_energy_balances_where_edges_go_under_and_come_out(
    tmp_path: Path, heel: str, depth: str, most: float
) -> None:
    """A barge that rolls its deck edges under, its bottom's edges out, or both at once, for a minute. Forces
    between these times are smooth, and Gauss points of order 8 along steps of order 5 leave 3e-9 of the
    energy where steps end there, and steps across the edges of a bottom 7e-8 and more. Of a deck alone they
    leave 1e-7 and 2e-7, which does not tell.
    """
    given = barge(heel=heel, hull={"box": ["100 m", "30 m", depth]})
    run = simulate(written(tmp_path, lift_of(given, start="as_given", duration="60 s")))
    assert run.attributes["energy_remainder"] < most


def test_an_opening_goes_under_before_the_deck(tmp_path: Path) -> None:
    """A vent in the side, 2 m above the water 14 m off the centre: it is wet beyond tan φ = 2/14, 8.1°."""
    vent = ["50 m", "-14 m", f"{DRAFT + 2} m"]
    given = lift_of(barge(heel="-12 deg", openings={"vent": vent}), start="as_given", duration="8 s")
    run = simulate(written(tmp_path, given))
    names = {name for _, kind, name in run.events() if kind in ("flooding", "surfacing")}
    assert names == {"barge.vent"}
    (time, _, _) = run.events("flooding")[0]
    at = int(np.searchsorted(run.time, time))
    between = [run.column(name, "barge")[at - 1 : at + 1] for name in ("vessel_freeboard", "vessel_heel")]
    assert between[0][0] >= 0 > between[0][1]
    assert between[1][0] > 0, "it is the side to which it rolls over from port"


TOP_HEAVY = {"masses": {"hull": {"mass": f"{MASS} kg", "at": ["50 m", "0 m", "22 m"]}}}


def test_a_top_heavy_barge_capsizes(tmp_path: Path) -> None:
    """KG 22 m is above the metacentre, at T/2 + B²/12T = 20.75 m: let go with 2° of heel to port it turns
    over. The run ends where its z axis is 60° from plumb, with what was recorded.
    """
    given = lift_of(barge(heel="-2 deg", **TOP_HEAVY), start="as_given", duration="200 s")
    simulation = Simulation(written(tmp_path, given))
    with pytest.raises(SimulationError) as raised:
        simulation.run()
    error, run = raised.value, raised.value.recording
    assert error.element == "barge"
    assert error.cause.startswith(
        "it has capsized over its port side, more than 60° from upright; before that "
    )
    flooded = run.events("flooding")[0]
    assert error.cause.endswith(f"barge.deck_edge went under at {flooded[0]:.2f} s")
    ((time, _, name),) = run.events("capsized")
    assert (time, name) == (error.time, "barge")
    assert flooded[0] < time <= run.time[-1] + 0.02
    heel = np.interp(time, run.time, run.column("vessel_heel", "barge"))
    # 20 ms before or after it has turned by 1° at most.
    assert math.degrees(heel) == pytest.approx(-60, abs=1.0)
    assert run.attributes["failure"]["element"] == "barge"
    assert run.attributes["status"] == "failed"
    with pytest.raises(SimulationError, match="capsized"):
        simulation.run()


def test_a_counterweight_that_is_lost_turns_a_barge_over(tmp_path: Path) -> None:
    """3000 t on each side; when the rope of one is cut the other heels it beyond all that its hull can right:
    what the message tells is the rope, and the deck edge that went under after it.
    """
    masses = barge()["masses"] | {"stack": {"mass": "3000 t", "at": ["50 m", "14 m", "30 m"]}}
    mechanics = {
        "bodies": {
            "weight": {"at": ["50 m", "-14 m", "19 m"], "joint": {"type": "point"}, "mass": "3000 t"},
        },
        "ropes": {
            "sling": {
                "rope": "thick",
                "length": "5 m",
                "cut_at": "1 s",
                "route": [
                    {"type": "end", "body": "barge", "at": ["50 m", "-14 m", "30 m"]},
                    {"type": "end", "body": "weight"},
                ],
            }
        },
    }
    ropes = {"thick": {"axial_stiffness": "5000 MN", "damping_time": "20 ms"}}
    given = lift_of(barge(draft="6 m", masses=masses), duration="60 s", ropes=ropes, mechanics=mechanics)
    with pytest.raises(SimulationError) as raised:
        simulate(written(tmp_path, given))
    cause = raised.value.cause
    assert "over its port side" in cause
    assert "before that sling was cut at 1.00 s, and barge.deck_edge went under at " in cause


def test_what_capsizes_or_sinks_at_rest_is_told(tmp_path: Path) -> None:
    """A barge that turns over before a run begins, and one that is heavier than all of its hull displaces."""
    path = written(tmp_path, lift_of(barge(heel="-2 deg", **TOP_HEAVY)))
    with pytest.raises(ScenarioError, match=r"vessels\.barge: it cannot start at rest: it capsizes before"):
        Simulation(path)
    # On its side it floats stably: that was an equilibrium like any other.
    with pytest.raises(NoEquilibriumError, match="it capsizes before it comes to rest"):
        Statics(path).equilibrium()
    masses = {"hull": {"mass": "25000 t", "at": ["50 m", "0 m", "5 m"]}}
    question = Statics(written(tmp_path, lift_of(barge(masses=masses))))
    with pytest.raises(NoEquilibriumError, match="it sinks: no hull bears that weight"):
        question.equilibrium()
    # Under water on two ropes from a bridge above it, it would rest.
    ropes = {
        name: {
            "rope": "strong",
            "length": "60 m",
            "route": [
                {"type": "end", "body": "bridge", "at": [f"{x} m", "0 m", "0 m"]},
                {"type": "end", "body": "barge", "at": [f"{x} m", "0 m", f"{DEPTH} m"]},
            ],
        }
        for name, x in {"fore": 90, "aft": 10}.items()
    }
    bridge = {"at": ["0 m", "0 m", "50 m"], "joint": {"type": "fixed"}}
    above = {"bodies": {"bridge": bridge}, "ropes": ropes}
    strong = {"strong": {"axial_stiffness": "5 GN"}}
    hung = written(tmp_path, lift_of(barge(masses=masses), mechanics=above, ropes=strong))
    with pytest.raises(NoEquilibriumError, match="it sinks: no hull bears that weight"):
        Statics(hung).equilibrium()
