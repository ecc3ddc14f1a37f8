"""A ship block of our own: double bottom, sides and decks of given size and weight.

The structure is that of a cargo hold between two erection joints: bottom and inner bottom with floors and
girders between them, single sides with webs, decks with transverses, pillars below them, and longitudinals
on all panels. The plates' thicknesses, apart from the profiles, are then scaled so that the whole weighs
what it shall, and, where that is asked for, has its centre of gravity at the height where it shall be.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from gantline.cad.errors import CadError
from gantline.cad.model import CadModel, Part, PartKind
from gantline.cad.structure import Bar, Hole, Panel, Plate, Profile

__all__ = ["ShipBlock", "ShipBlockSizes", "ship_block"]

Array = npt.NDArray[np.float64]

X, Y, Z = np.eye(3)
#: Plates that yards weld into hulls [m].
_THINNEST, _THICKEST = 0.005, 0.040
#: Plates are not longer and not wider than this [m].
_LONGEST, _WIDEST = 12.0, 3.2
#: Thicknesses before they are scaled, as ratios to one another.
_RATIOS = {"bottom": 1.1, "inner": 1.0, "floor": 0.95, "deck": 1.0, "side": 1.05, "web": 0.95}
_LONGITUDINAL = Profile("LBar", 0.100, 0.075, 0.007, 0.007)
_LIGHT_LONGITUDINAL = Profile("FlatBar", 0.120, 0.008)
_FACE = Profile("FlatBar", 0.120, 0.010)
_PILLAR = Profile("Tube", 0.1683, 0.1683, 0.008)
#: What panels are for, in the words of OCX.
_SHELL, _DECK = "SHELL: Bottom shell", "DECK: Weather deck"
_WEB_FRAME, _OTHER = "WEB_FRAME", "UNDEFINED: Miscellaneous"
#: Depths of the webs at the sides and below the decks [m].
_SIDE_WEB, _DECK_WEB = 0.8, 0.7


@dataclass(frozen=True)
class ShipBlockSizes:
    """What a ship block is made to.

    Attributes:
        length: along x, from −length/2 to length/2 [m].
        breadth: along y, from −breadth/2 to breadth/2 [m].
        height: from the bottom at z = 0 to the uppermost deck [m].
        mass: of all parts [kg].
        centre_height: height of the centre of gravity [m]; None where the structure puts it.
        double_bottom: height of the inner bottom [m].
        frame_spacing: between floors and web frames [m].
        longitudinal_spacing: between longitudinals [m].
        tween_decks: decks between inner bottom and uppermost deck.
    """

    length: float
    breadth: float
    height: float
    mass: float
    centre_height: float | None = None
    double_bottom: float = 1.2
    frame_spacing: float = 3.2
    longitudinal_spacing: float = 0.9
    tween_decks: int = 0

    def __post_init__(self) -> None:
        _between("length", self.length, 3.0, 120.0)
        _between("breadth", self.breadth, 4.0, 80.0)
        _between("height", self.height, 3.0, 60.0)
        _between("double bottom", self.double_bottom, 0.8, 0.4 * self.height)
        _between("frame spacing", self.frame_spacing, 0.5, self.length / 2)
        _between("longitudinal spacing", self.longitudinal_spacing, 0.3, self.breadth / 4)
        if not 0 <= self.tween_decks <= 20 or self.deck_spacing < 2 * _DECK_WEB:
            raise CadError(f"{self.tween_decks} tween decks do not go into a height of {self.height:g} m")
        if self.centre_height is not None:
            _between("height of the centre of gravity", self.centre_height, 0.0, self.height)
        if not self.mass > 0:
            raise CadError(f"a mass of {self.mass:g} kg is not positive")

    @property
    def deck_spacing(self) -> float:
        """Height between decks [m]."""
        return (self.height - self.double_bottom) / (self.tween_decks + 1)

    @property
    def decks(self) -> list[float]:
        """Heights of the decks from below [m]."""
        return [self.double_bottom + (place + 1) * self.deck_spacing for place in range(self.tween_decks + 1)]

    @property
    def frames(self) -> list[float]:
        """Where the floors and web frames are along x [m]."""
        return _grid(self.length / 2, self.frame_spacing, 0.1)

    @property
    def name(self) -> str:
        """Such as ``SHIP BLOCK 43X23X11``."""
        return f"SHIP BLOCK {self.length:g}X{self.breadth:g}X{self.height:g}"


@dataclass(frozen=True, eq=False)
class ShipBlock:
    """A ship block.

    Attributes:
        sizes: what it was made to.
        panels: plates with their stiffeners.
        pillars: between inner bottom and decks.
    """

    sizes: ShipBlockSizes
    panels: tuple[Panel, ...]
    pillars: tuple[Bar, ...]

    @property
    def parts(self) -> tuple[Part, ...]:
        """All parts with their weights."""
        return (*(part for panel in self.panels for part in panel.parts), *(bar.part for bar in self.pillars))

    @property
    def model(self) -> CadModel:
        """All parts as a model."""
        return CadModel(self.sizes.name, "gantline", self.parts, "m")

    @property
    def thicknesses(self) -> dict[str, float]:
        """Plate thickness of each panel [m]."""
        return {panel.name: panel.plates[0].thickness for panel in self.panels}


def ship_block(sizes: ShipBlockSizes) -> ShipBlock:
    """A ship block of given size and weight.

    Raises:
        CadError: if no plates between 5 and 40 mm give this weight, or this height of the centre of gravity.
    """
    panels, pillars = list(_panels(sizes)), tuple(_pillars(sizes))
    bars = [bar.part for panel in panels for bar in panel.bars] + [bar.part for bar in pillars]
    mass, moment = _sums(bars)
    lower = [panel for panel in panels if panel.plates[0].outline[:, 2].max() <= sizes.double_bottom]
    upper = [panel for panel in panels if panel not in lower]
    low, high = (_sums(plate.part for panel in group for plate in panel.plates) for group in (lower, upper))
    left = sizes.mass - mass
    if sizes.centre_height is None:
        factors = (left / (low[0] + high[0]),) * 2
    else:
        wanted = sizes.mass * sizes.centre_height - moment
        matrix = np.array([[low[0], high[0]], [low[1], high[1]]])
        found = np.linalg.solve(matrix, np.array([left, wanted]))
        factors = (float(found[0]), float(found[1]))
    scaled = [_scaled(panel, factors[panel in upper]) for panel in panels]
    _check(sizes, scaled, mass, low[0] + high[0])
    return ShipBlock(sizes, tuple(scaled), pillars)


def _sums(parts: Iterable[Part]) -> tuple[float, float]:
    """Mass, and its moment about z = 0."""
    found = [part.properties for part in parts if part.properties is not None]
    return math.fsum(each.mass for each in found), math.fsum(each.mass * each.centre[2] for each in found)


def _scaled(panel: Panel, factor: float) -> Panel:
    return replace(panel, plates=tuple(replace(p, thickness=p.thickness * factor) for p in panel.plates))


def _check(sizes: ShipBlockSizes, panels: list[Panel], bars: float, plates: float) -> None:
    thin, thick = (pick(panels, key=lambda panel: panel.plates[0].thickness) for pick in (min, max))
    least, most = thin.plates[0].thickness, thick.plates[0].thickness
    if least >= _THINNEST and most <= _THICKEST:
        return
    ratios = _RATIOS.values()
    lightest, heaviest = (
        bars + plates * 1e3 * bound
        for bound in (_THINNEST / min(ratios), _THICKEST / max(ratios))
    )  # fmt: skip
    possible = f"between {lightest / 1e3:.4g} and {heaviest / 1e3:.4g} t"
    asked = f"{sizes.mass / 1e3:g} t"
    if sizes.centre_height is not None:
        asked += f" with the centre of gravity {sizes.centre_height:g} m high"
    worst, size = (thin, least) if least < _THINNEST else (thick, most)
    raise CadError(
        f"{asked} needs {1e3 * size:.3g} mm plates in {worst.name}; yards weld plates of 5 to 40 mm. "
        f"This structure weighs {possible}; other spacings or decks give other weights"
    )


def _between(what: str, value: float, least: float, most: float) -> None:
    if not least <= value <= most:
        raise CadError(f"a {what} of {value:g} m is not between {least:g} and {most:g} m")


def _grid(half: float, spacing: float, edge: float) -> list[float]:
    """Multiples of a spacing about 0, not closer than `edge` to either end."""
    count = math.floor((half - edge) / spacing)
    return [place * spacing for place in range(-count, count + 1)]


def _panels(sizes: ShipBlockSizes) -> Iterator[Panel]:
    half, beam = sizes.length / 2, sizes.breadth / 2
    inner = sizes.double_bottom
    lengthwise = [y for y in _grid(beam, sizes.longitudinal_spacing, 0.25) if not _on_girder(sizes, y)]
    flats = [("BOTTOM", 0.0, "bottom", _SHELL, Z, _LONGITUDINAL)]
    flats += [("INNER BOTTOM", inner, "inner", _OTHER, -Z, _LIGHT_LONGITUDINAL)]
    flats += [
        (f"DECK {place}", z, "deck", _DECK, -Z, _LIGHT_LONGITUDINAL) for place, z in enumerate(sizes.decks, 1)
    ]
    for name, z, ratio, function, web, profile in flats:
        corner = np.array([-half, -beam, z])
        plates = tuple(_plates(name, corner, 2 * half * X, 2 * beam * Y, ratio))
        bars = tuple(
            Bar(f"{name} L{place}", PartKind.STIFFENER, profile,
                np.array([[-half, y, z], [half, y, z]]), web, -Y if y > 0 else Y)
            for place, y in enumerate(lengthwise, 1)
        )  # fmt: skip
        yield Panel(name, function, plates, bars)
    for name, side in (("SIDE P", 1.0), ("SIDE S", -1.0)):
        corner = np.array([-half, side * beam, 0.0])
        plates = tuple(_plates(name, corner, 2 * half * X, sizes.height * Z, "side"))
        heights = np.arange(
            inner + sizes.longitudinal_spacing, sizes.height - 0.25, sizes.longitudinal_spacing
        )
        bars = tuple(
            Bar(f"{name} L{place}", PartKind.STIFFENER, _LIGHT_LONGITUDINAL,
                np.array([[-half, side * beam, z], [half, side * beam, z]]), -side * Y, -Z)
            for place, z in enumerate(heights.tolist(), 1)
        )  # fmt: skip
        yield Panel(name, _OTHER, plates, bars)
    for place, y in enumerate(_girders(sizes), 1):
        name = f"GIRDER {place}"
        plates = tuple(_plates(name, np.array([-half, y, 0.0]), 2 * half * X, inner * Z, "floor"))
        yield Panel(name, _OTHER, plates)
    for place, x in enumerate(sizes.frames, 1):
        yield Panel(f"FLOOR {place}", _OTHER, (_floor(sizes, place, x),))
        yield from _web_frame(sizes, place, x)


def _girders(sizes: ShipBlockSizes) -> list[float]:
    return [-sizes.breadth / 4, 0.0, sizes.breadth / 4] if sizes.breadth > 12 else [0.0]


def _on_girder(sizes: ShipBlockSizes, y: float) -> bool:
    return any(abs(y - girder) < 0.2 for girder in _girders(sizes))


def _plates(name: str, corner: Array, first: Array, second: Array, ratio: str) -> Iterator[Plate]:
    """A rectangle cut into plates of a size that mills roll: strakes along its first side."""
    along = math.ceil(float(np.linalg.norm(first)) / _LONGEST - 1e-9)
    across = math.ceil(float(np.linalg.norm(second)) / _WIDEST - 1e-9)
    sides = np.array([first / along, second / across])
    for row in range(across):
        for column in range(along):
            start = corner + column * sides[0] + row * sides[1]
            yield Plate(f"{name} {row + 1}.{column + 1}", start, sides, 1e-3 * _RATIOS[ratio])


def _floor(sizes: ShipBlockSizes, place: int, x: float) -> Plate:
    """A floor over the whole breadth, with lightening holes side by side, about one for two longitudinals."""
    count = 2 * max(1, round(sizes.breadth / (4 * sizes.longitudinal_spacing)))
    cell = sizes.breadth / count
    height = 0.4 * sizes.double_bottom
    width = max(height, 0.5 * cell)
    corner = np.array([x, -sizes.breadth / 2, 0.0])
    middles = [-sizes.breadth / 2 + (k + 0.5) * cell for k in range(count)]
    holes = tuple(Hole(np.array([x, y, sizes.double_bottom / 2]), width, height) for y in middles)
    sides = np.array([sizes.breadth * Y, sizes.double_bottom * Z])
    return Plate(f"FLOOR {place}", corner, sides, 1e-3 * _RATIOS["floor"], holes)


def _web_frame(sizes: ShipBlockSizes, place: int, x: float) -> Iterator[Panel]:
    """Webs at both sides and transverses below each deck, with face plates on their free edges."""
    beam, inner = sizes.breadth / 2, sizes.double_bottom
    thickness = 1e-3 * _RATIOS["web"]
    centred = (0.0, -_FACE.height / 2)
    for name, side in (("P", 1.0), ("S", -1.0)):
        corner = np.array([x, side * beam, inner])
        sides = np.array([-side * _SIDE_WEB * Y, (sizes.height - inner) * Z])
        edge = side * (beam - _SIDE_WEB)
        ends = np.array([[x, edge, inner], [x, edge, sizes.height - _DECK_WEB]])
        label = f"WEB {place} {name}"
        face = Bar(f"{label} FACE", PartKind.STIFFENER, _FACE, ends, X, -side * Y, centred)
        yield Panel(label, _WEB_FRAME, (Plate(label, corner, sides, thickness),), (face,))
    for deck, z in enumerate(sizes.decks, 1):
        reach = beam - _SIDE_WEB
        label = f"TRANSVERSE {place}.{deck}"
        corner, sides = np.array([x, -reach, z - _DECK_WEB]), np.array([2 * reach * Y, _DECK_WEB * Z])
        ends = np.array([[x, -reach, z - _DECK_WEB], [x, reach, z - _DECK_WEB]])
        face = Bar(f"{label} FACE", PartKind.STIFFENER, _FACE, ends, X, -Z, centred)
        yield Panel(label, _WEB_FRAME, (Plate(label, corner, sides, thickness),), (face,))


def _pillars(sizes: ShipBlockSizes) -> Iterator[Bar]:
    """In two rows at a quarter of the breadth, below every second transverse."""
    below = [sizes.double_bottom, *sizes.decks[:-1]]
    centred = (-_PILLAR.height / 2,) * 2
    for x in sizes.frames[len(sizes.frames) // 2 % 2 :: 2]:
        for name, y in (("S", -sizes.breadth / 4), ("P", sizes.breadth / 4)):
            for tier, (low, deck) in enumerate(zip(below, sizes.decks, strict=True), 1):
                ends = np.array([[x, y, low], [x, y, deck - _DECK_WEB]])
                label = f"PILLAR {sizes.frames.index(x) + 1}.{tier} {name}"
                yield Bar(label, PartKind.PILLAR, _PILLAR, ends, Y, X, centred)
