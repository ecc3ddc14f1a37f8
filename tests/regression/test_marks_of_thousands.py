"""`24,000 kg` was told to have a decimal comma, and with the point that was asked for it is 24 kg.

`24 000 kg` was told that '000 kg' is not a unit of mass, `24_000 kg` that '_000 kg' is none. Three digits
behind a comma may be either: both ways of writing it are told, and neither is taken.
"""

from __future__ import annotations

import pytest

from gantline.units import UnitError, quantity


@pytest.mark.parametrize(
    ("text", "says"),
    [
        (
            "24,000 kg",
            "'24,000 kg': thousands are written without a mark, '24000 kg', or decimals with a point, "
            "'24.000 kg'",
        ),
        ("1,250,000 kg", "'1,250,000 kg': thousands are written without a mark, '1250000 kg'"),
        ("24 000 kg", "'24 000 kg': thousands are written without a mark, '24000 kg'"),
        ("24_000 kg", "'24_000 kg': thousands are written without a mark, '24000 kg'"),
        ("1'250'000 kg", "'1'250'000 kg': thousands are written without a mark, '1250000 kg'"),
        ("1 250 000 kg", "'1 250 000 kg': thousands are written without a mark, '1250000 kg'"),
    ],
)
def test_thousands_are_written_without_a_mark(text: str, says: str) -> None:
    with pytest.raises(UnitError) as found:
        quantity(text, "mass")
    assert str(found.value) == says


@pytest.mark.parametrize("text", ["8,6 t", "8,65 t", "8,6543 t"])
def test_a_decimal_comma_is_one(text: str) -> None:
    with pytest.raises(UnitError, match="has a decimal comma"):
        quantity(text, "mass")
