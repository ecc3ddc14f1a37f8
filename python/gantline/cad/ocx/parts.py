"""Parts of an OCX file: plates, brackets, stiffeners, pillars and edge reinforcements."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np
import numpy.typing as npt

from gantline.cad.assumptions import DENSITIES
from gantline.cad.errors import CadError
from gantline.cad.mass_properties import MassProperties
from gantline.cad.mesh import TriangleMesh
from gantline.cad.model import DeclaredWeight, Part, PartKind
from gantline.cad.ocx.catalogue import Catalogue, Material
from gantline.cad.ocx.curves import Curve, polyline
from gantline.cad.ocx.geometry import JOIN, read_contour, read_trace
from gantline.cad.ocx.moments import Frame
from gantline.cad.ocx.plate import Sheet, contour_frame, curved_sheet, flat_sheet, is_flat, spans
from gantline.cad.ocx.quantities import Quantities
from gantline.cad.ocx.surface import Surface, read_surface
from gantline.cad.ocx.sweep import BarError, EndCut, Inclination, swept
from gantline.cad.ocx.xml import Element

__all__ = ["KINDS", "PartReader"]

Array = npt.NDArray[np.float64]

KINDS = {
    "Plate": PartKind.PLATE,
    "Bracket": PartKind.BRACKET,
    "Stiffener": PartKind.STIFFENER,
    "Pillar": PartKind.PILLAR,
    "EdgeReinforcement": PartKind.EDGE_REINFORCEMENT,
}
#: Mass properties, triangles, material, size and doubts of a part.
_Read = tuple[MassProperties | None, TriangleMesh, str, str, tuple[str, ...]]
_Reader = Callable[[Element, Element | None], _Read]
_STEEL = 7850.0  # kg/m³, where the file names no material
_NO_MESH = TriangleMesh(np.zeros((0, 3)), np.zeros((0, 3), dtype=np.int32))
_THICKEST = 0.15  # m; rolled ship plates end at about 100 mm
_THINNEST = 0.5e-3  # m; sheet of ventilation trunks has 1 mm
_GAP = 1e-2  # of a contour [m], from which it is doubtful
_NET = 0.005  # by which a plate's area may differ from the declared one without a doubt


class PartReader:
    """Turns elements into parts."""

    def __init__(self, catalogue: Catalogue, quantities: Quantities, tolerance: float) -> None:
        self._catalogue = catalogue
        self._quantities = quantities
        self._tolerance = tolerance

    def part(self, element: Element, panel: Element | None) -> Part:
        """A part, in a panel or alone.

        A part whose geometry cannot be read still is one, with its declared weight, the reason as a doubt.

        Raises:
            CadError: if the part is broken and declares no weight either: it would be missing in the sum.
        """
        declared = self.declared(element)
        read = self._plate if KINDS[element.name] in (PartKind.PLATE, PartKind.BRACKET) else self._bar
        try:
            properties, mesh, material, size, doubts = self._read(read, element, panel)
        except CadError as problem:
            if declared is None:
                raise
            reason = str(problem).removeprefix(f"{self._quantities.file}: ")
            has_place = declared.mass > 0 and declared.centre is not None
            counts = (
                "its declared weight counts" if has_place else "nor does it declare a weight and its place"
            )
            doubts = (f"its geometry is not read, {counts} ({reason})",)
            properties, mesh, material, size = None, _NO_MESH, "", ""
        return Part(
            name=element.attributes.get("name") or element.attributes.get("id", ""),
            kind=KINDS[element.name],
            properties=properties,
            declared=declared,
            mesh=mesh,
            material=material,
            size=size,
            group="" if panel is None else panel.attributes.get("name") or panel.attributes.get("id", ""),
            doubts=doubts,
        )

    def _read(self, read: _Reader, element: Element, panel: Element | None) -> _Read:
        try:
            return read(element, panel)
        except CadError:
            raise
        except ValueError as problem:
            # Such as a contour that crosses itself, whose parts have areas of either sign.
            raise self._quantities.fail(element, f"makes no body: {problem}") from None

    def declared(self, element: Element) -> DeclaredWeight | None:
        """What a part or panel says that it weighs; None if nothing.

        Raises:
            CadError: if that is no weight.
        """
        table = element.child("PhysicalProperties")
        if table is None:
            return None
        mass = self._quantities.of_child(table, "DryWeight", "mass")
        if mass is None:
            return None
        if mass < 0:
            raise self._quantities.fail(element, f"declares a weight of {mass:g} kg")
        centre = table.child("CenterOfGravity")
        return DeclaredWeight(mass, None if centre is None else self._quantities.point(centre))

    def _plate(self, element: Element, panel: Element | None) -> _Read:
        holder = element.child("PlateMaterial")
        if holder is None:
            raise self._quantities.fail(element, "has no PlateMaterial")
        material, doubts = self._material(holder)
        thickness = self._thickness(element, holder, material.density, doubts)
        contour = element.child("OuterContour")
        if contour is None:
            raise self._quantities.fail(element, "has no OuterContour")
        path, gap = read_contour(contour, self._quantities)
        if gap > _GAP:
            doubts.append(f"its contour is open by {gap:.3g} m, closed by a straight line")
        frame = contour_frame(path)
        if frame is None:
            raise self._quantities.fail(contour, "encloses no area")
        sheet = self._sheet(element, panel, path, frame, thickness, material.density, doubts)
        doubts += sheet.doubts
        net = self._quantities.of_child(element, "NetArea", "area")
        if net and sheet.area and abs(sheet.area - net) > _NET * net:
            doubts.append(f"its area is {sheet.area:.4g} m², declared are {net:.4g} m²")
        size = f"{1e3 * thickness:.4g} mm"
        return sheet.properties, sheet.mesh, material.name, size, tuple(doubts)

    def _thickness(self, element: Element, holder: Element, density: float, doubts: list[str]) -> float:
        """Thickness as stated [m], or, where no plate is that thick, as declared weight and area mean it."""
        stated = self._quantities.positive(holder, "Thickness")
        declared, net = self.declared(element), self._quantities.of_child(element, "NetArea", "area")
        if _THINNEST <= stated <= _THICKEST:
            return stated
        meant = declared.mass / (density * net) if declared is not None and net else 0.0
        if stated < _THICKEST or not 0 < meant <= _THICKEST:
            doubts.append(f"its thickness of {1e3 * stated:.4g} mm is no plate's")
            return stated
        doubts.append(
            f"its thickness of {1e3 * stated:.4g} mm is no plate's: {1e3 * meant:.4g} mm are taken, which "
            "its declared weight and area mean"
        )
        return meant

    def _sheet(
        self,
        element: Element,
        panel: Element | None,
        path: Sequence[Curve],
        frame: Frame,
        thickness: float,
        density: float,
        doubts: list[str],
    ) -> Sheet:
        openings = self._openings(element, panel)
        surface = self._surface(element, panel)
        flat = is_flat(path, frame)
        if flat and (surface is None or not spans(surface, path, frame)):
            return flat_sheet(path, frame, openings, thickness, density, self._tolerance)
        if surface is not None:
            sheet = curved_sheet(path, frame, surface, openings, thickness, density, self._tolerance)
            if sheet is not None:
                return sheet
            doubts.append("it is curved, and its surface does not reach over its contour: taken as flat")
        else:
            doubts.append("it is curved, and its surface is not read: taken as flat")
        return flat_sheet(path, frame, openings, thickness, density, self._tolerance)

    def _surface(self, element: Element, panel: Element | None) -> Surface | None:
        for owner in (element, panel):
            geometry = None if owner is None else owner.child("UnboundedGeometry")
            for child in () if geometry is None else geometry.children:
                if child.name == "SurfaceRef":
                    found = self._catalogue.surface(child)
                else:
                    found = read_surface(child, self._quantities)
                if found is not None:
                    return found
        return None

    def _openings(self, element: Element, panel: Element | None) -> list[list[Curve]]:
        """Openings of the part and those of its panel, which cut every plate that they touch."""
        holders = element.all("CutBy", "PlateCutBy")
        if panel is not None and element.name == "Plate":
            holders += panel.all("CutBy")
        found = [read_contour(inner, self._quantities)[0] for inner in element.all("InnerContour")]
        for child in (child for holder in holders for child in holder.children):
            if child.name in ("Hole2DContour", "SlotContour"):
                found.append(self._catalogue.placed_hole(child))
            elif child.name == "InnerContour":
                found.append(read_contour(child, self._quantities)[0])
        return found

    def _bar(self, element: Element, panel: Element | None) -> _Read:
        holder = element.child("MaterialRef")
        material, doubts = self._material(holder)
        reference = element.child("SectionRef")
        if reference is None:
            raise self._quantities.fail(element, "has no SectionRef")
        section = self._catalogue.section(reference)
        doubts += section.doubts
        trace = self._trace(element, doubts)
        inclinations = self._inclinations(element, trace)
        default_u = -section.width / 2 if section.is_symmetrical else 0.0
        default_v = -section.height / 2 if element.name == "Pillar" else 0.0
        given = [self._quantities.of_child(reference, name) for name in ("OffsetU", "OffsetV")]
        offset = np.array(
            [
                default if value is None else value
                for value, default in zip(given, (default_u, default_v), strict=True)
            ]
        )
        ends = (self._end_cut(element, "EndCutEnd1"), self._end_cut(element, "EndCutEnd2"))
        try:
            bar = swept(trace, section, offset, inclinations, material.density, self._tolerance, ends)
        except BarError as problem:
            raise self._quantities.fail(element, str(problem)) from None
        return bar.properties, bar.mesh, material.name, section.name, (*doubts, *bar.doubts)

    def _end_cut(self, element: Element, name: str) -> EndCut | None:
        """The cut at an end; flanges are cut with the web, copes are not cut."""
        cut = element.child(name)
        if cut is None:
            return None
        angle = self._quantities.of_child(cut, "WebCutBackAngle", "angle")
        found = EndCut(
            cutback=self._quantities.of_child(cut, "CutbackDistance") or 0.0,
            # No slope is written as no angle, as zero, or as a right angle.
            angle=angle if angle else math.pi / 2,
            nose=self._quantities.of_child(cut, "WebNoseHeight") or 0.0,
        )
        if found.cutback < 0 or found.nose < 0 or not math.radians(5) <= found.angle <= math.pi / 2 + 1e-9:
            raise self._quantities.fail(
                cut, "has a negative length, or an angle not between 5 and 90 degrees"
            )
        return found

    def _trace(self, element: Element, doubts: list[str]) -> list[Curve]:
        line = element.child("TraceLine")
        if line is not None:
            trace, gap = read_trace(line, self._quantities)
            if gap > JOIN:
                doubts.append(f"its trace line has gaps of up to {gap:.3g} m")
            return trace
        edges = element.all("EdgeCurveRef")
        if not edges:
            raise self._quantities.fail(element, "has neither TraceLine nor EdgeCurveRef")
        return [curve for edge in edges for curve in self._catalogue.edge(edge)]

    def _inclinations(self, element: Element, trace: Sequence[Curve]) -> list[Inclination]:
        found = []
        for each in element.all("Inclination"):
            flange = each.child("FlangeDirection")
            found.append(
                Inclination(
                    self._quantities.direction(each, "WebDirection"),
                    None if flange is None else self._quantities.direction(each, "FlangeDirection"),
                    trace[0].start
                    if each.child("Position") is None
                    else self._quantities.point_of(each, "Position"),
                )
            )
        if found:
            return found
        if element.name != "Pillar":
            raise self._quantities.fail(element, "has no Inclination")
        # A pillar may leave it open: any direction across it.
        points = polyline(trace, 1e-3)
        way = points[-1] - points[0]
        size = float(np.linalg.norm(way))
        if not size > 0:
            raise self._quantities.fail(element, "has a trace line without length")
        return [Inclination(Frame.across(points[0], way / size).first, None, points[0])]

    def _material(self, reference: Element | None) -> tuple[Material, list[str]]:
        if reference is None or "localRef" not in reference.attributes:
            return Material("", _STEEL), [f"it names no material: {_STEEL:g} kg/m³ is taken"]
        material = self._catalogue.material(reference)
        if DENSITIES[0] <= material.density <= DENSITIES[1]:
            return material, []
        said = f"material {material.name} has a density of {material.density:.4g} kg/m³"
        return material, [f"{said}, which nothing has; steel has {_STEEL:g} kg/m³"]
