"""A load that is held while it stands on one corner had no static force of the sling across.

40 t hang in four slings, 98 kN each, and are lowered onto one support, as where one of four stands higher.
The corner stays, the load leans about it, and the sling across gets tighter by a third of what that at the
corner loses: with R on the support all slings are those of W/4, and R/4 more across. Static forces were those
of the load hanging clear alone, so that for 20 s of 122 kN in one sling the contingency of 1.1 was on 98 kN:
a shackle was at 65 % of its working load limit that bears 81 %.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.checks import check_recording, values_of
from gantline.results.recording import Recording

MASS, CONTINGENCY, FACTOR, GRAVITY = 40.0, 1.1, 1.2, 9.81  # t, 1, 1, m/s^2
#: Of a shackle, and of a lug [t].
LIMIT, CAPACITY = 17.0, 22.0
LIFT = f"""
format: 1
lift: {{title: A load on one corner}}
duration: 110 s
ground: {{level: 0 m}}
ropes: {{sling: {{axial_stiffness: 200 MN, mass: none, damping_time: 20 ms}}}}
shackles: {{s: {{working_load_limit: {LIMIT} t, mass: 1 kg, bow_diameter: 60 mm, pin_diameter: 42 mm}}}}
lug_types: {{L: {{main_plate: xz, capacity: {CAPACITY} t}}}}
load:
  name: module
  shape: {{box: [8 m, 8 m, 2 m]}}
  position: [0 m, 0 m, 1 m]
  weight: {{calculated: {MASS} t, contingency: {CONTINGENCY}}}
  centre_of_gravity: {{at: [0 m, 0 m, 1 m]}}
  stands_on: under
  lugs:
    A: {{at: [3 m, 3 m, 2 m], type: L}}
    B: {{at: [-3 m, 3 m, 2 m], type: L}}
    C: {{at: [-3 m, -3 m, 2 m], type: L}}
    D: {{at: [3 m, -3 m, 2 m], type: L}}
supports:
  under:
    under: module
    places: {{a: {{at: [3 m, 3 m]}}, b: {{at: [-3 m, 3 m]}}, c: {{at: [-3 m, -3 m]}}, d: {{at: [3 m, -3 m]}}}}
    height: 1 m
    stiffness: 400 MN/m
    damping: 1 MN s/m
    friction: 0.3
cranes:
  crane: {{type: fixed_hook, at: [0 m, 0 m, 103 m], hoist: {{speed: 3 m/min, acceleration: 0.01 m/s^2}}}}
sling_defaults: {{rope: sling, length: 100.1 m, shackles: {{top: s, bottom: s}}}}
slings:
  A: {{from: crane, to: module.A}}
  B: {{from: crane, to: module.B}}
  C: {{from: crane, to: module.C}}
  D: {{from: crane, to: module.D}}
plan:
  - {{step: lift off, hoist: crane, speed: 0.6 m/min, until: {{supports: clear}}}}
  - {{step: clear, hoist: crane, speed: 1 m/min, by: 0.1 m}}
  - {{step: hold, hold: 20 s, remove_supports: [under.b, under.c, under.d]}}
  - {{step: down, lower: crane, speed: 0.3 m/min, until: {{load_transferred: 75 %}}}}
  - {{step: look, hold: until_end}}
rules: {{dynamic_amplification_factor: {FACTOR}}}
"""


@pytest.fixture(scope="module")
def run() -> Recording:
    return gantline.simulate(gantline.parse_scenario(LIFT))


def test_the_sling_across_has_a_quarter_of_what_the_corner_bears(run: Recording) -> None:
    """T = W/4 + s (2x - d) across and W/4 + s (x - d) beside, of springs s, let down by d, the middle by x.

    Moments about the corner: x = 2d/3; its own sling has s d less, and R = 4 s d/3. Slings lean by 2.4 deg.
    """
    corner = float(run.column("contact_force", "support.under.a")[-1])
    across = float(run.column("rope_tension", "sling.C")[-1])
    assert corner > 0.2 * MASS * 1e3 * GRAVITY
    assert across == pytest.approx((MASS * 1e3 * GRAVITY + corner) / 4.0, rel=1e-2)


def test_it_is_held_against_what_shackle_and_lug_bear(run: Recording) -> None:
    across = float(run.column("rope_tension", "sling.C")[-1]) / (1e3 * GRAVITY)
    shackles, lugs = (
        values_of(run, name) for name in ("shackle_load_of_working_load_limit", "lug_load_of_capacity")
    )
    assert shackles["C bottom"] == pytest.approx(across * CONTINGENCY / LIMIT, rel=2e-3)
    assert lugs["module.C"] == pytest.approx(across * CONTINGENCY * FACTOR / CAPACITY, rel=2e-3)
    [check] = [one for one in check_recording(run) if one.name == "lug_load_of_capacity"]
    assert check.element == "module.C" and "partly standing" in check.formula


def test_beside_it_slings_are_those_of_the_load_hanging(run: Recording) -> None:
    hung = MASS / 4.0 * CONTINGENCY / LIMIT
    shackles = values_of(run, "shackle_load_of_working_load_limit")
    assert [shackles[f"{name} bottom"] for name in "ABD"] == pytest.approx([hung] * 3, rel=5e-3)
