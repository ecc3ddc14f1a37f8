"""OCX as a tree of elements, read so that no file can cost more than a bound of time and memory.

Expat reads the file as a stream. A document type is refused, so there are no entities that could expand;
depth, size, number of elements and number of parts are limited while reading. Elements of other namespaces
are passed over, and so is what has no bearing on weight and shape. Names lose their prefixes: the namespace
is checked once.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from xml.parsers import expat

from gantline.cad.errors import CadError

__all__ = ["Element", "parse"]

#: Bounds. An OCX file of a whole ship has some ten thousand parts and some hundred megabytes.
MOST_BYTES = 512_000_000
MOST_ELEMENTS = 3_000_000
MOST_PARTS = 100_000
MOST_DEPTH = 64

_CHUNK = 1 << 18
#: How files begin that are packed.
_PACKED = {b"PK\x03\x04": "zip", b"\x1f\x8b": "gzip"}
_LONGEST_TEXT = 256
_LONGEST_SHOWN = 80
_SPACE = " "  # between namespace and name; no namespace name has a blank

#: Namespaces of the schema: 2.8, and all from 3.0 on, which name their version in it.
_NAMESPACE = re.compile(
    r"https?://(data\.dnvgl\.com/Schemas/ocxXMLSchema"
    r"|3docx\.org/fileadmin/+ocx_schema/+V?[\w.]+/+OCX_Schema\.xsd)"
)
_UNITS = re.compile(r"urn:oasis:names:tc:unitsml:.*")

#: What says nothing about weight or shape.
_PASSED_OVER = frozenset(
    {
        "Arrangement",
        "BuilderInformation",
        "ClassificationData",
        "ConnectionConfiguration",
        "CustomProperties",
        "DesignView",
        "DimensionSet",
        "FrameTables",
        "GridRef",
        "Penetration",
        "ShipDesignation",
        "SplitBy",
        "StatutoryData",
        "TonnageData",
        "XRefPlanes",
        "YRefPlanes",
        "ZRefPlanes",
    }
)
PART_NAMES = frozenset({"Plate", "Stiffener", "Bracket", "Pillar", "EdgeReinforcement"})


class Element:
    """An element: local name, attributes by local name, children, text, and the line where it stands."""

    __slots__ = ("attributes", "children", "line", "name", "text")

    def __init__(self, name: str, attributes: dict[str, str], line: int) -> None:
        self.name = name
        self.attributes = attributes
        self.children: list[Element] = []
        self.text = ""
        self.line = line

    def child(self, *names: str) -> Element | None:
        """The first child with one of these names, or None."""
        for child in self.children:
            if child.name in names:
                return child
        return None

    def all(self, *names: str) -> list[Element]:
        """Children with one of these names, in order."""
        return [child for child in self.children if child.name in names]

    def walk(self) -> Iterator[Element]:
        """The element itself and all below it, in the order of the file."""
        stack = [self]
        while stack:
            element = stack.pop()
            yield element
            stack.extend(reversed(element.children))


def parse(data: bytes, file: str) -> Element:
    """Read an OCX file.

    Args:
        data: The whole file.
        file: Its name, for messages.

    Returns:
        The root element, `ocxXML`.

    Raises:
        CadError: If it is no OCX, is broken, or is beyond the bounds.
    """
    if len(data) > MOST_BYTES:
        raise CadError(f"{file}: has {len(data)} bytes; at most {MOST_BYTES} are read")
    if packer := next((name for begin, name in _PACKED.items() if data.startswith(begin)), None):
        raise CadError(f"{file}: is packed by {packer}; unpack it (what ends on '.gz' is unpacked here)")
    reader = _Reader(file)
    try:
        for start in range(0, len(data), _CHUNK):
            reader.expat.Parse(data[start : start + _CHUNK], False)
        reader.expat.Parse(b"", True)
    except expat.ExpatError as problem:
        reason = (expat.ErrorString(problem.code) or "").removeprefix("not well-formed (").removesuffix(")")
        if problem.code in _ENDS_EARLY:
            raise CadError(
                f"{file}: the file ends in the middle, at line {problem.lineno}; is it complete?"
            ) from None
        raise CadError(f"{file}: line {problem.lineno}: is not well-formed XML ({reason})") from None
    except (LookupError, ValueError) as problem:
        # An encoding that Python does not know, or of more than one byte a letter that expat does not.
        if isinstance(problem, CadError):
            raise
        raise CadError(f"{file}: its text encoding cannot be read ({problem}); save it as UTF-8") from None
    assert reader.root is not None
    return reader.root


_ENDS_EARLY = frozenset(
    {
        expat.errors.codes[expat.errors.XML_ERROR_NO_ELEMENTS],
        expat.errors.codes[expat.errors.XML_ERROR_UNCLOSED_TOKEN],
        expat.errors.codes[expat.errors.XML_ERROR_PARTIAL_CHAR],
        expat.errors.codes[expat.errors.XML_ERROR_UNCLOSED_CDATA_SECTION],
    }
)


class _Reader:
    """What expat calls."""

    def __init__(self, file: str) -> None:
        self.file = file
        self.root: Element | None = None
        self.expat = expat.ParserCreate(namespace_separator=_SPACE)
        self.expat.buffer_text = True
        self.expat.ordered_attributes = True
        self.expat.StartElementHandler = self._start
        self.expat.EndElementHandler = self._end
        self.expat.CharacterDataHandler = self._text
        self.expat.StartDoctypeDeclHandler = self._doctype
        self._open: list[Element] = []
        self._passing = 0  # depth within a subtree that is passed over
        self._elements = 0
        self._parts = 0

    def _start(self, full_name: str, attributes: list[str]) -> None:
        namespace, _, name = full_name.rpartition(_SPACE)
        if len(self._open) + self._passing >= MOST_DEPTH:
            self._stop(f"elements are nested more than {MOST_DEPTH} deep")
        if self._passing:
            self._passing += 1
            return
        if self.root is None:
            self._check_root(namespace, name)
        elif name in _PASSED_OVER or not (_NAMESPACE.fullmatch(namespace) or _UNITS.fullmatch(namespace)):
            self._passing = 1
            return
        self._count(name)
        pairs = zip(attributes[::2], attributes[1::2], strict=True)
        element = Element(
            sys.intern(name),
            {sys.intern(key.rpartition(_SPACE)[2]): value for key, value in pairs},
            self.expat.CurrentLineNumber,
        )
        if self._open:
            self._open[-1].children.append(element)
        else:
            self.root = element
        self._open.append(element)

    def _end(self, _: str) -> None:
        if self._passing:
            self._passing -= 1
        else:
            self._open.pop()

    def _text(self, text: str) -> None:
        if self._open and not self._passing:
            element = self._open[-1]
            if len(element.text) < _LONGEST_TEXT:
                element.text = (element.text + text).strip()[:_LONGEST_TEXT]

    def _count(self, name: str) -> None:
        self._elements += 1
        if self._elements > MOST_ELEMENTS:
            self._stop(f"has more than {MOST_ELEMENTS} elements; export fewer parts at a time")
        if name in PART_NAMES:
            self._parts += 1
            if self._parts > MOST_PARTS:
                self._stop(f"has more than {MOST_PARTS} parts; export fewer parts at a time")

    def _doctype(self, *_: object) -> None:
        self._stop("has a document type declaration, which OCX has no use for; it is not read")

    def _check_root(self, namespace: str, name: str) -> None:
        if name != "ocxXML":
            self._stop(f"is no OCX: its first element is '{name[:_LONGEST_SHOWN]}', not 'ocxXML'")
        if not _NAMESPACE.fullmatch(namespace):
            shown = f"'{namespace[:_LONGEST_SHOWN]}'" if namespace else "none"
            self._stop(f"is no OCX that is known: its namespace is {shown}, not that of schema 2.8 to 3.1")

    def _stop(self, what: str) -> None:
        raise CadError(f"{self.file}: line {self.expat.CurrentLineNumber}: {what}")
