"""The strip of a plan's steps above curves over time."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from matplotlib.axes import Axes
from matplotlib.patches import Rectangle

from gantline.results.progress import Stretch, stretches
from gantline.results.recording import Recording

__all__ = ["LETTER", "draw_strip", "is_tall", "strips_of"]

LETTER = 0.58 / 72.0  # mean width of a letter, inch per point of size
_INK = "#3E5468"


def strips_of(recordings: Mapping[str, Recording], span: float) -> list[tuple[str, list[Stretch]]]:
    """Steps of every recording that has a plan; those that agree to the width of a line stand once."""
    strips = [
        (letter, steps) for letter, steps in ((k, stretches(v)) for k, v in recordings.items()) if steps
    ]
    if len(strips) > 1 and all(_agree(strips[0][1], steps, 0.003 * span) for _, steps in strips[1:]):
        return [("", strips[0][1])]
    return strips


def _agree(one: Sequence[Stretch], other: Sequence[Stretch], within: float) -> bool:
    return [step.names for step in one] == [step.names for step in other] and all(
        abs(x.begin - y.begin) <= within and abs(x.end - y.end) <= within
        for x, y in zip(one, other, strict=True)
    )


def is_tall(steps: Sequence[Stretch], span: float) -> bool:
    """Whether a name of a step takes two lines."""
    return any("\n" in _fit(step, span)[0] for step in steps)


def draw_strip(strip: Axes, letter: str, steps: Sequence[Stretch], span: float) -> None:
    """Draw the steps of a plan where they went, with the names that there is room for."""
    strip.set_axis_off()
    strip.set_ylim(0.0, 1.0)
    if letter:
        place = strip.text(-0.008, 0.46, letter, transform=strip.transAxes, fontsize=8, color=_INK)
        place.set(ha="right", va="center")
    for index, step in enumerate(steps):
        tint = "#E9EEF3" if index % 2 == 0 else "#D5DFE8"
        wide = step.end - step.begin
        strip.add_patch(
            Rectangle((step.begin, 0.0), wide, 1.0, facecolor=tint, edgecolor="white", linewidth=1)
        )
        text, size = _fit(step, span)
        if text:
            label = strip.text((step.begin + step.end) / 2, 0.46, text, fontsize=size, color=_INK)
            label.set(ha="center", va="center", linespacing=0.95, in_layout=False)


def _fit(step: Stretch, span: float) -> tuple[str, float]:
    """What there is room for of the name of a step, and its size: in one line, in two smaller ones, or ""."""
    room = 5.6 * (step.end - step.begin) / span - 0.06  # inch
    shorter = [f"{step.names[0]} + {len(step.names) - 1} more"] if len(step.names) > 1 else []
    for name in (step.name, *shorter):
        if len(name) * 8.0 * LETTER <= room:
            return name, 8.0
        for lines in _in_two(name):
            if max(map(len, lines)) * 6.5 * LETTER <= room:
                return "\n".join(lines), 6.5
    return "", 0.0


def _in_two(name: str) -> list[tuple[str, ...]]:
    """A name in one line or two, the best way first."""
    words = name.split()
    halves = [(" ".join(words[:cut]), " ".join(words[cut:])) for cut in range(1, len(words))]
    return [(name,), *sorted(halves, key=lambda pair: max(map(len, pair)))[:1]]
