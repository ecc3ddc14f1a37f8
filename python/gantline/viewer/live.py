"""A lift that is being simulated, for pages that show it while it runs.

A page asks for what it does not have yet: `live/<samples that it has>`. The answer is a packed recording of
what has been recorded since, a line of header and a line of data, or nothing if there is nothing new; the
header's `live` says how far the run is. As long as nobody asks, a run pays nothing.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable

from gantline.results.recording import Recording
from gantline.viewer.pack import pack

_PATIENCE = 2.0  # s that an answer waits for something new
_LONGEST_START = 20.0  # s that a page waits for the first samples
_LOADING = 10.0  # s that a page may take to be made, sent and laid out before it asks for more
_WATCHED = 3.0  # s after a question in which the next one is expected
_SHARE = 0.2  # of the time of a run that showing it may take


class LiveView:
    """What a run has recorded so far, between the run and those who look at it.

    Args:
        recording: Gives everything recorded so far; called in the thread that calls `offer`.
        duration: Simulated time at the end [s].
        clock: Tells the time, from whenever [s].
    """

    def __init__(
        self,
        recording: Callable[[], Recording],
        duration: float,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self._recording = recording
        self._duration = duration
        self._clock = clock
        self._latest: Recording | None = None
        self._status = "running"
        self._changed = threading.Condition()
        self._watched_until: float | None = None
        self._end_seen = False
        self._offered_at = 0.0
        self._cost = 0.0

    def offer(self) -> None:
        """Hand on what has been recorded if somebody looks; to be called often while the lift runs."""
        now = self._clock()
        if not self._is_watched(now) or now - self._offered_at < self._cost / _SHARE:
            return
        self._hand_on(self._recording(), "running")
        self._offered_at = self._clock()
        self._cost = self._offered_at - now

    def finish(self, recording: Recording, status: str) -> None:
        """Hand on all of it, and that there is no more.

        Args:
            recording: The recording.
            status: `done`, `stopped` or `failed`.
        """
        self._hand_on(recording, status)

    def first(self) -> Recording:
        """What there is for a page to begin with.

        Raises:
            ValueError: If nothing has been recorded in a while.
        """
        with self._changed:
            self._expect(_LONGEST_START)
            self._changed.wait_for(self._has_begun, _LONGEST_START)
            if self._latest is None:
                raise ValueError("the lift has not begun yet; load this page again")
            self._expect(_LOADING)
            return self._latest

    def since(self, samples: int) -> str:
        """What a page has not got yet, as header and data in a line each; empty if it has everything.

        Args:
            samples: How many samples it has.
        """
        with self._changed:
            self._expect(_WATCHED)
            self._changed.wait_for(lambda: self._has_more(samples), _PATIENCE)
            latest, status = self._latest, self._status
            self._expect(_WATCHED)
        if latest is None or (status == "running" and len(latest.time) <= samples):
            return ""
        packed = pack(latest, since=min(samples, len(latest.time)))
        packed.header["live"] = {"status": status, "duration": self._duration}
        answer = f"{packed.header_text()}\n{packed.data_text()}"
        if status != "running":
            with self._changed:
                self._end_seen = True
                self._changed.notify_all()
        return answer

    def wait_for_readers(self, start: float) -> None:
        """Wait until a page that looks has got the end of the lift.

        Args:
            start: How long a first page may take to come [s].
        """
        with self._changed:
            self._changed.wait_for(lambda: self._watched_until is not None, start)
            while not self._end_seen and self._is_watched(self._clock()):
                self._changed.wait(_WATCHED)

    def _hand_on(self, recording: Recording, status: str) -> None:
        with self._changed:
            self._latest, self._status = recording, status
            self._changed.notify_all()

    def _expect(self, within: float) -> None:
        self._watched_until = self._clock() + within

    def _is_watched(self, now: float) -> bool:
        return self._watched_until is not None and now < self._watched_until

    def _has_begun(self) -> bool:
        return self._latest is not None and (self._status != "running" or len(self._latest.time) > 1)

    def _has_more(self, samples: int) -> bool:
        return self._latest is not None and (self._status != "running" or len(self._latest.time) > samples)
