"""Ctrl-C while statics follows a plan from rest to rest, which takes seconds."""

from __future__ import annotations

import os
import signal
import threading
from pathlib import Path

import pytest

from gantline.statics import Statics

LIFT = Path(__file__).resolve().parents[2] / "scenarios" / "floating_crane"


def test_ctrl_c_ends_a_search_between_two_equilibria() -> None:
    """The search is not heard of before its end otherwise; what it belongs to can be asked again."""
    question = Statics(LIFT)
    # Where tests run in the background Python leaves Ctrl-C alone.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    interrupt = threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT))
    interrupt.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            question.equilibrium()  # the end of the lift: a thousand equilibria and more
        interrupt.join()
    finally:
        signal.signal(signal.SIGINT, before)
    assert question.equilibrium(time=0.0).is_stable
