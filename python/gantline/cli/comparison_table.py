"""The comparison of two lifts as a table, A beside B."""

from __future__ import annotations

import textwrap
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial

from gantline.cli.table import ABSENT, show, table
from gantline.results.alike import without_rounding
from gantline.results.common_time import Deviation
from gantline.results.comparison import (
    Comparison,
    Difference,
    ForceComparison,
    MotionComparison,
    method_of,
    peak_sling,
    tolerances_of,
)
from gantline.results.recording import Recording
from gantline.results.stability import Stability
from gantline.units import quantity

_Row = tuple[str, ...]
_Writer = Callable[[float, str], str]

#: Metrics of the table: name, what it is called, unit, decimals. Each says of which kind of thing it is; of
#: several the largest is shown, of `final_load_transferred` the smallest.
_HEADLINES = (
    ("peak_sling_tension", "peak sling tension", "kN", 1),
    ("peak_sling_tension_time", "at", "s", 2),
    ("peak_equalizing_rope_tension", "peak equalizing rope tension", "kN", 1),
    ("peak_tension_spread_when_clear", "tension spread of an equalizer when clear", "%", 2),
    ("final_tension_spread", "tension spread of an equalizer at the end", "%", 2),
    ("skew_load_factor", "skew load factor of a sling", "", 3),
    ("dynamic_amplification_factor", "dynamic amplification factor of a sling", "", 3),
    ("static_hook_load", "static hook load", "kN", 1),
    ("peak_hook_load", "peak hook load", "kN", 1),
    ("lift_off_time", "lift-off at", "s", 2),
    ("final_load_transferred", "load transferred at the end", "%", 1),
    ("travel_used_up", "travel of a moving sheave up, of stroke", "%", 1),
    ("travel_used_down", "travel of a moving sheave down, of stroke", "%", 1),
    ("peak_equalizer_tilt", "tilt of an equalizer's frame", "deg", 2),
    ("peak_load_tilt", "tilt of a load", "deg", 2),
    ("peak_load_yaw", "yaw of a load", "deg", 2),
    ("peak_load_drift_when_clear", "drift of a load when clear", "m", 3),
)
#: The bound of `gantline.results.alike`, in words.
_ROUNDING = "Differences of no more than 1e-9 of a value, 1 mN of kN, 1 nm, 1 ns or 1 nrad are rounding"
#: Ways in mm from which on digits do not tell them any more; they are written in m.
_FAR = 1e5
#: Columns of text of a verdict.
_WIDTH = 100
_COUNTS = (("steps", "steps"), ("rejected", "attempts rejected"))
_ONLY = {
    "sling": "slings",
    "equalizer": "equalizers",
    "hook": "hooks",
    "hinge": "hinges",
    "load": "loads",
    "rope": "ropes",
    "body": "bodies",
}


def comparison_table(
    comparison: Comparison,
    integration_times: tuple[float | None, float | None],
    verdicts: tuple[str, str] = ("", ""),
) -> list[str]:
    """Lines of the table.

    Args:
        comparison: What is shown.
        integration_times: Wall time in the integrator of A and B [s]; None where nothing was simulated.
        verdicts: On A and B by the limits of their lift files; empty for none.

    Returns:
        The lines.
    """
    parts = [
        [f"{letter}  {name}" for letter, name in zip("AB", comparison.names, strict=True)],
        _verdicts(verdicts),
        _parted(comparison),
        _headlines(comparison),
        _run(comparison, Difference(*integration_times)),
        _forces("Rope", comparison.ropes),
        _forces("Hook load", comparison.hooks),
        _forces("Hinge force", comparison.hinges),
        _motion(comparison),
        _only(comparison),
        _stability(comparison),
    ]
    return [line for part in parts if part for line in (*part, "")][:-1]


def _verdicts(verdicts: tuple[str, str]) -> list[str]:
    """Go or no-go of A and of B."""
    lines = []
    for letter, verdict in zip("AB", verdicts, strict=True):
        lines += textwrap.wrap(
            verdict, _WIDTH, initial_indent=f"  {letter}  ", subsequent_indent=" " * 5, break_on_hyphens=False
        )
    return ["Verdict", *lines] if lines else []


def _parted(comparison: Comparison) -> list[str]:
    """Ropes that were cut, broke or were taken off in A or in B."""
    rows = [
        (letter, one.rope, one.kind, show(one.time, "s", 3), show(one.tension, "kN", 1))
        for letter, parted in zip("AB", comparison.parted, strict=True)
        for one in parted
    ]
    return table(("Parted or off", "", "", "at", "tension"), rows, "lllrr") if rows else []


def _headlines(comparison: Comparison) -> list[str]:
    rows: list[_Row] = []
    for name, title, unit, digits in _HEADLINES:
        if name not in comparison.metrics:
            continue
        value = comparison.metrics[name]
        title, a, b, absolute, relative = _row(title, value, unit, partial(show, unit=unit, digits=digits))
        # Of what rounds to zero a share says nothing.
        is_nothing = value.a is not None and show(abs(value.a), unit, digits) == show(0.0, unit, digits)
        rows.append((title, a, b, absolute, ABSENT if is_nothing and value.absolute else relative))
        if name == "peak_sling_tension":
            slings = (peak_sling(comparison.a), peak_sling(comparison.b))
            rows.append(("in sling", *(sling or ABSENT for sling in slings), "", ""))
    return table(("Lift", "A", "B", "B - A", "of A"), rows, "lrrrr") if rows else []


def _tolerances(a: Recording, b: Recording) -> Iterator[_Row]:
    """What the error of a step might be, where one of them was told."""
    kinds = (("tension tolerance", "N", 2), ("position tolerance", "mm", 3))
    for (title, unit, digits), *both in zip(kinds, tolerances_of(a), tolerances_of(b), strict=True):
        if any(both):
            yield title, *(show(one, unit, digits) if one else ABSENT for one in both), "", ""


def _run(comparison: Comparison, integration: Difference) -> list[str]:
    a, b = comparison.a, comparison.b
    sides = comparison.stability
    rows: list[_Row] = [
        ("method", *(method_of(one, with_tolerances=False) for one in (a, b)), "", ""),
        *_tolerances(a, b),
        ("status", sides[0].status, sides[1].status, "", ""),
        _row("simulated", Difference(*_simulated(sides)), "s", lambda v: show(v, "s", 2)),
    ]
    for name, title in _COUNTS:
        if name in comparison.counters:
            rows.append(_row(title, comparison.counters[name], "", lambda v: f"{int(v):,}"))
    rows.append(_row("time in the integrator", integration, "s", lambda v: _plain(v, "s")))
    remainder = Difference(sides[0].energy_remainder, sides[1].energy_remainder)
    rows.append((*_row("energy remainder", remainder, "", lambda v: f"{v:.1e}")[:3], "", ""))
    rows.append(("its bound", *(f"{side.energy_bound:.0e}" for side in sides), "", ""))
    residual = Difference(sides[0].complementarity_residual, sides[1].complementarity_residual)
    rows.append((*_row("complementarity residual", residual, "N", lambda v: f"{v:.2g} N")[:3], "", ""))
    return table(("Run", "A", "B", "B - A", "of A"), rows, "lrrrr")


def _simulated(sides: Iterable[Stability]) -> Iterator[float | None]:
    """Until when each was simulated [s]; an equilibrium was not."""
    return (None if side.is_at_rest else side.end for side in sides)


def _row(title: str, value: Difference, unit: str, write: Callable[[float], str]) -> _Row:
    a, b = (ABSENT if one is None else write(one) for one in (value.a, value.b))
    if _is_rounding(value, unit):
        return title, a, b, _signed(0.0, unit), _signed(0.0, "%")
    return title, a, b, _signed(value.absolute, unit), _signed(value.relative, "%")


def _is_rounding(value: Difference, unit: str) -> bool:
    """Whether two values that are not the same differ by rounding alone."""
    if value.a is None or value.b is None or not value.absolute:
        return False
    return without_rounding(value.absolute, max(abs(value.a), abs(value.b)), unit) == 0.0


def _deviation(deviation: Deviation | None, scale: float, unit: str, write: _Writer) -> _Row:
    """What is written of a deviation: its mean square, its largest value and when that is.

    Args:
        deviation: Over the common times, or None.
        scale: The largest value that it is one of [SI].
        unit: Unit of the table.
        write: How the largest value is written.
    """
    if deviation is None:
        return ABSENT, ABSENT, ABSENT
    if without_rounding(deviation.largest, scale, unit) == 0.0:
        return _plain(0.0, unit), write(0.0, unit), ABSENT
    return _plain(deviation.rms, unit), write(deviation.largest, unit), show(deviation.time, "s", 2)


def _has_rounding(comparison: Comparison) -> bool:
    """Whether anything of the table is 0 that differs by rounding."""
    metrics = (
        _is_rounding(comparison.metrics[name], unit)
        for name, _, unit, _ in _HEADLINES
        if name in comparison.metrics
    )
    peaks = ((one.deviation, _largest(one)) for one in _all_forces(comparison))
    forces = ((one, largest, _unit_of(largest)) for one, largest in peaks)
    motions = ((of, 0.0, unit) for one in _shown_motions(comparison) for of, unit in _parts(one))
    deviations = (
        one is not None and one.largest != 0.0 and without_rounding(one.largest, scale, unit) == 0.0
        for one, scale, unit in (*forces, *motions)
    )
    return any(metrics) or any(deviations)


def _all_forces(comparison: Comparison) -> Sequence[ForceComparison]:
    return (*comparison.ropes, *comparison.hooks, *comparison.hinges)


def _largest(force: ForceComparison) -> float:
    return max(abs(force.peak_a.value), abs(force.peak_b.value))


def _unit_of(largest: float) -> str:
    """In which a force is written [N]."""
    return "kN" if largest >= 1e3 else "N"


def _parts(motion: MotionComparison) -> Sequence[tuple[Deviation | None, str]]:
    """How a body is apart, and how it is turned, with the units in which the table has that."""
    return (motion.position, "mm"), (motion.attitude, "deg")


def _signed(value: float | None, unit: str) -> str:
    """A difference with its sign and three digits, in a unit; no unit for pure numbers."""
    if value is None:
        return ABSENT
    number = value / quantity(f"1 {unit}", _DIMENSION[unit]) if unit else value
    if unit == "mm" and abs(number) >= _FAR:
        return _signed(value, "m")
    if number == 0.0:
        return f"0 {unit}".strip()
    if abs(number) >= 1e5 or abs(number) < 1e-4:
        return f"{number:+.1e} {unit}".strip()
    written = f"{number:+,.0f}" if abs(number) >= 100.0 else f"{number:+.3g}"
    return f"{written} {unit}".strip()


_DIMENSION = {
    "kN": "force",
    "N": "force",
    "s": "time",
    "m": "length",
    "mm": "length",
    "deg": "angle",
    "%": "ratio",
}


def _forces(title: str, forces: Sequence[ForceComparison]) -> list[str]:
    rows = []
    for force in forces:
        largest = _largest(force)
        unit = _unit_of(largest)
        digits = 1 if unit == "kN" else 3
        rows.append(
            (
                _both(force.name, force.name_b),
                show(force.peak_a.value, unit, digits),
                show(force.peak_a.time, "s", 2),
                show(force.peak_b.value, unit, digits),
                show(force.peak_b.time, "s", 2),
                *_deviation(force.deviation, largest, unit, _signed),
            )
        )
    head = (title, "peak of A", "at", "peak of B", "at", "B - A: rms", "largest", "at")
    return table(head, rows, "lrrrrrrr") if rows else []


def _motion(comparison: Comparison) -> list[str]:
    rows = []
    for one in _shown_motions(comparison):
        cells = (cell for of, unit in _parts(one) for cell in _deviation(of, 0.0, unit, _plain))
        rows.append((_both(one.name, one.name_b), *cells))
    title = "Motion of the load" if comparison.loads else "Motion"
    head = (title, "apart: rms", "largest", "at", "turned: rms", "largest", "at")
    return table(head, rows, "lrrrrrr") if rows else []


def _shown_motions(comparison: Comparison) -> Sequence[MotionComparison]:
    """Those of the loads; of a lift without any those of all bodies that are apart."""
    return comparison.loads or [one for one in comparison.bodies if _moves(one)]


def _moves(motion: MotionComparison) -> bool:
    return any(
        one is not None and without_rounding(one.largest, 0.0, unit) > 0.0 for one, unit in _parts(motion)
    )


def _plain(value: float | None, unit: str) -> str:
    return ABSENT if value is None else _signed(value, unit).lstrip("+")


def _both(name: str, name_b: str) -> str:
    return name if name == name_b else f"{name} | {name_b}"


def _only(comparison: Comparison) -> list[str]:
    lines = []
    for letter, only in (("A", comparison.only_a), ("B", comparison.only_b)):
        if only:
            kinds = "; ".join(f"{_ONLY[kind]} {', '.join(names)}" for kind, names in only.items())
            lines.append(f"Only in {letter}: {kinds}")
    return lines


def _stability(comparison: Comparison) -> list[str]:
    lines = []
    for letter, side in zip("AB", comparison.stability, strict=True):
        first, *rest = side.sentences()
        lines += [f"{letter}  {first}", *(f"   {sentence}" for sentence in rest)]
    if comparison.common is None:
        lines.append("There is no time that both recorded: nothing over time can be compared.")
    elif any(side.is_at_rest for side in comparison.stability):
        lines.append(f"Compared at {comparison.common.times[0]:g} s alone, at rest.")
    elif len(comparison.common.times) == 1:
        lines.append(f"Compared at {comparison.common.times[0]:g} s alone, which both have.")
    elif min(side.end or 0.0 for side in comparison.stability) < max(
        side.end or 0.0 for side in comparison.stability
    ):
        times = comparison.common.times
        lines.append(f"Compared over time from {times[0]:g} s to {times[-1]:g} s, which both have.")
    if _has_rounding(comparison):
        lines.append(f"{_ROUNDING}: 0 above.")
    return ["Stability", *(f"  {line}" for line in lines)]
