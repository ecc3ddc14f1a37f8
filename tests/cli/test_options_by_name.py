"""What is wrong with a value behind an option is told by the option, as it was typed.

It was told by the setting of a lift file (`sample_interval: ...` of who typed `--duration`), by a line of the
file in which the value is not, or by nothing at all.
"""

from __future__ import annotations

import pickle
import shlex

import pytest

from gantline.overrides import SettingError
from gantline.scenario import load_scenario
from gantline.study.sweep import SweepError, run_sweep
from program import called, program

LENGTH = "slings.S1.length"


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (
            "run equalizer --step '1 ms'",
            "--step: not a setting of the integrator adaptive; del and explicit have it",
        ),
        ("run equalizer --integrator del --step '0 s'", "--step: '0 s' is not a time above zero"),
        (
            "run equalizer --integrator del --tension-tolerance '50 N'",
            "--tension-tolerance: not a setting of the integrator del; adaptive has it",
        ),
        (
            "run equalizer --duration '10 ms'",
            "--duration: 0.02 s between samples are more than the duration of 0.01 s: there would be no",
        ),
        (
            "run equalizer --integrator del --duration '0.5 ms' --sample-interval '0.1 ms'",
            "--duration: the step of 0.001 s is longer than the duration of 0.0005 s; 1 ms is usual",
        ),
        ("compare equalizer --b adjusting_factor=0", "--b adjusting_factor: '0' is not a number above zero"),
        (
            "compare equalizer --a equalizers=loose",
            "--a equalizers: 'loose' is none; 'locked' pins all moving sheaves where they start",
        ),
        (
            "compare equalizer --a integrator=del --both 'step=1 ms'",
            "B: --both step: not a setting of the integrator adaptive; del and explicit have it",
        ),
        (
            "ballast floating_crane --step pump",
            "--step: 'pump' is not a step of the plan; known here: 'take up",
        ),
        (
            "ballast floating_crane --time '9000 s'",
            "--time: 9000 s is not in the lift, which lasts 2750 s",
        ),
        ("ballast floating_crane --tanks ,", "--tanks: no tank may change; name one at least"),
        ("ballast floating_crane --tanks row1.1,aft", "--tanks: 'aft' is not a tank of barge; known here: "),
        (
            "ballast floating_crane --vessel tug",
            "--vessel: 'tug' is not a vessel with tanks; known here: 'barge'",
        ),
        (
            "ballast floating_crane --trim '-50 deg'",
            "--trim: -50 deg is too steep; less than 45 deg is right",
        ),
        (
            "ballast floating_crane --draft '50 m'",
            "--draft: a draft of 50 m is not between the keel of barge",
        ),
        (
            f"statics equalizer --sweep '{LENGTH}=2 m..-2 m/3'",
            f"--sweep: {LENGTH}=0 m: '0 m' is zero; this length has to be above zero",
        ),
        (
            "statics equalizer --sweep 'duration=1 s..2 s/2'",
            "--sweep: duration=1 s: step 'hoist', plan[1].brake_from: 25 s is after the end of the lift",
        ),
    ],
)
def test_the_option_is_named(words: str, says: str) -> None:
    told = called(*shlex.split(words))
    err = told.stderr
    assert (told.returncode, told.stdout) == (2, "")
    assert err.startswith(f"error: {says}")
    assert len(err.splitlines()) == 1 and ".yaml" not in err


def test_a_lift_without_tanks_is_told_by_its_file() -> None:
    told = program("ballast", "equalizer")
    assert told.returncode == 2
    assert told.stderr.endswith(
        "equalizer.yaml: no vessel with tanks floats in this lift; give one 'tanks'\n"
    )


def test_a_sweep_of_python_is_told_by_the_line_of_the_file_with_the_value() -> None:
    scenario = load_scenario("equalizer")
    with pytest.raises(SweepError, match=rf":\d+: {LENGTH}: '-1 m' is negative") as found:
        list(run_sweep(scenario, LENGTH, "-1 m", "2 m", 2))
    assert found.value.value == "-1 m"
    again = pickle.loads(pickle.dumps(found.value))
    assert (str(again), again.value) == (str(found.value), "-1 m")


def test_a_setting_of_python_keeps_its_name() -> None:
    """Numbers are without unit there, so that the message says which."""
    problem = SettingError(["step", "duration"], "is not a time above zero", 0.0, " in seconds")
    assert str(problem) == "step: 0.0 is not a time above zero in seconds"
    assert (
        problem.as_typed({"duration": ("--duration", "0 s")}) == "--duration: '0 s' is not a time above zero"
    )
    assert problem.as_typed({}) == str(problem)
    again = pickle.loads(pickle.dumps(problem))
    assert (str(again), again.names) == (str(problem), ("step", "duration"))
