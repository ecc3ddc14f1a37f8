"""Brakes of winches and hoists that hold less than what hangs on them at rest, by statics alone."""

from __future__ import annotations

from gantline.scenario import Scenario, ScenarioError
from gantline.scenario.cranes.reeving import hoist_drum
from gantline.scenario.errors import Doubt
from gantline.statics import Statics
from gantline.study.drum_pulls import OfDrum, pull_at, when, without_stops
from gantline.study.steps import StepAtRest, run_steps
from gantline.units import format_by_size

__all__ = ["weak_brakes"]


#: Equilibria of one weight differ by less than this share [1].
_ROUNDING = 1.0 + 1e-6


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
        question = Statics(without_stops(scenario))
        for one in run_steps(question):
            if one.state.rest is None:
                continue
            for brake in brakes:
                pull = pull_at(question, one.state.rest.recording, brake)
                known = most[brake.drum][0] if brake.drum in most else brake.holds
                if pull > known * _ROUNDING:
                    most[brake.drum] = pull, one
    except ScenarioError:  # lengths that are adjusted have no statics
        return []
    return [Doubt(brake.path, _told(brake, *most[brake.drum])) for brake in brakes if brake.drum in most]


def _brakes(scenario: Scenario) -> list[OfDrum]:
    """Those that hold less than their motors."""
    found = []
    for name, hook in scenario.hooks.items():
        hoist = hook.hoist
        if hook.reeving is not None and hoist.brake is not None and hoist.brake < (hoist.capacity or 0.0):
            path = (*hook.paths[""], "hoist", "brake")
            found.append(OfDrum(name, hoist_drum(name), path, hoist.brake, hook.reeving.parts))
    drums = scenario.mechanics.drums if scenario.mechanics is not None else None
    for name, drum in (drums or {}).items():
        drive = drum.drive
        if drive is not None and drive.brake is not None and drive.brake < (drive.capacity or 0.0):
            path = ("mechanics", "drums", name, "drive", "brake")
            found.append(OfDrum(name, name, path, drive.brake))
    return found


def _told(brake: OfDrum, pull: float, one: StepAtRest) -> str:
    each = " of each rope" if brake.ropes > 1 else ""
    holds = f"the brake of {brake.name} holds a pull of {format_by_size(brake.holds, 'force', 4)}{each}"
    hangs = f"at rest {when(one)} it has to hold {format_by_size(pull, 'force', 4)}"
    return f"{holds}, and {hangs}: an emergency stop lets go what hangs there"
