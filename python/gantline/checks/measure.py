"""What can be checked: a measure gives everything that its limit is held against, and what it cannot tell."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass

import numpy as np

from gantline.results import series
from gantline.results.alike import ROUNDING, first_peak
from gantline.results.recording import Recording
from gantline.results.variable import BoolArray, FloatArray

#: Most elements that a remark names.
_MOST_NAMED = 3


@dataclass(frozen=True)
class Found:
    """A value that a limit is held against.

    Attributes:
        value: SI.
        element: What it belongs to.
        time: When [s]; None if it belongs to no one time.
        formula: How it comes about, with numbers; empty if it was measured as it is.
        factors: Names of the rule's factors in it.
        between: What it may have come to between two samples, where that is worse, SI; None where it is not.
        at_design: What it comes to with the design weight, where that is known and worse, SI; None where not.
        with_losses: What it comes to with sheaves that take what sheaves take as a rule, SI, where nothing
            says what they do; None where something does.
    """

    value: float
    element: str
    time: float | None = None
    formula: str = ""
    factors: tuple[str, ...] = ()
    between: float | None = None
    at_design: float | None = None
    with_losses: float | None = None


@dataclass(frozen=True)
class Missing:
    """An element that cannot be checked.

    Attributes:
        element: Its name.
        reason: What is not known, or why it has no value.
        is_strength: Whether what it may bear is not known, which the lift file could say.
    """

    element: str
    reason: str
    is_strength: bool = False


@dataclass(frozen=True)
class Refused:
    """An element that fails whatever the limit: what happens to it is not allowed at all.

    Attributes:
        element: Its name.
        reason: What is not allowed.
        found: What it came to when that happened; None where that is no number.
    """

    element: str
    reason: str
    found: Found | None = None


@dataclass(frozen=True)
class Caution:
    """Something to warn of even within the limit.

    Attributes:
        text: What it is.
    """

    text: str


Finding = Found | Missing | Refused | Caution
Findings = Callable[[Recording, BoolArray], Iterator[Finding]]


@dataclass(frozen=True)
class Alarm:
    """A bound past which nothing goes without a word where nobody set a limit; no limit of any rule.

    Attributes:
        value: SI, of an element of a recording.
        source: Where it comes from, or why it is sensible.
    """

    value: Callable[[Recording, str], float]
    source: str


@dataclass(frozen=True)
class Measure:
    """One quantity that a limit can be set for.

    Attributes:
        meaning: What is compared with what, in words.
        unit: Unit in which people read it.
        digits: Decimals with which people read it.
        findings: Gives the values within a mask of samples.
        at_least: Whether the limit is the smallest allowed value, not the largest.
        when_clear: Whether only samples count at which the loads are clear of their supports.
        warns_up_to: A value over the limit but not over this one is a warning; over this one it
            fails, whatever the limit. None of what `at_least` is asked for.
        by_definition: Limit that holds where nobody sets one, such as all of a rated capacity.
        definition: Where that limit comes from.
        is_listed: Whether it stands in the table without a limit too.
        alarm: Where nobody sets a limit, a value past that of its element warns; one within it is as without
            it. What is not listed stands in the table then.
    """

    meaning: str
    unit: str
    digits: int
    findings: Findings
    at_least: bool = False
    when_clear: bool = False
    warns_up_to: float | None = None
    by_definition: float | None = None
    definition: str = ""
    is_listed: bool = False
    alarm: Alarm | None = None


def extreme(
    recording: Recording,
    values: FloatArray,
    during: BoolArray,
    element: str,
    formula: Callable[[int], str] | None = None,
    *,
    smallest: bool = False,
    alike: float = 0.0,
) -> Iterator[Found]:
    """The largest (or smallest) of a series within a mask, when it first is so; nothing if the mask is empty.

    Args:
        recording: The recording.
        values: Shape (time,).
        during: Mask of samples.
        element: What they belong to.
        formula: The formula at a sample, if it needs more than the value.
        smallest: Whether the smallest is looked for.
        alike: What of it is no difference, in the unit of the values: of a series that stays where it has
            come to but for some ringing, when it came there.
    """
    if not during.any():
        return
    upwards = -values if smallest else values
    within = np.where(during, upwards, -np.inf)
    most = float(within.max())
    # Of a peak that is no more than what is alike the formula would be that of where there is none yet.
    near = min(alike, max(0.1 * abs(most), ROUNDING))
    at = int(np.argmax(within >= most - near)) if alike else first_peak(within)
    text = formula(at) if formula is not None else ""
    highest = crest(recording.time, upwards, during)
    between = None if highest is None or not highest > most else -highest if smallest else highest
    value = -most if smallest else most
    yield Found(value, element, float(recording.time[at]), text, between=between)


def crest(time: FloatArray, values: FloatArray, during: BoolArray) -> float | None:
    """The highest vertex of a parabola through a sample and its two neighbours, all of them in a mask.

    Of samples that are no lower than their neighbours, which the vertex then lies between. A parabola is what
    a smooth series is about its crest; past a kink it goes by no more than an eighth of the bend there. What
    comes to rest has no crest there: the parabola about the higher neighbour goes no higher than the sample.

    With b and c the slope and half the bend of the parabola at the sample it goes b²/(-4c) higher than that.
    The last sample of a run may be nearer to the one before than others are.
    """
    if np.count_nonzero(during) < 3:
        return None
    vertices = values.copy()
    apart = np.diff(time)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        slopes = np.diff(values) / apart
        half_bend = np.diff(slopes) / (apart[:-1] + apart[1:])
        slope = (slopes[:-1] * apart[1:] + slopes[1:] * apart[:-1]) / (apart[:-1] + apart[1:])
    before, here, after = values[:-2], values[1:-1], values[2:]
    is_round = np.isfinite(half_bend) & (half_bend < 0.0)
    vertices[1:-1][is_round] -= slope[is_round] ** 2 / (4.0 * half_bend[is_round])
    # At the ends there is no neighbour's parabola.
    vertices[[0, -1]] = np.inf
    higher = np.where(after > before, vertices[2:], vertices[:-2])
    found = vertices[1:-1]
    # Past a kink close to the end the parabola over the longer interval goes by any amount.
    found[-1:] = np.minimum(found[-1:], higher[-1:])
    counts = during[:-2] & during[1:-1] & during[2:] & (here >= before) & (here >= after)
    counts &= is_round & (higher > here)
    return float(found[counts].max()) if counts.any() else None


def to_either_side(
    recording: Recording, variable: str, elements: Iterable[str], during: BoolArray
) -> Iterator[Found]:
    """The largest size of a variable of each of these elements, whichever its sign."""
    for element in elements:
        yield from extreme(recording, np.abs(recording.column(variable, element)), during, element)


def carrying(recording: Recording, rope: str, during: BoolArray) -> BoolArray:
    """Samples of a mask at which a rope carries enough for its direction to mean something, shape (time,)."""
    return during & series.is_carrying(recording.column("rope_tension", rope))


def named(elements: Iterable[str]) -> str:
    """The first few of some names, each once, and how many more there are."""
    names = list(dict.fromkeys(elements))
    more = f" and {len(names) - _MOST_NAMED} more" if len(names) > _MOST_NAMED else ""
    return f"{', '.join(names[:_MOST_NAMED])}{more}"
