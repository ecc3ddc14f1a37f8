"""Text databases `.hyd`: lines of a key and numbers in columns of ten characters, tonnes and kilonewtons.

They say neither density nor the sign of their phases; so the wave forces (`FAMP`, `FEPS`) are not read.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import numpy.typing as npt

from gantline.hydro.database.model import DatabaseError, HydrodynamicDatabase

__all__ = ["read_text"]

_COLUMN = 10
_TONNES = 1000.0


def read_text(path: Path) -> list[HydrodynamicDatabase]:
    """The body of a file.

    Raises:
        DatabaseError: If it is no such file, or something that it needs is not in it.
    """
    text = path.read_bytes().decode("utf-8", errors="replace")
    tables_at: list[tuple[float, dict[str, list[list[float]]]]] = []
    announced = None
    reference: npt.NDArray[np.float64] | None = None
    for number, line in enumerate(text.splitlines(), 1):
        key = line[:_COLUMN].strip()
        if key == "PARA":
            announced = int(_columns(path, number, line, 1)[0])
        elif key == "REFS":
            reference = np.array(_columns(path, number, line, 3)[:3])
        elif key == "OMEGA":
            tables_at.append((_columns(path, number, line, 1)[0], {"ADMAS": [], "BDAMP": []}))
        elif key in ("ADMAS", "BDAMP"):
            if not tables_at:
                raise DatabaseError(f"{path}:{number}: '{key}' stands before the first 'OMEGA'")
            tables_at[-1][1][key].append(_columns(path, number, line, 6)[:6])
    if not tables_at:
        raise DatabaseError(f"{path}: there is no line 'OMEGA' in it, as .hyd files have")
    if announced is not None and announced != len(tables_at):
        raise DatabaseError(
            f"{path}: is cut off: {announced} frequencies are announced, {len(tables_at)} are there"
        )
    for omega, tables in tables_at:
        for key, rows in tables.items():
            if len(rows) != 6:
                raise DatabaseError(
                    f"{path}: at {omega:g} rad/s '{key}' has {len(rows)} rows; six are needed"
                )
    tables_at.sort(key=lambda one: one[0])
    mass, damping = (np.array([tables[key] for _, tables in tables_at]) for key in ("ADMAS", "BDAMP"))
    return [
        HydrodynamicDatabase(
            name=path.stem,
            source=f"{path.name} (text)",
            frequencies=np.array([omega for omega, _ in tables_at]),
            added_mass=mass * _TONNES,
            damping=damping * _TONNES,
            reference=reference,
        )
    ]


def _columns(path: Path, number: int, line: str, least: int) -> list[float]:
    """Numbers of a line; columns may touch."""
    rest = line.rstrip()[_COLUMN:]
    words = [rest[start : start + _COLUMN] for start in range(0, len(rest), _COLUMN)]
    try:
        values = [float(word) for word in words if word.strip()]
    except ValueError:
        raise DatabaseError(
            f"{path}:{number}: '{line.strip()[:60]}' has a column that is no number"
        ) from None
    if len(values) < least:
        raise DatabaseError(f"{path}:{number}: {least} columns are needed, {len(values)} are there")
    return values
