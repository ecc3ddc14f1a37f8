"""Equilibria that are looked for, and runs that go on, side by side."""

from __future__ import annotations

import os
from concurrent.futures import ThreadPoolExecutor
from threading import Event
from types import TracebackType

from gantline.assembly import Assembly
from gantline.interrupt import noted_interrupt
from gantline.scenario import Scenario
from gantline.statics import Statics
from gantline.study.asked import count_of

__all__ = ["SideBySide"]


class SideBySide(ThreadPoolExecutor):
    """Threads that look for equilibria, or simulate: the core does both without holding the interpreter.

    What is still worked on as its `with` ends, by an error or by Ctrl-C, is given up.

    Args:
        workers: How many at a time; None for as many as there are processors.
    """

    def __init__(self, workers: int | None = None) -> None:
        super().__init__(os.cpu_count() if workers is None else count_of("workers", workers))
        self._stopped = Event()

    def question(self, scenario: Scenario, assembly: Assembly | None = None) -> Statics:
        """A lift of which one of the threads may ask.

        Args:
            scenario: The lift.
            assembly: What has been assembled of it, where that is there already.

        Raises:
            ScenarioError: As of `Statics`.
        """
        return Statics(scenario, goes_on=self.goes_on, assembly=assembly)

    def goes_on(self) -> bool:
        """False once all is given up; what a thread works on asks for it now and then."""
        return not self._stopped.is_set()

    def give_up(self) -> None:
        """Let go of what is still worked on; one more Ctrl-C changes nothing, for all is ending already."""
        self._stopped.set()
        with noted_interrupt():
            self.shutdown(cancel_futures=True)

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        self.give_up()
