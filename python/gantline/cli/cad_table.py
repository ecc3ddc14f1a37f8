"""What was read from CAD, as a table for people and as JSON for programs."""

from __future__ import annotations

import json
import textwrap
from typing import Any

import numpy as np

from gantline.cad import CadModel, Part
from gantline.cad.doubts import doubts_of_parts, doubts_of_the_whole
from gantline.cli.table import ABSENT, table
from gantline.units import format_quantity

__all__ = ["cad_json", "cad_table"]


def cad_table(model: CadModel, width: int, *, list_parts: bool = False) -> list[str]:
    """Lines that tell what was read.

    Args:
        model: what was read.
        width: columns that a line may have.
        list_parts: whether every part has a line.
    """
    count = f"{len(model.parts)} part{'s' * (len(model.parts) != 1)}"
    lines = [model.name, f"{model.form}; {count}; lengths in {model.unit}", ""]
    lines += [*_kinds(model), "", *_whole(model), ""]
    if list_parts:
        lines += [*_parts(model), ""]
    doubts = _doubts(model)
    lines.append("Doubts" if doubts else "No doubts.")
    for doubt in doubts:
        lines += textwrap.wrap(
            doubt, max(width, 60), initial_indent="  ", subsequent_indent="    ", break_on_hyphens=False
        )
    return [*lines, ""]


def _mass(value: float | None) -> str:
    return ABSENT if value is None else format_quantity(value, "kg", 1)


def _share(computed: float | None, declared: float | None) -> str:
    if computed is None or not declared:
        return ABSENT
    return f"{round(100.0 * (computed - declared) / declared, 2) + 0.0:+.2f} %"  # no -0.00


def _masses(part: Part) -> tuple[float | None, float | None]:
    """Computed and declared mass of a part."""
    return (
        None if part.properties is None else part.properties.mass,
        None if part.declared is None else part.declared.mass,
    )


def _kinds(model: CadModel) -> list[str]:
    """A line for each kind, and one for all."""
    head = ("Kind", "parts", "computed", "declared", "difference", "worst part", "computed", "declared")
    rows = []
    for name, kind in [*((kind.value, kind) for kind, _ in model.kinds), ("all", None)]:
        parts = model.parts if kind is None else model.of_kind(kind)
        computed = [mass for part in parts if (mass := _masses(part)[0]) is not None]
        declared = [mass for part in parts if (mass := _masses(part)[1]) is not None]
        both = model.compared(kind)
        worst = both.worst
        pairs = sum(None not in _masses(part) for part in parts)
        of_some = f" of {pairs}" if both.declared and pairs < max(len(computed), len(declared)) else ""
        pair = (None, None) if worst is None else _masses(worst)
        rows.append(
            (
                name,
                str(len(parts)),
                _mass(sum(computed) if computed else None),
                _mass(sum(declared) if declared else None),
                f"{_share(both.computed, both.declared)}{of_some}",
                ABSENT if worst is None else worst.name or "(no name)",
                _mass(pair[0]),
                _mass(pair[1]),
            )
        )
    return table(head, rows, "lrrrrlrr")


def _whole(model: CadModel) -> list[str]:
    body = model.properties
    low, high = model.box if len(model.mesh.triangles) else np.full((2, 3), np.nan)
    rows = [
        ("Mass", format_quantity(body.mass, "t", 3), ""),
        ("Centre of gravity", *_three(body.centre)),
        ("Box from", *_three(low)),
        ("Box to", *_three(high)),
        ("Box size", *_three(high - low)),
        ("Radii of gyration", *_three(np.sqrt(np.diag(body.inertia) / body.mass))),
    ]
    declared = _declared_centre(model)
    if declared is not None:
        away = float(np.linalg.norm(declared - body.centre))
        rows.insert(2, ("  by declared weights", *_three(declared), f"{1e3 * away:.1f} mm away"))
    lines = []
    for name, *cells in rows:
        lines.append(f"{name:<22}{'  '.join(f'{cell:>14}' for cell in cells if cell)}")
    inertia = body.inertia / 1000.0
    for row, axis in enumerate("xyz"):
        title = "Inertia [t m²]" if row == 0 else ""
        lines.append(
            f"{title:<20}{axis} " + "  ".join(f"{round(value, 3) + 0.0:>14.3f}" for value in inertia[row])
        )
    return [line.rstrip() for line in lines]


def _three(values: Any) -> tuple[str, str, str]:
    """Three lengths [m] as cells."""
    # Adding zero leaves no minus before a zero.
    x, y, z = (ABSENT if not np.isfinite(value) else f"{round(value, 4) + 0.0:.4f} m" for value in values)
    return x, y, z


def _declared_centre(model: CadModel) -> Any:
    """Centre of gravity by declared weights (3,); None if not all parts declare theirs."""
    declared = [part.declared for part in model.parts]
    if not all(each is not None and each.centre is not None for each in declared):
        return None
    masses = np.array([each.mass for each in declared if each is not None])
    centres = np.array([each.centre for each in declared if each is not None])
    return masses @ centres / masses.sum() if masses.sum() > 0 else None


def _parts(model: CadModel) -> list[str]:
    head = ("Part", "kind", "of", "size", "material", "computed", "declared", "difference", "x", "y", "z")
    rows = []
    for part in model.parts:
        body = part.counted
        place = (ABSENT,) * 3 if body is None else tuple(f"{value:.3f} m" for value in body.centre)
        computed, declared = _masses(part)
        rows.append(
            (
                part.name or "(no name)",
                part.kind.value,
                part.group or ABSENT,
                part.size or ABSENT,
                part.material or ABSENT,
                _mass(computed),
                _mass(declared),
                _share(computed, declared),
                *place,
            )
        )
    return table(head, rows, "lllllrrrrrr")


def _doubts(model: CadModel) -> list[str]:
    whole = [f"{doubt[:1].upper()}{doubt[1:]}." for doubt in doubts_of_the_whole(model)]
    return [*whole, *(f"{doubt}." for doubt in doubts_of_parts(model))]


def cad_json(model: CadModel) -> str:
    """All that was read as a JSON document, SI units."""
    body = model.properties
    both = model.compared()
    document = {
        "name": model.name,
        "form": model.form,
        "unit": model.unit,
        "mass": body.mass,
        "centre_of_gravity": body.centre.tolist(),
        "inertia": body.inertia.tolist(),
        "box": model.box.tolist() if len(model.mesh.triangles) else None,
        "declared_mass": sum(part.declared.mass for part in model.parts if part.declared is not None),
        "difference": both.difference,
        "worst_part": None if both.worst is None else both.worst.name,
        "kinds": {
            kind.value: {
                "parts": len(parts),
                "computed_mass": model.compared(kind).computed,
                "declared_mass": model.compared(kind).declared,
            }
            for kind, parts in model.kinds
        },
        "doubts": _doubts(model),
        "parts": [_part(part) for part in model.parts],
    }
    return json.dumps(document, indent=2, allow_nan=False, ensure_ascii=False)


def _part(part: Part) -> dict[str, Any]:
    own, declared = part.properties, part.declared
    return {
        "name": part.name,
        "kind": part.kind.value,
        "group": part.group,
        "material": part.material,
        "size": part.size,
        "mass": None if own is None else own.mass,
        "centre_of_gravity": None if own is None else own.centre.tolist(),
        "inertia": None if own is None else own.inertia.tolist(),
        "declared_mass": None if declared is None else declared.mass,
        "declared_centre_of_gravity": None
        if declared is None or declared.centre is None
        else declared.centre.tolist(),
        "doubts": list(part.doubts),
    }
