"""STEP and IGES, read by Open CASCADE in a process of its own, as parts with exact mass properties."""

from __future__ import annotations

import importlib.util
import json
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from gantline.cad.assumptions import DENSITIES, STAND_UP, Assumptions
from gantline.cad.bodies import NO_THICKNESS, NO_WEIGHT
from gantline.cad.errors import CadError
from gantline.cad.files import content, missing
from gantline.cad.mass_properties import MassProperties
from gantline.cad.mesh import TriangleMesh
from gantline.cad.model import CadModel, Part, PartKind
from gantline.units import DIMENSIONS

__all__ = ["COARSE", "FINE", "STEP_FORMATS", "read_step_file"]

#: Endings of names, and how the formats are called.
STEP_FORMATS = {".step": "STEP", ".stp": "STEP", ".igs": "IGES", ".iges": "IGES"}
#: How far triangles may be from the surface they stand for, as a share of the part's size; masses are exact.
COARSE = 0.002
#: The same of a hull, of which the triangles are all that floats: its volume is then right to a thousandth.
FINE = 0.0002
#: What a file may take before it is given up [s], [bytes].
_LONGEST = 600.0
_MOST_MEMORY = 12_000_000_000
#: Open CASCADE hands out millimetres.
_MILLIMETRE = 1e-3
#: How STEP and IGES name units of length.
_UNIT_NAMES = {
    "millimetre": "mm", "millimeter": "mm", "mm": "mm", "metre": "m", "meter": "m", "m": "m",
    "centimetre": "cm", "centimeter": "cm", "cm": "cm", "kilometre": "km", "km": "km",
}  # fmt: skip


def read_step_file(path: Path, given: Assumptions, deflection: float = COARSE) -> CadModel:
    """A STEP or IGES file: solids weighed by exact volume, open surfaces by area and plate thickness.

    Args:
        path: the file.
        given: what to take where it says nothing.
        deflection: how far triangles may be from a part's surface, as a share of the part's size [1].

    Raises:
        CadError: if it cannot be read, holds no solid and no surface, takes too long or too much memory, or
            Open CASCADE is not installed.
    """
    form = STEP_FORMATS[path.suffix.lower()]
    _check_header(path, form)
    if importlib.util.find_spec("OCP") is None:
        raise missing(path, "Open CASCADE (cadquery-ocp-novtk)")
    with tempfile.TemporaryDirectory(prefix="gantline-") as folder:
        result = Path(folder) / "parts.npz"
        _run(path, form, deflection, result)
        with np.load(result) as arrays:
            found = json.loads(str(arrays["parts"]))
            meshes = [(arrays[f"v{k}"], arrays[f"t{k}"]) for k in range(len(found["parts"]))]
    if not meshes:
        raise CadError(f"{path}: there is no solid and no surface in this {form} file")
    factor, unit, doubts = _unit(found["unit"], given)
    doubts += found["doubts"]
    if count := sum(not body["agree"] for body in found["parts"]):
        doubts.append(f"{count} of {len(found['parts'])} parts have faces that do not agree on their outside")
    parts = [
        _part(body, TriangleMesh(*mesh).scaled(factor), factor, given)
        for body, mesh in zip(found["parts"], meshes, strict=True)
    ]
    if given.up == "y":
        parts = [_stood_up(part) for part in parts]
    return CadModel(path.name, form, tuple(_numbered(parts, path)), unit, tuple(doubts))


def _check_header(path: Path, form: str) -> None:
    """Say in a moment, and without the library, what is no such file or was cut off."""
    data = content(path)
    if form == "STEP":
        if b"ISO-10303-21" not in data[:2000]:
            raise CadError(f"{path}: it is no STEP file: 'ISO-10303-21;' does not stand at its beginning")
        if b"END-ISO-10303-21" not in data[-2000:]:
            raise CadError(f"{path}: the STEP file is cut off: it does not end on 'END-ISO-10303-21;'")
        return
    last = data.rstrip().rsplit(b"\n", 1)[-1]
    if len(data) < 160 or data[72:73] not in b"SBC":
        raise CadError(f"{path}: it is no IGES file: column 73 of its first line is not 'S'")
    if last[72:73] != b"T":
        raise CadError(f"{path}: the IGES file is cut off: its last line is not its terminate section")


def _run(path: Path, form: str, deflection: float, result: Path) -> None:
    program = str(Path(__file__).with_name("_occt.py"))
    command = [sys.executable, "-P", program, str(path), str(result), str(deflection), str(_MOST_MEMORY)]
    try:
        done = subprocess.run(
            command, capture_output=True, text=True, timeout=_LONGEST, check=False, errors="replace"
        )
    except subprocess.TimeoutExpired:
        raise CadError(f"{path}: reading took longer than {_LONGEST:g} s and was given up") from None
    if done.returncode == 0 and result.exists():
        return
    lines = done.stderr.strip().splitlines()
    if done.returncode == 2 and lines:
        raise CadError(f"{path}: {lines[-1]}")
    why = f"it was ended by signal {-done.returncode}" if done.returncode < 0 else "".join(lines[-1:])
    raise CadError(f"{path}: Open CASCADE could not read this {form} file: {why or 'it said nothing'}")


def _unit(named: str, given: Assumptions) -> tuple[float, str, list[str]]:
    """Metres per length as handed out, the unit as text, and doubts."""
    known = _UNIT_NAMES.get(named.strip().lower())
    if given.unit is not None:
        if known is None:
            raise CadError(
                f"the file is in '{named}': a unit that is asked for instead cannot be held against that"
            )
        factor = _MILLIMETRE * DIMENSIONS["length"][given.unit] / DIMENSIONS["length"][known]
        return factor, f"{given.unit}, as asked for; the file says {known}", []
    if not named.strip():
        return _MILLIMETRE, "mm, the format's own", ["the file names no unit of length; it is taken as mm"]
    if "," in named:
        return _MILLIMETRE, f"{named}, as the file says", [f"the file has several units of length: {named}"]
    return _MILLIMETRE, f"{known or named}, as the file says", []


def _part(body: Mapping[str, Any], mesh: TriangleMesh, factor: float, given: Assumptions) -> Part:
    names = [name for name in body["names"] if name]
    doubts = []
    solid = bool(body["solid"])
    density, material = given.density, ""
    if body["density"] > 0:
        stated = _density(body["density"])
        if stated is not None:
            density, material = stated, f"{stated:.6g} kg/m^3"
        else:
            doubts.append("the file gives a density that is that of no material, which is not used")
    amount = body["content"] * factor ** (3 if solid else 2)
    if not body["agree"]:
        doubts.append("its faces do not agree on which side is outside, so its mass may be wrong")
    if count := body["cavities"]:
        doubts.append(f"{count} closed surface{'s' * (count > 1)} within it: taken as what is hollow")
    smallest = 1e-12 * mesh.size ** (3 if solid else 2) if len(mesh.triangles) else 0.0
    properties = None
    if solid and amount < -smallest:
        amount = -amount
        doubts.append("all its faces were turned inwards; they are turned")
        mesh = mesh.flipped()
    if abs(amount) <= smallest:
        doubts.append(NO_WEIGHT)
    elif not solid and given.thickness is None:
        doubts.append(NO_THICKNESS)
    else:
        try:
            properties = _weighed(body, factor, density * amount * (1.0 if solid else given.thickness or 0.0))
        except ValueError as problem:  # faces that the library has read wrongly
            doubts.append(f"its faces are broken, so it has no weight: {problem}")
    return Part(
        name=names[-1] if names else "",
        kind=PartKind.SOLID if solid else PartKind.SHELL,
        properties=properties,
        declared=None,
        mesh=mesh,
        material=material,
        size=f"{given.thickness * 1e3:g} mm" if given.thickness and not solid else "",
        group=" / ".join(names[:-1]),
        doubts=tuple(doubts),
    )


def _density(given: float) -> float | None:
    """Density [kg/m^3] of a number that the library hands out per mm^3, in g or kg as the file has it.

    No two of these readings are both that of a material, so the number tells which is meant.
    """
    for factor in (1e6, 1e9, 1e3):
        if DENSITIES[0] <= factor * given <= DENSITIES[1]:
            return factor * given
    return None


def _weighed(body: Mapping[str, Any], factor: float, mass: float) -> MassProperties:
    """Mass properties from moments of volume or area: both scale with the mass that is spread over them."""
    inertia = np.array(body["inertia"]) / body["content"] * factor**2
    return MassProperties(mass, np.array(body["centre"]) * factor, mass * inertia)


def _stood_up(part: Part) -> Part:
    """A part of a file that has y up, turned."""
    still = np.zeros(3)
    properties = None if part.properties is None else part.properties.moved(STAND_UP, still)
    return replace(part, properties=properties, mesh=part.mesh.moved(STAND_UP, still))


def _numbered(parts: list[Part], path: Path) -> list[Part]:
    """Parts of one name told apart by numbers; those without one named after the file."""
    names = [part.name or path.stem for part in parts]
    total, seen = Counter(names), Counter[str]()
    numbered = []
    for name, part in zip(names, parts, strict=True):
        seen[name] += 1
        numbered.append(replace(part, name=name if total[name] == 1 else f"{name} {seen[name]}"))
    return numbered
