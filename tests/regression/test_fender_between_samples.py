"""A bump on a fender between samples.

Fender forces are those of samples. A barge of 12 300 t that wind presses against two fenders rebounds within
1.7 s and puts 3.67 MN on each; with samples 1 s apart it was 2.75 MN, 78 % of what they take in place of
105 %, and nothing said so.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from afloat import LENGTH, barge, lift_of, written
from gantline.checks import Verdict
from gantline.results.recording import Recording
from gantline.simulation import simulate
from of_recording import checks_of


def run_of(folder: Path, apart: str, stiffness: str = "20 MN/m") -> Recording:
    """Wind presses the barge 1 m to port, to where a wall faces it."""
    side = {"area": "2000 m^2", "coefficient": "1.2", "along": "y", "at": [f"{LENGTH / 2} m", "0 m", "8 m"]}
    fender: dict[str, Any] = {
        "vessel": "barge",
        "wall": ["0 m", "16 m"],
        "facing": "-90 deg",
        "stiffness": stiffness,
        "capacity": "3.5 MN",
    }
    given = lift_of(
        barge(wind_areas={"side": side}),
        duration="30 s",
        start="as_given",
        wind={"speed": "20 m/s", "direction": "90 deg"},
        fenders={name: {**fender, "at": [f"{x} m", "15 m", "4 m"]} for name, x in (("aft", 10), ("bow", 90))},
        simulation={"sample_interval": apart},
    )
    return simulate(written(folder, given))


def told(run: Recording) -> list[str]:
    return [one for one in run.attributes["warnings"] if one.startswith("samples")]


def test_a_bump_that_samples_miss_is_told(tmp_path: Path) -> None:
    """Of half a swing of the length D samples Δt apart have at least cos(πΔt/2D) of its peak. Both beside the
    largest are above 80 % of it, cos(πΔt/D), where that is 95 %.
    """
    fine, coarse = run_of(tmp_path, "0.02 s"), run_of(tmp_path, "1 s")
    forces = [run.column("fender_force", "aft").max() for run in (fine, coarse)]
    assert forces[0] > 3.5e6
    assert forces[1] < 0.8 * forces[0]
    assert not told(fine)
    (said,) = told(coarse)
    assert said.startswith("samples 1.00 s apart miss the peaks of fenders: aft has ")
    assert said.endswith("a shorter 'sample_interval' has more of them")
    (check,) = checks_of(fine, "fender_force_of_capacity")
    assert check.verdict is Verdict.FAILED


def test_a_soft_fender_needs_fewer(tmp_path: Path) -> None:
    """A soft fender: 5.0 s for half a swing of 12 300 t on 4.8 MN/m."""
    assert not told(run_of(tmp_path, "0.5 s", "2.4 MN/m"))


def test_samples_that_have_it_are_silent(tmp_path: Path) -> None:
    """Nine of them in half a swing."""
    assert not told(run_of(tmp_path, "0.2 s"))
