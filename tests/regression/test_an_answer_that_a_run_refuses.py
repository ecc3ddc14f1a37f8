"""`--level` and `--plumb` gave answers with which no run started, and did not say so.

They are looked for among cases, which may pull from the start. `reeved_hoist` with its centre of gravity
0.2 m and 0.1 m aside hangs level with two slings that are 68 mm and 32 mm shorter, where there are 6 mm of
slack under the hook: put into the lift file they were refused, "make the sling longer". So was the place of
the hook over the centre of gravity, for the slings to the far lugs.

The bearing of the hook is at x, y over the datum and 16.75 m high, lugs at (±3, ±2, 5) m: the way to a lug is
the root of (3 ± x)² + (2 ± y)² + 11.75², and up to 5 mm more for what the load sinks into the ground.
"""

from __future__ import annotations

import math
import re
from pathlib import Path

import pytest

from gantline.assembly import assemble
from gantline.scenario import Scenario, load_scenario
from gantline.scenario.errors import StartError
from gantline.study import adjust_lengths, plumb_hooks
from program import called

LIFT = Path(__file__).parents[2] / "scenarios" / "reeved_hoist"
ASIDE = {"load.centre_of_gravity.at": ["0.2 m", "0.1 m", "2.5 m"]}


def aside(**changes: str) -> Scenario:
    """The lift with its centre of gravity aside."""
    return load_scenario(LIFT).changed(ASIDE | changes)


def reaches(sentence: str, x: float, y: float) -> bool:
    """Whether the way in a message is that from the hook to a lug so far beside it."""
    found = re.search(r"it is (\d+\.\d{3}) m at the start$", sentence)
    return found is not None and 0.0 <= float(found[1]) - math.sqrt(x**2 + y**2 + 11.75**2) < 5e-3


def test_lengths_that_are_too_short_at_the_start() -> None:
    """Both slings that get shorter, each with the way that it does not reach."""
    answer = adjust_lengths(aside(), slopes=(0.0, 0.0))
    found = [one for one in answer.cannot_start if one.startswith("slings.")]
    assert [one.partition(":")[0] for one in found] == ["slings.S2", "slings.S4"]
    assert all(reaches(one, 3.0, 2.0) for one in found)
    assert answer.to_json()["cannot_start"] == list(answer.cannot_start)
    with pytest.raises(StartError, match=r"slings\.S2: the sling is 12\.2321 m"):
        assemble(aside().changed({path: f"{value!r} m" for path, value in answer.values.items()}))


def test_a_hook_from_whose_place_slings_do_not_reach() -> None:
    """Over the centre of gravity S1 does not reach its lug, which is 3.2 m and 1.9 m beside."""
    answer = plumb_hooks(aside())
    assert answer.values["cranes.hook.at.x"] == pytest.approx(0.2, abs=1e-3)
    (far,) = [one for one in answer.cannot_start if one.startswith("slings.S1:")]
    assert reaches(far, 3.2, 1.9)
    assert answer.to_json()["cannot_start"] == list(answer.cannot_start)


def test_an_answer_with_which_a_run_starts() -> None:
    """With the hook 0.2 m lower nothing is too short, and nothing is said."""
    lower = aside(**{"cranes.hook.at.z": "16.55 m"})
    assert adjust_lengths(lower, slopes=(0.0, 0.0)).cannot_start == ()
    assert plumb_hooks(lower).cannot_start == ()


def test_it_stands_below_the_case(tmp_path: Path) -> None:
    """In the table, and there without the advice that would undo the answer."""
    path = tmp_path / "lift.yaml"
    text = (LIFT / "scenario.yaml").read_text(encoding="utf-8")
    path.write_text(text.replace("{at: [0 m, 0 m, 2.5 m]}", "{at: [0.2 m, 0.1 m, 2.5 m]}"), encoding="utf-8")
    result = called("statics", path, "--level")
    assert result.returncode == 0, result.stderr
    said = result.stdout.partition("As a case of the lift file")[2]
    assert "With these values a run cannot start where the lift does" in said
    (line,) = [line for line in said.splitlines() if line.startswith("  slings.S2: the sling is 12.2321 m")]
    assert reaches(line, 3.0, 2.0)
    assert "make the sling longer" not in said
