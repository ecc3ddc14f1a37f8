"""Hulls from files of triangles: STL, as text or binary, and OBJ; a further ending .gz is unpacked."""

from __future__ import annotations

import gzip
import re
from pathlib import Path

import numpy as np
import numpy.typing as npt

from gantline.hydro.hull import Hull
from gantline.hydro.shapes import box_hull
from gantline.units import DIMENSIONS, UnitError, quantity

__all__ = ["HullError", "read_hull"]

Array = npt.NDArray[np.float64]
Whole = npt.NDArray[np.int64]

_BINARY = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


class HullError(ValueError):
    """A hull that cannot be read; the message says what is wrong."""


def read_hull(given: str | Path, unit: str = "m") -> Hull:
    """A hull from a file, or `box:100m,30m,8m` for a box of that length, breadth and depth.

    Args:
        given: STL or OBJ file, perhaps with .gz behind it, or a box.
        unit: unit of length in the file.

    Raises:
        HullError: if there is no such file, or it holds no hull.
    """
    text = str(given)
    try:
        if unit not in DIMENSIONS["length"]:
            raise HullError(f"'{unit}' is no unit of length; there are {', '.join(DIMENSIONS['length'])}")
        if text.startswith("box:"):
            return _box(text)
        path = Path(given)
        vertices, triangles = _triangles(path)
        return Hull(path.name, vertices * DIMENSIONS["length"][unit], triangles)
    except HullError:
        raise
    except ValueError as problem:
        raise HullError(f"{text}: {problem}") from None


def _box(text: str) -> Hull:
    parts = text.removeprefix("box:").split(",")
    if len(parts) != 3:
        raise HullError(f"'{text}' is no box; it would be right as box:100m,30m,8m: length, breadth, depth")
    try:
        return box_hull([quantity(part.strip(), "length") for part in parts], text)
    except UnitError as problem:
        raise HullError(f"'{text}': {problem}") from None


def _triangles(path: Path) -> tuple[Array, Whole]:
    packed = path.suffix.lower() == ".gz"
    suffix = (path.with_suffix("") if packed else path).suffix.lower()
    if suffix not in (".stl", ".obj"):
        raise HullError(f"{path}: a hull comes from an STL or OBJ file, not from '{suffix or path.name}'")
    try:
        data = path.read_bytes()
        if packed:
            data = gzip.decompress(data)
    except OSError as problem:
        raise HullError(f"{path}: it cannot be read: {problem.strerror or problem}") from None
    found = _obj(path, data) if suffix == ".obj" else _stl(path, data)
    if not len(found[1]):
        raise HullError(f"{path}: there are no triangles in it")
    return found


def _stl(path: Path, data: bytes) -> tuple[Array, Whole]:
    count = int.from_bytes(data[80:84], "little") if len(data) >= 84 else -1
    if len(data) == 84 + 50 * count:
        corners = np.frombuffer(data, dtype=_BINARY, offset=84)["corners"].astype(float)
    elif data[:512].lstrip().lower().startswith(b"solid"):
        numbers = re.findall(rb"vertex\s+(\S+)\s+(\S+)\s+(\S+)", data)
        if len(numbers) % 3:
            raise HullError(f"{path}: a triangle in it has no three corners; is it complete?")
        corners = np.array(numbers, dtype=float).reshape(-1, 3, 3)
    else:
        raise HullError(f"{path}: this is no STL file, or only a part of one")
    return corners.reshape(-1, 3), np.arange(3 * len(corners), dtype=np.int64).reshape(-1, 3)


def _obj(path: Path, data: bytes) -> tuple[Array, Whole]:
    vertices: list[list[float]] = []
    triangles: list[list[int]] = []
    for number, line in enumerate(data.decode("utf-8", errors="replace").splitlines(), 1):
        words = line.split()
        if not words:
            continue
        try:
            if words[0] == "v":
                vertices.append([float(word) for word in words[1:4]])
            elif words[0] == "f":
                # 7, 7/1 and 7/1/3 name vertex 7; negative numbers count back from the last.
                named = [int(word.partition("/")[0]) for word in words[1:]]
                corners = [index - 1 if index > 0 else len(vertices) + index for index in named]
                triangles += [[corners[0], corners[k], corners[k + 1]] for k in range(1, len(corners) - 1)]
        except ValueError:
            raise HullError(f"{path}:{number}: '{line.strip()}' is no line of an OBJ file") from None
    return np.array(vertices, dtype=float).reshape(-1, 3), np.array(triangles, dtype=np.int64).reshape(-1, 3)
