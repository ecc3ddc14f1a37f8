"""A ship's section that floats across a wave flume, as it was measured and as a lift file."""

from __future__ import annotations

import dataclasses
import json
import math
import shutil
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import h5py
import numpy as np

import gantline
from gantline.hydro import HydrodynamicDatabase, read_database, write_database
from gantline.hydro.database.model import DRIFTING
from waves import harmonic

#: Its sizes along the flume, across it, to the water and to the deck, radius of the bilges [m]; mass [kg];
#: centre of gravity above the keel, as measured, and radius of gyration in roll [m].
BREADTH, LENGTH, DRAFT, HEIGHT, BILGE = 0.40, 0.586, 0.20, 0.256, 0.0512
MASS, KG, ROLLS = 46.8, 0.106, 0.36 * BREADTH
#: Of two springs in sway, together [N/m], and of the guides in sway and heave [N s/m].
SPRINGS, GUIDES = 59.5, 8.7
FILE = Path(__file__).parents[1] / "validation" / "section_in_flume.nc"
#: Of a line to its far end [m].
_FAR = 20.0
_PERIODS = 45


@dataclass(frozen=True)
class Measured:
    """Motions of the section in regular waves: amplitudes over that of the waves, roll over their slope too.

    Attributes:
        held: The motion that is held, if one is.
        frequency: Of the waves [rad/s].
        amplitude: Of the waves without the section [m].
        sway, heave, roll: means of the records; None where the motion is held.
    """

    held: str | None
    frequency: float
    amplitude: float
    sway: float | None
    heave: float
    roll: float | None

    @property
    def period(self) -> float:
        """Of the waves [s]."""
        return 2 * math.pi / self.frequency

    @property
    def name(self) -> str:
        """In words."""
        held = f"{self.held} held" if self.held else "free"
        return f"{held}, {self.period:.3f} s, {1e3 * self.amplitude:.1f} mm"


#: Sundsdal, Greco, Hanssen and Lugni (2025), https://github.com/KRSundsdal1/2D-ship-cross-section-in-regular-waves
#: under CC0 1.0: amplitudes by least squares over two periods at a time, their mean over the window from five
#: periods after the front of the waves until what the section has thrown back returns from the wave maker;
#: waves by probe 4 of the runs without the section. Of two records and more their mean.
MEASURED = (
    Measured(None, 4.143, 19.58e-3, 0.963, 1.258, 2.407),
    Measured(None, 5.075, 12.02e-3, 0.572, 1.545, 6.927),
    Measured(None, 5.194, 12.03e-3, 0.348, 1.621, 5.861),
    Measured(None, 5.425, 11.97e-3, 0.326, 1.627, 3.283),
    Measured(None, 7.004, 12.32e-3, 0.390, 0.305, 0.327),
    Measured(None, 7.004, 20.05e-3, 0.387, 0.301, 0.332),
    Measured(None, 7.830, 11.87e-3, 0.282, 0.132, 0.169),
    Measured(None, 9.905, 20.28e-3, 0.181, 0.023, 0.046),
    Measured("roll", 4.952, 12.05e-3, 0.697, 1.573, None),
    Measured("roll", 5.194, 12.03e-3, 0.638, 1.729, None),
    Measured("roll", 5.425, 11.97e-3, 0.616, 1.706, None),
    Measured("roll", 5.860, 11.96e-3, 0.570, 1.221, None),
    Measured("roll", 7.004, 12.32e-3, 0.441, 0.321, None),
    Measured("roll", 7.830, 11.87e-3, 0.340, 0.152, None),
    Measured("roll", 9.265, 12.08e-3, 0.251, 0.060, None),
    Measured("sway", 5.194, 12.03e-3, None, 1.592, 6.877),
    Measured("sway", 5.425, 11.97e-3, None, 1.595, 4.588),
    Measured("sway", 5.860, 11.96e-3, None, 1.128, 2.107),
    Measured("sway", 6.065, 11.90e-3, None, 0.853, 1.517),
    Measured("sway", 7.004, 12.32e-3, None, 0.293, 0.499),
    Measured("sway", 7.830, 11.87e-3, None, 0.131, 0.230),
    Measured("sway", 8.578, 11.58e-3, None, 0.069, 0.141),
)


def simulated(folder: Path, frequency: float, amplitude: float, held: str | None) -> tuple[float, ...]:
    """Sway, heave and roll as in `Measured`, of the last ten waves of 45."""
    period = 2 * math.pi / frequency
    sea = {"regular": {"height": f"{2 * amplitude} m", "period": f"{period} s", "direction": "90 deg"}}
    path = lift(folder, period, held, waves=sea, duration=f"{_PERIODS * period} s")
    run = gantline.simulate(path, sample_interval=period / 40)
    late = run.time > run.time[-1] - 10 * period - 1e-9
    place = run.variables["body_position"].values[late, 0]
    rolled = 2 * run.variables["body_orientation"].values[late, 0, 1]
    found = [harmonic(run.time[late], values, frequency) for values in (place[:, 1], place[:, 2], rolled)]
    sway, heave, roll = np.abs(found) / amplitude
    return float(sway), float(heave), float(roll) / wave_number(frequency)


def wave_number(frequency: float, depth: float = 1.0) -> float:
    """Of ω² = g k tanh(k h) [1/m]."""
    k = frequency**2 / 9.81
    for _ in range(30):
        tanh = math.tanh(k * depth)
        k -= (9.81 * k * tanh - frequency**2) / (9.81 * tanh + 9.81 * k * depth * (1 - tanh**2))
    return k


def lift(
    folder: Path, period: float, held: str | None = None, drift: float | None = None, **given: Any
) -> Path:
    """A lift file: water of one period [s], springs and guides as lines, a motion that is held or all.

    With `drift`, the mean force of waves of 1 m [N/m²], waves have that, whatever their frequency.
    """
    # Files that stay as they are, for lifts of one folder, are read once.
    hull, water = folder / "section.obj", folder / (FILE.name if drift is None else f"drift {drift!r}.nc")
    if not hull.exists():
        _write_hull(hull)
    if not water.exists():
        _write_water(water, drift)
    by_file = {"database": water.name, "at": ["0 m", "0 m", f"{DRAFT} m"]}
    of_period = {**by_file, "period": f"{period} s"}
    # A motion is held by springs a thousand times as stiff, or by a thousand times the inertia.
    fixed = held in ("sway", "all")
    stiffness, damping = (500 * SPRINGS, 0.01) if fixed else (SPRINGS / 2, GUIDES / SPRINGS)
    radii = ["5 m"] * 3 if held in ("roll", "all") else [f"{ROLLS} m", "0.2 m", "0.2 m"]
    pulled = 0.6e-3 * stiffness if fixed else 0.25 * stiffness
    # 1 N/m beside the 2.3 kN/m of the water, or hundreds of times as much, from so far above and below that
    # their pull does not count in sway.
    guided, taut, far = (1e6, 100.0, 100 * _FAR) if held in ("heave", "all") else (1.0, 1.0, _FAR)
    guides = {"guide": far, **({"below": -far} if guided > 1 else {})}
    centre = ["0 m", "0 m", f"{KG} m"]
    springs = {
        name: {
            "vessel": "section",
            "fairlead": centre,
            "to": ["0 m", f"{side * _FAR} m", f"{KG - DRAFT} m"],
            "rope": "spring",
            "pretension": f"{pulled} N",
            "type": "spring",
        }
        for name, side in (("ahead", 1), ("behind", -1))
    }
    upright = {
        name: {
            "vessel": "section",
            "fairlead": centre,
            "to": ["0 m", "0 m", f"{height} m"],
            "rope": "guide",
            "pretension": f"{taut} N",
            "type": "spring",
        }
        for name, height in guides.items()
    }
    whole = {
        "format": 1,
        "lift": {"title": "A ship's section across a wave flume"},
        "duration": "1 s",
        "start": "rest",
        "water": {"density": "1000 kg/m^3"},
        "ropes": {
            "spring": {
                "axial_stiffness": f"{stiffness * _FAR} N",
                "damping_time": f"{damping} s",
                "mass": "none",
            },
            "guide": {
                "axial_stiffness": f"{guided * far} N",
                "damping_time": f"{GUIDES / guided} s",
                "mass": "none",
            },
        },
        "vessels": {
            "section": {
                "position": ["0 m", "0 m"],
                "draft": f"{DRAFT} m",
                "hull": {"mesh": "section.obj", "units": "m", "up": "z"},
                "masses": {"all": {"mass": f"{MASS} kg", "at": centre}},
                "radii_of_gyration": radii,
                "added_mass": of_period,
                "water_damping": of_period,
                **({"wave_forces": {**by_file, "drift": drift is not None}} if "waves" in given else {}),
            }
        },
        "mooring_lines": {**springs, **upright},
        **given,
    }
    path = folder / "lift.yaml"
    path.write_text(json.dumps(whole), encoding="utf-8")
    return path


def _write_water(path: Path, drift: float | None) -> None:
    """The database, with a mean force of waves of 1 m from either side, if there is one."""
    if drift is None:
        path.write_bytes(FILE.read_bytes())
        return
    database = _measured_in()
    forces = np.zeros((len(database.frequencies), len(database.directions), 3))
    forces[:, :, 1] = drift * np.sin(database.directions)
    one = path.with_name("drift.nc")
    if not one.exists():
        write_database(dataclasses.replace(database, drift=forces), one)
    # Forces of another size in a copy take a tenth of the time of another file.
    shutil.copyfile(one, path)
    with h5py.File(path, "r+") as file:
        file[f"drift_force_{DRIFTING[1]}"][: len(forces)] = forces[:, :, 1]


@cache
def _measured_in() -> HydrodynamicDatabase:
    """The database of the section, read once."""
    return read_database(FILE)


def outline(element: float = 0.008) -> Any:
    """Corners of it below the water, from its waterline at +y over the bottom to −y (n, 2) [m]."""
    half = BREADTH / 2
    bend = np.linspace(0.0, np.pi / 2, round(np.pi / 2 * BILGE / element) + 1)
    side = np.linspace(0.0, BILGE - DRAFT, round((DRAFT - BILGE) / element) + 1)
    bottom = np.linspace(half - BILGE, 0.0, round((half - BILGE) / element) + 1)
    bilge = np.stack([np.cos(bend) - 1.0, 1.0 - DRAFT / BILGE - np.sin(bend)], axis=1) * BILGE + [half, 0.0]
    right = np.vstack(
        [
            np.stack([np.full(len(side), half), side], axis=1),
            bilge[1:],
            np.stack([bottom, np.full(len(bottom), -DRAFT)], axis=1)[1:],
        ]
    )
    return np.vstack([right, (right * [-1.0, 1.0])[-2::-1]])


def _write_hull(path: Path) -> None:
    """The section as a prism from −x to +x, its keel at z = 0."""
    below = outline() + np.array([0.0, DRAFT])
    section = np.vstack([[BREADTH / 2, HEIGHT], below, [-BREADTH / 2, HEIGHT]])
    count = len(section)
    ends = [(end * LENGTH / 2, y, z) for end in (-1, 1) for y, z in section]
    middles = [(end * LENGTH / 2, 0.0, HEIGHT / 2) for end in (-1, 1)]
    faces = []
    for one in range(count):
        other = (one + 1) % count
        faces += [(one, count + other, other), (one, count + one, count + other)]
        faces += [(2 * count, one, other), (2 * count + 1, count + other, count + one)]
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in np.array(ends + middles).tolist()]
    lines += ["f " + " ".join(str(corner + 1) for corner in face) for face in faces]
    path.write_text("\n".join(lines), encoding="utf-8")
