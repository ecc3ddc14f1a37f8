"""STL and OBJ: formats so plain that the base install reads them, for loads and for hulls alike."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from gantline.cad.mesh import TriangleMesh
from gantline.cad.ocx.triangulate import triangulated

__all__ = ["TooManyTrianglesError", "read_obj", "read_stl"]

_BINARY = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
_HEAD = 84
#: Corners of a polygon that is not convex, above which it is cut as if it were.
_MOST_CORNERS = 500
#: How far corners of a polygon may lie off its plane, as a share of its size. Of a skew one no cut is more
#: right than another for what is enclosed, and other programs make fans.
_FLAT = 1e-5
#: One decimal number as text files have it.
_VERTEX = re.compile(rb"vertex\s+(\S+)\s+(\S+)\s+(\S+)", re.IGNORECASE)


class TooManyTrianglesError(ValueError):
    """A file announces or holds more triangles than are read."""


def read_stl(data: bytes, most: int) -> TriangleMesh:
    """The triangles of an STL file, text or binary; nothing is welded.

    Args:
        data: the file.
        most: triangles that are read at most.

    Raises:
        TooManyTrianglesError: if there are more.
        ValueError: if it is no STL file, or a part of one; the sentence says what is wrong.
    """
    count = int.from_bytes(data[_HEAD - 4 : _HEAD], "little") if len(data) >= _HEAD else 0
    is_text = data[:512].lstrip()[:5].lower() == b"solid" and len(data) != _HEAD + _BINARY.itemsize * count
    if is_text:
        return _soup(_text_corners(data), most)
    if len(data) < _HEAD or len(data) < _HEAD + _BINARY.itemsize * count:
        held = max(len(data) - _HEAD, 0) // _BINARY.itemsize
        raise ValueError(f"it is no STL file, or cut off: {count} triangles are announced, {held} are there")
    if count > most:
        raise TooManyTrianglesError
    if len(data) >= _HEAD + _BINARY.itemsize * (count + 1):
        held = (len(data) - _HEAD) // _BINARY.itemsize
        raise ValueError(
            f"it is a broken STL file: {count} triangles are announced, but there are bytes of {held}; "
            "export it anew, into a file of its own"
        )
    with np.errstate(invalid="ignore"):  # what is no number is refused with the mesh
        corners = np.frombuffer(data, _BINARY, count, _HEAD)["corners"].astype(float)
    return _soup(corners, most)


def _text_corners(data: bytes) -> npt.NDArray[np.float64]:
    if b"endsolid" not in data[-2000:].lower():
        raise ValueError("the STL file is cut off: it does not end on 'endsolid'")
    numbers = _VERTEX.findall(data)
    if len(numbers) % 3:
        raise ValueError("it is a broken STL file: a triangle in it has no three corners")
    try:
        return np.array(numbers, dtype=float).reshape(-1, 3, 3)
    except ValueError:
        raise ValueError("it is a broken STL file: a corner in it is no three numbers") from None


def _soup(corners: npt.NDArray[np.float64], most: int) -> TriangleMesh:
    if len(corners) > most:
        raise TooManyTrianglesError
    return TriangleMesh(corners.reshape(-1, 3), np.arange(3 * len(corners)).reshape(-1, 3))


def read_obj(data: bytes, most: int) -> dict[str, TriangleMesh]:
    """The objects of an OBJ file by name, polygons cut into triangles; the name is empty before the first.

    Args:
        data: the file.
        most: triangles that are read at most.

    Raises:
        TooManyTrianglesError: if there are more.
        ValueError: if a line of it is broken; the sentence says which.
    """
    vertices: list[list[float]] = []
    objects: dict[str, list[list[int]]] = {}
    polygons = objects.setdefault("", [])
    count = 0
    last, named_by = -1, 0  # the highest vertex that a face names, from 0 on, and the line that does
    for number, line in enumerate(_lines(data), 1):
        words = line.split()
        if not words:
            continue
        try:
            if words[0] == "v":
                x, y, z = map(float, words[1:4])
                vertices.append([x, y, z])
            elif words[0] == "f":
                corners = [_vertex(word, len(vertices)) for word in words[1:]]
                if len(corners) < 3:
                    raise ValueError("a face has three corners or more")
                polygons.append(corners)
                count += len(corners) - 2
                if max(corners) > last:
                    last, named_by = max(corners), number
                if count > most:
                    raise TooManyTrianglesError
            elif words[0] == "o":
                polygons = objects.setdefault(" ".join(words[1:]), [])
        except TooManyTrianglesError:
            raise
        except ValueError:
            raise ValueError(
                f"it is no OBJ file, or a broken one: line {number}, '{line.strip()[:60]}'"
            ) from None
    if last >= len(vertices):
        raise ValueError(
            f"it is no OBJ file, or a broken one: line {named_by} names vertex {last + 1}, "
            f"but the file has only {len(vertices)}"
        )
    places = np.array(vertices, dtype=float).reshape(-1, 3)
    return {name: _object(places, [*_cut(places, faces)]) for name, faces in objects.items() if faces}


def _lines(data: bytes) -> list[str]:
    """Lines of a text file, whichever way they end."""
    text = data.decode("utf-8-sig", errors="replace")
    return text.replace("\r\n", "\n").replace("\r", "\n").split("\n")


def _vertex(word: str, count: int) -> int:
    """The vertex that 7, 7/1 or 7/1/3 names, from 0 on; negative numbers count back from the last."""
    index = int(word.partition("/")[0])
    if index == 0 or index < -count:
        raise ValueError(f"there is no vertex {index}")
    return index - 1 if index > 0 else count + index


def _cut(vertices: npt.NDArray[np.float64], polygons: list[list[int]]) -> Iterator[tuple[int, int, int]]:
    """Triangles of polygons: a fan about the first corner; where that leaves a flat polygon, its ears."""
    hollow = _not_convex(vertices, polygons)
    for place, corners in enumerate(polygons):
        fan = [(corners[0], *pair) for pair in pairwise(corners[1:])]
        if place in hollow and len(corners) <= _MOST_CORNERS:
            ears = _ears(vertices[corners])
            # Fewer, as of a skew one, would leave out a corner, and open an edge to the next face.
            if len(ears) == len(fan):
                fan = [(corners[a], corners[b], corners[c]) for a, b, c in ears]
        yield from fan


def _not_convex(vertices: npt.NDArray[np.float64], polygons: list[list[int]]) -> set[int]:
    """Which polygons have a corner that turns against the sense in which the whole runs round."""
    by_size: dict[int, list[int]] = {}
    for place, corners in enumerate(polygons):
        if len(corners) > 3:
            by_size.setdefault(len(corners), []).append(place)
    found: set[int] = set()
    for places in by_size.values():
        with np.errstate(over="ignore", invalid="ignore"):  # what is no number is refused with the mesh
            points = vertices[[polygons[place] for place in places]]
            sides = np.roll(points, -1, axis=1) - points
            turns = np.cross(sides, np.roll(sides, -1, axis=1))
            whole = np.cross(points[:, 1:-1] - points[:, :1], points[:, 2:] - points[:, :1]).sum(axis=1)
            against = (
                np.einsum("mni,mi->mn", turns, whole) < -1e-9 * np.einsum("mi,mi->m", whole, whole)[:, None]
            )
        found.update(places[which] for which in np.flatnonzero(against.any(axis=1)))
    return found


def _ears(points: npt.NDArray[np.float64]) -> list[tuple[int, int, int]]:
    """Triangles of a flat polygon (n, 3) seen along the axis that it faces most, in its own sense."""
    whole = np.cross(points[1:-1] - points[0], points[2:] - points[0]).sum(axis=0)
    off = np.abs((points - points.mean(axis=0)) @ whole).max() / np.linalg.norm(whole)
    if off > _FLAT * np.linalg.norm(np.ptp(points, axis=0)):
        return []
    axis = int(np.argmax(np.abs(whole)))
    flat = [(axis + 1) % 3, (axis + 2) % 3]
    return [
        (int(a), int(b), int(c))
        for a, b, c in triangulated(points[:, flat[:: 1 if whole[axis] > 0 else -1]])[1]
    ]


def _object(vertices: npt.NDArray[np.float64], faces: list[tuple[int, int, int]]) -> TriangleMesh:
    try:
        mesh = TriangleMesh(vertices, faces)
    except ValueError as problem:
        raise ValueError(f"it is no OBJ file, or a broken one: {problem}") from None
    return mesh.of(np.arange(len(faces)))
