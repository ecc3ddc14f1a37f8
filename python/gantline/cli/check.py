"""`gantline check`: is this lift file right, and what does it describe?"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gantline.cli.messages import scenario_errors

if TYPE_CHECKING:
    from gantline.results.rig import Rig


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
    typer.echo("\n".join([*heading(rig), *weights(rig), *ropes, *_rope_weights(rig), *_sheaves(rig)]))
    nodes = sum(rope.nodes for rope in rig.ropes)
    numbers = {
        "bodies": len(document["bodies"]) - nodes - len(rig.sheaves) - len(rig.drums),
        "ropes": len(rig.ropes),
        "nodes of ropes": nodes,
        "drums": len(rig.drums),
        "contacts": len(document["contacts"]),
    }
    counts = ", ".join(f"{number} {what}" for what, number in numbers.items() if number)
    typer.echo(f"{simulation.scenario.source}: in order ({counts}; {simulation.duration:g} s to simulate)")


def _rope_weights(rig: Rig) -> list[str]:
    """How the weight of each rope acts, for those that have one."""
    from gantline.cli.summary import show
    from gantline.cli.table import table

    rows = [
        (rope.name, rope.weight, show(rope.mass, "kg", 1), show(rope.mass_on_world or None, "kg", 1))
        for rope in rig.ropes
        if rope.mass > 0.0
    ]
    return table(("Rope", "weight", "mass", "on the world"), rows, "llrr") if rows else []


def _sheaves(rig: Rig) -> list[str]:
    """Losses and inertia of each sheave that is not ideal."""
    from gantline.cli.summary import show
    from gantline.cli.table import table

    head = ("Sheave", "rope", "turns at a ratio of", "groove friction", "moves with the rope", "")

    def turns_at(ratio: float | None) -> str:
        return "never" if ratio is None else f"{ratio:.4f}" if ratio > 1.0 else "-"

    rows = [
        (
            sheave.name,
            sheave.rope,
            turns_at(sheave.ratio),
            "-" if sheave.groove_friction is None else f"{sheave.groove_friction:g}",
            show(sheave.inertia, "kg", 1),
            sheave.inertia_from,
        )
        for sheave in rig.sheaves
    ]
    return table(head, rows, "llrrrl") if rows else []
