"""The floating crane that takes its load off a quay without stops at 25, 50 and 75 % of it.

What steps that wait for something leave, at rest, is the same work for each of them.
"""

from __future__ import annotations

from pathlib import Path

from gantline.scenario import Scenario, parse_scenario
from lift_text import changed, without

_FILE = Path(__file__).parents[2] / "scenarios" / "floating_crane" / "scenario.yaml"
_LEFT_OUT = ("to {0} percent,", "astern at {0},", "bow lines at {0},", "hold point {1},")


def taken_at_once(duration: str) -> Scenario:
    """The lift so long: its load is clear after 790 s, and stays over its stools until 960 s."""
    text = without(_FILE.read_text(encoding="utf-8"), "cases")
    for number, share in enumerate((25, 50, 75), start=1):
        for form in _LEFT_OUT:
            words = form.format(share, number)
            (line,) = [line for line in text.splitlines(keepends=True) if f"{{step: {words}" in line]
            text = text.replace(line, "")
    return parse_scenario(changed(text, ("duration: 2750 s", f"duration: {duration}")), str(_FILE))
