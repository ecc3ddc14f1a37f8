"""A recording: everything that is kept of one simulated lift.

It wraps columns of numbers, knows nothing of the simulator, and is not to be changed.
`gantline.results.derive` lists its variables with their dimensions and units.
"""

from __future__ import annotations

import difflib
from collections.abc import Callable, Collection, Hashable, Iterator, Mapping, Sequence
from functools import cached_property
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from gantline.arguments import needed, path_of
from gantline.results.kinds import EVENT_KINDS
from gantline.results.rig import Rig
from gantline.results.status import INCOMPLETE, READY
from gantline.results.variable import FloatArray, Indices, Variable

if TYPE_CHECKING:
    import xarray

_Kept = TypeVar("_Kept")

#: Endings of files by which programs know tables, texts and pages, which a recording is none of.
_OTHER_KINDS = frozenset({".csv", ".html", ".json", ".ods", ".parquet", ".txt", ".xls", ".xlsx"})
#: Where a variable comes from.
_MADE = "gantline.results.Variable(('time', 'rope'), values, 'N', 'tension') makes one of an array"
#: Most names that a message lists.
_MOST_NAMED = 12


class Recording:
    """What happened in one lift, as named variables over time.

    Args:
        variables: Variables by name; `time` [s] is one of them.
        coordinates: Names along a dimension, for example `{"rope": ["sling.S1", ...]}`.
        attributes: What describes the whole: `title`, `gantline_version`, `scenario` (text of the lift file),
            `settings`, `warnings`, `rig`, `scene`, `counters`, `energy_remainder`, `status`; of a run that
            failed also `failure` with its `time` [s], `element` and `cause`; of one that was simulated with a
            finer method too `refinement`, see `gantline.results.refinement`.

    Raises:
        TypeError: If a variable is none, such as an array.
        ValueError: If lengths along a dimension do not agree.
    """

    def __init__(
        self,
        variables: Mapping[str, Variable],
        coordinates: Mapping[str, Sequence[str]],
        attributes: Mapping[str, Any],
    ) -> None:
        self._variables = MappingProxyType(dict(variables))
        self._coordinates = MappingProxyType({dim: tuple(labels) for dim, labels in coordinates.items()})
        self._attributes = MappingProxyType(dict(attributes))
        self._sizes = MappingProxyType(_sizes(self._variables, self._coordinates))
        self._kept: dict[Hashable, Any] = {}

    @property
    def variables(self) -> Mapping[str, Variable]:
        """All variables by name."""
        return self._variables

    @property
    def coordinates(self) -> Mapping[str, tuple[str, ...]]:
        """Names along the dimensions that have names."""
        return self._coordinates

    @property
    def attributes(self) -> Mapping[str, Any]:
        """What describes the recording as a whole.

        Dictionaries and lists in it are the recording's own. `copy.deepcopy` gives a rig that may be changed,
        and `Recording(one.variables, one.coordinates, {**one.attributes, "rig": rig})` another recording.
        """
        return self._attributes

    @property
    def sizes(self) -> Mapping[str, int]:
        """Length of every dimension."""
        return self._sizes

    @property
    def title(self) -> str:
        """Title of the lift."""
        return str(self._attributes.get("title", ""))

    @property
    def time(self) -> FloatArray:
        """Times of the samples [s], shape (time,)."""
        return self._variables["time"].values

    @property
    def is_equilibrium(self) -> bool:
        """Whether it is of a lift at rest, of which the last sample counts, and nothing is dynamic.

        Its status says so. One sample alone is at rest too, unless it is what a run has by then; a sample
        before the last is where the lift starts, from which travel is counted.
        """
        status = str(self.attributes.get("status", ""))
        alone = len(self.time) == 1 and status not in (*INCOMPLETE, READY)
        return bool(len(self.time)) and (alone or status.startswith("at rest"))

    @cached_property
    def rig(self) -> Rig:
        """What was lifted with what (loads, hooks, equalizers, slings, limits)."""
        return Rig.from_json(self._attributes.get("rig", {}))

    def __reduce__(self) -> tuple[Any, ...]:
        """For pickle and copy: a mapping that cannot be changed cannot be pickled as it is."""
        return Recording, (dict(self._variables), dict(self._coordinates), dict(self._attributes))

    def __getitem__(self, name: str) -> Variable:
        try:
            return self._variables[name]
        except KeyError:
            raise KeyError(no_variable(name, self._variables)) from None
        except TypeError:  # as tables take lists
            found = f"the name of one variable is needed, not {type(name).__name__}"
            raise TypeError(f"{found}; 'dataset' of a recording takes lists") from None

    def __contains__(self, name: object) -> bool:
        return name in self._variables

    def __iter__(self) -> Iterator[str]:
        return iter(self._variables)

    def __len__(self) -> int:
        return len(self._variables)

    def __repr__(self) -> str:
        sizes = ", ".join(f"{dim}: {size}" for dim, size in self._sizes.items())
        return f"<Recording {self.title!r}: {len(self._variables)} variables; {sizes}>"

    def _repr_html_(self) -> str:
        """For notebooks: what was lifted, how long it is, how it ended, its warnings."""
        from gantline.html import facts_table
        from gantline.results import series
        from gantline.results.alike import first_largest
        from gantline.units import format_quantity

        sizes = ", ".join(f"{size} {dim}" for dim, size in self.sizes.items() if dim in self.coordinates)
        rows = [("status", str(self._attributes.get("status", "")))]
        if len(self.time):
            span = f"{self.time[0]:g} s to {self.time[-1]:g} s"
            rows.append(("time", f"{span}, {len(self.time)} samples"))
        slings = [sling.rope for sling in self.rig.slings]
        if slings and "rope_tension" in self and len(self.time):
            peaks = {rope: series.rope_peak(self, rope)[0] for rope in slings}
            rope = first_largest(peaks, lambda name: peaks[name], "kN") or slings[0]
            rows.append(("largest sling tension", f"{format_quantity(peaks[rope], 'kN', 1)} ({rope})"))
        rows += [("names", sizes), ("variables", ", ".join(self._variables))]
        rows += [("warning", str(warning)) for warning in self._attributes.get("warnings") or ()]
        return facts_table(self.title or "Recording", rows)

    def column(self, name: str, label: str) -> FloatArray:
        """One named series of a variable, for example `column("rope_tension", "sling.S1")`.

        Args:
            name: Name of a variable that has one named dimension besides time.
            label: A name along that dimension.

        Returns:
            The values for that name, read-only; shape (time,) for a variable over time.

        Raises:
            KeyError: If there is no such variable or name.
            TypeError: If it is no name.
        """
        variable = self[name]
        if not isinstance(
            label, str
        ):  # an array is compared with each name, and is then neither true nor false
            raise TypeError(f"label: one name along {name} is needed, not {type(label).__name__}")
        for axis, dim in enumerate(variable.dims):
            labels = self._coordinates.get(dim, ())
            if dim != "xyz" and dim != "wxyz" and label in labels:
                values: FloatArray = variable.values[(slice(None),) * axis + (labels.index(label),)]
                return values
        dims = [dim for dim in variable.dims if dim not in ("time", "xyz", "wxyz")]
        known = [str(one) for dim in dims for one in self._coordinates.get(dim, ())]
        if not known:
            raise KeyError(
                f"{name} has no names along it, so no {label!r}; recording[{name!r}].values has all"
            )
        likely = [one for one in known if one.endswith(f".{label}")] or known
        more = f" and {len(likely) - _MOST_NAMED} more" if len(likely) > _MOST_NAMED else ""
        raise KeyError(f"{name} has no {label!r}; it has {', '.join(likely[:_MOST_NAMED])}{more}")

    def events(self, kind: str | None = None) -> list[tuple[float, str, str]]:
        """Events in order of time.

        Args:
            kind: Only this kind, for example `lift_off`.

        Returns:
            Time [s], kind and name of each; nothing of a kind that did not happen.

        Raises:
            KeyError: If no recording has events of this kind.
            TypeError: If it is no kind.
        """
        if kind is not None and not isinstance(kind, str):
            raise TypeError(
                f"kind: one kind of event is needed, not {type(kind).__name__}; 'lift_off' is one"
            )
        found = [event for event in self._events if kind is None or event[1] == kind]
        # Of a version to come a recording may have kinds that are not known here.
        if not found and kind is not None and kind not in EVENT_KINDS:
            raise KeyError(f"no kind of event is {kind!r}; they are {', '.join(EVENT_KINDS)}")
        return found

    @cached_property
    def _events(self) -> Sequence[tuple[float, str, str]]:
        if "event_time" not in self:
            return ()
        columns = (self[f"event_{what}"].values.tolist() for what in ("time", "kind", "name"))
        return tuple(zip(*columns, strict=True))

    @cached_property
    def points_of_ropes(self) -> Mapping[str, Indices]:
        """Places along `rope_point` of what is drawn of each rope, from its first end to its last.

        Empty for a recording without drawn paths; a rope of which nothing is drawn is not in it.
        """
        if "rope_of_point" not in self:
            return MappingProxyType({})
        places: dict[str, list[int]] = {}
        for place, rope in enumerate(self["rope_of_point"].values.tolist()):
            places.setdefault(rope, []).append(place)
        return MappingProxyType({rope: np.array(of_rope) for rope, of_rope in places.items()})

    def kept(self, name: Hashable, make: Callable[[], _Kept]) -> _Kept:
        """What many ask for and nobody changes, worked out the first time.

        Args:
            name: What it is, and of what.
            make: Works it out.

        Returns:
            The same each time; an array cannot be written to.
        """
        if name not in self._kept:
            found = self._kept[name] = make()
            if isinstance(found, np.ndarray):
                found.flags.writeable = False
        kept: _Kept = self._kept[name]
        return kept

    def metrics(self) -> dict[str, float]:
        """The lift in key numbers, SI units; `gantline.results.metrics` defines each.

        Raises:
            ValueError: If it is a part of a recording, made by hand, that lacks what they are of.
        """
        return dict(self._metrics)

    @cached_property
    def _metrics(self) -> Mapping[str, float]:
        from gantline.results.metrics import metrics_of

        try:
            return metrics_of(self)
        except KeyError:
            self._hold("metrics are of whole recordings")
            raise

    def _hold(self, why: str) -> None:
        """Refuse what is made by hand and lacks what every recording has; `why` says who needs it."""
        from gantline.results.file.form import FormError
        from gantline.results.file.validity import hold_recording

        try:
            hold_recording(self)
        except FormError as problem:
            right = "variables, names and attributes of another recording are right together"
            raise ValueError(f"{why}, and of this one {problem}; {right}") from None

    @property
    def dataset(self) -> xarray.Dataset:
        """The same as an `xarray.Dataset` (dictionaries among the attributes as they are, not as text).

        Each time a new one, to which variables may be added and of which others may be put in their place;
        values are those of the recording and cannot be written to.

        For pandas take a variable of it, `dataset["rope_tension"].to_pandas()`: `to_dataframe` of the whole
        has a row for each combination of all dimensions, and none at all where nothing has happened.
        """
        return self._dataset.copy()

    @cached_property
    def _dataset(self) -> xarray.Dataset:
        from gantline.results.file.dataset import dataset_of

        return dataset_of(self)

    def save(self, path: str | Path) -> Path:
        """Write a NetCDF4 file that holds everything; same recording, same bytes.

        Args:
            path: File to write, such as `lift.nc`; an existing one is replaced, and only once the new one is
                complete.

        Returns:
            The path written.

        Raises:
            OSError: If it cannot be written there.
            ValueError: If its name ends as that of a file of another kind, such as a table; or if it was made
                by hand and lacks something without which it could not be read again.
        """
        from gantline.results.file.netcdf import save_recording

        file = path_of(path, "a file to write")
        if file.suffix.lower() in _OTHER_KINDS:
            right = "gantline.export.write_csv and write_parquet write tables of its variables"
            raise ValueError(f"{file}: a recording is a NetCDF4 file, {file.stem}.nc; {right}")
        self._hold(f"{file}: nothing is written: only whole recordings can be read again")
        return save_recording(self, file)


def no_variable(name: object, known: Collection[str], which: str = "") -> str:
    """What to say of a variable that is not there: the one that is written most like it, and all of them.

    Args:
        name: What was asked for.
        known: Variables that could have been.
        which: Of what they are, such as `"over time "`.
    """
    near = difflib.get_close_matches(str(name), known, n=1)
    likely = f"did you mean {near[0]!r}? It has" if near else "it has"
    return f"no variable {name!r} {which}in this recording; {likely} {', '.join(known)}"


def recorded(value: Recording) -> Recording:
    """What is a recording, as it is; for functions that take one, which would end inside otherwise.

    Raises:
        TypeError: If it is none, such as the file of one, or the simulation that made it.
    """
    if not isinstance(value, Recording):
        right = "gantline.open_recording reads a file, and 'run' of a simulation gives one"
        raise TypeError(f"a recording is needed, not {type(value).__name__}; {right}")
    return value


def open_recording(path: str | Path) -> Recording:
    """Read a recording that `Recording.save` wrote.

    Args:
        path: NetCDF4 file.

    Returns:
        The recording.

    Raises:
        FileNotFoundError: If there is no such file.
        TypeError: If it is no name of a file.
        ValueError: If the file is not a recording of gantline.
    """
    from gantline.results.file.netcdf import load_recording

    if not isinstance(path, str | Path):
        raise TypeError(f"the file of a recording is needed, not {type(path).__name__}")
    return load_recording(Path(path))


def _sizes(variables: Mapping[str, Variable], coordinates: Mapping[str, Sequence[str]]) -> dict[str, int]:
    sizes: dict[str, int] = {}
    for name, variable in variables.items():
        needed(variable, Variable, f"{name}: a variable", _MADE)
        for dim, size in zip(variable.dims, variable.values.shape, strict=True):
            if sizes.setdefault(dim, size) != size:
                raise ValueError(f"{name} is {size} long in {dim}, other variables {sizes[dim]}")
    for dim, labels in coordinates.items():
        if sizes.setdefault(dim, len(labels)) != len(labels):
            raise ValueError(f"{len(labels)} names for the {sizes[dim]} values in {dim}")
    return sizes
