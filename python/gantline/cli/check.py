"""`gantline check`: is this lift file right, and what does it describe?"""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from gantline.cli.messages import scenario_errors


def check(
    lift: Annotated[
        Path,
        typer.Argument(
            metavar="LIFT", help="Lift file, its folder, or the name of a lift that comes with gantline."
        ),
    ],
) -> None:
    """Check a lift file without simulating it; nothing is written."""
    with scenario_errors():
        from gantline.simulation import Simulation

        simulation = Simulation(lift)
    from gantline.cli.summary import heading, weights
    from gantline.results.rig import Rig

    rig = Rig.from_json(simulation.assembly.rig)
    document = simulation.assembly.document
    typer.echo("\n".join([*heading(rig), *weights(rig)]))
    counts = ", ".join(
        f"{len(document[key])} {key}" for key in ("bodies", "ropes", "contacts") if document.get(key)
    )
    typer.echo(f"{simulation.scenario.source}: in order ({counts}; {simulation.duration:g} s to simulate)")
