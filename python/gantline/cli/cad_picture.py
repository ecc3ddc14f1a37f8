"""The picture of a model from CAD."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from gantline.cad import CadModel, PartKind
from gantline.plot.model import Piece, model_figure
from gantline.units import format_quantity

__all__ = ["model_picture"]


def model_picture(model: CadModel) -> Figure | None:
    """Draw a model, a colour for each kind of part; None if no part has geometry."""
    numbers = {id(part): number for number, part in enumerate(model.parts)}
    pieces = []
    for kind, parts in model.kinds:
        drawn = [part for part in parts if len(part.mesh.triangles)]
        if not drawn:
            continue
        mass = sum(body.mass for part in parts if (body := part.counted) is not None)
        pieces.append(
            Piece(
                label=f"{len(parts)} {_plural(kind, len(parts))}, {format_quantity(mass, 't', 2)}",
                corners=np.concatenate([part.mesh.corners for part in drawn]),
                part=np.concatenate(
                    [np.full(len(part.mesh.triangles), numbers[id(part)], dtype=float) for part in drawn]
                ),
                tone=list(PartKind).index(kind),
                is_skin=kind in (PartKind.PLATE, PartKind.SHELL),
            )
        )
    if not pieces:
        return None
    body = model.properties
    x, y, z = body.centre.round(3) + 0.0
    whole = format_quantity(body.mass, "t", 2)
    subtitle = f"{model.form}: {whole}, centre of gravity {x:.3f}, {y:.3f}, {z:.3f} m"
    return model_figure(model.name, subtitle, pieces, body.centre)


def _plural(kind: str, count: int) -> str:
    """A kind of part as it is called where there are so many."""
    return str(kind) if count == 1 else f"{kind}s"
