"""Ctrl-C as a wish, where what goes on should be ended well."""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType

__all__ = ["noted_interrupt"]


@contextmanager
def noted_interrupt() -> Iterator[Callable[[], bool]]:
    """Note the first Ctrl-C in place of raising it; a second one goes where it would have gone.

    Yields:
        Whether there was one.
    """
    if threading.current_thread() is not threading.main_thread():
        yield lambda: False
        return
    wished = threading.Event()
    before = signal.getsignal(signal.SIGINT)

    def wish(_signal: int, _frame: FrameType | None) -> None:
        wished.set()
        signal.signal(signal.SIGINT, before)

    signal.signal(signal.SIGINT, wish)
    try:
        yield wished.is_set
    finally:
        signal.signal(signal.SIGINT, before)
