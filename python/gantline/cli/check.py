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
    from gantline.cli.summary import heading, show, weights
    from gantline.cli.table import table
    from gantline.results.rig import Rig

    rig = Rig.from_json(simulation.assembly.rig)
    document = simulation.assembly.document
    kinds = [
        (
            name,
            kind.construction or "-",
            "inextensible" if kind.stiffness is None else show(kind.stiffness, "MN", 1),
            show(kind.mass_per_length, "kg/m", 2),
            show(kind.breaking_force, "kN", 0),
        )
        for name, kind in (simulation.scenario.ropes or {}).items()
    ]
    head = ("Kind of rope", "construction", "EA", "mass", "minimum breaking force")
    ropes = table(head, kinds, "llrrr") if kinds else []
    typer.echo("\n".join([*heading(rig), *weights(rig), *ropes]))
    counts = ", ".join(
        f"{len(document[key])} {key}" for key in ("bodies", "ropes", "contacts") if document.get(key)
    )
    typer.echo(f"{simulation.scenario.source}: in order ({counts}; {simulation.duration:g} s to simulate)")
