"""Ctrl-C that was pressed twice lost what a study had found.

The first lets go of runs that go on, which takes a moment. A second one in that moment, by an impatient hand
or from `timeout -s INT`, which signals twice, ended `gantline cases --simulate` with "no case is known" after
ten of sixteen runs, and `gantline seas` and `cases` alike.
"""

from __future__ import annotations

import signal
import threading
import time

import pytest

from gantline.study.side_by_side import SideBySide


def test_a_second_ctrl_c_while_all_is_let_go_changes_nothing() -> None:
    """What goes on sees that it was given up, and Ctrl-C comes again before it has ended."""
    begun = threading.Event()
    with SideBySide(1) as pool:

        def work() -> str:
            begun.set()
            while pool.goes_on():
                time.sleep(1e-3)
            # Wakes the main thread, which waits for this one.
            signal.pthread_kill(threading.main_thread().ident or 0, signal.SIGINT)
            time.sleep(0.05)
            return "ended"

        one = pool.submit(work)
        begun.wait()
        try:
            pool.give_up()
        except KeyboardInterrupt:
            pytest.fail("the second Ctrl-C ends it")
        assert one.result() == "ended"
