"""How far what a lift is checked for moves where its method is finer: the method's own error.

`gantline.study.refined` leaves in the recording what is read here.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from gantline.results.recording import Recording, recorded
from gantline.units import format_quantity

__all__ = ["Apart", "Figure", "Refinement", "refinement_of"]

#: Decimals beyond those with which people read a figure; what does not show in them is rounding.
_FURTHER = 2
#: Nobody asks for less [%].
_LEAST_SHOWN = 1e-3
#: A distance below which nobody asks of which body it is [m].
_LEAST_APART = 1e-4
#: Figures that are told one by one.
_MOST_TOLD = 3


@dataclass(frozen=True)
class Figure:
    """What a check came to in both runs.

    Attributes:
        name: Key of the limit.
        element: What governs it as run.
        value: As run [SI].
        finer: In the finer run [SI].
        limit: What it is held against [SI]; None if nothing is.
        unit: Unit in which people read it.
        digits: Decimals with which people read it.
        at_least: Whether the limit is the smallest allowed value, not the largest.
        step: Step of the plan whose end was checked; empty for the whole lift.
    """

    name: str
    element: str
    value: float
    finer: float
    limit: float | None
    unit: str
    digits: int
    at_least: bool = False
    step: str = ""

    @property
    def moved(self) -> float:
        """By how much its share of the limit moved, or its value where it has no limit, of the larger [1]."""
        apart = abs(self.finer - self.value)
        if not float(self.shown(apart).split()[0]):
            return 0.0
        if self.is_of_limit:
            assert self.limit is not None
            if self.at_least:
                return abs(self.limit / self.finer - self.limit / self.value)
            return apart / self.limit
        return apart / max(abs(self.value), abs(self.finer))

    @property
    def is_of_limit(self) -> bool:
        """Whether it uses some of a limit; a margin that is used up may be as far below it as it likes."""
        is_left = not self.at_least or min(self.value, self.finer) > 0.0
        return self.limit is not None and self.limit > 0.0 and is_left

    def shown(self, value: float) -> str:
        """A value in its unit, with enough decimals to show what moves."""
        return format_quantity(value, self.unit, self.digits + _FURTHER)


@dataclass(frozen=True)
class Apart:
    """Where a body is farthest from where it is in the finer run.

    Attributes:
        body: Its name.
        distance: Of its centre of gravity in both runs [m].
        time: When that is [s].
    """

    body: str
    distance: float
    time: float

    @property
    def sentence(self) -> str:
        """How far places of bodies differ, and where and when most."""
        if self.distance < _LEAST_APART:
            return f"places of bodies differ by less than {format_quantity(_LEAST_APART, 'mm', 1)}"
        unit, digits = ("mm", 1) if self.distance < 1.0 else ("m", 2)
        far, when = format_quantity(self.distance, unit, digits), format_quantity(self.time, "s", 1)
        return f"places of bodies differ by up to {far}, that of {self.body} at {when}"


@dataclass(frozen=True)
class Refinement:
    """A lift as run beside the same with a finer method.

    Attributes:
        settings: What the finer run had: `tension_tolerance` [N] and `position_tolerance` [m], or `step` [s].
        figures: What was checked.
        verdicts: Checks that came out otherwise, each in words.
        tension: Largest of the ropes' rms differences over the lift, of its largest tension [1]; None without
            ropes.
        lift_off: By how much later the loads came clear [s]; None where they did not in both.
        apart: The body that is farthest from where it is in the finer run; None without bodies that move.
    """

    settings: Mapping[str, float]
    figures: Sequence[Figure]
    verdicts: Sequence[str]
    tension: float | None = None
    lift_off: float | None = None
    apart: Apart | None = None

    @property
    def told(self) -> list[Figure]:
        """The figures that moved most, most first."""
        moved = [one for one in self.figures if one.moved > 0.0]
        return sorted(moved, key=lambda one: -one.moved)[:_MOST_TOLD]

    @property
    def moved(self) -> float:
        """By how much the figure moved that moved most, see `Figure.moved` [1]."""
        return max((one.moved for one in self.figures), default=0.0)

    @property
    def how(self) -> str:
        """What was finer, in words."""
        if "step" in self.settings:
            return f"steps a quarter as long ({1e3 * self.settings['step']:.3g} ms)"
        force, length = self.settings["tension_tolerance"], 1e3 * self.settings["position_tolerance"]
        return f"tolerances a tenth ({force:.3g} N, {length:.3g} mm)"

    def sentences(self) -> Iterator[str]:
        """What there is to say beside the figures of `told`."""
        others = len(self.figures) - len(self.told)
        many = "" if others == 1 else "s"
        verb = ("differs" if others == 1 else "differ") if self.told else "is" if others == 1 else "are"
        what = f"other figure{many}" if self.told else f"figure{many}"
        rest = f" {others} {what} {verb} {'by less' if self.told else 'the same'}"
        yield f"with {self.how}" + (rest if others else "")
        if self.lift_off is not None:
            apart = format_quantity(abs(self.lift_off), "ms", 1)
            how = "later" if self.lift_off > 0.0 else "earlier"
            yield f"loads come clear {f'{apart} {how}' if float(apart.split()[0]) else 'at the same time'}"
        if self.tension is not None:
            yield f"tensions of ropes differ by {in_per_cent(self.tension)} rms of their largest"
        if self.apart is not None:
            yield self.apart.sentence


def in_per_cent(share: float) -> str:
    """A small share with the digits that it has."""
    percent = 100.0 * share
    if percent < _LEAST_SHOWN:
        return f"less than {_LEAST_SHOWN:g} %"
    return f"{percent:.0f} %" if percent >= 10.0 else f"{percent:.2g} %"


def refinement_of(recording: Recording) -> Refinement | None:
    """What a recording says of its finer run; None of one that has had none."""
    said: Mapping[str, Any] | None = recorded(recording).attributes.get("refinement")
    if said is None:
        return None
    apart = said.get("apart")
    return Refinement(
        **{
            **said,
            "figures": [Figure(**one) for one in said["figures"]],
            "apart": None if apart is None else Apart(**apart),
        }
    )
