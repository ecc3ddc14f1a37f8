"""What `gantline ballast` prints."""

from __future__ import annotations

from typing import TYPE_CHECKING

from gantline.cli.table import pairs, signed, table
from gantline.units import format_quantity

if TYPE_CHECKING:
    from gantline.study import BallastAnswer, VesselAttitude


def report(answer: BallastAnswer) -> list[str]:
    """Contents, how the vessel floats with them, and what to put into the lift file."""
    pumped = any(abs(answer.contents_then[tank] - answer.contents[tank]) > 0.5 for tank in answer.contents)
    head = ["Tank", "content", "new content", "change", *(["at that moment"] if pumped else [])]
    rows = []
    for tank, content in answer.contents.items():
        change = content - answer.given[tank]
        cells = [tank, _tonnes(answer.given[tank]), _tonnes(content), signed(change, "t", 1)]
        rows.append([*cells, *([_tonnes(answer.contents_then[tank])] if pumped else [])])
    sea = answer.sea_water
    way = "from the sea" if sea > 0.0 else "to the sea"
    (transverse, longitudinal), (of_heel, of_trim) = answer.gm, answer.free_surface
    return [
        *table(head, rows, "l" + "r" * (len(head) - 1)),
        "",
        f"  water moved, the least: {_tonnes(answer.moved)}, of that {_tonnes(abs(sea))} {way}",
        "",
        *pairs(
            f"{answer.vessel} at rest",
            [
                (f"at {answer.time_given:g} s, before", _attitude(answer.attitude_given)),
                (f"at {answer.time:g} s, so", _attitude(answer.attitude)),
                ("at the start, so", _attitude(answer.attitude_before)),
                ("displacement", _tonnes(answer.displacement)),
                ("GM for heel", f"{transverse:.2f} m, free surfaces take {of_heel:.2f} m of it"),
                ("GM for trim", f"{longitudinal:.2f} m, free surfaces take {of_trim:.2f} m of it"),
            ],
        ),
        "",
        "As contents in the lift file:",
        *(f"  {tank}: {{content: {content / 1e3:.3f} t}}" for tank, content in answer.contents.items()),
    ]


def _attitude(one: VesselAttitude) -> str:
    parts = [
        f"{key} {format_quantity(angle, 'deg', 3)}" for key, angle in (("heel", one.heel), ("trim", one.trim))
    ]
    return f"{', '.join(parts)}, draft {format_quantity(one.draft, 'm', 3)}"


def _tonnes(mass: float) -> str:
    return format_quantity(mass, "t", 1)
