"""OCX (Open Class 3D Exchange), the exchange format of ship structures: a file in, a model out.

Read are schema 2.8 to 3.1 as NAPA, AVEVA, CADMATIC, 3DEXPERIENCE and PROSTEP write them (3docx.org). What
is read and what is not, and how masses follow from it, says `docs/concepts/cad.md`.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from gantline.cad.errors import CadError
from gantline.cad.model import CadModel, Part
from gantline.cad.ocx.catalogue import Catalogue
from gantline.cad.ocx.parts import KINDS, PartReader
from gantline.cad.ocx.quantities import Quantities
from gantline.cad.ocx.xml import Element, parse

__all__ = ["read_ocx"]

#: Triangles may miss the parts by this much [m].
_TOLERANCE = 1e-3
_KNOWN = ((2, 8), (3, 1))
_HOLDERS = ("ComposedOf", "StiffenedBy")


def read_ocx(data: bytes, file: str) -> CadModel:
    """Read an OCX file.

    Args:
        data: the whole file.
        file: its name, for messages and as the model's name if it has none.

    Raises:
        CadError: if it is no OCX, is broken, or has no parts.
    """
    root = parse(data, file)
    vessel = root.child("Vessel", "Form")
    if vessel is None:
        raise CadError(f"{file}: has no Vessel, so there are no parts")
    quantities = Quantities(root, file)
    reader = PartReader(Catalogue(root, quantities), quantities, _TOLERANCE)
    parts = tuple(reader.part(element, panel) for element, panel in _elements(vessel))
    if not parts:
        raise CadError(f"{file}: has no plates, stiffeners, brackets or pillars")
    version = root.attributes.get("schemaVersion", "")
    return CadModel(
        name=vessel.attributes.get("name") or file,
        form=", ".join(filter(None, [f"OCX {version}".strip(), _origin(root)])),
        parts=parts,
        unit=_unit(quantities),
        doubts=tuple(_doubts(version, parts)),
    )


def _elements(vessel: Element) -> Iterator[tuple[Element, Element | None]]:
    """Parts in the order of the file, each with its panel; panels may hold panels, brackets stiffeners."""
    stack: list[tuple[Element, Element | None]] = [(child, None) for child in reversed(vessel.children)]
    while stack:
        element, panel = stack.pop()
        if element.name in KINDS:
            yield element, panel
        inner = element if element.name == "Panel" else panel
        if element.name in KINDS or element.name == "Panel":
            holders = element.all(*_HOLDERS)
            children = [child for holder in holders for child in holder.children]
            stack += [(child, inner) for child in reversed(children)]


def _origin(root: Element) -> str:
    header = root.child("Header")
    return "" if header is None else header.attributes.get("originating_system", "").strip()


def _unit(quantities: Quantities) -> str:
    sizes = Counter(quantities.used.values())
    names = {1.0: "m", 1e-3: "mm", 1e-2: "cm", 0.0254: "inch", 0.3048: "foot"}
    found = [names.get(size, f"{size:g} m") for size in sorted(sizes, reverse=True)]
    return f"{' and '.join(found)}, as the file says"


def _doubts(version: str, parts: tuple[Part, ...]) -> Iterator[str]:
    try:
        major, minor = (int(number) for number in version.split(".")[:2])
        is_known = _KNOWN[0] <= (major, minor) <= _KNOWN[1]
    except ValueError:
        is_known = False
    if not is_known:
        yield f"schema version '{version[:20]}' is not one of 2.8 to 3.1: it is read as if it were"
    names = Counter((part.name, part.group, part.kind) for part in parts)
    twice = [name for (name, _, _), count in names.items() if count > 1 and name]
    if twice:
        yield f"{len(twice)} names are borne by several parts of one kind and panel, such as '{twice[0]}'"
