"""Work of waves that was called energy from nowhere.

The first page of `crane_barge_in_swell`, whose balance closes to 3e-11, said "GAINS ENERGY from 13.70 s on:
up to 5.18 % of the largest energy comes from no drive": what wind, current and waves put in stands under
`fluid_work`, and was not counted among the work done.
"""

from __future__ import annotations

import numpy as np

from gantline.results.recording import Recording
from gantline.results.stability import stability_of
from gantline.results.variable import Variable
from sample_lift import sample_recording


def pushed(**energy: list[float]) -> Recording:
    """A recording with these energies [J] and all other kinds zero."""
    recording = sample_recording(np.arange(5.0), tension=np.zeros((5, 5)))
    kinds = ("kinetic", "gravity", "elastic", "fluid", "drive_work", "fluid_work")
    values = np.stack([np.array(energy.get(kind, [0.0] * 5)) for kind in kinds], axis=1)
    variables = {**recording.variables, "energy": Variable(("time", "energy_kind"), values, "J", "energy")}
    coordinates = {**recording.coordinates, "energy_kind": kinds}
    return Recording(variables, coordinates, recording.attributes)


def test_what_waves_put_in_is_no_energy_from_nowhere() -> None:
    """100 J of kinetic energy from 100 J of work of the waves: nothing came from nowhere."""
    found = stability_of(
        pushed(kinetic=[0.0, 25.0, 50.0, 75.0, 100.0], fluid_work=[0.0, 25.0, 50.0, 75.0, 100.0])
    )
    assert (found.energy_gain, found.energy_gain_time) == (0.0, None)


def test_more_than_waves_put_in_is() -> None:
    """100 J of kinetic energy of which waves put in 80: 20 J of 100 + 80 at most are from nowhere, 1/9."""
    found = stability_of(
        pushed(kinetic=[0.0, 20.0, 40.0, 60.0, 100.0], fluid_work=[0.0, 20.0, 40.0, 60.0, 80.0])
    )
    assert found.energy_gain is not None and abs(found.energy_gain - 20.0 / 180.0) < 1e-12
    assert found.energy_gain_time == 4.0
