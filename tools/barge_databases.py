"""Hydrodynamic databases of the barges of `crane_barge_in_swell` and `off_a_barge`, by Capytaine.

    pip install capytaine==3.0.0        in an environment of its own: gantline does not need it
    python tools/barge_databases.py

A boundary element method. Meshes are the boxes below the water, with a lid inside against irregular
frequencies; reference points are the middles of the waterlines. Each barge is computed by itself, and both as
they lie in `off_a_barge`. Drift forces are those of the crane barge as it floats with its crane and what
hangs from it, without moorings. Some ten minutes.
"""

from dataclasses import dataclass
from pathlib import Path

import capytaine as cpt
import numpy as np
import xarray as xr
from capytaine.post_pro import far_field_mean_drift_force, rao

LENGTH, BREADTH, DRAFT = 90.0, 30.0, 3.0
DENSITY, GRAVITY = 1025.0, 9.81
#: [s]; faces of 1.25 m by 1.25 m or less are an eleventh of the shortest wave. With 1.7 m by 1.5 m A and B of
#: surge and pitch, equal by nature, differed by 3.5 % of the largest, now by 0.6 %.
PERIODS = [*np.arange(3.0, 9.1, 0.5), 10.0, 11.0, 12.5, 14.5, 18.0, 25.0]
#: More of them for two barges [s]: the water in the gap of 1 m between them swings at 3.8 s.
OF_THE_GAP = [*np.arange(3.1, 4.45, 0.1), 4.25, 4.75]
#: Radius of the faces of their lids [m].
OF_LID = 2.0
#: Directions in which waves that bodies send out are known [rad], a little beyond a turn as Capytaine asks.
AROUND = np.radians(np.arange(-4.0, 364.1, 2.0))
SCENARIOS = Path(__file__).parents[1] / "scenarios"

#: What floats of the crane barge, as its scenario has it: mass [t], place from stern and keel [m], inertia
#: about its own centre of gravity [t m²]. The module, with hook block and falls, is at the boom head, from
#: where it hangs.
_BOOM = np.radians(65.0)
_ON_DECK = 7910.0
FLOATS = [
    (_ON_DECK, (42.542, 0.0, 3.073), _ON_DECK * np.square([10.0, 26.0, 27.0])),
    (
        190.0,
        (84.0 + 0.48 * 55.0 * np.cos(_BOOM), 0.0, 7.5 + 0.48 * 55.0 * np.sin(_BOOM)),
        48000.0 * np.array([np.sin(_BOOM) ** 2, 1.0, np.cos(_BOOM) ** 2]),
    ),
    (25.0 + 13.0 + 121.0, (84.0 + 55.0 * np.cos(_BOOM), 0.0, 7.5 + 55.0 * np.sin(_BOOM)), np.zeros(3)),
]


def inertia() -> np.ndarray:
    """Of all that floats, about the reference point (6, 6) [kg, kg m, kg m²]."""
    total = np.zeros((6, 6))
    for mass, place, own in FLOATS:
        x, y, z = np.array(place) - [LENGTH / 2, 0.0, DRAFT]
        cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
        total[:3, :3] += mass * np.eye(3)
        total[:3, 3:] -= mass * cross
        total[3:, :3] += mass * cross
        total[3:, 3:] += np.diag(own) - mass * cross @ cross
    return 1e3 * total


def stiffness() -> np.ndarray:
    """Of the weight of all that floats and the water under a box (6, 6) [N/m, N m]."""
    area, weight = LENGTH * BREADTH, DENSITY * GRAVITY
    moment = 1e3 * GRAVITY * sum(mass * (place[2] - DRAFT) for mass, place, _ in FLOATS)
    found = np.zeros((6, 6))
    found[2, 2] = weight * area
    found[3, 3] = weight * area * (BREADTH**2 / 12 - DRAFT**2 / 2) - moment
    found[4, 4] = weight * area * (LENGTH**2 / 12 - DRAFT**2 / 2) - moment
    return found


@dataclass(frozen=True)
class Barge:
    """A box.

    Attributes:
        size: Length, breadth and draft [m].
        faces: Along them; as many above the water, which are taken off.
    """

    size: tuple[float, float, float]
    faces: tuple[int, int, int]

    def body(
        self,
        name: str,
        at: tuple[float, float] = (0.0, 0.0),
        heading: float = 0.0,
        of_lid: float | None = None,
    ) -> cpt.FloatingBody:
        """Its hull below the water and a lid inside.

        Args:
            name: Of the body.
            at: Middle of its waterline [m].
            heading: Of its length [rad].
            of_lid: Radius of faces of the lid [m]; as those of the hull if not given.
        """
        length, breadth, draft = self.size
        box = cpt.mesh_parallelepiped(size=(length, breadth, 2 * draft), resolution=self.faces)
        below = box.immersed_part()
        hull, lid = (
            mesh.rotated_z(heading).translated((*at, 0.0))
            for mesh in (below, below.generate_lid(z=-0.05, faces_max_radius=of_lid))
        )
        dofs = cpt.rigid_body_dofs(rotation_center=(*at, 0.0))
        return cpt.FloatingBody(mesh=hull, lid_mesh=lid, dofs=dofs, name=name)


CRANE_BARGE = Barge((LENGTH, BREADTH, DRAFT), (72, 24, 8))
CARGO_BARGE = Barge((60.0, 24.0, 2.0), (48, 24, 6))


def computed(
    body: cpt.FloatingBody, periods: list[float], directions: np.ndarray, around: np.ndarray | None = None
) -> xr.Dataset:
    """What waves do to a body, or to several joined ones, and they to the water.

    Args:
        body: Of one hull or more.
        periods: Of waves [s].
        directions: Of waves [rad].
        around: Directions in which waves that it sends out are wanted, if they are [rad].
    """
    coords = {
        "omega": 2 * np.pi / np.unique(np.round(periods, 3))[::-1],
        "wave_direction": directions,
        "radiating_dof": list(body.dofs),
        "water_depth": [np.inf],
        "rho": [DENSITY],
        "g": [GRAVITY],
    }
    if around is not None:
        coords["theta"] = around
    found: xr.Dataset = cpt.BEMSolver().fill_dataset(xr.Dataset(coords=coords), body)
    return found


def with_drift(found: xr.Dataset) -> xr.Dataset:
    """Of the crane barge, with mean drift forces in place of the waves that it sends out."""
    motions = ("influenced_dof", "radiating_dof")
    found["inertia_matrix"], found["hydrostatic_stiffness"] = (motions, inertia()), (motions, stiffness())
    pairs = far_field_mean_drift_force(rao(found), found)
    # Of waves that go together with themselves alone; waves that bodies send out are not needed any more.
    for name, table in pairs.items():
        over = table.squeeze().transpose("omega", "wave_direction_k", "wave_direction_l").values
        found[name] = ("omega", "wave_direction"), np.einsum("nkk->nk", over).real
    return found.drop_dims("theta")


if __name__ == "__main__":
    half, whole = np.radians(np.arange(0, 181, 15)), np.radians(np.arange(0, 360, 15))
    crane = computed(CRANE_BARGE.body("barge"), PERIODS, half, AROUND)
    cpt.export_dataset(SCENARIOS / "crane_barge_in_swell" / "crane_barge.nc", with_drift(crane))
    cargo = computed(CARGO_BARGE.body("barge"), PERIODS, half)
    cpt.export_dataset(SCENARIOS / "off_a_barge" / "cargo_barge.nc", cargo)
    # Places and headings of the scenario. Lids need no finer faces than keep what goes on inside away from
    # the waves of the sea, and cost time.
    both = cpt.FloatingBody.join_bodies(
        CRANE_BARGE.body("barge", (LENGTH / 2, 0.0), of_lid=OF_LID),
        CARGO_BARGE.body("cargo", (103.0, 0.0), np.pi / 2, of_lid=OF_LID),
    )
    # `excitation_force` is the sum of two others.
    together = computed(both, PERIODS + OF_THE_GAP, whole).drop_vars("excitation_force")
    # What bodies do to each other is alike there and back by nature. With these faces it differs by up to
    # 6.4 % of the diagonal, at 3.2 s; gantline takes the mean, and would warn of that in each run.
    for name in ("added_mass", "radiation_damping"):
        matrices = together[name].transpose("omega", "influenced_dof", "radiating_dof")
        values = matrices.values
        together[name] = matrices.dims, (values + values.transpose(0, 2, 1)) / 2
    cpt.export_dataset(SCENARIOS / "off_a_barge" / "both_barges.nc", together)
