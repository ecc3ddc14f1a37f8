"""A run that failed 120 s after the last stage that its picture showed.

A sheerleg hoisted its hook block into the sheaves above it, and the picture of stages ended with the load
half way up, with a place left empty: neither page nor pictures showed what had happened.
"""

from __future__ import annotations

import pytest

from gantline.plot.moments import stages
from gantline.results.recording import Recording
from sample_lift import ringing_lift


@pytest.mark.parametrize(("status", "is_shown"), [("done", False), ("failed", True), ("stopped", True)])
def test_the_end_is_shown_where_a_run_broke_off(status: str, is_shown: bool) -> None:
    """Of a run that went through its plan the last step that moved something is the last stage."""
    whole = ringing_lift()
    recording = Recording(whole.variables, whole.coordinates, {**whole.attributes, "status": status})
    last = stages(recording)[-1]
    assert (last.name == "end" and last.sample == len(recording.time) - 1) is is_shown
