"""Forces of waves on a ship's section across a wave flume, as measured, and mean forces by gantline."""

from __future__ import annotations

import csv
import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import gantline
from ship_section import LENGTH, lift

FILE = Path(__file__).parents[1] / "validation" / "section_drift.csv"
DENSITY, G = 1000.0, 9.81
#: Set-ups of the section by what is held, and which of sway, heave and roll, 0 to 2, are then free.
SET_UPS = {
    "held": (),
    "free": (0, 1, 2),
    "roll held": (0, 1),
    "heave held": (0, 2),
    "sway held": (1, 2),
}
#: Of the waves [rad/s].
RECORDED = (
    4.143, 4.952, 5.075, 5.194, 5.311, 5.425, 5.646, 5.860, 6.065, 7.004, 7.830, 8.578, 9.265, 9.905,
)  # fmt: skip


@dataclass(frozen=True)
class Pushed:
    """A mean force of regular waves on the section.

    Attributes:
        set_up: Of `SET_UPS`.
        frequency: Of the waves [rad/s].
        amplitude: Of the waves without the section [m].
        forces: With the waves, one of each record [N].
    """

    set_up: str
    frequency: float
    amplitude: float
    forces: tuple[float, ...]

    @property
    def period(self) -> float:
        """Of the waves [s]."""
        return math.tau / self.frequency

    @property
    def breaks(self) -> bool:
        """Whether waves are so steep that those thrown back by the held section and they seem to break."""
        return self.set_up == "held" and _steep(self.period, self.amplitude)

    @property
    def whole(self) -> float:
        """½ρga² per metre, with which waves push that are thrown back whole [N]."""
        return DENSITY * G * self.amplitude**2 / 2 * LENGTH

    @property
    def share(self) -> float:
        """Of that force, the mean of the records."""
        return sum(self.forces) / len(self.forces) / self.whole

    @property
    def name(self) -> str:
        """In words."""
        return f"{self.set_up}, {self.period:.3f} s, {1e3 * self.amplitude:.1f} mm"


#: Sundsdal, Greco, Hanssen and Lugni (2025), https://github.com/KRSundsdal1/2D-ship-cross-section-in-regular-waves
#: under CC0 1.0: means by least squares over whole periods, from five and a half periods after the front of
#: the waves until what the section has thrown back returns from the wave maker, less what the sensor has
#: before the waves; waves by probe 4 of the runs without the section. Of the held section `Fy` of the
#: transducer, else `Force_Sway` of the rail, turned to be with the waves. Windows of less than two periods
#: are left out.
MEASURED = (
    Pushed("held", 4.952, 20.14e-3, (0.929,)),
    Pushed("held", 5.075, 11.98e-3, (0.297,)),
    Pushed("held", 5.194, 12.08e-3, (0.335,)),
    Pushed("held", 5.311, 19.97e-3, (1.036,)),
    Pushed("held", 5.425, 19.89e-3, (1.088,)),
    Pushed("held", 5.646, 19.92e-3, (1.053,)),
    Pushed("held", 5.86, 11.96e-3, (0.418,)),
    Pushed("held", 5.86, 19.84e-3, (1.031,)),
    Pushed("held", 6.065, 11.91e-3, (0.378, 0.387, 0.361, 0.385)),
    Pushed("held", 6.065, 19.76e-3, (1.133,)),
    Pushed("held", 7.004, 12.33e-3, (0.397, 0.418)),
    Pushed("held", 7.004, 20.06e-3, (1.049,)),
    Pushed("held", 7.83, 11.90e-3, (0.392, 0.426, 0.389, 0.393)),
    Pushed("held", 7.83, 19.82e-3, (1.146, 1.151)),
    Pushed("held", 8.578, 11.56e-3, (0.325, 0.350, 0.384)),
    Pushed("held", 8.578, 19.74e-3, (1.071,)),
    Pushed("held", 9.265, 12.08e-3, (0.342, 0.406)),
    Pushed("held", 9.265, 19.78e-3, (0.939,)),
    Pushed("held", 9.905, 12.48e-3, (0.486, 0.465)),
    Pushed("held", 9.905, 20.27e-3, (1.061, 1.055)),
    Pushed("free", 5.075, 11.98e-3, (0.211,)),
    Pushed("free", 5.194, 12.08e-3, (0.249,)),
    Pushed("free", 5.425, 11.99e-3, (0.360, 0.341)),
    Pushed("free", 7.004, 12.33e-3, (0.306, 0.305)),
    Pushed("free", 7.004, 20.06e-3, (0.806, 0.810, 0.804, 0.814)),
    Pushed("free", 7.83, 11.90e-3, (0.283,)),
    Pushed("free", 9.905, 20.27e-3, (1.056,)),
    Pushed("roll held", 4.952, 12.02e-3, (0.118, 0.079)),
    Pushed("roll held", 5.194, 12.08e-3, (0.143,)),
    Pushed("roll held", 5.425, 11.99e-3, (0.248, 0.223)),
    Pushed("roll held", 5.86, 11.96e-3, (0.388,)),
    Pushed("roll held", 7.004, 12.33e-3, (0.328,)),
    Pushed("roll held", 7.83, 11.90e-3, (0.312,)),
    Pushed("roll held", 9.265, 12.08e-3, (0.371,)),
    Pushed("heave held", 4.952, 12.02e-3, (0.188,)),
    Pushed("heave held", 5.194, 12.08e-3, (0.093,)),
    Pushed("heave held", 5.425, 11.99e-3, (0.089, 0.070)),
    Pushed("heave held", 5.86, 11.96e-3, (0.110, 0.120)),
    Pushed("heave held", 6.065, 11.91e-3, (0.148,)),
    Pushed("heave held", 7.004, 12.33e-3, (0.244, 0.229)),
    Pushed("heave held", 7.83, 11.90e-3, (0.258,)),
    Pushed("heave held", 8.578, 11.56e-3, (0.291,)),
    Pushed("heave held", 9.265, 12.08e-3, (0.375, 0.360)),
    Pushed("sway held", 5.194, 12.08e-3, (0.137, 0.139)),
    Pushed("sway held", 5.425, 11.99e-3, (0.131,)),
    Pushed("sway held", 5.86, 11.96e-3, (0.341, 0.344)),
    Pushed("sway held", 6.065, 11.91e-3, (0.343,)),
    Pushed("sway held", 7.004, 12.33e-3, (0.401,)),
    Pushed("sway held", 7.83, 11.90e-3, (0.404, 0.406)),
    Pushed("sway held", 8.578, 11.56e-3, (0.371,)),
)


@dataclass(frozen=True)
class Shaken:
    """Amplitudes of forces of regular waves on the held section, over that of the waves.

    Attributes:
        frequency: Of the waves [rad/s].
        amplitude: Of the waves without the section [m].
        sway, heave: Means of the records [N/m].
    """

    frequency: float
    amplitude: float
    sway: float
    heave: float

    @property
    def period(self) -> float:
        """Of the waves [s]."""
        return math.tau / self.frequency

    @property
    def breaks(self) -> bool:
        """Whether waves are so steep that those thrown back and they seem to break."""
        return _steep(self.period, self.amplitude)


def _steep(period: float, amplitude: float) -> bool:
    """Waves of 20 mm below 0.7 s."""
    return period < 0.7 and amplitude > 0.015


#: From the same records and windows: `Fy` and `Fz`.
FORCES = (
    Shaken(4.143, 19.44e-3, 1706.0, 1414.0),
    Shaken(4.952, 20.14e-3, 1803.0, 1125.0),
    Shaken(5.075, 11.98e-3, 1799.0, 1072.0),
    Shaken(5.194, 12.08e-3, 1771.0, 1017.0),
    Shaken(5.311, 19.97e-3, 1789.0, 1008.0),
    Shaken(5.425, 19.89e-3, 1785.0, 982.0),
    Shaken(5.646, 19.92e-3, 1728.0, 900.0),
    Shaken(5.86, 11.96e-3, 1707.0, 857.0),
    Shaken(5.86, 19.84e-3, 1706.0, 857.0),
    Shaken(6.065, 11.91e-3, 1656.0, 799.0),
    Shaken(6.065, 19.76e-3, 1650.0, 798.0),
    Shaken(7.004, 12.33e-3, 1454.0, 591.0),
    Shaken(7.004, 20.06e-3, 1445.0, 589.0),
    Shaken(7.83, 11.90e-3, 1302.0, 452.0),
    Shaken(7.83, 19.82e-3, 1271.0, 442.0),
    Shaken(8.578, 11.56e-3, 1170.0, 332.0),
    Shaken(8.578, 19.74e-3, 1085.0, 311.0),
    Shaken(9.265, 12.08e-3, 1032.0, 200.0),
    Shaken(9.265, 19.78e-3, 871.0, 180.0),
    Shaken(9.905, 12.48e-3, 895.0, 136.0),
    Shaken(9.905, 20.27e-3, 630.0, 99.0),
)


def drift(set_up: str) -> tuple[np.ndarray, np.ndarray]:
    """Frequencies [rad/s], and mean forces of waves of 1 m by `tools/section_drift.py` [N/m²]."""
    with FILE.open(encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    columns = [[float(row[name]) for row in rows] for name in ("frequency [rad/s]", set_up)]
    return np.array(columns[0]), np.array(columns[1])


def simulated(folder: Path, set_up: str, frequency: float, amplitude: float) -> float:
    """Mean force of waves on the section, by its springs over the last fifteen waves of 40 [N].

    Of 30 where it is held, which leaves the same to four digits. So does a hundredth of a newton, a hundred
    times the usual tolerance, where sway and roll are free, in many times the steps of others.
    """
    frequencies, forces = drift(set_up)
    period, waves = math.tau / frequency, 30 if set_up == "held" else 40
    held = {"held": "all", "free": None}.get(set_up, set_up.removesuffix(" held"))
    path = lift(
        folder,
        period,
        held,
        drift=float(np.interp(frequency, frequencies, forces)),
        waves={"regular": {"height": f"{2 * amplitude} m", "period": f"{period} s", "direction": "90 deg"}},
        duration=f"{waves * period} s",
    )
    tolerance = 0.01 if set_up == "heave held" else None
    run = gantline.simulate(path, sample_interval=period / 40, tension_tolerance=tolerance)
    # The end of a period is the beginning of the next: either, not both.
    late = run.time > run.time[-1] - 15 * period + 1e-9
    pulls = [run.column("rope_tension", f"mooring.{line}")[late].mean() for line in ("behind", "ahead")]
    return float(pulls[0] - pulls[1])
