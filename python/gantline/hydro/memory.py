"""What water remembers of a body's motion: added mass and damping of all frequencies of a database.

A body in waves that it has made itself is pushed by them until they are gone (Cummins 1962):

    F(t) = -A(∞) v̇(t) - ∫ K(s) v(t - s) ds        B(ω) + iω (A(ω) - A(∞)) = ∫ K(s) exp(-iωs) ds

K is taken as a sum of what answers like a damped oscillator to its velocity,

    ∫ K(s) exp(-iωs) ds = Σ C_j iω/(ω_j² - ω² + 2i ζ_j ω_j ω)

each with a matrix C_j that is symmetric and has no negative eigenvalue. No such sum ever gives a body energy
in the whole, or damps a motion that has no end. ω_j and ζ_j come from a grid, C_j by least squares: first for
each motion by itself, without negative terms (Lawson and Hanson 1974), then for all together by the
alternating direction method of multipliers (Boyd and others 2011). See docs/concepts/fluid_memory.md.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
import numpy.typing as npt

from gantline.arguments import needed, number
from gantline.hydro.database.model import AXES, Coupling, DatabaseError, HydrodynamicDatabase

__all__ = ["Memory", "Misfit", "fit_memory"]

Array = npt.NDArray[np.float64]

#: Fewer frequencies say too little of what lies between them.
_FEWEST = 8
#: The longest period must be this many times the shortest.
_SPAN = 4.0
#: Oscillators in a factor of ten of frequency, and their damping ratios.
_PER_DECADE = 20
_RATIOS = (0.1, 0.15, 0.2, 0.3, 0.4, 0.6, 0.8, 0.95)
#: Slower than this [rad/s], in two minutes, bodies make no waves to speak of; it is not looked at.
_SLOWEST = 0.05
#: A motion with less damping than this share of the most of shifts, or of turns, makes no waves.
_SILENT = 1e-6
#: Damping below zero in the mean of all frequencies that may be noise, of the most of shifts, or of turns.
_NOISE = 0.01
#: Rounds of the fit of all motions together, before and after terms that add less are left out.
_ROUNDS = (400, 400)
_SMALL = 1e-3
#: Misfit from which on it is said: of the largest damping, or of the whole change of added mass.
_POOR = 0.05
#: The same from which on the file contradicts itself.
_USELESS = 0.3
#: Difference of matrices from their transposes from which on it is said, of the largest of the diagonal.
_UNSYMMETRIC = 0.02


@dataclass(frozen=True)
class Misfit:
    """How far a fit is from its file, over the file's frequencies as if logarithmically spaced.

    Attributes:
        damping: root mean square and largest error of damping, of the largest of the motion.
        added_mass: the same of added mass, of its whole change over the file's frequencies.
        motion: which is worst, of `AXES`, or two of them that go together.
        period: where it is [s].
    """

    damping: tuple[float, float]
    added_mass: tuple[float, float]
    motion: str
    period: float

    @property
    def in_words(self) -> str:
        """Mean errors, and where they are worst."""
        damping, added = (
            f"{100 * share:.0f} %" if share >= 0.1 else f"{100 * share:.2g} %"
            for share in (self.damping[0], self.added_mass[0])
        )
        shares = f"{damping} of the largest damping and {added} of the change of added mass"
        return f"{shares}, most in {self.motion} at {self.period:.4g} s"

    @property
    def mean(self) -> float:
        """The larger of both root mean squares [1]."""
        return max(self.damping[0], self.added_mass[0])


@dataclass(frozen=True)
class Memory:
    """What water remembers of a body's motion about a point, SI units.

    Attributes:
        infinite_added_mass: A(∞) (6, 6) [kg, kg m, kg m^2].
        frequencies: ω_j (n,) [rad/s].
        ratios: ζ_j (n,).
        strengths: C_j (n, 6, 6) [N/m, N, N m].
        misfit: how well it agrees with the file.
        doubts: what is doubtful, a sentence each.
    """

    infinite_added_mass: Array
    frequencies: Array
    ratios: Array
    strengths: Array
    misfit: Misfit
    doubts: tuple[str, ...] = ()

    @property
    def poles(self) -> npt.NDArray[np.complex128]:
        """p_j = -ζω + iω√(1 - ζ²) (n,) [1/s]."""
        poles: npt.NDArray[np.complex128] = self.frequencies * (
            -self.ratios + 1j * np.sqrt(1 - self.ratios**2)
        )
        return poles

    @property
    def residues(self) -> npt.NDArray[np.complex128]:
        """R_j (n, 6, 6) of K(t) = Re Σ R_j exp(p_j t), each term C exp(-at) (cos βt - (a/β) sin βt)."""
        turn = 1 + 1j * self.ratios / np.sqrt(1 - self.ratios**2)
        residues: npt.NDArray[np.complex128] = self.strengths * turn[:, None, None]
        return residues

    def kernel(self, time: Array) -> Array:
        """K (times, 6, 6) [N/m, N, N m] at `time` (times,) [s], from 0 on."""
        terms = np.exp(np.multiply.outer(time, self.poles))
        kernel: Array = np.einsum("tj,jab->tab", terms, self.residues).real
        return kernel

    def _answer(self, frequency: Array) -> npt.NDArray[np.complex128]:
        basis = _oscillators(np.asarray(frequency), self.frequencies, self.ratios)
        answer: npt.NDArray[np.complex128] = np.einsum("wj,jab->wab", basis, self.strengths)
        return answer

    def damping(self, frequency: Array) -> Array:
        """B (n, 6, 6) [N s/m, N s, N m s] at `frequency` (n,) [rad/s]."""
        return self._answer(frequency).real

    def added_mass(self, frequency: Array) -> Array:
        """A (n, 6, 6) [kg, kg m, kg m^2] at `frequency` (n,) above zero [rad/s]."""
        change = self._answer(frequency).imag / np.asarray(frequency)[:, None, None]
        added: Array = self.infinite_added_mass + change
        return added


def fit_memory(database: HydrodynamicDatabase, density: float) -> Memory:
    """What water remembers by a hydrodynamic database.

    Args:
        database: added mass and damping at some frequencies.
        density: of the water that it is wanted for [kg/m^3].

    Raises:
        DatabaseError: if the frequencies are too few, or added mass and damping do not go together.
    """
    right = "gantline.hydro.read_database reads one"
    needed(database, HydrodynamicDatabase, "a hydrodynamic database", right)
    number(density, "density", "kilograms a cubic metre")
    heard = database.frequencies >= _SLOWEST * (1 - 1e-9)
    _check(database, database.frequencies[heard])
    database = replace(
        database,
        frequencies=database.frequencies[heard],
        added_mass=database.added_mass[heard],
        damping=database.damping[heard],
        directions=np.zeros(0),  # waves are none of its memory
        excitation=None,
        drift=None,
        others={
            name: Coupling(*(values[heard] for values in coupling))
            for name, coupling in database.others.items()
        },
    )
    scale, infinite = 1.0, None
    if database.infinite_added_mass is not None:
        infinite, doubts = database.added_mass_at(None, density)
    else:
        doubts = list(database.doubts)
        if database.density is None:
            doubts.append(f"{database.source} does not say for which water; that of the lift is taken")
    if database.density is not None:
        scale = density / database.density
    doubts += database.outlying(None)
    asymmetry = max(map(_asymmetry, (database.added_mass, database.damping)))
    if asymmetry > _UNSYMMETRIC:
        share = f"differ by up to {100 * asymmetry:.2g} % of the largest of the diagonal"
        doubts.append(f"{database.source}: pairs that are the same by nature {share}; their means are taken")
    added, damping = (
        scale * (values + values.transpose(0, 2, 1)) / 2 for values in (database.added_mass, database.damping)
    )
    fit = _Fit(database.frequencies, added, damping, infinite)
    _check_signs(database, fit)
    memory = _solved(fit)
    if infinite is None:
        what = "added mass at infinite frequency"
        infinite, doubts = database.not_negative(memory.infinite_added_mass, what, doubts)
    memory = replace(memory, infinite_added_mass=infinite)
    misfit = _misfit(memory, fit)
    _judge(database, misfit, doubts)
    return replace(memory, misfit=misfit, doubts=tuple(doubts))


def _check(database: HydrodynamicDatabase, frequency: Array) -> None:
    if len(frequency) >= _FEWEST and frequency[-1] >= _SPAN * frequency[0]:
        return
    periods = database.periods
    given = "has one frequency"
    if len(periods) > 1:
        given = f"has {len(periods)} frequencies, periods from {periods[-1]:.4g} to {periods[0]:.4g} s"
    wanted = f"memory needs {_FEWEST} periods below two minutes, the longest {_SPAN:g} times the shortest"
    instead = "'added_mass' and 'water_damping' of one period do with less"
    raise DatabaseError(f"{database.source}: {given}; {wanted}; {instead}")


def _check_signs(database: HydrodynamicDatabase, fit: _Fit) -> None:
    """Damping below zero at some frequencies is noise; over all of them its sign is wrong."""
    mean = np.einsum("w,waa->a", fit.weight**2, fit.damping)
    kinds = np.repeat([np.abs(mean[:3]).max(), np.abs(mean[3:]).max()], 3)
    driven = [f"{axis} ({value:.3g})" for axis, value in zip(AXES, mean, strict=True) if value < 0.0]
    if np.any(mean < -_NOISE * kinds):
        sentence = f"its damping of {', '.join(driven)} is below zero in the mean of all frequencies"
        raise DatabaseError(f"{database.source}: {sentence}, as if water drove; a sign has slipped")
    if not len(fit.loud):
        instead = "'added_mass' of one period is right"
        raise DatabaseError(f"{database.source}: it damps nothing, so water remembers nothing; {instead}")


def _asymmetry(matrices: Array) -> float:
    """Largest difference from the transpose, of the largest that shifts and turns have at any frequency."""
    largest = np.diagonal(matrices, axis1=1, axis2=2).max(axis=0)
    scale = np.sqrt(np.repeat(np.maximum([largest[:3].max(), largest[3:].max()], 1e-300), 3))
    return float(np.max(np.abs(matrices - matrices.transpose(0, 2, 1)) / np.outer(scale, scale)))


def _judge(database: HydrodynamicDatabase, misfit: Misfit, doubts: list[str]) -> None:
    sentence = f"{database.source}: its damping and added mass do not go together as those of one water"
    sentence = f"{sentence}; the nearest that do miss them by {misfit.in_words}"
    if misfit.mean > _USELESS:
        instead = "'added_mass' and 'water_damping' of one period ask for no such thing"
        raise DatabaseError(f"{sentence}; {instead}")
    if misfit.mean > _POOR:
        doubts.append(sentence)


def _oscillators(frequency: Array, own: Array, ratio: Array) -> npt.NDArray[np.complex128]:
    """iω/(ω_j² - ω² + 2iζ_jω_jω), (n, j)."""
    s = 1j * frequency[:, None]
    answers: npt.NDArray[np.complex128] = s / (own**2 + s * (2 * ratio * own + s))
    return answers


class _Fit:
    """The least squares problem, all in shares: of the largest damping, and of the change of added mass."""

    def __init__(self, frequency: Array, added: Array, damping: Array, infinite: Array | None) -> None:
        self.frequency, self.added, self.damping, self.infinite = frequency, added, damping, infinite
        given = (frequency, added, damping, infinite)
        self._given = tuple(None if values is None else values.tobytes() for values in given)
        steps = np.gradient(np.log(frequency))
        #: Weights of frequencies, as if they were logarithmically spaced.
        self.weight = np.sqrt(steps / steps.sum())
        largest = np.diagonal(damping, axis1=1, axis2=2).max(axis=0)
        kinds = np.repeat([largest[:3].max(), largest[3:].max()], 3)
        #: Motions that make waves.
        self.loud = np.flatnonzero(largest > np.maximum(_SILENT * kinds, 0.0))
        self.largest = np.sqrt(np.where(largest > 0, largest, 1.0))
        change = np.ptp(np.diagonal(added, axis1=1, axis2=2), axis=0)
        # (FM2): where anything is damped, added mass changes.
        change = np.maximum(change, largest / frequency[-1])
        self.change = np.sqrt(np.where(change > 0, change, 1.0))

    def __hash__(self) -> int:
        return hash(self._given)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Fit) and other._given == self._given

    def solved(self) -> Memory:
        """The fit."""
        slowest, fastest = self.frequency[0], 1.2 * self.frequency[-1]
        grid = np.geomspace(slowest, fastest, math.ceil(_PER_DECADE * math.log10(fastest / slowest)))
        own, ratio = np.repeat(grid, len(_RATIOS)), np.tile(_RATIOS, len(grid))
        start = np.zeros((len(own), 6))
        for motion in self.loud:
            start[:, motion] = self._alone(own, ratio, int(motion))
        used = start.any(axis=1)
        own, ratio, strengths = own[used], ratio[used], np.einsum("ja,ab->jab", start[used], np.eye(6))
        for rounds in _ROUNDS:
            strengths = self._together(own, ratio, strengths, rounds)
            diagonal = np.diagonal(strengths, axis1=1, axis2=2) / (2 * ratio * own)[:, None]
            kept = (diagonal > _SMALL * self.largest**2).any(axis=1)
            own, ratio, strengths = own[kept], ratio[kept], strengths[kept]
        answer = np.einsum("wj,jab->wab", _oscillators(self.frequency, own, ratio), strengths)
        left = self.added - answer.imag / self.frequency[:, None, None]
        infinite = self.infinite
        if infinite is None:
            infinite = np.einsum("w,wab->ab", self.weight**2, left)
        return Memory(infinite, own, ratio, strengths, Misfit((0, 0), (0, 0), AXES[0], 1.0))

    def _system(self, own: Array, ratio: Array, pair: tuple[int, int]) -> tuple[Array, Array]:
        """Matrix (2n, j) and right side (2n,) for one entry of the matrices; A(∞) taken out."""
        a, b = pair
        answers = _oscillators(self.frequency, own, ratio)
        damped = self.weight / (self.largest[a] * self.largest[b])
        moved = self.weight / (self.change[a] * self.change[b])
        added = self.added[:, a, b]
        masses = answers.imag / self.frequency[:, None]
        if self.infinite is not None:
            added = added - self.infinite[a, b]
        else:
            share = self.weight**2
            added, masses = added - share @ added, masses - share @ masses
        matrix = np.vstack([answers.real * damped[:, None], masses * moved[:, None]])
        return matrix, np.concatenate([self.damping[:, a, b] * damped, added * moved])

    def _alone(self, own: Array, ratio: Array, motion: int) -> Array:
        """Strengths (j,) for one motion by itself."""
        from scipy.optimize import nnls  # takes half a second to load

        matrix, right = self._system(own, ratio, (motion, motion))
        sizes = np.linalg.norm(matrix, axis=0)
        found, _ = nnls(matrix / sizes, right, maxiter=30 * len(own))
        strengths: Array = found / sizes
        return strengths

    def _together(self, own: Array, ratio: Array, start: Array, rounds: int) -> Array:
        """Strengths (j, 6, 6) for all motions, none with a negative eigenvalue."""
        size = self.largest[:, None] * self.largest
        # Unknowns of equal size: the peak that each oscillator gives the damping, of the largest there is.
        peak = 2 * ratio * own
        pairs = [(a, b) for a in self.loud.tolist() for b in self.loud.tolist() if a <= b]
        inverses, rights, weights = [], [], []
        for pair in pairs:
            matrix, right = self._system(own, ratio, pair)
            matrix = matrix * (peak * size[pair])
            normal = matrix.T @ matrix
            weights.append(np.trace(normal) / len(own))
            inverses.append(np.linalg.inv(normal + weights[-1] * np.eye(len(own))))
            rights.append(matrix.T @ right)
        solve, right, weight = np.array(inverses), np.array(rights), np.array(weights)[:, None]
        rows, columns = np.array(pairs).T
        inside = start / (peak[:, None, None] * size)
        apart, free = np.zeros_like(inside), np.zeros_like(inside)
        for _ in range(rounds):
            wanted = right + weight * (inside - apart)[:, rows, columns].T
            free[:, rows, columns] = (solve @ wanted[:, :, None])[:, :, 0].T
            free[:, columns, rows] = free[:, rows, columns]
            values, vectors = np.linalg.eigh(free + apart)
            inside = (vectors * np.maximum(values, 0.0)[:, None, :]) @ vectors.transpose(0, 2, 1)
            apart += free - inside
        strengths: Array = inside * peak[:, None, None] * size
        return strengths


@lru_cache(maxsize=8)
def _solved(fit: _Fit) -> Memory:
    """The fit, made once of the same numbers, in whichever files: lifts that are compared have copies."""
    return fit.solved()


def _misfit(memory: Memory, fit: _Fit) -> Misfit:
    errors = [
        np.abs(by_fit - given) / np.outer(size, size)
        for by_fit, given, size in (
            (memory.damping(fit.frequency), fit.damping, fit.largest),
            (memory.added_mass(fit.frequency), fit.added, fit.change),
        )
    ]
    damped, moved = (error[:, fit.loud][:, :, fit.loud] for error in errors)
    means = [np.sqrt(np.einsum("w,wab->ab", fit.weight**2, error**2)) for error in (damped, moved)]
    both = np.maximum(*means)
    a, b = (int(place) for place in np.unravel_index(np.argmax(both), both.shape))
    at = int(np.argmax(np.maximum(damped, moved)[:, a, b]))
    one, other = AXES[int(fit.loud[a])], AXES[int(fit.loud[b])]
    return Misfit(
        (float(means[0].max()), float(damped.max())),
        (float(means[1].max()), float(moved.max())),
        one if one == other else f"{one} by {other}",
        float(2 * np.pi / fit.frequency[at]),
    )
