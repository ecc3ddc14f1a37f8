"""Names that nothing has were answered with nothing, in Python.

`recording.events("tautt")` gave an empty list, as if no rope had ever become taut, and
`check_recording(recording, ending="hold")` held an equilibrium against no step at all, or against every step
whose name is part of that word. `values_of(recording, "load_tlt")` ended with "KeyError: 'load_tlt'". Each
says now which names there are. So does `Statics.times_of`, to which a step that is none had not begun,
and `CasesResult.of`, which gave no states.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import gantline.study
from gantline.checks import check_recording, values_of
from gantline.results.kinds import EVENT_KINDS
from lift_text import BASE

_ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def recording() -> gantline.Recording:
    """Of a lift whose ropes become taut and none of whose ropes parts."""
    return gantline.simulate("equalizer", duration=4.0)


def test_a_kind_of_event_that_is_mistyped(recording: gantline.Recording) -> None:
    """Kinds that did not happen have no events; one that nobody knows is refused with all there are."""
    assert recording.events("taut")
    assert recording.events("broken") == []
    with pytest.raises(KeyError, match="no kind of event is 'tautt'; they are taut, slack, lift_off"):
        recording.events("tautt")


def test_every_kind_is_known() -> None:
    """Kinds of the core, and those that the documents list, are the known ones, in the order of these."""
    core = (_ROOT / "crates/gantline-core/src/event/mod.rs").read_text(encoding="utf-8")
    document = (_ROOT / "docs/reference/recording.md").read_text(encoding="utf-8")
    row = next(line for line in document.splitlines() if line.startswith("| `event_time`"))
    listed = re.findall(r"`(\w+)`", row.split("|")[4].partition(";")[0])
    listed += re.findall(r"`(\w+)`", row.split("|")[4].partition(";")[2].partition(";")[0])
    assert listed == list(EVENT_KINDS)
    assert set(re.findall(r'Self::\w+ => "(\w+)"', core)) <= set(EVENT_KINDS)


def test_a_quantity_that_is_mistyped(recording: gantline.Recording) -> None:
    """The known ones are named."""
    with pytest.raises(KeyError, match="is 'load_tlt'; they are static_hook_load, "):
        values_of(recording, "load_tlt")


@pytest.mark.parametrize("ending", ["hoist", ["hoist", "hoist agian"]])
def test_steps_that_are_mistyped(recording: gantline.Recording, ending: list[str]) -> None:
    """One word is no list of steps, and every name is one of the plan."""
    with pytest.raises(ValueError, match="are no steps of the plan; they are "):
        check_recording(recording, ending)


def test_a_step_that_is_mistyped() -> None:
    """A step that the way to an equilibrium has not come to has no times; one that is none is refused."""
    statics = gantline.Statics("equalizer")
    statics.equilibrium(0.0)
    assert statics.times_of(statics.scenario.plan[-1].step)[1] is None
    with pytest.raises(ValueError, match="the plan has no step 'nosuch'; its steps are "):
        statics.times_of("nosuch")


def test_a_case_that_is_mistyped() -> None:
    """The lift as it is given is the case without a name."""
    lift = gantline.parse_scenario(BASE + "cases: {heavy: {set: {load.weight.simulate: design}}}\n", "x.yaml")
    found = gantline.study.run_cases(lift, 0.0)
    assert [len(found.of(name)) for name in ("", "heavy")] == [1, 1]
    with pytest.raises(KeyError, match="there is no case 'heavvy'; there are '', 'heavy'"):
        found.of("heavvy")
