"""STL and OBJ: formats so plain that the base install reads them, for loads and for hulls alike."""

from __future__ import annotations

import re
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from gantline.cad.mesh import TriangleMesh

__all__ = ["TooManyTrianglesError", "read_obj", "read_stl"]

_BINARY = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
_HEAD = 84
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
    return _soup(np.frombuffer(data, _BINARY, count, _HEAD)["corners"].astype(float), most)


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
    objects: dict[str, list[tuple[int, int, int]]] = {}
    triangles = objects.setdefault("", [])
    count = 0
    last, named_by = -1, 0  # the highest vertex that a face names, from 0 on, and the line that does
    for number, line in enumerate(data.decode("utf-8", errors="replace").split("\n"), 1):
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
                triangles += [(corners[0], *pair) for pair in pairwise(corners[1:])]
                count += len(corners) - 2
                if max(corners) > last:
                    last, named_by = max(corners), number
                if count > most:
                    raise TooManyTrianglesError
            elif words[0] == "o":
                triangles = objects.setdefault(" ".join(words[1:]), [])
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
    return {name: _object(vertices, faces) for name, faces in objects.items() if faces}


def _vertex(word: str, count: int) -> int:
    """The vertex that 7, 7/1 or 7/1/3 names, from 0 on; negative numbers count back from the last."""
    index = int(word.partition("/")[0])
    if index == 0 or index < -count:
        raise ValueError(f"there is no vertex {index}")
    return index - 1 if index > 0 else count + index


def _object(vertices: list[list[float]], faces: list[tuple[int, int, int]]) -> TriangleMesh:
    try:
        mesh = TriangleMesh(vertices, faces)
    except ValueError as problem:
        raise ValueError(f"it is no OBJ file, or a broken one: {problem}") from None
    return mesh.of(np.arange(len(faces)))
