"""Field types of the scenario models: quantities with units, plain numbers, names, texts.

Every value arrives as the text that stands in the file. A type here turns it into a float in SI units (or a
name, a number, a truth value), refuses it with a plain sentence, and describes itself to editors through the
JSON Schema.
"""

from __future__ import annotations

import re
from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import Annotated, Any, Final

from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler
from pydantic.json_schema import JsonSchemaValue
from pydantic_core import PydanticCustomError, core_schema

from gantline.scenario.errors import shorten
from gantline.units import DIMENSIONS, UnitError, example, quantity, units_of

#: Largest size of a quantity that is taken for meant [SI]; anything beyond is a slip of the pen.
_LARGEST: Final[dict[str, tuple[float, str]]] = {
    "length": (1e5, "100 km"),
    "mass": (1e9, "1000000 t"),
    "time": (1e6, "1000000 s"),
    "force": (1e13, "1e7 MN"),
    "power": (1e12, "1e6 MW"),
    "angle": (100.0, "5729 deg"),
    "speed": (1e3, "1000 m/s"),
    "angular_speed": (1e4, "1e4 rad/s"),
    "acceleration": (1e4, "1e4 m/s^2"),
    "angular_acceleration": (1e3, "1e3 rad/s^2"),
    "mass_flow": (1e6, "3.6e6 t/h"),
    "stiffness": (1e13, "1e7 MN/m"),
    "damping": (1e13, "1e7 MN s/m"),
    "torque": (1e12, "1e6 MN m"),
    "rotational_stiffness": (1e15, "1e9 MN m/rad"),
    "rotational_damping": (1e12, "1e6 MN m s"),
    "inertia": (1e15, "1e12 t m^2"),
    "area": (1e7, "1e7 m^2"),
    "volume": (1e9, "1e9 m^3"),
    "mass_moment": (1e12, "1e9 t m"),
    "coupled_damping": (1e13, "1e7 MN s"),
    "mass_per_length": (1e5, "100 t/m"),
    "density": (1e5, "100 t/m^3"),
    "stress": (1e13, "1e4 GPa"),
    "ratio": (1e4, "1e4"),
}

#: Largest share of a limit that is written without its percent sign: what is more has lost it [1].
_MOST_PLAIN: Final = 2.0
#: Smallest size of a quantity that has to be above zero [SI]; below it arithmetic has no room left.
SMALLEST: Final = 1e-9

_NUMBER: Final = r"[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?"
NAME_PATTERN: Final = r"[A-Za-z0-9_.\-]+"
_BETWEEN_NAMES: Final = re.compile(r"\s*[,;&+]\s*|\s+and\s+")
_LONGEST_NAME: Final = 64
_LONGEST_JOINED: Final = 4 * _LONGEST_NAME
_LONGEST_TEXT: Final = 2000


def refuse(sentence: str, key: str | None = None, **context: Any) -> PydanticCustomError:
    """The error by which a validator refuses a value, or the `key` of a mapping, with a sentence of ours.

    What else is known of it, `context`, is for whoever makes messages of several errors.
    """
    of_key = {} if key is None else {"key": key}
    return PydanticCustomError("gantline", "{sentence}", {"sentence": sentence, **of_key, **context})


def found(value: object) -> str:
    """What a value is, for the first half of a message."""
    if isinstance(value, dict):
        return "a mapping" if value else "an empty mapping"
    if isinstance(value, list):
        return "a list" if value else "an empty list"
    return f"'{shorten(str(value))}'"


def one_line(sentence: str) -> str:
    """A sentence that repeats user text, on one printable line."""
    return "".join(character if character.isprintable() else "?" for character in " ".join(sentence.split()))


@dataclass(frozen=True)
class Reader(ABC):
    """A field type that reads one text; subclasses say how, and how the JSON Schema shows it."""

    @abstractmethod
    def read(self, value: object) -> Any:
        """Value from the text that stands in the file."""

    @abstractmethod
    def shown(self) -> JsonSchemaValue:
        """JSON Schema of the text."""

    def __get_pydantic_core_schema__(
        self, _source: Any, _handler: GetCoreSchemaHandler
    ) -> core_schema.CoreSchema:
        """Validate with `read` alone."""
        return core_schema.no_info_plain_validator_function(self.read)

    def __get_pydantic_json_schema__(
        self, _schema: core_schema.CoreSchema, _handler: GetJsonSchemaHandler
    ) -> JsonSchemaValue:
        """Describe with `shown` alone."""
        return self.shown()


@dataclass(frozen=True)
class Quantity(Reader):
    """A quantity with a unit, within bounds that make sense."""

    dimension: str
    sign: str = "any"  # any, positive (above zero), not_negative

    def read(self, value: object) -> float:
        """Value [SI unit of the dimension]."""
        if not isinstance(value, str):
            raise refuse(f"found {found(value)}; {example(self.dimension)}")
        try:
            number = quantity(value, self.dimension)
        except UnitError as error:
            raise refuse(one_line(str(error))) from None
        wrong = self._wrong(number, value)
        if wrong:
            raise refuse(f"'{shorten(value)}' {wrong}")
        return number

    def _wrong(self, number: float, text: str) -> str:
        """What is wrong with a number, to be said after its text; empty of one that may be."""
        largest, shown = _LARGEST[self.dimension]
        if self.sign != "any" and number < 0:
            bound = "above zero" if self.sign == "positive" else "zero or more"
            return f"is negative; this {self._name} has to be {bound}"
        if self.sign == "positive" and number == 0:
            return f"is zero; this {self._name} has to be above zero"
        if self.sign == "positive" and number < SMALLEST:
            return "is absurdly small; check the number and its unit"
        if abs(number) > largest:
            return f"is absurdly large (more than {shown}); check the number and its unit"
        return ""

    @property
    def _name(self) -> str:
        """What messages call it: `length`."""
        return example(self.dimension).split(" is written")[0].split(" ", 1)[1]

    def shown(self) -> JsonSchemaValue:
        """A string with the units of the dimension, or a bare zero."""
        units = "|".join(re.escape(unit).replace("\\ ", " ") for unit in units_of(self.dimension) if unit)
        optional = "?" if "" in DIMENSIONS[self.dimension] else ""
        examples = re.findall(r"'([^']*)'", example(self.dimension))
        text = {
            "type": "string",
            "pattern": rf"^\s*{_NUMBER}\s*({units}){optional}\s*$",
            "examples": examples,
        }
        zero = {"type": "string", "pattern": r"^\s*[+-]?0+(\.0*)?\s*$"}
        bare = {"type": "number"} if optional else {"const": 0}
        return {"anyOf": [text, bare] if optional else [text, zero, bare]}


@dataclass(frozen=True)
class Share(Quantity):
    """A share of something, not a coefficient of any size: 95 is no 9500 %."""

    dimension: str = "ratio"
    sign: str = "not_negative"

    def _wrong(self, number: float, text: str) -> str:
        if number > _MOST_PLAIN and "%" not in text:
            return f"is {100.0 * number:g} %; {example(self.dimension)}"
        return super()._wrong(number, text)


@dataclass(frozen=True)
class Number(Reader):
    """A plain number without a unit."""

    least: float = -1e12
    most: float = 1e12
    whole: bool = False

    def read(self, value: object) -> float | int:
        """The number."""
        text = value if isinstance(value, str) else ""
        if not re.fullmatch(r"[+-]?[0-9]+" if self.whole else _NUMBER, text.strip(), re.ASCII):
            likely = 1.05 if self.least <= 1.05 <= self.most else (self.least + self.most) / 2
            kind = "a whole number like '1'" if self.whole else f"a plain number like '{likely:g}'"
            raise refuse(f"found {found(value)}; {kind} is needed")
        number = float(text)
        if not self.least <= number <= self.most:
            raise refuse(f"'{shorten(text)}' is out of range; from {self.least:g} to {self.most:g} is right")
        return int(number) if self.whole else number

    def shown(self) -> JsonSchemaValue:
        """A number, or the same number as text."""
        kind = "integer" if self.whole else "number"
        return {
            "anyOf": [
                {"type": kind, "minimum": self.least, "maximum": self.most},
                {"type": "string", "pattern": r"^[+-]?[0-9]+$" if self.whole else rf"^{_NUMBER}$"},
            ]
        }


@dataclass(frozen=True)
class Truth(Reader):
    """`true` or `false`, and no other word."""

    def read(self, value: object) -> bool:
        """The truth value."""
        if value not in ("true", "false"):
            raise refuse(f"found {found(value)}; 'true' or 'false' is needed")
        return value == "true"

    def shown(self) -> JsonSchemaValue:
        """A truth value, or the same as text."""
        return {"enum": [True, False, "true", "false"]}


@dataclass(frozen=True)
class NameText(Reader):
    """A name: letters from a to z, digits, ``_``, ``-`` and ``.``; always text."""

    def read(self, value: object) -> str:
        """The name as text."""
        if not isinstance(value, str) or not re.fullmatch(NAME_PATTERN, value, re.ASCII):
            right = "a name has letters from a to z, digits, '_', '-' and '.' only"
            raise refuse(f"found {found(value)}; {right}")
        # Before its own name and a dot a lug has that of its load, a drum those of its crane and hook.
        if max(map(len, value.split("."))) > _LONGEST_NAME or len(value) > _LONGEST_JOINED:
            dots = f" between dots, {_LONGEST_JOINED} in all" if "." in value else ""
            raise refuse(f"found {found(value)}; a name has at most {_LONGEST_NAME} characters{dots}")
        return str(value)

    def shown(self) -> JsonSchemaValue:
        """A string of the letters that names have; YAML readers of editors may take ``1`` for a number."""
        return {"type": ["string", "number", "boolean"], "pattern": f"^{NAME_PATTERN}$"}


@dataclass(frozen=True)
class Word(Reader):
    """One of a few words, which may look like numbers; `forms` are what may stand in place of a word."""

    words: tuple[str, ...]
    forms: tuple[str, ...] = ()

    def read(self, value: object) -> str:
        """The word."""
        if value not in self.words:
            right = " or ".join((*map(repr, self.words), *self.forms))
            raise refuse(f"found {found(value)}; right is {right}")
        return str(value)

    def shown(self) -> JsonSchemaValue:
        """The words, and the numbers that YAML readers of editors may take them for."""
        return {"enum": [*self.words, *(int(word) for word in self.words if word.isdecimal())]}


@dataclass(frozen=True)
class FreeText(Reader):
    """Any text, such as a title."""

    def read(self, value: object) -> str:
        """The text."""
        if not isinstance(value, str):
            raise refuse(f"found {found(value)}; a text is needed")
        if len(value) > _LONGEST_TEXT:
            raise refuse(f"found a text of {len(value)} characters; at most {_LONGEST_TEXT} are allowed")
        if not value.strip():
            raise refuse("found an empty text; write something or leave the key out")
        return str(value)

    def shown(self) -> JsonSchemaValue:
        """A string; YAML readers of editors may take it for a number."""
        return {"type": ["string", "number", "boolean"]}


@dataclass(frozen=True)
class FilesReader(Reader):
    """Reads the name of a file, or a list of such."""

    most: int = 20

    def read(self, value: object) -> tuple[str, ...]:
        """Their names."""
        names = value if isinstance(value, list) else [value]
        if not names or not all(isinstance(name, str) and name.strip() for name in names):
            raise refuse(f"found {found(value)}; the name of a file or a list of such names is needed")
        if len(names) > self.most:
            raise refuse(f"found {len(names)} files; at most {self.most} are right")
        if len({*names}) < len(names):
            raise refuse("a file is named twice; once is right")
        return tuple(str(name) for name in names)

    def shown(self) -> JsonSchemaValue:
        """A text, or a list of texts."""
        return {
            "anyOf": [
                {"type": "string", "examples": ["yard.yaml"]},
                {"type": "array", "items": {"type": "string"}, "minItems": 1, "maxItems": self.most},
            ]
        }


@dataclass(frozen=True)
class ListOf(Reader):
    """A list of values of one field type, of a given length or at least one."""

    item: Reader
    count: int | None = None
    least: int = 1
    scalar: bool = False  # one value may stand alone, without brackets
    right: str | None = None  # one that would do, where a value repeated would not

    def read(self, value: object) -> tuple[Any, ...]:
        """The values."""
        needed = f"a list of {self.count}" if self.count is not None else "a list"
        if self.scalar and isinstance(value, str):
            return (self._alone(value),)
        if not isinstance(value, list):
            raise refuse(f"found {found(value)}; {needed} is needed, such as {self._example(value)}")
        if self.count is not None and len(value) != self.count:
            right = self._with_points(value) or f"{needed} is needed, such as {self._example()}"
            raise refuse(f"found a list of {len(value)}; {right}")
        if len(value) < self.least:
            raise refuse(
                f"found a list of {len(value)}; at least {self.least} are needed, such as {self._example()}"
            )
        items = []
        for place, item in enumerate(value, start=1):
            try:
                items.append(self.item.read(item))
            except PydanticCustomError as error:
                raise refuse(f"item {place}: {error.message()}") from None
        return tuple(items)

    def _alone(self, value: str) -> Any:
        """The one item that stands without brackets; of several in one text it says how a list is written."""
        try:
            return self.item.read(value)
        except PydanticCustomError as error:
            right = f"found {found(value)}; several go into a list, {self._example(value)}"
            raise (refuse(right) if self._parted(value) else error) from None

    def _parted(self, value: object) -> list[str]:
        """Names or words that stand in one text, with commas between them; none of any other text."""
        if not isinstance(value, str) or not isinstance(self.item, (NameText, Word)):
            return []
        parts = _BETWEEN_NAMES.split(value.strip(" []"))
        is_right = len(parts) == self.count if self.count is not None else len(parts) >= max(self.least, 2)
        return parts if is_right and all(map(self._is_item, parts)) else []

    def _with_points(self, items: list[Any]) -> str | None:
        """What is right where commas within numbers parted items: `[0,5 m, 2 m]` is a list of three."""
        if not isinstance(self.item, Quantity) or not all(isinstance(item, str) for item in items):
            return None
        joined = re.sub(r"(?<![^ ])([+-]?[0-9]+), (?=[0-9]+ *[^0-9., ])", r"\1.", ", ".join(items))
        if len(joined.split(", ")) != self.count:
            return None
        return f"decimal commas? write [{shorten(joined)}]"

    def _is_item(self, given: object) -> bool:
        """Whether something that is no list would do as one of its items."""
        try:
            self.item.read(given)
        except PydanticCustomError:
            return False
        return isinstance(given, str)

    def _example(self, given: object = None) -> str:
        if parts := self._parted(given):
            return f"[{', '.join(parts)}]"
        if self.right is not None:
            return self.right
        if isinstance(self.item, Quantity) and self._is_item(given):
            one = str(given)
        elif isinstance(self.item, Quantity):
            one = re.findall(r"'([^']*)'", example(self.item.dimension))[0]
        elif isinstance(self.item, Number):  # not zeros alone, which are no direction
            return "[" + ", ".join(["0"] * ((self.count or self.least) - 1) + ["1"]) + "]"
        else:
            one = "name"
        return "[" + ", ".join([one] * (self.count or self.least)) + "]"

    def shown(self) -> JsonSchemaValue:
        """An array, or one item where that is allowed."""
        least = self.least if self.count is None else self.count
        array: JsonSchemaValue = {"type": "array", "items": self.item.shown(), "minItems": least}
        if self.count is not None:
            array["maxItems"] = self.count
        return {"anyOf": [self.item.shown(), array]} if self.scalar else array


@dataclass(frozen=True)
class SymmetricMatrix(Reader):
    """Six rows of six quantities over shifts and turns along x, y, z; symmetric."""

    shifts: str  # dimension of shifts over shifts
    mixed: str
    turns: str

    def read(self, value: object) -> tuple[tuple[float, ...], ...]:
        """The rows [SI units of the dimensions]."""
        if not isinstance(value, list) or len(value) != 6:
            raise refuse(f"found {found(value)}; a matrix is a list of six rows of six quantities each")
        rows = tuple(self._row(number, row) for number, row in enumerate(value))
        for i in range(6):
            for j in range(i):
                if abs(rows[i][j] - rows[j][i]) > 1e-9 * max(abs(rows[i][j]), abs(rows[j][i])):
                    places = f"row {i + 1}, item {j + 1} and row {j + 1}, item {i + 1}"
                    raise refuse(f"{places} differ; this matrix has to be symmetric")
        return rows

    def _row(self, number: int, row: object) -> tuple[float, ...]:
        if not isinstance(row, list) or len(row) != 6:
            raise refuse(f"row {number + 1}: found {found(row)}; a row is a list of six quantities")
        values = []
        for place, item in enumerate(row):
            try:
                values.append(Quantity(self._dimension(number, place)).read(item))
            except PydanticCustomError as error:
                raise refuse(f"row {number + 1}, item {place + 1}: {error.message()}") from None
        return tuple(values)

    def _dimension(self, row: int, column: int) -> str:
        return (self.shifts, self.mixed, self.turns)[(row > 2) + (column > 2)]

    def shown(self) -> JsonSchemaValue:
        """An array of arrays."""
        items = {
            "anyOf": [Quantity(dimension).shown() for dimension in (self.shifts, self.mixed, self.turns)]
        }
        row: JsonSchemaValue = {"type": "array", "items": items, "minItems": 6, "maxItems": 6}
        return {"type": "array", "items": row, "minItems": 6, "maxItems": 6}


@dataclass(frozen=True)
class WordOr(Reader):
    """One of a few words, or a value of another field type."""

    words: tuple[str, ...]
    other: Reader

    def read(self, value: object) -> Any:
        """The word, or the other value."""
        if isinstance(value, str) and value in self.words:
            return str(value)
        try:
            return self.other.read(value)
        except PydanticCustomError as error:
            listed = " or ".join(f"'{word}'" for word in self.words)
            raise refuse(f"{error.message()}; or {listed}") from None

    def shown(self) -> JsonSchemaValue:
        """The words, or the other."""
        return {"anyOf": [{"enum": list(self.words)}, self.other.shown()]}


Length = Annotated[float, Quantity("length")]
PositiveLength = Annotated[float, Quantity("length", "positive")]
NotNegativeLength = Annotated[float, Quantity("length", "not_negative")]
Mass = Annotated[float, Quantity("mass", "not_negative")]
PositiveMass = Annotated[float, Quantity("mass", "positive")]
PositiveForce = Annotated[float, Quantity("force", "positive")]
PositivePower = Annotated[float, Quantity("power", "positive")]
NotNegativeForce = Annotated[float, Quantity("force", "not_negative")]
Time = Annotated[float, Quantity("time", "not_negative")]
PositiveTime = Annotated[float, Quantity("time", "positive")]
Angle = Annotated[float, Quantity("angle")]
NotNegativeAngle = Annotated[float, Quantity("angle", "not_negative")]
PositiveAngle = Annotated[float, Quantity("angle", "positive")]
Speed = Annotated[float, Quantity("speed")]
PositiveSpeed = Annotated[float, Quantity("speed", "positive")]
AngularSpeed = Annotated[float, Quantity("angular_speed")]
PositiveAngularSpeed = Annotated[float, Quantity("angular_speed", "positive")]
PositiveAngularAcceleration = Annotated[float, Quantity("angular_acceleration", "positive")]
PositiveAcceleration = Annotated[float, Quantity("acceleration", "positive")]
Acceleration = Annotated[float, Quantity("acceleration", "not_negative")]
PositiveMassFlow = Annotated[float, Quantity("mass_flow", "positive")]
PositiveArea = Annotated[float, Quantity("area", "positive")]
PositiveStress = Annotated[float, Quantity("stress", "positive")]
PositiveStiffness = Annotated[float, Quantity("stiffness", "positive")]
Damping = Annotated[float, Quantity("damping", "not_negative")]
PositiveRotationalStiffness = Annotated[float, Quantity("rotational_stiffness", "positive")]
RotationalDamping = Annotated[float, Quantity("rotational_damping", "not_negative")]
Torque = Annotated[float, Quantity("torque", "not_negative")]
PositiveInertia = Annotated[float, Quantity("inertia", "positive")]
Inertia = Annotated[float, Quantity("inertia")]
Ratio = Annotated[float, Quantity("ratio", "not_negative")]
Position = Annotated[tuple[float, float, float], ListOf(Quantity("length"), 3)]
#: Three plain numbers, whatever their length.
Direction = Annotated[tuple[float, float, float], ListOf(Number(least=-1e6, most=1e6), 3)]
Sizes = Annotated[tuple[float, float, float], ListOf(Quantity("length", "positive"), 3)]
Margins = Annotated[tuple[float, float, float], ListOf(Quantity("length", "not_negative"), 3)]
Velocity = Annotated[tuple[float, float, float], ListOf(Quantity("speed"), 3)]
AngularVelocity = Annotated[tuple[float, float, float], ListOf(Quantity("angular_speed"), 3)]
Lengths = Annotated[tuple[float, ...], ListOf(Quantity("length"))]
Components = Annotated[int, Number(least=10, most=1000, whole=True)]
Seed = Annotated[int, Number(least=0, most=2**31, whole=True)]
Flag = Annotated[bool, Truth()]
Name = Annotated[str, NameText()]
Names = Annotated[tuple[str, ...], ListOf(NameText(), scalar=True)]
Text = Annotated[str, FreeText()]
