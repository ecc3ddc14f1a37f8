"""What a wave program says about one body, whatever the format of its file."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from gantline.arguments import is_number
from gantline.hydro.database.around import ForcesAround, all_round, beside
from gantline.hydro.database.outlying import outliers
from gantline.hydro.waves import wave_number as number_of_waves

__all__ = ["AXES", "DRIFTING", "Coupling", "DatabaseError", "HydrodynamicDatabase", "turn_about_z"]

Array = npt.NDArray[np.float64]

#: The six motions, in the order of rows and columns.
AXES = ("surge", "sway", "heave", "roll", "pitch", "yaw")
#: Those that drift forces are of.
DRIFTING = ("surge", "sway", "yaw")

#: Difference of a matrix from its transpose that panel methods leave, of the diagonal.
_UNSYMMETRIC = 0.02
#: The same beyond which a file contradicts itself.
_CONTRADICTS = 0.25
#: Directions are within a turn to either side, but for rounding [rad].
_ONE_TURN = 2 * math.pi * (1 + 1e-6)
#: Frequencies that are nearer than this share of them are one but for rounding: cubics through two values
#: there have any slope, and swing as far as the next frequencies.
_ONE_FREQUENCY = 1e-6
#: Turn of the phase at a corner from one point of a file to the next that leaves nine of ten forces between
#: them within 4 %, and all within a tenth [rad]: docs/concepts/waves.md.
_FARTHEST = 1.5
#: Gravity by which waves of files are as long as they are [m/s^2].
_GRAVITY = 9.81
#: Negative damping that panel methods leave near irregular frequencies, of the diagonal.
_NEGATIVE = 0.02


class DatabaseError(ValueError):
    """A hydrodynamic database cannot be used; the message is one plain sentence."""


class Coupling(NamedTuple):
    """What motions of another body do to one, through the waves that they make.

    Attributes:
        added_mass: [force on the one, motion of the other] by frequency (n, 6, 6) [kg, kg m, kg m^2].
        damping: The same of damping (n, 6, 6) [N s/m, N s, N m s].
    """

    added_mass: Array
    damping: Array


@dataclass(frozen=True, eq=False)
class HydrodynamicDatabase:
    """Radiation, and what waves do, of one body. SI units, x forward, y to port, z up.

    Attributes:
        name: of the body.
        source: name of the file and its format, in words.
        frequencies: circular frequencies, rising, all above zero and finite (n,) [rad/s].
        added_mass: (n, 6, 6) [kg, kg m, kg m^2].
        damping: (n, 6, 6) [N s/m, N s, N m s].
        density: of the water that they are for [kg/m^3]; None where the file does not say.
        infinite_added_mass: at infinite frequency (6, 6); None where the file has none.
        reference: point that matrices are about, in the file's axes, z = 0 in the water (3,) [m]; None where
            the file does not say.
        displacement: volume (float) [m^3]; None where the file does not say.
        water_depth: [m], infinite for deep water; None where the file does not say.
        directions: that waves run in, from x towards y (k,) [rad]; empty where there are none.
        excitation: complex force per metre of wave amplitude (n, k, 6) [N/m, N]: force Re(F exp(−iωt)) in the
            wave Re(exp(i(κx − ωt))) at the file's origin; None where there is none.
        drift: surge, sway and yaw over the square of the amplitude (n, k, 3) [N/m^2, N/m]; None where there
            is none.
        others: what the other bodies of the file do to this one, by their names; empty of one that is alone.
            All wave forces are then those beside the others held fast.
        doubts: what is doubtful, a sentence each.
    """

    name: str
    source: str
    frequencies: Array
    added_mass: Array
    damping: Array
    density: float | None = None
    infinite_added_mass: Array | None = None
    reference: Array | None = None
    displacement: float | None = None
    water_depth: float | None = None
    directions: Array = field(default_factory=lambda: np.zeros(0))
    excitation: npt.NDArray[np.complex128] | None = None
    drift: Array | None = None
    others: Mapping[str, Coupling] = field(default_factory=dict)
    doubts: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        self._take_arrays()
        count = len(self.frequencies)
        if count == 0:
            raise DatabaseError(f"{self.source}: there are no frequencies in it")
        for what, values in (("added mass", self.added_mass), ("damping", self.damping)):
            if values.shape != (count, 6, 6):
                shape = " × ".join(map(str, values.shape))
                raise DatabaseError(
                    f"{self.source}: its {what} is {shape}; {count} frequencies need {count} × 6 × 6"
                )
            if not np.isfinite(values).all():
                raise DatabaseError(f"{self.source}: its {what} has numbers that are not finite")
        self._hold_frequencies()
        if self.density is not None and not 0 < self.density < 1e5:
            raise DatabaseError(f"{self.source}: {self.density:g} kg/m^3 is not the density of water")
        if self.infinite_added_mass is not None and not (
            self.infinite_added_mass.shape == (6, 6) and np.isfinite(self.infinite_added_mass).all()
        ):
            raise DatabaseError(f"{self.source}: its added mass at infinite frequency is no 6 × 6 matrix")
        if self.reference is not None and self.reference.shape != (3,):
            found = f"its reference point has {self.reference.size} coordinates"
            raise DatabaseError(f"{self.source}: {found}; x, y and z are needed")
        for name, coupling in self.others.items():
            for values in coupling:
                if values.shape != (count, 6, 6) or not np.isfinite(values).all():
                    found = f"what {name} does to {self.name} is no {count} × 6 × 6 numbers that are finite"
                    raise DatabaseError(f"{self.source}: {found}")
        self._hold_waves()

    def _hold_frequencies(self) -> None:
        """Raise DatabaseError where frequencies do not rise from above zero, by more than rounding."""
        if not (np.isfinite(self.frequencies).all() and np.all(np.diff(self.frequencies, prepend=0.0) > 0)):
            raise DatabaseError(f"{self.source}: its frequencies do not rise from above zero")
        gaps = np.diff(self.frequencies)
        if len(gaps) and (gaps / self.frequencies[1:]).min() < _ONE_FREQUENCY:
            twice = f"{self.frequencies[int(gaps.argmin())]:.6g} rad/s"
            sentence = f"it has two frequencies of {twice} that differ by rounding"
            raise DatabaseError(f"{self.source}: {sentence}; leave one of them out")

    def _take_arrays(self) -> None:
        """Take lists of numbers for arrays; raise DatabaseError where there are no numbers."""
        kinds = {"directions": "directions", "excitation": "wave forces", "drift": "drift forces"}
        needed = {"frequencies": "frequencies", "added_mass": "added mass", "damping": "damping"}
        more = {"infinite_added_mass": "added mass at infinite frequency", "reference": "reference point"}
        for name, what in {**needed, **more, **kinds}.items():
            given = getattr(self, name)
            if given is None and name not in needed:
                continue
            try:
                values = np.asarray(given, dtype=complex if name == "excitation" else float)
            except (TypeError, ValueError):  # texts, or lists of several lengths
                values = np.zeros(())
            if not values.ndim:
                raise DatabaseError(f"{self.source}: what is given as its {what} is no array of numbers")
            object.__setattr__(self, name, values)
        if self.frequencies.ndim != 1:
            raise DatabaseError(f"{self.source}: its frequencies are no single row")
        for name, unit in (("density", "kg/m^3"), ("displacement", "m^3"), ("water_depth", "m")):
            value = getattr(self, name)
            if value is not None and not is_number(value):
                raise DatabaseError(f"{self.source}: {value!r} is no number, and its {name} is one [{unit}]")

    def _hold_waves(self) -> None:
        """Raise DatabaseError where directions or wave forces are none."""
        farthest = float(np.abs(self.directions).max(initial=0.0))
        if not farthest <= _ONE_TURN:
            raise DatabaseError(
                f"{self.source}: its waves run in directions up to {farthest:g} rad; degrees are no radians"
            )
        shape = (len(self.frequencies), len(self.directions))
        for what, values, motions in (("wave forces", self.excitation, 6), ("drift forces", self.drift, 3)):
            if values is None:
                continue
            if values.shape != (*shape, motions):
                own, wanted = (" × ".join(map(str, one)) for one in (values.shape, (*shape, motions)))
                raise DatabaseError(
                    f"{self.source}: its {what} are {own}; {shape[0]} frequencies and {shape[1]} "
                    f"directions need {wanted}"
                )
            if not np.isfinite(values).all():
                raise DatabaseError(f"{self.source}: its {what} have numbers that are not finite")

    def __repr__(self) -> str:
        count = len(self.directions)
        waves = f"wave forces in {count} directions" if self.excitation is not None else "no wave forces"
        waves += "" if self.drift is None else " with drift forces"
        least, most = self.periods[[-1, 0]]
        periods = f"{len(self.frequencies)} periods from {least:.4g} s to {most:.4g} s"
        return f"<HydrodynamicDatabase {self.name!r}, {self.source}: {periods}, {waves}>"

    def along(self, heading: float) -> HydrodynamicDatabase:
        """The same along axes that are turned about z.

        Args:
            heading: of the new x axis, from x towards y [rad].
        """
        turn = turn_about_z(heading)

        def turned(matrices: Array) -> Array:
            along: Array = turn @ matrices @ turn.T
            return along

        return replace(
            self,
            added_mass=turned(self.added_mass),
            damping=turned(self.damping),
            infinite_added_mass=(
                None if self.infinite_added_mass is None else turned(self.infinite_added_mass)
            ),
            reference=None if self.reference is None else turn[:3, :3] @ self.reference,
            directions=(self.directions - heading) % math.tau,
            excitation=None if self.excitation is None else self.excitation @ turn.T,
            drift=None if self.drift is None else self.drift @ turn[np.ix_([0, 1, 5], [0, 1, 5])].T,
            others={
                name: Coupling(turned(one.added_mass), turned(one.damping))
                for name, one in self.others.items()
            },
        )

    @property
    def asymmetry(self) -> tuple[float, float]:
        """Largest difference of added mass and of damping from their transposes, of the diagonal."""
        return max(map(_asymmetry, self.added_mass)), max(map(_asymmetry, self.damping))

    @property
    def periods(self) -> Array:
        """Periods of the frequencies (n,) [s]."""
        return 2 * np.pi / self.frequencies

    def added_mass_at(self, period: float | None, density: float) -> tuple[Array, list[str]]:
        """Added mass at a period, by a cubic spline over frequency, made symmetric.

        Args:
            period: [s]; None is infinite frequency.
            density: of the water that it is wanted for [kg/m^3].

        Returns:
            the matrix (6, 6) [kg, kg m, kg m^2] about the reference point; what is doubtful.

        Raises:
            DatabaseError: if the period is not within the file, or the matrix is no added mass.
        """
        if period is None:
            if self.infinite_added_mass is None:
                raise DatabaseError(f"{self.source}: has no infinite frequency; {self._range()}")
            matrix = self.infinite_added_mass
        else:
            matrix = self._between(self.added_mass, period)
        found, doubts = self._ready(matrix, density, "added mass")
        return found, doubts if period is None else doubts + self.outlying(period)

    def outlying(self, period: float | None) -> list[str]:
        """Each frequency whose added mass stands alone, a sentence each.

        Args:
            period: [s]; of those alone whose values tell what is there, between their neighbours; None for
                all that the file has.
        """
        said = []
        for one in outliers(self.added_mass):
            ends = self.periods[[min(one.place + 1, len(self.periods) - 1), max(one.place - 1, 0)]]
            if period is None or ends[0] <= period <= ends[1]:
                axes = ", ".join(AXES[axis] for axis in one.axes)
                what = f"{self.source}: its added mass of {axes} at {self.periods[one.place]:.4g} s"
                beside = f"is {one.times:.3g} times that at the periods beside it"
                smooth = f"{beside}, where it goes smoothly by nature"
                if self.others:
                    why = "but for resonances of the water between bodies: frequencies closer to it tell"
                    said.append(f"{what} {smooth}, {why}")
                else:
                    said.append(f"{what} {smooth}: leave that frequency out")
        return said

    def damping_at(self, period: float, density: float) -> tuple[Array, list[str]]:
        """Damping at a period [s], shape (6, 6) [N s/m, N s, N m s]; otherwise as `added_mass_at`."""
        return self._ready(self._between(self.damping, period), density, "damping")

    def excitation_at(
        self, frequency: Array, direction: float, density: float, phased_at: npt.ArrayLike = (0.0, 0.0)
    ) -> tuple[npt.NDArray[np.complex128], list[str]]:
        """Wave forces per metre of amplitude, by cubic splines over frequency and over direction.

        Above the highest frequency of the file they are zero, below the lowest those of the lowest.

        Args:
            frequency: ω of waves (n,) [rad/s].
            direction: that they run in, from x towards y [rad].
            density: of the water that they are wanted for [kg/m^3].
            phased_at: point from which phases count, in the file's axes, x and y (2,) [m]. From the middle
                of the body forces change least from one frequency or direction to the next.

        Returns:
            forces (n, 6) [N/m, N] about the reference point; what is doubtful.

        Raises:
            DatabaseError: if the file has no wave forces, or none for this direction.
        """
        found = self.excitation_around(frequency, density, phased_at).at(direction)
        doubts = list(self.doubts)
        if self.density is None:
            doubts.append(f"{self.source} does not say for which water; that of the lift is taken")
        if found is None:
            own = np.degrees(self.directions) % 360.0
            shown, wanted = ", ".join(f"{angle:.4g}" for angle in sorted(own)[:12]), math.degrees(direction)
            why = ", and beside other bodies those of one side are no mirror image" if self.others else ""
            raise DatabaseError(
                f"{self.source}: no waves that run {wanted % 360.0:.4g} deg from its bow; it has {shown} deg"
                f"{why}"
            )
        if beside(self.directions, direction) is None:  # never of one beside others
            doubts.append(f"{self.source}: its waves come from one side; from the other they are mirrored")
        return found, doubts

    def excitation_around(
        self, frequency: Array, density: float, phased_at: npt.ArrayLike = (0.0, 0.0)
    ) -> ForcesAround:
        """Wave forces per metre in all directions of the file, and mirrored in those of its other side.

        Those of a body beside others are not mirrored: what lies on one side of it does not on the other.

        Args:
            frequency: ω of waves (n,) [rad/s].
            density: of the water that they are wanted for [kg/m^3].
            phased_at: as of `excitation_at`; of what is mirrored it is on the centre plane of the body.

        Raises:
            DatabaseError: if the file has no wave forces.
        """
        if self.excitation is None or not len(self.directions):
            raise DatabaseError(f"{self.source}: has no wave forces; a file of a run with waves has")
        x, y = np.asarray(phased_at, dtype=float)
        along = np.cos(self.directions) * x + np.sin(self.directions) * y
        way = np.outer(self.wave_number(self.frequencies), along)
        phased = self.excitation * np.exp(-1j * way)[:, :, np.newaxis]
        signs = None if self.others else np.array([1.0, -1.0, 1.0, -1.0, 1.0, -1.0])
        forces, directions = all_round(self.directions, phased, signs)
        scaled = forces * complex(self._denser(density))
        return ForcesAround.between(self.frequencies, scaled, frequency, directions)

    def drift_around(self, frequency: Array, density: float, *, derivative: int = 0) -> ForcesAround | None:
        """Drift forces over the square of the amplitude in the directions of `excitation_around`.

        None of a file that has none.

        Args:
            frequency: ω of waves (n,) [rad/s].
            density: of the water that they are wanted for [kg/m^3].
            derivative: over the frequency, 0 or 1.
        """
        if self.drift is None:
            return None
        signs = None if self.others else np.array([1.0, -1.0, -1.0])
        drifts, directions = all_round(self.directions, self.drift, signs)
        scaled = drifts * self._denser(density)
        return ForcesAround.drifts_between(
            self.frequencies, scaled, frequency, directions, derivative=derivative
        )

    def _denser(self, density: float) -> float:
        """Forces in water of this density [kg/m^3] over those of the file."""
        return 1.0 if self.density is None else density / self.density

    def has_close(
        self, frequency: Array, direction: float, length: float, breadth: float
    ) -> npt.NDArray[np.bool_]:
        """Whether forces of waves can be told from those beside them in the file (n,).

        The phase at a corner, κ (x cos β + y sin β), turns by so much at most from one frequency or direction
        to the next that a cubic spline follows: docs/concepts/waves.md.

        Args:
            frequency: ω of waves (n,) [rad/s].
            direction: that they run in, from x towards y, one that forces are known for [rad].
            length: of the body [m].
            breadth: of the body [m].
        """
        rise = np.zeros(len(frequency))
        if len(self.frequencies) > 1:
            after = np.clip(np.searchsorted(self.frequencies, frequency), 1, len(self.frequencies) - 1)
            numbers = self.wave_number(self.frequencies)
            is_between = ~np.isclose(self.frequencies[[after - 1, after]], frequency, rtol=1e-6).any(axis=0)
            rise = np.where(is_between, numbers[after] - numbers[after - 1], 0.0)
        both = np.concatenate([self.directions, -self.directions])
        place = beside(both, direction)
        assert place is not None  # forces are known
        before, _, gap = place
        within = both[before] + gap * np.array([0.0, 0.5, 1.0])
        along, across = abs(math.cos(direction)), abs(math.sin(direction))
        turned = rise * (length / 2 * along + breadth / 2 * across)
        swept = length / 2 * np.abs(np.sin(within)) + breadth / 2 * np.abs(np.cos(within))
        turn = np.maximum(turned, self.wave_number(frequency) * gap * swept.max())
        close: npt.NDArray[np.bool_] = turn <= _FARTHEST
        return close

    def wave_number(self, frequency: Array) -> Array:
        """κ of waves in the file's depth (n,) [1/m] by ω (n,) [rad/s]."""
        depth = None if self.water_depth is None or math.isinf(self.water_depth) else self.water_depth
        return number_of_waves(frequency, _GRAVITY, depth)

    def _range(self) -> str:
        longest, shortest = self.periods[0], self.periods[-1]
        return f"its periods go from {shortest:.4g} to {longest:.4g} s"

    def _between(self, values: Array, period: float) -> Array:
        wanted = 2 * np.pi / period
        low, high = self.frequencies[0], self.frequencies[-1]
        if not low * (1 - 1e-9) <= wanted <= high * (1 + 1e-9):
            raise DatabaseError(f"{self.source}: a period of {period:.4g} s is not in it; {self._range()}")
        if len(self.frequencies) == 1:
            only: Array = values[0]
            return only
        from scipy.interpolate import CubicSpline  # takes a second to load

        between: Array = CubicSpline(self.frequencies, values)(np.clip(wanted, low, high))
        return between

    def _ready(self, matrix: Array, density: float, what: str) -> tuple[Array, list[str]]:
        """Symmetric, without negative eigenvalues, for another water."""
        doubts = list(self.doubts)
        if self.density is None:
            doubts.append(f"{self.source} does not say for which water; that of the lift is taken")
        else:
            matrix = matrix * (density / self.density)
        difference = np.abs(matrix - matrix.T) / np.outer(_scale(matrix), _scale(matrix))
        i, j = (int(place) for place in np.unravel_index(np.argmax(difference), (6, 6)))
        if difference[i, j] > _UNSYMMETRIC:
            one, other = f"{AXES[i]} by {AXES[j]}", f"{AXES[j]} by {AXES[i]}"
            share = f"{100 * difference[i, j]:.3g} % of the diagonal"
            sentence = (
                f"{self.source}: its {what} of {one} and of {other}, the same by nature, differ by {share}"
            )
            if difference[i, j] > _CONTRADICTS:
                raise DatabaseError(f"{sentence}; another period may be better")
            doubts.append(f"{sentence}; their mean is taken")
        return self.not_negative((matrix + matrix.T) / 2, what, doubts)

    def not_negative(self, matrix: Array, what: str, doubts: list[str]) -> tuple[Array, list[str]]:
        """A symmetric matrix with small negative eigenvalues, which a body would be driven by, set to zero.

        Args:
            matrix: (6, 6).
            what: it is, in words.
            doubts: sentences so far.

        Returns:
            the matrix; the sentences, with one on this where it is no rounding.

        Raises:
            DatabaseError: if they are not small.
        """
        scale = _scale(matrix)
        values, vectors = np.linalg.eigh(matrix / np.outer(scale, scale))
        least = float(values[0])
        if least >= -1e-12:
            return matrix, doubts
        if least < -_NEGATIVE * float(values[-1]):
            share = f"{100 * -least / float(values[-1]):.3g} % of the largest"
            if self.others and what == "added mass":
                swings = f"a motion whose added mass is below zero, by {share}, as water that swings beside "
                instead = f"{', '.join(self.others)} makes it; 'radiation' or another period can have it"
                raise DatabaseError(f"{self.source}: {swings}{instead}")
            gains = f"its {what} has a motion that gains energy from the water, {share}"
            raise DatabaseError(f"{self.source}: {gains}; another period may be better")
        if least < -1e-6 * float(values[-1]):
            share = f"{-100 * least / float(values[-1]):.2g} % of the largest"
            doubts.append(f"{self.source}: a motion whose {what} is below zero, by {share}, is set to zero")
        mended = (vectors * np.maximum(values, 0.0)) @ vectors.T * np.outer(scale, scale)
        return (mended + mended.T) / 2, doubts


def turn_about_z(heading: float) -> Array:
    """Of surge to yaw along axes into those along others (6, 6), whose x has this direction [rad]."""
    cos, sin = math.cos(heading), math.sin(heading)
    turn = np.zeros((6, 6))
    turn[:3, :3] = turn[3:, 3:] = [[cos, sin, 0.0], [-sin, cos, 0.0], [0.0, 0.0, 1.0]]
    return turn


def _scale(matrix: Array) -> Array:
    """Roots of the largest diagonal terms of shifts and turns, by motion (6,): they make all terms alike."""
    shift, turn = (float(np.abs(np.diag(matrix)[part]).max()) for part in (slice(0, 3), slice(3, 6)))
    scale: Array = np.sqrt(np.repeat([shift or turn or 1.0, turn or shift or 1.0], 3))
    return scale


def _asymmetry(matrix: Array) -> float:
    return float(np.max(np.abs(matrix - matrix.T) / np.outer(_scale(matrix), _scale(matrix))))
