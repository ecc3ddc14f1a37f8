"""Drums so wide, or with layers so thick, for the rope on them that a unit has slipped."""

from __future__ import annotations

from collections.abc import Iterator

from gantline.assembly.cranes.reeving import reeved_hooks
from gantline.scenario import Scenario
from gantline.scenario.cranes.drum import RopeOnDrum
from gantline.scenario.errors import Doubt
from gantline.scenario.findings import Path
from gantline.scenario.mechanics import RopeEnd

__all__ = ["doubtful_drums"]

#: Rules ask for drums of 11 to 30 diameters of their rope, mines for 120; beyond this ratio is none [1].
_WIDEST = 200.0
#: A layer adds the rope's own diameter at the most, or less where it lies in grooves [1].
_THICKEST = 1.5


def doubtful_drums(scenario: Scenario) -> list[Doubt]:
    """Each drum whose diameter or `layer_step` is not of the rope that lies on it.

    A drum ten times too wide has a tenth of the turns to pay out: no rope runs off it.
    """
    return list(dict.fromkeys(_drums(scenario)))  # ropes alike on one drum say the same


def _drums(scenario: Scenario) -> Iterator[Doubt]:
    ropes = scenario.ropes or {}
    for hook in reeved_hooks(scenario):
        thick = ropes[hook.reeving.rope].diameter
        at = (*hook.hook.paths["drum"], "diameter")
        step_at = (*hook.hook.paths["drum"], "layer_step")
        yield from _off(f"the drum of {hook.name}", hook.drum, thick, hook.drum.diameter, at, step_at)
    mechanics = scenario.mechanics
    drums = (None if mechanics is None else mechanics.drums) or {}
    for name, rope in ((None if mechanics is None else mechanics.ropes) or {}).items():
        for place, guide in enumerate(rope.route):
            if isinstance(guide, RopeEnd) and guide.drum is not None:
                drum, own = drums[guide.drum], guide.drum_diameter
                path: Path = ("mechanics", "drums", guide.drum)
                at = (*path, "diameter")
                if own is not None:
                    at = ("mechanics", "ropes", name, "route", place, "drum_diameter")
                thick, step_at = ropes[rope.rope].diameter, (*path, "layer_step")
                yield from _off(f"drum {guide.drum}", drum, thick, own or drum.diameter, at, step_at)


def _off(
    name: str, drum: RopeOnDrum, thick: float | None, diameter: float, at: Path, step_at: Path
) -> Iterator[Doubt]:
    """What is wrong with a drum of a diameter for a rope so thick [m]."""
    if thick is None:
        return
    if diameter > _WIDEST * thick:
        times = f"{diameter / thick:.0f} times its rope of {1e3 * thick:g} mm"
        wide = f"{name} has a diameter of {diameter:g} m, {times}"
        yield Doubt(at, f"{wide}; 16 to 30 times are usual, and a unit has slipped")
    elif diameter < thick:
        narrow = f"{name} has a diameter of {1e3 * diameter:g} mm, less than its rope of {1e3 * thick:g} mm"
        yield Doubt(at, f"{narrow}; 16 to 30 times are usual, and a unit has slipped")
    if drum.layers > 1 and drum.layer_step is not None and drum.layer_step > _THICKEST * thick:
        steps = f"each layer of {name} adds {1e3 * drum.layer_step:g} mm to its radius"
        usual = "0.87 to 1 times that are usual, and a unit has slipped"
        yield Doubt(step_at, f"{steps}, and its rope is {1e3 * thick:g} mm thick; {usual}")
