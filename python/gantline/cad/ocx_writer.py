"""Ship structure as OCX 3.1: panels with plates and stiffeners, each with its weight and centre of gravity.

Written as exporters of ship CAD do it: lengths in metres with their unit at each value, contours and trace
lines as curves in space, sections and hole shapes in catalogues, units in the words of UnitsML (3docx.org,
schema 3.1.0).
"""

from __future__ import annotations

import uuid
from collections.abc import Iterable
from xml.etree import ElementTree

import numpy as np
import numpy.typing as npt

from gantline.cad.assumptions import STEEL
from gantline.cad.mass_properties import MassProperties
from gantline.cad.model import Part, PartKind
from gantline.cad.ship_block import ShipBlock
from gantline.cad.structure import Bar, Panel, Plate, Profile

__all__ = ["write_ocx"]

Array = npt.NDArray[np.float64]
_Node = ElementTree.Element

_SCHEMA = "https://3docx.org/fileadmin//ocx_schema//V310//OCX_Schema.xsd"
_UNITS_SCHEMA = "urn:oasis:names:tc:unitsml:schema:xsd:UnitsMLSchema_lite-0.9.18"
#: No clock: the same ship block gives the same bytes, so what was read from it can be found again.
_TIME = "2000-01-01T00:00:00Z"
#: Units by name: symbol, dimension, root units with powers and prefixes.
_UNITS: dict[str, tuple[str, str, tuple[tuple[str, int, str], ...]]] = {
    "Um": ("m", "D_L", (("meter", 1, ""),)),
    "Um2": ("m2", "D_L2", (("meter", 2, ""),)),
    "Umm": ("mm", "D_L", (("meter", 1, "m"),)),
    "URad": ("rad", "D_None", (("radian", 1, ""),)),
    "UKg": ("kg", "D_Kg", (("gram", 1, "k"),)),
    "UKgOverm3": ("kg/m3", "D_Kg.M-3", (("gram", 1, "k"), ("meter", -3, ""))),
}
_DIMENSIONS: dict[str, tuple[tuple[str, str, int], ...]] = {
    "D_L": (("Length", "L", 1),),
    "D_L2": (("Length", "L", 2),),
    "D_Kg": (("Mass", "M", 1),),
    "D_Kg.M-3": (("Mass", "M", 1), ("Length", "L", -3)),
    "D_None": (),
}


def write_ocx(made: ShipBlock) -> bytes:
    """The ship block as the bytes of an OCX file."""
    return _Writer(made).data()


class _Writer:
    """Builds the tree of elements; ids count from 1 in the order of writing."""

    def __init__(self, made: ShipBlock) -> None:
        self._made = made
        self._count = 0
        self._profiles: dict[Profile, str] = {}
        self._holes: dict[tuple[float, float], str] = {}

    def data(self) -> bytes:
        """The whole file."""
        root = ElementTree.Element(
            "ocx:ocxXML",
            {
                "xmlns:ocx": _SCHEMA,
                "xmlns:xsi": "http://www.w3.org/2001/XMLSchema-instance",
                "schemaVersion": "3.1.0",
                "xsi:schemaLocation": f"{_SCHEMA} OCX_Schema.xsd",
            },
        )
        name = self._made.sizes.name
        header = {"name": name, "author": "gantline", "organization": "gantline", "time_stamp": _TIME}
        more = {"originating_system": "gantline", "documentation": "generated", "application_version": "1"}
        _add(root, "Header", {**header, **more})
        vessel = self._named(root, "Vessel", name)
        _value(vessel, "DistanceTolerance", 1, "Umm")
        _value(vessel, "AngleTolerance", 0.001, "URad")
        system = self._named(vessel, "CoordinateSystem", "GLOBAL", isGlobal="true")
        cartesian = _add(system, "LocalCartesian")
        _point(cartesian, "Origin", np.zeros(3))
        _direction(cartesian, "PrimaryAxis", np.array([1.0, 0.0, 0.0]))
        _direction(cartesian, "SecondaryAxis", np.array([0.0, 1.0, 0.0]))
        for panel in self._made.panels:
            self._panel(vessel, panel)
        for pillar in self._made.pillars:
            self._bar(vessel, pillar, pillar.part)
        self._catalogues(root)
        _units(root)
        ElementTree.indent(root, space=" ")
        text: bytes = ElementTree.tostring(root, encoding="utf-8", xml_declaration=True)
        return text + b"\n"

    def _named(self, parent: _Node, element: str, name: str, **attributes: str) -> _Node:
        self._count += 1
        # From the name: the same part keeps its identity from file to file.
        identity = str(uuid.uuid5(uuid.NAMESPACE_OID, f"{self._made.sizes.name}/{element}/{name}"))
        known = {"id": f"id{self._count}", "name": name, "ocx:GUIDRef": identity}
        return _add(parent, element, {**known, **attributes})

    def _panel(self, vessel: _Node, panel: Panel) -> None:
        node = self._named(
            vessel, "Panel", panel.name, **{"ocx:functionType": panel.function, "ocx:tightness": "NonTight"}
        )
        first = panel.plates[0]
        geometry = self._named(_add(node, "UnboundedGeometry"), "Plane3D", panel.name)
        _point(geometry, "Origin", first.corner)
        normal = np.cross(*first.sides)
        _direction(geometry, "Normal", normal / np.linalg.norm(normal))
        parts = panel.parts
        composed = _add(node, "ComposedOf")
        for plate, part in zip(panel.plates, parts, strict=False):
            self._plate(composed, plate, part)
        if panel.bars:
            stiffened = _add(node, "StiffenedBy")
            for bar, part in zip(panel.bars, parts[len(panel.plates) :], strict=True):
                self._bar(stiffened, bar, part)
        if any(plate.holes for plate in panel.plates):
            self._openings(node, panel.plates)
        _weight(node, MassProperties.combined(part.properties for part in parts if part.properties))

    def _plate(self, parent: _Node, plate: Plate, part: Part) -> None:
        node = self._named(parent, "Plate", plate.name)
        _weight(node, part.properties)
        _value(node, "NetArea", plate.area, "Um2")
        curve = self._named(_add(node, "OuterContour"), "CompositeCurve3D", plate.name)
        corners = plate.outline
        for start, end in zip(corners, np.roll(corners, -1, axis=0), strict=True):
            _line(curve, start, end)
        material = _add(node, "PlateMaterial", {"localRef": "material", "ocx:refType": "ocx:Material"})
        _value(material, "Thickness", plate.thickness, "Um")

    def _openings(self, panel: _Node, plates: Iterable[Plate]) -> None:
        cut = _add(panel, "CutBy")
        for plate in plates:
            axes = plate.sides / np.linalg.norm(plate.sides, axis=1, keepdims=True)
            for place, hole in enumerate(plate.holes, 1):
                shape = self._holes.setdefault((hole.width, hole.height), f"hole{len(self._holes) + 1}")
                node = self._named(cut, "Hole2DContour", f"{plate.name} H{place}")
                _add(node, "HoleRef", {"localRef": shape, "ocx:refType": "ocx:Hole2D"})
                where = _add(node, "Transformation")
                _point(where, "Origin", hole.centre)
                _direction(where, "PrimaryAxis", axes[0])
                _direction(where, "SecondaryAxis", axes[1])

    def _bar(self, parent: _Node, bar: Bar, part: Part) -> None:
        kind = "Pillar" if bar.kind is PartKind.PILLAR else "Stiffener"
        node = self._named(parent, kind, bar.name)
        _weight(node, part.properties)
        _line(self._named(_add(node, "TraceLine"), "CompositeCurve3D", bar.name), *bar.ends)
        _add(node, "MaterialRef", {"localRef": "material", "ocx:refType": "ocx:Material"})
        section = self._profiles.setdefault(bar.profile, f"section{len(self._profiles) + 1}")
        reference = _add(node, "SectionRef", {"localRef": section, "ocx:refType": "ocx:BarSection"})
        _value(reference, "OffsetU", bar.offset[0], "Um")
        _value(reference, "OffsetV", bar.offset[1], "Um")
        inclination = _add(node, "Inclination")
        _direction(inclination, "WebDirection", bar.web)
        _direction(inclination, "FlangeDirection", bar.flange)
        _point(inclination, "Position", bar.ends.mean(axis=0))

    def _catalogues(self, root: _Node) -> None:
        catalogue = _add(root, "ClassCatalogue", {"id": "classes"})
        materials = _add(catalogue, "MaterialCatalogue", {"id": "materials"})
        steel = _add(materials, "Material", {"id": "material", "name": "A", "ocx:grade": "A"})
        _value(steel, "Density", STEEL, "UKgOverm3")
        sections = _add(catalogue, "XSectionCatalogue", {"id": "sections"})
        for profile, name in self._profiles.items():
            shape = _add(_add(sections, "BarSection", {"id": name, "name": profile.name}), profile.kind)
            sizes = {"Height": profile.height, "Width": profile.width}
            if profile.kind == "LBar":
                sizes |= {"WebThickness": profile.web, "FlangeThickness": profile.flange}
            elif profile.kind == "Tube":
                sizes = {"Diameter": profile.height, "Thickness": profile.web}
            for key, size in sizes.items():
                _value(shape, key, size, "Um")
        if self._holes:
            holes = _add(catalogue, "HoleShapeCatalogue", {"id": "holes"})
            for (width, height), name in self._holes.items():
                label = f"O{1e3 * width:.0f}X{1e3 * height:.0f}"
                shape = _add(_add(holes, "Hole2D", {"id": name, "name": label}), "RectangularHole")
                _value(shape, "Height", height, "Um")
                _value(shape, "Width", width, "Um")
                _value(shape, "FilletRadius", height / 2, "Um")


def _add(parent: _Node, name: str, attributes: dict[str, str] | None = None) -> _Node:
    return ElementTree.SubElement(parent, f"ocx:{name}", attributes or {})


def _number(value: float) -> str:
    """The shortest text that is read back as the same number."""
    return repr(float(value) + 0.0)


def _value(parent: _Node, name: str, value: float, unit: str) -> None:
    _add(parent, name, {"numericvalue": _number(value), "unit": unit})


def _point(parent: _Node, name: str, at: Array) -> None:
    _add(parent, name, {"coordinates": " ".join(map(_number, at)), "unit": "Um"})


def _direction(parent: _Node, name: str, way: Array) -> None:
    _add(parent, name, {"direction": " ".join(map(_number, way))})


def _line(parent: _Node, start: Array, end: Array) -> None:
    line = _add(parent, "Line3D")
    _point(line, "StartPoint", start)
    _point(line, "EndPoint", end)


def _weight(parent: _Node, weighed: MassProperties | None) -> None:
    assert weighed is not None  # parts of a ship block have weights
    properties = _add(parent, "PhysicalProperties")
    _value(properties, "DryWeight", weighed.mass, "UKg")
    _point(properties, "CenterOfGravity", weighed.centre)


def _units(root: _Node) -> None:
    def add(parent: _Node, name: str, **attributes: str) -> _Node:
        return ElementTree.SubElement(parent, f"unitsml:{name}", attributes)

    units = ElementTree.SubElement(root, "unitsml:UnitsML", {"xmlns:unitsml": _UNITS_SCHEMA})
    table = add(units, "UnitSet")
    for name, (symbol, dimension, roots) in _UNITS.items():
        unit = add(table, "Unit", **{"xml:id": name, "dimensionURL": dimension})
        add(unit, "UnitName", **{"xml:lang": "en"}).text = symbol
        add(unit, "UnitSymbol", type=symbol)
        holder = add(unit, "RootUnits")
        for base, power, prefix in roots:
            more = {"prefix": prefix} if prefix else {}
            add(holder, "EnumeratedRootUnit", unit=base, powerNumerator=str(power), **more)
    table = add(units, "DimensionSet")
    for name, factors in _DIMENSIONS.items():
        node = add(table, "Dimension", **{"xml:id": name})
        if not factors:
            node.set("dimensionless", "true")
        for kind, symbol, power in factors:
            add(node, kind, symbol=symbol, powerNumerator=str(power))
