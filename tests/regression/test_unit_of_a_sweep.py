"""Values of a sweep stood in the first unit of their dimension, whatever unit was asked for.

`--sweep 'wind.speed=0 m/s..15 m/s/4'` had the lines `0 m/min`, `300 m/min`, `600 m/min`, `900 m/min`, levels
of the ground under tracks in mm had metres.
"""

from __future__ import annotations

import pytest
from typer.testing import CliRunner

from gantline.cli.app import app
from gantline.units import unit_of


@pytest.mark.parametrize(
    ("swept", "shown"),
    [
        ("cranes.test_hook.hoist.speed=0.2 m/s..0.3 m/s/2", ("0.2 m/s", "0.3 m/s")),
        ("load.weight.calculated=0.3 t..310000 kg/2", ("300 kg", "310000 kg")),
        ("cranes.test_hook.at.z=36400 mm..36500 mm/2", ("36400 mm", "36500 mm")),
        ("load.centre_of_gravity.at.x=0..20 cm/2", ("0 cm", "20 cm")),
    ],
)
def test_values_stand_in_the_unit_that_was_asked_for(swept: str, shown: tuple[str, ...]) -> None:
    """That of the last value, since the first may be a bare 0."""
    result = CliRunner().invoke(app, ["statics", "equalizer", "--sweep", swept])
    lines = [line.strip().split("  ")[0] for line in result.stdout.splitlines()[1:3]]
    assert tuple(lines) == shown


def test_a_value_that_cannot_be_stands_in_it_too() -> None:
    """`3000.0 kg` stood for 3 t."""
    swept = "load.weight.calculated=-3 t..3 t/2"
    result = CliRunner().invoke(app, ["statics", "equalizer", "--sweep", swept])
    assert result.exit_code == 2
    assert "-3 t" in result.stderr and "kg" not in result.stderr


def test_values_without_a_unit_of_their_own_have_that_of_their_dimension() -> None:
    assert unit_of("0", "0", dimension="length") == "m"
    assert unit_of("3 m/min", "0", dimension="speed") == "m/min"
