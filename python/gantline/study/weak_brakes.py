"""Brakes of winches and hoists that hold less than what hangs on them at rest, by statics alone."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from gantline.results.recording import Recording
from gantline.scenario import Scenario, ScenarioError
from gantline.scenario.errors import Doubt
from gantline.scenario.findings import Path
from gantline.scenario.reeving import hoist_drum
from gantline.scenario.steps import MovingStep
from gantline.statics import Statics
from gantline.study.steps import END, START, StepAtRest, run_steps
from gantline.units import format_by_size

__all__ = ["weak_brakes"]


#: Equilibria of one weight differ by less than this share [1].
_ROUNDING = 1.0 + 1e-6


@dataclass(frozen=True)
class _Brake:
    """The brake of a drum.

    Attributes:
        name: Whose it is.
        drum: The flow that it holds.
        path: Where the lift file says what it holds.
        holds: Pull on the first layer that it holds [N].
        ropes: Ropes at the drum by which that pull counts, parts of line of a hook.
    """

    name: str
    drum: str
    path: Path
    holds: float
    ropes: int = 1


def weak_brakes(scenario: Scenario) -> list[Doubt]:
    """Each brake that an emergency stop would throw in and that what hangs there at rest would drag along.

    The lift is looked at where each step of its plan ends, as if no emergency stop came before, with sheaves
    that lose nothing. A brake as strong as its motor is not looked at: what the motor lifts it holds.

    Args:
        scenario: The lift.

    Returns:
        Of each such brake what it would have to hold at most; none of a lift without statics.
    """
    brakes = _brakes(scenario)
    if not brakes:
        return []
    most: dict[str, tuple[float, StepAtRest]] = {}
    try:
        question = Statics(_without_stops(scenario))
        for one in run_steps(question):
            if one.state.rest is None:
                continue
            for brake in brakes:
                pull = _pull(question, one.state.rest.recording, brake)
                known = most[brake.drum][0] if brake.drum in most else brake.holds
                if pull > known * _ROUNDING:
                    most[brake.drum] = pull, one
    except ScenarioError:  # lengths that are adjusted have no statics
        return []
    return [Doubt(brake.path, _told(brake, *most[brake.drum])) for brake in brakes if brake.drum in most]


def _brakes(scenario: Scenario) -> list[_Brake]:
    """Those that hold less than their motors."""
    found = []
    for name, hook in scenario.hooks.items():
        hoist = hook.hoist
        if hook.reeving is not None and hoist.brake is not None and hoist.brake < (hoist.capacity or 0.0):
            path = (*hook.paths[""], "hoist", "brake")
            found.append(_Brake(name, hoist_drum(name), path, hoist.brake, hook.reeving.parts))
    drums = scenario.mechanics.drums if scenario.mechanics is not None else None
    for name, drum in (drums or {}).items():
        drive = drum.drive
        if drive is not None and drive.brake is not None and drive.brake < (drive.capacity or 0.0):
            path = ("mechanics", "drums", name, "drive", "brake")
            found.append(_Brake(name, name, path, drive.brake))
    return found


def _without_stops(scenario: Scenario) -> Scenario:
    """The lift whose steps brake as usual where they would stop in an emergency."""
    plan = [
        step.model_copy(update={"brake_from": step.emergency_stop_at, "emergency_stop_at": None})
        if isinstance(step, MovingStep) and step.emergency_stop_at is not None
        else step
        for step in scenario.plan
    ]
    return scenario.model_copy(update={"plan": plan, "emergency_stop": None})


def _pull(question: Statics, recording: Recording, brake: _Brake) -> float:
    """What the drum sees of each of its ropes at rest, on its first layer [N]."""
    turning = sum(
        rate * float(recording.column("segment_tension", segment)[-1])
        for rope in question.assembly.document["ropes"]
        for rate, segment in _on_drum(rope, recording, brake.drum)
    )
    return abs(turning) * _layer(recording, brake.drum) / brake.ropes


def _on_drum(rope: Mapping[str, Any], recording: Recording, drum: str) -> Iterator[tuple[float, str]]:
    """What a rope gets of a unit of the drum's flow, and its segment there, at each end on that drum."""
    own = [one for one in recording.coordinates["segment"] if one.rpartition("/")[0] == rope["name"]]
    for place in (0, -1):
        on = rope["route"][place].get("drum")
        if on is not None and on["flow"] == drum:
            yield on["rate"], own[place]


def _layer(recording: Recording, name: str) -> float:
    """Pitch diameter of the layer that a drum winds over that of its first one [1]."""
    drum = next((one for one in recording.rig.drums if one.name == name), None)
    if drum is None or name not in recording.coordinates.get("counted_drum", ()):
        return 1.0
    layers = float(recording.column("drum_layer", name)[-1]) - 1.0
    return 1.0 + 2.0 * drum.layer_step * layers / drum.diameter


def _told(brake: _Brake, pull: float, one: StepAtRest) -> str:
    when = f"at the {one.name}" if one.name in (START, END) else f"at the end of '{one.name}'"
    each = " of each rope" if brake.ropes > 1 else ""
    holds = f"the brake of {brake.name} holds a pull of {format_by_size(brake.holds, 'force', 4)}{each}"
    hangs = f"at rest {when} it has to hold {format_by_size(pull, 'force', 4)}"
    return f"{holds}, and {hangs}: an emergency stop lets go what hangs there"
