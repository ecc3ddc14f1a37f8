"""Everyday units of a yard, to and from SI.

A quantity is a text like ``300 t``, ``0.3 m/min`` or ``2 MN s/m``. Inside the program every quantity is a
float in SI units (radians for angles). A dimensional quantity without a unit is an error, except zero:
``mass: 300`` must never come to mean 300 kg.
"""

from __future__ import annotations

import difflib
import math
import re
from collections.abc import Iterable
from decimal import ROUND_HALF_UP, Context, Decimal
from typing import Final

from gantline.arguments import needed

__all__ = [
    "DIMENSIONS",
    "UnitError",
    "common_dimension",
    "compared_digits",
    "example",
    "format_by_size",
    "format_quantity",
    "in_unit",
    "is_quantity",
    "length_digits",
    "quantity",
    "si_text",
    "telling_digits",
    "unit_of",
    "units_of",
]

_TONNE: Final = 1000.0
_MINUTE: Final = 60.0
_HOUR: Final = 3600.0
_DEGREE: Final = math.pi / 180.0

#: Factors to SI by dimension; the first units of each are the ones that messages show as examples.
DIMENSIONS: Final[dict[str, dict[str, float]]] = {
    "length": {"m": 1.0, "mm": 1e-3, "cm": 1e-2, "km": 1e3},
    "mass": {"t": _TONNE, "kg": 1.0, "g": 1e-3},
    "time": {"s": 1.0, "ms": 1e-3, "us": 1e-6, "min": _MINUTE, "h": _HOUR},
    "force": {"kN": 1e3, "N": 1.0, "MN": 1e6, "GN": 1e9},
    "power": {"kW": 1e3, "W": 1.0, "MW": 1e6},
    "angle": {"deg": _DEGREE, "rad": 1.0},
    "speed": {"m/min": 1 / _MINUTE, "m/s": 1.0, "mm/s": 1e-3, "km/h": 1e3 / _HOUR},
    "angular_speed": {
        "deg/s": _DEGREE,
        "rad/s": 1.0,
        "deg/min": _DEGREE / _MINUTE,
        "rev/min": 2 * math.pi / _MINUTE,
    },
    "acceleration": {"m/s^2": 1.0, "mm/s^2": 1e-3},
    "angular_acceleration": {"deg/s^2": _DEGREE, "rad/s^2": 1.0},
    "mass_flow": {"t/h": _TONNE / _HOUR, "t/min": _TONNE / _MINUTE, "kg/s": 1.0, "t/s": _TONNE},
    "stiffness": {"MN/m": 1e6, "kN/m": 1e3, "N/m": 1.0, "N/mm": 1e3, "kN/mm": 1e6},
    "damping": {"MN s/m": 1e6, "kN s/m": 1e3, "N s/m": 1.0},
    "torque": {"kN m": 1e3, "N m": 1.0, "MN m": 1e6},
    "rotational_stiffness": {"MN m/rad": 1e6, "kN m/rad": 1e3, "N m/rad": 1.0},
    "rotational_damping": {"kN m s": 1e3, "N m s": 1.0, "MN m s": 1e6},
    "inertia": {"t m^2": _TONNE, "kg m^2": 1.0},
    "area": {"m^2": 1.0},
    "volume": {"m^3": 1.0},
    "mass_moment": {"t m": _TONNE, "kg m": 1.0},
    "coupled_damping": {"kN s": 1e3, "N s": 1.0, "MN s": 1e6},
    "mass_per_length": {"kg/m": 1.0, "t/m": _TONNE},
    "density": {"t/m^3": _TONNE, "kg/m^3": 1.0},
    "stress": {"MPa": 1e6, "GPa": 1e9, "kPa": 1e3, "Pa": 1.0, "N/mm^2": 1e6, "kN/mm^2": 1e9},
    "ratio": {"%": 1e-2, "": 1.0},
}

#: Units in which values of a dimension are shown by their size, the largest first.
_BY_SIZE: Final[dict[str, tuple[str, ...]]] = {
    "force": ("MN", "kN", "N"),
    "mass": ("t", "kg"),
    "rotational_stiffness": ("MN m/rad", "kN m/rad", "N m/rad"),
}

#: Units in which tables show what may be a thousandth of one, and decimals that reach to that.
_THOUSANDS: Final = frozenset({"kN", "t"})
_OF_A_THOUSAND: Final = 3
#: What is less is nothing in them: half of the last of those decimals.
_TO_TELL: Final = 0.5e-3
#: With room for the largest number and all its decimals.
_HALVES_UP: Final = Context(prec=400, rounding=ROUND_HALF_UP)

#: How a message names a dimension and what it shows as a right example.
_WORDS: Final[dict[str, tuple[str, str]]] = {
    "length": ("a length", "'23 m' or '66 mm'"),
    "mass": ("a mass", "'300 t' or '20 kg'"),
    "time": ("a time", "'40 s' or '2 ms'"),
    "force": ("a force", "'200 MN' or '10 kN'"),
    "power": ("a power", "'250 kW'"),
    "angle": ("an angle", "'2 deg' or '0.1 rad'"),
    "speed": ("a speed", "'3 m/min' or '0.1 m/s'"),
    "angular_speed": ("an angular speed", "'0.5 deg/s' or '0.1 rad/s'"),
    "acceleration": ("an acceleration", "'0.1 m/s^2'"),
    "angular_acceleration": ("an angular acceleration", "'0.01 deg/s^2' or '0.001 rad/s^2'"),
    "mass_flow": ("a rate of pumping", "'500 t/h' or '140 kg/s'"),
    "stiffness": ("a stiffness", "'200 MN/m' or '5 kN/m'"),
    "damping": ("a damping", "'2 MN s/m' or '5 kN s/m'"),
    "torque": ("a torque", "'5 kN m'"),
    "rotational_stiffness": ("a rotational stiffness", "'50 MN m/rad' or '5 kN m/rad'"),
    "rotational_damping": ("a rotational damping", "'5 kN m s'"),
    "inertia": ("an inertia", "'110.9 t m^2' or '500 kg m^2'"),
    "area": ("an area", "'120 m^2'"),
    "volume": ("a volume", "'25 m^3'"),
    "mass_moment": ("a mass times a length", "'500 t m'"),
    "coupled_damping": ("a damping that couples shift and turn", "'20 kN s'"),
    "mass_per_length": ("a mass per length", "'16.8 kg/m'"),
    "density": ("a density", "'1.025 t/m^3'"),
    "stress": ("a stress, pressure or modulus", "'100 kN/mm^2' or '150 kPa'"),
    "ratio": ("a share", "'5 %' or '0.05'"),
}

#: Units that lifts are written in elsewhere, in units of here: a near name, mph for km/h, is another size.
_ELSEWHERE: Final[dict[str, dict[str, tuple[float, str]]]] = {
    "length": {"ft": (0.3048, "m"), "in": (25.4, "mm")},
    "mass": {"lb": (0.45359237, "kg"), "lbs": (0.45359237, "kg")},
    "force": {
        "kip": (4.4482216152605, "kN"),
        "kips": (4.4482216152605, "kN"),
        "lbf": (4.4482216152605, "N"),
        "tf": (9.80665, "kN"),
        "kgf": (9.80665, "N"),
    },
    "speed": {
        "ft/min": (0.3048, "m/min"),
        "ft/s": (0.3048, "m/s"),
        "mph": (0.44704, "m/s"),
        "kn": (1852 / 3600, "m/s"),
        "knots": (1852 / 3600, "m/s"),
        "kt": (1852 / 3600, "m/s"),
        "kts": (1852 / 3600, "m/s"),
        "m/h": (1 / 60, "m/min"),
        "fpm": (0.3048, "m/min"),
    },
    "stress": {
        "t/m^2": (9.80665, "kPa"),
        "kN/m^2": (1.0, "kPa"),
        "bar": (100.0, "kPa"),
        "psi": (6.894757293168, "kPa"),
    },
}
#: Those that are metric: speeds of strand jacks are given in m/h, and miles per hour look like it.
_METRIC_ELSEWHERE: Final = frozenset({"m/h"})
#: Units that are smaller or larger than any of here, in units of here. A small one may stand for a unit whose
#: letters differ by their case alone, which is a thousand million times as large.
_OTHER_SIZES: Final[dict[str, dict[str, tuple[float, str]]]] = {
    "length": {"um": (1e-3, "mm"), "µm": (1e-3, "mm"), "nm": (1e-6, "mm")},
    "mass": {"mg": (1e-6, "kg"), "kt": (1e3, "t")},
    "stiffness": {"GN/m": (1e3, "MN/m")},
    "rotational_stiffness": {"GN m/rad": (1e3, "MN m/rad")},
    "torque": {"GN m": (1e3, "MN m")},
    "force": {"mN": (1e-3, "N"), "uN": (1e-6, "N"), "µN": (1e-6, "N")},
}
#: Units in other spellings, which are not near to their symbols.
_SPELT_OUT: Final[dict[str, str]] = {
    **dict.fromkeys(("tonne", "tonnes", "metric ton", "metric tons"), "t"),
    **dict.fromkeys(("metre", "metres", "meter", "meters"), "m"),
    **dict.fromkeys(("second", "seconds"), "s"),
    **dict.fromkeys(("minute", "minutes"), "min"),
    **dict.fromkeys(("hr", "hrs", "hour", "hours"), "h"),
    **dict.fromkeys(("\u00b0", "\u00ba"), "deg"),
    **dict.fromkeys(("percent", "per cent"), "%"),
    **dict.fromkeys(("rpm", "r/min", "1/min", "min^-1", "u/min"), "rev/min"),
    "mpm": "m/min",
    **dict.fromkeys(("kph", "kmh", "kmph"), "km/h"),
}
#: One that has several sizes.
_TONS: Final = "a short ton is 0.9072 t, a long ton 1.016 t"

_NUMBER: Final = r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?"
_QUANTITY: Final = re.compile(rf"({_NUMBER})\s*(\S.*)?", re.ASCII)
#: A number whose thousands are marked, or which has three digits behind a decimal comma; and what follows it.
#: Programs mark them as `1_000`, Switzerland as `1'000`.
_GROUPED: Final = re.compile(r"([+-]?[0-9]{1,3})([, _'])([0-9]{3}(?:\2[0-9]{3})*)\s*([^0-9\s,.].*)", re.ASCII)
#: One of several quantities that are written as one, `1 min 30 s`.
_PART: Final = re.compile(r"([0-9]+\.?[0-9]*)\s*([A-Za-z%]+)\s*", re.ASCII)
#: A power without its sign, `m/s2`.
_POWER: Final = re.compile(r"(?<=[A-Za-z])([23])\b")
_TOLERANCE: Final = re.compile(r"±|\+\s*/?\s*-")
#: Blanks that do not part lines, of thousands and of pages of the web.
_OTHER_BLANKS: Final = re.compile("[\u00a0\u2000-\u200a\u202f\u205f\u3000]")
#: What word processors make of a minus sign.
_DASHES: Final = "\u2212\u2010\u2011\u2012\u2013\u2014\uff0d"
#: With which a mass weighs a force where one is given for the other [m/s^2].
_GRAVITY: Final = 9.81
#: Points of the compass that people give for directions, as angles from east towards north [deg].
_COMPASS: Final = {
    point: (90.0 - 22.5 * place) % 360.0
    for place, point in enumerate(
        ("N", "NNE", "NE", "ENE", "E", "ESE", "SE", "SSE", "S", "SSW", "SW", "WSW", "W", "WNW", "NW", "NNW")
    )
}
_LONGEST: Final = 60


class UnitError(ValueError):
    """A text is not the quantity that is needed; the message is a plain sentence."""


def units_of(dimension: str) -> tuple[str, ...]:
    """Unit symbols that a dimension may be written in."""
    return tuple(DIMENSIONS[dimension])


def example(dimension: str) -> str:
    """Sentence part that names a dimension with examples: ``a mass is written like '300 t' or '20 kg'``."""
    name, examples = _WORDS[dimension]
    return f"{name} is written like {examples}"


def common_dimension(*texts: str, among: Iterable[str] = DIMENSIONS) -> str:
    """Dimension in which all of some quantities are written; a bare zero has any.

    Args:
        texts: as written.
        among: those that it may be, keys of `DIMENSIONS`; one that a share may be ends with `ratio`.

    Raises:
        UnitError: if one is no quantity, or they have no dimension in common.
    """
    common = list(among)
    for text in texts:
        fitting = [dimension for dimension in common if _is_quantity(text, dimension)]
        if not fitting:
            what = example(common[0]) if len(common) == 1 else "a quantity is written like '0.2 m' or '5 %'"
            raise UnitError(f"found '{text[:_LONGEST]}'; {what}")
        common = fitting
    return common[-1] if "ratio" in common else common[0]


def is_quantity(text: str) -> bool:
    """Whether a text is a number with a unit of any dimension, or a share."""
    return any(_is_quantity(text, dimension) for dimension in DIMENSIONS)


def si_text(value: float, dimension: str) -> str:
    """A value [SI] as a text that reads back to the last digit."""
    unit = next(unit for unit, factor in DIMENSIONS[dimension].items() if factor == 1.0)
    return f"{value!r} {unit}".strip()


def in_unit(value: float, dimension: str, unit: str, digits: int = 6) -> str:
    """A value [SI] in a unit of its dimension, with so many digits at most: ``3 t``."""
    return f"{value / DIMENSIONS[dimension][unit]:.{digits}g} {unit}".strip()


def unit_of(*texts: str, dimension: str) -> str:
    """Unit in which quantities of one dimension are written: that of the last which has one.

    Args:
        texts: as written; a bare zero has no unit.
        dimension: theirs, a key of `DIMENSIONS`, whose first unit counts where none has one; shares without
            one are plain numbers.
    """
    for text in reversed(texts):
        match = _QUANTITY.fullmatch(text.strip())
        if match is not None and (unit := _plain(match.group(2) or "")) in DIMENSIONS[dimension] and unit:
            return unit
    return "" if "" in DIMENSIONS[dimension] else units_of(dimension)[0]


def _is_quantity(text: str, dimension: str) -> bool:
    try:
        quantity(text, dimension)
    except UnitError:
        return False
    return True


def quantity(text: str, dimension: str) -> float:
    """Value of a written quantity.

    Args:
        text: the quantity as written, such as ``300 t``.
        dimension: a key of `DIMENSIONS`.

    Returns:
        The value [SI unit of the dimension].

    Raises:
        KeyError: if there is no such dimension.
        TypeError: if it is no text, such as a number without a unit.
        UnitError: if the text is no finite number with a unit of this dimension.
    """
    if dimension not in DIMENSIONS:
        raise KeyError(f"no dimension is {dimension!r}; there are {', '.join(DIMENSIONS)}")
    needed(text, str, "a text", example(dimension))
    shown = text if len(text) <= _LONGEST else text[:_LONGEST] + "..."
    match = _QUANTITY.fullmatch(text.strip())
    if match is None:
        raise UnitError(_not_a_number(shown, dimension))
    number = float(match.group(1))
    unit = _plain(match.group(2) or "")
    if not math.isfinite(number):
        raise UnitError(f"'{shown}' is too large to be a number; {example(dimension)}")
    units = DIMENSIONS[dimension]
    if unit in units:
        value = number * units[unit]
        if not math.isfinite(value):
            raise UnitError(f"'{shown}' is too large to be a number; {example(dimension)}")
        return value
    if unit == "":
        if number == 0.0:
            return 0.0
        raise UnitError(f"'{shown}' has no unit; {example(dimension)}")
    raise UnitError(_wrong_unit(shown, number, unit, dimension))


def format_quantity(value: float, unit: str, digits: int) -> str:
    """Write an SI value in a unit: ``format_quantity(702043, "kN", 1) == "702.0 kN"``; never "-0.0".

    Args:
        value: the value [SI].
        unit: a unit symbol of `DIMENSIONS`.
        digits: decimals after the point; a force in kN and a mass in t that these would round by more than
            1 % gets more of them, down to 1 N and 1 kg: lifts of 200 kg are shown by the same tables.

    Raises:
        UnitError: if the unit is not known.
    """
    for units in DIMENSIONS.values():
        if unit in units:
            shown = value / units[unit]
            decimals = _decimals(shown, digits) if unit in _THOUSANDS else digits
            return f"{_decimal_text(shown, decimals)} {unit}".rstrip()
    raise UnitError(f"'{unit}' is not a known unit")


def _decimal_text(value: float, digits: int) -> str:
    """A number with so many decimals, halves away from zero: as people round, and as the player does.

    Python's own way has 47.25 as 47.2: a design weight of 45 t x 1.05, which people write as 47.3 t.
    """
    if not math.isfinite(value):
        return f"{value:.{digits}f}"
    return f"{Decimal(value).quantize(Decimal(1).scaleb(-digits), context=_HALVES_UP):zf}"


def length_digits(value: float) -> int:
    """Decimals of a distance in m: 2, and 3 of less than 1 m, of which people count millimetres.

    Args:
        value: the distance, or how much is left of one [m].
    """
    return 3 if abs(value) < 1.0 else 2


def telling_digits(value: float, limit: float, unit: str, digits: int) -> int:
    """Decimals, at least these, with which a value past its limit is not written like the limit.

    Args:
        value: the value [SI].
        limit: what it is past [SI].
        unit: a unit symbol of `DIMENSIONS`.
        digits: decimals with which both are written otherwise; they stay where four more do not tell either.

    Raises:
        UnitError: if the unit is not known.
    """
    for more in range(digits, digits + 5):
        if format_quantity(value, unit, more) != format_quantity(limit, unit, more):
            return more
    return digits


def compared_digits(value: float, limit: float | None, unit: str, digits: int, *, at_least: bool) -> int:
    """Decimals, at least these, with which a value and what it is held against are written.

    Args:
        value: the value [SI].
        limit: what it is held against [SI]; None for nothing.
        unit: a unit symbol of `DIMENSIONS`.
        digits: decimals of both, if these tell a value past its limit from it.
        at_least: whether the limit is the smallest allowed value, not the largest.

    Raises:
        UnitError: if the unit is not known.
    """
    digits = max(digits, length_digits(value)) if unit == "m" else digits
    if limit is None:
        return digits
    is_past = value < limit if at_least else value > limit
    return telling_digits(value, limit, unit, digits) if is_past else digits


def _decimals(value: float, digits: int) -> int:
    """Decimals that keep what rounding takes off a value below 1 %, of one that is more than rounding."""
    while digits < _OF_A_THOUSAND and abs(value) >= _TO_TELL and 0.5 * 0.1**digits > 0.01 * abs(value):
        digits += 1
    return digits


def format_by_size(value: float, dimension: str, digits: int = 3) -> str:
    """Write an SI value in the largest unit of which it is at least one: `150 kN`, `1.5 MN`, `900 N`.

    Args:
        value: the value [SI].
        dimension: `force`, `mass` or `rotational_stiffness`.
        digits: significant digits; zeros after the point are left out.
    """
    factors = DIMENSIONS[dimension]
    rounded = float(f"{value:.{digits}g}")
    *larger, smallest = _BY_SIZE[dimension]
    unit = next((unit for unit in larger if abs(rounded) >= factors[unit]), smallest)
    return f"{float(f'{rounded / factors[unit]:.{digits}g}') + 0.0:,.15g} {unit}"


def _plain(unit: str) -> str:
    """One spelling for one unit: no superscripts, product dots or repeated spaces."""
    unit = unit.replace("²", "^2").replace("·", " ").replace("*", " ").replace("µs", "us")
    return " ".join(unit.split())


def _not_a_number(shown: str, dimension: str) -> str:
    if re.fullmatch(r"[+-]?\.?(nan|inf|infinity)\b.*", shown.strip(), re.IGNORECASE):
        return f"'{shown}' is not a finite number; {example(dimension)}"
    if _QUANTITY.fullmatch(shown.strip()[1:].strip()) and shown.strip()[0] in _DASHES:
        dash, right = shown.strip()[0], f"-{shown.strip()[1:].strip()}"
        return f"'{shown}' begins with '{dash}', a dash; a minus sign is '-': write '{right}'"
    if dimension == "angle" and (angle := _COMPASS.get(shown.strip().upper())) is not None:
        point, opposite = shown.strip(), (angle + 180.0) % 360.0
        counts = "angles count from world x towards y, of wind, current and waves to where they go"
        ends = f"'{angle:g} deg' is towards {point}, and what comes from {point} has '{opposite:g} deg'"
        return f"'{point}' is a point of the compass; {counts}: with x to the east and y to the north {ends}"
    return f"'{shown}' is not a number with a unit; {example(dimension)}"


def _wrong_unit(shown: str, number: float, unit: str, dimension: str) -> str:
    if grouped := _GROUPED.fullmatch(_OTHER_BLANKS.sub(" ", shown.strip())):
        first, mark, digits, rest = grouped.groups()
        whole = f"'{first}{digits.replace(mark, '')} {rest}'"
        is_either = mark == "," and len(digits) == 3
        decimal = f", or decimals with a point, '{first}.{digits} {rest}'" if is_either else ""
        return f"'{shown}': thousands are written without a mark, {whole}{decimal}"
    if re.match(r",[0-9]", unit):
        right = shown.strip().replace(",", ".", 1)
        asked = f"write '{right}'" if _is_quantity(right, dimension) else example(dimension)
        return f"'{shown}' has a decimal comma; a decimal point is needed: {asked}"
    if (several := _several(shown, dimension)) is not None:
        return several
    for other, units in DIMENSIONS.items():
        if unit in units:
            name, examples = _WORDS[dimension]
            weighed = _weighed(shown, number * units[unit], other, dimension)
            return f"'{shown}' is {_WORDS[other][0]}; needed is {name}, written like {examples}{weighed}"
    powers = _POWER.sub(r"^\1", unit)
    if powers in (elsewhere := _ELSEWHERE.get(dimension, {})):
        factor, here = elsewhere[powers]
        why = "" if powers in _METRIC_ELSEWHERE else "units are metric: "
        # Five digits: within a twenty-thousandth of what was written, and no more than people copy right.
        said = f"{float(f'{number * factor:.5g}'):.15g} {here}"
        return f"'{shown}' is {said}; {why}{example(dimension)}"
    if unit in (others := _OTHER_SIZES.get(dimension, {})):
        factor, here = others[unit]
        alike = [other for other in DIMENSIONS[dimension] if other.lower() == unit.lower()]
        asked = f"; or is '{alike[0]}' meant?" if alike else ""
        return f"'{unit}' in '{shown}' is no unit here; it is written '{number * factor:.7g} {here}'{asked}"
    spelt_out = _SPELT_OUT.get(unit.lower(), powers)
    if unit.lower() not in _SPELT_OUT and dimension == "mass" and unit.endswith(("ton", "tons")):
        return f"'{unit}' in '{shown}' has several sizes: {_TONS}; {example(dimension)}"
    known = [symbol for symbol in DIMENSIONS[dimension] if symbol]
    lowered = {symbol.lower(): symbol for symbol in reversed(known)}
    near = difflib.get_close_matches(unit.lower(), list(lowered), n=1, cutoff=0.5)
    likely = spelt_out if spelt_out in known else lowered[near[0]] if near else None
    hint = example(dimension) if likely is None else f"did you mean '{likely}'?"
    return f"'{unit}' in '{shown}' is not a unit of {_WORDS[dimension][0].split(' ', 1)[1]}; {hint}"


def _several(shown: str, dimension: str) -> str | None:
    """What is to be said of several numbers where one is needed; None where there is one."""
    if (tolerance := _TOLERANCE.search(shown)) is not None:
        right = shown[: tolerance.start()].strip()
        return f"'{shown}' has a tolerance, and that has a key of its own; right is '{right}'"
    if dimension == "time" and re.match(r"[0-9]+:[0-9]", shown):
        return f"'{shown}' is written with a ':'; a time is one number with its unit, such as '90 s'"
    parts = _PART.findall(shown)
    units = DIMENSIONS[dimension]
    is_whole = "".join(match.group(0) for match in _PART.finditer(shown)) == shown
    if len(parts) < 2 or not is_whole or any(unit not in units for _, unit in parts):
        return None
    last = parts[-1][1]
    total = sum(float(number) * units[unit] for number, unit in parts) / units[last]
    return f"'{shown}' is written in several units; right is one: '{total:.12g} {last}'"


def _weighed(shown: str, value: float, given: str, needed: str) -> str:
    """The force that a mass weighs, or the mass that weighs a force, where one is given for the other."""
    if value > 0.0 and (given, needed) == ("force", "mass"):
        return f" ({_rounded(value / _GRAVITY / _TONNE)} t weigh {shown})"
    if value > 0.0 and (given, needed) == ("mass", "force"):
        return f" ({shown} weigh {_rounded(value * _GRAVITY / 1e3)} kN)"
    return ""


def _rounded(value: float) -> str:
    """Four digits, written out."""
    return f"{float(f'{value:.4g}'):.12g}"
