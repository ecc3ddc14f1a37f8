"""Tables of `gantline hydro`."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from gantline.cli.table import table

if TYPE_CHECKING:
    from gantline.hydro import Hull, Hydrostatics, RightingArms

_HEAD = ("Draft", "Mass", "Volume", "LCB", "KB", "BM", "KM", "BM_L", "KM_L", "Waterplane", "LCF", "Wetted")
_UNITS = ("[m]", "[t]", "[m³]", "[m]", "[m]", "[m]", "[m]", "[m]", "[m]", "[m²]", "[m]", "[m²]")


def report(
    hull: Hull, rows: list[Hydrostatics], arms: list[tuple[Hydrostatics, RightingArms]], kg: float | None
) -> list[str]:
    """Lines of the whole report.

    Args:
        hull: The hull.
        rows: Its hydrostatics at each draft.
        arms: Righting arms at some of them.
        kg: Centre of gravity above the hull's z = 0 [m]; None shows no GM.
    """
    low, high = hull.box
    size = " × ".join(f"{side:.6g}" for side in high - low)
    state = "closed" if hull.closure.is_closed else "not closed"
    trim = rows[0].attitude.trim
    lies = (
        "even keel"
        if trim == 0
        else f"trim {abs(math.degrees(trim)):.4g}° by the {'stern' if trim > 0 else 'bow'}"
    )
    lines = [
        f"{hull.name}: {size} m, x {low[0]:.6g} to {high[0]:.6g}, z {low[2]:.6g} to {high[2]:.6g}; "
        f"{state} mesh of {len(hull.mesh[1])} triangles",
        f"{lies}; water of {rows[0].density / 1e3:.4g} t/m³; heights above z = 0, places along x",
        "",
        *_hydrostatics(rows, kg),
    ]
    if arms:
        lines += ["", *_righting(arms)]
    return lines


def _hydrostatics(rows: list[Hydrostatics], kg: float | None) -> list[str]:
    extra = [("GM", "GM_L"), ("[m]", "[m]")] if kg is not None else [(), ()]
    cells: list[tuple[str, ...]] = [(*_UNITS, *extra[1])]
    for row in rows:
        gm = [f"{value:.3f}" for value in row.gm(row.centre_of_gravity_at(kg))] if kg is not None else []
        cells.append(
            (
                f"{row.attitude.draft:.3f}",
                _large(row.mass / 1e3),
                _large(row.volume),
                f"{row.lcb:.3f}",
                f"{row.kb:.3f}",
                f"{row.bm_transverse:.3f}",
                f"{row.km_transverse:.3f}",
                f"{row.bm_longitudinal:.2f}",
                f"{row.km_longitudinal:.2f}",
                _large(row.waterplane_area),
                f"{row.lcf:.3f}",
                _large(row.wetted_surface),
                *gm,
            )
        )
    title = "Hydrostatics" if kg is None else f"Hydrostatics, KG {kg:.4g} m"
    return [title, *table((*_HEAD, *extra[0]), cells, "r" * len(cells[0]))]


def _righting(arms: list[tuple[Hydrostatics, RightingArms]]) -> list[str]:
    heads = tuple(f"{row.attitude.draft:.3f} m" for row, _ in arms)
    cells = []
    for index, angle in enumerate(arms[0][1].heel):
        values = [round(float(curve.arm[index]), 3) + 0.0 for _, curve in arms]  # + 0.0: zero has no sign
        cells.append((f"{math.degrees(angle):.1f}", *(f"{value:.3f}" for value in values)))
    title = "Righting arms [m] over heel [deg], free to trim, at the displacement of each draft"
    return [title, *table(("Heel", *heads), cells, "r" * (1 + len(arms)))]


def _large(value: float) -> str:
    """Four digits at least, and no more decimals than a hull is known by."""
    digits = 1 if abs(value) >= 1000 else 2 if abs(value) >= 10 else 4
    return f"{value:.{digits}f}"
