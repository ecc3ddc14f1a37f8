"""`gantline run --refine`: a finer run beside a run, and how far what is checked moves."""

from __future__ import annotations

from typing import TYPE_CHECKING

import typer

from gantline.cli.messages import warn
from gantline.cli.progress import progress
from gantline.cli.table import table

if TYPE_CHECKING:
    from gantline.results.recording import Recording
    from gantline.results.refinement import Refinement
    from gantline.simulation import Simulation

__all__ = ["refinement_table", "with_refinement"]


def with_refinement(simulation: Simulation, recording: Recording) -> Recording:
    """The recording with what a finer run says of it; as it is, with a warning, where that one breaks off."""
    from gantline.simulation import SimulationError
    from gantline.study import finer_simulation, refined

    finer = finer_simulation(simulation, recording)
    typer.echo("simulating once more with a finer method", err=True)
    try:
        with progress(finer) as report:
            found = finer.run(on_progress=report)
    except SimulationError as problem:
        warn(f"not refined: {problem}")
        return recording
    if found.attributes["status"] != "done":
        warn(f"not refined: stopped at {finer.time:.2f} s of {finer.duration:g} s")
        return recording
    return refined(recording, found)


def refinement_table(refinement: Refinement | None) -> list[str]:
    """Lines of the figures that moved most; none of a lift that was not refined."""
    from gantline.results.refinement import in_per_cent

    if refinement is None:
        return []
    rows = [
        (
            one.name,
            f"{one.element} (end of '{one.step}')" if one.step else one.element,
            one.shown(one.value),
            one.shown(one.finer),
            f"{in_per_cent(one.moved)}{' of its limit' if one.is_of_limit else ''}",
        )
        for one in refinement.told
    ]
    head = ("Numerical error", "", "as run", "finer", "differs by")
    lines = table(head, rows, "llrrl") if rows else [head[0]]
    return [*lines, *(f"  {sentence}" for sentence in refinement.sentences())]
