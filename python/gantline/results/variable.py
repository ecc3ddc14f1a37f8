"""One recorded quantity: numbers with their dimensions, unit and description."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

FloatArray = npt.NDArray[np.float64]
BoolArray = npt.NDArray[np.bool_]
Indices = npt.NDArray[np.int64]


@dataclass(frozen=True, eq=False)
class Variable:
    """Recorded values that cannot be changed.

    Attributes:
        dims: Names of the dimensions, one for each axis of `values`.
        values: Floating-point numbers, or text (`event_kind`, `event_name`). A read-only array is taken as it
            is, any other is copied.
        unit: SI unit, for example `N`; `1` for pure numbers and text.
        description: What it is, in one line.
    """

    dims: tuple[str, ...]
    values: npt.NDArray[Any]
    unit: str
    description: str

    def __post_init__(self) -> None:
        given = np.asarray(self.values)
        values = given.copy() if given.flags.writeable else given
        if values.dtype.kind not in "fU":
            values = values.astype(np.float64) if values.dtype.kind in "biu" else values.astype(np.str_)
        if values.ndim != len(self.dims):
            raise ValueError(f"{values.ndim} axes of values, but the dimensions are {self.dims}")
        values.flags.writeable = False
        object.__setattr__(self, "values", values)
        object.__setattr__(self, "dims", tuple(self.dims))

    def __reduce__(self) -> tuple[Any, ...]:
        """For pickle and copy, which would lose that the values are read-only."""
        return Variable, (self.dims, self.values, self.unit, self.description)

    def __repr__(self) -> str:
        sizes = ", ".join(f"{dim}: {size}" for dim, size in zip(self.dims, self.values.shape, strict=True))
        unit = "" if self.unit == "1" else f" [{self.unit}]"
        return f"<Variable{unit} ({sizes}): {self.description}>"

    def __array__(self, dtype: npt.DTypeLike | None = None, copy: bool | None = None) -> npt.NDArray[Any]:
        """Its values, where numpy or what builds on it is given the variable itself."""
        is_copied = copy or (dtype is not None and self.values.dtype != dtype)
        return np.array(self.values, dtype=dtype) if is_copied else self.values

    @property
    def is_text(self) -> bool:
        """Whether the values are text and not numbers."""
        return bool(self.values.dtype.kind == "U")


#: Columns of the core by name.
Columns = Mapping[str, FloatArray]
#: Names along their dimensions, by dimension.
Names = Mapping[str, Sequence[str]]
#: Variables that follow from columns, and the names along dimensions that they bring.
Derived = tuple[dict[str, Variable], dict[str, Sequence[str]]]
