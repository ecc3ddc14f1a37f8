"""The time of the plan was `--time` with `statics` and `cases`, and `--at-time` with `ballast` alone."""

from __future__ import annotations

import pytest

from program import called


@pytest.mark.parametrize("verb", ["statics", "cases", "ballast"])
def test_every_verb_that_asks_for_a_moment_has_it_by_one_name(verb: str) -> None:
    shown = called(verb, "--help").stdout
    assert "--time TIME" in shown and "Time of the plan" in shown and "--at-time" not in shown
    refused = called(verb, "floating_crane", "--time", "12")
    assert refused.returncode == 2
    assert refused.stderr == "error: --time: '12' has no unit; a time is written like '40 s' or '2 ms'\n"
