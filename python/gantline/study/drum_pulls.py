"""What drums of winches and hoists have to hold of their ropes at rest."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from gantline.results.recording import Recording
from gantline.scenario import Scenario
from gantline.scenario.findings import Path
from gantline.scenario.plan.steps import MovingStep
from gantline.statics import Statics
from gantline.study.steps import END, START, StepAtRest

__all__ = ["OfDrum", "pull_at", "when", "without_stops"]


@dataclass(frozen=True)
class OfDrum:
    """The brake or the motor of a drum.

    Attributes:
        name: Whose it is.
        drum: The flow that it holds.
        path: Where the lift file says what it holds.
        holds: Pull of each rope on the first layer that it holds [N].
        ropes: Ropes at the drum by which that pull counts, parts of line of a hook.
    """

    name: str
    drum: str
    path: Path
    holds: float
    ropes: int = 1


def without_stops(scenario: Scenario) -> Scenario:
    """The lift whose steps brake as usual where they would stop in an emergency."""
    plan = [
        step.model_copy(update={"brake_from": step.emergency_stop_at, "emergency_stop_at": None})
        if isinstance(step, MovingStep) and step.emergency_stop_at is not None
        else step
        for step in scenario.plan
    ]
    return scenario.model_copy(update={"plan": plan, "emergency_stop": None})


def pull_at(question: Statics, recording: Recording, one: OfDrum) -> float:
    """What the drum sees of each of its ropes at rest, on its first layer [N]."""
    turning = sum(
        rate * float(recording.column("segment_tension", segment)[-1])
        for rope in question.assembly.document["ropes"]
        for rate, segment in _on_drum(rope, recording, one.drum)
    )
    return abs(turning) * _layer(recording, one.drum) / one.ropes


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


def when(one: StepAtRest) -> str:
    """The moment of a lift at rest, in words."""
    return f"at the {one.name}" if one.name in (START, END) else f"at the end of '{one.name}'"
