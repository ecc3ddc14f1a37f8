"""One question asked by several threads at the same time."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor

import numpy as np

from gantline.statics import Statics


def test_each_thread_gets_the_equilibrium_that_it_asked_for() -> None:
    """As one thread gets them one after the other; a thread that came in between was a TypeError."""
    moments = [0.0, 8.0, 16.0, 24.0] * 3

    def tensions(question: Statics, moment: float) -> np.ndarray:
        return question.equilibrium(moment).recording["rope_tension"].values

    alone = Statics("equalizer")
    expected = [tensions(alone, moment) for moment in moments]
    shared = Statics("equalizer")
    with ThreadPoolExecutor(4) as pool:
        found = list(pool.map(lambda moment: tensions(shared, moment), moments))
    for one, other in zip(found, expected, strict=True):
        assert np.array_equal(one, other)
