"""What stands on certificates and in word processors, and answers that led nowhere.

`load_tilt: −2 deg` with the minus sign of a word processor was "not a number with a unit", though it looks
like one; `1 min 30 s` was asked "did you mean 'min'?"; `12.06 m ± 25 mm` had a unit `m ± 25 mm`. 5 mpm of a
crane's data sheet were taken for mm/s, and 15 t/m2 for N/mm^2, a hundred times as much. Who gave a capacity
in kN where a mass is needed, or a breaking force in t, was left to divide by g.
"""

from __future__ import annotations

import pytest

from gantline.units import UnitError, quantity


@pytest.mark.parametrize(
    ("text", "dimension", "says"),
    [
        (
            "\u22123 m",
            "length",
            "'\u22123 m' begins with '\u2212', a dash; a minus sign is '-': write '-3 m'",
        ),
        (
            "\u2013 3 m",
            "length",
            "'\u2013 3 m' begins with '\u2013', a dash; a minus sign is '-': write '-3 m'",
        ),
        (
            "\u2212",
            "length",
            "'\u2212' is not a number with a unit; a length is written like '23 m' or '66 mm'",
        ),
        ("1 min 30 s", "time", "'1 min 30 s' is written in several units; right is one: '90 s'"),
        ("5 m 20 mm", "length", "'5 m 20 mm' is written in several units; right is one: '5020 mm'"),
        (
            "1:30 min",
            "time",
            "'1:30 min' is written with a ':'; a time is one number with its unit, such as '90 s'",
        ),
        (
            "12.06 m \u00b1 25 mm",
            "length",
            "'12.06 m \u00b1 25 mm' has a tolerance, and that has a key of its own; right is '12.06 m'",
        ),
        (
            "60 t +/- 5 %",
            "mass",
            "'60 t +/- 5 %' has a tolerance, and that has a key of its own; right is '60 t'",
        ),
        ("5 mpm", "speed", "'mpm' in '5 mpm' is not a unit of speed; did you mean 'm/min'?"),
        ("4 kmh", "speed", "'kmh' in '4 kmh' is not a unit of speed; did you mean 'km/h'?"),
        (
            "15 t/m2",
            "stress",
            "'15 t/m2' is 147.1 kPa; units are metric: a stress, pressure or modulus is written like "
            "'100 kN/mm^2' or '150 kPa'",
        ),
        (
            "2 N/mm2",
            "stress",
            "'N/mm2' in '2 N/mm2' is not a unit of stress, pressure or modulus; did you mean 'N/mm^2'?",
        ),
        # 10 ft are 3.048 m.
        (
            "10 fpm",
            "speed",
            "'10 fpm' is 3.048 m/min; units are metric: a speed is written like '3 m/min' or '0.1 m/s'",
        ),
    ],
)
def test_the_answer_says_what_would_be_right(text: str, dimension: str, says: str) -> None:
    with pytest.raises(UnitError) as found:
        quantity(text, dimension)
    assert str(found.value) == says


@pytest.mark.parametrize(
    ("text", "dimension", "weigh"),
    [
        # m = F/9.81 m/s^2 and F = m 9.81 m/s^2
        ("392.4 kN", "mass", "(40 t weigh 392.4 kN)"),
        ("200 t", "force", "(200 t weigh 1962 kN)"),
        ("20000 t", "force", "(20000 t weigh 196200 kN)"),
    ],
)
def test_a_force_for_a_mass_is_answered_with_the_mass_that_weighs_it(
    text: str, dimension: str, weigh: str
) -> None:
    with pytest.raises(UnitError) as found:
        quantity(text, dimension)
    assert str(found.value).endswith(weigh)
    assert "is a force; needed is a mass" in str(found.value) or "is a mass; needed is a force" in str(
        found.value
    )
