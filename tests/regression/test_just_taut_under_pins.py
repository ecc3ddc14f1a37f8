"""`del` with an equalizing rope that is just taut under locking pins: "not settled in 3450 of 22750 steps".

Nothing stretches such a rope, so what it is stretched by is rounding of its own length, 1e-14 m, and it
pulled with 5e-8 N or hung slack by that. Forces were held against their laws to 1e-12 of these 1e-14 m: a
step took 43 factorisations on average, 100 over sheaves with losses and inertia, whose stick and slip was
decided by the same newtons, and many came to no end. Users were told to try a shorter step. Over light
sheaves with losses 130 of 22,500 steps came to no end for longer, where 1e-12 of the stretches of spans was
taken for their rounding: that is of their lengths.
"""

from __future__ import annotations

from pathlib import Path

import pytest

import gantline
from gantline.scenario import parse_scenario

LIFT = Path(__file__).parents[2] / "scenarios" / "equalizer_sling_cut" / "scenario.yaml"
SHEAVES = "efficiency: 1.0, rotating_mass: 0 kg"
METHOD = "\nsimulation: {integrator: del, step: 2 ms}\n"


@pytest.mark.parametrize(
    "sheaves", [SHEAVES, "efficiency: 0.98, rotating_mass: 0 kg", "efficiency: 0.98, rotating_mass: 100 kg"]
)
def test_what_rounding_decides_is_settled(sheaves: str) -> None:
    """Slings go taut under the pins and 300 t are hoisted: all steps settle, nearly all at once."""
    text = LIFT.read_text(encoding="utf-8")
    for old, new in (
        ("duration: 140 s", "duration: 45 s"),
        ("brake_from: 60 s", "brake_from: 40 s"),
        ("cut_at: 40 s, ", ""),
        ("locked: false", "locked: true"),
        (SHEAVES, sheaves),
    ):
        assert old in text
        text = text.replace(old, new)
    recording = gantline.simulate(parse_scenario(text + METHOD))
    counters = recording.attributes["counters"]
    assert counters["unconverged"] == 0
    assert counters["factorisations"] < 1.05 * counters["steps"]
    # The hook bears the load on its slings, and the rope nothing.
    assert float(recording.column("rope_tension", "sling.S1").max()) > 500e3
    assert float(recording.column("rope_tension", "e1.equalizing").max()) < 1e-6
