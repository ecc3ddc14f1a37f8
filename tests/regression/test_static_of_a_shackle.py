"""Shackles of a lift whose rules have no dynamic amplification factor.

The dynamic load of a shackle is the larger of peak and static load then, and the static one is that of the
design weight. `shackle_dynamic_load_of_strength` looked at the peak alone, which is of the simulated weight:
40 t with a contingency of 1.15 stood at 79.1 % of a proof load of 14 t in place of 87.8 %.
"""

from __future__ import annotations

import pytest

from four_slings import CONTINGENCY, DYNAMIC, LIFT
from gantline import Simulation
from gantline.results import series
from gantline.scenario import parse_scenario
from of_recording import checks_of

G = 9.81
PROOF = 14e3 * G  # N
SHACKLES = f"shackles: {{w: {{working_load_limit: 25 t, proof_load: {PROOF / 1e3!r} kN, mass: 20 kg}}}}\n"


def test_the_design_weight_hangs_in_shackles_too() -> None:
    text = LIFT.replace(f"rules: {{dynamic_amplification_factor: {DYNAMIC}}}\n", "")
    text = text.replace("ropes:\n", f"{SHACKLES}ropes:\n", 1)
    text = text.replace("slings:\n", "sling_defaults: {shackles: {top: w}}\nslings:\n")
    recording = Simulation(parse_scenario(text)).run()
    tension = {sling.rope: recording.column("rope_tension", sling.rope) for sling in recording.rig.slings}
    static = max(series.greatest_static(recording, one)[0] or 0.0 for one in tension.values())
    peak = max(series.rope_peak(recording, rope)[0] for rope in tension)
    assert CONTINGENCY * static > 1.05 * peak  # N: otherwise nothing is tested
    (found,) = checks_of(recording, "shackle_dynamic_load_of_strength")
    # max(static x contingency + half of the sling's weight (RW4), peak) / min(working load limit, proof load)
    worst = max(tension, key=lambda rope: series.greatest_static(recording, tension[rope])[0] or 0.0)
    upper, lower = series.rope_ends(recording, worst)
    rope = recording.rig.rope(worst)
    assert rope is not None
    height = series.static_value(recording, upper[:, 2] - lower[:, 2])
    assert height is not None
    own = 0.5 * rope.mass_per_length * G * height
    assert found.value == pytest.approx((CONTINGENCY * static + own) / PROOF, rel=1e-12)
    assert found.time is None  # that of the design weight belongs to no sample
    raised = f"static {static / 1e3:.1f} kN x 1.15 to the design weight + own weight {own / 1e3:.3f} kN"
    assert found.formula.startswith(f"({raised}) / min(WLL")
