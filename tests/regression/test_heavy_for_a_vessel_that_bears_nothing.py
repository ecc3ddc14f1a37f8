"""The warning that a load is heavy beside a vessel with `wave_motion`, of vessels that have no part in it.

A tug that only holds a mooring line was told that the load changes how she lies. The warning is for vessels
that lift the load or that it may stand on, whenever the plan has it so.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from compensated import compensated_text
from gantline.hydro import write_raos
from gantline.scenario import parse_scenario
from gantline.simulation import Simulation
from hooked_lift import TWO_HOOKS, TWO_HOOKS_LUGS, TWO_HOOKS_SLINGS, hooked_lift
from table_of_raos import ON_DECK, goes_with_the_water

VESSEL = """\
vessels:
  vessel:
    position: [20 m, 0 m]
    draft: 4 m
    hull: {box: [100 m, 30 m, 8 m]}
    wave_motion: {raos: vessel.csv, phases: lag, at: [50 m, 0 m, 4 m]}
"""
THIN = "ropes: {thin: {axial_stiffness: 1 MN, damping_time: 0.1 s, mass: none},"
TAG_LINE = """\
tag_lines:
  aft: {at: [5 m, 0 m, 1 m], to: [1 m, 0 m, 8 m], held_by: vessel, rope: thin, pretension: 1 kN}
"""
FALL = """\
mechanics:
  bodies:
    house: {parent: vessel, at: [2 m, 0 m, 30 m], joint: {type: fixed}, mass: 1 t}
  ropes:
    fall:
      rope: thin
      length: 60 m
      route:
        - {type: end, body: house}
        - {type: end, body: load}
"""


@pytest.mark.parametrize(
    ("aboard", "is_told"),
    [("", False), (TAG_LINE, False), (ON_DECK, True), (FALL, True)],
    ids=["nothing", "tag_line", "deck", "rope"],
)
def test_only_who_lifts_or_bears_it_is_told(tmp_path: Path, aboard: str, is_told: bool) -> None:
    """369 t of 100 m x 30 m x 4 m x 1.025 t/m^3 = 12 300 t are 3 %; the bound is 2 %."""
    write_raos(goes_with_the_water(), tmp_path / "vessel.csv")
    text = hooked_lift(
        TWO_HOOKS,
        TWO_HOOKS_LUGS,
        TWO_HOOKS_SLINGS,
        mass=369e3,
        position=(0, 0, 6.9),
        more=VESSEL + aboard,
    ).replace("ropes: {", THIN, 1)
    found = Simulation(parse_scenario(text, str(tmp_path / "lift.yaml"))).assembly.warnings
    assert any("of what vessel displaces" in one for one in found) == is_told


def test_a_vessel_is_told_whose_crane_lifts_it(tmp_path: Path) -> None:
    """90 m x 30 m x 3 m x 1.025 t/m^3 = 8300 t, of which the load of 120 t is 1.4 %; 249 t are 3.0 %."""
    write_raos(goes_with_the_water(), tmp_path / "own.csv")
    text = compensated_text("  - {step: hold, hold: until_end}\n", can="")
    by_forces = text[text.index("    radiation:") : text.index("mooring_lines:")]
    by_table = "    wave_motion: {raos: own.csv, phases: lag, at: [45 m, 0 m, 3 m]}\n\n"
    lift = parse_scenario(text.replace(by_forces, by_table), str(tmp_path / "lift.yaml"))
    for mass, said in ((120, []), (249, ["the load weighs 3.0 % of what barge displaces"])):
        found = Simulation(lift.changed({"load.weight.calculated": f"{mass} t"})).assembly.warnings
        assert [one.split(":")[0] for one in found if "displaces" in one] == said
