"""Ctrl-C, or somebody else's no, while statics follows a plan from rest to rest, which takes seconds."""

from __future__ import annotations

import inspect
import os
import signal
import sys
import threading
import time
from pathlib import Path

import pytest

from gantline.scenario import load_scenario
from gantline.statics import Equilibrium, NoEquilibriumError, Statics
from gantline.study.side_by_side import SideBySide

LIFT = Path(__file__).resolve().parents[2] / "scenarios" / "floating_crane"


def interrupt_a_search() -> None:
    """Ctrl-C for the main thread once it searches: its innermost frame is the one that called the core."""
    main = threading.main_thread().ident
    assert main is not None
    search = inspect.unwrap(Statics.equilibrium)
    while sys._current_frames()[main].f_code is not search.__code__:
        time.sleep(0.001)
    time.sleep(0.02)  # from the call into the core
    os.kill(os.getpid(), signal.SIGINT)


def test_ctrl_c_ends_a_search_between_two_equilibria() -> None:
    """The search is not heard of before its end otherwise; what it belongs to can be asked again."""
    question = Statics(LIFT)
    # Where tests run in the background Python leaves Ctrl-C alone.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    interrupt = threading.Thread(target=interrupt_a_search, daemon=True)
    try:
        with pytest.raises(KeyboardInterrupt):
            interrupt.start()
            question.equilibrium()  # the end of the lift: a thousand equilibria and more
        interrupt.join()
    finally:
        signal.signal(signal.SIGINT, before)
    assert question.equilibrium(time=0.0).is_stable


def test_what_other_threads_look_for_is_given_up() -> None:
    """Ctrl-C reaches one thread alone; as that leaves its `with`, those that search for it are told."""
    has_begun = threading.Event()

    def search(question: Statics) -> Equilibrium:
        has_begun.set()
        return question.equilibrium()

    with pytest.raises(KeyboardInterrupt), SideBySide(1) as pool:
        pending = pool.submit(search, pool.question(load_scenario(LIFT)))
        has_begun.wait()
        raise KeyboardInterrupt
    with pytest.raises(NoEquilibriumError, match="it was stopped"):
        pending.result()
