"""Capytaine's NetCDF files, and DAVE's `.dhyd`, which are made of the same tables in tonnes and kilonewtons.

Both name their dimensions, and the order of the motions is whatever the file has. Time goes as exp(−iωt).
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import numpy.typing as npt

from gantline.hydro.database.model import AXES, DRIFTING, Coupling, DatabaseError, HydrodynamicDatabase
from gantline.hydro.database.opening import checked_hdf5, text_of
from gantline.hydro.database.tables import Tables, tables_in

__all__ = ["read_capytaine", "read_dhyd"]

Array = npt.NDArray[np.float64]
Complex = npt.NDArray[np.complex128]

#: Tonnes and kilonewtons.
_DAVE = 1000.0
_RADIATION = ("omega", "radiating_dof", "influenced_dof")
_TABLES = ("added_mass", "radiation_damping")


def read_capytaine(path: Path) -> list[HydrodynamicDatabase]:
    """All bodies of a file that Capytaine wrote; SI units throughout.

    Raises:
        DatabaseError: If it is no such file, or something that it needs is not in it.
    """
    source = f"{path.name} (Capytaine)"
    with tables_in(path) as found:
        if "added_mass" not in found or "radiation_damping" not in found:
            raise DatabaseError(
                f"{path}: has no 'added_mass' and 'radiation_damping' as Capytaine's files have"
            )
        for name in ("omega", *_RADIATION[1:]):
            if name not in found:
                raise DatabaseError(f"{path}: has no '{name}', which its tables run over")
        # A single one is no dimension, but is there.
        speeds = np.asarray(found["forward_speed"].values if "forward_speed" in found else 0.0, dtype=float)
        if speeds.any():
            fastest = speeds.flat[np.abs(speeds).argmax()]
            raise DatabaseError(f"{path}: is for a vessel at {fastest:g} m/s; one without speed can be read")
        bodies = _bodies(path, [text_of(dof) for dof in found["influenced_dof"].values])
        density = _scalar(path, found, "rho")
        depth = _scalar(path, found, "water_depth")
        omega = np.asarray(found["omega"].values, dtype=float)
        order = np.argsort(omega)
        kept = order[np.isfinite(omega[order]) & (omega[order] > 0)]
        at_infinity = order[np.isposinf(omega[order])]
        single = text_of(found["body_name"].values) if "body_name" in found else ""
        result = []
        for body, dofs in bodies.items():
            mass, damping = (_matrix(path, found, name, dofs) for name in _TABLES)
            directions, excitation = _capytaine_waves(path, found, dofs)
            drift = _drift(path, found, directions)
            result.append(
                HydrodynamicDatabase(
                    name=body or single or path.stem,
                    source=source,
                    frequencies=omega[kept],
                    added_mass=mass[kept],
                    damping=damping[kept],
                    density=density,
                    infinite_added_mass=mass[at_infinity[0]] if len(at_infinity) else None,
                    reference=_point(found, body, "rotation_center", "rotation_centers"),
                    displacement=_volume(found, body),
                    water_depth=depth,
                    directions=directions,
                    excitation=None if excitation is None else excitation[kept],
                    # Of several bodies the file has that of all together.
                    drift=None if drift is None or len(bodies) > 1 else drift[kept],
                    others={
                        other: Coupling(*(_matrix(path, found, name, dofs, moving)[kept] for name in _TABLES))
                        for other, moving in bodies.items()
                        if other != body
                    },
                )
            )
        return result


def read_dhyd(path: Path) -> list[HydrodynamicDatabase]:
    """The body of a `.dhyd` file; it says neither reference point nor draft.

    Raises:
        DatabaseError: If it is no such file, or something that it needs is not in it.
    """
    names = checked_hdf5(path)
    needed = ["mass/added_mass", "mass/omega", "damping/radiation_damping", "damping/omega"]
    groups = [axis.capitalize() for axis in AXES if f"{axis.capitalize()}/real" in names]
    needed += [f"{group}/{over}" for group in groups for over in ("omega", "wave_direction")]
    for name in needed:
        if name not in names:
            raise DatabaseError(f"{path}: has no '{name}', as .dhyd files have")
    with tables_in(path, "mass") as mass, tables_in(path, "damping") as damping:
        dofs = list(AXES)
        omega = np.asarray(mass["omega"].values, dtype=float)
        order = np.argsort(omega)
        if not np.array_equal(omega, np.asarray(damping["omega"].values, dtype=float)):
            raise DatabaseError(f"{path}: added mass and damping are for different frequencies")
        matrices = (
            _matrix(path, mass, "added_mass", dofs),
            _matrix(path, damping, "radiation_damping", dofs),
        )
        directions, excitation = _dhyd_waves(path, names, omega)
        return [
            HydrodynamicDatabase(
                name=text_of(mass["body_name"].values) if "body_name" in mass else path.stem,
                source=f"{path.name} (DAVE)",
                frequencies=omega[order],
                added_mass=matrices[0][order] * _DAVE,
                damping=matrices[1][order] * _DAVE,
                density=_scalar(path, mass, "rho"),
                water_depth=_scalar(path, mass, "water_depth"),
                directions=directions,
                excitation=None if excitation is None else excitation[order] * _DAVE,
            )
        ]


def _bodies(path: Path, dofs: Sequence[str]) -> dict[str, list[str]]:
    """The six motions of each body by its name; of a single one the name may be empty."""
    found: dict[str, dict[str, str]] = {}
    for dof in dofs:
        body, _, axis = dof.rpartition("__")
        if axis.lower() in AXES:
            found.setdefault(body, {})[axis.lower()] = dof
    whole = {body: [motions[axis] for axis in AXES] for body, motions in found.items() if len(motions) == 6}
    if not whole:
        listed = ", ".join(dofs[:12])
        raise DatabaseError(f"{path}: no body has the six motions surge to yaw; it has {listed}")
    return whole


def _matrix(
    path: Path, found: Tables, name: str, dofs: Sequence[str], moving: Sequence[str] | None = None
) -> Array:
    """(n, 6, 6): rows are forces, columns motions, those of the same body if no other is `moving`."""
    table = found[name]
    for over in _RADIATION:
        if over not in table.dims:
            raise DatabaseError(f"{path}: its '{name}' does not run over '{over}'")
    if not table.runs_over(*_RADIATION):
        extra = ", ".join(dim for dim in table.dims if dim not in _RADIATION)
        raise DatabaseError(f"{path}: its '{name}' runs over {extra} as well")
    values = np.asarray(table.over("omega", "influenced_dof", "radiating_dof"), dtype=float)
    return values[:, _places(path, found, "influenced_dof", dofs)][
        :, :, _places(path, found, "radiating_dof", moving or dofs)
    ]


def _places(path: Path, found: Tables, dimension: str, dofs: Sequence[str]) -> list[int]:
    known = {text_of(dof).lower(): place for place, dof in enumerate(found[dimension].values)}
    missing = [dof for dof in dofs if dof.lower() not in known]
    if missing:
        raise DatabaseError(f"{path}: its '{dimension}' has no {missing[0]}")
    return [known[dof.lower()] for dof in dofs]


def _scalar(path: Path, found: Tables, name: str) -> float | None:
    if name not in found:
        return None
    values = np.unique(np.asarray(found[name].values, dtype=float))
    if len(values) != 1:
        raise DatabaseError(f"{path}: its '{name}' has {len(values)} values; one can be read")
    return float(values[0])


def _point(found: Tables, body: str, *names: str) -> Array | None:
    """A point (3,) of a body where the file has it under one of these names."""
    for name in names:
        values = _of_body(found, body, name)
        if values is not None and values.shape == (3,) and np.isfinite(values).all():
            return values
    return None


def _volume(found: Tables, body: str) -> float | None:
    values = _of_body(found, body, "disp_volume")
    return float(values[0]) if values is not None and values.size == 1 else None


def _of_body(found: Tables, body: str, name: str) -> Array | None:
    """Numbers that a file has for each body, or for its only one; None where it has none of that name.

    Capytaine called what they run over `body_name`, since version 3 `body`.
    """
    if name not in found:
        return None
    table = found[name]
    for over in ("body", "body_name"):
        if over in table.dims and body:
            if over not in found:
                return None  # which row is whose nothing says
            known = [text_of(one) for one in found[over].values]
            if body not in known:
                return None
            table = table.at(over, known.index(body))
    return np.asarray(table.values, dtype=float).reshape(-1)


def _capytaine_waves(path: Path, found: Tables, dofs: Sequence[str]) -> tuple[Array, Complex | None]:
    """Froude–Krylov and diffraction forces together; angles in radians."""
    parts = [found[name] for name in ("Froude_Krylov_force", "diffraction_force") if name in found]
    if len(parts) != 2 or "wave_direction" not in found:
        return np.zeros(0), None
    is_pair = any("complex" in part.dims for part in parts)
    wanted = ("omega", "wave_direction", "influenced_dof")
    over = ("complex", *wanted) if is_pair else wanted
    if not all(part.runs_over(*over) for part in parts):
        return np.zeros(0), None
    values = parts[0].over(*over) + parts[1].over(*over)
    if is_pair:
        pair = {text_of(label): place for place, label in enumerate(found["complex"].values)}
        values = values[pair["re"]] + 1j * values[pair["im"]]
    places = _places(path, found, "influenced_dof", dofs)
    directions = np.asarray(found["wave_direction"].values, dtype=float)
    return directions, np.asarray(values, dtype=complex)[:, :, places]


def _drift(path: Path, found: Tables, directions: Array) -> Array | None:
    """Surge, sway and yaw (n, k, 3) of single waves, `drift_force_surge` and so on.

    Capytaine's `far_field_mean_drift_force` gives them for pairs of waves: of each with itself.
    """
    names = [f"drift_force_{axis}" for axis in DRIFTING]
    if not all(name in found for name in names):
        return None
    tables = []
    for name in names:
        table = found[name]
        if "complex" in table.dims:
            real = [text_of(label) for label in found["complex"].values].index("re")
            table = table.at("complex", real)
        over = ("omega", *(dim for dim in table.dims if dim.startswith("wave_direction")))
        if not table.runs_over(*over) or len(over) == 1:
            raise DatabaseError(f"{path}: its '{name}' runs over {', '.join(table.dims)}")
        for dim in over[1:]:
            if not np.array_equal(np.asarray(found[dim].values, dtype=float), directions):
                raise DatabaseError(f"{path}: its '{name}' has other directions than its wave forces")
        values = table.over(*over).real
        tables.append(np.einsum("nkk->nk", values) if values.ndim == 3 else values)
    return np.stack(tables, axis=-1)


def _dhyd_waves(path: Path, names: Sequence[str], omega: Array) -> tuple[Array, Complex | None]:
    """Groups Surge to Yaw with `real` and `imag` over frequency and direction [deg]."""
    groups = [axis.capitalize() for axis in AXES]
    if not all(f"{group}/{part}" in names for group in groups for part in ("real", "imag")):
        return np.zeros(0), None
    forces: list[Complex] = []
    directions = np.zeros(0)
    for group in groups:
        with tables_in(path, group) as found:
            real, imaginary = (found[part].over("omega", "wave_direction") for part in ("real", "imag"))
            values = np.asarray(real + 1j * imaginary, dtype=complex)
            own = np.asarray(found["omega"].values, dtype=float)
            ways = np.radians(np.asarray(found["wave_direction"].values, dtype=float))
        if values.shape != (len(omega), len(ways)):
            raise DatabaseError(f"{path}: the wave forces of {group} have another shape than its damping")
        if not np.allclose(own, omega, rtol=1e-9, atol=0):
            raise DatabaseError(f"{path}: the wave forces of {group} have other frequencies than its damping")
        if forces and not np.array_equal(ways, directions):
            raise DatabaseError(f"{path}: the wave forces of {group} have other directions than {groups[0]}")
        directions = ways
        forces.append(values)
    return directions, np.stack(forces, axis=-1)
