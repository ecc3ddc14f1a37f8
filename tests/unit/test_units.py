"""Everyday units: written quantities to SI and back."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gantline.units import (
    DIMENSIONS,
    UnitError,
    example,
    format_by_size,
    format_quantity,
    length_digits,
    quantity,
    telling_digits,
    units_of,
)

#: Units without a prefix, in SI; a gram is 1e-3 kg.
WHOLE = {
    "m": 1.0,
    "g": 1e-3,
    "t": 1e3,
    "s": 1.0,
    "min": 60.0,
    "h": 3600.0,
    "N": 1.0,
    "W": 1.0,
    "Pa": 1.0,
    "rad": 1.0,
    "deg": math.pi / 180,
    "rev": 2 * math.pi,
    "%": 1e-2,
    "": 1.0,
}
PREFIXES = {"u": 1e-6, "m": 1e-3, "c": 1e-2, "k": 1e3, "M": 1e6, "G": 1e9}


def by_its_letters(unit: str) -> float:
    """What a unit is in SI, by its parts: `kN m s`, `N/mm^2`; of each its prefix and its power."""
    above, *below = unit.split("/")
    product = 1.0
    for part, sign in [*((part, 1) for part in above.split(" ")), *((part, -1) for part in below)]:
        name, _, power = part.partition("^")
        whole = WHOLE[name] if name in WHOLE else PREFIXES[name[0]] * WHOLE[name[1:]]
        product *= whole ** (sign * int(power or 1))
    return product


@pytest.mark.parametrize(
    ("dimension", "unit"), [(dimension, unit) for dimension in DIMENSIONS for unit in DIMENSIONS[dimension]]
)
def test_every_unit_is_what_its_letters_say(dimension: str, unit: str) -> None:
    assert quantity(f"3 {unit}", dimension) == pytest.approx(3 * by_its_letters(unit), rel=1e-15)


@pytest.mark.parametrize(
    ("text", "dimension", "value"),
    [
        ("300 t", "mass", 300e3),  # 1 t = 1000 kg
        ("20 kg", "mass", 20.0),
        ("250 g", "mass", 0.25),
        ("200 MN", "force", 200e6),
        ("12 GN", "force", 12e9),
        ("10kN", "force", 10e3),
        ("66 mm", "length", 0.066),
        ("-2.5 m", "length", -2.5),
        ("3 km", "length", 3e3),
        ("3 m/min", "speed", 0.05),  # 3/60
        ("36 km/h", "speed", 10.0),
        ("0.1 m/s^2", "acceleration", 0.1),
        ("0.1 m/s²", "acceleration", 0.1),
        ("180 deg", "angle", math.pi),
        ("1 rev/min", "angular_speed", 2 * math.pi / 60),
        ("5 %", "ratio", 0.05),
        ("0.05", "ratio", 0.05),
        ("2 MN s/m", "damping", 2e6),
        ("2 MN·s/m", "damping", 2e6),
        ("200 MN/m", "stiffness", 200e6),
        ("5 N/mm", "stiffness", 5e3),
        ("5 kN m", "torque", 5e3),
        ("5 kN  m", "torque", 5e3),
        ("5 kN m s", "rotational_damping", 5e3),
        ("110.9 t m^2", "inertia", 110.9e3),
        ("16.8 kg/m", "mass_per_length", 16.8),
        ("1960 N/mm^2", "stress", 1960e6),
        ("100 kN/mm^2", "stress", 100e9),
        ("2 ms", "time", 0.002),
        ("1.5 h", "time", 5400.0),
        ("1e2 s", "time", 100.0),
        (".5 s", "time", 0.5),
        (" 40 s ", "time", 40.0),
    ],
)
def test_written_quantities(text: str, dimension: str, value: float) -> None:
    assert quantity(text, dimension) == pytest.approx(value, rel=1e-15)


@pytest.mark.parametrize("zero", ["0", "0.0", "-0", "0e5", "0 m"])
def test_zero_needs_no_unit(zero: str) -> None:
    assert quantity(zero, "length") == 0.0


@pytest.mark.parametrize(
    ("text", "dimension", "says"),
    [
        ("300", "mass", "'300' has no unit; a mass is written like '300 t' or '20 kg'"),
        (
            "300 kN",
            "mass",
            "'300 kN' is a force; needed is a mass, written like '300 t' or '20 kg' (30.58 t weigh 300 kN)",
        ),
        ("300 T", "mass", "'T' in '300 T' is not a unit of mass; did you mean 't'?"),
        ("1 mN", "force", "'mN' in '1 mN' is no unit here; it is written '0.001 N'; or is 'MN' meant?"),
        ("10 µN", "force", "'µN' in '10 µN' is no unit here; it is written '1e-05 N'"),
        ("1.5 GN/m", "stiffness", "'GN/m' in '1.5 GN/m' is no unit here; it is written '1500 MN/m'"),
        ("2 GN m", "torque", "'GN m' in '2 GN m' is no unit here; it is written '2000 MN m'"),
        ("1.2 kt", "mass", "'kt' in '1.2 kt' is no unit here; it is written '1200 t'"),
        ("20 kt", "speed", "'20 kt' is 10.289 m/s; units are metric: " + example("speed")),
        ("5 nm", "length", "'nm' in '5 nm' is no unit here; it is written '5e-06 mm'"),
        (
            "3 stone",
            "mass",
            "'stone' in '3 stone' is not a unit of mass; a mass is written like '300 t' or '20 kg'",
        ),
        ("12 ft", "length", "'12 ft' is 3.6576 m; units are metric: " + example("length")),
        ("10 kips", "force", "'10 kips' is 44.482 kN; units are metric: " + example("force")),
        ("30 mph", "speed", "'30 mph' is 13.411 m/s; units are metric: " + example("speed")),
        (
            "5 short tons",
            "mass",
            "'short tons' in '5 short tons' has several sizes: a short ton is 0.9072 t, a long ton 1.016 t; "
            + example("mass"),
        ),
        ("5 knm", "torque", "'knm' in '5 knm' is not a unit of torque; did you mean 'kN m'?"),
        ("2,5 m", "length", "'2,5 m' has a decimal comma; a decimal point is needed: write '2.5 m'"),
        ("2,5 lm", "length", "'2,5 lm' has a decimal comma; a decimal point is needed: " + example("length")),
        ("about 3 m", "length", "'about 3 m' is not a number with a unit; " + example("length")),
        ("nan", "length", "'nan' is not a finite number; " + example("length")),
        ("-inf m", "length", "'-inf m' is not a finite number; " + example("length")),
        ("1e400 m", "length", "'1e400 m' is too large to be a number; " + example("length")),
        ("1e307 km", "length", "'1e307 km' is too large to be a number; " + example("length")),
        ("", "time", "'' is not a number with a unit; a time is written like '40 s' or '2 ms'"),
        ("5 %", "time", "'5 %' is a share; needed is a time, written like '40 s' or '2 ms'"),
        ("１２ m", "length", "'１２ m' is not a number with a unit; " + example("length")),
    ],
)
def test_what_is_no_quantity(text: str, dimension: str, says: str) -> None:
    with pytest.raises(UnitError) as caught:
        quantity(text, dimension)
    assert str(caught.value) == says


def test_a_long_text_is_not_repeated_whole() -> None:
    with pytest.raises(UnitError) as caught:
        quantity("x" * 10_000, "mass")
    assert len(str(caught.value)) < 200


@pytest.mark.parametrize(
    ("value", "unit", "digits", "text"),
    [
        (702_043.0, "kN", 1, "702.0 kN"),
        (0.05, "m/min", 1, "3.0 m/min"),
        (0.933, "%", 0, "93 %"),
        (math.radians(-69.0), "deg", 1, "-69.0 deg"),
        (1.25, "", 2, "1.25"),
        (-1e-4, "m", 3, "0.000 m"),
        (3_423.0, "kN", 1, "3.42 kN"),
        (5_040.0, "kN", 1, "5.0 kN"),
        (200.0, "t", 1, "0.200 t"),
        (-0.6, "kN", 1, "-0.001 kN"),
        (0.4, "kN", 1, "0.0 kN"),
        (12_500.0, "t", 0, "12.5 t"),
    ],
)
def test_writing_a_quantity(value: float, unit: str, digits: int, text: str) -> None:
    assert format_quantity(value, unit, digits) == text


@pytest.mark.parametrize(
    ("value", "limit", "unit", "digits", "told"),
    [
        (-0.0022, 0.0, "m", 2, 3),  # -0.002 m of 0.000 m
        (1.00004, 1.0, "%", 1, 3),  # 100.004 % of 100.000 %
        (3.2, 3.0, "m", 2, 2),
        (1.0 + 1e-12, 1.0, "m", 2, 2),  # no digits that people read tell
    ],
)
def test_decimals_that_tell_a_value_from_its_limit(
    value: float, limit: float, unit: str, digits: int, told: int
) -> None:
    assert telling_digits(value, limit, unit, digits) == told


@pytest.mark.parametrize(("value", "digits"), [(1.0, 2), (12.3, 2), (0.999, 3), (-0.004, 3), (0.0, 3)])
def test_distances_below_a_metre_have_millimetres(value: float, digits: int) -> None:
    assert length_digits(value) == digits


@pytest.mark.parametrize(
    ("value", "dimension", "digits", "text"),
    [
        (150e3, "force", 3, "150 kN"),
        (101.27e6, "force", 4, "101.3 MN"),
        (999.96e3, "force", 3, "1 MN"),
        (1.234e9, "force", 3, "1,230 MN"),
        (-900.0, "force", 3, "-900 N"),
        (0.0, "mass", 3, "0 kg"),
        (49.6, "mass", 3, "49.6 kg"),
        (360e3, "rotational_stiffness", 3, "360 kN m/rad"),
    ],
)
def test_writing_a_quantity_in_a_unit_of_its_size(
    value: float, dimension: str, digits: int, text: str
) -> None:
    """An EA of 150 kN read `0.1 MN`."""
    assert format_by_size(value, dimension, digits) == text


def test_writing_in_an_unknown_unit() -> None:
    with pytest.raises(UnitError, match="'tf' is not a known unit"):
        format_quantity(1.0, "tf", 1)


def test_a_unit_belongs_to_one_dimension() -> None:
    symbols = [symbol for dimension in DIMENSIONS for symbol in units_of(dimension)]
    assert len(symbols) == len(set(symbols))


@given(
    st.sampled_from([(dimension, unit) for dimension in DIMENSIONS for unit in DIMENSIONS[dimension]]),
    st.floats(min_value=-1e6, max_value=1e6, allow_subnormal=False),
)
def test_what_is_written_is_read_back(pair: tuple[str, str], number: float) -> None:
    dimension, unit = pair
    factor = DIMENSIONS[dimension][unit]
    text = format_quantity(number * factor, unit, 17)
    assert quantity(text, dimension) == pytest.approx(number * factor, rel=1e-12, abs=1e-16 * factor)


@given(st.text(max_size=30), st.sampled_from(list(DIMENSIONS)))
def test_any_text_is_a_quantity_or_an_error(text: str, dimension: str) -> None:
    try:
        assert math.isfinite(quantity(text, dimension))
    except UnitError as error:
        assert "\n" not in str(error).replace(text, "")
