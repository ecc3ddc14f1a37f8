"""The weight of a load in the head of tables.

It was that of the body in the simulation, on which lower halves of slings and lower shackles are lumped:
"simulated weight 1005.0 t; calculated 1000.0 t" of a load that was simulated with its calculated weight, and
not the weight by whose ratio to the design weight checks raise forces.
"""

from __future__ import annotations

from four_slings import LIFT
from gantline.assembly import assemble
from gantline.cli.summary import weights
from gantline.results.rig import Rig
from gantline.scenario import parse_scenario

#: Four shackles of 60 kg, and half of four slings of 8.6 m of 7.92 kg/m: 0.376 t.
SHACKLES = "shackles: {w: {working_load_limit: 25 t, mass: 60 kg}}\n"


def head(text: str) -> list[str]:
    return weights(Rig.from_json(assemble(parse_scenario(text)).rig))


def test_rigging_is_no_weight_of_the_load() -> None:
    said = "Load module: simulated weight 40.0 t, with {} of rigging on it; "
    design = "calculated 40.0 t x contingency 1.15 = design 46.0 t"
    assert head(LIFT) == [said.format("0.136 t") + design]  # 4 x 8.6/2 m x 7.92 kg/m = 0.136 t
    text = SHACKLES + LIFT.replace("format: 1\n", "", 1)
    text = "format: 1\n" + text.replace("slings:\n", "sling_defaults: {shackles: {bottom: w}}\nslings:\n", 1)
    assert head(text) == [said.format("0.376 t") + design]


def test_nothing_is_said_of_no_rigging() -> None:
    text = LIFT.replace("damping_time: 10 ms}", "damping_time: 10 ms, mass: none}")
    assert head(text)[0].startswith("Load module: simulated weight 40.0 t; calculated")
