"""A bump on a fender between samples.

Fender forces were those of samples. A barge of 12 300 t that wind presses against two fenders rebounds within
1.7 s and puts 3.67 MN on each; with samples 1 s apart it was 2.75 MN, 78 % of what they take in place of
105 %. First nothing said so, then a warning asked for closer samples; now the peak is that of all steps.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from afloat import LENGTH, barge, lift_of, written
from gantline.checks import Verdict
from gantline.report.afloat import afloat_facts
from gantline.report.subject import Subject
from gantline.results.loads.contact_peaks import contact_peak
from gantline.results.recording import Recording
from gantline.simulation import simulate
from of_recording import checks_of


def run_of(folder: Path, apart: str, integrator: str) -> Recording:
    """Wind presses the barge 1 m to port, to where a wall faces it."""
    side = {"area": "2000 m^2", "coefficient": "1.2", "along": "y", "at": [f"{LENGTH / 2} m", "0 m", "8 m"]}
    fender: dict[str, Any] = {
        "vessel": "barge",
        "wall": ["0 m", "16 m"],
        "facing": "-90 deg",
        "stiffness": "20 MN/m",
        "capacity": "3.5 MN",
    }
    given = lift_of(
        barge(wind_areas={"side": side}),
        duration="30 s",
        start="as_given",
        wind={"speed": "20 m/s", "direction": "90 deg"},
        fenders={name: {**fender, "at": [f"{x} m", "15 m", "4 m"]} for name, x in (("aft", 10), ("bow", 90))},
        simulation={"sample_interval": apart, "integrator": integrator},
    )
    return simulate(written(folder, given))


@pytest.mark.parametrize("integrator", ["adaptive", "del"])
def test_a_bump_between_samples_counts(tmp_path: Path, integrator: str) -> None:
    """Its peak is that of all steps: with samples 0.02 s and 1 s apart it is the same to rounding."""
    fine, coarse = (run_of(tmp_path, apart, integrator) for apart in ("0.02 s", "1 s"))
    sampled = coarse.column("fender_force", "aft").max()
    for fender in fine.rig.fenders:
        force, time = contact_peak(fine, fender.contact)
        of_few, when = contact_peak(coarse, fender.contact)
        assert of_few == pytest.approx(force, rel=1e-3)
        assert when == pytest.approx(time, abs=0.02)
        assert force > 3.5e6 and sampled < 0.8 * force
    for run in (fine, coarse):
        (check,) = checks_of(run, "fender_force_of_capacity")
        assert check.verdict is Verdict.FAILED
        largest = max(contact_peak(run, fender.contact)[0] for fender in run.rig.fenders)
        assert check.value == pytest.approx(largest / 3.5e6, rel=1e-9)
    facts = dict(afloat_facts(Subject(coarse)))
    assert f"{100 * largest / 3.5e6:.0f} % of capacity" in facts["largest fender force"]
