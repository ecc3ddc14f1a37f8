"""What a recording says of how sound its run was: status, energy balance, residuals. Nothing is guessed.

*Energy from nowhere* is what the audit's columns show directly: kinetic + gravity + elastic energy less the
work of drives, and of wind, current and waves, can only fall, since every loss is positive. By how much it
rises above the least that it has had, relative to the largest of kinetic + elastic + |work|, is energy that
none of them put in. A method that shakes a stiff rope or feeds a swing shows it here, whatever the frequency.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from gantline.results.metrics import energy_bound
from gantline.results.recording import Recording
from gantline.results.variable import FloatArray
from gantline.units import format_by_size

#: Energy from nowhere up to which a run counts as stable, of the largest energy [1]. It is wider than the
#: bound of the remainder, which leaves out what the method itself takes or gives within its tolerances.
ENERGY_GAIN_BOUND = 1e-3
#: Energy of what stands still [J]: a kilogram has it at a thousandth of a millimetre per second. What joints
#: alone hold at rest has less, made of rounding, and none of that is a gain.
STILL = 1e-12


@dataclass(frozen=True)
class Failure:
    """Why a run could not go on.

    Attributes:
        time: Simulated time [s].
        element: The rope, body or contact at which it failed; empty if it belongs to none.
        cause: What failed, in one sentence.
    """

    time: float
    element: str
    cause: str


@dataclass(frozen=True)
class Stability:
    """How sound a run was.

    Attributes:
        status: `done`, `paused`, `running`, `stopped` or `failed`; of an equilibrium, that it is at rest and
            when.
        end: When it ended, which is its last sample [s]; None without samples.
        failure: Why it could not go on; None if it could, or if an old recording does not tell.
        energy_remainder: Largest energy that the audit cannot place, of the largest energy [1]; None if not
            kept.
        energy_bound: Remainder up to which the balance counts as closed [1].
        energy_gain: Largest energy from nowhere, of the largest energy [1]; None if energy was not recorded.
        energy_gain_time: When it first passes `ENERGY_GAIN_BOUND` [s]; None if it does not.
        complementarity_residual: Largest distance of a force from its law over the samples [N].
        constraint_residual: Largest excess length of an inextensible rope over the samples [m].
        unconverged: Steps that ended before it was settled which ropes and contacts carry.
        is_at_rest: Whether it is an equilibrium, which has neither steps nor a balance.
    """

    status: str
    end: float | None
    failure: Failure | None
    energy_remainder: float | None
    energy_bound: float
    energy_gain: float | None
    energy_gain_time: float | None
    complementarity_residual: float | None
    constraint_residual: float | None
    unconverged: int
    is_at_rest: bool = False

    @property
    def is_sound(self) -> bool:
        """Whether it reached its end, its balance closes, it gained no energy and all its steps settled."""
        remainder = self.energy_remainder or 0.0
        return (
            (self.status == "done" or self.is_at_rest)
            and remainder <= self.energy_bound
            and self.energy_gain_time is None
            and self.unconverged == 0
        )

    def sentences(self) -> Iterator[str]:
        """The same in plain words; what is not as it should be is in capitals."""
        yield self._how_it_ended()
        if self.energy_remainder is not None:
            closes = self.energy_remainder <= self.energy_bound
            verdict = "the balance closes" if closes else "THE BALANCE DOES NOT CLOSE"
            yield f"energy remainder {self.energy_remainder:.1e}, bound {self.energy_bound:.0e}: {verdict}"
        if self.energy_gain_time is not None:
            share = f"{100 * (self.energy_gain or 0.0):.3g} % of the largest energy"
            yield f"GAINS ENERGY from {self.energy_gain_time:.2f} s on: up to {share} comes from no drive"
        elif self.energy_gain is not None:
            yield f"no energy from nowhere beyond {100 * ENERGY_GAIN_BOUND:g} % of the largest energy"
        if self.complementarity_residual is not None:
            yield f"forces keep their laws to {format_by_size(self.complementarity_residual, 'force', 2)}"
        if self.constraint_residual:
            yield f"inextensible ropes keep their length to {self.constraint_residual:.2g} m"
        if self.unconverged:
            yield f"{self.unconverged} STEPS NOT SETTLED: which ropes and contacts carry was left open"

    def _how_it_ended(self) -> str:
        if self.status == "done":
            return f"ran to its end, {self.end:g} s" if self.end is not None else "ran to its end"
        if self.is_at_rest:
            return self.status
        reached = "before its first sample" if self.end is None else f"at {self.end:.2f} s"
        if self.status != "failed":
            return f"{self.status.upper()} {reached}: what follows compares what there is"
        if self.failure is None:
            return f"FAILED {reached}; the recording does not tell the cause"
        place = f" at {self.failure.element}" if self.failure.element else ""
        return f"FAILED at {self.failure.time:.3f} s{place}: {self.failure.cause}"


def stability_of(recording: Recording) -> Stability:
    """How sound the run of a recording was.

    Args:
        recording: Any recording, also of a run that failed.
    """
    attributes = recording.attributes
    # An equilibrium is found, and its first sample is where the lift starts: no motion leads there.
    at_rest = recording.is_equilibrium and str(attributes.get("status", "done")) != "done"
    gain, since = (None, None) if at_rest else _energy_gain(recording)
    remainder = attributes.get("energy_remainder")
    return Stability(
        status=str(attributes.get("status", "done")),
        end=float(recording.time[-1]) if len(recording.time) else None,
        failure=failure_of(recording),
        energy_remainder=None if remainder is None else float(remainder),
        energy_bound=energy_bound(attributes["settings"]),
        energy_gain=gain,
        energy_gain_time=since,
        complementarity_residual=_largest(recording, "residual_complementarity"),
        constraint_residual=_largest(recording, "residual_constraint"),
        unconverged=int((attributes.get("counters") or {}).get("unconverged", 0)),
        is_at_rest=at_rest,
    )


def failure_of(recording: Recording) -> Failure | None:
    """Why a run could not go on; None if it could, or if an old recording does not tell."""
    document = recording.attributes.get("failure")
    if not document:
        return None
    return Failure(float(document["time"]), str(document["element"]), str(document["cause"]))


def _energy_gain(recording: Recording) -> tuple[float | None, float | None]:
    if "energy" not in recording or not len(recording.time):
        return None, None
    kinds = recording.coordinates["energy_kind"]
    return energy_gain(recording["energy"].values, kinds, recording.time, ENERGY_GAIN_BOUND)


def energy_gain(
    energy: FloatArray, kinds: Sequence[str], time: FloatArray, bound: float
) -> tuple[float, float | None]:
    """Energy from nowhere, of the largest energy, and when it passed a bound [s]; None if it did not.

    Args:
        energy: Recorded energies, shape (samples, kinds) [J].
        kinds: What they are, as in a recording.
        time: Of the samples, at least one [s].
        bound: That of the gain [1].
    """
    of_kind = dict(zip(kinds, energy.T, strict=True))
    works = [of_kind[kind] for kind in ("drive_work", "fluid_work") if kind in of_kind]
    largest = float(np.max(of_kind["kinetic"] + of_kind["elastic"] + np.sum(np.abs(works), axis=0)))
    if largest <= STILL:
        return 0.0, None
    stored = [of_kind[kind] for kind in ("kinetic", "gravity", "elastic", "fluid") if kind in of_kind]
    kept = np.sum(stored, axis=0) - np.sum(works, axis=0)
    gain = (kept - np.minimum.accumulate(kept)) / largest
    beyond = np.flatnonzero(gain > bound)
    return float(gain.max()), float(time[beyond[0]]) if beyond.size else None


def _largest(recording: Recording, name: str) -> float | None:
    if name not in recording or not recording[name].values.size:
        return None
    return float(recording[name].values.max())
