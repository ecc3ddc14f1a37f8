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


def test_threads_go_on_until_all_is_given_up() -> None:
    """What has begun is told as its `with` ends, and what has not is never begun."""
    has_begun, may_end = threading.Event(), threading.Event()

    def wait() -> bool:
        has_begun.set()
        may_end.wait()
        return pool.goes_on()

    with SideBySide(1) as pool:
        assert pool.submit(pool.goes_on).result() is True
        first, second = pool.submit(wait), pool.submit(wait)
        has_begun.wait()
        threading.Timer(0.05, may_end.set).start()
    assert first.result() is False
    assert second.cancelled()


@pytest.mark.parametrize("workers", [1, 3])
def test_as_many_threads_as_asked_for(workers: int) -> None:
    """So many wait for each other and meet; one more is not there before the others have given up."""

    def meet(timeout: float) -> None:
        together.wait(timeout)

    together = threading.Barrier(workers + 1)
    with SideBySide(workers) as pool:
        met = [pool.submit(meet, 0.2) for _ in range(workers + 1)]
        assert all(isinstance(one.exception(), threading.BrokenBarrierError) for one in met[:workers])
    together = threading.Barrier(workers)
    with SideBySide(workers) as pool:
        met = [pool.submit(meet, 60.0) for _ in range(workers)]
        assert [one.exception() for one in met] == [None] * workers
    with pytest.raises(ValueError, match="workers"):
        SideBySide(0)
