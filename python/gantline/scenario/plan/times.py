"""How long a run is, in steps and samples: what is too many, whether the lift file or a command says so."""

from __future__ import annotations

from collections.abc import Iterator

__all__ = ["wrong_times"]

_MOST_STEPS = 100_000_000
_MOST_SAMPLES = 1_000_000


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
        ("sample_interval", sample_interval, _MOST_SAMPLES, "20 ms"),
    ):
        if interval is not None and duration / interval > most:
            sentence = f"{duration:g} s in parts of {interval:g} s are more than {most // 10**6} million"
            yield key, f"{sentence}; {usual} is usual"
