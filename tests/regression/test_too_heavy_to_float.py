"""A vessel with a digit too many in its mass, on mooring lines.

Without lines it falls without end, and was said to sink. Lines slow it, the search for rest ended on its way
down, and the lift could not start since `no step brings its forces closer to balance`: of no use to whoever
looks for the digit.
"""

from __future__ import annotations

import pytest

from gantline.scenario import parse_scenario
from gantline.statics import NoEquilibriumError, Statics

LIFT = """\
format: 1
lift: {title: A barge that is too heavy}
duration: 1 s
ropes: {moor_44: {construction: 6x36 IWRC, grade: 1960, diameter: 44 mm, damping_time: 10 ms}}
vessels:
  barge:
    draft: 2 m
    hull: {box: [40 m, 12 m, 4 m]}
    masses: {hull: {mass: 9840 t, at: [20 m, 0 m, 2 m]}}
    radii_of_gyration: [4 m, 11 m, 11 m]
"""
LINE = (
    "  {name}: {{vessel: barge, fairlead: [{x} m, {y} m, 4 m], to: [{far} m, {aside} m, -30 m], "
    "rope: moor_44, pretension: 200 kN, sea_bed: -30 m}}\n"
)
LINES = "mooring_lines:\n" + "".join(
    LINE.format(name=f"{end}.{side}", x=x, y=5 * y, far=far, aside=200 * y)
    for end, x, far in (("stern", 1, -200), ("bow", 39, 240))
    for side, y in (("ps", 1), ("sb", -1))
)


@pytest.mark.parametrize("lines", ["", LINES], ids=["free", "moored"])
def test_it_sinks(lines: str) -> None:
    """Its hull displaces 40 x 12 x 4 m of water, 1968 t."""
    with pytest.raises(NoEquilibriumError) as caught:
        Statics(parse_scenario(LIFT + lines)).equilibrium()
    weighs = "its masses and tanks alone are 9840 t, and all of its hull displaces 1968 t"
    cause = f"it sinks: no hull bears that weight; {weighs}"
    assert (caught.value.element, caught.value.cause) == ("barge", cause)
    floats = LIFT.replace("9840 t", "984 t") + lines
    assert Statics(parse_scenario(floats)).equilibrium().is_stable
