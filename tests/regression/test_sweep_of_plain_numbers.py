"""A sweep of plain numbers wrote them with a percent sign, and keys that take numbers alone refused that.

`--sweep waves.swell.peak_enhancement=1.0..3.0/3` ended with code 2: "found '100 %'; a plain number like
'1.05' is needed". Of coefficients, which take both, the table had 20 % for 0.2.
"""

from __future__ import annotations

import pytest
from typer.testing import CliRunner

from gantline.cli.app import app
from gantline.units import unit_of


@pytest.mark.parametrize(
    ("lift", "swept", "shown"),
    [
        ("crane_barge_in_swell", "waves.swell.peak_enhancement=1.0..3.0/2", ("1", "3")),
        ("equalizer", "ground.friction=0.2..0.4/2", ("0.2", "0.4")),
        ("equalizer", "ground.friction=20 %..40 %/2", ("20 %", "40 %")),
    ],
)
def test_numbers_stand_as_they_were_written(lift: str, swept: str, shown: tuple[str, ...]) -> None:
    result = CliRunner().invoke(app, ["statics", lift, "--sweep", swept])
    assert result.exit_code != 2, result.stderr
    lines = [line.strip().split("  ")[0] for line in result.stdout.splitlines()]
    assert tuple(dict.fromkeys(line for line in lines if line in shown)) == shown


def test_a_share_without_a_sign_is_a_plain_number() -> None:
    assert unit_of("0", "0.4", dimension="ratio") == ""
    assert unit_of("20 %", "0", dimension="ratio") == "%"
