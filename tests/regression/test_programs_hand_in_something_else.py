"""What programs handed to functions of recordings and studies in place of what these take.

`check_recording("run.nc")` ended with "'str' object has no attribute 'rig'", `compare` of a simulation with
"expected str, bytes or os.PathLike object"; `plumb_hooks(hooks="test_hook")` with "'t' is not a hook";
`run_sweep` with a count of 3.0, `run_seas` with heights of 0.5, and a command of 10^400 m/s ended inside.
`run_seas(directions=[180])`, which takes radians, ran waves from 233 deg, without a word. And
`refined` took a finer run of another duration, whose figures differ by what it did not run.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import gantline
from gantline import study
from gantline.export import gltf_binary, write_csv
from gantline.export.tables import VariableError
from gantline.plot import figures

BARGE = "crane_barge_in_swell"
TAKES_ONE: dict[str, Callable[[Any], object]] = {
    "checks": gantline.checks.check_recording,
    "compare": lambda one: gantline.compare(one, one),
    "report": lambda one: gantline.write_report(one, Path("report.html")),
    "csv": lambda one: write_csv(one, Path("table.csv")),
    "glb": gltf_binary,
    "pictures": lambda one: list(figures(one)),
}


@pytest.mark.parametrize("take", TAKES_ONE.values(), ids=TAKES_ONE)
def test_a_simulation_is_no_recording(take: Callable[[Any], object]) -> None:
    right = "gantline.open_recording reads a file, and 'run' of a simulation gives one"
    with pytest.raises(TypeError, match=f"a recording is needed, not Simulation; {right}"):
        take(gantline.Simulation("pulleys"))


@pytest.mark.parametrize("take", [one for name, one in TAKES_ONE.items() if name != "compare"])
def test_the_name_of_a_file_is_no_recording(take: Callable[[Any], object]) -> None:
    with pytest.raises(TypeError, match="a recording is needed, not str"):
        take("run.nc")


def test_a_name_is_no_list_of_names() -> None:
    right = r"'test_hook' is a text, and a list of names is needed, such as \['test_hook'\]"
    with pytest.raises(TypeError, match=f"hooks: {right}"):
        study.plumb_hooks("equalizer", hooks="test_hook")
    with pytest.raises(TypeError, match="slings: 'S1' is a text"):
        study.adjust_lengths("equalizer", heading=0.0, slings="S1")
    with pytest.raises(VariableError, match=r"'energy' is a text, .* such as \['energy'\]"):
        write_csv(gantline.simulate("pulleys", duration=0.1), Path("table.csv"), "energy")


@pytest.mark.parametrize("count", ["3", 3.0, True, None])
def test_a_count_is_a_whole_number(count: Any) -> None:
    with pytest.raises(TypeError, match=r"count: .* is no whole number from 1 on"):
        next(study.run_sweep("equalizer", "slings.S1.length", "22 m", "24 m", count))
    with pytest.raises(ValueError, match="workers: 0 are none; a whole number from 1 on is needed"):
        study.run_cases("equalizer", workers=0)


@pytest.mark.parametrize("heights", [0.5, ["0.5 m"]])
def test_heights_are_a_list_of_numbers(heights: Any) -> None:
    with pytest.raises(study.NoSeaError, match=r"heights: .* is no list of numbers, in m, s or rad"):
        study.run_seas(BARGE, heights=heights)


def test_directions_are_radians() -> None:
    """180 rad are 28.6 turns: nobody means them."""
    told = "directions: 180 rad are more than a full turn; 3.1416 rad are 180 deg"
    with pytest.raises(study.NoSeaError, match=told):
        study.run_seas(BARGE, directions=[180.0])


def test_a_command_past_all_numbers() -> None:
    run = gantline.Simulation("reeved_hoist", duration=1.0)
    with pytest.raises(gantline.CommandError, match=r"speed: 10+ is not a speed in m and s"):
        run.command("hook", speed=10**400)


def test_a_finer_run_of_another_duration() -> None:
    whole, short = (gantline.simulate("pulleys", duration=lasts) for lasts in (0.2, 0.1))
    told = r"no runs of one lift and one duration \(0.2 s and 0.1 s\)"
    with pytest.raises(ValueError, match=told):
        study.refined(whole, short)


def test_a_variable_of_recordings_alone() -> None:
    """A recording has a height of every hook of this crane: "there is no 'hook_height'" was no answer."""
    run = gantline.Simulation("goliath", duration=1.0)
    told = "'hook_height' is worked out for recordings alone, see `recording`; there are rope_tension, "
    with pytest.raises(KeyError, match=told):
        run.now("hook_height", "goliath.U1")
    with pytest.raises(KeyError, match="there is no 'height' at present; there are rope_tension, "):
        run.now("height", "goliath.U1")
