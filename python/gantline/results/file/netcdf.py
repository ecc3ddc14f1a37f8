"""Recordings as NetCDF4 files, written through h5netcdf; read through h5py, in a quarter of the time.

All variables stand in the root group with `units` and `long_name`; names along a dimension are a text
variable of the same name as the dimension, so `xarray.open_dataset` reads them as coordinates. Attributes
are JSON text, except those that are plain text anyway (`title`, `gantline_version`, `scenario`, `status`).
The file holds no clock time: the same recording gives the same bytes.
"""

from __future__ import annotations

import errno
import json
import math
import os
import zlib
from collections import deque
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, Future, ThreadPoolExecutor
from contextlib import contextmanager
from itertools import product
from pathlib import Path
from typing import Any

import h5netcdf
import h5py
import numpy as np

from gantline.replacing import ROOM_OF_TABLES, hold_room, replaced
from gantline.results.file.form import FormError
from gantline.results.file.layout import hold_variable
from gantline.results.file.validity import hold_recording
from gantline.results.recording import Recording
from gantline.results.rig import Rig
from gantline.results.variable import Variable
from gantline.scales import alone, said, tables_of

_FORMAT = 1
_PLAIN_TEXT = frozenset({"title", "gantline_version", "scenario", "status"})
_OF_THE_FORMAT = frozenset({"recording_format", "_NCProperties"})
_LEVEL = 1  # of gzip: higher ones take longer and save nothing
_COMPRESS_FROM = 1 << 16  # bytes; smaller variables are not worth a chunk index
_WORKERS = os.cpu_count() or 1
_COMPONENTS = frozenset({"xyz", "wxyz"})  # each in chunks of its own: its values are like their neighbours

#: Infinite where there is nothing left that they could be of: ropes that have all parted.
_ENDLESS = frozenset({"clearance"})


def save_recording(recording: Recording, path: Path) -> Path:
    """Write a recording to `path` at once: under another name first, then renamed.

    Args:
        recording: What to write.
        path: The file; an existing one is replaced.

    Returns:
        The path.

    Raises:
        OSError: If it cannot be written.
    """
    with replaced(path) as trial:
        with trial.open("r+b") as empty:
            hold_room(empty.fileno(), ROOM_OF_TABLES, path)
        with _Kept(trial, path) as tables, h5netcdf.File(tables, "w") as file:
            _write(recording, file, tables.hold)
            tables.hold(0)
        os.truncate(trial, _end_of(trial))
    return path


def _end_of(path: Path) -> int:
    """Where the tables of a file say that it ends [bytes]: behind it is room that was held and is not used.

    The superblock has it, with addresses of eight bytes (HDF5 File Format Specification 3.0, II.A).
    """
    with path.open("rb") as file:
        superblock = file.read(64)
    place = {0: 40, 1: 44}.get(superblock[8], 28)
    return int.from_bytes(superblock[place : place + 8], "little")


class _Kept(h5py.File):  # type: ignore[misc]  # h5py says nothing of its types
    """A new file whose tables stay open: h5netcdf looks each of them up some dozen times."""

    def __init__(self, trial: Path, path: Path) -> None:
        super().__init__(trial, "w", track_order=True)
        self._found: dict[str, Any] = {}
        self._path = path

    def hold(self, size: int) -> None:
        """Hold room for so many bytes more, and for what the library writes as it closes the file."""
        hold_room(self.id.get_vfd_handle(), self.id.get_filesize() + size + ROOM_OF_TABLES, self._path)

    def __getitem__(self, name: Any) -> Any:
        if name == "/":
            return self
        if not isinstance(name, str):
            return super().__getitem__(name)
        place = f"/{name.lstrip('/')}"
        if place not in self._found:
            self._found[place] = super().__getitem__(place)
        return self._found[place]

    def __delitem__(self, name: str) -> None:
        # The dummy of a dimension, in whose place its labels come.
        self._found.pop(f"/{name.lstrip('/')}", None)
        super().__delitem__(name)


def load_recording(path: Path) -> Recording:
    """Read a recording.

    Args:
        path: A file that `save_recording` wrote.

    Returns:
        The recording.

    Raises:
        FileNotFoundError: If there is no such file.
        ValueError: If it is not a recording, or one that is damaged; the message says what is wrong.
    """
    with _opened(path) as file:
        return _read(file)


def load_rig(path: Path) -> Rig:
    """Read what a recording knows of its lift, and none of its samples.

    Args:
        path: A file that `save_recording` wrote.

    Returns:
        The rig.

    Raises:
        FileNotFoundError: If there is no such file.
        ValueError: If it is not a recording, or one that is damaged; the message says what is wrong.
    """
    with _opened(path) as file:
        return Rig.from_json(_attributes(file)["rig"])


@contextmanager
def _opened(path: Path) -> Iterator[h5py.File]:
    """A recording's file; what goes wrong while it is read is said of the path."""
    try:
        if not path.is_file():
            raise FileNotFoundError(f"{path}: {_in_its_place(path)}")
        with h5py.File(path, "r") as file:
            if "recording_format" not in file.attrs:
                raise ValueError("another program wrote it: it has no attribute 'recording_format'")
            form = int(alone(file.attrs["recording_format"]))
            if form > _FORMAT:
                raise ValueError(f"recording format {form}; this version reads up to {_FORMAT}")
            yield file
    except FileNotFoundError:
        raise
    except PermissionError as problem:
        # HDF5 puts sentences of its own, with the path once more, in place of those of the system.
        why = os.strerror(problem.errno or errno.EACCES)
        raise ValueError(f"{path}: cannot be read ({why.lower()})") from None
    except FormError as problem:
        raise ValueError(
            f"{path}: {problem}. The recording is damaged, or another program has changed it: "
            "run the lift again"
        ) from None
    except (OSError, LookupError, RuntimeError, TypeError, AttributeError, ValueError) as problem:
        # What h5py says of a damaged file has many forms.
        raise ValueError(f"{path}: not a recording of gantline ({_reason(str(problem))})") from problem


def _in_its_place(path: Path) -> str:
    """What is said of a path where no file is: which recordings a folder has, that of a run before others."""
    inside = sorted(path.glob("*.nc"), key=lambda one: (one.name != "recording.nc", one.name))
    if not inside:
        return "is a folder without a recording" if path.is_dir() else "no such file"
    if len(inside) > 1 and inside[0].name == "recording.nc":
        return f"is a folder; of the {len(inside)} recordings in it that of the run is {inside[0]}"
    more = f", the first of {len(inside)}" if len(inside) > 1 else ""
    return f"is a folder; the recording in it is {inside[0]}{more}"


def _reason(words: str) -> str:
    """What h5py says, in words of those who make recordings where it is of the commonest kinds."""
    if "file signature not found" in words:
        return "it is no NetCDF4 file"
    if "truncated file" in words:
        return "it is cut off: copy it anew, or run the lift again"
    return words


def _write(recording: Recording, file: h5netcdf.File, hold: Callable[[int], None]) -> None:
    # An event-free lift has an event dimension of length 0, which NetCDF keeps as an unlimited one.
    file.dimensions = {dim: size or None for dim, size in recording.sizes.items()}
    for dim, labels in recording.coordinates.items():
        names = file.create_variable(dim, (dim,), dtype=h5py.string_dtype())
        if labels:
            names[...] = np.array(labels, dtype=object)
    with ThreadPoolExecutor(_WORKERS) as pool:
        for name, variable in recording.variables.items():
            _write_variable(file, name, variable, pool, hold)
    file.attrs["recording_format"] = _FORMAT
    for name, value in recording.attributes.items():
        text = value if name in _PLAIN_TEXT else json.dumps(value, allow_nan=False)
        hold(len(text.encode()))
        file.attrs[name] = text


def _write_variable(
    file: h5netcdf.File, name: str, variable: Variable, pool: Executor, hold: Callable[[int], None]
) -> None:
    values = variable.values
    options: dict[str, Any] = {}
    is_large = not variable.is_text and values.nbytes >= _COMPRESS_FROM
    if is_large:
        options = {
            "compression": "gzip",
            "compression_opts": _LEVEL,
            "shuffle": True,
            "chunks": _chunks(variable),
        }
    target = file.create_variable(
        name, variable.dims, dtype=h5py.string_dtype() if variable.is_text else "<f8", **options
    )
    if is_large:
        _write_chunks(target._h5ds, values, options["chunks"], pool, hold)
    elif values.size:
        hold(values.nbytes)
        target[...] = values.astype(object) if variable.is_text else values
    target.attrs["units"] = variable.unit
    target.attrs["long_name"] = variable.description


def _write_chunks(
    target: h5py.Dataset,
    values: np.ndarray[Any, np.dtype[Any]],
    shape: tuple[int, ...],
    pool: Executor,
    hold: Callable[[int], None],
) -> None:
    """Write a dataset in chunks of whole rows, or of a component of them, compressed on all processors.

    The library would filter one chunk after the other: the same bytes, shuffled and deflated here, are handed
    to it as they are to stand in the file. Only so many are under way that memory stays small.
    """
    pending: deque[tuple[tuple[int, ...], Future[bytes]]] = deque()

    def write(most: int) -> None:
        while len(pending) > most:
            place, packed = pending.popleft()
            hold(len(packed.result()))
            target.id.write_direct_chunk(place, packed.result())

    whole = np.asarray(values, dtype="<f8")
    starts = product(*(range(0, size, chunk) for size, chunk in zip(whole.shape, shape, strict=True)))
    for start in starts:
        chunk = whole[tuple(slice(at, at + size) for at, size in zip(start, shape, strict=True))]
        pending.append((start, pool.submit(_filtered, chunk, shape[0])))
        write(2 * _WORKERS)
    write(0)


def _filtered(chunk: np.ndarray[Any, np.dtype[Any]], rows: int) -> bytes:
    """What the filters shuffle and gzip make of a chunk; the last one is filled up with zeros."""
    if len(chunk) < rows:
        chunk = np.concatenate([chunk, np.zeros((rows - len(chunk), *chunk.shape[1:]))])
    in_order = np.ascontiguousarray(chunk).view(np.uint8)
    shuffled = np.ascontiguousarray(in_order.reshape(-1, chunk.itemsize).T)
    # Of the faster libraries ISA-L was tried: now and then it makes other bytes of the same chunk.
    return zlib.compress(shuffled.data, _LEVEL)


def _chunks(variable: Variable) -> tuple[int, ...]:
    """Whole rows, of vectors one component of them: about a megabyte, so that reading one time span is cheap.

    Components side by side look like noise to gzip: apart, a drawn path takes less than half of the room.
    """
    values = variable.values
    is_vector = values.ndim > 1 and variable.dims[-1] in _COMPONENTS
    inner = (*values.shape[1:-1], 1) if is_vector else values.shape[1:]
    row = max(1, math.prod(inner) * values.itemsize)
    return (max(1, min(len(values), (1 << 20) // row)), *inner)


def _read(file: h5py.File) -> Recording:
    variables: dict[str, Variable] = {}
    coordinates: dict[str, list[str]] = {}
    for name, dims, stored in tables_of(file):
        hold_variable(name, dims, stored.dtype)
        unit = said(stored, "units")
        if unit is None and dims != (name,):
            raise FormError(f"variable '{name}' has no attribute 'units'")
        values = _without_infinity(np.asarray(stored[...]), endless=name in _ENDLESS)
        values.flags.writeable = False
        if unit is None:
            coordinates[name] = [str(label) for label in _text(values)]
            continue
        is_number = values.dtype.kind == "f"
        description = said(stored, "long_name") or ""
        variables[name] = Variable(dims, values if is_number else _text(values), unit, description)
    try:
        recording = Recording(variables, coordinates, _attributes(file))
    except ValueError as problem:
        raise FormError(str(problem)) from None
    hold_recording(recording)
    return recording


def _without_infinity(
    values: np.ndarray[Any, np.dtype[Any]], *, endless: bool
) -> np.ndarray[Any, np.dtype[Any]]:
    """The same with no number where one is infinite: no run leaves any, and no mean of it is known.

    Where values may be `endless`, positive ones stay.
    """
    if values.dtype.kind != "f":
        return values
    with np.errstate(over="ignore", invalid="ignore"):
        if np.isfinite(values.sum()):
            return values
    return np.where(np.isneginf(values) if endless else np.isinf(values), np.nan, values)


def _text(values: np.ndarray[Any, np.dtype[Any]]) -> np.ndarray[Any, np.dtype[np.str_]]:
    decoded = [v.decode() if isinstance(v, bytes) else str(v) for v in values.ravel()]
    return np.array(decoded, dtype=np.str_).reshape(values.shape)


def _attributes(file: h5py.File) -> dict[str, Any]:
    own = {name: alone(value) for name, value in file.attrs.items() if name not in _OF_THE_FORMAT}
    return {name: _attribute(name, value) for name, value in own.items()}


def _attribute(name: str, value: Any) -> Any:
    """What an attribute says; text that is no JSON is what another program has added, such as `history`."""
    if name in _PLAIN_TEXT:
        return str(value)
    try:
        return json.loads(str(value))
    except ValueError:
        return str(value)
