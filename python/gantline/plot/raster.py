"""Triangles as an image: shaded, front before back, edges drawn, skins half transparent.

Each triangle becomes runs of pixels, a run a row, and the nearest at each pixel is kept (a depth buffer),
all by arrays. Skins are peeled off layer by layer.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gantline.results.variable import FloatArray

__all__ = ["View", "rendered"]

Whole = npt.NDArray[np.int64]

_FINER = 2  # pixels of the buffer per pixel of the image, along each side
_BATCH = 1 << 21  # pixels at a time
_BITS = 32  # of a number that tells depth and triangle, those for the triangle
_DEPTHS = float(1 << 30)  # steps of depth, from the farthest to the nearest
_STEP = 0.03  # of the whole depth, from which a jump is an edge
_LAYERS = 3  # of skins that are seen through one another
_OPACITY = 0.45  # of a skin
# Where the light comes from: to the right, up, towards the viewer.
_LIGHT = np.array([-0.45, 0.55, 0.7]) / np.linalg.norm([-0.45, 0.55, 0.7])
_EDGE = 0.52  # brightness of pixels at an edge
_MARGIN = 0.04


@dataclass(frozen=True)
class View:
    """Directions in the world that are right, up and towards the viewer on paper, unit vectors."""

    right: FloatArray
    up: FloatArray
    toward: FloatArray

    @classmethod
    def along(cls, toward: FloatArray) -> View:
        """Seen from a direction, z up; y up where that direction is z."""
        toward = toward / np.linalg.norm(toward)
        above = np.array([0.0, 1.0, 0.0]) if abs(toward[2]) > 0.99 else np.array([0.0, 0.0, 1.0])
        right = np.cross(above, toward)
        right = right / np.linalg.norm(right)
        return cls(right, np.cross(toward, right), toward)

    def project(self, points: FloatArray) -> FloatArray:
        """Points on paper [m], shape (..., 2), of points in space, shape (..., 3)."""
        return np.stack([points @ self.right, points @ self.up], axis=-1)

    @property
    def axis(self) -> int:
        """World axis that a side view has to the right: 0 for x, 1 for y."""
        return int(np.argmax(np.abs(self.right[:2])))


@dataclass(frozen=True, eq=False)
class _Spans:
    """Runs of pixels: triangle, first pixel, how many, depth at the first, its change per pixel."""

    triangle: Whole
    begin: Whole
    length: Whole
    depth: FloatArray
    slope: FloatArray


@dataclass(frozen=True, eq=False)
class _Layer:
    """What is nearest at each pixel: depth, 0 far to 1 near, and which triangle, −1 for none."""

    depth: FloatArray
    which: Whole


def rendered(
    corners: Sequence[FloatArray],
    parts: Sequence[FloatArray],
    colours: FloatArray,
    skins: Sequence[bool],
    view: View,
    size: tuple[int, int],
) -> tuple[FloatArray, tuple[float, float, float, float]]:
    """Draw groups of triangles.

    Args:
        corners: of each group (n, 3, 3) [m].
        parts: number of the part of each triangle, of each group (n,); edges are drawn between parts.
        colours: of each group (groups, 3).
        skins: whether a group is half transparent.
        view: from where.
        size: of the image, width and height [pixel].

    Returns:
        the image (height, width, 4) with transparency, and its place on paper: left, right, bottom, top [m].
    """
    triangles = np.concatenate(list(corners))
    group = np.repeat(np.arange(len(corners)), [len(each) for each in corners])
    part = np.concatenate(list(parts)).astype(np.int64)
    width, height = size[0] * _FINER, size[1] * _FINER
    flat = view.project(triangles)
    low, high = flat.reshape(-1, 2).min(axis=0), flat.reshape(-1, 2).max(axis=0)
    scale = (1 - 2 * _MARGIN) * min(width / max(high[0] - low[0], 1e-9), height / max(high[1] - low[1], 1e-9))
    middle = (low + high) / 2
    pixels = (flat - middle) * scale + [width / 2, height / 2]
    depth = triangles @ view.toward
    depth = (depth - depth.min()) / max(float(np.ptp(depth)), 1e-9)
    is_skin = np.array(skins, dtype=bool)[group]
    normals = _normals(triangles, view)
    face = _faces(part, normals)
    light = np.stack([view.right, view.up, view.toward], axis=1) @ _LIGHT
    shade = (0.68 + 0.32 * np.clip(normals @ light, 0.0, 1.0))[:, None] * colours[group]

    def coloured(layer: _Layer) -> tuple[FloatArray, npt.NDArray[np.bool_]]:
        seen = layer.which >= 0
        image = np.ones((height, width, 3))
        image[seen] = shade[layer.which[seen]]
        image[_edges(layer, face)] *= _EDGE
        return image, seen

    shape = height, width
    solid = _nearest(_spans(pixels, depth, np.flatnonzero(~is_skin), shape), shape, None)
    image, seen = coloured(solid)
    skin_spans = _spans(pixels, depth, np.flatnonzero(is_skin), shape)
    for layer in reversed(_peeled(skin_spans, shape, part, _LAYERS)):
        front = (layer.which >= 0) & (layer.depth >= solid.depth)
        over, _ = coloured(layer)
        # A skin with nothing behind it hides what is no more than white paper.
        share = np.where(seen, _OPACITY, 1.0)[..., None]
        image = np.where(front[..., None], share * over + (1 - share) * image, image)
        seen = seen | front
    half = np.array([width, height]) / 2 / scale
    left, bottom = middle - half
    right, top = middle + half
    return _coarser(image, seen, size), (float(left), float(right), float(bottom), float(top))


def _normals(triangles: FloatArray, view: View) -> FloatArray:
    """Unit normals of triangles towards who looks, zero of those without area, shape (n, 3)."""
    normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    normals = np.divide(normals, lengths, out=np.zeros_like(normals), where=lengths > 0)
    towards: FloatArray = np.where((normals @ view.toward)[:, None] < 0, -normals, normals)
    return towards


def _coarser(image: FloatArray, seen: npt.NDArray[np.bool_], size: tuple[int, int]) -> FloatArray:
    """An image as means of its pixels, transparent where nothing is seen; the top row first."""
    both = np.concatenate([image, seen[..., None].astype(float)], axis=2)
    both[..., :3] *= both[..., 3:]
    small = both.reshape(size[1], _FINER, size[0], _FINER, 4).mean(axis=(1, 3))
    small[..., :3] = np.divide(
        small[..., :3], small[..., 3:], out=np.ones_like(small[..., :3]), where=small[..., 3:] > 0
    )
    clipped: FloatArray = np.clip(small[::-1], 0.0, 1.0)
    return clipped


def _peeled(spans: Iterable[_Spans], shape: tuple[int, int], part: Whole, count: int) -> list[_Layer]:
    """Skins from the front to the back; of the part that is in front the other faces are not seen."""
    layers: list[_Layer] = []
    kept = list(spans)
    while len(layers) < count and kept:
        layer = _nearest(kept, shape, (layers[-1], part) if layers else None)
        if not (layer.which >= 0).any():
            break
        layers.append(layer)
    return layers


def _nearest(spans: Iterable[_Spans], shape: tuple[int, int], before: tuple[_Layer, Whole] | None) -> _Layer:
    """Nearest triangle at each pixel, beyond a layer before and not of its part.

    Depth and triangle go into one number, depth first, so that the largest of all tells both.
    """
    best = np.full(shape[0] * shape[1], -1, dtype=np.int64)
    for each in spans:
        row = np.repeat(np.arange(len(each.begin)), each.length)
        along = np.arange(len(row)) - np.repeat(np.cumsum(each.length) - each.length, each.length)
        place = each.begin[row] + along
        depth = each.depth[row] + along * each.slope[row]
        triangle = each.triangle[row]
        if before is not None:
            layer, part = before
            front = layer.which.reshape(-1)[place]
            seen = (front >= 0) & (depth < layer.depth.reshape(-1)[place]) & (part[front] != part[triangle])
            place, depth, triangle = place[seen], depth[seen], triangle[seen]
        key = (np.clip(depth, 0.0, 1.0) * _DEPTHS).astype(np.int64) << _BITS
        np.maximum.at(best, place, key | triangle)
    seen = best >= 0
    depth = np.where(seen, (best >> _BITS) / _DEPTHS, -np.inf)
    which = np.where(seen, best & ((1 << _BITS) - 1), -1)
    return _Layer(depth.reshape(shape), which.reshape(shape))


def _spans(pixels: FloatArray, depth: FloatArray, chosen: Whole, shape: tuple[int, int]) -> Iterator[_Spans]:
    """Runs of pixels that triangles cover, row by row, in batches."""
    height, width = shape
    low = np.clip(np.ceil(pixels[chosen, :, 1].min(axis=1) - 0.5), 0, height).astype(np.int64)
    high = np.clip(np.ceil(pixels[chosen, :, 1].max(axis=1) - 0.5), 0, height).astype(np.int64)
    rows = high - low
    yield _slivers(pixels, depth, chosen[rows == 0], shape)
    total = np.cumsum(rows)
    for batch in np.split(np.arange(len(chosen)), np.flatnonzero(np.diff(total // _BATCH)) + 1):
        own = np.repeat(batch, rows[batch])
        if not len(own):
            continue
        count = rows[batch]
        y = low[own] + np.arange(len(own)) - np.repeat(np.cumsum(count) - count, count)
        yield from _runs(pixels[chosen[own]], depth[chosen[own]], chosen[own], y, width)


def _slivers(pixels: FloatArray, depth: FloatArray, triangle: Whole, shape: tuple[int, int]) -> _Spans:
    """Triangles that no row goes through, as lines along the nearest row."""
    height, width = shape
    x, y = pixels[triangle, :, 0], pixels[triangle, :, 1]
    row = np.clip(np.floor(y.mean(axis=1)), 0, height - 1).astype(np.int64)
    begin = np.clip(np.floor(x.min(axis=1)), 0, width - 1).astype(np.int64)
    end = np.clip(np.ceil(x.max(axis=1)), begin + 1, width).astype(np.int64)
    away = depth[triangle].mean(axis=1)
    return _Spans(triangle, row * width + begin, end - begin, away, np.zeros_like(away))


def _runs(corners: FloatArray, depth: FloatArray, triangle: Whole, y: Whole, width: int) -> Iterator[_Spans]:
    """The run of pixels of each triangle (n, 3, 2) in a row (n,)."""
    at = y + 0.5
    left, right = np.full(len(y), np.inf), np.full(len(y), -np.inf)
    for one, other in ((0, 1), (1, 2), (2, 0)):
        a, b = corners[:, one], corners[:, other]
        crosses = (a[:, 1] <= at) != (b[:, 1] <= at)
        rise = np.where(crosses, b[:, 1] - a[:, 1], 1.0)
        x = a[:, 0] + (at - a[:, 1]) / rise * (b[:, 0] - a[:, 0])
        left = np.where(crosses, np.minimum(left, x), left)
        right = np.where(crosses, np.maximum(right, x), right)
    covered = right > left
    begin = np.clip(np.ceil(np.where(covered, left, 0.0) - 0.5), 0, width).astype(np.int64)
    end = np.clip(np.ceil(np.where(covered, right, 0.0) - 0.5), 0, width).astype(np.int64)
    end = np.where(covered & (begin < width), np.maximum(end, begin + 1), end)  # plates seen edge on are seen
    a, b, c = corners.transpose(1, 0, 2)
    area = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])
    used = np.flatnonzero((end > begin) & (np.abs(area) > 1e-9))
    a, b, c, area, at = a[used], b[used], c[used], area[used], at[used]
    begin, end, nearness = begin[used], end[used], depth[used]
    # Depth is linear over the triangle: its rate along x, and its value at the first pixel.
    rise, run = nearness[:, 1] - nearness[:, 0], nearness[:, 2] - nearness[:, 0]
    slope = (rise * (c[:, 1] - a[:, 1]) - run * (b[:, 1] - a[:, 1])) / area
    up = (run * (b[:, 0] - a[:, 0]) - rise * (c[:, 0] - a[:, 0])) / area
    first = nearness[:, 0] + slope * (begin + 0.5 - a[:, 0]) + up * (at - a[:, 1])
    # Not beyond its corners where it is seen edge on.
    first = np.clip(first, nearness.min(axis=1), nearness.max(axis=1))
    length = end - begin
    start = y[used] * width + begin
    for batch in np.split(np.arange(len(used)), np.flatnonzero(np.diff(np.cumsum(length) // _BATCH)) + 1):
        yield _Spans(triangle[used][batch], start[batch], length[batch], first[batch], slope[batch])


def _faces(part: Whole, normals: FloatArray) -> Whole:
    """Number of the face that each triangle belongs to: a part, and a direction to about a tenth."""
    keys = np.concatenate([part[:, None], np.round(10.0 * normals).astype(np.int64)], axis=1)
    return np.asarray(np.unique(keys, axis=0, return_inverse=True)[1].reshape(-1))


def _edges(layer: _Layer, face: Whole) -> npt.NDArray[np.bool_]:
    """Pixels at which a part ends, a face turns, or depth jumps."""
    seen = layer.which >= 0
    own = np.where(seen, face[layer.which], -1)
    depth = np.where(seen, layer.depth, 0.0)
    edge = np.zeros(own.shape, dtype=bool)
    for axis in (0, 1):
        differs = (np.diff(own, axis=axis) != 0) | (np.abs(np.diff(depth, axis=axis)) > _STEP)
        if axis == 0:
            edge[:-1] |= differs
            edge[1:] |= differs
        else:
            edge[:, :-1] |= differs
            edge[:, 1:] |= differs
    return edge & seen
