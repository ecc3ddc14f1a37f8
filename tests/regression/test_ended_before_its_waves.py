"""A run that ended before its waves and gusts had grown.

Waves grow over three of their longest peak periods and gusts over 20 s, so that what rests at the start
begins to move without a jerk. A run of 20 s of `crane_barge_in_swell`, whose waves are whole from 21 s on,
had a dynamic factor of 1.011, one of 300 s has 1.044: it was a GO with 0 warnings, and so was a module that
hung for 15 s in gusts of 18 m/s. A load that came off its supports in the first seconds was lifted in a calm,
whatever the lift file says of the sea.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from four_slings import LIFT
from gantline.results.recording import Recording
from gantline.scenario import Scenario, parse_scenario
from gantline.simulation import simulate
from recorded_motion import written_record

FILE = Path(__file__).parents[2] / "scenarios" / "crane_barge_in_swell" / "scenario.yaml"
WIND = "wind: {speed: 12 m/s, direction: 60 deg, gusts: {speed: 18 m/s}}\n"
AREA = "  wind_areas: {side: {area: 18 m^2, coefficient: 1.2, along: y, at: [0 m, 0 m, 1.5 m]}}\n  lugs:\n"

LITTLE = "it sees little of them"


def told(run: Recording) -> list[str]:
    return [one for one in run.attributes["warnings"] if " grow" in one]


@pytest.mark.parametrize(("duration", "is_told"), [(20.0, True), (41.0, True), (42.0, False)])
def test_waves(duration: float, is_told: bool) -> None:
    """Whole at 3 × 7 s, and so for as long again at 42 s."""
    scenario = parse_scenario(FILE.read_text(encoding="utf-8"), str(FILE))
    said = f"the run ends at {{:g}} s, and its waves grow until 21 s: {LITTLE}; 42 s at least are right"
    assert told(simulate(scenario, duration=duration)) == ([said.format(duration)] if is_told else [])


def blown(text: str, wind: str = WIND) -> Scenario:
    return parse_scenario(text.replace("ground:", f"{wind}ground:").replace("  lugs:\n", AREA))


def in_gusts(before: str = "", wind: str = WIND) -> Recording:
    return simulate(blown(LIFT.replace("plan:\n", f"plan:\n{before}"), wind))


def test_gusts() -> None:
    """The plan lifts at once; what lifts off then does so in nearly steady wind."""
    (said,) = told(in_gusts())
    assert said.startswith("module lifts off at ")
    rest = "smaller than the lift file has them; hold it that long first"
    assert said.endswith(f" s, while gusts grow, until 20 s: {rest}")
    assert not told(in_gusts("  - {step: wait, hold: 20 s}\n"))
    assert not told(in_gusts(wind=WIND.replace(", gusts: {speed: 18 m/s}", "")))


def test_gusts_of_a_short_run() -> None:
    text = LIFT[: LIFT.index("plan:")] + "plan: [{step: wait, hold: until_end}]\n"
    (said,) = told(simulate(blown(text), duration=15.0))
    assert said == f"the run ends at 15 s, and its gusts grow until 20 s: {LITTLE}; 40 s at least are right"


BARGE = """\
vessels:
  barge:
    position: [0 m, 60 m]
    draft: 4 m
    hull: {box: [100 m, 30 m, 8 m]}
    wave_motion: {record: motion.csv, at: [50 m, 0 m, 4 m]}
plan:
"""


def test_records(tmp_path: Path) -> None:
    """A heave of 7.33 s grows over three of its periods, to the next tenth of a second 22.0 s; what lifts off
    half a second before is told.
    """
    motion = np.zeros((734, 6))
    motion[:, 2] = np.cos(2 * np.pi * np.arange(734) / 73.3)
    written_record(motion, 0.1, tmp_path / "motion.csv")

    def after(hold: float) -> list[str]:
        wait = f"  - {{step: wait, hold: {hold:.3f} s}}\n" if hold else ""
        return told(
            simulate(parse_scenario(LIFT.replace("plan:\n", BARGE + wait), str(tmp_path / "lift.yaml")))
        )

    (at_once,) = after(0.0)
    lifts, rest = at_once.split(" s, while recorded motions grow, until 22 s: ")
    assert rest == "smaller than the lift file has them; hold it that long first"
    way = 22.0 - float(lifts.removeprefix("module lifts off at "))
    (late,) = after(way - 0.5)
    assert late.startswith("module lifts off at 21.50 s")
    assert not after(way + 0.5)
