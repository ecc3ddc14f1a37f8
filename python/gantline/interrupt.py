"""Being told to end: Ctrl-C as a wish, where what goes on should be ended well; and what has to go before."""

from __future__ import annotations

import os
import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from types import FrameType

__all__ = ["noted_interrupt", "tidied"]

#: What is to be done before the program is ended by a signal, the last first, and the process that does it.
_TIDYING: list[tuple[int, Callable[[], None]]] = []


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


@contextmanager
def tidied(tidy: Callable[[], None]) -> Iterator[None]:
    """Have something done where the program is told to end, by `kill` or since its terminal has gone.

    That raises nothing, so what is half done would stay. The program ends as it would have ended; whoever has
    a way of his own to take the signal keeps it.

    Args:
        tidy: What is to be done; that it cannot be is no matter.
    """
    own = []
    if threading.current_thread() is threading.main_thread():
        every = [getattr(signal, name, None) for name in ("SIGTERM", "SIGHUP")]
        own = [one for one in every if one is not None and signal.getsignal(one) is signal.SIG_DFL]
    entry = (os.getpid(), tidy)
    _TIDYING.append(entry)
    for one in own:
        signal.signal(one, _end)
    try:
        yield
    finally:
        for one in own:
            signal.signal(one, signal.SIG_DFL)
        _TIDYING.remove(entry)


def _end(number: int, _frame: FrameType | None) -> None:
    for process, tidy in reversed(_TIDYING):
        # A process that was forked has these too, and what it ends for is no end of the first.
        if process == os.getpid():
            with suppress(OSError):
                tidy()
    signal.signal(number, signal.SIG_DFL)
    os.kill(os.getpid(), number)
