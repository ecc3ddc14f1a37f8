"""Steps of a beam with a turnbuckle in sling E that wait for its tension, or name it twice.

`until: {sling_tension: …}` was to be `mooring_tension`, which takes no sling. A sling named twice was a line.
"""

from __future__ import annotations

import pytest

from gantline.scenario import ScenarioError, parse_scenario
from lift_text import BASE, changed

HOISTED = changed(BASE, ("tolerance: 0.25 %}", "chain_hoist: {speed: 1 m/min}}"))
HOIST = "hoist: hook, speed: 3 m/min, start_at: 0 s, brake_from: 10 s"


@pytest.mark.parametrize(
    ("step", "said"),
    [
        ("hoist: S1, speed: 1 m/min, by: 0.1 m", "plan[1].hoist: 'S1' is not a hook; known here: 'hook'"),
        (
            "haul: S1, speed: 1 m/min, by: 0.1 m",
            "plan[1].haul: sling 'S1' has no 'chain_hoist' that could move it; give it one, such as "
            "'chain_hoist: {speed: 1 m/min, rated_capacity: 20 t}'",
        ),
        (
            "haul: [S2, sling.S2], speed: 1 m/min, by: 0.1 m",
            "plan[1].haul: names a sling twice; each sling stands once",
        ),
        (
            "haul: S2, speed: 1 m/min, until: {sling_tension: {sling: S2, above: 200 kN}}",
            "plan[1].until.sling_tension: 'sling_tension' is not a key of until: no step waits for a "
            "tension; of slings end it 'by' the length that 'gantline statics' finds, or wait for "
            "'hoist_load' or 'load_tilt'",
        ),
    ],
)
def test_a_sling_is_told_what_moves_it(step: str, said: str) -> None:
    with pytest.raises(ScenarioError) as caught:
        parse_scenario(changed(HOISTED, (HOIST, step)))
    assert said in str(caught.value)
