"""Numbers of an OCX file in SI units: quantities, points and directions, by the file's own table of units.

A file lists its units (UnitsML) and gives each number the name of one. A unit says what it is up to three
times, and exporters contradict themselves: one calls millimetres ``mm`` and makes their root unit mm⁻³. The
symbol is asked first, then the name in English, then the root units.
"""

from __future__ import annotations

import math
import re

import numpy as np
import numpy.typing as npt

from gantline.cad.errors import CadError
from gantline.cad.ocx.xml import Element
from gantline.units import DIMENSIONS

__all__ = ["Quantities", "described"]

Array = npt.NDArray[np.float64]

_FOOT, _INCH, _POUND = 0.3048, 0.0254, 0.45359237  # international, exact by definition

#: SI size of what a symbol or an English name says, by dimension.
_LENGTHS = {
    **DIMENSIONS["length"],
    "dm": 0.1,
    '"': _INCH,
    "in": _INCH,
    "'": _FOOT,
    "ft": _FOOT,
    "yd": 3 * _FOOT,
    "meter": 1.0,
    "metre": 1.0,
    "millimeter": 1e-3,
    "millimetre": 1e-3,
    "centimeter": 1e-2,
    "centimetre": 1e-2,
    "decimeter": 0.1,
    "decimetre": 0.1,
    "inch": _INCH,
    "inches": _INCH,
    "foot": _FOOT,
    "feet": _FOOT,
    "yard": 3 * _FOOT,
}
_SYMBOLS: dict[str, tuple[str, float]] = {
    **{name: ("length", size) for name, size in _LENGTHS.items()},
    **{f"{name}{power}": (kind, size**exponent)
       for name, size in DIMENSIONS["length"].items()
       for powers, kind, exponent in (("2²", "area", 2), ("3³", "volume", 3), ("4⁴", "fourth", 4))
       for power in powers},
    **{f"{name}^{exponent}": (kind, size**exponent)
       for name, size in DIMENSIONS["length"].items()
       for kind, exponent in (("area", 2), ("volume", 3), ("fourth", 4))},
    **{name: ("mass", size) for name, size in DIMENSIONS["mass"].items()},
    "lb": ("mass", _POUND),
    "kilogram": ("mass", 1.0),
    "kilo gram": ("mass", 1.0),
    "tonne": ("mass", 1000.0),
    "kg/m3": ("density", 1.0),
    "kg/m^3": ("density", 1.0),
    "kg/m³": ("density", 1.0),
    "t/m3": ("density", 1000.0),
    "g/cm3": ("density", 1000.0),
    "kg/dm3": ("density", 1000.0),
    **{name: ("angle", size) for name, size in DIMENSIONS["angle"].items()},
    "°": ("angle", math.pi / 180.0),
}  # fmt: skip

_PREFIXES = {"k": 1e3, "h": 1e2, "d": 1e-1, "c": 1e-2, "m": 1e-3, "u": 1e-6, "µ": 1e-6, "M": 1e6}
_ROOTS = {
    "meter": ("length", 1.0),
    "gram": ("mass", 1e-3),
    "inch": ("length", _INCH),
    "foot": ("length", _FOOT),
    "yard": ("length", 3 * _FOOT),
    "pound": ("mass", _POUND),
    "radian": ("angle", 1.0),
    "arc_degree": ("angle", math.pi / 180.0),
}
_DIMENSION_OF = {
    (("length", 1),): "length",
    (("length", 2),): "area",
    (("length", 3),): "volume",
    (("length", 4),): "fourth",
    (("mass", 1),): "mass",
    (("length", -3), ("mass", 1)): "density",
    (("angle", 1),): "angle",
}
_WORDS = {
    "length": "a length",
    "mass": "a mass",
    "density": "a density",
    "area": "an area",
    "angle": "an angle",
}


class Quantities:
    """Reads numbers of one file.

    Attributes:
        file: name of the file, for messages.
        used: units of length that have been met, by their name in the file, with their size [m].
    """

    def __init__(self, root: Element, file: str) -> None:
        self.file = file
        self.used: dict[str, float] = {}
        self._units: dict[str, tuple[str, float]] = {}
        for element in (table for child in root.all("UnitsML") for table in child.walk()):
            if element.name == "Unit" and "id" in element.attributes:
                unit = _unit(element)
                if unit is not None:
                    self._units[element.attributes["id"]] = unit

    def fail(self, element: Element, what: str) -> CadError:
        """An error that names file, line and element."""
        return CadError(f"{self.file}: line {element.line}: {described(element)} {what}")

    def quantity(self, element: Element, dimension: str = "length") -> float:
        """Value of a quantity [SI].

        Raises:
            CadError: if it has no finite number, or its unit is unknown or of another dimension.
        """
        text = element.attributes.get("numericvalue")
        if text is None:
            raise self.fail(element, "has no numericvalue")
        return self._number(element, text) * self._size(element, dimension)

    def of_child(self, parent: Element, name: str, dimension: str = "length") -> float | None:
        """Value [SI] of the quantity that is a child; None if there is none."""
        child = parent.child(name)
        return None if child is None else self.quantity(child, dimension)

    def needed(self, parent: Element, name: str, dimension: str = "length") -> float:
        """As `of_child`, of a child that must be there; CadError if it is not."""
        value = self.of_child(parent, name, dimension)
        if value is None:
            raise self.fail(parent, f"has no {name}")
        return value

    def positive(self, parent: Element, name: str, dimension: str = "length") -> float:
        """As `needed`, of a value that must be greater than zero; CadError if it is not."""
        value = self.needed(parent, name, dimension)
        if not value > 0:
            raise self.fail(parent, f"has a {name} of {value:g}, which is not positive")
        return value

    def point(self, element: Element) -> Array:
        """Coordinates (3,) [m], in either encoding: a list of three, or a child each."""
        if "coordinates" in element.attributes:
            return self.numbers(element, "coordinates", 3) * self._size(element, "length")
        inner = element.child("Point3D")
        if inner is not None:
            return self.point(inner)
        return np.array([self.needed(element, axis) for axis in ("X", "Y", "Z")])

    def point_of(self, parent: Element, name: str) -> Array:
        """Coordinates (3,) [m] of a child that must be there; CadError if it is not."""
        child = parent.child(name)
        if child is None:
            raise self.fail(parent, f"has no {name}")
        return self.point(child)

    def direction(self, parent: Element, name: str) -> Array:
        """Unit vector (3,) of a child that must be there, in either encoding.

        Raises:
            CadError: if it is not there, or has no direction.
        """
        child = parent.child(name)
        if child is None:
            raise self.fail(parent, f"has no {name}")
        if "direction" in child.attributes:
            vector = self.numbers(child, "direction", 3)
        else:
            vector = np.array([self._number(child, child.attributes.get(axis, "")) for axis in "xyz"])
        length = float(np.linalg.norm(vector))
        if not 1e-9 < length < 1e9:
            raise self.fail(child, "is no direction: its length is not finite and positive")
        return vector / length

    def numbers(self, element: Element, attribute: str, count: int | None = None) -> Array:
        """A list of numbers in an attribute as it stands there, shape (count,).

        Raises:
            CadError: if it is no list of finite numbers, or not of as many as said.
        """
        text = element.attributes.get(attribute, "")
        try:
            values = np.array(text.split(), dtype=float)
        except ValueError:
            raise self.fail(element, f"has a {attribute} that is no list of numbers") from None
        if count is not None and len(values) != count:
            raise self.fail(element, f"has {len(values)} numbers as {attribute}, not {count}")
        if not np.isfinite(values).all() or (len(values) and float(np.abs(values).max()) > 1e12):
            raise self.fail(element, f"has a number beyond all bounds as {attribute}")
        return values

    def _number(self, element: Element, text: str) -> float:
        try:
            value = float(text)
        except ValueError:
            raise self.fail(element, f"has '{text[:40]}' where a number must be") from None
        if not math.isfinite(value) or abs(value) > 1e12:
            raise self.fail(element, f"has a number beyond all bounds: '{text[:40]}'")
        return value

    def _size(self, element: Element, dimension: str) -> float:
        name = element.attributes.get("unit")
        if name is None:
            raise self.fail(element, "has no unit")
        unit = self._units.get(name)
        if unit is None:
            raise self.fail(
                element, f"has the unit '{name[:40]}', which the file's table of units does not explain"
            )
        found, size = unit
        if (found, dimension) == ("length", "area"):
            return size**2  # as one exporter writes its areas
        if found != dimension:
            right = _WORDS.get(dimension, dimension)
            raise self.fail(
                element, f"has the unit '{name[:40]}' of {_WORDS.get(found, found)}, not of {right}"
            )
        if dimension == "length":
            self.used[name] = size
        return size


def described(element: Element) -> str:
    """What an element is, with its name if it has one."""
    name = element.attributes.get("name") or element.attributes.get("id")
    return f"{element.name} '{name[:60]}'" if name else element.name


def _unit(element: Element) -> tuple[str, float] | None:
    """Dimension and SI size of a unit; None if nothing that is needed here."""
    symbols = [symbol.attributes.get("type") or symbol.text for symbol in element.all("UnitSymbol")]
    names = [
        name.text.lower()
        for name in element.all("UnitName")
        if name.attributes.get("lang", "en").lower().startswith("en")
    ]
    for text in (*symbols, *names):
        plain = re.sub(r"\s+", " ", text).strip()
        for candidate in (plain, plain.removesuffix("s")):
            if candidate in _SYMBOLS:
                return _SYMBOLS[candidate]
    return _from_roots(element)


def _from_roots(element: Element) -> tuple[str, float] | None:
    powers: dict[str, int] = {}
    size = 1.0
    for root in (each for group in element.all("RootUnits") for each in group.all("EnumeratedRootUnit")):
        known = _ROOTS.get(root.attributes.get("unit", ""))
        prefix = root.attributes.get("prefix")
        if known is None or (prefix is not None and prefix not in _PREFIXES):
            return None
        try:
            power = int(root.attributes.get("powerNumerator", "1"))
        except ValueError:
            return None
        if not -4 <= power <= 4:
            return None
        dimension, one = known
        powers[dimension] = powers.get(dimension, 0) + power
        size *= (one * (_PREFIXES[prefix] if prefix is not None else 1.0)) ** power
    found = _DIMENSION_OF.get(tuple(sorted((name, power) for name, power in powers.items() if power)))
    return None if found is None else (found, size)
