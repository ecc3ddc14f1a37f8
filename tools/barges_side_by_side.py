"""The table of docs/concepts/side_by_side.md: two barges side by side in waves from abeam, by Capytaine.

    pip install capytaine==3.0.0        in an environment of its own: gantline does not need it
    python tools/barges_side_by_side.py FOLDER

Writes `two.nc` of both together, `crane.nc` and `barge.nc` of each by itself into FOLDER, and prints heave
and roll of the smaller per metre of waves: alone, beside the larger held fast, and with both afloat. Some
minutes.
"""

import sys
from pathlib import Path

import capytaine as cpt
import numpy as np
import xarray as xr
from scipy.interpolate import CubicSpline

DENSITY, GRAVITY = 1025.0, 9.81
#: Length, breadth and draft [m], faces along them, as many above the water, and middle of the waterline [m].
HULLS = {
    "crane": ((60.0, 20.0, 3.0), (30, 10, 4), (0.0, 0.0)),
    "barge": ((40.0, 12.0, 2.0), (20, 8, 4), (0.0, 22.0)),
}
#: Centre of gravity over the keel [m]; share of critical damping in roll.
HEIGHT, ROLL = {"crane": 4.0, "barge": 3.0}, 0.05
#: [s]; close where water swings between the hulls.
PERIODS = [
    *(3.5, 3.75, 4.0, 4.2, 4.4, 4.6, 4.8, 4.9, 5.0, 5.1, 5.2, 5.3, 5.4, 5.6, 5.8),
    *(6.0, 6.25, 6.5, 7.0, 7.5, 8.0, 9.0, 10.0, 12.0, 15.0, 20.0, 25.0),
]
SHOWN = (12.0, 8.0, 7.0, 6.0, 5.0)
AXES = ("Surge", "Sway", "Heave", "Roll", "Pitch", "Yaw")


def body(name: str) -> cpt.FloatingBody:
    """A hull below the water, with a lid inside against irregular frequencies."""
    (length, breadth, draft), faces, (x, y) = HULLS[name]
    mesh = cpt.mesh_parallelepiped(
        size=(length, breadth, 2 * draft), resolution=faces, center=(x, y, 0.0)
    ).immersed_part()
    dofs = cpt.rigid_body_dofs(rotation_center=(x, y, 0.0))
    return cpt.FloatingBody(mesh=mesh, lid_mesh=mesh.generate_lid(z=-0.05), dofs=dofs, name=name)


def computed(path: Path, what: cpt.FloatingBody) -> None:
    """Write the database of a body, or of several joined ones."""
    wanted = xr.Dataset(
        coords={
            "omega": [*(2 * np.pi / np.array(sorted(PERIODS, reverse=True))), np.inf],
            "wave_direction": np.radians(np.arange(0, 360, 15)),
            "radiating_dof": list(what.dofs),
            "water_depth": [np.inf],
            "rho": [DENSITY],
            "g": [GRAVITY],
        }
    )
    cpt.export_dataset(path, cpt.BEMSolver().fill_dataset(wanted, what))


def own(name: str) -> tuple[np.ndarray, np.ndarray]:
    """Inertia and stiffness about the middle of the waterline (6, 6); radii 0.35 B, 0.28 L."""
    length, breadth, draft = HULLS[name][0]
    mass, over = DENSITY * length * breadth * draft, HEIGHT[name] - draft
    lever = np.array([[0.0, -over, 0.0], [over, 0.0, 0.0], [0.0, 0.0, 0.0]])
    inertia = np.zeros((6, 6))
    inertia[:3, :3], inertia[:3, 3:], inertia[3:, :3] = mass * np.eye(3), -mass * lever, mass * lever
    radii = np.square([0.35 * breadth, 0.28 * length, 0.28 * length])
    inertia[3:, 3:] = mass * np.diag(radii) - mass * lever @ lever
    arms = np.square([breadth, length]) / (12 * draft) - draft / 2 - over
    heave = DENSITY * GRAVITY * length * breadth
    return inertia, np.diag([0.0, 0.0, heave, *(mass * GRAVITY * arms), 0.0])


def water(path: Path, names: list[str], period: float, degrees: float) -> list[np.ndarray]:
    """Added mass, damping and forces of a file at a period [s] and a direction of waves."""
    found = xr.open_dataset(path)
    dofs = [f"{name}__{axis}" if len(names) > 1 else axis for name in names for axis in AXES]
    kept = np.flatnonzero(np.isfinite(found["omega"].values))
    over = {"omega": kept}
    both = found["Froude_Krylov_force"] + found["diffraction_force"]
    forces = both.sel(complex="re") + 1j * both.sel(complex="im")
    place = int(np.argmin(np.abs(found["wave_direction"].values - np.radians(degrees))))
    matrices = [
        found[name].isel(over).sel(influenced_dof=dofs, radiating_dof=dofs)
        for name in ("added_mass", "radiation_damping")
    ]
    tables = [one.transpose("omega", "influenced_dof", "radiating_dof").values for one in matrices]
    pushed = forces.isel({**over, "wave_direction": place}).sel(influenced_dof=dofs)
    tables.append(pushed.transpose("omega", "influenced_dof").values)
    omega = found["omega"].values[kept]
    return [CubicSpline(omega, table)(2 * np.pi / period) for table in tables]


def impedance(names: list[str], added: np.ndarray, damping: np.ndarray, period: float) -> np.ndarray:
    """Of bodies with their own inertia, stiffness and damping in roll."""
    omega = 2 * np.pi / period
    whole = -(omega**2) * added - 1j * omega * damping
    for k, name in enumerate(names):
        inertia, stiffness = own(name)
        rows = slice(6 * k, 6 * k + 6)
        whole[rows, rows] += stiffness - omega**2 * inertia
        swings = inertia[3, 3] + added[rows, rows][3, 3]
        whole[rows, rows][3, 3] -= 2j * omega * ROLL * np.sqrt(stiffness[3, 3] * swings)
    return whole


def shown(folder: Path, degrees: float) -> None:
    """Print heave [m] and roll [deg] of the smaller per metre: alone, beside one held fast, both afloat."""
    for period in SHOWN:
        added, damping, forces = water(folder / "two.nc", [*HULLS], period, degrees)
        whole = impedance([*HULLS], added, damping, period)
        afloat = np.linalg.solve(whole, forces)[6:]
        held = np.linalg.solve(whole[6:, 6:], forces[6:])
        added, damping, forces = water(folder / "barge.nc", ["barge"], period, degrees)
        alone = np.linalg.solve(impedance(["barge"], added, damping, period), forces)
        heave = ", ".join(f"{abs(one[2]):.2f}" for one in (alone, held, afloat))
        roll = ", ".join(f"{np.degrees(abs(one[3])):.2f}" for one in (alone, held, afloat))
        print(f"{degrees:g} deg, {period:g} s: heave {heave}; roll {roll}")


if __name__ == "__main__":
    where = Path(sys.argv[1])
    bodies = {name: body(name) for name in HULLS}
    for name, one in bodies.items():
        computed(where / f"{name}.nc", one)
    computed(where / "two.nc", cpt.FloatingBody.join_bodies(*bodies.values()))
    for degrees in (90.0, 270.0):
        shown(where, degrees)
