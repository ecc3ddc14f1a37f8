"""A chart that reaches as far as the jib of its boom was told to be of another boom.

Rows were held against the length of the boom alone: a row at 115 m outreach of a boom of 110 m with a hook
14 m beyond its head was a warning, though that hook comes to 116.5 m.
"""

from __future__ import annotations

import math

import pytest

from boom_lift import BOW, HEEL, LENGTH, boom_lift
from gantline.assembly import assemble
from gantline.scenario import parse_scenario

ALONG, ABOVE = 14.0, -5.0
ON_JIB = f"H1: {{type: H, along: {ALONG} m, above: {ABOVE} m, height: 40 m}}"
#: From the bow to the pin with that level ahead of the heel pins, equation (BM6).
JIB = HEEL[0] - BOW + math.hypot(LENGTH + ALONG, ABOVE)
HEAD = HEEL[0] - BOW + LENGTH
ONE = "H1: {type: H, height: 40 m}"


def said(hooks: str, farthest: float) -> list[str]:
    chart = f"rating: {{outreach: [20 m, 60 m, {farthest!r} m], rated: [900 t, 800 t, 300 t]}}"
    text = boom_lift(hooks=hooks).replace("    outreach_from", f"    {chart}\n    outreach_from")
    return [one.sentence for one in assemble(parse_scenario(text)).doubts if "reaches" in one.sentence]


@pytest.mark.parametrize(
    ("hooks", "farthest", "words"),
    [
        (ONE, 1.09 * HEAD, None),
        (ONE, 1.11 * HEAD, f"its boom reaches no farther than {HEAD:.1f} m"),
        (ON_JIB, 1.11 * HEAD, None),
        (ON_JIB, 1.09 * JIB, None),
        (ON_JIB, 1.11 * JIB, f"its jib reaches no farther than {JIB:.1f} m"),
    ],
)
def test_rows_are_held_against_the_hook_that_reaches_farthest(
    hooks: str, farthest: float, words: str | None
) -> None:
    """Rows up to 10 % beyond what a level boom reaches are in order."""
    found = said(hooks, farthest)
    assert bool(found) is (words is not None)
    assert words is None or words in found[0]
