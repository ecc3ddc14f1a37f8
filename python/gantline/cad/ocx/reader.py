"""OCX (Open Class 3D Exchange), the exchange format of ship structures: a file in, a model out.

Read are schema 2.8 to 3.1 as NAPA, AVEVA, CADMATIC, 3DEXPERIENCE and PROSTEP write them (3docx.org). What
is read and what is not, and how masses follow from it, says `docs/concepts/cad.md`.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence

from gantline.cad.errors import CadError
from gantline.cad.model import CadModel, Part
from gantline.cad.ocx.catalogue import Catalogue
from gantline.cad.ocx.parts import KINDS, PartReader
from gantline.cad.ocx.quantities import Quantities, described
from gantline.cad.ocx.xml import Element, parse

__all__ = ["read_ocx"]

#: Triangles may miss the parts by this much [m].
_TOLERANCE = 1e-3
_KNOWN = ((2, 8), (3, 1))
_HOLDERS = ("ComposedOf", "StiffenedBy")
#: What declares the weight of parts that are read by themselves.
_WHOLES = ("Panel", "Vessel", "Form")
#: By which share a panel's declared weight may differ from that of its parts.
_LACKING = 0.01


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
    elements = [*_elements(vessel.children)]
    parts = tuple(reader.part(element, panel) for element, panel in elements)
    if not parts:
        raise CadError(f"{file}: has no plates, stiffeners, brackets or pillars")
    version = root.attributes.get("schemaVersion", "")
    return CadModel(
        name=vessel.attributes.get("name") or file,
        form=", ".join(filter(None, [f"OCX {version}".strip(), _origin(root)])),
        parts=parts,
        unit=_unit(quantities),
        doubts=(
            *_doubts(version, parts),
            *_not_counted(root, [element for element, _ in elements]),
            *_lacking(
                vessel,
                reader,
                {id(element): part for (element, _), part in zip(elements, parts, strict=True)},
            ),
        ),
    )


def _elements(children: Sequence[Element]) -> Iterator[tuple[Element, Element | None]]:
    """Parts in the order of the file, each with its panel; panels may hold panels, brackets stiffeners."""
    stack: list[tuple[Element, Element | None]] = [(child, None) for child in reversed(children)]
    while stack:
        element, panel = stack.pop()
        if element.name in KINDS:
            yield element, panel
        inner = element if element.name == "Panel" else panel
        if element.name in KINDS or element.name == "Panel":
            holders = element.all(*_HOLDERS)
            held = [child for holder in holders for child in holder.children]
            stack += [(child, inner) for child in reversed(held)]


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


def _not_counted(root: Element, counted: Sequence[Element]) -> Iterator[str]:
    """What is called a part, stands among parts or declares a weight, and is none that is read."""
    known = {id(element) for element in counted}
    missed = []
    for element in root.walk():
        inner = [child for holder in element.all(*_HOLDERS) for child in holder.children]
        missed += [child for child in inner if child.name not in (*KINDS, "Panel")]
        table = element.child("PhysicalProperties")
        weighs = table is not None and table.child("DryWeight") is not None
        is_made = element.child("PlateMaterial", "SectionRef") is not None
        is_part = element.name in KINDS or ((weighs or is_made) and element.name not in _WHOLES)
        if is_part and id(element) not in known:
            missed.append(element)
    missed = [*{id(element): element for element in missed}.values()]
    if missed:
        more = f" and {len(missed) - 1} more" if len(missed) > 1 else ""
        shown = f"{described(missed[0])} in line {missed[0].line}{more}"
        yield f"may be parts, but are not where parts stand, so they weigh nothing here: {shown}"


def _lacking(vessel: Element, reader: PartReader, parts: Mapping[int, Part]) -> Iterator[str]:
    """Panels that declare another weight than their parts have: some may be missing in the file."""
    found = []
    for panel in (element for element in vessel.walk() if element.name == "Panel"):
        declared = reader.declared(panel)
        if declared is None:
            continue
        below = [parts[id(element)] for element, _ in _elements([panel])]
        own = [part for part in below if part.group == _name(panel)]
        sums = [math.fsum(_weight(part) for part in some) for some in (own, below)]
        if min(abs(total - declared.mass) for total in sums) > _LACKING * declared.mass:
            found.append(f"panel '{_name(panel)}' {declared.mass:.4g} kg, its parts {sums[1]:.4g} kg")
    if found:
        more = f" and {len(found) - 1} more" if len(found) > 1 else ""
        missing = "panels declare another weight than their parts, of which some may be missing"
        yield f"{missing}: {found[0]}{more}"


def _name(panel: Element) -> str:
    return panel.attributes.get("name") or panel.attributes.get("id", "")


def _weight(part: Part) -> float:
    """Declared mass of a part, or what it weighs here [kg]."""
    if part.declared is not None:
        return part.declared.mass
    return 0.0 if part.counted is None else part.counted.mass
