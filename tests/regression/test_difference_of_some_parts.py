"""Masses that differ by 9 % in a line that says +0.00 %.

A part of OCX whose geometry cannot be read counts with its declared weight, which stands among the declared
ones of its kind in the table of `gantline cad` and not among the computed ones. The difference beside is
that of the parts that have both: of a unit with 63 plates, one without a thickness, 10546.0 kg, 11563.4 kg
and +0.00 %. It says of how many it is.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from gantline.cad import DeclaredWeight, PartKind
from gantline.cad.ship_block import ShipBlockSizes, ship_block
from gantline.cli.cad_table import cad_table


def test_the_table_says_of_how_many_parts_it_is() -> None:
    model = ship_block(ShipBlockSizes(length=20.0, breadth=12.0, height=9.0, mass=120e3)).model
    first, *others = model.parts
    assert first.kind is PartKind.PLATE and first.properties is not None
    alone = replace(first, properties=None, declared=DeclaredWeight(first.properties.mass, np.zeros(3)))
    lines = [line.split() for line in cad_table(replace(model, parts=(alone, *others)), 120)]
    plates = sum(part.kind is PartKind.PLATE for part in model.parts)
    (line,) = (line for line in lines if line[:1] == ["plate"])
    assert line[1] == str(plates) and line[6:10] == ["+0.00", "%", "of", str(plates - 1)]
    (pillars,) = (line for line in lines if line[:1] == ["pillar"])
    assert "of" not in pillars[6:9]
