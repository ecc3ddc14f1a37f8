"""Loads on long ropes whose upper end moves, in air and in water, and a rope that sags, against MoorDyn.

MoorDyn 2.7.2 (BSD-3-Clause) computed the tensions of the first and the last of 40 segments that are kept
beside this file; `python -m benchmarks.lines --write` does it again.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

from mechanics import Floats

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from benchmarks.heaved_lines import GRAVITY, LINES, SAMPLE_INTERVAL, HeavedLine, tensions  # noqa: E402

KEPT = Path(__file__).with_name("lines_in_moordyn.csv")
PAGE = ROOT / "docs" / "verification" / "lines_in_moordyn.md"
#: Rms differences over the largest tension. Both codes have the same chain of masses: what is left is the
#: default tolerance of gantline. The load that snatches: dampers of MoorDyn push in a slack rope, by
#: BA = 200 kN s times a strain rate of 0.1/s where a segment of 10 m takes 1 m/s, 20 kN of 1363. The rope
#: that sags: halves of a segment at its ends in place of 7/16, by which an integration of its own differs by
#: 0.2 %.
BOUNDS = {
    "load on a rope": 1e-4,
    "load that snatches": 2e-3,
    "load in water": 1e-4,
    "rope that sags": 3e-3,
}


def moordyn(line: HeavedLine) -> Floats:
    """Tensions of both ends from the second sample on (n, 2) [N], their end masses those of gantline."""
    rows = KEPT.read_text(encoding="utf-8").splitlines()
    names = rows[2].split(",")
    table = np.loadtxt(rows[3:], delimiter=",")
    assert table[:, 0] == pytest.approx(SAMPLE_INTERVAL * np.arange(1, len(table) + 1))
    both: Floats = 1e3 * table[:, [names.index(f"{line.name}: {end}") for end in ("first", "last")]]
    if line.load is None:
        return both
    # Below the first segment there is a sixteenth of a segment more, below the last a sixteenth less.
    sixteenth = line.mass * line.length / line.segments / 16 * GRAVITY
    both += np.array([sixteenth, -sixteenth])
    return both


@pytest.fixture(scope="module")
def found() -> dict[str, Floats]:
    return {line.name: tensions(line)[1:] for line in LINES}


@pytest.mark.parametrize("line", LINES, ids=lambda line: line.name)
def test_tensions_are_those_of_moordyn(line: HeavedLine, found: dict[str, Floats]) -> None:
    """All along, and the largest of either end to a thousandth, of the rope that sags to two."""
    expected, own = moordyn(line), found[line.name]
    peaks = expected.max(axis=0)
    assert np.sqrt(np.mean((own - expected) ** 2)) < BOUNDS[line.name] * peaks.max()
    assert own.max(axis=0) == pytest.approx(peaks, rel=1e-3 if line.load else 2e-3)


def test_slack_and_taut_at_the_same_times(found: dict[str, Floats]) -> None:
    """The load that snatches: spells without tension at the load begin and end within a sample, 0.02 s."""
    [line] = [line for line in LINES if line.name == "load that snatches"]
    expected = moordyn(line)[:, 1]
    # MoorDyn's dampers push while the rope is slack.
    slack = [tension < 0.03 * expected.max() for tension in (expected, found[line.name][:, 1])]
    changes = [np.flatnonzero(np.diff(one.astype(int))) for one in slack]
    assert len(changes[0]) == len(changes[1]) >= 6
    assert np.abs(changes[0] - changes[1]).max() <= 1


def test_the_page_has_them(found: dict[str, Floats]) -> None:
    """Every row of the table of docs/verification/lines_in_moordyn.md."""
    page = PAGE.read_text(encoding="utf-8")
    missing = [row for row in (_row(line, found[line.name]) for line in LINES) if row not in page]
    assert missing == []


def _row(line: HeavedLine, own: Floats) -> str:
    """Of the page's table: largest tension at either end by both, and the difference."""
    expected = moordyn(line)
    digits = 1 if expected.max() > 1e5 else 2
    peaks = [
        f"{one / 1e3:.{digits}f} | {other / 1e3:.{digits}f} kN"
        for one, other in zip(expected.max(axis=0), own.max(axis=0), strict=True)
    ]
    rms = np.sqrt(np.mean((own - expected) ** 2)) / expected.max()
    return f"| {line.name} | {' | '.join(peaks)} | {100 * rms:.2g} % |"
