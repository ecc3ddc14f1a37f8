"""How long a run is, in steps and samples: what is too many, whether the lift file or a command says so."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product

__all__ = ["usual_sample_interval", "wrong_times"]

_MOST_STEPS = 100_000_000
_MOST_SAMPLES = 1_000_000
#: Samples of a lift that does not say how many: ten minutes of one every 20 ms. A lift with much gear keeps
#: 25 kB of each in memory, and what is slow enough to last for longer is followed by fewer.
_USUAL_SAMPLES = 30_000
_SHORTEST = 20e-3


def usual_sample_interval(duration: float) -> float:
    """Time between samples of a lift that does not say it [s].

    Args:
        duration: Simulated time of its lift file [s].

    Returns:
        20 ms, or the least round number that makes no more than 30,000 samples.
    """
    least = duration / _USUAL_SAMPLES * (1.0 - 1e-9)  # of ten minutes exactly
    round_ones = (float(f"{digit}e{power}") for power, digit in product(range(-2, 300), (1, 2, 5)))
    return next(one for one in round_ones if one >= max(least, _SHORTEST))


def wrong_times(duration: float, step: float | None, sample_interval: float) -> Iterator[tuple[str, str]]:
    """What is wrong with the times of a run.

    Args:
        duration: Simulated time [s].
        step: Of a method with fixed steps [s].
        sample_interval: Time between samples [s].

    Yields:
        Names of settings and sentences.
    """
    if step is not None and step > duration:
        yield (
            "step",
            f"the step of {step:g} s is longer than the duration of {duration:g} s; 1 ms is usual",
        )
    # A single sample would stand for a lift at rest, and not for a run that has hardly begun.
    if sample_interval > duration:
        longer = f"{sample_interval:g} s between samples are more than the duration of {duration:g} s"
        yield "sample_interval", f"{longer}: there would be no sample between its start and its end"
    for key, interval, most, usual in (
        ("step", step, _MOST_STEPS, "1 ms"),
        ("sample_interval", sample_interval, _MOST_SAMPLES, f"{usual_sample_interval(duration):g} s"),
    ):
        if interval is not None and duration / interval > most:
            sentence = f"{duration:g} s in parts of {interval:g} s are more than {most // 10**6} million"
            yield key, f"{sentence}; {usual} is usual"
