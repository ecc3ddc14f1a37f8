"""An hour of waves from abeam: what `docs/concepts/waves.md` has of the barge of `crane_barge_in_swell`.

    python -m tools.hour_from_abeam

Some four minutes of a processor for each of three: whose lines and hull take nothing, who has 5 % of what is
critical, and whom no drift forces push.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

from gantline import simulate

sys.path[:0] = [str(Path(__file__).resolve().parents[1] / "tests" / "support")]

from from_abeam import barge_from_abeam  # noqa: E402

_HOUR, _SAMPLES = 3600.0, 0.5  # [s]
_BARGES = {
    "lines and hull take nothing": {},
    "they take 5 %": {"damped": True},
    "no drift forces": {"drift": False},
}


def main() -> None:
    """Print standard deviations of sway and yaw, and the largest tension of a line, of each."""
    for name, given in _BARGES.items():
        recording = simulate(barge_from_abeam(**given), duration=_HOUR, sample_interval=_SAMPLES)
        sway = recording.column("body_position", "barge")[:, 1]
        w, x, y, z = recording.column("body_orientation", "barge").T
        yaw = np.degrees(np.arctan2(2 * (w * z + x * y), 1 - 2 * (y**2 + z**2)))
        peaks = [
            value for key, value in recording.metrics().items() if key.startswith("peak_mooring_tension.")
        ]
        print(f"{name}: sway {sway.std():.2f} m, yaw {yaw.std():.2f} deg, line {max(peaks) / 1e3:.0f} kN")


if __name__ == "__main__":
    main()
