"""Small OCX files, written by hand, in either encoding of coordinates and any unit."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

OLD = "http://data.dnvgl.com/Schemas/ocxXMLSchema"
NEW = "https://3docx.org/fileadmin//ocx_schema//V310//OCX_Schema.xsd"
_UNITS = "urn:oasis:names:tc:unitsml:schema:xsd:UnitsMLSchema_lite-0.9.18"
_SIZES = {"m": 1.0, "mm": 1e-3}

Point = Sequence[float]


@dataclass(frozen=True)
class Writer:
    """How a file is written.

    Attributes:
        unit: of lengths, ``m`` or ``mm``.
        nested: coordinates as a child each, as schema 2.8 does, or as one list.
        namespace: of the schema.
        version: of the schema, as it says itself.
    """

    unit: str = "m"
    nested: bool = False
    namespace: str = NEW
    version: str = "3.1.0"

    def length(self, name: str, value: float) -> str:
        """A quantity [m]."""
        return f'<ocx:{name} numericvalue="{value / _SIZES[self.unit]!r}" unit="L"/>'

    def point(self, name: str, at: Point, more: str = "") -> str:
        """A point [m]."""
        values = [value / _SIZES[self.unit] for value in at]
        if not self.nested:
            return f'<ocx:{name} coordinates="{" ".join(map(repr, values))}" unit="L"{more}/>'
        axes = "".join(
            f'<ocx:{axis} numericvalue="{value!r}" unit="L"/>'
            for axis, value in zip("XYZ", values, strict=True)
        )
        return f"<ocx:{name}{more}>{axes}</ocx:{name}>"

    def direction(self, name: str, way: Point) -> str:
        """A direction."""
        x, y, z = way
        if self.nested:
            return f'<ocx:{name} x="{x!r}" y="{y!r}" z="{z!r}"/>'
        return f'<ocx:{name} direction="{x!r} {y!r} {z!r}"/>'

    def line(self, start: Point, end: Point) -> str:
        """A straight line."""
        ends = self.point("StartPoint", start) + self.point("EndPoint", end)
        return f"<ocx:Line3D>{ends}</ocx:Line3D>"

    def arc(self, start: Point, middle: Point, end: Point) -> str:
        """An arc through three points."""
        names = ("StartPoint", "IntermediatePoint", "EndPoint")
        points = (self.point(name, at) for name, at in zip(names, (start, middle, end), strict=True))
        return f"<ocx:CircumArc3D>{''.join(points)}</ocx:CircumArc3D>"

    def circle(self, centre: Point, normal: Point, diameter: float) -> str:
        """A whole circle."""
        inner = self.length("Diameter", diameter) + self.point("Center", centre)
        return f"<ocx:Circle3D>{inner}{self.direction('Normal', normal)}</ocx:Circle3D>"

    def nurbs(
        self, degree: int, knots: Sequence[float], points: Sequence[Point], weights: Sequence[float]
    ) -> str:
        """A NURBS curve."""
        if self.nested:
            controls = "".join(
                f'<ocx:ControlPoint weight="{weight!r}">{self.point("Point3D", at)}</ocx:ControlPoint>'
                for at, weight in zip(points, weights, strict=True)
            )
        else:
            controls = "".join(
                self.point("ControlPoint", at, f' weight="{weight!r}"')
                for at, weight in zip(points, weights, strict=True)
            )
        return (
            f'<ocx:NURBS3D><ocx:NURBSproperties degree="{degree}" numCtrlPts="{len(points)}"/>'
            f'<ocx:KnotVector value="{" ".join(map(repr, knots))}"/>'
            f"<ocx:ControlPtList>{controls}</ocx:ControlPtList></ocx:NURBS3D>"
        )

    def polygon(self, corners: Sequence[Point]) -> str:
        """A closed contour of straight lines."""
        return "".join(
            self.line(corner, following)
            for corner, following in zip(corners, [*corners[1:], corners[0]], strict=True)
        )

    def declared(self, mass: float | None, centre: Point | None = None) -> str:
        """Declared weight [kg]."""
        if mass is None:
            return ""
        place = "" if centre is None else self.point("CenterOfGravity", centre)
        return (
            f'<ocx:PhysicalProperties><ocx:DryWeight numericvalue="{mass!r}" unit="M"/>{place}'
            "</ocx:PhysicalProperties>"
        )

    def plate(
        self,
        name: str,
        contour: str,
        thickness: float = 0.01,
        *,
        declared: float | None = None,
        centre: Point | None = None,
        more: str = "",
        tag: str = "Plate",
    ) -> str:
        """A plate or bracket; `more` are further children."""
        return (
            f'<ocx:{tag} id="{name}" name="{name}">{self.declared(declared, centre)}'
            f"<ocx:OuterContour>{contour}</ocx:OuterContour>"
            f'<ocx:PlateMaterial localRef="steel">{self.length("Thickness", thickness)}</ocx:PlateMaterial>'
            f"{more}</ocx:{tag}>"
        )

    def bar(
        self,
        name: str,
        trace: str,
        section: str = "flat",
        *,
        web: Point = (0.0, 0.0, 1.0),
        flange: Point | None = (0.0, 1.0, 0.0),
        at: Point = (0.0, 0.0, 0.0),
        offset: tuple[float, float] | None = None,
        declared: float | None = None,
        more: str = "",
        tag: str = "Stiffener",
    ) -> str:
        """A stiffener, pillar or edge reinforcement."""
        offsets = (
            "" if offset is None else self.length("OffsetU", offset[0]) + self.length("OffsetV", offset[1])
        )
        flanges = "" if flange is None else self.direction("FlangeDirection", flange)
        stands = self.direction("WebDirection", web) + flanges + self.point("Position", at)
        return (
            f'<ocx:{tag} id="{name}" name="{name}">{self.declared(declared)}'
            f"<ocx:TraceLine>{trace}</ocx:TraceLine>"
            '<ocx:MaterialRef localRef="steel"/>'
            f'<ocx:SectionRef localRef="{section}">{offsets}</ocx:SectionRef>'
            f"<ocx:Inclination>{stands}</ocx:Inclination>{more}</ocx:{tag}>"
        )

    def section(self, name: str, shape: str, **dimensions: float) -> str:
        """A section of the catalogue."""
        inner = "".join(self.length(key, value) for key, value in dimensions.items())
        return (
            f'<ocx:BarSection id="{name}" name="{name}"><ocx:{shape}>{inner}</ocx:{shape}></ocx:BarSection>'
        )

    def hole(self, name: str, shape: str, dimensions: Mapping[str, float], more: str = "") -> str:
        """A parametric hole of the catalogue."""
        inner = "".join(self.length(key, value) for key, value in dimensions.items())
        return f'<ocx:Hole2D id="{name}" name="{name}"><ocx:{shape}{more}>{inner}</ocx:{shape}></ocx:Hole2D>'

    def placed_hole(
        self, name: str, origin: Point, first: Point = (1.0, 0.0, 0.0), second: Point = (0.0, 1.0, 0.0)
    ) -> str:
        """A hole of the catalogue in its place."""
        place = self.point("Origin", origin)
        axes = self.direction("PrimaryAxis", first) + self.direction("SecondaryAxis", second)
        return (
            f'<ocx:Hole2DContour><ocx:HoleRef localRef="{name}"/>'
            f"<ocx:Transformation>{place}{axes}</ocx:Transformation></ocx:Hole2DContour>"
        )

    def panel(self, name: str, composed: str, stiffened: str = "", more: str = "") -> str:
        """A panel."""
        return (
            f'<ocx:Panel id="{name}" name="{name}">{more}<ocx:ComposedOf>{composed}</ocx:ComposedOf>'
            f"<ocx:StiffenedBy>{stiffened}</ocx:StiffenedBy></ocx:Panel>"
        )

    def file(self, vessel: str, *, sections: str = "", holes: str = "", density: float = 7850.0) -> bytes:
        """A whole file around what the vessel holds."""
        symbol, prefix = self.unit, "" if self.unit == "m" else 'prefix="m" '
        units = (
            f'<Unit id="L"><UnitName lang="en">length</UnitName><UnitSymbol type="{symbol}"/>'
            f'<RootUnits><EnumeratedRootUnit unit="meter" {prefix}powerNumerator="1"/></RootUnits></Unit>'
            '<Unit id="M"><UnitSymbol type="kg"/></Unit><Unit id="D"><UnitSymbol type="kg/m3"/></Unit>'
            '<Unit id="A"><UnitSymbol type="m2"/></Unit><Unit id="G"><UnitSymbol type="deg"/></Unit>'
        )
        flat = self.section("flat", "FlatBar", Height=0.2, Width=0.01)
        return (
            f'<?xml version="1.0" encoding="UTF-8"?><ocx:ocxXML xmlns:ocx="{self.namespace}" '
            f'schemaVersion="{self.version}"><ocx:Header originating_system="by hand"/>'
            f'<ocx:Vessel id="vessel" name="small">{vessel}</ocx:Vessel><ocx:ClassCatalogue>'
            f'<ocx:MaterialCatalogue><ocx:Material id="steel" name="A" grade="A">'
            f'<ocx:Density numericvalue="{density!r}" unit="D"/></ocx:Material></ocx:MaterialCatalogue>'
            f"<ocx:XSectionCatalogue>{flat}{sections}</ocx:XSectionCatalogue>"
            f"<ocx:HoleShapeCatalogue>{holes}</ocx:HoleShapeCatalogue></ocx:ClassCatalogue>"
            f'<UnitsML xmlns="{_UNITS}"><UnitSet>{units}</UnitSet></UnitsML></ocx:ocxXML>'
        ).encode()


SQUARE = [(0.0, 0.0, 0.0), (2.0, 0.0, 0.0), (2.0, 2.0, 0.0), (0.0, 2.0, 0.0)]


def sample(writer: Writer) -> bytes:
    """All kinds of parts: a panel of plate with hole, stiffener, bracket and edge reinforcement; a pillar."""
    plate = writer.plate("P1", writer.polygon(SQUARE), declared=282.4, centre=(1.0, 1.0, 0.0))
    bracket = writer.plate(
        "B1", writer.polygon([(1.0, 0.0, 0.0), (1.0, 0.5, 0.0), (1.0, 0.0, 0.5)]), tag="Bracket", declared=9.8
    )
    stiffener = writer.bar("S1", writer.line((0.0, 1.0, 0.0), (2.0, 1.0, 0.0)), declared=31.4)
    rim = writer.bar(
        "E1",
        writer.circle((1.0, 1.0, 0.0), (0.0, 0.0, 1.0), 0.72),
        at=(1.36, 1.0, 0.0),
        flange=(1.0, 0.0, 0.0),
        offset=(0.0, -0.1),
        tag="EdgeReinforcement",
    )
    upright = writer.line((0.5, 0.5, 0.0), (0.5, 0.5, 3.0))
    pillar = writer.bar("C1", upright, "tube", web=(0.0, 1.0, 0.0), flange=None, tag="Pillar")
    cut = f"<ocx:CutBy>{writer.placed_hole('round', (1.0, 1.0, 0.0))}</ocx:CutBy>"
    return writer.file(
        writer.panel("deck", plate + bracket, stiffener + rim, cut) + pillar,
        sections=writer.section("tube", "Tube", Diameter=0.1, Thickness=0.005),
        holes=writer.hole("round", "ParametricCircle", {"Diameter": 0.72}),
    )
