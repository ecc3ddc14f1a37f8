"""What stood at the end of a cell filled pages, and parts of the package were not there.

The repr of a comparison had ten thousand characters, that of cases twenty thousand: every array and every
sheave. `gantline.study.run_cases`, as the reference writes it, was `module 'gantline' has no attribute
'study'` unless something else had imported it before.
"""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

import gantline
from gantline.study import run_cases
from sample_lift import ringing_lift

REFERENCE = Path(__file__).parents[2] / "docs/reference/python.md"


def parts() -> list[str]:
    """Packages and modules whose things the reference shows."""
    shown = re.findall(r":: gantline\.([a-z_]+)\.\w", REFERENCE.read_text(encoding="utf-8"))
    return sorted(set(shown))


def test_results_are_shown_in_a_line() -> None:
    """Whatever there is to show."""
    recording = ringing_lift()
    cases = run_cases("equalizer_yard", workers=1)
    shown = [
        recording["rope_tension"],
        gantline.compare(recording, recording),
        gantline.Statics("equalizer").equilibrium(),
        cases,
        gantline.Simulation("equalizer"),
    ]
    assert [repr(one) for one in shown if len(repr(one)) > 200 or not repr(one).startswith("<")] == []
    assert repr(cases).endswith(f"{len(cases.names) - 1} cases, {len(cases.states)} states in all>")


def test_the_reference_shows_parts() -> None:
    assert {"checks", "export", "hydro", "plot", "results", "study"} <= set(parts())


@pytest.mark.parametrize("part", parts())
def test_a_part_needs_no_import_of_its_own(part: str) -> None:
    """In a process of its own, where nothing else has imported it; and importing gantline loads none."""
    said = (
        f"import sys, gantline; assert 'gantline.{part}' not in sys.modules; print(gantline.{part}.__name__)"
    )
    answer = subprocess.run([sys.executable, "-c", said], capture_output=True, text=True, check=False)
    assert (answer.stdout, answer.stderr) == (f"gantline.{part}\n", "")
    assert part in dir(gantline)
