"""A recording with values that are no numbers was a GO.

A sample of `rope_tension` lost from a recording left the angles of its sling, its lug and its shackle without
a value, and the verdict was the GO of the whole recording: only a warning on the error stream told of it. All
places of ropes lost let the check `hangs_stably` end in a traceback of numpy. A recording that is not whole
gives no verdict now.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from gantline.checks import Outcome, Verdict, check_recording, outcome_of, verdict_of
from gantline.cli.app import app
from gantline.results.recording import Recording
from sample_lift import ringing_lift


def with_gap(name: str, samples: slice) -> Recording:
    """A lift of which a variable is lost at some samples."""
    whole = ringing_lift()
    values = whole[name].values.copy()
    values[samples] = np.nan
    variables = {**whole.variables, name: replace(whole[name], values=values)}
    return Recording(variables, whole.coordinates, whole.attributes)


@cache
def outcome_of_the_whole() -> Outcome:
    return outcome_of(check_recording(ringing_lift()))


@pytest.mark.parametrize(
    "name", ["body_position", "body_orientation", "rope_point", "rope_tension", "energy"]
)
@pytest.mark.parametrize("samples", [slice(1000, 1001), slice(None)], ids=["one sample", "all"])
def test_a_recording_with_gaps_is_no_go(tmp_path: Path, name: str, samples: slice) -> None:
    """Whatever is lost, at one sample or at all: no go, and the check says of what."""
    assert outcome_of_the_whole() is Outcome.GO_WITH_WARNINGS
    part = with_gap(name, samples)
    checks = check_recording(part)
    (told,) = (check for check in checks if check.name == "all_known")
    assert told.verdict is Verdict.WARNING
    assert told.remark.startswith(f"{name} of ")
    assert outcome_of(checks) in (Outcome.NO_VERDICT, Outcome.NO_GO)
    if not any(check.verdict is Verdict.FAILED for check in checks):
        assert verdict_of(checks).startswith(f"NO VERDICT: {told.remark}")
    result = CliRunner().invoke(app, ["check", str(part.save(tmp_path / "lift.nc"))])
    assert result.exit_code in (1, 4)
    assert result.exception is None or isinstance(result.exception, SystemExit)
